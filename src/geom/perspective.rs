//! [`Perspective`]: what changes over a triangle in space as it is seen from an eye.
//!
//! What changes evenly over a triangle in space does not do so on a screen: the far half of it looks shorter. With w the distance of
//! a corner along the view, which is the w of clip space, `value / w` and `1 / w` change evenly on the screen, and their quotient
//! is the value. With a, b, c the weights of the corners on the screen (see [`facet`](super::facet)):
//! ```text
//!             a v0 / w0 + b v1 / w1 + c v2 / w2      sum of shares
//!     value = ---------------------------------  =  ---------------
//!                 a / w0 + b / w1 + c / w2              nearness
//! ```
//! **How.** The nearness of a corner is a whole number, `2^30 w / wi` with w the least of the three, rounded to the nearest. The
//! nearness at the first pixel of the box, and what it gains in a step to the right and down, are rounded once, to 2^-32. From then
//! on it is a function of the pixel alone, exact in 64 bits: no window, band or tile can change a pixel. The same holds for the share
//! of each number, which is the part of its range above the least of the three, times the nearness. A pixel takes one reciprocal of
//! its nearness, exact in 33 bits, and two products for each number.
//!
//! **Error.** Where w differs by at most a factor r over the triangle, a value is off by at most the half unit that rounding takes and
//! `r 2^-27` of the range of its corners. For bytes and r = 16 the latter is 1 / 32,000 of a step. What is equal at all corners
//! is constant, and no value leaves the range of its corners. A w that is not positive is taken for the least that is.
//!
//! **In runs.** [`Runs`] finds the value at every N-th pixel of a row and at the last one, and goes evenly in between. Over a run along
//! which w changes by a factor r, the values in between are off by at most `(sqrt(r) - 1) / (sqrt(r) + 1)` of what the value changes by
//! along the run. Runs have N pixels at most, and fewer, down to 1, where the r of one might be above 9/8: so the error is below 3 % of
//! the change. Where one run ends the next begins, so each takes one reciprocal. The first starts where a row of the window does; so
//! in a tile, values in between may differ by as much.
//!
//! Sources: J. Blinn, "Hyperbolic Interpolation", IEEE Computer Graphics and Applications 12, 1992; C. Hecker, "Perspective Texture
//! Mapping", Game Developer, 1995 (runs).

use core::{fmt::Debug, num::NonZeroU32};

use fixed::types::{I16F16, I24F8};

use super::{
    facet::Facet,
    small::NoSmall,
    varying::{Fast, Pair, Varying},
};
use crate::num::{
    cast::{low_u16, low_u32, low_u8, saturate, signed, signed_wide, unsigned},
    recip::{reciprocal, Divisor},
    wide::{high_word, product, wide_times_small},
};

/// A value, and how far away it is: changes over a triangle as it does in space, and is exact at every pixel. See the
/// [module](self).
///
/// At a pixel, w is the distance there, cut down.
/// ```
/// use embedded_raster::{geom::{Facet, Perspective, Plane}, PointFx};
/// use fixed::types::I16F16;
/// let facet = Facet::new([PointFx::px(0, 0), PointFx::px(4, 0), PointFx::px(0, 4)])?;
/// // On the right, it is three times as far away.
/// let at = |w, value: u8| Perspective { w: I16F16::from_num(w), value };
/// let plane = Plane::new(&facet, [at(1, 0), at(3, 120), at(1, 0)]);
/// assert_eq!([0, 1, 2].map(|x| plane.at(x, 0).value), [5, 20, 43]); // evenly: 15, 45, 75
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Perspective<V> {
    /// The w of clip space, positive.
    pub w: I16F16,
    /// One number, or several in an array or a tuple.
    pub value: V,
}

/// [`Perspective`] in runs of at most N pixels, of which only the first is exact, and the last of the row. See the [module](self).
///
/// N is from 2 to 64.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Runs<V, const N: u32> {
    /// The w of clip space, positive.
    pub w: I16F16,
    /// One number, or several in an array or a tuple.
    pub value: V,
}

/// What can be seen in perspective: numbers, arrays and tuples of them, and a place in a texture, `Fast<(I16F16, I16F16)>`.
pub trait Numbers: Copy {
    /// How the shares change over a triangle.
    type Shares: Copy + Debug;
    /// The shares at one pixel, with what they gain from each to the next.
    type Run: Copy + Debug;
    /// The values at an end of an even run.
    type End: Copy + Debug;
    /// The values at one pixel of an even run, with what they gain from each to the next.
    type Even: Copy + Debug;

