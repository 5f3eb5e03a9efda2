//! [`Scanout`]: a display that shows its memory over time, one row after the other.
//!
//! A picture of a framebuffer shows it at one moment. A display never does: it reads its memory row by row, from the top down, and begins
//! anew some sixty times a second. What is drawn meanwhile is seen in the lower rows only, and so is a buffer that is exchanged, or a
//! palette that is changed:
//! ```text
//!   time --->   | blank | row 0 | row 1 |  ...  | last row | blank | row 0 | ...
//!                                   ^                      ^
//!                                   a flip here tears      here it does not
//! ```
//! Time is counted in nanoseconds of the display; nothing here looks at a clock. [`play`] is a program that draws over time, with one
//! buffer, two or three, and returns what was seen.
//! ```
//! use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
//! use embedded_raster_simulator::scanout::{play, Flips, Scanout};
//! // A program that takes 30 ms to fill the screen with another colour, in two halves.
//! let draw = |screen: &mut [Rgb888; 4], frame: u32, part: usize| {
//!     let color = [Rgb888::RED, Rgb888::BLUE][frame as usize % 2];
//!     screen.chunks_mut(2).nth(part).map(|half| {
//!         half.fill(color);
//!         15_000_000
//!     })
//! };
//! let row = |screen: &[Rgb888; 4], y: usize| vec![screen[y]];
//! let is_torn = |buffers: usize| {
//!     let mut display = Scanout::new(1, 4, 60);
//!     let black = [Rgb888::BLACK; 4];
//!     match buffers {
//!         1 => play(&mut display, [black], Flips::AtRefresh, 20, draw, row),
//!         _ => play(&mut display, [black; 2], Flips::AtRefresh, 20, draw, row),
//!     };
//!     display.take().iter().any(|picture| picture.color(0, 0) != picture.color(0, 3))
//! };
//! assert!(is_torn(1) && !is_torn(2));
//! ```

use std::ops::Range;

use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
use embedded_raster::present::{Buffer, Swapchain};

use crate::picture::Picture;

/// What a display reads.
pub trait Source {
    /// A refresh begins: from now on for some rows nothing is shown.
    fn refresh(&mut self);

    /// The colours of a row as they are now.
    fn row(&mut self, y: usize) -> Vec<Rgb888>;
}

/// A display of some size that is refreshed so many times a second. A sixteenth of the time, at the beginning of each refresh, it shows
/// nothing.
#[derive(Clone, Debug)]
pub struct Scanout {
    size: (usize, usize),
    /// Nanoseconds of a refresh.
    period: u64,
    now: u64,
    /// The refresh that is under way, and those of its rows that have been shown.
    refresh: u64,
    shown: Vec<Rgb888>,
    pictures: Vec<Picture>,
}

impl Scanout {
    /// Its first refresh begins now.
    ///
    /// # Panics
    /// If it has no rows, or is not refreshed.
    pub fn new(width: usize, height: usize, hertz: u32) -> Self {
        assert!(height > 0 && hertz > 0, "a display shows something");
        let period = 1_000_000_000 / u64::from(hertz);
        Self { size: (width, height), period, now: 0, refresh: 0, shown: vec![], pictures: vec![] }
    }

    /// Nanoseconds since it was made.
    pub fn now(&self) -> u64 {
        self.now
    }

    /// Nanoseconds of a refresh.
    pub fn period(&self) -> u64 {
        self.period
    }

    /// How long it takes until the next refresh begins.
    pub fn until_refresh(&self) -> u64 {
        (self.refresh + 1) * self.period - self.now
    }

    /// Goes on for so many nanoseconds: what is shown meanwhile is read from the source.
    pub fn run(&mut self, nanoseconds: u64, source: &mut impl Source) {
        let until = self.now + nanoseconds;
        loop {
            let row = self.shown.len() / self.size.0.max(1);
            let next = if row < self.size.1 { self.time_of(row) } else { (self.refresh + 1) * self.period };
            if next > until {
                break;
            }
            if row < self.size.1 {
                self.shown.extend(source.row(row));
                self.shown.resize((row + 1) * self.size.0, Rgb888::BLACK);
            } else {
                let colors = std::mem::take(&mut self.shown);
                self.pictures.push(Picture::from_colors(self.size.0, self.size.1, colors));
                self.refresh += 1;
                source.refresh();
            }
        }
        self.now = until;
    }

