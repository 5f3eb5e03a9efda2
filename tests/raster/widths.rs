//! Round things with a width: gauges, segments, arcs with caps and dashes, lines with round corners. Against their equations in
//! floats: a centre that is not as they say lies within 0.14 pixel of one that is; for what needs no curves, within 1/128 pixel.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "tests mix widths on purpose"
)]

use std::{
    collections::BTreeSet,
    f64::consts::{PI, TAU},
};

use embedded_graphics_core::pixelcolor::BinaryColor;
use embedded_raster::{
    geom::{Curves, RoundCorners},
    px,
    raster::{arc, chord, ellipse, gauge, polygon, rounded::Align, stroke},
    Angle, Canvas, Cap, EdgeSlot, Ellipse, FillRule, Join, PathSegment, PointFx, Rect, Sector, Stroke,
};
use fixed::types::I24F8;
use twins::{
    assert_runs, collect,
    hits::Hits,
    rng::{cases, Rng},
    runs_where, tiles, Run, TILE_SIZES,
};

/// A place in pixels.
type Place = (f64, f64);

const WINDOW: Rect = Rect { x0: -3, y0: -2, x1: 50, y1: 44 };

fn pixel_set(runs: &[Run]) -> BTreeSet<(i32, i32)> {
    runs.iter().flat_map(|&(y, x0, x1)| (x0..x1).map(move |x| (x, y))).collect()
}

/// Fails where a centre is not in the shape, or out of it, as it should, and no place that near it is either.
fn check(got: &[Run], has: impl Fn(Place) -> bool, reach: f64, what: impl Fn() -> String) -> usize {
    let (got, mut inside) = (pixel_set(got), 0);
    for y in WINDOW.y0..WINDOW.y1 {
        for x in WINDOW.x0..WINDOW.x1 {
            let (at, is_drawn) = ((f64::from(x) + 0.5, f64::from(y) + 0.5), got.contains(&(x, y)));
            let is_near = |ring: i32| {
                (0..24).any(|i| {
                    let (angle, far) = (f64::from(i) / 24.0 * TAU, reach * f64::from(ring) / 3.0);
                    has((at.0 + far * angle.cos(), at.1 + far * angle.sin())) == is_drawn
                })
            };
            let is_right = has(at) == is_drawn || (1..=3).any(is_near);
            assert!(is_right, "({x}, {y}) drawn: {is_drawn}, {}", what());
            inside += usize::from(is_drawn);
        }
    }
    inside
}

fn turns(angle: Angle) -> f64 {
    f64::from(angle.to_bits()) / 4_294_967_296.0 * TAU
}

/// How far clockwise from an angle a place lies, seen from the origin: from 0 to below a turn.
fn clockwise(start: Angle, (x, y): Place) -> f64 {
    (y.atan2(x) - turns(start)).rem_euclid(TAU)
}

fn minus(a: Place, b: Place) -> Place {
    (a.0 - b.0, a.1 - b.1)
}

fn distance(a: Place, b: Place) -> f64 {
    (a.0 - b.0).hypot(a.1 - b.1)
}

fn pixels(at: PointFx) -> Place {
    (at.x.to_num(), at.y.to_num())
}

fn random_angle(rng: &mut Rng) -> Angle {
    match rng.below(4) {
        0 => Angle::turns(rng.below(16) as u32, 16),
        1 => Angle::turns(rng.below(8) as u32, 8).plus(rng.int(-3, 3)),
        _ => Angle::from_bits(rng.bits() as u32),
    }
}

/// How far it is from the centre of an ellipse to it in a direction.
fn reach((a, b): Place, angle: f64) -> f64 {
    if a <= 0.0 || b <= 0.0 {
        0.0
    } else {
        1.0 / (angle.cos() / a).hypot(angle.sin() / b)
    }
}

fn gauge_has(outer: Place, inner: Place, ends: [Angle; 2], p: Place) -> bool {
    let length = ends[0].clockwise_to(ends[1]);
    if length == 0 {
        return false;
    }
    let (radius, angle) = (p.0.hypot(p.1), p.1.atan2(p.0));
    let in_ring = radius <= reach(outer, angle) && radius > reach(inner, angle);
    let in_sector = clockwise(ends[0], p) < f64::from(length) / 4_294_967_296.0 * TAU;
    in_ring && in_sector
        || ends.into_iter().map(turns).any(|angle| {
            let (far, near) = (reach(outer, angle), reach(inner, angle));
            let middle = far.midpoint(near);
            distance(p, (middle * angle.cos(), middle * angle.sin())) <= (far - near) / 2.0
        })
}

