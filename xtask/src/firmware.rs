//! Building one program for one chip.

use std::fmt;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::str::FromStr;

use anyhow::{bail, Context, Error, Result};

use crate::toolchain::Toolchain;
use crate::Chip;

/// The optimisation level.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Opt {
    /// `opt-level = 3`.
    Three,
    /// `opt-level = "s"`.
    Small,
}

impl Opt {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Three, Self::Small];

    /// The profile of the firmware's workspace, which is also the folder it builds into.
    fn profile(self) -> &'static str {
        match self {
            Self::Three => "release",
            Self::Small => "small",
        }
    }

    /// As it is written in a manifest.
    pub fn name(self) -> &'static str {
        match self {
            Self::Three => "3",
            Self::Small => "s",
        }
    }
}

impl FromStr for Opt {
    type Err = Error;

    fn from_str(name: &str) -> Result<Self, Error> {
        Ok(match name {
            "3" => Self::Three,
            "s" => Self::Small,
            _ => bail!("no opt level `{name}`: there are 3 and s"),
        })
    }
}

/// What a program is built for.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Build {
    /// The chip.
    pub chip: Chip,
    /// The optimisation level.
    pub opt: Opt,
    /// With `-C target-cpu` of the chip's processor, which schedules instructions and merges stores in another way.
    pub cpu: bool,
}

impl Build {
    /// As most firmwares are built: without a processor.
    pub fn new(chip: Chip, opt: Opt) -> Self {
        Self { chip, opt, cpu: false }
    }
}

impl fmt::Display for Build {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, opt-level {}", self.chip, self.opt.name())?;
        if self.cpu {
            write!(f, ", target-cpu={}", self.chip.processor().0)?;
        }
        Ok(())
    }
}

/// A binary of the firmware's workspace. Its package is part of the name: building the whole
/// workspace at once would give each package the features of all.
#[derive(Copy, Clone, Debug)]
pub struct Program<'a> {
    /// The member that holds it.
    pub package: &'a str,
    /// Its name.
    pub bin: &'a str,
}

/// The folder of the firmware's workspace.
pub fn root() -> PathBuf {
    project().join("firmware")
}

/// The folder of the project.
pub fn project() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap_or(Path::new("."))
}

/// Builds a program and returns where its ELF is.
pub fn build(program: &Program<'_>, build: Build) -> Result<PathBuf> {
    build_one(program, build, &[])
}

/// The same, of a program that prints only with the feature `print`.
pub fn build_printing(program: &Program<'_>, build: Build) -> Result<PathBuf> {
    build_one(program, build, &["--features", "print"])
}

fn build_one(program: &Program<'_>, Build { chip, opt, cpu }: Build, features: &[&str]) -> Result<PathBuf> {
    let mut cargo = Toolchain::find(chip)?.cargo_build(&[chip]);
    cargo.args(["--bin", program.bin]).args(features);
    if cpu {
        cargo.args(flags(&[chip], |chip| format!("'-Ctarget-cpu={}'", chip.processor().0)));
    }
    let target_dir = target_dir(cpu);
    cargo_build(cargo, program.package, &target_dir, &[chip], opt)?;
    Ok(folder(&target_dir, chip, opt).join(program.bin))
}

/// Builds programs of a package for some chips by one call of cargo: what they share is compiled once, and what one core does
/// alone for one chip, such as the core library, is done beside that of another. [`build`] then has nothing left to do.
pub fn build_together(package: &str, bins: &[&str], chips: &[Chip], opt: Opt, cpu: bool) -> Result<()> {
    each_toolchain(chips, |chips, mut cargo| {
        cargo.args(bins.iter().flat_map(|bin| ["--bin", bin]));
        if cpu {
            cargo.args(flags(chips, |chip| format!("'-Ctarget-cpu={}'", chip.processor().0)));
        }
        cargo_build(cargo, package, &target_dir(cpu), chips, opt)
    })
}

/// With a processor in a folder of its own: another flag builds everything anew.
fn target_dir(cpu: bool) -> PathBuf {
    root().join(if cpu { "target/cpu" } else { "target" })
}

/// Builds all programs of a package, with some of its features, and returns the folder of the ELFs.
pub fn build_all(package: &str, features: &[&str], chip: Chip, opt: Opt) -> Result<PathBuf> {
    let mut cargo = Toolchain::find(chip)?.cargo_build(&[chip]);
    cargo.args(["--bins", "--features", &features.join(",")]);
    cargo_build(cargo, package, &target_dir(false), &[chip], opt)?;
    Ok(folder(&target_dir(false), chip, opt))
}

/// Builds all programs of a package with what [`frames`](crate::frames) reads, in a folder of their own, and returns it for each
/// chip.
pub fn build_with_frames(package: &str, chips: &[Chip], opt: Opt) -> Result<Vec<PathBuf>> {
    let target_dir = root().join("target/frames");
    each_toolchain(chips, |chips, mut cargo| {
        // One of them is unstable.
        cargo.args(flags(chips, |_| "'-Zemit-stack-sizes', '-Clink-arg=--emit-relocs'".into()));
        cargo.arg("--bins").env("RUSTC_BOOTSTRAP", "1");
        cargo_build(cargo, package, &target_dir, chips, opt)
    })?;
    Ok(chips.iter().map(|&chip| folder(&target_dir, chip, opt)).collect())
}

/// Calls `work` with a command of cargo for all chips, or with one for each, if they need different toolchains.
fn each_toolchain(chips: &[Chip], work: impl Fn(&[Chip], Command) -> Result<()>) -> Result<()> {
    let toolchains = chips.iter().map(|&chip| Toolchain::find(chip)).collect::<Result<Vec<_>>>()?;
    match &toolchains[..] {
        [first, others @ ..] if others.iter().all(|other| other == first) => work(chips, first.cargo_build(chips)),
        _ => chips.iter().zip(&toolchains).try_for_each(|(&chip, found)| work(&[chip], found.cargo_build(&[chip]))),
    }
}

/// Flags of the compiler for each chip, beside those of `.cargo/config.toml`.
fn flags(chips: &[Chip], flags: impl Fn(Chip) -> String) -> Vec<String> {
    let flags = |&chip: &Chip| ["--config".into(), format!("target.{}.rustflags=[{}]", chip.target(), flags(chip))];
    chips.iter().flat_map(flags).collect()
}

/// Builds into a folder.
fn cargo_build(mut cargo: Command, package: &str, target_dir: &Path, chips: &[Chip], opt: Opt) -> Result<()> {
    cargo.args(["--quiet", "--package", package, "--profile", opt.profile()]);
    // Its folder matters: there is the configuration with the linker scripts.
    cargo.arg("--target-dir").arg(target_dir).current_dir(root());
    let status = cargo.status().with_context(|| format!("starting {cargo:?}"))?;
    if !status.success() {
        let chips: Vec<_> = chips.iter().map(ToString::to_string).collect();
        bail!("{package} does not build for {}: cargo ended with {status}", chips.join(" and "));
    }
    Ok(())
}

/// Where ELFs come to lie.
fn folder(target_dir: &Path, chip: Chip, opt: Opt) -> PathBuf {
    target_dir.join(chip.target()).join(opt.profile())
}
