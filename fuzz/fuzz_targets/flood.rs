//! Flood fills of any picture, with tables of any length, against a breadth-first search.
#![no_main]

mod input;

use embedded_graphics_core::geometry::Point;
use embedded_raster::raster::flood::{fill, Connectivity, FloodSlot};
use input::Input;
use libfuzzer_sys::fuzz_target;
use twins::letters::Letters;

fuzz_target!(|data: &[u8]| {
    let mut input = Input(data);
    let (size, capacity, choice) = (input.byte(), input.byte() % 12, input.byte());
    let (width, height) = (i32::from(size & 15) + 1, i32::from(size >> 4) + 1);
    let reach = if choice & 1 == 0 { Connectivity::Sides } else { Connectivity::Corners };
    let seed = (i32::from(input.byte()) % width, i32::from(input.byte()) % height);
    // What is open is 0 or 1.
    let mut bits = 0;
    let picture = Letters::new(width, height, |i| {
        if i % 8 == 0 {
            bits = input.byte();
        }
        bits >> (i % 8) & 1 == u8::from(choice & 2 != 0)
    });
    let mut got = picture.clone();
    fill(&mut got, Point::new(seed.0, seed.1), reach, &mut vec![FloodSlot::EMPTY; capacity.into()]);
    let wanted = picture.flooded(seed, reach);
    assert!(
        got == wanted,
        "{reach:?} from {seed:?} with {capacity} slots in\n{}got\n{}wanted\n{}",
        picture.text(),
        got.text(),
        wanted.text()
    );
    // Outside nothing happens.
    let outside = Point::new(input.int(), input.int());
    if got.at(outside.x, outside.y).is_none() {
        fill(&mut got, outside, reach, &mut []);
        assert!(got == wanted, "something was painted from {outside}");
    }
});
