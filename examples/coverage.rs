//! What a path covers of each pixel, as a picture of 8-bit greys: 0 is outside, 255 inside.
//!
//! `cargo run --release --example coverage -- --path "M4,4 h20 v20 z" --size 32x32 --out triangle.pgm`
//! The path is written as in SVG. Bands, strips and clips change nothing of what is drawn: they are here to see that.
#![allow(clippy::cast_precision_loss, reason = "a sum of levels, shown with three digits")]

use std::{
    error::Error,
    fs::File,
    io::{self, Write},
    process::ExitCode,
};

use embedded_graphics_core::pixelcolor::Gray8;
use embedded_raster::{
    paint::Cover, raster::coverage, Antialias, CoverageSlot, FillRule, Framebuffer, Path, Rect, Svg,
};
use embedded_raster_simulator::finish;

const USAGE: &str = "\
usage: coverage --path DATA [--size WxH] [--fill nonzero|evenodd] [--out FILE.pgm]
                [--band ROWS] [--strip COLUMNS] [--clip X0,Y0,X1,Y1]

--path DATA         path data of SVG, in pixels: all commands
--size WxH          pixels of the picture: 32x32, at most 65535x65535
--fill RULE         nonzero or evenodd: nonzero
--out FILE.pgm      what is written, in the binary form of PGM, one byte a pixel: coverage.pgm
--band ROWS         draws so many rows at a time
--strip COLUMNS     has cells for so many columns only
--clip X0,Y0,X1,Y1  draws in this rectangle only: the pixels in it are the same, all others are 0
";

/// Bytes of pixels that are drawn at once, at most.
const MEMORY: usize = 1 << 24;

fn main() -> ExitCode {
    finish("coverage", run(lexopt::Parser::from_env()))
}

/// Does what the arguments say, and returns what there is to say of it.
fn run(arguments: lexopt::Parser) -> Result<String, Box<dyn Error>> {
    let Some(options) = Options::parse(arguments)? else {
        return Ok(USAGE.into());
    };
    let path = Path::svg(options.path.as_deref().ok_or("--path is missing; --help tells the rest")?)?;
    let (width, height) = options.size;
    let named = |error: io::Error| format!("{}: {error}", options.out);
    let mut file = File::create(&options.out).map_err(named)?;
    write!(file, "P5\n{width} {height}\n255\n").map_err(named)?;
    let (mut sum, mut full, mut partly) = (0, 0_u32, 0_u32);
    options.draw(path, |levels| {
        for &level in levels {
            sum += u64::from(level);
            full += u32::from(level == u8::MAX);
            partly += u32::from((1..u8::MAX).contains(&level));
        }
        file.write_all(levels).map_err(|error| named(error).into())
    })?;
    Ok(format!(
        "{}: {width} x {height}, {full} pixels covered, {partly} in part, {:.3} in all\n",
        options.out,
        sum as f64 / 255.0
    ))
}

struct Options {
    path: Option<String>,
    size: (u16, u16),
    rule: FillRule,
    out: String,
    band: u16,
    strip: u16,
    clip: Rect,
}

impl Options {
    /// `None` if help was asked for.
    fn parse(mut arguments: lexopt::Parser) -> Result<Option<Self>, lexopt::Error> {
        use lexopt::prelude::*;
        let mut options = Self {
            path: None,
            size: (32, 32),
            rule: FillRule::NonZero,
            out: "coverage.pgm".into(),
            band: u16::MAX,
            strip: u16::MAX,
            clip: Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX),
        };
        while let Some(argument) = arguments.next()? {
            match argument {
                Long("path") => options.path = Some(arguments.value()?.string()?),
                Long("size") => options.size = arguments.value()?.parse_with(parse_size)?,
                Long("fill") => options.rule = arguments.value()?.parse_with(parse_rule)?,
                Long("out" | "output") => options.out = arguments.value()?.string()?,
                Long("band") => options.band = arguments.value()?.parse_with(parse_count)?,
                Long("strip") => options.strip = arguments.value()?.parse_with(parse_count)?,
                Long("clip") => options.clip = arguments.value()?.parse_with(parse_clip)?,
                Short('h') | Long("help") => return Ok(None),
                _ => return Err(argument.unexpected()),
            }
        }
        Ok(Some(options))
    }

    /// The picture, row by row: a few at a time, in the same memory.
    fn draw(
        &self,
        path: Svg<'_>,
        mut each: impl FnMut(&[u8]) -> Result<(), Box<dyn Error>>,
    ) -> Result<(), Box<dyn Error>> {
        let (width, height) = self.size;
        let most = (MEMORY / usize::from(width)).max(1);
        let rows = self.band.min(height).min(u16::try_from(most).unwrap_or(u16::MAX));
        let mut levels = vec![0; usize::from(width) * usize::from(rows)];
        let mut cells = vec![0; coverage::cells(self.strip.min(width))];
        let mut table = vec![CoverageSlot::EMPTY; 256];
        for start in (0..height).step_by(rows.into()) {
            let end = start.saturating_add(rows).min(height);
            let levels = &mut levels[..usize::from(width) * usize::from(end - start)];
            levels.fill(0);
            let mut frame = Framebuffer::<Gray8>::band(&mut *levels, width, height, start..end)?;
            let paint = Cover(Gray8::new(255));
            let mut frame = frame.clipped(self.clip);
            // A table that is too small for one row says what is enough for all.
            while let Err(error) = frame.fill_path_aa(path, self.rule, &mut table, &mut cells, paint) {
                if table.len() >= error.enough {
                    return Err(error.into());
                }
                table.resize(error.enough, CoverageSlot::EMPTY);
            }
            each(levels)?;
        }
        Ok(())
    }
}

