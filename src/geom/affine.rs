//! [`Affine`]: maps of the plane that keep straight lines straight, to draw a shape larger, turned, slanted or elsewhere.
//! ```text
//!     x' = xx x + xy y + dx         xx  xy  dx        the six numbers are 16.16: from -32,768 to 32,768,
//!     y' = yx x + yy y + dy         yx  yy  dy        in steps of 1/65,536
//! ```
//! A curve whose control points are mapped is the mapped curve. So [`Affine::path`] maps a path while it is drawn, segment by
//! segment, and curves are cut into lines after that: a path that is drawn ten times as large is as smooth as one that was made
//! so.
//!
//! **Rounding.** A mapped place is the exact value, rounded once to the nearest 1/256 pixel, halves upwards; it stops at the ends
//! of the range. Products of maps are rounded to the nearest 1/65,536, and stop at the ends too.
//!
//! Source: J. D. Foley et al., "Computer Graphics: Principles and Practice", 1990, section 5.2.

use core::borrow::Borrow;

use fixed::types::I16F16;

use super::{
    angle::Angle,
    path::PathSegment,
    point::{bits, PointFx},
};
use crate::num::{cast::narrow, wide::Sum};

/// A place in units of 1/65,536 pixel, in the range of [`PointFx`]: from `-2^39` to below `2^39`.
pub(super) type Fine = (i64, i64);

/// The nearest number in the range of [`Fine`].
pub(super) const fn in_range(n: i64) -> i64 {
    const END: i64 = 1 << 39;
    if n < -END {
        -END
    } else if n >= END {
        END - 1
    } else {
        n
    }
}

/// A map of the plane: scaling, turning, slanting, mirroring and moving, in any combination.
/// ```
/// use embedded_raster::{fixed::types::I16F16, Affine, Angle, PointFx};
/// let two = I16F16::from_num(2);
/// let map = Affine::scale(two, two).then(Affine::rotate(Angle::degrees(90))).then(Affine::translate(two, I16F16::ZERO));
/// assert_eq!(map.apply(PointFx::px(3, 1)), PointFx::px(0, 6));
/// ```
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Affine {
    /// How much of x is in x'.
    pub xx: I16F16,
    /// How much of y is in x'.
    pub xy: I16F16,
    /// Pixels that are added to x'.
    pub dx: I16F16,
    /// How much of x is in y'.
    pub yx: I16F16,
    /// How much of y is in y'.
    pub yy: I16F16,
    /// Pixels that are added to y'.
    pub dy: I16F16,
}

