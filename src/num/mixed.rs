//! [`Mixed`]: numbers with 32 bits before and 64 bits after the point, to be added up many times.

use core::ops::{Add, AddAssign};

use super::{
    cast::{low_u32, signed, unsigned},
    wide::times_small,
};

/// `whole + fraction / 2^64`. Sums and products keep the low 32 bits of the whole part: a sum that ends in range is right, wherever
/// it was on its way.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Mixed {
    pub(crate) whole: i32,
    pub(crate) fraction: u64,
}

impl Mixed {
    /// A whole number.
    #[inline(always)]
    pub(crate) const fn from_whole(whole: i32) -> Self {
        Self { whole, fraction: 0 }
    }

    /// So many times as much, for n below 2^16.
    #[inline]
    pub(crate) fn times(self, n: u32) -> Self {
        let words = [low_u32(self.fraction), low_u32(self.fraction >> 32), unsigned(self.whole)];
        let [low, high, whole] = times_small(words, n);
        Self { whole: signed(whole), fraction: u64::from(high) << 32 | u64::from(low) }
    }

    /// The highest 64 bits, of which `whole` bits are before the point; cut down.
    #[inline(always)]
    pub(crate) fn cut(self, whole: u32) -> u64 {
        u64::from(unsigned(self.whole)) << 32 << (32_u32.wrapping_sub(whole) & 63) | self.fraction >> (whole & 63)
    }
}

impl Add for Mixed {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let (fraction, carry) = self.fraction.overflowing_add(other.fraction);
        Self { whole: self.whole.wrapping_add(other.whole).wrapping_add(i32::from(carry)), fraction }
    }
}

impl AddAssign for Mixed {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn exact(n: Mixed) -> i128 {
        (i128::from(n.whole) << 64) + i128::from(n.fraction)
    }

    #[test]
    fn sums_and_products_are_those_of_wide_numbers() {
        let wholes = [0, 1, -1, 255, 70_000, i32::MIN, i32::MAX];
        let fractions = [0, 1, 1 << 31, (1 << 32) - 1, 1 << 32, 1 << 63, u64::MAX];
        let numbers: std::vec::Vec<_> =
            wholes.iter().flat_map(|&whole| fractions.map(|fraction| Mixed { whole, fraction })).collect();
        let cut = |n: i128| n << 32 >> 32;
        for &a in &numbers {
            for &b in &numbers {
                assert_eq!(exact(a + b), cut(exact(a) + exact(b)), "{a:?} + {b:?}");
            }
            for n in [0, 1, 2, 3, 255, 65_534, 65_535] {
                assert_eq!(exact(a.times(n)), cut(exact(a).wrapping_mul(n.into())), "{n} times {a:?}");
            }
            for whole in [1, 8, 16, 31] {
                let wanted = exact(a) >> whole & i128::from(u64::MAX);
                assert_eq!(i128::from(a.cut(whole)), wanted, "{a:?} with {whole} bits");
            }
        }
    }
}
