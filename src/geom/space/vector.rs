//! [`Vec3`] and [`Vec4`]: places and directions in space, in 16.16.

use core::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

use fixed::types::I16F16;

use super::number::{from_2_30, nearest_root};
use crate::num::{
    cast::{narrow, signed, unsigned},
    recip::{inverse_root_wide, Denominator},
    wide::{nearest, Sum},
};

/// A place or a direction in space, to `2^-16`, from -32,768 to 32,767.99998.
///
/// Sums, differences and products are taken coordinate by coordinate. None of them overflows: a coordinate that would leave
/// the range stops at its end. Products are rounded once, to the nearest number, halves upwards.
/// ```
/// use embedded_raster::Vec3;
/// use fixed::types::I16F16;
/// let (a, b) = (Vec3::whole(1, 2, 3), Vec3::whole(3, 0, -1));
/// assert_eq!(a + (b - a) * I16F16::from_num(0.5), Vec3::whole(2, 1, 1));
/// assert_eq!(a.dot(b), 0);
/// assert_eq!(a.cross(b), Vec3::whole(-2, 10, -6));
/// assert_eq!(Vec3::whole(20_000, 0, 0) + Vec3::whole(20_000, 0, 0), Vec3::new(I16F16::MAX, I16F16::ZERO, I16F16::ZERO));
/// ```
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Vec3 {
    /// To the right.
    pub x: I16F16,
    /// Up, unless the program means something else.
    pub y: I16F16,
    /// Towards the viewer, unless the program means something else.
    pub z: I16F16,
}

impl Vec3 {
    /// (0, 0, 0).
    pub const ZERO: Self = Self::from_bits([0; 3]);
    /// (1, 0, 0).
    pub const X: Self = Self::whole(1, 0, 0);
    /// (0, 1, 0).
    pub const Y: Self = Self::whole(0, 1, 0);
    /// (0, 0, 1).
    pub const Z: Self = Self::whole(0, 0, 1);

    /// Of fixed-point coordinates.
    #[inline]
    pub const fn new(x: I16F16, y: I16F16, z: I16F16) -> Self {
        Self { x, y, z }
    }

    /// Of whole coordinates.
    #[inline]
    pub const fn whole(x: i16, y: i16, z: i16) -> Self {
        Self::from_bits([(x as i32) << 16, (y as i32) << 16, (z as i32) << 16])
    }

    /// In units of `2^-16`.
    #[inline]
    pub const fn from_bits([x, y, z]: [i32; 3]) -> Self {
        Self { x: I16F16::from_bits(x), y: I16F16::from_bits(y), z: I16F16::from_bits(z) }
    }

    /// In units of `2^-16`.
    #[inline]
    pub const fn to_bits(self) -> [i32; 3] {
        [self.x.to_bits(), self.y.to_bits(), self.z.to_bits()]
    }

    /// With a fourth coordinate: 1 for a place, 0 for a direction.
    #[inline]
    pub const fn with_w(self, w: I16F16) -> Vec4 {
        Vec4 { x: self.x, y: self.y, z: self.z, w }
    }

    /// The dot product: rounded once, from the exact sum, halves upwards. Stops at the ends of the range.
    #[inline]
    pub const fn dot(self, other: Self) -> I16F16 {
        let ([a, b, c], [d, e, f]) = (self.to_bits(), other.to_bits());
        I16F16::from_bits(Sum::ZERO.plus(a, d).plus(b, e).plus(c, f).nearest(16))
    }

    /// The cross product: each coordinate is rounded once, from the exact difference, halves upwards. Stops at the ends of the
    /// range.
    ///
    /// Seen from its tip, `self` turns counter-clockwise to `other`.
    /// ```
    /// # use embedded_raster::Vec3;
    /// assert_eq!(Vec3::X.cross(Vec3::Y), Vec3::Z);
    /// ```
    #[inline]
    #[must_use]
    pub const fn cross(self, other: Self) -> Self {
        let [x, y, z] = cross(self.to_bits(), other.to_bits());
        Self::from_bits([x.nearest(16), y.nearest(16), z.nearest(16)])
    }

