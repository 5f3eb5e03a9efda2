//! [`Pen`]: the pieces of a stroke, each a convex contour.

use core::num::NonZeroU32;

use super::{
    direction::{moved, with_sign, Direction},
    style::{Cap, Join, Stroke},
};
use crate::{
    geom::{bits, PointFx, View},
    num::{
        cast::{low_u32, magnitude, unsigned},
        round::{difference, div_rem_wide},
    },
    span::Rect,
};

/// What happens along a contour.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) enum Event {
    /// A side.
    Side {
        /// Where it starts.
        a: PointFx,
        /// Where it ends.
        b: PointFx,
        /// Its direction. `None` if it lies outside of the window, with all that is drawn for it.
        u: Option<Direction>,
        /// What is at `a`.
        start: Start,
    },
    /// The end of an open contour, or of a dash: the last side has a cap there.
    Stop,
    /// The end of a closed contour: its last side is joined to its first one.
    Close,
    /// A contour without length.
    Dot(PointFx),
}

/// What a side begins with.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) enum Start {
    /// A corner, or the end of a stroke.
    Corner,
    /// A place inside of a curve.
    Smooth,
    /// The start of a closed contour.
    Ring,
}

/// For widths up to the first number: cosine and sine, times 2^30, of the turn from one vertex of a fan to the next. The turns are
/// 1/8, 1/16 ... 1/2048 of a circle.
const TURNS: [(u32, (i32, i32)); 9] = [
    (768, (759_250_125, 759_250_125)),
    (3_072, (992_008_094, 410_903_207)),
    (12_288, (1_053_110_176, 209_476_638)),
    (49_152, (1_068_571_464, 105_245_103)),
    (196_608, (1_072_448_455, 52_686_014)),
    (786_432, (1_073_418_433, 26_350_943)),
    (3_145_728, (1_073_660_973, 13_176_464)),
    (12_582_912, (1_073_721_611, 6_588_356)),
    (u32::MAX, (1_073_736_771, 3_294_193)),
];

/// What all pieces of a stroke are made from.
#[derive(Copy, Clone, Debug)]
pub struct Pen {
    pub(super) width: u32,
    cap: Cap,
    join: Join,
    /// Square of the miter limit, in 2^-16.
    limit: u32,
    turn: (i32, i32),
    /// How far from its line it may paint.
    pub(super) reach: u32,
    pub(super) sight: Sight,
}

/// Which parts of a stroke a window can show.
#[derive(Copy, Clone, Debug)]
pub struct Sight {
    /// The window, and as much around it as a side, a cap, or a join without a tip may reach.
    pub(super) near: View,
    /// The window, and as much around it as the tip of a miter may reach. Tips stand at corners, nowhere else.
    corners: View,
}

impl Sight {
    /// With so many units more around the window.
    pub(super) fn wider(self, units: u32) -> Self {
        Self { near: self.near.wider(units), corners: self.corners.wider(units) }
    }

    /// Whether what lies around two places, but for tips of miters, cannot be seen.
    pub(super) fn hides(&self, a: PointFx, b: PointFx) -> bool {
        self.near.hides(a, b, 0)
    }

    /// Whether a join cannot be seen, whatever its kind.
    pub(super) fn hides_corner(&self, v: PointFx) -> bool {
        self.corners.hides(v, v, 0)
    }

    /// A lower bound for the distance of a place from what can be seen, but for tips of miters, in units of 2^-16 pixel.
    pub(super) fn beside(&self, v: PointFx) -> u64 {
        let ((x, y), [(x0, y0), (x1, y1)]) = (bits(v), self.near.corners());
        let beside = |n: i32, low: i32, high: i32| difference(low, n).max(difference(n, high));
        magnitude(beside(x, x0, x1).max(beside(y, y0, y1)).max(0)) << 8
    }
}

impl Pen {
    /// For strokes that `window` may show.
    pub(super) fn new<D>(stroke: &Stroke<D>, window: Rect) -> Self {
        let width = unsigned(stroke.width.to_bits().clamp(0, 1 << 24));
        let limit = unsigned(stroke.miter_limit.to_bits().clamp(0, 0xffff));
        let turn = TURNS.iter().find(|&&(most, _)| width <= most).map_or((0, 0), |turn| turn.1);
        // Half the width for round joins, times the root of 2 for the corners of a square cap, the limit for a miter.
        let far = if matches!(stroke.join, Join::Miter) { limit.max(384) } else { 384 };
        let reach = |far: u32| low_u32(u64::from(width).wrapping_mul(u64::from(far)) >> 9).wrapping_add(2);
        let (near, reach) = (reach(384), reach(far));
        let sight = Sight { near: View::of(window, near), corners: View::of(window, reach) };
        Self { width, cap: stroke.cap, join: stroke.join, limit: limit.wrapping_mul(limit), turn, reach, sight }
    }

