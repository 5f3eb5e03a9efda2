//! [`Strip`]: what sides cover of the pixels of a row, summed up.
//!
//! Each pixel has a cell. A side adds to the cells of the pixels that it goes through, and to those right of them; summed up from
//! the left, they are what all sides cover: the sides weighted by their winding, each with all that lies right of it.
//! ```text
//!                 x0    x1
//!      +-------+--:----:+-------+        inset  x0 + x1 as seen from the left side of the pixel, 0..=2 pixels
//!   ^  |       |   \####|#######|        area   what the side covers of its own pixel: height (2 - inset) / 2
//!   |  |       |    \###|#######|        cells  + area in this pixel, + height - area in the next one:
//!  height      |     \##|#######|               from there on the sum is the height
//!   v  |       |      \#|#######|
//!      +-------+--------+-------+
//! ```
//! Places along the row and heights are in steps of the grid, 32,768 to a pixel. Where a side goes through several pixels, let w be
//! its width and H its height on this row: left of the border at x it has `floor((x H + floor(w / 2)) / w)` of its height, x
//! counted from its left end. That is the nearest step, and whoever goes over the same side the other way takes away just what
//! was added.
//!
//! An area is rounded to the nearest `2^-18` pixel. What follows the pixel gets the rest, so the sum from there on is exact, and a
//! pixel that is full or empty is so to the last bit. Cells have 32 bits: winding numbers from -8,191 to 8,191.
//!
//! A side left of the strip adds to the carry, the sum before the first cell. Of a side that leaves on the right the rest is left
//! out.
//!
//! **Which cells are touched** is kept in bits. Between them the sum does not change: there are the long runs of full pixels and
//! of empty ones, found 32 at a time.
//!
//! Source: the cells of R. Levien's font-rs, and those of D. Turner's `ftgrays.c` in FreeType.

use core::{
    mem::{replace, take},
    num::NonZeroU32,
};

use super::row::Row;
use crate::{
    geom::fill_rule::FillRule,
    num::cast::{index, low_u32, low_u8, magnitude, saturate, signed, unsigned},
    span::Sink,
};

/// There are `2^GRID_BITS` steps of the grid in a pixel.
pub(super) const GRID_BITS: u32 = 15;
const PIXEL: u32 = 1 << GRID_BITS;
/// The area of a pixel is `2^AREA_BITS`.
pub(super) const AREA_BITS: u32 = 18;
/// So many bits more than a height has an area.
const HEIGHT_BITS: u32 = AREA_BITS - GRID_BITS;
/// So many bits more than an area has a height times a sum of two insets.
const PRODUCT_BITS: u32 = 2 * GRID_BITS + 1 - AREA_BITS;

/// No word has a bit.
const NO_WORDS: (u32, u32) = (u32::MAX, 0);

/// The cells of some columns of a row.
#[derive(Debug)]
pub(super) struct Strip<'a> {
    /// One for each pixel, and one beyond, to which nobody listens.
    cells: &'a mut [i32],
    /// A bit for each pixel that a side goes through, the leftmost one the highest of its word.
    touched: &'a mut [i32],
    /// The first of these words with a bit, and the last one.
    words: (u32, u32),
    /// The sum before the first cell.
    carry: i32,
    /// Its first column.
    pub(super) column: i32,
    /// How many pixels it has now.
    width: u32,
    /// Its sides in steps of the grid, from the left side of the window. Beyond 32 bits, the largest number: then all sides that are
    /// not far lie left of it.
    left: i32,
    right: i32,
}

/// How many numbers a strip of so many pixels takes.
pub(super) const fn needed(pixels: usize) -> usize {
    pixels.saturating_add(1).saturating_add(pixels.div_ceil(32))
}

/// How many pixels so many numbers are enough for.
pub(super) const fn enough_for(numbers: usize) -> usize {
    // 32 pixels take 33 numbers, and one more is there for all.
    let numbers = numbers.saturating_sub(1);
    let rest = (numbers % 33).saturating_sub(1);
    (numbers / 33).saturating_mul(32).saturating_add(rest)
}

