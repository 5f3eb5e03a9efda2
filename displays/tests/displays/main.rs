//! What displays are sent: recorded, compared byte by byte with what the crates of drivers send for the same picture, and read as the
//! controllers read it.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "small numbers, and random bits"
)]

mod bands;
mod buses;
mod controllers;
mod hub75;
mod leds;
mod ltdc;
mod memory_lcd;
mod oled;
mod paper;
mod pictures;
mod target;
mod tft;
mod wire;
