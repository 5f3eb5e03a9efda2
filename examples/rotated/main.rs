//! One page on screens that are built in any way round: turned by quarters, and in a mirror. The page knows nothing of it.
//!
//! `cargo run --release --example rotated` writes `rotated.png`, all eight ways on one sheet; `-- --turn 90 --mirror` one of them, as the
//! screen of a device has it; `-- --window` shows one. What is drawn stands in `page.rs`.

mod page;
#[cfg(test)]
#[path = "../../tests/golden/compare.rs"]
mod pictures;

use std::{error::Error, process::ExitCode};

use embedded_raster::{
    pixel::EGA,
    surface::{Turn, Turned},
    Canvas, Framebuffer, Index4, Rect,
};
use embedded_raster_simulator::{
    desktop::{Desktop, Input, Key},
    finish, in_bands, Picture,
};
use page::{HEIGHT, WIDTH};

const USAGE: &str = "\
usage: rotated [--turn 0|90|180|270] [--mirror] [--value TENTHS] [--band ROWS] [--out FILE.png] [--window]

--turn DEGREES  one screen, on which the page is turned clockwise: all eight ways unless told
--mirror        one screen, on which the page is in a mirror
--value TENTHS  what the page shows, in tenths of a degree: 215
--band ROWS     draws so many rows at a time: the same picture
--out FILE.png  what is written: rotated.png
--window        shows one screen: Right and Left turn it, M puts it in a mirror, Up and Down change the value, Esc ends
";

const TURNS: [Turn; 4] = [Turn::None, Turn::Quarter, Turn::Half, Turn::ThreeQuarters];

/// Columns and rows of a sheet with a place for each way, and of such a place.
const SHEET: (u16, u16) = (4 * PLACE, 2 * PLACE);
const PLACE: u16 = WIDTH + 8;

fn main() -> ExitCode {
    finish("rotated", run(lexopt::Parser::from_env()))
}

fn run(arguments: lexopt::Parser) -> Result<String, Box<dyn Error>> {
    let Some(options) = Options::parse(arguments)? else { return Ok(USAGE.into()) };
    if options.window {
        return watch(options);
    }
    let picture = options.picture()?;
    picture.write_png(&options.out)?;
    picture.show(120);
    Ok(format!("{}: {} x {}\n", options.out, picture.width(), picture.height()))
}

/// How a screen is built in.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
struct Way {
    turn: Turn,
    is_mirrored: bool,
}

impl Way {
    /// Columns and rows of the screen.
    fn size(self) -> (u16, u16) {
        match self.turn {
            Turn::None | Turn::Half => (WIDTH, HEIGHT),
            Turn::Quarter | Turn::ThreeQuarters => (HEIGHT, WIDTH),
        }
    }

    /// Draws the page on the screen, or on as much of it as is in memory.
    fn draw(self, screen: &mut Framebuffer<'_, Index4>, value: i32) -> Result<(), embedded_raster::Error> {
        let (width, height) = self.size();
        let turned = Turned::of_area(screen, self.turn, Rect::new(0, 0, width.into(), height.into()));
        page::draw(&mut if self.is_mirrored { turned.mirrored() } else { turned }, value)
    }
}

/// Draws all ways: upright ones above those in a mirror.
fn draw_sheet(sheet: &mut Framebuffer<'_, Index4>, value: i32) -> Result<(), embedded_raster::Error> {
    sheet.fill_window(Index4::new(7));
    for (row, is_mirrored) in (0..).zip([false, true]) {
        for (column, turn) in (0..).zip(TURNS) {
            let (way, place) = (Way { turn, is_mirrored }, i32::from(PLACE));
            let [width, height] = <[u16; 2]>::from(way.size()).map(i32::from);
            let (left, top) = (column * place + (place - width) / 2, row * place + (place - height) / 2);
            way.draw(&mut sheet.view(Rect::new(left, top, left + width, top + height)), value)?;
        }
    }
    Ok(())
}

struct Options {
    /// One way of eight.
    way: Option<Way>,
    /// Tenths of a degree.
    value: i32,
    band: u16,
    out: String,
    window: bool,
}

impl Options {
    /// `None` if help was asked for.
    fn parse(mut arguments: lexopt::Parser) -> Result<Option<Self>, lexopt::Error> {
        use lexopt::prelude::*;
        let mut options = Self { way: None, value: 215, band: u16::MAX, out: "rotated.png".into(), window: false };
        while let Some(argument) = arguments.next()? {
            match argument {
                Long("turn") => {
                    options.way.get_or_insert_default().turn = arguments.value()?.parse_with(parse_turn)?;
                }
                Long("mirror") => options.way.get_or_insert_default().is_mirrored = true,
                Long("value") => options.value = arguments.value()?.parse_with(parse_value)?,
                Long("band") => options.band = arguments.value()?.parse_with(parse_band)?,
                Long("out" | "output") => options.out = arguments.value()?.string()?,
                Long("window") => options.window = true,
                Short('h') | Long("help") => return Ok(None),
                _ => return Err(argument.unexpected()),
            }
        }
        Ok(Some(options))
    }

