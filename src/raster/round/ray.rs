//! Where rays from the centre of an ellipse meet it.

use super::curve::Curve;
use crate::{
    geom::on_ellipse,
    num::{
        cast::{low_u32, magnitude},
        wide::times,
    },
};

/// Units of these places, to the power of two in a pixel.
pub(super) const SHIFT: u32 = 9;

/// The centre and the radii of an ellipse in units of 1/512 pixel: below 2^42.
pub(super) fn scaled(curve: &Curve) -> ((i64, i64), (i64, i64)) {
    let up = |n: i64| n.wrapping_shl(SHIFT.wrapping_sub(curve.shift));
    ((up(curve.centre.0), up(curve.centre.1)), (up(curve.radii.0).max(0), up(curve.radii.1).max(0)))
}

/// The place where the ray in a direction meets an ellipse with these radii, seen from its centre, in the same units, each coordinate
/// rounded towards it. The direction is a vector of length 1 in 2.30. Without two radii it is the centre.
pub(super) fn place((rx, ry): (i64, i64), direction: (i32, i32)) -> (i64, i64) {
    if rx == 0 || ry == 0 {
        return (0, 0);
    }
    // The ratio of the radii is that of their upper 32 bits.
    let down = 32_u32.saturating_sub((rx | ry).leading_zeros());
    let upper = |n: i64| low_u32(magnitude(n) >> down).max(1);
    let (x, y) = on_ellipse([upper(rx), upper(ry)], direction);
    (along(rx, x), along(ry, y))
}

/// `n part / 2^30`, rounded towards 0, for n from 0 to below `2^43`.
fn along(n: i64, part: i32) -> i64 {
    let (high, low) = times((n >> 32, low_u32(magnitude(n & 0xffff_ffff))), part.unsigned_abs());
    let size = high.wrapping_shl(2).wrapping_add(i64::from(low >> 30));
    if part < 0 {
        size.wrapping_neg()
    } else {
        size
    }
}
