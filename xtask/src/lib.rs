//! The commands that people and CI both run. Most of it builds the firmware, runs it on emulated chips and makes tables of
//! what it prints; [`proofs`] are builds that prove something, and [`checks`] runs everything, step by step.
//!
//! ```text
//!  toolchain   one that has the target, or one that can build `core`
//!    |
//!  firmware    cargo build  ---> ELF ---> size: bytes of flash and RAM
//!    |                            |
//!    |                            |      frames: its deepest stack
//!    |                            |      symbols: what must not be linked
//!    |                            |
//!  emulator         QEMU and plugin ---> output ---> table: cycles and instructions per pixel
//!                                                      scene: whole frames, compared with the host's
//!                                                      cube: with little RAM, in bands
//!                                                      moving: frame after frame
//!                                                      bands: RAM against cycles
//!                                                      budget: what has grown
//! ```
//!
//! [`playground`] is the page in the browser; [`server`] and [`browser`] are there to check it.

#![allow(clippy::missing_errors_doc, reason = "a command that fails prints what was wrong")]

pub mod bands;
pub mod browser;
pub mod budget;
pub mod checks;
pub mod chip;
pub mod cube;
pub mod emulator;
pub mod firmware;
pub mod frames;
pub mod moving;
pub mod playground;
pub mod plugin;
pub mod proofs;
pub mod readme;
pub mod rims;
pub mod scene;
pub mod server;
pub mod size;
pub mod steps;
pub mod symbols;
pub mod table;
pub mod toolchain;
pub mod ways;

pub use chip::Chip;
pub use firmware::{Build, Opt, Program};

use anyhow::Result;

/// Builds a program, runs it on the chip and returns what it printed.
pub fn run(program: &Program<'_>, build: Build) -> Result<String> {
    let elf = firmware::build(program, build)?;
    emulator::run(build.chip, &elf)
}

/// Everything that a number depends on.
pub fn heading(build: Build) -> Result<String> {
    let compiler = toolchain::Toolchain::find(build.chip)?.version()?;
    Ok(format!("{build}, {compiler}"))
}
