//! A picture of many colours in few: the nearest one, ordered dither in three sizes, and error diffusion in two ways.
//!
//! `cargo run --release --example dither` writes `dither.png`, six panels in the 16 colours of EGA, of a picture that it makes;
//! `-- --input FILE.png` takes another one, `--palette auto:16` the best 16 colours of the picture, `--palette FILE` those of a file.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "a picture that is made of light and shade, in floats"
)]

use std::{error::Error, fs, process::ExitCode};

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{PixelColor, Rgb888, RgbColor},
};
use embedded_raster::{
    paint::Bayer,
    pixel::{Atkinson, ColorCube, FloydSteinberg, EGA},
    Framebuffer, Index1, Index2, Index4, Index8, Palette, PixelFormat, Surface,
};
use embedded_raster_simulator::{finish, palettes, quantize, Picture};

const USAGE: &str = "\
usage: dither [--input FILE.png] [--palette ega|mono|auto:N|FILE] [--constant NAME] [--out FILE.png]

--input FILE.png   the picture: one that the program makes
--palette ega      the 16 colours of EGA
--palette mono     black and white; --colors 2 is the same, --colors 16 is EGA
--palette auto:N   the N colours, 2 to 256, that show the picture best
--palette FILE     those of a file: .gpl, JASC .pal, .act or hexadecimal
--constant NAME    prints the palette as a constant of a Rust program, too
--out FILE.png     what is written: dither.png
";

fn main() -> ExitCode {
    finish("dither", run(lexopt::Parser::from_env()))
}

fn run(mut arguments: lexopt::Parser) -> Result<String, Box<dyn Error>> {
    use lexopt::prelude::*;
    let (mut input, mut source, mut constant) = (None, Source::Ega, None);
    let mut out = "dither.png".to_owned();
    while let Some(argument) = arguments.next()? {
        match argument {
            Long("input") => input = Some(arguments.value()?.string()?),
            Long("colors") => source = arguments.value()?.parse_with(parse_colors)?,
            Long("palette") => source = arguments.value()?.parse_with(Source::parse)?,
            Long("constant") => constant = Some(arguments.value()?.parse_with(parse_constant)?),
            Long("out" | "output") => out = arguments.value()?.string()?,
            Short('h') | Long("help") => return Ok(USAGE.into()),
            _ => return Err(argument.unexpected().into()),
        }
    }
    let picture = match input {
        Some(path) => Picture::read_png(&path).map_err(|error| format!("{path}: {error}"))?,
        None => ball(),
    };
    let colors = source.colors(&picture)?;
    let sheet = draw(&picture, &colors)?;
    sheet.write_png(&out)?;
    sheet.show(100);
    let constant = constant.map_or(String::new(), |name| palettes::to_rust(&name, &colors));
    Ok(format!("{constant}{out}: {} x {}, of {} colours\n", sheet.width(), sheet.height(), colors.len()))
}

/// The panels, in as few bits as the colours need.
fn draw(picture: &Picture, colors: &[Rgb888]) -> Result<Picture, Box<dyn Error>> {
    match colors.len() {
        0 => Err("the picture has no pixels".into()),
        1..=2 => panels::<Index1, 2>(picture, colors),
        3..=4 => panels::<Index2, 4>(picture, colors),
        5..=16 => panels::<Index4, 16>(picture, colors),
        _ => panels::<Index8, 256>(picture, colors),
    }
}

/// Where the palette comes from.
enum Source {
    Ega,
    Mono,
    Auto(usize),
    File(String),
}

