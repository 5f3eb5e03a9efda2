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
    num::cast::{index, low_u32, low_u8, signed, unsigned},
    span::{ClippedSpan, Rect, Sink, SoftRow},
    tune::keep_rolled,
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
    let (x0, width) = (window.x0, window.width());
    let mut rims = [[0; CHUNK]; 2];
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
        let (left, right) = if a <= b { (a, b) } else { (b, a) };
        if !apart((left, right), (x0, y, width), &mut rims, sink) {
            Levels { sink: &mut *sink, chunk: [0; CHUNK], y, x0, width }.between([left, right]);
        }
        y = y.wrapping_add(1);
    }
    for (side, state) in sides.into_iter().zip(states) {
        side.set_state(state);
    }
    y
}

/// A row whose sides lie in the window, have no pixel in common, and go through few: told in one call. `false` if it is another one.
#[inline(always)]
fn apart(
    (left, right): ((i32, i32), (i32, i32)),
    (x0, y, width): (i32, i32, u32),
    [before, behind]: &mut [[u8; CHUNK]; 2],
    sink: &mut impl Sink,
) -> bool {
    // The last column of a side that ends on a border is the one before it, but for a vertical one: then there is one beside it, which
    // is covered as a whole, or not at all.
    let (first, next) = (unsigned(left.1) >> GRID_BITS, unsigned(right.0) >> GRID_BITS);
    // As unsigned numbers, places left of the window lie right of it: one comparison for both.
    if left.0 < 0 || first >= next || unsigned(right.1) >> GRID_BITS >= width {
        return false;
    }
    let Some((start, _, levels)) = LEFT.levels(unsigned(left.0), unsigned(left.1), before) else { return false };
    let Some((_, end, last)) = RIGHT.levels(unsigned(right.0), unsigned(right.1), behind) else { return false };
    if start < end {
        let x = |column: u32| x0.wrapping_add_unsigned(column);
        sink.soft_row(SoftRow::inside(ClippedSpan::inside(y, x(start), x(end)), levels, last));
    }
    true
}

/// How the levels of a rim come out of S: an S times the factor, and the base, `2^AREA_BITS` times the level.
struct Rim {
    factor: u32,
    base: u32,
    /// The levels before a side and behind it.
    ends: [u8; 2],
}

const HALF: u32 = FULL / 2;
/// What lies right of a side.
const LEFT: Rim = Rim { factor: 255, base: HALF, ends: [0, u8::MAX] };
/// What lies left of it: the whole pixel, less S.
const RIGHT: Rim = Rim { factor: 255_u32.wrapping_neg(), base: 255 * FULL + HALF, ends: [u8::MAX, 0] };

impl Rim {
    #[inline(always)]
    fn level(&self, sum: u32) -> u8 {
        low_u8(sum.wrapping_mul(self.factor).wrapping_add(self.base) >> AREA_BITS)
    }

    /// The levels of the pixels that a side goes through, and the columns where they begin and end: those of the first one and of the
    /// last one are left out if they are what is before the side and behind it. `None` if there are too many.
    ///
    /// None in the middle can be left out so: a side goes through 32 pixels at most, so of each but the first one and the last one at
    /// least a 64th lies on either side.
    #[inline(always)]
    fn levels<'l>(&self, from: u32, to: u32, levels: &'l mut [u8; CHUNK]) -> Option<(u32, u32, &'l [u8])> {
        let (column, enter) = (from >> GRID_BITS, from & (PIXEL - 1));
        let inset = to.wrapping_sub(column << GRID_BITS);
        #[cfg(test)]
        crate::num::tally::add(crate::num::tally::Work::Step);
        let (last, columns);
        if inset <= PIXEL {
            let sum = (2 * PIXEL).wrapping_sub(enter).wrapping_sub(inset) << (AREA_BITS - GRID_BITS - 1);
            last = self.level(sum);
            columns = 1;
            levels[0] = last;
        } else {
            let width = NonZeroU32::new(to.wrapping_sub(from))?;
            let ahead = PIXEL.wrapping_sub(enter);
            // At most 2^30, and half of 2^31.
            let n = (ahead << GRID_BITS).wrapping_add(width.get() >> 1);
            let done = n / width;
            levels[0] = self.level(rounded_area(done, ahead));
            if inset <= 2 * PIXEL {
                last = self.level(last_sum(done, inset.wrapping_sub(PIXEL)));
                columns = 2;
                levels[1] = last;
            } else {
                columns = inset.wrapping_sub(1).wrapping_shr(GRID_BITS).wrapping_add(1);
                let rest = levels.get_mut(1..index(signed(columns)))?;
                last = self.more_levels(width, (done, n), inset, rest);
            }
        }
        let [before, behind] = self.ends;
        let skipped = u32::from(levels[0] == before);
        let left_out = u32::from(last == behind);
        let (start, end) = (skipped, columns.wrapping_sub(left_out));
        // A single pixel is left out once at most, as the ends differ.
        let told = levels.get(index(signed(start))..index(signed(end)))?;
        Some((column.wrapping_add(start), column.wrapping_add(end), told))
    }

    /// The levels of the second pixel and those that follow, and the last one of them once more. The side has so much of its height
    /// in the first one, as that division says.
    #[inline(always)]
    fn more_levels(&self, width: NonZeroU32, (mut done, n): (u32, u32), inset: u32, levels: &mut [u8]) -> u8 {
        let Some((end, between)) = levels.split_last_mut() else { return 0 };
        let mut rest = n.wrapping_sub(done.wrapping_mul(width.get()));
        let (each, more) = ((1 << 30) / width, (1 << 30) % width);
        for place in between {
            keep_rolled(true);
            #[cfg(test)]
            crate::num::tally::add(crate::num::tally::Work::Step);
            let before = done;
            (done, rest) = (done.wrapping_add(each), rest.wrapping_add(more));
            if rest >= width.get() {
                (done, rest) = (done.wrapping_add(1), rest.wrapping_sub(width.get()));
            }
            // The height before the pixel, and half of that in it.
            *place = self.level(before.wrapping_add(done) << (AREA_BITS - GRID_BITS - 1));
        }
        *end = self.level(last_sum(done, (inset.wrapping_sub(1) & (PIXEL - 1)).wrapping_add(1)));
        *end
    }
}

/// S of the last pixel of a side: it has so much of its height before it, and ends there.
#[inline(always)]
fn last_sum(done: u32, inset: u32) -> u32 {
    let rest = rounded_area(PIXEL.wrapping_sub(done), (2 * PIXEL).wrapping_sub(inset));
    (done << (AREA_BITS - GRID_BITS)).wrapping_add(rest)
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
    #[inline(never)]
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
        let full = if left.1 > 0 { self.left_rim(Rise::new(left.0, left.1)) } else { first };
        if next < self.width {
            self.right_rim(full, Rise::new(right.0, right.1));
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

    /// The pixels that the left side goes through. Returns where those begin that are full.
    #[inline(never)]
    fn left_rim(&mut self, mut side: Rise) -> u32 {
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

    /// The pixels from `full` on that are so, and those that the right side goes through.
    #[inline(never)]
    fn right_rim(&mut self, full: u32, mut side: Rise) {
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
