//! What is asked of polygons, segments and viewports, against the rules in wide integers.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "wide numbers that were checked to fit"
)]

use embedded_graphics_core::geometry::Point;
use embedded_raster::{
    geom::{
        clip,
        polygon::{contains, crossings, is_convex, orientation, twice_area},
        Viewport,
    },
    raster::polygon,
    CrossingListFull, EdgeSlot, FillRule, PointFx, Rect,
};
use fixed::types::{I16F16, I24F8};
use twins::{
    assert_runs, collect, polygon_contains,
    rng::Rng,
    runs_where,
    scenes::{outline, window_on, Scale},
    tools::{clip_twin, convex_twin, hull, map_twin},
    vertices, wide, Units,
};

/// Places on a convex curve or nearly: regular enough that many are convex.
fn round(rng: &mut Rng) -> Vec<Units> {
    let n = 3 + rng.index(9);
    let (reach, step) = (rng.pick(&[1, 2, 3, 50]), rng.pick(&[1, 64, 100_000_000 / 8]));
    let all: Vec<Units> = (0..n).map(|_| (rng.int(-reach, reach) * step, rng.int(-reach, reach) * step)).collect();
    let mut contour = hull(&all);
    // Spoil it now and then: a vertex in the middle of a side, a repeated one, a spike, a second round, an exchange.
    for _ in 0..rng.index(4) {
        let (i, n) = (rng.index(contour.len()), contour.len());
        let (p, q) = (contour[i], contour[(i + 1) % n]);
        let middle = (i32::midpoint(p.0, q.0), i32::midpoint(p.1, q.1));
        match rng.below(7) {
            0 | 1 => contour.insert(i + 1, middle),
            2 => contour.insert(i, p),
            3 => contour.extend_from_within(..),
            4 => contour.swap(i, (i + 1) % n),
            5 => contour.insert(i, q),
            _ => contour.insert(i, rng.pick(&all)),
        }
    }
    let turn = rng.index(contour.len());
    contour.rotate_left(turn);
    if rng.one_in(2) {
        contour.reverse();
    }
    contour
}

#[test]
fn convexity() {
    let mut rng = Rng::new(700);
    let (mut convex, mut other) = (0, 0);
    let mut compare = |contour: &[Units]| {
        let got = is_convex(&vertices(contour));
        assert_eq!(got, convex_twin(contour), "{contour:?}");
        *if got { &mut convex } else { &mut other } += 1;
    };
    for i in 0..150_000 {
        compare(&round(&mut rng));
        let n = rng.index(7);
        compare(&outline(&mut rng, Scale::ALL[i % 4], n));
    }
    assert!(convex > 25_000 && other > 25_000, "{convex} are convex, {other} not");
}

#[test]
fn convexity_by_hand() {
    let (low, high) = (i32::MIN, i32::MAX);
    let cases: [(&[Units], bool); 16] = [
        (&[], true),
        (&[(3, 4)], true),
        (&[(3, 4), (3, 4)], true),
        (&[(0, 0), (5, 5)], true),
        (&[(0, 0), (5, 5), (9, 9), (2, 2)], true),
        (&[(0, 0), (5, 0), (1, 0), (9, 0)], false),
        (&[(0, 0), (4, 0), (4, 4), (0, 4)], true),
        (&[(0, 4), (4, 4), (4, 0), (0, 0)], true),
        (&[(0, 0), (4, 4), (4, 0), (0, 4)], false),
        (&[(0, -20), (12, 17), (-19, -6), (19, -6), (-12, 17)], false),
        (&[(0, 0), (4, 0), (4, 4), (0, 0), (4, 0), (4, 4)], false),
        (&[(0, 0), (9, 0), (5, 0), (5, 5)], false),
        (&[(0, 0), (9, 0), (9, 9), (9, 5), (9, 12), (0, 12)], false),
        (&[(low, low), (high, low), (high, high), (low, high)], true),
        (&[(low, low), (high, high), (high, high - 1)], true),
        (&[(low, low), (0, -1), (high, high), (low, high)], true),
    ];
    for (contour, wanted) in cases {
        assert_eq!(convex_twin(contour), wanted, "the twin, {contour:?}");
        assert_eq!(is_convex(&vertices(contour)), wanted, "{contour:?}");
    }
}

