//! One picture at 16 bits, but for the pixels of one colour.
#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::Canvas;

board::entry!(main);

fn main() {
    size::on_picture(|frame, at, picture| frame.blit_keyed(at, picture, size::color::<Rgb565>()));
}
