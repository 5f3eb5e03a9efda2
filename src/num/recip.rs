//! Reciprocals: divisions by one number of many others, and inverse square roots. Multiplications only: no chip needs a
//! divider for them, no table lies in flash, and every chip has the same results.
//!
//! **Division.** A divisor d is shifted up to m in `2^31..2^32`. Its reciprocal is stored as `v = floor((2^64 - 1) / m) - 2^32`,
//! which is exact. Any n below `2^32 d` is then divided by d in two multiplications: the high word of n, times v, is the
//! quotient or one less; the remainder says which, and is exact too. A reciprocal takes 6 multiplications of 32 bits and 3 whose
//! products have 64, without a branch; a quotient takes one of each. The long division of `num::round` goes through 32 steps.
//! ```text
//!   t  = (32 y^2 - 144 y + 210) / 99      y = m / 2^31: the best parabola for 1/y in 1..2, 1/99 off at most
//!   t  = t + t (1 - y t)                  16 bits; 1/9801 off, and rounding
//!   v1 = t + t (1 - y t)                  18 bits, rounded so that it is below 1/y
//!   v2 = v1 + v1 (1 - y v1)               33 bits, one off at most
//!   v  = v2 - high((v2 + 1) m)            the product has one of two high words: exact
//! ```
//! **Inverse square roots** take the same steps, `y + y (1 - x y^2) / 2`, from a parabola that is 1/41 off.
//!
//! Source: N. Möller and T. Granlund, "Improved division by invariant integers", IEEE Transactions on Computers 60, 2011
//! (v1 to v, and the division).

use core::num::NonZeroU32;

use super::{
    cast::{low_u32, magnitude, narrow, saturate, signed, signed_wide, unsigned},
    wide::{high_word, product},
};

/// A number to divide many others by.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) struct Divisor {
    /// The divisor times `2^shift`, in `2^31..2^32`.
    normal: u32,
    /// `floor((2^64 - 1) / normal) - 2^32`.
    inverse: u32,
    shift: u32,
}

impl Divisor {
    pub(crate) const fn new(d: NonZeroU32) -> Self {
        let shift = d.get().leading_zeros();
        let normal = d.get() << shift;
        Self { normal, inverse: reciprocal(normal), shift }
    }

    /// `floor((2^32 - 1) / d)`: the whole part of the reciprocal, as what is cut away comes to less than the next whole number.
    #[inline]
    pub(crate) const fn inverse(self) -> u32 {
        // Its highest bit, and what is left of the others.
        1_u32.wrapping_shl(self.shift) | (self.inverse >> 1).wrapping_shr(31_u32.wrapping_sub(self.shift))
    }

    const fn divisor(self) -> u32 {
        self.normal.wrapping_shr(self.shift)
    }

    /// Quotient and remainder. The caller knows that the quotient fits: `n < 2^32 d`.
    #[inline]
    pub(crate) const fn div_rem(self, n: u64) -> (u32, u32) {
        let n = n.wrapping_shl(self.shift);
        let (high, low) = (low_u32(n >> 32), low_u32(n));
        // high (2^32 + v) + low: its high word is the quotient or one less, so one more is the quotient or one more.
        let guess = product(high, self.inverse).wrapping_add(n);
        let mut quotient = low_u32(guess >> 32).wrapping_add(1);
        let mut rest = low.wrapping_sub(quotient.wrapping_mul(self.normal));
        if rest > low_u32(guess) {
            quotient = quotient.wrapping_sub(1);
            rest = rest.wrapping_add(self.normal);
        }
        if rest >= self.normal {
            quotient = quotient.wrapping_add(1);
            rest = rest.wrapping_sub(self.normal);
        }
        (quotient, rest.wrapping_shr(self.shift))
    }

    /// `n / d` rounded down, and the remainder. The caller knows that the quotient fits.
    #[inline]
    pub(crate) const fn floor(self, n: i64) -> (i32, u32) {
        // Of a negative n its complement -1 - n is divided: floor(n / d) = -1 - floor((-1 - n) / d).
        let sign = n >> 63;
        let (quotient, rest) = self.div_rem(magnitude(n ^ sign));
        let last = self.divisor().wrapping_sub(1);
        (signed(quotient) ^ narrow(sign), if sign < 0 { last.wrapping_sub(rest) } else { rest })
    }

    /// `n / d`, rounded to the nearest number, halves upwards. Stops at the ends of the range.
    #[inline]
    pub(crate) const fn nearest(self, n: i64) -> i32 {
        let size = n.unsigned_abs();
        let d = self.divisor();
        if size >> 32 >= d as u64 {
            return if n < 0 { i32::MIN } else { i32::MAX };
        }
        let (quotient, rest) = self.div_rem(size);
        let other = d.wrapping_sub(rest);
        if n < 0 {
            saturate(signed_wide(quotient as u64 + (rest > other) as u64).wrapping_neg())
        } else {
            saturate(signed_wide(quotient as u64 + (rest >= other) as u64))
        }
    }
}

