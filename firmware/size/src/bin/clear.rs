//! The whole frame in one colour, at 16 bits.
#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::Rgb565;

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| frame.clear(size::color::<Rgb565>()));
}
