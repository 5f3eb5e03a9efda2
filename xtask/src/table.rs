//! The lines of the `table` program, and the Markdown tables made of them.

use std::fmt::Write;
use std::str::FromStr;

use anyhow::{bail, Context, Error, Result};

use crate::plugin;

/// One line: what a workload costs in one format and engine.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Name of the workload.
    pub workload: String,
    /// Name of the pixel format.
    pub format: String,
    /// Name of the engine.
    pub engine: String,
    /// Modelled cycles of the whole workload, where they are counted.
    pub cycles: Option<f64>,
    /// Instructions, likewise of all of it.
    pub instructions: f64,
    /// Items drawn.
    pub calls: u32,
    /// Pixels drawn.
    pub pixels: u32,
    /// Bytes of stack.
    pub stack: u32,
    /// Checksum of the frame.
    pub crc32: u32,
}

impl FromStr for Row {
    type Err = Error;

    fn from_str(line: &str) -> Result<Self, Error> {
        let fields: Vec<&str> = line.split(';').collect();
        let &[workload, format, engine, cycles, instructions, calls, pixels, stack, crc32] = &fields[..] else {
            bail!("{} fields instead of 9", fields.len());
        };
        Ok(Self {
            workload: workload.into(),
            format: format.into(),
            engine: engine.into(),
            cycles: parse_cycles(cycles)?,
            instructions: instructions.parse()?,
            calls: calls.parse()?,
            pixels: pixels.parse()?,
            stack: stack.parse()?,
            crc32: u32::from_str_radix(crc32, 16)?,
        })
    }
}

/// A number, or what stands for none.
pub(crate) fn parse_cycles(field: &str) -> Result<Option<f64>> {
    Ok(if field == plugin::NONE { None } else { Some(field.parse()?) })
}

/// All rows of a program's output; lines that start with `#` are remarks.
pub fn parse(output: &str) -> Result<Vec<Row>> {
    let lines = output.lines().filter(|line| !line.starts_with('#') && !line.is_empty());
    lines.map(|line| line.parse().with_context(|| format!("in the line `{line}`"))).collect()
}

/// What the cells of a table say.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Cell {
    /// Cycles and instructions of a pixel.
    PerPixel,
    /// Those of an item.
    PerCall,
    /// Bytes of stack.
    Stack,
}

impl FromStr for Cell {
    type Err = Error;

    fn from_str(name: &str) -> Result<Self, Error> {
        Ok(match name {
            "pixel" => Self::PerPixel,
            "call" => Self::PerCall,
            "stack" => Self::Stack,
            _ => bail!("no column `{name}`: there are pixel, call and stack"),
        })
    }
}

impl Cell {
    /// What a table of these rows says about its cells.
    pub fn title(self, rows: &[Row]) -> String {
        let unit =
            if rows.iter().any(|row| row.cycles.is_some()) { "modelled cycles (instructions)" } else { "instructions" };
        match self {
            Self::PerPixel => format!("{unit} per pixel"),
            Self::PerCall => format!("{unit} per call"),
            Self::Stack => "bytes of stack".into(),
        }
    }

    fn show(self, row: &Row) -> String {
        let items = match self {
            Self::PerPixel => row.pixels,
            Self::PerCall => row.calls,
            Self::Stack => return row.stack.to_string(),
        };
        let [cycles, instructions] =
            [row.cycles, Some(row.instructions)].map(|sum| sum.map(|sum| rounded(sum / f64::from(items))));
        let instructions = instructions.unwrap_or_default();
        cycles.map_or(instructions.clone(), |cycles| format!("{cycles} ({instructions})"))
    }
}

/// Three significant digits below 100, no fraction above.
fn rounded(value: f64) -> String {
    let digits = match value {
        v if v < 1.0 => 3,
        v if v < 10.0 => 2,
        v if v < 100.0 => 1,
        _ => 0,
    };
    format!("{value:.digits$}")
}

/// A table of one format: a row for each workload, a column for each engine, in the order in which
/// they first appear. `–` is what an engine cannot draw.
pub fn markdown(rows: &[Row], format: &str, cell: Cell) -> String {
    let rows: Vec<&Row> = rows.iter().filter(|row| row.format == format).collect();
    let engines = distinct(rows.iter().map(|row| row.engine.as_str()));
    let mut text = format!("| {format} | calls | pixels | {} |\n", engines.join(" | "));
    text.push_str("|---|---:|---:|");
    text.push_str(&"---:|".repeat(engines.len()));
    text.push('\n');
    for workload in order(&rows) {
        let same: Vec<&Row> = rows.iter().copied().filter(|r| r.workload == workload).collect();
        let cost = |engine: &&str| {
            let row = same.iter().find(|row| row.engine == *engine);
            row.map_or("–".into(), |row| cell.show(row))
        };
        let cells: Vec<String> = engines.iter().map(cost).collect();
        let (calls, pixels) = same.first().map_or((0, 0), |row| (row.calls, row.pixels));
        // Writing to a string cannot fail.
        let _ = writeln!(text, "| {workload} | {calls} | {pixels} | {} |", cells.join(" | "));
    }
    text
}

