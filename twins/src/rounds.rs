//! Sectors and rectangles with rounded corners, pixel by pixel.

use embedded_raster::{Angle, Radii, Rect};

use super::shapes;

/// Is a place less than half a turn after a direction? It stands a little farther from the horizontal line through the middle, or
/// below it, and much less to the right; the middle itself a little to the right, and much less below.
fn after((x, y): (i32, i32), (u, v): (i64, i64)) -> bool {
    let (x, y) = (i128::from(x), i128::from(y));
    // In units so small that e is a nudge, and e^2 is far below e.
    let (one, e) = (1_i128 << 62, 1_i128 << 31);
    let (right, down) = match (u, v) {
        (0, 0) => (e, 1),
        (_, ..0) => (1, -e),
        _ => (1, e),
    };
    x * (i128::from(v) * one + down) - y * (i128::from(u) * one + right) > 0
}

/// Does a place, seen from the middle, lie in a sector?
pub fn sector_has(start: Angle, end: Angle, place: (i64, i64)) -> bool {
    let turn = end.to_bits().wrapping_sub(start.to_bits());
    let (first, second) = (after(start.cos_sin(), place), after(end.cos_sin(), place));
    match turn {
        0 => false,
        1..=0x8000_0000 => first && !second,
        _ => first || !second,
    }
}

/// A pixel seen from the middle of a box, in half pixels.
pub fn from_box(area: Rect, x: i32, y: i32) -> (i64, i64) {
    let part = |at: i32, from: i32, to: i32| 2 * i64::from(at) + 1 - i64::from(from) - i64::from(to);
    (part(x, area.x0, area.x1), part(y, area.y0, area.y1))
}

/// Which corner of a rounded rectangle a pixel lies in: its box, twice the radius wide.
fn corner_of(area: Rect, radii: Radii, x: i32, y: i32) -> Option<Rect> {
    let limit = area.width().min(area.height()) / 2;
    let near = |radius: u32| i64::from(radius.min(limit));
    let (left, right) = (i64::from(x) - i64::from(area.x0), i64::from(area.x1) - 1 - i64::from(x));
    let (top, bottom) = (i64::from(y) - i64::from(area.y0), i64::from(area.y1) - 1 - i64::from(y));
    let square = |x0: i64, y0: i64, r: i64| Rect::new(x0 as i32, y0 as i32, (x0 + 2 * r) as i32, (y0 + 2 * r) as i32);
    let (x0, y0, x1, y1) = (area.x0.into(), area.y0.into(), i64::from(area.x1), i64::from(area.y1));
    let [a, b, c, d] = [radii.top_left, radii.top_right, radii.bottom_right, radii.bottom_left].map(near);
    if left < a && top < a {
        Some(square(x0, y0, a))
    } else if right < b && top < b {
        Some(square(x1 - 2 * b, y0, b))
    } else if right < c && bottom < c {
        Some(square(x1 - 2 * c, y1 - 2 * c, c))
    } else if left < d && bottom < d {
        Some(square(x0, y1 - 2 * d, d))
    } else {
        None
    }
}

/// Is the centre of a pixel inside a rectangle with rounded corners?
pub fn rounded_has(area: Rect, radii: Radii, x: i32, y: i32) -> bool {
    match corner_of(area, radii, x, y) {
        Some(corner) => shapes::box_ellipse_has(corner, x, y),
        None => area.contains(x, y),
    }
}

/// Does its outline have a pixel?
pub fn rounded_outline_has(area: Rect, radii: Radii, x: i32, y: i32) -> bool {
    match corner_of(area, radii, x, y) {
        Some(corner) => shapes::outline_has(corner, x, y),
        None => area.contains(x, y) && (x == area.x0 || y == area.y0 || x == area.x1 - 1 || y == area.y1 - 1),
    }
}

/// The outline and what lies between its pixels on each row.
pub fn rounded_enclosed_has(area: Rect, radii: Radii, x: i32, y: i32) -> bool {
    match corner_of(area, radii, x, y) {
        Some(corner) => shapes::enclosed_has(corner, x, y),
        None => area.contains(x, y),
    }
}
