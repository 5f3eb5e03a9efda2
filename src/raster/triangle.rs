//! Filled triangles: three vertices in, at most one span a row out.
//!
//! A pixel is drawn when its *centre* lies inside. A centre exactly on an edge counts for left and top edges only (the
//! top-left rule), so two triangles that share an edge draw every pixel along it once: no gap, no overlap.
//! ```text
//!           a            row y is crossed at y + 1/2, where a.y <= y + 1/2 < b.y
//!         /   \
//!    ---/-.-.-.-\---     x0 = first centre at or right of the left edge
//!     /           \      x1 = first centre at or right of the right edge
//!    b-------------c     drawn: x0 <= x < x1, the same rounding on both sides
//! ```
//! There are two ways to the same pixels. [`fill`] solves each row for its two ends, the crossings of
//! [`EdgeSlot`](super::EdgeSlot): what flat fills use. [`walk`] steps the three edge functions over the bounding box: what values
//! that change across the triangle build on.
//!
//! The *long* side from the top corner to the bottom one faces two short ones. Which of two sides is the left one need not be
//! computed. Crossings are rounded the same way on both, and rounding keeps the order: on every row the left one is not
//! beyond the right one. So of two unequal crossings the lesser is the left side's, on all rows of the triangle; and between
//! equal ones lies no pixel.
//!
//! Crossings are found as the chip and the size ask for: by sums of fixed-point numbers where that is exact (the proof is
//! there), or by quotient and remainder. Built for size, a firmware has the second way only.
//!
//! Sources: "Rasterization Rules", Direct3D 11 documentation; J. Pineda, "A Parallel Algorithm for Polygon
//! Rasterization", SIGGRAPH 1988 (edge functions).

use core::{
    cmp::Ordering,
    hint::black_box,
    num::Wrapping,
    ops::{Add, AddAssign, BitOr},
};

use super::edge::{Slope, Sum};
use crate::{
    geom::{bits, PointFx},
    num::{
        cast::{narrow, unsigned},
        round::{compare_products, difference, first_centre_from},
    },
    rect::Rect,
    span::{ClippedSpan, Span},
    target::{COMPACT, DIVIDES},
};

/// Emits the spans of a filled triangle that lie in `window`, top row first.
///
/// * `corners`: in either winding, any coordinates.
/// * `emit`: called once per row that has a pixel.
///
/// Cannot fail. A triangle without area emits nothing.
/// ```
/// use embedded_raster::{raster::triangle, Rect, PointFx};
/// let mut widths = vec![];
/// let corners = [PointFx::px(0, 0), PointFx::px(4, 0), PointFx::px(0, 4)];
/// triangle::fill(corners, Rect::new(0, 0, 64, 48), |s| widths.push(s.len()));
/// assert_eq!(widths, [3, 2, 1]); // centres on the slope, a right edge, are out
/// ```
#[inline]
pub fn fill(corners: [PointFx; 3], window: Rect, emit: impl FnMut(ClippedSpan)) {
    fill_to(corners, window, &mut { emit });
}

/// Receives spans. Unlike a closure it can be inlined in two places.
pub(crate) trait Sink {
    /// What a closure does when it is called.
    fn emit(&mut self, span: ClippedSpan);
}

impl<F: FnMut(ClippedSpan)> Sink for F {
    #[inline(always)]
    fn emit(&mut self, span: ClippedSpan) {
        self(span);
    }
}

/// [`fill`] into a sink.
#[inline(always)]
pub(crate) fn fill_to(corners: [PointFx; 3], window: Rect, sink: &mut impl Sink) {
    let corners = sorted(corners.map(bits));
    if DIVIDES && !COMPACT {
        fill_by_sums(corners, window, sink);
    } else {
        fill_by_steps(corners, window, sink);
    }
}

