//! One polygon with soft rims at 16 bits.
#![no_std]
#![no_main]

use core::hint::black_box;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::{paint::Cover, raster::coverage, Antialias, CoverageSlot, FillRule};

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        // On the stack: three sides need three slots.
        let (mut table, mut cells) = ([CoverageSlot::EMPTY; 3], [0; coverage::cells(size::WIDTH)]);
        let paint = Cover(size::color::<Rgb565>());
        let drawn = frame.fill_polygon_aa(&size::corners(), FillRule::NonZero, &mut table, &mut cells, paint);
        let _ = black_box(drawn.is_ok());
    });
}
