//! Strokes with gaps.
//!
//! ```text
//!    lengths  [ 6 | 3 | 2 | 3 ]      on, off, on, off, and from the start again
//!
//!    a ======   ==   ======   ==   =====     a dash goes on around a corner, and has two ends with caps
//!      |<phase>|                        =    the pattern starts `phase` before the contour does
//! ```
//! **The rule.** The pattern runs along each contour from its start, in units of 2^-20 pixel. A side is as long as `floor(2^12 |d|)`,
//! with d scaled as for [`stroke`](super). A side that stands for a part of a curve is as long as that part. By Gauss's rule this is the
//! mean of its speeds at three times, times how long it takes: in the middle, and at the root of 3/20 of that time before and after,
//! which weigh 8, 5 and 5 of 18. A part shorter than 32 units at whose end the curve has turned by more than a quarter of a turn is
//! measured in two: until it has, and from then on. A part of a curve that ends where it starts is no side; the next side is longer by
//! its length. The place at a distance s from the start of a side with the direction u is `a + u s`, rounded to the nearest unit, or the
//! end of the side. Where the side is a part of a curve, the dash ends at right angles to the curve there. Between two such places, or
//! the ends of the side, a dash is a side of the same direction.
//!
//! A tiny part of a curve, within which the pen may turn on the spot (see [`stroke`](super)), is cut by time: its time is halved to 2^-20 of
//! the curve, each half being as long as Gauss's rule says. What lies between two cuts is such a part itself, from the point of the curve
//! at the one to that at the other, and turns by what the curve turns by between them.
//!
//! A pattern with an odd number of lengths counts twice, the second time with on and off exchanged. Negative lengths count as 0. A
//! dash that goes on to the end of a ring, and one that begins at its start, are one, with a join. A pattern that is shorter in all
//! than 1/16 pixel, or than 1/64 of the width, is solid. A length of 0 is a dot with round caps, and a square with square ones.
//!
//! **Work.** A contour that cannot be seen costs a few comparisons a segment, however many dashes it has. Of another one all
//! is measured that comes before the last part that can be seen: by a square root for each line, and three for each of those that a
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
//! the window, between the ends of the type, takes less than 40 square roots, where measuring all of it takes more than 10,000; twenty
//! loops out of the window and back, with 200 slots in 41 bands, make less than six times the sides of pieces that they make in one,
//! and take less than eight times the steps in the pattern.

use core::{mem, num::NonZeroU32};

use fixed::types::I24F8;

use super::{
    border::Border,
    cut::Cut,
    direction::{distance, speed, Direction, OVERSHOT},
    pen::{Pen, Sight},
    sides::{follow, Follow, Outline, Side, Start, Whole},
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
    /// square root for each line, and three for each of the lines that a curve is cut into (2^15 at most), as the phase depends on them.
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
        let Self { width, cap, join, miter_limit, min_width, dash: () } = self;
        Stroke { width, cap, join, miter_limit, min_width, dash: Dash { lengths, phase } }
    }
}

impl Cut for Dash<'_> {
    #[expect(clippy::while_let_on_iterator, reason = "a `for` loop moves each outline, which may have many words")]
    fn border<O: Whole, const CURVED: bool>(
        self,
        mut contours: impl Iterator<Item = O>,
        pen: &Pen,
        each: &mut dyn FnMut(PointFx, PointFx),
    ) {
        let pattern = Pattern::new(self.lengths, pen.width);
        let (sight, first) = (pen.sight.wider(OVERSHOT), pattern.map_or(Place::default(), |p| p.start(self.phase)));
        let border = Border::<CURVED>::new(pen, each);
        let mut cutter =
            Cutter { border, sight: &sight, pattern, first, at: first, skipped: 0, still: 0, has_ended: false };
        while let Some(ref mut outline) = contours.next() {
            follow(&mut outline.front(&sight, pattern.is_some()), &sight, pen.width, &mut cutter);
        }
    }
}

/// Lengths, in units of 2^-20 pixel from here on.
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
    const LEAST: u64 = 1 << 16;

    /// `None` if it is solid.
    fn new(lengths: &'a [I24F8], width: u32) -> Option<Self> {
        let least = Self::LEAST.max(u64::from(width) << 6);
        let sum = lengths.iter().fold(0, |sum: u64, &length| sum.saturating_add(units(length)));
        let times = lengths.len() & 1;
        let (count, period) = (lengths.len() << times, sum << times);
        (least..1 << 60).contains(&period).then_some(Self { lengths, count, period })
    }

    fn length(&self, index: usize) -> u64 {
        let again = index.wrapping_sub(self.lengths.len());
        self.lengths.get(index).or_else(|| self.lengths.get(again)).map_or(0, |&length| units(length))
    }

    fn start(&self, phase: I24F8) -> Place {
        let rest = self.rest(u64::from(phase.to_bits().unsigned_abs()) << 12);
        let back = phase < I24F8::ZERO && rest > 0;
        let mut at = Place { index: 0, left: self.length(0) };
        self.advance(&mut at, if back { self.period.wrapping_sub(rest) } else { rest });
        at
    }

    /// A distance less all whole periods. It is below 2^48, or below 2^47 more than a period.
    #[inline(never)]
    fn rest(&self, distance: u64) -> u64 {
        if let Some(period) = NonZeroU32::new(low_u32(self.period)).filter(|_| self.period >> 32 == 0) {
            return u64::from(div_rem_wide(distance, period).1);
        }
        // The distance is below 2^16 periods.
        (0..16).rev().fold(distance, |rest, n| {
            if rest.wrapping_shr(n) >= self.period {
                rest.wrapping_sub(self.period.wrapping_shl(n))
            } else {
                rest
            }
        })
    }

    /// Moves a place on by a distance of at most one period.
    #[inline(never)]
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
    magnitude(i64::from(length.to_bits().max(0))) << 12
}

