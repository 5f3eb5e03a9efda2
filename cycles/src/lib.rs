//! Modelled cycles: a plugin of QEMU that adds up what the vendors' tables say of each instruction.
//!
//! ```text
//!  thumb, riscv     bytes of an instruction ---> its kind, what it writes, what it needs early
//!    |
//!  model, hazard3   ... and the one before, and what came of it ---> cycles
//!    |
//!  counter          ... of a section of a program
//!    |
//!  plugin           the emulator's calls: an instruction starts, memory is accessed
//! ```

pub mod counter;
pub mod hazard3;
pub mod instruction;
pub mod model;
pub mod riscv;
pub mod thumb;
// A test has no emulator to be linked with.
#[cfg(not(test))]
mod plugin;
