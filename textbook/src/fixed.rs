//! Triangles in fixed point, with corners in 1/256 pixel: values along sides and rows, and by the gradients of their plane.
//!
//! Source: C. Hecker, "Perspective Texture Mapping", Game Developer, 1995 (gradients of the plane, and the centres of pixels).

use crate::{sorted, Number, Size, Span};

/// Bits of the fraction of places along x.
const PLACE: u32 = 16;

/// `n / d` with so many bits of fraction.
#[inline]
fn ratio(n: i64, d: i64, bits: u32) -> i64 {
    (n << bits) / d
}

/// The first row, or column, whose centre is not above, or left of, a place in 1/256 pixel.
#[inline(always)]
fn first_centre(at: i32) -> i32 {
    (at + 127) >> 8
}

/// The same of a place with 16 bits of fraction.
#[inline(always)]
fn first_column(x: i32) -> i32 {
    x.wrapping_add(0x7fff) >> PLACE
}

/// A side from row to row: where it is, and the values there.
struct Side<const N: usize> {
    x: i32,
    x_by: i32,
    at: [i32; N],
    by: [i32; N],
}

impl<const N: usize> Side<N> {
    #[inline]
    fn new((a, u): ([i32; 2], [i32; N]), (b, v): ([i32; 2], [i32; N]), y: i32, bits: u32) -> Self {
        let (height, down) = (i64::from(b[1] - a[1]), i64::from(256 * y + 128 - a[1]));
        let x_by = ratio((b[0] - a[0]).into(), height, PLACE);
        let by = core::array::from_fn(|i| ratio(i64::from(v[i] - u[i]) << 8, height, bits) as i32);
        Self {
            x: (a[0] << (PLACE - 8)).wrapping_add(((x_by * down) >> 8) as i32),
            x_by: x_by as i32,
            at: core::array::from_fn(|i| (u[i] << bits).wrapping_add(((i64::from(by[i]) * down) >> 8) as i32)),
            by,
        }
    }

    #[inline(always)]
    fn step(&mut self) {
        self.x = self.x.wrapping_add(self.x_by);
        self.at.iter_mut().zip(self.by).for_each(|(at, by)| *at = at.wrapping_add(by));
    }
}

/// Goes down the sides of a triangle. `row` gets a row, the side on the left and the one on the right.
#[inline(always)]
fn sides<const N: usize>(
    corners: [[i32; 2]; 3],
    values: [[i32; N]; 3],
    bits: u32,
    height: i32,
    mut row: impl FnMut(i32, &Side<N>, &Side<N>),
) {
    let [a, b, c] = sorted(corners, values);
    if a.0[1] >= c.0[1] {
        return;
    }
    let first = first_centre(a.0[1]).max(0);
    let mut long = Side::new(a, c, first, bits);
    for (upper, lower, top) in [(a, b, first), (b, c, first_centre(b.0[1]).max(0))] {
        let bottom = first_centre(lower.0[1]).min(height);
        if top >= bottom {
            continue;
        }
        let mut short = Side::new(upper, lower, top, bits);
        for y in top..bottom {
            if long.x < short.x {
                row(y, &long, &short);
            } else {
                row(y, &short, &long);
            }
            long.step();
            short.step();
        }
    }
}

/// Calls `span` with each row of a triangle: values go down the sides, then along the row, by additions with BITS bits of fraction.
///
/// The value on the left side is taken for that of the first pixel, and what a row gains is divided by its whole pixels: there are
/// divisions of 32 bits in each row. A half is added, for those who cut the fraction off.
#[inline(always)]
pub fn rows<const BITS: u32, const N: usize>(
    corners: [[i32; 2]; 3],
    values: [[i32; N]; 3],
    size: Size,
    mut span: impl FnMut(Span<i32, N>),
) {
    sides(corners, values, BITS, size.height, |y, left, right| {
        let (x0, x1) = (first_column(left.x), first_column(right.x));
        let width = (right.x.wrapping_sub(left.x) >> PLACE).max(1);
        let skipped = (-x0).max(0);
        let (first, last) = (x0.max(0), x1.min(size.width));
        if first < last {
            let by: [i32; N] = core::array::from_fn(|i| right.at[i].wrapping_sub(left.at[i]) / width);
            let half = 1 << (BITS - 1);
            let at = core::array::from_fn(|i| left.at[i].wrapping_add(half).wrapping_add(by[i].wrapping_mul(skipped)));
            span(Span { start: (y * size.width + first) as usize, len: (last - first) as usize, at, by });
        }
    });
}

/// A number of fixed point, from one of 64 bits.
pub trait Fixed: Number {
    /// Its low bits.
    fn from_low(n: i64) -> Self;

    /// Without so many bits of fraction.
    fn whole(self, bits: u32) -> i32;
}

impl Fixed for i32 {
    #[inline(always)]
    fn from_low(n: i64) -> Self {
        n as Self
    }

    #[inline(always)]
    fn whole(self, bits: u32) -> i32 {
        self >> bits
    }
}

impl Fixed for i64 {
    #[inline(always)]
    fn from_low(n: i64) -> Self {
        n
    }

    #[inline(always)]
    fn whole(self, bits: u32) -> i32 {
        (self >> bits) as i32
    }
}

/// Calls `span` with each row of a triangle: what values gain to the right and downwards is the same all over it, and found once,
/// with BITS bits of fraction. Values are taken at the centres. A half is added, for those who cut the fraction off.
#[inline(always)]
pub fn plane<T: Fixed, const BITS: u32, const N: usize>(
    corners: [[i32; 2]; 3],
    values: [[i32; N]; 3],
    size: Size,
    mut span: impl FnMut(Span<T, N>),
) {
    let [a, b, c] = corners;
    let way = |to: [i32; 2]| (i64::from(to[0] - a[0]), i64::from(to[1] - a[1]));
    let ((bx, by), (cx, cy)) = (way(b), way(c));
    let area = bx * cy - by * cx;
    if area == 0 {
        return;
    }
    let gains: [[i64; 2]; N] = core::array::from_fn(|i| {
        let (u, v) = (i64::from(values[1][i] - values[0][i]), i64::from(values[2][i] - values[0][i]));
        [ratio(u * cy - v * by, area, BITS + 8), ratio(v * bx - u * cx, area, BITS + 8)]
    });
    sides(corners, [[]; 3], BITS, size.height, |y, left: &Side<0>, right| {
        let (first, last) = (first_column(left.x).max(0), first_column(right.x).min(size.width));
        if first < last {
            let (along, down) = (i64::from(256 * first + 128 - a[0]), i64::from(256 * y + 128 - a[1]));
            let at = core::array::from_fn(|i| {
                let [x, y] = gains[i];
                let start = (i64::from(values[0][i]) << BITS) + (1 << (BITS - 1));
                let gained = x.wrapping_mul(along).wrapping_add(y.wrapping_mul(down)) >> 8;
                T::from_low(start.wrapping_add(gained))
            });
            let by = gains.map(|[x, _]| T::from_low(x));
            span(Span { start: (y * size.width + first) as usize, len: (last - first) as usize, at, by });
        }
    });
}
