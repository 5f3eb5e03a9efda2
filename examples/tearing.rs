//! What is seen of one buffer, two and three: a display that is refreshed 60 times a second, and a program that takes 14 ms for a frame.
//!
//! `cargo run --release --example tearing -- --frames 60 --out tearing.gif` shows four screens side by side, refresh by refresh. The bars
//! move to the right, and are upright; where one is broken, the picture tears.

#[expect(clippy::cast_possible_truncation, reason = "bytes of a table")]
#[expect(unreachable_pub, reason = "it is public in its own crate")]
#[path = "../firmware/board/src/crc.rs"]
mod crc;

use std::{error::Error, process::ExitCode};

use embedded_graphics::{
    mono_font::{ascii::FONT_6X10, MonoTextStyle},
    pixelcolor::Rgb888,
    prelude::*,
    text::{Alignment, Text},
};
use embedded_raster::{buffer_bytes, pixel::EGA, Canvas, Framebuffer, Index4, Rect};
use embedded_raster_simulator::{
    finish,
    moving::{run, Moment, Moving, Options, USAGE},
    scanout::{play, Flips, Scanout},
    Picture,
};

/// Nanoseconds for each part of a frame.
const TIME: u64 = 2_000_000;
/// Parts of a frame: it is cleared, and then the bars are drawn, from the bottom up.
const PARTS: i32 = 7;

fn main() -> ExitCode {
    finish("tearing", go())
}

fn go() -> Result<String, Box<dyn Error>> {
    match Options::from_command_line("tearing", [320, 240])? {
        Some(options) => run("tearing", &options, Tearing::new(options.size)),
        None => {
            Ok(format!("usage: tearing [--size WxH] [--frames N] [--out FILE.png|.apng|.gif] [--window]\n\n{USAGE}\n"))
        }
    }
}

/// The four screens: what is written above each, and what was seen.
const SCREENS: [&str; 4] = ["one buffer", "two, flipped at once", "two", "three"];

struct Tearing {
    size: [u16; 2],
    /// Refreshes that have been seen.
    seen: [Vec<Picture>; 4],
    refresh: usize,
}

/// Refreshes that are played: then they begin anew.
const REFRESHES: usize = 120;

impl Tearing {
    fn new(size: [u16; 2]) -> Self {
        // A screen in each corner, below its title.
        let inner = [size[0] / 2, (size[1] / 2).saturating_sub(14)].map(|side| side.max(1));
        let seen = [
            seen::<1>(inner, Flips::AtOnce),
            seen::<2>(inner, Flips::AtOnce),
            seen::<2>(inner, Flips::AtRefresh),
            seen::<3>(inner, Flips::AtRefresh),
        ];
        Self { size, seen, refresh: 3 }
    }
}

/// What a display shows of a program with `N` buffers.
fn seen<const N: usize>([width, height]: [u16; 2], flips: Flips) -> Vec<Picture> {
    let mut display = Scanout::new(width.into(), height.into(), 60);
    let bytes = buffer_bytes::<Index4>(width, height);
    let draw = |memory: &mut Vec<u8>, frame: u32, part: usize| {
        let mut on = Framebuffer::<Index4>::new(memory, width, height).ok()?;
        let (wide, high) = (i32::from(width), i32::from(height));
        let part = i32::try_from(part).ok().filter(|&part| part < PARTS)?;
        if part == 0 {
            on.clear(Index4::new(1));
        }
        let (y0, y1) = (high - high * part / (PARTS - 1), high - high * (part - 1) / (PARTS - 1));
        let first = i32::try_from(frame).ok()? * 5 % (wide / 3).max(1);
        for x in (first..wide).step_by((wide / 3).max(1).unsigned_abs() as usize) {
            on.fill_rectangle(Rect::new(x, y0, x + wide / 12 + 1, y1.min(high)), Index4::new(14));
        }
        Some(TIME)
    };
    let row = |memory: &Vec<u8>, y: usize| {
        let bytes = bytes / usize::from(height);
        let index = |x: usize| memory[y * bytes + x / 2] >> (4 - x % 2 * 4) & 15;
        (0..usize::from(width)).map(|x| EGA.colors()[usize::from(index(x))]).collect()
    };
    play(&mut display, [(); N].map(|()| vec![0; bytes]), flips, REFRESHES as u64, draw, row);
    display.take()
}

impl Moving for Tearing {
    fn next(&mut self) -> Result<Moment, embedded_raster::Error> {
        let [width, height] = self.size;
        let mut memory = vec![0; buffer_bytes::<Rgb888>(width, height)];
        let mut all = Framebuffer::<Rgb888>::new(&mut memory, width, height)?;
        for (number, (title, seen)) in SCREENS.iter().zip(&self.seen).enumerate() {
            let picture = &seen[self.refresh % seen.len()];
            let [right, down] = [number % 2, number / 2].map(|n| i32::try_from(n).unwrap_or(0));
            let (x, y) = (right * i32::from(width) / 2, down * i32::from(height) / 2);
            let mut screen = all.view(Rect::new(x, y, x + i32::from(width) / 2, y + i32::from(height) / 2));
            let middle = Point::new(i32::from(width) / 4, 9);
            let style = MonoTextStyle::new(&FONT_6X10, Rgb888::WHITE);
            let Ok(_) = Text::with_alignment(title, middle, style, Alignment::Center).draw(&mut screen);
            let places = (0..picture.height()).flat_map(|y| (0..picture.width()).map(move |x| (x, y)));
            for ((x, y), color) in places.zip(picture.colors()) {
                let [x, y] = [x, y + 14].map(|n| i32::try_from(n).unwrap_or(0));
                screen.draw_point((x, y), color);
            }
        }
        self.refresh += 1;
        let (picture, bytes) = (Picture::of(&all), buffer_bytes::<Index4>(width / 2, height / 2));
        Ok(Moment { picture, sent: vec![], drawn: vec![], crc32: crc::crc32(&memory), ram: 8 * bytes })
    }
}
