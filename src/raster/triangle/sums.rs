//! Triangles by sums of fixed-point numbers, for chips that divide: one addition a side and row.

use core::num::NonZeroU32;

use super::steps;
use crate::{
    num::{
        cast::{low_u32, magnitude, signed, unsigned},
        round::first_centre_from,
    },
    raster::slope::Slope,
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

/// Crossings of small sides in columns `0..1024`, as 10 bits of pixel and 22 of fraction: a step is one addition.
///
/// M / dy is a multiple of 1 / dy. So its floor is right while the stored number is not below it, and above it by less than
/// 1 / dy.
#[derive(Copy, Clone, Default)]
struct Sum {
    at: u32,
    by: u32,
}

impl Sum {
    /// Columns from 0 on.
    const COLUMNS: i32 = 1 << (32 - Self::BITS);
    /// Width and height together of a side that may be called tiny: 54 pixels.
    const TINY: u32 = 54 * 256;
    /// Bits of the fraction.
    const BITS: u32 = 22;

    /// From row y, which the side crosses; less than 2^16 units high.
    ///
    /// Start and step are too large by at most `2^-22` each, k rows down by `(k + 1) 2^-22`: less than 1 / dy in the first
    /// [`reach`](Self::reach) rows.
    #[inline(always)]
    fn new(side: Slope, y: i32) -> Self {
        let (p, m) = side.numerator(side.down_to(y));
        // |M| is below 2^12 dy, and |dx| too where there is a second row: then dy is above 2^8.
        let ratio = |n: i32| {
            let n = unsigned(n).wrapping_add(side.dy.get() << 12);
            let (q, r) = (n / side.dy, n % side.dy);
            let (high, rest) = ((r << 16) / side.dy, (r << 16) % side.dy);
            let low = (rest << (Self::BITS - 16)) / side.dy;
            (q << Self::BITS | high << (Self::BITS - 16) | low).wrapping_add(1)
        };
        Self { at: (unsigned(p) << Self::BITS).wrapping_add(ratio(m)), by: ratio(side.dx) }
    }

    /// For how many rows the sum of a side of at most this height is exact: 64 or more.
    #[inline(always)]
    fn reach(height: NonZeroU32) -> i32 {
        signed(((1 << Self::BITS) - 1) / height)
    }

    /// The same in tiny triangles, with one division.
    ///
    /// Let `i = floor((2^32 - 1) / dy)`. M i, with steps of dx i, differs from `2^32 M / dy` by at most |M|, where M is that of
    /// the row. Cutting off 10 bits, at the start and in each step, takes up to `2^10` more each time. Half of i is added at the
    /// start, so the floor is right while `|M| + 2^10 (k + 1) <= i / 2` in row k. As |M| is at most `dy (256 + |dx|) / 256` and k
    /// at most `dy / 256 + 1`, it is enough that `dy^2 (1280 + |dx|) <= 2^39 - 2^19.1 dy`. With `|dx| + dy = s` the left side is
    /// at most `4 (1280 + s)^3 / 27`, below `2^38.9` for s up to [`TINY`](Self::TINY). (Where dy is 1, M is 0 or -1, there is
    /// one row, and half of i will do.)
    #[inline(always)]
    fn tiny(side: Slope, y: i32) -> Self {
        let Slope { from, dx, dy, .. } = side;
        let ax = from.0.wrapping_add(128);
        let (p, f) = (ax >> 8, unsigned(ax) & 255);
        let n = f.wrapping_mul(dy.get()).wrapping_add(unsigned(side.down_to(y).wrapping_mul(dx)));
        let m = signed(n).wrapping_sub(1) >> 8;
        let i = (u32::MAX / dy) & (u32::MAX >> 1);
        let times = |n: i32| i64::from(n).wrapping_mul(i64::from(i));
        let cut = |n: i64| low_u32(magnitude(n >> (32 - Self::BITS)));
        let start = i64::from(p) << 32 | i64::from(i >> 1);
        Self { at: cut(start.wrapping_add(times(m))), by: cut(times(dx)) }
    }

    /// The first pixel right of the side on this row.
    #[inline(always)]
    fn x(self) -> i32 {
        signed(self.at >> Self::BITS)
    }

    /// To the next row.
    #[inline(always)]
    fn step(&mut self) {
        self.at = self.at.wrapping_add(self.by);
    }
}
