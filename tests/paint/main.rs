//! Paints that change from pixel to pixel, against plain loops over all pixels.
#![allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "random numbers, cut on purpose")]

mod along;
mod argb;
mod cover;
mod depth;
mod diffusion;
mod gamma;
mod gradient;
mod masked;
mod pattern;
mod pictures;
mod shade;
mod small;
mod sums;
mod texture;
