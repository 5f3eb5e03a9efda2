//! Values and depths over triangles and along lines, against exact ratios at every pixel.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| twins::targets::shading(data));
