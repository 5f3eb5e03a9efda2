//! [`Pieces`]: the lines that are the border of caps, joins and sides, each kind as the sketches of [`stroke`](super) show it.

use core::num::NonZeroU32;

use super::{
    direction::{is_tiny, moved, Direction},
    pen::Pen,
    style::{Cap, Join},
};
use crate::{
    geom::{bits, PointFx},
    num::{
        cast::{low_u32, magnitude, narrow, saturate, signed, signed_wide},
        root::square_root,
        round::{difference, div_rem_wide, first_centre_after, first_centre_from},
    },
};

/// A vector in units.
type Offset = (i32, i32);

/// Takes the lines of a border: from one place to another.
pub(super) type Each<'a> = &'a mut dyn FnMut(PointFx, PointFx);

/// The start or the end of a side.
#[derive(Copy, Clone, Debug)]
pub(super) struct End {
    pub(super) at: PointFx,
    pub(super) u: Direction,
    /// To the right of u, half a width long.
    pub(super) offset: Offset,
    /// The other end of the side.
    pub(super) other: PointFx,
    pub(super) is_straight: bool,
    /// Whether the side is drawn. Of one beside the window, with a corner whose tip may show, nothing else is.
    pub(super) is_drawn: bool,
}

/// What tells the lines of each piece; where it is `CURVED`, sides may bend. If not, nothing of what they take is linked.
pub(super) struct Pieces<'a, const CURVED: bool> {
    pub(super) pen: &'a Pen,
    pub(super) each: Each<'a>,
}

