//! Coverage of shapes that are not polygons: round shapes against areas under their curves, rectangles against polygons, the
//! brightness of lines.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "areas under curves are computed in floating point"
)]

use embedded_raster::{
    raster::coverage::{self, CoverageSlot},
    Angle, ClippedSpan, Ellipse, FillRule, PointFx, Radii, Rect, Sector, Stroke,
};
use fixed::types::I24F8;
use twins::{
    coverage::Levels,
    rng::{cases, Rng},
};

fn told(window: Rect, shape: impl FnOnce(&mut [CoverageSlot], &mut [i32], &mut Levels)) -> Levels {
    let mut levels = Levels::new(window);
    shape(&mut [CoverageSlot::EMPTY; 64], &mut [0; 200], &mut levels);
    levels
}

fn sum(levels: &Levels) -> f64 {
    levels.levels.iter().map(|&level| f64::from(level) / 255.0).sum()
}

#[test]
fn rectangles_are_polygons() {
    let mut rng = Rng::new(1_500);
    for _ in 0..cases(4_000) {
        let reach = rng.pick(&[300, 2_000, 6_000, i32::MAX]);
        let mut place = || (rng.int(-reach, reach), rng.int(-reach, reach));
        let ((ax, ay), (bx, by)) = (place(), place());
        let window = Rect::new(-11, -9, 12, 10);
        let [a, b] = [(ax, ay), (bx, by)].map(|(x, y)| PointFx::from_bits(x, y));
        let rectangle = told(window, |_, _, levels| coverage::rectangle(a, b, window, levels));
        let corners = [(ax, ay), (bx, ay), (bx, by), (ax, by)].map(|(x, y)| PointFx::from_bits(x, y));
        let polygon = told(window, |table, cells, levels| {
            coverage::fill([corners], FillRule::NonZero, table, cells, window, levels).expect("enough slots");
        });
        assert!(rectangle.levels == polygon.levels, "{a:?} {b:?}\n{}\n{}", rectangle.picture(), polygon.picture());
    }
}

/// How much of a pixel an ellipse covers: the integral of its half width, which is an area under a circle.
fn covered_by_ellipse((cx, cy): (f64, f64), (rx, ry): (f64, f64), (x, y): (i32, i32)) -> f64 {
    // What lies between the centre and a height.
    let below = |v: f64| {
        let t = (v / ry).min(1.0);
        rx * ry / 2.0 * (t * (1.0 - t * t).max(0.0).sqrt() + t.asin())
    };
    // What lies between the centre and a place, with the sign that its quarter of the plane has.
    let corner = |u: f64, v: f64| {
        let (x, y) = (u.abs().min(rx), v.abs().min(ry));
        let height = ry * (1.0 - (x / rx).powi(2)).max(0.0).sqrt();
        let area = if y <= height { x * y } else { x * height + below(y) - below(height) };
        area * u.signum() * v.signum()
    };
    let (left, top) = (f64::from(x) - cx, f64::from(y) - cy);
    let (right, bottom) = (left + 1.0, top + 1.0);
    corner(right, bottom) - corner(left, bottom) - corner(right, top) + corner(left, top)
}

#[test]
fn ellipses_cover_what_lies_in_their_curves() {
    let (mut rng, mut worst) = (Rng::new(1_510), 0.0_f64);
    for i in 0..cases(600) {
        let reach = rng.pick(&[800, 3_000, 9_000, 40_000]);
        let centre = (rng.int(-2_000, 2_000), rng.int(-2_000, 2_000));
        let radii = (rng.int(1, reach), if i % 2 == 0 { rng.int(1, reach) } else { reach });
        let radii = if i % 3 == 0 { (reach, reach) } else { radii };
        let window = Rect::new(-15, -15, 16, 16);
        // In a box of whole pixels now and then.
        let units = |n: i32| f64::from(n) / 256.0;
        let (ellipse, middle, half) = if i % 5 == 0 {
            let (w, h) = (rng.int(1, 30), rng.int(1, 30));
            let area = Rect::new(-14, -12, w - 14, h - 12);
            let half = (f64::from(w) / 2.0, f64::from(h) / 2.0);
            (Ellipse::in_box(area), (half.0 - 14.0, half.1 - 12.0), half)
        } else {
            let ellipse = Ellipse::new(
                PointFx::from_bits(centre.0, centre.1),
                I24F8::from_bits(radii.0),
                I24F8::from_bits(radii.1),
            );
            (ellipse, (units(centre.0), units(centre.1)), (units(radii.0), units(radii.1)))
        };
        let draw =
            |ellipse: Ellipse, window: Rect| told(window, |_, _, levels| coverage::ellipse(ellipse, window, levels));
        let got = draw(ellipse, window);
        // In parts, and upside down.
        let inner = Rect::new(rng.int(-15, 0), rng.int(-15, 0), rng.int(1, 16), rng.int(1, 16));
        let part = draw(ellipse, inner);
        let turned = (i % 5 != 0).then(|| {
            let centre = PointFx::from_bits(256 - centre.0, 256 - centre.1);
            draw(Ellipse::new(centre, I24F8::from_bits(radii.0), I24F8::from_bits(radii.1)), window)
        });
        for (x, y) in (-15..16).flat_map(|y| (-15..16).map(move |x| (x, y))) {
            let error = f64::from(got.at(x, y)) - covered_by_ellipse(middle, half, (x, y)) * 255.0;
            worst = worst.max(error.abs());
            assert!(error.abs() <= 1.6, "{error} of a 255th at ({x}, {y}): {ellipse:?}");
            assert!(!inner.contains(x, y) || part.at(x, y) == got.at(x, y), "({x}, {y}) of {ellipse:?} in {inner:?}");
            let is_same = turned.as_ref().is_none_or(|turned| turned.at(-x, -y) == got.at(x, y));
            assert!(is_same, "({x}, {y}) of {ellipse:?} upside down");
        }
    }
    println!("ellipses are at most {worst} 255ths off");
}

