//! Paths as SVG has them, on a framebuffer of any depth: filled, with an outline, turned and scaled.
//!
//! `cargo run --example svg -- --path "M4 4h16l-8 16z"` writes `svg.png` and shows it in the terminal; `-- --help` tells the rest.
//! How a path is drawn stands in `simulator/src/svg/scene.rs`: a call of `fill_path_fx`, and one of `stroke_path_fx`.

use std::{
    collections::BTreeSet,
    error::Error,
    fs,
    io::{self, Write},
    process::ExitCode,
    str::FromStr,
};

use embedded_graphics::{pixelcolor::Rgb888, prelude::RgbColor};
use embedded_raster::{raster::polygon::drop_out::DropOut, Affine, Angle, Cap, FillRule, Join, Path, Stroke};
use embedded_raster_simulator::{
    finish, show,
    svg::{draw, slots, Drawing, File, Outline, Screen, Shape},
    Key, Shot,
};
use fixed::types::{I16F16, I24F8};

const USAGE: &str = "\
usage: svg --path DATA [--path DATA ...] | --input FILE.svg [--size WxH] [--bits 1|2|4|8|16|24|32] [--fill nonzero|evenodd|none]
           [--dropout[=simple|smart|simple-no-stubs|smart-no-stubs]]
           [--stroke WIDTH [--cap butt|square|round] [--join miter|bevel|round] [--miter-limit N]
           [--dash A,B,... [--phase N]] [--min-width[=WIDTH]]]
           [--scale F] [--rotate DEG] [--translate X,Y] [--band ROWS] [--slots N] [--out FILE.png|.pbm|.pgm] [--window]

--path DATA      what SVG has in the attribute `d`, drawn in black on white
--input FILE     an SVG file, in its own colours: paths, basic shapes, groups, transforms, fills and outlines; what it asks
                 for beyond that is named on standard error. Path data that makes no sense is drawn as far as it does, and then
                 is an error
--size WxH       size of the picture: 24x24, or that of the file; at most 4096x4096
--bits BITS      depth of the picture: 1
--fill RULE      what is inside of the path: nonzero
--dropout        also draws what lies between the centres of pixels: smart
--stroke WIDTH   an outline of this width, from 0 to 65536; none unless told
--cap, --join    its ends: butt; its corners: miter
--miter-limit N  how far a corner may reach, in widths: 4
--dash LENGTHS   lengths of dashes and gaps, in turn
--phase N        where in them a contour begins: 0
--min-width      the least width of outlines: a pixel, also if not told; --min-width=0 for what covers centres of pixels only
--scale F        so many times as large, widths and dashes too
--rotate DEG     turned around 0,0 after that, clockwise
--translate X,Y  moved after that
--band ROWS      draws in bands of that many rows: the same picture with less memory
--slots N        slots of the edge table: 65535
--out FILE       where the picture goes; svg.png unless told
--window         shows it: left and right turn it, + and - change its size, D the depth, Esc quits

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
    if options.window {
        return watch(options);
    }
    let Scene { shapes, screen, unknown, error } = options.scene()?;
    for what in unknown {
        writeln!(io::stderr(), "svg: not drawn as it should be: {what}")?;
    }
    let drawing = draw(&shapes, &screen)?;
    drawing.picture.write(&options.out)?;
    drawing.picture.show(100);
    let Screen { width, height, bits, .. } = screen;
    let (needs, out) = (slots(&shapes, &screen), &options.out);
    let lines = [
        format!("{out}: {width} x {height} at {bits} bit{} per pixel", if bits == 1 { "" } else { "s" }),
        format!("pixels {}", drawing.pixels),
        format!("slots {} at once, {} with fewer rows at a time", needs.whole, needs.least),
    ];
    let text = lines.map(|line| line + "\n").concat();
    match error {
        None => Ok(text),
        Some(error) => {
            write!(io::stdout(), "{text}")?;
            Err(error.into())
        }
    }
}

/// What is drawn, and on what.
struct Scene {
    shapes: Vec<Shape>,
    screen: Screen,
    /// What a file asks for in vain.
    unknown: BTreeSet<String>,
    /// Path data of a file that makes no sense: it is drawn as far as it does.
    error: Option<String>,
}

