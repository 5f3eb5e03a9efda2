//! Divisions that say how they round, without a panic path and without the compiler's 64-bit division.

use core::{
    cmp::Ordering,
    num::{NonZeroU32, NonZeroU64},
};

use super::cast::{low_u32, signed, unsigned};
use crate::tune::{DIVIDES, WORDS};

/// Quotient rounded down and remainder in `0..d`.
#[inline(always)]
pub(crate) fn floor_div_rem(n: i32, d: NonZeroU32) -> (i32, u32) {
    // Of a negative n its complement -1 - n is divided: floor(n / d) = -1 - floor((-1 - n) / d).
    let sign = n >> 31;
    let m = unsigned(n ^ sign);
    let (q, r) = (m / d, m % d);
    (signed(q) ^ sign, if sign < 0 { d.get().wrapping_sub(1).wrapping_sub(r) } else { r })
}

/// Quotient and remainder of a wide number whose quotient fits 32 bits: `n < 2^32 d`.
///
/// One 32-bit division when `n` is small. Else two of them, digit by digit of 16 bits, where the chip divides, or 32 steps of long
/// division where it does not; computers of 64 bits just divide. No firmware links the 64-bit division of the runtime library.
#[inline(never)]
pub(crate) fn div_rem_wide(n: u64, d: NonZeroU32) -> (u32, u32) {
    if WORDS {
        let wide = NonZeroU64::from(d);
        return (low_u32(n / wide), low_u32(n % wide));
    }
    let (high, low) = (low_u32(n >> 32), low_u32(n));
    if high == 0 {
        return (low / d, low % d);
    }
    if DIVIDES {
        by_digits(n, d)
    } else {
        by_bits(high, low, d.get())
    }
}

/// D. E. Knuth, "The Art of Computer Programming" 2, section 4.3.1, algorithm D, with two digits of 16 bits.
#[inline(always)]
fn by_digits(n: u64, d: NonZeroU32) -> (u32, u32) {
    let zeros = d.leading_zeros();
    let (n, d) = (n.wrapping_shl(zeros), d.get().wrapping_shl(zeros));
    // The upper digit has its highest bit set.
    let Some(upper) = NonZeroU32::new(d >> 16) else { return (0, 0) };
    let digit = |rest: u32, next: u32| {
        let (mut q, mut r) = (rest / upper, rest % upper);
        // It is too large by 2 at most.
        while q >> 16 != 0 || q.wrapping_mul(d & 0xffff) > (r << 16 | next) {
            (q, r) = (q.wrapping_sub(1), r.wrapping_add(upper.get()));
            if r >> 16 != 0 {
                break;
            }
        }
        (q, (rest << 16 | next).wrapping_sub(q.wrapping_mul(d)))
    };
    let (high, rest) = digit(low_u32(n >> 32), low_u32(n) >> 16);
    let (low, rest) = digit(rest, low_u32(n) & 0xffff);
    (high << 16 | low, rest.wrapping_shr(zeros))
}

/// Long division: (rest, low) is shifted left bit by bit, and the bits of the quotient come into `low` from the right.
#[inline(always)]
fn by_bits(mut rest: u32, mut low: u32, d: u32) -> (u32, u32) {
    for _ in 0..32 {
        let carry = rest >> 31;
        rest = rest << 1 | low >> 31;
        low <<= 1;
        if carry != 0 || rest >= d {
            rest = rest.wrapping_sub(d);
            low |= 1;
        }
    }
    (low, rest)
}

/// `ceil((a * m - h) / b)` for `m <= b`, `h < a`, `1 <= b`: the quotient fits 32 bits as `m / b <= 1`.
#[inline(never)]
pub(crate) fn ceil_ratio(a: u32, m: u32, h: u32, b: NonZeroU32) -> u32 {
    let n = (u64::from(a) * u64::from(m)).wrapping_sub(u64::from(h));
    let (q, r) = div_rem_wide(n, b);
    q.wrapping_add(u32::from(r != 0))
}

/// `ceil(2^32 n / d)` for `n < d < 2^16`, in two 32-bit divisions.
#[inline]
pub(crate) fn fraction(n: u32, d: NonZeroU32) -> u32 {
    let (high, rest) = ((n << 16) / d, (n << 16) % d);
    let (low, rest) = ((rest << 16) / d, (rest << 16) % d);
    (high << 16 | low).wrapping_add(u32::from(rest != 0))
}

/// `n >> 8` after adding one half pixel, without overflow: the first pixel whose centre lies *right of* `n` 24.8 units.
#[inline(always)]
pub(crate) fn first_centre_after(n: i32) -> i32 {
    (n >> 8) + (n >> 7 & 1)
}

