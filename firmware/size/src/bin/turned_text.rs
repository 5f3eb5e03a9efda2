//! Text on a screen that is turned, at 16 bits.
#![no_std]
#![no_main]

use core::hint::black_box;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::surface::{Turn, Turned};
use embedded_raster::text::{Style, FONT_6X10};

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        let mut upright = Turned::new(frame, black_box(Turn::Quarter));
        let [at, _] = size::points();
        Style::new(&FONT_6X10, size::color::<Rgb565>()).draw(&mut upright, at, black_box("Hello"));
    });
}