/// The same for radii of any size: of 512 slices of the pixel, along the axis that the curve goes along, the parts that lie inside. Nothing
/// cancels out that is as large as the radii.
fn covered_by_large_ellipse(centre: (f64, f64), radii: (f64, f64), (x, y): (i32, i32)) -> f64 {
    const SLICES: i32 = 512;
    let (left, top) = (f64::from(x) - centre.0, f64::from(y) - centre.1);
    let slope = (left + 0.5).abs() * radii.1 * radii.1 - (top + 0.5).abs() * radii.0 * radii.0;
    let ((along, across), (r, other)) =
        if slope < 0.0 { ((left, top), (radii.0, radii.1)) } else { ((top, left), (radii.1, radii.0)) };
    let slice = |i: i32| {
        let t = (along + (f64::from(i) + 0.5) / f64::from(SLICES)) / r;
        if t.abs() >= 1.0 {
            return 0.0;
        }
        let half = other * ((1.0 - t) * (1.0 + t)).sqrt();
        ((across + 1.0).min(half) - across.max(-half)).max(0.0)
    };
    (0..SLICES).map(slice).sum::<f64>() / f64::from(SLICES)
}

/// At any place of the curve, of circles, and of ellipses as thin as they may be.
#[test]
fn ellipses_of_all_radii_cover_what_lies_in_their_curves() {
    let (mut rng, mut worst) = (Rng::new(1_511), [0.0_f64; 32]);
    for i in 0..cases(4_000) {
        let bits = rng.int(12, 31);
        let large = rng.int(1 << (bits - 1), i32::MAX >> (31 - bits));
        let thin = rng.int(1, 15);
        let small = [large, rng.int(1, large), 1 << rng.int(0, bits - 1), rng.int(1, 4_000).min(large), thin][i % 5];
        let radii = if i % 10 < 5 { (large, small) } else { (small, large) };
        let centre = (rng.int(-5_000, 5_000), rng.int(-5_000, 5_000));
        let ellipse =
            Ellipse::new(PointFx::from_bits(centre.0, centre.1), I24F8::from_bits(radii.0), I24F8::from_bits(radii.1));
        let units = |n: i32| f64::from(n) / 256.0;
        let (middle, half) = ((units(centre.0), units(centre.1)), (units(radii.0), units(radii.1)));
        let (window, _) = somewhere_on(&mut rng, middle, half, i / 10);
        let got = told(window, |_, _, levels| coverage::ellipse(ellipse, window, levels));
        for (x, y) in (window.y0..window.y1).flat_map(|y| (window.x0..window.x1).map(move |x| (x, y))) {
            let wanted = covered_by_large_ellipse(middle, half, (x, y)) * 255.0;
            let error = (f64::from(got.at(x, y)) - wanted).abs();
            let worst = &mut worst[bits as usize];
            *worst = worst.max(error);
        }
    }
    println!("ellipses are at most so many 255ths off, by the bits of the larger radius: {worst:?}");
    assert!(worst[..=26].iter().all(|&worst| worst <= 1.6), "{worst:?}");
    assert!(worst[..=30].iter().all(|&worst| worst <= 2.5) && worst[31] <= 4.5, "{worst:?}");
}

