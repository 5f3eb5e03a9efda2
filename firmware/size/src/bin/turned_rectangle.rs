//! One rectangle on a screen that is turned, at 16 bits.
#![no_std]
#![no_main]

use core::hint::black_box;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::surface::{Turn, Turned};
use embedded_raster::Canvas;

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        let mut upright = Turned::new(frame, black_box(Turn::Quarter));
        upright.fill_rectangle(size::area(), size::color::<Rgb565>());
    });
}
