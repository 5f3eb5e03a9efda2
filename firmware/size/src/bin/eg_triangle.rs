//! The peer of `triangle`: one triangle of embedded-graphics on its own framebuffer.
#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::{PrimitiveStyle, Triangle};

board::entry!(main);

fn main() {
    size::on_eg(|frame| {
        let [a, b, c] = size::corners().map(|corner| corner.pixel());
        let style = PrimitiveStyle::with_fill(size::color::<Rgb565>());
        let Ok(()) = Triangle::new(a, b, c).into_styled(style).draw(frame);
    });
}
