//! A row of greys in fewer levels, in place, by ordered dither.
#![no_std]
#![no_main]

use core::hint::black_box;

use embedded_graphics::pixelcolor::Gray8;
use embedded_graphics::prelude::{GrayColor, Point};
use embedded_raster::paint::Bayer;
use embedded_raster::{Readable, Span};

board::entry!(main);

fn main() {
    size::on_frame::<Gray8>(|frame| {
        let Some(span) = black_box(Span { y: 7, x0: -5, x1: 300 }).clip(frame.window()) else { return };
        frame.edit_span(span, |x, old| Gray8::new(Bayer::<4>::shade(old.luma(), 15, Point::new(x, span.y())) * 17));
    });
}
