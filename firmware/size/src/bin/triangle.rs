//! One triangle at 16 bits.
#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::Canvas;

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| frame.fill_triangle_fx(size::corners(), size::color::<Rgb565>()));
}
