//! Cosine and sine by polynomials, nearly always rounded to the nearest number.
//!
//! An angle is a fraction of a turn, in units of `2^-32` turns. It is reduced to an eighth of a turn by mirroring at an
//! axis or a diagonal; so directions that are mirror images have exactly mirrored results. There, with w from 0 to 1 for
//! an eighth of a turn and y = w^2,
//! ```text
//!   sine   = w (s0 - y (s1 - y (s2 - y (s3 - y s4))))      s0 = pi/4, s1 = (pi/4)^3 / 6 ...
//!   cosine = 1 - y (c0 - y (c1 - y (c2 - y (c3 - y c4))))  c0 = (pi/4)^2 / 2, c1 = (pi/4)^4 / 24 ...
//! ```
//! The numbers are those of the series, changed a little: they are the polynomials through five zeros of a Chebyshev
//! polynomial, which spreads the error of leaving the rest of the series away evenly.
//!
//! **No direction turns back.** One unit of angle moves the tip of a vector of length `2^30` by 2 pi / 4 = 1.57 units. If
//! each coordinate is at most 0.55 units off, a tip is at most 0.55 sqrt(2) = 0.78 units off to the side; so of two different
//! angles less than half a turn apart, the second's direction is never before the first's, and never the same. Quarters and
//! eighths of a turn, where mirrored parts meet, are exact: an axis or equal coordinates. One test walks through every angle
//! of an eighth; another measures the distance from the true values, which is below 0.55.
//!
//! Source of the reduction and of the way to fit: J. F. Hart et al., "Computer Approximations", Wiley, 1968.

use super::cast::{low_u32, signed};

/// 1 in 2.30.
const ONE: i32 = 1 << 30;

/// `sqrt(1/2)` in 2.30.
const DIAGONAL: i32 = 759_250_125;

/// s0, times 2^64: high and low word.
const SINE_FIRST: [u32; 2] = [0xc90f_daa2, 0x1dac_34b8];

/// s1 to s4, times 2^35.
const SINE: [u32; 4] = [2_774_394_667, 85_569_259, 1_256_618, 10_617];

/// c0, times 2^64: high and low word.
const COSINE_FIRST: [u32; 2] = [0x4ef4_f326, 0xf8d8_c78c];

/// c1 to c4, times 2^37.
const COSINE: [u32; 4] = [2_179_004_479, 44_803_972, 493_490, 3_343];

/// Cosine and sine in 2.30 of `turn / 2^32` turns.
pub(crate) const fn cos_sin(turn: u32) -> (i32, i32) {
    let (quarter, rest) = (turn >> 30, turn & ((1 << 30) - 1));
    let (x, y) = match rest {
        0 => (ONE, 0),
        0x2000_0000 => (DIAGONAL, DIAGONAL),
        1..0x2000_0000 => in_eighth(rest),
        _ => {
            let (x, y) = in_eighth((1_u32 << 30).wrapping_sub(rest));
            (y, x)
        }
    };
    match quarter {
        0 => (x, y),
        1 => (y.wrapping_neg(), x),
        2 => (x.wrapping_neg(), y.wrapping_neg()),
        _ => (y, x.wrapping_neg()),
    }
}

/// Cosine and sine of an angle below an eighth of a turn.
const fn in_eighth(turn: u32) -> (i32, i32) {
    // w and y times 2^32; y rounded, for terms that are small, and y^2's two words, for the first one.
    let w = turn << 3;
    let square = product(w, w);
    let y = high(square);
    // w s0 - w (y ...), both times 2^64. The second is h = y ... times 2^35, and at most 0.08.
    let h = high(product(y, polynomial(y, SINE)));
    let [s0, s0_low] = SINE_FIRST;
    let first = product(w, s0).wrapping_add(product(w, s0_low) >> 32);
    let sine = first.wrapping_sub(product(w, h) >> 3);
    // y c0 - y (y ...), both times 2^64. The second is y ... times 2^37, and at most 0.016.
    let h = high(product(y, polynomial(y, COSINE)));
    let [c0, c0_low] = COSINE_FIRST;
    let (y_high, y_low) = (low_u32(square >> 32), low_u32(square));
    let first = product(y_high, c0).wrapping_add(product(y_high, c0_low) >> 32).wrapping_add(product(y_low, c0) >> 32);
    let below_one = first.wrapping_sub(product(y, h) >> 5);
    (ONE.wrapping_sub(rounded(below_one)), rounded(sine))
}

