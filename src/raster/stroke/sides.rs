//! The sides of a contour, and the pieces of a stroke that they are made into.

use core::slice;

use super::{
    direction::Direction,
    pen::{Event, Pen, Piece, Start},
};
use crate::geom::{
    flatten::{Contour, Knot},
    PointFx, View,
};

/// Something that is a list of places.
pub(super) trait Outline: Clone {
    fn next_knot(&mut self) -> Option<Knot>;
    fn is_closed(&self) -> bool;
}

impl Outline for Contour<'_> {
    #[inline]
    fn next_knot(&mut self) -> Option<Knot> {
        self.next_knot()
    }

    #[inline]
    fn is_closed(&self) -> bool {
        self.is_closed()
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
    fn next_knot(&mut self) -> Option<Knot> {
        self.places.next().map(|&at| Knot { at, smooth: false })
    }

    #[inline]
    fn is_closed(&self) -> bool {
        self.closed
    }
}

/// The sides of a contour, without those of no length.
#[derive(Clone, Debug)]
pub(super) struct Sides<O> {
    outline: O,
    view: View,
    start: PointFx,
    last: Option<Knot>,
    /// Whether there was a side.
    moved: bool,
}

impl<O: Outline> Sides<O> {
    #[inline]
    pub(super) fn new(outline: O, view: View) -> Self {
        Self { outline, view, start: PointFx::from_bits(0, 0), last: None, moved: false }
    }

    fn side(&mut self, from: Knot, b: PointFx) -> Event {
        let ring = !self.moved && self.outline.is_closed();
        let start = match from.smooth {
            _ if ring => Start::Ring,
            true => Start::Smooth,
            false => Start::Corner,
        };
        self.moved = true;
        let a = from.at;
        let u = if self.view.hides(a, b, 0) { None } else { Direction::between(a, b).map(|(u, _)| u) };
        Event::Side { a, b, u, start }
    }
}

impl<O: Outline> Iterator for Sides<O> {
    type Item = Event;

    #[inline(never)]
    fn next(&mut self) -> Option<Event> {
        while let Some(node) = self.outline.next_knot() {
            match self.last.replace(node) {
                None => self.start = node.at,
                Some(last) if last.at != node.at => return Some(self.side(last, node.at)),
                // The same place again makes no side. It is smooth if both are.
                Some(last) => self.last = Some(Knot { smooth: node.smooth && last.smooth, ..node }),
            }
        }
        let last = self.last.take()?;
        let closed = self.outline.is_closed();
        if closed && last.at != self.start {
            self.last = Some(Knot { at: self.start, smooth: false });
            return Some(self.side(last, self.start));
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