impl<const CURVED: bool> Pieces<'_, CURVED> {
    fn line(&mut self, a: PointFx, b: PointFx) {
        (self.each)(a, b);
    }

    /// An end of a side that goes to or comes from another place.
    #[cfg_attr(embedded_raster_compact, inline(never))]
    pub(super) fn end(&self, at: PointFx, u: Direction, other: PointFx, is_straight: bool, is_drawn: bool) -> End {
        End { at, u, offset: u.right().offset(self.pen.width), other, is_straight, is_drawn }
    }

    /// The straight end of a side, from the offset to its opposite.
    #[cfg_attr(embedded_raster_compact, inline(never))]
    pub(super) fn across(&mut self, at: PointFx, offset: Offset) {
        let (a, b) = (moved(at, offset), moved(at, opposite(offset)));
        if is_far_out(at) {
            // There a place that was moved may have stopped at the end of the type. In all borders the line goes by the middle.
            self.line(a, at);
            self.line(at, b);
        } else {
            self.line(a, b);
        }
    }

    /// A polyline of an end and a start: what is left of a line across each.
    #[cfg_attr(embedded_raster_compact, inline(never))]
    fn gap(&mut self, at: PointFx, from: Offset, to: Offset) {
        self.line(moved(at, from), at);
        self.line(at, moved(at, to));
    }

    /// The cap where a side ends, or where it starts.
    #[cfg_attr(embedded_raster_compact, inline(never))]
    pub(super) fn cap(&mut self, end: &End, is_start: bool) {
        if end.is_drawn {
            let (u, offset) = if is_start { (end.u.back(), opposite(end.offset)) } else { (end.u, end.offset) };
            self.cap_at(end.at, u, offset);
        }
    }

    /// What is at the end of a line that goes this way, from the right to the left.
    #[inline]
    fn cap_at(&mut self, at: PointFx, u: Direction, offset: Offset) {
        match self.pen.cap {
            Cap::Butt => self.across(at, offset),
            Cap::Square => {
                // The offset to the right, turned to the left, points ahead.
                let ahead = (offset.1, offset.0.wrapping_neg());
                let sum = |o: Offset| (o.0.wrapping_add(ahead.0), o.1.wrapping_add(ahead.1));
                let [a, b] = [offset, opposite(offset)].map(|o| (moved(at, o), moved(at, sum(o))));
                self.line(a.0, a.1);
                self.line(a.1, b.1);
                self.line(b.1, b.0);
            }
            Cap::Round => self.fan(at, u.right(), u.right().back()),
        }
    }

    /// Lines around a place, from one offset to another, turning left by half a turn at most.
    #[cfg_attr(embedded_raster_compact, inline(never))]
    fn fan(&mut self, at: PointFx, from: Direction, to: Direction) {
        let (mut u, width) = (from, self.pen.width);
        let mut last = moved(at, from.offset(width));
        loop {
            u = u.turned(self.pen.turn);
            let is_last = u.cross(to) >= 0;
            let next = moved(at, if is_last { to } else { u }.offset(width));
            self.line(last, next);
            if is_last {
                return;
            }
            last = next;
        }
    }

    /// The outer side of a corner, turning left.
    #[cfg_attr(embedded_raster_compact, inline(never))]
    fn outside(&mut self, at: PointFx, from: Direction, to: Direction, join: Join) {
        if join == Join::Round {
            return self.fan(at, from, to);
        }
        let [a, b] = [from, to].map(|u| moved(at, u.offset(self.pen.width)));
        match if join == Join::Miter { self.pen.tip(from, to) } else { None } {
            Some(tip) => {
                let tip = moved(at, tip);
                self.line(a, tip);
                self.line(tip, b);
            }
            None => self.line(a, b),
        }
    }

    /// The tip of a corner of which not both sides are drawn, as a piece of its own.
    #[cold]
    fn lone_tip(&mut self, last: &End, next: &End) {
        if last.is_drawn {
            self.across(last.at, last.offset);
        }
        if next.is_drawn {
            self.across(next.at, opposite(next.offset));
        }
        let at = next.at;
        let (p, q) = (last.u.right(), next.u.right());
        let (from, to) = if last.u.cross(next.u) > 0 { (q.back(), p.back()) } else { (p, q) };
        let tip = if self.pen.join == Join::Miter { self.pen.tip(from, to) } else { None };
        if tip.is_some_and(|tip| !self.pen.sight.hides(at, moved(at, tip))) {
            self.outside(at, from, to, Join::Miter);
            self.gap(at, to.offset(self.pen.width), from.offset(self.pen.width));
        }
    }

    /// What is between the end of a side and the start of the next. `turns`: as a curve does, so that what the pen sweeps over on
    /// the inner side belongs to the stroke too.
    #[cfg_attr(embedded_raster_compact, inline(never))]
    pub(super) fn join(&mut self, last: &End, next: &End, turns: bool) {
        let (at, p, q, turns) = (next.at, last.u, next.u, CURVED && turns);
        if !(last.is_drawn && next.is_drawn) {
            return self.lone_tip(last, next);
        }
        if p == q {
            return;
        }
        let turn = p.cross(q);
        if turn == 0 && p.dot(q) > 0 {
            self.gap(at, last.offset, opposite(last.offset));
            return self.gap(at, opposite(next.offset), next.offset);
        }
        let join = if turns { Join::Round } else { self.pen.join };
        let (right_last, right_next) = (p.right(), q.right());
        // The inner side: from an offset of the last side to one of the next, on the right, or back on the left.
        let (from, to, is_right) = if turn > 0 {
            self.outside(at, right_next.back(), right_last.back(), join);
            (last.offset, next.offset, true)
        } else {
            self.outside(at, right_last, right_next, join);
            (opposite(next.offset), opposite(last.offset), false)
        };
        let (first, second) = if is_right { (right_next, right_last) } else { (right_last.back(), right_next.back()) };
        // What is swept over is no more than a triangle.
        let is_short = !turns || first.turned(self.pen.turn).cross(second) >= 0;
        if is_short && is_inside(last, next, is_right) {
            return self.line(moved(at, from), moved(at, to));
        }
        self.gap(at, from, to);
        if turns {
            self.line(at, moved(at, first.offset(self.pen.width)));
            self.fan(at, first, second);
            self.line(moved(at, second.offset(self.pen.width)), at);
        }
    }

    /// A contour without length.
    #[cfg_attr(embedded_raster_compact, inline(never))]
    pub(super) fn dot(&mut self, at: PointFx) {
        match self.pen.cap {
            _ if self.pen.sight.hides(at, at) => {}
            Cap::Butt => {}
            Cap::Square => {
                for u in [Direction::RIGHT, Direction::RIGHT.back()] {
                    self.cap_at(at, u, u.right().offset(self.pen.width));
                }
            }
            Cap::Round => self.disc(at),
        }
    }

    /// The pixels of [`Ellipse::circle`](crate::Ellipse::circle): for each row a rectangle that is one unit high.
    fn disc(&mut self, at: PointFx) {
        let ((x, y), width) = (bits(at), i64::from(self.pen.width));
        let half = saturate(width >> 1);
        let (first, end) = (first_centre_from(y.saturating_sub(half)), first_centre_after(y.saturating_add(half)));
        let closed = (x | y).trailing_zeros() >= 7;
        for row in first.max(self.pen.rows.0)..end.min(self.pen.rows.1) {
            // Twice the distance of its centre: at most the width.
            let centre = row << 8 | 128;
            let away = difference(centre, y) << 1;
            let square = width.wrapping_mul(width).wrapping_sub(away.wrapping_mul(away));
            if square < 0 {
                continue;
            }
            let root = square_root(magnitude(square));
            let is_more = closed || root & 1 != 0 || i64::from(root).wrapping_mul(root.into()) != square;
            let reach = signed(root >> 1);
            let (left, right) = (x.saturating_sub(reach), x.saturating_add(reach).saturating_add(is_more.into()));
            let below = centre.wrapping_add(1);
            self.line(PointFx::from_bits(left, centre), PointFx::from_bits(left, below));
            self.line(PointFx::from_bits(right, below), PointFx::from_bits(right, centre));
        }
    }

    /// Both borders of a side.
    #[cfg_attr(embedded_raster_compact, inline(never))]
    pub(super) fn band(&mut self, start: &End, end: &End) {
        let (a, b) = (start.at, end.at);
        let [right, left] = [start.offset, opposite(start.offset)].map(|o| moved(a, o));
        let [right_end, left_end] = [end.offset, opposite(end.offset)].map(|o| moved(b, o));
        let goes_back = |end: &End| cross(between(a, b), end.offset) < 0;
        if CURVED && is_tiny(a, b, self.pen.width) && goes_back(start) && goes_back(end) {
            // It goes backwards, and counts as minus one. With that twice more, it is one.
            self.line(right, right_end);
            self.line(left_end, left);
            for _ in 0..2 {
                for (from, to) in [(right, left), (left, left_end), (left_end, right_end), (right_end, right)] {
                    self.line(from, to);
                }
            }
            return;
        }
        let fold = if !CURVED || start.offset == end.offset { None } else { fold(start, end, self.pen.width) };
        let Some((is_right, apex)) = fold else {
            self.line(right, right_end);
            return self.line(left_end, left);
        };
        // Behind the apex one border goes backwards, and what it encloses counts as minus one. With that twice more, it is one.
        let (from, to) = if is_right {
            self.line(left_end, left);
            (right_end, right)
        } else {
            self.line(right, right_end);
            (left, left_end)
        };
        self.line(from, to);
        for _ in 0..2 {
            self.line(apex, from);
            self.line(to, apex);
        }
    }
}

