//! Curves to lines, within a tolerance, on the grid of 1/256 pixel.
//!
//! A Bézier curve is cut into halves (of its time), those into halves again, until each part is flat, and becomes its chord, or
//! bends evenly, and becomes a few chords of equal time.
//! ```text
//!            _.-o-._
//!         .o'       'o.               o  points on the curve, at its start, its end and the times T
//!       .'             '.
//!      o                 'o           from 0 to 1/2 it bends evenly: 3 pieces; from 1/2 to 3/4 one is enough
//!                           '-o-....__o
//! ```
//! Of the part from t to t + h with the chord c, let `W(s)` be `h^2 P''/2` at t + s h: the control points of the part lie at the
//! thirds of c, less W(1/3) / 3 and W(2/3) / 3. So it is never farther from c than `|W| / 4`, and, if its control points lie between
//! the ends of c, not farther than `|W x c| / 4 |c|`. It is *flat* within `D` units when for both W
//! ```text
//!     |W x c| / 4 D <= |c|  and  |W c| <= |c|^2      if |c| >= 4 D
//!     |W| <= 4 D                                     if |c| < 4 D
//! ```
//! Else let W be that of its ends, W(0) and W(1). One of m pieces is not farther from its chord than the longer W, `/ 4 m^2`: the
//! fewest are m with `|W| <= 4 D m^2`. It *bends evenly* if m is 2, or if m is at most 16 and both W point across the chord, to the
//! same side: `4 |W x c| > |W||c|` for the longer W. There pieces of equal time are hardly more than there must be.
//!
//! All W and the quotient are rounded down to whole numbers, and parts with a coordinate of W not within 2^15 are neither flat nor
//! even. Where a side of the chord has more than 15 bits, both sides lose their low ones, down to 15, and so does W c. D is 32
//! units. Piece i of m ends at `t + i h / m`, rounded to the nearest 2^-20.
//!
//! A vertex is the point of the curve, exactly, rounded to the nearest unit (halves upwards). Together with all that is rounded
//! above, lines stay within 34.6 units (0.136 pixels) of the curve. The same curve from its end to its start has the same
//! vertices: shapes that share it leave no gap.
//!
//! **Work.** A curve has at most 2^15 pieces, as many as the ends of the type can make, and fewer halvings than pieces. A part that
//! lies beside the window with all of its tolerance becomes its chord, whatever its bend. That changes no pixel of a fill:
//! left of the window, how often a row is crossed depends on the two ends only; on the other sides nothing counts.
//!
//! Range: any `I24F8`. Points are sums below 2^93, in words of 64 and 32 bits.
//!
//! Sources: G. Farin, "Curves and Surfaces for CAGD", 1988 (halving, chords, second differences).

use core::{num::NonZeroU32, slice::Iter};

use super::{
    path::{Path, PathSegment},
    point::{bits, PointFx},
    view::View,
};
use crate::{
    num::{
        cast::{low_u32, magnitude, narrow, saturate, signed, unsigned},
        round::difference,
        wide::times,
    },
    rect::Rect,
    target::COMPACT,
};

/// 4 D is `2^7` units.
const FOUR_D: u32 = 7;
/// Bits of the parameter t.
const TIME: u32 = 20;
/// The end of a curve.
const END: u32 = 1 << TIME;

impl<'a> Path<'a> {
    /// Its contours, one after the other; each is an iterator over vertices. A move that nothing follows is no contour.
    #[inline]
    pub const fn contours(self) -> Contours<'a> {
        Contours { rest: self.segments(), start: PointFx::from_bits(0, 0), view: View::ALL }
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

/// The vertices of one contour of a [`Path`](super::Path), the first one included, the closing side not.
#[derive(Clone, Debug)]
pub struct Contour<'a> {
    start: Option<PointFx>,
    at: PointFx,
    segments: Iter<'a, PathSegment>,
    curve: Option<Bezier>,
    closed: bool,
    view: View,
}

/// A vertex, and whether the path goes on smoothly there, inside of a curve.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) struct Knot {
    pub(crate) at: PointFx,
    pub(crate) smooth: bool,
}

impl<'a> Contour<'a> {
    #[inline]
    pub(super) fn new(start: PointFx, segments: &'a [PathSegment], closed: bool, view: View) -> Self {
        Self { start: Some(start), at: start, segments: segments.iter(), curve: None, closed, view }
    }

    /// Whether it ends with [`PathSegment::Close`]. A fill closes every contour.
    #[inline]
    pub const fn is_closed(&self) -> bool {
        self.closed
    }

