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
//! are clipped to the window anyway. G is 6,140: the middle of the picture and 3,070 pixels around it. A triangle that lies outside
//! of one edge of the picture as a whole is left out at once.
//!
//! Between the planes w is not negative: twice `G w` is at least 0.
//!
//! **Exact.** A new corner is where two straight lines meet: sides of the triangle, or what a plane leaves of it. In the triangle's
//! own weights a0, a1, a2 (a place is the mean of its corners, weighted so) such a line is `d0 a0 + d1 a1 + d2 a2 = 0`, where di says
//! how far inside of the plane corner i is; the side opposite to corner i is `ai = 0`. Two lines d and e meet at `d x e`, the cross
//! product. So what is left of a triangle is kept as a list of lines, not of corners. Where a corner is, and on which side of the
//! next plane, is found from the triangle itself, however many planes came before, and each of its coordinates and values is
//! rounded once, from the exact ratio. A corner on a side of the triangle has weights of the ends of that side alone: both
//! triangles of the side get the same one, and there are no cracks.
//!
//! Places on the screen and depths are found from a position with more bits, which is not rounded before the division: where w is
//! small, as it is on a plane close to the eye, half a unit of it would be pixels.
//!
//! **Once.** What is left of a triangle has up to nine corners, and is handed out as a fan of triangles. Corners have been rounded: of a
//! needle, one may have got inside, or two long sides may cross, and some fans fold back over themselves. Rounding keeps the order
//! of columns and of rows, so the outline still goes down once and up once, and a row crosses it twice: the pixels between are wound
//! around once, this way or that. The triangles of *each* fan, fronts less backs, add up to these windings, so there are no cracks; a fold
//! adds a front and a back to a pixel that has to be painted once or not at all. So the fan is taken that paints the fewest pixels, which
//! is one that turns one way if there is one. Only where two sides cross between two pixels, each of them less than 1/128 pixel away
//! from both sides and on another side of them, every fan may have a pixel in its fold: of 9,000,000 random needles 3 have one.
//!
//! Range: a di is below 2^45, so the weights of a corner between two planes are below 2^91, and their sum is below 2^93. Means of
//! numbers of 32 bits take 125 bits, and a division of as many steps as their difference and what is behind the point have bits.
//!
//! Source: I. Sutherland and G. Hodgman, "Reentrant Polygon Clipping", Communications of the ACM 17, 1974 (the polygon, plane by
//! plane).

use core::mem::swap;

use heapless::Vec;

use super::{
    vertex::Vertex,
    viewport::{turn, Corner, Screen},
};
use crate::{
    geom::{space::Vec4, Mix, PointFx},
    num::cast::{signed, unsigned},
    raster::triangle,
    span::ClippedSpan,
};

/// Planes that cut.
const PLANES: u32 = 6;
/// The sides of a triangle are the first lines, planes come after them.
const FIRST_PLANE: u8 = 3;
/// All of them.
const LINES: u8 = 9;

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

/// The planes that a place lies outside of, one bit each.
#[inline]
pub(super) fn planes(screen: Screen, at: Vec4) -> u32 {
    (0..PLANES).fold(0, |code, plane| code | u32::from(inside(screen, at, plane) < 0) << (plane & 31))
}

/// The planes that a place lies outside of, and above them the edges of the picture, one bit each.
#[inline]
fn outcode(screen: Screen, at: Vec4) -> u32 {
    let [x, y, _, w] = at.to_bits().map(i64::from);
    let edges = [w.wrapping_add(x), w.wrapping_sub(x), w.wrapping_add(y), w.wrapping_sub(y)];
    let bits = (PLANES..PLANES + 4).zip(edges);
    bits.fold(planes(screen, at), |code, (bit, distance)| code | u32::from(distance < 0) << (bit & 31))
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
    corners: &[Vertex<V>; 3],
    planes: u32,
    mut piece: impl FnMut(&[Corner<V>; 3]),
) {
    let triangle = Triangle { screen, corners: corners.each_ref().map(|corner| corner.position) };
    let lines = triangle.left(planes);
    let Some(&last) = lines.last() else { return };
    let (mut polygon, mut places): (Vec<Corner<V>, { LINES as usize }>, Places) = (Vec::new(), Vec::new());
    let mut line = last;
    for &next in &lines {
        let Some(corner) = corner(&triangle, corners, line, next) else { return };
        // There is room for all.
        _ = (places.push(corner.projected.place), polygon.push(corner));
        line = next;
    }
    let mut fan = |[a, b, c]: [usize; 3]| {
        if let (Some(a), Some(b), Some(c)) = (polygon.get(a), polygon.get(b), polygon.get(c)) {
            piece(&[*a, *b, *c]);
        }
    };
    fan_from(apex(screen, &places), places.len()).for_each(&mut fan);
}

/// Places of the corners of what is left.
type Places = Vec<PointFx, { LINES as usize }>;

