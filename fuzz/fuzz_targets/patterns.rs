//! Patterns, tiles and raster operations, against their rules pixel by pixel.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| twins::pictures::patterns(data));
