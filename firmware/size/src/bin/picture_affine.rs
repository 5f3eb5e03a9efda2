//! One picture under a map, at 16 bits. The map is not made here: an angle would link a sine.
#![no_std]
#![no_main]

use core::hint::black_box;

use embedded_raster::fixed::types::I16F16;
use embedded_raster::{Affine, Pictures};

board::entry!(main);

fn main() {
    size::on_picture(|frame, _, picture| {
        let map = [60_000, -30_000, 700_000, 30_000, 60_000, 900_000].map(|bits| I16F16::from_bits(black_box(bits)));
        let [xx, xy, dx, yx, yy, dy] = map;
        let _ = frame.blit_affine(&Affine { xx, xy, dx, yx, yy, dy }, picture, Some);
    });
}