/// The commonest triangles by additions ([`Sum`]): less than 256 pixels high, and no column of them outside the window.
#[inline(always)]
fn fill_by_sums([a, b, c]: [(i32, i32); 3], window: Rect, sink: &mut impl Sink) {
    let (y0, y1) = (first_centre_from(a.1).max(window.y0), first_centre_from(c.1).min(window.y1));
    if y0 >= y1 {
        return;
    }
    let (first, width) = (unsigned(window.x0) << 8, unsigned(window.x1.wrapping_sub(window.x0)) << 8);
    let is_inside = |x: i32| unsigned(x).wrapping_sub(first) <= width;
    let in_range = window.x0 >= 0 && window.x0 < window.x1 && window.x1 < Sum::COLUMNS;
    if !in_range || !is_inside(a.0) || !is_inside(b.0) || !is_inside(c.0) {
        return fill_apart(a, b, c, window, sink);
    }
    let height = unsigned(c.1.wrapping_sub(a.1));
    let widths = c.0.abs_diff(a.0).wrapping_add(b.0.abs_diff(a.0));
    let tiny = height.checked_add(widths).is_some_and(|sum| sum < Sum::TINY);
    let turn = first_centre_from(b.1).min(y1);
    let (mut long, mut short, mut end);
    if tiny {
        long = tiny_side(a, c, y0);
        (short, end) = if y0 < turn { (tiny_side(a, b, y0), turn) } else { (tiny_side(b, c, y0), y1) };
    } else if height < 1 << 16 {
        (long, short, end) = block(a, b, c, y0, y1);
    } else {
        return fill_apart(a, b, c, window, sink);
    }
    let mut long_is_left = true;
    let mut y = y0;
    loop {
        let (mut left, mut right) = if long_is_left { (long, short) } else { (short, long) };
        while y < end {
            let (x0, x1) = (left.x(), right.x());
            if let Some(span) = (Span { y, x0, x1 }).known_inside() {
                sink.emit(span);
            } else if x0 > x1 {
                // The sides are the other way round, and all rows were empty so far.
                (left, right) = (right, left);
                long_is_left = !long_is_left;
                continue;
            } else {
                // A row number that is not simply counted keeps the compiler from counting addresses beside it: there
                // are not enough registers.
                y = black_box(y);
            }
            left.step();
            right.step();
            y = y.wrapping_add(1);
        }
        if y >= y1 {
            return;
        }
        if tiny {
            long = if long_is_left { left } else { right };
            (short, end) = (tiny_side(b, c, y), y1);
        } else {
            (long, short, end) = block(a, b, c, y, y1);
        }
    }
}

/// A side of a tiny triangle from row y on; nothing if it is horizontal, as it crosses no row then.
#[inline(always)]
fn tiny_side(upper: (i32, i32), lower: (i32, i32), y: i32) -> Sum {
    Slope::new(upper, lower).map_or(Sum::default(), |side| Sum::tiny(side, y))
}

/// The long and the short side from row y on, and the row after the last one before y1 that they are good for.
#[inline(never)]
fn block(a: (i32, i32), b: (i32, i32), c: (i32, i32), y: i32, y1: i32) -> (Sum, Sum, i32) {
    let turn = first_centre_from(b.1);
    let (upper, lower, end) = if y < turn { (a, b, turn.min(y1)) } else { (b, c, y1) };
    match (Slope::new(a, c), Slope::new(upper, lower)) {
        (Some(long), Some(short)) => {
            (Sum::new(long, y), Sum::new(short, y), end.min(y.saturating_add(Sum::reach(long.dy))))
        }
        _ => (Sum::default(), Sum::default(), y1),
    }
}

/// [`fill_by_steps`] in a function of its own, with registers of its own.
#[inline(never)]
fn fill_apart(a: (i32, i32), b: (i32, i32), c: (i32, i32), window: Rect, sink: &mut impl Sink) {
    fill_by_steps([a, b, c], window, sink);
}

/// Triangles of any size, in two blocks of rows: above and below the middle corner.
#[inline(always)]
fn fill_by_steps([a, b, c]: [(i32, i32); 3], window: Rect, sink: &mut impl Sink) {
    let (y0, y1) = (first_centre_from(a.1).max(window.y0), first_centre_from(c.1).min(window.y1));
    if y0 >= y1 {
        return;
    }
    let turn = first_centre_from(b.1).min(y1);
    let start = |upper, lower, (y, end): (i32, i32)| {
        Slope::new(upper, lower).map(|side| side.stepper_at(y, end.wrapping_sub(y)))
    };
    let Some(mut long) = start(a, c, (y0, y1)) else { return };
    let mut y = y0;
    while y < y1 {
        let (upper, lower, end) = if y < turn { (a, b, turn) } else { (b, c, y1) };
        let Some(mut short) = start(upper, lower, (y, end)) else { return };
        while y < end {
            let (x0, x1) = (long.value.min(short.value), long.value.max(short.value));
            if let Some(span) = (Span { y, x0, x1 }).clip_columns(window) {
                sink.emit(span);
            }
            long.step();
            short.step();
            y = y.wrapping_add(1);
        }
    }
}

