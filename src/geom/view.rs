//! [`View`]: the part of the plane that a window shows, for shapes that leave out what is not seen.

use super::point::{bits, PointFx};
use crate::{num::cast::saturate, span::Rect};

/// A rectangle of places, in 24.8 units, its sides included.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) struct View {
    x0: i32,
    y0: i32,
    x1: i32,
    y1: i32,
    /// How far lines may be from the curves that they stand for: a quarter of `2^tolerance` units.
    pub(super) tolerance: u32,
}

/// 32 units, 1/8 pixel.
const USUAL: u32 = 7;
/// 2 units, 1/128 pixel.
const FINE: u32 = 3;

impl View {
    /// Everywhere.
    pub(crate) const ALL: Self = Self { x0: i32::MIN, y0: i32::MIN, x1: i32::MAX, y1: i32::MAX, tolerance: USUAL };

    /// A window, with a margin of `reach` units around it.
    pub(crate) fn of(window: Rect, reach: u32) -> Self {
        let Rect { x0, y0, x1, y1 } = window;
        let more = i64::from(reach);
        let (low, high) = (|n| moved(n, more.wrapping_neg()), |n| moved(n, more));
        Self { x0: low(x0), y0: low(y0), x1: high(x1), y1: high(y1), tolerance: USUAL }
    }

    /// The same, with curves cut finer: for coverage, which shows more of them than pixels do.
    pub(crate) const fn finely(self) -> Self {
        Self { tolerance: FINE, ..self }
    }

    /// Everywhere, with the same tolerance.
    pub(super) const fn everywhere(self) -> Self {
        Self { tolerance: self.tolerance, ..Self::ALL }
    }

    /// Whether the box around two places, with a margin of `slack` units, lies beside the view: as a whole left of it,
    /// right of it, above it or below it.
    #[inline(never)]
    pub(crate) fn hides(&self, a: PointFx, b: PointFx, slack: i64) -> bool {
        let (a, b) = (bits(a), bits(b));
        let beside = |p: i32, q: i32, low: i32, high: i32| {
            i64::from(p.max(q)).wrapping_add(slack) < i64::from(low)
                || i64::from(p.min(q)).wrapping_sub(slack) > i64::from(high)
        };
        beside(a.0, b.0, self.x0, self.x1) || beside(a.1, b.1, self.y0, self.y1)
    }

    /// With a margin of so many units around it.
    #[cfg_attr(embedded_raster_compact, inline(never))]
    pub(crate) fn wider(self, units: u32) -> Self {
        let Self { x0, y0, x1, y1, tolerance } = self;
        let (low, high) = (|n: i32| n.saturating_sub_unsigned(units), |n: i32| n.saturating_add_unsigned(units));
        Self { x0: low(x0), y0: low(y0), x1: high(x1), y1: high(y1), tolerance }
    }

    /// Whether the box around some places lies beside the view.
    #[inline(never)]
    pub(crate) fn misses(&self, places: &[PointFx]) -> bool {
        let beside = |v: &PointFx| {
            let (x, y) = bits(*v);
            u32::from(x < self.x0)
                | u32::from(x > self.x1) << 1
                | u32::from(y < self.y0) << 2
                | u32::from(y > self.y1) << 3
        };
        places.iter().map(beside).fold(u32::MAX, |all, sides| all & sides) != 0
    }

    /// Its upper left corner and its lower right one.
    pub(crate) const fn corners(&self) -> [(i32, i32); 2] {
        [(self.x0, self.y0), (self.x1, self.y1)]
    }

    /// Whether a place lies in it.
    pub(crate) fn holds(&self, v: PointFx) -> bool {
        let (x, y) = bits(v);
        self.x0 <= x && x <= self.x1 && self.y0 <= y && y <= self.y1
    }
}

/// The left side of a pixel, moved.
#[cfg_attr(embedded_raster_compact, inline(never))]
fn moved(pixel: i32, by: i64) -> i32 {
    saturate((i64::from(pixel) << 8).wrapping_add(by))
}
