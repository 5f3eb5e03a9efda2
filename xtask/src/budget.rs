//! Budgets: what cycles, instructions, flash and stack may be, in a text file. One that grows by more than 2 % is an error, and so is
//! one that is missing.
//!
//! ```text
//!  cycles;m4;3;clear;rgb565;52371             of one workload of this crate
//!  instructions;m4;3;clear;rgb565;9920.1      likewise
//!  cycles;m4-cpu;3;clear;rgb565;64836         the same, built with `-C target-cpu`
//!  stack;m4;3;map;index4;512                  bytes, of a whole frame
//!  flash;m0;s;line;;600                       bytes of code and constants of a firmware in size/, beyond the empty one
//!  stack;m0;s;line;;120                       and its stack, summed from the frames
//! ```

use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::PathBuf;

use anyhow::{bail, ensure, Context, Result};

use crate::firmware::{self, Build, Opt, Program};
use crate::scene::Frame;
use crate::{run, scene, size, table, Chip};

/// The chips that have budgets, by their names on the command line.
const CHIPS: [(&str, Chip); 2] = [("m0", Chip::M0), ("m4", Chip::M4)];
/// What may be grown by: 1 of so many. Another compiler may bring as much.
const TOLERANCE: f64 = 50.0;

/// Cycles around a loop that is checked.
const LOOP_ENDS: f64 = 10.0;

/// What is measured, as in the file without its last field, to the number.
pub type Budgets = BTreeMap<String, f64>;

/// How much is measured.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Columns {
    /// Speed in the builds that most firmwares are, and flash on the chip that has least of it.
    Usual,
    /// Speed with `-C target-cpu` too, and flash on both.
    All,
}

impl Columns {
    /// Whether a number is one of them.
    fn have(self, name: &str) -> bool {
        self == Self::All || !is_of_processor(name) && !name.contains(";m4;s;")
    }

    /// The chips whose flash is measured.
    fn sized(self) -> &'static [(&'static str, Chip)] {
        if self == Self::All {
            &CHIPS
        } else {
            &CHIPS[..1]
        }
    }
}

/// This crate, as it is named among other engines.
const OWN: &str = "embedded-raster";

/// What stands in a chip's name for a build with `-C target-cpu`.
const CPU: &str = "-cpu";

/// Measures everything that has a budget. Frames must be those of this computer.
pub fn measure(columns: Columns) -> Result<Budgets> {
    let mut all = Budgets::new();
    let chips = CHIPS.map(|(_, chip)| chip);
    let processors: &[bool] = if columns == Columns::All { &[false, true] } else { &[false] };
    for &cpu in processors {
        firmware::build_together("bench", &["cycles", "everyday", "own", "scene"], &chips, Opt::Three, cpu)?;
    }
    let sized = columns.sized();
    firmware::build_with_frames(size::PACKAGE, &sized.iter().map(|&(_, chip)| chip).collect::<Vec<_>>(), Opt::Small)?;
    check_models(&chips)?;
    let host = scene::on_host("host")?;
    // Those of this crate.
    let features: Vec<String> = size::programs()?.into_iter().filter(|name| !name.starts_with("eg_")).collect();
    for (name, chip) in CHIPS {
        let build = Build::new(chip, Opt::Three);
        for &cpu in processors {
            let name = format!("{name}{}", if cpu { CPU } else { "" });
            speed(&mut all, &name, Build { cpu, ..build }, &host)?;
        }
    }
    for &(name, chip) in sized {
        for feature in size::features(&features, chip, Opt::Small)? {
            let name = format!("{name};s;{};", feature.name);
            let number = |bytes: i64| i32::try_from(bytes).map(f64::from);
            all.insert(format!("flash;{name}"), number(feature.text + feature.rodata)?);
            all.insert(format!("stack;{name}"), number(feature.frames)?);
        }
    }
    Ok(all)
}

/// Cycles and instructions of workloads and frames, and the stack of frames.
fn speed(all: &mut Budgets, name: &str, build: Build, host: &[Frame]) -> Result<()> {
    let mut insert = |of: &str, cycles: Option<f64>, instructions: f64| {
        all.extend(cycles.map(|cycles| (format!("cycles;{name};3;{of}"), cycles)));
        all.insert(format!("instructions;{name};3;{of}"), instructions);
    };
    // Not the stack of workloads: in one program with all of them it depends on what is inlined where.
    let rows = |bin| table::parse(&run(&Program { package: "bench", bin }, build)?);
    for row in rows("own")?.into_iter().chain(rows("everyday")?.into_iter().filter(|row| row.engine == OWN)) {
        insert(&format!("{};{}", row.workload, row.format), row.cycles, row.instructions);
    }
    let frames = scene::on_chip(build)?;
    scene::compare(host, build.chip, &frames)?;
    for frame in &frames {
        insert(&format!("{};{}", frame.name, frame.format), frame.cycles, frame.instructions);
    }
    let stack = |frame: &Frame| (format!("stack;{name};3;{};{}", frame.name, frame.format), frame.stack.into());
    all.extend(frames.iter().map(stack));
    Ok(())
}

/// Checks the cycles that are modelled for some chips by those of the manuals.
pub fn check_models(chips: &[Chip]) -> Result<()> {
    for &chip in chips {
        let output = run(&Program { package: "bench", bin: "cycles" }, Build::new(chip, Opt::Three))?;
        check_model(&output).with_context(|| chip.to_string())?;
    }
    Ok(())
}

