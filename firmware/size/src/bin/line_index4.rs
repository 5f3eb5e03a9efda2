//! One line at 4 bits.
#![no_std]
#![no_main]

use embedded_raster::{Canvas, Index4};

board::entry!(main);

fn main() {
    size::on_frame::<Index4>(|frame| {
        let [a, b] = size::points();
        frame.draw_line(a, b, size::color::<Index4>());
    });
}
