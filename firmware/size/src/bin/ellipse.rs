//! The outline of one ellipse at 16 bits.
#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::Canvas;

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| frame.draw_ellipse(size::area(), size::color::<Rgb565>()));
}
