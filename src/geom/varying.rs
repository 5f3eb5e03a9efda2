//! [`Varying`]: what changes over a triangle from corner to corner, and [`Plane`]: its value at every pixel.
//!
//! **Exact.** A value at a pixel is the nearest one to the exact mean of the corners at the centre of the pixel, halves upwards:
//! `floor(N / D + 1/2)`, where D is twice the area of the triangle. That is a rule for one pixel; no other pixel, no window and no
//! band takes part in it. It has consequences. What is equal at all corners is constant. Nothing leaves the range of the corners.
//! Two parts of a triangle that are cut at places where the values are whole show what the whole shows.
//!
//! It is found by additions. The value is the whole part of T = (N + floor(D / 2)) / D, a multiple of 1 / D. A number S is kept that
//! is at least T, and above it by less than 1 / D: both have the same whole part. S comes from the first pixel of the box by x
//! steps to the right and y steps down, and each of them adds some excess. The largest triangles that are allowed have D below
//! 2^41.2, and x + y below 12,288 = 2^13.6.
//! - Numbers of up to 32 bits are kept with 64 bits of fraction. A step adds at most 6 units of 2^-64: 2^(2.6 + 13.6 + 41.2) is
//!   below 2^64.
//! - Along a row, numbers of 16 bits have 48 bits of fraction, which is enough for 100 pixels in the largest triangles; then they
//!   are computed anew: see [`reach`](Varying::reach). In triangles of 63 pixels, width and height together, D is below 2^27, and
//!   48 bits are enough for rows too.
//! - Bytes are kept with 56 bits of fraction, and 8 before it. A step adds less than 1 + 2 n / D units of 2^-56, with n below
//!   2^30.6 for a step, and below 2^52 for the start: 2^(13.6 + 41.2) + 2^(1 + 13.6 + 30.6) + 2^53 is below 2^56.
//! - Over triangles of 63 pixels there is a form with nothing to choose from row to row: see [`small`](super::small).
//! - Three levels of a colour of 16 bits share 128 bits, 37 for each fraction: see `paint/colors.rs`. Along a row of a large
//!   triangle, they are computed anew every few pixels, too.
//!
//! **Fast.** [`Fast`] starts each row from the same plane, and goes on in 32 bits: 16 for the fraction. A step is cut towards zero,
//! so a value that is found n pixels from the start of a row is off by at most `n 2^-16` and the half that rounding takes. It
//! does not leave the range of the corners either. Three levels of a colour of 16 bits share 64 bits then. Of two `I16F16`, a place
//! in a texture, whole bits are added: both are off by at most n and a half of them, which is `n 2^-16` too.
//!
//! Sources: J. Foley, A. van Dam, S. Feiner, J. Hughes, "Computer Graphics: Principles and Practice", 2nd edition, 1990, 16.2
//! (H. Gouraud's shading, 1971, row by row).

use core::fmt::Debug;

use fixed::types::{I16F16, I24F8};

use super::{
    facet::Facet,
    small::{NoSmall, Small, Sums},
};
use crate::num::{
    cast::{low_u16, low_u32, low_u8, signed, unsigned},
    mixed::Mixed,
    wide::wide_times_small,
};

/// What changes over a triangle: a number, a colour, or several of them in an array or a tuple.
///
/// Numbers are taken by their bits: of an `I16F16` the nearest one is the nearest multiple of 2^-16.
/// ```
/// use embedded_raster::{geom::{Facet, Plane}, PointFx};
/// let facet = Facet::new([PointFx::px(0, 0), PointFx::px(4, 0), PointFx::px(0, 4)])?;
/// let plane = Plane::new(&facet, [(0_u8, 1000_u16), (80, 1000), (0, 1000)]);
/// assert_eq!([0, 1, 2].map(|x| plane.at(x, 0)), [(10, 1000), (30, 1000), (50, 1000)]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
pub trait Varying: Copy {
    /// How it changes over a triangle.
    type Slopes: Copy + Debug;
    /// Its value in the first column of a row.
    type Row: Copy + Debug;
    /// Its value at one pixel, with what it gains from each to the next.
    type Run: Copy + Debug;
    /// How it changes over a small triangle; [`NoSmall`] if that has no form of its own.
    type Small: Small<Self::Run>;

    /// How it changes over a triangle where it has these values at the corners.
    fn slopes(facet: &Facet, corners: [Self; 3]) -> Self::Slopes;

    /// The same at the first pixel of the box of a small triangle, in the form for that, if there is one.
    #[inline(always)]
    fn small(facet: &Facet, corners: [Self; 3]) -> Option<Self::Small> {
        let _ = (facet, corners);
        None
    }

