//! The peer of `line`: one line of embedded-graphics on its own framebuffer.
#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::{Line, PrimitiveStyle};

board::entry!(main);

fn main() {
    size::on_eg(|frame| {
        let [a, b] = size::points();
        let style = PrimitiveStyle::with_stroke(size::color::<Rgb565>(), 1);
        let Ok(()) = Line::new(a, b).into_styled(style).draw(frame);
    });
}
