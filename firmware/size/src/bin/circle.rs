//! One disc in a box at 16 bits.
#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::{Canvas, Ellipse};

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| frame.fill_ellipse_fx(Ellipse::in_box(size::area()), size::color::<Rgb565>()));
}
