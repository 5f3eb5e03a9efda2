//! What soft rims cost on chips: the lines of the program `rims`.

use std::fmt::Write;
use std::str::FromStr;

use anyhow::{bail, Context, Error, Result};

use crate::{run, table, Build, Program};

/// One line: a shape, drawn in one way.
struct Line {
    shape: String,
    way: String,
    cycles: Option<f64>,
    instructions: f64,
    pixels: f64,
    rims: f64,
}

impl FromStr for Line {
    type Err = Error;

    fn from_str(line: &str) -> Result<Self, Error> {
        let fields: Vec<&str> = line.split(';').collect();
        let &[shape, way, cycles, instructions, pixels, rims] = &fields[..] else {
            bail!("{} fields instead of 6 in the line `{line}`", fields.len());
        };
        Ok(Self {
            shape: shape.into(),
            way: way.into(),
            cycles: table::parse_cycles(cycles)?,
            instructions: instructions.parse()?,
            pixels: pixels.parse()?,
            rims: rims.parse()?,
        })
    }
}

/// A shape, drawn with soft rims and without.
#[derive(Clone, Debug, PartialEq)]
pub struct Rims {
    /// Its name.
    pub shape: String,
    /// Modelled cycles of the plain fill, or instructions where nobody counts cycles.
    pub flat: f64,
    /// Those of the shape with soft rims.
    pub soft: f64,
    /// Pixels that are touched.
    pub pixels: f64,
    /// Those that are covered in part.
    pub rims: f64,
}

impl Rims {
    /// How many times the plain fill it takes.
    pub fn times(&self) -> f64 {
        self.soft / self.flat
    }

    /// What a pixel of the rim takes beyond the plain fill.
    pub fn each(&self) -> f64 {
        (self.soft - self.flat) / self.rims
    }
}

/// Reads the lines of the program: of each shape the plain one first.
fn parse(output: &str) -> Result<Vec<Rims>> {
    let lines = output.lines().filter(|line| !line.starts_with('#') && !line.is_empty());
    let lines = lines.map(str::parse).collect::<Result<Vec<Line>>>()?;
    lines
        .chunks(2)
        .map(|two| {
            let [flat, soft] = two else { bail!("a shape without its second line") };
            let ways = (flat.way.as_str(), soft.way.as_str());
            (ways == ("flat", "soft") && flat.shape == soft.shape).then_some(()).context("lines in no order")?;
            let cost = |line: &Line| line.cycles.unwrap_or(line.instructions);
            Ok(Rims {
                shape: flat.shape.clone(),
                flat: cost(flat),
                soft: cost(soft),
                pixels: soft.pixels,
                rims: soft.rims,
            })
        })
        .collect()
}

/// Runs the program on a chip.
pub fn measure(build: Build) -> Result<Vec<Rims>> {
    parse(&run(&Program { package: "bench", bin: "rims" }, build)?)
}

/// A Markdown table: cycles of the shape without soft rims and with them, and of a pixel of the rim.
pub fn markdown(shapes: &[Rims]) -> String {
    let mut text = String::from(
        "| shape | pixels | in part | plain | soft | times | more a pixel in part |\n|---|---:|---:|---:|---:|---:|---:|\n",
    );
    for shape in shapes {
        let Rims { shape: name, flat, soft, pixels, rims } = shape;
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "| {name} | {pixels} | {rims} | {flat:.0} | {soft:.0} | {:.2} | {:.1} |",
            shape.times(),
            shape.each()
        );
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_lines_are_a_shape() {
        let text = "# a remark\nx;flat;100;80.0;50;10\nx;soft;400;300.0;50;10\n";
        let shapes = parse(text).expect("well-formed");
        assert_eq!((shapes[0].times(), shapes[0].each()), (4.0, 30.0));
        assert!(markdown(&shapes).contains("| x | 50 | 10 | 100 | 400 | 4.00 | 30.0 |"), "{}", markdown(&shapes));
        assert!(parse("x;flat;100;80.0;50;10\n").is_err(), "half a shape");
    }
}
