//! Curves to lines, within a tolerance, on the grid of 1/256 pixel.
//!
//! A Bézier curve is a function of time: P(t) for t from 0 to 1. It is cut in the middle of its time, the halves are
//! cut in the middle of theirs, and so on, until each part is *flat* or *bends evenly*. A flat part becomes its chord,
//! the straight line between its ends. A part that bends evenly becomes a few chords of equal time.
//! ```text
//!            _.-o-._
//!         .o'       'o.               o  points on the curve: the ends of the chords
//!       .'             '.
//!      o                 'o           from 0 to 1/2 it bends evenly: 3 chords; from 1/2 to 3/4 one is enough
//!                           '-o-....__o
//! ```
//! **Symbols**, for the part from time t to time t + h:
//! ```text
//!     c       its chord as a vector: P(t + h) - P(t)
//!     s       time within the part, from 0 at its start to 1 at its end
//!     W(s)    its bend, a vector: h^2 P''(t + s h) / 2, half of the second derivative by s; linear in s
//!     D       the tolerance: 32 units; 2 for coverage
//!     a x b   the cross product ax by - ay bx;   a b   the scalar product ax bx + ay by;   |a|   the length of a
//! ```
//! **How far a part is from its chord.** The inner control points of the part are the points at one and two thirds of
//! its chord, less W(1/3) / 3 and W(2/3) / 3. So at time s the curve is
//! ```text
//!     s (1 - s) ((1 - s) W(1/3) + s W(2/3))
//! ```
//! away from the point at s of the chord, and s (1 - s) is 1/4 at most: with the longer of these two W, never farther
//! than
//! |W| / 4. If, besides, both control points lie between the ends of the chord, as seen along it, then only the distance across
//! the chord counts, with the W that is larger across it: |W x c| / (4 |c|).
//!
//! **Flat** is a part when, for both W(1/3) and W(2/3),
//! ```text
//!     |W x c| / 4 D <= |c|  and  |W c| <= |c|^2      if |c| >= 4 D
//!     |W| <= 4 D                                     if |c| < 4 D
//! ```
//! **Bends evenly.** If a part is not flat, let W be the longer one of W(0) and W(1). In m pieces of equal time, h is m
//! times less and bends are m^2 times less: each piece is within |W| / (4 m^2) of its chord. The fewest pieces are the
//! lowest m with |W| <= 4 D m^2. The part bends evenly if m is 2; or if m is at most 16, both W(0) and W(1) point to
//! the same side of the chord, and `4 |V x c| > |W| |c|`, V being the one of the two with the smaller product: both
//! point across the chord rather than along it. Then pieces of equal time are hardly more than there must be.
//!
//! **For strokes** the borders beside the curve count too: they bend with it, the outer one more. A curve for a stroke of the
//! width w is halved until each part is flat in this sense:
//! ```text
//!     |W x c| / 4 |c| + w m^2 / 4 <= D  and  |W c| <= |c|^2,    m = max(p, q) < 1
//!     p = |W(1/3) x c| / c (c - W(1/3))       q = |W(2/3) x c| / c (c + W(2/3))
//!     or  |W| <= 8
//! ```
//! The ways at both ends are c - W(1/3) and c + W(2/3): p and q are the tangents of their angles with the chord. Between the offsets of
//! its ends, which are w / 2 long, a border bends from its chord by `w m^2 / 4` more than the part does from its own. That summand takes
//! at most 3/4 of D. For thin strokes, up to 1.25 pixels, it is `4 w m^2` instead: then one line turns so little that its straight sides
//! hardly differ from the curve's. A part that is flat by the third line only may turn by any angle: there the pen turns on the spot, see
//! [`stroke`](crate::raster::stroke).
//!
//! Where `w (p + q) / 2 >= l`, l being the longer component of c, the radius of the curve may be less than w / 2, and the inner border
//! may go backwards. There, and where one end of a part has less than 3/4 of its mean speed, the part has to turn evenly as well: with
//! `w |p - q| <= 64` no offset ends more than some units from where it would if the part turned evenly.
//!
//! At the end of each line the *way* of the curve is known. It is the first of these that is not 0: P'; P'', which counts backwards
//! before that time; the third derivative.
//!
//! **Rounding.** The coordinates of all W and the quotient by 4 D are rounded down to whole numbers. A part with a
//! coordinate of W that is not within 2^15 is neither flat nor even: it is halved. Where a coordinate of c has more
//! than 15 bits, both lose as many low bits as the longer one has too many, and W c loses as many. Piece i of m ends at
//! time `t + i h / m`, rounded to the nearest 2^-20.
//!
//! A vertex is the exact point of the curve, rounded to the nearest unit (halves upwards). With everything that is
//! rounded above, lines stay within 34.6 units (0.136 pixels) of the curve; for coverage, within 3.3 units (1/77 pixel), or 4.3
//! where a chord is longer than 128 pixels. A curve and the same curve from its end to
//! its start have the same vertices: shapes that share it leave no gap.
//!
//! **Work.** A curve has 2^15 pieces at most, or 2^17 for coverage, when its control points are at the ends of the type, and fewer
//! halvings than pieces. A part that lies as a whole on one side of the window, tolerance included, becomes its chord however
//! much it bends. That changes no pixel of a fill: of what lies left of the window it only matters how often a row is
//! crossed in each direction, and the ends of the part decide that; what lies above, below or right of the window does
//! not matter.
//!
//! Range: any `I24F8`. Points are sums below 2^93, in words of 64 and 32 bits.
//!
//! Sources: G. Farin, "Curves and Surfaces for CAGD", 1988 (halving, chords, second differences).

