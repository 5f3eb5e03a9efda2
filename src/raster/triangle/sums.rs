//! Triangles by sums of fixed-point numbers, for chips that divide: one addition a side and row.

use super::steps;
use crate::{
    geom::{bits, PointFx},
    num::{cast::unsigned, round::first_centre_from},
    raster::{slope::Slope, sum::Sum},
    span::{Rect, Sink, Span},
    tune::not_counted,
};

/// The most common triangles, by additions ([`Sum`]): less than 256 pixels high, with all of their columns in the window.
#[inline(always)]
pub(super) fn fill([a, b, c]: [(i32, i32); 3], window: Rect, mut sink: impl Sink) {
    let (y0, y1) = (first_centre_from(a.1).max(window.y0), first_centre_from(c.1).min(window.y1));
    if y0 >= y1 {
        return;
    }
    let (first, width) = (unsigned(window.x0) << 8, unsigned(window.x1.wrapping_sub(window.x0)) << 8);
    let is_inside = |x: i32| unsigned(x).wrapping_sub(first) <= width;
    let in_range = window.x0 >= 0 && window.x0 < window.x1 && window.x1 < Sum::COLUMNS;
    if !in_range || !is_inside(a.0) || !is_inside(b.0) || !is_inside(c.0) {
        return fill_apart(a, b, c, window, sink);
    }
    let height = unsigned(c.1.wrapping_sub(a.1));
    let widths = c.0.abs_diff(a.0).wrapping_add(b.0.abs_diff(a.0));
    let tiny = height.checked_add(widths).is_some_and(|sum| sum < Sum::TINY);
    let turn = first_centre_from(b.1).min(y1);
    let (mut long, mut short, mut end);
    if tiny {
        long = tiny_side(a, c, y0);
        (short, end) = if y0 < turn { (tiny_side(a, b, y0), turn) } else { (tiny_side(b, c, y0), y1) };
    } else if height < 1 << 16 {
        (long, short, end) = block(a, b, c, y0, y1);
    } else {
        return fill_apart(a, b, c, window, sink);
    }
    let mut long_is_left = true;
    let mut y = y0;
    loop {
        let (mut left, mut right) = if long_is_left { (long, short) } else { (short, long) };
        while y < end {
            #[cfg(test)]
            crate::num::tally::add(crate::num::tally::Work::Step);
            let (x0, x1) = (left.x(), right.x());
            if let Some(span) = (Span { y, x0, x1 }).known_inside() {
                sink.span(span);
            } else if x0 > x1 {
                // The sides have to be exchanged; all rows so far were empty.
                (left, right) = (right, left);
                long_is_left = !long_is_left;
                continue;
            } else {
                y = not_counted(y);
            }
            left.step();
            right.step();
            y = y.wrapping_add(1);
        }
        if y >= y1 {
            return;
        }
        if tiny {
            long = if long_is_left { left } else { right };
            (short, end) = (tiny_side(b, c, y), y1);
        } else {
            (long, short, end) = block(a, b, c, y, y1);
        }
    }
}

/// A tiny triangle, all of whose columns lie in the window, row by row.
#[derive(Copy, Clone)]
pub(crate) struct Tiny {
    /// The next row, the one at which a side ends, and the one after the last.
    y: i32,
    end: i32,
    last: i32,
    /// The left and the right side in the next row.
    left: Sum,
    right: Sum,
    /// The third side, where another one has ended.
    lower: Sum,
    long_is_left: bool,
}

impl Tiny {
    /// `None` if the triangle is not tiny, or if it has no rows or not all of its columns in the window.
    #[inline(never)]
    pub(crate) fn new(corners: [PointFx; 3], window: Rect) -> Option<Self> {
        let [a, b, c] = super::sorted(corners.map(bits));
        let height = unsigned(c.1.wrapping_sub(a.1));
        let widths = c.0.abs_diff(a.0).wrapping_add(b.0.abs_diff(a.0));
        let (first, width) = (unsigned(window.x0) << 8, unsigned(window.x1.wrapping_sub(window.x0)) << 8);
        let is_inside = |x: i32| unsigned(x).wrapping_sub(first) <= width;
        let in_range = window.x0 >= 0 && window.x0 < window.x1 && window.x1 < Sum::COLUMNS;
        let is_tiny = height.checked_add(widths).is_some_and(|sum| sum < Sum::TINY);
        let (y0, y1) = (first_centre_from(a.1).max(window.y0), first_centre_from(c.1).min(window.y1));
        if !in_range || !is_tiny || !is_inside(a.0) || !is_inside(b.0) || !is_inside(c.0) || y0 >= y1 {
            return None;
        }
        let turn = first_centre_from(b.1).clamp(y0, y1);
        let (long, lower) = (tiny_side(a, c, y0), tiny_side(b, c, turn));
        let short = if y0 < turn { tiny_side(a, b, y0) } else { lower };
        // Sides are below 2^13.8 units, products below 2^27.6.
        let product = |p: (i32, i32), q: (i32, i32)| p.0.wrapping_sub(a.0).wrapping_mul(q.1.wrapping_sub(a.1));
        let long_is_left = product(b, c) > product(c, b);
        let (left, right) = if long_is_left { (long, short) } else { (short, long) };
        Some(Self { y: y0, end: turn, last: y1, left, right, lower, long_is_left })
    }

    /// The next row.
    #[inline(always)]
    pub(crate) const fn y(&self) -> i32 {
        self.y
    }

    /// Calls `f` with the pixels of each row, which may be none, as long as it wants more. A row that it answers with `false` stays
    /// the next one.
    #[inline(always)]
    pub(crate) fn each_row(&mut self, mut f: impl FnMut(Span) -> bool) {
        // Not in their place, but in registers.
        let Self { mut y, mut end, last, mut left, mut right, lower, long_is_left } = *self;
        loop {
            while y < end {
                if !f(Span { y, x0: left.x(), x1: right.x() }) {
                    *self = Self { y, end, last, left, right, lower, long_is_left };
                    return;
                }
                left.step();
                right.step();
                y = y.wrapping_add(1);
            }
            if y >= last {
                return;
            }
            end = last;
            if long_is_left {
                right = lower;
            } else {
                left = lower;
            }
        }
    }
}

/// A side of a tiny triangle from row y on; nothing if it is horizontal, as it crosses no row then.
#[inline(always)]
fn tiny_side(upper: (i32, i32), lower: (i32, i32), y: i32) -> Sum {
    Slope::new(upper, lower).map_or(Sum::default(), |side| Sum::tiny(side, y))
}

/// The long and the short side from row y on, and the row at which they end or stop being exact, at most y1.
#[inline(never)]
fn block(a: (i32, i32), b: (i32, i32), c: (i32, i32), y: i32, y1: i32) -> (Sum, Sum, i32) {
    let turn = first_centre_from(b.1);
    let (upper, lower, end) = if y < turn { (a, b, turn.min(y1)) } else { (b, c, y1) };
    match (Slope::new(a, c), Slope::new(upper, lower)) {
        (Some(long), Some(short)) => {
            (Sum::new(long, y), Sum::new(short, y), end.min(y.saturating_add(Sum::reach(long.dy))))
        }
        _ => (Sum::default(), Sum::default(), y1),
    }
}

/// [`steps::fill`], not inlined, so that it has all registers to itself.
#[inline(never)]
fn fill_apart(a: (i32, i32), b: (i32, i32), c: (i32, i32), window: Rect, sink: impl Sink) {
    steps::fill([a, b, c], window, sink);
}
