//! The sides of a contour: from place to place, and which way the path goes at both ends of each.

use core::slice;

use super::{
    direction::{is_tiny, Direction},
    pen::Sight,
};
use crate::geom::{
    flatten::{Bezier, Contour, Front, Knot, Way, THIN},
    PointFx, Segments,
};

/// Something that is a list of places.
pub trait Outline {
    /// The next place, and whether the path is smooth there.
    fn next_place(&mut self) -> Option<(PointFx, bool)>;
    /// Whether there is a side from the last place to the first.
    fn is_closed(&self) -> bool;
    /// Whether it may have a corner at a place, though the knot there is smooth.
    fn ends_at(&self, v: PointFx) -> bool;
    /// The curve that the last side is a part of.
    fn curve(&self) -> Option<&Bezier>;
}

/// An outline of which the end may be left out.
pub trait Whole: Outline {
    /// The same up to the last part of it that can be seen: what is left out does not change what is seen. Curves are followed
    /// `everywhere` or where they can be seen.
    fn front(&mut self, sight: &Sight, everywhere: bool) -> impl Outline;
}

impl<I: Segments, const WIDE: bool> Outline for Contour<I, WIDE> {
    #[inline]
    fn next_place(&mut self) -> Option<(PointFx, bool)> {
        self.next_knot().map(|Knot { at, smooth }| (at, smooth))
    }

    #[inline]
    fn is_closed(&self) -> bool {
        self.is_closed()
    }

    #[inline]
    fn ends_at(&self, v: PointFx) -> bool {
        self.ends_at(v)
    }

    #[inline]
    fn curve(&self) -> Option<&Bezier> {
        self.curve()
    }
}

impl<I: Segments, const WIDE: bool> Whole for Contour<I, WIDE> {
    #[inline]
    fn front(&mut self, sight: &Sight, everywhere: bool) -> impl Outline {
        self.front(sight.near, everywhere, |v| sight.hides_corner(v))
    }
}

impl<I: Segments, const WIDE: bool> Outline for Front<'_, I, WIDE> {
    #[inline]
    fn next_place(&mut self) -> Option<(PointFx, bool)> {
        self.next_knot().map(|Knot { at, smooth }| (at, smooth))
    }

    #[inline]
    fn is_closed(&self) -> bool {
        self.is_closed()
    }

    #[inline]
    fn ends_at(&self, v: PointFx) -> bool {
        self.ends_at(v)
    }

    #[inline]
    fn curve(&self) -> Option<&Bezier> {
        self.curve()
    }
}

/// Lines from place to place.
#[derive(Clone, Debug)]
pub(super) struct Polyline<'a> {
    pub(super) places: slice::Iter<'a, PointFx>,
    pub(super) closed: bool,
}

impl Outline for Polyline<'_> {
    #[inline]
    fn next_place(&mut self) -> Option<(PointFx, bool)> {
        self.places.next().map(|&at| (at, false))
    }

    #[inline]
    fn is_closed(&self) -> bool {
        self.closed
    }

    #[inline]
    fn ends_at(&self, _: PointFx) -> bool {
        true
    }

    #[inline]
    fn curve(&self) -> Option<&Bezier> {
        None
    }
}

impl Whole for Polyline<'_> {
    fn front(&mut self, sight: &Sight, _: bool) -> impl Outline {
        let places = self.places.as_slice();
        let hides = |a: PointFx, b: PointFx| sight.hides(a, b) && sight.hides_corner(a) && sight.hides_corner(b);
        let [first, .., last] = *places else { return self.clone() };
        if self.closed && !hides(last, first) {
            return self.clone();
        }
        let seen = places.windows(2).rposition(|side| matches!(*side, [a, b] if !hides(a, b)));
        let len = seen.map_or(0, |side| side.wrapping_add(2));
        Self { places: places.get(..len).unwrap_or_default().iter(), closed: false }
    }
}

