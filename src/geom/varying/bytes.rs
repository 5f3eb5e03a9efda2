//! Bytes: in 64 bits, 56 of them behind the point.

use super::traits::Varying;
use crate::{
    geom::{
        facet::{Facet, SmallFacet},
        small::{Small, Sums},
    },
    num::{
        cast::{low_u32, low_u8},
        wide::wide_times_small,
    },
};

/// How a byte changes over a triangle: in 64 bits, 8 of them before the point.
#[derive(Copy, Clone, Debug)]
pub struct ByteSlopes {
    start: u64,
    right: u64,
    down: u64,
}

impl ByteSlopes {
    /// Bits of the fraction.
    pub(crate) const BITS: u32 = 56;

    #[inline(always)]
    pub(crate) fn new(facet: &Facet, corners: [u8; 3]) -> Self {
        let [start, right, down] = facet.byte_slopes(corners, Self::BITS);
        Self { start, right, down }
    }

    #[inline(always)]
    pub(crate) fn row(&self, down: u32) -> u64 {
        self.start.wrapping_add(wide_times_small(self.down, down))
    }

    #[inline(always)]
    pub(crate) fn run(&self, row: u64, right: u32) -> Level {
        Level { at: row.wrapping_add(wide_times_small(self.right, right)), by: self.right }
    }
}

/// A byte at one pixel.
#[derive(Copy, Clone, Debug)]
pub struct Level {
    pub(crate) at: u64,
    pub(crate) by: u64,
}

impl Level {
    #[inline(always)]
    fn value(self) -> u8 {
        low_u8(low_u32(self.at >> ByteSlopes::BITS))
    }

    #[inline(always)]
    fn step(&mut self) {
        self.at = self.at.wrapping_add(self.by);
    }
}

impl Small<Level> for Sums<u64> {
    #[inline(always)]
    fn skip(&mut self, rows: u32) {
        self.down(rows);
    }

    #[inline(always)]
    fn below(&mut self) {
        self.step();
    }

    #[inline(always)]
    fn run(&self, right: u32) -> Level {
        let (at, by) = self.start(right);
        Level { at, by }
    }
}

impl Varying for u8 {
    type Slopes = ByteSlopes;
    type Row = u64;
    type Run = Level;
    type Small = Sums<u64>;

    #[inline(always)]
    fn slopes(facet: &Facet, corners: [Self; 3]) -> ByteSlopes {
        ByteSlopes::new(facet, corners)
    }

    #[inline(always)]
    fn small(facet: &SmallFacet, corners: [Self; 3]) -> Option<Sums<u64>> {
        let sums = facet.words(corners.map(i32::from));
        Some(Sums::shifted(sums, ByteSlopes::BITS - SmallFacet::BITS))
    }

    #[inline(always)]
    fn row(slopes: &ByteSlopes, down: u32) -> u64 {
        slopes.row(down)
    }

    #[inline(always)]
    fn below(slopes: &ByteSlopes, row: &mut u64) {
        *row = row.wrapping_add(slopes.down);
    }

    #[inline(always)]
    fn run(slopes: &ByteSlopes, row: &u64, right: u32) -> Level {
        slopes.run(*row, right)
    }

    #[inline(always)]
    fn value(run: &Level) -> Self {
        run.value()
    }

    #[inline(always)]
    fn step(run: &mut Level) {
        run.step();
    }
}