impl Source {
    fn parse(text: &str) -> Result<Self, &'static str> {
        match text {
            "ega" => Ok(Self::Ega),
            "mono" => Ok(Self::Mono),
            _ => match text.strip_prefix("auto:") {
                Some(count) => {
                    let count = count.parse().ok().filter(|count| (2..=256).contains(count));
                    count.map(Self::Auto).ok_or("--palette auto:N takes 2 to 256")
                }
                None => Ok(Self::File(text.into())),
            },
        }
    }

    fn colors(&self, picture: &Picture) -> Result<Vec<Rgb888>, Box<dyn Error>> {
        Ok(match self {
            Self::Ega => EGA.colors().to_vec(),
            Self::Mono => vec![Rgb888::BLACK, Rgb888::WHITE],
            Self::Auto(count) => quantize::palette(picture, *count),
            Self::File(path) => {
                let file = fs::read(path).map_err(|error| format!("{path}: {error}"))?;
                palettes::parse(&file).map_err(|error| format!("{path}: {error}"))?
            }
        })
    }
}

fn parse_colors(text: &str) -> Result<Source, &'static str> {
    match text {
        "2" => Ok(Source::Mono),
        "16" => Ok(Source::Ega),
        _ => Err("--colors takes 2 or 16"),
    }
}

fn parse_constant(text: &str) -> Result<String, &'static str> {
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let is_name = text.chars().all(is_part) && text.starts_with(|c: char| !c.is_ascii_digit());
    is_name.then(|| text.into()).ok_or("--constant takes a name such as SUNSET")
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

/// How far thresholds move a level: the mean distance from a colour to the nearest other one, in the channel that differs most.
fn spread(colors: &[Rgb888]) -> u8 {
    let away = |a: &Rgb888, b: &Rgb888| a.r().abs_diff(b.r()).max(a.g().abs_diff(b.g())).max(a.b().abs_diff(b.b()));
    let nearest = |a: &Rgb888| colors.iter().filter(|b| *b != a).map(|b| away(a, b)).min().unwrap_or(0);
    let sum: usize = colors.iter().map(|color| usize::from(nearest(color))).sum();
    u8::try_from(sum / colors.len().max(1)).unwrap_or(u8::MAX)
}

