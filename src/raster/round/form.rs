//! The quadratic form of an ellipse, and how its sign is followed along rows.

use core::{
    num::Wrapping,
    ops::{Add, AddAssign, BitAnd, Shr, Sub, SubAssign},
};

use super::curve::{Curve, Ellipse, Size};
use crate::{
    num::cast::{narrow, signed, unsigned},
    span::Rect,
    tune::COMPACT,
};

/// Whether what fits 32 bits is followed in 32 bits; built for size, in 64 like the others.
pub(super) const NARROW: bool = !COMPACT;

/// Numbers that the form is computed in. Results that are stored fit. On the way to them numbers may wrap, which cancels out.
pub(super) trait Number:
    Copy
    + Default
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Shr<usize, Output = Self>
    + BitAnd<Output = Self>
    + AddAssign
    + SubAssign
{
    fn of(n: i64) -> Self;
    fn times(self, other: Self) -> Self;
}

impl Number for Wrapping<i32> {
    #[inline(always)]
    fn of(n: i64) -> Self {
        Self(narrow(n))
    }

    #[inline(always)]
    fn times(self, other: Self) -> Self {
        self * other
    }
}

impl Number for Wrapping<i64> {
    #[inline(always)]
    fn of(n: i64) -> Self {
        Self(n)
    }

    #[inline(always)]
    fn times(self, other: Self) -> Self {
        self * other
    }
}

impl Number for Wrapping<i128> {
    #[inline(always)]
    fn of(n: i64) -> Self {
        Self(n.into())
    }

    // Not inlined: in 32-bit words it takes 250 bytes.
    #[inline(never)]
    fn times(self, other: Self) -> Self {
        self * other
    }
}

/// `E(u, v) = p u^2 + q v^2 - p a^2`, which is negative inside, in steps of `2^shift` units along both axes.
///
/// A step changes E by a multiple of `2^(shift + 1)`. So it is enough to follow `F = floor((E - bias) / 2^(shift + 1))`. With
/// bias 1, `F < 0` means inside or on the curve; with bias 0, it means inside.
#[derive(Copy, Clone)]
pub(super) struct Form<T> {
    p: T,
    q: T,
    aa: T,
    shift: u32,
}

impl<T: Number> Form<T> {
    /// With semi-axes a and b. For a circle all is divided by a^2, so that p = q = 1.
    #[inline(always)]
    pub(super) fn new((a, b): (i64, i64), shift: u32) -> Self {
        let square = |n: i64| T::of(n).times(T::of(n));
        let (aa, bb) = (square(a), square(b));
        let (p, q) = if a == b { (T::of(1), T::of(1)) } else { (bb, aa) };
        Self { p, q, aa, shift }
    }

    /// F, found without computing E as a whole, which would need two bits more than there are.
    #[inline(always)]
    pub(super) fn value(&self, u: i64, v: i64, bias: i64) -> T {
        let (u, v) = (T::of(u), T::of(v));
        let k = (self.shift as usize).wrapping_add(1);
        let low = T::of(2_i64.wrapping_shl(self.shift).wrapping_sub(1));
        let (uu, vv) = (u.times(u) - self.aa, v.times(v));
        let rest = self.p.times(uu & low) + self.q.times(vv & low) - T::of(bias);
        self.p.times(uu >> k) + self.q.times(vv >> k) + (rest >> k)
    }

    /// What F gains by a step along u, and by one along v.
    #[inline(always)]
    fn steps(&self, u: i64, v: i64) -> (T, T) {
        let half = 1_i64.wrapping_shl(self.shift) >> 1;
        (self.p.times(T::of(u.wrapping_add(half))), self.q.times(T::of(v.wrapping_add(half))))
    }

    /// What these two gains gain by each step.
    #[inline(always)]
    fn second(&self) -> (T, T) {
        let unit = T::of(1_i64.wrapping_shl(self.shift));
        (self.p.times(unit), self.q.times(unit))
    }
}

/// The pixels of a row on one side of the centre, counted from the centre outwards.
#[derive(Copy, Clone)]
struct Side<T> {
    /// F of the first pixel that is not counted.
    f: T,
    /// What it gains to the pixel after that.
    step: T,
    count: u32,
    /// No more are counted: pixels further out are not visible.
    max: u32,
}

impl<T: Number> Side<T> {
    /// Counts on, or back, until the first pixel that is not counted is the first one outside.
    #[inline(always)]
    fn settle(&mut self, second: T) {
        while self.f < T::default() && self.count < self.max {
            self.f += self.step;
            self.step += second;
            #[cfg(test)]
            crate::num::tally::add(crate::num::tally::Work::Step);
            self.count = self.count.wrapping_add(1);
        }
        while self.count > 0 {
            let step = self.step - second;
            let before = self.f - step;
            if before < T::default() {
                return;
            }
            (self.f, self.step) = (before, step);
            #[cfg(test)]
            crate::num::tally::add(crate::num::tally::Work::Step);
            self.count = self.count.wrapping_sub(1);
        }
    }
}

