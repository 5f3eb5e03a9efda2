//! Curves to lines, within a tolerance, on the grid of 1/256 pixel.
//!
//! A Bézier curve is cut into n pieces that take the same time, and each piece becomes its chord.
//! ```text
//!            _.-o-._            o  points on the curve, at t = T(i) / 2^20, T(i) about 2^20 i / n
//!         .o'       'o.         between two of them the chord is off by at most h^2/8 max|P''|
//!       .'             '.
//!      o                 o
//! ```
//! With `a = P0 - 2 P1 + P2` (and `b = P1 - 2 P2 + P3`) that is `|a| / (4 n^2)` for a quadratic curve and
//! `3 max(|a|, |b|) / (4 n^2)` for a cubic one, so the fewest pieces within `D` units are
//! `n = ceil(sqrt(|a| / 4 D))` and `ceil(sqrt(3 max / 4 D))`. D is 32 units for fills and strokes, 8 for lines one pixel wide.
//!
//! `2^20 = n q + r` gives `T(i) = i q + min(i, r)`: no division, and steps of q or q + 1. A vertex is the point of the
//! curve at T(i), exactly, rounded to the nearest unit (halves upwards). Together, rounding included, lines stay within
//! 34 units (0.133 pixels), or 9.3 (0.037 pixels), of the curve.
//!
//! **Work.** n is at most 16,874 (33,748): what the ends of the type can make. Of a curve that leaves the window most
//! pieces are never looked at: k pieces lie within `k^2` tolerances of their common chord, and when that whole strip lies on one side of the
//! window the chord takes their place. That changes no pixel of a fill: left of the window, how often a row is crossed
//! depends on the two ends only; on the other sides nothing counts.
//!
//! Range: any `I24F8`. Points are sums below 2^93, in words of 64 and 32 bits.
//!
//! Sources: G. Farin, "Curves and Surfaces for CAGD", 1988 (chords); L. Fernández-Jambrina and others on segment counts
//! from second differences.

use core::{num::NonZeroU32, slice::Iter};

use super::{bits, path::PathSegment, view::View, Vertex};
use crate::num::{
    cast::{low_u32, magnitude, narrow},
    hypot::{length_above, square_root},
    round::difference,
    wide::times,
};

/// Chords are off by at most 2^5 units: for everything with an inside.
pub(crate) const FINE: u32 = 5;
/// By 2^3 units: for lines one pixel wide.
pub(crate) const FINER: u32 = 3;

/// Bits of the parameter t.
const TIME: u32 = 20;

/// The vertices of one contour of a [`Path`](super::Path), the first one included, the closing side not.
#[derive(Clone, Debug)]
pub struct Contour<'a> {
    start: Option<Vertex>,
    at: Vertex,
    segments: Iter<'a, PathSegment>,
    curve: Option<Curve>,
    closed: bool,
    view: View,
    shift: u32,
}

/// A vertex, and whether the path goes on smoothly there, inside of a curve.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) struct Node {
    pub(crate) at: Vertex,
    pub(crate) smooth: bool,
}

impl<'a> Contour<'a> {
    #[inline]
    pub(super) fn new(start: Vertex, segments: &'a [PathSegment], closed: bool, view: View, shift: u32) -> Self {
        Self { start: Some(start), at: start, segments: segments.iter(), curve: None, closed, view, shift }
    }

    /// Whether it ends with [`PathSegment::Close`]. A fill closes every contour.
    #[inline]
    pub const fn is_closed(&self) -> bool {
        self.closed
    }

    #[inline(never)]
    pub(crate) fn next_node(&mut self) -> Option<Node> {
        if let Some(at) = self.start.take() {
            return Some(Node { at, smooth: false });
        }
        loop {
            if let Some(node) = self.curve.as_mut().and_then(|curve| curve.next(&self.view)) {
                return Some(node);
            }
            let from = self.at;
            self.at = match *self.segments.next()? {
                PathSegment::LineTo(to) => {
                    self.at = to;
                    return Some(Node { at: to, smooth: false });
                }
                PathSegment::QuadraticTo(c, to) => {
                    self.curve = Some(Curve::quadratic([from, c, to], &self.view, self.shift));
                    to
                }
                PathSegment::CubicTo(c, d, to) => {
                    self.curve = Some(Curve::cubic([from, c, d, to], &self.view, self.shift));
                    to
                }
                PathSegment::MoveTo(_) | PathSegment::Close => return None,
            };
        }
    }
}

