//! `cargo run -p fontbake -- FONT.bdf --out font.erf` makes a font for `embedded_raster::text`; `--help` tells the rest.

use std::{error::Error, fs, path::Path, process::ExitCode};

use embedded_raster::text::Font;
use fontbake::{bdf, chars, constant, truetype, Glyphs};

const USAGE: &str = "\
usage: fontbake FONT.bdf|FONT.ttf|FONT.otf [--size ROWS] [--chars CODES | --text TEXT] [--replacement CHAR]
                [--out FILE.erf|FILE.rs] [--name NAME]

--size ROWS         of TrueType: rows from the top of the highest letter to the bottom of the lowest: 16
--chars CODES       characters by code: 0x20-0x7e,0xb0. All of a BDF; 0x20-0x7e of TrueType
--text TEXT         the characters of a text, such as 0123456789:
--replacement CHAR  what is drawn for characters that the font lacks: ?
--out FILE          bytes for Font::read, or a Rust constant if it ends in .rs: font.erf
--name NAME         of the constant: FONT
";

fn main() -> ExitCode {
    match run(lexopt::Parser::from_env()) {
        Ok(said) => {
            print!("{said}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("fontbake: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(mut arguments: lexopt::Parser) -> Result<String, Box<dyn Error>> {
    use lexopt::prelude::*;
    let (mut file, mut size, mut wanted, mut replacement) = (None, 16.0, None, '?');
    let (mut out, mut name) = (String::from("font.erf"), String::from("FONT"));
    while let Some(argument) = arguments.next()? {
        match argument {
            Value(path) if file.is_none() => file = Some(path.string()?),
            Long("size") => size = arguments.value()?.parse_with(parse_size)?,
            Long("chars") => wanted = Some(arguments.value()?.parse_with(chars::parse)?),
            Long("text") => wanted = Some(arguments.value()?.string()?.chars().collect()),
            Long("replacement") => replacement = arguments.value()?.parse()?,
            Long("out" | "output") => out = arguments.value()?.string()?,
            Long("name") => name = arguments.value()?.parse_with(parse_name)?,
            Short('h') | Long("help") => return Ok(USAGE.into()),
            _ => return Err(argument.unexpected().into()),
        }
    }
    let Some(file) = file else { return Err("a font is wanted; --help tells more".into()) };
    let glyphs = read(&file, size, wanted, replacement).map_err(|error| format!("{file}: {error}"))?;
    let bytes = glyphs.bake()?;
    let font = Font::read(&bytes)?;
    let about = format!(
        "Made by fontbake from {}: {} glyphs of {} rows. {}",
        Path::new(&file).file_name().unwrap_or_default().to_string_lossy(),
        font.len(),
        font.height(),
        glyphs.copyright
    );
    let is_rust = Path::new(&out).extension().is_some_and(|extension| extension == "rs");
    let written = if is_rust { constant(&name, &about, &bytes).into_bytes() } else { bytes.clone() };
    fs::write(&out, written).map_err(|error| format!("{out}: {error}"))?;
    Ok(format!("{out}: {} glyphs of {} rows, {} bytes of flash\n", font.len(), font.height(), bytes.len()))
}

fn read(path: &str, size: f32, wanted: Option<Vec<char>>, replacement: char) -> Result<Glyphs, Box<dyn Error>> {
    let file = fs::read(path)?;
    if file.starts_with(b"STARTFONT") {
        return Ok(bdf::read(&file, wanted.as_deref(), replacement)?);
    }
    Ok(truetype::read(&file, size, &wanted.unwrap_or_else(chars::ascii), replacement)?)
}

fn parse_name(text: &str) -> Result<String, &'static str> {
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let is_name = text.chars().all(is_part) && text.starts_with(|c: char| !c.is_ascii_digit());
    is_name.then(|| text.into()).ok_or("--name takes a name such as LARGE")
}

fn parse_size(text: &str) -> Result<f32, &'static str> {
    text.parse().ok().filter(|size| (1.0..=255.0).contains(size)).ok_or("--size takes 1 to 255 rows")
}
