//! [`Bezier`]: a curve, cut into pieces.

use core::num::NonZeroU32;

use super::{
    bends::Bends,
    polynomial::{Polynomial, TIME_BITS},
};
use crate::{
    geom::{
        point::{bits, PointFx},
        view::View,
    },
    num::{
        cast::{low_u32, magnitude, signed_wide},
        round::difference,
        wide::{product, times},
    },
    tune::COMPACT,
};

/// Whether small curves are followed in 32 bits; built for size, all are in 64.
const NARROW: bool = !COMPACT;
/// The time at the end of a curve.
const END: u32 = 1 << TIME_BITS;

/// Which way a curve goes at a place: a vector of any length.
pub(crate) type Way = (i64, i64);

/// A part that turns back is shorter than 32 units, in units of 2^-20 pixel: all others are cut where they turn.
const SHORT: u64 = 32 << 12;

/// Whether two ways differ by more than a quarter of a turn. Both lose as many bits as the longer component has above 31.
fn is_back(u: Way, v: Way) -> bool {
    let bits = |n: i64| n.unsigned_abs();
    let lost = 33_u32.saturating_sub((bits(u.0) | bits(u.1) | bits(v.0) | bits(v.1)).leading_zeros());
    let product = |n: i64, m: i64| n.wrapping_shr(lost).wrapping_mul(m.wrapping_shr(lost));
    product(u.0, v.0).wrapping_add(product(u.1, v.1)) < 0
}

/// A vertex, and whether it lies inside of a curve, where the path has no corner.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) struct Knot {
    pub(crate) at: PointFx,
    pub(crate) smooth: bool,
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
    #[cfg_attr(embedded_raster_compact, inline(never))]
    fn time(self, done: u32) -> u32 {
        let Some(pieces) = NonZeroU32::new(self.pieces) else { return self.start };
        self.start.wrapping_add(done.wrapping_shl(self.level).wrapping_add(self.pieces >> 1) / pieces)
    }
}

impl Bezier {
    /// One that stays where it is.
    pub(super) const NONE: Self = {
        let (part, nowhere) = (Section { start: 0, level: 0, pieces: 0, done: 0 }, PointFx::from_bits(0, 0));
        let (x, y) = (Polynomial::NONE, Polynomial::NONE);
        // Zeros, which are not copied from anywhere.
        Self { x, y, part, from: 0, last: nowhere, ahead: (0, nowhere), is_inside: false, is_small: false }
    };

    /// By its four control points, or, if it is not `cubic`, by the first three of them; the last one is its end in any case.
    #[cfg_attr(embedded_raster_compact, inline(never))]
    pub(super) fn set(&mut self, points: [PointFx; 4], cubic: bool, view: &View) {
        let places = points.map(bits);
        self.x = Polynomial::new(places.map(|p| p.0), cubic);
        self.y = Polynomial::new(places.map(|p| p.1), cubic);
        self.is_small = NARROW && self.x.is_small() && self.y.is_small();
        self.part = Section { start: 0, level: 0, pieces: 0, done: 0 };
        self.is_inside = points.iter().all(|&p| view.holds(p));
        let [start, _, _, end] = points;
        (self.from, self.last, self.ahead) = (0, start, (END, end));
    }

    /// When the part ended whose pieces have all come; `None` if others will come.
    pub(super) fn done(&self) -> Option<u32> {
        (self.part.done == self.part.pieces).then(|| self.part.end())
    }