impl Iterator for Contour<'_> {
    type Item = Vertex;

    #[inline]
    fn next(&mut self) -> Option<Vertex> {
        self.next_node().map(|node| node.at)
    }
}

/// A curve on its way: after `done` of its `n` pieces.
#[derive(Clone, Debug)]
struct Curve {
    x: Polynomial,
    y: Polynomial,
    last: Vertex,
    done: u32,
    n: u32,
    /// `2^20 = n q + r`.
    q: u32,
    r: u32,
    /// By how much a chord may be off, as a power of two.
    shift: u32,
    /// No part of it can leave the view.
    whole: bool,
}

impl Curve {
    fn quadratic(points: [Vertex; 3], view: &View, shift: u32) -> Self {
        let [(ax, ay), (bx, by), (cx, cy)] = points.map(bits);
        let (x, y) = (Polynomial::quadratic([ax, bx, cx]), Polynomial::quadratic([ay, by, cy]));
        let bend = length_above(x.b.unsigned_abs(), y.b.unsigned_abs());
        Self::new(x, y, bend, shift, points.iter().all(|&p| view.holds(p)))
    }

    fn cubic(points: [Vertex; 4], view: &View, shift: u32) -> Self {
        let [(ax, ay), (bx, by), (cx, cy), (dx, dy)] = points.map(bits);
        let (x, y) = (Polynomial::cubic([ax, bx, cx, dx]), Polynomial::cubic([ay, by, cy, dy]));
        let bend = |p: [i32; 3], q: [i32; 3]| length_above(second(p).unsigned_abs(), second(q).unsigned_abs());
        let bend = bend([ax, bx, cx], [ay, by, cy]).max(bend([bx, cx, dx], [by, cy, dy]));
        Self::new(x, y, bend.wrapping_mul(3), shift, points.iter().all(|&p| view.holds(p)))
    }

    /// For a curve whose chords of one n-th are off by at most `bend / (4 n^2)`.
    fn new(x: Polynomial, y: Polynomial, bend: u64, shift: u32, whole: bool) -> Self {
        let shift_up = shift.wrapping_add(2);
        let square = bend.wrapping_add(1_u64.wrapping_shl(shift_up).wrapping_sub(1)).wrapping_shr(shift_up);
        let root = square_root(square);
        let above = u64::from(root).wrapping_mul(u64::from(root)) < square;
        let n = NonZeroU32::new(root.wrapping_add(u32::from(above))).unwrap_or(NonZeroU32::MIN);
        let last = Vertex::from_bits(x.d, y.d);
        Self { x, y, last, done: 0, n: n.get(), q: (1 << TIME) / n, r: (1 << TIME) % n, shift, whole }
    }

    /// The end of the next piece, or of as many as lie beside the view.
    fn next(&mut self, view: &View) -> Option<Node> {
        let left = self.n.wrapping_sub(self.done);
        if left == 0 {
            return None;
        }
        // The pieces as leaves of a tree: a branch that can be seen is asked for its smaller branches.
        let branch = 1_u32.wrapping_shl(31 ^ left.leading_zeros());
        let mut pieces = match self.done {
            _ if self.whole => 1,
            0 => branch,
            done => (done & done.wrapping_neg()).min(branch),
        };
        loop {
            let done = self.done.wrapping_add(pieces);
            let at = self.at(done);
            if pieces == 1 || view.hides(self.last, at, self.slack(pieces)) {
                (self.last, self.done) = (at, done);
                return Some(Node { at, smooth: done != self.n });
            }
            pieces >>= 1;
        }
    }

    /// How far from their chord that many pieces may lie, roundings included. D grows by less than an eighth where T(i) is
    /// not quite 2^20 i / n.
    fn slack(&self, pieces: u32) -> i64 {
        (i64::from(pieces).wrapping_mul(i64::from(pieces)).wrapping_mul(9).wrapping_shl(self.shift) >> 3)
            .wrapping_add(2)
    }

    fn at(&self, i: u32) -> Vertex {
        let t = i.wrapping_mul(self.q).wrapping_add(i.min(self.r));
        Vertex::from_bits(self.x.at(t), self.y.at(t))
    }
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
