//! Texels at any place of a picture, against a sum over four of them.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| twins::targets::texture(data));