use core::{iter::Copied, slice::Iter};

mod bends;
mod bezier;
mod polynomial;

pub use self::bezier::Bezier;
pub(crate) use self::{
    bends::THIN,
    bezier::{Knot, Way},
};
use super::{
    path::{Path, PathSegment},
    point::PointFx,
    view::View,
};
use crate::span::Rect;

/// What a path can be made of: an iterator over segments that can be gone over again, such as that of a [`Path`], of an array, of
/// an [`Svg`](super::svg::Svg), or any of these [mapped](super::affine::Affine::path).
///
/// It says `None` again behind its end, as iterators usually do.
pub trait Segments: Iterator<Item = PathSegment> + Clone {}

impl<I: Iterator<Item = PathSegment> + Clone> Segments for I {}

/// The segments of a [`Path`].
pub type Slice<'a> = Copied<Iter<'a, PathSegment>>;

impl<'a> Path<'a> {
    /// Its contours, one after the other; each is an iterator over vertices. A move that nothing follows is no contour.
    #[inline]
    pub fn contours(self) -> Contours<Slice<'a>> {
        Contours::new(self)
    }

    /// The contours for a fill of which only `window` is seen: see [`Contours::within`].
    #[inline]
    pub fn contours_in(self, window: Rect) -> Contours<Slice<'a>> {
        Contours::within(self, window)
    }

    /// The contours for a fill with soft rims, of which only `window` is seen: see [`Contours::finely_within`].
    #[inline]
    pub fn fine_contours_in(self, window: Rect) -> Contours<Slice<'a>> {
        Contours::finely_within(self, window)
    }
}

impl<I: Segments> Contours<I> {
    /// The contours of any path, one after the other.
    /// ```
    /// use embedded_raster::{geom::Contours, PathSegment::*, PointFx};
    /// let zigzag = (0..5).map(|i| if i == 0 { MoveTo(PointFx::px(0, 0)) } else { LineTo(PointFx::px(i, i & 1)) });
    /// let lengths: Vec<usize> = Contours::new(zigzag).map(|contour| contour.count()).collect();
    /// assert_eq!(lengths, [5]);
    /// ```
    #[inline]
    pub fn new(path: impl IntoIterator<IntoIter = I>) -> Self {
        Self { rest: path.into_iter(), start: PointFx::from_bits(0, 0), view: View::ALL, width: 0 }
    }

    /// The contours for a fill of which only `window` is seen. It has the same pixels there with fewer vertices: curves
    /// beside the window are not followed, so the number of vertices depends on the window and not on the size of the
    /// curves.
    #[inline]
    pub fn within(path: impl IntoIterator<IntoIter = I>, window: Rect) -> Self {
        Self { view: View::of(window, 0), ..Self::new(path) }
    }

