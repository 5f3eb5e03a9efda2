//! [`WideDivisor`]: many divisions by one number, by products with its reciprocal.
//!
//! Source: T. Granlund and P. Montgomery, "Division by Invariant Integers using Multiplication", PLDI 1994.

use super::{
    cast::{low_u32, low_u64, narrow, signed, signed_wide},
    mixed::Mixed,
    recip,
    wide::{product, signed_product},
};
use crate::tune::{COMPACT, WORDS};

/// Whether the reciprocal of a number below 2^32 is found in two digits. Otherwise it is found bit by bit.
const BY_DIGITS: bool = !COMPACT;

/// A number `d` to divide by.
///
/// With `d 2^s` from 2^63 to 2^64, `inverse` is `floor((2^127 - 1) / (d 2^s))`. It has 64 bits, the highest one set, and is
/// below `2^127 / (d 2^s)` by at most 1 + 2^-63.
#[derive(Copy, Clone, Debug)]
pub(crate) struct WideDivisor {
    d: u64,
    inverse: u64,
    /// 63 - s
    down: u32,
}

impl WideDivisor {
    /// Of a number from 1 to 2^63 - 1; 0 is taken for 1.
    #[inline]
    pub(crate) fn new(d: u64) -> Self {
        if BY_DIGITS && d >> 32 == 0 {
            let d = low_u32(d).max(1);
            let shift = d.leading_zeros();
            return Self { d: d.into(), inverse: reciprocal(d << (shift & 31)), down: 31_u32.wrapping_sub(shift) };
        }
        let d = d.max(1);
        let shift = d.leading_zeros();
        Self { d, inverse: reciprocal_wide(d << (shift & 63)), down: 63_u32.wrapping_sub(shift) }
    }

    /// `floor(n / d)`, and what remains.
    ///
    /// The product of |n| and the reciprocal, divided by `2^(127 - s)`, is below |n| / d by at most `(1 + 2^-63) / 2` as |n| is at
    /// most 2^63. So its whole part is right or 1 too small, which the remainder tells.
    #[inline]
    pub(crate) fn quotient(&self, n: i64) -> (i64, u64) {
        let m = n.unsigned_abs();
        let mut q = high_product(m, self.inverse).0 >> (self.down & 63);
        let mut r = m.wrapping_sub(q.wrapping_mul(self.d));
        if r >= self.d {
            (q, r) = (q.wrapping_add(1), r.wrapping_sub(self.d));
        }
        if n < 0 {
            q = q.wrapping_neg();
            if r != 0 {
                (q, r) = (q.wrapping_sub(1), self.d.wrapping_sub(r));
            }
        }
        (signed_wide(q), r)
    }

    /// `n / d`, rounded to the nearest number, halves upwards. The caller knows that n and half of d are below 2^63 together.
    #[inline]
    pub(crate) fn nearest(&self, n: i64) -> i64 {
        self.quotient(n.wrapping_add(signed_wide(self.d >> 1))).0
    }

    /// `n / d`: not below it, and above it by at most `3 2^-64`. Of the whole part, the low 32 bits.
    ///
    /// A remainder is below d. So its product with the reciprocal, divided by `2^(63 - s)`, is too small by less than 2 units of
    /// `2^-64`, and cutting it takes less than 1 more.
    #[inline]
    pub(crate) fn divide(&self, n: i64) -> Mixed {
        let (q, r) = self.quotient(n);
        let (high, low) = (high_product(r, self.inverse).0, r.wrapping_mul(self.inverse));
        // The high half is below 2^down, so nothing is lost on the left.
        let fraction = high.checked_shl(64_u32.wrapping_sub(self.down)).unwrap_or(0) | low >> (self.down & 63);
        Mixed { whole: narrow(q), fraction } + Mixed { whole: 0, fraction: 3 }
    }
}

impl WideDivisor {
    /// `2^bits n / d`, for up to 64 bits: not below it, and above it by less than `1 + 2^(bits - 63) |n| / d`. Of the whole part of
    /// what is wanted, what is left in 64 bits.
    ///
    /// It is |n| times the reciprocal, divided by `2^(127 - s - bits)`. The reciprocal is at most 1 + 2^-63 below the true one. For a
    /// negative n that errs upwards, as wanted; for any other n, the reciprocal plus 1 is taken.
    #[inline]
    pub(crate) fn ratio(&self, n: i64, bits: u32) -> u64 {
        let m = n.unsigned_abs();
        let (mut high, mut low) = (high_product(m, self.inverse).0, m.wrapping_mul(self.inverse));
        if n >= 0 {
            let (sum, carry) = low.overflowing_add(m);
            (high, low) = (high.wrapping_add(carry.into()), sum);
        }
        self.cut(high, low, bits, n < 0)
    }