    #[inline(never)]
    pub(super) fn side(&self, a: PointFx, b: PointFx, u: Direction) -> Option<Piece> {
        if self.sight.hides(a, b) {
            return None;
        }
        let (right, left) = (u.right().offset(self.width), u.right().back().offset(self.width));
        Some(Piece::new([moved(a, right), moved(b, right), moved(b, left), moved(a, left)], 4))
    }

    /// The cap at the end of a side with the direction u.
    #[inline(never)]
    pub(super) fn cap(&self, at: PointFx, u: Option<Direction>) -> Option<Piece> {
        let (right, left) = u.map(|u| (u.right(), u.right().back()))?;
        let (r, l) = (right.offset(self.width), left.offset(self.width));
        match self.cap {
            Cap::Butt => None,
            Cap::Square if self.sight.hides(at, at) => None,
            Cap::Square => {
                // The offset to the right, turned to the left, points ahead.
                let ahead = (r.1, l.0);
                let sum = |o: (i32, i32)| (o.0.wrapping_add(ahead.0), o.1.wrapping_add(ahead.1));
                Some(Piece::new([moved(at, r), moved(at, sum(r)), moved(at, sum(l)), moved(at, l)], 4))
            }
            Cap::Round => self.wedge(at, right, left, Join::Round),
        }
    }

    /// Between two sides that meet.
    pub(super) fn join(
        &self,
        at: PointFx,
        last: Option<Direction>,
        next: Option<Direction>,
        smooth: bool,
    ) -> Option<Piece> {
        let (last, next) = (last?, next?);
        let turn = last.cross(next);
        if turn == 0 && last.dot(next) > 0 || self.sight.hides_corner(at) {
            return None;
        }
        // On the outer side of the corner, in the order in which the piece turns left, as all pieces do.
        let (from, to) =
            if turn > 0 { (next.right().back(), last.right().back()) } else { (last.right(), next.right()) };
        self.wedge(at, from, to, if smooth { Join::Round } else { self.join })
    }

    #[inline(never)]
    fn wedge(&self, at: PointFx, from: Direction, to: Direction, join: Join) -> Option<Piece> {
        let tip = if join == Join::Miter { self.tip(from, to).map(|tip| moved(at, tip)) } else { None };
        if self.sight.hides(at, tip.unwrap_or(at)) {
            return None;
        }
        let [start, end] = [from, to].map(|o| moved(at, o.offset(self.width)));
        let flat = Piece::new([at, start, end, end], 3);
        Some(match tip {
            Some(tip) => Piece::new([at, start, tip, end], 4),
            None if join == Join::Round => {
                let fan = Fan { centre: at, last: from, end: to, turn: self.turn, width: self.width };
                Piece { fan: Some(fan), ..flat }
            }
            None => flat,
        })
    }

    /// Where two offset borders meet, unless that is too far.
    fn tip(&self, from: Direction, to: Direction) -> Option<(i32, i32)> {
        // 1 + cos, of 31 bits.
        let c = (from.dot(to) >> 30).wrapping_add(1 << 30);
        let near = c > 0 && u64::from(self.limit).wrapping_mul(magnitude(c)) >= 1 << 47;
        let c = NonZeroU32::new(low_u32(magnitude(c))).filter(|_| near)?;
        let reach = |p: i32, q: i32| {
            let sum = i64::from(p).wrapping_add(i64::from(q));
            let n = u64::from(self.width).wrapping_mul(sum.unsigned_abs()).wrapping_add(u64::from(c.get()));
            with_sign(div_rem_wide(n >> 1, c).0, sum)
        };
        Some((reach(from.x, to.x), reach(from.y, to.y)))
    }
}

/// One piece of a stroke: the vertices of a convex contour.
#[derive(Clone, Debug)]
pub struct Piece {
    corners: [PointFx; 4],
    len: usize,
    /// How many corners were returned.
    done: usize,
    /// Its vertices come after the first two corners.
    fan: Option<Fan>,
}

impl Piece {
    const fn new(corners: [PointFx; 4], len: usize) -> Self {
        Self { corners, len, done: 0, fan: None }
    }
}

impl Iterator for Piece {
    type Item = PointFx;

    #[inline(never)]
    fn next(&mut self) -> Option<PointFx> {
        if self.done == 2 {
            if let Some(v) = self.fan.as_mut().and_then(Fan::next) {
                return Some(v);
            }
        }
        let corner = self.corners.get(self.done).filter(|_| self.done < self.len)?;
        self.done = self.done.wrapping_add(1);
        Some(*corner)
    }
}

/// Vertices on a circle, between two offsets of at most half a turn.
#[derive(Clone, Debug)]
struct Fan {
    centre: PointFx,
    last: Direction,
    end: Direction,
    turn: (i32, i32),
    width: u32,
}

impl Fan {
    fn next(&mut self) -> Option<PointFx> {
        self.last = self.last.turned(self.turn);
        (self.last.cross(self.end) < 0).then(|| moved(self.centre, self.last.offset(self.width)))
    }
}
