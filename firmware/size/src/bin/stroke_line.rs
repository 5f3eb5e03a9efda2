//! One line of a width, with every kind of end and corner, at 16 bits.
#![no_std]
#![no_main]

use core::hint::black_box;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::{Canvas, EdgeSlot, Stroke};

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        let mut table = [EdgeSlot::EMPTY; 16];
        let stroke = black_box(Stroke::px(5));
        let drawn = frame.stroke_polyline_fx(&size::corners(), false, &stroke, &mut table, size::color::<Rgb565>());
        let _ = black_box(drawn.is_ok());
    });
}