    /// A row so many pixels below the first row of the triangle's box.
    fn row(slopes: &Self::Slopes, down: u32) -> Self::Row;

    /// To the row below.
    fn below(slopes: &Self::Slopes, row: &mut Self::Row);

    /// A pixel of a row so many pixels to the right of the first column of the triangle's box.
    fn run(slopes: &Self::Slopes, row: &Self::Row, right: u32) -> Self::Run;

    /// [`run`](Self::run), where so many pixels of the row are asked for from there on: at least 1. The run is right for
    /// [`reach`](Self::reach) of them.
    #[inline(always)]
    fn stretch(slopes: &Self::Slopes, row: &Self::Row, right: u32, pixels: u32) -> Self::Run {
        let _ = pixels;
        Self::run(slopes, row, right)
    }

    /// Takes a run on that has gone through all the pixels for which it is right, where so many more are asked for.
    #[inline(always)]
    fn go_on(slopes: &Self::Slopes, run: &mut Self::Run, (right, down): (u32, u32), pixels: u32) {
        *run = Self::stretch(slopes, &Self::row(slopes, down), right, pixels);
    }

    /// The value.
    fn value(run: &Self::Run) -> Self;

    /// To the next pixel on the right.
    fn step(run: &mut Self::Run);

    /// For how many pixels a run is right, at least 1. Then another has to be made.
    #[inline(always)]
    fn reach(slopes: &Self::Slopes) -> u32 {
        let _ = slopes;
        u32::MAX
    }
}

/// The values of a [`Varying`] at all pixels of a triangle.
#[derive(Copy, Clone, Debug)]
pub struct Plane<V: Varying> {
    first: (i32, i32),
    slopes: V::Slopes,
}

impl<V: Varying> Plane<V> {
    /// With these values at the corners.
    #[inline]
    pub fn new(facet: &Facet, corners: [V; 3]) -> Self {
        Self { first: facet.first(), slopes: V::slopes(facet, corners) }
    }

    /// The value at a pixel of the triangle. Outside of the triangle's box it means nothing.
    #[inline]
    pub fn at(&self, x: i32, y: i32) -> V {
        V::value(&Rows::new(*self, y).run(x, 1))
    }

    /// Calls `f` with the values of `n` pixels of the triangle, from (x, y) to the right.
    /// ```
    /// use embedded_raster::{geom::{Facet, Plane}, PointFx};
    /// let facet = Facet::new([PointFx::px(0, 0), PointFx::px(4, 0), PointFx::px(0, 4)])?;
    /// let mut values = vec![];
    /// Plane::new(&facet, [0_u8, 80, 0]).each(0, 1, 2, |value| values.push(value));
    /// assert_eq!(values, [10, 30]);
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[inline]
    pub fn each(&self, mut x: i32, y: i32, mut n: u32, mut f: impl FnMut(V)) {
        let rows = Rows::new(*self, y);
        let mut run = rows.run(x, n.max(1));
        loop {
            let part = n.min(rows.reach());
            for _ in 0..part {
                f(V::value(&run));
                V::step(&mut run);
            }
            (x, n) = (x.wrapping_add(signed(part)), n.wrapping_sub(part));
            if n == 0 {
                return;
            }
            rows.go_on(&mut run, (x, y), n);
        }
    }

    /// For how many pixels a run is right.
    #[inline(always)]
    pub(crate) fn reach(&self) -> u32 {
        V::reach(&self.slopes).max(1)
    }

    /// The first row of the triangle's box.
    #[inline(always)]
    pub(crate) const fn top(&self) -> i32 {
        self.first.1
    }
}

impl<A: Varying, B: Varying> Plane<(A, B)> {
    /// Each by itself.
    #[inline(always)]
    pub(crate) fn split(self) -> (Plane<A>, Plane<B>) {
        let Self { first, slopes: (a, b) } = self;
        (Plane { first, slopes: a }, Plane { first, slopes: b })
    }
}

/// The rows of a plane, to be asked for from the top down.
#[derive(Copy, Clone, Debug)]
pub(crate) struct Rows<V: Varying> {
    plane: Plane<V>,
    y: i32,
    row: V::Row,
}

impl<V: Varying> Rows<V> {
    /// At the first row of a triangle's box, with these values at its corners.
    #[inline(always)]
    pub(crate) fn over(facet: &Facet, corners: [V; 3]) -> Self {
        let (first, slopes) = (facet.first(), V::slopes(facet, corners));
        let row = V::row(&slopes, 0);
        Self { plane: Plane { first, slopes }, y: first.1, row }
    }