/// Shows it in a window, and does what the keys say.
fn watch(mut options: Options) -> Result<String, Box<dyn Error>> {
    // The window stays as large as it was.
    (options.screen, options.is_sized) = (options.scene()?.screen, true);
    let first = options.shot()?;
    show::<Box<dyn Error>>("svg", first, |keys| {
        let mut is_new = false;
        for key in keys {
            let (scale, rotate) = (options.scale, options.rotate);
            match key {
                Key::Left => options.rotate = (rotate - I16F16::from_num(5)) % I16F16::from_num(360),
                Key::Right => options.rotate = (rotate + I16F16::from_num(5)) % I16F16::from_num(360),
                Key::Equal | Key::NumPadPlus => options.scale = scale.saturating_mul(I16F16::from_num(1.125)),
                Key::Minus | Key::NumPadMinus => options.scale = scale / I16F16::from_num(1.125),
                Key::D => options.screen.bits = next(&[1, 2, 4, 8, 16, 24, 32], options.screen.bits),
                _ => continue,
            }
            is_new = true;
        }
        is_new.then(|| options.shot()).transpose()
    })
    .map_err(|error| format!("{error} (a window needs a display; without --window, a file is written)"))?;
    Ok(String::new())
}

/// The one after `current`, the first one after the last.
fn next<T: Copy + PartialEq>(all: &[T], current: T) -> T {
    let at = all.iter().position(|&one| one == current).unwrap_or(0);
    all[(at + 1) % all.len()]
}

