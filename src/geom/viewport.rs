//! [`Viewport`]: coordinates of a plane to places on the screen, and back.
//!
//! Along each axis, `v0` goes to `p0` and `v1` to `p1`, and everything else to the unit nearest to the straight line through
//! these two:
//! ```text
//!     p(v) = p0 + floor( (v - v0) (p1 - p0) / (v1 - v0) + 1/2 )
//! ```
//! One rounding of an exact quotient: nothing drifts, corners are exact, and the order of coordinates is kept, as a rounded
//! straight line has no steps back. The way back is the same formula with the two sides exchanged, so it is off by half a
//! unit of the plane at most; from a place on the screen and to it again is no change at all while a unit of the plane is
//! not larger than one of the screen.
//!
//! Range: any 32 bits on both sides. Factors have 32 bits and a sign, their product 64; the quotient takes one long
//! division. What would lie beyond the ends of the type stops there.

use core::num::NonZeroU32;

use fixed::types::I16F16;

use super::point::{bits, PointFx};
use crate::{
    num::{
        cast::{saturate, signed_wide},
        round::div_rem_wide,
    },
    rect::Rect,
};

/// A map between a rectangle of a plane and one of the screen.
///
/// Numbers of the plane are in any unit of 32 bits: `I16F16` for [`new`](Self::new) and [`place`](Self::place), or else the
/// bits of what you like.
/// ```
/// use embedded_raster::{geom::Viewport, Rect, PointFx};
/// use fixed::types::I16F16;
/// let one = I16F16::ONE;
/// let view = Viewport::new([-one, -one], [one, one], Rect::new(0, 0, 320, 240)).with_y_up();
/// assert_eq!(view.vertex(-one, one), PointFx::px(0, 0));
/// assert_eq!(view.vertex(I16F16::ZERO, I16F16::ZERO), PointFx::px(160, 120));
/// assert_eq!(view.place(PointFx::px(240, 240)), [one / 2, -one]);
/// ```
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Viewport {
    x: AxisMap,
    y: AxisMap,
}

/// Two ends on the plane, and theirs on the screen.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
struct AxisMap {
    plane: (i32, i32),
    screen: (i32, i32),
}

impl Viewport {
    /// Maps the rectangle from corner `low` to corner `high` to the outline of `area`: `low` to its left upper corner.
    ///
    /// `high` may be less than `low`: then that axis is turned round. If they are the same, all goes to where `low` goes.
    #[inline]
    pub fn new(low: [I16F16; 2], high: [I16F16; 2], area: Rect) -> Self {
        Self::from_bits(low.map(I16F16::to_bits), high.map(I16F16::to_bits), area)
    }

    /// The same for corners in any unit.
    #[inline]
    pub fn from_bits(low: [i32; 2], high: [i32; 2], area: Rect) -> Self {
        let (upper, lower) = (bits(PointFx::px(area.x0, area.y0)), bits(PointFx::px(area.x1, area.y1)));
        let ([x0, y0], [x1, y1]) = (low, high);
        Self {
            x: AxisMap { plane: (x0, x1), screen: (upper.0, lower.0) },
            y: AxisMap { plane: (y0, y1), screen: (upper.1, lower.1) },
        }
    }

    /// The same with y of the plane pointing up: `low` goes to the left lower corner.
    #[inline]
    #[must_use]
    pub fn with_y_up(self) -> Self {
        let (top, bottom) = self.y.screen;
        Self { y: AxisMap { screen: (bottom, top), ..self.y }, ..self }
    }

    /// Where a place of the plane lies on the screen, to the nearest 1/256 pixel.
    #[inline]
    pub fn vertex(&self, x: I16F16, y: I16F16) -> PointFx {
        self.vertex_from_bits([x.to_bits(), y.to_bits()])
    }

    /// The same in any unit.
    pub fn vertex_from_bits(&self, [x, y]: [i32; 2]) -> PointFx {
        let to_screen = |v, axis: AxisMap| map(v, axis.plane, axis.screen);
        PointFx::from_bits(to_screen(x, self.x), to_screen(y, self.y))
    }

    /// Which place of the plane lies at a place on the screen, to the nearest unit.
    #[inline]
    pub fn place(&self, at: PointFx) -> [I16F16; 2] {
        self.place_bits(at).map(I16F16::from_bits)
    }

    /// The same in any unit.
    pub fn place_bits(&self, at: PointFx) -> [i32; 2] {
        let to_plane = |p, axis: AxisMap| map(p, axis.screen, axis.plane);
        let (x, y) = bits(at);
        [to_plane(x, self.x), to_plane(y, self.y)]
    }
}

/// `to.0 + (v - from.0) (to.1 - to.0) / (from.1 - from.0)`, rounded to nearest, halves up.
fn map(v: i32, from: (i32, i32), to: (i32, i32)) -> i32 {
    let Some(d) = NonZeroU32::new(from.1.abs_diff(from.0)) else { return to.0 };
    let n = u64::from(v.abs_diff(from.0)) * u64::from(to.1.abs_diff(to.0));
    let is_negative = (v < from.0) ^ (from.1 < from.0) ^ (to.1 < to.0);
    // A quotient of more than 32 bits is beyond all ends.
    let (whole, rest) = if n >> 32 < u64::from(d.get()) { div_rem_wide(n, d) } else { (u32::MAX, 0) };
    let left = d.get().wrapping_sub(rest);
    let rounds_up = if is_negative { rest > left } else { rest >= left };
    let distance = signed_wide(u64::from(whole)).wrapping_add(i64::from(rounds_up));
    saturate(i64::from(to.0).wrapping_add(if is_negative { distance.wrapping_neg() } else { distance }))
}