/// A number with a sign to divide others by, or zero.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) struct Denominator {
    divisor: Option<Divisor>,
    is_negative: bool,
}

impl Denominator {
    pub(crate) const fn new(b: i32) -> Self {
        let divisor = match NonZeroU32::new(b.unsigned_abs()) {
            Some(d) => Some(Divisor::new(d)),
            None => None,
        };
        Self { divisor, is_negative: b < 0 }
    }

    /// `a / b`, rounded to the nearest number, halves upwards. Stops at the ends of the range; of `a / 0` it is the end on the
    /// side of `a`, and 0 of 0 / 0.
    pub(crate) const fn under(self, a: i64) -> i32 {
        // The one number without an opposite has one that is 2^-63 off: nobody sees it, but in a result beyond the range.
        let a = if self.is_negative { 0_i64.saturating_sub(a) } else { a };
        match self.divisor {
            Some(divisor) => divisor.nearest(a),
            None if a > 0 => i32::MAX,
            None if a < 0 => i32::MIN,
            None => 0,
        }
    }
}

/// `floor((2^64 - 1) / m) - 2^32` for m from `2^31` on.
pub(crate) const fn reciprocal(m: u32) -> u32 {
    // 1/y times 2^16, with x = y times 2^15.
    let x = m >> 16;
    // (144 - 32 y) / 99 times 2^16, and 210 / 99 times 2^16. The second product is at most 160 / 99 times 2^31.
    let slope = 95_325_u32.wrapping_sub(x.wrapping_mul(21_183) >> 15);
    let t = 139_016_u32.wrapping_sub(x.wrapping_mul(slope) >> 15);
    // 1 - y t times 2^31, at most 1/99 of it: 15 bits and a sign are left of it.
    let error = signed((1_u32 << 31).wrapping_sub(t.wrapping_mul(x))) >> 10;
    let t = t.wrapping_add(unsigned(signed(t).wrapping_mul(error) >> 21));
    // 2^46 / m, then 2^49 / m: twice it, less its square times m. Rounded down, as m is rounded up.
    let v0 = t >> 1;
    let v1 = (v0 << 4).wrapping_sub(high_word(v0.wrapping_mul(v0), (m >> 11) + 1)).wrapping_sub(1);
    // 2^48 - v1 m / 2, which is not negative and fits a word.
    let error = ((v1 >> 1) & (m & 1).wrapping_neg()).wrapping_sub(v1.wrapping_mul((m >> 1) + (m & 1)));
    let v2 = (v1 << 15).wrapping_add(high_word(v1, error) >> 1);
    // (2^32 + v2 + 1) m.
    let carry = v2.wrapping_mul(m).overflowing_add(m).1;
    v2.wrapping_sub(high_word(v2, m).wrapping_add(carry as u32).wrapping_add(m))
}

/// `2^46 / sqrt(m)` for m from `2^30` on: with m as a fraction x from 1/4 to 1, `1 / sqrt(x)` in 2.30, from 1 to 2.
///
/// At most 0.75 units off.
pub(crate) const fn inverse_root(m: u32) -> u32 {
    // 2.671 - 3.285 x + 1.639 x^2, times 2^14. Both products are below 2^32.
    let x = m >> 16;
    let slope = 107_655_u32.wrapping_sub(x.wrapping_mul(53_693) >> 16);
    let y = 43_759_u32.wrapping_sub(x.wrapping_mul(slope) >> 17);
    // 1 - x y^2 times 2^30, at most 1/20 of it. Then y times 2^15, 1/1100 off and below 2^16.
    let square = y.wrapping_mul(y) >> 14;
    let error = signed((1_u32 << 30).wrapping_sub(square.wrapping_mul(x))) >> 12;
    let y = unsigned(signed(y << 1).wrapping_add(signed(y).wrapping_mul(error) >> 18));
    // The same times 2^22, at most 2^13. Then y in 2.30, 2^-19 off.
    let error = high((1_u64 << 62).wrapping_sub(product(m, y.wrapping_mul(y))));
    let y = unsigned(signed(y << 15).wrapping_add(signed(y).wrapping_mul(signed(error) >> 8) >> 8));
    // The same times 2^42, at most 2^24. What is left is rounding.
    let square = low_u32(product(y, y).wrapping_add(1 << 29) >> 30);
    let error = signed(low_u32((1_u64 << 62).wrapping_sub(product(m, square)) >> 20));
    y.wrapping_add(unsigned(narrow(((y as i64).wrapping_mul(error as i64) >> 42).wrapping_add(1) >> 1)))
}

