//! [`PointFx`]: a place on the plane in 24.8. [`px`]: a length in whole pixels.

use core::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

use embedded_graphics_core::geometry::Point;
use fixed::types::I24F8;

use crate::num::cast::saturate;

/// A place on the plane, to 1/256 of a pixel, from -8,388,608 to 8,388,607.996.
///
/// Pixel (x, y) covers `x..x+1` and `y..y+1`. [`px`](Self::px) is its top left *corner*, at (x, y);
/// [`centre_of`](Self::centre_of) is its *centre*, at (x + 1/2, y + 1/2). A [`Point`] names a pixel, not a place, and so do a
/// column and a row, `(x, y)`: [`PointFx::from`] either is the centre of that pixel.
/// ```
/// use embedded_graphics_core::geometry::Point;
/// use embedded_raster::{fixed::types::I24F8, px, PointFx};
/// let corner = PointFx::px(3, -4);
/// assert_eq!(corner, PointFx::from_bits(768, -1024));
/// assert_eq!(corner, PointFx::new(px(3), px(-4)));
/// let centre = PointFx::from(Point::new(3, -4));
/// assert_eq!(centre, PointFx::new(I24F8::from_num(3.5), I24F8::from_num(-3.5)));
/// assert_eq!(centre, PointFx::from((3, -4)));
/// assert_eq!((corner.pixel(), centre.pixel()), (Point::new(3, -4), Point::new(3, -4)));
/// ```
///
/// Sums, differences and products are taken coordinate by coordinate. None of them overflows: a coordinate that would
/// leave the range stops at its end. Products are rounded to the nearest 1/256, halves upwards.
/// ```
/// # use embedded_raster::{fixed::types::I24F8, px, PointFx};
/// let (a, b) = (PointFx::px(10, 20), PointFx::px(16, 40));
/// assert_eq!(a + (b - a) * I24F8::from_num(0.25), PointFx::new(I24F8::from_num(11.5), px(25)));
/// assert_eq!(PointFx::px(8_000_000, 0) + PointFx::px(8_000_000, 1), PointFx::new(I24F8::MAX, I24F8::ONE));
/// assert_eq!(PointFx::from_bits(1, -1) * I24F8::from_num(0.5), PointFx::from_bits(1, 0));
/// ```
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct PointFx {
    /// To the right.
    pub x: I24F8,
    /// Down.
    pub y: I24F8,
}

/// Whole pixels, wherever an `I24F8` is asked for: widths, radii, diameters, lengths of dashes, coordinates. Stops at the ends of
/// the range.
/// ```
/// use embedded_raster::{fixed::types::I24F8, px, Ellipse, PointFx, Stroke};
/// const DASHES: [I24F8; 2] = [px(6), px(3)];
/// let dashed = Stroke::px(2).dashed(&DASHES, px(0));
/// let disc = Ellipse::circle(PointFx::px(40, 30), px(12));
/// assert_eq!(px(3), I24F8::from_num(3));
/// assert_eq!(px(3) / 2, I24F8::from_num(1.5));
/// assert_eq!([px(i32::MAX), px(i32::MIN)], [I24F8::MAX, I24F8::MIN]);
/// ```
#[inline]
pub const fn px(pixels: i32) -> I24F8 {
    I24F8::from_bits(saturate((pixels as i64) << 8))
}

impl PointFx {
    /// A place in fixed-point pixels.
    #[inline]
    pub const fn new(x: I24F8, y: I24F8) -> Self {
        Self { x, y }
    }

    /// A place in whole pixels: the top left *corner* of pixel (x, y). Stops at the ends of the range.
    ///
    /// For the centre of a pixel see [`centre_of`](Self::centre_of).
    #[inline]
    pub const fn px(x: i32, y: i32) -> Self {
        Self { x: px(x), y: px(y) }
    }

    /// A place in units of 1/256 pixel.
    #[inline]
    pub const fn from_bits(x: i32, y: i32) -> Self {
        Self { x: I24F8::from_bits(x), y: I24F8::from_bits(y) }
    }

    /// The *centre* of a pixel. Stops at the ends of the range.
    ///
    /// For its top left corner see [`px`](Self::px).
    #[inline]
    pub const fn centre_of(p: Point) -> Self {
        Self::from_bits(saturate(((p.x as i64) << 8) + 128), saturate(((p.y as i64) << 8) + 128))
    }

    /// The pixel that contains it. A place on the border of two pixels belongs to the one on its right, or below it.
    #[inline]
    pub const fn pixel(self) -> Point {
        Point::new(self.x.to_bits() >> 8, self.y.to_bits() >> 8)
    }
}

/// The *centre* of the pixel: [`centre_of`](PointFx::centre_of).
impl From<Point> for PointFx {
    #[inline]
    fn from(pixel: Point) -> Self {
        Self::centre_of(pixel)
    }
}

/// The *centre* of the pixel in column x and row y, as of a [`Point`]. [`px`](PointFx::px) is its corner.
impl From<(i32, i32)> for PointFx {
    #[inline]
    fn from((x, y): (i32, i32)) -> Self {
        Self::centre_of(Point::new(x, y))
    }
}

/// Coordinates stop at the ends of the range.
impl Add for PointFx {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self { x: self.x.saturating_add(other.x), y: self.y.saturating_add(other.y) }
    }
}

/// Coordinates stop at the ends of the range.
impl Sub for PointFx {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self { x: self.x.saturating_sub(other.x), y: self.y.saturating_sub(other.y) }
    }
}

/// The place on the opposite side of (0, 0). The lowest coordinate becomes the highest, one unit less than its
/// opposite.
impl Neg for PointFx {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self { x: self.x.saturating_neg(), y: self.y.saturating_neg() }
    }
}

impl AddAssign for PointFx {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for PointFx {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

/// Coordinates are rounded to the nearest 1/256, halves upwards, and stop at the ends of the range.
impl Mul<I24F8> for PointFx {
    type Output = Self;

    #[inline]
    fn mul(self, factor: I24F8) -> Self {
        // Products are at most 2^62: adding a half cannot overflow.
        let scaled = |n: I24F8| {
            let product = i64::from(n.to_bits()).wrapping_mul(i64::from(factor.to_bits()));
            I24F8::from_bits(saturate(product.wrapping_add(128) >> 8))
        };
        Self { x: scaled(self.x), y: scaled(self.y) }
    }
}

/// As (3.500, -0.004): decimal fractions, rounded to the nearest thousandth.
#[cfg(feature = "defmt")]
impl defmt::Format for PointFx {
    fn format(&self, f: defmt::Formatter<'_>) {
        let [x, y] = [self.x, self.y].map(crate::num::decimal::Decimal::new);
        defmt::write!(f, "({}, {})", x, y);
    }
}

/// In units of 1/256 pixel, the private form of the loops.
pub(crate) const fn bits(v: PointFx) -> (i32, i32) {
    (v.x.to_bits(), v.y.to_bits())
}
