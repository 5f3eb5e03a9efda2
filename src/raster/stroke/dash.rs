//! Strokes with gaps.
//!
//! ```text
//!    lengths  [ 6 | 3 | 2 | 3 ]      on, off, on, off, and from the start again
//!
//!    a ======   ==   ======   ==   =====     a dash goes on around a corner, and has two ends with caps
//!      |<phase>|                        =    the pattern starts `phase` before the contour does
//! ```
//! **The rule.** The pattern runs along each contour from its start, in units of 2^-16 pixel: a side is as long as
//! `floor(2^8 |d|)`, with d scaled as for [`stroke`](super). The place at a distance s from the start of a side with the
//! direction u is `a + u s`, rounded to the nearest unit. Between two such places, or the ends of the side, a dash is a side of
//! the same direction. A pattern with an odd number of lengths counts twice, the second time with on and off exchanged. Negative
//! lengths count as 0. A pattern that is shorter in all than 1/16 pixel, or than 1/64 of the width, is solid. A length of 0 is a
//! dot with round caps, and a square with square ones.
//!
//! **Work.** A contour that cannot be seen costs a few comparisons a segment, however many dashes it has. Of another one all
//! is measured that comes before the last part that can be seen: by a square root for each line, and for each of those that a
//! curve is cut into. What comes behind is left out. What cannot be seen is measured, and no more: the pattern moves on by the sum
//! of the lengths, at most one period each time that the contour comes back into view. Of a side that can be seen, whole periods
//! beside the window are skipped at once. So a stroke takes work for
//!
//! * each segment;
//! * each dash in the window, and one period for each side there;
//! * each line before the last one that can be seen. A curve has 2^15 lines at most: the phase of its dashes depends on every one.
//!
//! With an edge table that is too small for the whole stroke, that is done for each band of rows, where "seen" is seen in the band:
//! lines are measured anew, up to the last that the band shows, and dashes of other bands are not made. Counted: a curve around
//! the window, between the ends of the type, takes 15 square roots, where 11,023 were taken when all of it was measured; twenty
//! loops out of the window and back, with 200 slots in 113 bands, 126,000 square roots, 30,000 steps in the pattern and
//! 48,000 sides of pieces; when each band made the whole stroke, it took 146,000, 595,000 and 932,000.

use core::{mem, num::NonZeroU32};

use fixed::types::I24F8;

use super::{
    cut::{Cut, Ready},
    direction::{distance, Direction, OVERSHOT},
    pen::{Event, Pen, Piece, Sight, Start},
    sides::{Outline, Pieces, Sides},
    style::Stroke,
};
use crate::{
    geom::{bits, PointFx},
    num::{
        cast::{low_u32, magnitude, saturate},
        round::div_rem_wide,
        wide::times,
    },
};

/// Lengths on and off in turn, in pixels, and how far into them a contour starts.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Dash<'a> {
    lengths: &'a [I24F8],
    phase: I24F8,
}

impl Stroke {
    /// With gaps: lengths on and off in turn, of which `phase` lies before the start of each contour. Whole pixels are
    /// [`px`](crate::px) of their number.
    ///
    /// What lies behind the last visible part of a contour costs a few comparisons a segment; what lies before it is measured, by a
    /// square root for each line, and for each of the lines that a curve is cut into (2^15 at most), as the phase depends on them.
    /// That is done once, or for each band of rows if the edge table is too small for the whole stroke.
    /// ```
    /// use embedded_raster::{buffer_bytes, px, Canvas, EdgeSlot, Framebuffer, Index1, Stroke, PointFx};
    /// let mut ram = [0; buffer_bytes::<Index1>(16, 3)];
    /// let mut frame = Framebuffer::<Index1>::new(&mut ram, 16, 3)?;
    /// let lengths = [4, 2].map(px);
    /// let line = [0, 16].map(|x| PointFx::from_bits(256 * x, 384));
    /// let stroke = Stroke::px(1).dashed(&lengths, px(1));
    /// frame.stroke_line_fx(line, &stroke, &mut [EdgeSlot::EMPTY; 16], Index1::MAX)?;
    /// assert_eq!(ram, [0, 0, 0b1110_0111, 0b1001_1110, 0, 0]);
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[inline]
    pub const fn dashed(self, lengths: &[I24F8], phase: I24F8) -> Stroke<Dash<'_>> {
        let Self { width, cap, join, miter_limit, dash: () } = self;
        Stroke { width, cap, join, miter_limit, dash: Dash { lengths, phase } }
    }
}

