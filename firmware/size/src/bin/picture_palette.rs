//! One picture of 8-bit indices through a palette, at 16 bits.
#![no_std]
#![no_main]

use core::hint::black_box;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::{Bitmap, Index8, Palette, Pictures};

static INDICES: [u8; 256] = [7; 256];
/// In flash, as colours that never change are.
static PALETTE: Palette<Rgb565, 256> = Palette::new([Rgb565::new(1, 2, 3); 256]);

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        let Ok(picture) = Bitmap::<Index8>::new(black_box(&INDICES), 16, 16) else { return };
        let (palette, [at, _]) = (black_box(&PALETTE), size::points());
        frame.blit_mapped(at, &picture, |index: Index8| palette.get(index.into()));
    });
}
