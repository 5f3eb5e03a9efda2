//! Pictures drawn as they are, stretched, under maps, in nine parts and as tiles, against exact ratios at each pixel.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| twins::pictures::blits(data));