    #[inline(never)]
    pub(crate) fn next_knot(&mut self) -> Option<Knot> {
        if let Some(at) = self.start.take() {
            return Some(Knot { at, smooth: false });
        }
        loop {
            if let Some(node) = self.curve.as_mut().and_then(|curve| curve.next(&self.view)) {
                return Some(node);
            }
            let from = self.at;
            self.at = match *self.segments.next()? {
                PathSegment::LineTo(to) => {
                    self.at = to;
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
                PathSegment::MoveTo(_) | PathSegment::Close => return None,
            };
        }
    }
}

impl Iterator for Contour<'_> {
    type Item = PointFx;

    #[inline]
    fn next(&mut self) -> Option<PointFx> {
        self.next_knot().map(|node| node.at)
    }
}

/// A curve on its way. Times are in units of 2^-20.
#[derive(Clone, Debug)]
struct Bezier {
    x: Polynomial,
    y: Polynomial,
    part: Section,
    /// Where the pieces so far ended.
    last: PointFx,
    /// The end of the part that was looked at last: of the next one too, if it is the second half of what was halved.
    ahead: (u32, PointFx),
    /// No part of it can leave the view.
    whole: bool,
    /// W can be found in 32 bits.
    small: bool,
}

/// A part of a curve, from `start` on and `2^level` long, after `done` of its pieces.
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

    /// When so many of its pieces are done. From its end to its start, the times are the same.
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

    fn new(x: Polynomial, y: Polynomial, (start, end): (PointFx, PointFx), whole: bool) -> Self {
        let small = !COMPACT && x.is_small() && y.is_small();
        let part = Section { start: 0, level: 0, pieces: 0, done: 0 };
        Self { x, y, part, last: start, ahead: (END, end), whole, small }
    }

    /// The end of the next piece.
    fn next(&mut self, view: &View) -> Option<Knot> {
        if self.part.done == self.part.pieces {
            let start = self.part.time(self.part.done);
            if start == END {
                return None;
            }
            self.part = self.next_part(start, view);
        }
        self.part.done = self.part.done.wrapping_add(1);
        let time = self.part.time(self.part.done);
        self.last = if time == self.ahead.0 { self.ahead.1 } else { self.at(time) };
        Some(Knot { at: self.last, smooth: time != END })
    }

    /// The part from here on that is not halved, because it is flat, bends evenly or cannot be seen.
    fn next_part(&mut self, start: u32, view: &View) -> Section {
        // The largest one that begins here: all that hold it were halved before.
        let mut part = Section { start, level: (start | END).trailing_zeros(), pieces: 0, done: 0 };
        loop {
            let end = part.end();
            if self.ahead.0 != end {
                self.ahead = (end, self.at(end));
            }
            let bends = self.bends(part);
            part.pieces = bends.pieces(self.last, self.ahead.1);
            if part.pieces == 0 && !self.whole && bends.hide(self.last, self.ahead.1, view) {
                part.pieces = 1;
            }
            if part.pieces != 0 {
                return part;
            }
            part.level = part.level.wrapping_sub(1);
        }
    }

    /// W at the thirds of a part.
    fn bends(&self, part: Section) -> Bends {
        let length = 1_u32.wrapping_shl(part.level);
        let first = part.start.wrapping_mul(3).wrapping_add(length);
        let down = TIME.wrapping_sub(part.level) << 1;
        let bends = |time| {
            if self.small {
                (self.x.small_bend(time, down), self.y.small_bend(time, down))
            } else {
                (self.x.bend(time, down), self.y.bend(time, down))
            }
        };
        Bends(bends(first), bends(first.wrapping_add(length)))
    }

    fn at(&self, t: u32) -> PointFx {
        PointFx::from_bits(self.x.at(t), self.y.at(t))
    }
}

/// W at the thirds of a part. A coordinate that does not fit is the largest there is.
struct Bends((i32, i32), (i32, i32));

