//! A paint program: what it holds, what can be done to it, scripts, and what its window shows.
//! ```text
//!   script ---parse---.                        .--> undo, redo
//!                      >--> Command --> Paint <---> PNG, with its palette
//!   keys, mouse -> Desk                        `--> the window
//! ```
//! * [`Command`]: one thing to do. Scripts and the window know no other way to change a picture.
//! * [`Sheet`]: a picture of 1, 2, 4 or 8 bits and its palette. All pixels of it are drawn by this library.
//! * [`Paint`]: a sheet, the settings of the tools, and the sheets of before. A command that fails changes nothing.
//! * [`Desk`]: tool bar, palette and status around the sheet; events to commands.

mod command;
mod desk;
mod model;
mod sheet;

pub use command::{parse, Command, ScriptError, FORMS};
pub use desk::Desk;
pub use model::{replay, Done, Failure, Paint, Summary};
pub use sheet::{Scratch, Sheet};