impl<'a> Strip<'a> {
    /// A strip of so many pixels, or as many as the memory is enough for. Nothing is in its cells.
    pub(super) fn new(memory: &'a mut [i32], pixels: usize) -> Self {
        let pixels = pixels.min(enough_for(memory.len()));
        let memory = memory.get_mut(..needed(pixels)).unwrap_or_default();
        memory.fill(0);
        let (cells, touched) = memory.split_at_mut_checked(pixels.wrapping_add(1)).unwrap_or_default();
        Self { cells, touched, words: NO_WORDS, carry: 0, column: 0, width: 0, left: 0, right: 0 }
    }

    /// Moves it so that it begins `from` pixels right of the left side `x0` of a window, and ends `end` pixels right of it at most.
    /// Returns where it ends.
    #[inline(always)]
    pub(super) fn move_to(&mut self, x0: i32, from: u32, end: u32) -> u32 {
        let most = low_u32(self.cells.len() as u64).saturating_sub(1).max(1);
        let end = from.saturating_add(most).min(end);
        let side = |pixels: u32| saturate(i64::from(pixels) << GRID_BITS);
        (self.left, self.right) = (side(from), side(end));
        (self.column, self.width) = (x0.wrapping_add_unsigned(from), end.wrapping_sub(from));
        end
    }

    /// Its left side in steps of the grid, from column 0.
    #[inline(always)]
    pub(super) fn far_left(&self) -> i64 {
        i64::from(self.column) << GRID_BITS
    }

    /// Adds a side that goes through the row from x = `from` to `to`, its left and its right end from the left side of the window,
    /// and takes so much of its height.
    #[inline(always)]
    pub(super) fn cover(&mut self, from: i32, to: i32, height: u32, winding: i32) {
        if to <= self.left {
            self.carry(height, winding);
        } else if from < self.left {
            let inside = |x: i32| i64::from(x).wrapping_sub(self.left.into());
            self.cover_far(inside(from), inside(to), height, winding);
        } else if from < self.right {
            let inside = |x: i32| unsigned(x.wrapping_sub(self.left));
            let (from, to) = (inside(from), inside(to));
            let word = |x: u32| x >> (GRID_BITS + 5);
            self.words = (self.words.0.min(word(from)), self.words.1.max(word(to)));
            self.cover_columns(from, to, height, winding);
        }
    }

    #[inline(always)]
    fn carry(&mut self, height: u32, winding: i32) {
        self.carry = self.carry.wrapping_add(signed(height << HEIGHT_BITS).wrapping_mul(winding));
    }

    /// Adds the part of a side that goes through one column, with the sum of the insets of its two ends.
    #[cfg_attr(not(embedded_raster_compact), inline(always))]
    #[cfg_attr(embedded_raster_compact, inline(never))]
    fn put(&mut self, column: u32, height: u32, insets: u32, winding: i32) {
        #[cfg(test)]
        crate::num::tally::add(crate::num::tally::Work::Step);
        let column = index(signed(column));
        let area = rounded_area(height, (2 * PIXEL).wrapping_sub(insets));
        let rest = (height << HEIGHT_BITS).wrapping_sub(area);
        let Some([cell, next]) = self.cells.get_mut(column..).and_then(<[i32]>::first_chunk_mut) else { return };
        *cell = cell.wrapping_add(signed(area).wrapping_mul(winding));
        *next = next.wrapping_add(signed(rest).wrapping_mul(winding));
        if let Some(word) = self.touched.get_mut(column >> 5) {
            *word |= signed(0x8000_0000_u32.wrapping_shr(low_u32(column as u64)));
        }
    }