/// A side that can be seen. If it ends where it starts, the pen turns there.
#[derive(Copy, Clone, Debug)]
pub(super) struct Side {
    /// Where it starts.
    pub(super) a: PointFx,
    /// Where it ends.
    pub(super) b: PointFx,
    /// Which way it goes at `a` and at `b`.
    pub(super) ways: [Direction; 2],
    /// What is at `a`.
    pub(super) start: Start,
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

/// Follows contours, side by side.
pub(super) trait Follow {
    /// A side, which is a part of the last curve of the outline if that has one.
    fn side<O: Outline>(&mut self, side: &Side, outline: &O);
    /// A side that is a tiny part of the last curve, from one place to another or to the same one: see [`turn`].
    fn turn<O: Outline>(&mut self, ends: (PointFx, PointFx), start: Start, outline: &O);
    /// A part of the last curve that is no side: it ends where it starts.
    fn stay<O: Outline>(&mut self, outline: &O);
    /// A side that lies outside of the window, with all that is drawn for it.
    fn hidden<O: Outline>(&mut self, a: PointFx, b: PointFx, outline: &O);
    /// The end of an open contour: the last side has a cap there.
    fn stop(&mut self);
    /// The end of a closed contour: its last side is joined to its first one.
    fn close(&mut self);
    /// A contour without length.
    fn dot(&mut self, at: PointFx);
}

/// Goes along a contour. Sides of no length are left out, but where a curve turns. Where a stroke is thin, the sides inside of a curve
/// are straight.
pub(super) fn follow<O: Outline>(outline: &mut O, sight: &Sight, width: u32, to: &mut impl Follow) {
    let Some((start, _)) = outline.next_place() else { return };
    let mut last = Knot { at: start, smooth: false };
    let (mut way, mut moved, mut done) = (None, false, false);
    while !done {
        let knot = if let Some((at, smooth)) = outline.next_place() {
            Knot { at, smooth }
        } else {
            done = true;
            if !outline.is_closed() {
                break;
            }
            Knot { at: start, smooth: false }
        };
        let (a, b) = (last.at, knot.at);
        let is_part = !done && outline.curve().is_some();
        let turns = is_part && width > THIN && is_tiny(a, b, width);
        if a == b && !(turns && can_turn(outline, sight, a)) {
            // The same place again makes no side. It is smooth if both are.
            if is_part {
                to.stay(outline);
            }
            last.smooth = last.smooth && (knot.smooth || done);
            continue;
        }
        let kind = match last.smooth {
            _ if !moved && outline.is_closed() => Start::Ring,
            true => Start::Smooth,
            false => Start::Corner,
        };
        moved = true;
        let no_tip = |smooth: bool, v: PointFx| smooth || sight.hides_corner(v);
        let is_hidden = sight.hides(a, b) && no_tip(last.smooth, a) && no_tip(knot.smooth && !outline.ends_at(b), b);
        if turns && !is_hidden {
            to.turn((a, b), kind, outline);
            (way, last) = (None, knot);
            continue;
        }
        match if is_hidden { None } else { ways(outline, (a, b), &mut way, !done, width <= THIN) } {
            Some(ways) => to.side(&Side { a, b, ways, start: kind }, outline),
            None => to.hidden(a, b, outline),
        }
        last = knot;
    }
    match outline.is_closed() {
        _ if !moved => to.dot(start),
        true => to.close(),
        false => to.stop(),
    }
}

/// The shortest time that is looked at, of 2^20 for a curve: where a curve hardly moves, its way is rounded.
const LEAST: u32 = 64;

/// Whether a curve that is seen here goes anywhere.
fn can_turn<O: Outline>(outline: &O, sight: &Sight, at: PointFx) -> bool {
    !sight.hides(at, at) && outline.curve().is_some_and(|curve| curve.way(0, false) != (0, 0))
}

/// A tiny part of a curve, between two times, may turn by any angle, and its chord says nothing of where it goes. The pen turns where it
/// starts, goes straight to where it ends, and turns there.
#[inline(never)]
pub(super) fn turn(
    curve: &Bezier,
    (from, end): (u32, u32),
    (a, b): (PointFx, PointFx),
    mut start: Start,
    width: u32,
    mut to: impl FnMut(&Side),
) {
    let way = |time: u32, before: bool| Direction::of(curve.way(time, before)).unwrap_or(Direction::RIGHT);
    let (mut u, last) = (way(from, false), way(end, true));
    let is_even = |u: Direction, time: u32, length: u32, v: Direction| {
        let bend = Direction::of(curve.bend_of_way(time, length));
        u.is_near(v) && bend.is_some_and(|bend| u.turns_evenly(bend, v, width))
    };
    if from == end {
        return to(&Side { a, b, ways: [u; 2], start });
    }
    if a != b
        && u.leads(a, b)
        && last.leads(a, b)
        && !u.turns_much(last, width)
        && is_even(u, from, end.wrapping_sub(from), last)
    {
        return to(&Side { a, b, ways: [u, last], start });
    }
    let (mut time, middle) = (from, from.wrapping_add(end) >> 1);
    for (place, until) in [(a, middle), (b, end)] {
        if until != middle && a != b {
            to(&Side { a, b, ways: [u; 2], start });
            start = Start::Smooth;
        }
        while time < until {
            // The longest that halving makes: a curve from its end to its start is cut at the same times.
            let left = until.wrapping_sub(time);
            let mut length = 1_u32.wrapping_shl(time.trailing_zeros().min(31_u32.wrapping_sub(left.leading_zeros())));
            let v = loop {
                let v = way(time.wrapping_add(length), true);
                if length <= LEAST || is_even(u, time, length, v) {
                    break v;
                }
                length >>= 1;
            };
            to(&Side { a: place, b: place, ways: [u, v], start });
            time = time.wrapping_add(length);
            (u, start) = (way(time, false), Start::Smooth);
        }
    }
}

/// Which way a side goes at its ends: as its curve does, or straight. `is_part`: of the outline's curve, if there is one. `known`: a
/// way and its direction, those of the end of the last side; then those of this one.
fn ways<O: Outline>(
    outline: &O,
    (a, b): (PointFx, PointFx),
    known: &mut Option<(Way, Direction)>,
    is_part: bool,
    is_thin: bool,
) -> Option<[Direction; 2]> {
    let Some(curve) = outline.curve().filter(|_| is_part) else { return Direction::between(a, b).map(|u| [u; 2]) };
    let [start, end] = curve.ways(is_thin);
    let (last, to) = (known.filter(|&(way, _)| way == start).map(|(_, u)| u), Direction::of(end));
    *known = to.map(|u| (end, u));
    match (last.or_else(|| Direction::of(start)), to) {
        (Some(from), Some(to)) => Some([from, to]),
        (from, to) => Direction::between(a, b).map(|u| [from.unwrap_or(u), to.unwrap_or(u)]),
    }
}
