//! Triangles, lines and points of any bits through the pipeline, against exact ratios.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| twins::targets::pipeline(data));