/// Counts the pixels inside on one side of the centre, from row to row downwards.
#[derive(Copy, Clone)]
pub(super) struct Follower<T> {
    side: Side<T>,
    down: T,
    second: (T, T),
}

impl<T: Number> Follower<T> {
    /// Starts at u on row v: at most `max` pixels are counted.
    #[inline(always)]
    pub(super) fn new(form: &Form<T>, (u, v): (i64, i64), bias: i64, max: u32) -> Self {
        let (step, down) = form.steps(u, v);
        let side = Side { f: form.value(u, v, bias), step, count: 0, max };
        Self { side, down, second: form.second() }
    }

    /// Pixels inside on this row; goes to the next.
    #[inline(always)]
    pub(super) fn row(&mut self) -> u32 {
        #[cfg(test)]
        crate::num::tally::add(crate::num::tally::Work::Step);
        self.side.settle(self.second.0);
        self.side.f += self.down;
        self.down += self.second.1;
        self.side.count
    }
}

/// The rows of a filled ellipse that are visible.
#[derive(Copy, Clone)]
pub(super) struct Rows<T> {
    right: Follower<T>,
    left: Follower<T>,
    /// Where both sides start to count: the right one at this pixel, the left one at the pixel before it.
    from: i32,
    /// The sum of both ends of a symmetric row.
    mirror: Option<i32>,
}

impl<T: Number> Rows<T> {
    /// From the first row of `clip` on, which lies inside of the ellipse's box.
    #[inline(always)]
    pub(super) fn new(curve: &Curve, clip: Rect) -> Self {
        let form = Form::new(curve.radii, curve.shift);
        let v = curve.v(clip.y0);
        if curve.closed {
            // It is symmetric, so one side is enough. It counts the distances that are visible on either side.
            let (from, max) = mirrored(curve, clip);
            let right = Follower::new(&form, (curve.u(from), v), 1, max);
            let sum = narrow(curve.both_ends());
            return Self { right, left: right, from, mirror: Some(sum) };
        }
        let from = curve.middle().max(clip.x0).min(clip.x1);
        let max = |a: i32, b: i32| unsigned(b.wrapping_sub(a));
        let right = Follower::new(&form, (curve.u(from), v), 0, max(from, clip.x1));
        let last = curve.u(from).wrapping_sub(1_i64.wrapping_shl(curve.shift)).wrapping_neg();
        let left = Follower::new(&form, (last, v), 1, max(clip.x0, from));
        Self { right, left, from, mirror: None }
    }

    /// First pixel and the one after the last of this row, inside of the clip for shapes that are not symmetric; goes to
    /// the next.
    #[inline(always)]
    pub(super) fn row(&mut self) -> (i32, i32) {
        let right = self.from.wrapping_add(signed(self.right.row()));
        let left = match self.mirror {
            Some(sum) => sum.wrapping_sub(right),
            None => self.from.wrapping_sub(signed(self.left.row())),
        };
        (left, right)
    }
}

/// For a symmetric ellipse: the first pixel at or right of the middle whose distance is visible on one of the sides, and
/// how many there are from it on.
#[inline(always)]
pub(super) fn mirrored(curve: &Curve, clip: Rect) -> (i32, u32) {
    let first = i64::from(curve.middle());
    let opposite = |x: i32| curve.both_ends().wrapping_sub(x.into());
    let (left_end, left_start) = (opposite(clip.x0), opposite(clip.x1));
    let (right_start, right_end) = (i64::from(clip.x0), i64::from(clip.x1));
    // On a clip across the middle one of the two starts lies left of it.
    let from = first.max(right_start).max(left_start);
    (narrow(from), unsigned(narrow(right_end.max(left_end).wrapping_sub(from))))
}

/// The rows of any ellipse, one after the other.
#[derive(Copy, Clone)]
pub(super) enum AnyRows {
    Small(Rows<Wrapping<i32>>),
    Medium(Rows<Wrapping<i64>>),
    Large(Rows<Wrapping<i128>>),
}

impl AnyRows {
    /// From the first row of `clip` on, which lies inside of the extent.
    pub(super) fn new(ellipse: &Ellipse, clip: Rect) -> Self {
        let curve = ellipse.curve();
        match curve.size() {
            Size::Small if NARROW => Self::Small(Rows::new(&curve, clip)),
            Size::Large => Self::Large(Rows::new(&curve, clip)),
            _ => Self::Medium(Rows::new(&curve, clip)),
        }
    }

    /// First pixel and the one after the last of this row, right if they are visible. Goes to the next row.
    #[inline(never)]
    pub(super) fn row(&mut self) -> (i32, i32) {
        match self {
            Self::Small(rows) => rows.row(),
            Self::Medium(rows) => rows.row(),
            Self::Large(rows) => rows.row(),
        }
    }
}
