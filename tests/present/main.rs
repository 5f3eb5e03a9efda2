//! Frames on their way to a display. What can happen to buffers is explored beside them, in `src/present`.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::missing_assert_message,
    reason = "small numbers, and random ones"
)]

mod bands;
mod cores;
mod damage;
mod queues;

use embedded_raster::{Canvas, Frame, Layout, Rect};

/// Something to draw that reaches into every row.
fn scene<L: Layout>(on: &mut Frame<&mut [u8], L>, color: impl Fn(u32) -> L::Color) {
    on.clear(color(0));
    on.fill_triangle([(-5, 3), (60, 20), (20, 45)], color(1));
    on.fill_ellipse(Rect::new(18, 7, 45, 30), color(2));
    on.draw_line((0, 0), (40, 30), color(3));
}