    #[doc(hidden)]
    fn shares(facet: &Facet, corners: [Self; 3], nearness: [u32; 3]) -> Self::Shares;

    #[doc(hidden)]
    fn run(shares: &Self::Shares, pixel: Pixel) -> Self::Run;

    #[doc(hidden)]
    fn step(run: &mut Self::Run);

    #[doc(hidden)]
    fn value(run: &Self::Run, inverse: Inverse) -> Self;

    #[doc(hidden)]
    fn end(shares: &Self::Shares, pixel: Pixel, inverse: Inverse) -> Self::End;

    #[doc(hidden)]
    fn even(from: Self::End, to: Self::End, part: u32) -> Self::Even;

    #[doc(hidden)]
    fn even_value(even: &Self::Even) -> Self;

    #[doc(hidden)]
    fn even_step(even: &mut Self::Even);
}

/// How far a pixel is from the first one of the box: to the right, and down.
type Pixel = (u32, u32);

/// A number that changes evenly on the screen, in 2^-32: at the first pixel of the box, and what it gains to the right and down.
#[derive(Copy, Clone, Debug)]
pub struct Flat {
    start: u64,
    right: u64,
    down: u64,
}

impl Flat {
    /// Of whole numbers up to 2^30 at the corners: not below the true number, and above it by less than 1/2 + 2^-17 in the box.
    #[inline(never)]
    fn new(facet: &Facet, corners: [u32; 3]) -> Self {
        // The start has a half more, which is for rounding: here it is too little to matter.
        let [start, right, down] = facet.slopes(corners.map(i64::from), true).map(|n| n.cut(32).wrapping_add(1));
        Self { start, right, down }
    }

    #[inline(always)]
    fn at(&self, (right, down): Pixel) -> u64 {
        self.start.wrapping_add(wide_times_small(self.right, right)).wrapping_add(wide_times_small(self.down, down))
    }
}

/// The whole part of a number in 2^-32.
#[inline(always)]
const fn whole(n: u64) -> u32 {
    low_u32(n >> 32)
}

/// The reciprocal of a nearness d: `2^32 + v` is `floor((2^64 - 1) / (2^shift d))`.
#[derive(Copy, Clone, Debug)]
pub struct Inverse {
    v: u32,
    shift: u32,
}

impl Inverse {
    /// Of a nearness in 2^-32. It is taken 3 larger than its whole part, so that no share is larger.
    #[inline(always)]
    fn new(nearness: u64) -> Self {
        let d = whole(nearness).wrapping_add(3) | 1;
        let shift = d.leading_zeros();
        Self { v: reciprocal(d << (shift & 31)), shift }
    }

    /// How often d goes into a share that is not larger, in 2^-32; below 1.
    #[inline(always)]
    fn part(self, share: u64) -> u32 {
        let n = whole(share) << (self.shift & 31);
        n.wrapping_add(high_word(n, self.v))
    }

    /// The distance that belongs to the nearness, where `least` belongs to 2^30.
    #[inline(always)]
    fn distance(self, least: u32) -> I16F16 {
        // Both factors are below 2^33 and 2^31. The shift is from 1 to 31.
        let product = (u64::from(least) << 32).wrapping_add(product(least, self.v));
        I16F16::from_bits(saturate(signed_wide(product >> (34_u32.wrapping_sub(self.shift) & 63))))
    }
}

/// The share of one number.
#[derive(Copy, Clone, Debug)]
pub struct Share {
    flat: Flat,
    /// The least value of the corners, and how much larger the largest is.
    base: u32,
    range: u32,
}

/// The share of one number at one pixel.
#[derive(Copy, Clone, Debug)]
pub struct ShareRun {
    at: u64,
    by: u64,
    base: u32,
    range: u32,
}

