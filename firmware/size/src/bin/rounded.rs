//! One rounded rectangle at 16 bits.
#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::{Canvas, Radii};

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| frame.fill_rounded(size::area(), Radii::all(9), size::color::<Rgb565>()));
}
