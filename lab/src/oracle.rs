//! The truth: which pixels a shape has, by the twins' rules in the lab's finer units, and how far what was painted is from
//! it. Slow on purpose; it shares no arithmetic with what is measured.

use embedded_raster::FillRule;
use twins::{
    curves::{bezier, distance},
    Place,
};

use crate::shape::{Units, ONE};

fn wide((x, y): Units) -> Place {
    (x.into(), y.into())
}

/// The centre of a pixel in units.
fn centre(pixel: i32) -> i128 {
    twins::centre(pixel, ONE.into())
}

/// A line from one pixel to another.
#[derive(Copy, Clone, Debug)]
pub(crate) struct TrueLine {
    a: (i128, i128),
    /// Along the longer axis, along the other.
    major: i128,
    minor: i128,
    steep: bool,
}

impl TrueLine {
    pub(crate) fn new(a: (i32, i32), b: (i32, i32)) -> Self {
        let (dx, dy) = (i128::from(b.0) - i128::from(a.0), i128::from(b.1) - i128::from(a.1));
        let steep = dy.abs() > dx.abs();
        let (major, minor) = if steep { (dy, dx) } else { (dx, dy) };
        Self { a: (a.0.into(), a.1.into()), major, minor, steep }
    }

    /// Steps along the major axis from the first end, and pixels along the minor axis from there.
    fn offsets(self, x: i32, y: i32) -> (i128, i128) {
        let (x, y) = (i128::from(x) - self.a.0, i128::from(y) - self.a.1);
        let (along, aside) = if self.steep { (y, x) } else { (x, y) };
        (if self.major < 0 { -along } else { along }, if self.minor < 0 { -aside } else { aside })
    }

    /// How far a pixel's centre is from the line along the minor axis, times the length of the line: `|m da - k db|`.
    fn distance_times_length(self, x: i32, y: i32) -> i128 {
        let (k, m) = self.offsets(x, y);
        (m * self.major.abs() - k * self.minor.abs()).abs()
    }

    /// How far a pixel's centre is from the line along the minor axis, in pixels.
    pub(crate) fn distance(self, x: i32, y: i32) -> f64 {
        self.distance_times_length(x, y) as f64 / self.major.abs().max(1) as f64
    }

    /// Is it between the ends and no further from the line than its neighbour on the other side? At a tie both are.
    pub(crate) fn is_nearest(self, x: i32, y: i32) -> bool {
        let (k, _) = self.offsets(x, y);
        0 <= k && k <= self.major.abs() && 2 * self.distance_times_length(x, y) <= self.major.abs()
    }

    /// The pixel in the same column (or row, if it is steep) one step aside.
    pub(crate) fn beside(self, (x, y): (i32, i32), step: i32) -> (i32, i32) {
        if self.steep {
            (x + step, y)
        } else {
            (x, y + step)
        }
    }
}

/// Is the centre of a pixel inside a triangle?
pub(crate) fn triangle_has(corners: [Units; 3], x: i32, y: i32) -> bool {
    twins::wide_triangle_has(corners.map(wide), ONE.into(), x, y)
}

/// The sides of a closed outline that cross the centres of a row.
pub(crate) fn sides_on_row(outline: &[Units], y: i32) -> Vec<(Place, Place)> {
    let sides = twins::sides_of(outline).map(|(a, b)| (wide(a), wide(b)));
    sides.filter(|&side| twins::crosses(side, centre(y))).collect()
}

/// Is the centre of pixel x inside by the even-odd rule?
pub(crate) fn polygon_has(sides_on_row: &[(Place, Place)], x: i32, y: i32) -> bool {
    let crossings = twins::crossings_at(sides_on_row.iter().copied(), (centre(x), centre(y)));
    twins::is_inside(FillRule::EvenOdd, crossings)
}

