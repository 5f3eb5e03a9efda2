//! One picture at 16 bits.
#![no_std]
#![no_main]

use embedded_raster::Canvas;

board::entry!(main);

fn main() {
    size::on_picture(|frame, at, picture| frame.blit(at, picture));
}
