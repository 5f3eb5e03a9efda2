//! [`Border`]: the border of a stroke, from side to side.
//!
//! Each part of a stroke has a border that turns the same way, and where two parts touch both have the same line, once in each
//! direction. Such a pair cancels out, so it is left out, and what comes out is the border of a whole run:
//! ```text
//!      _________ _________                 _________ _________
//!     |         |         |               |                   |      the lines across are in two borders,
//!     |    1    |    2    |      ->       |         1 + 2     |      once up and once down
//!     |_________|_________|               |_________ _________|
//! ```
//! How often a place is wound around is the sum over all parts, and it is the same with and without such lines. So the order in
//! which the lines are made does not matter: the right border and the left one grow at once, and nothing is stored but the end
//! that is open, and the start of a ring.

use super::{
    direction::Direction,
    pen::Pen,
    pieces::{opposite, Each, End, Pieces},
    sides::{Follow, Outline, Side, Start},
};
use crate::geom::{flatten::THIN, PointFx};

/// What came before.
#[derive(Copy, Clone, Debug)]
enum Last {
    /// Nothing: the next side begins with a cap.
    Nothing,
    /// Something that cannot be seen.
    Hidden,
    Side(End),
}

/// The border of a stroke.
pub(super) struct Border<'a, const CURVED: bool> {
    pieces: Pieces<'a, CURVED>,
    last: Last,
    /// The start of a ring, which will be joined to its end.
    first: Option<End>,
}

impl<'a, const CURVED: bool> Border<'a, CURVED> {
    pub(super) fn new(pen: Pen, each: Each<'a>) -> Self {
        Self { pieces: Pieces { pen, each }, last: Last::Nothing, first: None }
    }

    /// The side and what is between it and the last one.
    fn add(&mut self, side: &Side) {
        let &Side { a, b, start, ways: [ua, ub] } = side;
        let is_straight = !CURVED || ua == ub;
        let from =
            End { is_drawn: !self.pieces.pen.sight.hides(a, b), ..self.pieces.end(a, ua, is_straight.then_some(b)) };
        match &self.last {
            Last::Side(last) => self.pieces.join(last, &from, start == Start::Smooth),
            Last::Nothing if start == Start::Ring => self.first = Some(from),
            Last::Nothing => self.pieces.cap(&End { u: ua.back(), offset: opposite(from.offset), ..from }),
            Last::Hidden if from.is_drawn => self.pieces.across(a, opposite(from.offset)),
            Last::Hidden => {}
        }
        let end = if is_straight {
            End { at: b, other: Some(a), ..from }
        } else {
            End { is_drawn: from.is_drawn, ..self.pieces.end(b, ub, None) }
        };
        self.last = Last::Side(end);
        if !from.is_drawn {
            return;
        }
        // A side that turns by more than its border may does so within a hair, or it would not be one side. There, and where the
        // stroke is thin, the pen turns before the side and after it.
        let turns = !is_straight && (self.pieces.pen.width <= THIN || self.pieces.turns_much(ua, ub));
        match if turns { Direction::between(a, b) } else { None } {
            None => self.pieces.band(&from, &end),
            Some(u) => {
                let (start, stop) = (self.pieces.end(a, u, Some(b)), self.pieces.end(b, u, Some(a)));
                self.pieces.join(&from, &start, true);
                self.pieces.band(&start, &stop);
                self.pieces.join(&stop, &end, true);
            }
        }
    }
}

impl<const CURVED: bool> Follow for Border<'_, CURVED> {
    fn side<O: Outline>(&mut self, side: &Side, _: &O) {
        self.add(side);
    }

    fn hidden<O: Outline>(&mut self, _: PointFx, _: PointFx, _: &O) {
        match &self.last {
            Last::Side(last) if last.is_drawn => self.pieces.across(last.at, last.offset),
            _ => {}
        }
        self.last = Last::Hidden;
    }

    fn stop(&mut self) {
        if let Last::Side(last) = &self.last {
            self.pieces.cap(last);
        }
        self.last = Last::Nothing;
    }

    fn close(&mut self) {
        match (&self.last, self.first.take()) {
            (Last::Side(last), Some(first)) => self.pieces.join(last, &first, false),
            // Of a ring without a start nothing can be seen there, or a dash ends there.
            (Last::Side(last), None) => self.pieces.cap(last),
            (Last::Hidden, Some(first)) if first.is_drawn => self.pieces.across(first.at, opposite(first.offset)),
            (Last::Nothing, Some(first)) => {
                self.pieces.cap(&End { u: first.u.back(), offset: opposite(first.offset), ..first });
            }
            _ => {}
        }
        self.last = Last::Nothing;
    }

    fn dot(&mut self, at: PointFx) {
        self.pieces.dot(at);
    }
}