    /// The length: the nearest number. Stops at the end of the range.
    /// ```
    /// # use embedded_raster::Vec3;
    /// assert_eq!(Vec3::whole(2, -3, 6).length(), 7);
    /// ```
    pub fn length(self) -> I16F16 {
        // The square of 2^16 units is 2^32: the root has the unit again.
        let [x, y, z] = self.to_bits();
        I16F16::from_bits(nearest_root(Sum::ZERO.plus(x, x).plus(y, y).plus(z, z).of_squares()))
    }

    /// The same direction with length 1. Zero stays zero.
    ///
    /// Each coordinate is at most 0.501 units of `2^-16` off, whatever the length was; axes are exact.
    /// ```
    /// # use embedded_raster::Vec3;
    /// assert_eq!(Vec3::from_bits([0, -1, 0]).normalize(), -Vec3::Y);
    /// assert_eq!(Vec3::ZERO.normalize(), Vec3::ZERO);
    /// ```
    #[must_use]
    pub const fn normalize(self) -> Self {
        let [x, y, z] = self.to_bits();
        normalized([x as i64, y as i64, z as i64])
    }
}

/// Three sums that are the exact cross product.
#[inline]
pub(crate) const fn cross([a, b, c]: [i32; 3], [d, e, f]: [i32; 3]) -> [Sum; 3] {
    let one = Sum::ZERO;
    [one.plus(b, f).minus(c, e), one.plus(c, d).minus(a, f), one.plus(a, e).minus(b, d)]
}

/// The direction of a vector of any length, with length 1. Zero stays zero.
pub(crate) const fn normalized(v: [i64; 3]) -> Vec3 {
    let [x, y, z] = unit(v);
    Vec3 { x: from_2_30(x), y: from_2_30(y), z: from_2_30(z) }
}

/// A power of two that numbers are multiplied by, so that the largest has as many bits as wanted.
#[derive(Copy, Clone)]
pub(crate) struct Scale {
    /// By how many bits to the left, or to the right if negative.
    pub(crate) left: i32,
}

impl Scale {
    /// So that the largest of some numbers is from `2^(bits - 1)` to `2^bits`, for `bits` up to 30.
    ///
    /// * `all`: the magnitudes of all numbers, or-ed: that has as many bits as the largest.
    pub(crate) const fn to_bits(bits: u32, all: u64) -> Self {
        Self { left: signed(all.leading_zeros().wrapping_add(bits)).wrapping_sub(64) }
    }

    /// The same, but small numbers stay as they are.
    pub(crate) const fn to_at_most_bits(bits: u32, all: u64) -> Self {
        let Self { left } = Self::to_bits(bits, all);
        Self { left: if left < 0 { left } else { 0 } }
    }

    /// A number times the power: the nearest one, halves upwards.
    #[inline]
    pub(crate) const fn of(self, n: i64) -> i32 {
        if self.left < 0 {
            nearest(n, unsigned(self.left.wrapping_neg()))
        } else {
            narrow(n << (self.left & 63))
        }
    }

    pub(crate) const fn of_all(self, [x, y, z]: [i64; 3]) -> [i32; 3] {
        [self.of(x), self.of(y), self.of(z)]
    }
}

/// The direction of a vector with length 1, in 2.30. Each coordinate is at most 2 units off. Zero stays zero.
pub(crate) const fn unit(v: [i64; 3]) -> [i32; 3] {
    let [x, y, z] = v;
    let scale = Scale::to_bits(30, x.unsigned_abs() | y.unsigned_abs() | z.unsigned_abs());
    let [x, y, z] = scale.of_all(v);
    let square = Sum::ZERO.plus(x, x).plus(y, y).plus(z, z).of_squares();
    if square == 0 {
        return [0; 3];
    }
    // x / sqrt(square) in 2.30 is x y 2^(s / 2 - 32). The square is from 2^58 to 3 2^60, so s is 2 or 4.
    let (y_2_30, s) = inverse_root_wide(square);
    let shift = 32_u32.wrapping_sub(s >> 1);
    let y_2_30 = y_2_30 as i64;
    [
        nearest((x as i64).wrapping_mul(y_2_30), shift),
        nearest((y as i64).wrapping_mul(y_2_30), shift),
        nearest((z as i64).wrapping_mul(y_2_30), shift),
    ]
}

