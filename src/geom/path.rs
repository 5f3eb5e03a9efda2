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
//! A path is a slice in the caller's memory. Its contours, and the vertices of each, are found while somebody iterates
//! over them; nothing is stored. How curves become lines, and how close those are, is told in
//! [`flatten`](super::flatten).

use super::{flatten::Contour, view::View, PointFx};
use crate::span::Rect;

/// One step of a [`Path`].
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum PathSegment {
    /// Ends the contour, if there is one, and begins another here.
    MoveTo(PointFx),
    /// A straight side.
    LineTo(PointFx),
    /// A quadratic Bézier curve: control point, end.
    QuadraticTo(PointFx, PointFx),
    /// A cubic Bézier curve: two control points, end.
    CubicTo(PointFx, PointFx, PointFx),
    /// Joins the end of the contour to its start. What follows without a move starts there too.
    Close,
}

/// Contours of lines and curves, borrowed. A path that does not begin with a move begins at (0, 0).
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
pub struct Path<'a> {
    segments: &'a [PathSegment],
}

impl<'a> Path<'a> {
    /// The path that these segments make.
    #[inline]
    pub const fn new(segments: &'a [PathSegment]) -> Self {
        Self { segments }
    }

    /// What it is made of.
    #[inline]
    pub const fn segments(self) -> &'a [PathSegment] {
        self.segments
    }

    /// Its contours, one after the other; each is an iterator over vertices. A move that nothing follows is no contour.
    #[inline]
    pub const fn contours(self) -> Contours<'a> {
        Contours { rest: self.segments, start: PointFx::from_bits(0, 0), view: View::ALL }
    }

    /// The same for a fill that only `window` will show: the pixels there are the same, the vertices that do not matter to
    /// them are fewer, and their number depends on the window instead of on the size of the curves.
    #[inline]
    pub fn contours_in(self, window: Rect) -> Contours<'a> {
        Contours { view: View::of(window, 0), ..self.contours() }
    }

    /// For what is drawn up to `reach` units around its lines.
    #[inline]
    pub(crate) fn contours_near(self, window: Rect, reach: u32) -> Contours<'a> {
        Contours { view: View::of(window, reach), ..self.contours() }
    }
}

/// The contours of a [`Path`].
#[derive(Clone, Debug)]
pub struct Contours<'a> {
    rest: &'a [PathSegment],
    /// Where a contour without a move starts.
    start: PointFx,
    view: View,
}

impl<'a> Iterator for Contours<'a> {
    type Item = Contour<'a>;

    #[inline(never)]
    fn next(&mut self) -> Option<Contour<'a>> {
        while let [PathSegment::MoveTo(start), rest @ ..] = self.rest {
            (self.start, self.rest) = (*start, rest);
        }
        let (mut len, mut closed) = (0_usize, false);
        for segment in self.rest {
            match segment {
                PathSegment::MoveTo(_) => break,
                PathSegment::Close => closed = true,
                _ => {}
            }
            len = len.wrapping_add(1);
            if closed {
                break;
            }
        }
        let (segments, rest) = self.rest.split_at_checked(len).filter(|_| len > 0)?;
        self.rest = rest;
        Some(Contour::new(self.start, segments, closed, self.view))
    }
}