#[test]
fn areas() {
    let mut rng = Rng::new(701);
    for i in 0..200_000 {
        let n = rng.index(20);
        let contour = outline(&mut rng, Scale::ALL[i % 4], n);
        // Trapezoids under the sides, down to the axis.
        let wanted: i128 = twins::sides(std::slice::from_ref(&contour))
            .map(|(a, b)| (wide(a).0 - wide(b).0) * (wide(a).1 + wide(b).1))
            .sum();
        let got = twice_area(&vertices(&contour));
        assert_eq!(got, wanted, "{contour:?}");
        assert_eq!(orientation(&vertices(&contour)), wanted.cmp(&0), "{contour:?}");
    }
    // The largest there is, and round it many times.
    let (low, high) = (i32::MIN, i32::MAX);
    let all = [(low, low), (high, low), (high, high), (low, high)].repeat(5_000);
    assert_eq!(twice_area(&vertices(&all)), 10_000 * ((1_i128 << 32) - 1).pow(2));
}

#[test]
fn places_in_polygons() {
    let mut rng = Rng::new(702);
    let mut inside = 0;
    for i in 0..60_000 {
        let n = 2 + rng.index(9);
        let all = outline(&mut rng, Scale::ALL[i % 4], n);
        let contours = [all[..n / 2].to_vec(), all[n / 2..].to_vec()];
        let places: Vec<Vec<PointFx>> = contours.iter().map(|c| vertices(c)).collect();
        // Pixels whose centres are places.
        let window = window_on(&mut rng, &all).intersection(Rect::new(-1 << 23, -1 << 23, 1 << 23, 1 << 23));
        for rule in [FillRule::NonZero, FillRule::EvenOdd] {
            // Centres of pixels: what the filler paints.
            let mut table = vec![EdgeSlot::EMPTY; n];
            let painted = collect(window, |emit| {
                polygon::fill(&places, rule, &mut table, window, emit).expect("a slot for every side");
            });
            let found = runs_where(window, |x, y| contains(&places, rule, PointFx::centre_of(Point::new(x, y))));
            assert_runs(window, &found, &painted, || format!("{rule:?} {contours:?}"));
            // Any other place: anywhere, at vertices, beside them.
            for _ in 0..10 {
                let (p, q) = (rng.pick(&all), rng.pick(&all));
                let at = match rng.below(4) {
                    0 => (rng.bits() as i32, rng.bits() as i32),
                    1 => (p.0, q.1),
                    2 => (i32::midpoint(p.0, q.0), i32::midpoint(p.1, q.1)),
                    _ => (p.0.saturating_add(rng.int(-1, 1)), p.1.saturating_add(rng.int(-1, 1))),
                };
                let wanted = polygon_contains(&contours, rule, at);
                assert_eq!(
                    contains(&places, rule, PointFx::from_bits(at.0, at.1)),
                    wanted,
                    "{at:?} {rule:?} {contours:?}"
                );
                inside += usize::from(wanted);
            }
        }
    }
    assert!(inside > 50_000, "only {inside} places were inside");
}

