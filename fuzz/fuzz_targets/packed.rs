//! Any bytes as a packed path, against the table of its commands.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| twins::targets::packed(data));