    /// The contours for a fill with soft rims, of which only `window` is seen: cut finer. See [`flatten`](self).
    #[inline]
    pub fn finely_within(path: impl IntoIterator<IntoIter = I>, window: Rect) -> Self {
        Self { view: View::of(window, 0).finely(), ..Self::new(path) }
    }

    /// The contours for something that is drawn up to `reach` units (1/256 pixel) around them, of which only `window`
    /// is seen.
    #[inline]
    pub(crate) fn near(path: impl IntoIterator<IntoIter = I>, window: Rect, reach: u32) -> Self {
        Self { view: View::of(window, reach), ..Self::new(path) }
    }

    /// The same for a stroke of this width, in units.
    #[inline]
    pub(crate) fn wide(
        path: impl IntoIterator<IntoIter = I>,
        window: Rect,
        reach: u32,
        width: u32,
    ) -> Contours<I, true> {
        let Self { rest, start, view, .. } = Self::near(path, window, reach);
        Contours { rest, start, view, width }
    }
}

/// The contours of a path; those for a stroke are `WIDE`.
#[derive(Clone, Debug)]
pub struct Contours<I, const WIDE: bool = false> {
    rest: I,
    /// Where a contour without a move starts.
    start: PointFx,
    view: View,
    /// Of a stroke, or 0.
    width: u32,
}

impl<I: Segments, const WIDE: bool> Iterator for Contours<I, WIDE> {
    type Item = Contour<I, WIDE>;

    #[inline(never)]
    fn next(&mut self) -> Option<Contour<I, WIDE>> {
        let mut segments = self.rest.clone();
        while let Some(PathSegment::MoveTo(start)) = self.rest.next() {
            (self.start, segments) = (start, self.rest.clone());
        }
        self.rest = segments.clone();
        let (mut len, mut closed) = (0_usize, false);
        while !closed {
            let mut rest = self.rest.clone();
            match rest.next() {
                None | Some(PathSegment::MoveTo(_)) => break,
                Some(segment) => closed = matches!(segment, PathSegment::Close),
            }
            self.rest = rest;
            len = len.wrapping_add(1);
        }
        let (start, view) = (self.start, self.view);
        (len > 0).then(|| Contour { width: self.width, ..Contour::new(start, segments, len, closed, view) })
    }
}

/// The vertices of one contour of a path, from its start on. Where the contour is closed, the start does not come
/// again.
#[derive(Clone, Debug)]
pub struct Contour<I, const WIDE: bool = false> {
    start: Option<PointFx>,
    at: PointFx,
    /// Its segments, and what follows them.
    segments: I,
    /// How many of them are its own.
    left: usize,
    /// The last curve, if `has_curve`. It is set up where it is: one that is moved takes as many words as a contour.
    curve: Bezier,
    has_curve: bool,
    closed: bool,
    view: View,
    width: u32,
}

impl<I: Segments, const WIDE: bool> Contour<I, WIDE> {
    #[inline]
    fn new(start: PointFx, segments: I, left: usize, closed: bool, view: View) -> Self {
        Self {
            start: Some(start),
            at: start,
            segments,
            left,
            curve: Bezier::NONE,
            has_curve: false,
            closed,
            view,
            width: 0,
        }
    }

    /// Of the stroke, at least 1; 0 where there is none. So a fill links nothing that is for strokes, nor a stroke what is for fills.
    #[inline(always)]
    fn width(&self) -> u32 {
        if WIDE {
            self.width.max(1)
        } else {
            0
        }
    }

    #[inline]
    fn next_segment(&mut self) -> Option<PathSegment> {
        self.left = self.left.checked_sub(1)?;
        self.segments.next()
    }

    /// Whether it ends with [`PathSegment::Close`]. A fill closes every contour.
    #[inline]
    pub const fn is_closed(&self) -> bool {
        self.closed
    }

    /// Whether the segment whose vertices come now ends at a place.
    #[inline]
    pub(crate) fn ends_at(&self, v: PointFx) -> bool {
        self.at == v
    }

    /// The curve whose vertices come now, or came last if no segment came after it.
    #[inline]
    pub(crate) fn curve(&self) -> Option<&Bezier> {
        self.has_curve.then_some(&self.curve)
    }