/// A cubic Bézier curve as chords in `f64`, so many that none is further than 1/5000 pixel from it. In pixels.
pub(crate) fn chords(points: [Units; 4]) -> Vec<(f64, f64)> {
    let [a, c, d, b] = points.map(|(x, y)| (x as f64 / ONE as f64, y as f64 / ONE as f64));
    // A chord of one n-th of the time is off by at most 3/4 of the larger second difference, divided by n^2.
    let bend = |p: (f64, f64), q: (f64, f64), r: (f64, f64)| (p.0 - 2.0 * q.0 + r.0).hypot(p.1 - 2.0 * q.1 + r.1);
    let n = (0.75 * 5_000.0 * bend(a, c, d).max(bend(c, d, b))).sqrt().ceil().max(1.0);
    (0..=n as u32).map(|i| bezier(vec![a, c, d, b], f64::from(i) / n)).collect()
}

/// How far a place is from the nearest of some lines.
pub(crate) fn distance_to<'a>(p: (f64, f64), lines: impl Iterator<Item = &'a [(f64, f64)]>) -> f64 {
    lines.map(|line| distance(p, line[0], line[1])).fold(f64::INFINITY, f64::min)
}

/// Where the centre of a pixel is, seen from the border of a shape.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Side {
    Outside,
    Border,
    Inside,
}

/// A line from the centre of one pixel to that of another, with a width in pixels: what is not further from it than half of
/// that. With round ends, or with none: only what lies between the ends.
pub(crate) fn stroke_has(a: (i32, i32), b: (i32, i32), width: u16, round: bool, x: i32, y: i32) -> Side {
    let wide = |p: (i32, i32)| (i128::from(p.0), i128::from(p.1));
    let (a, b, p) = (wide(a), wide(b), wide((x, y)));
    let (dx, dy, px, py) = (b.0 - a.0, b.1 - a.1, p.0 - a.0, p.1 - a.1);
    let (length, along) = (dx * dx + dy * dy, px * dx + py * dy);
    let width = i128::from(width) * i128::from(width);
    let side = |twice_distance: i128, width: i128| match twice_distance.cmp(&width) {
        std::cmp::Ordering::Less => Side::Inside,
        std::cmp::Ordering::Equal => Side::Border,
        std::cmp::Ordering::Greater => Side::Outside,
    };
    let disc = |qx: i128, qy: i128| side(4 * (qx * qx + qy * qy), width);
    let across = side(4 * (px * dy - py * dx).pow(2), width * length);
    match (round, along) {
        (true, n) if n < 0 => disc(px, py),
        (true, n) if n > length => disc(p.0 - b.0, p.1 - b.1),
        (false, n) if n < 0 || n > length => Side::Outside,
        (false, n) if n == 0 || n == length => across.min(Side::Border),
        _ => across,
    }
}

#[cfg(test)]
mod tests {
    use embedded_raster::Rect;

    use super::*;
    use crate::shape::BITS;

    /// Whole pixels to units.
    fn px((x, y): (i64, i64)) -> Units {
        (x << BITS, y << BITS)
    }

    fn picture(width: i32, height: i32, has: impl Fn(i32, i32) -> bool) -> Vec<String> {
        let row = |y| (0..width).map(|x| if has(x, y) { '#' } else { '.' }).collect();
        (0..height).map(row).collect()
    }

    #[test]
    fn the_worked_line() {
        let line = TrueLine::new((20, 41), (30, 44));
        let rows = [41, 41, 42, 42, 42, 43, 43, 43, 43, 44, 44];
        let wanted: Vec<_> = (20..).zip(rows).collect();
        assert_eq!(twins::line((20, 41), (30, 44), Rect::new(0, 0, 99, 99)), wanted);
        assert!(wanted.iter().all(|&(x, y)| line.is_nearest(x, y)), "a chosen pixel is a nearest one");
        // Half a pixel from both at step 5: a tie.
        assert!(line.is_nearest(25, 42) && line.is_nearest(25, 43), "a tie has two nearest pixels");
        assert!((line.distance(25, 42) - 0.5).abs() < 1e-12, "and both are half a pixel away");
        assert!(!line.is_nearest(19, 41) && !line.is_nearest(31, 44), "nothing beyond the ends");
        assert_eq!(twins::line((20, 41), (30, 44), Rect::new(0, 0, 99, 42)), wanted[..2], "nor beyond the window");
    }

