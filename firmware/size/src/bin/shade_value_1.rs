//! One triangle at 16 bits with one number at each corner, of which a function makes colours.
#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::{raw::RawU16, Rgb565};
use embedded_raster::Canvas;

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        let values = size::values().map(|[value, ..]| value);
        let _ = frame.shade_triangle_fx(size::corners(), values, |value| Rgb565::from(RawU16::new(value)));
    });
}