impl Share {
    fn new(facet: &Facet, corners: [i64; 3], nearness: [u32; 3]) -> Self {
        let [a, b, c] = corners;
        let (least, most) = (a.min(b).min(c), a.max(b).max(c));
        // Numbers of 32 bits differ by less than 2^32.
        let above = |n: i64| low_u32(n.wrapping_sub(least).cast_unsigned());
        let shares = match NonZeroU32::new(above(most)) {
            None => [0; 3],
            Some(range) => {
                let divisor = Divisor::new(range);
                // Below 2^62; the quotient is at most the nearness.
                let share = |n: i64, nearness: u32| {
                    unsigned(divisor.nearest(signed_wide(u64::from(above(n)).wrapping_mul(nearness.into()))))
                };
                let [p, q, r] = nearness;
                [share(a, p), share(b, q), share(c, r)]
            }
        };
        Self { flat: Flat::new(facet, shares), base: low_u32(least.cast_unsigned()), range: above(most) }
    }

    #[inline(always)]
    fn run(&self, pixel: Pixel) -> ShareRun {
        ShareRun { at: self.flat.at(pixel), by: self.flat.right, base: self.base, range: self.range }
    }

    #[inline(always)]
    fn end(&self, pixel: Pixel, inverse: Inverse) -> End {
        End { above: self.run(pixel).above(inverse), base: self.base }
    }
}

impl ShareRun {
    /// How far the value is above the least, in 2^-32, and a half more. Below 2^64, and its whole part is not above the range.
    #[inline(always)]
    fn above(&self, inverse: Inverse) -> u64 {
        product(inverse.part(self.at), self.range).wrapping_add(1 << 31)
    }

    /// The nearest value, halves upwards, modulo 2^32.
    #[inline(always)]
    fn value(&self, inverse: Inverse) -> u32 {
        let part = inverse.part(self.at);
        // The highest bit of the low word is the half.
        let above = high_word(part, self.range).wrapping_add(part.wrapping_mul(self.range) >> 31);
        self.base.wrapping_add(above)
    }

    #[inline(always)]
    fn step(&mut self) {
        self.at = self.at.wrapping_add(self.by);
    }
}

/// A value at an end of an even run: how far it is above the least, in 2^-32, with a half more, and the least.
#[derive(Copy, Clone, Debug)]
pub struct End {
    above: u64,
    base: u32,
}

/// A value at one pixel of an even run, in 2^-32.
#[derive(Copy, Clone, Debug)]
pub struct Even {
    at: u64,
    by: u64,
}

/// `2^32 / k`, cut down.
const PARTS: [u32; 65] = {
    let mut parts = [u32::MAX; 65];
    let mut k = 2_u32;
    while k < 65 {
        parts[k as usize] = low_u32((1_u64 << 32) / k as u64);
        k += 1;
    }
    parts
};

/// The part of a way that one of so many even steps is, in 2^-32.
#[inline(always)]
fn part_of(steps: u32) -> u32 {
    PARTS.get(steps as usize).copied().unwrap_or(0)
}

/// What one even step from one number to another adds, cut towards zero.
#[inline(always)]
fn gain(from: u64, to: u64, part: u32) -> u64 {
    let falls = to < from;
    let way = if falls { from.wrapping_sub(to) } else { to.wrapping_sub(from) };
    let gain = product(whole(way), part).wrapping_add(high_word(low_u32(way), part).into());
    if falls {
        gain.wrapping_neg()
    } else {
        gain
    }
}

/// The same for whole numbers.
#[inline(always)]
fn whole_gain(from: u32, to: u32, part: u32) -> i32 {
    if to < from {
        signed(high_word(from.wrapping_sub(to), part)).wrapping_neg()
    } else {
        signed(high_word(to.wrapping_sub(from), part))
    }
}

macro_rules! numbers {
    ($($type:ty, |$n:ident| $wide:expr, |$bits:ident| $value:expr;)*) => {
        $(impl Numbers for $type {
            type Shares = Share;
            type Run = ShareRun;
            type End = End;
            type Even = Even;

            #[inline]
            fn shares(facet: &Facet, corners: [Self; 3], nearness: [u32; 3]) -> Share {
                Share::new(facet, corners.map(|$n| $wide), nearness)
            }

            #[inline(always)]
            fn run(shares: &Share, pixel: Pixel) -> ShareRun {
                shares.run(pixel)
            }

            #[inline(always)]
            fn step(run: &mut ShareRun) {
                run.step();
            }

            #[inline(always)]
            fn value(run: &ShareRun, inverse: Inverse) -> Self {
                let $bits = run.value(inverse);
                $value
            }

            #[inline(always)]
            fn end(shares: &Share, pixel: Pixel, inverse: Inverse) -> End {
                shares.end(pixel, inverse)
            }

            #[inline(always)]
            fn even(End { above, base }: End, to: End, part: u32) -> Even {
                Even { at: above.wrapping_add(u64::from(base) << 32), by: gain(above, to.above, part) }
            }

            #[inline(always)]
            fn even_value(even: &Even) -> Self {
                let $bits = whole(even.at);
                $value
            }

            #[inline(always)]
            fn even_step(even: &mut Even) {
                even.at = even.at.wrapping_add(even.by);
            }
        })*
    };
}