#[test]
fn crossings_of_a_line_with_a_polygon() {
    let mut rng = Rng::new(705);
    let (mut many, mut found_in_all) = (0, 0);
    for i in 0..60_000 {
        let n = 2 + rng.index(12);
        let all = outline(&mut rng, Scale::ALL[i % 4], n);
        let contours = [all[..n / 2].to_vec(), all[n / 2..].to_vec()];
        let places: Vec<Vec<PointFx>> = contours.iter().map(|c| vertices(c)).collect();
        let y = match rng.below(3) {
            0 => rng.pick(&all).1,
            1 => i32::midpoint(rng.pick(&all).1, rng.pick(&all).1),
            _ => rng.pick(&all).1.saturating_add(rng.int(-300, 300)),
        };
        let mut wanted: Vec<(i32, bool)> = twins::sides(&contours)
            .filter(|(a, b)| (a.1 <= y) != (b.1 <= y))
            .map(|(a, b)| (map_twin(y, (a.1, b.1), (a.0, b.0)), a.1 < b.1))
            .collect();
        wanted.sort_unstable();
        let result = crossings::<_, 6>(&places, I24F8::from_bits(y));
        if wanted.len() > 6 {
            assert_eq!(result, Err(CrossingListFull { capacity: 6, needed: wanted.len() }), "{y} {contours:?}");
            many += 1;
            continue;
        }
        let found = result.expect("there is room");
        assert!(found.is_sorted_by_key(|crossing| crossing.x), "{found:?}");
        let mut got: Vec<(i32, bool)> = found.iter().map(|c| (c.x.to_bits(), c.goes_down)).collect();
        got.sort_unstable();
        assert_eq!(got, wanted, "{y} {contours:?}");
        found_in_all += found.len();
        // Between two of them nothing changes: an odd number lies to the left inside of the polygon.
        for (k, pair) in found.windows(2).enumerate() {
            let (left, right) = (pair[0].x.to_bits(), pair[1].x.to_bits());
            if left.checked_add(2).is_some_and(|after| after < right) {
                let inside = contains(&places, FillRule::EvenOdd, PointFx::from_bits(left + 1, y));
                assert_eq!(inside, k % 2 == 0, "right of crossing {k}, {y} {contours:?}");
            }
        }
    }
    assert!(many > 1_000 && found_in_all > 50_000, "{many} were too many, {found_in_all} in all");
}

#[test]
fn clipped_segments() {
    let mut rng = Rng::new(703);
    let (mut seen, mut corners_touched) = (0, 0);
    for i in 0..200_000 {
        let places = outline(&mut rng, Scale::ALL[i % 4], 4);
        let (mut ends, area) = ([places[0], places[1]], [places[2], places[3]]);
        match rng.below(8) {
            // Through a corner, in both directions by the same amounts.
            0 => {
                let (corner, dx, dy) = (area[0], rng.int(-900, 900), rng.int(-900, 900));
                ends = [
                    (corner.0.saturating_sub(dx), corner.1.saturating_sub(dy)),
                    (corner.0.saturating_add(dx), corner.1.saturating_add(dy)),
                ];
            }
            1 => ends[1].0 = ends[0].0,
            2 => ends[1].1 = ends[0].1,
            3 => ends[rng.index(2)] = area[0],
            _ => {}
        }
        let [a, b, p, q] = [ends[0], ends[1], area[0], area[1]].map(|(x, y)| PointFx::from_bits(x, y));
        let got = clip::segment(a, b, [p, q]);
        let wanted = clip_twin(ends, area);
        assert_eq!(got.is_some(), wanted.is_some(), "{ends:?} in {area:?}");
        let (Some(got), Some(wanted)) = (got, wanted) else { continue };
        for (k, t) in wanted.into_iter().enumerate() {
            let at = got.at[k];
            assert_eq!(i128::from(at.number) * t.1, t.0 * i128::from(at.of.get()), "{ends:?} in {area:?}: end {k}");
            let ((ax, ay), (bx, by)) = (wide(ends[0]), wide(ends[1]));
            let place = PointFx::from_bits(t.nearest(ax, bx), t.nearest(ay, by));
            assert_eq!(got.ends[k], place, "{ends:?} in {area:?}: end {k}");
        }
        // The other way, the same ends; and nothing is left to clip.
        let back = clip::segment(b, a, [q, p]).expect("the same segment");
        assert_eq!(back.ends, [got.ends[1], got.ends[0]], "{ends:?} in {area:?}");
        let again = clip::segment(got.ends[0], got.ends[1], [p, q]).expect("it lies inside");
        assert_eq!(again.ends, got.ends, "{ends:?} in {area:?}");
        seen += 1;
        corners_touched += usize::from(got.ends[0] == got.ends[1] && ends[0] != ends[1]);
    }
    assert!(seen > 30_000 && corners_touched > 250, "{seen} were seen, {corners_touched} touch a corner");
}

fn any_number(rng: &mut Rng) -> i32 {
    match rng.below(4) {
        0 => rng.pick(&[i32::MIN, i32::MIN + 1, -65_536, -1, 0, 1, 65_536, i32::MAX - 1, i32::MAX]),
        1 => rng.int(-9, 9),
        2 => rng.int(-70_000, 70_000),
        _ => rng.bits() as i32,
    }
}

