//! One picture stretched to a box, at 16 bits.
#![no_std]
#![no_main]

use embedded_raster::Pictures;

board::entry!(main);

fn main() {
    size::on_picture(|frame, _, picture| frame.blit_stretched(size::area(), picture, Some));
}
