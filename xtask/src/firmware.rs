//! Building one program for one chip.

use std::path::{Path, PathBuf};
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
pub fn build(program: &Program<'_>, chip: Chip, opt: Opt) -> Result<PathBuf> {
    Ok(cargo_build(program.package, &["--bin", program.bin], chip, opt)?.join(program.bin))
}

/// Builds all programs of a package, with some of its features, and returns the folder of the ELFs.
pub fn build_all(package: &str, features: &[&str], chip: Chip, opt: Opt) -> Result<PathBuf> {
    cargo_build(package, &["--bins", "--features", &features.join(",")], chip, opt)
}

fn cargo_build(package: &str, what: &[&str], chip: Chip, opt: Opt) -> Result<PathBuf> {
    let target_dir = root().join("target");
    let mut cargo = Toolchain::find(chip)?.cargo_build(chip);
    cargo.args(["--quiet", "--package", package, "--profile", opt.profile()]).args(what);
    // Its folder matters: there is the configuration with the linker scripts.
    cargo.arg("--target-dir").arg(&target_dir).current_dir(root());
    let status = cargo.status().with_context(|| format!("starting {cargo:?}"))?;
    if !status.success() {
        bail!("{package} does not build for {chip}: cargo ended with {status}");
    }
    Ok(target_dir.join(chip.target()).join(opt.profile()))
}