/// Six ways, in two rows, in indices of a palette of `N` entries; the first of the colours fills what is left of it.
fn panels<C, const N: usize>(picture: &Picture, colors: &[Rgb888]) -> Result<Picture, Box<dyn Error>>
where
    C: PixelFormat<Color = C> + PixelColor + Into<u8>,
{
    let palette: Palette<Rgb888, N> =
        Palette::new(std::array::from_fn(|index| *colors.get(index).unwrap_or(&colors[0])));
    let side = |n: usize, panels: u16| u16::try_from(n).ok().filter(|&n| n <= u16::MAX / panels);
    let (Some(width), Some(height)) = (side(picture.width(), 3), side(picture.height(), 2)) else {
        let (width, height) = (picture.width(), picture.height());
        return Err(format!("the picture is {width} x {height}: six panels take 21845 x 32767 at most").into());
    };
    let size = (3 * width, 2 * height);
    let mut ram = vec![0; embedded_raster::buffer_bytes::<C>(size.0, size.1)];
    let mut frame = Framebuffer::<C>::new(&mut ram[..], size.0, size.1)?;
    let cube = ColorCube::<32_768>::new(&palette);
    let nearest = |[r, g, b]: [u8; 3]| {
        let index = cube.nearest(Rgb888::new(r, g, b));
        let shown = palette.get(index).unwrap_or_default();
        (C::unpack(index.into()), [shown.r(), shown.g(), shown.b()])
    };
    let (mut row, mut rows) = (vec![[0; 3]; width.into()], vec![[[0; 3]; 2]; width.into()]);
    let mut floyd_steinberg = FloydSteinberg::new(&mut row);
    let mut atkinson = Atkinson::new(&mut rows);
    let spread = spread(colors);
    let mut ways: [&mut dyn FnMut([u8; 3], Point) -> C; 6] = [
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
    Ok(Picture::indexed(&frame, &palette))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Six panels of the picture that the program makes.
    fn sheet(source: &str) -> Picture {
        let colors = Source::parse(source).expect("a palette").colors(&ball()).expect("colours");
        draw(&ball(), &colors).expect("a picture")
    }

    /// How far the means of blocks of 8 x 8 pixels are from those of the picture: what the eye sees from afar.
    fn mean_error(sheet: &Picture, panel: usize) -> f64 {
        let picture = ball();
        let mean = |picture: &Picture, left: usize, top: usize| {
            let all = (0..64).filter_map(|n| picture.color(left + n % 8, top + n / 8));
            let sum =
                all.fold([0_u32; 3], |[r, g, b], c| [r + u32::from(c.r()), g + u32::from(c.g()), b + u32::from(c.b())]);
            sum.map(|sum| f64::from(sum) / 64.0)
        };
        let (left, top) = (panel % 3 * 96, panel / 3 * 96);
        let blocks = (0..144).map(|n| (n % 12 * 8, n / 12 * 8));
        let errors = blocks.map(|(x, y)| {
            let (a, b) = (mean(&picture, x, y), mean(sheet, left + x, top + y));
            a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>()
        });
        (errors.sum::<f64>() / 144.0 / 3.0).sqrt()
    }

    #[test]
    fn colors_of_the_picture_show_it_better() {
        let (ega, own) = (sheet("ega"), sheet("auto:16"));
        for panel in [0, 3, 4, 5] {
            let (ega, own) = (mean_error(&ega, panel), mean_error(&own, panel));
            assert!(own < ega, "panel {panel}: {own} against {ega}");
        }
        let errors = [0, 3, 4].map(|panel| mean_error(&own, panel));
        assert!(errors[1] < errors[0] && errors[2] < errors[0], "dither shows more: {errors:?}");
    }

    #[test]
    fn a_palette_has_the_depth_that_it_needs() {
        for (source, bits) in [("mono", 1), ("auto:3", 2), ("auto:5", 4), ("ega", 4), ("auto:17", 8), ("auto:256", 8)] {
            let sheet = sheet(source);
            let embedded_raster_simulator::Pixels::Indexed { bits: found, .. } = sheet.pixels() else {
                panic!("not indexed")
            };
            assert_eq!(*found, bits, "{source}");
        }
    }

    #[test]
    fn palettes_come_from_files_and_go_to_programs() {
        let [file, out] = ["gpl", "png"].map(|end| {
            let path = std::env::temp_dir().join(format!("dither-file-{}.{end}", std::process::id()));
            path.to_str().expect("a plain name").to_owned()
        });
        fs::write(&file, "GIMP Palette\n#\n0 0 0 night\n255 240 200 day\n").expect("a file");
        let arguments = ["--palette", &file, "--constant", "DAY", "--out", &out];
        let said = run(lexopt::Parser::from_args(arguments)).expect("a picture");
        assert!(said.starts_with("pub const DAY: Palette<Rgb888, 2> = ") && said.contains("(255, 240, 200)"), "{said}");
        for file in [file, out] {
            fs::remove_file(file).expect("it is there");
        }
    }

    #[test]
    fn pictures_that_are_too_wide_are_told_with_their_size() {
        let wide = Picture::from_colors(21_846, 1, vec![Rgb888::WHITE; 21_846]);
        let error = draw(&wide, &[Rgb888::WHITE]).expect_err("too wide").to_string();
        assert_eq!(error, "the picture is 21846 x 1: six panels take 21845 x 32767 at most");
    }

    #[test]
    fn wrong_arguments_are_told_in_a_line() {
        for (arguments, expected) in [
            ("--palette auto:1", r#"cannot parse argument "auto:1": --palette auto:N takes 2 to 256"#),
            ("--palette no-such.gpl", "no-such.gpl: "),
            ("--palette Cargo.toml", "Cargo.toml: line 1 is no colour"),
            ("--constant 3D", r#"cannot parse argument "3D": --constant takes a name such as SUNSET"#),
            ("--colors 3", r#"cannot parse argument "3": --colors takes 2 or 16"#),
            ("--input Cargo.toml", "Cargo.toml: "),
        ] {
            let error = run(lexopt::Parser::from_args(arguments.split(' '))).map(|said| said.len());
            let error = error.expect_err(arguments).to_string();
            assert!(error.starts_with(expected) && !error.contains('\n'), "{arguments}: {error}");
        }
    }
}
