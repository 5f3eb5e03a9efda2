//! Ways to shade a triangle, on chips: the lines of the program `ways`.

use std::fmt::Write;
use std::str::FromStr;

use anyhow::{bail, Error, Result};

use crate::{run, table, Build, Program};

/// One line: what a way takes for a workload of a family.
#[derive(Clone, Debug, PartialEq)]
pub struct Way {
    /// What changes over the triangles: colours, depths, places in a texture.
    pub family: String,
    /// Name of the workload.
    pub workload: String,
    /// Name of the way.
    pub name: String,
    /// Modelled cycles of a pixel, where they are counted.
    pub cycles: Option<f64>,
    /// Instructions of a pixel.
    pub instructions: f64,
}

impl FromStr for Way {
    type Err = Error;

    fn from_str(line: &str) -> Result<Self, Error> {
        let fields: Vec<&str> = line.split(';').collect();
        let &[family, workload, name, cycles, instructions, pixels] = &fields[..] else {
            bail!("{} fields instead of 6 in the line `{line}`", fields.len());
        };
        let pixels: f64 = pixels.parse()?;
        Ok(Self {
            family: family.into(),
            workload: workload.into(),
            name: name.into(),
            cycles: table::parse_cycles(cycles)?.map(|cycles| cycles / pixels),
            instructions: instructions.parse::<f64>()? / pixels,
        })
    }
}

/// Reads the lines of the program.
fn parse(output: &str) -> Result<Vec<Way>> {
    output.lines().filter(|line| !line.starts_with('#') && !line.is_empty()).map(str::parse).collect()
}

/// Runs the program on a chip.
pub fn measure(build: Build) -> Result<Vec<Way>> {
    parse(&run(&Program { package: "bench", bin: "ways" }, build)?)
}

/// A Markdown table: cycles and instructions of a pixel.
pub fn markdown(ways: &[Way]) -> String {
    let mut text =
        String::from("| family | workload | way | cycles a pixel | instructions |\n|---|---|---|---:|---:|\n");
    for Way { family, workload, name, cycles, instructions } in ways {
        let cycles = cycles.map_or("–".into(), |cycles| format!("{cycles:.1}"));
        // Writing to a string cannot fail.
        let _ = writeln!(text, "| {family} | {workload} | {name} | {cycles} | {instructions:.1} |");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_divided_by_their_pixels() {
        let ways = parse("# a remark\ngouraud;100 px;exact;300;200.0;10\ndepth;x;y;-;5.0;10\n").expect("well-formed");
        assert_eq!((ways[0].cycles, ways[0].instructions), (Some(30.0), 20.0));
        assert_eq!(ways[1].cycles, None, "nobody counted them");
        assert!(parse("gouraud;100 px").is_err(), "two fields are no line");
        assert!(markdown(&ways).contains("| gouraud | 100 px | exact | 30.0 | 20.0 |"), "{}", markdown(&ways));
    }
}
