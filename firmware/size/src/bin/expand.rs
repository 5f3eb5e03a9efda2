//! Eight-bit indices through a palette to 16 bits.
#![no_std]
#![no_main]

use core::hint::black_box;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::{Index8, Palette};

static INDICES: [u8; 320] = [7; 320];
/// In flash, as colours that never change are.
static PALETTE: Palette<Rgb565, 256> = Palette::new([Rgb565::new(1, 2, 3); 256]);

board::entry!(main);

fn main() {
    size::on_memory(|memory| black_box(&PALETTE).expand::<Index8, Rgb565>(black_box(&INDICES), memory));
}
