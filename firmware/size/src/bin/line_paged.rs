//! One line on pages of eight rows to a byte, as small OLEDs have them.
#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::BinaryColor;
use embedded_raster::{surface::Paged, Canvas};

board::entry!(main);

fn main() {
    size::on_memory(|memory| {
        let [a, b] = size::points();
        if let Ok(mut oled) = Paged::<BinaryColor>::new(memory, 128, 64) {
            oled.draw_line(a, b, size::color::<BinaryColor>());
        }
    });
}