    /// The end of the next piece; `None` at the end of the curve.
    pub(super) fn next(&mut self, view: &View, width: u32) -> Option<Knot> {
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
    pub(super) fn seen_until(&self, view: &View, width: u32) -> u32 {
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
    #[cfg_attr(embedded_raster_compact, inline(never))]
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

    /// When the piece that came last began and when it ended.
    pub(crate) fn times(&self) -> (u32, u32) {
        (self.from, self.part.time(self.part.done))
    }

    /// How the curve's slope changes from a time on, for so long: the slope is a curve of the second degree itself, and this is its middle
    /// control point.
    pub(crate) fn bend_of_way(&self, from: u32, length: u32) -> Way {
        let slopes = [0, length >> 1, length].map(|t| self.slope(from.wrapping_add(t)));
        let control = |[a, m, b]: [i64; 3]| (m << 2).wrapping_sub(a).wrapping_sub(b);
        (control(slopes.map(|s| s.0)), control(slopes.map(|s| s.1)))
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

    /// Whether the piece that came last ends at a place.
    pub(crate) fn is_at(&self, place: PointFx) -> bool {
        self.last == place
    }

    /// How long the curve is between two times, in units of 2^-20 pixel. `speed` is the length of a slope, as 31 bits, and how many leading
    /// zeros it had. Where it is short and turns back, as at a cusp, its speed has a kink: it is measured before that and after it.
    #[inline(never)]
    pub(crate) fn length(&self, (from, end): (u32, u32), speed: impl Fn(Way) -> (u32, u32)) -> u64 {
        let whole = self.even_length((from, end), &speed);
        let start = self.slope(from);
        if whole >= SHORT || !is_back(start, self.slope(end)) {
            return whole;
        }
        let (mut before, mut after) = (from, end);
        while after.wrapping_sub(before) > 1 {
            let middle = before.wrapping_add(after) >> 1;
            if is_back(start, self.slope(middle)) {
                after = middle;
            } else {
                before = middle;
            }
        }
        self.even_length((from, before), &speed).wrapping_add(self.even_length((before, end), &speed))
    }

    fn slope(&self, time: u32) -> Way {
        (self.x.slope(time), self.y.slope(time))
    }

    /// The same by its speed at the three times of Gauss's rule. What is rounded is rounded to nearest: lengths are summed up.
    #[inline(never)]
    fn even_length(&self, (from, end): (u32, u32), speed: impl Fn(Way) -> (u32, u32)) -> u64 {
        let h = end.wrapping_sub(from);
        // The root of 3/5.
        let off = low_u32(product(h, 3_326_808_142) >> 32);
        let at = |twice: u32| {
            let time = from.wrapping_add(twice >> 1);
            let (length, zeros) = speed(self.slope(time));
            product(length, h).wrapping_shr(zeros.wrapping_sub(2)).wrapping_add(1) >> 1
        };
        let (a, b, c) = (at(h.wrapping_sub(off)), at(h), at(h.wrapping_add(off)));
        let sum = a.wrapping_add(c).wrapping_mul(5).wrapping_add(b << 3).wrapping_add(9);
        // 2^32 / 18.
        magnitude(times((signed_wide(sum >> 32), low_u32(sum)), 238_609_294).0)
    }

    /// When between two times the curve has gone so far, in units of 2^-20 pixel.
    #[inline(never)]
    pub(crate) fn time_at(
        &self,
        (mut from, mut end): (u32, u32),
        mut s: u64,
        speed: impl Fn(Way) -> (u32, u32),
    ) -> u32 {
        while end.wrapping_sub(from) > 1 {
            let middle = from.wrapping_add(end) >> 1;
            let length = self.length((from, middle), &speed);
            if s <= length {
                end = middle;
            } else {
                (from, s) = (middle, s.wrapping_sub(length));
            }
        }
        from
    }

    /// Which way it goes at a time. Where it stands still for a moment, it goes one way before, and perhaps another way after.
    #[inline(never)]
    pub(crate) fn way(&self, time: u32, before: bool) -> Way {
        let slope = self.slope(time);
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

    /// Its point at a time.
    #[cfg_attr(embedded_raster_compact, inline(never))]
    pub(crate) fn at(&self, t: u32) -> PointFx {
        #[cfg(test)]
        crate::num::tally::add(crate::num::tally::Work::Point);
        PointFx::from_bits(self.x.at(t), self.y.at(t))
    }
}