/// The inverse square root of n > 0: a number y in 2.30, from 1 to 2, and an even shift s, where `1 / sqrt(n)` is
/// `y 2^(s / 2 - 62)`.
pub(crate) const fn inverse_root_wide(n: u64) -> (u32, u32) {
    let shift = n.leading_zeros() & !1;
    (inverse_root(low_u32(n.wrapping_shl(shift) >> 32)), shift)
}

const fn high(n: u64) -> u32 {
    low_u32(n >> 32)
}

#[cfg(test)]
#[allow(
    clippy::float_arithmetic,
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the reference"
)]
mod tests {
    use super::*;

    /// The largest of what `of` says of every number of so many leading zeros or fewer, every `step`-th of them; in two
    /// threads.
    fn largest(from: u32, step: usize, of: impl Fn(u32) -> f64 + Sync) -> f64 {
        let middle = from + (u32::MAX - from) / 2;
        let part = |range: core::ops::RangeInclusive<u32>| range.step_by(step).map(&of).fold(0.0, f64::max);
        let ends = (0..1000).flat_map(|i| [from + i, u32::MAX - i]).map(&of).fold(0.0, f64::max);
        std::thread::scope(|scope| {
            let low = scope.spawn(|| part(from..=middle));
            let high = part(middle..=u32::MAX);
            low.join().expect("it does not panic").max(high).max(ends)
        })
    }

    fn reciprocals(step: usize) {
        let worst = largest(1 << 31, step, |m| {
            let wanted = u64::MAX / u64::from(m) - (1 << 32);
            wanted.abs_diff(u64::from(reciprocal(m))) as f64
        });
        assert!(worst == 0.0, "{worst} off");
    }

    fn roots(step: usize) -> f64 {
        largest(1 << 30, step, |m| (f64::from(inverse_root(m)) - 70_368_744_177_664.0 / f64::from(m).sqrt()).abs())
    }

    #[test]
    fn reciprocals_are_exact() {
        reciprocals(37);
    }

    #[test]
    #[ignore = "a minute: every number, where the other test takes every 37th"]
    fn all_reciprocals_are_exact() {
        reciprocals(1);
    }

    #[test]
    fn inverse_roots_are_as_near_as_they_say() {
        let worst = roots(37);
        assert!(worst < 0.75, "{worst} units");
    }

    #[test]
    #[ignore = "a minute: every number, where the other test takes every 37th"]
    fn all_inverse_roots_are_as_near_as_they_say() {
        let worst = roots(1);
        assert!(worst < 0.75, "{worst} units");
    }

    const ENDS: [u32; 15] = [
        1,
        2,
        3,
        7,
        255,
        256,
        65_535,
        65_536,
        65_537,
        1 << 24,
        0x7fff_ffff,
        1 << 31,
        0x8000_0001,
        u32::MAX - 1,
        u32::MAX,
    ];

    #[test]
    fn divisions_are_exact_up_to_the_last_quotient() {
        for d in ENDS.into_iter().chain((0..100).map(|i| 2_654_435_769_u32.wrapping_mul(i) >> (i % 32) | 1)) {
            let divisor = Divisor::new(NonZeroU32::new(d).unwrap());
            assert_eq!(divisor.inverse(), u32::MAX / d, "divisor {d}");
            for q in ENDS.into_iter().chain([0]) {
                for r in [0, 1, d / 2, d - 1].into_iter().filter(|&r| r < d) {
                    let n = product(q, d) + u64::from(r);
                    assert_eq!(divisor.div_rem(n), (q, r), "divisor {d}");
                    let n = signed_wide(n >> 1);
                    if q < 1 << 31 && n < i64::from(d) << 30 {
                        for n in [n, -n, -n - 1] {
                            let (q, r) = divisor.floor(n);
                            let d = i64::from(d);
                            assert_eq!((q.into(), r.into()), (n.div_euclid(d), n.rem_euclid(d)), "{n} / {d}");
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn ratios_are_the_nearest() {
        let numbers = ENDS
            .into_iter()
            .flat_map(|n| [i64::from(n), -i64::from(n), i64::from(n) << 16, i64::from(n) << 31, -(i64::from(n) << 31)]);
        for a in numbers.chain([0, i64::MIN, i64::MIN + 1, i64::MAX]) {
            for d in ENDS {
                for b in [signed(d), signed(d).wrapping_neg()].into_iter().filter(|&b| b != 0) {
                    let (sign, b128) = (i128::from(b).signum(), i128::from(b));
                    // floor(a / b + 1/2)
                    let wanted = (2 * i128::from(a) * sign + b128.abs()).div_euclid(2 * b128.abs());
                    let wanted = wanted.clamp(i32::MIN.into(), i32::MAX.into());
                    assert_eq!(i128::from(Denominator::new(b).under(a)), wanted, "{a} / {b}");
                }
            }
        }
        assert_eq!([1, 0, -1].map(|a| Denominator::new(0).under(a)), [i32::MAX, 0, i32::MIN]);
    }
}
