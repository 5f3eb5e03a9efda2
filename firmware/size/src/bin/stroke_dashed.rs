//! One path with a curve, stroked with dashes, at 16 bits.
#![no_std]
#![no_main]

use core::hint::black_box;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::{Canvas, EdgeSlot, Path, PathSegment, PointFx, Stroke};

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        let [a, b, c] = size::corners();
        let outline = black_box([PathSegment::MoveTo(a), PathSegment::QuadraticTo(b, c)]);
        let mut table = [EdgeSlot::EMPTY; 32];
        let PointFx { x, y } = black_box(PointFx::px(6, 3));
        let lengths = [x, y];
        let stroke = black_box(Stroke::px(5)).dashed(&lengths, y);
        let drawn = frame.stroke_path_fx(Path::new(&outline), &stroke, &mut table, size::color::<Rgb565>());
        let _ = black_box(drawn.is_ok());
    });
}
