//! [`PointFx`]: a place on the plane in 24.8.

use embedded_graphics_core::geometry::Point;
use fixed::types::I24F8;

use crate::num::cast::saturate;

/// A place on the plane, to 1/256 of a pixel, from -8,388,608 to 8,388,607.996.
///
/// Pixel (x, y) covers `x..x+1` and `y..y+1`; its centre is at (x + 1/2, y + 1/2).
/// ```
/// use embedded_raster::PointFx;
/// use fixed::types::I24F8;
/// let a = PointFx::px(3, -4);
/// assert_eq!(a, PointFx::from_bits(768, -1024));
/// assert_eq!(a, PointFx::new(I24F8::from_num(3), I24F8::from_num(-4)));
/// ```
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct PointFx {
    /// To the right.
    pub x: I24F8,
    /// Down.
    pub y: I24F8,
}

impl PointFx {
    /// A place in fixed-point pixels.
    #[inline]
    pub const fn new(x: I24F8, y: I24F8) -> Self {
        Self { x, y }
    }

    /// A place in whole pixels: the top left corner of pixel (x, y). Stops at the ends of the range.
    #[inline]
    pub const fn px(x: i32, y: i32) -> Self {
        Self::from_bits(saturate((x as i64) << 8), saturate((y as i64) << 8))
    }

    /// A place in units of 1/256 pixel.
    #[inline]
    pub const fn from_bits(x: i32, y: i32) -> Self {
        Self { x: I24F8::from_bits(x), y: I24F8::from_bits(y) }
    }

    /// The centre of a pixel. Stops at the ends of the range.
    #[inline]
    pub const fn centre_of(p: Point) -> Self {
        Self::from_bits(saturate(((p.x as i64) << 8) + 128), saturate(((p.y as i64) << 8) + 128))
    }

    /// The pixel that contains it.
    #[inline]
    pub const fn pixel(self) -> Point {
        Point::new(self.x.to_bits() >> 8, self.y.to_bits() >> 8)
    }
}

/// In units of 1/256 pixel, the private form of the loops.
pub(crate) const fn bits(v: PointFx) -> (i32, i32) {
    (v.x.to_bits(), v.y.to_bits())
}
