//! Frames that every chip and this computer must draw alike.

use std::fmt::Write;
use std::process::Command;
use std::str::FromStr;

use anyhow::{bail, ensure, Context, Error, Result};

use crate::firmware::{self, Build, Program};
use crate::size::Sections;
use crate::{emulator, heading, run, table, Chip};

/// The programs that print frames: all of them, and the map with its memory static.
const SCENE: Program<'_> = Program { package: "bench", bin: "scene" };
const MAP: Program<'_> = Program { package: "bench", bin: "map" };

/// One line of such a program.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// What it shows.
    pub name: String,
    /// Name of the pixel format.
    pub format: String,
    /// Modelled cycles, where they are counted.
    pub cycles: Option<f64>,
    /// Instructions; 0 where they are not counted.
    pub instructions: f64,
    /// Bytes of stack, likewise.
    pub stack: u32,
    /// Checksum of its bytes.
    pub crc32: u32,
}

impl FromStr for Frame {
    type Err = Error;

    fn from_str(line: &str) -> Result<Self, Error> {
        let fields: Vec<&str> = line.split(';').collect();
        let &[name, format, cycles, instructions, stack, crc32] = &fields[..] else {
            bail!("{} fields instead of 6 in the line `{line}`", fields.len());
        };
        Ok(Self {
            name: name.into(),
            format: format.into(),
            cycles: table::parse_cycles(cycles)?,
            instructions: instructions.parse()?,
            stack: stack.parse()?,
            crc32: u32::from_str_radix(crc32, 16)?,
        })
    }
}

/// Reads the lines of such a program.
pub(crate) fn parse(output: &str) -> Result<Vec<Frame>> {
    output.lines().filter(|line| !line.starts_with('#')).map(str::parse).collect()
}

/// Draws all frames in some builds for chips and prints what they take. Fails where one is not that of this computer.
pub fn check_all(builds: &[Build]) -> Result<()> {
    let host = on_host("host")?;
    for build in builds {
        let (build, chip) = (*build, build.chip);
        let frames = on_chip(build)?;
        println!("{}\n\n{}", heading(build)?, markdown(&frames));
        compare(&host, chip, &frames)?;
        let ram = map(build)?;
        println!("The map alone: {} bytes of static RAM, {} of stack.\n", ram.statics, ram.stack);
    }
    println!("All frames are those of this computer.");
    Ok(())
}

/// Draws frames on this computer: those of an example of the package `scene`.
pub fn on_host(example: &str) -> Result<Vec<Frame>> {
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or("cargo".into()));
    cargo.args(["run", "--quiet", "--release", "--package", "scene", "--example", example]);
    cargo.arg("--target-dir").arg(firmware::root().join("target")).current_dir(firmware::root());
    let output = cargo.output().with_context(|| format!("starting {cargo:?}"))?;
    ensure!(output.status.success(), "drawing on the host: {}", String::from_utf8_lossy(&output.stderr));
    parse(&String::from_utf8(output.stdout)?)
}

/// Draws all frames on a chip.
pub fn on_chip(build: Build) -> Result<Vec<Frame>> {
    parse(&run(&SCENE, build)?)
}

/// Fails where a frame of a chip is not that of this computer.
pub fn compare(host: &[Frame], chip: Chip, frames: &[Frame]) -> Result<()> {
    ensure!(host.len() == frames.len(), "{chip} draws {} frames, the host {}", frames.len(), host.len());
    for (expected, frame) in host.iter().zip(frames) {
        let Frame { name, format, crc32, .. } = frame;
        ensure!((&expected.name, &expected.format) == (name, format), "{chip} draws the frames in another order");
        ensure!(
            expected.crc32 == *crc32,
            "{name} in {format} on {chip} has the checksum {crc32:08x}, on the host {:08x}",
            expected.crc32
        );
    }
    Ok(())
}

/// What the map takes when its memory is static.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
struct Ram {
    /// Bytes of static RAM: framebuffer, edge table, and what the board needs.
    statics: u64,
    /// Bytes of stack.
    stack: u32,
}

/// Builds and runs the map alone.
fn map(build: Build) -> Result<Ram> {
    let elf = firmware::build(&MAP, build)?;
    let frames = parse(&emulator::run(build.chip, &elf)?)?;
    let stack = frames.first().context("the map prints nothing")?.stack;
    Ok(Ram { statics: Sections::of(&elf)?.ram(), stack })
}

/// A Markdown table of the frames of a chip.
fn markdown(frames: &[Frame]) -> String {
    let mut text = String::from(
        "| frame | format | modelled cycles | instructions | stack | CRC-32 |\n|---|---|---:|---:|---:|---|\n",
    );
    for Frame { name, format, cycles, instructions, stack, crc32 } in frames {
        let cycles = cycles.map_or("–".into(), |cycles| format!("{cycles:.0}"));
        // Writing to a string cannot fail.
        let _ = writeln!(text, "| {name} | {format} | {cycles} | {instructions:.0} | {stack} | {crc32:08x} |");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    const OUTPUT: &str = "# a remark\nmap;index4;234;123.4;56;4d0f4b9a\nshapes;rgb565;-;9.0;8;00000001\n";

    #[test]
    fn another_checksum_is_an_error() {
        let host = parse(OUTPUT).expect("well-formed");
        assert_eq!((host[0].cycles, host[0].instructions, host[0].crc32), (Some(234.0), 123.4, 0x4D0F_4B9A), "fields");
        assert_eq!(host[1].cycles, None, "nobody counted them");
        assert!(compare(&host, Chip::M0, &host).is_ok(), "the same");
        let mut other = host.clone();
        other[1].crc32 = 2;
        let error = compare(&host, Chip::M0, &other).expect_err("not the same").to_string();
        assert!(error.contains("shapes in rgb565"), "{error}");
        assert!(compare(&host, Chip::M0, &host[..1]).is_err(), "one is missing");
    }
}
