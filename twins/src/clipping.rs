//! Clipping in clip coordinates, by the rule: what lies inside of all planes, and its corners as exact ratios.

/// How far from the middle of a picture a corner may lie, in half pixels.
const GUARD: i64 = 6_140;

/// How far inside of each plane a place is: near, far, left, right, bottom, top.
pub fn distances([x, y, z, w]: [i32; 4], (width, height): (u16, u16)) -> [i64; 6] {
    let [x, y, z, w] = [x, y, z, w].map(i64::from);
    let (x, y, guard) = (x * i64::from(width), y * i64::from(height), GUARD * w);
    [z, w - z, guard + x, guard - x, guard + y, guard - y]
}

/// The nearest number to the mean of some, halves upwards.
pub fn mean<const N: usize>(weights: [i128; N], numbers: [i64; N]) -> i64 {
    let total: i128 = weights.iter().sum();
    let sum: i128 = weights.iter().zip(numbers).map(|(w, n)| w * i128::from(n)).sum();
    (2 * sum + total).div_euclid(2 * total) as i64
}

/// The corners of what is left of a triangle, as weights of its corners: every place where two of its sides and planes meet that is
/// outside of none. Some may be there several times.
pub fn corners(triangle: [[i32; 4]; 3], size: (u16, u16)) -> Vec<[i128; 3]> {
    let [a, b, c] = triangle.map(|corner| distances(corner, size));
    let planes = (0..6).map(|plane| [a[plane], b[plane], c[plane]]);
    let lines: Vec<[i64; 3]> = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].into_iter().chain(planes).collect();
    let mut found = vec![];
    for (i, d) in lines.iter().enumerate() {
        for e in &lines[..i] {
            let product =
                |i: usize, j: usize| i128::from(d[i]) * i128::from(e[j]) - i128::from(d[j]) * i128::from(e[i]);
            let place = [product(1, 2), product(2, 0), product(0, 1)];
            // Weights that all have one sign, made positive; parallel lines meet nowhere.
            let place = if place.iter().any(|&w| w < 0) { place.map(|w| -w) } else { place };
            if place.iter().all(|&w| w >= 0) && place != [0; 3] && lines.iter().all(|line| !is_outside(place, *line)) {
                found.push(place);
            }
        }
    }
    found
}

/// Whether the sum of three products of up to 140 bits is negative.
fn is_outside(weights: [i128; 3], distances: [i64; 3]) -> bool {
    // 2^64 high + low, both far from the ends of their type.
    let (mut high, mut low) = (0_i128, 0_i128);
    for (weight, distance) in weights.into_iter().zip(distances) {
        high += (weight >> 64) * i128::from(distance);
        low += i128::from(weight as u64) * i128::from(distance);
    }
    high + (low >> 64) < 0
}

/// The part of a line that is left, as weights of its ends: where it begins and where it ends.
pub fn line(ends: [[i32; 4]; 2], size: (u16, u16)) -> Option<[[i128; 2]; 2]> {
    let [d, e] = ends.map(|end| distances(end, size).map(i128::from));
    // Every place where it may begin or end; those inside of all planes, in their order along the line.
    let crossings = (0..6).filter(|&p| (d[p] < 0) != (e[p] < 0)).map(|p| [e[p].abs(), d[p].abs()]);
    let mut inside: Vec<[i128; 2]> = [[1, 0], [0, 1]]
        .into_iter()
        .chain(crossings)
        .filter(|[a, b]| (0..6).all(|p| a * d[p] + b * e[p] >= 0))
        .collect();
    // b / (a + b) of one against that of the other.
    inside.sort_by(|[a, b], [c, d]| (b * c).cmp(&(d * a)));
    Some([*inside.first()?, *inside.last()?])
}