/// By y, with three compare-exchanges.
#[inline(always)]
fn sorted([mut a, mut b, mut c]: [(i32, i32); 3]) -> [(i32, i32); 3] {
    if b.1 < a.1 {
        (a, b) = (b, a);
    }
    if c.1 < b.1 {
        (b, c) = (c, b);
        if b.1 < a.1 {
            (a, b) = (b, a);
        }
    }
    [a, b, c]
}

/// The same spans as [`fill`], found by testing every pixel of the clipped bounding box against three edge functions.
///
/// For the side from a to b, `E(x, y) = (b.x - a.x)(y - a.y) - (b.y - a.y)(x - a.x)` is positive on the inner side. From
/// centre to centre it moves by multiples of 256; with the fill rule as a bias of -1 or 0 in the constant,
/// `floor(E / 256)` has the sign of E for ever, and its steps are plain dx and dy: in a box of 2,048 pixels all of it
/// fits 32 bits, beyond that the same loop runs in 64.
#[inline]
pub fn walk(corners: [PointFx; 3], window: Rect, emit: impl FnMut(ClippedSpan)) {
    let [a, mut b, mut c] = corners.map(bits);
    let products = (difference(b.0, a.0), difference(c.1, a.1), difference(b.1, a.1), difference(c.0, a.0));
    match compare_products((products.0, products.1), (products.2, products.3)) {
        Ordering::Equal => return,
        Ordering::Less => (b, c) = (c, b),
        Ordering::Greater => {}
    }
    let (left, right) = (a.0.min(b.0).min(c.0), a.0.max(b.0).max(c.0));
    let (upper, lower) = (a.1.min(b.1).min(c.1), a.1.max(b.1).max(c.1));
    let area = Rect {
        x0: first_centre_from(left),
        y0: first_centre_from(upper),
        x1: first_centre_from(right),
        y1: first_centre_from(lower),
    }
    .intersection(window);
    if area.is_empty() {
        return;
    }
    let sides = [EdgeFunction::new(a, b, area), EdgeFunction::new(b, c, area), EdgeFunction::new(c, a, area)];
    if right.abs_diff(left) | lower.abs_diff(upper) < 1 << 19 {
        walk_box(sides.map(EdgeFunction::narrow), area, emit);
    } else {
        walk_box(sides, area, emit);
    }
}

/// `floor((E - bias) / 256)` at a pixel centre, and what it gains to the right and downwards.
#[derive(Copy, Clone)]
struct EdgeFunction<T> {
    value: T,
    right: T,
    down: T,
}

impl EdgeFunction<Wrapping<i64>> {
    /// At the first pixel of `area`. All terms are below 2^58: pixel distances below 2^25 times sides below 2^32.
    #[inline]
    fn new(a: (i32, i32), b: (i32, i32), area: Rect) -> Self {
        let (dx, dy) = (difference(b.0, a.0), difference(b.1, a.1));
        let (x, y) = (centre_minus(area.x0, a.0), centre_minus(area.y0, a.1));
        // Of the centres on the side itself, those that step inside by (+e, +e^2) belong to the triangle.
        let bias = i64::from(!(dy < 0 || dy == 0 && dx > 0));
        let whole = dx.wrapping_mul(y >> 8).wrapping_sub(dy.wrapping_mul(x >> 8));
        let rest = dx.wrapping_mul(y & 255).wrapping_sub(dy.wrapping_mul(x & 255)).wrapping_sub(bias) >> 8;
        Self { value: Wrapping(whole.wrapping_add(rest)), right: Wrapping(dy.wrapping_neg()), down: Wrapping(dx) }
    }

    fn narrow(self) -> EdgeFunction<Wrapping<i32>> {
        let cut = |n: Wrapping<i64>| Wrapping(narrow(n.0));
        EdgeFunction { value: cut(self.value), right: cut(self.right), down: cut(self.down) }
    }
}

/// From a 24.8 coordinate to the centre of a pixel.
fn centre_minus(pixel: i32, from: i32) -> i64 {
    (i64::from(pixel) * 256 + 128).wrapping_sub(i64::from(from))
}

