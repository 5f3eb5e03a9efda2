//! [`Viewport`]: from the coordinates of a plane (a chart, a map) to places on the screen, and back.
//!
//! Each axis is a straight line through two given pairs of numbers: `v0` on the plane is `p0` on the screen, and `v1`
//! is `p1`. Any other number v of the plane is the unit of the screen (1/256 pixel) that is nearest to
//! ```text
//!     p(v) = p0 + (v - v0) (p1 - p0) / (v1 - v0)          halfway between two units: the larger one
//! ```
//! The quotient is exact, and rounded once. So nothing drifts, the corners are exact, and what is in order on the plane
//! is in order on the screen, because a straight line that is rounded never steps back.
//!
//! The way back is the same formula with the plane and the screen exchanged. Its result is off by half a unit of the
//! plane at most. If a unit of the plane is not larger than a unit of the screen, a place on the screen that is taken
//! to the plane and back again is the same place.
//!
//! Range: any 32 bits on both sides. A difference of two such numbers has 32 bits and a sign, a product of two
//! differences 64, and the quotient takes one long division. What would lie beyond the ends of the type stops there.

use core::num::NonZeroU32;

use fixed::types::I16F16;

use super::point::{bits, PointFx};
use crate::{
    num::{
        cast::{saturate, signed_wide},
        round::div_rem_wide,
    },
    span::Rect,
};

/// A map between a rectangle of a plane and one of the screen.
///
/// Coordinates of the plane are `I16F16`, or any other numbers of 32 bits: methods with `bits` in their names take and
/// return them as they are, without a unit.
/// ```
/// use embedded_raster::{geom::Viewport, Rect, PointFx};
/// use fixed::types::I16F16;
/// let one = I16F16::ONE;
/// let view = Viewport::new([-one, -one], [one, one], Rect::new(0, 0, 320, 240)).with_y_up();
/// assert_eq!(view.to_screen(-one, one), PointFx::px(0, 0));
/// assert_eq!(view.to_screen(I16F16::ZERO, I16F16::ZERO), PointFx::px(160, 120));
/// assert_eq!(view.to_plane(PointFx::px(240, 240)), [one / 2, -one]);
/// ```
/// Whole numbers go in as they are: a hundred samples of a converter of 12 bits, the largest at the top.
/// ```
/// use embedded_raster::{geom::Viewport, Rect, PointFx};
/// let chart = Viewport::from_bits([0, 0], [100, 4096], Rect::new(10, 10, 310, 138)).with_y_up();
/// assert_eq!(chart.bits_to_screen([0, 0]), PointFx::px(10, 138));
/// assert_eq!(chart.bits_to_screen([50, 3072]), PointFx::px(160, 42));
/// assert_eq!(chart.to_plane_bits(PointFx::px(310, 10)), [100, 4096]);
/// ```
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Viewport {
    x: AxisMap,
    y: AxisMap,
}

/// Two ends on the plane, and theirs on the screen.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct AxisMap {
    plane: (i32, i32),
    screen: (i32, i32),
}

impl Viewport {
    /// The corner `low` of a rectangle of the plane goes to the upper left corner of `area`, the corner `high` to the
    /// lower right one.
    ///
    /// Where `high` is less than `low`, that axis is reversed. Where they are the same, everything goes to where `low`
    /// goes.
    #[inline]
    pub fn new(low: [I16F16; 2], high: [I16F16; 2], area: Rect) -> Self {
        Self::from_bits(low.map(I16F16::to_bits), high.map(I16F16::to_bits), area)
    }

    /// [`new`](Self::new) for corners in any unit: whole numbers, too.
    #[inline]
    pub fn from_bits(low: [i32; 2], high: [i32; 2], area: Rect) -> Self {
        let (upper, lower) = (bits(PointFx::px(area.x0, area.y0)), bits(PointFx::px(area.x1, area.y1)));
        let ([x0, y0], [x1, y1]) = (low, high);
        Self {
            x: AxisMap { plane: (x0, x1), screen: (upper.0, lower.0) },
            y: AxisMap { plane: (y0, y1), screen: (upper.1, lower.1) },
        }
    }

    /// The same map upside down, for planes where y points up: `low` goes to the lower left corner.
    #[inline]
    #[must_use]
    pub fn with_y_up(self) -> Self {
        let (top, bottom) = self.y.screen;
        Self { y: AxisMap { screen: (bottom, top), ..self.y }, ..self }
    }

    /// Where a place of the plane lies on the screen, to the nearest 1/256 pixel.
    #[inline]
    pub fn to_screen(self, x: I16F16, y: I16F16) -> PointFx {
        self.bits_to_screen([x.to_bits(), y.to_bits()])
    }

    /// [`to_screen`](Self::to_screen) for coordinates in any unit.
    pub fn bits_to_screen(self, [x, y]: [i32; 2]) -> PointFx {
        let to_screen = |v, axis: AxisMap| map(v, axis.plane, axis.screen);
        PointFx::from_bits(to_screen(x, self.x), to_screen(y, self.y))
    }

    /// Which place of the plane lies at a place on the screen, to the nearest unit of the plane.
    #[inline]
    pub fn to_plane(self, at: PointFx) -> [I16F16; 2] {
        self.to_plane_bits(at).map(I16F16::from_bits)
    }

    /// [`to_plane`](Self::to_plane) for coordinates in any unit.
    pub fn to_plane_bits(self, at: PointFx) -> [i32; 2] {
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