/// A side that is being cut, from `s` on.
struct Length {
    side: Side,
    /// From its start straight to its end, if it is cut in between; and how far that is.
    u: Direction,
    straight: u64,
    /// As long as the curve, which may be a little more.
    whole: u64,
    s: u64,
    /// The place there.
    at: PointFx,
}

/// How far it is from one place to another, as the curve goes of which this is a part.
fn measure<O: Outline>(a: PointFx, b: PointFx, outline: &O) -> u64 {
    // The side that closes a ring begins where the last piece ended.
    let curve = outline.curve().filter(|curve| !curve.is_at(a));
    curve.map_or_else(|| distance(a, b), |curve| curve.length(curve.times(), speed))
}

impl Length {
    /// To this distance from its start.
    #[cfg_attr(embedded_raster_compact, inline(never))]
    fn go_to(&mut self, s: u64) {
        self.s = s;
        self.at = if s >= self.straight.min(self.whole) {
            self.side.b
        } else {
            let (x, y) = bits(self.side.a);
            PointFx::from_bits(along(x, self.u.x, s), along(y, self.u.y, s))
        };
    }

    /// Which way it goes at a place: at its ends it is known, in between the curve is asked.
    fn way<O: Outline>(&self, s: u64, at: PointFx, outline: &O) -> Direction {
        let [start, end] = self.side.ways;
        match outline.curve() {
            _ if s == 0 => start,
            Some(curve) if start != end && s != self.whole => {
                Direction::of(curve.way_beside(at, (self.u.x, self.u.y))).unwrap_or(self.u)
            }
            _ => end,
        }
    }
}

/// A coordinate, moved by a distance in a direction.
#[cfg_attr(embedded_raster_compact, inline(never))]
fn along(from: i32, u: i32, s: u64) -> i32 {
    let (high, _) = times((i64::from(low_u32(s >> 32)), low_u32(s)), u.unsigned_abs());
    let distance = high.wrapping_add(1 << 9) >> 10;
    saturate(i64::from(from).wrapping_add(if u < 0 { distance.wrapping_neg() } else { distance }))
}

/// Cuts sides into dashes.
struct Cutter<'a, 'b, const CURVED: bool> {
    border: Border<'b, CURVED>,
    sight: &'b Sight,
    /// `None` if it is solid.
    pattern: Option<Pattern<'a>>,
    /// The place in it at which a contour starts.
    first: Place,
    at: Place,
    /// How far ahead of that place the pattern is, by sides that cannot be seen.
    skipped: u64,
    /// How long the parts of curves are that came since the last side, and ended where they started: the next side is longer by that.
    still: u64,
    /// Whether a dash ended where the last side did. If a ring ends there too, the dash is joined to the first one.
    has_ended: bool,
}

impl<const CURVED: bool> Follow for Cutter<'_, '_, CURVED> {
    fn side<O: Outline>(&mut self, side: &Side, outline: &O) {
        let Some(pattern) = self.pattern else { return self.border.side(side, outline) };
        let &Side { a, b, ways: [start, _], .. } = side;
        let whole = measure(a, b, outline).wrapping_add(self.begin(&pattern));
        let (mut u, mut straight) = (start, whole);
        if outline.curve().is_some() && self.at.left < whole {
            (u, straight) = (Direction::between(a, b).unwrap_or(start), distance(a, b));
        }
        let mut length = Length { side: *side, u, straight, whole, s: 0, at: a };
        while length.s != length.whole {
            self.cut(&pattern, &mut length, outline);
        }
    }

    fn turn<O: Outline>(&mut self, (mut a, b): (PointFx, PointFx), start: Start, outline: &O) {
        let Some(curve) = outline.curve() else { return };
        let (mut from, end) = curve.times();
        let Some(pattern) = self.pattern else { return self.border.part(curve, (from, end), (a, b), start) };
        let whole = curve.length((from, end), speed).wrapping_add(self.begin(&pattern));
        let (mut s, start_time) = (0, from);
        loop {
            let start = if s == 0 { start } else { Start::Corner };
            let (on, left) = self.go_on(&pattern, whole.wrapping_sub(s));
            s = s.wrapping_add(left);
            let is_last = s == whole;
            let (until, to) = if is_last {
                (end, b)
            } else {
                let time = curve.time_at((start_time, end), s, speed);
                (time, curve.at(time))
            };
            if on {
                self.border.part(curve, (from, until), (a, to), start);
            }
            self.cut_off(on, is_last);
            if is_last {
                return;
            }
            (from, a) = (until, to);
        }
    }

