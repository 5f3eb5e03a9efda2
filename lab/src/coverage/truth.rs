//! Exact areas: of polygons by the twin's ratios of wide integers, of all else in double precision, off by less than 2^-30.

use embedded_raster::FillRule;
use twins::coverage::{area, true_area, PIXEL};

use super::{outline::Outline, shape::Soft};
use crate::frame::{HEIGHT, WIDTH};

/// How much of each pixel of a box is covered, from 0 to 1.
#[expect(clippy::struct_field_names, reason = "areas are areas")]
pub(crate) struct Areas {
    pub(crate) x0: i32,
    pub(crate) y0: i32,
    pub(crate) width: i32,
    pub(crate) areas: Vec<f64>,
}

type Place = (f64, f64);

/// The box of some places on the screen: its first column and row, and how many it has.
#[expect(clippy::needless_pass_by_value, reason = "an iterator is copied for each axis")]
fn bounds(places: impl Iterator<Item = Place> + Clone) -> [i32; 4] {
    let ends = |of: fn(Place) -> f64, most: i32| {
        let low = places.clone().map(of).fold(f64::MAX, f64::min).floor().clamp(0.0, most.into()) as i32;
        let high = places.clone().map(of).fold(f64::MIN, f64::max).ceil().clamp(0.0, most.into()) as i32;
        (low, (high - low).max(0))
    };
    let ((x0, width), (y0, height)) = (ends(|p| p.0, WIDTH), ends(|p| p.1, HEIGHT));
    [x0, y0, width, height]
}

fn pixels((x, y): twins::Units) -> Place {
    (f64::from(x) / 256.0, f64::from(y) / 256.0)
}

/// The corners of the rectangle one pixel wide around a line.
pub(crate) fn around(a: Place, b: Place) -> [Place; 4] {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let half = 0.5 / dx.hypot(dy);
    let (x, y) = (-dy * half, dx * half);
    [(a.0 + x, a.1 + y), (b.0 + x, b.1 + y), (b.0 - x, b.1 - y), (a.0 - x, a.1 - y)]
}

/// Chords of a curve.
const CHORDS: u32 = 2_048;

fn chords(curves: &[[twins::Units; 4]]) -> Vec<Place> {
    let at = |curve: &[twins::Units; 4], i: u32| {
        let (p, t) = (curve.map(pixels), f64::from(i) / f64::from(CHORDS));
        let s = 1.0 - t;
        let weights = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
        let sum = |of: fn(Place) -> f64| weights.iter().zip(p).map(|(w, p)| w * of(p)).sum::<f64>();
        (sum(|p| p.0), sum(|p| p.1))
    };
    curves.iter().flat_map(|curve| (0..CHORDS).map(move |i| at(curve, i))).collect()
}

fn circle(centre: Place, radius: f64) -> Vec<Place> {
    let corners = 16 * CHORDS;
    // The corners lie so far outside that the area is that of the circle.
    let part = std::f64::consts::TAU / f64::from(corners);
    let radius = radius * (part / part.sin()).sqrt();
    (0..corners)
        .map(|i| f64::from(i) * part)
        .map(|t| (centre.0 + radius * t.cos(), centre.1 + radius * t.sin()))
        .collect()
}

impl Areas {
    pub(crate) fn of(shape: &Soft) -> Self {
        match &shape.outline {
            Outline::Polygon(contours) => {
                let places = contours.iter().flatten().copied().map(pixels);
                let [x0, y0, width, height] = bounds(places);
                let place = |i: i32| (x0 + i % width.max(1), y0 + i / width.max(1));
                // Sides of a triangle do not cross.
                let is_simple = contours.len() == 1 && contours[0].len() == 3;
                let area = if is_simple { area } else { true_area };
                let exact = |i| area(contours, shape.rule, place(i)) as f64 / PIXEL as f64;
                Self { x0, y0, width, areas: (0..width * height).map(exact).collect() }
            }
            &Outline::Circle(centre, radius) => {
                Self::sum(&circle(pixels(centre), f64::from(radius) / 256.0), shape.rule)
            }
            Outline::Curves(curves) => Self::sum(&chords(curves), shape.rule),
            &Outline::Line(a, b) => Self::sum(&around(pixels(a), pixels(b)), shape.rule),
        }
    }

