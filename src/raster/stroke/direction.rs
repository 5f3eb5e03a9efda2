//! [`Direction`]: which way a side of a stroke goes, as a vector of length 1.

use core::num::NonZeroU32;

use crate::{
    geom::{bits, PointFx},
    num::{
        cast::{low_u32, magnitude, narrow, signed},
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

    /// Whether it differs from another one by less than an eighth of a turn.
    pub(crate) fn is_near(self, other: Self) -> bool {
        self.dot(other) >> 30 > 759_250_125
    }

    /// Whether a straight line between the offsets in two directions would cut off 32 units or more of the circle that they lie on:
    /// at an angle a it cuts off about `w (1 - cos a) / 8`.
    pub(crate) fn turns_much(self, other: Self, width: u32) -> bool {
        let less = magnitude((1_i64 << 60).wrapping_sub(self.dot(other)).max(0)) >> 30;
        less.wrapping_mul(width.into()) > 256 << 30
    }

    /// Whether all ways between this one and v, which another one bends to, lie between both; or leave that by so little that half a
    /// width that way ends within 16 units.
    pub(crate) fn turns_evenly(self, bend: Self, v: Self, width: u32) -> bool {
        let (p, q) = (self.cross(bend), bend.cross(v));
        let less = p.unsigned_abs().min(q.unsigned_abs()) >> 30;
        self.dot(bend) > 0 && bend.dot(v) > 0 && ((p < 0) == (q < 0) || less.wrapping_mul(width.into()) <= 64 << 30)
    }

    /// Whether it leads from a place towards another one, not far away.
    pub(crate) fn leads(self, a: PointFx, b: PointFx) -> bool {
        let (a, b) = (bits(a), bits(b));
        let product = |n: i32, m: i32, u: i32| difference(m, n).wrapping_mul(i64::from(u));
        product(a.0, b.0, self.x).wrapping_add(product(a.1, b.1, self.y)) > 0
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

/// Whether a side is so short, beside the width of its stroke, that what it turns by has to be looked at: up to `2 sqrt(w)` units.
pub(crate) fn is_tiny(a: PointFx, b: PointFx, width: u32) -> bool {
    let (a, b) = (bits(a), bits(b));
    let longer = u64::from(a.0.abs_diff(b.0).max(a.1.abs_diff(b.1)));
    longer.wrapping_mul(longer) <= u64::from(width) << 2
}

/// How far two places are from each other, in units of 2^-20 pixel, rounded down. It takes a third of what the direction does.
#[inline(never)]
pub(crate) fn distance(a: PointFx, b: PointFx) -> u64 {
    let (a, b) = (bits(a), bits(b));
    let Scaled { length, zeros, .. } = Scaled::new(difference(b.0, a.0), difference(b.1, a.1));
    (u64::from(length) << 13).wrapping_shr(zeros.wrapping_sub(32))
}

/// The length of a vector, scaled, and how many leading zeros its larger component has.
pub(crate) fn speed((x, y): (i64, i64)) -> (u32, u32) {
    let Scaled { length, zeros, .. } = Scaled::new(x, y);
    (length, zeros)
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
