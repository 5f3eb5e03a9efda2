//! What can be asked of a polygon: is it convex, which way round does it go, how large is it, is a place inside, where
//! does a horizontal line cross it?
//!
//! An outline is closed: its last vertex is joined to its first. Vertices that repeat the one before, or lie in the
//! middle of a straight side, never change an answer.
//!
//! Range: any `I24F8`; the answers are exact. Work: a few multiplications a side. Memory: none.
//!
//! **Convex** is an outline whose direction, from side to side, always turns the same way, left or right, and turns by
//! one whole turn in all. A pentagram always turns the same way, too, but by two whole turns. To count them without
//! angles, call a direction *forward* when it points to the right, or straight down, and *backward* otherwise: one
//! whole turn changes between forward and backward exactly twice. Source: the winding of the tangent, as in J.
//! O'Rourke, "Computational Geometry in C", 1998, section 1.4.
//!
//! **Inside** is what [`fill`](crate::raster::polygon::fill) paints, for any place instead of the centres of pixels. A
//! place exactly on a side counts as if it were moved a little to the right, and much less down. Source: the crossings
//! of a ray, M. Shimrat, "Algorithm 112", Communications of the ACM 5, 1962, with the half-open rows of the rasterizer.

use core::{borrow::Borrow, cmp::Ordering, mem::swap};

use fixed::types::I24F8;
use heapless::Vec;

use super::{
    clip::place_between,
    exact::{cross_sign, turn_at, Place},
    fill_rule::FillRule,
    point::{bits, PointFx},
};
use crate::{error::CrossingListFull, num::round::difference};

/// Calls `visit` with each side of a closed contour.
#[inline(always)]
fn sides(contour: impl IntoIterator<Item = impl Borrow<PointFx>>, visit: impl FnMut(Place, Place)) {
    each_side(contour.into_iter().map(|v| bits(*v.borrow())), visit);
}

/// Calls `visit` with the ends of each side of a closed contour, which are whatever its vertices are given as.
#[inline(always)]
pub(crate) fn each_side<T: Copy>(mut vertices: impl Iterator<Item = T>, mut visit: impl FnMut(T, T)) {
    let Some(first) = vertices.next() else { return };
    let mut last = first;
    // One call, which is inlined: at two places it would not be, or be there twice.
    loop {
        let next = vertices.next();
        let vertex = next.unwrap_or(first);
        visit(last, vertex);
        if next.is_none() {
            return;
        }
        last = vertex;
    }
}

/// The lowest and the highest coordinates of some vertices; `None` without a vertex.
#[inline]
pub(crate) fn bounds(vertices: impl Iterator<Item = impl Borrow<PointFx>>) -> Option<(Place, Place)> {
    let mut places = vertices.map(|v| bits(*v.borrow()));
    let first = places.next()?;
    Some(
        places
            .fold((first, first), |(low, high), (x, y)| ((low.0.min(x), low.1.min(y)), (high.0.max(x), high.1.max(y)))),
    )
}

/// Whether an outline goes once round a convex region, in either direction.
///
/// Its sides then cross every row twice at most. An outline without area is convex if it goes along a straight line and
/// back once, or stays at one place. An outline that crosses itself, goes round twice, or has a spike is not convex.
/// ```
/// use embedded_raster::{geom::polygon::is_convex, PointFx};
/// let outline = |places: &[(i32, i32)]| places.iter().map(|&(x, y)| PointFx::px(x, y)).collect::<Vec<_>>();
/// assert!(is_convex(&outline(&[(0, 0), (2, 0), (4, 0), (4, 0), (4, 4), (0, 4)])));
/// assert!(!is_convex(&outline(&[(0, 0), (4, 4), (4, 0), (0, 4)])), "a bow-tie");
/// assert!(!is_convex(&outline(&[(0, -20), (12, 17), (-19, -6), (19, -6), (-12, 17)])), "a pentagram");
/// ```
pub fn is_convex(outline: &[PointFx]) -> bool {
    let mut turns = Turns::default();
    sides(outline, |a, b| turns.add((difference(b.0, a.0), difference(b.1, a.1))));
    // The turn from the last side to the first one.
    if let Some(first) = turns.first {
        turns.add(first);
    }
    !(turns.clockwise && turns.counterclockwise) && turns.reversals <= 2
}