/// Fails where a loop of the program `cycles` does not take what the manual says: `loop;cycles of the manual;modelled cycles`.
fn check_model(output: &str) -> Result<()> {
    for line in output.lines() {
        let fields: Vec<&str> = line.split(';').collect();
        let &[name, manual, modelled] = &fields[..] else { bail!("{} fields instead of 3 in `{line}`", fields.len()) };
        // Without the plugin there is nothing to check.
        let Some(modelled) = table::parse_cycles(modelled)? else { continue };
        let manual: f64 = manual.parse().with_context(|| format!("in the line `{line}`"))?;
        // The loop is entered, and its last branch is not taken.
        ensure!(
            (modelled - manual).abs() <= LOOP_ENDS,
            "{name}: {modelled} cycles are modelled, the manual gives {manual}"
        );
    }
    Ok(())
}

/// Measures, and compares with the file. Fails with a list of all that grew, that has no budget, or that is gone.
pub fn check(columns: Columns) -> Result<()> {
    let measured = &measure(columns)?;
    let path = path();
    let text = fs::read_to_string(&path).with_context(|| format!("reading {}", path.display()))?;
    let mut budgets = parse(&text)?;
    budgets.retain(|name, _| columns.have(name));
    let wrong = differences(&budgets, measured);
    if !wrong.is_empty() {
        bail!("{} of {} budgets:\n{wrong}write them anew with --bless", wrong.lines().count(), measured.len());
    }
    println!("{} numbers within their budgets", measured.len());
    Ok(())
}

/// Writes the file anew.
pub fn bless(measured: &Budgets) -> Result<()> {
    let mut text =
        String::from("# Written by `cargo xtask budget --bless`: what; chip; opt-level; of what; format; number\n");
    for (name, number) in measured {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{name};{number}");
    }
    fs::write(path(), text).with_context(|| format!("writing {}", path().display()))
}

/// Whether a number is one of a build with `-C target-cpu`.
fn is_of_processor(name: &str) -> bool {
    name.split(';').nth(1).is_some_and(|chip| chip.ends_with(CPU))
}

fn path() -> PathBuf {
    firmware::root().join("budgets.txt")
}

fn parse(text: &str) -> Result<Budgets> {
    let lines = text.lines().filter(|line| !line.starts_with('#') && !line.is_empty());
    lines
        .map(|line| {
            let (name, number) = line.rsplit_once(';').with_context(|| format!("no number in `{line}`"))?;
            Ok((name.to_owned(), number.parse().with_context(|| format!("no number in `{line}`"))?))
        })
        .collect()
}

/// A line for each that is not as it should be.
fn differences(budgets: &Budgets, measured: &Budgets) -> String {
    let mut text = String::new();
    for (name, &now) in measured {
        let _ = match budgets.get(name) {
            None => writeln!(text, "{name}: {now}, has no budget"),
            Some(&budget) if now > budget + budget / TOLERANCE => {
                writeln!(text, "{name}: {now}, the budget is {budget} ({:+.1} %)", (now / budget - 1.0) * 100.0)
            }
            Some(_) => Ok(()),
        };
    }
    for name in budgets.keys().filter(|name| !measured.contains_key(*name)) {
        let _ = writeln!(text, "{name}: has a budget, but is not measured");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_percent_are_free() {
        let budgets = parse("# remark\nflash;m0;s;line;;600\nstack;m4;3;clear;rgb565;0\n").expect("well-formed");
        let with = |line, clear| {
            let all = [("flash;m0;s;line;", line), ("stack;m4;3;clear;rgb565", clear)];
            differences(&budgets, &all.map(|(name, number)| (name.to_owned(), number)).into())
        };
        assert_eq!(with(612.0, 0.0), "", "2 % more");
        assert_eq!(with(100.0, 0.0), "", "less");
        assert_eq!(with(613.0, 0.0), "flash;m0;s;line;: 613, the budget is 600 (+2.2 %)\n");
        assert!(with(600.0, 4.0).contains("clear"), "anything is more than nothing");
    }

    #[test]
    fn columns_are_known_by_the_chip() {
        assert!(is_of_processor("cycles;m4-cpu;3;clear;rgb565"), "with a processor");
        assert!(!is_of_processor("cycles;m4;3;clear;rgb565"), "without");
        let usual = |name| Columns::Usual.have(name);
        assert!(usual("flash;m0;s;line;") && usual("cycles;m4;3;clear;rgb565"), "of the usual builds");
        assert!(!usual("flash;m4;s;line;") && !usual("cycles;m0-cpu;3;clear;rgb565"), "of others");
    }

    #[test]
    fn a_model_is_checked_to_some_cycles() {
        assert!(check_model("a list;12000;12003\na call;9000;-\n").is_ok(), "around the loop, and without the plugin");
        let error = check_model("a list;12000;9003\n").expect_err("no load may overlap").to_string();
        assert!(error.starts_with("a list: 9003 cycles"), "{error}");
        assert!(check_model("a list;12000\n").is_err(), "two fields");
    }

    #[test]
    fn what_is_missing_is_an_error() {
        let one = Budgets::from([("flash;m0;s;line;".to_owned(), 1.0)]);
        assert_eq!(differences(&Budgets::new(), &one).lines().count(), 1, "no budget");
        assert_eq!(differences(&one, &Budgets::new()).lines().count(), 1, "not measured");
        assert!(parse("flash").is_err(), "no number");
    }
}