/// The corners of the triangles of a fan, by their numbers.
#[inline(always)]
fn fan_from(apex: usize, corners: usize) -> impl Iterator<Item = [usize; 3]> {
    let around = move |i: usize| {
        let at = apex.wrapping_add(i);
        at.checked_sub(corners).unwrap_or(at)
    };
    (2..corners).map(move |i| [apex, around(i.wrapping_sub(1)), around(i)])
}

/// The corner from which a fan of triangles paints the fewest pixels.
///
/// From each corner of a convex polygon a fan has the same ones. But each place has been rounded: see the [module](self).
#[inline(never)]
fn apex(screen: Screen, places: &Places) -> usize {
    let corner = |i: usize| places.get(i).copied().unwrap_or_default();
    let fan = |apex: usize| fan_from(apex, places.len()).map(|places| places.map(corner));
    let is_one_way = |&apex: &usize| {
        let ways = fan(apex).map(turn).fold(0, |ways, turn| ways | u32::from(turn < 0) << 1 | u32::from(turn > 0));
        ways != 3
    };
    let pixels = |&apex: &usize| {
        let mut pixels = 0_u32;
        for corners in fan(apex) {
            triangle::fill(corners, screen.window(), |span: ClippedSpan| pixels = pixels.wrapping_add(span.len()));
        }
        pixels
    };
    let all = 0..places.len();
    all.clone().find(is_one_way).or_else(|| all.min_by_key(pixels)).unwrap_or(0)
}

/// The corner between two lines, with all that belongs to it.
#[inline(never)]
fn corner<V: Mix>(triangle: &Triangle, corners: &[Vertex<V>; 3], line: u8, next: u8) -> Option<Corner<V>> {
    // Two sides meet at the corner that is opposite to the third one.
    let uncut = corners.get(usize::from(FIRST_PLANE.wrapping_sub(line).wrapping_sub(next)));
    match uncut {
        Some(corner) if line < FIRST_PLANE && next < FIRST_PLANE => triangle.screen.corner(*corner),
        _ => between(triangle.screen, &triangle.meet(line, next), corners),
    }
}

/// What lies between three vertices, by their weights: each number is rounded once.
fn between<V: Mix>(screen: Screen, weights: &[i128; 3], corners: &[Vertex<V>; 3]) -> Option<Corner<V>> {
    let positions = corners.each_ref().map(|corner| corner.position);
    let position = mean_position(weights, positions, 0);
    // The place on the screen takes as many bits more as keep all coordinates, rounded, below 2^31.
    let most = position.to_bits().into_iter().fold(0, |most: u32, n| most.max(n.unsigned_abs()));
    let more = most.leading_zeros().saturating_sub(2);
    let projected = screen.project(mean_position(weights, positions, more))?;
    let values = V::mix(&|numbers| mean(weights, numbers, 0), corners.each_ref().map(|corner| corner.values));
    Some(Corner { vertex: Vertex { position, values }, projected })
}

/// A mean of positions, times a power of two.
#[inline(never)]
fn mean_position(weights: &[i128; 3], corners: [Vec4; 3], more: u32) -> Vec4 {
    let [a, b, c] = corners.map(Vec4::to_bits);
    let mut numbers = a.into_iter().zip(b).zip(c);
    // There is one for each.
    Vec4::from_bits([(); 4].map(|()| numbers.next().map_or(0, |((a, b), c)| mean(weights, [a, b, c], more))))
}

/// The nearest number to the mean of three times `2^more`, halves upwards. Weights are not negative, and not all of them are 0. The
/// caller knows that it has 32 bits.
///
/// How far the mean is above the least number is found by long division: it is not above the largest one, so a few steps give its
/// whole part, and `more` steps what is behind the point.
#[inline(never)]
fn mean(weights: &[i128; 3], numbers: [i32; 3], more: u32) -> i32 {
    let [a, b, c] = numbers;
    let (low, high) = (a.min(b).min(c), a.max(b).max(c));
    let above = |number: i32| i128::from(unsigned(number.wrapping_sub(low)));
    let products = weights.iter().zip(numbers).map(|(&weight, number)| weight.wrapping_mul(above(number)));
    let mut rest = products.fold(0_i128, i128::wrapping_add).cast_unsigned();
    let total = weights.iter().copied().fold(0_i128, i128::wrapping_add).cast_unsigned();
    let bits = 32_u32.wrapping_sub(unsigned(high.wrapping_sub(low)).leading_zeros());
    let (mut part, mut quotient) = (total.wrapping_shl(bits), 0_u32);
    for _ in 0..bits {
        (part, quotient) = (part >> 1, quotient << 1);
        if rest >= part {
            (rest, quotient) = (rest.wrapping_sub(part), quotient | 1);
        }
    }
    for _ in 0..more {
        (rest, quotient) = (rest << 1, quotient << 1);
        if rest >= total {
            (rest, quotient) = (rest.wrapping_sub(total), quotient | 1);
        }
    }
    let is_half = rest << 1 >= total;
    low.wrapping_shl(more).wrapping_add(signed(quotient)).wrapping_add(is_half.into())
}

/// Lines that bound what is left of a triangle, in their order around it: numbers of its sides (of the corners opposite to them),
/// and of planes.
///
/// A triangle has three, and gains one with each plane.
type Lines = Vec<u8, { LINES as usize }>;