    /// A side that begins in the strip, its ends from the left side of the strip.
    #[inline(always)]
    fn cover_columns(&mut self, from: u32, to: u32, height: u32, winding: i32) {
        let (mut column, enter) = (from >> GRID_BITS, from & (PIXEL - 1));
        // Of the right end, from the left side of the column.
        let mut inset = to.wrapping_sub(column << GRID_BITS);
        if inset <= PIXEL {
            return self.put(column, height, enter.wrapping_add(inset), winding);
        }
        let Some(width) = NonZeroU32::new(to.wrapping_sub(from)) else { return };
        // At most 2^30, and half of 2^31.
        let n = PIXEL.wrapping_sub(enter).wrapping_mul(height).wrapping_add(width.get() >> 1);
        let (mut part, mut rest) = (n / width, n % width);
        let mut left = height.wrapping_sub(part);
        self.put(column, part, enter.wrapping_add(PIXEL), winding);
        column = column.wrapping_add(1);
        inset = inset.wrapping_sub(PIXEL);
        if inset > PIXEL {
            let (each, more) = ((height << GRID_BITS) / width, (height << GRID_BITS) % width);
            while inset > PIXEL && column < self.width {
                (part, rest) = (each, rest.wrapping_add(more));
                if rest >= width.get() {
                    (part, rest) = (part.wrapping_add(1), rest.wrapping_sub(width.get()));
                }
                left = left.wrapping_sub(part);
                self.put(column, part, PIXEL, winding);
                column = column.wrapping_add(1);
                inset = inset.wrapping_sub(PIXEL);
            }
        }
        if column < self.width {
            self.put(column, left, inset, winding);
        }
    }

    /// A side that may begin left of the strip and be of any width, its ends from the left side of the strip.
    #[cold]
    #[inline(never)]
    pub(super) fn cover_far(&mut self, from: i64, to: i64, height: u32, winding: i32) {
        if to <= 0 {
            return self.carry(height, winding);
        }
        if from >= i64::from(self.width) << GRID_BITS {
            return;
        }
        self.words = (0, self.width >> 5);
        // Below 2^41.
        let width = magnitude(to.wrapping_sub(from)).max(1);
        // Left of a place, so much of the height.
        let before = |x: i64| {
            let n = magnitude(x.wrapping_sub(from)).wrapping_mul(height.into()).wrapping_add(width >> 1);
            short_ratio(n, width)
        };
        let (mut column, mut enter, mut done) = (0, 0, 0);
        if from < 0 {
            (done, _) = before(0);
            self.carry(done, winding);
        } else {
            let from = low_u32(magnitude(from));
            (column, enter) = (from >> GRID_BITS, from & (PIXEL - 1));
        }
        let mut inset = to.wrapping_sub(i64::from(column) << GRID_BITS);
        if inset > i64::from(PIXEL) {
            let (mut at, mut rest) = before(i64::from(column.wrapping_add(1)) << GRID_BITS);
            let (each, more) = short_ratio(u64::from(height) << GRID_BITS, width);
            loop {
                self.put(column, at.wrapping_sub(done), enter.wrapping_add(PIXEL), winding);
                (column, enter, done) = (column.wrapping_add(1), 0, at);
                inset = inset.wrapping_sub(i64::from(PIXEL));
                if column >= self.width {
                    return;
                }
                if inset <= i64::from(PIXEL) {
                    break;
                }
                (at, rest) = (at.wrapping_add(each), rest.wrapping_add(more));
                if rest >= width {
                    (at, rest) = (at.wrapping_add(1), rest.wrapping_sub(width));
                }
            }
        }
        self.put(column, height.wrapping_sub(done), enter.wrapping_add(low_u32(magnitude(inset))), winding);
    }

