//! Lines between places: ends to 1/256 pixel.
//!
//! **Which pixels.** A line follows its longer axis, x if both are equally long. It has one pixel in each column from that of its
//! first end to that of its last one, both included; a steep line has one in each row. In a column, it is the pixel in which the
//! straight line through both ends crosses the *middle* of the column. If it crosses there from one pixel to the next, it is the
//! one farther along the way.
//! ```text
//!     |   :   |   :   |   :   |   :   |     dotted: the middles of columns
//!     | a-#..._   :   |   :   |   :   |     drawn: the pixels with #
//!   --+---:---+-"---:_+---:---+---:---+--
//!     |   :   |   :   |"--#.._|   :   |     b lies before the middle of its column, less than half a pixel:
//!     |   :   |   :   |   :   |"b-#   |     the line is followed on to there
//!   --+---:---+---:---+---:---+---:---+--
//! ```
//! Between the centres of two pixels, this is Bresenham's line with its choice at ties: see [`mod@line`].
//!
//! **How.** With a, b in units of 1/256 pixel, `da >= db` their distances along both axes, e the way from a to the middle of its
//! column, and f the way to a from the border over which the line comes into the row of a, the middle of column k is reached
//! `m(k) = floor((f + (e + 256 k) db / da) / 256)` rows on. With `n = floor((f da + e db) / 256)` that is `floor((n + k db) / da)`:
//! the steps of a line whose lengths are da and db and that begins with another remainder. From the other end, the same sum gives
//! the last row and the last remainder.
//!
//! Range: any places. `f` is at most 256 and `e` at most 128, so n is from -da / 2 to 3 da / 2. `k < 2^24` and `db < 2^32`, so no
//! product has more than 57 bits.
//!
//! Work: the set-up, with at most four divisions, and one addition for each pixel in the window. A line that the window shows whole
//! takes no division.

use core::num::NonZeroU32;

use super::line::{self, distances, offset};
use crate::{
    geom::{bits, PointFx},
    num::{
        cast::{low_u32, magnitude},
        round::{ceil_ratio, div_rem_wide},
    },
    span::{Rect, Sink, Steps},
};

/// Emits the pixels of the line between two places that lie in `window`.
///
/// Cannot fail, for any places and any window.
/// ```
/// use embedded_raster::{raster::line_fx, ClippedSpan, PointFx, Rect};
/// let (a, b) = (PointFx::from_bits(100, 300), PointFx::from_bits(920, 640));
/// let mut spans = vec![];
/// line_fx::draw(a, b, Rect::new(0, 0, 64, 48), |s: ClippedSpan| spans.push((s.y(), s.x0(), s.x1())));
/// assert_eq!(spans, [(1, 0, 2), (2, 2, 4)]);
/// ```
#[inline]
pub fn draw(a: PointFx, b: PointFx, window: Rect, mut sink: impl Sink) {
    if let Some(steps) = clip(a, b, window) {
        sink.steps(steps);
    }
}

/// A box that encloses the line between two places: all of its pixels.
pub fn extent(a: PointFx, b: PointFx) -> Rect {
    let way = Way::new(a, b);
    let (first, last) = (way.pixel(0, 0), way.pixel(way.count, way.last.0));
    line::extent(first.into(), last.into())
}

/// The visible part of the line between two places; `None` when no pixel of it lies in `window`.
///
/// Cannot fail, for any places and any window.
#[inline(never)]
pub fn clip(a: PointFx, b: PointFx, window: Rect) -> Option<Steps> {
    let way = Way::new(a, b);
    let Way { along, aside, steep, da, db, count, h, last: (most, _) } = way;
    let (columns, rows) = ((window.x0, window.x1), (window.y0, window.y1));
    let (major, minor) = if steep { (rows, columns) } else { (columns, rows) };
    let major = distances(along.start, along.is_forward, major.0, major.1)?;
    let (near, far) = distances(aside.start, aside.is_forward, minor.0, minor.1)?;
    if near > most {
        return None;
    }
    let (mut first, mut last) = (major.0, major.1.min(count));
    if let Some(db) = NonZeroU32::new(db) {
        if near > 0 {
            first = first.max(ceil_ratio(da, near, h, db));
        }
        if far < most {
            last = last.min(ceil_ratio(da, far.wrapping_add(1), h, db).wrapping_sub(1));
        }
    }
    if first > last {
        return None;
    }
    let ((minor_first, rest_first), (minor_last, rest_last)) = (way.state(first), way.state(last));
    // A line that was drawn upwards is given from its other end: see `clip_far`.
    let is_down = if steep { along.is_forward } else { aside.is_forward };
    let (start, rest) = if is_down {
        (way.pixel(first, minor_first), rest_first)
    } else {
        (way.pixel(last, minor_last), da.wrapping_sub(1).wrapping_sub(rest_last))
    };
    let goes_right = if steep { aside.is_forward } else { along.is_forward } == is_down;
    Some(Steps {
        first: start,
        left: last.wrapping_sub(first),
        sideways: minor_last.wrapping_sub(minor_first),
        x_step: if goes_right { 1 } else { -1 },
        steep,
        rest: rest.wrapping_sub(da),
        minor: db,
        major: da,
    })
}

