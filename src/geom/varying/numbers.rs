//! Numbers of up to 32 bits: [`Slopes`], which are right for any of them, and what adds them up with all of their bits.

use fixed::types::{I16F16, I24F8};

use super::traits::Varying;
use crate::{
    geom::{facet::Facet, small::NoSmall},
    num::{cast::unsigned, mixed::Mixed},
};

/// How a number changes over a triangle.
#[derive(Copy, Clone, Debug)]
pub struct Slopes {
    pub(super) start: Mixed,
    pub(super) right: Mixed,
    pub(super) down: Mixed,
}

impl Slopes {
    #[inline(always)]
    pub(super) fn new(facet: &Facet, corners: [i64; 3], is_wide: bool) -> Self {
        let [start, right, down] = facet.slopes(corners, is_wide);
        Self { start, right, down }
    }

    #[inline(always)]
    pub(super) fn row(&self, down: u32) -> Mixed {
        self.start + self.down.times(down)
    }

    #[inline(always)]
    pub(super) fn at(&self, row: Mixed, right: u32) -> Mixed {
        row + self.right.times(right)
    }
}

/// The value of a number in the first column of a row.
#[derive(Copy, Clone, Debug)]
pub struct NumberRow(pub(super) Mixed);

/// A number of up to 32 bits, in 96 bits.
#[derive(Copy, Clone, Debug)]
pub struct Wide {
    at: Mixed,
    by: Mixed,
}

macro_rules! wide {
    ($($type:ty, $is_wide:literal, |$n:ident| $bits:expr, |$back:ident| $value:expr;)*) => {
        $(impl Varying for $type {
            type Slopes = Slopes;
            type Row = NumberRow;
            type Run = Wide;
            type Small = NoSmall;

            #[inline(always)]
            fn slopes(facet: &Facet, corners: [Self; 3]) -> Slopes {
                Slopes::new(facet, corners.map(|$n| $bits.into()), $is_wide)
            }

            #[inline(always)]
            fn row(slopes: &Slopes, down: u32) -> NumberRow {
                NumberRow(slopes.row(down))
            }

            #[inline(always)]
            fn below(slopes: &Slopes, row: &mut NumberRow) {
                row.0 += slopes.down;
            }

            #[inline(always)]
            fn run(slopes: &Slopes, row: &NumberRow, right: u32) -> Wide {
                Wide { at: slopes.at(row.0, right), by: slopes.right }
            }

            #[inline(always)]
            fn value(run: &Wide) -> Self {
                let $back = run.at.whole;
                $value
            }

            #[inline(always)]
            fn step(run: &mut Wide) {
                run.at += run.by;
            }
        })*
    };
}

wide! {
    i32, true, |n| n, |bits| bits;
    u32, true, |n| n, |bits| unsigned(bits);
    I16F16, true, |n| n.to_bits(), |bits| Self::from_bits(bits);
    I24F8, true, |n| n.to_bits(), |bits| Self::from_bits(bits);
}