pub(super) const fn opposite((x, y): Offset) -> Offset {
    (x.wrapping_neg(), y.wrapping_neg())
}

/// The cross product of two vectors below 2^34 and 2^26.
#[cfg_attr(embedded_raster_compact, inline(never))]
fn cross(a: (i64, i64), b: Offset) -> i64 {
    a.0.wrapping_mul(b.1.into()).wrapping_sub(a.1.wrapping_mul(b.0.into()))
}

const fn wide((x, y): Offset) -> (i64, i64) {
    (x as i64, y as i64)
}

/// The vector from a place to another.
#[cfg_attr(embedded_raster_compact, inline(never))]
fn between(a: PointFx, b: PointFx) -> (i64, i64) {
    let (a, b) = (bits(a), bits(b));
    (difference(b.0, a.0), difference(b.1, a.1))
}

/// Whether a place may not be moved by half a width without stopping at the end of the type.
pub(super) fn is_far_out(at: PointFx) -> bool {
    let (x, y) = bits(at);
    (x.unsigned_abs() | y.unsigned_abs()) >> 30 != 0
}

/// Whether the way on the inner side of a corner, from one offset by the corner to the other, can be cut short. It can where the
/// triangle between these three places lies in both sides: it was wound around twice, and still is once.
#[cfg_attr(embedded_raster_compact, inline(never))]
fn is_inside(last: &End, next: &End, is_right: bool) -> bool {
    if !(last.is_straight && next.is_straight) || [last.other, next.other, next.at].into_iter().any(is_far_out) {
        return false;
    }
    let side = |o: Offset| if is_right { o } else { opposite(o) };
    let (p, q) = (side(last.offset), side(next.offset));
    // The products of a corner that turns left have the other sign.
    let sign = if is_right { 1 } else { -1 };
    cross(wide(p), q).wrapping_mul(sign) >= 0
        && holds(between(last.other, next.at), p, q, sign)
        && holds(between(next.other, next.at), q, p, sign.wrapping_neg())
}

