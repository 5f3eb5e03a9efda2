//! Lines one pixel wide, by Bresenham's rule, clipped exactly.
//!
//! From `a` to `b` the line has `da` steps along its longer (*major*) axis and `db <= da` along the other. After `k` steps
//! it has made the minor steps nearest to `k db / da`, and at a tie it has made one more:
//! `m(k) = floor((2 k db + da) / (2 da))`, both ends drawn. In Bresenham's words: the decision `p` starts at `2 db - da`;
//! at `p >= 0` the minor axis steps and `p += 2 db - 2 da`, else `p += 2 db`.
//!
//! With `h = floor(da / 2)` the same is `m(k) = floor((k db + h) / da)`, all below 2^64 for any `i32` ends. Solved for `k`,
//! `m(k) >= m` from `k = ceil((m da - h) / db)` on. So one division for each side of the window tells which steps lie in it, and
//! the remainder of `(k db + h) / da` is the decision to go on from. No end is ever moved, so the visible pixels are those
//! of the whole line.
//!
//! Work: the set-up, and one addition for each pixel in the window. A sink is called once.
//!
//! Range: any `i32`. Set-up takes at most four divisions, 32-bit ones while `da m < 2^32`; a line that lies in the window
//! takes none. Images built for size use `search`, which needs neither divisions nor products.
//!
//! Lines between *places*, whose ends are given to 1/256 pixel, have the same rule with other remainders: see
//! [`line_fx`](super::line_fx).
//!
//! Source: J. E. Bresenham, "Algorithm for computer control of a digital plotter", IBM Systems Journal 4(1), 1965.

mod search;

use core::num::NonZeroU32;

use embedded_graphics_core::geometry::Point;

use crate::{
    num::{
        cast::{low_u32, magnitude, signed, unsigned},
        round::{ceil_ratio, difference, div_rem_wide},
    },
    span::{Rect, Sink, Steps},
    tune::COMPACT,
};

/// Built for size, the visible part is searched: no divisions, no products.
const SEARCHED: bool = COMPACT;

/// Emits the pixels of the line from `a` to `b` that lie in `window`, both ends included.
///
/// Cannot fail, for any coordinates and any window.
/// ```
/// use embedded_graphics_core::geometry::Point;
/// use embedded_raster::{raster::line, ClippedSpan, Rect};
/// let window = Rect::new(0, 0, 25, 48);
/// let mut spans = vec![];
/// line::draw(Point::new(20, 41), Point::new(30, 44), window, |s: ClippedSpan| spans.push((s.y(), s.x0(), s.x1())));
/// assert_eq!(spans, [(41, 20, 22), (42, 22, 25)]);
/// ```
#[inline]
pub fn draw(a: Point, b: Point, window: Rect, mut sink: impl Sink) {
    if let Some(steps) = clip(a, b, window) {
        sink.steps(steps);
    }
}

/// A box that encloses the line from `a` to `b`: all of its pixels, and the ends. It stops at the end of `i32`.
pub fn extent(a: Point, b: Point) -> Rect {
    let end = |a: i32, b: i32| a.max(b).saturating_add(1);
    Rect { x0: a.x.min(b.x), y0: a.y.min(b.y), x1: end(a.x, b.x), y1: end(a.y, b.y) }
}

/// The visible part of the line from `a` to `b`, both ends included; `None` when no pixel of it lies in `window`.
///
/// Cannot fail, for any coordinates and any window.
/// ```
/// use embedded_graphics_core::geometry::Point;
/// use embedded_raster::{raster::line, Rect};
/// let window = Rect::new(0, 0, 25, 48);
/// let steps = line::clip(Point::new(20, 41), Point::new(30, 44), window).unwrap();
/// let mut spans = vec![];
/// steps.spans(|s| spans.push((s.y(), s.x0(), s.x1())));
/// assert_eq!(spans, [(41, 20, 22), (42, 22, 25)]);
/// ```
#[inline]
pub fn clip(a: Point, b: Point, window: Rect) -> Option<Steps> {
    if SEARCHED {
        // Tested here, where the compiler may know the window.
        if window.is_empty() {
            return None;
        }
        search::clip(&[a.x, b.x, window.x0, window.x1], &[a.y, b.y, window.y0, window.y1])
    } else if window.contains(a.x, a.y) && window.contains(b.x, b.y) {
        Some(whole(a, b))
    } else {
        clip_far(a, b, window)
    }
}

