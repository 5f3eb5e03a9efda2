//! Rows that two sides go through from the upper border to the lower one, as in the middle of triangles, lines and bars. They need
//! no cells: left of both sides there is nothing, between them all is full, and what a side covers of the pixels that it goes
//! through is found from left to right, one pixel after the other.
//! ```text
//!      +-----+-----+-----+-----+-----+-----+
//!      |     |   .'|#####|#####|##'. |     |     the rim of the left side, a plain span, the rim of the right side
//!      |     | .'##|#####|#####|####'|     |
//!      +-----+-----+-----+-----+-----+-----+
//! ```
//! The numbers are those that the cells of `strip.rs` would sum up to: S, what lies right of a side in a pixel, is the height that
//! the side has before the pixel, times the width of the pixel, and the area of its part in it. The sides go in opposite
//! directions, so the sum is S of one less S of the other, of whichever sign: by either fill rule the level is that of its size.

use core::num::NonZeroU32;

use super::{
    slot::CoverageSlot,
    strip::{level_of, rounded_area, AREA_BITS, GRID_BITS},
};
use crate::{
    num::cast::{index, low_u32, signed, unsigned},
    span::{ClippedSpan, Rect, Sink},
};

const PIXEL: u32 = 1 << GRID_BITS;
const FULL: u32 = 1 << AREA_BITS;

/// So many levels at most are told at a time.
const CHUNK: usize = 32;

/// Draws rows from y up to `end` that two sides go through, and returns the first one that it leaves to others: where a side enters
/// the window from the left. The sides step down to that row.
#[inline(never)]
pub(super) fn rows(sides: [&CoverageSlot; 2], (mut y, end): (i32, i32), window: Rect, sink: &mut impl Sink) -> i32 {
    let mut states = sides.map(CoverageSlot::state);
    let mut row = Levels { sink, chunk: [0; CHUNK], y, x0: window.x0, width: window.width() };
    while y < end {
        let [(a, a_next), (b, b_next)] = states.each_ref().map(|(x, crossing)| (*x, crossing.value));
        let a = (a.min(a_next), a.max(a_next));
        let b = (b.min(b_next), b.max(b_next));
        if (a.0 < 0 && a.1 > 0) || (b.0 < 0 && b.1 > 0) {
            break;
        }
        for (x, crossing) in &mut states {
            *x = crossing.value;
            crossing.step();
        }
        row.y = y;
        row.between(if a <= b { [a, b] } else { [b, a] });
        y = y.wrapping_add(1);
    }
    for (side, state) in sides.into_iter().zip(states) {
        side.set_state(state);
    }
    y
}

/// S of the first column of a side and of the next one, if it goes through no more. The same numbers as those of [`Rise`].
#[inline(always)]
fn one_or_two(from: u32, to: u32) -> Option<(u32, [u32; 2])> {
    let (column, enter) = (from >> GRID_BITS, from & (PIXEL - 1));
    let inset = to.wrapping_sub(column << GRID_BITS);
    #[cfg(test)]
    crate::num::tally::add(crate::num::tally::Work::Step);
    if inset <= PIXEL {
        let area = (2 * PIXEL).wrapping_sub(enter).wrapping_sub(inset) << (AREA_BITS - GRID_BITS - 1);
        return Some((column, [area, FULL]));
    }
    let width = NonZeroU32::new(to.wrapping_sub(from)).filter(|_| inset <= 2 * PIXEL)?;
    let ahead = PIXEL.wrapping_sub(enter);
    let part = (ahead << GRID_BITS).wrapping_add(width.get() >> 1) / width;
    let rest = rounded_area(PIXEL.wrapping_sub(part), (3 * PIXEL).wrapping_sub(inset));
    Some((column, [rounded_area(part, ahead), (part << (AREA_BITS - GRID_BITS)).wrapping_add(rest)]))
}

/// What a side covers of one pixel after the other, of those that it goes through. It has the height of a pixel.
struct Rise {
    column: u32,
    /// S of that column.
    sum: u32,
    /// Where its right end is, from the left side of the column.
    inset: u32,
    /// The height that it has up to the end of the column.
    done: u32,
    /// What remains of the division that says so, and the divisor.
    rest: u32,
    width: u32,
    /// What each column between adds to both.
    each: u32,
    more: u32,
}

