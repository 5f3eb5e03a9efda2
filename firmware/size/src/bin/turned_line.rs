//! One line on a screen that is turned, at 16 bits.
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
        let [from, to] = size::points();
        upright.draw_line(from, to, size::color::<Rgb565>());
    });
}
