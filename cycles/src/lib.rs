//! Modelled cycles: a plugin of QEMU that adds up what the vendors' tables say of each instruction.
//!
//! ```text
//!  decode     bytes of an instruction ---> its kind, what it writes, where its address comes from
//!    |
//!  model      ... and the one before, and what came of it ---> cycles
//!    |
//!  counter    ... of a section of a program
//!    |
//!  plugin     the emulator's calls: an instruction starts, memory is accessed
//! ```

pub mod counter;
pub mod decode;
pub mod model;
// A test has no emulator to be linked with.
#[cfg(not(test))]
mod plugin;