impl Bends {
    /// How many pieces the part between two places is cut into; 0 if it is halved instead.
    ///
    /// W and sides of the chord are below 2^15: sums of two products fit 31 bits.
    #[inline(always)]
    fn pieces(&self, from: PointFx, to: PointFx) -> u32 {
        let &Self(first, second) = self;
        if !are_small(first, second) {
            return 0;
        }
        let (c, scale) = chord(bits(from), bits(to));
        let square = product(c, c);
        let flat = |w: (i32, i32)| {
            if square < 1 << (2 * FOUR_D) {
                return product(w, w) <= 1 << (2 * FOUR_D);
            }
            let across = cross(w, c).unsigned_abs() >> FOUR_D;
            let along = product(w, c).wrapping_shr(scale);
            along <= square && across >> 16 == 0 && across.wrapping_mul(across) <= square
        };
        if flat(first) && flat(second) {
            return 1;
        }
        // On to the ends, as W is linear.
        let on = |p: i32, q: i32| p.wrapping_mul(2).wrapping_sub(q);
        let start = (on(first.0, second.0), on(first.1, second.1));
        let end = (on(second.0, first.0), on(second.1, first.1));
        if !are_small(start, end) {
            return 0;
        }
        let longer = product(start, start).max(product(end, end));
        let mut pieces = 1_u32;
        // |W| <= 4 D m^2, in squares.
        while pieces.wrapping_mul(pieces).wrapping_shl(FOUR_D).wrapping_pow(2) < longer {
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

    /// Whether the part between two places lies beside the view.
    fn hide(&self, from: PointFx, to: PointFx, view: &View) -> bool {
        let &Self((a, b), (c, d)) = self;
        let size = [b, c, d].into_iter().fold(a.unsigned_abs(), |size, n| size.max(n.unsigned_abs()));
        // It is within |W| / 4 of the chord; W and both ends are rounded.
        size < unsigned(i32::MAX) && view.hides(from, to, i64::from(size >> 2).wrapping_add(3))
    }
}

/// Whether all coordinates are within 2^15.
#[inline(always)]
fn are_small(a: (i32, i32), b: (i32, i32)) -> bool {
    let beyond = |n: i32| unsigned(n).wrapping_add(1 << 15) >> 16;
    beyond(a.0) | beyond(a.1) | beyond(b.0) | beyond(b.1) == 0
}

/// From one place to another, in 15 bits and a sign, and how many low bits it lost.
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

#[inline(always)]
fn cross(a: (i32, i32), b: (i32, i32)) -> i32 {
    a.0.wrapping_mul(b.1).wrapping_sub(a.1.wrapping_mul(b.0))
}

/// The scalar product of two vectors, without its sign.
#[inline(always)]
fn product(a: (i32, i32), b: (i32, i32)) -> u32 {
    a.0.wrapping_mul(b.0).wrapping_add(a.1.wrapping_mul(b.1)).unsigned_abs()
}

/// `P0 - 2 P1 + P2`: below 2^33.
fn second([a, b, c]: [i32; 3]) -> i64 {
    difference(a, b).wrapping_add(difference(c, b))
}

/// One coordinate of a curve: `((a t + b) t + c) t + d`.
#[derive(Copy, Clone, Debug)]
struct Polynomial {
    a: i64,
    b: i64,
    c: i64,
    d: i32,
}

impl Polynomial {
    fn quadratic(p: [i32; 3]) -> Self {
        Self { a: 0, b: second(p), c: difference(p[1], p[0]) << 1, d: p[0] }
    }

    fn cubic([p0, p1, p2, p3]: [i32; 4]) -> Self {
        let c = difference(p1, p0).wrapping_mul(3);
        let b = second([p0, p1, p2]).wrapping_mul(3);
        Self { a: difference(p3, p0).wrapping_sub(difference(p2, p1).wrapping_mul(3)), b, c, d: p0 }
    }

    /// `h^2 P''/2` at a third of `time / 2^20`, for h of `2^-down/2`. With the coefficients small, all fits 31 bits.
    #[inline(always)]
    fn small_bend(&self, time: u32, down: u32) -> i32 {
        let by_time = i64::from(narrow(self.a)).wrapping_mul(i64::from(time)) >> TIME;
        narrow(self.b).wrapping_add(narrow(by_time)).wrapping_shr(down)
    }

    /// The same of any curve: below 2^36 and 2^56 before the shifts.
    #[inline(never)]
    fn bend(&self, time: u32, down: u32) -> i32 {
        let by_time = self.a.wrapping_mul(i64::from(time)) >> TIME;
        saturate(self.b.wrapping_add(by_time).wrapping_shr(down))
    }

    /// Whether both coefficients of the second derivative are below 2^28.
    fn is_small(&self) -> bool {
        (self.a.unsigned_abs() | self.b.unsigned_abs()) >> 28 == 0
    }

    /// Its value at `t / 2^20`, rounded to nearest.
    ///
    /// `a t + b` is below 2^36 and `(a t + b) t + c` below 2^35, as it is the slope of a chord of the curve; times 2^20 and 2^40
    /// they are sums of 56 and 75 bits, and the third product is as large as the curve: 2^32 times 2^60.
    #[inline(never)]
    fn at(self, t: u32) -> i32 {
        let first = self.a.wrapping_mul(i64::from(t)).wrapping_add(self.b << TIME);
        let (high, low) = times((first >> 32, low_u32(magnitude(first))), t);
        let (high, _) = times((high.wrapping_add(self.c << (2 * TIME - 32)), low), t);
        // Of the whole 96 bits a floor is wanted: the low word does not matter.
        narrow(i64::from(self.d).wrapping_add(high.wrapping_add(1 << 27) >> 28))
    }
}
