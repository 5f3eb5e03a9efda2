//! A paint program for pictures of 1, 2, 4 and 8 bits, as firmware with a small screen and a palette would have it.
//!
//! `cargo run --release --example paint` opens a window. `-- --script assets/paint-demo.txt` needs none: it carries out the
//! commands of a file, writes `paint.png` and shows it in the terminal; `-- --help` tells the rest.
//! What is drawn and how stands in `simulator/src/paint/sheet.rs`; what can be done, in `simulator/src/paint/command.rs`.

use std::{error::Error, fs, process::ExitCode};

use embedded_raster_simulator::{
    finish,
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
    finish("paint", run(lexopt::Parser::from_env()))
}

/// Does what the arguments say, and returns what there is to say of it.
fn run(arguments: lexopt::Parser) -> Result<String, Box<dyn Error>> {
    let Some(options) = Options::parse(arguments)? else {
        return Ok(format!("{USAGE}\n  {}\n\n{RANGES}\n", FORMS.join("\n  ")));
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
    Ok(report(&paint, &summary, &options.output))
}

fn report(paint: &Paint, summary: &Summary, output: &str) -> String {
    let sheet = paint.sheet();
    let (width, height) = sheet.size;
    let counted = |n: usize, what: &str| format!("{n} {what}{}", if n == 1 { "" } else { "s" });
    let (bits, slots) = (counted(sheet.bits.into(), "bit"), counted(summary.slots, "slot"));
    let bytes = counted(sheet.ram.len(), "byte");
    let (commands, pixels) = (counted(summary.commands, "command"), counted(summary.pixels, "pixel"));
    format!(
        "{output}: {width} x {height} at {bits} per pixel, {bytes} of framebuffer\n\
         done: {commands}, {pixels} changed\n\
         scratch: {slots} for the largest flood fill, of {} given\n",
        paint.scratch().slots
    )
}

fn open(mut desk: Desk) -> Result<String, Box<dyn Error>> {
    let first = desk.shot();
    let result = watch("paint", first, |events| Ok::<_, WindowError>(desk.go(events).then(|| desk.shot())));
    result.map_err(|error| format!("no window: {error}; `--script FILE` needs none"))?;
    Ok(String::new())
}

struct Options {
    size: (u16, u16),
    bits: u8,
    script: Option<String>,
    output: String,
}

impl Options {
    /// `None` if help was asked for.
    fn parse(mut arguments: lexopt::Parser) -> Result<Option<Self>, lexopt::Error> {
        use lexopt::prelude::*;
        let mut options = Self { size: (320, 240), bits: 4, script: None, output: "paint.png".into() };
        while let Some(argument) = arguments.next()? {
            match argument {
                Long("bits") => options.bits = arguments.value()?.parse_with(parse_bits)?,
                Long("size") => options.size = arguments.value()?.parse_with(parse_size)?,
                Long("script") => options.script = Some(arguments.value()?.string()?),
                Long("out" | "output") => options.output = arguments.value()?.string()?,
                Short('h') | Long("help") => return Ok(None),
                _ => return Err(argument.unexpected()),
            }
        }
        Ok(Some(options))
    }
}

fn parse_bits(text: &str) -> Result<u8, &'static str> {
    text.parse().ok().filter(|bits| [1, 2, 4, 8].contains(bits)).ok_or("--bits takes one of 1, 2, 4, 8")
}

fn parse_size(text: &str) -> Result<(u16, u16), &'static str> {
    let size = text.split_once(['x', 'X']).and_then(|(w, h)| Some((w.parse().ok()?, h.parse().ok()?)));
    let sides = 1..=1024;
    size.filter(|(w, h)| sides.contains(w) && sides.contains(h))
        .ok_or("--size takes WIDTHxHEIGHT, from 1x1 to 1024x1024")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrong_arguments_are_told_in_a_line() {
        let script = std::env::temp_dir().join(format!("paint-{}.txt", std::process::id()));
        fs::write(&script, "# night\ncolor 200\n").expect("a file");
        let script = script.display();
        for (arguments, expected) in [
            ("--size 0x0", r#"cannot parse argument "0x0": --size takes WIDTHxHEIGHT, from 1x1 to 1024x1024"#.into()),
            (
                "--size 1025x5",
                r#"cannot parse argument "1025x5": --size takes WIDTHxHEIGHT, from 1x1 to 1024x1024"#.into(),
            ),
            ("--bits 3", r#"cannot parse argument "3": --bits takes one of 1, 2, 4, 8"#.into()),
            ("--script", "missing argument for option '--script'".into()),
            ("lake.txt", r#"unexpected argument "lake.txt""#.into()),
            ("--script no-such-file.txt", "no-such-file.txt: ".into()),
            ("--script assets/paint-demo.txt --output /no/such/folder/x.png", "/no/such/folder/x.png: ".into()),
            (
                &format!("--script {script}"),
                format!("{script}: line 2: color 200 is not in 0 to 15, the colors of 4 bits"),
            ),
        ] {
            let error = run(lexopt::Parser::from_args(arguments.split(' '))).expect_err(arguments).to_string();
            assert!(error.starts_with(&expected) && !error.contains('\n'), "{arguments}: {error}");
        }
        let help = run(lexopt::Parser::from_args(["--help"])).expect("help");
        assert!(help.starts_with("usage: paint") && help.contains("line X Y X Y"), "{help}");
    }
}
