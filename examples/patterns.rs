//! Hatchings, shades and raster operations at one bit per pixel: what tells areas apart where there are no colours.
//!
//! `cargo run --release --example patterns` writes `patterns.png`; `-- --out FILE.png` another file.

use std::{error::Error, process::ExitCode};

use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
use embedded_raster::{
    buffer_bytes,
    paint::{
        pattern::{self, Pattern},
        RasterOp,
    },
    raster::{arc, rectangle},
    Canvas, Ellipse, Framebuffer, Index1, Palette, Rect, Sector,
};
use embedded_raster_simulator::{finish, Picture};

const SIZE: (u16, u16) = (176, 128);

const HATCHINGS: [[u8; 8]; 9] = [
    pattern::HORIZONTAL,
    pattern::VERTICAL,
    pattern::DIAGONAL,
    pattern::BACK_DIAGONAL,
    pattern::GRID,
    pattern::DIAGONAL_GRID,
    pattern::CHECKER,
    pattern::DOTS,
    pattern::BRICKS,
];

fn main() -> ExitCode {
    finish("patterns", run(lexopt::Parser::from_env()))
}

fn run(mut arguments: lexopt::Parser) -> Result<String, Box<dyn Error>> {
    use lexopt::prelude::*;
    let mut out = "patterns.png".to_owned();
    while let Some(argument) = arguments.next()? {
        match argument {
            Long("out" | "output") => out = arguments.value()?.string()?,
            Short('h') | Long("help") => return Ok("usage: patterns [--out FILE.png]\n".into()),
            _ => return Err(argument.unexpected().into()),
        }
    }
    let picture = draw()?;
    picture.write_png(&out)?;
    picture.show(100);
    Ok(format!("{out}: {} x {}\n", SIZE.0, SIZE.1))
}

fn draw() -> Result<Picture, Box<dyn Error>> {
    let mut ram = [0; buffer_bytes::<Index1>(SIZE.0, SIZE.1)];
    let mut frame = Framebuffer::<Index1>::new(&mut ram, SIZE.0, SIZE.1)?;
    let ink = Index1::new(1);

    // A chart. Its parts touch, and the patterns are fixed to the screen, so that they have no seam.
    let pie = Rect::new(4, 4, 73, 73);
    let shares = [9, 5, 4, 3, 2, 1];
    let whole: u32 = shares.iter().sum();
    let mut start = 0;
    let parts = [pattern::DIAGONAL, pattern::DOTS, pattern::CHECKER, pattern::VERTICAL, pattern::GRID, pattern::BRICKS];
    for (share, rows) in shares.into_iter().zip(parts) {
        let sector = Sector::slice(start, share, u16::try_from(whole)?);
        let part = Pattern::new(rows, ink, Some(Index1::new(0)));
        frame.paint(part, |window, brush| arc::fill(Ellipse::in_box(pie), sector, window, brush));
        start += share;
    }
    frame.draw_ellipse(pie, ink);

    // The nine hatchings.
    for (number, rows) in (0..).zip(HATCHINGS) {
        let (left, top) = (80 + number % 3 * 31, 4 + number / 3 * 24);
        let area = Rect::new(left, top, left + 28, top + 21);
        frame
            .paint(Pattern::new(rows, ink, None).at((left, top)), |window, brush| rectangle::fill(area, window, brush));
        frame.draw_rectangle(area, ink);
    }

    // From black to white in 21 steps of shades.
    for step in 0..21_i32 {
        let left = 4 + step * 8;
        let shade = Pattern::new(pattern::shade(step.unsigned_abs() * 64 / 20), ink, None);
        frame.paint(shade, |window, brush| rectangle::fill(Rect::new(left, 82, left + 8, 100), window, brush));
    }

    // A menu: the line that is chosen is the negative of what it was.
    for (line, rows) in (0..).zip([pattern::DOTS, pattern::CHECKER]) {
        let area = Rect::new(6, 106 + 10 * line, 100 + 40 * line, 112 + 10 * line);
        frame.paint(Pattern::new(rows, ink, None), |window, brush| rectangle::fill(area, window, brush));
    }
    frame.paint(RasterOp::invert(), |window, brush| rectangle::fill(Rect::new(4, 104, 172, 114), window, brush));
    Ok(Picture::indexed(&frame, &Palette::new([Rgb888::WHITE, Rgb888::BLACK])))
}
