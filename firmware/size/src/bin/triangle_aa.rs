//! One triangle with soft rims at 16 bits.
#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::{paint::Cover, raster::coverage, Antialias};

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        let mut cells = [0; coverage::cells(size::WIDTH)];
        frame.fill_triangle_aa(size::corners(), &mut cells, Cover(size::color::<Rgb565>()));
    });
}