/// A ring around the centre of a pixel, of a corner, or of any place.
struct Ring {
    outer: Ellipse,
    inner: Ellipse,
    centre: Place,
    radii: [Place; 2],
}

impl Ring {
    fn random(rng: &mut Rng) -> Self {
        if rng.one_in(2) {
            let (x, y) = (rng.int(-4, 20), rng.int(-4, 20));
            let (w, h) = (rng.int(1, 44), rng.int(1, 40));
            let (w, h) = if rng.one_in(3) { (w, h) } else { (w, w) };
            let by = rng.int(0, w.min(h) / 2 + 1);
            let [area, hole] = [0, by].map(|by| Rect::new(x + by, y + by, x + w - by, y + h - by));
            let half = |n: i32| f64::from(n.max(0)) / 2.0;
            let centre = (f64::from(x) + half(w), f64::from(y) + half(h));
            let hole_radii = if hole.is_empty() { (0.0, 0.0) } else { (half(w - 2 * by), half(h - 2 * by)) };
            let [outer, inner] = [area, hole].map(Ellipse::in_box);
            return Self { outer, inner, centre, radii: [(half(w), half(h)), hole_radii] };
        }
        let at = PointFx::from_bits(rng.int(0, 12_000), rng.int(0, 10_000));
        let (a, b) = (rng.int(1, 6_000), rng.int(1, 6_000));
        let (a, b) = if rng.one_in(3) { (a, b) } else { (a, a) };
        let width = rng.int(0, a.min(b));
        let shape = |by: i32| Ellipse::new(at, I24F8::from_bits(a - by), I24F8::from_bits(b - by));
        let radii = [0, width].map(|by| (f64::from(a - by) / 256.0, f64::from(b - by) / 256.0));
        Self { outer: shape(0), inner: shape(width), centre: pixels(at), radii }
    }
}

#[test]
fn gauges_are_ring_sectors_and_discs() {
    let mut rng = Rng::new(2_100);
    let mut inside = 0;
    for i in 0..cases(1_500) {
        let (ring, start) = (Ring::random(&mut rng), random_angle(&mut rng));
        // Some are shorter than their ends.
        let end = if i % 3 == 0 { start.plus(rng.int(0, 1 << 28)) } else { random_angle(&mut rng) };
        let sector = Sector::new(start, end);
        let got = collect(WINDOW, |emit| gauge::fill(ring.outer, ring.inner, sector, WINDOW, emit));
        let has = |p: Place| gauge_has(ring.radii[0], ring.radii[1], [start, end], minus(p, ring.centre));
        inside += check(&got, has, 1.0 / 128.0, || format!("{:?} at {:?}, {start:?} {end:?}", ring.radii, ring.centre));
        let sharp = collect(WINDOW, |emit| arc::ring_sector(ring.outer, ring.inner, sector, WINDOW, emit));
        assert!(pixel_set(&sharp).is_subset(&pixel_set(&got)), "the ring is in it: {:?} {start:?} {end:?}", ring.radii);
    }
    assert!(inside > cases(1_500) * 50, "{inside}");
}

#[test]
fn whole_gauges_are_rings() {
    let area = Rect::new(0, 0, 30, 30);
    let [outer, inner] = [area, area.inset(6)].map(Ellipse::in_box);
    let whole = Sector::slice(1, 3, 3);
    let got = collect(area, |emit| gauge::fill(outer, inner, whole, area, emit));
    let wanted = collect(area, |emit| arc::ring(outer, inner, area, emit));
    assert_runs(area, &got, &wanted, || "a whole turn".into());
    let none = Sector::slice(1, 0, 3);
    assert_eq!(collect(area, |emit| gauge::fill(outer, inner, none, area, emit)), [], "nothing");
}

