//! One triangle at 16 bits with three numbers at each corner, of which a function makes colours.
#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::{raw::RawU16, Rgb565};
use embedded_raster::Canvas;

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        let color = |[a, b, c]: [u16; 3]| Rgb565::from(RawU16::new(a ^ b ^ c));
        let _ = frame.shade_triangle_fx(size::corners(), size::values(), color);
    });
}
