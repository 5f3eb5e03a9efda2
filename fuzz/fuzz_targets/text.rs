//! Text in any font anywhere, against its pixels one by one; and any bytes as a font.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| twins::texts::target(data));