#[derive(Debug)]
struct Options {
    paths: Vec<String>,
    input: Option<String>,
    /// The size of the screen was told.
    is_sized: bool,
    screen: Screen,
    fill: Option<FillRule>,
    drop_out: Option<DropOut>,
    /// Its width is none of its own if there is no outline.
    stroke: Stroke,
    has_outline: bool,
    dashes: Vec<I24F8>,
    phase: I24F8,
    scale: I16F16,
    rotate: I16F16,
    translate: (I16F16, I16F16),
    out: String,
    window: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            paths: vec![],
            input: None,
            is_sized: false,
            screen: Screen { width: 24, height: 24, bits: 1, band: 4096, slots: 65_535, paper: Rgb888::WHITE },
            fill: Some(FillRule::NonZero),
            drop_out: None,
            stroke: Stroke::px(1),
            has_outline: false,
            dashes: vec![],
            phase: I24F8::ZERO,
            scale: I16F16::ONE,
            rotate: I16F16::ZERO,
            translate: (I16F16::ZERO, I16F16::ZERO),
            out: "svg.png".into(),
            window: false,
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
                Long("input") => options.input = Some(arguments.value()?.string()?),
                Long("size") => {
                    options.is_sized = true;
                    (options.screen.width, options.screen.height) = arguments.value()?.parse_with(parse_size)?;
                }
                Long("bits") => options.screen.bits = arguments.value()?.parse_with(parse_bits)?,
                Long("fill") => options.fill = arguments.value()?.parse_with(parse_fill)?,
                Long("dropout") => {
                    let kind = arguments.optional_value();
                    options.drop_out = Some(kind.map_or(Ok(DropOut::SMART), |kind| kind.parse_with(parse_drop_out))?);
                }
                Long("stroke") => {
                    options.stroke.width = arguments.value()?.parse_with(parse_width)?;
                    options.has_outline = true;
                }
                Long("cap") => options.stroke.cap = arguments.value()?.parse_with(parse_cap)?,
                Long("join") => options.stroke.join = arguments.value()?.parse_with(parse_join)?,
                Long("miter-limit") => options.stroke.miter_limit = arguments.value()?.parse_with(parse_number)?,
                Long("dash") => options.dashes = arguments.value()?.parse_with(parse_dashes)?,
                Long("phase") => options.phase = arguments.value()?.parse_with(parse_number)?,
                Long("min-width") => {
                    let width = arguments.optional_value();
                    options.stroke.min_width = width.map_or(Ok(I24F8::ONE), |width| width.parse_with(parse_width))?;
                }
                Long("scale") => options.scale = arguments.value()?.parse_with(parse_number)?,
                Long("rotate") => options.rotate = arguments.value()?.parse_with(parse_number)?,
                Long("translate") => options.translate = arguments.value()?.parse_with(parse_pair)?,
                Long("band") => options.screen.band = arguments.value()?.parse_with(parse_rows)?,
                Long("slots") => options.screen.slots = arguments.value()?.parse_with(parse_slots)?,
                Long("out" | "output") => options.out = arguments.value()?.parse_with(parse_out)?,
                Long("window") => options.window = true,
                Short('h') | Long("help") => return Ok(None),
                _ => return Err(argument.unexpected()),
            }
        }
        if options.paths.is_empty() && options.input.is_none() {
            return Err("there is nothing to draw: --path DATA or --input FILE is missing".into());
        }
        Ok(Some(options))
    }

    /// What the window shows, and what its title says of it.
    fn shot(&self) -> Result<Shot, Box<dyn Error>> {
        let Scene { shapes, screen, .. } = self.scene()?;
        let Drawing { picture, pixels } = draw(&shapes, &screen)?;
        let caption = format!("{} bit{}", screen.bits, if screen.bits == 1 { "" } else { "s" });
        let row = (usize::from(screen.width) * screen.bits as usize).div_ceil(8);
        Ok(Shot { picture, caption, ram: row * usize::from(screen.band.min(screen.height)), drawn: pixels as u64 })
    }

    /// What is drawn, the file first, and on what.
    fn scene(&self) -> Result<Scene, Box<dyn Error>> {
        let (mut shapes, mut screen, mut unknown, mut error) = (vec![], self.screen, BTreeSet::new(), None);
        if let Some(input) = &self.input {
            let named = |error: String| format!("{input}: {error}");
            let text = fs::read_to_string(input).map_err(|error| named(error.to_string()))?;
            let mut file = File::parse(&text).map_err(named)?;
            if !self.is_sized {
                let size = file.size();
                let scaled = |n: u16| {
                    let wide = u64::from(n) * u64::from(self.scale.to_bits().unsigned_abs());
                    u16::try_from((wide + (1 << 15)) >> 16).unwrap_or(u16::MAX).clamp(1, 4096)
                };
                (screen.width, screen.height) = (scaled(size.0), scaled(size.1));
            }
            let fit = if self.is_sized { (screen.width, screen.height) } else { file.size() };
            shapes = self.file(&mut file, fit);
            unknown = file.unknown;
            error = file.errors.first().map(|first| match file.errors.len() {
                1 => named(first.clone()),
                all => named(format!("{first}, and {} more", all - 1)),
            });
        }
        shapes.extend(self.paths()?);
        Ok(Scene { shapes, screen, unknown, error })
    }

    /// The shapes of a file.
    fn file(&self, file: &mut File, size: (u16, u16)) -> Vec<Shape> {
        let (scale, (x, y)): (f64, _) = (self.scale.to_num(), self.translate);
        let (sin, cos) = self.rotate.to_num::<f64>().to_radians().sin_cos();
        let then = [scale * cos, scale * sin, -scale * sin, scale * cos, x.to_num(), y.to_num()];
        let mut shapes = file.shapes(size, then, self.stroke.min_width);
        for shape in &mut shapes {
            shape.drop_out = self.drop_out;
        }
        shapes
    }

    /// The paths of the command line.
    fn paths(&self) -> Result<Vec<Shape>, Box<dyn Error>> {
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
            color: Rgb888::BLACK,
        });
        let shape = |text: &String| {
            let path = Path::svg(text).map_err(|error| format!("--path: {error}"))?.mapped(map).collect();
            let fill = self.fill.map(|rule| (rule, Rgb888::BLACK));
            Ok(Shape { path, fill, drop_out: self.drop_out, outline: outline.clone() })
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

fn parse_drop_out(text: &str) -> Result<DropOut, &'static str> {
    match text {
        "simple" => Ok(DropOut::SIMPLE),
        "smart" => Ok(DropOut::SMART),
        "simple-no-stubs" => Ok(DropOut::SIMPLE_WITHOUT_STUBS),
        "smart-no-stubs" => Ok(DropOut::SMART_WITHOUT_STUBS),
        _ => Err("--dropout takes simple, smart, simple-no-stubs or smart-no-stubs"),
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
    width.ok_or_else(|| "a width from 0 to 65536 is wanted".into())
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

#[cfg(test)]
mod tests {
    use super::*;

    fn options(arguments: &[&str]) -> Result<Options, String> {
        let parser = lexopt::Parser::from_iter(["svg"].iter().chain(arguments));
        Options::parse(parser).map(|options| options.expect("no help")).map_err(|error| error.to_string())
    }

    fn drawn(arguments: &[&str]) -> Result<Drawing, String> {
        let options = options(arguments)?;
        let Scene { shapes, screen, .. } = options.scene().map_err(|error| error.to_string())?;
        draw(&shapes, &screen).map_err(|error| error.to_string())
    }

    fn pixels(arguments: &[&str]) -> usize {
        drawn(arguments).unwrap_or_else(|error| panic!("{error}")).pixels
    }

    #[test]
    fn pixels_are_counted_once() {
        let square = ["--path", "M4 4h16v16h-16z"];
        assert_eq!(pixels(&square), 256, "filled");
        assert_eq!(pixels(&[&square[..], &["--fill", "none"]].concat()), 0, "nothing");
        assert_eq!(pixels(&[&square[..], &["--fill", "none", "--stroke", "2"]].concat()), 324 - 196, "an outline");
        assert_eq!(pixels(&[&square[..], &["--stroke", "2"]].concat()), 324, "both");
        assert_eq!(pixels(&[&square[..], &["--path", "M0 0h8v8h-8z"]].concat()), 256 + 64 - 16, "two paths");
        let hole = ["--path", "M4 4h16v16h-16zM8 8h8v8h-8z", "--fill", "evenodd"];
        assert_eq!(pixels(&hole), 192, "a hole");
        let moved = ["--scale", "0.5", "--rotate", "90", "--translate", "24,0"];
        assert_eq!(pixels(&[&square[..], &moved].concat()), 64, "scaled, turned and moved");
        let stem = ["--path", "M3.55 2H4.15V10H3.55z"];
        assert_eq!(pixels(&stem), 0, "between two columns");
        for kind in ["--dropout", "--dropout=simple", "--dropout=smart"] {
            assert_eq!(pixels(&[&stem[..], &[kind]].concat()), 8, "one column, {kind}");
        }
    }

    #[test]
    fn bands_and_depths_show_the_same() {
        let path = ["--path", "M12 1a11 11 0 1 0 .1 0zm-5 4 9 12-12-6z", "--fill", "evenodd", "--stroke", "1.5"];
        let whole = drawn(&path).unwrap();
        for band in ["1", "7", "24", "9999"] {
            let banded = drawn(&[&path[..], &["--band", band]].concat()).unwrap();
            assert!(banded.picture == whole.picture && banded.pixels == whole.pixels, "{band} rows at a time");
        }
        for bits in ["1", "2", "4", "8", "16", "24", "32"] {
            let other = drawn(&[&path[..], &["--bits", bits]].concat()).unwrap();
            assert!(other.picture.colors().eq(whole.picture.colors()), "{bits} bits");
        }
        let full = drawn(&[&path[..], &["--slots", "3"]].concat()).unwrap_err();
        assert!(
            full.starts_with("edge table full: 4 edges cross row ") || full.contains("the table holds 3"),
            "{full}"
        );
    }

    #[test]
    fn wrong_arguments_are_told_in_a_line() {
        for (arguments, wanted) in [
            (&["--path", "M4 4 L"][..], "--path: position 6: a number is expected"),
            (&["--path", "L4 4"], "--path: position 0: a path begins with M"),
            (&["--path", "M4 4 X"], "--path: position 5: a command is expected"),
            (&["--path", "M4 4A1 1 0 2 0 5 5"], "--path: position 11: a flag is expected, 0 or 1"),
            (&[], "there is nothing to draw: --path DATA or --input FILE is missing"),
        ] {
            assert_eq!(drawn(arguments).unwrap_err(), wanted, "{arguments:?}");
        }
        for (name, value) in [
            ("--bits", "3"),
            ("--size", "24"),
            ("--size", "0x24"),
            ("--fill", "odd"),
            ("--stroke", "-1"),
            ("--stroke", "x"),
            ("--cap", "flat"),
            ("--join", "mitre"),
            ("--miter-limit", ""),
            ("--dash", "8,x"),
            ("--dash", "8,-4"),
            ("--phase", "a"),
            ("--scale", "1e9x"),
            ("--rotate", "left"),
            ("--translate", "4"),
            ("--band", "0"),
            ("--slots", "0"),
            ("--out", "x.jpg"),
            ("--dropout=none", ""),
            ("--colour", "red"),
        ] {
            let error = options(&["--path", "M0 0", name, value]).expect_err(name);
            assert!(!error.contains('\n'), "{error}");
        }
    }
}
