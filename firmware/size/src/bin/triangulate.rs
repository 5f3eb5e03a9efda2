//! One polygon cut into triangles, without drawing them.
#![no_std]
#![no_main]

use core::hint::black_box;

use embedded_raster::geom::triangulate::{self, SideSlot};

board::entry!(main);

fn main() {
    size::on_memory(|_| {
        // On the stack: three sides need three slots.
        let mut nodes = [SideSlot::EMPTY; 3];
        let cut = triangulate::each(&size::corners(), &[], &mut nodes, |triangle| {
            black_box(triangle);
        });
        let _ = black_box(cut.is_ok());
    });
}