/// The turns from each side to the next, so far.
#[derive(Default)]
struct Turns {
    first: Option<(i64, i64)>,
    last: (i64, i64),
    clockwise: bool,
    counterclockwise: bool,
    /// Changes between forward and backward.
    reversals: u8,
}

impl Turns {
    /// Adds the turn to the next side, given by its direction.
    fn add(&mut self, side: (i64, i64)) {
        if side == (0, 0) {
            return;
        }
        if self.first.is_none() {
            (self.first, self.last) = (Some(side), side);
        }
        let forward = |d: (i64, i64)| d.0 > 0 || d.0 == 0 && d.1 > 0;
        self.reversals = self.reversals.saturating_add(u8::from(forward(side) != forward(self.last)));
        match cross_sign(self.last, side) {
            Ordering::Greater => self.clockwise = true,
            Ordering::Less => self.counterclockwise = true,
            Ordering::Equal => {}
        }
        self.last = side;
    }
}

/// Twice the area of an outline, in units of 1/65,536 of a pixel: positive if it goes clockwise as seen on the screen,
/// negative if it goes the other way.
///
/// Regions that the outline goes round twice count twice. Where it goes round some regions clockwise and others the
/// other way, they count with opposite signs.
/// ```
/// use embedded_raster::{geom::polygon::twice_area, PointFx};
/// let outline = [(0, 0), (4, 0), (4, 3)].map(|(x, y)| PointFx::px(x, y));
/// assert_eq!(twice_area(&outline), 12 << 16);
/// ```
pub fn twice_area(outline: &[PointFx]) -> i128 {
    let Some((&first, &last)) = outline.first().zip(outline.last()) else { return 0 };
    // The sum of x (y after - y before) over all vertices; each product is below 2^63.
    let mut sum = 0_i128;
    let mut add = |before: PointFx, at: PointFx, after: PointFx| {
        let height = difference(bits(after).1, bits(before).1);
        sum = sum.wrapping_add(i128::from(i64::from(bits(at).0).wrapping_mul(height)));
    };
    let (mut before, mut at) = (last, first);
    for &after in outline.iter().skip(1) {
        add(before, at, after);
        (before, at) = (at, after);
    }
    add(before, at, first);
    sum
}

/// Which way an outline goes round: `Greater` when clockwise as seen on the screen, `Less` when the other way, `Equal`
/// when it has no area. An outline that crosses itself goes the way that it goes round most of its area.
/// ```
/// use core::cmp::Ordering;
/// use embedded_raster::{geom::polygon::orientation, PointFx};
/// let mut outline = [(0, 0), (4, 0), (4, 3)].map(|(x, y)| PointFx::px(x, y));
/// assert_eq!(orientation(&outline), Ordering::Greater);
/// outline.reverse();
/// assert_eq!(orientation(&outline), Ordering::Less);
/// ```
pub fn orientation(outline: &[PointFx]) -> Ordering {
    twice_area(outline).cmp(&0)
}

/// Whether a place lies inside of a polygon.
///
/// * `contours`: closed outlines, as for [`fill`](crate::raster::polygon::fill). With [`PointFx::centre_of`] a pixel it
///   is true exactly for the pixels that `fill` paints.
/// ```
/// use embedded_raster::{geom::polygon::contains, FillRule, PointFx};
/// let outer = [(0, 0), (6, 0), (6, 4), (0, 4)].map(|(x, y)| PointFx::px(x, y));
/// let hole = [(2, 1), (4, 1), (4, 3), (2, 3)].map(|(x, y)| PointFx::px(x, y));
/// assert!(contains([outer, hole], FillRule::EvenOdd, PointFx::px(0, 0)), "on the left and upper sides");
/// assert!(!contains([outer, hole], FillRule::EvenOdd, PointFx::px(3, 2)));
/// assert!(contains([outer, hole], FillRule::NonZero, PointFx::px(3, 2)), "both go the same way");
/// ```
pub fn contains<C>(contours: C, rule: FillRule, at: PointFx) -> bool
where
    C: IntoIterator,
    C::Item: IntoIterator,
    <C::Item as IntoIterator>::Item: Borrow<PointFx>,
{
    let at = bits(at);
    let mut winding = 0_i32;
    for contour in contours {
        sides(contour, |a, b| {
            if (a.1 <= at.1) == (b.1 <= at.1) {
                return;
            }
            let (upper, lower, sign) = if a.1 < b.1 { (a, b, 1) } else { (b, a, -1) };
            // The side lies left of the place, or the place is on it: from upper over lower to the place is no turn
            // clockwise.
            if turn_at(upper, lower, at) != Ordering::Greater {
                winding = winding.wrapping_add(sign);
            }
        });
    }
    winding & rule.mask() != 0
}