    /// [`ratio`](Self::ratio) for a number of 32 bits.
    #[inline]
    pub(crate) fn narrow_ratio(&self, n: i32, bits: u32) -> u64 {
        let m = n.unsigned_abs();
        let times = |word: u64, more: u32| product(low_u32(word), m).wrapping_add(more.into());
        let low = times(self.inverse, if n < 0 { 0 } else { m });
        let high = times(self.inverse >> 32, low_u32(low >> 32));
        self.cut(high >> 32, high << 32 | u64::from(low_u32(low)), bits, n < 0)
    }

    /// Factors for many ratios with so many bits of fraction, up to 64, if `2^(bits + 32) / d` is below 2^64.
    #[inline]
    pub(crate) fn scale(&self, bits: u32) -> Option<Scale> {
        // The reciprocal is that number times 2^(95 - s - bits).
        let shift = self.down.wrapping_add(32).checked_sub(bits)?;
        Some(Scale { inverse: self.inverse >> (shift & 63) })
    }

    /// The product of a ratio, cut to so many bits of fraction.
    #[inline(always)]
    fn cut(&self, high: u64, low: u64, bits: u32, is_negative: bool) -> u64 {
        // 127 - s is 64 more than `down`: from 0 to 126.
        let shift = self.down.wrapping_add(64).wrapping_sub(bits);
        let cut = match shift {
            0 => low,
            1..64 => high << (64 - shift) | low >> shift,
            _ => high >> (shift & 63),
        };
        if is_negative {
            cut.wrapping_neg()
        } else {
            cut.wrapping_add(1)
        }
    }
}

/// `2^(bits + 32) / d`, too small by less than 2: for ratios without a shift and without a branch.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Scale {
    inverse: u64,
}

impl Scale {
    /// Of a number from 2^17 to 2^26, for 48 bits of fraction: as by [`WideDivisor::scale`].
    #[inline]
    pub(crate) fn small(d: u32) -> Self {
        let shift = d.leading_zeros();
        Self { inverse: reciprocal(d << (shift & 31)) >> (15_u32.wrapping_sub(shift) & 63) }
    }

    /// For so many bits less.
    #[inline(always)]
    pub(crate) const fn less(self, bits: u32) -> Self {
        Self { inverse: self.inverse >> (bits & 63) }
    }

    /// `2^bits n / d`, if the factor is below 2^63, and `more`: above the ratio by at least `more - 1 - 2^-30 |n|`, and by at most
    /// `more + 2^-30 |n|`.
    ///
    /// The halves of the factor have 31 bits, as numbers with a sign are multiplied best. What is cut away is less than 3 of the
    /// factor, and less than 1 of the product.
    #[inline(always)]
    pub(crate) fn ratio(self, n: i32, more: i64) -> u64 {
        if WORDS {
            // The product as a whole.
            let product = i128::from(n).wrapping_mul(signed_wide(self.inverse).into());
            return low_u64((product >> 32).cast_unsigned()).wrapping_add(more.cast_unsigned());
        }
        let times = |half: u64| signed_product(n, signed(low_u32(half)));
        let low = times((self.inverse & 0xffff_ffff) >> 1) >> 31;
        times(self.inverse >> 32).wrapping_add(low).wrapping_add(more).cast_unsigned()
    }

    /// `2^bits n / d` and 1, for |n| below 2^30, if the factor is below 2^63: above the ratio by more than `-2^-30 |n|`, and by at most
    /// `1 + 2^-30 |n|`.
    ///
    /// Of what the lower half of the factor gives, the high word is enough.
    #[inline(always)]
    pub(crate) fn narrow_ratio(self, n: i32) -> u64 {
        let low = signed_product(n << 1, signed(low_u32((self.inverse & 0xffff_ffff) >> 1))) >> 32;
        let high = signed_product(n, signed(low_u32(self.inverse >> 32)));
        high.wrapping_add(low.wrapping_add(1)).cast_unsigned()
    }

