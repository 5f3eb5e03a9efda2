//! [`Plan`]: which pixels are copied where.

use embedded_graphics_core::geometry::Point;

use crate::{
    num::cast::{narrow, saturate, signed},
    span::{ClippedSpan, Rect},
};

/// Which pixels of a window are copied from which of a source: the same number of columns and rows, at least one.
#[derive(Copy, Clone)]
pub(super) struct Plan {
    pub(super) to: Point,
    pub(super) from: Point,
    pub(super) width: u32,
    pub(super) height: u32,
}

impl Plan {
    /// The pixels of `source` that fall into `window` if its top left one falls on `at`.
    pub(super) fn new(window: Rect, at: Point, source: Rect) -> Option<Self> {
        // One axis: the visible start, its place in the source, and the length. In wide numbers, as the source may end
        // beyond i32::MAX.
        let clip = |low: i32, high: i32, at: i32, from: i32, from_end: i32| {
            let start = low.max(at);
            let end = i64::from(high).min(i64::from(at) + i64::from(from_end) - i64::from(from));
            let len = narrow(end - i64::from(start)).unsigned_abs();
            (i64::from(start) < end).then(|| (start, start.wrapping_sub(at).wrapping_add(from), len))
        };
        let (x, from_x, width) = clip(window.x0, window.x1, at.x, source.x0, source.x1)?;
        let (y, from_y, height) = clip(window.y0, window.y1, at.y, source.y0, source.y1)?;
        Some(Self { to: Point::new(x, y), from: Point::new(from_x, from_y), width, height })
    }

    /// The pixels of `area` that lie in a window and still do when the top left one of the area is moved to `to`.
    pub(super) fn within(window: Rect, area: Rect, to: Point) -> Option<Self> {
        let seen = area.intersection(window);
        // In wide numbers: an area may start at i32::MIN, far outside, and still be moved by a pixel.
        let shifted = |to: i32, area: i32, seen: i32| saturate(i64::from(to) - i64::from(area) + i64::from(seen));
        let at = Point::new(shifted(to.x, area.x0, seen.x0), shifted(to.y, area.y0, seen.y0));
        Self::new(window, at, seen)
    }

    /// Calls `f` with each row, and the first pixel of its source.
    #[inline(always)]
    pub(super) fn each_row(self, mut f: impl FnMut(ClippedSpan, (i32, i32))) {
        let x1 = self.to.x.wrapping_add(signed(self.width));
        for down in 0..signed(self.height) {
            let span = ClippedSpan::inside(self.to.y.wrapping_add(down), self.to.x, x1);
            f(span, (self.from.x, self.from.y.wrapping_add(down)));
        }
    }

    /// Calls `f` with each pixel and its source. If both lie in the same picture, each pixel is read before it is written.
    #[inline(always)]
    pub(super) fn each_pixel(self, mut f: impl FnMut((i32, i32), (i32, i32))) {
        let Self { to, from, width, height } = self;
        let place = |i: u32, n: u32, back: bool| signed(if back { n.wrapping_sub(1).wrapping_sub(i) } else { i });
        for i in 0..height {
            let down = place(i, height, to.y > from.y);
            for i in 0..width {
                let right = place(i, width, to.x > from.x);
                let moved = |p: Point| (p.x.wrapping_add(right), p.y.wrapping_add(down));
                f(moved(to), moved(from));
            }
        }
    }
}
