//! The plugin of the emulator that models cycles, and how its numbers come into what a program prints.
//!
//! ```text
//!  the plugin prints    cycles 9          the empty section, then
//!                       cycles 1234       the section with the work in it
//!  the program prints   clear;@0;1008.0   the number of that pair
//!  together they are    clear;1225;1008.0
//! ```

use std::env;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use anyhow::{ensure, Context, Result};
use object::{Object, ObjectSymbol};

use crate::firmware::project;
use crate::Chip;

/// The function of the board that begins and ends a section.
const MARK: &str = "board_mark";
/// From this version on QEMU refuses the plugin: its interface has changed.
const TOO_NEW: u32 = 9;
/// What stands for cycles that nobody counted.
pub(crate) const NONE: &str = "-";

/// The argument of the emulator after `-plugin`; `None` when the program has no sections, or the emulator is too new.
pub(crate) fn argument(chip: Chip, elf: &Path) -> Result<Option<OsString>> {
    let Some(mark) = mark(elf)? else { return Ok(None) };
    if major_version(chip)? >= TOO_NEW {
        eprintln!("no modelled cycles: QEMU {TOO_NEW} and later has another interface for plugins");
        return Ok(None);
    }
    let mut argument = build()?.into_os_string();
    argument.push(format!(",core={},mark={mark:#x}", chip.processor().1));
    Ok(Some(argument))
}

/// Where the function is, if the program has it.
fn mark(elf: &Path) -> Result<Option<u64>> {
    let bytes = fs::read(elf).with_context(|| format!("reading {}", elf.display()))?;
    let file = object::File::parse(&*bytes)?;
    let mark = file.symbols().find(|symbol| symbol.name() == Ok(MARK));
    // The lowest bit says that it is Thumb code.
    Ok(mark.map(|symbol| symbol.address() & !1))
}

fn major_version(chip: Chip) -> Result<u32> {
    let (program, package) = chip.emulator();
    let asked = Command::new(program).arg("--version").output();
    let output = asked.with_context(|| format!("starting {program}, of the Debian package {package}"))?;
    parse_version(&String::from_utf8_lossy(&output.stdout)).with_context(|| format!("no version of {program}"))
}

fn parse_version(text: &str) -> Option<u32> {
    text.split_once("version ")?.1.split('.').next()?.parse().ok()
}

/// Builds the plugin, once for all runs of this tool, and returns where it is.
fn build() -> Result<PathBuf> {
    static BUILT: OnceLock<PathBuf> = OnceLock::new();
    if let Some(built) = BUILT.get() {
        return Ok(built.clone());
    }
    let folder = project().join("target/plugin");
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or("cargo".into()));
    cargo.args(["build", "--quiet", "--release", "--package", "cycles", "--target-dir"]).arg(&folder);
    let status = cargo.current_dir(project()).status().with_context(|| format!("starting {cargo:?}"))?;
    ensure!(status.success(), "the plugin does not build: cargo ended with {status}");
    let name = format!("{}cycles{}", env::consts::DLL_PREFIX, env::consts::DLL_SUFFIX);
    Ok(BUILT.get_or_init(|| folder.join("release").join(name)).clone())
}

/// What the program printed, with the cycles that the plugin printed where the program has their places.
pub(crate) fn together(output: &str) -> Result<String> {
    let mut sections = Vec::new();
    let mut text = String::new();
    for line in output.lines() {
        if let Some(cycles) = line.strip_prefix("cycles ") {
            sections.push(cycles.parse::<u64>().with_context(|| format!("in the line `{line}`"))?);
            continue;
        }
        let field = |field: &str| field.strip_prefix('@').map_or(Some(field.to_owned()), |n| work(&sections, n));
        let fields: Option<Vec<String>> = line.split(';').map(field).collect();
        text.push_str(&fields.with_context(|| format!("no such section in the line `{line}`"))?.join(";"));
        text.push('\n');
    }
    Ok(text)
}

/// The cycles of a section with work, without those of the empty one before it.
fn work(sections: &[u64], number: &str) -> Option<String> {
    if sections.is_empty() {
        return Some(NONE.to_owned());
    }
    let number: usize = number.parse().ok()?;
    let cycles = sections.get(2 * number + 1)?.checked_sub(*sections.get(2 * number)?)?;
    Some(cycles.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cycles_come_into_their_places() {
        let output = "# remark\ncycles 9\ncycles 1234\nclear;@0;1008.0\ncycles 9\ncycles 10\nline;@1;2.0\n";
        assert_eq!(together(output).expect("well-formed"), "# remark\nclear;1225;1008.0\nline;1;2.0\n");
    }

    #[test]
    fn without_the_plugin_there_are_none() {
        assert_eq!(together("clear;@0;1008.0\n").expect("well-formed"), "clear;-;1008.0\n");
        assert!(together("cycles 9\ncycles 10\nclear;@1;1.0\n").is_err(), "a section that was not counted");
        assert!(together("cycles x\n").is_err(), "no number");
    }

    #[test]
    fn versions_of_the_emulator() {
        assert_eq!(parse_version("QEMU emulator version 7.2.22 (Debian 1:7.2)\nCopyright"), Some(7));
        assert_eq!(parse_version("QEMU emulator version 10.0.2"), Some(10));
        assert_eq!(parse_version("qemu"), None);
    }
}
