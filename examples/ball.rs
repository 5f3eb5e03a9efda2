//! A ball that bounces, and goes where the arrow keys say: a whole program for the desktop.
//!
//! `cargo run --release --example ball` opens a window; `-- --frames 60 --out ball.gif`, or no display, writes a file.

use std::process::ExitCode;

use embedded_raster::{pixel::EGA, Canvas, Index4, Rect};
use embedded_raster_simulator::{finish, run, Key};

fn main() -> ExitCode {
    let mut x = 72;
    let played = run((160, 120), EGA, |frame, input, time| {
        x += i32::from(input.is_down(Key::Right)) - i32::from(input.is_down(Key::Left));
        let y = 100 - (900 - (time.frame % 60 - 30).pow(2)) / 10;
        frame.clear(Index4::new(1));
        frame.fill_ellipse(Rect::new(x, y, x + 16, y + 16), Index4::new(14));
        Ok(())
    });
    finish("ball", played)
}