    /// At row y.
    #[inline(always)]
    pub(crate) fn new(plane: Plane<V>, y: i32) -> Self {
        let down = unsigned(y.wrapping_sub(plane.first.1));
        Self { plane, y, row: V::row(&plane.slopes, down) }
    }

    /// To row y: the row below is one addition away.
    #[inline(always)]
    pub(crate) fn go_to(&mut self, y: i32) {
        if y == self.y.wrapping_add(1) {
            V::below(&self.plane.slopes, &mut self.row);
            self.y = y;
        } else if y != self.y {
            *self = Self::new(self.plane, y);
        }
    }

    /// The run that begins in column x of the row, where so many pixels are asked for.
    #[inline(always)]
    pub(crate) fn run(&self, x: i32, pixels: u32) -> V::Run {
        V::stretch(&self.plane.slopes, &self.row, unsigned(x.wrapping_sub(self.plane.first.0)), pixels)
    }

    /// Takes a run on that has come to a pixel, where so many more are asked for.
    #[inline(always)]
    pub(crate) fn go_on(&self, run: &mut V::Run, (x, y): (i32, i32), pixels: u32) {
        let Plane { first, ref slopes } = self.plane;
        V::go_on(slopes, run, (unsigned(x.wrapping_sub(first.0)), unsigned(y.wrapping_sub(first.1))), pixels);
    }

    /// For how many pixels a run is right.
    #[inline(always)]
    pub(crate) fn reach(&self) -> u32 {
        self.plane.reach()
    }
}

/// How a number changes over a triangle.
#[derive(Copy, Clone, Debug)]
pub struct Slopes {
    start: Mixed,
    right: Mixed,
    down: Mixed,
}

impl Slopes {
    #[inline(always)]
    fn new(facet: &Facet, corners: [i64; 3], is_wide: bool) -> Self {
        let [start, right, down] = facet.slopes(corners, is_wide);
        Self { start, right, down }
    }

    #[inline(always)]
    fn row(&self, down: u32) -> Mixed {
        self.start + self.down.times(down)
    }

    #[inline(always)]
    fn at(&self, row: Mixed, right: u32) -> Mixed {
        row + self.right.times(right)
    }
}

