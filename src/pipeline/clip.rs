//! Clipping in homogeneous coordinates: before the division by w, where what lies behind the eye is no special case.
//!
//! | plane | inside | why |
//! |---|---|---|
//! | near | `z >= 0` | what is behind the eye has no place on the screen |
//! | far | `z <= w` | depths end there |
//! | left, right | `-G w <= x W <= G w` | coordinates on the screen have a range |
//! | bottom, top | `-G w <= y H <= G w` | the same |
//!
//! The last four are a *guard band*, much larger than most pictures: what only crosses an edge of the picture is not cut, as spans
//! are clipped to the window anyway. G is 6,143: the middle of the picture and 3,071.5 pixels around it. What lies outside of one
//! edge of the picture as a whole is left out at once.
//!
//! Between the planes w is not negative: twice `G w` is at least 0.

use core::mem::swap;

use heapless::Vec;

use super::{vertex::Vertex, viewport::Screen};
use crate::geom::{space::Vec4, Barycentric, Mix};

/// Planes that cut.
const PLANES: u32 = 6;
/// A triangle gains one corner with each plane.
const CORNERS: usize = 3 + PLANES as usize;

/// What a look at the corners says.
pub(super) enum Clipped {
    /// All of them lie outside of one plane, or of one edge of the picture.
    Outside,
    /// All of them lie inside of all planes.
    Inside,
    /// These planes have corners outside: one bit each.
    Cut(u32),
}

/// How far inside of a plane a place is: below 2^45 on both sides.
#[inline(always)]
fn inside(screen: Screen, at: Vec4, plane: u32) -> i64 {
    let [x, y, z, w] = at.to_bits().map(i64::from);
    let guard = |n: i64, size: u16| Screen::GUARD.wrapping_mul(w).wrapping_add(n.wrapping_mul(size.into()));
    match plane {
        0 => z,
        1 => w.wrapping_sub(z),
        2 => guard(x, screen.width),
        3 => guard(x.wrapping_neg(), screen.width),
        4 => guard(y, screen.height),
        _ => guard(y.wrapping_neg(), screen.height),
    }
}

/// The planes that a place lies outside of, and above them the edges of the picture, one bit each.
#[inline]
fn outcode(screen: Screen, at: Vec4) -> u32 {
    let [x, y, _, w] = at.to_bits().map(i64::from);
    let edges = [w.wrapping_add(x), w.wrapping_sub(x), w.wrapping_add(y), w.wrapping_sub(y)];
    let planes = (0..PLANES).fold(0, |code, plane| code | u32::from(inside(screen, at, plane) < 0) << (plane & 31));
    let bits = (PLANES..PLANES + 4).zip(edges);
    bits.fold(planes, |code, (bit, distance)| code | u32::from(distance < 0) << (bit & 31))
}

/// Which planes cut a triangle.
#[inline]
pub(super) fn look<V>(screen: Screen, corners: &[Vertex<V>; 3]) -> Clipped {
    let [a, b, c] = corners.each_ref().map(|corner| outcode(screen, corner.position));
    if a & b & c != 0 {
        return Clipped::Outside;
    }
    match (a | b | c) & ((1 << PLANES) - 1) {
        0 => Clipped::Inside,
        planes => Clipped::Cut(planes),
    }
}

/// The parts of a triangle inside of some planes.
#[inline(never)]
pub(super) fn cut<V: Mix>(
    screen: Screen,
    corners: [Vertex<V>; 3],
    planes: u32,
    mut piece: impl FnMut(&[Vertex<V>; 3]),
) {
    // Two polygons, by turns what is cut and what comes of it: only the references change places.
    let (mut first, mut second): (Polygon<V>, Polygon<V>) = (Vec::from_array(corners), Vec::new());
    let (mut from, mut to) = (&mut first, &mut second);
    for plane in (0..PLANES).filter(|plane| planes >> (plane & 31) & 1 != 0) {
        cut_by_plane(screen, from, plane, to);
        swap(&mut from, &mut to);
    }
    let Some((&first, rest)) = from.split_first() else { return };
    for pair in rest.windows(2) {
        if let &[second, third] = pair {
            piece(&[first, second, third]);
        }
    }
}

/// What is left of a triangle.
type Polygon<V> = Vec<Vertex<V>, CORNERS>;

/// The part of a polygon inside of a plane: corners inside, and a new one where a side crosses the plane.
fn cut_by_plane<V: Mix>(screen: Screen, polygon: &Polygon<V>, plane: u32, cut: &mut Polygon<V>) {
    cut.clear();
    // There is room for all: a convex polygon crosses a plane twice.
    let mut keep = |vertex| _ = cut.push(vertex);
    let Some(mut before) = polygon.last() else { return };
    let mut from = inside(screen, before.position, plane);
    for vertex in polygon {
        let to = inside(screen, vertex.position, plane);
        if (from < 0) != (to < 0) {
            let [inner, outer] = if from < 0 { [(vertex, to), (before, from)] } else { [(before, from), (vertex, to)] };
            keep(crossing(inner, outer));
        }
        if to >= 0 {
            keep(*vertex);
        }
        (before, from) = (vertex, to);
    }
}

/// The corner where a side crosses a plane, from its inner end to its outer one: the same for both triangles of the side.
#[inline(never)]
fn crossing<V: Mix>((inner, d): (&Vertex<V>, i64), (outer, e): (&Vertex<V>, i64)) -> Vertex<V> {
    let place = Barycentric { weights: [e.wrapping_neg(), d, 0], total: d.wrapping_sub(e) };
    let (a, b) = (inner.position.to_bits(), outer.position.to_bits());
    let mut ends = a.into_iter().zip(b);
    // There is one for each.
    let position = [(); 4].map(|()| ends.next().map_or(0, |(a, b)| place.mix([a, b, a])));
    Vertex { position: Vec4::from_bits(position), values: V::mix(&place, [inner.values, outer.values, inner.values]) }
}
