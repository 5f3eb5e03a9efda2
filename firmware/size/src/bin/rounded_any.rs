//! One rounded rectangle at 16 bits, whose radii are not known when the program is compiled.
#![no_std]
#![no_main]

use core::hint::black_box;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::{Canvas, Radii};

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        frame.fill_rounded(size::area(), black_box(Radii::all(9)), size::color::<Rgb565>());
    });
}