impl Rise {
    /// From one place to another one that is not left of it, in steps of the grid.
    #[inline(always)]
    fn new(from: u32, to: u32) -> Self {
        let (column, enter) = (from >> GRID_BITS, from & (PIXEL - 1));
        let inset = to.wrapping_sub(column << GRID_BITS);
        let (width, ahead) = (to.wrapping_sub(from), PIXEL.wrapping_sub(enter));
        let rise = Self { column, sum: 0, inset, done: 0, rest: 0, width, each: 0, more: 0 };
        let Some(divisor) = NonZeroU32::new(width).filter(|_| inset > PIXEL) else {
            // The height is 2^15, so there is nothing to round.
            return Self { sum: ahead.wrapping_add(PIXEL).wrapping_sub(inset) << (AREA_BITS - GRID_BITS - 1), ..rise };
        };
        // At most 2^30, and half of 2^31.
        let n = (ahead << GRID_BITS).wrapping_add(width >> 1);
        let (done, rest) = (n / divisor, n % divisor);
        let (each, more) = if inset > 2 * PIXEL { ((1 << 30) / divisor, (1 << 30) % divisor) } else { (0, 0) };
        Self { sum: rounded_area(done, ahead), done, rest, each, more, ..rise }
    }

    /// The last column that it goes through.
    #[inline(always)]
    fn last(&self) -> u32 {
        self.column.wrapping_add(self.inset.saturating_sub(1) >> GRID_BITS)
    }

    /// Moves on to the next column. Beyond the last one all is full.
    #[inline(always)]
    fn step(&mut self) {
        self.column = self.column.wrapping_add(1);
        if self.inset <= PIXEL {
            (self.inset, self.sum) = (0, FULL);
            return;
        }
        self.inset = self.inset.wrapping_sub(PIXEL);
        let before = self.done << (AREA_BITS - GRID_BITS);
        let area = if self.inset > PIXEL {
            let mut part = self.each;
            self.rest = self.rest.wrapping_add(self.more);
            if self.rest >= self.width {
                (part, self.rest) = (part.wrapping_add(1), self.rest.wrapping_sub(self.width));
            }
            self.done = self.done.wrapping_add(part);
            part << (AREA_BITS - GRID_BITS - 1)
        } else {
            rounded_area(PIXEL.wrapping_sub(self.done), (2 * PIXEL).wrapping_sub(self.inset))
        };
        self.sum = before.wrapping_add(area);
    }
}

/// The pixels of a row, told to a sink.
struct Levels<'s, S> {
    sink: &'s mut S,
    chunk: [u8; CHUNK],
    y: i32,
    /// The left column of the window, and how many it has.
    x0: i32,
    width: u32,
}

