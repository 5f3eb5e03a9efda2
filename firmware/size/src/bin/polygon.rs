//! One polygon at 16 bits.
#![no_std]
#![no_main]

use core::hint::black_box;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::{Canvas, EdgeSlot, FillRule};

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        // On the stack: three sides need three slots.
        let mut table = [EdgeSlot::EMPTY; 3];
        let drawn = frame.fill_polygon_fx(&size::corners(), FillRule::NonZero, &mut table, size::color::<Rgb565>());
        let _ = black_box(drawn.is_ok());
    });
}