/// What a canvas draws is what the functions say, for every alignment.
#[test]
fn canvases_draw_them() {
    let (area, sector) = (Rect::new(8, 7, 34, 33), Sector::new(Angle::degrees(135), Angle::degrees(45)));
    for (align, out) in [(Align::Inside, 0), (Align::Centred, 2), (Align::Outside, 5)] {
        let boxes = [area.inset(-out), area.inset(5 - out)];
        let [outer, inner] = boxes.map(Ellipse::in_box);
        let wanted = collect(WINDOW, |emit| gauge::fill(outer, inner, sector, WINDOW, emit));
        let mut hits = Hits::new(WINDOW);
        hits.stroke_round_arc(area, sector, 5, align, BinaryColor::On);
        assert_runs(WINDOW, &hits.runs(), &wanted, || format!("{align:?}"));
        let mut hits = Hits::new(WINDOW);
        hits.fill_gauge(boxes[0], boxes[1], sector, BinaryColor::On);
        assert_runs(WINDOW, &hits.runs(), &wanted, || format!("boxes, {align:?}"));
    }
    let wanted = collect(WINDOW, |emit| chord::fill(Ellipse::in_box(area), sector, WINDOW, emit));
    let mut hits = Hits::new(WINDOW);
    hits.fill_chord(area, sector, BinaryColor::On);
    assert_runs(WINDOW, &hits.runs(), &wanted, || "chord".into());
}

#[test]
fn segments_lie_beyond_their_chord() {
    let mut rng = Rng::new(2_101);
    for _ in 0..cases(1_500) {
        let (ring, start, end) = (Ring::random(&mut rng), random_angle(&mut rng), random_angle(&mut rng));
        let radii = ring.radii[0];
        let place = |angle: Angle| {
            let far = reach(radii, turns(angle));
            (far * turns(angle).cos(), far * turns(angle).sin())
        };
        let (a, b, length) = (place(start), place(end), start.clockwise_to(end));
        // Of two ends that are one, the line through them could be any.
        if radii.0.min(radii.1) <= 0.0 || distance(a, b) < 0.2 {
            continue;
        }
        let has = |p: Place| {
            let p = minus(p, ring.centre);
            let cross = (b.0 - a.0) * (p.1 - a.1) - (b.1 - a.1) * (p.0 - a.0);
            length != 0 && cross < 0.0 && p.0.hypot(p.1) <= reach(radii, p.1.atan2(p.0))
        };
        let sector = Sector::new(start, end);
        let got = collect(WINDOW, |emit| chord::fill(ring.outer, sector, WINDOW, emit));
        // The line turns around its ends: farther away it is farther off, if they are near each other.
        let allowed = (1.0 / 128.0) * (radii.0.max(radii.1) / distance(a, b)).max(1.0);
        check(&got, has, allowed, || format!("{radii:?} around {:?}, {start:?} {end:?}", ring.centre));
    }
}

/// Both segments of a chord are the ellipse, each pixel once; and the half discs are those of sectors.
#[test]
fn both_segments_of_a_chord_are_the_ellipse() {
    let mut rng = Rng::new(2_102);
    for i in 0..cases(4_000) {
        let (ring, start, end) = (Ring::random(&mut rng), random_angle(&mut rng), random_angle(&mut rng));
        let end = if i % 4 == 0 { start + Angle::turns(1, 2) } else { end };
        if start == end {
            continue;
        }
        let mut hits = Hits::new(WINDOW);
        for sector in [Sector::new(start, end), Sector::new(end, start)] {
            hits.add(&collect(WINDOW, |emit| chord::fill(ring.outer, sector, WINDOW, emit)));
        }
        let wanted = collect(WINDOW, |emit| ellipse::fill(ring.outer, WINDOW, emit));
        assert_runs(WINDOW, &hits.runs(), &wanted, || format!("{:?} {start:?} {end:?}", ring.radii));
    }
    for size in 1..30 {
        let area = Rect::new(3, 2, 3 + size, 2 + size);
        for quarter in 0..4 {
            let half = Sector::slice(quarter, 2, 4);
            let got = collect(WINDOW, |emit| chord::fill(Ellipse::in_box(area), half, WINDOW, emit));
            let wanted = collect(WINDOW, |emit| arc::fill(Ellipse::in_box(area), half, WINDOW, emit));
            assert_runs(WINDOW, &got, &wanted, || format!("half of {size} from quarter {quarter} on"));
        }
    }
}

