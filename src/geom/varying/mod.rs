//! [`Varying`]: what changes over a triangle from corner to corner, and [`Plane`]: its value at every pixel.
//!
//! **Exact.** A value at a pixel is the nearest one to the exact mean of the corners at the centre of the pixel, halves upwards:
//! `floor(N / D + 1/2)`, where D is twice the area of the triangle. That is a rule for one pixel; no other pixel, no window and no
//! band takes part in it. It has consequences. What is equal at all corners is constant. Nothing leaves the range of the corners.
//! Two parts of a triangle that are cut at places where the values are whole show what the whole shows.
//!
//! It is found by additions. The value is the whole part of T = (N + floor(D / 2)) / D, a multiple of 1 / D. A number S is kept that
//! is at least T, and above it by less than 1 / D: both have the same whole part. S comes from the first pixel of the box by x
//! steps to the right and y steps down, and each of them adds some excess. The largest triangles that are allowed have D below
//! 2^41.2, and x + y below 12,288 = 2^13.6.
//! - Numbers of up to 32 bits are kept with 64 bits of fraction. A step adds at most 6 units of 2^-64: 2^(2.6 + 13.6 + 41.2) is
//!   below 2^64.
//! - Along a row, numbers of 16 bits have 48 bits of fraction, which is enough for 100 pixels in the largest triangles; then they
//!   are computed anew: see [`reach`](Varying::reach). In triangles of 63 pixels, width and height together, D is below 2^27, and
//!   48 bits are enough for rows too.
//! - Bytes are kept with 56 bits of fraction, and 8 before it. A step adds less than 1 + 2 n / D units of 2^-56, with n below
//!   2^30.6 for a step, and below 2^52 for the start: 2^(13.6 + 41.2) + 2^(1 + 13.6 + 30.6) + 2^53 is below 2^56.
//! - Over triangles of 63 pixels there is a form with nothing to choose from row to row: see [`small`](super::small).
//! - Three levels of a colour of 16 bits share 128 bits, 37 for each fraction: see `paint/colors.rs`. Along a row of a large
//!   triangle, they are computed anew every few pixels, too.
//!
//! **Fast.** [`Fast`] starts each row from the same plane, and goes on in 32 bits: 16 for the fraction. A step is cut towards zero,
//! so a value that is found n pixels from the start of a row is off by at most `n 2^-16` and the half that rounding takes. It
//! does not leave the range of the corners either. Three levels of a colour of 16 bits share 64 bits then. Of two `I16F16`, a place
//! in a texture, whole bits are added: both are off by at most n and a half of them, which is `n 2^-16` too.
//!
//! Sources: J. Foley, A. van Dam, S. Feiner, J. Hughes, "Computer Graphics: Principles and Practice", 2nd edition, 1990, 16.2
//! (H. Gouraud's shading, 1971, row by row).

mod bytes;
mod fast;
mod numbers;
mod plane;
mod several;
mod traits;
mod words;

pub(crate) use self::plane::Rows;
pub use self::{
    bytes::{ByteSlopes, Level},
    fast::{Fast, Pair, Short},
    numbers::{NumberRow, Slopes, Wide},
    plane::Plane,
    traits::Varying,
    words::{Word, WordSlopes},
};
