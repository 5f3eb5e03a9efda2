//! Clipped lines against the rule, in wide integers.
#![no_main]

mod input;

use embedded_graphics_core::geometry::Point;
use embedded_raster::raster::line;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let mut input = input::Input(data);
    let window = input.window();
    let (a, b) = ((input.int(), input.int()), (input.int(), input.int()));
    let mut pixels = vec![];
    if let Some(steps) = line::clip(Point::new(a.0, a.1), Point::new(b.0, b.1), window) {
        steps.spans(|s| pixels.extend((s.x0()..s.x1()).map(|x| (s.y(), x))));
    }
    pixels.sort_unstable();
    let mut wanted: Vec<_> = twins::line(a, b, window).into_iter().map(|(x, y)| (y, x)).collect();
    wanted.sort_unstable();
    assert_eq!(pixels, wanted, "{a:?} to {b:?} in {window:?}");
});
