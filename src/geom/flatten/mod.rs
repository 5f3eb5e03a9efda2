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
//!     |W x c| / 4 |c| + w T^2 / 16 <= D  and  |W c| <= |c|^2,    T = (|W(0) x c| + |W(1) x c|) / |c|^2 < 1
//!     or  |W| <= 8
//! ```
//! T is the angle that the part turns by. Between the offsets of its ends, which are w / 2 long, a border turns by it too, and bends
//! from its chord by w T^2 / 16 more than the part does from its own. That summand takes at most 3/4 of D. For thin strokes, up to
//! 1.25 pixels, it is `w T^2` instead: then one line turns so little that its straight sides hardly differ from the curve's. A part
//! that is flat by the second line only is a cusp, or nearly one: what turns there is a join.
//!
//! Where `w |V x c| >= m |c|^2` for V = W(0) or W(1), m being the longer component of c, the radius of the curve may be less than
//! w / 2, and the inner border may go backwards. There the part has to turn evenly as well: with
//! `w |(W(0) - W(1)) x c| <= 192 |c|^2` no offset ends more than 24 units from where it would if the part turned evenly.
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

use core::{iter::Copied, num::NonZeroU32, slice::Iter};

use super::{
    path::{Path, PathSegment},
    point::{bits, PointFx},
    view::View,
};
use crate::{
    num::{
        cast::{low_u32, magnitude, narrow, saturate, signed, unsigned},
        round::{difference, div_rem_wide},
        wide::times,
    },
    span::Rect,
    tune::COMPACT,
};

/// Whether small curves are followed in 32 bits; built for size, all are in 64.
const NARROW: bool = !COMPACT;
/// 4 D is `2^7` units for strokes.
const FOUR_D_BITS: u32 = 7;
/// Strokes up to this width, in units, are thin.
pub(crate) const THIN: u32 = 320;
/// Times are in units of `2^-20`.
const TIME_BITS: u32 = 20;
/// The time at the end of a curve.
const END: u32 = 1 << TIME_BITS;

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
    curve: Option<Bezier>,
    closed: bool,
    view: View,
    width: u32,
}

/// Which way a curve goes at a place: a vector of any length.
pub(crate) type Way = (i64, i64);

/// A vertex, and whether it lies inside of a curve, where the path has no corner.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) struct Knot {
    pub(crate) at: PointFx,
    pub(crate) smooth: bool,
}

impl<I: Segments, const WIDE: bool> Contour<I, WIDE> {
    #[inline]
    fn new(start: PointFx, segments: I, left: usize, closed: bool, view: View) -> Self {
        Self { start: Some(start), at: start, segments, left, curve: None, closed, view, width: 0 }
    }

    /// Of the stroke, or 0. Where there is none it is a constant: then a fill links nothing that is for strokes.
    #[inline(always)]
    const fn width(&self) -> u32 {
        if WIDE {
            self.width
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
        self.curve.as_ref()
    }

    /// The same up to the last part of it that a view may show. What comes behind is left out, and with it the closing side. A
    /// segment between corners that are not hidden counts as shown. Curves are followed `everywhere` or where they may show.
    #[inline]
    pub(crate) fn front(self, view: View, everywhere: bool, hides_corner: impl Fn(PointFx) -> bool) -> Front<I, WIDE> {
        let contour = if everywhere { Self { view: self.view.everywhere(), ..self } } else { self };
        let mut front = Front { contour, view, until: None };
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
            if let Some(knot) = self.curve.as_mut().and_then(|curve| curve.next(&self.view, width)) {
                return Some(knot);
            }
            let from = self.at;
            self.at = match self.next_segment()? {
                PathSegment::LineTo(to) => {
                    (self.at, self.curve) = (to, None);
                    return Some(Knot { at: to, smooth: false });
                }
                PathSegment::QuadraticTo(c, to) => {
                    self.curve = Some(Bezier::quadratic([from, c, to], &self.view));
                    to
                }
                PathSegment::CubicTo(c, d, to) => {
                    self.curve = Some(Bezier::cubic([from, c, d, to], &self.view));
                    to
                }
                PathSegment::MoveTo(_) | PathSegment::Close => {
                    self.curve = None;
                    return None;
                }
            };
        }
    }
}

