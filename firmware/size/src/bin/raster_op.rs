//! One rectangle whose bits are flipped, at 16 bits.
#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::paint::RasterOp;
use embedded_raster::raster::rectangle;
use embedded_raster::Canvas;

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        let paint = RasterOp::xor(size::color::<Rgb565>());
        frame.paint(paint, |window, brush| rectangle::fill(size::area(), window, brush));
    });
}
