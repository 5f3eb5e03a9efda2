//! Error diffusion, against a model with all errors in one large table.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| twins::pictures::diffusion(data));
