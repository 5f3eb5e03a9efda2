//! Paths as SVG has them, on a framebuffer of any depth: filled, with an outline, turned and scaled.
//!
//! `cargo run --example svg -- --path "M4 4h16l-8 16z"` writes `svg.png` and shows it in the terminal; `-- --help` tells the rest.
//! How a path is drawn stands in `simulator/src/svg/scene.rs`: a call of `fill_path_fx`, and one of `stroke_path_fx`.

use std::{error::Error, process::ExitCode, str::FromStr};

use embedded_graphics::{pixelcolor::Rgb888, prelude::RgbColor};
use embedded_raster::{Affine, Angle, Cap, FillRule, Join, Path, Stroke};
use embedded_raster_simulator::{
    finish,
    svg::{draw, slots, Outline, Screen, Shape},
};
use fixed::types::{I16F16, I24F8};

const USAGE: &str = "\
usage: svg --path DATA [--path DATA ...] [--size WxH] [--bits 1|2|4|8|16|24|32] [--fill nonzero|evenodd|none]
           [--stroke WIDTH [--cap butt|square|round] [--join miter|bevel|round] [--miter-limit N]
           [--dash A,B,... [--phase N]] [--min-width]]
           [--scale F] [--rotate DEG] [--translate X,Y] [--band ROWS] [--slots N] [--out FILE.png|.pbm|.pgm]

--path DATA      what SVG has in the attribute `d`, drawn in black on white
--size WxH       size of the picture: 24x24, at most 4096x4096
--bits BITS      depth of the picture: 1
--fill RULE      what is inside of the path: nonzero
--stroke WIDTH   an outline of this width, from 0 to 65536; none unless told
--cap, --join    its ends: butt; its corners: miter
--miter-limit N  how far a corner may reach, in widths: 4
--dash LENGTHS   lengths of dashes and gaps, in turn
--phase N        where in them a contour begins: 0
--min-width      outlines are a pixel wide at least
--scale F        so many times as large, widths and dashes too
--rotate DEG     turned around 0,0 after that, clockwise
--translate X,Y  moved after that
--band ROWS      draws in bands of that many rows: the same picture with less memory
--slots N        slots of the edge table: 65535
--out FILE       where the picture goes; svg.png unless told

It prints `pixels`, how many were painted, and `slots`, how many the largest shape needs at once and how many with fewer rows at
a time.";

fn main() -> ExitCode {
    finish("svg", run(lexopt::Parser::from_env()))
}

/// Does what the arguments say, and returns what there is to say of it.
fn run(arguments: lexopt::Parser) -> Result<String, Box<dyn Error>> {
    let Some(options) = Options::parse(arguments)? else {
        return Ok(format!("{USAGE}\n"));
    };
    let shapes = options.shapes()?;
    let drawing = draw(&shapes, &options.screen)?;
    drawing.picture.write(&options.out)?;
    drawing.picture.show(100);
    let Screen { width, height, bits, .. } = options.screen;
    let (needs, out) = (slots(&shapes, &options.screen), &options.out);
    let lines = [
        format!("{out}: {width} x {height} at {bits} bit{} per pixel", if bits == 1 { "" } else { "s" }),
        format!("pixels {}", drawing.pixels),
        format!("slots {} at once, {} with fewer rows at a time", needs.whole, needs.least),
    ];
    Ok(lines.map(|line| line + "\n").concat())
}

#[derive(Debug)]
struct Options {
    paths: Vec<String>,
    screen: Screen,
    fill: Option<FillRule>,
    /// Its width is none of its own if there is no outline.
    stroke: Stroke,
    has_outline: bool,
    dashes: Vec<I24F8>,
    phase: I24F8,
    min_width: bool,
    scale: I16F16,
    rotate: I16F16,
    translate: (I16F16, I16F16),
    out: String,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            paths: vec![],
            screen: Screen { width: 24, height: 24, bits: 1, band: 4096, slots: 65_535, paper: Rgb888::WHITE },
            fill: Some(FillRule::NonZero),
            stroke: Stroke::px(1),
            has_outline: false,
            dashes: vec![],
            phase: I24F8::ZERO,
            min_width: false,
            scale: I16F16::ONE,
            rotate: I16F16::ZERO,
            translate: (I16F16::ZERO, I16F16::ZERO),
            out: "svg.png".into(),
        }
    }
}

impl Options {
    /// `None` if help was asked for.
    fn parse(mut arguments: lexopt::Parser) -> Result<Option<Self>, lexopt::Error> {
        use lexopt::prelude::*;
        let mut options = Self::default();
        while let Some(argument) = arguments.next()? {
            match argument {
                Long("path") => options.paths.push(arguments.value()?.string()?),
                Long("size") => {
                    (options.screen.width, options.screen.height) = arguments.value()?.parse_with(parse_size)?;
                }
                Long("bits") => options.screen.bits = arguments.value()?.parse_with(parse_bits)?,
                Long("fill") => options.fill = arguments.value()?.parse_with(parse_fill)?,
                Long("stroke") => {
                    options.stroke.width = arguments.value()?.parse_with(parse_width)?;
                    options.has_outline = true;
                }
                Long("cap") => options.stroke.cap = arguments.value()?.parse_with(parse_cap)?,
                Long("join") => options.stroke.join = arguments.value()?.parse_with(parse_join)?,
                Long("miter-limit") => options.stroke.miter_limit = arguments.value()?.parse_with(parse_number)?,
                Long("dash") => options.dashes = arguments.value()?.parse_with(parse_dashes)?,
                Long("phase") => options.phase = arguments.value()?.parse_with(parse_number)?,
                Long("min-width") => options.min_width = true,
                Long("scale") => options.scale = arguments.value()?.parse_with(parse_number)?,
                Long("rotate") => options.rotate = arguments.value()?.parse_with(parse_number)?,
                Long("translate") => options.translate = arguments.value()?.parse_with(parse_pair)?,
                Long("band") => options.screen.band = arguments.value()?.parse_with(parse_rows)?,
                Long("slots") => options.screen.slots = arguments.value()?.parse_with(parse_slots)?,
                Long("out") => options.out = arguments.value()?.parse_with(parse_out)?,
                Short('h') | Long("help") => return Ok(None),
                _ => return Err(argument.unexpected()),
            }
        }
        if options.paths.is_empty() {
            return Err("there is nothing to draw: --path DATA is missing".into());
        }
        Ok(Some(options))
    }