/// The value of a number in the first column of a row.
#[derive(Copy, Clone, Debug)]
pub struct NumberRow(Mixed);

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
    fn small(facet: &Facet, corners: [Self; 3]) -> Option<Sums<u64>> {
        let sums = facet.small_bytes(corners.map(i32::from))?;
        Some(Sums::shifted(sums, ByteSlopes::BITS - Facet::SMALL_BITS))
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
        let Some(slopes) = facet.word_slopes(corners) else { return Self::large(facet, corners) };
        let [start, right, down] =
            slopes.map(|n| Mixed { whole: 0, fraction: n << (Word::BITS.wrapping_sub(Facet::SMALL_BITS)) });
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
    const BITS: u32 = 48;
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
            fn small(facet: &Facet, corners: [Self; 3]) -> Option<Sums<u64>> {
                let sums = facet.word_slopes(corners.map(i32::from))?;
                Some(Sums::shifted(sums, Word::BITS - Facet::SMALL_BITS))
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

/// A varying in its fast mode: in 32 bits along each row. The values of some pixels are not the nearest ones: see the
/// [module](self).
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Fast<V>(pub V);

/// A number of up to 16 bits, in 32 bits.
#[derive(Copy, Clone, Debug)]
pub struct Short {
    at: u32,
    by: u32,
}

impl Short {
    #[inline(always)]
    pub(crate) fn new(slopes: &Slopes, row: Mixed, right: u32) -> Self {
        let cut = |n: Mixed| low_u32(n.cut(16) >> 32);
        // Towards zero, so that no value gets away from where the row began by more than it should.
        let up = u32::from(slopes.right.whole < 0);
        Self { at: cut(slopes.at(row, right)), by: cut(slopes.right).wrapping_add(up) }
    }

    #[inline(always)]
    pub(crate) fn value(self) -> u32 {
        self.at >> 16
    }

    #[inline(always)]
    pub(crate) fn step(&mut self) {
        self.at = self.at.wrapping_add(self.by);
    }
}

macro_rules! fast {
    ($($type:ty, |$n:ident| $value:expr;)*) => {
        $(impl Varying for Fast<$type> {
            type Slopes = Slopes;
            type Row = NumberRow;
            type Run = Short;
            type Small = NoSmall;

            #[inline(always)]
            fn slopes(facet: &Facet, corners: [Self; 3]) -> Slopes {
                Slopes::new(facet, corners.map(|n| n.0.into()), false)
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
            fn run(slopes: &Slopes, row: &NumberRow, right: u32) -> Short {
                Short::new(slopes, row.0, right)
            }

            #[inline(always)]
            fn value(run: &Short) -> Self {
                let $n = run.value();
                Self($value)
            }

            #[inline(always)]
            fn step(run: &mut Short) {
                run.step();
            }
        })*
    };
}

fast! {
    u8, |n| low_u8(n);
    u16, |n| low_u16(n);
    i16, |n| low_i16(signed(n));
}

/// Two numbers of 32 bits at one pixel as one of 64, and what is added to it: the first one, and `2^32` times the second.
///
/// So the high word is the second number, or one less where the first is negative. Two separate numbers would take too many
/// registers: of each the compiler keeps four values, as the loop does four pixels in a turn.
#[derive(Copy, Clone, Debug)]
pub struct Pair {
    at: u64,
    by: u64,
}

impl Pair {
    #[inline(always)]
    pub(crate) fn new([first, second]: [i32; 2], [first_by, second_by]: [i32; 2]) -> Self {
        let join = |low: i32, high: i32| i64::from(high).wrapping_shl(32).wrapping_add(low.into()).cast_unsigned();
        Self { at: join(first, second), by: join(first_by, second_by) }
    }

    #[inline(always)]
    pub(crate) fn value(self) -> [i32; 2] {
        let (low, high) = (low_u32(self.at), low_u32(self.at >> 32));
        [signed(low), signed(high.wrapping_add(low >> 31))]
    }

    #[inline(always)]
    pub(crate) fn step(&mut self) {
        self.at = self.at.wrapping_add(self.by);
    }
}

impl Varying for Fast<(I16F16, I16F16)> {
    type Slopes = [Slopes; 2];
    type Row = [NumberRow; 2];
    type Run = Pair;
    type Small = NoSmall;

    #[inline(always)]
    fn slopes(facet: &Facet, corners: [Self; 3]) -> [Slopes; 2] {
        let of = |number: fn(Self) -> I16F16| Slopes::new(facet, corners.map(|n| number(n).to_bits().into()), true);
        [of(|n| n.0 .0), of(|n| n.0 .1)]
    }

    #[inline(always)]
    fn row([first, second]: &[Slopes; 2], down: u32) -> [NumberRow; 2] {
        [NumberRow(first.row(down)), NumberRow(second.row(down))]
    }

    #[inline(always)]
    fn below([first, second]: &[Slopes; 2], [first_row, second_row]: &mut [NumberRow; 2]) {
        first_row.0 += first.down;
        second_row.0 += second.down;
    }

    #[inline(always)]
    fn run([first, second]: &[Slopes; 2], [first_row, second_row]: &[NumberRow; 2], right: u32) -> Pair {
        // Towards zero, as above.
        let by = |slopes: &Slopes| slopes.right.whole.wrapping_add((slopes.right.whole < 0).into());
        let at = [first.at(first_row.0, right).whole, second.at(second_row.0, right).whole];
        Pair::new(at, [by(first), by(second)])
    }

    #[inline(always)]
    fn value(run: &Pair) -> Self {
        let [first, second] = run.value();
        Self((I16F16::from_bits(first), I16F16::from_bits(second)))
    }

    #[inline(always)]
    fn step(run: &mut Pair) {
        run.step();
    }
}

/// The low half.
#[inline(always)]
fn low_i16(n: i32) -> i16 {
    i16::from_le_bytes(low_u16(unsigned(n)).to_le_bytes())
}

impl Varying for () {
    type Slopes = ();
    type Row = ();
    type Run = ();
    type Small = ();

    #[inline(always)]
    fn slopes(_: &Facet, _: [Self; 3]) {}

    #[inline(always)]
    fn small(_: &Facet, _: [Self; 3]) -> Option<()> {
        Some(())
    }

    #[inline(always)]
    fn row((): &(), _: u32) {}

    #[inline(always)]
    fn below((): &(), (): &mut ()) {}

    #[inline(always)]
    fn run((): &(), (): &(), _: u32) {}

    #[inline(always)]
    fn value((): &()) {}

    #[inline(always)]
    fn step((): &mut ()) {}
}

impl<V: Varying, const N: usize> Varying for [V; N] {
    type Slopes = [V::Slopes; N];
    type Row = [V::Row; N];
    type Run = [V::Run; N];
    type Small = [V::Small; N];

    #[inline(always)]
    fn slopes(facet: &Facet, [a, b, c]: [Self; 3]) -> Self::Slopes {
        let mut rest = b.into_iter().zip(c);
        a.map(|a| {
            let (b, c) = rest.next().unwrap_or((a, a));
            V::slopes(facet, [a, b, c])
        })
    }

    #[inline(always)]
    fn small(facet: &Facet, [a, b, c]: [Self; 3]) -> Option<Self::Small> {
        let mut rest = b.into_iter().zip(c);
        let sums = a.map(|a| {
            let (b, c) = rest.next().unwrap_or((a, a));
            V::small(facet, [a, b, c])
        });
        // All of them have one, or none.
        let first = (*sums.first()?)?;
        Some(sums.map(|sums| sums.unwrap_or(first)))
    }

    #[inline(always)]
    fn row(slopes: &Self::Slopes, down: u32) -> Self::Row {
        slopes.each_ref().map(|slopes| V::row(slopes, down))
    }

    #[inline(always)]
    fn below(slopes: &Self::Slopes, row: &mut Self::Row) {
        slopes.iter().zip(row).for_each(|(slopes, row)| V::below(slopes, row));
    }

    #[inline(always)]
    fn run(slopes: &Self::Slopes, row: &Self::Row, right: u32) -> Self::Run {
        Self::stretch(slopes, row, right, 1)
    }

    #[inline(always)]
    fn stretch(slopes: &Self::Slopes, row: &Self::Row, right: u32, pixels: u32) -> Self::Run {
        let mut rows = row.iter();
        // There is one for each.
        slopes.each_ref().map(|slopes| match rows.next() {
            Some(row) => V::stretch(slopes, row, right, pixels),
            None => V::stretch(slopes, &V::row(slopes, 0), right, pixels),
        })
    }

    #[inline(always)]
    fn value(run: &Self::Run) -> Self {
        run.each_ref().map(V::value)
    }

    #[inline(always)]
    fn step(run: &mut Self::Run) {
        for run in run {
            V::step(run);
        }
    }

    #[inline(always)]
    fn reach(slopes: &Self::Slopes) -> u32 {
        slopes.iter().map(V::reach).fold(u32::MAX, u32::min)
    }
}

macro_rules! tuple {
    ($($name:ident $place:tt),*) => {
        impl<$($name: Varying),*> Varying for ($($name,)*) {
            type Slopes = ($($name::Slopes,)*);
            type Row = ($($name::Row,)*);
            type Run = ($($name::Run,)*);
            type Small = ($($name::Small,)*);

            #[inline(always)]
            fn slopes(facet: &Facet, [a, b, c]: [Self; 3]) -> Self::Slopes {
                ($($name::slopes(facet, [a.$place, b.$place, c.$place]),)*)
            }

            #[inline(always)]
            fn small(facet: &Facet, [a, b, c]: [Self; 3]) -> Option<Self::Small> {
                Some(($($name::small(facet, [a.$place, b.$place, c.$place])?,)*))
            }

            #[inline(always)]
            fn row(slopes: &Self::Slopes, down: u32) -> Self::Row {
                ($($name::row(&slopes.$place, down),)*)
            }

            #[inline(always)]
            fn below(slopes: &Self::Slopes, row: &mut Self::Row) {
                $($name::below(&slopes.$place, &mut row.$place);)*
            }

            #[inline(always)]
            fn run(slopes: &Self::Slopes, row: &Self::Row, right: u32) -> Self::Run {
                ($($name::run(&slopes.$place, &row.$place, right),)*)
            }

            #[inline(always)]
            fn stretch(slopes: &Self::Slopes, row: &Self::Row, right: u32, pixels: u32) -> Self::Run {
                ($($name::stretch(&slopes.$place, &row.$place, right, pixels),)*)
            }

            #[inline(always)]
            fn value(run: &Self::Run) -> Self {
                ($($name::value(&run.$place),)*)
            }

            #[inline(always)]
            fn step(run: &mut Self::Run) {
                $($name::step(&mut run.$place);)*
            }

            #[inline(always)]
            fn reach(slopes: &Self::Slopes) -> u32 {
                u32::MAX$(.min($name::reach(&slopes.$place)))*
            }
        }
    };
}

tuple!(A 0);
tuple!(A 0, B 1);
tuple!(A 0, B 1, C 2);
tuple!(A 0, B 1, C 2, D 3);
tuple!(A 0, B 1, C 2, D 3, E 4);
tuple!(A 0, B 1, C 2, D 3, E 4, F 5);
