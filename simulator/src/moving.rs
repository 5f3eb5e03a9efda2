//! Programs that show a scene that moves: their options, their files, and their window.
//!
//! A program has a [`Moving`] scene; [`run`] does the rest. In a window, keys stop the scene and go step by step, forwards and back. What can be
//! laid over a frame ([`Overlays`]) is there by keys in a window, and by an option in files.

use std::{collections::VecDeque, error::Error, fs, io::IsTerminal, time::Instant};

use embedded_raster::Rect;
use lexopt::prelude::*;

pub use crate::moment::Moment;
use crate::{
    film,
    overlay::{Overlays, Times},
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

/// What such a program is asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Options {
    /// Columns and rows.
    pub size: [u16; 2],
    frames: u16,
    out: String,
    is_gif: bool,
    window: bool,
    overlays: Overlays,
}

/// What all of them can do, for the end of a usage text.
pub const USAGE: &str = "\
--size WxH    320x240 unless told, at most 4096x4096
--frames N    so many frames: 1, in one file
--out FILE    where they go: NAME.png unless told; with several frames, a PNG is animated
--overlay heat|damage|time[,...]
              lays over each frame how often its pixels were drawn, what is sent to the display, or how long frames took
--window      shows it: Space stops and goes on, Right and Left go on and back by one frame, H, S and T show what `heat`, `damage`
              and `time` show, Esc quits";

