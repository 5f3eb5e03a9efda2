//! Values over triangles, word for word: exact ratios of wide integers, pixel by pixel.

use embedded_raster::{geom::Facet, Rect};

use super::{centre, rng::Rng, twice_area, wide, Units};

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

/// The most units that a box may have in width and height together.
const MOST: i32 = (Facet::MOST as i32) << 8;

/// A triangle of some kind, of which there are 48, and a window on it: tiny ones, slivers, such that reach far out of the window, and
/// the largest.
pub fn triangle_of_kind(rng: &mut Rng, kind: usize) -> ([Units; 3], Rect) {
    let side = [40, 700, 256 * 40, 256 * 300, 256 * 4095, MOST / 2][kind % 6];
    let (left, upper) = (rng.int(-side, side / 2), rng.int(-side, side / 2));
    let mut corner = |along: i32| {
        let (x, y) = (rng.int(0, side), rng.int(0, side));
        match along {
            // Corners of the box.
            0 => (left + x / side * side, upper + y / side * side),
            1 => (left + side, upper),
            2 => (left, upper + side),
            // Close to the diagonal: a sliver.
            3 => (left + x, upper + x + rng.int(-2, 2).clamp(-x, side - x)),
            4 => ((left + x) & !255 | 128, (upper + y) & !255 | 128),
            _ => (left + x, upper + y),
        }
    };
    let pick = kind / 6 % 8;
    let units = [
        corner([5, 1, 3, 4, 5, 0, 5, 1][pick]),
        corner([5, 2, 3, 4, 3, 1, 5, 2][pick]),
        corner([5, 5, 3, 4, 3, 2, 5, 0][pick]),
    ];
    // Windows around a place of the triangle, and sometimes rows as a whole.
    let [a, b, c] = units;
    let (u, v) = (rng.int(0, 100), rng.int(0, 100));
    let at = |a: i32, b: i32, c: i32| {
        let (b, c) = (i64::from(b - a) * i64::from(u) / 100, i64::from(c - a) * i64::from(v.min(100 - u)) / 100);
        ((i64::from(a) + b + c) >> 8) as i32
    };
    let (x, y) = (at(a.0, b.0, c.0), at(a.1, b.1, c.1));
    let window =
        if rng.one_in(8) { Rect::new(-20_000, y, 20_000, y + 1) } else { Rect::new(x - 20, y - 3, x + 20, y + 3) };
    (units, window)
}
