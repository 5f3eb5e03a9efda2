//! Triangles in `f32`: pixel by pixel with barycentric coordinates, and row by row along the sides.
//!
//! Sources: J. Pineda, "A Parallel Algorithm for Polygon Rasterization", 1988 (the test of a pixel); H. Gouraud, "Continuous
//! Shading of Curved Surfaces", 1971 (rows).

use crate::{sorted, Size, Span};

/// The least whole number that is not below.
#[inline(always)]
fn ceil(x: f32) -> i32 {
    let cut = x as i32;
    cut + i32::from(x > cut as f32)
}

/// Calls `pixel` with each pixel of a triangle, in reading order, and the values there: all centres of its box are tested.
#[inline(always)]
pub fn barycentric<const N: usize>(
    [a, b, c]: [[f32; 2]; 3],
    values: [[f32; N]; 3],
    size: Size,
    mut pixel: impl FnMut(usize, [f32; N]),
) {
    let cross =
        |[ax, ay]: [f32; 2], [bx, by]: [f32; 2], [px, py]: [f32; 2]| (bx - ax) * (py - ay) - (by - ay) * (px - ax);
    let area = cross(a, b, c);
    if area == 0.0 {
        return;
    }
    let part = 1.0 / area;
    let box_of = |i: usize, most: i32| {
        let (low, high) = (a[i].min(b[i]).min(c[i]), a[i].max(b[i]).max(c[i]));
        (ceil(low - 0.5).max(0), ceil(high - 0.5).min(most))
    };
    let ((left, right), (top, bottom)) = (box_of(0, size.width), box_of(1, size.height));
    for y in top..bottom {
        for x in left..right {
            let p = [x as f32 + 0.5, y as f32 + 0.5];
            let (u, v) = (cross(b, c, p) * part, cross(c, a, p) * part);
            let w = 1.0 - u - v;
            if u >= 0.0 && v >= 0.0 && w >= 0.0 {
                let at = core::array::from_fn(|i| u * values[0][i] + v * values[1][i] + w * values[2][i]);
                pixel((y * size.width + x) as usize, at);
            }
        }
    }
}

/// A side from row to row: where it is, and the values there.
struct Side<const N: usize> {
    x: f32,
    x_by: f32,
    at: [f32; N],
    by: [f32; N],
}

impl<const N: usize> Side<N> {
    #[inline]
    fn new((a, u): ([f32; 2], [f32; N]), (b, v): ([f32; 2], [f32; N]), y: i32) -> Self {
        let part = 1.0 / (b[1] - a[1]);
        let (x_by, by) = ((b[0] - a[0]) * part, core::array::from_fn(|i| (v[i] - u[i]) * part));
        let down = y as f32 + 0.5 - a[1];
        Self { x: a[0] + x_by * down, x_by, at: core::array::from_fn(|i| u[i] + by[i] * down), by }
    }

    #[inline(always)]
    fn step(&mut self) {
        self.x += self.x_by;
        self.at.iter_mut().zip(self.by).for_each(|(at, by)| *at += by);
    }
}

/// Calls `span` with each row of a triangle: from sides that go from row to row by additions, as the values on them do. Along a
/// row, values are taken at the centres.
#[inline(always)]
pub fn rows<const N: usize>(
    corners: [[f32; 2]; 3],
    values: [[f32; N]; 3],
    size: Size,
    mut span: impl FnMut(Span<f32, N>),
) {
    let [a, b, c] = sorted(corners, values);
    let first = ceil(a.0[1] - 0.5).max(0);
    if a.0[1] >= c.0[1] {
        return;
    }
    let mut long = Side::new(a, c, first);
    let halves = [(a, b, first), (b, c, ceil(b.0[1] - 0.5).max(0))];
    for (upper, lower, top) in halves {
        let bottom = ceil(lower.0[1] - 0.5).min(size.height);
        if top >= bottom {
            continue;
        }
        let mut short = Side::new(upper, lower, top);
        for y in top..bottom {
            let (left, right) = if long.x < short.x { (&long, &short) } else { (&short, &long) };
            let (x0, x1) = (ceil(left.x - 0.5).max(0), ceil(right.x - 0.5).min(size.width));
            if x0 < x1 {
                let part = 1.0 / (right.x - left.x);
                let by: [f32; N] = core::array::from_fn(|i| (right.at[i] - left.at[i]) * part);
                let along = x0 as f32 + 0.5 - left.x;
                let at = core::array::from_fn(|i| left.at[i] + by[i] * along);
                span(Span { start: (y * size.width + x0) as usize, len: (x1 - x0) as usize, at, by });
            }
            long.step();
            short.step();
        }
    }
}