/// Where a horizontal line crosses a side of a polygon.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Crossing {
    /// The exact place, rounded to the nearest 1/256 pixel, halves to the right.
    pub x: I24F8,
    /// The side goes down the screen from where it starts to where it ends; otherwise it goes up.
    pub goes_down: bool,
}

#[cfg(feature = "defmt")]
impl defmt::Format for Crossing {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(
            f,
            "Crossing {{ x: {}, goes_down: {} }}",
            crate::num::decimal::Decimal::new(self.x),
            self.goes_down
        );
    }
}

/// Where a horizontal line at height `y` crosses the sides of a polygon, from left to right.
///
/// * `contours`: closed outlines, as for [`contains`].
/// * `N`: how many crossings there is room for.
///
/// A side that ends exactly on the line counts if the rest of it lies below, and a horizontal side never does, so the
/// number of crossings is always even. By the even-odd rule the line is inside of the polygon from the first crossing
/// to the second, from the third to the fourth, and so on: what hatching draws. Crossings that are rounded to the same
/// x come in any order.
///
/// # Errors
/// [`CrossingListFull`] if there are more than `N`.
/// ```
/// use embedded_raster::{geom::polygon::crossings, px, CrossingListFull, PointFx};
/// let letter_v = [(0, 0), (3, 0), (5, 6), (7, 0), (10, 0), (5, 9)].map(|(x, y)| PointFx::px(x, y));
/// let found = crossings::<_, 4>([&letter_v], px(3))?;
/// let x: Vec<f32> = found.iter().map(|crossing| crossing.x.to_num()).collect();
/// assert_eq!(x, [1.66796875, 4.0, 6.0, 8.33203125]);
/// let error = crossings::<_, 1>([&letter_v], px(3)).unwrap_err();
/// assert_eq!(error, CrossingListFull { capacity: 1, needed: 4 });
/// # Ok::<(), CrossingListFull>(())
/// ```
pub fn crossings<C, const N: usize>(contours: C, y: I24F8) -> Result<Vec<Crossing, N>, CrossingListFull>
where
    C: IntoIterator,
    C::Item: IntoIterator,
    <C::Item as IntoIterator>::Item: Borrow<PointFx>,
{
    let (y, mut found, mut needed) = (y.to_bits(), Vec::new(), 0_usize);
    for contour in contours {
        sides(contour, |a, b| {
            let (a_is_above, b_is_above) = (a.1 <= y, b.1 <= y);
            if a_is_above != b_is_above {
                let x = I24F8::from_bits(place_between((a.1, b.1), (a.0, b.0), y));
                insert(&mut found, Crossing { x, goes_down: a_is_above });
                needed = needed.saturating_add(1);
            }
        });
    }
    if needed > N {
        return Err(CrossingListFull { capacity: N, needed });
    }
    Ok(found)
}

/// Inserts a crossing before those that lie further right. Of a full list the last one gets lost.
fn insert<const N: usize>(list: &mut Vec<Crossing, N>, new: Crossing) {
    let mut next = new;
    for crossing in list.iter_mut() {
        if next.x < crossing.x {
            swap(crossing, &mut next);
        }
    }
    list.push(next).unwrap_or(());
}