/// Thinner than the steps that the largest radii are measured in: the pixel of the centre is covered as little as those beside it.
#[test]
fn the_thinnest_ellipses_are_thin_in_the_middle() {
    let window = Rect::new(-8, -8, 9, 9);
    for (long, thin) in [(1 << 30, 1), (1_248_605_466, 2), (i32::MAX, 3), (i32::MAX, 7), (1 << 28, 1), (1 << 20, 1)] {
        for (rx, ry) in [(long, thin), (thin, long)] {
            let middle = PointFx::from_bits(45, 106);
            let ellipse = Ellipse::new(middle, I24F8::from_bits(rx), I24F8::from_bits(ry));
            let got = told(window, |_, _, levels| coverage::ellipse(ellipse, window, levels));
            let most = got.levels.iter().max().copied().unwrap_or(0);
            assert!(i32::from(most) <= 2 * thin + 4, "{ellipse:?}\n{}", got.picture());
        }
    }
}

/// Boxes as large as the type allows: the middle is full, also up to the ends of the axes, and the corners are empty.
#[test]
fn ellipses_in_endless_boxes_have_a_middle_and_corners() {
    let (low, high) = (i32::MIN, i32::MAX);
    let boxes = [Rect::new(low, low, high, high), Rect::new(low, -9, high, 9), Rect::new(-9, low, 9, high)];
    let boxes = boxes.into_iter().chain([Rect::new(low, low, 0, high), Rect::new(-3, 5, high, high)]);
    for area in boxes {
        let level = |x: i32, y: i32| {
            let window = Rect::new(x, y, x + 1, y + 1);
            told(window, |_, _, levels| coverage::ellipse(Ellipse::in_box(area), window, levels)).levels[0]
        };
        let middle = |a: i32, b: i32| i64::midpoint(a.into(), b.into()) as i32;
        let (x, y) = (middle(area.x0, area.x1), middle(area.y0, area.y1));
        // The ends of a thin one are not full.
        let inset = if area.width().min(area.height()) < 99 { 1 << 29 } else { 3 };
        let [left, right] = [area.x0.saturating_add(inset).min(x), area.x1.saturating_sub(inset + 1).max(x)];
        let [top, bottom] = [area.y0.saturating_add(inset).min(y), area.y1.saturating_sub(inset + 1).max(y)];
        for (x, y) in [(x, y), (left, y), (right, y), (x, top), (x, bottom)] {
            assert_eq!(level(x, y), 255, "({x}, {y}) in {area:?}");
        }
        for (x, y) in [(area.x0, area.y0), (area.x1 - 1, area.y0), (area.x0, area.y1 - 1), (area.x1 - 1, area.y1 - 1)] {
            assert_eq!(level(x, y), 0, "({x}, {y}) in {area:?}");
        }
    }
}

/// A place of a curve, and a window around it: anywhere, or near one of the ends of an axis. With the direction in which it lies.
fn somewhere_on(rng: &mut Rng, centre: (f64, f64), radii: (f64, f64), kind: usize) -> (Rect, f64) {
    let quarter = f64::from(rng.int(0, 4)) * std::f64::consts::FRAC_PI_2;
    let angle = match kind % 3 {
        0 => quarter,
        1 => quarter + f64::from(rng.int(-1_000, 1_000)) / 1e6,
        _ => f64::from(rng.int(0, 62_832)) / 1e4,
    };
    let (x, y) = ((centre.0 + radii.0 * angle.cos()) as i32, (centre.1 + radii.1 * angle.sin()) as i32);
    let (right, down) = (rng.int(0, 16), rng.int(0, 16));
    (Rect::new(x - right, y - down, x - right + 16, y - down + 16), angle)
}