/// The workloads in the order of the program. An engine leaves out what it cannot draw, so one that is new goes after the
/// one that came before it.
fn order<'a>(rows: &[&'a Row]) -> Vec<&'a str> {
    let mut seen: Vec<&str> = Vec::new();
    let mut next = 0;
    for row in rows {
        let place = seen.iter().position(|name| *name == row.workload);
        if place.is_none() {
            seen.insert(next, &row.workload);
        }
        next = place.unwrap_or(next) + 1;
    }
    seen
}

/// Those of some items that are wanted by name, in their own order; all of them when nothing is said. A name that no item has
/// is an error: a row that is gone must not be missed silently.
pub fn select<T>(items: Vec<T>, wanted: Option<&[String]>, name: impl Fn(&T) -> &str) -> Result<Vec<T>> {
    let Some(wanted) = wanted else { return Ok(items) };
    if let Some(unknown) = wanted.iter().find(|wanted| !items.iter().any(|item| name(item) == *wanted)) {
        bail!("no row `{unknown}`");
    }
    Ok(items.into_iter().filter(|item| wanted.iter().any(|wanted| name(item) == wanted)).collect())
}

/// The formats of some rows, in the order in which they first appear.
pub fn formats(rows: &[Row]) -> Vec<&str> {
    distinct(rows.iter().map(|row| row.format.as_str()))
}

fn distinct<'a>(names: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    names.fold(Vec::new(), |mut seen, name| {
        if !seen.contains(&name) {
            seen.push(name);
        }
        seen
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const OUTPUT: &str = "\
# a remark
clear;rgb565;a;2460080;1230040.0;1;76800;40;da5b9130
rects-8x8;rgb565;a;384;256.0;2;128;64;5454667a
clear;gray8;a;-;768000.0;1;76800;40;da5b9130
clear;rgb565;b;-;6052.1;1;76800;52;da5b9130
";

    #[test]
    fn a_line_has_nine_fields() {
        let rows = parse(OUTPUT).expect("well-formed");
        assert_eq!(rows.len(), 4, "without the remark");
        assert_eq!(rows[3].instructions.to_string(), "6052.1", "with its tenths");
        assert_eq!([rows[0].cycles, rows[2].cycles], [Some(2_460_080.0), None]);
        assert_eq!(rows[3].crc32, 0xDA5B_9130, "in hexadecimal");
        assert!(parse("clear;rgb565;a").is_err(), "three fields are no line");
    }

    #[test]
    fn a_table_has_one_format_and_a_column_for_each_engine() {
        let rows = parse(OUTPUT).expect("well-formed");
        assert_eq!(
            markdown(&rows, "rgb565", Cell::PerPixel),
            "| rgb565 | calls | pixels | a | b |\n\
             |---|---:|---:|---:|---:|\n\
             | clear | 1 | 76800 | 32.0 (16.0) | 0.079 |\n\
             | rects-8x8 | 2 | 128 | 3.00 (2.00) | – |\n"
        );
        assert_eq!(formats(&rows), ["rgb565", "gray8"]);
    }

    #[test]
    fn only_the_rows_that_are_wanted() {
        let rows = |wanted: Option<&[&str]>| {
            let wanted = wanted.map(|names| names.iter().map(|&name| name.to_owned()).collect::<Vec<_>>());
            select(parse(OUTPUT).expect("well-formed"), wanted.as_deref(), |row| &row.workload)
        };
        assert_eq!(rows(None).expect("all").len(), 4, "all of them unless told");
        assert_eq!(rows(Some(&["clear"])).expect("it is there").len(), 3, "of every format and engine");
        assert_eq!(rows(Some(&["clear", "circle"])).expect_err("it is not").to_string(), "no row `circle`");
    }

    #[test]
    fn a_workload_of_one_engine_only_keeps_its_place() {
        let rows = [("clear", "a"), ("text", "a"), ("clear", "b"), ("star", "b"), ("text", "b")];
        let rows =
            rows.map(|(name, engine)| parse(&format!("{name};gray8;{engine};-;1.0;1;1;0;0")).expect("well-formed"));
        let rows: Vec<&Row> = rows.iter().flatten().collect();
        assert_eq!(order(&rows), ["clear", "star", "text"]);
    }

    #[test]
    fn cells_divide_by_pixels_or_calls() {
        let rows = parse(OUTPUT).expect("well-formed");
        assert_eq!(Cell::PerCall.show(&rows[1]), "192 (128)");
        assert_eq!(Cell::PerCall.title(&rows), "modelled cycles (instructions) per call");
        assert_eq!(Cell::PerPixel.title(&rows[2..]), "instructions per pixel", "nobody counted cycles");
        assert_eq!(Cell::Stack.show(&rows[1]), "64");
    }
}