/// One axis of a line.
#[derive(Copy, Clone)]
struct Axis {
    /// The column or row that distances are counted from.
    start: i32,
    /// Whether columns or rows grow along the way.
    is_forward: bool,
}

/// A line by what it does along its way.
struct Way {
    along: Axis,
    aside: Axis,
    steep: bool,
    /// Lengths in units of 1/256 pixel.
    da: u32,
    db: u32,
    /// Steps from the first pixel to the last one.
    count: u32,
    /// The remainder at the first pixel.
    h: u32,
    /// Minor steps made at the last pixel, and the remainder there.
    last: (u32, u32),
}

impl Way {
    fn new(a: PointFx, b: PointFx) -> Self {
        let ((ax, ay), (bx, by)) = (bits(a), bits(b));
        let (columns, rows) = ((ax, bx, ax.abs_diff(bx)), (ay, by, ay.abs_diff(by)));
        let steep = rows.2 > columns.2;
        let ((au, bu, da), (av, bv, db)) = if steep { (rows, columns) } else { (columns, rows) };
        let (u_forward, v_forward) = (au <= bu, av <= bv);
        let turned = |n: i32, is_forward: bool| if is_forward { n } else { n.wrapping_neg() };
        // Rows that the middle of an end's column is reached after that end's own row, and the remainder.
        let end = |u: i32, v: i32| {
            let to_middle = turned(128_i32.wrapping_sub(u & 255), u_forward);
            let from_border = if v_forward { v & 255 } else { 256_i32.wrapping_sub(v & 255) };
            let product = |n: i32, length: u32| i64::from(n).wrapping_mul(length.into());
            let n = product(from_border, da).wrapping_add(product(to_middle, db)) >> 8;
            let rest = |n: i64| low_u32(magnitude(n));
            let length = i64::from(da);
            match n {
                // A single place.
                _ if da == 0 => (0, 0),
                ..0 => (-1, rest(n.wrapping_add(length))),
                _ if n >= length => (1, rest(n.wrapping_sub(length))),
                _ => (0, rest(n)),
            }
        };
        let ((before, h), (after, last_rest)) = (end(au, av), end(bu, bv));
        let rows = turned((bv >> 8).wrapping_sub(av >> 8), v_forward).wrapping_add(after).wrapping_sub(before);
        Self {
            along: Axis { start: au >> 8, is_forward: u_forward },
            aside: Axis { start: (av >> 8).wrapping_add(turned(before, v_forward)), is_forward: v_forward },
            steep,
            da,
            db,
            count: (au >> 8).abs_diff(bu >> 8),
            h,
            last: (rows.unsigned_abs(), last_rest),
        }
    }

    /// Minor steps made after k, and the remainder: known without a division at the ends of the line.
    fn state(&self, k: u32) -> (u32, u32) {
        match NonZeroU32::new(self.da) {
            _ if k == 0 => (0, self.h),
            _ if k == self.count => self.last,
            Some(da) => {
                let n = u64::from(k).wrapping_mul(self.db.into()).wrapping_add(self.h.into());
                div_rem_wide(n, da)
            }
            None => (0, 0),
        }
    }

    /// Column and row after so many major and minor steps.
    fn pixel(&self, along: u32, aside: u32) -> (i32, i32) {
        let (u, v) = (
            offset(self.along.start, self.along.is_forward, along),
            offset(self.aside.start, self.aside.is_forward, aside),
        );
        if self.steep {
            (v, u)
        } else {
            (u, v)
        }
    }
}
