//! SVG files to packed paths: constants of a Rust program, in about half of the bytes of their texts.
//!
//! ```sh
//! cargo run -p embedded-raster-simulator --bin pathbake -- home.svg star.svg --out icons.rs
//! ```

use std::{error::Error, fmt::Write, fs, path::Path, process::ExitCode};

use embedded_raster::{Cap, FillRule, Join};
use embedded_raster_simulator::svg::{pack, File, Outline, Shape};
use fixed::types::I24F8;

const HELP: &str = "\
Packs the paths of SVG files into constants of a Rust program, to be drawn by `embedded-raster`.

pathbake FILE.svg... [options]

--size WIDTHxHEIGHT  the pixels that a file is fitted into, as large as it asks for if this is not given
--tolerance PIXELS   how far a place may be from where it was, along x or y: 0.02 if this is not given
--out FILE.rs        where to write; to the terminal if this is not given

Paths that follow each other and are stroked in the same way become one. What a file asks for beyond paths, basic shapes, groups,
transforms and flat colours is named on the standard error. Colours are left to the program.";

struct Options {
    files: Vec<String>,
    size: Option<(u16, u16)>,
    /// In units of 1/256 pixel.
    tolerance: u32,
    out: Option<String>,
}

impl Options {
    /// Of the command line; `None` if it asks for help.
    fn parse(mut arguments: impl Iterator<Item = String>) -> Result<Option<Self>, String> {
        let mut options = Self { files: vec![], size: None, tolerance: 5, out: None };
        while let Some(argument) = arguments.next() {
            let mut value = || arguments.next().ok_or(format!("{argument} takes a value"));
            match argument.as_str() {
                "-h" | "--help" => return Ok(None),
                "--size" => {
                    let text = value()?;
                    let size = text.split_once('x').and_then(|(w, h)| Some((w.parse().ok()?, h.parse().ok()?)));
                    let size = size.filter(|&(w, h): &(u16, u16)| w > 0 && h > 0);
                    options.size = Some(size.ok_or("--size takes WIDTHxHEIGHT")?);
                }
                "--tolerance" => {
                    let text = value()?;
                    let pixels = text.parse::<I24F8>().ok().filter(|pixels| *pixels >= 0);
                    options.tolerance =
                        pixels.ok_or("--tolerance takes pixels, such as 0.02")?.to_bits().unsigned_abs();
                }
                "--out" => options.out = Some(value()?),
                _ if argument.starts_with('-') => return Err(format!("there is no option {argument}")),
                _ => options.files.push(argument),
            }
        }
        if options.files.is_empty() {
            return Err("there is no file: pathbake FILE.svg... [--out FILE.rs]".into());
        }
        Ok(Some(options))
    }
}

fn main() -> ExitCode {
    let told = match Options::parse(std::env::args().skip(1)) {
        Ok(Some(options)) => bake(&options).map_err(|error| error.to_string()),
        Ok(None) => {
            println!("{HELP}");
            Ok(())
        }
        Err(error) => Err(error),
    };
    match told {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

/// Writes the program text.
fn bake(options: &Options) -> Result<(), Box<dyn Error>> {
    let mut text = String::from(
        "//! Icons. Written by `pathbake`: see `embedded_raster::geom::packed`.\n\nuse embedded_raster::{PackedPath, Path};\n",
    );
    let (mut packed, mut written) = (0, 0);
    for name in &options.files {
        let named = |error: String| format!("{name}: {error}");
        let mut file =
            File::parse(&fs::read_to_string(name).map_err(|error| named(error.to_string()))?).map_err(named)?;
        let size = options.size.unwrap_or_else(|| file.size());
        let shapes = joined(file.shapes(size, [1.0, 0.0, 0.0, 1.0, 0.0, 0.0], I24F8::ZERO));
        let data = file.data().map(str::len).sum::<usize>();
        for unknown in &file.unknown {
            eprintln!("{name}: {unknown} is left out");
        }
        let mut bytes = 0;
        for (i, shape) in shapes.iter().enumerate() {
            let path = pack(shape.path.iter().copied(), options.tolerance).map_err(named)?;
            bytes += path.len();
            let number = if shapes.len() > 1 { format!("_{i}") } else { String::new() };
            let constant = format!("{}{number}", constant(name));
            write!(text, "\n/// {name}, {} x {}: {}. {} bytes.\n", size.0, size.1, style(shape), path.len())?;
            write!(text, "#[rustfmt::skip]\npub const {constant}: PackedPath<'static> = checked(&[")?;
            for (i, byte) in path.iter().enumerate() {
                let space = if i % 16 == 0 { "\n    " } else { " " };
                write!(text, "{space}{byte:#04x},")?;
            }
            text.push_str("\n]);\n");
        }
        eprintln!("{name}: {bytes} bytes, {data} as SVG path data");
        (packed, written) = (packed + bytes, written + data);
    }
    text.push_str(
        "\nconst fn checked(bytes: &'static [u8]) -> PackedPath<'static> {\n    match Path::packed(bytes) {\n        Ok(path) => \
         path,\n        Err(_) => panic!(\"no packed path\"),\n    }\n}\n",
    );
    eprintln!("{} files: {packed} bytes, {written} as SVG path data", options.files.len());
    match &options.out {
        Some(out) => fs::write(out, text)?,
        None => print!("{text}"),
    }
    Ok(())
}

/// Shapes that follow each other and are only stroked, in the same way, as one: strokes are unions.
fn joined(shapes: Vec<Shape>) -> Vec<Shape> {
    let key = |outline: &Outline| (outline.stroke, outline.dashes.clone(), outline.phase, outline.color);
    let mut all: Vec<Shape> = vec![];
    for shape in shapes {
        match (all.last_mut(), &shape.outline) {
            (Some(last), Some(outline))
                if last.fill.is_none()
                    && shape.fill.is_none()
                    && last.outline.as_ref().map(key) == Some(key(outline)) =>
            {
                last.path.extend(shape.path);
            }
            _ => all.push(shape),
        }
    }
    all
}

/// The name of a constant, of a file.
fn constant(file: &str) -> String {
    let stem = Path::new(file).file_stem().map(|stem| stem.to_string_lossy()).unwrap_or_default();
    let letters = stem.chars().map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_uppercase() } else { '_' });
    let name: String = letters.collect();
    if name.starts_with(|c: char| c.is_ascii_digit()) || name.is_empty() {
        format!("_{name}")
    } else {
        name
    }
}

/// How it is to be drawn.
fn style(shape: &Shape) -> String {
    let mut parts = vec![];
    if let Some((rule, color)) = shape.fill {
        let rule = if rule == FillRule::EvenOdd { "even-odd" } else { "non-zero" };
        parts.push(format!("filled by the {rule} rule, {color:?}"));
    }
    if let Some(Outline { stroke, dashes, color, .. }) = &shape.outline {
        let cap = match stroke.cap {
            Cap::Butt => "butt",
            Cap::Square => "square",
            Cap::Round => "round",
        };
        let join = match stroke.join {
            Join::Miter => "miter",
            Join::Bevel => "bevel",
            Join::Round => "round",
        };
        let dashed = if dashes.is_empty() { "" } else { ", dashed" };
        parts.push(format!("stroked {} wide, {cap} caps, {join} joins{dashed}, {color:?}", stroke.width));
    }
    if parts.is_empty() {
        "not painted".into()
    } else {
        parts.join(" and ")
    }
}