impl Default for Affine {
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl Affine {
    /// Leaves everything where it is.
    pub const IDENTITY: Self = Self::scale(I16F16::ONE, I16F16::ONE);

    /// So many times as wide and as high, seen from (0, 0); mirrored if negative.
    #[inline]
    pub const fn scale(x: I16F16, y: I16F16) -> Self {
        Self { xx: x, xy: I16F16::ZERO, dx: I16F16::ZERO, yx: I16F16::ZERO, yy: y, dy: I16F16::ZERO }
    }

    /// Moved by so many pixels to the right, and down.
    #[inline]
    pub const fn translate(x: I16F16, y: I16F16) -> Self {
        Self { dx: x, dy: y, ..Self::IDENTITY }
    }

    /// Turned around (0, 0), clockwise as seen on the screen. Quarters of a turn are exact.
    pub const fn rotate(angle: Angle) -> Self {
        let (cos, sin) = angle.cos_sin();
        // From 2.30 to 16.16, rounded to nearest. None is larger than 2^30.
        let cos = I16F16::from_bits(cos.wrapping_add(1 << 13) >> 14);
        let down = I16F16::from_bits(sin.wrapping_add(1 << 13) >> 14);
        let up = I16F16::from_bits(sin.wrapping_neg().wrapping_add(1 << 13) >> 14);
        Self { xx: cos, xy: up, dx: I16F16::ZERO, yx: down, yy: cos, dy: I16F16::ZERO }
    }

    /// First this map, then another one.
    /// ```
    /// use embedded_raster::{fixed::types::I16F16, Affine, PointFx};
    /// let number = I16F16::from_num::<i32>;
    /// let (grow, move_on) = (Affine::scale(number(3), number(2)), Affine::translate(number(1), number(1)));
    /// assert_eq!(grow.then(move_on).apply(PointFx::px(5, 5)), PointFx::px(16, 11));
    /// assert_eq!(move_on.then(grow).apply(PointFx::px(5, 5)), PointFx::px(18, 12));
    /// ```
    #[must_use]
    pub const fn then(self, next: Self) -> Self {
        let (xx, yx) = next.turned(self.xx, self.yx);
        let (xy, yy) = next.turned(self.xy, self.yy);
        let (dx, dy) = next.turned(self.dx, self.dy);
        Self { xx, xy, dx: dx.saturating_add(next.dx), yx, yy, dy: dy.saturating_add(next.dy) }
    }

    /// A vector: nothing is added to it.
    const fn turned(self, x: I16F16, y: I16F16) -> (I16F16, I16F16) {
        let (x, y) = (x.to_bits(), y.to_bits());
        let right = Sum::ZERO.plus(self.xx.to_bits(), x).plus(self.xy.to_bits(), y);
        let down = Sum::ZERO.plus(self.yx.to_bits(), x).plus(self.yy.to_bits(), y);
        (I16F16::from_bits(right.nearest(16)), I16F16::from_bits(down.nearest(16)))
    }

    /// A place, mapped.
    pub const fn apply(self, place: PointFx) -> PointFx {
        let (x, y) = bits(place);
        // In units of 2^-24 pixel.
        let right = Sum::ZERO.plus(self.xx.to_bits(), x).plus(self.xy.to_bits(), y).plus(self.dx.to_bits(), 256);
        let down = Sum::ZERO.plus(self.yx.to_bits(), x).plus(self.yy.to_bits(), y).plus(self.dy.to_bits(), 256);
        PointFx::from_bits(right.nearest(16), down.nearest(16))
    }

    /// A finer place, mapped, and rounded once.
    pub(super) const fn apply_fine(self, place: Fine) -> PointFx {
        PointFx::from_bits(
            fine_sum([self.xx.to_bits(), self.xy.to_bits(), self.dx.to_bits()], place),
            fine_sum([self.yx.to_bits(), self.yy.to_bits(), self.dy.to_bits()], place),
        )
    }

    /// A segment, mapped.
    pub const fn segment(self, segment: PathSegment) -> PathSegment {
        match segment {
            PathSegment::MoveTo(a) => PathSegment::MoveTo(self.apply(a)),
            PathSegment::LineTo(a) => PathSegment::LineTo(self.apply(a)),
            PathSegment::QuadraticTo(c, a) => PathSegment::QuadraticTo(self.apply(c), self.apply(a)),
            PathSegment::CubicTo(c, d, a) => PathSegment::CubicTo(self.apply(c), self.apply(d), self.apply(a)),
            PathSegment::Close => PathSegment::Close,
        }
    }

    /// A path, mapped segment by segment while somebody goes over it.
    /// ```
    /// use embedded_raster::{fixed::types::I16F16, Affine, Canvas, EdgeSlot, FillRule, Framebuffer, Index1, PathSegment::*, PointFx};
    /// let flag = [MoveTo(PointFx::px(0, 0)), LineTo(PointFx::px(2, 0)), LineTo(PointFx::px(0, 2)), Close];
    /// let larger = Affine::scale(I16F16::from_num(4), I16F16::from_num(2));
    /// let mut ram = [0; 4];
    /// let mut frame = Framebuffer::<Index1>::new(&mut ram, 8, 4)?;
    /// frame.fill_path_fx(larger.path(flag), FillRule::NonZero, &mut [EdgeSlot::EMPTY; 4], Index1::MAX)?;
    /// assert_eq!(ram, [0b1111_1110, 0b1111_1000, 0b1110_0000, 0b1000_0000]);
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[inline]
    pub fn path<P>(self, path: P) -> Mapped<P::IntoIter>
    where
        P: IntoIterator,
        P::Item: Borrow<PathSegment>,
    {
        Mapped { segments: path.into_iter(), map: self }
    }

    /// The longest that a vector of one pixel along an axis may become along one, in 16.16.
    pub(super) const fn growth(self) -> u32 {
        let along = self.xx.to_bits().unsigned_abs().saturating_add(self.xy.to_bits().unsigned_abs());
        let across = self.yx.to_bits().unsigned_abs().saturating_add(self.yy.to_bits().unsigned_abs());
        if along > across {
            along
        } else {
            across
        }
    }
}

/// `p x + q y + d` for 16.16 factors, rounded to the nearest 1/256.
///
/// The upper 32 bits of x and y, times the factors, are in units of `2^-24`; the lower 8 bits, times the factors, in units of
/// `2^-32`. Rounding the second sum down to `2^-24` does not change what is rounded down in the end.
const fn fine_sum([p, q, d]: [i32; 3], (x, y): Fine) -> i32 {
    let low = (p as i64).wrapping_mul(x & 255).wrapping_add((q as i64).wrapping_mul(y & 255)) >> 8;
    Sum::ZERO
        .plus(p, narrow(x >> 8))
        .plus(q, narrow(y >> 8))
        .plus(d, 256)
        .plus(narrow(low >> 8), 256)
        .plus(narrow(low & 255), 1)
        .nearest(16)
}

/// A path that is mapped while somebody goes over it: see [`Affine::path`].
#[derive(Copy, Clone, Debug)]
pub struct Mapped<I> {
    segments: I,
    map: Affine,
}

impl<I> Iterator for Mapped<I>
where
    I: Iterator,
    I::Item: Borrow<PathSegment>,
{
    type Item = PathSegment;

    #[inline]
    fn next(&mut self) -> Option<PathSegment> {
        Some(self.map.segment(*self.segments.next()?.borrow()))
    }
}
