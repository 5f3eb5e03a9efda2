//! One flood fill at 16 bits.
#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::raster::flood::{Connectivity, FloodSlot};
use embedded_raster::Canvas;

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        let [seed, _] = size::points();
        frame.flood_fill(seed, Connectivity::Sides, &mut [FloodSlot::EMPTY; 16], size::color::<Rgb565>());
    });
}
