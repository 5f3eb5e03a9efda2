//! One triangle at 4 bits.
#![no_std]
#![no_main]

use embedded_raster::{Canvas, Index4};

board::entry!(main);

fn main() {
    size::on_frame::<Index4>(|frame| frame.fill_triangle_fx(size::corners(), size::color::<Index4>()));
}
