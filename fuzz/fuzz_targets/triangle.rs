//! Both triangle fillers against three edge functions per pixel, in wide integers.
#![no_main]

mod input;

use embedded_raster::raster::triangle;
use libfuzzer_sys::fuzz_target;
use twins::{assert_runs, collect, corners};

fuzz_target!(|data: &[u8]| {
    let mut input = input::Input(data);
    let window = input.window();
    let units = [(); 3].map(|()| (input.int(), input.int()));
    let wanted = twins::triangle(units, window);
    let filled = collect(window, |emit| triangle::fill(corners(units), window, emit));
    assert_runs(window, &filled, &wanted, || format!("fill {units:?}"));
    let walked = collect(window, |emit| triangle::walk(corners(units), window, emit));
    assert_runs(window, &walked, &wanted, || format!("walk {units:?}"));
    let in_blocks = collect(window, |emit| triangle::walk_blocks(corners(units), window, emit));
    assert_runs(window, &in_blocks, &wanted, || format!("walk_blocks {units:?}"));
});
