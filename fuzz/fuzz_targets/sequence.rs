//! Calls of the list one after the other, through views, clips and bands of any layout, against a naive surface.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| twins::sequences::sequence(data));
