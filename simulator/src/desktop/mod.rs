//! A program on the desktop, as with a game library: a closure draws each frame, is told what was done, and which time it is.
//!
//! ```no_run
//! use embedded_raster::{pixel::EGA, Canvas, Index4, Rect};
//! use embedded_raster_simulator::{finish, run, Key};
//!
//! fn main() -> std::process::ExitCode {
//!     let mut x = 76;
//!     finish("ball", run((160, 120), EGA, |frame, input, time| {
//!         x += i32::from(input.is_down(Key::Right)) - i32::from(input.is_down(Key::Left));
//!         let y = 100 - (time.frame % 60 - 30).pow(2) / 10;
//!         frame.clear(Index4::new(1));
//!         frame.fill_ellipse(Rect::new(x, y, x + 16, y + 16), Index4::new(14));
//!         Ok(())
//!     }))
//! }
//! ```
//! The size is in pixels; the palette says which format they have: one of 16 colours takes indices of 4 bits. [`Memory`] stands for any
//! other format or layout. The memory of the frame stays from one frame to the next, as that of a microcontroller does.
//!
//! The window has keys of its own, among them those for screenshots and films: see [`window`](mod@crate::window). Without a display, or with
//! `--frames N`, the same closure draws that many frames, as fast as it can, into a file; `--out` names it. [`Desktop::play`] does
//! so in a test, with a script of keys.

mod colors;
mod driver;
mod host;
mod input;
mod inspector;
mod recorder;
mod view;

use std::{
    error::Error,
    fs,
    path::Path,
    time::{Duration, Instant},
};

use embedded_raster::{surface::Grid, Frame, Layout};

use self::view::first_size;
pub use self::{
    colors::{Colors, Memory, Through},
    host::WindowError,
    input::{Event, Input, Key},
};
pub(crate) use self::{
    driver::{drive, Shown},
    host::Glass,
};
use crate::{film, picture::Picture};

/// What goes wrong in a program.
pub type Failure = Box<dyn Error>;

/// When a frame is drawn.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Time {
    /// Its number, from 0. It stops at the largest number, after a year.
    pub frame: i32,
    /// Time since the first frame. Without a window it is the same in every run: a sixtieth of a second for each frame.
    pub now: Duration,
}

impl Time {
    /// Of a program that keeps up with sixty frames a second.
    fn of_frame(frame: i32) -> Self {
        let nanos = u64::from(frame.unsigned_abs()) * 1_000_000_000 / 60;
        Self { frame, now: Duration::from_nanos(nanos) }
    }
}

/// What a program is asked for on the command line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Options {
    /// So many frames, in one file: a film, if there are several.
    pub frames: u16,
    /// The file. Its name ends with `.png`, `.apng` or `.gif`.
    pub out: String,
    /// Opens a window instead.
    pub window: bool,
}

/// What they are, for the end of a usage text.
pub const USAGE: &str = "\
--frames N  of the film: 1
--out FILE  what is written: NAME.png, .apng or .gif unless told; with several frames, a PNG is animated
--window    shows it, until Esc: F2 writes a picture, F3 and F4 film it, F5 draws lines between pixels, F6 says what the
            pixel under the mouse is, F7, F8 and the wheel zoom, F9 shows all of it
";

impl Options {
    /// Those of a command line; `None` if it asks for help. Unless told, the file is named after the program.
    ///
    /// # Errors
    /// An option that does not exist, or a value that makes no sense.
    pub fn parse(name: &str, mut arguments: lexopt::Parser) -> Result<Option<Self>, lexopt::Error> {
        use lexopt::prelude::*;
        let mut options = Self { frames: 1, out: format!("{name}.png"), window: false };
        while let Some(argument) = arguments.next()? {
            match argument {
                Long("frames") => options.frames = arguments.value()?.parse_with(parse_frames)?,
                Long("out" | "output") => options.out = arguments.value()?.parse_with(parse_name)?,
                Long("window") => options.window = true,
                Short('h') | Long("help") => return Ok(None),
                _ => return Err(argument.unexpected()),
            }
        }
        Ok(Some(options))
    }
}

fn parse_frames(text: &str) -> Result<u16, &'static str> {
    text.parse().ok().filter(|&count| count > 0).ok_or("a number from 1 to 65535")
}

fn parse_name(text: &str) -> Result<String, &'static str> {
    let is_one = ["png", "apng", "gif"].contains(&end(text).as_str());
    is_one.then(|| text.to_owned()).ok_or("a name that ends with .png, .apng or .gif")
}