numbers! {
    u8, |n| n.into(), |bits| low_u8(bits);
    u16, |n| n.into(), |bits| low_u16(bits);
    i16, |n| n.into(), |bits| low_u16(bits).cast_signed();
    u32, |n| n.into(), |bits| bits;
    i32, |n| n.into(), |bits| signed(bits);
    I16F16, |n| n.to_bits().into(), |bits| Self::from_bits(signed(bits));
    I24F8, |n| n.to_bits().into(), |bits| Self::from_bits(signed(bits));
}

/// Along even runs both are one number.
impl Numbers for Fast<(I16F16, I16F16)> {
    type Shares = [Share; 2];
    type Run = [ShareRun; 2];
    type End = [End; 2];
    type Even = Pair;

    #[inline]
    fn shares(facet: &Facet, corners: [Self; 3], nearness: [u32; 3]) -> [Share; 2] {
        [corners.map(|n| n.0 .0), corners.map(|n| n.0 .1)].map(|corners| I16F16::shares(facet, corners, nearness))
    }

    #[inline(always)]
    fn run(shares: &[Share; 2], pixel: Pixel) -> [ShareRun; 2] {
        shares.each_ref().map(|share| share.run(pixel))
    }

    #[inline(always)]
    fn step(run: &mut [ShareRun; 2]) {
        run.iter_mut().for_each(ShareRun::step);
    }

    #[inline(always)]
    fn value([first, second]: &[ShareRun; 2], inverse: Inverse) -> Self {
        let [u, v] = [first, second].map(|run| I16F16::from_bits(signed(run.value(inverse))));
        Self((u, v))
    }

    #[inline(always)]
    fn end(shares: &[Share; 2], pixel: Pixel, inverse: Inverse) -> [End; 2] {
        shares.each_ref().map(|share| share.end(pixel, inverse))
    }

    #[inline(always)]
    fn even([u, v]: [End; 2], [u_end, v_end]: [End; 2], part: u32) -> Pair {
        let at = |end: End| signed(end.base.wrapping_add(whole(end.above)));
        let by = |from: End, to: End| whole_gain(whole(from.above), whole(to.above), part);
        Pair::new([at(u), at(v)], [by(u, u_end), by(v, v_end)])
    }

    #[inline(always)]
    fn even_value(even: &Pair) -> Self {
        <Self as Varying>::value(even)
    }

    #[inline(always)]
    fn even_step(even: &mut Pair) {
        even.step();
    }
}

impl<V: Numbers, const N: usize> Numbers for [V; N] {
    type Shares = [V::Shares; N];
    type Run = [V::Run; N];
    type End = [V::End; N];
    type Even = [V::Even; N];

    #[inline]
    fn shares(facet: &Facet, [a, b, c]: [Self; 3], nearness: [u32; 3]) -> Self::Shares {
        let mut rest = b.into_iter().zip(c);
        a.map(|a| {
            let (b, c) = rest.next().unwrap_or((a, a));
            V::shares(facet, [a, b, c], nearness)
        })
    }

    #[inline(always)]
    fn run(shares: &Self::Shares, pixel: Pixel) -> Self::Run {
        shares.each_ref().map(|shares| V::run(shares, pixel))
    }

    #[inline(always)]
    fn step(run: &mut Self::Run) {
        run.iter_mut().for_each(V::step);
    }

    #[inline(always)]
    fn value(run: &Self::Run, inverse: Inverse) -> Self {
        run.each_ref().map(|run| V::value(run, inverse))
    }

    #[inline(always)]
    fn end(shares: &Self::Shares, pixel: Pixel, inverse: Inverse) -> Self::End {
        shares.each_ref().map(|shares| V::end(shares, pixel, inverse))
    }

