//! One line with soft rims at 16 bits.
#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::{paint::Cover, raster::coverage, Antialias};

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        let mut cells = [0; coverage::cells(size::WIDTH)];
        let [a, b, _] = size::corners();
        frame.draw_line_aa(a, b, &mut cells, Cover(size::color::<Rgb565>()));
    });
}
