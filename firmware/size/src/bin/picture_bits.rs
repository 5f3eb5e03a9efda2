//! One picture of one bit a pixel in two colours, at 16 bits.
#![no_std]
#![no_main]

use core::hint::black_box;

use embedded_graphics::pixelcolor::{BinaryColor, Rgb565};
use embedded_raster::{Bitmap, Canvas};

static BITS: [u8; 32] = [7; 32];

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        let Ok(picture) = Bitmap::<BinaryColor>::new(black_box(&BITS), 16, 16) else { return };
        let [at, _] = size::points();
        frame.blit_mask(at, &picture, size::color::<Rgb565>(), size::color::<Rgb565>());
    });
}
