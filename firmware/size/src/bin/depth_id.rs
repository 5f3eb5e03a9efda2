//! One triangle in a buffer of numbers of triangles, with a depth buffer of 16 bits.
#![no_std]
#![no_main]

use embedded_raster::{paint::depth, pixel::Id16, Canvas};

board::entry!(main);

fn main() {
    size::on_depth::<Id16>(|frame, depths| {
        let (values, id) = (size::values().map(|[depth, ..]| (depth, ())), size::color::<Id16>());
        let _ = frame.depth_triangle_fx(size::corners(), values, depths, depth::less, |()| id);
    });
}