#[inline]
fn walk_box<T>(mut sides: [EdgeFunction<T>; 3], area: Rect, mut emit: impl FnMut(ClippedSpan))
where
    T: Copy + Default + PartialOrd + Add<Output = T> + AddAssign + BitOr<Output = T>,
{
    for y in area.y0..area.y1 {
        let [mut e0, mut e1, mut e2] = sides.map(|e| e.value);
        let mut inside = |x: &mut i32, wanted: bool| {
            // The sign of the three together: negative as soon as one is.
            while *x < area.x1 && ((e0 | e1 | e2) >= T::default()) != wanted {
                e0 += sides[0].right;
                e1 += sides[1].right;
                e2 += sides[2].right;
                *x = x.wrapping_add(1);
            }
            *x
        };
        let mut x = area.x0;
        let (x0, x1) = (inside(&mut x, true), inside(&mut x, false));
        if let Some(span) = (Span { y, x0, x1 }).clip_columns(area) {
            emit(span);
        }
        for side in &mut sides {
            side.value += side.down;
        }
    }
}

#[cfg(test)]
#[allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap, reason = "tests cut numbers on purpose")]
mod tests {
    use super::*;
    use std::{vec, vec::Vec};

    fn both(corners: [(i32, i32); 3], window: Rect) -> [Vec<(i32, i32, i32)>; 2] {
        let vertices = corners.map(|(x, y)| PointFx::from_bits(x, y));
        let mut spans = [vec![], vec![], vec![]];
        fill_by_steps(sorted(corners), window, &mut |s: ClippedSpan| spans[0].push((s.y(), s.x0(), s.x1())));
        walk(vertices, window, |s| spans[1].push((s.y(), s.x0(), s.x1())));
        fill_by_sums(sorted(corners), window, &mut |s: ClippedSpan| spans[2].push((s.y(), s.x0(), s.x1())));
        let [solved, walked, summed] = spans;
        assert_eq!(solved, summed, "steps, sums: {corners:?}");
        [solved, walked]
    }

    #[test]
    fn corners_on_centres() {
        let [solved, walked] = both([(128, 128), (1152, 128), (128, 1152)], Rect::new(0, 0, 8, 8));
        assert_eq!(solved, [(0, 0, 4), (1, 0, 3), (2, 0, 2), (3, 0, 1)]);
        assert_eq!(walked, solved);
    }

    #[test]
    fn random_triangles_agree_in_every_way() {
        let mut state = 1_u64;
        let mut random = |bits: u32| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((state >> 32) as u32 as i32) >> (32 - bits)
        };
        for i in 0..200_000 {
            let bits = [10, 12, 14, 16, 17, 20, 25, 32][i % 8];
            let corners = [(); 3].map(|()| (random(bits), random(bits)));
            let (x, y) = ((random(bits) >> 8).max(-1 << 22), random(bits) >> 8);
            let [solved, walked] = both(corners, Rect::new(x - 20, y - 20, x + 20, y + 20));
            assert_eq!(walked, solved, "{corners:?}");
        }
    }

    #[test]
    fn sums_agree_up_to_their_limits() {
        let mut state = 7_u64;
        let mut random = |below: i32| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (((state >> 33) * u64::from(below.unsigned_abs())) >> 31) as i32
        };
        for i in 0..60_000 {
            let columns = [320, 1023, 64, 1024][i % 4];
            let (width, height) = (random(columns * 256) + 1, random([13, 54, 257, 400][i / 4 % 4] * 256) + 1);
            let (left, top) = (random(columns * 256 - width + 1), random(40 * 256) - 20 * 256);
            // Two of three corners on corners of the box, or on the lines through them: the longest and steepest sides.
            let mut corner = |j: i32| {
                let (x, y) = (random(width + 1), random(height + 1));
                (
                    left + if random(3) == 0 { j % 2 * width } else { x },
                    top + if random(3) == 0 { j / 2 * height } else { y },
                )
            };
            let corners = sorted([corner(0), corner(3), corner(i as i32 % 4)]);
            let window = Rect::new(0, random(8), columns, 230);
            let (mut summed, mut stepped) = (vec![], vec![]);
            fill_by_sums(corners, window, &mut |s: ClippedSpan| summed.push((s.y(), s.x0(), s.x1())));
            fill_by_steps(corners, window, &mut |s: ClippedSpan| stepped.push((s.y(), s.x0(), s.x1())));
            assert_eq!(summed, stepped, "{corners:?} in {window:?}");
        }
    }

    #[test]
    fn ends_of_the_type() {
        let (low, high) = (i32::MIN, i32::MAX);
        let [solved, walked] = both([(low, low), (high, low), (low, high)], Rect::new(-3, -2, 4, 2));
        assert_eq!(solved, [(-2, -3, 1), (-1, -3, 0), (0, -3, -1), (1, -3, -2)]);
        assert_eq!(walked, solved);
    }
}
