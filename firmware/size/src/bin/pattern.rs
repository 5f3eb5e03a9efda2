//! One rectangle in a pattern of two colours, at 16 bits.
#![no_std]
#![no_main]

use core::hint::black_box;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::paint::{pattern, Pattern};
use embedded_raster::raster::rectangle;
use embedded_raster::Canvas;

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        let [color, ground, _] = size::colors();
        let paint = Pattern::new(black_box(pattern::DIAGONAL), color, Some(ground));
        frame.paint(paint, |window, brush| rectangle::fill(size::area(), window, brush));
    });
}
