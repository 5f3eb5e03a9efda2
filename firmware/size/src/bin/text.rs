//! Text of this crate in its font of 6 x 10 pixels, at 16 bits.
#![no_std]
#![no_main]

use core::hint::black_box;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::text::{Style, FONT_6X10};

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        let [at, _] = size::points();
        Style::new(&FONT_6X10, size::color::<Rgb565>()).draw(frame, at, black_box("Hello"));
    });
}
