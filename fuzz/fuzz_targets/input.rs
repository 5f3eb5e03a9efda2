//! Numbers out of the fuzzer's bytes.

pub(crate) use twins::input::Input;
