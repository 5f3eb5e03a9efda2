//! Programs that show a scene that moves: their options, their files, and their window.
//!
//! A program has a [`Moving`] scene; [`run`] does the rest. In a window, keys stop the scene and go on step by step, and show how often each
//! pixel was drawn, and what was sent to the display.

use std::{error::Error, fs, io::IsTerminal, time::Instant};

use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
use embedded_raster::Rect;
use lexopt::prelude::*;

use crate::{
    film,
    heat::heat,
    picture::Picture,
    window::{show, Key, Shot},
};

/// One frame after the other.
pub trait Moving {
    /// Draws the next frame.
    ///
    /// # Errors
    /// There is too little memory.
    fn next(&mut self) -> Result<Moment, embedded_raster::Error>;
}

/// A frame.
#[derive(Clone, Debug)]
pub struct Moment {
    /// What the display shows now.
    pub picture: Picture,
    /// What it was sent for it.
    pub sent: Vec<Rect>,
    /// How often each pixel was drawn, row by row; empty if nobody counted.
    pub drawn: Vec<u16>,
    /// CRC-32 of what is shown, as a display is sent it.
    pub crc32: u32,
    /// Bytes of memory that a microcontroller would spend.
    pub ram: usize,
}

/// What such a program is asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Options {
    /// Columns and rows.
    pub size: [u16; 2],
    frames: u16,
    out: String,
    is_gif: bool,
    window: bool,
}

/// What all of them can do, for the end of a usage text.
pub const USAGE: &str = "\
--size WxH    320x240 unless told, at most 4096x4096
--frames N    so many frames: 1, in one file
--out FILE    where they go: NAME.png unless told; with several frames, a PNG is animated
--window      shows it: Space stops and goes on, Right goes on by one frame, H shows how often each pixel is drawn,
              S what is sent to the display, Esc quits";

impl Options {
    /// Those of the command line; `None` if help was asked for. Unless told, the file is named after the program, and the screen has that size.
    ///
    /// # Errors
    /// An option that does not exist, or a value that makes no sense.
    pub fn from_command_line(name: &str, size: [u16; 2]) -> Result<Option<Self>, lexopt::Error> {
        let mut options = Self { size, frames: 1, out: format!("{name}.png"), is_gif: false, window: false };
        let mut arguments = lexopt::Parser::from_env();
        while let Some(argument) = arguments.next()? {
            match argument {
                Long("size") => options.size = arguments.value()?.parse_with(parse_size)?,
                Long("frames") => options.frames = arguments.value()?.parse_with(parse_count)?,
                Long("out") => {
                    let out = arguments.value()?;
                    options.is_gif = out.parse_with(parse_kind)?;
                    options.out = out.string()?;
                }
                Long("window") => options.window = true,
                Short('h') | Long("help") => return Ok(None),
                _ => return Err(argument.unexpected()),
            }
        }
        Ok(Some(options))
    }
}

fn parse_size(text: &str) -> Result<[u16; 2], &'static str> {
    let size = text.split_once(['x', 'X']).and_then(|(w, h)| Some([w.parse().ok()?, h.parse().ok()?]));
    let fits = |size: &[u16; 2]| size.iter().all(|side| (1..=4096).contains(side));
    size.filter(fits).ok_or("WIDTHxHEIGHT, each from 1 to 4096")
}

fn parse_count(text: &str) -> Result<u16, &'static str> {
    text.parse().ok().filter(|&count| count > 0).ok_or("a number from 1 to 65535")
}

/// Whether it is a GIF, by the end of its name.
fn parse_kind(text: &str) -> Result<bool, &'static str> {
    let end = text.rsplit_once('.').map(|(_, end)| end.to_ascii_lowercase());
    match end.as_deref() {
        Some("png" | "apng") => Ok(false),
        Some("gif") => Ok(true),
        _ => Err("a name that ends with .png, .apng or .gif"),
    }
}

/// Writes the frames that were asked for, or opens a window. Returns a line that says what was drawn.
///
/// # Errors
/// Those of files and windows, and of the scene.
pub fn run(name: &str, options: &Options, mut scene: impl Moving) -> Result<String, Box<dyn Error>> {
    if options.window {
        watch(name, scene)?;
        return Ok(String::new());
    }
    let (mut last, mut sent, mut drawn) = (None, 0, 0);
    let next = |_| -> Result<Picture, Box<dyn Error>> {
        let moment = scene.next()?;
        sent += pixels(&moment.sent);
        drawn += count(&moment.drawn);
        let picture = moment.picture.clone();
        last = Some(moment);
        Ok(picture)
    };
    let bytes = if options.is_gif { film::gif(options.frames, next)? } else { film::apng(options.frames, next)? };
    fs::write(&options.out, bytes).map_err(|error| format!("{}: {error}", options.out))?;
    let Some(Moment { picture, crc32, ram, .. }) = last else { return Ok(String::new()) };
    let preview = if std::io::stdout().is_terminal() { picture.preview(100) } else { String::new() };
    let ([width, height], frames) = (options.size, options.frames);
    let plural = if frames == 1 { "" } else { "s" };
    Ok(format!(
        "{preview}{}: {width} x {height}, {frames} frame{plural}, {drawn} pixels drawn, {sent} sent, {ram} bytes of RAM, CRC-32 of the last {crc32:08x}\n",
        options.out
    ))
}