/// Of an angle and its mirror image, gauges and segments are their own mirror images.
#[test]
fn gauges_and_segments_are_as_symmetric_as_their_angles() {
    let mut rng = Rng::new(2_103);
    for _ in 0..cases(3_000) {
        let (w, h) = (rng.int(1, 40), rng.int(1, 40));
        let (w, h) = if rng.one_in(3) { (w, h) } else { (w, w) };
        let (area, by) = (Rect::new(0, 0, w, h), rng.int(1, 9));
        let inner = Ellipse::in_box(Rect::new(by, by, w - by, h - by));
        let start = random_angle(&mut rng);
        for (end, is_sideways) in [(Angle::turns(1, 2) - start, true), (-start, false)] {
            let (outer, sector) = (Ellipse::in_box(area), Sector::new(start, end));
            let gauge = collect(area, |emit| gauge::fill(outer, inner, sector, area, emit));
            let segment = collect(area, |emit| chord::fill(outer, sector, area, emit));
            for got in [gauge, segment] {
                let set = pixel_set(&got);
                let mirrored =
                    runs_where(area, |x, y| set.contains(&if is_sideways { (w - 1 - x, y) } else { (x, h - 1 - y) }));
                assert_runs(area, &got, &mirrored, || format!("{start:?} to {end:?}, {by}"));
            }
        }
    }
}

fn stroked(path: impl Iterator<Item = PathSegment> + Clone, stroke: &Stroke, dashes: &[I24F8]) -> Vec<Run> {
    let mut table = vec![EdgeSlot::EMPTY; 3_000];
    let stroke = stroke.dashed(dashes, px(0));
    collect(WINDOW, |emit| stroke::fill(path, &stroke, &mut table, WINDOW, emit).expect("enough slots"))
}

/// How long it is on and off, in turn, in pixels along a circle; all of it is on if there is nothing else.
struct Pattern {
    lengths: Vec<f64>,
    whole: f64,
    is_closed: bool,
}

impl Pattern {
    /// Where dashes begin and end.
    fn dashes(&self) -> Vec<(f64, f64)> {
        if self.lengths.is_empty() {
            return vec![(0.0, self.whole)];
        }
        let (mut all, mut at) = (vec![], 0.0);
        for (i, length) in self.lengths.iter().cycle().enumerate() {
            if at >= self.whole {
                break;
            }
            if i % 2 == 0 {
                all.push((at, (at + length).min(self.whole)));
            }
            at += length;
        }
        all
    }
}

/// Whether a place, seen from the centre, is in the stroke of an arc of a circle.
fn arc_has(radius: f64, width: f64, cap: Cap, start: Angle, pattern: &Pattern, p: Place) -> bool {
    let (half, far) = (width / 2.0, p.0.hypot(p.1));
    if (far - radius).abs() > width {
        return false;
    }
    let along = clockwise(start, p) * radius;
    let dashes = pattern.dashes();
    let is_on = |&(a, b): &(f64, f64)| a <= along && along < b;
    if (far - radius).abs() <= half && dashes.iter().any(is_on) {
        return true;
    }
    // Caps, but where both ends of a ring are one.
    let is_joined = |at: f64| {
        let ends = |(a, b): &(f64, f64)| (*a == 0.0, *b >= pattern.whole);
        let first = dashes.first().is_some_and(|dash| ends(dash).0);
        let last = dashes.last().is_some_and(|dash| ends(dash).1);
        pattern.is_closed && first && last && (at == 0.0 || at >= pattern.whole)
    };
    dashes.iter().flat_map(|&(a, b)| [(a, -1.0), (b, 1.0)]).filter(|&(at, _)| !is_joined(at)).any(|(at, sign)| {
        let angle = turns(start) + at / radius;
        let (cos, sin) = (angle.cos(), angle.sin());
        let d = (p.0 - radius * cos, p.1 - radius * sin);
        let (ahead, across) = (sign * (-d.0 * sin + d.1 * cos), d.0 * cos + d.1 * sin);
        match cap {
            Cap::Butt => false,
            Cap::Square => (0.0..=half).contains(&ahead) && across.abs() <= half,
            Cap::Round => ahead >= 0.0 && d.0.hypot(d.1) <= half,
        }
    })
}

