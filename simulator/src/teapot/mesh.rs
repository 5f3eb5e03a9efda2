//! [`Mesh`]: triangles in space.

use std::collections::HashMap;

use embedded_raster::Vec3;
use fixed::types::I16F16;

/// A corner of a triangle.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Corner {
    /// Where it is.
    pub place: Vec3,
    /// The direction in which the surface looks there, of length 1, or zero if it has none.
    pub normal: Vec3,
    /// Where it is on the texture, in squares of the chequerboard.
    pub texel: [I16F16; 2],
}

/// Triangles, counter-clockwise as seen from outside.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mesh {
    /// Each with its three corners.
    pub triangles: Vec<[Corner; 3]>,
}

impl Mesh {
    /// How far from (0, 0, 0) a corner may lie: the largest one does. A picture has 1/2^19 of it for a pixel.
    pub const RADIUS: i16 = 16;

    /// The direction in which a triangle looks, of length 1, or zero if it has no area.
    pub fn face_normal([a, b, c]: &[Corner; 3]) -> Vec3 {
        direction(cross(a.place, b.place, c.place))
    }

    /// The sides of its triangles, in their order. One that several triangles share, from whichever end, is there once.
    pub(super) fn sides(&self) -> Vec<Side> {
        let (mut sides, mut known) = (Vec::<Side>::new(), HashMap::new());
        for (number, [a, b, c]) in self.triangles.iter().enumerate() {
            for (a, b) in [(a, b), (b, c), (c, a)] {
                let mut ends = [a.place, b.place];
                ends.sort_unstable_by_key(|end| end.to_bits());
                let place = *known.entry(ends).or_insert(sides.len());
                if place == sides.len() {
                    sides.push(Side { ends, triangles: vec![] });
                }
                sides[place].triangles.push(number);
            }
        }
        sides
    }

    /// Gives a normal to each corner that has none: the mean of those of all triangles around it, each weighted by its area. Corners
    /// at one place have one normal.
    pub(super) fn smooth(&mut self) {
        let mut sums = HashMap::<[i32; 3], [f64; 3]>::new();
        for [a, b, c] in &self.triangles {
            let area = cross(a.place, b.place, c.place);
            for corner in [a, b, c] {
                let sum = sums.entry(corner.place.to_bits()).or_default();
                *sum = [0, 1, 2].map(|i| sum[i] + area[i]);
            }
        }
        for corner in self.triangles.iter_mut().flatten().filter(|corner| corner.normal == Vec3::ZERO) {
            corner.normal = sums.get(&corner.place.to_bits()).map_or(Vec3::ZERO, |&sum| direction(sum));
        }
    }

    /// Turns all triangles over if they look against their normals: then they are clockwise as seen from outside.
    pub(super) fn face_outwards(&mut self) {
        let agreement = |[a, b, c]: &[Corner; 3]| {
            let area = cross(a.place, b.place, c.place);
            [a, b, c].map(|corner| dot(area, units(corner.normal))).iter().sum::<f64>()
        };
        if self.triangles.iter().map(agreement).sum::<f64>() < 0.0 {
            for [_, b, c] in &mut self.triangles {
                std::mem::swap(b, c);
            }
        }
    }
}

/// A side of one triangle or of several.
pub(super) struct Side {
    pub(super) ends: [Vec3; 2],
    /// Their numbers, from 0 on.
    pub(super) triangles: Vec<usize>,
}

/// How places of any size are moved and scaled, so that the middle of the box around some of them is (0, 0, 0), and the furthest of
/// those is [`Mesh::RADIUS`] away.
pub(super) struct Fit {
    middle: [f64; 3],
    /// The largest coordinate after the move: parts of it have squares that are neither infinite nor zero.
    largest: f64,
    scale: f64,
}

impl Fit {
    pub(super) fn new(places: &[[f64; 3]]) -> Self {
        let mut low = [f64::INFINITY; 3];
        let mut high = [f64::NEG_INFINITY; 3];
        for place in places {
            low = [0, 1, 2].map(|i| low[i].min(place[i]));
            high = [0, 1, 2].map(|i| high[i].max(place[i]));
        }
        // Halves first: the sum of two numbers may be infinite.
        let mut fit = Self { middle: [0, 1, 2].map(|i| low[i] / 2.0 + high[i] / 2.0), largest: 1.0, scale: 1.0 };
        let largest = places.iter().flat_map(|&place| fit.part(place)).fold(0.0, |most: f64, n| most.max(n.abs()));
        if largest > 0.0 {
            fit.largest = largest;
        }
        let squares = places.iter().map(|&place| fit.part(place)).map(|part| dot(part, part));
        // At least 1, unless all places are one.
        fit.scale = f64::from(Mesh::RADIUS) / squares.fold(1.0, f64::max).sqrt();
        fit
    }

    fn part(&self, place: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|i| (place[i] - self.middle[i]) / self.largest)
    }

    pub(super) fn place(&self, place: [f64; 3]) -> Vec3 {
        vector(self.part(place).map(|n| n * self.scale))
    }
}

/// The nearest direction of length 1; zero for zero.
pub(super) fn direction(v: [f64; 3]) -> Vec3 {
    let largest = v.iter().fold(0.0, |most: f64, n| most.max(n.abs()));
    if largest == 0.0 {
        return Vec3::ZERO;
    }
    // Subnormal numbers have few bits, but no direction is lost to an infinite quotient.
    let parts = v.map(|n| n / largest);
    let length = dot(parts, parts).sqrt();
    vector(parts.map(|n| n / length))
}

/// The nearest number.
pub(super) fn number(n: f64) -> I16F16 {
    I16F16::saturating_from_num(n)
}

fn vector([x, y, z]: [f64; 3]) -> Vec3 {
    Vec3::new(number(x), number(y), number(z))
}

/// A vector, in numbers that one can calculate with.
pub(super) fn units(v: Vec3) -> [f64; 3] {
    v.to_bits().map(|n| f64::from(n) / 65_536.0)
}

/// Twice the area of a triangle, in the direction in which it looks.
pub(super) fn cross(a: Vec3, b: Vec3, c: Vec3) -> [f64; 3] {
    let (a, b, c) = (units(a), units(b), units(c));
    let [x, y, z] = [0, 1, 2].map(|i| b[i] - a[i]);
    let [p, q, r] = [0, 1, 2].map(|i| c[i] - a[i]);
    [y * r - z * q, z * p - x * r, x * q - y * p]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