    /// Of a closed contour: along each row, what its sides add up to.
    fn sum(contour: &[Place], rule: FillRule) -> Self {
        let [x0, y0, width, height] = bounds(contour.iter().copied());
        let row = width as usize + 2;
        let mut sums = vec![0.0; row * height as usize];
        for (i, &a) in contour.iter().enumerate() {
            let b = contour[(i + 1) % contour.len()];
            let inside = |p: Place| (p.0 - f64::from(x0), p.1 - f64::from(y0));
            side(&mut sums, row, inside(a), inside(b));
        }
        let mut areas = Vec::new();
        for row in sums.chunks_exact(row) {
            let mut sum = 0.0_f64;
            areas.extend(row[..width as usize].iter().map(|part| {
                sum += part;
                match rule {
                    FillRule::NonZero => sum.abs().min(1.0),
                    FillRule::EvenOdd => 1.0 - (sum.abs() % 2.0 - 1.0).abs(),
                }
            }));
        }
        Self { x0, y0, width, areas }
    }
}

/// Adds what lies right of a side, the differences from pixel to pixel.
fn side(sums: &mut [f64], row: usize, a: Place, b: Place) {
    let (a, b, winding) = if a.1 <= b.1 { (a, b, 1.0) } else { (b, a, -1.0) };
    let rows = (sums.len() / row) as f64;
    let (top, bottom) = (a.1.max(0.0), b.1.min(rows));
    if top >= bottom {
        return;
    }
    let slope = (b.0 - a.0) / (b.1 - a.1);
    let most = (row - 2) as f64;
    let mut y = top;
    while y < bottom {
        let end = (y.floor() + 1.0).min(bottom);
        let cells = &mut sums[y.floor() as usize * row..];
        let at = |y: f64| a.0 + (y - a.1) * slope;
        let (x0, x1) = (at(y).min(at(end)), at(y).max(at(end)));
        let height = winding * (end - y);
        // Pieces between borders of columns; what lies beside the box counts at its ends.
        let mut x = x0;
        loop {
            let next = if x1 - x0 > 0.0 { (x.floor() + 1.0).min(x1) } else { x1 };
            let part = if x1 - x0 > 0.0 { height * (next - x) / (x1 - x0) } else { height };
            let (left, right) = (x.clamp(0.0, most), next.clamp(0.0, most));
            let column = left.floor().min(most);
            let mean = left.midpoint(right) - column;
            cells[column as usize] += part * (1.0 - mean);
            cells[column as usize + 1] += part * mean;
            if next >= x1 {
                break;
            }
            x = next;
        }
        y = end;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Both ways to find areas, on polygons.
    #[test]
    fn sums_are_the_areas_of_wide_integers() {
        let mut rng = twins::rng::Rng::new(140);
        for _ in 0..200 {
            let corner = |rng: &mut twins::rng::Rng| (rng.int(500, 60_000), rng.int(500, 50_000));
            let corners = vec![corner(&mut rng), corner(&mut rng), corner(&mut rng)];
            let places: Vec<_> = corners.iter().copied().map(pixels).collect();
            let exact = Areas::of(&Soft::new(Outline::Polygon(vec![corners]), FillRule::NonZero));
            let sums = Areas::sum(&places, FillRule::NonZero);
            assert_eq!((exact.x0, exact.y0, exact.width), (sums.x0, sums.y0, sums.width));
            for (a, b) in exact.areas.iter().zip(&sums.areas) {
                assert!((a - b).abs() < 1e-9, "{a} and {b}");
            }
        }
    }

    #[test]
    fn circles_have_their_area() {
        let areas = Areas::of(&Soft::new(Outline::Circle((20_000, 15_000), 5_000), FillRule::NonZero));
        let (sum, radius): (f64, f64) = (areas.areas.iter().sum(), 5_000.0 / 256.0);
        assert!((sum - std::f64::consts::PI * radius * radius).abs() < 1e-6, "{sum}");
    }
}
