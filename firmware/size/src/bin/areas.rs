//! Rectangles of pixels at 16 bits, from three places of a program: beside `area` this shows what a second caller costs.
#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::{Framebuffer, Rect, Surface};

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        panel(frame);
        bar(frame, size::points()[1].x);
        cursor(frame);
    });
}

#[inline(never)]
fn panel(frame: &mut Framebuffer<'_, Rgb565>) {
    frame.fill_area(size::area(), size::color::<Rgb565>());
}

/// As wide as a value says.
#[inline(never)]
fn bar(frame: &mut Framebuffer<'_, Rgb565>, value: i32) {
    frame.fill_area(Rect::new(10, 220, value, 230), size::color::<Rgb565>());
}

#[inline(never)]
fn cursor(frame: &mut Framebuffer<'_, Rgb565>) {
    let [at, _] = size::points();
    frame.fill_area(Rect::new(at.x, at.y, at.x.wrapping_add(2), at.y.wrapping_add(16)), size::color::<Rgb565>());
}
