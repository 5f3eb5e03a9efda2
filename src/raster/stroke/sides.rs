//! The sides of a contour, and the pieces of a stroke that they are made into.

use core::slice;

use super::{
    direction::Direction,
    pen::{Event, Pen, Piece, Sight, Start},
};
use crate::geom::{
    flatten::{Contour, Front, Knot},
    PointFx, Segments,
};

/// Something that is a list of places.
pub trait Outline: Clone {
    /// The next place, and whether the path is smooth there.
    fn next_place(&mut self) -> Option<(PointFx, bool)>;
    /// Whether there is a side from the last place to the first.
    fn is_closed(&self) -> bool;
    /// Whether it may have a corner at a place, though the knot there is smooth.
    fn ends_at(&self, v: PointFx) -> bool;
    /// The same up to the last part of it that can be seen: what is left out does not change what is seen. Curves are followed
    /// `everywhere` or where they can be seen.
    fn front(self, sight: Sight, everywhere: bool) -> impl Outline;
}

impl<I: Segments> Outline for Contour<I> {
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
    fn front(self, sight: Sight, everywhere: bool) -> impl Outline {
        self.front(sight.near, everywhere, |v| sight.hides_corner(v))
    }
}

impl<I: Segments> Outline for Front<I> {
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
    fn front(self, _: Sight, _: bool) -> impl Outline {
        self
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

    fn front(self, sight: Sight, _: bool) -> impl Outline {
        let places = self.places.as_slice();
        let hides = |a: PointFx, b: PointFx| sight.hides(a, b) && sight.hides_corner(a) && sight.hides_corner(b);
        let [first, .., last] = *places else { return self };
        if self.closed && !hides(last, first) {
            return self;
        }
        let seen = places.windows(2).rposition(|side| matches!(*side, [a, b] if !hides(a, b)));
        let len = seen.map_or(0, |side| side.wrapping_add(2));
        Self { places: places.get(..len).unwrap_or_default().iter(), closed: false }
    }
}

/// The sides of a contour, without those of no length.
#[derive(Clone, Debug)]
pub(super) struct Sides<O> {
    outline: O,
    sight: Sight,
    start: PointFx,
    last: Option<Knot>,
    /// Whether there was a side.
    moved: bool,
}

impl<O: Outline> Sides<O> {
    #[inline]
    pub(super) fn new(outline: O, sight: Sight) -> Self {
        Self { outline, sight, start: PointFx::from_bits(0, 0), last: None, moved: false }
    }

    fn side(&mut self, from: Knot, to: Knot) -> Event {
        let ring = !self.moved && self.outline.is_closed();
        let start = match from.smooth {
            _ if ring => Start::Ring,
            true => Start::Smooth,
            false => Start::Corner,
        };
        self.moved = true;
        let (a, b) = (from.at, to.at);
        let no_tip = |smooth: bool, v: PointFx| smooth || self.sight.hides_corner(v);
        let hidden =
            self.sight.hides(a, b) && no_tip(from.smooth, a) && no_tip(to.smooth && !self.outline.ends_at(b), b);
        let u = if hidden { None } else { Direction::between(a, b) };
        Event::Side { a, b, u, start }
    }
}

impl<O: Outline> Iterator for Sides<O> {
    type Item = Event;

    #[inline(never)]
    fn next(&mut self) -> Option<Event> {
        while let Some((at, smooth)) = self.outline.next_place() {
            let node = Knot { at, smooth };
            match self.last.replace(node) {
                None => self.start = node.at,
                Some(last) if last.at != node.at => return Some(self.side(last, node)),
                // The same place again makes no side. It is smooth if both are.
                Some(last) => self.last = Some(Knot { smooth: node.smooth && last.smooth, ..node }),
            }
        }
        let last = self.last.take()?;
        let closed = self.outline.is_closed();
        if closed && last.at != self.start {
            let start = Knot { at: self.start, smooth: false };
            self.last = Some(start);
            return Some(self.side(last, start));
        }
        Some(match closed {
            _ if !self.moved => Event::Dot(self.start),
            true => Event::Close,
            false => Event::Stop,
        })
    }
}

/// The pieces of a stroke.
#[derive(Clone, Debug)]
pub(super) struct Pieces<E> {
    events: E,
    pen: Pen,
    /// What comes after the piece that was taken last.
    pending: Option<Piece>,
    /// Where the last side ended, and its direction if it is not hidden.
    last: Option<(PointFx, Option<Direction>)>,
    /// The direction of the first side.
    first: Option<Direction>,
}

impl<E: Iterator<Item = Event>> Pieces<E> {
    #[inline]
    pub(super) fn new(events: E, pen: Pen) -> Self {
        Self { events, pen, pending: None, last: None, first: None }
    }
}

impl<E: Iterator<Item = Event>> Iterator for Pieces<E> {
    type Item = Piece;

    #[inline(never)]
    fn next(&mut self) -> Option<Piece> {
        if let Some(part) = self.pending.take() {
            return Some(part);
        }
        loop {
            let pen = &self.pen;
            let parts = match self.events.next()? {
                Event::Side { a, b, u, start } => {
                    let before = match self.last {
                        Some((_, last)) => pen.join(a, last, u, start == Start::Smooth),
                        None if start == Start::Ring => None,
                        None => pen.cap(a, u.map(Direction::back)),
                    };
                    if start == Start::Ring {
                        self.first = u;
                    }
                    self.last = Some((b, u));
                    (before, u.and_then(|u| pen.side(a, b, u)))
                }
                Event::Stop => (self.last.take().and_then(|(b, u)| pen.cap(b, u)), None),
                Event::Close => (self.last.take().and_then(|(b, u)| pen.join(b, u, self.first, false)), None),
                Event::Dot(at) => {
                    let u = Direction::RIGHT;
                    (pen.cap(at, Some(u)), pen.cap(at, Some(u.back())))
                }
            };
            match parts {
                (Some(part), pending) => {
                    self.pending = pending;
                    return Some(part);
                }
                (None, Some(part)) => return Some(part),
                (None, None) => {}
            }
        }
    }
}
