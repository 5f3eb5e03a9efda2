//! Flash, RAM and stack of the programs in `size`, beyond an empty one.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use object::{Object, ObjectSection, ObjectSymbol};

use crate::firmware::{self, Opt};
use crate::{emulator, frames, Chip};

/// The package of the programs.
pub(crate) const PACKAGE: &str = "size";
/// The program that the others are compared with.
const EMPTY: &str = "empty";
/// How the names of the static framebuffers end: what a scene needs anyway.
const FRAMEBUFFER: &str = "FRAMEBUFFER";

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
    /// Those of them that are the framebuffer.
    pub framebuffer: u64,
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
        for symbol in file.symbols().filter(|symbol| symbol.name().is_ok_and(|name| name.ends_with(FRAMEBUFFER))) {
            sum.framebuffer += symbol.size();
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

    /// Static RAM, the framebuffer included.
    pub fn ram(self) -> u64 {
        self.data + self.bss
    }

    /// Code, constants and static RAM that this program has beyond another; an optimiser may also take something away.
    fn beyond(self, other: Self) -> [i64; 3] {
        let fields = |s: Self| [s.text, s.rodata, s.ram() - s.framebuffer];
        let (mine, theirs) = (fields(self), fields(other));
        std::array::from_fn(|i| beyond(mine[i], theirs[i]))
    }
}

fn beyond(mine: u64, theirs: u64) -> i64 {
    mine.wrapping_sub(theirs).cast_signed()
}

/// What one feature costs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Feature {
    /// The program that uses it, and nothing else.
    pub name: String,
    /// Bytes of code beyond the empty program; of that one itself, all of it.
    pub text: i64,
    /// Bytes of constants, likewise.
    pub rodata: i64,
    /// Bytes of static RAM beside the framebuffer, likewise.
    pub ram: i64,
    /// Bytes of stack beyond the empty program, summed from the sizes of the frames.
    pub frames: i64,
}

/// Measures some programs, without their painted stack: that takes another build.
pub fn features(programs: &[String], chip: Chip, opt: Opt) -> Result<Vec<Feature>> {
    let folders = firmware::build_with_frames(PACKAGE, &[chip], opt)?;
    let folder = folders.first().context("the folder of a chip")?;
    let empty = Sections::of(&folder.join(EMPTY))?;
    let empty_frames = frames::deepest(&folder.join(EMPTY))?;
    let measure = |name: &String| {
        let elf = folder.join(name);
        let is_empty = name == EMPTY;
        let (others, others_frames) = if is_empty { (Sections::default(), 0) } else { (empty, empty_frames) };
        let [text, rodata, ram] = Sections::of(&elf)?.beyond(others);
        let frames = beyond(frames::deepest(&elf)?, others_frames);
        Ok(Feature { name: name.clone(), text, rodata, ram, frames })
    };
    programs.iter().map(measure).collect()
}

/// Bytes of stack of some programs, painted.
pub fn painted(programs: &[String], chip: Chip, opt: Opt) -> Result<Vec<u32>> {
    let folder = firmware::build_all(PACKAGE, &["stack"], chip, opt)?;
    programs.iter().map(|name| stack(chip, &folder.join(name))).collect()
}

/// What the program prints when it is built to print its stack; the empty one prints nothing.
fn stack(chip: Chip, elf: &Path) -> Result<u32> {
    let output = emulator::run(chip, elf)?;
    output.lines().next().map_or(Ok(0), |line| line.parse().with_context(|| format!("{}: {line}", elf.display())))
}

/// A Markdown table of programs: the empty one as it is, the others beyond it.
pub fn markdown(features: &[Feature], painted: &[u32]) -> String {
    let mut text = String::from(
        "| program | .text | .rodata | static RAM | stack, painted | stack, summed |\n|---|---:|---:|---:|---:|---:|\n",
    );
    for (Feature { name, text: code, rodata, ram, frames }, stack) in features.iter().zip(painted) {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "| {name} | {code} | {rodata} | {ram} | {stack} | {frames} |");
    }
    text
}

/// Names of all programs, the empty one first: each is a file in the package's `bin` folder.
pub fn programs() -> Result<Vec<String>> {
    let folder = firmware::root().join(PACKAGE).join("src/bin");
    let entries = fs::read_dir(&folder).with_context(|| format!("reading {}", folder.display()))?;
    let mut names = Vec::new();
    for entry in entries {
        let path = entry?.path();
        if let Some(name) = path.file_stem().filter(|_| path.extension().is_some_and(|e| e == "rs")) {
            names.push(name.to_string_lossy().into_owned());
        }
    }
    names.sort_by_key(|name| (name != EMPTY, name.clone()));
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
        assert_eq!(Sections::default().beyond(sum), [-10, 0, -5]);
        sum.framebuffer = 3;
        assert_eq!(sum.beyond(Sections::default()), [10, 0, 2], "the framebuffer is not the feature's");
    }

    #[test]
    fn the_empty_program_is_the_first() {
        assert_eq!(programs().expect("the folder")[0], EMPTY);
    }
}