/// How the name of a file ends.
fn end(name: &str) -> String {
    Path::new(name).extension().map(|end| end.to_string_lossy().to_ascii_lowercase()).unwrap_or_default()
}

/// Runs a program: in a window, or without one as the command line or a missing display asks for.
///
/// * `size`: columns and rows of the frame.
/// * `colors`: what its pixels are, and what they look like. See [`Colors`].
/// * `draw`: called for each frame, with the memory of the last one.
///
/// Returns what there is to say at the end: `finish` prints it.
///
/// # Errors
/// An option that does not exist, those of files, and those of `draw`.
pub fn run<C: Colors>(
    size: (u16, u16),
    colors: C,
    draw: impl FnMut(&mut Frame<&mut [u8], C::Layout>, &mut Input, Time) -> Result<(), Failure>,
) -> Result<String, Failure> {
    let mut arguments = std::env::args();
    let program = arguments.next().unwrap_or_default();
    let is_asked = arguments.next().is_some();
    let name = Path::new(&program).file_stem().map_or("program".into(), |stem| stem.to_string_lossy().into_owned());
    let Some(options) = Options::parse(&name, lexopt::Parser::from_env())? else {
        return Ok(format!("usage: {name} [--frames N] [--out FILE.png|.apng|.gif] [--window]\n\n{USAGE}"));
    };
    let desktop = Desktop::new(&name, size, colors);
    if is_asked {
        return desktop.run(&options, draw);
    }
    match desktop.open() {
        Ok(window) => desktop.drive(window, draw).map(|()| String::new()),
        Err(error) => Ok(format!("no window: {error}\n{}", desktop.write(&options, draw)?)),
    }
}

/// What draws a frame.
trait Draw<L>: FnMut(&mut Frame<&mut [u8], L>, &mut Input, Time) -> Result<(), Failure> {}

impl<L, F: FnMut(&mut Frame<&mut [u8], L>, &mut Input, Time) -> Result<(), Failure>> Draw<L> for F {}

/// A program by its name, the size of its frame, and the colours of its pixels: [`run`] in parts.
#[derive(Clone, Debug)]
pub struct Desktop<C> {
    name: String,
    size: (u16, u16),
    colors: C,
}

impl<C: Colors> Desktop<C> {
    /// A program of this name, with a frame of so many columns and rows.
    pub fn new(name: &str, size: (u16, u16), colors: C) -> Self {
        Self { name: name.into(), size, colors }
    }

    /// Opens a window or writes a file, as the options say. Returns a line that says what was written.
    ///
    /// # Errors
    /// If no window can be opened, those of files, and those of `draw`.
    pub fn run(
        self,
        options: &Options,
        draw: impl FnMut(&mut Frame<&mut [u8], C::Layout>, &mut Input, Time) -> Result<(), Failure>,
    ) -> Result<String, Failure> {
        if options.window {
            let window = self
                .open()
                .map_err(|error| format!("{error} (a window needs a display; without --window, a file is written)"))?;
            return self.drive(window, draw).map(|()| String::new());
        }
        self.write(options, draw)
    }

    /// The pictures of as many frames as the script has, each with what is done before it: for tests.
    /// ```
    /// use embedded_raster::{pixel::EGA, Canvas, Index4, Surface};
    /// use embedded_raster_simulator::desktop::{Desktop, Input, Key};
    /// let mut x = 0;
    /// let script = [Input::keys(&[Key::Right]), Input::default(), Input::keys(&[Key::Right])];
    /// let pictures = Desktop::new("dot", (4, 1), EGA).play(script, |frame, input, _| {
    ///     x += i32::from(input.is_pressed(Key::Right));
    ///     frame.draw_point((x, 0), Index4::new(15));
    ///     Ok(())
    /// })?;
    /// let row = |at: usize| [0, 1, 2, 3].map(|x| pictures[at].index(x, 0).unwrap_or(0));
    /// assert_eq!([row(0), row(1), row(2)], [[0, 15, 0, 0], [0, 15, 0, 0], [0, 15, 15, 0]]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// Those of `draw`.
    pub fn play(
        &self,
        script: impl IntoIterator<Item = Input>,
        mut draw: impl FnMut(&mut Frame<&mut [u8], C::Layout>, &mut Input, Time) -> Result<(), Failure>,
    ) -> Result<Vec<Picture>, Failure> {
        let (mut memory, mut pictures) = (self.memory(), vec![]);
        for (number, mut input) in (0..).zip(script) {
            pictures.push(self.frame(&mut memory, &mut input, Time::of_frame(number), &mut draw)?);
            if input.closes {
                break;
            }
        }
        Ok(pictures)
    }

