//! Colours as [`Varying`]s: each channel changes by itself, and is the nearest level of its own.
//!
//! Colours of up to 16 bits have their three channels in one number of 128 bits, so that a step is one addition of four words:
//! ```text
//!     127   123 122       86 85   81 80        43 42   37 36         0
//!    +---------+------------+-------+------------+-------+------------+
//!    |  blue   |  fraction  |  red  |  fraction  | green |  fraction  |    of Rgb565
//!    +---------+------------+-------+------------+-------+------------+
//! ```
//! A step that is negative borrows from the channel on its left, and the sum is right all the same, as no channel is negative: it
//! is the sum of three products, whatever carries do. With 37 bits of fraction a channel is right while it is less than 1 / D
//! too large (see [`geom::varying`](crate::geom::varying)): after k steps, while (k + 1) D is below 2^37 less 3 %.
//!
//! The order of the channels is that in which an RGB565 is put together soonest. In its word, blue is on top and needs a shift
//! only, and green lies where it lies in the colour: four instructions on Cortex-M4, with one mask in a register.
//!
//! [`Fast`] has 16 bits for each fraction, and so all three in 64 bits.
//!
//! Computers with vector registers take each level in a number of its own instead, as those of larger colours: their compilers make vectors
//! of several pixels of these, but not of numbers of 128 bits.

use embedded_graphics_core::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, Gray2, Gray4, Gray8, GrayColor, Rgb555, Rgb565, Rgb666, Rgb888, RgbColor,
};

use crate::{
    geom::{
        small::{NoSmall, Small, Sums},
        varying::ByteSlopes,
        Facet, Fast, Mix, SmallFacet, Varying,
    },
    num::{
        cast::{low_u32, low_u64, low_u8, signed_wide},
        wide::{product, times_small},
    },
    pixel::{Rgb332, Rgb444, Xrgb8888},
    tune::LONG_PRODUCTS,
};

