//! A gauge on 128 x 64 pixels at one bit: a dial with ticks and numerals, and a needle.
//!
//! `cargo run --release --example gauge` writes `gauge.png` and shows it in the terminal; `-- --help` tells the rest. What is drawn
//! stands in `simulator/src/gauge.rs`.
#![allow(clippy::cast_possible_truncation, reason = "the needle goes from 0 to 1,000")]

use std::{error::Error, process::ExitCode, time::Instant};

use embedded_raster_simulator::{
    finish,
    gauge::{gauge, MOST, SIZE},
    show, Shot,
};

const USAGE: &str = "\
usage: gauge [--value N] [--zoom N] [--out FILE.png] [--window]

--value N       what it shows, in tenths: 724, at most 1000
--zoom N        so many times as large: 4, at most 16
--out FILE.png  what is written: gauge.png
--window        shows it going up and down; Esc quits
";

fn main() -> ExitCode {
    finish("gauge", run(lexopt::Parser::from_env()))
}

fn run(arguments: lexopt::Parser) -> Result<String, Box<dyn Error>> {
    let Some(options) = Options::parse(arguments)? else { return Ok(USAGE.into()) };
    if options.window {
        watch(options.value)?;
        return Ok(String::new());
    }
    let picture = gauge(options.value)?.zoomed(options.zoom.into());
    picture.write_png(&options.out)?;
    picture.show(100);
    Ok(format!("{}: {} x {}, {} times as large\n", options.out, SIZE.0, SIZE.1, options.zoom))
}

/// Shows it from a value up to the end, back to the start, and so on.
fn watch(from: u16) -> Result<(), Box<dyn Error>> {
    let start = Instant::now();
    show::<Box<dyn Error>>("gauge", shot(from)?, |_| {
        let passed = u64::from(from) + start.elapsed().as_millis() as u64 / 8;
        let turn = passed % (2 * u64::from(MOST));
        Ok(Some(shot(turn.min(2 * u64::from(MOST) - turn) as u16)?))
    })
}

fn shot(value: u16) -> Result<Shot, embedded_raster::Error> {
    let pixels = usize::from(SIZE.0) * usize::from(SIZE.1);
    Ok(Shot { picture: gauge(value)?, caption: "1 bit".into(), ram: pixels / 8, drawn: pixels as u64 })
}

struct Options {
    value: u16,
    zoom: u16,
    out: String,
    window: bool,
}

impl Options {
    /// `None` if help was asked for.
    fn parse(mut arguments: lexopt::Parser) -> Result<Option<Self>, lexopt::Error> {
        use lexopt::prelude::*;
        let mut options = Self { value: 724, zoom: 4, out: "gauge.png".into(), window: false };
        while let Some(argument) = arguments.next()? {
            match argument {
                Long("value") => options.value = arguments.value()?.parse_with(|text| parse_number(text, 0, MOST))?,
                Long("zoom") => options.zoom = arguments.value()?.parse_with(|text| parse_number(text, 1, 16))?,
                Long("out" | "output") => options.out = arguments.value()?.string()?,
                Long("window") => options.window = true,
                Short('h') | Long("help") => return Ok(None),
                _ => return Err(argument.unexpected()),
            }
        }
        Ok(Some(options))
    }
}

fn parse_number(text: &str, least: u16, most: u16) -> Result<u16, String> {
    let number = text.parse().ok().filter(|n| (least..=most).contains(n));
    number.ok_or_else(|| format!("a number from {least} to {most} is wanted"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_needle_moves() {
        let pictures = [0, 333, 1000].map(|value| gauge(value).expect("enough memory"));
        assert!(pictures[0] != pictures[1] && pictures[1] != pictures[2], "three values");
        assert!(gauge(u16::MAX).expect("enough memory") == pictures[2], "beyond the end");
    }

    #[test]
    fn wrong_arguments_are_told_in_a_line() {
        for (arguments, expected) in [
            ("--value 1001", r#"cannot parse argument "1001": a number from 0 to 1000 is wanted"#),
            ("--zoom 0", r#"cannot parse argument "0": a number from 1 to 16 is wanted"#),
            ("--out /no/such/folder/x.png", "/no/such/folder/x.png: "),
        ] {
            let error = run(lexopt::Parser::from_args(arguments.split(' '))).expect_err(arguments).to_string();
            assert!(error.starts_with(expected) && !error.contains('\n'), "{arguments}: {error}");
        }
    }
}
