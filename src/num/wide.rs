//! Products of more than 64 bits.

use core::hint::black_box;

use super::cast::{low_u32, magnitude, narrow, saturate, signed, signed_wide, unsigned};
use crate::tune::LONG_PRODUCTS;

/// The product of two words.
#[inline]
pub(crate) const fn product(a: u32, b: u32) -> u64 {
    if LONG_PRODUCTS {
        (a as u64).wrapping_mul(b as u64)
    } else {
        by_halves(a, b)
    }
}

/// The same where no instruction has the high word: four products of halves. A function for products of 64 bits takes twice as long.
#[inline]
const fn by_halves(a: u32, b: u32) -> u64 {
    let ((a1, a0), (b1, b0)) = ((a >> 16, a & 0xffff), (b >> 16, b & 0xffff));
    let low = a0.wrapping_mul(b0);
    // Sums of a product of halves and one or two halves.
    let middle = a1.wrapping_mul(b0).wrapping_add(low >> 16);
    let other = a0.wrapping_mul(b1).wrapping_add(middle & 0xffff);
    let high = a1.wrapping_mul(b1).wrapping_add(middle >> 16).wrapping_add(other >> 16);
    (high as u64) << 32 | (other << 16 | low & 0xffff) as u64
}

/// The high word of a product of two words.
#[inline]
pub(crate) const fn high_word(a: u32, b: u32) -> u32 {
    if LONG_PRODUCTS {
        low_u32((a as u64).wrapping_mul(b as u64) >> 32)
    } else {
        high_by_halves(a, b)
    }
}

/// The same from products of halves. LLVM would see that this is the high half of a product of 64 bits, and call the function for those,
/// which takes twice as long; so one of the sums is hidden from it.
#[inline]
const fn high_by_halves(a: u32, b: u32) -> u32 {
    let ((a1, a0), (b1, b0)) = ((a >> 16, a & 0xffff), (b >> 16, b & 0xffff));
    let middle = black_box(a1.wrapping_mul(b0).wrapping_add(a0.wrapping_mul(b0) >> 16));
    let other = a0.wrapping_mul(b1).wrapping_add(middle & 0xffff);
    a1.wrapping_mul(b1).wrapping_add(middle >> 16).wrapping_add(other >> 16)
}

/// The product of two words with signs.
#[inline]
pub(crate) const fn signed_product(a: i32, b: i32) -> i64 {
    if LONG_PRODUCTS {
        (a as i64).wrapping_mul(b as i64)
    } else {
        with_signs(a, b)
    }
}

/// The same from the product of two words. Taken without their signs, negative ones are 2^32 too large.
#[inline]
const fn with_signs(a: i32, b: i32) -> i64 {
    let excess = unsigned(a >> 31 & b).wrapping_add(unsigned(b >> 31 & a));
    signed_wide(by_halves(unsigned(a), unsigned(b)).wrapping_sub((excess as u64) << 32))
}

/// So many times a number of several words, the lowest one first, for a factor below 2^16. Of the product, as many words.
#[inline(always)]
pub(crate) fn times_small<const N: usize>(words: [u32; N], factor: u32) -> [u32; N] {
    let mut carry = 0;
    words.map(|word| {
        let (low, high) = if LONG_PRODUCTS {
            let sum = product(word, factor).wrapping_add(u64::from(carry));
            (low_u32(sum), low_u32(sum >> 32))
        } else {
            times_half(word, factor, carry)
        };
        carry = high;
        low
    })
}

/// Both words of a product with a factor below 2^16 and a carry below 2^16, from two products of halves.
#[inline(always)]
const fn times_half(word: u32, factor: u32, carry: u32) -> (u32, u32) {
    let low = (word & 0xffff).wrapping_mul(factor).wrapping_add(carry);
    let high = (word >> 16).wrapping_mul(factor).wrapping_add(low >> 16);
    (high << 16 | low & 0xffff, high >> 16)
}

/// The same for a number of 64 bits.
#[inline(always)]
pub(crate) fn wide_times_small(n: u64, factor: u32) -> u64 {
    if LONG_PRODUCTS {
        return n.wrapping_mul(factor.into());
    }
    let [low, high] = times_small([low_u32(n), low_u32(n >> 32)], factor);
    u64::from(high) << 32 | u64::from(low)
}