#[test]
fn arcs_have_caps_and_dashes() {
    let mut rng = Rng::new(2_104);
    let mut inside = 0;
    for i in 0..cases(1_500) {
        let centre = PointFx::from_bits(rng.int(0, 12_000), rng.int(0, 10_000));
        let bits = rng.int(512, 9_000);
        let width = rng.int(256, (2 * bits).min(3_000));
        let (radius, start, end) = (I24F8::from_bits(bits), random_angle(&mut rng), random_angle(&mut rng));
        let is_closed = i % 5 == 0;
        let sector =
            if is_closed { Sector::sweep(start, fixed::types::I16F16::from_num(360)) } else { Sector::new(start, end) };
        let turn = if is_closed { TAU } else { f64::from(start.clockwise_to(end)) / 4_294_967_296.0 * TAU };
        let dashes: Vec<I24F8> = (0..rng.pick(&[0, 0, 2, 4])).map(|_| I24F8::from_bits(rng.int(300, 4_000))).collect();
        let cap = rng.pick(&[Cap::Butt, Cap::Square, Cap::Round]);
        let r: f64 = radius.to_num();
        let pattern = Pattern { lengths: dashes.iter().map(|n| n.to_num()).collect(), whole: turn * r, is_closed };
        let stroke = Stroke::new(I24F8::from_bits(width)).with_cap(cap).with_join(Join::Bevel);
        let got = stroked(arc::path(centre, [radius; 2], sector), &stroke, &dashes);
        let w = f64::from(width) / 256.0;
        // Places of curves have 1/256 pixel: the way of a very short one, and so its caps, may be a little turned.
        if pattern.whole < 0.5 {
            continue;
        }
        let has = |p: Place| arc_has(r, w, cap, start, &pattern, minus(p, pixels(centre)));
        inside += check(&got, has, 0.14, || {
            format!("{centre:?} r {r} width {w} {cap:?} from {start:?} by {turn}, dashes {dashes:?}")
        });
        let mut hits = Hits::new(WINDOW);
        let dashed = stroke.dashed(&dashes, px(0));
        hits.stroke_arc_fx(centre, [radius; 2], sector, &dashed, &mut vec![EdgeSlot::EMPTY; 3_000], BinaryColor::On)
            .expect("enough slots");
        assert_runs(WINDOW, &hits.runs(), &got, || "canvas".into());
    }
    assert!(inside > cases(1_500) * 50, "{inside}");
}

/// Arcs of ellipses: both ends lie on the rays, and everything in between on the ellipse.
#[test]
fn arcs_of_ellipses_lie_between_their_rays() {
    let mut rng = Rng::new(2_105);
    for _ in 0..cases(20_000) {
        let most = 1 << rng.int(9, 22);
        let radii = [(); 2].map(|()| rng.int(256, most)).map(I24F8::from_bits);
        let [a, b] = radii.map(|r| r.to_num::<f64>());
        if a > 100.0 * b || b > 100.0 * a {
            continue;
        }
        let centre = PointFx::from_bits(rng.int(-99_999, 99_999), rng.int(-99_999, 99_999));
        let (start, end) = (random_angle(&mut rng), random_angle(&mut rng));
        let segments: Vec<PathSegment> = Curves::arc(centre, radii, start, end).collect();
        let what = || format!("{a} {b} from {start:?} to {end:?}: {segments:?}");
        let Some(&PathSegment::MoveTo(first)) = segments.first() else {
            assert!(start.clockwise_to(end) < 16, "{}", what());
            continue;
        };
        let mut last = 0.0;
        let whole = f64::from(start.clockwise_to(end)) / 4_294_967_296.0 * TAU;
        let mut at = first;
        for segment in &segments[1..] {
            let PathSegment::CubicTo(c, d, to) = *segment else { panic!("{}", what()) };
            for step in 0..=8 {
                let t = f64::from(step) / 8.0;
                let p = twins::curves::bezier([at, c, d, to].map(pixels).to_vec(), t);
                let (u, v) = minus(p, pixels(centre));
                let level = (u / a).hypot(v / b);
                assert!((level - 1.0).abs() * a.min(b) < 1.0 / 64.0, "{level} at {p:?} {}", what());
                let done = clockwise(start, (u, v));
                // Around the start it may be nearly a whole turn, and around the end of a whole turn nearly nothing.
                let done = done + TAU * ((last - done) / TAU).round();
                let slack = 0.012 / a.min(b);
                assert!(done > last - slack, "{done} after {last} {}", what());
                assert!(done <= whole + slack, "{done} of {whole} {}", what());
                last = last.max(done);
            }
            at = to;
        }
        let near = |end: PointFx, angle: Angle| {
            let far = reach((a, b), turns(angle));
            let wanted = (pixels(centre).0 + far * turns(angle).cos(), pixels(centre).1 + far * turns(angle).sin());
            assert!(distance(pixels(end), wanted) < 1.0 / 200.0, "{end:?} for {wanted:?} {}", what());
        };
        near(first, start);
        near(at, end);
    }
}

