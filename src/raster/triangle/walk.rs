//! Triangles by edge functions: pixel by pixel, and in blocks.

use core::{
    cmp::Ordering,
    num::Wrapping,
    ops::{Add, AddAssign, BitOr},
};

use crate::{
    geom::{bits, PointFx},
    num::{
        cast::narrow,
        round::{compare_products, difference, first_centre_from},
    },
    span::{Rect, Sink, Span},
};

/// The same spans as [`fill`](super::fill), found by testing every pixel of the clipped bounding box against three edge functions.
///
/// For the side from a to b, `E(x, y) = (b.x - a.x)(y - a.y) - (b.y - a.y)(x - a.x)` is positive on the inner side. From
/// centre to centre it moves by multiples of 256; with the fill rule as a bias of -1 or 0 in the constant,
/// `floor(E / 256)` has the sign of E for ever, and its steps are plain dx and dy: in a box of 2,048 pixels all of it
/// fits 32 bits, beyond that the same loop runs in 64.
#[inline]
pub fn walk(corners: [PointFx; 3], window: Rect, sink: impl Sink) {
    match set_up(corners, window) {
        Some((sides, area, true)) => walk_box(sides.map(EdgeFunction::narrow), area, sink),
        Some((sides, area, false)) => walk_box(sides, area, sink),
        None => {}
    }
}

/// The same spans again, found by a look at blocks of 8 x 8 pixels: one that lies outside of a side as a whole is passed over, one
/// that lies inside of all sides is taken, and only in the others pixels are tested. So a long thin triangle that runs diagonally
/// does not test its bounding box.
///
/// A block lies outside of a side where the edge function is negative even at its best corner, and inside where it is not
/// negative even at its worst one. What is inside of a triangle is convex: so in a row of blocks, those that are not outside
/// follow each other, and so do those inside, and in a row of pixels, all between two pixels inside are inside.
///
/// Source: M. Abrash, "Rasterization on Larrabee", Dr. Dobb's Journal, 2009 (blocks that are trivially accepted or rejected).
#[inline]
pub fn walk_blocks(corners: [PointFx; 3], window: Rect, sink: impl Sink) {
    match set_up(corners, window) {
        Some((sides, area, true)) => block_rows(sides.map(EdgeFunction::narrow), area, sink),
        Some((sides, area, false)) => block_rows(sides, area, sink),
        None => {}
    }
}

/// An edge function that no triangle is too large for.
type WideFunction = EdgeFunction<Wrapping<i64>>;