    /// Tells a row what all its pixels in the strip are covered, and empties the cells. `level` makes a level of a sum and of the
    /// column, counted from the left side of the strip; of pixels of the same sum beside each other it is asked for the first one.
    #[inline(always)]
    pub(super) fn sum_up(&mut self, level: impl Fn(i32, usize) -> u8, row: &mut Row<'_, impl Sink>) {
        let (mut sum, column) = (take(&mut self.carry), self.column);
        let mut told = 0;
        let column = |cell: usize| column.wrapping_add(signed(low_u32(cell as u64)));
        let width = index(signed(self.width));
        let (first, last) = replace(&mut self.words, NO_WORDS);
        // The word after the last one may have the cell that follows the last pixel.
        let (first, end) = (first as usize, (last as usize).saturating_add(2).min(self.touched.len()));
        let (mut base, mut before) = (first.wrapping_mul(32), 0);
        for word in self.touched.get_mut(first..end).unwrap_or_default() {
            #[cfg(test)]
            crate::num::tally::add(crate::num::tally::Work::Step);
            let word = unsigned(take(word));
            // Of a pixel that a side goes through the next cell is touched, too.
            let mut rest = word | word >> 1 | before << 31;
            before = word & 1;
            while rest != 0 {
                let first = rest.leading_zeros();
                let end = first.wrapping_add((!(rest << first)).leading_zeros());
                rest &= u32::MAX.checked_shr(end).unwrap_or(0);
                let [first, end] = [first, end].map(|bit| base.wrapping_add(bit as usize).min(width));
                if told < first {
                    row.run_to(column(first), level(sum, told));
                }
                told = first;
                for cell in self.cells.get_mut(first..end).unwrap_or_default() {
                    sum = sum.wrapping_add(take(cell));
                    row.put(level(sum, told));
                    told = told.wrapping_add(1);
                }
            }
            base = base.wrapping_add(32);
        }
        if let Some(beyond) = self.cells.get_mut(width) {
            *beyond = 0;
        }
        if told < width {
            row.run_to(column(width), level(sum, told));
        }
    }
}

/// The level of a pixel: what is covered of it in 255ths, rounded to nearest, halves upwards.
#[inline(always)]
pub(super) fn level(sum: i32, rule: FillRule) -> u8 {
    let (size, full) = (sum.unsigned_abs(), 1 << AREA_BITS);
    let area = match rule {
        FillRule::NonZero => size.min(full),
        FillRule::EvenOdd => {
            // The odd part of it, mirrored: 0, 1, 0 for sums of 0, 1, 2 pixels.
            let size = size & (2 * full - 1);
            size.min((2 * full).wrapping_sub(size))
        }
    };
    level_of(area)
}

/// The level of an area of at most a pixel.
#[inline(always)]
pub(super) fn level_of(area: u32) -> u8 {
    low_u8(area.wrapping_mul(255).wrapping_add(1 << (AREA_BITS - 1)) >> AREA_BITS)
}

/// A height of at most a pixel times twice a width of at most two, as an area.
#[inline(always)]
pub(super) fn rounded_area(height: u32, twice_width: u32) -> u32 {
    // At most 2^31, as the factors are at most 2^15 and 2^16, and half a unit.
    height.wrapping_mul(twice_width).wrapping_add(1 << (PRODUCT_BITS - 1)) >> PRODUCT_BITS
}

/// So much of a height as lies before a place: `along` of a width, rounded to the nearest step, halves upwards.
#[inline]
pub(super) fn ratio(along: u64, height: u32, width: u64) -> u32 {
    short_ratio(along.wrapping_mul(height.into()).wrapping_add(width >> 1), width).0
}

/// Quotient and remainder of two numbers whose quotient is at most `2^15`, and the divisor below `2^48`.
#[inline(never)]
fn short_ratio(mut n: u64, d: u64) -> (u32, u64) {
    let mut quotient = 0;
    for bit in (0..=GRID_BITS).rev() {
        let part = d.wrapping_shl(bit);
        if n >= part {
            n = n.wrapping_sub(part);
            quotient |= 1_u32.wrapping_shl(bit);
        }
    }
    (quotient, n)
}
