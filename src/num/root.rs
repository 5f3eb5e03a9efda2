//! Square roots, without floats and without a wide division.
//!
//! Sources: the digit-by-digit method, T. R. Crenshaw, "Integer Square Roots", Embedded Systems Programming, 1998; P. Zimmermann,
//! "Karatsuba Square Root", INRIA, 1999 (the lower half by a division).

use core::num::NonZeroU32;

use super::cast::{low_u32, signed_wide};
use crate::tune::DIVIDES;

/// `floor(sqrt(n))`.
#[inline(never)]
pub(crate) fn square_root(n: u64) -> u32 {
    #[cfg(test)]
    super::tally::add(super::tally::Work::Root);
    if DIVIDES {
        by_halves(n)
    } else {
        by_digits(n)
    }
}

/// Two bits of `n` at a time.
#[inline(always)]
fn by_digits(n: u64) -> u32 {
    let (mut rest, mut root) = (n, 0_u64);
    // The largest power of 4 that is not larger than n. For n = 0 any power will do.
    let mut bit = 1_u64 << (63_u32.wrapping_sub(n.leading_zeros()) & 0b11_1110);
    while bit != 0 {
        let trial = root | bit;
        root >>= 1;
        if rest >= trial {
            rest = rest.wrapping_sub(trial);
            root |= bit;
        }
        bit >>= 2;
    }
    low_u32(root)
}

/// The upper half of the root two bits at a time, in 32 bits, and the lower half by a division.
///
/// With `n = 2^32 h + 2^16 i + j`, `s = floor(sqrt(h))` and `h = s^2 + r`, the root is `2^16 s + q`, or less by 1, where q is
/// `(2^16 r + i) / 2 s` rounded down, as long as h is 2^30 or more.
#[inline(always)]
fn by_halves(n: u64) -> u32 {
    // An even number of zeros is shifted out, and half as many bits of the root.
    let zeros = n.leading_zeros() & !1;
    let n = n.wrapping_shl(zeros);
    let (high, low) = (low_u32(n >> 32), low_u32(n));
    let (mut rest, mut root, mut bit) = (high, 0_u32, 1_u32 << 30);
    while bit != 0 {
        let trial = root | bit;
        root >>= 1;
        if rest >= trial {
            rest = rest.wrapping_sub(trial);
            root |= bit;
        }
        bit >>= 2;
    }
    // Half of (2^16 rest + i), which has 33 bits, by the root; the lost bit comes back with the remainder.
    let Some(divisor) = NonZeroU32::new(root) else { return 0 };
    let half = rest << 15 | low >> 17;
    let (q, left) = (half / divisor, half % divisor);
    let left = left << 1 | low >> 16 & 1;
    let found = (root << 16).wrapping_add(q);
    // What is left of n, which may be negative.
    let over =
        signed_wide(u64::from(left) << 16 | u64::from(low & 0xffff)) < signed_wide(u64::from(q).wrapping_mul(q.into()));
    found.wrapping_sub(u32::from(over)).wrapping_shr(zeros >> 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_rounded_down() {
        let mut squares = (0..70_000_u64).chain((0..32).map(|k| 1 << k)).chain((1..33).map(|k| (1 << k) - 1));
        assert!(squares.all(|r| square_root(r * r) == low_u32(r)), "of a square");
        for r in [1_u64, 2, 3, 255, 256, 65_535, 65_536, 0x7fff_ffff, 0x8000_0000, 0xffff_ffff] {
            assert_eq!(u64::from(square_root(r * r - 1)), r - 1, "below {r} squared");
            assert_eq!(u64::from(square_root(r * r + 1)), r, "above {r} squared");
        }
        assert_eq!(square_root(u64::MAX), u32::MAX);
        assert_eq!(square_root(0), 0);
        let mut n = 9_u64;
        for _ in 0..400_000 {
            n = n.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
            let number = n >> (n >> 3 & 63);
            assert_eq!(by_halves(number), by_digits(number), "of {number}");
            let square = (n >> 32) * (n >> 32);
            assert_eq!(by_halves(square.wrapping_sub(1)), by_digits(square.wrapping_sub(1)), "below {square}");
        }
    }
}