/// So many times a word below 2^31, for a factor with a sign between -2^16 and 2^16.
#[inline(always)]
pub(crate) fn signed_times_small(factor: i32, n: u32) -> i64 {
    if LONG_PRODUCTS {
        signed_product(factor, signed(n))
    } else {
        halves_with_sign(factor, n)
    }
}

/// The same from products of halves.
#[inline(always)]
fn halves_with_sign(factor: i32, n: u32) -> i64 {
    let sign = i64::from(factor >> 31);
    let (low, high) = times_half(n, factor.unsigned_abs(), 0);
    (signed_wide(u64::from(high) << 32 | u64::from(low)) ^ sign).wrapping_sub(sign)
}

/// So many times a number, of which the low 64 bits are left.
#[inline(always)]
pub(crate) const fn wide_times(n: i64, factor: u32) -> i64 {
    if LONG_PRODUCTS {
        n.wrapping_mul(factor as i64)
    } else {
        wide_by_halves(n, factor)
    }
}

/// The same from products of halves.
#[inline]
const fn wide_by_halves(n: i64, factor: u32) -> i64 {
    let (high, low) = (low_u32(magnitude(n) >> 32), low_u32(magnitude(n)));
    let high = high.wrapping_mul(factor).wrapping_add(high_by_halves(low, factor));
    signed_wide((high as u64) << 32 | low.wrapping_mul(factor) as u64)
}

/// `(2^32 high + low) factor`, in the same form. The caller knows that the product fits into 96 bits.
#[inline(always)]
pub(crate) fn times((high, low): (i64, u32), factor: u32) -> (i64, u32) {
    let carry = i64::from(high_word(low, factor));
    (wide_times(high, factor).wrapping_add(carry), low.wrapping_mul(factor))
}

/// An exact sum of up to four products of two `i32`.
///
/// Four products add up to `2^64` at most, which is more than `i64` holds. But whoever rounds a sum to 32 bits has no need of the
/// largest ones. So the sum is kept modulo `2^64`, beside the sum of the products' upper 30 bits, which says whether that is
/// enough. A product costs one multiplication, an addition of two words, and one of one word.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) struct Sum {
    /// Modulo `2^64`.
    low: i64,
    /// Less than 4 off from the sum divided by `2^34`.
    high: i32,
}

impl Sum {
    pub(crate) const ZERO: Self = Self { low: 0, high: 0 };

    /// With a b more.
    #[inline(always)]
    pub(crate) const fn plus(self, a: i32, b: i32) -> Self {
        let product = (a as i64).wrapping_mul(b as i64);
        Self { low: self.low.wrapping_add(product), high: self.high.wrapping_add(narrow(product >> 34)) }
    }

    /// With a b less.
    #[inline(always)]
    pub(crate) const fn minus(self, a: i32, b: i32) -> Self {
        let product = (a as i64).wrapping_mul(b as i64);
        Self { low: self.low.wrapping_sub(product), high: self.high.wrapping_sub(narrow(product >> 34)) }
    }

    /// The sum, if it is below `2^62`, be it negative or not. Else `2^62` or a little more, with the sum's sign.
    #[inline(always)]
    pub(crate) const fn total(self) -> i64 {
        // Within the limits the sum is at most 2^62 + 2^36.
        const LIMIT: i32 = 1 << 28;
        if self.high >= LIMIT {
            1 << 62
        } else if self.high < -LIMIT {
            -1 << 62
        } else {
            self.low
        }
    }

    /// A sum of squares of up to three numbers: it is below `2^64`.
    #[inline(always)]
    pub(crate) const fn of_squares(self) -> u64 {
        magnitude(self.low)
    }

    /// The sum divided by `2^shift`, rounded to the nearest number, halves upwards, for `1 <= shift <= 30`. Stops at the ends of
    /// the range.
    #[inline(always)]
    pub(crate) const fn nearest(self, shift: u32) -> i32 {
        nearest(self.total(), shift)
    }
}

