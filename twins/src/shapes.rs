//! The rules, word for word.

use embedded_graphics_core::geometry::Point;
use embedded_raster::{FillRule, Rect};

use super::{runs_where, wide, Place, Run, Units};

/// 24.8 units to a pixel.
const ONE: i128 = 256;

/// The centre of a pixel in units, `per_pixel` to a pixel.
pub fn centre(pixel: i32, per_pixel: i128) -> i128 {
    i128::from(pixel) * per_pixel + per_pixel / 2
}

/// Twice the signed area of a triangle, positive when it turns clockwise on the screen (y points down).
pub fn twice_area(a: Units, b: Units, c: Units) -> i128 {
    edge_function(wide(a), wide(b), wide(c))
}

/// Positive on the inner side of the side from a to b of a triangle with positive area.
///
/// Where it is inlined the compiler sees that numbers in 24.8 are narrow: the tests of triangles take half of the time.
#[inline(always)]
fn edge_function(a: Place, b: Place, p: Place) -> i128 {
    (b.0 - a.0) * (p.1 - a.1) - (b.1 - a.1) * (p.0 - a.0)
}

/// Is the centre of a pixel inside a triangle?
#[inline]
pub fn triangle_has(corners: [Units; 3], x: i32, y: i32) -> bool {
    wide_triangle_has(corners.map(wide), ONE, x, y)
}

/// Is the centre of a pixel inside, a centre on a side counting as if it stood at (+e, +e^2)? In units, `per_pixel` to a
/// pixel.
#[inline(always)]
pub fn wide_triangle_has([a, b, c]: [Place; 3], per_pixel: i128, x: i32, y: i32) -> bool {
    let (b, c) = match edge_function(a, b, c) {
        0 => return false,
        area if area < 0 => (c, b),
        _ => (b, c),
    };
    let at = (centre(x, per_pixel), centre(y, per_pixel));
    let inside = |from: Place, to: Place| match edge_function(from, to, at) {
        // The edge function moves by dx e^2 - dy e; e decides unless its factor is zero.
        0 => to.1 < from.1 || (to.1 == from.1 && to.0 > from.0),
        e => e > 0,
    };
    inside(a, b) && inside(b, c) && inside(c, a)
}

/// The pixels of a triangle, pixel by pixel.
pub fn triangle(corners: [Units; 3], window: Rect) -> Vec<Run> {
    runs_where(window, |x, y| triangle_has(corners, x, y))
}

/// The sides of a closed contour, the last vertex joined to the first.
pub fn sides_of<T: Copy>(contour: &[T]) -> impl Iterator<Item = (T, T)> + '_ {
    (0..contour.len()).map(|i| (contour[i], contour[(i + 1) % contour.len()]))
}

/// The sides of closed contours.
pub fn sides(contours: &[Vec<Units>]) -> impl Iterator<Item = (Units, Units)> + '_ {
    contours.iter().flat_map(|c| sides_of(c))
}

/// Does a side cross a row: `y0 <= y < y1`?
pub fn crosses((a, b): (Place, Place), y: i128) -> bool {
    a.1.min(b.1) <= y && y < a.1.max(b.1)
}

/// The sides of closed contours that cross a row.
fn sides_at(contours: &[Vec<Units>], y: i128) -> impl Iterator<Item = (Units, Units)> + '_ {
    sides(contours).filter(move |&side| crosses(wide_side(side), y))
}

fn wide_side((a, b): (Units, Units)) -> (Place, Place) {
    (wide(a), wide(b))
}

/// The winding number and the number of sides at or left of a place, of those that cross its row.
pub fn crossings_at(sides_on_row: impl Iterator<Item = (Place, Place)>, (x, y): Place) -> (i32, u32) {
    sides_on_row.fold((0, 0), |(winding, count), (a, b)| {
        let (upper, lower, sign) = if a.1 < b.1 { (a, b, 1) } else { (b, a, -1) };
        // The crossing ux + (y - uy) dx / dy is at or left of x.
        let ((ux, uy), (dx, dy)) = (upper, (lower.0 - upper.0, lower.1 - upper.1));
        if (y - uy) * dx <= (x - ux) * dy {
            (winding + sign, count + 1)
        } else {
            (winding, count)
        }
    })
}

/// The winding number and the number of sides at or left of the centre of a pixel.
pub fn crossings(contours: &[Vec<Units>], x: i32, y: i32) -> (i32, u32) {
    let at = (centre(x, ONE), centre(y, ONE));
    crossings_at(sides_at(contours, at.1).map(wide_side), at)
}

/// Is a place inside that has these crossings at or left of it?
pub fn is_inside(rule: FillRule, (winding, count): (i32, u32)) -> bool {
    match rule {
        FillRule::NonZero => winding != 0,
        FillRule::EvenOdd => count % 2 == 1,
    }
}

/// Is a place inside a polygon?
pub fn polygon_contains(contours: &[Vec<Units>], rule: FillRule, at: Units) -> bool {
    is_inside(rule, crossings_at(sides_at(contours, at.1.into()).map(wide_side), wide(at)))
}

