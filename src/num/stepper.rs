//! Quotient and remainder stepping: `floor(n / d)` while `n` grows by the same amount at every step.
//!
//! The quotient moves by `floor(step / d)`; the remainder moves by the rest of that division, and when it reaches `d`
//! the quotient takes one more. Nothing is rounded, so nothing drifts. The remainder is stored as `r + (2^32 - d)`:
//! then "reaches d" is the carry of a 32-bit addition, one instruction for every `d` up to `2^32 - 1`.
//!
//! Source: C. Hecker, "Perspective Texture Mapping, Part II", Game Developer, 1995.

use core::num::NonZeroU32;

use super::{
    cast::{low_u32, signed, unsigned},
    round::fraction,
};

/// A running `floor(n / d)`.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) struct Stepper {
    /// `floor(n / d)` plus the caller's offset.
    pub(crate) value: i32,
    /// What every step adds to `value`.
    pub(crate) slope: i32,
    /// `n mod d + 2^32 - d`.
    rest: u32,
    /// What every step adds to the remainder, below `d`.
    rest_step: u32,
    d: u32,
}

impl Stepper {
    /// A stepper that stands still.
    pub(crate) const ZERO: Self = Self { value: 0, slope: 0, rest: 0, rest_step: 0, d: 0 };

    /// Starts at `value` with remainder `rest`; each step adds `slope` and `rest_step / d`.
    #[inline(always)]
    pub(crate) fn new(d: NonZeroU32, (value, rest): (i32, u32), (slope, rest_step): (i32, u32)) -> Self {
        Self { value, slope, rest: rest.wrapping_sub(d.get()), rest_step, d: d.get() }
    }

    /// One step on.
    #[inline(always)]
    pub(crate) fn step(&mut self) {
        let (rest, carry) = self.rest.overflowing_add(self.rest_step);
        self.value = self.value.wrapping_add(self.slope).wrapping_add(i32::from(carry));
        self.rest = if carry { rest.wrapping_sub(self.d) } else { rest };
    }
}

/// A running `floor(n / d)` in one 64-bit number: quotient above, fraction below, so that a step is one addition.
///
/// Both fractions are rounded up to multiples of 2^-32: after k steps the sum is too large by less than (k + 1) 2^-32. The
/// true value is a multiple of 1/d, so its floor is right as long as `(k + 1) d <= 2^32`: for [`Glide::steps`] steps.
///
/// Set-up divides four times more than that of a [`Stepper`]: worth it where the chip divides.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) struct Glide {
    at: u64,
    by: u64,
}

/// What the sides of a triangle walk by.
pub(crate) trait Walk: Copy {
    /// Starts at a quotient and remainder; each step adds a quotient and remainder.
    fn new(d: NonZeroU32, start: (i32, u32), step: (i32, u32)) -> Self;
    /// The quotient.
    fn value(self) -> i32;
    /// One step on.
    fn step(&mut self);
    /// Steps from set-up that are exact, at least 1.
    fn steps(d: NonZeroU32) -> i32;
}

impl Walk for Stepper {
    #[inline(always)]
    fn new(d: NonZeroU32, start: (i32, u32), step: (i32, u32)) -> Self {
        Self::new(d, start, step)
    }

    #[inline(always)]
    fn value(self) -> i32 {
        self.value
    }

    #[inline(always)]
    fn step(&mut self) {
        self.step();
    }

    #[inline(always)]
    fn steps(_: NonZeroU32) -> i32 {
        i32::MAX
    }
}

impl Walk for Glide {
    #[inline(always)]
    fn new(d: NonZeroU32, start: (i32, u32), step: (i32, u32)) -> Self {
        // A fraction rounded up to 1 carries: the sum is what is meant.
        let number = |(whole, rest): (i32, u32)| (u64::from(unsigned(whole)) << 32).wrapping_add(fraction(rest, d));
        Self { at: number(start), by: if step == (0, 0) { 0 } else { number(step) } }
    }

    #[inline(always)]
    fn value(self) -> i32 {
        signed(low_u32(self.at >> 32))
    }

    #[inline(always)]
    fn step(&mut self) {
        self.at = self.at.wrapping_add(self.by);
    }

    #[inline(always)]
    fn steps(d: NonZeroU32) -> i32 {
        if d.get() < 1 << 19 {
            8191
        } else {
            signed(u32::MAX / d).wrapping_sub(1).max(1)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stepping_is_division() {
        for d in [1_u32, 2, 3, 7, 255, 65_537, 524_287, 524_289, 5_000_011, 0x7fff_ffff, 0x8000_0000, 0xffff_ffff] {
            for (n, step) in [(0_i64, 1_i64), (5, -3), (-1, 2), (i64::from(d) - 1, i64::from(d) - 1), (0, -1)] {
                let wide = i64::from(d);
                let split = |n: i64| (n.div_euclid(wide) as i32, n.rem_euclid(wide) as u32);
                let d = NonZeroU32::new(d).unwrap();
                let mut stepper = Stepper::new(d, split(n), split(step));
                let mut glide: Glide = Walk::new(d, split(n), split(step));
                for k in 0..10_000 {
                    let wanted = (n + k * step).div_euclid(wide);
                    assert_eq!(i64::from(stepper.value), wanted, "({n} + {k} * {step}) / {d}");
                    if k < i64::from(Glide::steps(d)) {
                        assert_eq!(i64::from(glide.value()), wanted, "({n} + {k} * {step}) / {d}, by fractions");
                    }
                    stepper.step();
                    glide.step();
                }
            }
        }
    }
}
