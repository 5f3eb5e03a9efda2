//! One rectangle at 16 bits.
#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::Canvas;

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        let [a, _, b] = size::corners();
        frame.fill_rectangle_fx(a, b, size::color::<Rgb565>());
    });
}