    /// One screen or the sheet, band by band.
    fn picture(&self) -> Result<Picture, embedded_raster::Error> {
        let (width, height) = self.way.map_or(SHEET, Way::size);
        let mut whole = in_bands((width, height), self.band, |band| match self.way {
            Some(way) => way.draw(band, self.value),
            None => draw_sheet(band, self.value),
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

fn parse_value(text: &str) -> Result<i32, &'static str> {
    text.parse().ok().filter(|value| (0..=999).contains(value)).ok_or("--value takes 0 to 999 tenths of a degree")
}

fn parse_band(text: &str) -> Result<u16, &'static str> {
    text.parse().ok().filter(|&rows| rows > 0).ok_or("--band takes 1 to 65535 rows")
}

/// Shows one screen in the middle of a square, in which it can be turned.
fn watch(options: Options) -> Result<String, Box<dyn Error>> {
    let (mut way, mut value) = (options.way.unwrap_or_default(), options.value);
    let window = embedded_raster_simulator::desktop::Options { frames: 1, out: options.out, window: true };
    Desktop::new("rotated", (PLACE, PLACE), EGA).run(&window, |frame, input, _| {
        change(&mut way, &mut value, input);
        let [width, height] = <[u16; 2]>::from(way.size()).map(i32::from);
        let (left, top) = ((i32::from(PLACE) - width) / 2, (i32::from(PLACE) - height) / 2);
        frame.fill_window(Index4::new(7));
        Ok(way.draw(&mut frame.view(Rect::new(left, top, left + width, top + height)), value)?)
    })
}

/// Does what the keys ask for.
fn change(way: &mut Way, value: &mut i32, input: &Input) {
    let at = TURNS.iter().position(|turn| *turn == way.turn).unwrap_or(0);
    if input.is_pressed(Key::Right) {
        way.turn = TURNS[(at + 1) % 4];
    }
    if input.is_pressed(Key::Left) {
        way.turn = TURNS[(at + 3) % 4];
    }
    way.is_mirrored ^= input.is_pressed(Key::M);
    let step = i32::from(input.is_down(Key::Up)) - i32::from(input.is_down(Key::Down));
    *value = (*value + step).clamp(100, 300);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(arguments: &str) -> Picture {
        let parser = lexopt::Parser::from_args(arguments.split_whitespace());
        let options = Options::parse(parser).expect("options").expect("no help");
        options.picture().expect("a picture")
    }

    /// `BLESS=1 cargo test --example rotated` writes it anew.
    #[test]
    fn the_sheet_is_as_it_was() {
        assert_eq!(pictures::compare("rotated-4", &picture("")), None);
    }

    #[test]
    fn each_way_is_the_page_turned() {
        let upright = picture("--turn 0");
        let (width, height) = (upright.width(), upright.height());
        for mirror in ["", "--mirror"] {
            for (turn, degrees) in TURNS.into_iter().zip(["0", "90", "180", "270"]) {
                let shown = picture(&format!("--turn {degrees} {mirror}"));
                for (x, y) in (0..width).flat_map(|x| (0..height).map(move |y| (x, y))) {
                    let from = if mirror.is_empty() { x } else { width - 1 - x };
                    let at = match turn {
                        Turn::None => (from, y),
                        Turn::Quarter => (height - 1 - y, from),
                        Turn::Half => (width - 1 - from, height - 1 - y),
                        Turn::ThreeQuarters => (y, width - 1 - from),
                    };
                    assert_eq!(upright.index(x, y), shown.index(at.0, at.1), "({x}, {y}), {degrees} {mirror}");
                }
            }
        }
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
    fn keys_turn_the_screen() {
        let (mut way, mut value) = (Way::default(), 299);
        let mut press = |key| {
            change(&mut way, &mut value, &Input::keys(&[key]));
            (way, value)
        };
        let seen = |turn, is_mirrored, value| (Way { turn, is_mirrored }, value);
        assert_eq!(press(Key::Left), seen(Turn::ThreeQuarters, false, 299));
        assert_eq!(press(Key::M), seen(Turn::ThreeQuarters, true, 299));
        assert_eq!(press(Key::Right), seen(Turn::None, true, 299));
        assert_eq!([press(Key::Up), press(Key::Up)], [seen(Turn::None, true, 300); 2]);
    }

    #[test]
    fn wrong_arguments_are_told_in_a_line() {
        for (arguments, expected) in [
            ("--turn 45", r#"cannot parse argument "45": --turn takes 0, 90, 180 or 270"#),
            ("--band 0", r#"cannot parse argument "0": --band takes 1 to 65535 rows"#),
            ("--value -1", r#"cannot parse argument "-1": --value takes 0 to 999 tenths of a degree"#),
            ("--out /no/such/folder/x.png", "/no/such/folder/x.png: "),
            ("page.png", r#"unexpected argument "page.png""#),
        ] {
            let error = run(lexopt::Parser::from_args(arguments.split(' '))).expect_err(arguments).to_string();
            assert!(error.starts_with(expected) && !error.contains('\n'), "{arguments}: {error}");
        }
    }
}
