//! Integers that stand for real numbers.
//!
//! | format | type | unit | used for |
//! |---|---|---|---|
//! | pixel | `i32` | 1 | [`Point`](embedded_graphics_core::geometry::Point), spans, windows |
//! | 24.8 | `i32` in [`I24F8`](fixed::types::I24F8) | 1/256 pixel | [`PointFx`](crate::geom::PointFx) |
//!
//! No operation here overflows: each states the range of its arguments, and its callers keep to it. So a call does the
//! same in debug and in release builds, with numbers at the ends of their type, too.

pub(crate) mod cast;
#[cfg(any(feature = "defmt", test))]
pub(crate) mod decimal;
pub(crate) mod divisor;
pub(crate) mod mixed;
pub(crate) mod recip;
pub(crate) mod root;
pub(crate) mod round;
pub(crate) mod stepper;
#[cfg(test)]
pub(crate) mod tally;
pub(crate) mod trig;
pub(crate) mod wide;
