//! Flash and RAM of the programs in `size`, beyond an empty one.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use object::{Object, ObjectSection};

use crate::firmware::{self, Opt, Program};
use crate::Chip;

/// The program that the others are compared with.
const EMPTY: &str = "empty";

/// Bytes of the sections that matter. The vector table and the places that the linker scripts keep
/// for stack and heap are the same in every program.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Sections {
    /// Code.
    pub text: u64,
    /// Constants.
    pub rodata: u64,
    /// Variables with a value, in flash and in RAM.
    pub data: u64,
    /// Variables without one, in RAM.
    pub bss: u64,
}

impl Sections {
    /// Reads an ELF.
    pub fn of(elf: &Path) -> Result<Self> {
        let bytes = fs::read(elf).with_context(|| format!("reading {}", elf.display()))?;
        let file = object::File::parse(&*bytes)?;
        let mut sum = Self::default();
        for section in file.sections() {
            sum.add(section.name()?, section.size());
        }
        Ok(sum)
    }

    fn add(&mut self, name: &str, size: u64) {
        match name {
            ".text" => self.text += size,
            ".rodata" => self.rodata += size,
            ".data" => self.data += size,
            ".bss" | ".uninit" => self.bss += size,
            _ => {}
        }
    }

    /// What this program has beyond another; an optimiser may also take something away.
    fn beyond(self, other: Self) -> [i64; 4] {
        let fields = |s: Self| [s.text, s.rodata, s.data, s.bss];
        let (mine, theirs) = (fields(self), fields(other));
        std::array::from_fn(|i| mine[i] as i64 - theirs[i] as i64)
    }
}

/// A Markdown table of all programs: the empty one as it is, the others beyond it.
pub fn markdown(chip: Chip, opt: Opt) -> Result<String> {
    let empty = measured(EMPTY, chip, opt)?;
    let mut text = String::from("| program | .text | .rodata | .data | .bss |\n");
    text += "|---|---:|---:|---:|---:|\n";
    text += &line(EMPTY, empty.beyond(Sections::default()));
    for bin in programs()?.iter().filter(|bin| *bin != EMPTY) {
        text += &line(&format!("{bin}, beyond {EMPTY}"), measured(bin, chip, opt)?.beyond(empty));
    }
    Ok(text)
}

fn line(name: &str, [text, rodata, data, bss]: [i64; 4]) -> String {
    format!("| {name} | {text} | {rodata} | {data} | {bss} |\n")
}

fn measured(bin: &str, chip: Chip, opt: Opt) -> Result<Sections> {
    Sections::of(&firmware::build(&Program { package: "size", bin }, chip, opt)?)
}

/// Names of all programs, sorted: each is a file in the package's `bin` folder.
fn programs() -> Result<Vec<String>> {
    let folder = firmware::root().join("size/src/bin");
    let entries = fs::read_dir(&folder).with_context(|| format!("reading {}", folder.display()))?;
    let mut names = Vec::new();
    for entry in entries {
        let path = entry?.path();
        if let Some(name) = path.file_stem().filter(|_| path.extension().is_some_and(|e| e == "rs")) {
            names.push(name.to_string_lossy().into_owned());
        }
    }
    names.sort();
    Ok(names)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_sections_of_a_program_count() {
        let mut sum = Sections::default();
        for (name, size) in [(".text", 10), (".bss", 4), (".uninit", 1), (".stack", 4096)] {
            sum.add(name, size);
        }
        assert_eq!(sum, Sections { text: 10, bss: 5, ..Sections::default() });
        assert_eq!(Sections::default().beyond(sum), [-10, 0, 0, -5]);
    }

    #[test]
    fn the_empty_program_is_there() {
        assert!(programs().expect("the folder").contains(&EMPTY.to_owned()), "{EMPTY}.rs");
    }
}
