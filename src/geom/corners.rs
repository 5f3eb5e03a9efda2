//! [`RoundCorners`]: lines from place to place whose corners are pieces of circles.
//!
//! ```text
//!    a ------- p . . . b           u, v   the directions from a to b, and from b to c: vectors of length 1
//!               '-.    .           2 h    the angle by which the corner turns: cos h = |u + v| / 2, sin h = |v - u| / 2
//!                  '   .           t      from b to where the circle touches both sides: r tan h
//!       centre +    \  .           p, q   b - t u, b + t v: from p to q it goes along the circle
//!                    | .
//!                    q . . c
//! ```
//! **The rule.** A corner of the radius r is a piece of the circle with that radius which touches both of its sides. It begins and
//! ends t from the corner, and *t is at most half of the shorter side*: where r tan h is more, the radius is less, `t / tan h`. So two
//! corners share a side, and a line keeps its ends. A corner without an angle, one that turns back all the way, and one with a side
//! of no length are as sharp as they were. Vertices that lie on a straight line change nothing.
//!
//! **Rounding.** u, v, sin h and cos h are computed to 30 bits. t is rounded to `2^-16` pixel, or to 1/256 where a radius or half
//! a side is 32,768 pixels long. The piece becomes cubic curves, as those of an [`Arc`](super::arc) do: it is within 1/100 pixel of its
//! circle. A way and the same way from its end to its start have the same corners, to 1/256 pixel.
//!
//! Range: any `I24F8`; a negative radius counts as 0. Work: three inverse square roots and a division or three for each corner, and
//! its curves. Memory: none.

use core::num::NonZeroU32;

use fixed::types::I24F8;

use super::{
    affine::{Affine, Fine},
    arc::{angle_of, part, ratio, root, times, Curves},
    path::PathSegment,
    point::{bits, PointFx},
};
use crate::num::{
    cast::{low_u32, magnitude, narrow, signed},
    recip::inverse_root_wide,
    round::difference,
    wide::Sum,
};

/// Lines from each place to the next, with round corners: the segments of a path, to be filled, stroked or drawn. See
/// [`corners`](self).
/// ```
/// use embedded_raster::{geom::RoundCorners, px, Canvas, Framebuffer, Index1, PointFx};
/// let places = [(1, 1), (14, 1), (14, 6)].map(PointFx::from);
/// let mut ram = [0; 16];
/// let mut frame = Framebuffer::<Index1>::new(&mut ram, 16, 8)?;
/// frame.draw_path_fx(RoundCorners::new(&places, false, px(4)), Index1::MAX);
/// let rows = [
///     0b0000_0000_0000_0000_u16,
///     0b0111_1111_1111_1000,
///     0b0000_0000_0000_0100,
///     0b0000_0000_0000_0010,
///     0b0000_0000_0000_0010,
///     0b0000_0000_0000_0010,
///     0b0000_0000_0000_0010,
///     0b0000_0000_0000_0000,
/// ];
/// assert_eq!(ram, rows.map(u16::to_be_bytes).concat()[..]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct RoundCorners<'a> {
    places: &'a [PointFx],
    closed: bool,
    /// In units of 1/256 pixel.
    radius: u32,
    /// The vertex that comes next; of a closed one, as many as there are for the first one again, and one more for the way back.
    next: usize,
    /// The corner that it goes around.
    curves: Option<Curves>,
}

impl<'a> RoundCorners<'a> {
    /// From each place to the next, and back to the first one if they are `closed`: then the first one has a round corner too.
    #[inline]
    pub const fn new(places: &'a [PointFx], closed: bool, radius: I24F8) -> Self {
        let radius = radius.to_bits();
        let radius = if radius > 0 { radius.unsigned_abs() } else { 0 };
        Self { places, closed, radius, next: 0, curves: None }
    }

    /// The corner at a vertex, if it is round.
    fn corner(&self, vertex: usize) -> Option<Corner> {
        let (n, last) = (self.places.len(), self.places.len().wrapping_sub(1));
        let is_end = vertex == 0 || vertex == last;
        if is_end && (!self.closed || n < 3) {
            return None;
        }
        let before = if vertex == 0 { last } else { vertex.wrapping_sub(1) };
        let after = if vertex == last { 0 } else { vertex.wrapping_add(1) };
        let place = |i: usize| self.places.get(i).copied();
        Corner::new([place(before)?, place(vertex)?, place(after)?], self.radius)
    }
}

impl Iterator for RoundCorners<'_> {
    type Item = PathSegment;

    fn next(&mut self) -> Option<PathSegment> {
        if let Some(segment) = self.curves.as_mut().and_then(Curves::step) {
            return Some(segment);
        }
        self.curves = None;
        let (n, number) = (self.places.len(), self.next);
        let vertex = if number == n && self.closed { 0 } else { number };
        let Some(&at) = self.places.get(vertex) else {
            let is_closing = self.closed && number == n.wrapping_add(1) && n > 0;
            self.next = n.wrapping_add(2);
            return is_closing.then_some(PathSegment::Close);
        };
        self.next = number.wrapping_add(1);
        let corner = self.corner(vertex);
        if number == 0 {
            return Some(PathSegment::MoveTo(corner.map_or(at, |corner| Affine::IDENTITY.apply_fine(corner.end))));
        }
        let Some(corner) = corner else {
            // Back to where it began: the way back does that.
            return if number == n { self.next() } else { Some(PathSegment::LineTo(at)) };
        };
        self.curves = Some(corner.curves);
        Some(PathSegment::LineTo(Affine::IDENTITY.apply_fine(corner.start)))
    }
}