/// `n / 2^shift`, rounded to the nearest number, halves upwards, for `2 <= shift`, or `shift = 1` and n below `2^63 - 1`. Stops at
/// the ends of the range.
#[inline(always)]
pub(crate) const fn nearest(n: i64, shift: u32) -> i32 {
    saturate(n.wrapping_shr(shift.wrapping_sub(1)).wrapping_add(1) >> 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_of_halves_are_those_of_words() {
        let ends =
            [0, 1, 2, 0xfffe, 0xffff, 0x1_0000, 0x1_0001, 0x7fff_ffff, 0x8000_0000, 0x8000_0001, 0xffff_fffe, u32::MAX];
        let more = (0..500_u32).map(|i| i.wrapping_mul(0x9e37_79b1) >> (i % 31));
        let numbers: std::vec::Vec<u32> = ends.into_iter().chain(more).collect();
        for &a in &numbers {
            for &b in &numbers {
                assert_eq!(by_halves(a, b), u64::from(a) * u64::from(b), "{a} {b}");
                assert_eq!(high_by_halves(a, b), low_u32((u64::from(a) * u64::from(b)) >> 32), "{a} {b}");
                let (i, k) = (a.cast_signed(), b.cast_signed());
                assert_eq!(with_signs(i, k), i64::from(i) * i64::from(k), "{i} {k}");
                let (factor, carry) = (b & 0xffff, a >> 16);
                let sum = u64::from(a) * u64::from(factor) + u64::from(carry);
                assert_eq!(times_half(a, factor, carry), (low_u32(sum), low_u32(sum >> 32)), "{a} {factor} {carry}");
                for k in [factor.cast_signed(), -factor.cast_signed()] {
                    let n = a >> 1;
                    assert_eq!(halves_with_sign(k, n), i64::from(k) * i64::from(n), "{k} {n}");
                }
                let n = (i64::from(i) << 32) + i64::from(a ^ b);
                assert_eq!(wide_by_halves(n, b), n.wrapping_mul(b.into()), "{n} {b}");
                let (wide, factor) = (u64::from(a) << 32 | u64::from(b), b >> 16);
                assert_eq!(wide_times_small(wide, factor), wide.wrapping_mul(factor.into()), "{wide} {factor}");
            }
        }
    }

    #[test]
    fn sums_are_rounded_once() {
        let ends = [i32::MIN, i32::MIN + 1, -65_536, -3, -1, 0, 1, 2, 32_768, 65_535, i32::MAX - 1, i32::MAX];
        let mut seed = 1_u64;
        let mut number = || {
            seed = seed.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
            let bits = low_u32(seed >> 33);
            if bits.is_multiple_of(4) {
                ends[bits as usize / 4 % 12]
            } else {
                (low_u32(seed >> 20).cast_signed()) >> (bits >> 3 & 31)
            }
        };
        let mut stopped = 0;
        for _ in 0..2_000_000 {
            let factors = [(); 4].map(|()| [number(), number()]);
            let [a, b, c, d] = factors;
            let sum = Sum::ZERO.plus(a[0], a[1]).plus(b[0], b[1]).minus(c[0], c[1]).plus(d[0], d[1]);
            let [a, b, c, d] = factors.map(|[a, b]| i128::from(a) * i128::from(b));
            for shift in [1, 16, 30] {
                let wanted = (a + b - c + d + (1 << (shift - 1))) >> shift;
                let wanted = wanted.clamp(i32::MIN.into(), i32::MAX.into());
                assert_eq!(i128::from(sum.nearest(shift)), wanted, "{factors:?} / 2^{shift}");
                stopped += i32::from(wanted == i128::from(i32::MAX));
            }
        }
        assert!(stopped > 100_000, "only {stopped} are beyond the range");
        let most = Sum::ZERO.plus(i32::MIN, i32::MIN).plus(i32::MIN, i32::MIN);
        assert_eq!([most.plus(i32::MIN, i32::MIN).plus(i32::MIN, i32::MIN).nearest(30)], [i32::MAX]);
        assert_eq!(most.plus(i32::MIN, i32::MIN).of_squares(), 3 << 62);
    }

    #[test]
    fn products_keep_their_carries() {
        for high in [0_i64, 1, -1, 1 << 40, -(1 << 40) - 7] {
            for low in [0_u32, 1, 0x8000_0000, u32::MAX] {
                for factor in [0_u32, 1, 3, 1 << 20, 0x003f_ffff] {
                    let (h, l) = times((high, low), factor);
                    let wanted = ((i128::from(high) << 32) + i128::from(low)) * i128::from(factor);
                    assert_eq!((i128::from(h) << 32) + i128::from(l), wanted, "{high} {low} {factor}");
                }
            }
        }
    }
}