/// `a - y (b - y (c - y d))`, y times 2^32.
const fn polynomial(y: u32, [a, b, c, d]: [u32; 4]) -> u32 {
    let inner = c.wrapping_sub(high(product(y, d)));
    a.wrapping_sub(high(product(y, b.wrapping_sub(high(product(y, inner))))))
}

const fn product(a: u32, b: u32) -> u64 {
    (a as u64).wrapping_mul(b as u64)
}

/// The high word, rounded to nearest. What is rounded here is below `2^64 - 2^31`.
const fn high(n: u64) -> u32 {
    low_u32(n.wrapping_add(1 << 31) >> 32)
}

/// 2.30 of a number below 0.8 that is given times 2^64.
const fn rounded(n: u64) -> i32 {
    signed(low_u32(n.wrapping_add(1 << 33) >> 34))
}

#[cfg(test)]
#[allow(
    clippy::float_arithmetic,
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    reason = "the reference"
)]
mod tests {
    use super::*;

    /// The distance from the true values, the larger of both.
    fn error(turn: u32) -> f64 {
        let angle = f64::from(turn) / 4_294_967_296.0 * core::f64::consts::TAU;
        let (x, y) = cos_sin(turn);
        let error = |n: i32, wanted: f64| (f64::from(n) - wanted * f64::from(ONE)).abs();
        error(x, angle.cos()).max(error(y, angle.sin()))
    }

    #[test]
    fn the_error_is_below_its_bound() {
        let worst = (0..1 << 29).step_by(251).map(error).fold(0.0, f64::max);
        assert!(worst < 0.55, "{worst}");
        let worst = (0..100_000_u32).map(|i| error(i.wrapping_mul(2_654_435_769))).fold(0.0, f64::max);
        assert!(worst < 0.55, "{worst}");
    }

    /// Every angle of an eighth of a turn, in four parts at once. All others are its mirror images.
    #[test]
    fn no_direction_turns_back() {
        let part = |part: u32| {
            let mut last = cos_sin(part << 27);
            for turn in (part << 27) + 1..=(part + 1) << 27 {
                let next = cos_sin(turn);
                let cross = i64::from(last.0) * i64::from(next.1) - i64::from(last.1) * i64::from(next.0);
                assert!(cross > 0, "from {last:?} to {next:?} at {turn:#x}");
                last = next;
            }
        };
        std::thread::scope(|scope| (0..4).for_each(|i| _ = scope.spawn(move || part(i))));
    }

    #[test]
    fn eighths_have_neighbours_on_either_side() {
        for eighth in 0..8_u32 {
            let [before, at, after] = [-1, 0, 1].map(|n| cos_sin((eighth << 29).wrapping_add_signed(n)));
            for (a, b) in [(before, at), (at, after), (before, after)] {
                let cross = i64::from(a.0) * i64::from(b.1) - i64::from(a.1) * i64::from(b.0);
                assert!(cross > 0, "{a:?} to {b:?} at eighth {eighth}");
            }
        }
    }

    #[test]
    fn quarters_and_mirror_images_are_exact() {
        assert_eq!([0, 1, 2, 3].map(|q: u32| cos_sin(q << 30)), [(ONE, 0), (0, ONE), (-ONE, 0), (0, -ONE)]);
        for turn in (0..1_u32 << 30).step_by(1_234_567) {
            let (x, y) = cos_sin(turn);
            assert_eq!(cos_sin((1 << 30) - turn), (y, x));
            assert_eq!(cos_sin(turn.wrapping_neg()), (x, -y));
            assert_eq!(cos_sin(turn.wrapping_add(1 << 31)), (-x, -y));
        }
    }
}