    #[inline(always)]
    fn even(from: Self::End, to: Self::End, part: u32) -> Self::Even {
        let mut to = to.into_iter();
        from.map(|from| V::even(from, to.next().unwrap_or(from), part))
    }

    #[inline(always)]
    fn even_value(even: &Self::Even) -> Self {
        even.each_ref().map(V::even_value)
    }

    #[inline(always)]
    fn even_step(even: &mut Self::Even) {
        even.iter_mut().for_each(V::even_step);
    }
}

macro_rules! tuple {
    ($($name:ident $place:tt),*) => {
        impl<$($name: Numbers),*> Numbers for ($($name,)*) {
            type Shares = ($($name::Shares,)*);
            type Run = ($($name::Run,)*);
            type End = ($($name::End,)*);
            type Even = ($($name::Even,)*);

            #[inline]
            fn shares(facet: &Facet, [a, b, c]: [Self; 3], nearness: [u32; 3]) -> Self::Shares {
                ($($name::shares(facet, [a.$place, b.$place, c.$place], nearness),)*)
            }

            #[inline(always)]
            fn run(shares: &Self::Shares, pixel: Pixel) -> Self::Run {
                ($($name::run(&shares.$place, pixel),)*)
            }

            #[inline(always)]
            fn step(run: &mut Self::Run) {
                $($name::step(&mut run.$place);)*
            }

            #[inline(always)]
            fn value(run: &Self::Run, inverse: Inverse) -> Self {
                ($($name::value(&run.$place, inverse),)*)
            }

            #[inline(always)]
            fn end(shares: &Self::Shares, pixel: Pixel, inverse: Inverse) -> Self::End {
                ($($name::end(&shares.$place, pixel, inverse),)*)
            }

            #[inline(always)]
            fn even(from: Self::End, to: Self::End, part: u32) -> Self::Even {
                ($($name::even(from.$place, to.$place, part),)*)
            }

            #[inline(always)]
            fn even_value(even: &Self::Even) -> Self {
                ($($name::even_value(&even.$place),)*)
            }

            #[inline(always)]
            fn even_step(even: &mut Self::Even) {
                $($name::even_step(&mut even.$place);)*
            }
        }
    };
}

tuple!(A 0);
tuple!(A 0, B 1);
tuple!(A 0, B 1, C 2);
tuple!(A 0, B 1, C 2, D 3);

/// How numbers change over a triangle that is seen in perspective.
#[derive(Copy, Clone, Debug)]
pub struct Seen<S> {
    nearness: Flat,
    /// The distance that belongs to a nearness of 2^30.
    least: u32,
    shares: S,
    reach: u32,
}

impl<S: Copy> Seen<S> {
    #[inline]
    fn new<V: Numbers<Shares = S>>(facet: &Facet, w: [I16F16; 3], values: [V; 3], most: u32) -> Self {
        let w = w.map(|w| NonZeroU32::new(unsigned(w.to_bits().max(1))).unwrap_or(NonZeroU32::MIN));
        let [a, b, c] = w;
        let least = a.min(b).min(c).get();
        let nearness = w.map(|w| unsigned(Divisor::new(w).nearest(signed_wide(u64::from(least) << 30)).max(1)));
        let (flat, shares) = (Flat::new(facet, nearness), V::shares(facet, values, nearness));
        // Along n pixels, w changes by a factor of at most 1 + n gain / nearness.
        let [p, q, r] = nearness;
        let gain = whole(signed_wide(flat.right).unsigned_abs()).saturating_add(1).saturating_mul(8);
        let mut reach = most;
        while reach > 1 && gain.saturating_mul(reach) > p.min(q).min(r) {
            reach >>= 1;
        }
        Self { nearness: flat, least, shares, reach }
    }

    #[inline(always)]
    fn inverse(&self, pixel: Pixel) -> Inverse {
        Inverse::new(self.nearness.at(pixel))
    }
}

/// Nearness and shares at one pixel.
#[derive(Copy, Clone, Debug)]
pub struct SeenRun<R> {
    nearness: u64,
    by: u64,
    least: u32,
    shares: R,
}

impl<V: Numbers> Varying for Perspective<V> {
    type Slopes = Seen<V::Shares>;
    type Row = u32;
    type Run = SeenRun<V::Run>;
    type Small = NoSmall;

