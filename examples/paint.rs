//! A paint program for pictures of 1, 2, 4 and 8 bits, as firmware with a small screen and a palette would have it.
//!
//! `cargo run --release --example paint` opens a window. `-- --script assets/paint-demo.txt` needs none: it carries out the
//! commands of a file, writes `paint.png` and shows it in the terminal; `-- --help` tells the rest.
//! What is drawn and how stands in `simulator/src/paint/sheet.rs`; what can be done, in `simulator/src/paint/command.rs`.

use std::{error::Error, fs, process::ExitCode};

use embedded_raster_simulator::{
    paint::{replay, Desk, Paint, Summary, FORMS},
    watch, WindowError,
};

const USAGE: &str = "\
usage: paint [--bits 1|2|4|8] [--size WxH] [--script FILE] [--output FILE.png]

--bits         depth to start with: 4
--size         size to start with: 320x240, at most 1024x1024
--script FILE  does what the lines of a file say, without a window
--output FILE  what is written, by a script or by S in the window: paint.png

In the window: 1 to 6 take a tool, O fills shapes or not, U and Y undo and redo, N clears, S saves. Arrows or a click choose a
colour; R, G, B change it (with shift downwards), [ and ] set the range that C cycles. A polygon takes a click for each corner
and is closed by a right click or Enter; Backspace drops it. Esc quits.

In a script, a line is one of these; what follows a # is a comment:";

/// What numbers in a script may be.
const RANGES: &str = "\
Sizes go from 1 to 1024, scratch memory from 0 to 1024. A color or an entry of the palette that the depth does not have is an
error; a range may reach beyond the depth: what is not there does not cycle. Coordinates are any whole numbers of 32 bits: what
lies outside of the sheet is not drawn.";

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("paint: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Box<dyn Error>> {
    let Some(options) = Options::from_command_line()? else {
        println!("{USAGE}\n  {}\n\n{RANGES}", FORMS.join("\n  "));
        return Ok(());
    };
    let mut paint = Paint::new(options.size, options.bits);
    let Some(path) = &options.script else {
        return open(Desk::new(paint, options.output));
    };
    let script = fs::read_to_string(path).map_err(|error| format!("{path}: {error}"))?;
    let summary = replay(&script, &mut paint).map_err(|error| format!("{path}: {error}"))?;
    let picture = paint.picture();
    picture.write_png(&options.output)?;
    picture.show(100);
    report(&paint, &summary, &options.output);
    Ok(())
}

fn report(paint: &Paint, summary: &Summary, output: &str) {
    let sheet = paint.sheet();
    let (width, height) = sheet.size;
    println!("{output}: {width} x {height} at {} bits per pixel, {} bytes of framebuffer", sheet.bits, sheet.ram.len());
    let plural = if summary.commands == 1 { "" } else { "s" };
    println!("done: {} command{plural}, {} pixels changed", summary.commands, summary.pixels);
    println!("scratch: {} slots for the largest flood fill, of {} given", summary.slots, paint.scratch().slots);
}

fn open(mut desk: Desk) -> Result<(), Box<dyn Error>> {
    let first = desk.shot();
    let result = watch("paint", first, |events| Ok::<_, WindowError>(desk.go(events).then(|| desk.shot())));
    result.map_err(|error| format!("no window: {error}; `--script FILE` needs none").into())
}

struct Options {
    size: (u16, u16),
    bits: u8,
    script: Option<String>,
    output: String,
}

impl Options {
    /// `None` if help was asked for.
    fn from_command_line() -> Result<Option<Self>, lexopt::Error> {
        use lexopt::prelude::*;
        let mut options = Self { size: (320, 240), bits: 4, script: None, output: "paint.png".into() };
        let mut arguments = lexopt::Parser::from_env();
        while let Some(argument) = arguments.next()? {
            match argument {
                Long("bits") => options.bits = arguments.value()?.parse_with(parse_bits)?,
                Long("size") => options.size = arguments.value()?.parse_with(parse_size)?,
                Long("script") => options.script = Some(arguments.value()?.string()?),
                Long("output") => options.output = arguments.value()?.string()?,
                Short('h') | Long("help") => return Ok(None),
                _ => return Err(argument.unexpected()),
            }
        }
        Ok(Some(options))
    }
}

fn parse_bits(text: &str) -> Result<u8, &'static str> {
    text.parse().ok().filter(|bits| [1, 2, 4, 8].contains(bits)).ok_or("one of 1, 2, 4, 8")
}

fn parse_size(text: &str) -> Result<(u16, u16), &'static str> {
    let size = text.split_once(['x', 'X']).and_then(|(w, h)| Some((w.parse().ok()?, h.parse().ok()?)));
    let sides = 1..=1024;
    size.filter(|(w, h)| sides.contains(w) && sides.contains(h)).ok_or("WIDTHxHEIGHT, from 1x1 to 1024x1024")
}
