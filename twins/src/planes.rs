//! Values over triangles, word for word: exact ratios of wide integers, pixel by pixel.

use super::{centre, twice_area, wide, Units};

/// The nearest whole number, halves upwards, to the mean of three values that a triangle's corners have, at the centre of a pixel.
/// The triangle has an area.
pub fn nearest(corners: [Units; 3], values: [i64; 3], x: i32, y: i32) -> i128 {
    let (numerator, area) = ratio(corners, values, x, y);
    (2 * numerator + area).div_euclid(2 * area)
}

/// The same as a ratio, its lower part positive.
pub fn ratio(corners: [Units; 3], values: [i64; 3], x: i32, y: i32) -> (i128, i128) {
    let ([a, b, c], p) = (corners.map(wide), (centre(x, 256), centre(y, 256)));
    let edge = |a: (i128, i128), b: (i128, i128)| (b.0 - a.0) * (p.1 - a.1) - (b.1 - a.1) * (p.0 - a.0);
    let weights = [edge(b, c), edge(c, a), edge(a, b)];
    let sum: i128 = weights.iter().zip(values).map(|(w, v)| w * i128::from(v)).sum();
    let area = twice_area(corners[0], corners[1], corners[2]);
    if area < 0 {
        (-sum, -area)
    } else {
        (sum, area)
    }
}
