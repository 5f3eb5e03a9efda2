//! [`Strip`]: up to eight columns of a picture of one bit per pixel, the piece that glyphs are made of.
//!
//! A picture of one bit per pixel can be cut into strips of eight columns: then a row of a strip is a byte, and the rows below it
//! are the bytes behind it. So a strip is a slice, and whoever paints it takes one byte after the other and moves down by a stride,
//! without looking for the place of a row. Most letters of small fonts are one strip.
//! ```text
//!   ..###...    0x38
//!   .#...#..    0x44       the leftmost pixel in the most significant bit
//!   .#####..    0x7c
//!   .#...#..    0x44
//! ```

use crate::{
    num::cast::signed,
    pixel::rows::strip::{Pairs, PAIRS},
    span::{ClippedSpan, Rect},
};

/// The visible part of a strip: rows of up to eight pixels that lie in the window of the surface that they are given to. Others
/// cannot make one.
#[derive(Copy, Clone, Debug)]
pub struct Strip<'a> {
    x: i32,
    y: i32,
    /// Pixels of a byte that lie on the left of the visible ones.
    skip: u32,
    /// Visible pixels of each byte: 1 to 8, and at most `8 - skip`.
    width: u32,
    rows: &'a [u8],
}

/// The [pairs](super::Surface::pairs) of the two colours of opaque strips. In builds that draw no strip by pairs it is empty, and costs
/// nothing to pass on: an array of one reference, or of none.
#[derive(Copy, Clone, Debug)]
pub struct Ready<'a>([&'a Pairs; PAIRS as usize]);

impl<'a> Ready<'a> {
    /// With the pairs of both colours.
    #[inline(always)]
    pub(crate) fn of(pairs: &'a Pairs) -> Self {
        Self([pairs; PAIRS as usize])
    }

    /// Of strips that have no ground.
    #[inline(always)]
    pub(crate) fn nothing() -> Self {
        const NONE: &Pairs = &[[0; 4]; 4];
        Self([NONE; PAIRS as usize])
    }

    /// The pairs, where strips are made of them.
    #[inline(always)]
    pub(super) fn pairs(self) -> Option<&'a Pairs> {
        self.0.first().copied()
    }
}

impl<'a> Strip<'a> {
    /// The columns `columns` of a strip whose first column would fall on `x`, its first row on `y`. What it says lies in the window
    /// as a whole.
    #[inline(always)]
    pub(crate) const fn inside(x: i32, y: i32, (skip, end): (u32, u32), rows: &'a [u8]) -> Self {
        Self { x: x.wrapping_add(signed(skip)), y, skip, width: end.wrapping_sub(skip), rows }
    }

    /// Column and row of its first pixel.
    #[inline(always)]
    pub(super) const fn first(&self) -> (i32, i32) {
        (self.x, self.y)
    }

    /// A byte for each row; how many pixels of each are left out, and how many are wanted from there on.
    #[inline(always)]
    pub(super) const fn bytes(&self) -> (&'a [u8], (u32, u32)) {
        (self.rows, (self.skip, self.width))
    }

    /// The pixels that it covers.
    pub(super) fn area(&self) -> Rect {
        let rows = i32::try_from(self.rows.len()).unwrap_or(i32::MAX);
        Rect::new(self.x, self.y, self.x.wrapping_add(signed(self.width)), self.y.wrapping_add(rows))
    }

    /// Calls `f` with runs of pixels that are all set, or all not, and which of both: from the top down, from left to right.
    pub(super) fn runs(&self, mut f: impl FnMut(ClippedSpan, bool)) {
        let Rect { x0, y0, x1, .. } = self.area();
        let mut y = y0;
        for &byte in self.rows {
            let mut bits = u32::from(byte) << 24 << (self.skip & 31);
            let mut x = x0;
            while x < x1 {
                let is_set = bits >> 31 != 0;
                let run = if is_set { bits.leading_ones() } else { bits.leading_zeros() };
                let end = x.wrapping_add(signed(run.min(8))).min(x1);
                f(ClippedSpan::inside(y, x, end), is_set);
                bits = bits.checked_shl(run).unwrap_or(0);
                x = end;
            }
            y = y.wrapping_add(1);
        }
    }
}