/// A line that lies in the window as a whole.
#[inline(always)]
fn whole(a: Point, b: Point) -> Steps {
    let up = a.y > b.y;
    let (top, bottom) = if up { (b, a) } else { (a, b) };
    let (dx, dy) = (top.x.abs_diff(bottom.x), unsigned(bottom.y.wrapping_sub(top.y)));
    let steep = dy > dx;
    let (major, minor) = if steep { (dy, dx) } else { (dx, dy) };
    Steps {
        first: (top.x, top.y),
        left: major,
        sideways: minor,
        x_step: if top.x <= bottom.x { 1 } else { -1 },
        steep,
        // r - da, where r is h, or its complement da - 1 - h if the line was drawn upwards: see `clip_far`.
        rest: !(major.wrapping_sub(u32::from(!up)) >> 1),
        minor,
        major,
    }
}

/// A line that crosses the border of the window, or misses it.
#[inline(never)]
fn clip_far(a: Point, b: Point, window: Rect) -> Option<Steps> {
    let (dx, dy) = (a.x.abs_diff(b.x), a.y.abs_diff(b.y));
    let (right, down) = (a.x <= b.x, a.y <= b.y);
    let steep = dy > dx;
    // Distances from `a`, in the direction of the line, of the first and last column and row of the window.
    let columns = distances(a.x, right, window.x0, window.x1)?;
    let rows = distances(a.y, down, window.y0, window.y1)?;
    let (da, db, major, minor) = if steep { (dy, dx, rows, columns) } else { (dx, dy, columns, rows) };
    let h = da >> 1;

    let mut first = major.0;
    let mut last = major.1.min(da);
    if minor.0 > db {
        return None;
    }
    if let Some(db) = NonZeroU32::new(db) {
        if minor.0 > 0 {
            first = first.max(ceil_ratio(da, minor.0, h, db));
        }
        if minor.1 < db.get() {
            last = last.min(ceil_ratio(da, minor.1.wrapping_add(1), h, db).wrapping_sub(1));
        }
    }
    if first > last {
        return None;
    }

    // Minor steps made after k, and the remainder: known without a division at the ends of the line.
    let state = |k: u32| match NonZeroU32::new(da) {
        _ if k == 0 => (0, h),
        _ if k == da => (db, h),
        Some(da) => div_rem_wide((u64::from(k) * u64::from(db)).wrapping_add(u64::from(h)), da),
        None => (0, 0),
    };
    let ((minor_first, rest_first), (minor_last, rest_last)) = (state(first), state(last));
    let left = last.wrapping_sub(first);
    let sideways = minor_last.wrapping_sub(minor_first);
    // A line that was drawn upwards is given from its other end. Going back over step k, it steps aside where r < db. That is
    // where adding db to the complement da - 1 - r carries.
    let (major, minor, right_down, rest) = if down {
        (first, minor_first, right, rest_first)
    } else {
        (last, minor_last, !right, da.wrapping_sub(1).wrapping_sub(rest_last))
    };
    let (along_x, along_y) = if steep { (minor, major) } else { (major, minor) };
    Some(Steps {
        first: (offset(a.x, right, along_x), offset(a.y, down, along_y)),
        left,
        sideways,
        x_step: if right_down { 1 } else { -1 },
        steep,
        rest: rest.wrapping_sub(da),
        minor: db,
        major: da,
    })
}

/// Distances from `from` to the first and the last of the positions `low..high`, walking up or down. `None` if all lie behind.
#[inline(always)]
pub(super) fn distances(from: i32, up: bool, low: i32, high: i32) -> Option<(u32, u32)> {
    if low >= high {
        return None;
    }
    let high = high.wrapping_sub(1);
    let (near, far) = if up {
        (difference(low, from), difference(high, from))
    } else {
        (difference(from, high), difference(from, low))
    };
    // Both are below 2^32 as differences of i32.
    (far >= 0).then(|| (low_u32(magnitude(near.max(0))), low_u32(magnitude(far))))
}

#[inline(always)]
pub(super) fn offset(from: i32, up: bool, distance: u32) -> i32 {
    if up {
        from.wrapping_add(signed(distance))
    } else {
        from.wrapping_sub(signed(distance))
    }
}
