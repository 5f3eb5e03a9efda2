//! One picture at 16 bits, but for the pixels of one colour.
#![no_std]
#![no_main]

use core::hint::black_box;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::Bitmap;

static PICTURE: [u8; 2 * 16 * 16] = [7; 2 * 16 * 16];

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        let Ok(picture) = Bitmap::new(black_box(&PICTURE), 16, 16) else { return };
        let [at, _] = size::points();
        frame.blit_keyed(at, &picture, size::color::<Rgb565>());
    });
}
