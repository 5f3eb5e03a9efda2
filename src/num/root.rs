//! Square roots, without floats and without divisions.
//!
//! Source: the digit-by-digit method, T. R. Crenshaw, "Integer Square Roots", Embedded Systems Programming, 1998.

use super::cast::low_u32;

/// `floor(sqrt(n))`, two bits of `n` at a time.
#[inline(never)]
pub(crate) fn square_root(n: u64) -> u32 {
    #[cfg(test)]
    super::tally::add(super::tally::Work::Root);
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
}