    fn stay<O: Outline>(&mut self, outline: &O) {
        if let Some(curve) = outline.curve() {
            self.still = self.still.wrapping_add(curve.length(curve.times(), speed));
        }
    }

    fn hidden<O: Outline>(&mut self, a: PointFx, b: PointFx, outline: &O) {
        if let Some(pattern) = self.pattern {
            // The dash that came here, and its ends, cannot be seen: nothing has to be joined to it.
            self.has_ended = false;
            let still = mem::take(&mut self.still);
            self.skip(&pattern, measure(a, b, outline).wrapping_add(still));
        }
        self.border.hidden(a, b, outline);
    }

    fn stop(&mut self) {
        self.border.stop();
        self.restart();
    }

    fn close(&mut self) {
        self.border.close();
        self.restart();
    }

    fn dot(&mut self, at: PointFx) {
        if self.at.is_on() {
            self.border.dot(at);
        }
    }
}

impl<const CURVED: bool> Cutter<'_, '_, CURVED> {
    fn restart(&mut self) {
        (self.at, self.skipped, self.still, self.has_ended) = (self.first, 0, 0, false);
    }

    /// Before the next side: how much longer it is than it seems.
    #[cfg_attr(embedded_raster_compact, inline(never))]
    fn begin(&mut self, pattern: &Pattern<'_>) -> u64 {
        self.end();
        let skipped = pattern.rest(mem::take(&mut self.skipped));
        pattern.advance(&mut self.at, skipped);
        mem::take(&mut self.still)
    }

    /// Goes on by one length of the pattern, or by `left` if that is less: whether it is on, and how far.
    #[cfg_attr(embedded_raster_compact, inline(never))]
    fn go_on(&mut self, pattern: &Pattern<'_>, left: u64) -> (bool, u64) {
        let (on, left) = (self.at.is_on(), left.min(self.at.left));
        self.at.left = self.at.left.wrapping_sub(left);
        self.has_ended = self.at.left == 0;
        if self.has_ended {
            pattern.next(&mut self.at);
        }
        (on, left)
    }

    /// Behind a length of the pattern. A dash that ends where a side does may be joined to another one.
    #[cfg_attr(embedded_raster_compact, inline(never))]
    fn cut_off(&mut self, on: bool, is_last: bool) {
        if on && is_last {
            return;
        }
        // The next dash has a cap, even if what came before a gap cannot be seen.
        if mem::take(&mut self.has_ended) || !on {
            self.border.stop();
        }
    }

    /// Ends the dash that went as far as the last side.
    fn end(&mut self) {
        if mem::take(&mut self.has_ended) {
            self.border.stop();
        }
    }

    /// Moves on by a distance below 2^46 and a little more.
    #[cfg_attr(embedded_raster_compact, inline(never))]
    fn skip(&mut self, pattern: &Pattern<'_>, distance: u64) {
        self.skipped = self.skipped.wrapping_add(distance);
        if self.skipped >> 47 != 0 {
            self.skipped = pattern.rest(self.skipped);
        }
    }

    /// Goes on by one length of the pattern, or to the end of a side, or over whole periods that cannot be seen.
    #[cfg_attr(embedded_raster_compact, inline(never))]
    fn cut<O: Outline>(&mut self, pattern: &Pattern<'_>, length: &mut Length, outline: &O) {
        #[cfg(test)]
        crate::num::tally::add(crate::num::tally::Work::Dash);
        let (s, end) = (length.s, length.side.b);
        let (from, left) = (length.at, length.whole.wrapping_sub(s));
        // Between two lengths of the pattern, and with no corner behind, whole periods that cannot be seen are skipped.
        if s > 0 && !self.sight.shows(from) {
            let mut beside = self.sight.beside(from).min(left);
            if beside > 0 && self.sight.hides(from, end) {
                if self.sight.hides_corner(end) {
                    self.skip(pattern, left);
                    length.s = length.whole;
                    // What was on has ended at `from`, so there is nothing open.
                    return self.border.hidden(from, end, outline);
                }
                beside = left;
            }
            if beside >= pattern.period {
                length.go_to(s.wrapping_add(beside.wrapping_sub(pattern.rest(beside))));
                return;
            }
        }
        let (on, left) = self.go_on(pattern, left);
        length.go_to(s.wrapping_add(left));
        if on {
            self.dash(length, (s, from), outline);
        }
        self.cut_off(on, length.s == length.whole);
    }

    /// A part of a side, up to the present place.
    #[cfg_attr(embedded_raster_compact, inline(never))]
    fn dash<O: Outline>(&mut self, length: &Length, (s, a): (u64, PointFx), outline: &O) {
        let b = length.at;
        let start = match length.side.start {
            // A dash that is the first thing on a ring may be joined to the last one.
            start if s == 0 => start,
            _ => Start::Corner,
        };
        let ways = [length.way(s, a, outline), length.way(length.s, b, outline)];
        self.border.side(&Side { a, b, ways, start }, outline);
    }
}
