//! Depths of what the pipeline draws.

use super::viewport::Projected;
use crate::{
    num::cast::{low_u16, low_u32, magnitude},
    pixel::{Depth16, Depth32},
    surface::Depth,
};

/// Depths that the pipeline makes of z and w.
pub trait DepthOf: Depth {
    /// The depth at the far plane.
    #[doc(hidden)]
    const MOST: u32;

    /// A depth, of a number that is not larger.
    #[doc(hidden)]
    fn number(n: u32) -> Self::Number;
}

impl DepthOf for Depth16 {
    const MOST: u32 = 0xffff;

    #[inline(always)]
    fn number(n: u32) -> u16 {
        low_u16(n)
    }
}

impl DepthOf for Depth32 {
    const MOST: u32 = u32::MAX;

    #[inline(always)]
    fn number(n: u32) -> u32 {
        n
    }
}

/// The nearest number to `MOST z / w`, for z from 0 to w; what is beyond stops there.
#[inline]
pub(super) fn of<Z: DepthOf>(projected: &Projected) -> u32 {
    // Products are below 2^63 - 2^32.
    let depth = projected.w.nearest(i64::from(projected.z.max(0)).wrapping_mul(Z::MOST.into()));
    low_u32(magnitude(depth.min(Z::MOST.into())))
}

/// Depths that are farther by what changes within half a pixel, and one more.
pub(super) fn set_back<Z: DepthOf>(depths: [u32; 3], steepness: u32) -> [u32; 3] {
    let [a, b, c] = depths;
    let all = a.max(b).max(c).wrapping_sub(a.min(b).min(c));
    let by = steepness.min(all).saturating_add(1);
    depths.map(|depth| depth.saturating_add(by).min(Z::MOST))
}