/// Rings of any width, sectors and sectors of rings around their arcs, rounded boxes. A disc and a ring around it add up.
#[test]
fn arcs_of_all_radii_are_near_their_curves() {
    let (mut rng, mut worst) = (Rng::new(1_512), [[0.0_f64; 32]; 5]);
    let names = ["disc", "ring", "sector", "sector of a ring", "rounded box"];
    for i in 0..cases(1_500) {
        let bits = rng.int(11, 30);
        let large = rng.int(1 << (bits - 1), (1 << bits) - 1);
        let radii = match i % 4 {
            0 | 1 => (large, large),
            2 => (large, rng.int(large / 9, large)),
            _ => (rng.int(large / 9, large), large),
        };
        // Thin ones, of less than a pixel, and wide ones.
        let width = rng.pick(&[40, 130, 300, 900]).min(radii.0.min(radii.1) - 8);
        let width = if rng.one_in(3) { radii.0.min(radii.1) / 2 } else { width };
        let inner = (radii.0 - width, radii.1 - width);
        let centre = (rng.int(-5_000, 5_000), rng.int(-5_000, 5_000));
        let ellipse = |(rx, ry): (i32, i32)| {
            Ellipse::new(PointFx::from_bits(centre.0, centre.1), I24F8::from_bits(rx), I24F8::from_bits(ry))
        };
        let (outer, inside) = (ellipse(radii), ellipse(inner));
        let units = |(x, y): (i32, i32)| (f64::from(x) / 256.0, f64::from(y) / 256.0);
        let (window, angle) =
            somewhere_on(&mut rng, units(centre), units(if i % 3 == 0 { inner } else { radii }), i / 4);
        let at = |away: f64| Angle::from_bits(((angle + away) / std::f64::consts::TAU * 4_294_967_296.0) as i64 as u32);
        // The arc is long enough to reach beyond the window, and ends elsewhere.
        let away = 64.0 / f64::from(radii.0.min(radii.1)) * 256.0;
        let ends = (away + f64::from(rng.int(0, 900)) / 1e3, away + f64::from(rng.int(0, 900)) / 1e3);
        let round = radii.0 == radii.1 && ends.0 < 1.5 && ends.1 < 1.5 && inner.0 > 64 * 256;
        let sector = Sector::new(at(-ends.0), at(ends.1));
        let disc = told(window, |_, _, levels| coverage::ellipse(inside, window, levels));
        let ring = told(window, |_, _, levels| coverage::ring(outer, inside, window, levels));
        let slice = told(window, |table, cells, levels| {
            coverage::sector(outer, sector, table, cells, window, levels).expect("enough slots");
        });
        let part = told(window, |table, cells, levels| {
            coverage::ring_sector(outer, inside, sector, (table, cells), window, levels).expect("enough slots");
        });
        // A box that is all corners.
        let pixels = (radii.0.max(radii.1) >> 8).max(1);
        let round_box = Rect::new(-pixels, -pixels, pixels, pixels);
        let reach = f64::from(pixels);
        let (around, _) = somewhere_on(&mut rng, (0.0, 0.0), (reach, reach), i / 4);
        let rounded = told(around, |table, cells, levels| {
            let radius = Radii::all(pixels as u32);
            coverage::rounded(round_box, radius, table, cells, around, levels).expect("enough slots");
        });
        for (x, y) in (around.y0..around.y1).flat_map(|y| (around.x0..around.x1).map(move |x| (x, y))) {
            let wanted = covered_by_large_ellipse((0.0, 0.0), (reach, reach), (x, y)) * 255.0;
            let worst = &mut worst[4][bits as usize];
            *worst = worst.max((f64::from(rounded.at(x, y)) - wanted).abs());
        }
        for (x, y) in (window.y0..window.y1).flat_map(|y| (window.x0..window.x1).map(move |x| (x, y))) {
            let covered = |radii: (i32, i32)| covered_by_large_ellipse(units(centre), units(radii), (x, y)) * 255.0;
            let (all, hole) = (covered(radii), covered(inner));
            let found = [
                (disc.at(x, y), hole),
                (ring.at(x, y), all - hole),
                (slice.at(x, y), if round { all } else { slice.at(x, y).into() }),
                (part.at(x, y), if round { all - hole } else { part.at(x, y).into() }),
            ];
            for (kind, (level, wanted)) in found.into_iter().enumerate() {
                let error = (f64::from(level) - wanted).abs();
                worst[kind][bits as usize] = worst[kind][bits as usize].max(error);
            }
            if all > 254.99 && hole > 0.01 {
                let sum = u32::from(disc.at(x, y)) + u32::from(ring.at(x, y));
                assert!((254..=256).contains(&sum), "{sum} at ({x}, {y}): {radii:?}, {inner:?} at {centre:?}");
            }
        }
    }
    for (name, worst) in names.iter().zip(worst) {
        println!("{name} are at most so many 255ths off, by the bits of the radius: {:.2?}", &worst[11..]);
    }
    assert!(worst.as_flattened().iter().all(|&worst| worst <= 4.5), "{worst:?}");
}

#[test]
fn rounded_rectangles_cover_their_area() {
    let window = Rect::new(-2, -2, 60, 50);
    for radius in 0..18 {
        let area = Rect::new(3, 4, 52, 41);
        let got = told(window, |table, cells, levels| {
            coverage::rounded(area, Radii::all(radius), table, cells, window, levels).expect("enough slots");
        });
        let corners = (4.0 - std::f64::consts::PI) * f64::from(radius * radius);
        let wanted = 49.0 * 37.0 - corners;
        // Chords lie inside of the arcs: at most 2.7 units, 2/3 of that on average, along a whole circle.
        let chords = std::f64::consts::TAU * f64::from(radius) * 2.7 / 256.0 * 2.0 / 3.0;
        assert!((sum(&got) - wanted).abs() < 0.1 + chords, "{radius}: {} for {wanted}", sum(&got));
        for (x, y) in (4..41).flat_map(|y| (3..52).map(move |x| (x, y))) {
            let mirrored = [(54 - x, y), (x, 44 - y)];
            assert!(mirrored.iter().all(|&(u, v)| got.at(x, y).abs_diff(got.at(u, v)) <= 2), "{radius}: ({x}, {y})");
        }
    }
}

