//! [`Angle`]: a fraction of a turn.

use crate::num::{
    cast::{signed, unsigned},
    trig::cos_sin,
};

/// A direction, as a fraction of a turn in units of `2^-32` turns: from the right, clockwise on the screen (y points down).
///
/// Adding and subtracting wraps at a whole turn.
/// ```
/// use embedded_raster::geom::Angle;
/// assert_eq!(Angle::degrees(90), Angle::turns(1, 4));
/// assert_eq!(Angle::degrees(-90), Angle::from_bits(3 << 30));
/// assert_eq!(Angle::turns(1, 4).cos_sin(), (0, 1 << 30)); // straight down
/// ```
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
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

    /// `n / 2^log2` turns would be exact; of any other fraction of a turn the unit below it is taken. Of no parts (`d = 0`)
    /// it is 0.
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

    /// In whole degrees, to the nearest unit.
    pub const fn degrees(degrees: i32) -> Self {
        let d = unsigned(degrees % 360 + 360) % 360;
        // 2^32 / 360 = 11,930,464 + 32 / 45
        Self(d.wrapping_mul(11_930_464).wrapping_add((d * 32 + 22) / 45))
    }

    /// Cosine and sine in units of `2^-30`, within 32 of them: see `num::trig`. Exact at quarters of a turn; mirror images
    /// are each other's exactly.
    pub fn cos_sin(self) -> (i32, i32) {
        cos_sin(self.0)
    }

    /// What has to be added to get to `other`, clockwise.
    #[inline]
    pub const fn clockwise_to(self, other: Self) -> u32 {
        other.0.wrapping_sub(self.0)
    }

    /// Turned further, clockwise or back, in units of `2^-32` turns.
    #[inline]
    #[must_use]
    pub const fn plus(self, units: i32) -> Self {
        Self(self.0.wrapping_add(unsigned(units)))
    }

    /// The same direction as a signed angle, from -1/2 turn on.
    #[inline]
    pub const fn to_signed(self) -> i32 {
        signed(self.0)
    }
}
