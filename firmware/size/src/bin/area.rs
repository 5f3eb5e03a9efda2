//! One rectangle of pixels at 16 bits.
#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::Surface;

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| frame.fill_area(size::area(), size::color::<Rgb565>()));
}