    #[inline]
    fn slopes(facet: &Facet, corners: [Self; 3]) -> Self::Slopes {
        Seen::new(facet, corners.map(|c| c.w), corners.map(|c| c.value), u32::MAX)
    }

    #[inline(always)]
    fn row(_: &Self::Slopes, down: u32) -> u32 {
        down
    }

    #[inline(always)]
    fn below(_: &Self::Slopes, row: &mut u32) {
        *row = row.wrapping_add(1);
    }

    #[inline(always)]
    fn run(slopes: &Self::Slopes, row: &u32, right: u32) -> Self::Run {
        let pixel = (right, *row);
        let Seen { nearness, least, ref shares, .. } = *slopes;
        SeenRun { nearness: nearness.at(pixel), by: nearness.right, least, shares: V::run(shares, pixel) }
    }

    #[inline(always)]
    fn value(run: &Self::Run) -> Self {
        let inverse = Inverse::new(run.nearness);
        Self { w: inverse.distance(run.least), value: V::value(&run.shares, inverse) }
    }

    #[inline(always)]
    fn step(run: &mut Self::Run) {
        run.nearness = run.nearness.wrapping_add(run.by);
        V::step(&mut run.shares);
    }
}

/// The distance at the first pixel of an even run, the values at one of its pixels, both where the next run begins, and how far to the
/// right that is.
#[derive(Copy, Clone, Debug)]
pub struct EvenRun<E, F> {
    w: I16F16,
    values: E,
    next: (I16F16, F),
    right: u32,
}

impl<V: Numbers, const N: u32> Runs<V, N> {
    #[inline(always)]
    fn end(slopes: &Seen<V::Shares>, pixel: Pixel) -> (I16F16, V::End) {
        let inverse = slopes.inverse(pixel);
        (inverse.distance(slopes.least), V::end(&slopes.shares, pixel, inverse))
    }

    /// The run from a pixel on, of which distance and values are known.
    #[inline(always)]
    fn from(
        slopes: &Seen<V::Shares>,
        (w, end): (I16F16, V::End),
        (right, down): Pixel,
        pixels: u32,
    ) -> EvenRun<V::Even, V::End> {
        let steps = slopes.reach.min(pixels.wrapping_sub(1));
        let right = right.wrapping_add(steps);
        let next = Self::end(slopes, (right, down));
        EvenRun { w, values: V::even(end, next.1, part_of(steps)), next, right }
    }
}

impl<V: Numbers, const N: u32> Varying for Runs<V, N> {
    type Slopes = Seen<V::Shares>;
    type Row = u32;
    type Run = EvenRun<V::Even, V::End>;
    type Small = NoSmall;

    #[inline]
    fn slopes(facet: &Facet, corners: [Self; 3]) -> Self::Slopes {
        const { assert!(2 <= N && N <= 64, "a run has 2 to 64 pixels") };
        Seen::new(facet, corners.map(|c| c.w), corners.map(|c| c.value), N)
    }

    #[inline(always)]
    fn row(_: &Self::Slopes, down: u32) -> u32 {
        down
    }

    #[inline(always)]
    fn below(_: &Self::Slopes, row: &mut u32) {
        *row = row.wrapping_add(1);
    }

    #[inline(always)]
    fn run(slopes: &Self::Slopes, row: &u32, right: u32) -> Self::Run {
        Self::stretch(slopes, row, right, 1)
    }

    #[inline(always)]
    fn stretch(slopes: &Self::Slopes, row: &u32, right: u32, pixels: u32) -> Self::Run {
        let pixel = (right, *row);
        Self::from(slopes, Self::end(slopes, pixel), pixel, pixels)
    }

    #[inline(always)]
    fn go_on(slopes: &Self::Slopes, run: &mut Self::Run, (_, down): Pixel, pixels: u32) {
        *run = Self::from(slopes, run.next, (run.right, down), pixels);
    }

    #[inline(always)]
    fn value(run: &Self::Run) -> Self {
        Self { w: run.w, value: V::even_value(&run.values) }
    }

    #[inline(always)]
    fn step(run: &mut Self::Run) {
        V::even_step(&mut run.values);
    }

    #[inline(always)]
    fn reach(slopes: &Self::Slopes) -> u32 {
        slopes.reach
    }
}