/// A corner of a line as the rule has it: where it begins and ends, its centre, its radius.
struct Corner {
    ends: [Place; 2],
    centre: Place,
    radius: f64,
}

fn corner([a, b, c]: [Place; 3], radius: f64) -> Option<Corner> {
    let unit = |d: Place| {
        let length = d.0.hypot(d.1);
        (length > 0.0).then(|| ((d.0 / length, d.1 / length), length))
    };
    let ((u, first), (v, second)) = (unit(minus(b, a))?, unit(minus(c, b))?);
    let half = (u.0 * v.1 - u.1 * v.0).atan2(u.0 * v.0 + u.1 * v.1) / 2.0;
    let t = (radius * half.abs().tan()).min(first / 2.0).min(second / 2.0);
    let radius = t / half.abs().tan();
    if half.abs() < 1e-7 || half.abs() > PI / 2.0 - 1e-7 || t <= 0.0 {
        return None;
    }
    let ends = [(b.0 - t * u.0, b.1 - t * u.1), (b.0 + t * v.0, b.1 + t * v.1)];
    let side = half.signum() * radius;
    Some(Corner { ends, centre: (ends[0].0 - u.1 * side, ends[0].1 + u.0 * side), radius })
}

/// A line with round corners, as places so dense that what lies between them does not matter.
fn dense(places: &[Place], closed: bool, radius: f64) -> Vec<Place> {
    let n = places.len();
    let mut all = vec![];
    for i in 0..n {
        let is_end = !closed && (i == 0 || i == n - 1) || n < 3;
        let three = [places[(i + n - 1) % n], places[i], places[(i + 1) % n]];
        match corner(three, radius).filter(|_| !is_end) {
            None => all.push(places[i]),
            Some(Corner { ends, centre, radius }) => {
                let [from, to] = ends.map(|end| minus(end, centre)).map(|d| d.1.atan2(d.0));
                // Less than half a turn.
                let turn = (to - from + PI).rem_euclid(TAU) - PI;
                all.extend((0..=64).map(|k| {
                    let angle = from + turn * f64::from(k) / 64.0;
                    (centre.0 + radius * angle.cos(), centre.1 + radius * angle.sin())
                }));
            }
        }
    }
    if closed {
        all.extend(all.first().copied());
    }
    all
}

fn random_places(rng: &mut Rng) -> Vec<PointFx> {
    let grid = rng.pick(&[1, 256, 1_024]);
    let mut at = |most: i32| rng.int(0, most) / grid * grid;
    let n = 2 + usize::from(at(2_560) as u16) % 6;
    (0..n).map(|_| PointFx::from_bits(at(12_000), at(10_000))).collect()
}

#[test]
fn round_corners_are_pieces_of_circles() {
    let mut rng = Rng::new(2_106);
    for _ in 0..cases(1_500) {
        let places = random_places(&mut rng);
        let (closed, radius) = (rng.one_in(2), I24F8::from_bits(rng.int(0, 6_000)));
        let width = rng.int(256, 1_500);
        let floats: Vec<Place> = places.iter().map(|&at| pixels(at)).collect();
        let line = dense(&floats, closed, radius.to_num());
        let half = f64::from(width) / 512.0;
        let has = |p: Place| {
            line.windows(2).any(|ends| {
                let (d, e) = (minus(ends[1], ends[0]), minus(p, ends[0]));
                let square = d.0 * d.0 + d.1 * d.1;
                let t = if square > 0.0 { ((d.0 * e.0 + d.1 * e.1) / square).clamp(0.0, 1.0) } else { 0.0 };
                distance(e, (t * d.0, t * d.1)) <= half
            })
        };
        let stroke = Stroke::new(I24F8::from_bits(width)).with_cap(Cap::Round).with_join(Join::Round);
        let got = stroked(RoundCorners::new(&places, closed, radius), &stroke, &[]);
        check(&got, has, 0.14, || format!("{places:?} closed {closed} radius {radius} width {width}"));
        let mut hits = Hits::new(WINDOW);
        let mut table = vec![EdgeSlot::EMPTY; 2_000];
        hits.stroke_round_polyline_fx(&places, closed, radius, &stroke, &mut table, BinaryColor::On)
            .expect("enough slots");
        assert_runs(WINDOW, &hits.runs(), &got, || "canvas".into());
    }
}

