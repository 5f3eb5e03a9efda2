//! The scenes of the examples and firmwares, at any depth, with any palette and dither, with one buffer, two or three, or in bands; on a
//! display that is simulated row by row. The page in the browser shows it; `playground/README.md` says how that is built.
//! ```text
//!   choice    what can be chosen, with its names
//!   scenes    what is drawn: the sources that the examples and firmwares have
//!     |
//!   screen    a surface around a frame, which stores colours as the look says
//!     |         and can paint a part of what it is told
//!   look      a colour to bits, by palette and dither, and back
//!     |
//!   player    a program that draws frame after frame, and a display that shows rows
//!   chips     the frames that firmwares draw, for their checksums
//! ```
//! Integers only, no heap and no `std`: the browser runs the code that chips run, and so does this computer, to the same bytes.
#![no_std]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "sizes of a screen of 320 x 240 pixels"
)]

#[cfg(test)]
extern crate std;

pub mod chips;
pub mod choice;
#[path = "../../simulator/src/clock/face.rs"]
pub mod clock;
#[allow(missing_docs, reason = "a table of a firmware")]
#[path = "../../firmware/board/src/crc.rs"]
pub mod crc;
pub mod look;
pub mod player;
pub mod scenes;
mod screen;
#[path = "../../examples/text/scene.rs"]
pub mod text;

pub use choice::Choice;
pub use player::{Memory, Player};