    /// `2^(bits - 8) n / d` and `more`: above the ratio by at least `more - 1 - 2^-39 |n|`, and by at most `more + 2^-39 |n|`.
    ///
    /// The product is one without signs: of a negative n it is 2^64 times the factor too large, which is subtracted.
    #[inline(always)]
    pub(crate) fn wide_ratio(self, n: i64, more: u64) -> u64 {
        let (high, other) = high_product(n.cast_unsigned(), self.inverse);
        let less = (n >> 63).cast_unsigned() & self.inverse;
        let cut = high.wrapping_sub(less) << 24 | u64::from(other >> 8);
        cut.wrapping_add(more)
    }
}

/// The high half of a product of 128 bits, and the word below it.
#[inline]
fn high_product(a: u64, b: u64) -> (u64, u32) {
    if WORDS {
        let product = u128::from(a).wrapping_mul(b.into());
        return (low_u64(product >> 64), low_u32(low_u64(product) >> 32));
    }
    let halves = |n: u64| (low_u32(n >> 32), low_u32(n));
    let ((a1, a0), (b1, b0)) = (halves(a), halves(b));
    // Sums of a product below 2^64 - 2^33 and one or two numbers below 2^32.
    let middle = product(a1, b0).wrapping_add(product(a0, b0) >> 32);
    let other = product(a0, b1).wrapping_add(u64::from(low_u32(middle)));
    (product(a1, b1).wrapping_add(middle >> 32).wrapping_add(other >> 32), low_u32(other))
}

/// `floor((2^127 - 1) / (2^32 d))` for a `d` whose highest bit is set, in two digits: it is `floor((2^95 - 1) / d)`.
///
/// On computers they are two divisions. Elsewhere the first digit is the reciprocal of 32 bits, cut down by one more. What is left, times
/// the whole reciprocal, is the second one, too small by less than 4.
fn reciprocal(d: u32) -> u64 {
    if WORDS {
        // The bit is set, which the compiler does not know: it would look for a division by 0.
        let (n, d) = (u64::MAX >> 1, u64::from(d | 1 << 31));
        let (high, rest) = (n / d, n % d);
        let low = (rest << 32 | 0xffff_ffff) / d;
        return high << 32 | low;
    }
    let (wide, inverse) = (u64::from(d), recip::reciprocal(d));
    let high = 1 << 31 | inverse >> 1;
    let rest = !high.wrapping_mul(d);
    let mut low = rest.wrapping_add(low_u32(product(rest, inverse) >> 32));
    let mut left = (u64::from(rest) << 32 | 0xffff_ffff).wrapping_sub(product(low, d));
    while left >= wide {
        low = low.wrapping_add(1);
        left = left.wrapping_sub(wide);
    }
    u64::from(high) << 32 | u64::from(low)
}

/// `floor((2^127 - 1) / d)` for a `d` whose highest bit is set: bit by bit.
#[inline(never)]
fn reciprocal_wide(d: u64) -> u64 {
    let (mut rest, mut q) = (u64::MAX >> 1, 0_u64);
    for _ in 0..64 {
        let carry = rest >> 63;
        rest = rest << 1 | 1;
        q <<= 1;
        if carry != 0 || rest >= d {
            rest = rest.wrapping_sub(d);
            q |= 1;
        }
    }
    q
}

#[cfg(test)]
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "tests mix widths on purpose"
)]
mod tests {
    use super::*;

    fn check(n: i64, d: u64) {
        let got = WideDivisor::new(d).divide(n);
        // With the low 32 bits of the whole part, as everything here.
        let (n, d) = (i128::from(n), i128::from(d));
        let whole = n.div_euclid(d);
        let (rest, part) = (n.rem_euclid(d), i128::from(got.fraction));
        let carry = i128::from(got.whole.wrapping_sub(whole as i32));
        assert!(carry == 0 || carry == 1, "{n} / {d}: {got:?}");
        // d (got - n / d), in 2^-64: exact, as rest 2^64 is below 2^127.
        let excess = (((carry << 64) + part) * d).wrapping_sub(rest << 64);
        let excess = if d < 1 << 60 { excess } else { excess.clamp(0, i128::MAX) };
        assert!((0..=3 * d).contains(&excess), "{n} / {d}: {got:?} is {excess} / d units too large");
    }

    #[test]
    fn quotients_are_close_from_above() {
        let ends: std::vec::Vec<u64> = (0..62).flat_map(|b| [1 << b, (1 << b) + 1, (1_u64 << b) * 3 - 1]).collect();
        for &d in &ends {
            for &n in &ends {
                for n in [n, n / d * d, (n / d * d).wrapping_sub(1), (n / d).wrapping_add(1).wrapping_mul(d)] {
                    let n = (n & (u64::MAX >> 1)) as i64;
                    check(n, d);
                    check(-n, d);
                    check(-n - 1, d);
                }
            }
            check(i64::MIN, d);
            check(i64::MAX, d);
        }
    }

