//! Colours as [`Varying`]s: each channel changes by itself, and is the nearest level of its own.
//!
//! Colours of up to 16 bits have their three channels in one number of 128 bits, so that a step is one addition of four words:
//! ```text
//!     127  123 122        86 85   80 79        43 42   38 37         1 0
//!    +--------+-------------+-------+-------------+-------+-------------+-+
//!    |  red   |  fraction   | green |  fraction   | blue  |  fraction   | |    of Rgb565
//!    +--------+-------------+-------+-------------+-------+-------------+-+
//! ```
//! A step that is negative borrows from the channel on its left, and the sum is right all the same, as no channel is negative: it
//! is the sum of three products, whatever carries do. With 37 bits of fraction a channel is right while it is less than 1 / D
//! too large (see [`geom::varying`](crate::geom::varying)): after k steps, while (k + 1) D is below 2^37 less 3 %.

use embedded_graphics_core::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, Gray2, Gray4, Gray8, GrayColor, Rgb555, Rgb565, Rgb666, Rgb888, RgbColor,
};

use crate::{
    geom::{varying::ByteSlopes, Barycentric, Facet, Fast, Mix, Varying},
    num::cast::{low_u32, low_u64, low_u8, signed_wide},
    pixel::{Rgb332, Rgb444, Xrgb8888},
};

/// What changes as its levels do.
macro_rules! by_levels {
    ($color:ty, $levels:ty, |$c:ident| $split:expr, |$l:pat_param| $join:expr) => {
        impl Varying for $color {
            type Slopes = <$levels as Varying>::Slopes;
            type Row = <$levels as Varying>::Row;
            type Run = <$levels as Varying>::Run;

            #[inline(always)]
            fn slopes(facet: &Facet, corners: [Self; 3]) -> Self::Slopes {
                <$levels>::slopes(facet, corners.map(|$c| $split))
            }

            #[inline(always)]
            fn row(slopes: &Self::Slopes, down: u32) -> Self::Row {
                <$levels>::row(slopes, down)
            }

            #[inline(always)]
            fn below(slopes: &Self::Slopes, row: &mut Self::Row) {
                <$levels>::below(slopes, row);
            }

            #[inline(always)]
            fn run(slopes: &Self::Slopes, row: &Self::Row, right: u32) -> Self::Run {
                <$levels>::run(slopes, row, right)
            }

            #[inline(always)]
            fn value(run: &Self::Run) -> Self {
                let $l = <$levels>::value(run);
                $join
            }

            #[inline(always)]
            fn step(run: &mut Self::Run) {
                <$levels>::step(run);
            }
        }
    };
}

/// Three levels, the second one of up to 6 bits, the others of up to 5.
#[derive(Copy, Clone, Debug)]
pub struct Levels([u8; 3]);

/// How three levels change over a triangle.
#[derive(Copy, Clone, Debug)]
#[non_exhaustive]
pub enum LevelSlopes {
    /// In a small triangle: at the first pixel of its box, to the right, and downwards.
    #[doc(hidden)]
    Packed([u128; 3]),
    /// In a large one, and for how many pixels a run is right.
    #[doc(hidden)]
    Apart([ByteSlopes; 3], u32),
}

/// Three levels in the first column of a row: packed, or as the number of the row.
#[derive(Copy, Clone, Debug)]
pub struct LevelRow {
    at: u128,
    down: u32,
}

/// Three levels at one pixel.
#[derive(Copy, Clone, Debug)]
pub struct LevelRun {
    at: u128,
    by: u128,
}

impl Levels {
    /// Bits of a fraction.
    const BITS: u32 = 37;
    /// The lowest bit of each fraction.
    const PLACES: [u32; 3] = [86, 43, 1];
    /// What D times the number of steps may be, and 3 % less, as the start has an excess of its own.
    const MOST: i64 = (1 << Self::BITS) - (1 << (Self::BITS - 5));

    /// Three numbers with that many bits of fraction, as one.
    #[inline(always)]
    fn packed(levels: [u64; 3]) -> u128 {
        let [a, b, c] = levels.map(|n| i128::from(signed_wide(n)).cast_unsigned());
        let [first, second, third] = Self::PLACES;
        (a << first).wrapping_add(b << second).wrapping_add(c << third)
    }
}

/// So many times as much.
#[inline(always)]
fn times(n: u128, factor: u32) -> u128 {
    let product = |word: u128| u64::from(low_u32(low_u64(word))).wrapping_mul(factor.into());
    let (low, rest) = (product(n), product(n >> 32));
    let middle = rest.wrapping_add(low >> 32);
    let high = product(n >> 64).wrapping_add(middle >> 32);
    let top = low_u32(product(n >> 96)).wrapping_add(low_u32(high >> 32));
    let words = [low_u32(low), low_u32(middle), low_u32(high), top];
    words.into_iter().rev().fold(0, |sum, word| sum << 32 | u128::from(word))
}

impl Varying for Levels {
    type Slopes = LevelSlopes;
    type Row = LevelRow;
    type Run = LevelRun;

