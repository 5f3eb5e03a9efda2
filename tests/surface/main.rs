//! Surfaces around memory and around other surfaces.

mod owned;
mod turned;
