//! An analogue clock with soft rims, on one bit, on 16 greys, on a palette of 16 colours and on 16 bits per pixel.
//!
//! `cargo run --release --example clock` writes `clock.png` and shows it in the terminal; `-- --help` tells the rest. What is drawn
//! stands in `simulator/src/clock.rs`.
#![allow(clippy::cast_possible_truncation, reason = "times of a day are small")]

use std::{error::Error, process::ExitCode, time::Instant};

use embedded_raster_simulator::{
    clock::{clock, Screen, Time},
    finish, show, Key, Picture, Shot,
};

const USAGE: &str = "\
usage: clock [--screen mono|gray4|palette16|rgb565] [--size N] [--time H:MM:SS] [--band ROWS] [--out FILE.png] [--window]

--screen        what it is shown on: rgb565
--size N        columns and rows: 160, at most 2000
--time H:MM:SS  what it shows: 10:09:36
--band ROWS     draws so many rows at a time: the same picture
--out FILE.png  what is written: clock.png
--window        shows it going; D changes the screen, Esc quits
";

fn main() -> ExitCode {
    finish("clock", run(lexopt::Parser::from_env()))
}

fn run(arguments: lexopt::Parser) -> Result<String, Box<dyn Error>> {
    let Some(options) = Options::parse(arguments)? else { return Ok(USAGE.into()) };
    if options.window {
        watch(options)?;
        return Ok(String::new());
    }
    let picture = options.draw(options.time)?;
    picture.write_png(&options.out)?;
    picture.show(100);
    Ok(format!("{}: {} x {}\n", options.out, options.size, options.size))
}

/// Shows it going, a second each second.
fn watch(mut options: Options) -> Result<(), Box<dyn Error>> {
    let start = Instant::now();
    let first = options.shot(options.time)?;
    show::<Box<dyn Error>>("clock", first, |keys| {
        if keys.contains(&Key::D) {
            let place = Screen::ALL.iter().position(|&(_, screen)| screen == options.screen).unwrap_or(0);
            options.screen = Screen::ALL[(place + 1) % Screen::ALL.len()].1;
        }
        let (hours, minutes, seconds) = options.time;
        let now = u64::from(hours) * 3600 + u64::from(minutes) * 60 + u64::from(seconds) + start.elapsed().as_secs();
        let time = ((now / 3600 % 24) as u8, (now / 60 % 60) as u8, (now % 60) as u8);
        Ok(Some(options.shot(time)?))
    })
}

struct Options {
    screen: Screen,
    size: u16,
    time: Time,
    band: u16,
    out: String,
    window: bool,
}

impl Options {
    /// `None` if help was asked for.
    fn parse(mut arguments: lexopt::Parser) -> Result<Option<Self>, lexopt::Error> {
        use lexopt::prelude::*;
        let mut options = Self {
            screen: Screen::Rgb565,
            size: 160,
            time: (10, 9, 36),
            band: u16::MAX,
            out: "clock.png".into(),
            window: false,
        };
        while let Some(argument) = arguments.next()? {
            match argument {
                Long("screen") => options.screen = arguments.value()?.parse_with(parse_screen)?,
                Long("size") => options.size = arguments.value()?.parse_with(|text| parse_number(text, 2_000))?,
                Long("band") => options.band = arguments.value()?.parse_with(|text| parse_number(text, u16::MAX))?,
                Long("time") => options.time = arguments.value()?.parse_with(parse_time)?,
                Long("out" | "output") => options.out = arguments.value()?.string()?,
                Long("window") => options.window = true,
                Short('h') | Long("help") => return Ok(None),
                _ => return Err(argument.unexpected()),
            }
        }
        Ok(Some(options))
    }

    fn draw(&self, time: Time) -> Result<Picture, embedded_raster::Error> {
        clock(self.screen, self.size, time, self.band)
    }

    fn shot(&self, time: Time) -> Result<Shot, embedded_raster::Error> {
        let (caption, bits) = match self.screen {
            Screen::Mono => ("1 bit, dithered", 1),
            Screen::Gray4 => ("16 greys", 4),
            Screen::Palette16 => ("16 colours", 4),
            Screen::Rgb565 => ("16 bits", 16),
        };
        let pixels = usize::from(self.size) * usize::from(self.size);
        Ok(Shot { picture: self.draw(time)?, caption: caption.into(), ram: pixels * bits / 8, drawn: pixels as u64 })
    }
}

fn parse_screen(text: &str) -> Result<Screen, &'static str> {
    let known = Screen::ALL.iter().find(|(name, _)| *name == text);
    known.map(|&(_, screen)| screen).ok_or("--screen takes mono, gray4, palette16 or rgb565")
}

fn parse_number(text: &str, most: u16) -> Result<u16, String> {
    text.parse().ok().filter(|n| (1..=most).contains(n)).ok_or_else(|| format!("a number from 1 to {most} is wanted"))
}

fn parse_time(text: &str) -> Result<Time, &'static str> {
    let parts: Vec<u8> = text.split(':').map_while(|part| part.parse().ok()).collect();
    match parts[..] {
        [h, m, s] if h < 24 && m < 60 && s < 60 && text.split(':').count() == 3 => Ok((h, m, s)),
        _ => Err("--time takes H:MM:SS"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bands_change_nothing() {
        for (name, screen) in Screen::ALL {
            let drawn = |rows| clock(screen, 90, (4, 51, 7), rows).expect("enough memory");
            let whole = drawn(90);
            for rows in [1, 7, 64] {
                assert!(drawn(rows).colors().eq(whole.colors()), "{name} in bands of {rows} rows");
            }
        }
    }

    #[test]
    fn wrong_arguments_are_told_in_a_line() {
        for (arguments, expected) in [
            ("--time 10:60:00", r#"cannot parse argument "10:60:00": --time takes H:MM:SS"#),
            ("--screen epaper", r#"cannot parse argument "epaper": --screen takes mono"#),
            ("--size 0", r#"cannot parse argument "0": a number from 1 to 2000 is wanted"#),
            ("--size 9 --out /no/such/folder/x.png", "/no/such/folder/x.png: "),
        ] {
            let error = run(lexopt::Parser::from_args(arguments.split(' '))).expect_err(arguments).to_string();
            assert!(error.starts_with(expected) && !error.contains('\n'), "{arguments}: {error}");
        }
    }
}