    /// What was seen since the last call: a picture for each refresh that has ended.
    pub fn take(&mut self) -> Vec<Picture> {
        std::mem::take(&mut self.pictures)
    }

    /// When a row of this refresh is shown.
    fn time_of(&self, row: usize) -> u64 {
        let Range { start, end } = self.period / 16..self.period;
        let (row, rows) = (row as u64, self.size.1 as u64);
        self.refresh * self.period + start + (end - start) * row / rows
    }
}

/// When a frame that is finished is shown.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Flips {
    /// When the next refresh begins. A program with one buffer, which has nothing to exchange, waits until then.
    AtRefresh,
    /// At once, wherever the display is.
    AtOnce,
}

/// What a program did.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Played {
    /// Frames that were drawn.
    pub frames: u32,
    /// Of these, how many were replaced by a newer one before they were shown.
    pub dropped: u32,
    /// Nanoseconds that the program waited for the display.
    pub waited: u64,
}

/// Draws frame after frame until the display has been refreshed so many times.
///
/// * `buffers`: what is drawn on, and shown.
/// * `draw`: draws a part of a frame, of the number of [`Buffer::frame`], on what the buffer holds. How many nanoseconds that took; `None`
///   if there is no such part: the frame is finished.
/// * `row`: the colours of a row of a buffer.
pub fn play<B, const N: usize>(
    display: &mut Scanout,
    buffers: [B; N],
    flips: Flips,
    refreshes: u64,
    mut draw: impl FnMut(&mut B, u32, usize) -> Option<u64>,
    row: impl Fn(&B, usize) -> Vec<Rgb888>,
) -> Played {
    let end = (display.refresh + refreshes) * display.period;
    let (mut chain, mut played) = (Swapchain::new(buffers), Played::default());
    let mut shown = 0;
    while display.now < end {
        let Some(mut buffer) = chain.begin() else {
            let wait = display.until_refresh();
            played.waited += wait;
            display.run(wait, &mut Wired { chain: &mut chain, drawn: None, flips, row: &row, shown: &mut shown });
            continue;
        };
        let frame = buffer.frame();
        let mut part = 0;
        while let Some(time) = draw(&mut buffer, frame, part) {
            // Of a single buffer the display goes on to show what is in it.
            let drawn = (N == 1).then_some(&buffer);
            display.run(time, &mut Wired { chain: &mut chain, drawn, flips, row: &row, shown: &mut shown });
            part += 1;
        }
        chain.finish(buffer);
        played.frames += 1;
        if N == 1 || flips == Flips::AtOnce {
            shown += u32::from(chain.flip().is_some());
        }
        if N == 1 && flips == Flips::AtRefresh {
            let wait = display.until_refresh();
            played.waited += wait;
            display.run(wait, &mut Wired { chain: &mut chain, drawn: None, flips, row: &row, shown: &mut shown });
        }
    }
    // One may still wait.
    shown += u32::from(chain.flip().is_some());
    played.dropped = played.frames - shown;
    played
}

/// A display that reads the buffers of a program.
struct Wired<'a, B, R, const N: usize> {
    chain: &'a mut Swapchain<B, N>,
    drawn: Option<&'a Buffer<B>>,
    flips: Flips,
    row: &'a R,
    /// Frames that were shown.
    shown: &'a mut u32,
}

impl<B, R: Fn(&B, usize) -> Vec<Rgb888>, const N: usize> Source for Wired<'_, B, R, N> {
    fn refresh(&mut self) {
        if self.flips == Flips::AtRefresh {
            *self.shown += u32::from(self.chain.flip().is_some());
        }
    }

    fn row(&mut self, y: usize) -> Vec<Rgb888> {
        self.drawn.or(self.chain.shown()).map_or(vec![], |buffer| (self.row)(buffer, y))
    }
}
