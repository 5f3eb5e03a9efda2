//! Triangles by edge functions, pixel by pixel.

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
        walk_box(sides.map(EdgeFunction::narrow), area, sink);
    } else {
        walk_box(sides, area, sink);
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
fn walk_box<T>(mut sides: [EdgeFunction<T>; 3], area: Rect, mut sink: impl Sink)
where
    T: Copy + Default + PartialOrd + Add<Output = T> + AddAssign + BitOr<Output = T>,
{
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
