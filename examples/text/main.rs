//! Text in bitmap fonts: transparent and opaque, every alignment, tabs, a font of one's own, and a screen that is turned.
//!
//! `cargo run --release --example text` writes `text.png` and shows it in the terminal; `-- --help` tells the rest. What is drawn stands in
//! `scene.rs`.

mod scene;

use std::{error::Error, fs, process::ExitCode};

use embedded_raster::{
    pixel::EGA,
    surface::{Turn, Turned},
    text::{Font, FONT_8X13},
    Framebuffer, Index4, Rect,
};
use embedded_raster_simulator::{finish, in_bands, Picture};
use scene::{page, HEIGHT, WIDTH};

const USAGE: &str = "\
usage: text [--font FILE.erf] [--text TEXT] [--turn 0|90|180|270] [--mirror] [--band ROWS] [--out FILE.png]

--font FILE.erf  a font that fontbake has made, for the large text; cells of 8 x 13 unless told
--text TEXT      the large text; \\n begins a line, \\t goes to a tab stop
--turn DEGREES   turns the page clockwise
--mirror         shows the page in a mirror
--band ROWS      draws so many rows at a time: the same picture
--out FILE.png   what is written: text.png
";

fn main() -> ExitCode {
    finish("text", run(lexopt::Parser::from_env()))
}

fn run(arguments: lexopt::Parser) -> Result<String, Box<dyn Error>> {
    let Some(options) = Options::parse(arguments)? else { return Ok(USAGE.into()) };
    let file = options.font.as_ref().map(|path| fs::read(path).map_err(|error| format!("{path}: {error}")));
    let bytes = file.transpose()?;
    let named = |error| format!("{}: {error}", options.font.as_deref().unwrap_or_default());
    let font = bytes.as_deref().map_or(Ok(FONT_8X13), Font::read).map_err(named)?;
    let picture = options.draw(&font)?;
    picture.write_png(&options.out)?;
    picture.show(120);
    Ok(format!("{}: {} x {}\n", options.out, picture.width(), picture.height()))
}

struct Options {
    font: Option<String>,
    text: String,
    turn: Turn,
    mirror: bool,
    band: u16,
    out: String,
}

impl Options {
    /// `None` if help was asked for.
    fn parse(mut arguments: lexopt::Parser) -> Result<Option<Self>, lexopt::Error> {
        use lexopt::prelude::*;
        let mut options = Self {
            font: None,
            text: "two\nlines".into(),
            turn: Turn::None,
            mirror: false,
            band: u16::MAX,
            out: "text.png".into(),
        };
        while let Some(argument) = arguments.next()? {
            match argument {
                Long("font") => options.font = Some(arguments.value()?.string()?),
                Long("text") => options.text = arguments.value()?.string()?.replace("\\n", "\n").replace("\\t", "\t"),
                Long("turn") => options.turn = arguments.value()?.parse_with(parse_turn)?,
                Long("mirror") => options.mirror = true,
                Long("band") => options.band = arguments.value()?.parse_with(parse_band)?,
                Long("out" | "output") => options.out = arguments.value()?.string()?,
                Short('h') | Long("help") => return Ok(None),
                _ => return Err(argument.unexpected()),
            }
        }
        Ok(Some(options))
    }

    fn draw(&self, font: &Font<'_>) -> Result<Picture, embedded_raster::Error> {
        let (width, height) = match self.turn {
            Turn::None | Turn::Half => (WIDTH, HEIGHT),
            Turn::Quarter | Turn::ThreeQuarters => (HEIGHT, WIDTH),
        };
        let screen = Rect::new(0, 0, width.into(), height.into());
        let mut whole = in_bands::<Index4, embedded_raster::Error>((width, height), self.band, |band| {
            let turned = Turned::of_area(band, self.turn, screen);
            page(&mut if self.mirror { turned.mirrored() } else { turned }, font, &self.text);
            Ok(())
        })?;
        Ok(Picture::indexed(&Framebuffer::<Index4>::new(&mut whole, width, height)?, &EGA))
    }
}

fn parse_turn(text: &str) -> Result<Turn, &'static str> {
    match text {
        "0" => Ok(Turn::None),
        "90" => Ok(Turn::Quarter),
        "180" => Ok(Turn::Half),
        "270" => Ok(Turn::ThreeQuarters),
        _ => Err("--turn takes 0, 90, 180 or 270"),
    }
}

fn parse_band(text: &str) -> Result<u16, &'static str> {
    text.parse().ok().filter(|&rows| rows > 0).ok_or("--band takes 1 to 65535 rows")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(arguments: &str) -> Picture {
        let parser = lexopt::Parser::from_args(arguments.split_whitespace());
        let options = Options::parse(parser).expect("options").expect("no help");
        options.draw(&FONT_8X13).expect("a picture")
    }

    #[test]
    fn bands_change_nothing() {
        for way in ["", "--turn 90", "--turn 270 --mirror"] {
            let whole = picture(way);
            for rows in [1, 7, 64] {
                assert!(picture(&format!("{way} --band {rows}")) == whole, "{way}, bands of {rows} rows");
            }
        }
    }

    #[test]
    fn a_turned_page_is_the_page_turned() {
        let (upright, turned) = (picture(""), picture("--turn 90"));
        assert_eq!((turned.width(), turned.height()), (upright.height(), upright.width()));
        for (x, y) in (0..upright.width()).flat_map(|x| (0..upright.height()).map(move |y| (x, y))) {
            assert_eq!(upright.index(x, y), turned.index(turned.width() - 1 - y, x), "({x}, {y})");
        }
    }

    #[test]
    fn wrong_arguments_are_told_in_a_line() {
        for (arguments, expected) in [
            ("--turn 45", r#"cannot parse argument "45": --turn takes 0, 90, 180 or 270"#),
            ("--band 0", r#"cannot parse argument "0": --band takes 1 to 65535 rows"#),
            ("--font /no/such.erf", "/no/such.erf: "),
            ("--font Cargo.toml", "Cargo.toml: not a font of this version"),
        ] {
            let error = run(lexopt::Parser::from_args(arguments.split(' '))).expect_err(arguments).to_string();
            assert!(error.starts_with(expected) && !error.contains('\n'), "{arguments}: {error}");
        }
    }
}