/// What is left of a polygon on one side of a line: where its value is not negative.
fn cut(shape: &[[f64; 2]], value: impl Fn([f64; 2]) -> f64) -> Vec<[f64; 2]> {
    let mut left = Vec::new();
    for (i, &to) in shape.iter().enumerate() {
        let from = shape[(i + shape.len() - 1) % shape.len()];
        let (u, v) = (value(from), value(to));
        if (u < 0.0) != (v < 0.0) {
            left.push([0, 1].map(|k| from[k] + (to[k] - from[k]) * u / (u - v)));
        }
        if v >= 0.0 {
            left.push(to);
        }
    }
    left
}

/// How much of a pixel the line from a to b covers, places in units from its centre: a rectangle one pixel wide, without any rounding
/// of its corners.
fn covered_by_line(a: (i128, i128), b: (i128, i128)) -> f64 {
    let length = ((b.0 - a.0) as f64).hypot((b.1 - a.1) as f64);
    // Whole numbers until the division: nothing cancels out.
    let across = ((b.0 - a.0) * -a.1 - (b.1 - a.1) * -a.0) as f64 / length / 256.0;
    let along = |end: (i128, i128)| ((b.0 - a.0) * -end.0 + (b.1 - a.1) * -end.1) as f64 / length / 256.0;
    let (cos, sin) = ((b.0 - a.0) as f64 / length, (b.1 - a.1) as f64 / length);
    let beside = |[x, y]: [f64; 2]| across + cos * y - sin * x;
    let (behind, before) = (along(a), along(b));
    let mut shape = vec![[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]];
    shape = cut(&shape, |p| 0.5 + beside(p));
    shape = cut(&shape, |p| 0.5 - beside(p));
    shape = cut(&shape, |[x, y]| behind + cos * x + sin * y);
    shape = cut(&shape, |[x, y]| -(before + cos * x + sin * y));
    let product = |i: usize| {
        let (p, q) = (shape[i], shape[(i + 1) % shape.len()]);
        p[0] * q[1] - q[0] * p[1]
    };
    (0..shape.len()).map(product).sum::<f64>() / 2.0
}

/// Levels of lines against areas, and the same levels in any window.
#[test]
fn lines_are_rectangles_one_pixel_wide() {
    let mut rng = Rng::new(1_519);
    let (mut worst, mut nearest, mut pixels) = (0.0_f64, 0_u32, 0_u32);
    for case in 0..cases(6_000) {
        let reach = rng.pick(&[40, 300, 900, 3_000, 30_000, 8_000_000, i32::MAX]);
        let mut place = || (rng.int(-reach, reach), rng.int(-reach, reach));
        let (a, mut b) = (place(), place());
        match case % 8 {
            0 => b.0 = a.0,
            1 => b.1 = a.1,
            2 => b.0 = a.0.saturating_add(rng.int(-9, 9)),
            3 => b.1 = a.1.saturating_add(rng.int(-9, 9)),
            _ => {}
        }
        // Around a place of the line that may be far from its ends.
        let part = rng.int(0, 1 << 10);
        let at =
            |a: i32, b: i32| ((i64::from(a) + (i64::from(b) - i64::from(a)) * i64::from(part) / 1_024) >> 8) as i32;
        let (x, y) = (at(a.0, b.0), at(a.1, b.1));
        let window = Rect::new(x - rng.int(0, 20), y - rng.int(0, 20), x + rng.int(1, 20), y + rng.int(1, 20));
        let [p, q] = [a, b].map(|(x, y)| PointFx::from_bits(x, y));
        let got = told(window, |_, _, levels| coverage::line(p, q, window, levels));
        let inner =
            Rect::new(window.x0 + rng.int(0, 9), window.y0 + rng.int(0, 9), window.x1 - rng.int(0, 9), window.y1);
        let part = told(inner, |_, _, levels| coverage::line(p, q, inner, levels));
        for (x, y) in (window.y0..window.y1).flat_map(|y| (window.x0..window.x1).map(move |x| (x, y))) {
            let from_centre = |(px, py): (i32, i32)| {
                (i128::from(px) - i128::from(x) * 256 - 128, i128::from(py) - i128::from(y) * 256 - 128)
            };
            let wanted = if a == b { 0.0 } else { 255.0 * covered_by_line(from_centre(a), from_centre(b)) };
            let level = got.at(x, y);
            let off = (f64::from(level) - wanted).abs();
            assert!(off < 0.51, "{a:?} {b:?} at ({x}, {y}): {level} for {wanted}\n{}", got.picture());
            worst = worst.max(off);
            if wanted > 0.0 {
                pixels += 1;
                nearest += u32::from(off <= 0.5);
            }
            if inner.contains(x, y) {
                assert_eq!(part.at(x, y), level, "{a:?} {b:?} at ({x}, {y}) in {inner:?} and in {window:?}");
            }
        }
    }
    println!("lines: at most {worst} off, {} of {pixels} not the nearest", pixels - nearest);
    assert!(f64::from(nearest) > 0.997 * f64::from(pixels), "{nearest} of {pixels}");
}

