//! Products of more than 64 bits.

use super::cast::{low_u32, magnitude, narrow, saturate, signed_wide};

/// `(2^32 high + low) factor`, in the same form. The caller knows that the product fits into 96 bits.
#[inline(always)]
pub(crate) fn times((high, low): (i64, u32), factor: u32) -> (i64, u32) {
    let product = u64::from(low).wrapping_mul(u64::from(factor));
    (high.wrapping_mul(i64::from(factor)).wrapping_add(signed_wide(product >> 32)), low_u32(product))
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