    /// The same up to the last part of it that a view may show. What comes behind is left out, and with it the closing side. A
    /// segment between corners that are not hidden counts as shown. Curves are followed `everywhere` or where they may show.
    #[inline]
    pub(crate) fn front(
        &mut self,
        view: View,
        everywhere: bool,
        hides_corner: impl Fn(PointFx) -> bool,
    ) -> Front<'_, I, WIDE> {
        if everywhere {
            self.view = self.view.everywhere();
        }
        let mut front = Front { contour: self, view, until: None };
        front.leave_out(hides_corner);
        front
    }

    #[inline(never)]
    pub(crate) fn next_knot(&mut self) -> Option<Knot> {
        if let Some(at) = self.start.take() {
            return Some(Knot { at, smooth: false });
        }
        loop {
            let width = self.width();
            if self.has_curve {
                if let Some(knot) = self.curve.next(&self.view, width) {
                    return Some(knot);
                }
            }
            let from = self.at;
            let (points, cubic) = match self.next_segment()? {
                PathSegment::LineTo(to) => {
                    (self.at, self.has_curve) = (to, false);
                    return Some(Knot { at: to, smooth: false });
                }
                PathSegment::QuadraticTo(c, to) => ([from, c, to, to], false),
                PathSegment::CubicTo(c, d, to) => ([from, c, d, to], true),
                PathSegment::MoveTo(_) | PathSegment::Close => {
                    self.has_curve = false;
                    return None;
                }
            };
            self.curve.set(points, cubic, &self.view);
            (self.at, self.has_curve) = (points[3], true);
        }
    }
}

/// The front of a contour, up to the last part that a view may show.
#[derive(Debug)]
pub(crate) struct Front<'a, I, const WIDE: bool> {
    contour: &'a mut Contour<I, WIDE>,
    view: View,
    /// The end of the last part of the last curve that the view may show.
    until: Option<u32>,
}

impl<I: Segments, const WIDE: bool> Front<'_, I, WIDE> {
    /// Takes a few comparisons a segment.
    fn leave_out(&mut self, hides_corner: impl Fn(PointFx) -> bool) {
        let contour = &mut *self.contour;
        let (start, mut at) = (contour.at, contour.at);
        let (mut count, mut seen) = (0_usize, 0);
        for segment in contour.segments.clone().take(contour.left) {
            count = count.wrapping_add(1);
            let (c, d, to) = match segment {
                PathSegment::LineTo(to) => (to, to, to),
                PathSegment::QuadraticTo(c, to) => (c, c, to),
                PathSegment::CubicTo(c, d, to) => (c, d, to),
                PathSegment::MoveTo(_) | PathSegment::Close => (start, start, start),
            };
            if !(self.view.misses(&[at, c, d, to]) && hides_corner(at) && hides_corner(to)) {
                seen = count;
            }
            at = to;
        }
        if seen < contour.left {
            contour.closed = false;
            contour.left = seen;
        }
        if seen == 0 {
            contour.start = None;
        }
    }

    #[inline(never)]
    pub(crate) fn next_knot(&mut self) -> Option<Knot> {
        let is_last = self.contour.left == 0;
        if let Some((curve, end)) = self.contour.curve().filter(|_| is_last).and_then(|c| Some((c, c.done()?))) {
            let until = *self.until.get_or_insert_with(|| curve.seen_until(&self.view, self.contour.width()));
            if end >= until {
                return None;
            }
        }
        self.contour.next_knot()
    }

    /// See [`Contour::curve`].
    #[inline]
    pub(crate) fn curve(&self) -> Option<&Bezier> {
        self.contour.curve()
    }

    /// Whether it ends with [`PathSegment::Close`], and that is not left out.
    #[inline]
    pub(crate) fn is_closed(&self) -> bool {
        self.contour.is_closed()
    }

    /// Whether the segment whose vertices come now ends at a place.
    #[inline]
    pub(crate) fn ends_at(&self, v: PointFx) -> bool {
        self.contour.ends_at(v)
    }
}

impl<I: Segments, const WIDE: bool> Iterator for Contour<I, WIDE> {
    type Item = PointFx;

    #[inline]
    fn next(&mut self) -> Option<PointFx> {
        self.next_knot().map(|knot| knot.at)
    }
}