/// The pixels of a polygon, pixel by pixel.
pub fn polygon(contours: &[Vec<Units>], rule: FillRule, window: Rect) -> Vec<Run> {
    // The same sides cross a whole row.
    let mut row = (None, vec![]);
    runs_where(window, |x, y| {
        let at = (centre(x, ONE), centre(y, ONE));
        if row.0 != Some(y) {
            row = (Some(y), sides_at(contours, at.1).collect());
        }
        is_inside(rule, crossings_at(row.1.iter().copied().map(wide_side), at))
    })
}

/// How many sides cross a row of a window, but for those that lie right of the centres of its last column as a whole. No place lies
/// in column 2^23 or beyond, so what a window shows there does not count.
pub fn sides_on_row(contours: &[Vec<Units>], window: Rect, y: i32) -> usize {
    let end = window.x1.min(1 << 23);
    if window.x0 >= end {
        return 0;
    }
    let last = centre(end - 1, ONE);
    sides_at(contours, centre(y, ONE)).filter(|(a, b)| i128::from(a.0.min(b.0)) <= last).count()
}

/// The pixels of a sub-pixel rectangle: left and top sides in, right and bottom sides out.
pub fn rectangle(a: Units, b: Units, window: Rect) -> Vec<Run> {
    let within = |c: i128, u: i32, v: i32| i128::from(u.min(v)) <= c && c < i128::from(u.max(v));
    runs_where(window, |x, y| within(centre(x, ONE), a.0, b.0) && within(centre(y, ONE), a.1, b.1))
}

/// Does the outline of a box of pixels have a pixel? Of those in the box, the ones beside a pixel that is not.
pub fn rectangle_outline_has(area: Rect, x: i32, y: i32) -> bool {
    let (x, y) = (i64::from(x), i64::from(y));
    let inside = |x: i64, y: i64| {
        i64::from(area.x0) <= x && x < i64::from(area.x1) && i64::from(area.y0) <= y && y < i64::from(area.y1)
    };
    inside(x, y) && [(-1, 0), (1, 0), (0, -1), (0, 1)].iter().any(|&(dx, dy)| !inside(x + dx, y + dy))
}

/// The pixels of a line that lie in a window, in the order of the line: after k steps along the longer axis
/// `m(k) = floor((2 k db + da) / (2 da))` along the other.
///
/// It walks the window's columns (or rows), not the line's, so that lines may be as long as they like.
pub fn line(a: (i32, i32), b: (i32, i32), window: Rect) -> Vec<(i32, i32)> {
    let (dx, dy) = (i128::from(b.0) - i128::from(a.0), i128::from(b.1) - i128::from(a.1));
    if dy.abs() > dx.abs() {
        // Steep: the same with the axes exchanged.
        let turned = Rect::new(window.y0, window.x0, window.y1, window.x1);
        return line((a.1, a.0), (b.1, b.0), turned).into_iter().map(|(y, x)| (x, y)).collect();
    }
    let (da, db) = (dx.abs(), dy.abs());
    let pixel = |x: i32| {
        let k = (i128::from(x) - i128::from(a.0)) * if dx < 0 { -1 } else { 1 };
        if k < 0 || k > da {
            return None;
        }
        let m = if da == 0 { 0 } else { (2 * k * db + da).div_euclid(2 * da) };
        let y = i128::from(a.1) + if dy < 0 { -m } else { m };
        (i128::from(window.y0) <= y && y < i128::from(window.y1)).then_some((x, y as i32))
    };
    let mut pixels: Vec<_> = (window.x0..window.x1).filter_map(pixel).collect();
    if dx < 0 {
        pixels.reverse();
    }
    pixels
}

/// Bresenham's loop itself, unclipped: the pixels and the decision before each step. `p` starts at `2 db - da`; at
/// `p >= 0` the minor axis steps.
pub fn bresenham(a: (i32, i32), b: (i32, i32)) -> (Vec<(i32, i32)>, Vec<i64>) {
    let (dx, dy) = (i64::from(b.0) - i64::from(a.0), i64::from(b.1) - i64::from(a.1));
    let (sx, sy) = (dx.signum() as i32, dy.signum() as i32);
    let (da, db) = (dx.abs().max(dy.abs()), dx.abs().min(dy.abs()));
    let (mut p, mut at) = (2 * db - da, a);
    let (mut pixels, mut decisions) = (vec![a], vec![]);
    for _ in 0..da {
        decisions.push(p);
        let minor = p >= 0;
        let (step_x, step_y) = if dy.abs() > dx.abs() { (minor, true) } else { (true, minor) };
        at = (at.0 + if step_x { sx } else { 0 }, at.1 + if step_y { sy } else { 0 });
        p += 2 * db - if minor { 2 * da } else { 0 };
        pixels.push(at);
    }
    (pixels, decisions)
}

