//! [`Direction`]: which way a side of a stroke goes, as a vector of length 1.

use core::num::NonZeroU32;

use crate::{
    geom::{bits, PointFx},
    num::{
        cast::{low_u32, narrow, signed},
        root::square_root,
        round::{difference, div_rem_wide},
    },
};

/// A vector of length 1 (and a little more), in units of 2^-30.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) struct Direction {
    pub(crate) x: i32,
    pub(crate) y: i32,
}

impl Direction {
    pub(crate) const RIGHT: Self = Self { x: 1 << 30, y: 0 };

    /// From a to b; `None` if they are the same place.
    #[cfg_attr(embedded_raster_compact, inline(never))]
    pub(crate) fn between(a: PointFx, b: PointFx) -> Option<Self> {
        let (a, b) = (bits(a), bits(b));
        Self::of((difference(b.0, a.0), difference(b.1, a.1)))
    }

    /// Of a vector below 2^63; `None` if it is none.
    #[inline(never)]
    pub(crate) fn of((x, y): (i64, i64)) -> Option<Self> {
        let Scaled { x, y, length, is_left, is_up, .. } = Scaled::new(x, y);
        let length = NonZeroU32::new(length)?;
        let share = |n: u32, back: bool| {
            let (q, r) = div_rem_wide(u64::from(n) << 30, length);
            with_sign(q.wrapping_add(u32::from(r != 0)), if back { -1 } else { 1 })
        };
        Some(Self { x: share(x, is_left), y: share(y, is_up) })
    }

    /// Turned to the right, as the screen shows it.
    pub(crate) const fn right(self) -> Self {
        Self { x: self.y.wrapping_neg(), y: self.x }
    }

    pub(crate) const fn back(self) -> Self {
        Self { x: self.x.wrapping_neg(), y: self.y.wrapping_neg() }
    }

    /// Positive if the other one points to the right of this one.
    #[cfg_attr(embedded_raster_compact, inline(never))]
    pub(crate) fn cross(self, other: Self) -> i64 {
        let product = |a: i32, b: i32| i64::from(a).wrapping_mul(i64::from(b));
        product(self.x, other.y).wrapping_sub(product(self.y, other.x))
    }

    #[cfg_attr(embedded_raster_compact, inline(never))]
    pub(crate) fn dot(self, other: Self) -> i64 {
        self.cross(other.right())
    }

    /// A turn to the left, by an angle of this cosine and sine.
    #[cfg_attr(embedded_raster_compact, inline(never))]
    pub(crate) fn turned(self, (cos, sin): (i32, i32)) -> Self {
        let by = Self { x: cos, y: sin };
        let rounded = |n: i64| narrow(n.wrapping_add(1 << 29) >> 30);
        Self { x: rounded(by.dot(self)), y: rounded(by.cross(self)) }
    }

    /// Half of a width in this direction, rounded away from zero.
    #[cfg_attr(embedded_raster_compact, inline(never))]
    pub(crate) fn offset(self, width: u32) -> (i32, i32) {
        let half = |n: i32| {
            let product = u64::from(width).wrapping_mul(u64::from(n.unsigned_abs()));
            with_sign(low_u32(product.wrapping_add((1 << 31) - 1) >> 31), i64::from(n))
        };
        (half(self.x), half(self.y))
    }
}

/// By less than so many units a place along a side, at a distance not above its length, is beside the line, or behind its end:
/// as a direction is rounded, up to 2^-30 of a distance that has up to 41 bits.
pub(crate) const OVERSHOT: u32 = 8;

/// How far two places are from each other, in units of 2^-16 pixel, rounded down. It takes a third of what the direction does.
#[inline(never)]
pub(crate) fn distance(a: PointFx, b: PointFx) -> u64 {
    let (a, b) = (bits(a), bits(b));
    let Scaled { length, zeros, .. } = Scaled::new(difference(b.0, a.0), difference(b.1, a.1));
    (u64::from(length) << 9).wrapping_shr(zeros.wrapping_sub(32))
}

/// A vector, scaled so that the larger component has 31 bits. A short one is exact.
struct Scaled {
    x: u32,
    y: u32,
    is_left: bool,
    is_up: bool,
    /// Of (x, y), rounded down.
    length: u32,
    /// Before it was scaled, the larger component had so many bits less than 64.
    zeros: u32,
}

impl Scaled {
    #[inline(never)]
    fn new(x: i64, y: i64) -> Self {
        let (is_left, is_up, x, y) = (x < 0, y < 0, x.unsigned_abs(), y.unsigned_abs());
        let zeros = (x | y).leading_zeros();
        let scaled = |n: u64| low_u32(n.wrapping_shl(zeros) >> 33);
        let (x, y) = (scaled(x), scaled(y));
        let square = |n: u32| u64::from(n).wrapping_mul(u64::from(n));
        let length = square_root(square(x).wrapping_add(square(y)));
        Self { x, y, is_left, is_up, length, zeros }
    }
}

/// A magnitude below 2^31, signed.
#[inline(always)]
pub(crate) fn with_sign(n: u32, sign: i64) -> i32 {
    if sign < 0 {
        signed(n).wrapping_neg()
    } else {
        signed(n)
    }
}

/// A place moved by (x, y). Coordinates stop at the ends of the type.
#[cfg_attr(embedded_raster_compact, inline(never))]
pub(crate) fn moved(v: PointFx, (x, y): (i32, i32)) -> PointFx {
    let (vx, vy) = bits(v);
    PointFx::from_bits(vx.saturating_add(x), vy.saturating_add(y))
}
