//! One triangle of one colour at 16 bits with a depth buffer of 16 bits.
#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::{paint::depth, Canvas};

board::entry!(main);

fn main() {
    size::on_depth::<Rgb565>(|frame, depths| {
        let (values, color) = (size::values().map(|[depth, ..]| (depth, ())), size::color::<Rgb565>());
        let _ = frame.depth_triangle_fx(size::corners(), values, depths, depth::less, |()| color);
    });
}