fn parse_size(text: &str) -> Result<(u16, u16), &'static str> {
    let size = text.split_once(['x', 'X']).and_then(|(w, h)| Some((w.parse().ok()?, h.parse().ok()?)));
    size.filter(|&(w, h)| w > 0 && h > 0).ok_or("--size takes WIDTHxHEIGHT, from 1x1 to 65535x65535")
}

fn parse_rule(text: &str) -> Result<FillRule, &'static str> {
    match text {
        "nonzero" => Ok(FillRule::NonZero),
        "evenodd" => Ok(FillRule::EvenOdd),
        _ => Err("--fill takes nonzero or evenodd"),
    }
}

fn parse_count(text: &str) -> Result<u16, &'static str> {
    text.parse().ok().filter(|&n| n > 0).ok_or("a number from 1 to 65535 is wanted")
}

fn parse_clip(text: &str) -> Result<Rect, &'static str> {
    let sides: Vec<i32> = text.split(',').map_while(|side| side.trim().parse().ok()).collect();
    match sides[..] {
        [x0, y0, x1, y1] if text.split(',').count() == 4 => Ok(Rect::new(x0, y0, x1, y1)),
        _ => Err("--clip takes X0,Y0,X1,Y1"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(arguments: &[&str]) -> Vec<u8> {
        let options = Options::parse(lexopt::Parser::from_args(arguments)).expect("right arguments").expect("no help");
        let path = Path::svg(options.path.as_deref().expect("a path")).expect("a right path");
        let mut picture = vec![];
        let keep = |levels: &[u8]| {
            picture.extend_from_slice(levels);
            Ok(())
        };
        options.draw(path, keep).expect("a picture");
        picture
    }

    /// A star with a hole, a ring of curves and arcs, and something beyond the picture on all sides.
    const STAR: &str = "M16 1 L25.3 30 L1 12 h30.2 L6.7 30 z m0 8 q9-3.5 6 7 t-9 4 z M-9-9 L50 3.3 A20 9 15 0 1 2 40z";

    #[test]
    fn bands_strips_and_clips_change_nothing() {
        for fill in ["nonzero", "evenodd"] {
            let arguments = ["--path", STAR, "--size", "61x33", "--fill", fill];
            let with = |more: &[&str]| drawn(&[&arguments[..], more].concat());
            let whole = with(&[]);
            assert!(whole.contains(&255) && whole.iter().any(|&l| l > 0 && l < 255), "a picture");
            for more in [&["--band", "1"][..], &["--band", "7"], &["--strip", "1"], &["--strip", "40", "--band", "5"]] {
                assert!(with(more) == whole, "{more:?}");
            }
            let clipped = with(&["--clip", "5,3,40,21", "--band", "4", "--strip", "33"]);
            for (i, (&clipped, &whole)) in clipped.iter().zip(&whole).enumerate() {
                let inside = (5..40).contains(&(i % 61)) && (3..21).contains(&(i / 61));
                assert_eq!(clipped, if inside { whole } else { 0 }, "pixel {i}");
            }
        }
    }

    #[test]
    fn halves_and_quarters() {
        let got = drawn(&["--path", "M.5,.5h2v1.5h-2z", "--size", "4x3"]);
        assert_eq!(got, [64, 128, 64, 0, 128, 255, 128, 0, 0, 0, 0, 0]);
        assert_eq!(drawn(&["--path", "", "--size", "2x1"]), [0, 0], "no path covers nothing");
        assert_eq!(drawn(&["--path", "M-1e30,-1e30H1e30V1e30H-1e30z", "--size", "2x1"]), [255, 255]);
    }

    #[test]
    fn wrong_arguments_are_told_in_a_line() {
        for (arguments, expected) in [
            (&["--path", "M0,0 L1"][..], "position 7: a number is expected"),
            (&["--path", "M0,0 X5,5"], "position 5: a command is expected"),
            (&["--path", "L0,0"], "position 0: a path begins with M"),
            (&["--size", "8x8"], "--path is missing"),
            (&["--size", "0x8"], r#"cannot parse argument "0x8": --size takes WIDTHxHEIGHT"#),
            (&["--fill", "odd"], r#"cannot parse argument "odd": --fill takes nonzero or evenodd"#),
            (&["--clip", "1,2,3"], r#"cannot parse argument "1,2,3": --clip takes X0,Y0,X1,Y1"#),
            (&["--band", "0"], r#"cannot parse argument "0": a number from 1"#),
            (&["--path", "M0,0", "--out", "/no/such/folder/x.pgm"], "/no/such/folder/x.pgm: "),
            (&["x.svg"], r#"unexpected argument "x.svg""#),
        ] {
            let error = run(lexopt::Parser::from_args(arguments)).expect_err("an error").to_string();
            assert!(error.starts_with(expected) && !error.contains('\n'), "{arguments:?}: {error}");
        }
        assert!(run(lexopt::Parser::from_args(["--help"])).expect("help").starts_with("usage: coverage"));
    }
}
