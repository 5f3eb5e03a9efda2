//! The pipeline: against homogeneous edge functions at every pixel, and by the laws that closed meshes have.
#![allow(
    clippy::cast_lossless,
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    clippy::float_arithmetic,
    clippy::float_cmp,
    reason = "the twin computes with floating point, with a margin"
)]

mod clip;
mod closed;
mod lines;
mod stages;
