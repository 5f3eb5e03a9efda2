//! One triangle at 16 bits with a colour at each corner.
#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::Canvas;

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        let _ = frame.shade_triangle_fx(size::corners(), size::colors(), |color| color);
    });
}