impl Cut for Dash<'_> {
    fn ready(self, width: u32) -> impl Ready {
        let pattern = Pattern::new(self.lengths, width)?;
        Some((pattern, pattern.start(self.phase)))
    }
}

/// A pattern, and the place in it where contours start. `None`: nothing to cut.
impl Ready for Option<(Pattern<'_>, Place)> {
    #[inline]
    fn pieces<O: Outline>(self, outline: O, pen: Pen) -> impl Iterator<Item = Piece> + Clone {
        let sight = pen.sight.wider(OVERSHOT);
        let sides = Sides::new(outline.front(sight, self.is_some()), sight);
        let at = self.map(|(_, start)| start).unwrap_or_default();
        Pieces::new(Cutter { sides, sight, pattern: self, at, skipped: 0, side: None, stop: false }, pen)
    }
}

/// Lengths, in units of 2^-16 pixel from here on.
#[derive(Copy, Clone, Debug)]
struct Pattern<'a> {
    lengths: &'a [I24F8],
    /// Lengths in a period: twice as many as there are in `lengths` if that number is odd.
    count: usize,
    period: u64,
}

/// A place in a pattern.
#[derive(Copy, Clone, Debug, Default)]
struct Place {
    index: usize,
    /// How much of this length lies ahead.
    left: u64,
}

impl Place {
    const fn is_on(self) -> bool {
        self.index & 1 == 0
    }
}

impl<'a> Pattern<'a> {
    /// The least period of narrow strokes: 1/16 pixel.
    const LEAST: u64 = 1 << 12;

    /// `None` if it is solid.
    fn new(lengths: &'a [I24F8], width: u32) -> Option<Self> {
        let least = Self::LEAST.max(u64::from(width) << 2);
        let sum = lengths.iter().fold(0, |sum: u64, &length| sum.saturating_add(units(length)));
        let times = lengths.len() & 1;
        let (count, period) = (lengths.len() << times, sum << times);
        (least..1 << 56).contains(&period).then_some(Self { lengths, count, period })
    }

    fn length(&self, index: usize) -> u64 {
        let again = index.wrapping_sub(self.lengths.len());
        self.lengths.get(index).or_else(|| self.lengths.get(again)).map_or(0, |&length| units(length))
    }

    fn start(&self, phase: I24F8) -> Place {
        let rest = self.rest(u64::from(phase.to_bits().unsigned_abs()) << 8);
        let back = phase < I24F8::ZERO && rest > 0;
        let mut at = Place { index: 0, left: self.length(0) };
        self.advance(&mut at, if back { self.period.wrapping_sub(rest) } else { rest });
        at
    }

    /// A distance less all whole periods. It is below 2^44, or below 2^43 more than a period.
    fn rest(&self, distance: u64) -> u64 {
        if let Some(period) = NonZeroU32::new(low_u32(self.period)).filter(|_| self.period >> 32 == 0) {
            return u64::from(div_rem_wide(distance, period).1);
        }
        // The distance is below 2^12 periods.
        (0..12).rev().fold(distance, |rest, n| {
            if rest.wrapping_shr(n) >= self.period {
                rest.wrapping_sub(self.period.wrapping_shl(n))
            } else {
                rest
            }
        })
    }

    /// Moves a place on by a distance of at most one period.
    fn advance(&self, at: &mut Place, mut distance: u64) {
        while distance > 0 && distance >= at.left {
            #[cfg(test)]
            crate::num::tally::add(crate::num::tally::Work::Dash);
            distance = distance.wrapping_sub(at.left);
            self.next(at);
        }
        at.left = at.left.wrapping_sub(distance);
    }

    fn next(&self, at: &mut Place) {
        let index = at.index.wrapping_add(1);
        at.index = if index < self.count { index } else { 0 };
        at.left = self.length(at.index);
    }
}

fn units(length: I24F8) -> u64 {
    magnitude(i64::from(length.to_bits().max(0))) << 8
}

/// A side that is being cut, from `s` on.
#[derive(Copy, Clone, Debug)]
struct Side {
    a: PointFx,
    b: PointFx,
    u: Direction,
    start: Start,
    length: u64,
    s: u64,
}