/// A corner that is round: where it begins and where it ends.
struct Corner {
    start: Fine,
    end: Fine,
    curves: Curves,
}

impl Corner {
    /// At b, on the way from a to c; `None` if it is sharp.
    fn new([a, b, c]: [PointFx; 3], radius: u32) -> Option<Self> {
        let ((u, first), (v, second)) = (direction(a, b)?, direction(b, c)?);
        // Half of both sums: numbers in 2.30.
        let middle = |a: i32, b: i32| narrow(i64::from(a).wrapping_add(b.into()) >> 1);
        let sum = (middle(u.0, v.0), middle(u.1, v.1));
        let apart = (middle(v.0, u.0.wrapping_neg()), middle(v.1, u.1.wrapping_neg()));
        let length = |(x, y): (i32, i32)| root(Sum::ZERO.plus(x, x).plus(y, y).of_squares().min(1 << 60));
        let (cos, sin) = (length(sum), length(apart));
        let (cos_divisor, sin_divisor) = (NonZeroU32::new(cos.unsigned_abs())?, NonZeroU32::new(sin.unsigned_abs())?);
        let limit = first.min(second) >> 1;
        let scale: u32 = if u64::from(radius).max(limit) < 1 << 23 { 16 } else { 8 };
        let up = scale.wrapping_sub(8);
        // Half of a side, which is not longer than the diagonal of the plane: below 2^32.
        let t = magnitude(ratio(sin, radius.wrapping_shl(up), cos_divisor)).min(limit.wrapping_shl(up));
        if t == 0 {
            return None;
        }
        let t = low_u32(t);
        // What is left of the radius.
        let radius = ratio(cos, t, sin_divisor);
        let fine = |n: i64| n.wrapping_shl(16_u32.wrapping_sub(scale));
        let along = |n: i64, (x, y): (i32, i32)| (times(fine(n), x), times(fine(n), y));
        let (x, y) = bits(b);
        let (x, y) = (i64::from(x) << 8, i64::from(y) << 8);
        let (back, ahead) = (along(t.into(), u), along(t.into(), v));
        let ends =
            [(x.wrapping_sub(back.0), y.wrapping_sub(back.1)), (x.wrapping_add(ahead.0), y.wrapping_add(ahead.1))];
        let way = unit(sum)?;
        // From the centre to the corner: to the left of the way, where that turns clockwise.
        let is_clockwise = Sum::ZERO.plus(u.0, v.1).minus(u.1, v.0).total() > 0;
        let out = if is_clockwise { (way.1, way.0.wrapping_neg()) } else { (way.1.wrapping_neg(), way.0) };
        // All of these twice. The centre is N cos h behind the middle of both ends.
        let (t, n) = (along(radius.wrapping_mul(2), way), along(radius.wrapping_mul(2), out));
        let [start, end] = ends;
        let behind = |start: i64, end: i64, n: i64| start.wrapping_add(end).wrapping_sub(times(n, cos));
        let centre = (behind(start.0, end.0, n.0), behind(start.1, end.1, n.1));
        Some(Self { start, end, curves: Curves::around(centre, [t, n], angle_of(cos, sin), ends) })
    }
}

/// The direction from one place to another, of length 1 in 2.30, and how far it is, in units of 1/256 pixel; `None` if they are one.
fn direction(a: PointFx, b: PointFx) -> Option<((i32, i32), u64)> {
    let (a, b) = (bits(a), bits(b));
    let d = (difference(b.0, a.0), difference(b.1, a.1));
    let size = d.0.unsigned_abs() | d.1.unsigned_abs();
    // So that the longer one has 29 bits.
    let up = signed(size.leading_zeros()).wrapping_sub(35);
    let scaled = |n: i64| narrow(if up >= 0 { n.wrapping_shl(up.unsigned_abs()) } else { n >> up.unsigned_abs() });
    let u = unit((scaled(d.0), scaled(d.1)))?;
    // The scalar product with the direction: not more than the length of d, below 2^33, times 2^30.
    let length = d.0.wrapping_mul(u.0.into()).wrapping_add(d.1.wrapping_mul(u.1.into())) >> 30;
    Some((u, magnitude(length.max(0))))
}

/// A vector below `2^30` with the length 1, in 2.30; `None` if it is 0.
fn unit((x, y): (i32, i32)) -> Option<(i32, i32)> {
    let square = Sum::ZERO.plus(x, x).plus(y, y).of_squares();
    if square == 0 {
        return None;
    }
    let (inverse, shift) = inverse_root_wide(square);
    let down = 32_u32.wrapping_sub(shift >> 1);
    Some((part(x, inverse, down), part(y, inverse, down)))
}