/// The first pixel whose centre lies at or right of (or below) `n` 24.8 units: `ceil((n - 128) / 256)`.
#[inline(always)]
pub(crate) fn first_centre_from(n: i32) -> i32 {
    (n >> 8) + (((n & 255) + 127) >> 8)
}

/// `a - b` for any two numbers.
#[inline(always)]
pub(crate) const fn difference(a: i32, b: i32) -> i64 {
    a as i64 - b as i64
}

/// Compares `a * b` with `c * d`, exactly, for factors of up to 32 bits and a sign.
#[inline]
pub(crate) fn compare_products((a, b): (i64, i64), (c, d): (i64, i64)) -> Ordering {
    // A sign and a magnitude below 2^64 each.
    let product = |a: i64, b: i64| (a.signum() * b.signum(), a.unsigned_abs().wrapping_mul(b.unsigned_abs()));
    let ((left_sign, left), (right_sign, right)) = (product(a, b), product(c, d));
    match left_sign.cmp(&right_sign) {
        Ordering::Equal if left_sign < 0 => right.cmp(&left),
        Ordering::Equal => left.cmp(&right),
        unequal => unequal,
    }
}

#[cfg(test)]
#[allow(clippy::cast_possible_truncation, reason = "tests cut numbers on purpose")]
mod tests {
    use super::*;

    const ENDS: [i64; 14] = [0, 1, 2, 3, 127, 128, 129, 255, 256, 65535, 65536, 0x7fff_fffe, 0x7fff_ffff, 0xffff_ffff];

    fn divisors() -> impl Iterator<Item = NonZeroU32> {
        ENDS.iter().filter_map(|&d| NonZeroU32::new(u32::try_from(d).unwrap()))
    }

    #[test]
    fn division_rounds_down_at_the_ends() {
        for n in ENDS.iter().flat_map(|&n| [n, -n, -n - 1]) {
            for d in divisors() {
                let d64 = i64::from(d.get());
                let rule = (n.div_euclid(d64), n.rem_euclid(d64));
                if let Ok(n) = i32::try_from(n) {
                    let (q, r) = floor_div_rem(n, d);
                    assert_eq!((i64::from(q), i64::from(r)), rule, "{n} / {d}");
                }
            }
        }
    }

    #[test]
    fn wide_division_is_exact_up_to_the_last_quotient() {
        for d in divisors() {
            let d64 = u64::from(d.get());
            for q in ENDS.map(i64::unsigned_abs) {
                for r in [0, 1, d64 / 2, d64 - 1].into_iter().filter(|&r| r < d64) {
                    let (got, rest) = div_rem_wide(q * d64 + r, d);
                    assert_eq!((u64::from(got), u64::from(rest)), (q, r), "divisor {d}");
                }
            }
        }
    }

    /// Each way for itself, whichever this machine takes.
    #[test]
    fn ways_of_division_agree() {
        let mut seed = 7_u64;
        let mut random = || {
            seed = seed.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
            (seed >> 32) as u32 >> (seed >> 27 & 31)
        };
        for _ in 0..400_000 {
            let Some(d) = NonZeroU32::new(random()) else { continue };
            let (q, r) = (random(), random() % d);
            let n = u64::from(q) * u64::from(d.get()) + u64::from(r);
            assert_eq!(by_digits(n, d), (q, r), "{n} / {d} by digits");
            assert_eq!(by_bits((n >> 32) as u32, n as u32, d.get()), (q, r), "{n} / {d} by bits");
        }
        for d in divisors() {
            for q in ENDS.map(i64::cast_unsigned).map(|q| q as u32) {
                let n = u64::from(q) * u64::from(d.get()) + u64::from(d.get() - 1);
                assert_eq!(by_digits(n, d), (q, d.get() - 1), "{n} / {d} by digits");
            }
        }
    }

    #[test]
    fn fractions_are_rounded_up() {
        for d in [1_u32, 2, 3, 7, 255, 256, 997, 32_768, 65_535] {
            for n in (0..d).step_by(d as usize / 50 + 1).chain([d - 1]) {
                let wanted = (u64::from(n) << 32).div_ceil(u64::from(d));
                assert_eq!(u64::from(fraction(n, NonZeroU32::new(d).unwrap())), wanted, "{n} / {d}");
            }
        }
    }

    #[test]
    fn centres() {
        for n in (-1000..1000).chain([i32::MIN, i32::MIN + 1, i32::MAX - 1, i32::MAX]) {
            let wide = i64::from(n);
            assert_eq!(i64::from(first_centre_after(n)), (wide + 128).div_euclid(256), "after {n}");
            assert_eq!(i64::from(first_centre_from(n)), (wide + 127).div_euclid(256), "from {n}");
        }
    }
}
