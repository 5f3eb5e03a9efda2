//! Segments cut at the sides of a rectangle.
//!
//! A place on the segment from `a` to `b` is `a + t (b - a)`, for t from 0 to 1. On the way from a to b the segment
//! passes two sides of the rectangle inwards, one of them vertical and one horizontal, and the opposite two outwards.
//! It is inside from the larger t of the inward ones to the smaller t of the outward ones; if the larger comes after
//! the smaller, no place of it is inside. Every t is a fraction of whole numbers, and they are compared exactly.
//! ```text
//!            |      | b          t = (x0 - ax) / (bx - ax) on the left side; likewise on the others
//!       y0 --+------o--
//!            |   /  |            the place on the border has the exact coordinate of the side, x0 here,
//!            o      |            and the other one rounded to the nearest unit: at most 1/512 pixel off, never outside
//!         /  |      |
//!       a   x0      x1
//! ```
//! To *draw* a line in a window, do not clip it here first: a line between rounded ends may have other pixels.
//! [`line::clip`](crate::raster::line::clip) keeps every pixel where it was.
//!
//! Range: any `I24F8`. A fraction has two 32-bit numbers, and their products have 64 bits. Each end that is moved takes
//! one long division for each coordinate.
//!
//! Source: Y.-D. Liang and B. A. Barsky, "A new concept and method for line clipping", ACM Transactions on Graphics 3,
//! 1984.

use core::num::NonZeroU32;

use super::point::{bits, PointFx};
use crate::num::round::div_rem_wide;

/// How far along a segment a place lies: `number / of`, from 0 to 1.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Fraction {
    /// The numerator, at most `of`.
    pub number: u32,
    /// The denominator.
    pub of: NonZeroU32,
}

impl Fraction {
    const ZERO: Self = Self { number: 0, of: NonZeroU32::MIN };
    const ONE: Self = Self { number: 1, of: NonZeroU32::MIN };

    /// Compared exactly.
    fn is_more_than(self, other: Self) -> bool {
        let product = |a: u32, b: NonZeroU32| u64::from(a) * u64::from(b.get());
        product(self.number, other.of) > product(other.number, self.of)
    }
}

/// The part of a segment that lies in a rectangle.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Clipped {
    /// Its ends, in the direction of the segment, rounded to the nearest unit and never outside.
    pub ends: [PointFx; 2],
    /// Where they are on the segment, exactly.
    pub at: [Fraction; 2],
}

/// The part of the segment from `a` to `b` that lies in the rectangle between two opposite corners, its sides included;
/// `None` if it has no place in common with it.
///
/// Coordinates halfway between two units are rounded to the larger one, so `b` to `a` gives the same ends, exchanged.
/// An end of the segment that lies inside stays as it is.
/// ```
/// use embedded_raster::{geom::clip, PointFx};
/// let corners = [PointFx::px(0, 0), PointFx::px(10, 10)];
/// let part = clip::segment(PointFx::px(-5, 2), PointFx::px(10, 5), corners).unwrap();
/// assert_eq!(part.ends, [PointFx::px(0, 3), PointFx::px(10, 5)]);
/// assert_eq!((part.at[0].number, part.at[0].of.get()), (5 * 256, 15 * 256));
/// assert_eq!(clip::segment(PointFx::px(-5, 4), PointFx::px(4, -5), corners), None);
/// let touch = clip::segment(PointFx::px(-5, 5), PointFx::px(5, -5), corners).unwrap();
/// assert_eq!(touch.ends, [PointFx::px(0, 0); 2]);
/// ```
pub fn segment(a: PointFx, b: PointFx, corners: [PointFx; 2]) -> Option<Clipped> {
    let ((ax, ay), (bx, by)) = (bits(a), bits(b));
    let [(px, py), (qx, qy)] = corners.map(bits);
    let (mut from, mut to) = (Fraction::ZERO, Fraction::ONE);
    for (a, b, low, high) in [(ax, bx, px.min(qx), px.max(qx)), (ay, by, py.min(qy), py.max(qy))] {
        let (enter, leave) = if a <= b { (low, high) } else { (high, low) };
        let backwards = a > b;
        // The whole segment lies before the one side, or beyond the other.
        if is_before(b, enter, backwards) || is_before(leave, a, backwards) {
            return None;
        }
        if is_before(a, enter, backwards) {
            from = fraction(a, b, enter).filter(|t| t.is_more_than(from)).unwrap_or(from);
        }
        if is_before(leave, b, backwards) {
            to = fraction(a, b, leave).filter(|&t| to.is_more_than(t)).unwrap_or(to);
        }
    }
    let at = [from, to];
    let place = |t| PointFx::from_bits(along(ax, bx, t), along(ay, by, t));
    (!from.is_more_than(to)).then(|| Clipped { ends: at.map(place), at })
}

/// Whether a segment passes `p` before `q`: its coordinate grows, or it goes backwards and the coordinate shrinks.
fn is_before(p: i32, q: i32, backwards: bool) -> bool {
    if backwards {
        p > q
    } else {
        p < q
    }
}

/// Where a segment from `a` to `b` passes `side`, which lies between them.
fn fraction(a: i32, b: i32, side: i32) -> Option<Fraction> {
    Some(Fraction { number: side.abs_diff(a), of: NonZeroU32::new(b.abs_diff(a))? })
}

/// Where a segment that goes from `from.0` to `from.1` on one axis, and from `to.0` to `to.1` on the other, passes `v`
/// of the first axis, which lies between its ends: the place on the other axis, rounded to nearest, halves up.
pub(super) fn place_between(from: (i32, i32), to: (i32, i32), v: i32) -> i32 {
    fraction(from.0, from.1, v).map_or(to.0, |t| along(to.0, to.1, t))
}

/// `a + t (b - a)`, rounded to nearest, halves up.
fn along(a: i32, b: i32, t: Fraction) -> i32 {
    let (whole, rest) = div_rem_wide(u64::from(b.abs_diff(a)) * u64::from(t.number), t.of);
    // Halves are rounded to the larger coordinate: away from a if the segment goes forwards, towards a if it goes
    // backwards.
    let left = t.of.get().wrapping_sub(rest);
    if a <= b {
        a.wrapping_add_unsigned(whole.wrapping_add(u32::from(rest >= left)))
    } else {
        a.wrapping_sub_unsigned(whole.wrapping_add(u32::from(rest > left)))
    }
}
