//! [`Path`]: contours of lines and Bézier curves.
//!
//! ```text
//!    QuadraticTo(c, b)           CubicTo(c, d, b)
//!
//!          c                       c . . . . . d      a is where the segment before ended,
//!        .   .                    .   _____   .       c and d pull, the curve ends in b and
//!      .  .-.  .                  . /       \ .       stays inside the hull of all of them
//!    a--'     '--b                a           b
//! ```
//! A [`Path`] is a slice in the caller's memory. Functions that draw paths take any iterator over segments that can be gone over
//! again: an array, the text of an [SVG path](super::svg), an [`Arc`](super::arc) behind other segments, all of them
//! [mapped](super::affine), or whatever a program computes. Contours, and the vertices of each, are computed while somebody
//! iterates over them, and nothing is stored; [`Path::outlines`] writes them down. How curves are cut into lines, and
//! how close the lines are to the curves, is explained in [`flatten`](super::flatten).

use core::{iter::Copied, slice::Iter};

use super::point::PointFx;

/// One step of a [`Path`].
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum PathSegment {
    /// Ends the contour before it, and begins another one here.
    MoveTo(PointFx),
    /// A straight side.
    LineTo(PointFx),
    /// A quadratic Bézier curve: control point, end.
    QuadraticTo(PointFx, PointFx),
    /// A cubic Bézier curve: two control points, end.
    CubicTo(PointFx, PointFx, PointFx),
    /// Joins the end of the contour to its start, and ends it. If no move follows, the next contour begins at that
    /// start too.
    Close,
}

/// Contours of lines and curves, in borrowed memory. A path that does not begin with a move begins at (0, 0).
/// ```
/// use embedded_raster::{Path, PathSegment::*, PointFx};
/// let p = PointFx::px;
/// let drop = [MoveTo(p(8, 0)), CubicTo(p(8, 4), p(14, 8), p(8, 12)), CubicTo(p(2, 8), p(8, 4), p(8, 0)), Close];
/// let path = Path::new(&drop);
/// let contours: Vec<Vec<PointFx>> = path.contours().map(|c| c.collect()).collect();
/// assert_eq!(contours.len(), 1);
/// assert_eq!(contours[0].len(), 17); // eight sides a curve, each within 1/7 pixel of it
/// ```
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Path<'a> {
    segments: &'a [PathSegment],
}

impl<'a> Path<'a> {
    /// The path that these segments make.
    #[inline]
    pub const fn new(segments: &'a [PathSegment]) -> Self {
        Self { segments }
    }

    /// The segments that it is made of.
    #[inline]
    pub const fn segments(self) -> &'a [PathSegment] {
        self.segments
    }
}

impl<'a> IntoIterator for Path<'a> {
    type Item = PathSegment;
    type IntoIter = Copied<Iter<'a, PathSegment>>;

    #[inline]
    fn into_iter(self) -> Self::IntoIter {
        self.segments.iter().copied()
    }
}