impl<S: Sink> Levels<'_, S> {
    /// What lies between two sides, from the left end of each to its right end. First comes the one that begins further left, or
    /// that ends further left if both begin at one place. Sides left of the window count as its left side.
    #[inline(always)]
    fn between(&mut self, [left, right]: [(i32, i32); 2]) {
        let inside = |(from, to): (i32, i32)| if to <= 0 { (0, 0) } else { (unsigned(from), unsigned(to)) };
        let [left, right] = [left, right].map(inside);
        // Where a side right of the window is does not matter.
        let (first, next) = (left.0 >> GRID_BITS, (right.0 >> GRID_BITS).min(self.width));
        if first >= self.width || right.1 == 0 {
            return;
        }
        // On the border of two columns a vertical side belongs to the one on its right.
        let last = (left.1.saturating_sub(1) >> GRID_BITS).max(first);
        if left.1 > 0 && last >= next && next < self.width {
            return self.both(Rise::new(left.0, left.1), Rise::new(right.0, right.1));
        }
        let full = if left.1 > 0 { self.left_rim(left.0, left.1) } else { first };
        if next < self.width {
            self.right_rim(full, right.0, right.1);
        } else {
            self.full(full, self.width);
        }
    }

    #[inline(always)]
    fn x(&self, column: u32) -> i32 {
        self.x0.wrapping_add_unsigned(column)
    }

    #[inline(always)]
    fn full(&mut self, start: u32, end: u32) {
        if start < end {
            self.sink.span(ClippedSpan::inside(self.y, self.x(start), self.x(end)));
        }
    }

    /// One or two pixels, from `column` on: those from `start` up to `end`.
    #[inline(always)]
    fn short(&mut self, column: u32, levels: [u8; 2], (start, end): (u32, u32)) {
        let [from, to] = [start, end].map(|x| index(signed(x.wrapping_sub(column))));
        if let Some(levels) = levels.get(from..to).filter(|levels| !levels.is_empty()) {
            self.sink.coverage(ClippedSpan::inside(self.y, self.x(start), self.x(end)), levels);
        }
    }

    /// The pixels that the left side goes through. Returns where those begin that are full.
    #[inline(always)]
    fn left_rim(&mut self, from: u32, to: u32) -> u32 {
        let Some((column, areas)) = one_or_two(from, to) else { return self.long_left_rim(Rise::new(from, to)) };
        let levels = areas.map(level_of);
        let is = |i: usize, level: u8| u32::from(levels.get(i) == Some(&level));
        let start = column.wrapping_add(is(0, 0));
        let end = column.wrapping_add(2).wrapping_sub(is(0, u8::MAX)).wrapping_sub(is(1, u8::MAX)).min(self.width);
        self.short(column, levels, (start, end));
        end
    }

    /// The pixels from `full` on that are so, and those that the right side goes through.
    #[inline(always)]
    fn right_rim(&mut self, full: u32, from: u32, to: u32) {
        let Some((column, areas)) = one_or_two(from, to) else { return self.long_right_rim(full, Rise::new(from, to)) };
        let levels = areas.map(|area| level_of(FULL.wrapping_sub(area)));
        let is = |i: usize, level: u8| u32::from(levels.get(i) == Some(&level));
        let start = column.wrapping_add(is(0, u8::MAX)).wrapping_add(is(1, u8::MAX)).min(self.width);
        let end = column.wrapping_add(2).wrapping_sub(is(0, 0)).wrapping_sub(is(1, 0)).min(self.width);
        self.full(full, start);
        self.short(column, levels, (start, end));
    }

    #[inline(never)]
    fn long_left_rim(&mut self, mut side: Rise) -> u32 {
        let mut end = side.last().wrapping_add(1).min(self.width);
        let mut len = 0;
        loop {
            let column = side.column;
            len = self.put(column, len, level_of(side.sum));
            if column.wrapping_add(1) >= end {
                break;
            }
            side.step();
        }
        while let Some(&u8::MAX) = self.chunk.get(..len).and_then(<[u8]>::last) {
            (len, end) = (len.wrapping_sub(1), end.wrapping_sub(1));
        }
        self.tell(end, len);
        end
    }

    #[inline(never)]
    fn long_right_rim(&mut self, full: u32, mut side: Rise) {
        let end = side.last().wrapping_add(1).min(self.width);
        let before = |side: &Rise| level_of(FULL.wrapping_sub(side.sum));
        while side.column < end && before(&side) == u8::MAX {
            side.step();
        }
        self.full(full, side.column);
        let mut len = 0;
        while side.column < end {
            len = self.put(side.column, len, before(&side));
            side.step();
        }
        self.tell(end, len);
    }

    /// The pixels of two sides that have some in common.
    #[inline(never)]
    fn both(&mut self, mut left: Rise, mut right: Rise) {
        let end = left.last().max(right.last()).wrapping_add(1).min(self.width);
        let mut len = 0;
        while left.column < end {
            let column = left.column;
            let mut taken = 0;
            if column == right.column {
                taken = right.sum;
                right.step();
            }
            len = self.put(column, len, level_of(left.sum.abs_diff(taken)));
            left.step();
        }
        self.tell(end, len);
    }

    /// The level of a pixel waits with `len` others before it. Returns how many wait now.
    #[inline(always)]
    fn put(&mut self, column: u32, mut len: usize, level: u8) -> usize {
        #[cfg(test)]
        crate::num::tally::add(crate::num::tally::Work::Step);
        if level == 0 || len == CHUNK {
            self.tell(column, len);
            len = 0;
        }
        match self.chunk.get_mut(len) {
            Some(place) if level != 0 => {
                *place = level;
                len.wrapping_add(1)
            }
            _ => len,
        }
    }

    /// Tells the levels that wait, of the pixels before a column.
    #[inline(always)]
    fn tell(&mut self, end: u32, len: usize) {
        let Some(levels) = self.chunk.get(..len).filter(|levels| !levels.is_empty()) else { return };
        let x1 = self.x(end);
        let x0 = x1.wrapping_sub_unsigned(low_u32(len as u64));
        self.sink.coverage(ClippedSpan::inside(self.y, x0, x1), levels);
    }
}