/// The three edge functions, the pixels to look at, and whether 32 bits are enough. `None` if there is no pixel.
#[inline]
fn set_up(corners: [PointFx; 3], window: Rect) -> Option<([WideFunction; 3], Rect, bool)> {
    let [a, mut b, mut c] = corners.map(bits);
    let products = (difference(b.0, a.0), difference(c.1, a.1), difference(b.1, a.1), difference(c.0, a.0));
    match compare_products((products.0, products.1), (products.2, products.3)) {
        Ordering::Equal => return None,
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
        return None;
    }
    let sides = [EdgeFunction::new(a, b, area), EdgeFunction::new(b, c, area), EdgeFunction::new(c, a, area)];
    Some((sides, area, right.abs_diff(left) | lower.abs_diff(upper) < 1 << 19))
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
fn walk_box<T: Number>(mut sides: [EdgeFunction<T>; 3], area: Rect, mut sink: impl Sink) {
    for y in area.y0..area.y1 {
        #[cfg(test)]
        crate::num::tally::add(crate::num::tally::Work::Step);
        let [mut e0, mut e1, mut e2] = sides.map(|e| e.value);
        let mut inside = |x: &mut i32, wanted: bool| {
            // The sign bit of all three together: negative as soon as one is.
            while *x < area.x1 && ((e0 | e1 | e2) >= T::default()) != wanted {
                e0 += sides[0].right;
                e1 += sides[1].right;
                e2 += sides[2].right;
                #[cfg(test)]
                crate::num::tally::add(crate::num::tally::Work::Step);
                *x = x.wrapping_add(1);
            }
            *x
        };
        let mut x = area.x0;
        let (x0, x1) = (inside(&mut x, true), inside(&mut x, false));
        if let Some(span) = (Span { y, x0, x1 }).clip_columns(area) {
            sink.span(span);
        }
        for side in &mut sides {
            side.value += side.down;
        }
    }
}

/// Pixels of a block, each way.
const BLOCK: i32 = 8;

/// What is to be known of a number to walk with it.
trait Number: Copy + Default + PartialOrd + Add<Output = Self> + AddAssign + BitOr<Output = Self> {
    /// So many times as much.
    fn times(self, n: i32) -> Self;
}

impl Number for Wrapping<i32> {
    #[inline(always)]
    fn times(self, n: i32) -> Self {
        self * Self(n)
    }
}

impl Number for Wrapping<i64> {
    #[inline(always)]
    fn times(self, n: i32) -> Self {
        self * Self(n.into())
    }
}

/// How a block lies to the triangle.
#[derive(Copy, Clone, PartialEq, Eq)]
enum Look {
    Outside,
    Crossed,
    Inside,
}

/// A block of so many pixels each way, whose first pixel the edge functions are at.
#[inline]
fn look<T: Number>(sides: &[EdgeFunction<T>; 3], columns: i32, rows: i32) -> Look {
    let mut look = Look::Inside;
    for side in sides {
        let (right, down) = (side.right.times(columns.wrapping_sub(1)), side.down.times(rows.wrapping_sub(1)));
        let positive = |n: T| if n > T::default() { n } else { T::default() };
        let negative = |n: T| if n < T::default() { n } else { T::default() };
        if side.value + positive(right) + positive(down) < T::default() {
            return Look::Outside;
        }
        if side.value + negative(right) + negative(down) < T::default() {
            look = Look::Crossed;
        }
    }
    look
}

/// Rows of blocks, from the top down.
fn block_rows<T: Number>(mut sides: [EdgeFunction<T>; 3], area: Rect, mut sink: impl Sink) {
    let mut y = area.y0;
    while y < area.y1 {
        let rows = BLOCK.min(area.y1.wrapping_sub(y));
        // The first column of the first block that is not outside, and the columns of the blocks inside.
        let (mut first, mut inside, mut at) = (None, (area.x1, area.x1), sides);
        let mut x = area.x0;
        while x < area.x1 {
            let columns = BLOCK.min(area.x1.wrapping_sub(x));
            match (look(&at, columns, rows), first) {
                (Look::Outside, Some(_)) => break,
                (Look::Outside, None) => {}
                (found, _) => {
                    first = first.or(Some((x, at)));
                    if found == Look::Inside {
                        let begin = if inside.0 == area.x1 { x } else { inside.0 };
                        inside = (begin, x.wrapping_add(columns));
                    }
                }
            }
            for side in &mut at {
                side.value += side.right.times(columns);
            }
            x = x.wrapping_add(columns);
        }
        if let Some((first, mut at)) = first {
            // Up to here: what follows is outside.
            let end = x;
            for down in 0..rows {
                row(at, (first, end), inside, y.wrapping_add(down), &mut sink);
                for side in &mut at {
                    side.value += side.down;
                }
            }
        }
        for side in &mut sides {
            side.value += side.down.times(rows);
        }
        y = y.wrapping_add(rows);
    }
}

/// One row of a row of blocks: pixels are tested in the columns `x..end`, but for those that are known to be inside.
#[inline]
fn row<T: Number>(
    sides: [EdgeFunction<T>; 3],
    (mut x, end): (i32, i32),
    inside: (i32, i32),
    y: i32,
    sink: &mut impl Sink,
) {
    let (mut values, right) = (sides.map(|e| e.value), sides.map(|e| e.right));
    test(&mut values, right, &mut x, end, true);
    let x0 = x;
    if x <= inside.0 && inside.0 < inside.1 {
        let n = inside.1.wrapping_sub(x);
        for (value, right) in values.iter_mut().zip(right) {
            *value += right.times(n);
        }
        x = inside.1;
    }
    test(&mut values, right, &mut x, end, false);
    if let Some(span) = (Span { y, x0, x1: x }).known_inside() {
        sink.span(span);
    }
}

/// Goes on until a pixel is inside, if that is wanted, or until one is outside.
#[inline(always)]
fn test<T: Number>(values: &mut [T; 3], [a, b, c]: [T; 3], x: &mut i32, end: i32, wanted: bool) {
    let [mut e0, mut e1, mut e2] = *values;
    while *x < end && ((e0 | e1 | e2) >= T::default()) != wanted {
        (e0, e1, e2) = (e0 + a, e1 + b, e2 + c);
        *x = x.wrapping_add(1);
    }
    *values = [e0, e1, e2];
}