/// A triangle in clip coordinates.
struct Triangle {
    screen: Screen,
    corners: [Vec4; 3],
}

impl Triangle {
    /// What is left of it inside of some planes.
    #[inline(never)]
    fn left(&self, planes: u32) -> Lines {
        let (mut from, mut to): (Lines, Lines) = (Vec::from_array([2, 0, 1]), Vec::new());
        for (plane, line) in (0..PLANES).zip(FIRST_PLANE..LINES) {
            if planes >> (plane & 31) & 1 != 0 {
                self.cut(&from, line, &mut to);
                swap(&mut from, &mut to);
            }
        }
        from
    }

    /// The lines that are left inside of a plane, which comes in between where it cuts.
    fn cut(&self, lines: &Lines, plane: u8, cut: &mut Lines) {
        cut.clear();
        // There is room for all: a convex polygon crosses a plane twice.
        let mut keep = |line| _ = cut.push(line);
        let (Some(&first), Some(&last)) = (lines.first(), lines.last()) else { return };
        let distances = self.line(plane);
        let mut is_inside = self.is_inside(last, first, &distances);
        let nexts = lines.iter().skip(1).chain([&first]);
        for (&line, &next) in lines.iter().zip(nexts) {
            let (from, to) = (is_inside, self.is_inside(line, next, &distances));
            if from || to {
                keep(line);
            }
            if from && !to {
                keep(plane);
            }
            is_inside = to;
        }
    }

    /// A line: how far inside of it each corner is.
    fn line(&self, line: u8) -> [i64; 3] {
        match line.checked_sub(FIRST_PLANE) {
            Some(plane) => self.corners.map(|corner| inside(self.screen, corner, plane.into())),
            None => [0, 1, 2].map(|corner: u8| (corner == line).into()),
        }
    }

    /// The weights of the place where two lines meet, which is in the triangle: not negative.
    #[inline(never)]
    fn meet(&self, first: u8, second: u8) -> [i128; 3] {
        let ([a0, a1, a2], [b0, b1, b2]) = (self.line(first).map(i128::from), self.line(second).map(i128::from));
        let minor = |a: i128, b: i128, c: i128, d: i128| a.wrapping_mul(d).wrapping_sub(b.wrapping_mul(c));
        let place = [minor(a1, a2, b1, b2), minor(a2, a0, b2, b0), minor(a0, a1, b0, b1)];
        // All have one sign.
        if place.iter().any(|&weight| weight < 0) {
            return place.map(i128::wrapping_neg);
        }
        place
    }

    /// Whether the place where two lines meet lies inside of another one.
    ///
    /// The sum of three products of 91 and 45 bits would be too long. So it is taken in two parts, 2^48 times one and the other.
    fn is_inside(&self, first: u8, second: u8, distances: &[i64; 3]) -> bool {
        let place = self.meet(first, second);
        let sum = |part: fn(i128) -> i128| {
            let products = place.iter().zip(distances).map(|(&w, &d)| part(w).wrapping_mul(d.into()));
            products.fold(0_i128, i128::wrapping_add)
        };
        let (high, low) = (sum(|w| w >> 48), sum(|w| w & 0xffff_ffff_ffff));
        high.wrapping_add(low >> 48) >= 0
    }
}

/// The part of a line inside of some planes: its ends, each rounded once. `None` if nothing is left.
#[inline(never)]
pub(super) fn cut_line<V: Mix>(screen: Screen, ends: &[Vertex<V>; 2], planes: u32) -> Option<[Corner<V>; 2]> {
    let [first, last] = *ends;
    // Weights of the ends, at the place where the line comes in, and where it goes out.
    let (mut entry, mut exit) = ([1, 0], [0, 1]);
    // Of two places, whether the first one is farther along the line. Products have 91 bits.
    let is_farther = |[a, b]: [i64; 2], [c, d]: [i64; 2]| {
        i128::from(b).wrapping_mul(c.into()) > i128::from(d).wrapping_mul(a.into())
    };
    for plane in (0..PLANES).filter(|plane| planes >> (plane & 31) & 1 != 0) {
        let (d, e) = (inside(screen, first.position, plane), inside(screen, last.position, plane));
        match (d < 0, e < 0) {
            (true, true) => return None,
            (true, false) => {
                let crossing = [e, d.wrapping_neg()];
                entry = if is_farther(crossing, entry) { crossing } else { entry };
            }
            (false, true) => {
                let crossing = [e.wrapping_neg(), d];
                exit = if is_farther(exit, crossing) { crossing } else { exit };
            }
            (false, false) => {}
        }
    }
    if is_farther(entry, exit) {
        return None;
    }
    let end = |[a, b]: [i64; 2]| between(screen, &[a.into(), b.into(), 0], &[first, last, first]);
    Some([
        if entry == [1, 0] { screen.corner(first)? } else { end(entry)? },
        if exit == [0, 1] { screen.corner(last)? } else { end(exit)? },
    ])
}
