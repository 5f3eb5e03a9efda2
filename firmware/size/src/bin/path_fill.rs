//! One filled path with curves at 16 bits.
#![no_std]
#![no_main]

use core::hint::black_box;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::{Canvas, EdgeSlot, FillRule, Path, PathSegment};

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        let [a, b, c] = size::corners();
        let outline = black_box([PathSegment::MoveTo(a), PathSegment::CubicTo(b, c, a), PathSegment::Close]);
        // On the stack.
        let mut table = [EdgeSlot::EMPTY; 8];
        let drawn = frame.fill_path_fx(Path::new(&outline), FillRule::NonZero, &mut table, size::color::<Rgb565>());
        let _ = black_box(drawn.is_ok());
    });
}
