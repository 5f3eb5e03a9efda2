//! [`Rect`]: a half-open rectangle of pixels.

use embedded_graphics_core::{
    geometry::{Point, Size},
    primitives::Rectangle,
};

use crate::num::cast::{saturate, unsigned};

/// Pixels `x0 <= x < x1`, `y0 <= y < y1`; empty when either range is.
///
/// The window of a surface, what may be drawn, is one. Unlike a [`Rectangle`] it can be as wide as the whole `i32` range, and
/// four comparisons tell whether a pixel lies in it.
/// ```
/// use embedded_raster::Rect;
/// let a = Rect::new(0, 0, 320, 240);
/// assert_eq!(a.intersection(Rect::new(-5, 200, 10, i32::MAX)), Rect::new(0, 200, 10, 240));
/// assert!(a.intersection(Rect::new(320, 0, 400, 9)).is_empty());
/// ```
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
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

    /// So many columns and rows from the pixel `top_left` on. What would lie beyond the end of `i32` is cut off.
    /// ```
    /// use embedded_graphics_core::geometry::{Point, Size};
    /// use embedded_raster::Rect;
    /// assert_eq!(Rect::with_size(Point::new(10, 20), Size::new(4, 3)), Rect::new(10, 20, 14, 23));
    /// ```
    #[inline]
    pub const fn with_size(top_left: Point, size: Size) -> Self {
        let ((x0, x1), (y0, y1)) =
            (from_start(top_left.x as i64, size.width), from_start(top_left.y as i64, size.height));
        Self { x0, y0, x1, y1 }
    }

    /// So many columns and rows around the pixel `center`. What would lie beyond the ends of `i32` is cut off.
    ///
    /// An even number of columns has no middle one: there is one column more on the right of `center` than on its left.
    /// Of an even number of rows, one more lies below. embedded-graphics' `Rectangle::with_center` does the same.
    /// ```
    /// use embedded_graphics_core::{geometry::{Point, Size}, primitives::Rectangle};
    /// use embedded_raster::Rect;
    /// let (center, size) = (Point::new(10, 10), Size::new(3, 4));
    /// assert_eq!(Rect::from_center(center, size), Rect::new(9, 9, 12, 13)); // row 9 above, rows 11 and 12 below
    /// assert_eq!(Rect::from_center(center, size), Rectangle::with_center(center, size).into());
    /// ```
    #[inline]
    pub const fn from_center(center: Point, size: Size) -> Self {
        let ((x0, x1), (y0, y1)) = (around(center.x, size.width), around(center.y, size.height));
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
    pub const fn intersection(self, other: Self) -> Self {
        Self {
            x0: larger(self.x0, other.x0),
            y0: larger(self.y0, other.y0),
            x1: smaller(self.x1, other.x1),
            y1: smaller(self.y1, other.y1),
        }
    }

    /// The smallest rectangle that holds the pixels of both. An empty one adds nothing.
    /// ```
    /// use embedded_raster::Rect;
    /// let a = Rect::new(0, 0, 4, 2);
    /// assert_eq!(a.union(Rect::new(6, 1, 8, 5)), Rect::new(0, 0, 8, 5));
    /// assert_eq!(a.union(Rect::new(99, 99, 99, 120)), a);
    /// ```
    #[inline]
    #[must_use]
    pub const fn union(self, other: Self) -> Self {
        if self.is_empty() {
            return other;
        }
        if other.is_empty() {
            return self;
        }
        Self {
            x0: smaller(self.x0, other.x0),
            y0: smaller(self.y0, other.y0),
            x1: larger(self.x1, other.x1),
            y1: larger(self.y1, other.y1),
        }
    }

    /// Moved by `dx` columns to the right and `dy` rows down. Each side stops at the ends of `i32`, so what would lie
    /// beyond them is cut off.
    /// ```
    /// use embedded_raster::Rect;
    /// assert_eq!(Rect::new(0, 0, 4, 2).translate(-3, 10), Rect::new(-3, 10, 1, 12));
    /// assert_eq!(Rect::new(0, 0, 4, 2).translate(i32::MAX - 1, 0).width(), 1);
    /// ```
    #[inline]
    #[must_use]
    pub const fn translate(self, dx: i32, dy: i32) -> Self {
        Self {
            x0: self.x0.saturating_add(dx),
            y0: self.y0.saturating_add(dy),
            x1: self.x1.saturating_add(dx),
            y1: self.y1.saturating_add(dy),
        }
    }

    /// The same pixels, counted from the pixel (`x`, `y`): moved by `-x` columns and `-y` rows. Each side stops at the
    /// ends of `i32`.
    #[inline]
    #[must_use]
    pub const fn relative_to(self, x: i32, y: i32) -> Self {
        Self {
            x0: self.x0.saturating_sub(x),
            y0: self.y0.saturating_sub(y),
            x1: self.x1.saturating_sub(x),
            y1: self.y1.saturating_sub(y),
        }
    }

    /// Without the `n` outermost rows and columns on each of the four sides; a negative `n` adds as many.
    ///
    /// If no column or no row is left, the result is empty; its first column or row is then its end, not beyond it. What would
    /// grow beyond the ends of `i32` stops there. An empty rectangle has no pixels to grow from and stays as it is.
    /// ```
    /// use embedded_raster::Rect;
    /// let a = Rect::new(0, 0, 10, 6);
    /// assert_eq!(a.inset(2), Rect::new(2, 2, 8, 4));
    /// assert_eq!(a.inset(-1), Rect::new(-1, -1, 11, 7));
    /// assert!(a.inset(3).is_empty());
    /// ```
    #[inline]
    #[must_use]
    pub const fn inset(self, n: i32) -> Self {
        if self.is_empty() {
            return self;
        }
        let ((x0, x1), (y0, y1)) = (inset(self.x0, self.x1, n), inset(self.y0, self.y1, n));
        Self { x0, y0, x1, y1 }
    }

    /// Its first pixel, in the upper left corner.
    #[inline]
    pub const fn top_left(self) -> Point {
        Point::new(self.x0, self.y0)
    }

    /// Columns and rows.
    #[inline]
    pub const fn size(self) -> Size {
        Size::new(self.width(), self.height())
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

const fn smaller(a: i32, b: i32) -> i32 {
    if a < b {
        a
    } else {
        b
    }
}

const fn larger(a: i32, b: i32) -> i32 {
    if a > b {
        a
    } else {
        b
    }
}

/// Both ends of `count` numbers from `start` on. An end that is outside of `i32` becomes the nearest `i32`.
const fn from_start(start: i64, count: u32) -> (i32, i32) {
    (saturate(start), saturate(start.wrapping_add(count as i64)))
}

/// Both ends of `count` numbers around `center`. If their count is even, one more lies after it than before it.
const fn around(center: i32, count: u32) -> (i32, i32) {
    from_start((center as i64).wrapping_sub((count.saturating_sub(1) / 2) as i64), count)
}

/// Both ends of a range, moved towards each other by `n`. If they would pass each other, both are the middle of the range.
const fn inset(start: i32, end: i32, n: i32) -> (i32, i32) {
    let (inner_start, inner_end) = (start.saturating_add(n), end.saturating_sub(n));
    if inner_start > inner_end {
        let middle = i32::midpoint(start, end);
        (middle, middle)
    } else {
        (inner_start, inner_end)
    }
}

/// Columns and rows beyond `i32::MAX` are cut off.
impl From<Rectangle> for Rect {
    #[inline]
    fn from(r: Rectangle) -> Self {
        Self::with_size(r.top_left, r.size)
    }
}

impl From<Rect> for Rectangle {
    #[inline]
    fn from(r: Rect) -> Self {
        Self { top_left: r.top_left(), size: r.size() }
    }
}
