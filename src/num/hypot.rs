//! Square roots and lengths, without floats and without divisions.
//!
//! Source: the digit-by-digit method, T. R. Crenshaw, "Integer Square Roots", Embedded Systems Programming, 1998.

use super::cast::low_u32;

/// `floor(sqrt(n))`, two bits of `n` at a time.
#[inline(never)]
pub(crate) fn square_root(n: u64) -> u32 {
    let (mut rest, mut root) = (n, 0_u64);
    // The largest power of 4 that may be in n; of 0 it does not matter.
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

/// `sqrt(x^2 + y^2)` rounded up, for sides below 2^40. Sides from 2^31 on lose low bits first, also rounded up.
#[inline(never)]
pub(crate) fn length_above(x: u64, y: u64) -> u64 {
    let shift = 33_u32.saturating_sub((x | y).leading_zeros());
    let up = |n: u64| (n >> shift).wrapping_add(u64::from(shift != 0));
    let (x, y) = (up(x), up(y));
    let square = x.wrapping_mul(x).wrapping_add(y.wrapping_mul(y));
    let root = u64::from(square_root(square));
    root.wrapping_add(u64::from(root.wrapping_mul(root) != square)) << shift
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
    }

    #[test]
    fn lengths_are_not_short_and_hardly_long() {
        let sides = (0..36).flat_map(|k| [1_u64 << k, (1 << k) - 1, (1 << k) + 1, 5 << k >> 2]);
        for x in sides.clone() {
            for y in sides.clone() {
                let (got, square) = (u128::from(length_above(x, y)), u128::from(x).pow(2) + u128::from(y).pow(2));
                assert!(got * got >= square, "{x}, {y}: {got} is too short");
                let less = got.saturating_sub(1 + (got >> 28));
                assert!(less * less <= square, "{x}, {y}: {got} is too long");
            }
        }
    }
}