    #[test]
    fn ratios_are_close_from_above() {
        let ends: std::vec::Vec<u64> = (0..42).flat_map(|b| [1 << b, (1 << b) + 1, (1_u64 << b) * 3 - 1]).collect();
        for &d in &ends {
            for n in (0..52).flat_map(|b| [1_i64 << b, (1 << b) + 1, (1 << b) * 3 - 1]).chain([0]) {
                for (n, bits) in [(n, 64), (-n, 64), (n, 56), (-n, 56), (n, 37), (-n, 37), (n, 1), (-n, 0)] {
                    let got = WideDivisor::new(d).ratio(n, bits);
                    // got - 2^bits n / d, times d; of got, 64 bits are known.
                    let exact = i128::from(n) << bits;
                    let floor = exact.div_euclid(d.into());
                    let over = i128::from(got.wrapping_sub(floor as u64));
                    let excess = over * i128::from(d) - exact.rem_euclid(d.into());
                    let most = i128::from(d) + ((i128::from(n).abs() << bits) >> 63) + 1;
                    assert!((0..=most).contains(&excess), "2^{bits} {n} / {d}: {got}, {excess} / d too large");
                    if let Ok(narrow) = i32::try_from(n) {
                        assert_eq!(WideDivisor::new(d).narrow_ratio(narrow, bits), got, "2^{bits} {n} / {d}");
                    }
                }
            }
        }
    }

    #[test]
    fn scaled_ratios_are_close_from_above() {
        let ends: std::vec::Vec<u64> = (0..42).flat_map(|b| [1 << b, (1 << b) + 1, (1_u64 << b) * 3 - 1]).collect();
        for &d in &ends {
            let Some(scale) = WideDivisor::new(d).scale(45).filter(|_| d > 1 << 14) else { continue };
            for n in (0..45).flat_map(|b| [1_i64 << b, (1 << b) + 1, (1 << b) * 3 / 2 - 1]).chain([0]) {
                for n in [n, -n] {
                    // got - 2^bits n / d, times d; of got, 64 bits are known.
                    let excess = |got: u64, bits: u32| {
                        let exact = i128::from(n) << bits;
                        let over = i128::from(got.wrapping_sub(exact.div_euclid(d.into()) as u64) as i64);
                        over * i128::from(d) - exact.rem_euclid(d.into())
                    };
                    let d = i128::from(d);
                    let part = |bits: u32| (d * i128::from(n).abs()) >> bits;
                    let wide = excess(scale.wide_ratio(n, 9), 37);
                    assert!(
                        (8 * d - part(39) - 1..=9 * d + part(39)).contains(&wide),
                        "2^37 {n} / {d}: {wide} / d too large"
                    );
                    if let Ok(narrow) = i32::try_from(n) {
                        let narrow = excess(scale.ratio(narrow, 9), 45);
                        assert!(
                            (8 * d - part(30) - 1..=9 * d + part(30)).contains(&narrow),
                            "2^45 {n} / {d}: {narrow} / d"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn small_scales_are_those_of_any_number() {
        let ends = (17..26).flat_map(|b| [0, 1, 2, 99].map(|n| (1 << b) + n)).chain([(1 << 26) - 1, 1 << 26]);
        for d in ends.chain((0..9_000).map(|i| (1 << 17) + i * 7_441)) {
            let scale = WideDivisor::new(d.into()).scale(48);
            assert_eq!(scale, Some(Scale::small(d)), "{d}");
            assert_eq!(WideDivisor::new(d.into()).scale(45), scale.map(|scale| scale.less(3)), "{d}");
        }
    }

    #[test]
    fn both_ways_to_a_reciprocal_agree() {
        let mut d = 0x8000_0000_u32;
        for i in 0..300_000_u32 {
            for d in [d, 0x8000_0000 + i, u32::MAX - i, ((0x8000 + i % 0x8000) << 16) | (0xffff - i % 3)] {
                let wide = u64::from(d) << 32;
                assert_eq!(reciprocal(d), reciprocal_wide(wide), "{d}");
                assert_eq!(u128::from(reciprocal_wide(wide)), (u128::MAX >> 1) / u128::from(wide), "{d}");
            }
            d = d.wrapping_mul(0x915f_77f5).wrapping_add(1) | 0x8000_0000;
        }
    }
}
