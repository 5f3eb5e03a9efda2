//! Quotient and remainder stepping: `floor(n / d)` while `n` grows by the same amount at every step.
//!
//! At each step the quotient grows by `floor(step / d)`, and the remainder by the remainder of that division. When the
//! remainder reaches `d`, it loses `d`, and the quotient grows by one more. Nothing is rounded, so nothing drifts. The
//! remainder r is stored as `r + 2^32 - d`: then it reaches `d` when a 32-bit addition carries, which is cheap to test
//! for every `d` up to `2^32 - 1`.
//!
//! Source: C. Hecker, "Perspective Texture Mapping, Part II", Game Developer, 1995.

use core::num::NonZeroU32;

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
    /// A stepper whose steps change nothing.
    #[inline(always)]
    pub(crate) const fn still(value: i32) -> Self {
        Self { value, slope: 0, rest: 0, rest_step: 0, d: 0 }
    }

    /// Starts at `value` with remainder `rest`; each step adds `slope` and `rest_step / d`.
    #[inline(always)]
    pub(crate) fn new(d: NonZeroU32, (value, rest): (i32, u32), (slope, rest_step): (i32, u32)) -> Self {
        Self { value, slope, rest: rest.wrapping_sub(d.get()), rest_step, d: d.get() }
    }

    /// The remainder and the divisor: their ratio is what the value lacks to be exact, rounded down.
    #[inline]
    pub(crate) fn remainder(&self) -> (u32, u32) {
        (self.rest.wrapping_add(self.d), self.d)
    }

    /// Takes one step.
    #[inline(always)]
    pub(crate) fn step(&mut self) {
        let (rest, carry) = self.rest.overflowing_add(self.rest_step);
        self.value = self.value.wrapping_add(self.slope).wrapping_add(i32::from(carry));
        self.rest = if carry { rest.wrapping_sub(self.d) } else { rest };
    }
}

#[cfg(test)]
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "tests cut numbers on purpose")]
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
                for k in 0..1_000 {
                    let wanted = (n + k * step).div_euclid(wide);
                    assert_eq!(i64::from(stepper.value), wanted, "({n} + {k} * {step}) / {d}");
                    stepper.step();
                }
            }
        }
    }
}
