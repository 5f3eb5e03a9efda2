//! Text of embedded-graphics on this crate's framebuffer, at 16 bits.
#![no_std]
#![no_main]

use core::hint::black_box;

use embedded_graphics::mono_font::{ascii::FONT_6X10, MonoTextStyle};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::text::Text;

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        let [at, _] = size::points();
        let style = MonoTextStyle::new(&FONT_6X10, size::color::<Rgb565>());
        let Ok(_) = Text::new(black_box("Hello"), at, style).draw(frame);
    });
}
