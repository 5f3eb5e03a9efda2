//! One cubic curve, one pixel wide, at 16 bits.
#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::Canvas;

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        let [a, b, c] = size::corners();
        frame.draw_cubic_fx([a, b, c, b], size::color::<Rgb565>());
    });
}
