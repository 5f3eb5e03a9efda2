//! Lines between places and the values along them, word for word: exact ratios of wide integers, column by column.

use embedded_raster::Rect;

use super::{centre, wide, Place, Units};

/// The same place with its axes exchanged.
fn turned((x, y): Units) -> Units {
    (y, x)
}

/// Whether y is the longer axis.
pub fn is_steep(a: Units, b: Units) -> bool {
    let ((ax, ay), (bx, by)) = (wide(a), wide(b));
    (by - ay).abs() > (bx - ax).abs()
}

/// The pixels of the line between two places that lie in a window, from a to b.
pub fn line_fx(a: Units, b: Units, window: Rect) -> Vec<(i32, i32)> {
    if is_steep(a, b) {
        let window = Rect::new(window.y0, window.x0, window.y1, window.x1);
        return line_fx(turned(a), turned(b), window).into_iter().map(turned).collect();
    }
    let (first, last) = (a.0 >> 8, b.0 >> 8);
    let pixel = |x: i32| {
        let y = row(wide(a), wide(b), centre(x, 256));
        let is_seen = i128::from(window.y0) <= y && y < i128::from(window.y1);
        is_seen.then_some((x, y as i32))
    };
    let columns = first.min(last).max(window.x0)..first.max(last).saturating_add(1).min(window.x1);
    let mut pixels: Vec<_> = columns.filter_map(pixel).collect();
    if first > last {
        pixels.reverse();
    }
    pixels
}

/// The row in which the straight line through a and b crosses the middle of a column. On the border between two rows, the one
/// farther along the way.
fn row((ax, ay): Place, (bx, by): Place, middle: i128) -> i128 {
    if ax == bx {
        return ay.div_euclid(256);
    }
    // The crossing is n / d, in 1/256 pixel.
    let (n, d) = (ay * (bx - ax) + (middle - ax) * (by - ay), bx - ax);
    let (n, d) = if d < 0 { (-n, -d) } else { (n, d) };
    let row = n.div_euclid(256 * d);
    row - i128::from(by < ay && n.rem_euclid(256 * d) == 0)
}

/// The nearest whole number, halves upwards, to the value of a line at a pixel, where it has two values at its ends.
pub fn nearest_along(a: Units, b: Units, values: [i64; 2], pixel: (i32, i32)) -> i128 {
    if is_steep(a, b) {
        return nearest_along(turned(a), turned(b), values, turned(pixel));
    }
    let ((ax, _), (bx, _)) = (wide(a), wide(b));
    let [first, last] = values.map(i128::from);
    if ax == bx {
        return first;
    }
    // The middle of the column, or the end before it.
    let x = centre(pixel.0, 256).clamp(ax.min(bx), ax.max(bx));
    let (n, d) = (first * (bx - x) + last * (x - ax), bx - ax);
    let (n, d) = if d < 0 { (-n, -d) } else { (n, d) };
    (2 * n + d).div_euclid(2 * d)
}
