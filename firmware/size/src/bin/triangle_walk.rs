//! One triangle at 16 bits by edge functions, without a division.
#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::{raster::triangle, Surface};

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        let color = size::color::<Rgb565>();
        triangle::walk(size::corners(), frame.window(), |span| frame.fill_span(span, color));
    });
}