    fn memory(&self) -> Vec<u8> {
        let (width, height) = self.size;
        let stride = C::Layout::row_bytes(width);
        vec![0; C::Layout::bytes(width, Grid { stride, rows: height.into() })]
    }

    fn frame(
        &self,
        memory: &mut [u8],
        input: &mut Input,
        time: Time,
        draw: &mut impl Draw<C::Layout>,
    ) -> Result<Picture, Failure> {
        let mut frame = Frame::<_, C::Layout>::new(memory, self.size.0, self.size.1)?;
        draw(&mut frame, input, time)?;
        Ok(self.colors.picture(&frame.as_bitmap()))
    }

    fn open(&self) -> Result<Glass, WindowError> {
        Glass::open(&self.name, first_size((self.size.0.into(), self.size.1.into())))
    }

    fn drive(self, mut window: Glass, mut draw: impl Draw<C::Layout>) -> Result<(), Failure> {
        let (mut memory, started) = (self.memory(), Instant::now());
        let caption = format!("{} x {} | {} bytes of RAM", self.size.0, self.size.1, memory.len());
        let mut time = Time::default();
        let picture = self.frame(&mut memory, &mut Input::default(), time, &mut draw)?;
        let first = Shown { picture, caption: caption.clone() };
        drive(&mut window, &self.name, ".", first, |input| {
            time = Time { frame: time.frame.saturating_add(1), now: started.elapsed() };
            let picture = self.frame(&mut memory, input, time, &mut draw)?;
            Ok(Some(Shown { picture, caption: caption.clone() }))
        })
    }

    fn write(&self, options: &Options, draw: impl Draw<C::Layout>) -> Result<String, Failure> {
        let pictures = self.play(vec![Input::default(); options.frames.into()], draw)?;
        let (Some(first), count) = (pictures.first(), pictures.len()) else { return Err("no frame".into()) };
        first.show(100);
        match (end(&options.out).as_str(), count) {
            ("png" | "apng", 1) => first.write_png(&options.out)?,
            (kind, _) => {
                let timed: Vec<_> = pictures.into_iter().map(|picture| (picture, film::DELAY)).collect();
                let bytes = if kind == "gif" { film::timed_gif(&timed)? } else { film::timed_apng(&timed)? };
                fs::write(&options.out, bytes).map_err(|error| format!("{}: {error}", options.out))?;
            }
        }
        let ((width, height), plural) = (self.size, if count == 1 { "" } else { "s" });
        let bytes = self.memory().len();
        Ok(format!("{}: {width} x {height}, {count} frame{plural}, {bytes} bytes of memory\n", options.out))
    }
}

#[cfg(test)]
mod tests {
    use std::{cell::RefCell, rc::Rc};

    use embedded_graphics_core::pixelcolor::{BinaryColor, Gray4, Gray8, Rgb565, Rgb888, RgbColor};
    use embedded_raster::{
        pixel::{Be, Lsb0, Xrgb8888, EGA},
        surface::{Packed12, Pages, Planes, Rows},
        Canvas, Index1, Index2, Index4, Index8, Palette,
    };

    use super::*;

    /// What a program of three frames shows: a dot that moves one pixel a frame, or to the other end with a key.
    fn shown<C: Colors>(colors: C, ink: <C::Layout as Layout>::Color) -> Vec<Vec<(usize, usize)>> {
        let script = [Input::default(), Input::keys(&[Key::End]), Input::default()];
        let mut x = 0;
        let pictures = Desktop::new("dot", (13, 9), colors).play(script, |frame, input, time| {
            x = if input.is_pressed(Key::End) { 12 } else { x + 1 };
            frame.draw_point((x, 3 + time.frame), ink);
            Ok(())
        });
        let lit = |picture: &Picture| {
            let all = (0..13).flat_map(|x| (0..9).map(move |y| (x, y)));
            all.filter(|&(x, y)| picture.color(x, y) != Some(Rgb888::BLACK)).collect()
        };
        pictures.expect("no error").iter().map(lit).collect()
    }

