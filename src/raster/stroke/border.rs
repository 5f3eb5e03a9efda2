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
    sides::{turn, Follow, Outline, Side, Start},
};
use crate::geom::{
    flatten::{Bezier, THIN},
    PointFx,
};

/// What came before.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
enum Last {
    /// Nothing: the next side begins with a cap.
    Nothing,
    /// Something that cannot be seen.
    Hidden,
    Side,
}

/// The border of a stroke.
pub(super) struct Border<'a, const CURVED: bool> {
    pieces: Pieces<'a, CURVED>,
    last: Last,
    /// The end of the last side, if that came last.
    end: End,
    /// The start of a ring, which will be joined to its end, if there is one.
    first: End,
    has_first: bool,
}

impl<'a, const CURVED: bool> Border<'a, CURVED> {
    pub(super) fn new(pen: &'a Pen, each: Each<'a>) -> Self {
        let (pieces, nowhere) = (Pieces { pen, each }, PointFx::from_bits(0, 0));
        let end = pieces.end(nowhere, Direction::RIGHT, nowhere, true, false);
        Self { pieces, last: Last::Nothing, end, first: end, has_first: false }
    }

    /// A tiny part of a curve, between two times.
    pub(super) fn part(&mut self, curve: &Bezier, times: (u32, u32), ends: (PointFx, PointFx), start: Start) {
        turn(curve, times, ends, start, self.pieces.pen.width, |side| self.add(side));
    }

    /// The side and what is between it and the last one.
    #[cfg_attr(embedded_raster_compact, inline(never))]
    fn add(&mut self, side: &Side) {
        let &Side { a, b, start, ways: [ua, ub] } = side;
        let (pieces, is_straight) = (&mut self.pieces, !CURVED || ua == ub && a != b);
        let is_drawn = !pieces.pen.sight.hides(a, b);
        let from = pieces.end(a, ua, b, is_straight, is_drawn);
        match self.last {
            Last::Side => pieces.join(&self.end, &from, start == Start::Smooth),
            Last::Nothing if start == Start::Ring => (self.first, self.has_first) = (from, true),
            Last::Nothing => pieces.cap(&from, true),
            Last::Hidden if is_drawn => pieces.across(a, opposite(from.offset)),
            Last::Hidden => {}
        }
        self.last = Last::Side;
        // The offset is the same, too.
        self.end = if is_straight { End { at: b, other: a, ..from } } else { pieces.end(b, ub, a, false, is_drawn) };
        if !is_drawn {
            return;
        }
        if CURVED && a == b {
            return pieces.join(&from, &self.end, true);
        }
        // Where the stroke is thin, the pen turns before the side and after it.
        let turns = !is_straight && pieces.pen.width <= THIN;
        match if turns { Direction::between(a, b) } else { None } {
            None => pieces.band(&from, &self.end),
            Some(u) => {
                let (start, stop) = (pieces.end(a, u, b, true, true), pieces.end(b, u, a, true, true));
                pieces.join(&from, &start, true);
                pieces.band(&start, &stop);
                pieces.join(&stop, &self.end, true);
            }
        }
    }
}

impl<const CURVED: bool> Follow for Border<'_, CURVED> {
    fn side<O: Outline>(&mut self, side: &Side, _: &O) {
        self.add(side);
    }

    fn turn<O: Outline>(&mut self, ends: (PointFx, PointFx), start: Start, outline: &O) {
        if let Some(curve) = outline.curve() {
            self.part(curve, curve.times(), ends, start);
        }
    }

    fn stay<O: Outline>(&mut self, _: &O) {}

    fn hidden<O: Outline>(&mut self, _: PointFx, _: PointFx, _: &O) {
        if self.last == Last::Side && self.end.is_drawn {
            self.pieces.across(self.end.at, self.end.offset);
        }
        self.last = Last::Hidden;
    }

    #[cfg_attr(embedded_raster_compact, inline(never))]
    fn stop(&mut self) {
        if self.last == Last::Side {
            self.pieces.cap(&self.end, false);
        }
        self.last = Last::Nothing;
    }

    #[cfg_attr(embedded_raster_compact, inline(never))]
    fn close(&mut self) {
        match (self.last, self.has_first) {
            (Last::Side, true) => self.pieces.join(&self.end, &self.first, false),
            // Of a ring without a start nothing can be seen there, or a dash ends there.
            (Last::Side, false) => self.pieces.cap(&self.end, false),
            (Last::Hidden, true) if self.first.is_drawn => {
                self.pieces.across(self.first.at, opposite(self.first.offset));
            }
            (Last::Nothing, true) => self.pieces.cap(&self.first, true),
            _ => {}
        }
        (self.last, self.has_first) = (Last::Nothing, false);
    }

    fn dot(&mut self, at: PointFx) {
        self.pieces.dot(at);
    }
}
