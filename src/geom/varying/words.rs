//! Numbers of 16 bits: along a row in 64 bits, 48 of them behind the point.

use super::{
    numbers::{NumberRow, Slopes},
    traits::Varying,
};
use crate::{
    geom::{
        facet::{Facet, SmallFacet},
        small::{Small, Sums},
    },
    num::{
        cast::{low_u16, low_u32},
        mixed::Mixed,
        wide::wide_times_small,
    },
};

/// How a number of 16 bits changes over a triangle.
#[derive(Copy, Clone, Debug)]
pub struct WordSlopes {
    slopes: Slopes,
    /// In a small triangle [`WordSlopes::SMALL`]: then the numbers are those of a [`Word`], each in the place of a fraction.
    reach: u32,
}

impl WordSlopes {
    const SMALL: u32 = u32::MAX;

    #[inline(always)]
    fn new(facet: &Facet, corners: [i32; 3]) -> Self {
        let small = facet.small();
        if !small.is_small() {
            return Self::large(facet, corners);
        }
        let [start, right, down] = small.words(corners).map(|fraction| Mixed { whole: 0, fraction });
        Self { slopes: Slopes { start, right, down }, reach: Self::SMALL }
    }

    #[inline(never)]
    fn large(facet: &Facet, corners: [i32; 3]) -> Self {
        // D times the steps may be 2^48, and 3 % less, as the start has an excess of its own.
        let reach = facet.times_in((1 << 48) - (1 << 43)).saturating_sub(1);
        Self { slopes: Slopes::new(facet, corners.map(i64::from), false), reach }
    }

    #[inline(always)]
    fn row(&self, down: u32) -> Mixed {
        if self.reach == Self::SMALL {
            let Slopes { start, down: by, .. } = self.slopes;
            let fraction = start.fraction.wrapping_add(wide_times_small(by.fraction, down));
            return Mixed { whole: 0, fraction };
        }
        self.slopes.row(down)
    }

    #[inline(always)]
    fn below(&self, row: &mut Mixed) {
        if self.reach == Self::SMALL {
            row.fraction = row.fraction.wrapping_add(self.slopes.down.fraction);
        } else {
            *row += self.slopes.down;
        }
    }

    #[inline(always)]
    fn run(&self, row: Mixed, right: u32) -> Word {
        let by = self.slopes.right;
        if self.reach == Self::SMALL {
            return Word { at: row.fraction.wrapping_add(wide_times_small(by.fraction, right)), by: by.fraction };
        }
        self.large_run(row, right)
    }

    #[inline(never)]
    fn large_run(&self, row: Mixed, right: u32) -> Word {
        let cut = |n: Mixed| n.cut(16).wrapping_add(1);
        Word { at: cut(self.slopes.at(row, right)), by: cut(self.slopes.right) }
    }
}

/// A number of 16 bits at one pixel: in 64 bits, 48 of them behind the point.
#[derive(Copy, Clone, Debug)]
pub struct Word {
    at: u64,
    by: u64,
}

impl Word {
    /// Bits of the fraction.
    const BITS: u32 = SmallFacet::BITS;
}

impl Small<Word> for Sums<u64> {
    #[inline(always)]
    fn skip(&mut self, rows: u32) {
        self.down(rows);
    }

    #[inline(always)]
    fn below(&mut self) {
        self.step();
    }

    #[inline(always)]
    fn run(&self, right: u32) -> Word {
        let (at, by) = self.start(right);
        Word { at, by }
    }
}

macro_rules! words {
    ($($type:ty, |$n:ident| $value:expr;)*) => {
        $(impl Varying for $type {
            type Slopes = WordSlopes;
            type Row = NumberRow;
            type Run = Word;
            type Small = Sums<u64>;

            #[inline(always)]
            fn slopes(facet: &Facet, corners: [Self; 3]) -> WordSlopes {
                WordSlopes::new(facet, corners.map(i32::from))
            }

            #[inline(always)]
            fn small(facet: &SmallFacet, corners: [Self; 3]) -> Option<Sums<u64>> {
                let [at, right, down] = facet.words(corners.map(i32::from));
                Some(Sums { at, right, down })
            }

            #[inline(always)]
            fn row(slopes: &WordSlopes, down: u32) -> NumberRow {
                NumberRow(slopes.row(down))
            }

            #[inline(always)]
            fn below(slopes: &WordSlopes, row: &mut NumberRow) {
                slopes.below(&mut row.0);
            }

            #[inline(always)]
            fn run(slopes: &WordSlopes, row: &NumberRow, right: u32) -> Word {
                slopes.run(row.0, right)
            }

            #[inline(always)]
            fn value(run: &Word) -> Self {
                let $n = low_u16(low_u32(run.at >> Word::BITS));
                $value
            }

            #[inline(always)]
            fn step(run: &mut Word) {
                run.at = run.at.wrapping_add(run.by);
            }

            #[inline(always)]
            fn reach(slopes: &WordSlopes) -> u32 {
                slopes.reach
            }
        })*
    };
}

words! {
    u16, |n| n;
    i16, |n| Self::from_le_bytes(n.to_le_bytes());
}
