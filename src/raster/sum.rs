//! [`Sum`]: the crossings of a side as a sum of fixed-point numbers, for chips that divide: one addition a row.

use core::num::NonZeroU32;

use super::slope::Slope;
use crate::{
    num::{
        cast::{low_u32, magnitude, signed, unsigned},
        recip::Divisor,
        wide::{signed_product, signed_times_small},
    },
    tune::{COMPACT, DIVIDES},
};

/// Whether shapes of two sides are filled by sums, or by quotient and remainder.
pub(super) const SUMS: bool = DIVIDES && !COMPACT;

/// Crossings of small sides in columns `0..1024`, as 10 bits of pixel and 22 of fraction: a step is one addition.
///
/// M / dy is a multiple of 1 / dy. So its floor is right while the stored number is not below it, and above it by less than
/// 1 / dy.
#[derive(Copy, Clone, Default)]
pub(super) struct Sum {
    at: u32,
    by: u32,
}

impl Sum {
    /// Columns from 0 on.
    pub(super) const COLUMNS: i32 = 1 << (32 - Self::BITS);
    /// Width and height together of a side that may be called tiny: 54 pixels.
    pub(super) const TINY: u32 = 54 * 256;
    /// Bits of the fraction.
    const BITS: u32 = 22;

    /// From row y, which the side crosses; less than 2^16 units high.
    ///
    /// Start and step are too large by at most `2^-22` each, k rows down by `(k + 1) 2^-22`: less than 1 / dy in the first
    /// [`reach`](Self::reach) rows.
    #[inline(always)]
    pub(super) fn new(side: Slope, y: i32) -> Self {
        Self::start(side, y, Self::step_of(side))
    }

    /// The same with a step that is known: that of a side in parallel to it.
    #[inline(always)]
    pub(super) fn start(side: Slope, y: i32, by: u32) -> Self {
        let (p, m) = side.numerator(side.down_to(y));
        Self { at: (unsigned(p) << Self::BITS).wrapping_add(Self::ratio(m, side.dy)), by }
    }

    /// What it gains from row to row, if it crosses more than one.
    #[inline(always)]
    pub(super) fn step_of(side: Slope) -> u32 {
        Self::ratio(side.dx, side.dy)
    }

    /// A little more than n / dy. |M| is below 2^12 dy, and |dx| too where there is a second row: then dy is above 2^8.
    #[inline(always)]
    fn ratio(n: i32, dy: NonZeroU32) -> u32 {
        let n = unsigned(n).wrapping_add(dy.get() << 12);
        let (q, r) = (n / dy, n % dy);
        let (high, rest) = ((r << 16) / dy, (r << 16) % dy);
        let low = (rest << (Self::BITS - 16)) / dy;
        (q << Self::BITS | high << (Self::BITS - 16) | low).wrapping_add(1)
    }

    /// For how many rows the sum of a side of at most this height is exact: 64 or more.
    #[inline(always)]
    pub(super) fn reach(height: NonZeroU32) -> i32 {
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
    pub(super) fn tiny(side: Slope, y: i32) -> Self {
        let Slope { from, dx, dy, .. } = side;
        let ax = from.0.wrapping_add(128);
        let (p, f) = (ax >> 8, unsigned(ax) & 255);
        let n = f.wrapping_mul(dy.get()).wrapping_add(unsigned(side.down_to(y).wrapping_mul(dx)));
        let m = signed(n).wrapping_sub(1) >> 8;
        let i = Self::inverse(dy) & (u32::MAX >> 1);
        let cut = |n: i64| low_u32(magnitude(n >> (32 - Self::BITS)));
        let start = i64::from(p) << 32 | i64::from(i >> 1);
        // Of a tiny triangle |dx| is below 2^14, and i below 2^31.
        let (first, step) = (signed_product(m, signed(i)), signed_times_small(dx, i));
        Self { at: cut(start.wrapping_add(first)), by: cut(step) }
    }

    /// `floor((2^32 - 1) / dy)`.
    #[inline(always)]
    fn inverse(dy: NonZeroU32) -> u32 {
        if DIVIDES {
            u32::MAX / dy
        } else {
            Divisor::new(dy).inverse()
        }
    }

    /// The first pixel right of the side on this row.
    #[inline(always)]
    pub(super) fn x(self) -> i32 {
        signed(self.at >> Self::BITS)
    }

    /// To the next row.
    #[inline(always)]
    pub(super) fn step(&mut self) {
        self.at = self.at.wrapping_add(self.by);
    }
}
