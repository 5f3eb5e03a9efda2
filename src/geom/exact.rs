//! Two questions that algorithms of plane geometry are made of, answered exactly: which way a path turns, and whether a
//! place lies in the circle through three others.
//!
//! Both are signs of determinants of differences, which have up to 32 bits and a sign:
//! ```text
//!                                                  | ax-dx  ay-dy  A |
//!     turn = (b - a) x (c - a)         in_circle = | bx-dx  by-dy  B |     A = (ax-dx)^2 + (ay-dy)^2, ...
//!                                                  | cx-dx  cy-dy  C |
//! ```
//! A product of two differences stays below 2^64, so `turn` compares magnitudes of 64 bits; when the differences fit
//! `i32`, two multiplications do. In `in_circle` a minor has up to 65 bits and a sum of squares 65, so the determinant
//! has up to 132: the sums of squares are cut into a high part and 32 low bits, and each part times the minors fits
//! `i128`.
//!
//! Range: any `I24F8`. Nothing is divided or rounded, so there is no tolerance: `Equal` means exactly equal.
//!
//! Source: L. Guibas and J. Stolfi, "Primitives for the manipulation of general subdivisions and the computation of
//! Voronoi diagrams", ACM Transactions on Graphics 4, 1985 (the predicates CCW and InCircle).

use core::cmp::Ordering;

use super::point::{bits, PointFx};
use crate::num::{
    cast::narrow,
    round::{compare_products, difference},
};

/// A place in 24.8 units.
pub(crate) type Place = (i32, i32);

/// Which way the path from `a` over `b` to `c` turns: `Greater` when clockwise as seen on the screen, where y points
/// down; `Less` when the other way; `Equal` when the three lie on a line or two of them are one.
/// ```
/// use core::cmp::Ordering;
/// use embedded_raster::{geom::exact::turn, PointFx};
/// let [a, b, c] = [(0, 0), (10, 0), (10, 1)].map(|(x, y)| PointFx::px(x, y));
/// assert_eq!(turn(a, b, c), Ordering::Greater);
/// assert_eq!(turn(c, b, a), Ordering::Less);
/// assert_eq!(turn(a, b, PointFx::px(-3, 0)), Ordering::Equal);
/// ```
#[inline]
pub fn turn(a: PointFx, b: PointFx, c: PointFx) -> Ordering {
    turn_at(bits(a), bits(b), bits(c))
}

/// [`turn`] in units. It is never inlined: a triangulation calls it from twenty places.
#[inline(never)]
pub(crate) fn turn_at(a: Place, b: Place, c: Place) -> Ordering {
    let (bx, by) = (difference(b.0, a.0), difference(b.1, a.1));
    let (cx, cy) = (difference(c.0, a.0), difference(c.1, a.1));
    cross_sign((bx, by), (cx, cy))
}

/// The sign of the cross product of two differences of places: `Greater` when the second lies clockwise of the first.
#[inline]
pub(crate) fn cross_sign(a: (i64, i64), b: (i64, i64)) -> Ordering {
    let small = |n: i64| i64::from(narrow(n)) == n;
    if small(a.0) && small(a.1) && small(b.0) && small(b.1) {
        let product = |a: i64, b: i64| i64::from(narrow(a)).wrapping_mul(i64::from(narrow(b)));
        return product(a.0, b.1).cmp(&product(a.1, b.0));
    }
    compare_products((a.0, b.1), (a.1, b.0))
}

/// Where `d` lies to the circle through `a`, `b` and `c`, which turn clockwise: `Greater` when inside, `Less` when
/// outside, `Equal` when on it. If the three turn the other way, `Greater` and `Less` change places. If they lie on a
/// line, the answer is one of the two for one side of that line, and the other for the other side.
/// ```
/// use core::cmp::Ordering;
/// use embedded_raster::{geom::exact::in_circle, PointFx};
/// let [a, b, c, d] = [(0, 0), (4, 0), (4, 4), (0, 4)].map(|(x, y)| PointFx::px(x, y));
/// assert_eq!(in_circle(a, b, c, d), Ordering::Equal);
/// assert_eq!(in_circle(a, b, c, PointFx::from_bits(1, 4 * 256)), Ordering::Greater);
/// assert_eq!(in_circle(a, b, c, PointFx::from_bits(-1, 4 * 256)), Ordering::Less);
/// ```
pub fn in_circle(a: PointFx, b: PointFx, c: PointFx, d: PointFx) -> Ordering {
    let from = |v: PointFx| {
        let (v, d) = (bits(v), bits(d));
        (i128::from(difference(v.0, d.0)), i128::from(difference(v.1, d.1)))
    };
    let (a, b, c) = (from(a), from(b), from(c));
    let square = |(x, y): (i128, i128)| x.wrapping_mul(x).wrapping_add(y.wrapping_mul(y));
    let minor = |(ax, ay): (i128, i128), (bx, by): (i128, i128)| ax.wrapping_mul(by).wrapping_sub(ay.wrapping_mul(bx));
    let mut sums = (0_i128, 0_i128);
    for (p, minor) in [(a, minor(b, c)), (b, minor(c, a)), (c, minor(a, b))] {
        let square = square(p);
        sums.0 = sums.0.wrapping_add((square >> 32).wrapping_mul(minor));
        sums.1 = sums.1.wrapping_add((square & LOW).wrapping_mul(minor));
    }
    // The determinant is 2^32 high + low, with 0 <= low < 2^32.
    let (high, low) = (sums.0.wrapping_add(sums.1 >> 32), sums.1 & LOW);
    high.cmp(&0).then(low.cmp(&0))
}

/// The 32 low bits of a sum of squares.
const LOW: i128 = 0xffff_ffff;
