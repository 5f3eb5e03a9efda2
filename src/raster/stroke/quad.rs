//! A line without caps: one parallelogram, filled without an edge table.
//!
//! ```text
//!            top                On each row two sides are crossed. From the top corner two sides go down, and each is followed by
//!           /   '-._            the one opposite to the other.
//!        one        '-._
//!           '-._        two     Crossings are rounded the same way on both. So the lesser one belongs to the left side, or they
//!               '-._   /        are equal and there is no pixel between them.
//!                   end
//! ```
//! As with triangles there are two ways down: by sums of fixed-point numbers (`raster::sum`) on chips that divide, for lines that lie
//! between the sides of the window and are not too large; and by quotient and remainder.

use super::direction::{moved, Direction};
use crate::{
    geom::{bits, PointFx},
    num::{
        cast::signed,
        round::{difference, first_centre_from},
        stepper::Stepper,
    },
    raster::{
        slope::Slope,
        sum::{Sum, SUMS},
    },
    span::{Rect, Sink, Span},
};

/// Emits the spans of a line of this width with butt caps that lie in `window`. Its ends are not far out.
#[inline]
pub(super) fn fill(width: u32, a: PointFx, b: PointFx, window: Rect, sink: impl Sink) {
    if window.is_empty() || is_beside(signed(width).wrapping_add(2), [a, b].map(bits), window) {
        return;
    }
    let Some(u) = Direction::between(a, b) else { return };
    let (right, left) = (u.right().offset(width), u.right().back().offset(width));
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

/// Whether a line and so many units around it, below 2^30, lie on one side of the window as a whole.
#[inline(always)]
fn is_beside(reach: i32, [a, b]: [(i32, i32); 2], window: Rect) -> bool {
    let beside = |p: i32, q: i32, first: i32, end: i32| {
        p.max(q).wrapping_add(reach) >> 8 < first || p.min(q).wrapping_sub(reach) >> 8 >= end
    };
    beside(a.0, b.0, window.x0, window.x1) || beside(a.1, b.1, window.y0, window.y1)
}

/// The top corner, those beside it, and the opposite one.
#[inline(never)]
fn draw(corners: [(i32, i32); 4], window: Rect, sink: impl Sink) {
    let [top, one, two, end] = corners;
    let rows = (first_centre_from(top.1).max(window.y0), first_centre_from(end.1).min(window.y1));
    let x0 = first_centre_from(top.0.min(one.0).min(two.0).min(end.0));
    let x1 = first_centre_from(top.0.max(one.0).max(two.0).max(end.0));
    if rows.0 >= rows.1 || x0 >= window.x1 || x1 <= window.x0 {
        return;
    }
    let is_inside = x0 >= window.x0.max(0) && x1 <= window.x1 && x1 < Sum::COLUMNS;
    if SUMS && is_inside && end.1.wrapping_sub(top.1) < 1 << 16 {
        by_sums(corners, rows, sink);
    } else {
        by_steps(corners, rows, window, sink);
    }
}

/// The most common lines, by additions: less than 256 pixels high, with all of their columns in the window.
#[inline(always)]
fn by_sums([top, one, two, bottom]: [(i32, i32); 4], (mut y, y1): (i32, i32), mut sink: impl Sink) {
    // Seen from the top, the left one is the one that points further to the left.
    let way = |end: (i32, i32)| (difference(end.0, top.0), difference(end.1, top.1));
    let (p, q) = (way(one), way(two));
    let (left, right) = if p.0.wrapping_mul(q.1) < p.1.wrapping_mul(q.0) { (one, two) } else { (two, one) };
    // Opposite sides are parallel, so there are two steps.
    let step_to = |end: (i32, i32)| Slope::new(top, end).map_or(0, Sum::step_of);
    let [first, second] = [left, right].map(step_to);
    let mut sides = [Side { sum: Sum::default(), end: y }; 2];
    while y < y1 {
        let [p, q] = &mut sides;
        p.go_on([top, left, bottom], [first, second], (y, y1));
        q.go_on([top, right, bottom], [second, first], (y, y1));
        let (mut left, mut right, end) = (p.sum, q.sum, p.end.min(q.end));
        while y < end {
            #[cfg(test)]
            crate::num::tally::add(crate::num::tally::Work::Step);
            if let Some(span) = (Span { y, x0: left.x(), x1: right.x() }).known_inside() {
                sink.span(span);
            }
            left.step();
            right.step();
            y = y.wrapping_add(1);
        }
        (p.sum, q.sum) = (left, right);
    }
}

/// One of two sides that follow each other, as far down as its sum is exact.
#[derive(Copy, Clone)]
struct Side {
    sum: Sum,
    /// The row at which it ends or stops being exact.
    end: i32,
}

impl Side {
    /// Goes on from row y, if it ended there. `steps`: of the upper side and of the lower one.
    #[inline(never)]
    fn go_on(&mut self, [top, middle, bottom]: [(i32, i32); 3], steps: [u32; 2], (y, y1): (i32, i32)) {
        if y < self.end {
            return;
        }
        let turn = first_centre_from(middle.1);
        let (a, b, step, stop) =
            if y < turn { (top, middle, steps[0], turn.min(y1)) } else { (middle, bottom, steps[1], y1) };
        // It crosses row y, so it is not horizontal.
        let Some(slope) = Slope::new(a, b) else { return };
        self.sum = Sum::start(slope, y, step);
        self.end = stop.min(y.saturating_add(Sum::reach(slope.dy)));
    }
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

/// Lines of any size, by quotient and remainder.
#[inline(never)]
fn by_steps([top, one, two, end]: [(i32, i32); 4], (mut y, y1): (i32, i32), window: Rect, mut sink: impl Sink) {
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

#[cfg(test)]
mod tests {
    use std::vec;

    use twins::rng::Rng;

    use super::*;
    use crate::span::ClippedSpan;

    /// Lines in any direction that are as long, as wide and as far to the right as sums may be, and short ones; in windows of fewer rows.
    #[test]
    fn sums_and_steps_agree() {
        let mut rng = Rng::new(532);
        let mut summed_rows = 0;
        for i in 0..40_000 {
            let size = [300, 5_000, 60_000, 261_000][i % 4];
            let place = |rng: &mut Rng| PointFx::from_bits(rng.int(0, size), rng.int(-500, size.min(65_000)));
            let (a, b) = (place(&mut rng), place(&mut rng));
            let width = u32::try_from(rng.int(0, [300, 3_000, 70_000][i / 4 % 3])).expect("a width");
            let Some(u) = Direction::between(a, b) else { continue };
            let offset = u.right().offset(width);
            let mut corners = [(a, 1), (b, 1), (b, -1), (a, -1)].map(|(v, sign)| {
                let (x, y) = bits(v);
                (x + sign * offset.0, y + sign * offset.1)
            });
            let first = (0..4).min_by_key(|&j| corners[j].1).expect("four");
            corners.rotate_left(first);
            corners.swap(2, 3);
            let window = Rect::new(0, rng.int(-2, 3), 1_023, rng.int(20, 250));
            let rows = (first_centre_from(corners[0].1).max(window.y0), first_centre_from(corners[3].1).min(window.y1));
            let is_inside = corners.iter().all(|&(x, _)| (0..=1_023 << 8).contains(&x));
            if rows.0 >= rows.1 || !is_inside || corners[3].1 - corners[0].1 >= 1 << 16 {
                continue;
            }
            let (mut summed, mut stepped) = (vec![], vec![]);
            by_sums(corners, rows, |s: ClippedSpan| summed.push((s.y(), s.x0(), s.x1())));
            by_steps(corners, rows, window, |s: ClippedSpan| stepped.push((s.y(), s.x0(), s.x1())));
            assert_eq!(summed, stepped, "{corners:?} in {rows:?}");
            summed_rows += summed.len();
        }
        assert!(summed_rows > 500_000, "{summed_rows} rows: too easy");
    }
}