    #[inline(always)]
    fn slopes(facet: &Facet, [a, b, c]: [Self; 3]) -> LevelSlopes {
        let [(a0, a1, a2), (b0, b1, b2), (c0, c1, c2)] = [a, b, c].map(|Self([r, g, b])| (r, g, b));
        let levels = [[a0, b0, c0], [a1, b1, c1], [a2, b2, c2]];
        let reach = facet.times_in(Self::MOST);
        if reach > facet.extent().wrapping_add(2) {
            let [a, b, c] = levels.map(|corners| facet.byte_slopes(corners, Self::BITS));
            let [(a0, a1, a2), (b0, b1, b2), (c0, c1, c2)] = [a, b, c].map(|[s, r, d]| (s, r, d));
            return LevelSlopes::Packed([[a0, b0, c0], [a1, b1, c1], [a2, b2, c2]].map(Self::packed));
        }
        LevelSlopes::Apart(levels.map(|corners| ByteSlopes::new(facet, corners)), reach.saturating_sub(1).max(1))
    }

    #[inline(always)]
    fn row(slopes: &LevelSlopes, down: u32) -> LevelRow {
        let at = match *slopes {
            LevelSlopes::Packed([start, _, below]) => start.wrapping_add(times(below, down)),
            LevelSlopes::Apart(..) => 0,
        };
        LevelRow { at, down }
    }

    #[inline(always)]
    fn below(slopes: &LevelSlopes, row: &mut LevelRow) {
        match *slopes {
            LevelSlopes::Packed([.., below]) => row.at = row.at.wrapping_add(below),
            LevelSlopes::Apart(..) => row.down = row.down.wrapping_add(1),
        }
    }

    #[inline(always)]
    fn run(slopes: &LevelSlopes, row: &LevelRow, right: u32) -> LevelRun {
        match *slopes {
            LevelSlopes::Packed([_, by, _]) => LevelRun { at: row.at.wrapping_add(times(by, right)), by },
            LevelSlopes::Apart(ref levels, reach) => run_apart(levels, reach, right, row.down),
        }
    }

    #[inline(always)]
    fn value(run: &LevelRun) -> Self {
        // Each level lies in one of the four words.
        Self(Self::PLACES.map(|place| {
            let bit = place.wrapping_add(Self::BITS);
            let word = low_u32(low_u64(run.at >> (bit & !31)));
            low_u8(word >> (bit & 31))
        }))
    }

    #[inline(always)]
    fn step(run: &mut LevelRun) {
        run.at = run.at.wrapping_add(run.by);
    }

    #[inline(always)]
    fn reach(slopes: &LevelSlopes) -> u32 {
        match *slopes {
            LevelSlopes::Packed(_) => u32::MAX,
            LevelSlopes::Apart(_, reach) => reach,
        }
    }
}

/// In a large triangle runs are computed from finer numbers.
#[inline(never)]
fn run_apart(levels: &[ByteSlopes; 3], reach: u32, right: u32, down: u32) -> LevelRun {
    // Alone, a pixel has to be right without a unit more: its unit may be larger than 1 / D.
    let more = u64::from(reach > 1);
    let cut =
        |n: u64, more: u64| (signed_wide(n) >> (ByteSlopes::BITS - Levels::BITS)).cast_unsigned().wrapping_add(more);
    let runs = levels.each_ref().map(|slopes| slopes.run(slopes.row(down), right));
    let at = Levels::packed(runs.map(|run| cut(run.at, more)));
    LevelRun { at, by: Levels::packed(runs.map(|run| cut(run.by, 1))) }
}

macro_rules! rgb {
    ($levels:ty, |$l:pat_param| $parts:expr, |$p:ident| $of:expr; $($color:ty),*) => {
        $(
            by_levels!($color, $levels, |c| { let $p = [c.r(), c.g(), c.b()]; $of }, |$l| {
                let [r, g, b] = $parts;
                Self::new(r, g, b)
            });
            by_levels!(Fast<$color>, [Fast<u8>; 3], |c| [Fast(c.0.r()), Fast(c.0.g()), Fast(c.0.b())], |[r, g, b]| {
                Self(<$color>::new(r.0, g.0, b.0))
            });
        )*
    };
}

/// A mean of colours is that of their levels.
macro_rules! mix {
    ($($color:ty, |$c:ident| $split:expr, |$l:pat_param| $join:expr;)*) => {
        $(impl Mix for $color {
            #[inline]
            fn mix(place: &Barycentric, corners: [Self; 3]) -> Self {
                let $l = Mix::mix(place, corners.map(|$c| $split));
                $join
            }
        })*
    };
}

macro_rules! gray {
    ($($color:ty),*) => {
        $(
            by_levels!($color, u8, |c| c.luma(), |luma| Self::new(luma));
            by_levels!(Fast<$color>, Fast<u8>, |c| Fast(c.0.luma()), |luma| Self(<$color>::new(luma.0)));
        )*
    };
}

rgb!(Levels, |Levels(l)| l, |p| Levels(p); Rgb332, Rgb444, Rgb555, Rgb565, Bgr555, Bgr565);
rgb!([u8; 3], |l| l, |p| p; Rgb666, Rgb888, Xrgb8888, Bgr666, Bgr888);
gray!(Gray2, Gray4, Gray8);

macro_rules! mixes {
    ($($rgb:ty),*; $($gray:ty),*) => {
        $(mix! { $rgb, |c| [c.r(), c.g(), c.b()], |[r, g, b]| Self::new(r, g, b); })*
        $(mix! { $gray, |c| c.luma(), |luma| Self::new(luma); })*
    };
}

mixes!(Rgb332, Rgb444, Rgb555, Rgb565, Rgb666, Rgb888, Xrgb8888, Bgr555, Bgr565, Bgr666, Bgr888; Gray2, Gray4, Gray8);