/// A line by a digital differential analyser in 16.16: one rounded slope, added again and again. A reference for the
/// report on speed against error, *not* exact: the slope is off by up to half a unit and the error grows along the line.
pub fn dda(a: Point, b: Point) -> Vec<Point> {
    let (dx, dy) = (i64::from(b.x) - i64::from(a.x), i64::from(b.y) - i64::from(a.y));
    let n = dx.abs().max(dy.abs());
    let slope = |d: i64| if n == 0 { 0 } else { ((d << 17) + n).div_euclid(2 * n) };
    let (mut x, mut y) = ((i64::from(a.x) << 16) + 0x8000, (i64::from(a.y) << 16) + 0x8000);
    let mut pixels = vec![];
    for _ in 0..=n {
        pixels.push(Point::new((x >> 16) as i32, (y >> 16) as i32));
        (x, y) = (x + slope(dx), y + slope(dy));
    }
    pixels
}

/// A line by the textbook's first method: slope times distance, rounded, in `f32`. A reference for the same report.
pub fn slope_and_round(a: Point, b: Point) -> Vec<Point> {
    let (dx, dy) = (b.x.wrapping_sub(a.x), b.y.wrapping_sub(a.y));
    let n = dx.abs().max(dy.abs());
    let at = |k: i32, from: i32, d: i32| {
        let slope = if n == 0 { 0.0 } else { d as f32 / n as f32 };
        (from as f32 + k as f32 * slope).round() as i32
    };
    (0..=n).map(|k| Point::new(at(k, a.x, dx), at(k, a.y, dy))).collect()
}

/// Is the centre of a pixel inside the ellipse that touches the sides of a box, or on its curve? In half pixels
/// `h^2 u^2 <= w^2 (h^2 - v^2)`: both sides are below 2^128 for any box.
pub fn box_ellipse_has(area: Rect, x: i32, y: i32) -> bool {
    let from_middle =
        |at: i32, from: i32, to: i32| (2 * i64::from(at) + 1 - i64::from(from) - i64::from(to)).unsigned_abs();
    let (u, v) = (from_middle(x, area.x0, area.x1), from_middle(y, area.y0, area.y1));
    area.contains(x, y) && within((u, v), (area.width().into(), area.height().into())) != std::cmp::Ordering::Greater
}

/// Less: a place lies inside the ellipse with semi-axes a and b around the origin.
fn within((u, v): (u64, u64), (a, b): (u64, u64)) -> std::cmp::Ordering {
    let square = |n: u64| u128::from(n) * u128::from(n);
    if v > b || u > a {
        return std::cmp::Ordering::Greater;
    }
    (square(b) * square(u)).cmp(&(square(a) * (square(b) - square(v))))
}

/// Is the centre of a pixel inside an ellipse given in units, `per_pixel` to a pixel? On the curve: yes, if the ellipse's
/// centre is one of the grid, that is twice a whole pixel; else on its left half only.
pub fn ellipse_has(centre: (i64, i64), radii: (i64, i64), per_pixel: i64, x: i32, y: i32) -> bool {
    let u = i64::from(x) * per_pixel + per_pixel / 2 - centre.0;
    let v = i64::from(y) * per_pixel + per_pixel / 2 - centre.1;
    if radii.0 <= 0 || radii.1 <= 0 {
        return false;
    }
    match within((u.unsigned_abs(), v.unsigned_abs()), (radii.0.unsigned_abs(), radii.1.unsigned_abs())) {
        std::cmp::Ordering::Less => true,
        std::cmp::Ordering::Equal => u < 0 || 2 * centre.0 % per_pixel == 0 && 2 * centre.1 % per_pixel == 0,
        std::cmp::Ordering::Greater => false,
    }
}

/// Does the outline of the ellipse in a box have a pixel? Of the column through the pixel, is it nearest to where the curve
/// crosses, or of the row? Of two equally near pixels the outer one is.
pub fn outline_has(area: Rect, x: i32, y: i32) -> bool {
    if !area.contains(x, y) {
        return false;
    }
    let (a, b) = (u64::from(area.width()) - 1, u64::from(area.height()) - 1);
    let from_middle =
        |at: i32, from: i32, to: i32| (2 * i64::from(at) + 1 - i64::from(from) - i64::from(to)).unsigned_abs();
    let (u, v) = (from_middle(x, area.x0, area.x1), from_middle(y, area.y0, area.y1));
    let inside = |u: u64, v: u64| within((u, v), (a, b)) != std::cmp::Ordering::Greater;
    // The crossing lies at or outside of the midpoint to the next pixel inwards, and inside of that to the next outwards.
    let in_column = (v == 0 || inside(u, v - 1)) && !inside(u, v + 1);
    let in_row = (u == 0 || inside(u - 1, v)) && !inside(u + 1, v);
    in_column || in_row
}

/// The outline and what lies between its pixels on each row.
pub fn enclosed_has(area: Rect, x: i32, y: i32) -> bool {
    let (a, b) = (u64::from(area.width()).wrapping_sub(1), u64::from(area.height()).wrapping_sub(1));
    let from_middle =
        |at: i32, from: i32, to: i32| (2 * i64::from(at) + 1 - i64::from(from) - i64::from(to)).unsigned_abs();
    let (u, v) = (from_middle(x, area.x0, area.x1), from_middle(y, area.y0, area.y1));
    outline_has(area, x, y) || area.contains(x, y) && within((u, v), (a, b)) != std::cmp::Ordering::Greater
}