/// Filled, with the places on the border left out.
#[test]
fn polygons_have_round_corners() {
    let mut rng = Rng::new(2_107);
    for _ in 0..cases(1_500) {
        let places = random_places(&mut rng);
        let radius = I24F8::from_bits(rng.int(0, 6_000));
        let floats: Vec<Place> = places.iter().map(|&at| pixels(at)).collect();
        let line = dense(&floats, true, radius.to_num());
        let has = |p: Place| {
            let crossings = line.windows(2).filter(|ends| {
                let ((ax, ay), (bx, by)) = (ends[0], ends[1]);
                (ay <= p.1) != (by <= p.1) && ax + (bx - ax) * (p.1 - ay) / (by - ay) <= p.0
            });
            crossings.count() % 2 == 1
        };
        let mut hits = Hits::new(WINDOW);
        let mut table = vec![EdgeSlot::EMPTY; 500];
        hits.fill_round_polygon_fx(&places, radius, FillRule::EvenOdd, &mut table, BinaryColor::On)
            .expect("enough slots");
        check(&hits.runs(), has, 0.14, || format!("{places:?} radius {radius}"));
    }
}

/// A round rectangle by its corners is the rounded rectangle by its radii, where the arithmetic of both is exact: not at a tie.
#[test]
fn sharp_corners_stay_sharp() {
    use PathSegment::{Close, LineTo, MoveTo};
    let square = [(4, 4), (20, 4), (20, 20), (4, 20)].map(|(x, y)| PointFx::px(x, y));
    let segments: Vec<PathSegment> = RoundCorners::new(&square, true, px(0)).collect();
    assert_eq!(segments, [MoveTo(square[0]), LineTo(square[1]), LineTo(square[2]), LineTo(square[3]), Close]);
    assert_eq!(RoundCorners::new(&square[..0], true, px(3)).count(), 0);
    assert_eq!(RoundCorners::new(&square[..1], true, px(3)).collect::<Vec<_>>(), [MoveTo(square[0]), Close]);
    let back = [square[0], square[1], square[0]];
    let there = [MoveTo(back[0]), LineTo(back[1]), LineTo(back[2])];
    assert_eq!(RoundCorners::new(&back, false, px(3)).collect::<Vec<_>>(), there, "straight back");
    let straight = [PointFx::px(0, 0), PointFx::px(3, 1), PointFx::px(9, 3)];
    assert_eq!(RoundCorners::new(&straight, false, px(3)).count(), 3, "straight on");
    // A radius of half a side and more: a circle.
    let circle: Vec<PathSegment> = RoundCorners::new(&square, true, px(99)).collect();
    assert_eq!(circle[0], MoveTo(PointFx::px(12, 4)));
    let mut runs = vec![vec![]; 2];
    let mut table = [EdgeSlot::EMPTY; 40];
    let contours = embedded_raster::geom::Contours::new(circle);
    runs[0] = collect(WINDOW, |emit| {
        polygon::fill(contours, FillRule::NonZero, &mut table, WINDOW, emit).expect("enough slots");
    });
    let disc = Ellipse::circle(PointFx::px(12, 12), px(8));
    runs[1] = collect(WINDOW, |emit| ellipse::fill(disc, WINDOW, emit));
    assert_runs(WINDOW, &runs[0], &runs[1], || "a circle".into());
}

