//! Quotients, roots, cosine and sine of 16.16 numbers, each with its error in units of the last place (ulp), `2^-16` here.
//!
//! | function | error | multiplications |
//! |---|---|---|
//! | [`divide`], [`reciprocal`] | 0.5 ulp: the nearest number | 11 |
//! | [`square_root`] | 0.5 ulp: the nearest number | none, 24 steps of two bits |
//! | [`inverse_root`] | 0.52 ulp | 11 |
//! | [`cos_sin`] | 0.5001 ulp | 16 |
//!
//! No chip needs a divider for them. They are functions of all bits: where there is no result, or none that a 16.16 number holds,
//! each says what it answers. `Angle::cos_sin` has cosine and sine in 2.30.

use fixed::types::I16F16;

use super::super::Angle;
use crate::num::{
    cast::{magnitude, saturate, signed_wide},
    recip::{inverse_root_wide, Denominator},
    root,
    wide::nearest,
};

/// `a / b`, the nearest number, halves upwards. It stops at the ends of the range; so does `a / 0`, on the side of `a`. 0 / 0 is 0.
/// ```
/// use embedded_raster::geom::space::number::divide;
/// use fixed::types::I16F16;
/// let [one, three] = [1, 3].map(I16F16::from_num);
/// assert_eq!(divide(one, three).to_bits(), 21_845);
/// assert_eq!(divide(-three, I16F16::ZERO), I16F16::MIN);
/// ```
pub const fn divide(a: I16F16, b: I16F16) -> I16F16 {
    I16F16::from_bits(Denominator::new(b.to_bits()).under((a.to_bits() as i64) << 16))
}

/// `1 / x`, the nearest number, halves upwards. Of 0 and of numbers whose reciprocal is larger, it is an end of the range.
/// ```
/// use embedded_raster::geom::space::number::reciprocal;
/// use fixed::types::I16F16;
/// assert_eq!(reciprocal(I16F16::from_num(-8)), I16F16::from_num(-0.125));
/// assert_eq!(reciprocal(I16F16::ZERO), I16F16::MAX);
/// ```
pub const fn reciprocal(x: I16F16) -> I16F16 {
    divide(I16F16::ONE, x)
}

/// The square root, the nearest number. 0 of a negative number.
/// ```
/// use embedded_raster::geom::space::number::square_root;
/// use fixed::types::I16F16;
/// assert_eq!(square_root(I16F16::from_num(2)), I16F16::from_num(1.414_213_562));
/// assert_eq!(square_root(I16F16::from_num(-2)), 0);
/// ```
pub fn square_root(x: I16F16) -> I16F16 {
    // sqrt(2^-16 bits) = 2^-16 sqrt(2^16 bits)
    I16F16::from_bits(nearest_root(if x.is_negative() { 0 } else { magnitude(i64::from(x.to_bits()) << 16) }))
}

/// The square root of a whole number, rounded to the nearest one. Stops at the end of the range.
pub(crate) fn nearest_root(n: u64) -> i32 {
    let root = u64::from(root::square_root(n));
    // No root is halfway between two whole numbers: (r + 1/2)^2 = r^2 + r + 1/4.
    let rest = n.wrapping_sub(root.wrapping_mul(root));
    saturate(signed_wide(root.wrapping_add(u64::from(rest > root))))
}

/// `1 / sqrt(x)`, at most 0.52 ulp off: nearly always the nearest number. The end of the range of 0 and of negative numbers.
/// ```
/// use embedded_raster::geom::space::number::inverse_root;
/// use fixed::types::I16F16;
/// assert_eq!(inverse_root(I16F16::from_num(0.25)), 2);
/// assert_eq!(inverse_root(I16F16::from_num(2)), I16F16::from_num(0.707_106_781));
/// ```
pub const fn inverse_root(x: I16F16) -> I16F16 {
    if x.to_bits() <= 0 {
        return I16F16::MAX;
    }
    // 2^16 / sqrt(2^-16 bits) = 2^24 / sqrt(bits) = y 2^(s / 2 - 38), where s is 32 or more.
    let (y, shift) = inverse_root_wide(magnitude(x.to_bits() as i64));
    I16F16::from_bits(nearest(signed_wide(y as u64), 38_u32.wrapping_sub(shift >> 1)))
}

/// Cosine and sine, each at most 0.5001 ulp off. Quarters of a turn are exact.
/// ```
/// use embedded_raster::{geom::space::number::cos_sin, Angle};
/// use fixed::types::I16F16;
/// assert_eq!(cos_sin(Angle::degrees(60)), (I16F16::from_num(0.5), I16F16::from_num(0.866_025_404)));
/// ```
pub const fn cos_sin(angle: Angle) -> (I16F16, I16F16) {
    let (x, y) = angle.cos_sin();
    (from_2_30(x), from_2_30(y))
}

/// The nearest 16.16 number to one in 2.30, halves upwards.
pub(crate) const fn from_2_30(n: i32) -> I16F16 {
    I16F16::from_bits(nearest(n as i64, 14))
}
