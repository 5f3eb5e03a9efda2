//! Two triangles made better, without drawing them.
#![no_std]
#![no_main]

use core::hint::black_box;

use embedded_raster::geom::delaunay;

board::entry!(main);

fn main() {
    size::on_memory(|_| {
        let mut triangles = black_box([[0, 1, 2], [2, 1, 0]]);
        let flips = delaunay::refine(&size::corners(), &mut triangles, &mut [[0; 3]; 2]);
        let _ = black_box((flips.is_ok(), triangles));
    });
}