/// Whether the end of an offset q from a corner lies in a side that comes to it along d and has the offset p there: between the lines
/// across at both ends of the side, and not beyond its borders.
#[cfg_attr(embedded_raster_compact, inline(never))]
fn holds(d: (i64, i64), p: Offset, q: Offset, sign: i64) -> bool {
    let ahead = (d.0.wrapping_add(q.0.into()), d.1.wrapping_add(q.1.into()));
    cross(ahead, p).wrapping_mul(sign) >= 0 && cross(d, q).unsigned_abs() <= cross(d, p).unsigned_abs()
}

/// If a side bends so much that the offsets of its ends cross: whether they do so on the right, and a place a little before the
/// crossing. The triangle from there to the far ends of both holds all that lies behind the crossing.
#[cfg_attr(embedded_raster_compact, inline(never))]
fn fold(start: &End, end: &End, width: u32) -> Option<(bool, PointFx)> {
    let (r, s) = (start.offset, end.offset);
    let chord = between(start.at, end.at);
    // Where they cross, as shares of both, is at `along / turn` and at `back / turn`.
    let (along, back, turn) = (cross(chord, s), cross(chord, r), cross(wide(r), s));
    let whole = turn.unsigned_abs();
    if along.unsigned_abs() >= whole || back.unsigned_abs() >= whole || (along < 0) != (back < 0) {
        return None;
    }
    let is_right = (along < 0) == (turn < 0);
    // Below 2^31.
    let shift = 33_u32.saturating_sub(whole.leading_zeros());
    let divisor = NonZeroU32::new(low_u32(whole.wrapping_shr(shift)))?;
    // As much before the crossing as makes two units to the sides.
    let before = |share: i64, at: PointFx, offset: Offset| {
        let share = share.unsigned_abs().saturating_sub(u64::from(width) << 1);
        let inner = if is_right { offset } else { opposite(offset) };
        part_of(inner, div_rem_wide(share.wrapping_shr(shift) << 31, divisor).0, at)
    };
    let (p, q) = (before(along, start.at, r), before(back, end.at, s));
    let middle = |p: i32, q: i32| narrow(i64::from(p).wrapping_add(q.into()) >> 1);
    Some((is_right, PointFx::from_bits(middle(p.0, q.0), middle(p.1, q.1))))
}

/// A place moved by a share of an offset, in 2^-31 of it.
#[inline(never)]
fn part_of((x, y): Offset, share: u32, at: PointFx) -> (i32, i32) {
    let part = |n: i32| saturate(signed_wide(share.into()).wrapping_mul(n.into()) >> 31);
    bits(moved(at, (part(x), part(y))))
}
