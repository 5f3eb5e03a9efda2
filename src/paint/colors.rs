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
    geom::{varying::ByteSlopes, Facet, Fast, Varying},
    num::cast::{low_u32, low_u64, low_u8, signed_wide},
    pixel::{Rgb332, Rgb444, Xrgb8888},
};

/// What changes as its levels do.
macro_rules! by_levels {
    ($color:ty, $levels:ty, |$c:ident| $split:expr, |$l:pat_param| $join:expr) => {
        impl Varying for $color {
            type Slopes = <$levels as Varying>::Slopes;
            type Run = <$levels as Varying>::Run;

            #[inline(always)]
            fn slopes(facet: &Facet, corners: [Self; 3]) -> Self::Slopes {
                <$levels>::slopes(facet, corners.map(|$c| $split))
            }

            #[inline(always)]
            fn run(slopes: &Self::Slopes, right: u32, down: u32) -> Self::Run {
                <$levels>::run(slopes, right, down)
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
pub struct LevelSlopes {
    levels: [ByteSlopes; 3],
    reach: u32,
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
    /// What D times the number of steps may be, and 3 % less, as the first pixel and the steps have an excess of their own.
    const MOST: i64 = (1 << Self::BITS) - (1 << (Self::BITS - 5));

    /// The sum of three numbers with 56 bits of fraction, each cut to 37 and then larger by `more` units.
    #[inline(always)]
    fn packed([a, b, c]: [u64; 3], more: i64) -> u128 {
        let part = |n: u64, place: u32| {
            let cut = (signed_wide(n) >> (64 - ByteSlopes::BITS - Self::BITS)).wrapping_add(more);
            // The sign fills the words above.
            i128::from(cut).cast_unsigned() << place
        };
        let [first, second, third] = Self::PLACES;
        part(a, first).wrapping_add(part(b, second)).wrapping_add(part(c, third))
    }
}

impl Varying for Levels {
    type Slopes = LevelSlopes;
    type Run = LevelRun;

    #[inline(always)]
    fn slopes(facet: &Facet, [a, b, c]: [Self; 3]) -> LevelSlopes {
        let [(a0, a1, a2), (b0, b1, b2), (c0, c1, c2)] = [a, b, c].map(|Self([r, g, b])| (r, g, b));
        let levels = [[a0, b0, c0], [a1, b1, c1], [a2, b2, c2]].map(|corners| ByteSlopes::new(facet, corners));
        LevelSlopes { levels, reach: facet.times_in(Self::MOST).saturating_sub(1).max(1) }
    }

    #[inline(always)]
    fn run(slopes: &LevelSlopes, right: u32, down: u32) -> LevelRun {
        let runs = slopes.levels.each_ref().map(|slopes| slopes.run(right, down));
        // Alone, a pixel has to be right without a unit more: its unit may be larger than 1 / D.
        let more = i64::from(slopes.reach > 1);
        LevelRun { at: Self::packed(runs.map(|run| run.at), more), by: Self::packed(runs.map(|run| run.by), 1) }
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
        slopes.reach
    }
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
