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
pub struct Direction {
    pub(crate) x: i32,
    pub(crate) y: i32,
}

impl Direction {
    pub(crate) const RIGHT: Self = Self { x: 1 << 30, y: 0 };

    /// From a to b, and the distance in units of 2^-16 pixel, rounded down; `None` if they are the same place.
    #[inline(never)]
    pub(crate) fn between(a: PointFx, b: PointFx) -> Option<(Self, u64)> {
        let (a, b) = (bits(a), bits(b));
        let (dx, dy) = (difference(b.0, a.0), difference(b.1, a.1));
        let zeros = (dx.unsigned_abs() | dy.unsigned_abs()).leading_zeros();
        // So that the larger component has 31 bits.
        let scaled = |d: u64| if zeros < 33 { d >> 1 } else { d << (zeros.wrapping_sub(33) & 63) };
        let (x, y) = (scaled(dx.unsigned_abs()), scaled(dy.unsigned_abs()));
        let length = NonZeroU32::new(square_root(x.wrapping_mul(x).wrapping_add(y.wrapping_mul(y))))?;
        let share = |n: u64, sign: i64| {
            let (q, r) = div_rem_wide(n << 30, length);
            with_sign(q.wrapping_add(u32::from(r != 0)), sign)
        };
        let long = u64::from(length.get()) << 8;
        let distance = if zeros < 33 { long << 1 } else { long >> (zeros.wrapping_sub(33) & 63) };
        Some((Self { x: share(x, dx), y: share(y, dy) }, distance))
    }

    /// Turned to the right, as the screen shows it.
    pub(crate) const fn right(self) -> Self {
        Self { x: self.y.wrapping_neg(), y: self.x }
    }

    pub(crate) const fn back(self) -> Self {
        Self { x: self.x.wrapping_neg(), y: self.y.wrapping_neg() }
    }

    /// Positive if the other one points to the right of this one.
    pub(crate) fn cross(self, other: Self) -> i64 {
        let product = |a: i32, b: i32| i64::from(a).wrapping_mul(i64::from(b));
        product(self.x, other.y).wrapping_sub(product(self.y, other.x))
    }

    pub(crate) fn dot(self, other: Self) -> i64 {
        self.cross(other.right())
    }

    /// A turn to the left, by an angle of this cosine and sine.
    pub(crate) fn turned(self, (cos, sin): (i32, i32)) -> Self {
        let by = Self { x: cos, y: sin };
        let rounded = |n: i64| narrow(n.wrapping_add(1 << 29) >> 30);
        Self { x: rounded(by.dot(self)), y: rounded(by.cross(self)) }
    }

    /// Half of a width in this direction, rounded away from zero.
    pub(crate) fn offset(self, width: u32) -> (i32, i32) {
        let half = |n: i32| {
            let product = u64::from(width).wrapping_mul(u64::from(n.unsigned_abs()));
            with_sign(low_u32(product.wrapping_add((1 << 31) - 1) >> 31), i64::from(n))
        };
        (half(self.x), half(self.y))
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
pub(crate) fn moved(v: PointFx, (x, y): (i32, i32)) -> PointFx {
    let (vx, vy) = bits(v);
    PointFx::from_bits(vx.saturating_add(x), vy.saturating_add(y))
}
