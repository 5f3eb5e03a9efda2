//! Text: fonts as bytes, and lines of glyphs against their pixels in every layout.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::missing_assert_message,
    reason = "small numbers, and random ones"
)]

mod draw;
mod font;