    #[test]
    fn lines_in_all_directions_have_one_pixel_a_step() {
        for (dx, dy) in [(9, 4), (4, 9), (-9, 4), (-4, 9), (9, -4), (4, -9), (-9, -4), (-4, -9), (7, 7), (0, 5), (5, 0)]
        {
            let (a, b) = ((20, 20), (20 + dx, 20 + dy));
            let line = TrueLine::new(a, b);
            let pixels = twins::line(a, b, Rect::new(0, 0, 40, 40));
            assert_eq!(pixels.len() as i32, dx.abs().max(dy.abs()) + 1, "({dx}, {dy})");
            assert!(pixels.contains(&a) && pixels.contains(&b), "both ends of ({dx}, {dy})");
            assert!(pixels.iter().all(|&(x, y)| line.is_nearest(x, y)), "({dx}, {dy})");
        }
    }

    #[test]
    fn centres_on_the_slope_are_out() {
        let corners = [(0, 0), (4, 0), (0, 4)].map(px);
        let wanted = ["###..", "##...", "#....", "....."];
        assert_eq!(picture(5, 4, |x, y| triangle_has(corners, x, y)), wanted);
        let [a, b, c] = corners;
        assert_eq!(picture(5, 4, |x, y| triangle_has([a, c, b], x, y)), wanted, "in either winding");
    }

    #[test]
    fn two_triangles_share_their_edge() {
        let [a, b, c, d] = [(0, 0), (4, 0), (4, 4), (0, 4)].map(px);
        for y in 0..5 {
            for x in 0..5 {
                let hits = [[a, b, c], [c, d, a]].iter().filter(|t| triangle_has(**t, x, y)).count();
                assert_eq!(hits == 1, x < 4 && y < 4, "({x}, {y})");
            }
        }
    }

    #[test]
    fn a_polygon_of_three_is_a_triangle() {
        for [a, b, c] in [[(1, 1), (7, 2), (3, 6)], [(0, 0), (8, 0), (0, 8)], [(2, 7), (6, 1), (5, 7)]] {
            let corners = [a, b, c].map(px);
            for y in 0..9 {
                let sides = sides_on_row(&corners, y);
                for x in 0..9 {
                    assert_eq!(polygon_has(&sides, x, y), triangle_has(corners, x, y), "({x}, {y})");
                }
            }
        }
    }

    #[test]
    fn chords_lie_on_a_straight_curve_and_end_where_it_does() {
        let line = chords([(0, 0), (2, 1), (4, 2), (6, 3)].map(px));
        assert_eq!(line, [(0.0, 0.0), (6.0, 3.0)]);
        let arch = chords([(0, 0), (0, 4), (6, 4), (6, 0)].map(px));
        assert_eq!(arch.last(), Some(&(6.0, 0.0)));
        assert!((distance_to((3.0, 2.0), arch.windows(2)) - 1.0).abs() < 1e-3, "the top of the arch is at (3, 3)");
    }

    #[test]
    fn a_stroke_is_as_wide_as_it_says() {
        let rows = |round: bool| {
            picture(9, 5, |x, y| match stroke_has((2, 2), (6, 2), 4, round, x, y) {
                Side::Inside => true,
                Side::Border => x % 2 == 0,
                Side::Outside => false,
            })
        };
        assert_eq!(rows(false), ["..#.#.#..", "..#####..", "..#####..", "..#####..", "..#.#.#.."], "butt");
        assert_eq!(rows(true), ["..#.#.#..", ".#######.", "#########", ".#######.", "..#.#.#.."], "round");
    }

    #[test]
    fn a_polygon_that_crosses_itself_has_holes() {
        let bow = [(0, 0), (6, 6), (6, 0), (0, 6)].map(px);
        // Centres on the diagonals belong to what lies right of them.
        let wanted = [".....#", "#...##", "##.###", "##.###", "#...##", ".....#"];
        assert_eq!(picture(6, 6, |x, y| polygon_has(&sides_on_row(&bow, y), x, y)), wanted);
    }
}
