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
pub fn build(program: &Program<'_>, Build { chip, opt, cpu }: Build) -> Result<PathBuf> {
    let mut cargo = Toolchain::find(chip)?.cargo_build(chip);
    cargo.args(["--bin", program.bin]);
    let mut target_dir = root().join("target");
    if cpu {
        // In a folder of its own: another flag builds everything anew. It goes beside the flags of .cargo/config.toml.
        target_dir.push("cpu");
        cargo
            .args(["--config", &format!("target.{}.rustflags=['-Ctarget-cpu={}']", chip.target(), chip.processor().0)]);
    }
    Ok(cargo_build(cargo, program.package, &target_dir, chip, opt)?.join(program.bin))
}

/// Builds all programs of a package, with some of its features, and returns the folder of the ELFs.
pub fn build_all(package: &str, features: &[&str], chip: Chip, opt: Opt) -> Result<PathBuf> {
    let mut cargo = Toolchain::find(chip)?.cargo_build(chip);
    cargo.args(["--bins", "--features", &features.join(",")]);
    cargo_build(cargo, package, &root().join("target"), chip, opt)
}

/// Builds all programs of a package with what [`frames`](crate::frames) reads, in a folder of their own, and returns it.
pub fn build_with_frames(package: &str, chip: Chip, opt: Opt) -> Result<PathBuf> {
    let target_dir = root().join("target/frames");
    let mut cargo = Toolchain::find(chip)?.cargo_build(chip);
    // Beside the flags of .cargo/config.toml. One of them is unstable.
    let flags = format!("target.{}.rustflags=['-Zemit-stack-sizes', '-Clink-arg=--emit-relocs']", chip.target());
    cargo.args(["--bins", "--config", &flags]).env("RUSTC_BOOTSTRAP", "1");
    cargo_build(cargo, package, &target_dir, chip, opt)
}

/// Builds into a folder, and returns that of the ELFs.
fn cargo_build(mut cargo: Command, package: &str, target_dir: &Path, chip: Chip, opt: Opt) -> Result<PathBuf> {
    cargo.args(["--quiet", "--package", package, "--profile", opt.profile()]);
    // Its folder matters: there is the configuration with the linker scripts.
    cargo.arg("--target-dir").arg(target_dir).current_dir(root());
    let status = cargo.status().with_context(|| format!("starting {cargo:?}"))?;
    if !status.success() {
        bail!("{package} does not build for {chip}: cargo ended with {status}");
    }
    Ok(target_dir.join(chip.target()).join(opt.profile()))
}
