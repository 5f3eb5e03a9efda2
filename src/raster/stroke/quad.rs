//! A line without caps: one parallelogram, filled without an edge table.
//!
//! ```text
//!            top                On each row two sides are crossed. From the top corner two sides go down, and each is followed by
//!           /   '-._            the one opposite to the other. Which of both is the left one need not be computed: crossings are
//!        one        '-._        rounded the same way on both, so the lesser is the left one's, or they are equal and there is no
//!           '-._        two     pixel between them.
//!               '-._   /
//!                   end
//! ```

use super::{
    direction::{moved, Direction},
    pen::Pen,
};
use crate::{
    geom::{bits, PointFx},
    num::{round::first_centre_from, stepper::Stepper},
    raster::slope::Slope,
    span::{Rect, Sink, Span},
};

/// Emits the spans of a line with butt caps, as wide as the pen, that lie in `window`.
#[inline]
pub(super) fn fill(pen: &Pen, a: PointFx, b: PointFx, window: Rect, sink: impl Sink) {
    if window.is_empty() || pen.sight.hides(a, b) {
        return;
    }
    let Some(u) = Direction::between(a, b) else { return };
    let (right, left) = (u.right().offset(pen.width), u.right().back().offset(pen.width));
    let corners = [moved(a, right), moved(b, right), moved(b, left), moved(a, left)].map(bits);
    // The highest corner, and those beside it.
    let (mut first, mut top) = (0, i32::MAX);
    for (i, corner) in corners.iter().enumerate() {
        if corner.1 < top {
            (first, top) = (i, corner.1);
        }
    }
    let corner = |i: usize| corners.get(first.wrapping_add(i) & 3).copied().unwrap_or_default();
    draw([corner(0), corner(1), corner(3), corner(2)], window, sink);
}

/// The sides of a chain of two, row by row.
struct Chain {
    crossing: Stepper,
    /// The first row of the second side, and that side.
    turn: i32,
    rest: [(i32, i32); 2],
}

impl Chain {
    /// From row y on.
    #[inline(always)]
    fn new([top, middle, end]: [(i32, i32); 3], (y, y1): (i32, i32)) -> Self {
        let turn = first_centre_from(middle.1);
        let mut chain = Self { crossing: Stepper::still(0), turn, rest: [middle, end] };
        if y < turn {
            chain.start([top, middle], (y, y1.min(turn)));
        } else {
            chain.second((y, y1));
        }
        chain
    }

    #[inline(never)]
    fn start(&mut self, [a, b]: [(i32, i32); 2], (y, y1): (i32, i32)) {
        if let Some(slope) = Slope::new(a, b) {
            self.crossing = slope.stepper_at(y, y1.wrapping_sub(y));
        }
    }

    #[inline(always)]
    fn second(&mut self, rows: (i32, i32)) {
        self.turn = i32::MAX;
        self.start(self.rest, rows);
    }
}

/// The top corner, those beside it, and the opposite one.
#[inline(never)]
fn draw([top, one, two, end]: [(i32, i32); 4], window: Rect, mut sink: impl Sink) {
    let (mut y, y1) = (first_centre_from(top.1).max(window.y0), first_centre_from(end.1).min(window.y1));
    if y >= y1 {
        return;
    }
    let (mut left, mut right) = (Chain::new([top, one, end], (y, y1)), Chain::new([top, two, end], (y, y1)));
    loop {
        let stop = left.turn.min(right.turn).min(y1);
        let (mut p, mut q) = (left.crossing, right.crossing);
        while y < stop {
            #[cfg(test)]
            crate::num::tally::add(crate::num::tally::Work::Step);
            let (x0, x1) = (p.value.min(q.value), p.value.max(q.value));
            if let Some(span) = (Span { y, x0, x1 }).clip_columns(window) {
                sink.span(span);
            }
            p.step();
            q.step();
            y = y.wrapping_add(1);
        }
        if y >= y1 {
            return;
        }
        (left.crossing, right.crossing) = (p, q);
        for chain in [&mut left, &mut right] {
            if chain.turn == y {
                chain.second((y, y1));
            }
        }
    }
}