/// A place in homogeneous coordinates: it stands for (x / w, y / w, z / w). With w = 0 it is a direction.
///
/// Arithmetic is that of [`Vec3`].
/// ```
/// use embedded_raster::{Vec3, Vec4};
/// assert_eq!(Vec4::whole(6, -3, 1, 2).project(), Vec3::from_bits([3 << 16, -3 << 15, 1 << 15]));
/// ```
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Vec4 {
    /// To the right.
    pub x: I16F16,
    /// Up.
    pub y: I16F16,
    /// Away from the viewer, in clip coordinates; else towards the viewer.
    pub z: I16F16,
    /// What the others are divided by.
    pub w: I16F16,
}

impl Vec4 {
    /// (0, 0, 0, 0).
    pub const ZERO: Self = Self::from_bits([0; 4]);

    /// Of fixed-point coordinates.
    #[inline]
    pub const fn new(x: I16F16, y: I16F16, z: I16F16, w: I16F16) -> Self {
        Self { x, y, z, w }
    }

    /// Of whole coordinates.
    #[inline]
    pub const fn whole(x: i16, y: i16, z: i16, w: i16) -> Self {
        Self::from_bits([(x as i32) << 16, (y as i32) << 16, (z as i32) << 16, (w as i32) << 16])
    }

    /// In units of `2^-16`.
    #[inline]
    pub const fn from_bits([x, y, z, w]: [i32; 4]) -> Self {
        Self { x: I16F16::from_bits(x), y: I16F16::from_bits(y), z: I16F16::from_bits(z), w: I16F16::from_bits(w) }
    }

    /// In units of `2^-16`.
    #[inline]
    pub const fn to_bits(self) -> [i32; 4] {
        [self.x.to_bits(), self.y.to_bits(), self.z.to_bits(), self.w.to_bits()]
    }

    /// Without the last coordinate.
    #[inline]
    pub const fn xyz(self) -> Vec3 {
        Vec3 { x: self.x, y: self.y, z: self.z }
    }

    /// The dot product: rounded once, from the exact sum, halves upwards. Stops at the ends of the range.
    #[inline]
    pub const fn dot(self, other: Self) -> I16F16 {
        let ([a, b, c, d], [e, f, g, h]) = (self.to_bits(), other.to_bits());
        I16F16::from_bits(Sum::ZERO.plus(a, e).plus(b, f).plus(c, g).plus(d, h).nearest(16))
    }

    /// The place that it stands for: the nearest to (x / w, y / w, z / w), halves upwards. Stops at the ends of the range; so
    /// does x / 0, on the side of x. 0 / 0 is 0.
    pub const fn project(self) -> Vec3 {
        let [x, y, z, w] = self.to_bits();
        let w = Denominator::new(w);
        Vec3::from_bits([w.under((x as i64) << 16), w.under((y as i64) << 16), w.under((z as i64) << 16)])
    }
}

/// The operators of a vector, coordinate by coordinate.
macro_rules! operators {
    ($($vector:ident: $($c:ident)*;)*) => {$(
        /// Coordinates stop at the ends of the range.
        impl Add for $vector {
            type Output = Self;

            #[inline]
            fn add(self, other: Self) -> Self {
                Self { $($c: self.$c.saturating_add(other.$c)),* }
            }
        }

        /// Coordinates stop at the ends of the range.
        impl Sub for $vector {
            type Output = Self;

            #[inline]
            fn sub(self, other: Self) -> Self {
                Self { $($c: self.$c.saturating_sub(other.$c)),* }
            }
        }

        /// The opposite. The lowest coordinate becomes the highest, one unit less than its opposite.
        impl Neg for $vector {
            type Output = Self;

            #[inline]
            fn neg(self) -> Self {
                Self { $($c: self.$c.saturating_neg()),* }
            }
        }

        impl AddAssign for $vector {
            #[inline]
            fn add_assign(&mut self, other: Self) {
                *self = *self + other;
            }
        }

        impl SubAssign for $vector {
            #[inline]
            fn sub_assign(&mut self, other: Self) {
                *self = *self - other;
            }
        }

        /// Coordinates are rounded to the nearest number, halves upwards, and stop at the ends of the range.
        impl Mul<I16F16> for $vector {
            type Output = Self;

            #[inline]
            fn mul(self, factor: I16F16) -> Self {
                let scaled = |n: I16F16| I16F16::from_bits(Sum::ZERO.plus(n.to_bits(), factor.to_bits()).nearest(16));
                Self { $($c: scaled(self.$c)),* }
            }
        }
    )*};
}

operators! {
    Vec3: x y z;
    Vec4: x y z w;
}