/// The front of a contour, up to the last part that a view may show.
#[derive(Clone, Debug)]
pub(crate) struct Front<I, const WIDE: bool> {
    contour: Contour<I, WIDE>,
    view: View,
    /// The end of the last part of the last curve that the view may show.
    until: Option<u32>,
}

impl<I: Segments, const WIDE: bool> Front<I, WIDE> {
    /// Takes a few comparisons a segment.
    fn leave_out(&mut self, hides_corner: impl Fn(PointFx) -> bool) {
        let contour = &mut self.contour;
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
        if let Some(curve) = self.contour.curve.as_ref().filter(|curve| is_last && curve.part.done == curve.part.pieces)
        {
            let until = *self.until.get_or_insert_with(|| curve.seen_until(&self.view, self.contour.width()));
            if curve.part.end() >= until {
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

/// A curve that is being cut into pieces. Times are in units of 2^-20.
#[derive(Clone, Debug)]
pub struct Bezier {
    x: Polynomial,
    y: Polynomial,
    /// The part whose pieces come now.
    part: Section,
    /// When the last piece began.
    from: u32,
    /// Where it ended.
    last: PointFx,
    /// A time, and the point of the curve then: the end of the part that was examined last. When a part is halved, its
    /// second half ends where it did, and the point is not computed again.
    ahead: (u32, PointFx),
    /// All control points lie in the view, and with them every part.
    is_inside: bool,
    /// Bends can be computed in 32 bits.
    is_small: bool,
}

/// A part of a curve, from time `start` on and `2^level` units of time long. It has so many `pieces`, of which some are
/// done.
#[derive(Copy, Clone, Debug)]
struct Section {
    start: u32,
    level: u32,
    pieces: u32,
    done: u32,
}

impl Section {
    fn end(self) -> u32 {
        self.start.wrapping_add(1_u32.wrapping_shl(self.level))
    }

    /// The time when so many of its pieces are done. A curve from its end to its start is cut at the same times.
    fn time(self, done: u32) -> u32 {
        let Some(pieces) = NonZeroU32::new(self.pieces) else { return self.start };
        self.start.wrapping_add(done.wrapping_shl(self.level).wrapping_add(self.pieces >> 1) / pieces)
    }
}

impl Bezier {
    fn quadratic(points: [PointFx; 3], view: &View) -> Self {
        let [(ax, ay), (bx, by), (cx, cy)] = points.map(bits);
        let (x, y) = (Polynomial::quadratic([ax, bx, cx]), Polynomial::quadratic([ay, by, cy]));
        Self::new(x, y, (points[0], points[2]), points.iter().all(|&p| view.holds(p)))
    }

    fn cubic(points: [PointFx; 4], view: &View) -> Self {
        let [(ax, ay), (bx, by), (cx, cy), (dx, dy)] = points.map(bits);
        let (x, y) = (Polynomial::cubic([ax, bx, cx, dx]), Polynomial::cubic([ay, by, cy, dy]));
        Self::new(x, y, (points[0], points[3]), points.iter().all(|&p| view.holds(p)))
    }

    fn new(x: Polynomial, y: Polynomial, (start, end): (PointFx, PointFx), is_inside: bool) -> Self {
        let is_small = NARROW && x.is_small() && y.is_small();
        let part = Section { start: 0, level: 0, pieces: 0, done: 0 };
        Self { x, y, part, from: 0, last: start, ahead: (END, end), is_inside, is_small }
    }

    /// The end of the next piece; `None` at the end of the curve.
    fn next(&mut self, view: &View, width: u32) -> Option<Knot> {
        let start = self.part.time(self.part.done);
        if self.part.done == self.part.pieces {
            if start == END {
                return None;
            }
            self.part = self.next_part(start, view, width);
        }
        self.from = start;
        self.part.done = self.part.done.wrapping_add(1);
        let time = self.part.time(self.part.done);
        self.last = if time == self.ahead.0 { self.ahead.1 } else { self.at(time) };
        Some(Knot { at: self.last, smooth: time != END })
    }

    /// The part that starts here and is not halved, because it is flat, bends evenly, or lies beside the view.
    fn next_part(&mut self, start: u32, view: &View, width: u32) -> Section {
        // Of the parts that halving makes, the longest that starts here: those around it were halved before.
        let mut part = Section { start, level: (start | END).trailing_zeros(), pieces: 0, done: 0 };
        loop {
            let end = part.end();
            if self.ahead.0 != end {
                self.ahead = (end, self.at(end));
            }
            let bends = self.bends(part);
            part.pieces = bends.pieces(self.last, self.ahead.1, view.tolerance, width);
            if part.pieces == 0 && !self.is_inside && bends.lie_beside(view, self.last, self.ahead.1) {
                part.pieces = 1;
            }
            if part.pieces != 0 {
                return part;
            }
            part.level = part.level.wrapping_sub(1);
        }
    }

    /// The end of the last part that the view may show, as far as halving tells.
    fn seen_until(&self, view: &View, width: u32) -> u32 {
        let (mut end, mut to, mut level) = (END, self.at(END), TIME_BITS);
        loop {
            let start = end.wrapping_sub(1_u32.wrapping_shl(level));
            let (part, from) = (Section { start, level, pieces: 0, done: 0 }, self.at(start));
            let bends = self.bends(part);
            if bends.lie_beside(view, from, to) {
                if start == 0 {
                    return 0;
                }
                (end, to, level) = (start, from, start.trailing_zeros());
            } else if bends.pieces(from, to, view.tolerance, width) != 0 {
                return end;
            } else {
                level = level.wrapping_sub(1);
            }
        }
    }

    /// W(1/3) and W(2/3) of a part.
    fn bends(&self, part: Section) -> Bends {
        let length = 1_u32.wrapping_shl(part.level);
        let first = part.start.wrapping_mul(3).wrapping_add(length);
        let down = TIME_BITS.wrapping_sub(part.level) << 1;
        let bends = |time| {
            if self.is_small {
                (self.x.small_bend(time, down), self.y.small_bend(time, down))
            } else {
                (self.x.bend(time, down), self.y.bend(time, down))
            }
        };
        Bends(bends(first), bends(first.wrapping_add(length)))
    }

    /// Which way it goes at the start and at the end of the piece that came last. (0, 0) inside of the curve, if only its own ends are
    /// asked for.
    pub(crate) fn ways(&self, only_ends: bool) -> [Way; 2] {
        let way = |time, is_end| if only_ends && time != 0 && time != END { (0, 0) } else { self.way(time, is_end) };
        [way(self.from, false), way(self.part.time(self.part.done), true)]
    }

    /// Which way it goes where the piece that came last passes a place beside it, as seen along a vector of 30 bits: within a
    /// 2^12th of its time.
    #[inline(never)]
    pub(crate) fn way_beside(&self, place: PointFx, along: (i32, i32)) -> Way {
        let (place, mut from, mut to) = (bits(place), self.from, self.part.time(self.part.done));
        for _ in 0..12 {
            let middle = from.wrapping_add(to) >> 1;
            let at = bits(self.at(middle));
            let product = |n: i32, m: i32, u: i32| difference(n, m).wrapping_mul(i64::from(u >> 2));
            if product(at.0, place.0, along.0).wrapping_add(product(at.1, place.1, along.1)) < 0 {
                from = middle;
            } else {
                to = middle;
            }
        }
        self.way(to, true)
    }

    /// How much longer than its chord the piece that came last is, in units of 2^-16 pixel, if it is a part as a whole. The length of
    /// the chord is given in units.
    ///
    /// A curve that turns evenly by a small angle T is longer by the T^2 / 24th part, and T is `2 |W x c| / |c|^2`.
    #[inline(never)]
    pub(crate) fn excess(&self, from: PointFx, length: u64) -> u64 {
        let Ok(length) = u32::try_from(length) else { return 0 };
        let Some(length) = NonZeroU32::new(length) else { return 0 };
        let (Bends(first, second), (a, b)) = (self.bends(self.part), (bits(from), bits(self.last)));
        let sum = |p: i32, q: i32| i64::from(p).wrapping_add(q.into());
        let (w, c) = ((sum(first.0, second.0), sum(first.1, second.1)), (difference(b.0, a.0), difference(b.1, a.1)));
        let across = w.0.wrapping_mul(c.1).wrapping_sub(w.1.wrapping_mul(c.0)).unsigned_abs();
        // 16 |W x c| / |c|, below 2^15 for parts that are flat.
        let (bend, _) = div_rem_wide(across << 3, length);
        let (bend, length) = (bend.min(0xffff), length.get());
        // bend^2 / 6 length.
        NonZeroU32::new(length.saturating_mul(6)).map_or(0, |divisor| u64::from(bend.wrapping_mul(bend) / divisor))
    }

    /// Which way it goes at a time. Where it stands still for a moment, it goes one way before, and perhaps another way after.
    #[inline(never)]
    fn way(&self, time: u32, before: bool) -> Way {
        let slope = (self.x.slope(time), self.y.slope(time));
        if slope != (0, 0) {
            return slope;
        }
        let bend = |p: &Polynomial| {
            let bend = p.a.wrapping_mul(3).wrapping_mul(i64::from(time)).wrapping_add(p.b << TIME_BITS);
            if before {
                bend.wrapping_neg()
            } else {
                bend
            }
        };
        match (bend(&self.x), bend(&self.y)) {
            (0, 0) => (self.x.a, self.y.a),
            bend => bend,
        }
    }

    fn at(&self, t: u32) -> PointFx {
        #[cfg(test)]
        crate::num::tally::add(crate::num::tally::Work::Point);
        PointFx::from_bits(self.x.at(t), self.y.at(t))
    }
}

/// W(1/3) and W(2/3) of a part. A coordinate that does not fit is the largest there is.
struct Bends((i32, i32), (i32, i32));

impl Bends {
    /// How many pieces the part between two places is cut into; 0 if it is halved instead. 4 D is `2^tolerance`.
    ///
    /// Coordinates of W and of the chord are below 2^15: sums of two products fit 31 bits.
    #[inline(always)]
    fn pieces(&self, from: PointFx, to: PointFx, tolerance: u32, width: u32) -> u32 {
        let &Self(first, second) = self;
        if !are_small(first, second) {
            return 0;
        }
        if width != 0 {
            return u32::from(self.is_flat_beside(from, to, width));
        }
        let (c, scale) = chord(bits(from), bits(to));
        let square = product(c, c);
        let flat = |w: (i32, i32)| {
            let least = 1_u32.wrapping_shl(tolerance.wrapping_mul(2));
            if square < least {
                return product(w, w) <= least;
            }
            let across = cross(w, c).unsigned_abs().wrapping_shr(tolerance);
            let along = product(w, c).wrapping_shr(scale);
            along <= square && across >> 16 == 0 && across.wrapping_mul(across) <= square
        };
        if flat(first) && flat(second) {
            return 1;
        }
        // W is linear: W(0) = 2 W(1/3) - W(2/3), and W(1) = 2 W(2/3) - W(1/3).
        let on = |p: i32, q: i32| p.wrapping_mul(2).wrapping_sub(q);
        let start = (on(first.0, second.0), on(first.1, second.1));
        let end = (on(second.0, first.0), on(second.1, first.1));
        if !are_small(start, end) {
            return 0;
        }
        let longer = product(start, start).max(product(end, end));
        let mut pieces = 1_u32;
        // The lowest m with |W| <= 4 D m^2, both sides squared.
        while pieces.wrapping_mul(pieces).wrapping_shl(tolerance).wrapping_pow(2) < longer {
            pieces = pieces.wrapping_add(1);
        }
        let (p, q) = (cross(start, c), cross(end, c));
        let across = u64::from(p.unsigned_abs().min(q.unsigned_abs()));
        let even = p ^ q >= 0 && across.wrapping_mul(across) > u64::from(longer).wrapping_mul(u64::from(square)) >> 4;
        if pieces == 2 || even && pieces <= 16 {
            pieces
        } else {
            0
        }
    }

    /// Whether the part between two places is flat, and so are the borders of a stroke beside it. Coordinates of W are below 2^15.
    #[inline(never)]
    fn is_flat_beside(&self, from: PointFx, to: PointFx, width: u32) -> bool {
        let &Self(first, second) = self;
        if product(first, first) <= 64 && product(second, second) <= 64 {
            return true;
        }
        let (c, scale) = chord(bits(from), bits(to));
        let Some(square) = NonZeroU32::new(product(c, c)) else { return false };
        let is_along = |w: (i32, i32)| product(w, c).wrapping_shr(scale) <= square.get();
        if !(is_along(first) && is_along(second)) {
            return false;
        }
        // W is linear. The coordinates of W(0) and W(1) are below 2^17, and their products with c below 2^33.
        let across = |w: (i32, i32)| {
            let product = |a: i32, b: i32| i64::from(a).wrapping_mul(i64::from(b));
            product(w.0, c.1).wrapping_sub(product(w.1, c.0))
        };
        let on = |p: i32, q: i32| p.wrapping_mul(2).wrapping_sub(q);
        let start = across((on(first.0, second.0), on(first.1, second.1)));
        let end = across((on(second.0, first.0), on(second.1, first.1)));
        let (uneven, wide) = (start.abs_diff(end), u64::from(width));
        let (start, end) = (start.unsigned_abs(), end.unsigned_abs());
        // Where the inner border may turn back, it does not turn unevenly.
        let longer = u64::from(c.0.unsigned_abs().max(c.1.unsigned_abs()));
        let sharp = start.max(end).wrapping_mul(wide).wrapping_shr(2_u32.wrapping_mul(scale));
        if sharp >= longer.wrapping_mul(square.get().into())
            && uneven.wrapping_mul(wide).wrapping_shr(scale) > u64::from(square.get()).wrapping_mul(192)
        {
            return false;
        }
        // In units of 2^-12.
        let sum = (start.wrapping_add(end) << 12).wrapping_shr(scale);
        if sum >= u64::from(square.get()) << 12 {
            return false;
        }
        let (turn, _) = div_rem_wide(sum, square);
        // 4 (D - w T^2 / 16), rounded up.
        let down = if width <= THIN { 22 } else { 26 };
        let turned = u64::from(turn.wrapping_mul(turn)).wrapping_mul(u64::from(width)).wrapping_shr(down);
        // At least a quarter of D is left for the curve itself.
        let Some(rest) = (1_u64 << FOUR_D_BITS).checked_sub(turned).filter(|&rest| rest >= 32) else { return false };
        let flat = |w: (i32, i32)| {
            let across = across(w).unsigned_abs();
            across.wrapping_mul(across) <= rest.wrapping_mul(rest).wrapping_mul(u64::from(square.get()))
        };
        flat(first) && flat(second)
    }

    /// Whether the part between two places, which has these bends, lies on one side of the view as a whole.
    fn lie_beside(&self, view: &View, from: PointFx, to: PointFx) -> bool {
        let &Self((a, b), (c, d)) = self;
        let size = [b, c, d].into_iter().fold(a.unsigned_abs(), |size, n| size.max(n.unsigned_abs()));
        // It is within |W| / 4 of the chord, in x and in y alike; the 3 units are for the rounding of W and of both
        // ends.
        size < unsigned(i32::MAX) && view.hides(from, to, i64::from(size >> 2).wrapping_add(3))
    }
}

/// Whether all coordinates are from -2^15 to below 2^15.
#[inline(always)]
fn are_small(a: (i32, i32), b: (i32, i32)) -> bool {
    let beyond = |n: i32| unsigned(n).wrapping_add(1 << 15) >> 16;
    beyond(a.0) | beyond(a.1) | beyond(b.0) | beyond(b.1) == 0
}

/// The vector from one place to another, its coordinates in 15 bits and a sign, and how many low bits they lost for
/// that.
fn chord(from: (i32, i32), to: (i32, i32)) -> ((i32, i32), u32) {
    let (x, y) = (from.0.abs_diff(to.0), from.1.abs_diff(to.1));
    let lost = 17_u32.saturating_sub((x | y).leading_zeros());
    let side = |length: u32, back: bool| {
        let length = signed(length.wrapping_shr(lost));
        if back {
            length.wrapping_neg()
        } else {
            length
        }
    };
    ((side(x, to.0 < from.0), side(y, to.1 < from.1)), lost)
}

/// The cross product of two vectors.
#[inline(always)]
fn cross(a: (i32, i32), b: (i32, i32)) -> i32 {
    a.0.wrapping_mul(b.1).wrapping_sub(a.1.wrapping_mul(b.0))
}

/// The magnitude of the scalar product of two vectors.
#[inline(always)]
fn product(a: (i32, i32), b: (i32, i32)) -> u32 {
    a.0.wrapping_mul(b.0).wrapping_add(a.1.wrapping_mul(b.1)).unsigned_abs()
}

/// The second difference of three control points, `a - 2 b + c`: below 2^33.
fn second_difference([a, b, c]: [i32; 3]) -> i64 {
    difference(a, b).wrapping_add(difference(c, b))
}

/// One coordinate of a curve as a function of the time t: `((a t + b) t + c) t + d`.
#[derive(Copy, Clone, Debug)]
struct Polynomial {
    a: i64,
    b: i64,
    c: i64,
    d: i32,
}

impl Polynomial {
    fn quadratic(p: [i32; 3]) -> Self {
        Self { a: 0, b: second_difference(p), c: difference(p[1], p[0]) << 1, d: p[0] }
    }

    fn cubic([p0, p1, p2, p3]: [i32; 4]) -> Self {
        let c = difference(p1, p0).wrapping_mul(3);
        let b = second_difference([p0, p1, p2]).wrapping_mul(3);
        Self { a: difference(p3, p0).wrapping_sub(difference(p2, p1).wrapping_mul(3)), b, c, d: p0 }
    }

    /// A coordinate of W, `h^2 P''/2`, for a part that takes the time h, with `h^2 = 2^-down`. P'' is taken at the time
    /// `time / 3`, in units of 2^-20.
    ///
    /// `P''/2 = 3 a t + b`, which is `a time + b`. When both coefficients are [small](Self::is_small), everything fits
    /// 31 bits.
    #[inline(always)]
    fn small_bend(&self, time: u32, down: u32) -> i32 {
        let by_time = i64::from(narrow(self.a)).wrapping_mul(i64::from(time)) >> TIME_BITS;
        narrow(self.b).wrapping_add(narrow(by_time)).wrapping_shr(down)
    }

    /// The same for any coefficients: the sum is below 2^36, and the product below 2^56, before they are shifted.
    #[inline(never)]
    fn bend(&self, time: u32, down: u32) -> i32 {
        let by_time = self.a.wrapping_mul(i64::from(time)) >> TIME_BITS;
        saturate(self.b.wrapping_add(by_time).wrapping_shr(down))
    }

    /// Whether both coefficients of the second derivative are below 2^28.
    fn is_small(&self) -> bool {
        (self.a.unsigned_abs() | self.b.unsigned_abs()) >> 28 == 0
    }

    /// Its slope at `t / 2^20`, times 2^8, rounded towards zero: below 2^44.
    ///
    /// `3 a t + 2 b` is below 2^38, and times 2^20 it has 58 bits. Times t, and with the slope at the start, `c 2^40`, it has 80.
    fn slope(&self, t: u32) -> i64 {
        let first = self.a.wrapping_mul(3).wrapping_mul(i64::from(t)).wrapping_add(self.b << (TIME_BITS + 1));
        let (high, low) = times((first >> 32, low_u32(magnitude(first))), t);
        let slope = high.wrapping_add(self.c << (2 * TIME_BITS - 32));
        slope.wrapping_add(i64::from(slope < 0 && low != 0))
    }

    /// Its value at `t / 2^20`, rounded to nearest.
    ///
    /// `a t + b` is below 2^36, and times 2^20 it has 56 bits. `(a t + b) t + c` is the slope of the chord from the
    /// start of the curve to here, below 2^35, and times 2^40 it has 75 bits. The third product is the way from the
    /// start to here: below 2^32, and 2^92 when times 2^60.
    #[inline(never)]
    fn at(self, t: u32) -> i32 {
        let first = self.a.wrapping_mul(i64::from(t)).wrapping_add(self.b << TIME_BITS);
        let (high, low) = times((first >> 32, low_u32(magnitude(first))), t);
        let (high, _) = times((high.wrapping_add(self.c << (2 * TIME_BITS - 32)), low), t);
        // The low word is dropped: it never changes what is rounded down here.
        narrow(i64::from(self.d).wrapping_add(high.wrapping_add(1 << 27) >> 28))
    }
}