/// The sum over what a line covers is its length, at any angle and wherever it lies: it is as bright everywhere.
#[test]
fn lines_are_as_bright_at_any_angle() {
    let mut rng = Rng::new(1_520);
    let window = Rect::new(0, 0, 130, 130);
    let (mut low, mut high) = (f64::MAX, 0.0_f64);
    for degrees in 0..360 {
        for _ in 0..4 {
            let (x, y) = (rng.int(64 * 256, 66 * 256), rng.int(64 * 256, 66 * 256));
            let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
            let away = |n: f64| (n * 60.0 * 256.0).round() as i32;
            let ends = [(x, y), (x + away(cos), y + away(sin))];
            let [a, b] = ends.map(|(x, y)| PointFx::from_bits(x, y));
            let length = f64::from(ends[1].0 - x).hypot(f64::from(ends[1].1 - y)) / 256.0;
            let got = told(window, |_, _, levels| coverage::line(a, b, window, levels));
            let brightness = sum(&got) / length;
            (low, high) = (low.min(brightness), high.max(brightness));
            let back = told(window, |_, _, levels| coverage::line(b, a, window, levels));
            assert!(got.levels == back.levels, "{degrees} degrees, and back");
        }
    }
    println!("lines have a brightness from {low} to {high}");
    assert!(low > 0.99 && high < 1.01, "{low} to {high}");
}

#[test]
fn lines_end_where_they_are_told() {
    let window = Rect::new(0, 0, 8, 3);
    let line = |ax, bx, y| {
        let [a, b] = [PointFx::from_bits(ax, y), PointFx::from_bits(bx, y)];
        told(window, |_, _, levels| coverage::line(a, b, window, levels)).levels
    };
    let row = [0, 128, 255, 255, 64, 0, 0, 0];
    assert_eq!(line(384, 1_088, 384), [&[0; 8][..], &row, &[0; 8]].concat());
    assert_eq!(line(1_088, 384, 384), [&[0; 8][..], &row, &[0; 8]].concat());
    assert_eq!(line(400, 400, 384), [0; 24], "a line of no length");
}

#[test]
fn strokes_of_lines_are_rectangles() {
    let window = Rect::new(0, 0, 20, 12);
    let ends = [PointFx::from_bits(600, 1_500), PointFx::from_bits(4_200, 1_500)];
    let stroke = told(window, |table, cells, levels| {
        let stroke = Stroke::px(3);
        coverage::stroke_polyline(&ends, false, &stroke, (table, cells), window, levels).expect("enough slots");
    });
    let [a, b] = [PointFx::from_bits(600, 1_500 - 384), PointFx::from_bits(4_200, 1_500 + 384)];
    let rectangle = told(window, |_, _, levels| coverage::rectangle(a, b, window, levels));
    assert!(stroke.levels == rectangle.levels, "{}\n{}", stroke.picture(), rectangle.picture());
}

/// How much of a pixel lies in an ellipse and in a sector around its centre, from one angle clockwise up to another: 32 x 32 samples.
fn covered_by_sector(centre: (f64, f64), radii: (f64, f64), (from, to): (f64, f64), (x, y): (i32, i32)) -> f64 {
    let turn = std::f64::consts::TAU;
    let inside = |i: i32, j: i32| {
        let place = |pixel: i32, part: i32, middle: f64| f64::from(pixel) + (f64::from(part) + 0.5) / 32.0 - middle;
        let (u, v) = (place(x, i, centre.0), place(y, j, centre.1));
        (u / radii.0).hypot(v / radii.1) < 1.0 && (v.atan2(u) - from).rem_euclid(turn) < (to - from).rem_euclid(turn)
    };
    let all = (0..32 * 32).filter(|n| inside(n % 32, n / 32)).count();
    all as f64 / 1024.0
}

