//! [`Angle`]: a fraction of a turn.

use core::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

use fixed::types::I16F16;

use crate::num::{
    cast::{low_u32, signed, unsigned},
    trig::cos_sin,
};

/// A direction: 0 points to the right, and angles grow clockwise as seen on the screen, where y points down.
///
/// It is stored as a number of units of `2^-32` turns. A whole turn is `2^32` units, one more than the largest `u32`,
/// so arithmetic that wraps around at the end of `u32` wraps around at a whole turn: sums, differences and products are
/// exact, and whole turns drop out of them.
/// ```
/// use embedded_raster::geom::Angle;
/// assert_eq!(Angle::degrees(90), Angle::turns(1, 4));
/// assert_eq!(Angle::degrees(-90), Angle::from_bits(3 << 30));
/// assert_eq!(Angle::turns(1, 4).cos_sin(), (0, 1 << 30)); // straight down
///
/// let quarter = Angle::degrees(90);
/// assert_eq!(quarter - Angle::degrees(180), -quarter);
/// assert_eq!(-quarter, Angle::degrees(270));
/// assert_eq!(quarter * 5, quarter);
/// ```
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Angle(u32);

impl Angle {
    /// In units of `2^-32` turns.
    #[inline]
    pub const fn from_bits(bits: u32) -> Self {
        Self(bits)
    }

    /// In units of `2^-32` turns.
    #[inline]
    pub const fn to_bits(self) -> u32 {
        self.0
    }

    /// The fraction `n / d` of a turn, rounded down to a whole number of units of `2^-32` turns; 0 if `d` is 0.
    ///
    /// Where `d` is a power of two nothing is rounded. Whole turns drop out: of 5/4 turns 1/4 is left.
    /// ```
    /// use embedded_raster::geom::Angle;
    /// assert_eq!(Angle::turns(3, 8).to_bits(), 3 << 29);
    /// assert_eq!(Angle::turns(1, 3).to_bits(), 0x5555_5555);
    /// ```
    pub const fn turns(n: u32, d: u16) -> Self {
        if d == 0 {
            return Self(0);
        }
        // Two steps of long division: the remainders are below 2^16.
        let d = d as u32;
        let rest = n % d;
        let (high, rest) = ((rest << 16) / d, (rest << 16) % d);
        let low = (rest << 16) / d;
        Self((high << 16) | low)
    }

    /// In whole degrees, rounded to the nearest unit of `2^-32` turns. Any number: whole turns drop out.
    pub const fn degrees(degrees: i32) -> Self {
        let d = unsigned(degrees % 360 + 360) % 360;
        // 2^32 / 360 = 11,930,464 + 32 / 45
        Self(d.wrapping_mul(11_930_464).wrapping_add((d * 32 + 22) / 45))
    }

    /// In degrees and fractions of degrees, rounded to the nearest unit of `2^-32` turns.
    /// ```
    /// use embedded_raster::geom::Angle;
    /// use fixed::types::I16F16;
    /// assert_eq!(Angle::degrees_fx(I16F16::from_num(22.5)), Angle::turns(1, 16));
    /// assert_eq!(Angle::degrees_fx(I16F16::from_num(-0.75)), Angle::turns(479, 480));
    /// ```
    pub const fn degrees_fx(degrees: I16F16) -> Self {
        // A bit of I16F16 is 2^32 / (360 * 2^16) = 8192 / 45 units. The quotient by 45 goes first, so that the rest
        // times 8192 fits; 45 is odd, so nothing is halfway between two units.
        const TURN: i32 = 360 << 16;
        let bits = unsigned((degrees.to_bits() % TURN).wrapping_add(TURN) % TURN);
        Self((bits / 45).wrapping_mul(8192).wrapping_add(((bits % 45) * 8192 + 22) / 45))
    }

    /// In degrees, from 0 to below 360, rounded to the nearest 1/65,536 degree.
    ///
    /// What is nearest to a whole turn is 0. For any `d`, `Angle::degrees_fx(d).to_degrees()` is `d` again, but for
    /// whole turns.
    /// ```
    /// use embedded_raster::geom::Angle;
    /// use fixed::types::I16F16;
    /// assert_eq!(Angle::turns(1, 16).to_degrees(), I16F16::from_num(22.5));
    /// assert_eq!(Angle::degrees(-1).to_degrees(), I16F16::from_num(359));
    /// assert_eq!(Angle::from_bits(u32::MAX).to_degrees(), 0);
    /// ```
    pub const fn to_degrees(self) -> I16F16 {
        // 360 * 2^16 bits are 2^32 units: bits = 360 units / 2^16, at most 360 * 2^16, a whole turn.
        let bits = low_u32(((self.0 as u64) * 360 + (1 << 15)) >> 16);
        I16F16::from_bits(if bits == 360 << 16 { 0 } else { signed(bits) })
    }

    /// Cosine and sine in units of `2^-30`, each at most 0.55 of these units off. Where they come from is told in
    /// `num::trig`.
    ///
    /// No direction turns back: of two angles, the later one is clockwise from the earlier one, be it by one unit only. Quarters of
    /// a turn are exact, and eighths have equal coordinates. Directions that are mirror images of each other, at an axis or at a diagonal, have
    /// exactly mirrored results.
    pub const fn cos_sin(self) -> (i32, i32) {
        cos_sin(self.0)
    }

    /// How far it is clockwise from here to `other`, in units of `2^-32` turns.
    #[inline]
    pub const fn clockwise_to(self, other: Self) -> u32 {
        other.0.wrapping_sub(self.0)
    }

    /// Turned by so many units of `2^-32` turns: clockwise, or back if they are negative.
    #[inline]
    #[must_use]
    pub const fn plus(self, units: i32) -> Self {
        Self(self.0.wrapping_add(unsigned(units)))
    }

    /// In units of `2^-32` turns, as the nearest way there from 0: clockwise if positive, the other way if negative.
    ///
    /// From -1/2 turn, which stands for half a turn either way, to one unit below 1/2 turn.
    #[inline]
    pub const fn to_signed(self) -> i32 {
        signed(self.0)
    }
}

/// Whole turns drop out.
impl Add for Angle {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self(self.0.wrapping_add(other.0))
    }
}

/// Whole turns drop out.
impl Sub for Angle {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self(self.0.wrapping_sub(other.0))
    }
}

/// The mirror image at the horizontal axis: as far from 0, the other way round.
impl Neg for Angle {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self(self.0.wrapping_neg())
    }
}

impl AddAssign for Angle {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Angle {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

/// So many times the angle, the other way round if negative. Whole turns drop out.
impl Mul<i32> for Angle {
    type Output = Self;

    #[inline]
    fn mul(self, times: i32) -> Self {
        Self(self.0.wrapping_mul(unsigned(times)))
    }
}