#[test]
fn viewports() {
    let mut rng = Rng::new(704);
    let mut there_and_back = 0;
    for _ in 0..200_000 {
        let mut number = || any_number(&mut rng);
        let (low, high) = ([number(), number()], [number(), number()]);
        let area = Rect::new(number(), number(), number() >> 8, number() >> 12);
        let mut view = Viewport::from_bits(low, high, area);
        let units = |v: PointFx| (v.x.to_bits(), v.y.to_bits());
        let (upper, lower) = (units(PointFx::px(area.x0, area.y0)), units(PointFx::px(area.x1, area.y1)));
        let (screen_x, mut screen_y) = ((upper.0, lower.0), (upper.1, lower.1));
        if rng.one_in(2) {
            (view, screen_y) = (view.with_y_up(), (screen_y.1, screen_y.0));
        }
        let (plane_x, plane_y) = ((low[0], high[0]), (low[1], high[1]));
        for _ in 0..4 {
            let (x, y) = (any_number(&mut rng), any_number(&mut rng));
            let vertex = units(view.bits_to_screen([x, y]));
            let wanted = (map_twin(x, plane_x, screen_x), map_twin(y, plane_y, screen_y));
            assert_eq!(vertex, wanted, "({x}, {y}) in {view:?}");
            let place = view.to_plane_bits(PointFx::from_bits(x, y));
            let wanted = [map_twin(x, screen_x, plane_x), map_twin(y, screen_y, plane_y)];
            assert_eq!(place, wanted, "back from ({x}, {y}) in {view:?}");
            // Order is kept: the next number is not on the other side.
            let next = units(view.bits_to_screen([x.saturating_add(1), y])).0;
            let grows = (low[0] <= high[0]) == (screen_x.0 <= screen_x.1);
            assert!(if grows { next >= vertex.0 } else { next <= vertex.0 }, "{x} and the next in {view:?}");
            // Where the plane is no coarser, the screen and back is no change, as far as the plane goes.
            let is_finer = plane_x.0.abs_diff(plane_x.1) >= screen_x.0.abs_diff(screen_x.1) && screen_x.0 != screen_x.1;
            if is_finer && place[0] != i32::MIN && place[0] != i32::MAX {
                assert_eq!(units(view.bits_to_screen(place)).0, x, "there and back in {view:?}");
                there_and_back += 1;
            }
        }
        if low[0] != high[0] && low[1] != high[1] {
            assert_eq!(units(view.bits_to_screen(low)), (screen_x.0, screen_y.0), "{view:?}");
            assert_eq!(units(view.bits_to_screen(high)), (screen_x.1, screen_y.1), "{view:?}");
        }
    }
    assert!(there_and_back > 50_000, "only {there_and_back} there and back");
}

#[test]
fn the_unit_square_on_a_screen() {
    let one = I16F16::ONE;
    let view = Viewport::new([-one, -one], [one, one], Rect::new(0, 0, 320, 240));
    assert_eq!(view.to_screen(-one, -one), PointFx::px(0, 0));
    assert_eq!(view.to_screen(one, one), PointFx::px(320, 240));
    let up = view.with_y_up();
    assert_eq!(up.to_screen(-one, -one), PointFx::px(0, 240));
    assert_eq!(up.to_screen(one, one), PointFx::px(320, 0));
    assert_eq!(up.with_y_up(), view);
    for x in -3..330 {
        for y in [-9, 0, 1, 119, 240, 300] {
            let at = PointFx::px(x, y);
            let [px, py] = up.to_plane(at);
            assert_eq!(up.to_screen(px, py), at);
        }
    }
    assert_eq!(up.to_screen(I16F16::MAX, I16F16::MIN), PointFx::from_bits(1_342_218_239, 1_006_663_680));
    let largest = Rect::new(i32::MIN, 0, i32::MAX, 1);
    let far = Viewport::new([-one, -one], [one, one], largest).to_screen(I16F16::MAX, one);
    assert_eq!(far, PointFx::from_bits(i32::MAX, 256), "it stops at the end");
}