    /// What is drawn.
    fn shapes(&self) -> Result<Vec<Shape>, Box<dyn Error>> {
        let (x, y) = self.translate;
        let map = Affine::scale(self.scale, self.scale)
            .then(Affine::rotate(Angle::degrees_fx(self.rotate)))
            .then(Affine::translate(x, y));
        let scaled = |length: I24F8| {
            let wide = i64::from(length.to_bits()) * i64::from(self.scale.to_bits().unsigned_abs());
            I24F8::from_bits(i32::try_from((wide + (1 << 15)) >> 16).unwrap_or(i32::MAX))
        };
        let outline = self.has_outline.then(|| Outline {
            stroke: Stroke { width: scaled(self.stroke.width), ..self.stroke },
            dashes: self.dashes.iter().map(|&length| scaled(length)).collect(),
            phase: scaled(self.phase),
            min_width: self.min_width,
            color: Rgb888::BLACK,
        });
        let shape = |text: &String| {
            let path = Path::svg(text).map_err(|error| format!("--path: {error}"))?.mapped(map).collect();
            Ok(Shape { path, fill: self.fill.map(|rule| (rule, Rgb888::BLACK)), outline: outline.clone() })
        };
        self.paths.iter().map(shape).collect()
    }
}

fn parse_size(text: &str) -> Result<(u16, u16), &'static str> {
    let size = text.split_once(['x', 'X']).and_then(|(w, h)| Some((w.parse().ok()?, h.parse().ok()?)));
    let fits = |&(w, h): &(u16, u16)| (1..=4096).contains(&w) && (1..=4096).contains(&h);
    size.filter(fits).ok_or("--size takes WIDTHxHEIGHT, each from 1 to 4096")
}

fn parse_bits(text: &str) -> Result<u32, &'static str> {
    let bits = text.parse().ok().filter(|bits| [1, 2, 4, 8, 16, 24, 32].contains(bits));
    bits.ok_or("--bits takes one of 1, 2, 4, 8, 16, 24, 32")
}

fn parse_fill(text: &str) -> Result<Option<FillRule>, &'static str> {
    match text {
        "nonzero" => Ok(Some(FillRule::NonZero)),
        "evenodd" => Ok(Some(FillRule::EvenOdd)),
        "none" => Ok(None),
        _ => Err("--fill takes nonzero, evenodd or none"),
    }
}

fn parse_cap(text: &str) -> Result<Cap, &'static str> {
    match text {
        "butt" => Ok(Cap::Butt),
        "square" => Ok(Cap::Square),
        "round" => Ok(Cap::Round),
        _ => Err("--cap takes butt, square or round"),
    }
}

fn parse_join(text: &str) -> Result<Join, &'static str> {
    match text {
        "miter" => Ok(Join::Miter),
        "bevel" => Ok(Join::Bevel),
        "round" => Ok(Join::Round),
        _ => Err("--join takes miter, bevel or round"),
    }
}

/// A decimal number, rounded to the nearest one of its type.
fn parse_number<T: FromStr>(text: &str) -> Result<T, String> {
    text.trim().parse().map_err(|_| "a decimal number, not too large".into())
}

fn parse_width(text: &str) -> Result<I24F8, String> {
    let width = parse_number(text).ok().filter(|width| (I24F8::ZERO..=I24F8::from_num(65_536)).contains(width));
    width.ok_or_else(|| "--stroke takes a width from 0 to 65536".into())
}

fn parse_pair(text: &str) -> Result<(I16F16, I16F16), String> {
    let (x, y) = text.split_once(',').ok_or("--translate takes X,Y")?;
    Ok((parse_number(x)?, parse_number(y)?))
}

fn parse_dashes(text: &str) -> Result<Vec<I24F8>, String> {
    let lengths: Result<Vec<I24F8>, _> =
        text.split([',', ' ']).filter(|part| !part.is_empty()).map(parse_number).collect();
    let lengths = lengths.ok().filter(|lengths| lengths.iter().all(|&length| length >= 0));
    lengths.ok_or_else(|| "--dash takes lengths, 0 or more, such as 8,4".into())
}

fn parse_rows(text: &str) -> Result<u16, &'static str> {
    text.parse().ok().filter(|&rows| rows > 0).ok_or("--band takes rows from 1 to 65535")
}

fn parse_slots(text: &str) -> Result<usize, &'static str> {
    text.parse().ok().filter(|slots| (1..=65_535).contains(slots)).ok_or("--slots takes a number from 1 to 65535")
}

fn parse_out(text: &str) -> Result<String, &'static str> {
    let end = text.rsplit_once('.').map(|(_, end)| end.to_ascii_lowercase());
    let known = matches!(end.as_deref(), Some("png" | "pbm" | "pgm"));
    known.then(|| text.into()).ok_or("--out takes a name that ends with .png, .pbm or .pgm")
}