impl Options {
    /// Those of the command line; `None` if help was asked for. Unless told, the file is named after the program, and the screen has that size.
    ///
    /// # Errors
    /// An option that does not exist, or a value that makes no sense.
    pub fn from_command_line(name: &str, size: [u16; 2]) -> Result<Option<Self>, lexopt::Error> {
        let (out, overlays) = (format!("{name}.png"), Overlays::default());
        let mut options = Self { size, frames: 1, out, is_gif: false, window: false, overlays };
        let mut arguments = lexopt::Parser::from_env();
        while let Some(argument) = arguments.next()? {
            match argument {
                Long("size") => options.size = arguments.value()?.parse_with(parse_size)?,
                Long("frames") => options.frames = arguments.value()?.parse_with(parse_count)?,
                Long("out" | "output") => {
                    let out = arguments.value()?;
                    options.is_gif = out.parse_with(parse_kind)?;
                    options.out = out.string()?;
                }
                Long("overlay") => options.overlays = arguments.value()?.parse()?,
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
        watch(name, options.overlays, scene)?;
        return Ok(String::new());
    }
    let (mut last, mut sent, mut drawn, mut times) = (None, 0, 0, Times::default());
    let next = |_| -> Result<Picture, Box<dyn Error>> {
        let moment = timed(&mut scene, &mut times)?;
        sent += pixels(&moment.sent);
        drawn += count(&moment.drawn);
        let picture = options.overlays.over(&moment, &times);
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

/// The next frame, and how long it took.
fn timed(scene: &mut impl Moving, times: &mut Times) -> Result<Moment, embedded_raster::Error> {
    let start = Instant::now();
    let moment = scene.next()?;
    times.add(start.elapsed());
    Ok(moment)
}

/// Shows the scene in a window.
fn watch(name: &str, overlays: Overlays, scene: impl Moving) -> Result<(), Box<dyn Error>> {
    let mut desk = Desk::new(scene, overlays);
    let first = desk.forwards()?;
    show::<Box<dyn Error>>(name, first, |keys| desk.go(keys))
        .map_err(|error| format!("{error} (a window needs a display; without --window, a file is written)").into())
}

/// How many frames there is a way back to.
const KEPT: usize = 60;

struct Desk<M> {
    scene: M,
    overlays: Overlays,
    is_paused: bool,
    /// The last frames, and how many of them are after the one that is shown.
    kept: VecDeque<Moment>,
    after: usize,
    times: Times,
}

impl<M: Moving> Desk<M> {
    fn new(scene: M, overlays: Overlays) -> Self {
        Self { scene, overlays, is_paused: false, kept: VecDeque::new(), after: 0, times: Times::default() }
    }

    /// What is shown after some keys; `None` if it is what was shown before.
    fn go(&mut self, keys: &[Key]) -> Result<Option<Shot>, Box<dyn Error>> {
        let mut steps = u32::from(!self.is_paused);
        for key in keys {
            match key {
                Key::Space => self.is_paused = !self.is_paused,
                Key::Right => {
                    steps = if self.is_paused { steps + 1 } else { 0 };
                    self.is_paused = true;
                }
                Key::Left => {
                    steps = 0;
                    self.is_paused = true;
                    self.after = (self.after + 1).min(self.kept.len().saturating_sub(1));
                }
                Key::H => self.overlays.heat = !self.overlays.heat,
                Key::S => self.overlays.damage = !self.overlays.damage,
                Key::T => self.overlays.time = !self.overlays.time,
                _ => {}
            }
        }
        if steps == 0 && keys.is_empty() {
            return Ok(None);
        }
        (1..steps).try_for_each(|_| self.step())?;
        if steps > 0 { self.forwards() } else { self.shot() }.map(Some)
    }

    /// One frame on: one that was shown before, or a new one.
    fn step(&mut self) -> Result<(), Box<dyn Error>> {
        if self.after > 0 {
            self.after -= 1;
            return Ok(());
        }
        if self.kept.len() == KEPT {
            self.kept.pop_front();
        }
        let moment = timed(&mut self.scene, &mut self.times)?;
        self.kept.push_back(moment);
        Ok(())
    }

    fn forwards(&mut self) -> Result<Shot, Box<dyn Error>> {
        self.step()?;
        self.shot()
    }

    fn shot(&self) -> Result<Shot, Box<dyn Error>> {
        let moment = self.kept.iter().rev().nth(self.after).ok_or("there is no frame")?;
        let Moment { sent, drawn, crc32, ram, .. } = moment;
        let micros = self.times.last().as_micros();
        let back = if self.after > 0 { format!(", {} back", self.after) } else { String::new() };
        let caption = format!("{micros} µs{back}, {} pixels sent, CRC-32 {crc32:08x}", pixels(sent));
        Ok(Shot { picture: self.overlays.over(moment, &self.times), caption, ram: *ram, drawn: count(drawn) })
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};

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
        let overlays = Overlays::default();
        let options = Options { size: [1, 1], frames: 3, out: out.clone(), is_gif: false, window: false, overlays };
        let line = run("dot", &options, Dot(0)).expect("it can be written");
        let end = "1 x 1, 3 frames, 6 pixels drawn, 3 sent, 3 bytes of RAM, CRC-32 of the last 00000003\n";
        assert!(line.ends_with(end), "{line}");
        let first = Picture::read_png(&out).expect("a picture");
        assert_eq!(first.color(0, 0), Some(Rgb888::new(1, 0, 0)), "the first of three");
        fs::remove_file(out).expect("it is there");
    }

    /// The red of the pixel that is shown after some keys, if it is shown anew.
    fn at(desk: &mut Desk<Dot>, keys: &[Key]) -> Option<u8> {
        let shot = desk.go(keys).expect("it can be drawn")?;
        shot.picture.color(0, 0).map(|color| color.r())
    }

    #[test]
    fn keys_stop_and_step() {
        let mut desk = Desk::new(Dot(0), Overlays::default());
        let mut at = |keys: &[Key]| at(&mut desk, keys);
        assert_eq!([at(&[]), at(&[])], [Some(1), Some(2)], "it moves");
        assert_eq!([at(&[Key::Space]), at(&[]), at(&[])], [Some(3), None, None], "it stops");
        assert_eq!([at(&[Key::Right]), at(&[]), at(&[Key::Right])], [Some(4), None, Some(5)], "step by step");
        assert_eq!(at(&[Key::Right, Key::Right]), Some(7), "two at once");
        assert_eq!([at(&[Key::Left]), at(&[Key::Left]), at(&[])], [Some(6), Some(5), None], "back");
        assert_eq!([at(&[Key::Right]), at(&[Key::Right]), at(&[Key::Right])], [Some(6), Some(7), Some(8)], "and on");
        assert_eq!([at(&[Key::Space]), at(&[])], [Some(8), Some(9)], "it goes on");
        assert_eq!(at(&[Key::S]), Some(255), "outlines");
        assert_ne!(at(&[Key::S, Key::H]), Some(11), "heat");
    }

    #[test]
    fn the_way_back_has_an_end() {
        let mut desk = Desk::new(Dot(0), Overlays::default());
        for _ in 0..KEPT + 3 {
            at(&mut desk, &[]);
        }
        assert_eq!(at(&mut desk, &[Key::Left; 200]), Some(4), "the first one that is kept");
        assert_eq!(desk.kept.len(), KEPT);
    }
}
