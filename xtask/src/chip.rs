//! The emulated chips.

use std::fmt;
use std::str::FromStr;

use anyhow::{bail, Error};

/// A chip that QEMU emulates and that the board crate knows.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Chip {
    /// Cortex-M0+, on the mps2-an385 (its Cortex-M3 runs the same Armv6-M code).
    M0,
    /// Cortex-M4 with floating point, on the mps2-an386.
    M4,
    /// RV32IMC, on the RISC-V virt machine; cycles are those of Hazard3, the core of RP2350.
    Riscv,
}

impl Chip {
    /// All of them, in the order of the tables.
    pub const ALL: [Self; 3] = [Self::M0, Self::M4, Self::Riscv];

    /// What the compiler calls it.
    pub fn target(self) -> &'static str {
        match self {
            Self::M0 => "thumbv6m-none-eabi",
            Self::M4 => "thumbv7em-none-eabihf",
            Self::Riscv => "riscv32imc-unknown-none-elf",
        }
    }

    /// The emulator's program, and the Debian package that brings it.
    pub(crate) fn emulator(self) -> (&'static str, &'static str) {
        match self {
            Self::M0 | Self::M4 => ("qemu-system-arm", "qemu-system-arm"),
            Self::Riscv => ("qemu-system-riscv32", "qemu-system-misc"),
        }
    }

    /// What the compiler calls the processor, and whose table the plugin of the emulator adds up.
    pub(crate) fn processor(self) -> (&'static str, &'static str) {
        match self {
            Self::M0 => ("cortex-m0plus", "m0"),
            Self::M4 => ("cortex-m4", "m4"),
            Self::Riscv => ("generic-rv32", "hazard3"),
        }
    }

    /// The machine, as arguments of the emulator.
    pub(crate) fn machine(self) -> &'static [&'static str] {
        match self {
            Self::M0 => &["-M", "mps2-an385"],
            Self::M4 => &["-M", "mps2-an386"],
            Self::Riscv => &["-M", "virt", "-cpu", "rv32", "-bios", "none"],
        }
    }
}

impl fmt::Display for Chip {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::M0 => "Cortex-M0+",
            Self::M4 => "Cortex-M4",
            Self::Riscv => "RV32IMC",
        })
    }
}

impl FromStr for Chip {
    type Err = Error;

    fn from_str(name: &str) -> Result<Self, Error> {
        Ok(match name {
            "m0" => Self::M0,
            "m4" => Self::M4,
            "riscv" => Self::Riscv,
            _ => bail!("no chip `{name}`: there are m0, m4 and riscv"),
        })
    }
}
