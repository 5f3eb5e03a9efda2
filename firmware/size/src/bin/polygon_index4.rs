//! One polygon at 4 bits.
#![no_std]
#![no_main]

use core::hint::black_box;

use embedded_raster::{Canvas, EdgeSlot, FillRule, Index4};

board::entry!(main);

fn main() {
    size::on_frame::<Index4>(|frame| {
        // On the stack: three sides need three slots.
        let mut table = [EdgeSlot::EMPTY; 3];
        let drawn = frame.fill_polygon_fx(&size::corners(), FillRule::NonZero, &mut table, size::color::<Index4>());
        let _ = black_box(drawn.is_ok());
    });
}