fn pixels(areas: &[Rect]) -> u64 {
    areas.iter().map(|area| u64::from(area.width()) * u64::from(area.height())).sum()
}

fn count(drawn: &[u16]) -> u64 {
    drawn.iter().copied().map(u64::from).sum()
}

/// Shows the scene in a window.
fn watch(name: &str, scene: impl Moving) -> Result<(), Box<dyn Error>> {
    let mut desk = Desk { scene, is_paused: false, heat: false, outlines: false, moment: None, micros: 0 };
    let first = desk.shot(1)?;
    show::<Box<dyn Error>>(name, first, |keys| desk.go(keys))
        .map_err(|error| format!("{error} (a window needs a display; without --window, a file is written)").into())
}

struct Desk<M> {
    scene: M,
    is_paused: bool,
    heat: bool,
    outlines: bool,
    moment: Option<Moment>,
    /// What the last frame took on this computer.
    micros: u128,
}

impl<M: Moving> Desk<M> {
    fn go(&mut self, keys: &[Key]) -> Result<Option<Shot>, Box<dyn Error>> {
        let mut steps = u32::from(!self.is_paused);
        for key in keys {
            match key {
                Key::Space => self.is_paused = !self.is_paused,
                Key::Right => {
                    steps = u32::from(self.is_paused);
                    self.is_paused = true;
                }
                Key::H => self.heat = !self.heat,
                Key::S => self.outlines = !self.outlines,
                _ => {}
            }
        }
        (steps > 0 || !keys.is_empty()).then(|| self.shot(steps)).transpose()
    }

    fn shot(&mut self, steps: u32) -> Result<Shot, Box<dyn Error>> {
        for _ in 0..steps {
            let start = Instant::now();
            self.moment = Some(self.scene.next()?);
            self.micros = start.elapsed().as_micros();
        }
        let Some(moment) = &self.moment else { return Err("there is no frame".into()) };
        let Moment { picture, sent, drawn, crc32, ram } = moment;
        let mut shown = if self.heat && !drawn.is_empty() { heat(picture.width(), drawn) } else { picture.clone() };
        if self.outlines {
            shown = shown.outlined(sent, Rgb888::MAGENTA);
        }
        let caption = format!("{} µs, {} pixels sent, CRC-32 {crc32:08x}", self.micros, pixels(sent));
        Ok(Shot { picture: shown, caption, ram: *ram, drawn: count(drawn) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A pixel that changes its colour.
    struct Dot(u8);

    impl Moving for Dot {
        fn next(&mut self) -> Result<Moment, embedded_raster::Error> {
            self.0 += 1;
            let picture = Picture::from_colors(1, 1, vec![Rgb888::new(self.0, 0, 0)]);
            Ok(Moment { picture, sent: vec![Rect::new(0, 0, 1, 1)], drawn: vec![2], crc32: self.0.into(), ram: 3 })
        }
    }

    #[test]
    fn values_are_what_the_usage_says() {
        assert_eq!((parse_size("160x120"), parse_size("1X4096")), (Ok([160, 120]), Ok([1, 4096])), "sizes");
        assert!(["", "160", "0x1", "1x4097", "1x-1"].iter().all(|text| parse_size(text).is_err()), "no sizes");
        assert!(["0", "x", "-3", "65536"].iter().all(|text| parse_count(text).is_err()), "no counts");
        assert_eq!(
            (parse_kind("a.PNG"), parse_kind("a.apng"), parse_kind("a.gif")),
            (Ok(false), Ok(false), Ok(true)),
            "files"
        );
        assert!(parse_kind("a.jpg").is_err() && parse_kind("gif").is_err(), "other files");
    }

    #[test]
    fn the_line_says_what_was_drawn() {
        let out = std::env::temp_dir().join(format!("embedded-raster-moving-{}.png", std::process::id()));
        let out = out.to_str().expect("a plain name").to_owned();
        let options = Options { size: [1, 1], frames: 3, out: out.clone(), is_gif: false, window: false };
        let line = run("dot", &options, Dot(0)).expect("it can be written");
        let end = "1 x 1, 3 frames, 6 pixels drawn, 3 sent, 3 bytes of RAM, CRC-32 of the last 00000003\n";
        assert!(line.ends_with(end), "{line}");
        let first = Picture::read_png(&out).expect("a picture");
        assert_eq!(first.color(0, 0), Some(Rgb888::new(1, 0, 0)), "the first of three");
        fs::remove_file(out).expect("it is there");
    }

    #[test]
    fn keys_stop_and_step() {
        let mut desk = Desk { scene: Dot(0), is_paused: false, heat: false, outlines: false, moment: None, micros: 0 };
        let mut at = |keys: &[Key]| {
            desk.go(keys).expect("it can be drawn").map(|shot| shot.picture.color(0, 0).map_or(0, |color| color.r()))
        };
        assert_eq!([at(&[]), at(&[])], [Some(1), Some(2)], "it moves");
        assert_eq!([at(&[Key::Space]), at(&[]), at(&[])], [Some(3), None, None], "it stops");
        assert_eq!([at(&[Key::Right]), at(&[]), at(&[Key::Right])], [Some(4), None, Some(5)], "step by step");
        assert_eq!([at(&[Key::Space]), at(&[])], [Some(5), Some(6)], "it goes on");
        assert_eq!(at(&[Key::S]), Some(255), "outlines");
        assert_ne!(at(&[Key::S, Key::H]), Some(8), "heat");
    }
}