#[test]
fn corners_at_the_ends_of_the_type() {
    let mut rng = Rng::new(2_108);
    for _ in 0..cases(20_000) {
        let shift = rng.int(0, 31);
        let mut place = || PointFx::from_bits(rng.int(i32::MIN, i32::MAX) >> shift, rng.int(i32::MIN, i32::MAX));
        let places = [place(), place(), place(), place()];
        let closed = rng.one_in(2);
        let radius = I24F8::from_bits(rng.int(i32::MIN, i32::MAX) >> rng.int(0, 31));
        let count = RoundCorners::new(&places, closed, radius).count();
        assert!(count <= 2 + 4 * 34, "{count} segments");
        for segment in RoundCorners::new(&places, closed, radius) {
            // All of it is in the box of the places, but for rounding.
            let PathSegment::LineTo(at) = segment else { continue };
            let [low_x, low_y] = [|p: &PointFx| p.x, |p: &PointFx| p.y].map(|of| places.iter().map(of).min().unwrap());
            let [high_x, high_y] =
                [|p: &PointFx| p.x, |p: &PointFx| p.y].map(|of| places.iter().map(of).max().unwrap());
            let slack = I24F8::from_bits(4);
            let is_within =
                |low: I24F8, n: I24F8, high: I24F8| low.saturating_sub(slack) <= n && n <= high.saturating_add(slack);
            assert!(is_within(low_x, at.x, high_x) && is_within(low_y, at.y, high_y), "{at:?} of {places:?}");
        }
    }
}

#[test]
fn tiles_show_the_same_gauges() {
    let mut rng = Rng::new(2_109);
    for _ in 0..cases(40) {
        let (ring, start, end) = (Ring::random(&mut rng), random_angle(&mut rng), random_angle(&mut rng));
        let sector = Sector::new(start, end);
        let shapes: [&dyn Fn(Rect) -> Vec<Run>; 2] =
            [&|window| collect(window, |emit| gauge::fill(ring.outer, ring.inner, sector, window, emit)), &|window| {
                collect(window, |emit| chord::fill(ring.outer, sector, window, emit))
            }];
        for shape in shapes {
            let wanted = shape(WINDOW);
            for size in TILE_SIZES {
                let mut hits = Hits::new(WINDOW);
                for tile in tiles(WINDOW, size) {
                    hits.add(&shape(tile));
                }
                assert_runs(WINDOW, &hits.runs(), &wanted, || {
                    format!("{:?} {start:?} {end:?} in {size:?}", ring.radii)
                });
            }
        }
    }
}

/// Boxes as large as there are, through a small window.
#[test]
fn large_gauges_and_segments() {
    let mut rng = Rng::new(2_110);
    for _ in 0..cases(20_000) {
        let size = |rng: &mut Rng| (1_i64 << rng.range(4, 31)) + rng.range(-3, 3);
        let (w, h) = (size(&mut rng), size(&mut rng));
        let (w, h) = if rng.one_in(2) { (w, w) } else { (w, h) };
        let (x, y) =
            (rng.range(i32::MIN.into(), i64::from(i32::MAX) - w), rng.range(i32::MIN.into(), i64::from(i32::MAX) - h));
        let area = Rect::new(x as i32, y as i32, (x + w) as i32, (y + h) as i32);
        let by = rng.int(0, (w.min(h) / 2) as i32);
        let inner = Rect::new(area.x0 + by, area.y0 + by, area.x1 - by, area.y1 - by);
        let start = random_angle(&mut rng);
        let sector = Sector::new(start, random_angle(&mut rng));
        let place = |middle: i64, size: i64, part: f64| (middle as f64 + size as f64 / 2.0 * part) as i64;
        let at = [
            place(x + w / 2, w - i64::from(by), turns(start).cos()),
            place(y + h / 2, h - i64::from(by), turns(start).sin()),
        ];
        let window = twins::scenes::window_near(&mut rng, at[0], at[1]);
        let [outer, inner] = [area, inner].map(Ellipse::in_box);
        let gauge = collect(window, |emit| gauge::fill(outer, inner, sector, window, emit));
        let sharp = collect(window, |emit| arc::ring_sector(outer, inner, sector, window, emit));
        assert!(pixel_set(&sharp).is_subset(&pixel_set(&gauge)), "{area:?} {by} {sector:?} in {window:?}");
        collect(window, |emit| chord::fill(outer, sector, window, emit));
    }
}
