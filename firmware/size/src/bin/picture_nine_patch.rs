//! One frame in nine parts, at 16 bits.
#![no_std]
#![no_main]

use core::hint::black_box;

use embedded_raster::{Pictures, Rect};

board::entry!(main);

fn main() {
    size::on_picture(|frame, _, picture| {
        frame.blit_nine_patch(size::area(), picture, black_box(Rect::new(5, 5, 11, 11)), Some);
    });
}
