//! What polygons cover against exact areas, and what paints make of it behind a mask and added up.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| twins::targets::coverage(data));