impl Side {
    fn at(&self, s: u64) -> PointFx {
        if s == self.length {
            return self.b;
        }
        let along = |from: i32, u: i32| {
            let (high, _) = times((i64::from(low_u32(s >> 32)), low_u32(s)), u.unsigned_abs());
            let distance = high.wrapping_add(1 << 5) >> 6;
            saturate(i64::from(from).wrapping_add(if u < 0 { distance.wrapping_neg() } else { distance }))
        };
        let (x, y) = bits(self.a);
        PointFx::from_bits(along(x, self.u.x), along(y, self.u.y))
    }
}

/// Sides with gaps.
#[derive(Clone, Debug)]
struct Cutter<'a, S> {
    sides: S,
    sight: Sight,
    /// And the place in it at which a contour starts. `None`: nothing to cut.
    pattern: Option<(Pattern<'a>, Place)>,
    at: Place,
    /// How far ahead of that place the pattern is, by sides that cannot be seen.
    skipped: u64,
    side: Option<Side>,
    /// Whether the dash ended with the piece that was returned last.
    stop: bool,
}

impl<S: Iterator<Item = Event>> Iterator for Cutter<'_, S> {
    type Item = Event;

    #[inline(never)]
    fn next(&mut self) -> Option<Event> {
        let Some((pattern, first)) = self.pattern else { return self.sides.next() };
        loop {
            if mem::take(&mut self.stop) {
                return Some(Event::Stop);
            }
            if let Some(mut side) = self.side.take() {
                if let Some(event) = self.piece(&pattern, &mut side) {
                    return Some(event);
                }
                continue;
            }
            match self.sides.next()? {
                Event::Side { a, b, u: Some(u), start } => {
                    let length = distance(a, b);
                    let skipped = pattern.rest(mem::take(&mut self.skipped));
                    pattern.advance(&mut self.at, skipped);
                    let start = if start == Start::Ring { Start::Corner } else { start };
                    self.side = Some(Side { a, b, u, start, length, s: 0 });
                }
                Event::Side { a, b, u: None, .. } => {
                    // The dash that came here, and its ends, cannot be seen: nothing has to be joined to it.
                    self.skip(&pattern, distance(a, b));
                    return Some(Event::Stop);
                }
                Event::Stop | Event::Close => {
                    (self.at, self.skipped) = (first, 0);
                    return Some(Event::Stop);
                }
                Event::Dot(_) if !self.at.is_on() => {}
                dot @ Event::Dot(_) => return Some(dot),
            }
        }
    }
}

impl<S> Cutter<'_, S> {
    /// Moves on by a distance below 2^42.
    fn skip(&mut self, pattern: &Pattern<'_>, distance: u64) {
        self.skipped = self.skipped.wrapping_add(distance);
        if self.skipped >> 43 != 0 {
            self.skipped = pattern.rest(self.skipped);
        }
    }

    /// The next piece of a side that is on. The side stays for another one unless it is used up.
    fn piece(&mut self, pattern: &Pattern<'_>, side: &mut Side) -> Option<Event> {
        loop {
            #[cfg(test)]
            crate::num::tally::add(crate::num::tally::Work::Dash);
            let from = side.at(side.s);
            let mut left = side.length.wrapping_sub(side.s);
            if left == 0 {
                return None;
            }
            // Between two lengths of the pattern, and with no corner behind, whole periods that cannot be seen are skipped.
            if side.s > 0 {
                let mut beside = self.sight.beside(from).min(left);
                if self.sight.hides(from, side.b) {
                    if self.sight.hides_corner(side.b) {
                        self.skip(pattern, left);
                        return None;
                    }
                    beside = left;
                }
                if beside >= pattern.period {
                    side.s = side.s.wrapping_add(beside.wrapping_sub(pattern.rest(beside)));
                    continue;
                }
            }
            let on = self.at.is_on();
            left = left.min(self.at.left);
            let start = if side.s == 0 { side.start } else { Start::Corner };
            side.s = side.s.wrapping_add(left);
            self.at.left = self.at.left.wrapping_sub(left);
            let ends = self.at.left == 0;
            if ends {
                pattern.next(&mut self.at);
            }
            if on {
                self.stop = ends;
                self.side = Some(*side);
                return Some(Event::Side { a: from, b: side.at(side.s), u: Some(side.u), start });
            }
        }
    }
}