#[test]
fn sectors_and_rings_cover_what_lies_in_them() {
    let (mut rng, window) = (Rng::new(1_530), Rect::new(-15, -15, 16, 16));
    let mut worst = 0.0_f64;
    for i in 0..cases(60) {
        let centre = (rng.int(-1_500, 1_500), rng.int(-1_500, 1_500));
        let reach = rng.pick(&[1_500, 4_000, 9_000, 200_000]);
        let rx = rng.int(reach / 3, reach);
        let ry = if i % 3 == 0 { rng.int(reach / 3, reach) } else { rx };
        // Quarters and eighths, where curves end, and a turn less a little; and any others.
        let eighth = |rng: &mut Rng| Angle::turns(rng.below(8) as u32, 8);
        let from = if i % 2 == 0 { eighth(&mut rng) } else { Angle::from_bits(rng.bits() as u32) };
        let to = match i % 5 {
            0 => from + Angle::from_bits(rng.pick(&[1 << 10, 1 << 20, 1 << 31, (1 << 31) + 5, u32::MAX - 900])),
            1 | 2 => eighth(&mut rng),
            _ => Angle::from_bits(rng.bits() as u32),
        };
        let ellipse = |shrink: i32| {
            let radius = |r: i32| I24F8::from_bits(r / shrink);
            Ellipse::new(PointFx::from_bits(centre.0, centre.1), radius(rx), radius(ry))
        };
        let units = |n: i32| f64::from(n) / 256.0;
        let (middle, radii) = ((units(centre.0), units(centre.1)), (units(rx), units(ry)));
        let turns = |angle: Angle| f64::from(angle.to_bits()) / 4_294_967_296.0 * std::f64::consts::TAU;
        let sector = Sector::new(from, to);
        let slice = told(window, |table, cells, levels| {
            coverage::sector(ellipse(1), sector, table, cells, window, levels).expect("enough slots");
        });
        let part = told(window, |table, cells, levels| {
            coverage::ring_sector(ellipse(1), ellipse(2), sector, (table, cells), window, levels)
                .expect("enough slots");
        });
        let ring = told(window, |_, _, levels| coverage::ring(ellipse(1), ellipse(2), window, levels));
        for (x, y) in (-15..16).flat_map(|y| (-15..16).map(move |x| (x, y))) {
            let all = |(rx, ry): (f64, f64)| covered_by_sector(middle, (rx, ry), (turns(from), turns(to)), (x, y));
            let (outer, half) = (all(radii), (units(rx / 2), units(ry / 2)));
            let disc = |(rx, ry)| covered_by_ellipse(middle, (rx, ry), (x, y));
            for (name, got, wanted) in [
                ("sector", slice.at(x, y), outer),
                ("part of a ring", part.at(x, y), outer - all(half)),
                ("ring", ring.at(x, y), disc(radii) - disc(half)),
            ] {
                // Samples are off by a 64th of a pixel where a side goes straight up or down: by four 255ths, and two sides by eight.
                let error = (f64::from(got) - wanted * 255.0).abs();
                worst = worst.max(error);
                let what =
                    format!("{:?} to {:?} around {centre:?}, radii {rx} and {ry}", from.to_degrees(), to.to_degrees());
                assert!(error <= 12.5, "{name}: {error} of a 255th at ({x}, {y}): {what}");
            }
        }
    }
    println!("sectors and rings are at most {worst} 255ths off samples");
}