    #[test]
    fn every_format_and_layout_is_shown() {
        let expected = [vec![(1, 3)], vec![(1, 3), (12, 4)], vec![(1, 3), (12, 4), (13, 5)][..2].to_vec()];
        let two = Palette::new([Rgb888::BLACK, Rgb888::WHITE]);
        let greys = Palette::<Rgb888, 256>::greys();
        let four = Palette::<Rgb888, 4>::greys();
        macro_rules! all {
            ($($colors:expr => $ink:expr),* $(,)?) => {$(
                assert_eq!(shown($colors, $ink), expected, stringify!($colors));
            )*};
        }
        all! {
            two => Index1::new(1),
            four => Index2::new(2),
            EGA => Index4::new(9),
            greys => Index8::new(200),
            &EGA => Index4::new(9),
            RefCell::new(EGA) => Index4::new(9),
            Rc::new(EGA) => Index4::new(9),
            Memory::<Rows<BinaryColor>>::new() => BinaryColor::On,
            Memory::<Rows<Gray4>>::new() => Gray4::new(7),
            Memory::<Rows<Gray8>>::new() => Gray8::new(7),
            Memory::<Rows<Rgb565>>::new() => Rgb565::RED,
            Memory::<Rows<Be<Rgb565>>>::new() => Rgb565::RED,
            Memory::<Rows<Rgb888>>::new() => Rgb888::RED,
            Memory::<Rows<Xrgb8888>>::new() => Xrgb8888::from(Rgb888::RED),
            Memory::<Pages<Lsb0<BinaryColor>>>::new() => BinaryColor::On,
            Memory::<Packed12>::new() => RgbColor::RED,
            Memory::<Planes<Index2>>::new().through(four) => Index2::new(2),
            Memory::<Rows<Lsb0<Index4>>>::new().through(EGA) => Index4::new(9),
        }
    }

    #[test]
    fn a_palette_may_change() {
        let colors = RefCell::new(Palette::new([Rgb888::BLACK, Rgb888::RED]));
        let pictures = Desktop::new("blink", (1, 1), &colors).play(vec![Input::default(); 2], |frame, _, time| {
            frame.clear(Index1::new(1));
            if time.frame == 1 {
                colors.borrow_mut().set(1, Rgb888::BLUE);
            }
            Ok(())
        });
        let pictures = pictures.expect("no error");
        assert_eq!([0, 1].map(|n| pictures[n].color(0, 0)), [Some(Rgb888::RED), Some(Rgb888::BLUE)]);
    }

    #[test]
    fn time_without_a_window_is_the_same_in_every_run() {
        let mut times = vec![];
        let desktop = Desktop::new("clock", (1, 1), EGA);
        let played = desktop.play(vec![Input::default(); 121], |_, input, time| {
            times.push(time.now);
            if time.frame == 90 {
                input.close();
            }
            Ok(())
        });
        assert_eq!((played.map(|pictures| pictures.len()).ok(), times.len()), (Some(91), 91), "it closes itself");
        assert_eq!((times[60], times[90]), (Duration::from_secs(1), Duration::from_millis(1500)), "sixty a second");
    }

    #[test]
    fn options_are_what_the_usage_says() {
        let parse = |text: &str| Options::parse("ball", lexopt::Parser::from_args(text.split_whitespace()));
        let options = |frames, out: &str, window| Some(Options { frames, out: out.into(), window });
        assert_eq!(parse("").ok(), Some(options(1, "ball.png", false)));
        assert_eq!(parse("--frames 30 --out x.GIF --window").ok(), Some(options(30, "x.GIF", true)));
        assert_eq!(parse("--help").ok(), Some(None));
        for wrong in ["--frames 0", "--frames x", "--out x.jpg", "--out gif", "--size 3x3", "x.png"] {
            assert!(parse(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn files_are_written_without_a_window() {
        let write = |name: &str, frames| {
            let out = std::env::temp_dir().join(format!("embedded-raster-desktop-{}-{name}", std::process::id()));
            let out = out.to_str().expect("a plain name").to_owned();
            let options = Options { frames, out: out.clone(), window: false };
            let said = Desktop::new("dot", (2, 1), EGA).run(&options, |frame, _, time| {
                frame.draw_point((0, 0), Index4::new(9 + u8::try_from(time.frame).expect("few frames")));
                Ok(())
            });
            (said.expect("it can be written"), out)
        };
        for (name, frames, end) in
            [("a.png", 1, "2 x 1, 1 frame, 1 bytes of memory\n"), ("b.apng", 3, "2 x 1, 3 frames, 1 bytes of memory\n")]
        {
            let (said, out) = write(name, frames);
            assert!(said.ends_with(end), "{said}");
            assert_eq!(Picture::read_png(&out).expect("a picture").index(0, 0), Some(9), "the first");
            fs::remove_file(out).expect("it is there");
        }
        let (_, out) = write("c.gif", 2);
        assert!(fs::read(&out).expect("it is there").starts_with(b"GIF89a"));
        fs::remove_file(out).expect("it is there");
    }
}
