//! One line with soft rims at 16 bits.
#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::{paint::Cover, Antialias};

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        let [a, b, _] = size::corners();
        frame.draw_line_aa(a, b, Cover(size::color::<Rgb565>()));
    });
}