/// In a pixel that both ellipses go through, a hole is taken away from what is around it, and what lies beside it is added.
#[test]
fn rings_of_any_two_ellipses() {
    let window = Rect::new(0, 0, 32, 20);
    let levels = |ellipse| told(window, |_, _, levels| coverage::ellipse(ellipse, window, levels)).levels;
    let circle = |x, y, r| Ellipse::circle(PointFx::from_bits(x, y), I24F8::from_bits(r));
    for (a, b, are_near) in [
        // Inside, touching from the inside, crescents, crossing, side by side in one pixel, and far away.
        (circle(2_600, 2_500, 2_000), circle(2_500, 2_600, 1_400), true),
        (circle(2_600, 2_500, 2_000), circle(3_000, 2_500, 1_600), true),
        (circle(2_600, 2_500, 2_000), circle(2_700, 2_530, 2_000), true),
        (circle(2_600, 2_500, 2_000), circle(4_000, 3_000, 1_100), true),
        (circle(2_600, 2_500, 2_000), circle(6_150, 2_500, 1_500), false),
        (circle(1_600, 1_500, 1_300), circle(6_150, 3_500, 1_100), false),
        (circle(1_600, 1_500, 1_300), circle(6_150, 3_500, 0), false),
        (circle(1_600, 1_500, -3), circle(6_150, 3_500, 900), false),
        (circle(1_600, 1_500, 1_300), circle(i32::MAX, i32::MIN, i32::MAX), false),
    ] {
        for (a, b) in [(a, b), (b, a)] {
            let ring = told(window, |_, _, levels| coverage::ring(a, b, window, levels)).levels;
            for ((&ring, a), b) in ring.iter().zip(levels(a)).zip(levels(b)) {
                let sum = u16::from(a) + u16::from(b);
                let wanted = if are_near { u16::from(a.abs_diff(b)) } else { sum.min(510 - sum) };
                assert_eq!(u16::from(ring), wanted, "{a} and {b}");
            }
        }
    }
    // A window without end, and ellipses far from each other in it: only their rows are looked at.
    let endless = Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX);
    let (a, b) = (circle(i32::MIN + 900, i32::MIN + 900, 900), circle(i32::MAX - 900, i32::MAX - 900, 900));
    let pixels = |shape: &dyn Fn(&mut u64)| {
        let mut pixels = 0;
        shape(&mut pixels);
        pixels
    };
    let count = |pixels: &mut u64, span: ClippedSpan| *pixels += u64::from(span.len());
    let disc = |disc| pixels(&|pixels| coverage::ellipse(disc, endless, |span: ClippedSpan| count(pixels, span)));
    let both = pixels(&|pixels| coverage::ring(a, b, endless, |span: ClippedSpan| count(pixels, span)));
    assert!(both == disc(a) + disc(b) && both > 60, "{both} pixels");
}

/// What an ellipse beside it takes away from a sector is nothing, however far it is: no outline goes from one to the other.
#[test]
fn ellipses_side_by_side_have_no_ring() {
    let window = Rect::new(-30, -30, 60, 60);
    let outer = Ellipse::circle(PointFx::px(10, 13), I24F8::from_num(9));
    let sector = Sector::new(Angle::degrees(20), Angle::degrees(300));
    let slice = told(window, |table, cells, levels| {
        coverage::sector(outer, sector, table, cells, window, levels).expect("enough slots");
    });
    for (x, y) in [(21, 13), (-1, 13), (10, 24), (10, 2), (40, 50), (8_000_000, 13), (10, -8_000_000)] {
        let inner = Ellipse::circle(PointFx::px(x, y), I24F8::from_num(2));
        let part = told(window, |table, cells, levels| {
            coverage::ring_sector(outer, inner, sector, (table, cells), window, levels).expect("enough slots");
        });
        assert!(part.levels == slice.levels, "({x}, {y})");
    }
}

/// What tells a shape, with scratch memory.
type Shape<'a> = &'a dyn Fn(&mut [CoverageSlot], &mut [i32], &mut Levels);

#[test]
fn sectors_that_are_all_or_nothing() {
    let window = Rect::new(-2, -2, 30, 30);
    let (disc, hole) = (
        Ellipse::circle(PointFx::px(14, 13), I24F8::from_num(11)),
        Ellipse::circle(PointFx::px(14, 13), I24F8::from_num(6)),
    );
    let levels = |shape: Shape<'_>| told(window, shape).levels;
    let whole = levels(&|_, _, levels| coverage::ellipse(disc, window, levels));
    let ring = levels(&|_, _, levels| coverage::ring(disc, hole, window, levels));
    let of = |sector: Sector| {
        let slice = levels(&|table, cells, levels| {
            coverage::sector(disc, sector, table, cells, window, levels).expect("enough slots");
        });
        let part = levels(&|table, cells, levels| {
            coverage::ring_sector(disc, hole, sector, (table, cells), window, levels).expect("enough slots");
        });
        (slice, part)
    };
    assert!(of(Sector::slice(0, 3, 3)) == (whole.clone(), ring.clone()), "a whole turn");
    assert!(of(Sector::slice(1, 0, 3)) == (vec![0; whole.len()], vec![0; ring.len()]), "nothing");
    // Slices of a pie add up to all of it, as shapes side by side do: to a 255th for each.
    let mut sums = (vec![0_u32; whole.len()], vec![0_u32; ring.len()]);
    for slice in 0..7 {
        let (slice, part) = of(Sector::slice(slice, 1, 7));
        for (sum, level) in sums.0.iter_mut().zip(slice).chain(sums.1.iter_mut().zip(part)) {
            *sum += u32::from(level);
        }
    }
    let near =
        |sums: &[u32], whole: &[u8]| sums.iter().zip(whole).all(|(&sum, &level)| sum.abs_diff(level.into()) <= 4);
    assert!(near(&sums.0, &whole) && near(&sums.1, &ring), "slices of a pie");
}
