//! Which compiler builds for a chip: one that has the target installed, or one that has the source
//! of `core` and builds it along.

use std::env;
use std::ffi::OsString;
use std::path::Path;
use std::process::Command;

use anyhow::{bail, Context, Result};

use crate::Chip;

/// A compiler with its cargo.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Toolchain {
    rustc: OsString,
    cargo: OsString,
    /// The target's library is not installed, its source is.
    builds_core: bool,
}

impl Toolchain {
    /// The one that builds for a chip.
    pub fn find(chip: Chip) -> Result<Self> {
        Self::find_for(chip.target())
    }

    /// The first toolchain that has the target installed, or else the first with library source.
    pub fn find_for(target: &str) -> Result<Self> {
        let installed = candidates();
        let usable = |builds_core| installed.iter().find(|c| c.can_build(target, builds_core));
        let (found, builds_core) = match (usable(false), usable(true)) {
            (Some(found), _) => (found, false),
            (None, Some(found)) => (found, true),
            (None, None) => bail!(missing(target)),
        };
        Ok(Self { builds_core, ..found.clone() })
    }

    /// The compiler's name and version.
    pub fn version(&self) -> Result<String> {
        self.ask(&["--version"])
    }

    /// `cargo build` for some chips, in the environment that this toolchain needs.
    pub(crate) fn cargo_build(&self, chips: &[Chip]) -> Command {
        self.cargo_build_for(chips.iter().map(|chip| chip.target()))
    }

    /// The same for any targets.
    pub(crate) fn cargo_build_for<'a>(&self, targets: impl IntoIterator<Item = &'a str>) -> Command {
        self.cargo("build", targets)
    }

    /// `cargo check` for a chip: all but the machine code.
    pub(crate) fn cargo_check(&self, chip: Chip) -> Command {
        self.cargo("check", [chip.target()])
    }

    fn cargo<'a>(&self, command: &str, targets: impl IntoIterator<Item = &'a str>) -> Command {
        let mut cargo = Command::new(&self.cargo);
        cargo.arg(command).env("RUSTC", &self.rustc);
        cargo.args(targets.into_iter().flat_map(|target| ["--target", target]));
        if self.builds_core {
            // What this needs is unstable, and stays the same from one release to the next.
            cargo.arg("-Zbuild-std=core").env("RUSTC_BOOTSTRAP", "1");
        }
        // Flags for the host would replace the linker scripts of .cargo/config.toml, and the library
        // path of the cargo that started this tool may belong to another compiler. What is measured
        // is what the opt-level chooses.
        for variable in
            ["RUSTFLAGS", "CARGO_ENCODED_RUSTFLAGS", "LD_LIBRARY_PATH", "EMBEDDED_RASTER_TUNE", "EMBEDDED_RASTER_CORE"]
        {
            cargo.env_remove(variable);
        }
        cargo
    }

    fn can_build(&self, target: &str, builds_core: bool) -> bool {
        if builds_core {
            let source = "lib/rustlib/src/rust/library/core/Cargo.toml";
            return self.ask(&["--print", "sysroot"]).is_ok_and(|p| Path::new(&p).join(source).exists());
        }
        let asked = self.ask(&["--print", "target-libdir", "--target", target]);
        asked.is_ok_and(|libraries| holds_core(Path::new(&libraries)))
    }

    fn ask(&self, args: &[&str]) -> Result<String> {
        let asked = Command::new(&self.rustc).args(args).output();
        let output = asked.with_context(|| format!("starting {}", self.rustc.display()))?;
        if !output.status.success() {
            bail!("{} {args:?}: {}", self.rustc.display(), output.status);
        }
        Ok(String::from_utf8(output.stdout)?.trim().to_owned())
    }
}

/// The toolchain in use, then the system's own, which rustup's may hide.
fn candidates() -> [Toolchain; 2] {
    let named = |variable, default: &str| env::var_os(variable).unwrap_or_else(|| default.into());
    [(named("RUSTC", "rustc"), named("CARGO", "cargo")), ("/usr/bin/rustc".into(), "/usr/bin/cargo".into())]
        .map(|(rustc, cargo)| Toolchain { rustc, cargo, builds_core: false })
}

fn holds_core(libraries: &Path) -> bool {
    let Ok(entries) = libraries.read_dir() else { return false };
    entries.flatten().any(|entry| entry.file_name().to_string_lossy().starts_with("libcore-"))
}

fn missing(target: &str) -> String {
    format!(
        "no Rust toolchain can build for {target}. Install the target:\n    \
         rustup target add {target}\n\
         or Debian's compiler with the source of its library:\n    \
         apt-get install --no-install-recommends rustc-web cargo-web rust-web-src rust-web-llvm lld-22"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_toolchain_says_what_to_install() {
        let text = missing(Chip::M0.target());
        assert!(text.contains("rustup target add thumbv6m-none-eabi"), "{text}");
    }

    #[test]
    fn a_folder_without_core_is_no_target() {
        assert!(!holds_core(Path::new(env!("CARGO_MANIFEST_DIR"))), "no libcore in here");
        assert!(!holds_core(Path::new("does/not/exist")), "nor in a missing folder");
    }
}
