//! [`Rect`]: a half-open rectangle of pixels.

use embedded_graphics_core::{
    geometry::{Point, Size},
    primitives::Rectangle,
};

use crate::num::cast::{saturate, unsigned};

/// Pixels `x0 <= x < x1`, `y0 <= y < y1`; empty when either range is.
///
/// The window of a surface is one: what may be drawn. Unlike [`Rectangle`] it can be as wide as the whole `i32` range
/// and tells at a glance whether a pixel lies in it.
/// ```
/// use embedded_raster::Rect;
/// let a = Rect::new(0, 0, 320, 240);
/// assert_eq!(a.intersection(Rect::new(-5, 200, 10, i32::MAX)), Rect::new(0, 200, 10, 240));
/// assert!(a.intersection(Rect::new(320, 0, 400, 9)).is_empty());
/// ```
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Rect {
    /// First column.
    pub x0: i32,
    /// First row.
    pub y0: i32,
    /// The column after the last.
    pub x1: i32,
    /// The row after the last.
    pub y1: i32,
}

impl Rect {
    /// Columns `x0..x1` of rows `y0..y1`.
    #[inline]
    pub const fn new(x0: i32, y0: i32, x1: i32, y1: i32) -> Self {
        Self { x0, y0, x1, y1 }
    }

    /// Whether it holds no pixel.
    #[inline]
    pub const fn is_empty(self) -> bool {
        self.x0 >= self.x1 || self.y0 >= self.y1
    }

    /// Whether it holds the pixel.
    #[inline]
    pub const fn contains(self, x: i32, y: i32) -> bool {
        self.x0 <= x && x < self.x1 && self.y0 <= y && y < self.y1
    }

    /// The pixels that lie in both.
    #[inline]
    #[must_use]
    pub fn intersection(self, other: Self) -> Self {
        Self {
            x0: self.x0.max(other.x0),
            y0: self.y0.max(other.y0),
            x1: self.x1.min(other.x1),
            y1: self.y1.min(other.y1),
        }
    }

    /// The same pixels, named from a point that lies at (`x`, `y`) here. Sides stop at the ends of `i32`.
    #[inline]
    #[must_use]
    pub fn relative_to(self, x: i32, y: i32) -> Self {
        Self {
            x0: self.x0.saturating_sub(x),
            y0: self.y0.saturating_sub(y),
            x1: self.x1.saturating_sub(x),
            y1: self.y1.saturating_sub(y),
        }
    }

    /// Columns.
    #[inline]
    pub const fn width(self) -> u32 {
        if self.x0 < self.x1 {
            unsigned(self.x1.wrapping_sub(self.x0))
        } else {
            0
        }
    }

    /// Rows.
    #[inline]
    pub const fn height(self) -> u32 {
        if self.y0 < self.y1 {
            unsigned(self.y1.wrapping_sub(self.y0))
        } else {
            0
        }
    }
}

/// Columns and rows beyond `i32::MAX` are cut off.
impl From<Rectangle> for Rect {
    #[inline]
    fn from(r: Rectangle) -> Self {
        let Point { x, y } = r.top_left;
        Self {
            x0: x,
            y0: y,
            x1: saturate(i64::from(x) + i64::from(r.size.width)),
            y1: saturate(i64::from(y) + i64::from(r.size.height)),
        }
    }
}

impl From<Rect> for Rectangle {
    #[inline]
    fn from(r: Rect) -> Self {
        Self { top_left: Point::new(r.x0, r.y0), size: Size::new(r.width(), r.height()) }
    }
}
