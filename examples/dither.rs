//! A picture of many colours in few: the nearest one, ordered dither in three sizes, and error diffusion in two ways.
//!
//! `cargo run --release --example dither` writes `dither.png`, six panels in the 16 colours of EGA, of a picture that it makes;
//! `-- --input FILE.png` takes another one, `--colors 2` black and white, `--out FILE.png` names the file.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "a picture that is made of light and shade, in floats"
)]

use std::{error::Error, process::ExitCode};

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{Rgb888, RgbColor},
};
use embedded_raster::{
    paint::Bayer,
    pixel::{Atkinson, ColorCube, FloydSteinberg, EGA},
    Framebuffer, Index4, Palette, Surface,
};
use embedded_raster_simulator::{finish, Picture};

const USAGE: &str = "\
usage: dither [--input FILE.png] [--colors 2|16] [--out FILE.png]

--input FILE.png  the picture: one that the program makes
--colors 2|16     black and white, or the colours of EGA: 16
--out FILE.png    what is written: dither.png
";

fn main() -> ExitCode {
    finish("dither", run(lexopt::Parser::from_env()))
}

fn run(mut arguments: lexopt::Parser) -> Result<String, Box<dyn Error>> {
    use lexopt::prelude::*;
    let (mut input, mut colors, mut out) = (None, 16, "dither.png".to_owned());
    while let Some(argument) = arguments.next()? {
        match argument {
            Long("input") => input = Some(arguments.value()?.string()?),
            Long("colors") => colors = arguments.value()?.parse_with(parse_colors)?,
            Long("out" | "output") => out = arguments.value()?.string()?,
            Short('h') | Long("help") => return Ok(USAGE.into()),
            _ => return Err(argument.unexpected().into()),
        }
    }
    let picture = match input {
        Some(path) => Picture::read_png(&path).map_err(|error| format!("{path}: {error}"))?,
        None => ball(),
    };
    let palette = if colors == 2 {
        Palette::new([EGA.colors()[0], EGA.colors()[15]].repeat(8).try_into().expect("16"))
    } else {
        EGA
    };
    let sheet = panels(&picture, &palette)?;
    sheet.write_png(&out)?;
    sheet.show(100);
    Ok(format!("{out}: {} x {}, of {colors} colours\n", sheet.width(), sheet.height()))
}

fn parse_colors(text: &str) -> Result<usize, &'static str> {
    match text {
        "2" => Ok(2),
        "16" => Ok(16),
        _ => Err("--colors takes 2 or 16"),
    }
}

/// A ball with a light on it, in front of a sky.
fn ball() -> Picture {
    let size = 96.0_f32;
    let pixels = (0..96 * 96).map(|n| {
        let (x, y) = ((n % 96) as f32 / size * 2.0 - 1.0, (n / 96) as f32 / size * 2.0 - 1.0);
        let square = (x * x + y * y) / 0.7;
        let level = |n: f32| (n * 255.0).clamp(0.0, 255.0) as u8;
        if square > 1.0 {
            let height = 0.5 + y / 2.0;
            return Rgb888::new(level(0.2 + 0.7 * height), level(0.4 + 0.5 * height), level(0.8 + 0.2 * height));
        }
        let z = (1.0 - square).sqrt();
        let light = (0.6 * z - 0.5 * x - 0.6 * y).max(0.0);
        Rgb888::new(level(0.15 + light), level(0.1 + 0.5 * light * light), level(0.1 + 0.4 * light.powi(6)))
    });
    Picture::from_colors(96, 96, pixels.collect())
}

/// Six ways, in two rows.
fn panels(picture: &Picture, palette: &Palette<Rgb888, 16>) -> Result<Picture, Box<dyn Error>> {
    let (width, height) = (u16::try_from(picture.width())?, u16::try_from(picture.height())?);
    let size = (width.checked_mul(3).ok_or("the picture is too wide")?, height.checked_mul(2).ok_or("too high")?);
    let mut ram = vec![0; embedded_raster::buffer_bytes::<Index4>(size.0, size.1)];
    let mut frame = Framebuffer::<Index4>::new(&mut ram[..], size.0, size.1)?;
    let cube = ColorCube::<32_768>::new(palette);
    let nearest = |[r, g, b]: [u8; 3]| {
        let index = cube.nearest(Rgb888::new(r, g, b));
        let shown = palette.get(index).unwrap_or_default();
        (Index4::new(index), [shown.r(), shown.g(), shown.b()])
    };
    let (mut row, mut rows) = (vec![[0; 3]; width.into()], vec![[[0; 3]; 2]; width.into()]);
    let mut floyd_steinberg = FloydSteinberg::new(&mut row);
    let mut atkinson = Atkinson::new(&mut rows);
    // How far thresholds move a level: half of the distance between the colours of the palette, about.
    let spread = if palette.colors()[1] == palette.colors()[15] { 255 } else { 96 };
    let mut ways: [&mut dyn FnMut([u8; 3], Point) -> Index4; 6] = [
        &mut |rgb, _| nearest(rgb).0,
        &mut |rgb, at| nearest(rgb.map(|level| Bayer::<2>::moved(level, spread, at))).0,
        &mut |rgb, at| nearest(rgb.map(|level| Bayer::<4>::moved(level, spread, at))).0,
        &mut |rgb, at| nearest(rgb.map(|level| Bayer::<8>::moved(level, spread, at))).0,
        &mut |rgb, _| floyd_steinberg.next(rgb, nearest),
        &mut |rgb, _| atkinson.next(rgb, nearest),
    ];
    for (number, way) in (0..).zip(&mut ways) {
        let (left, top) = (number % 3 * i32::from(width), number / 3 * i32::from(height));
        for (at, color) in (0..).zip(picture.colors()) {
            let (x, y) = (at % i32::from(width), at / i32::from(width));
            let index = way([color.r(), color.g(), color.b()], Point::new(x, y));
            frame.set(Point::new(left + x, top + y), index);
        }
    }
    Ok(Picture::indexed(&frame, palette))
}
