//! Triangles by sums of fixed-point numbers, for chips that divide: one addition a side and row.

use super::steps;
use crate::{
    geom::{bits, PointFx},
    num::{
        cast::{index, low_u8, unsigned},
        round::first_centre_from,
    },
    raster::{slope::Slope, sum::Sum},
    span::{Rect, Sink, Span},
    tune::{hidden_zero, keep_rolled, not_counted},
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

/// A span in a row of a tiny triangle: how far it is to the right of the first column of the triangle's box, and its pixels, which
/// may be none.
pub(crate) type TinySpan = [u8; 2];

/// Room for the spans of a tiny triangle: it has fewer than 56 rows.
#[derive(Debug)]
pub(crate) struct TinySpans([u32; 28]);

impl TinySpans {
    /// All spans are empty.
    #[inline(always)]
    pub(crate) fn new() -> Self {
        // For a zero that the compiler knows it calls `memclr`, which takes 190 cycles on Cortex-M4.
        Self([hidden_zero(); 28])
    }

    /// One for each row.
    #[inline(always)]
    pub(crate) fn rows(&mut self) -> &mut [TinySpan] {
        bytemuck::pod_align_to_mut::<u32, TinySpan>(&mut self.0).1
    }
}

/// The spans of a tiny triangle, row by row, if all of its columns lie in the window: the first row, and how many there are. They go to
/// `spans`. `column` is the first one of its box.
///
/// `None` if the triangle is not tiny, or if it has no rows or not all of its columns in the window.
#[inline(never)]
pub(crate) fn tiny(corners: [PointFx; 3], window: Rect, column: i32, spans: &mut TinySpans) -> Option<(i32, usize)> {
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
    let rows = index(y1.wrapping_sub(y0));
    let (upper, lower) = spans.rows().get_mut(..rows)?.split_at_mut_checked(index(turn.wrapping_sub(y0)))?;
    let (long, third) = (tiny_side(a, c, y0), tiny_side(b, c, turn));
    let short = if y0 < turn { tiny_side(a, b, y0) } else { third };
    // Sides are below 2^13.8 units, products below 2^27.6.
    let product = |p: (i32, i32), q: (i32, i32)| p.0.wrapping_sub(a.0).wrapping_mul(q.1.wrapping_sub(a.1));
    let long_is_left = product(b, c) > product(c, b);
    let (mut left, mut right) = if long_is_left { (long, short) } else { (short, long) };
    between(&mut left, &mut right, column, upper);
    if long_is_left {
        right = third;
    } else {
        left = third;
    }
    between(&mut left, &mut right, column, lower);
    Some((y0, rows))
}

/// The spans between two sides of a tiny triangle.
#[inline(always)]
fn between(left: &mut Sum, right: &mut Sum, column: i32, spans: &mut [TinySpan]) {
    for span in spans {
        keep_rolled(true);
        let (x0, x1) = (unsigned(left.x()), unsigned(right.x()));
        *span = [x0.wrapping_sub(unsigned(column)), x1.wrapping_sub(x0)].map(low_u8);
        left.step();
        right.step();
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
