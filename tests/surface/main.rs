//! Surfaces around memory and around other surfaces.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::missing_assert_message,
    reason = "small numbers, and random ones"
)]

mod owned;
mod turned;
