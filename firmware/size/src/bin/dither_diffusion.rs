//! A grey picture on one bit, by error diffusion.
#![no_std]
#![no_main]

use core::hint::black_box;

use embedded_graphics::pixelcolor::{BinaryColor, Gray8};
use embedded_graphics::prelude::GrayColor;
use embedded_raster::pixel::FloydSteinberg;
use embedded_raster::{Bitmap, Pictures};

static LEVELS: [u8; 256] = [70; 256];

board::entry!(main);

fn main() {
    size::on_frame::<BinaryColor>(|frame| {
        let Ok(picture) = Bitmap::<Gray8>::new(black_box(&LEVELS), 16, 16) else { return };
        let [at, _] = size::points();
        let mut row = [[0; 1]; 16];
        let mut rule = FloydSteinberg::new(&mut row);
        frame.blit_mapped(at, &picture, |color: Gray8| {
            Some(rule.next([color.luma()], |[level]| {
                (BinaryColor::from(level >= 128), [if level >= 128 { 255 } else { 0 }])
            }))
        });
    });
}