/// What changes as its levels do.
macro_rules! by_levels {
    ($color:ty, $levels:ty, |$c:ident| $split:expr, |$l:pat_param| $join:expr) => {
        impl Varying for $color {
            type Slopes = <$levels as Varying>::Slopes;
            type Row = <$levels as Varying>::Row;
            type Run = <$levels as Varying>::Run;
            type Small = <$levels as Varying>::Small;

            #[inline(always)]
            fn slopes(facet: &Facet, corners: [Self; 3]) -> Self::Slopes {
                <$levels>::slopes(facet, corners.map(|$c| $split))
            }

            #[inline(never)]
            fn small(facet: &SmallFacet, corners: [Self; 3]) -> Option<Self::Small> {
                <$levels>::small(facet, corners.map(|$c| $split))
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
            fn go_on(slopes: &Self::Slopes, run: &mut Self::Run, at: (u32, u32), pixels: u32) {
                <$levels>::go_on(slopes, run, at, pixels);
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

            #[inline(always)]
            fn reach(slopes: &Self::Slopes) -> u32 {
                <$levels>::reach(slopes)
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
    /// In another one.
    #[doc(hidden)]
    Apart(Apart),
}

/// How three levels change over a large triangle, where packed numbers are right for a run of some pixels.
///
/// Each step adds up to one unit too much. After a run, the whole units of that are subtracted: so after j runs, and k steps of the
/// next one, the numbers are too large by less than j + k + 1 units. Where the longest rows would need more runs than that allows,
/// each run starts from the finer numbers instead.
#[derive(Copy, Clone, Debug)]
pub struct Apart {
    levels: [ByteSlopes; 3],
    /// What a step to the right adds.
    by: u128,
    /// What is taken back between runs; 0 to start from the finer numbers.
    back: u128,
    /// Pixels of a run.
    reach: u32,
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
    const BITS: u32 = Facet::SMALL_BITS;
    /// The lowest bit of each fraction.
    const PLACES: [u32; 3] = [44, 0, 86];
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

impl LevelSlopes {
    /// And what each level gains to the right.
    #[inline(never)]
    fn new(facet: &Facet, [a, b, c]: [Levels; 3]) -> (Self, [u64; 3]) {
        let [Levels([a0, a1, a2]), Levels([b0, b1, b2]), Levels([c0, c1, c2])] = [a, b, c];
        let levels = [[a0, b0, c0], [a1, b1, c1], [a2, b2, c2]];
        let Some([a, b, c]) = facet.level_slopes(levels) else { return Self::apart(facet, levels) };
        let [(a0, a1, a2), (b0, b1, b2), (c0, c1, c2)] = [a, b, c].map(|[s, r, d]| (s, r, d));
        let right = [a1, b1, c1];
        (Self::Packed([[a0, b0, c0], right, [a2, b2, c2]].map(Levels::packed)), right)
    }

    /// In a triangle that is too large for packed numbers, or too steep.
    #[inline(never)]
    fn apart(facet: &Facet, levels: [[u8; 3]; 3]) -> (Self, [u64; 3]) {
        let levels = levels.map(|corners| ByteSlopes::new(facet, corners));
        let fine = levels.each_ref().map(|slopes| slopes.run(0, 0).by);
        let right = fine.map(|gain| cut(gain, 1));
        // With `most` steps and the start, a number is just right.
        let most = facet.times_in(Levels::MOST).saturating_sub(1).max(1);
        let (mut reach, mut back) = (most, 0);
        let shares =
            [most >> 3, most >> 2].into_iter().map(|runs| (most.wrapping_sub(runs) & !3, runs.wrapping_add(1)));
        if let Some((long, _)) = { shares }.find(|(long, runs)| long.saturating_mul(*runs) >= facet.width()) {
            reach = long;
            let less = ByteSlopes::BITS - Levels::BITS;
            // A step gains up to 1 unit too much. A reach is below 2^36.
            let excess =
                |(coarse, fine): (u64, u64)| (coarse << less).wrapping_sub(fine).wrapping_mul(reach.into()) >> less;
            let [a, b, c] = fine;
            let [p, q, r] = right;
            back = Levels::packed([(p, a), (q, b), (r, c)].map(excess));
        }
        (Self::Apart(Apart { levels, by: Levels::packed(right), back, reach }), right)
    }
}

/// The bits of a byte's slope, cut to those of a level.
#[inline(always)]
fn cut(n: u64, more: u64) -> u64 {
    (signed_wide(n) >> (ByteSlopes::BITS - Levels::BITS)).cast_unsigned().wrapping_add(more)
}

/// So many times as much, for a factor below 2^16.
#[inline(always)]
fn times(n: u128, factor: u32) -> u128 {
    let word = |bit: u32| low_u32(low_u64(n.wrapping_shr(bit)));
    if LONG_PRODUCTS {
        // Of every other word, so that products do not overlap.
        let [a, b, c, d] = [0, 32, 64, 96].map(|bit| u128::from(product(word(bit), factor)));
        return (a | c << 64).wrapping_add(b << 32 | d << 96);
    }
    times_small([0, 32, 64, 96].map(word), factor).into_iter().rev().fold(0, |sum, word| sum << 32 | u128::from(word))
}

/// A number, and so many times another one: word by word, each with its part of the sum and with what the one before carries.
#[inline(always)]
fn plus_times(at: u128, n: u128, factor: u32) -> u128 {
    if !LONG_PRODUCTS {
        return at.wrapping_add(times(n, factor));
    }
    let word = |n: u128, bit: u32| low_u32(low_u64(n.wrapping_shr(bit)));
    let mut carry = 0;
    let [a, b, c] = [0, 32, 64].map(|bit| {
        let sum = product(word(n, bit), factor).wrapping_add(word(at, bit).into()).wrapping_add(u64::from(carry));
        carry = low_u32(sum >> 32);
        u128::from(low_u32(sum))
    });
    let d = word(n, 96).wrapping_mul(factor).wrapping_add(word(at, 96)).wrapping_add(carry);
    a | b << 32 | c << 64 | u128::from(d) << 96
}

/// The level whose lowest bit is that one. Each lies in one of the four words.
#[inline(always)]
fn level(n: u128, bit: u32) -> u8 {
    low_u8(low_u32(low_u64(n >> (bit & 0x60))) >> (bit & 31))
}

impl Small<LevelRun> for Sums<u128> {
    #[inline(always)]
    fn skip(&mut self, rows: u32) {
        self.at = self.at.wrapping_add(times(self.down, rows));
    }

    #[inline(always)]
    fn below(&mut self) {
        self.at = self.at.wrapping_add(self.down);
    }

    #[inline(always)]
    fn run(&self, right: u32) -> LevelRun {
        LevelRun { at: plus_times(self.at, self.right, right), by: self.right }
    }
}

impl Varying for Levels {
    type Slopes = LevelSlopes;
    type Row = LevelRow;
    type Run = LevelRun;
    type Small = Sums<u128>;

    #[inline(always)]
    fn slopes(facet: &Facet, corners: [Self; 3]) -> LevelSlopes {
        LevelSlopes::new(facet, corners).0
    }

    #[inline(always)]
    fn small(facet: &SmallFacet, corners: [Self; 3]) -> Option<Sums<u128>> {
        let [Levels([a0, a1, a2]), Levels([b0, b1, b2]), Levels([c0, c1, c2])] = corners;
        let [a, b, c] = facet.levels([[a0, b0, c0], [a1, b1, c1], [a2, b2, c2]]);
        let ([a0, a1, a2], [b0, b1, b2], [c0, c1, c2]) = (a, b, c);
        let packed = Levels::packed;
        Some(Sums { at: packed([a0, b0, c0]), right: packed([a1, b1, c1]), down: packed([a2, b2, c2]) })
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
            LevelSlopes::Apart(ref apart) => LevelRun { at: start_apart(apart, right, row.down), by: apart.by },
        }
    }

    #[inline(always)]
    fn go_on(slopes: &LevelSlopes, run: &mut LevelRun, (right, down): (u32, u32), _: u32) {
        match *slopes {
            LevelSlopes::Apart(Apart { back, .. }) if back != 0 => run.at = run.at.wrapping_sub(back),
            _ => *run = Self::run(slopes, &Self::row(slopes, down), right),
        }
    }

    #[inline(always)]
    fn value(run: &LevelRun) -> Self {
        Self(Self::PLACES.map(|place| level(run.at, place.wrapping_add(Self::BITS))))
    }

    #[inline(always)]
    fn step(run: &mut LevelRun) {
        run.at = run.at.wrapping_add(run.by);
    }

    #[inline(always)]
    fn reach(slopes: &LevelSlopes) -> u32 {
        match *slopes {
            LevelSlopes::Packed(_) => u32::MAX,
            LevelSlopes::Apart(Apart { reach, .. }) => reach,
        }
    }
}

/// In a large triangle runs start from finer numbers. Alone, a pixel has to be right without a unit more: its unit may be larger
/// than 1 / D.
#[inline(never)]
fn start_apart(apart: &Apart, right: u32, down: u32) -> u128 {
    let more = u64::from(apart.reach > 1);
    Levels::packed(apart.levels.each_ref().map(|slopes| cut(slopes.run(slopes.row(down), right).at, more)))
}

/// How three levels change over a triangle in their fast mode: from pixel to pixel of a row by `by`.
#[derive(Copy, Clone, Debug)]
pub struct FastSlopes {
    levels: LevelSlopes,
    by: u64,
}

/// Three levels at one pixel, with 16 bits of fraction each: those of [`Levels`] in the same order.
#[derive(Copy, Clone, Debug)]
pub struct FastRun {
    at: u64,
    by: u64,
}

impl FastRun {
    /// Bits of a fraction.
    const BITS: u32 = 16;
    /// The lowest bit of each fraction.
    const PLACES: [u32; 3] = [22, 0, 43];

    /// Levels with a shorter fraction.
    #[inline(always)]
    fn cut(at: u128) -> u64 {
        let part = |(from, to): (u32, u32), mask: u64| {
            (low_u64(at >> (from.wrapping_add(Levels::BITS - Self::BITS) & 127)) & mask) << (to & 63)
        };
        let ([a, b, c], [p, q, r]) = (Levels::PLACES, Self::PLACES);
        part((a, p), (1 << 21) - 1) | part((b, q), (1 << 22) - 1) | part((c, r), (1 << 21) - 1)
    }
}

impl Varying for Fast<Levels> {
    type Slopes = FastSlopes;
    type Row = LevelRow;
    type Run = FastRun;
    type Small = NoSmall;

    #[inline(always)]
    fn slopes(facet: &Facet, corners: [Self; 3]) -> FastSlopes {
        let (levels, right) = LevelSlopes::new(facet, corners.map(|corner| corner.0));
        let less = Levels::BITS - FastRun::BITS;
        let by = right.into_iter().zip(FastRun::PLACES).fold(0_u64, |sum, (gain, place)| {
            // Towards zero.
            let up = (signed_wide(gain) >> 63).cast_unsigned() & ((1 << less) - 1);
            let gain = (signed_wide(gain.wrapping_add(up)) >> less).cast_unsigned();
            sum.wrapping_add(gain << (place & 63))
        });
        FastSlopes { levels, by }
    }

    #[inline(always)]
    fn row(slopes: &FastSlopes, down: u32) -> LevelRow {
        Levels::row(&slopes.levels, down)
    }

    #[inline(always)]
    fn below(slopes: &FastSlopes, row: &mut LevelRow) {
        Levels::below(&slopes.levels, row);
    }

    #[inline(always)]
    fn run(slopes: &FastSlopes, row: &LevelRow, right: u32) -> FastRun {
        FastRun { at: FastRun::cut(Levels::run(&slopes.levels, row, right).at), by: slopes.by }
    }

    #[inline(always)]
    fn value(run: &FastRun) -> Self {
        Self(Levels(FastRun::PLACES.map(|place| level(run.at.into(), place.wrapping_add(FastRun::BITS)))))
    }

    #[inline(always)]
    fn step(run: &mut FastRun) {
        run.at = run.at.wrapping_add(run.by);
    }
}

macro_rules! packed {
    ($($color:ty),*) => {
        $(
            #[cfg(embedded_raster_vectors)]
            by_levels!($color, [u8; 3], |c| [c.r(), c.g(), c.b()], |[r, g, b]| Self::new(r, g, b));
            #[cfg(not(embedded_raster_vectors))]
            by_levels!($color, Levels, |c| Levels([c.r(), c.g(), c.b()]), |Levels([r, g, b])| Self::new(r, g, b));
            by_levels!(
                Fast<$color>,
                Fast<Levels>,
                |c| Fast(Levels([c.0.r(), c.0.g(), c.0.b()])),
                |Fast(Levels([r, g, b]))| Self(<$color>::new(r, g, b))
            );
        )*
    };
}

macro_rules! bytes {
    ($($color:ty),*) => {
        $(
            by_levels!($color, [u8; 3], |c| [c.r(), c.g(), c.b()], |[r, g, b]| Self::new(r, g, b));
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
            fn mix(mean: &impl Fn([i32; 3]) -> i32, corners: [Self; 3]) -> Self {
                let $l = Mix::mix(mean, corners.map(|$c| $split));
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

packed!(Rgb332, Rgb444, Rgb555, Rgb565, Bgr555, Bgr565);
bytes!(Rgb666, Rgb888, Xrgb8888, Bgr666, Bgr888);
gray!(Gray2, Gray4, Gray8);

macro_rules! mixes {
    ($($rgb:ty),*; $($gray:ty),*) => {
        $(mix! { $rgb, |c| [c.r(), c.g(), c.b()], |[r, g, b]| Self::new(r, g, b); })*
        $(mix! { $gray, |c| c.luma(), |luma| Self::new(luma); })*
    };
}

mixes!(Rgb332, Rgb444, Rgb555, Rgb565, Rgb666, Rgb888, Xrgb8888, Bgr555, Bgr565, Bgr666, Bgr888; Gray2, Gray4, Gray8);
