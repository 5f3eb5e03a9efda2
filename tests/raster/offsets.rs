//! Strokes against what a stroke is: the places within half a width of the true curve, at right angles to it, and caps and joins
//! that stand on its tangents. Every pixel whose centre is farther than 0.14 pixel from the border is right.

use std::collections::HashSet;

use crate::stroke::islands;
use embedded_raster::{
    px,
    raster::{ellipse, stroke as thick},
    Cap, EdgeSlot, Ellipse, Join, Path, PathSegment, PointFx, Rect, Stroke,
};
use fixed::types::I24F8;
use twins::{
    collect,
    curves::{bezier, segments, Piece},
    offsets::Model,
    picture,
    rng::{cases, Rng},
    strokes::Pen,
    Run,
};

/// 0.14 pixel, in units.
const REACH: f64 = 0.14 * 256.0;

fn fx(n: f64) -> I24F8 {
    I24F8::from_num((n * 256.0).round() / 256.0)
}

fn at(x: f64, y: f64) -> PointFx {
    PointFx { x: fx(x), y: fx(y) }
}

fn drawn<D: thick::Dashing>(path: &[PathSegment], stroke: &Stroke<D>, window: Rect) -> Vec<Run> {
    let path = Path::new(path);
    let mut table = vec![EdgeSlot::EMPTY; 2_000];
    collect(window, |emit| thick::fill(path, stroke, &mut table, window, emit).expect("enough slots"))
}

fn count(runs: &[Run]) -> i32 {
    runs.iter().map(|run| run.2 - run.1).sum()
}

fn of_pen(pen: Pen) -> Stroke {
    Stroke::new(I24F8::from_bits(pen.width))
        .with_cap(pen.cap)
        .with_join(pen.join)
        .with_miter_limit(I24F8::from_bits(pen.limit))
}

use PathSegment::{Close, CubicTo, LineTo, MoveTo};

/// A quarter of a circle of radius 6, 24 wide: one cap stands on y = 20, the other on x = 20.
#[test]
fn caps_stand_on_the_curve() {
    let path = [MoveTo(at(26.0, 20.0)), CubicTo(at(26.0, 23.313_708_5), at(23.313_708_5, 26.0), at(20.0, 26.0))];
    let window = Rect::new(0, 0, 48, 48);
    let runs = drawn(&path, &Stroke::px(24), window);
    assert_eq!(count(&runs), 283, "{}", picture(window, &runs));
    let row = |y: i32| runs.iter().filter(|run| run.0 == y).map(|run| (run.1, run.2)).collect::<Vec<_>>();
    assert_eq!(row(20), [(20, 38)], "{}", picture(window, &runs));
}

/// A line runs smoothly into a curve, whose first chord is not its direction.
#[test]
fn smooth_joints_have_no_miter() {
    let path = [
        MoveTo(at(4.0, 20.0)),
        LineTo(at(20.0, 20.0)),
        CubicTo(at(32.0, 20.0), at(40.0, 20.0), at(40.0, 20.5)),
        LineTo(at(40.0, 36.0)),
    ];
    let window = Rect::new(0, 0, 64, 40);
    let runs = drawn(&path, &Stroke::px(12), window);
    assert_eq!(count(&runs), 613, "{}", picture(window, &runs));
    assert_eq!(runs.iter().filter(|run| run.0 == 15).map(|run| run.2).max(), Some(43), "{}", picture(window, &runs));
}

/// A dash that is on at both ends of a ring is one dash, with a join at the seam.
#[test]
fn dashes_close_rings() {
    let path = [MoveTo(at(4.0, 4.0)), LineTo(at(20.0, 4.0)), LineTo(at(20.0, 20.0)), LineTo(at(4.0, 20.0)), Close];
    let window = Rect::new(0, 0, 24, 24);
    let stroke = Stroke::px(4);
    let runs = drawn(&path, &stroke.dashed(&[px(8), px(4)], px(4)), window);
    assert_eq!(count(&runs), 176, "{}", picture(window, &runs));
    let runs = drawn(&path, &stroke.dashed(&[px(1_000), px(4)], px(0)), window);
    assert_eq!(count(&runs), 256, "{}", picture(window, &runs));
}

/// Cases after public bug reports, as they were right before.
#[test]
fn cases_that_were_right() {
    let dots = [fx(0.01), fx(20.7)];
    let stroke = Stroke::px(15).with_cap(Cap::Square).dashed(&dots, px(0));
    let line = [MoveTo(at(100.0, 100.5)), LineTo(at(500.0, 100.5))];
    assert_eq!(count(&drawn(&line, &stroke, Rect::new(0, 0, 600, 160))), 4_515);
    let back =
        [MoveTo(at(602.469, 286.585)), CubicTo(at(641.975, 286.585), at(562.963, 286.585), at(562.963, 286.585))];
    let stroke = Stroke::px(9).with_join(Join::Round);
    assert_eq!(count(&drawn(&back, &stroke, Rect::new(0, 0, 660, 300))), 487);
    let places = [(10.0, 30.0), (100.0, 30.0), (130.0, 80.0), (130.0, 40.0), (250.0, 30.0), (450.0, 30.0)];
    let mut lines: Vec<PathSegment> = places.iter().map(|&(x, y)| LineTo(at(x, y))).collect();
    lines[0] = MoveTo(at(10.0, 30.0));
    assert_eq!(count(&drawn(&lines, &Stroke::px(10), Rect::new(0, 0, 470, 120))), 5_090);
}

/// Below a pixel a stroke is the connected outline of one pixel.
#[test]
fn thin_strokes_are_seen() {
    let ring = [MoveTo(at(2.0, 2.0)), LineTo(at(10.0, 2.0)), LineTo(at(10.0, 6.0)), LineTo(at(2.0, 6.0)), Close];
    let window = Rect::new(0, 0, 12, 8);
    let runs = drawn(&ring, &Stroke::new(fx(0.75)), window);
    assert_eq!((count(&runs), islands(&runs)), (24, 1), "{}", picture(window, &runs));
    assert_eq!(runs, drawn(&ring, &Stroke::px(1), window));
    assert_eq!(drawn(&ring, &Stroke::new(fx(0.75)).with_min_width(px(0)), window), []);
    let curve = [MoveTo(at(2.0, 2.3)), CubicTo(at(20.0, 3.0), at(40.0, 10.0), at(57.0, 37.0))];
    let window = Rect::new(0, 0, 60, 40);
    let runs = drawn(&curve, &Stroke::new(fx(0.5)), window);
    assert_eq!(islands(&runs), 1, "{}", picture(window, &runs));
    let mut rng = Rng::new(560);
    for _ in 0..cases(20_000) {
        let mut place = || PointFx::from_bits(rng.int(0, 14_000), rng.int(0, 9_000));
        let curve = [MoveTo(place()), CubicTo(place(), place(), place())];
        let width = I24F8::from_bits(rng.int(0, 700));
        let stroke = Stroke::new(width).with_join(rng.pick(&[Join::Round, Join::Bevel])).with_cap(Cap::Round);
        let runs = drawn(&curve, &stroke, window);
        assert_eq!(islands(&runs), 1, "{width} {curve:?}\n{}", picture(window, &runs));
    }
}

/// A path of a few segments within some pixels, with a liking for trouble: control points on the ends, smooth joints, cusps.
fn path(rng: &mut Rng) -> Vec<Piece> {
    let reach = rng.pick(&[600, 2_000, 5_000]);
    let (x, y) = (rng.int(3_000, 9_000), rng.int(3_000, 7_000));
    let place = |rng: &mut Rng| (x + rng.int(-reach, reach), y + rng.int(-reach, reach));
    let mut last = place(rng);
    let mut back = last;
    let mut path = vec![Piece::Move(last)];
    for _ in 0..rng.int(1, 3) {
        let [mut c, mut d, to] = [(); 3].map(|()| place(rng));
        if rng.one_in(3) {
            // Smooth: the first control point opposite to the one before.
            c = (2 * last.0 - back.0, 2 * last.1 - back.1);
        }
        match rng.below(8) {
            0 => c = last,
            1 => d = to,
            2 => (c, d) = (last, to),
            3 => (c, d) = (to, last),
            _ => {}
        }
        let piece = match rng.below(6) {
            0 => Piece::Line(to),
            1 => Piece::Quadratic(c, to),
            _ => Piece::Cubic(c, d, to),
        };
        (back, last) = (if matches!(piece, Piece::Quadratic(..)) { c } else { d }, to);
        path.push(piece);
    }
    if rng.one_in(4) {
        path.push(Piece::Close);
    }
    path
}

/// The pixels that are not as they should be, and do not lie within a seventh of one that is, with whether they are drawn.
fn wrong(model: &Model, runs: &[Run], window: Rect) -> Vec<((i32, i32), bool)> {
    let drawn: HashSet<(i32, i32)> = runs.iter().flat_map(|r| (r.1..r.2).map(|x| (x, r.0))).collect();
    let all = (window.y0..window.y1).flat_map(|y| (window.x0..window.x1).map(move |x| (x, y)));
    all.filter_map(|(x, y)| {
        let (centre, is_drawn) = ((f64::from(x * 256 + 128), f64::from(y * 256 + 128)), drawn.contains(&(x, y)));
        let is_right = model.contains(centre) == is_drawn || model.has_near(centre, REACH, is_drawn);
        (!is_right).then_some(((x, y), is_drawn))
    })
    .collect()
}

/// Where two parts of a stroke overlap by less than both may be off, there may be a crack between them, inside of the stroke: that
/// is one pixel in some ten thousands of strokes like these.
#[test]
fn every_pixel_is_within_a_seventh() {
    let mut rng = Rng::new(561);
    let window = Rect::new(0, 0, 48, 40);
    let (mut cracks, mut inside, mut cases_left) = (vec![], 0, cases(300));
    while cases_left > 0 {
        let path = path(&mut rng);
        let width = rng.pick(&[256, 300, 321, 400, 512, 768, 1_100, 2_000, 4_000, 9_000, 25_600, 51_200]);
        let pen = Pen {
            width,
            cap: rng.pick(&[Cap::Butt, Cap::Square, Cap::Round]),
            join: rng.pick(&[Join::Miter, Join::Bevel, Join::Round]),
            limit: 1024,
        };
        let model = Model::new(&path, pen);
        if model.is_near_limit() {
            continue;
        }
        cases_left -= 1;
        let runs = drawn(&segments(&path), &of_pen(pen), window);
        inside += runs.iter().map(|run| run.1.abs_diff(run.2) as usize).sum::<usize>();
        for ((x, y), is_drawn) in wrong(&model, &runs, window) {
            let what = || format!("({x}, {y}) is {is_drawn}: {pen:?} {path:?}\n{}", picture(window, &runs));
            assert!(!is_drawn, "{}", what());
            cracks.push(what());
        }
    }
    assert!(cracks.len() * 20_000 <= inside, "{} of {inside}\n{}", cracks.len(), cracks.concat());
    assert!(inside > 50_000 || cases(300) < 300, "{inside}");
}

/// One curve that turns sharply somewhere: hairpins, control points beside an end, cusps and what is nearly one, S, tiny curves.
#[expect(clippy::cast_possible_truncation, reason = "a place within some pixels")]
fn sharp_curve(rng: &mut Rng) -> Vec<Piece> {
    let (x, y) = (6_000, 5_000);
    let reach = rng.pick(&[20, 100, 600, 2_000, 5_000]);
    let place = |rng: &mut Rng| (x + rng.int(-reach, reach), y + rng.int(-reach, reach));
    let near = |rng: &mut Rng, at: (i32, i32)| {
        let reach = rng.pick(&[1, 2, 4, 16, 64, 256]);
        (at.0 + rng.int(-reach, reach), at.1 + rng.int(-reach, reach))
    };
    let [a, mut c, mut d, mut b] = [(); 4].map(|()| place(rng));
    match rng.below(10) {
        0 => c = near(rng, a),
        1 => d = near(rng, b),
        2 => (c, d) = (near(rng, a), near(rng, b)),
        3 => (c, d) = (near(rng, b), near(rng, a)),
        // There and back again.
        4 => (d, b) = (near(rng, c), near(rng, a)),
        5 => {
            let way = (c.0 - a.0, c.1 - a.1);
            b = near(rng, a);
            d = near(rng, (b.0 + way.0, b.1 + way.1));
        }
        // On one line, nearly.
        6 => {
            let way = (f64::from(b.0 - a.0), f64::from(b.1 - a.1));
            let on = |rng: &mut Rng| {
                let t = rng.unit() * 3.0 - 1.0;
                near(rng, (a.0 + (t * way.0) as i32, a.1 + (t * way.1) as i32))
            };
            (c, d) = (on(rng), on(rng));
        }
        // A cross: its loop may be a cusp, nearly.
        7 => {
            let (u, v) = ((c.0 - a.0, c.1 - a.1), (d.0 - a.0, d.1 - a.1));
            b = (a.0 + v.0, a.1 + v.1);
            (c, d) = ((a.0 + u.0 + v.0, a.1 + u.1 + v.1), (a.0 + u.0, a.1 + u.1));
            (c, d) = (near(rng, c), near(rng, d));
        }
        _ => {}
    }
    let piece = if rng.one_in(5) { Piece::Quadratic(c, b) } else { Piece::Cubic(c, d, b) };
    vec![Piece::Move(a), piece]
}

/// A pixel on the border of the stroke.
#[expect(clippy::cast_possible_truncation, reason = "a place within some hundred pixels")]
fn place_on_border(rng: &mut Rng, path: &[Piece], width: i32) -> (i32, i32) {
    let points: Vec<(f64, f64)> = match path {
        [Piece::Move(a), Piece::Quadratic(c, b)] => vec![*a, *c, *b],
        [Piece::Move(a), Piece::Cubic(c, d, b)] => vec![*a, *c, *d, *b],
        _ => panic!("a curve"),
    }
    .into_iter()
    .map(|(x, y)| (f64::from(x), f64::from(y)))
    .collect();
    let any = rng.unit();
    let t = rng.pick(&[any, 0.0, 0.5, 1.0, 0.01, 0.99]);
    let at = bezier(points.clone(), t);
    let way = bezier(points.windows(2).map(|p| (p[1].0 - p[0].0, p[1].1 - p[0].1)).collect(), t);
    let length = way.0.hypot(way.1);
    let half = f64::from(width) / 2.0 * if rng.one_in(2) { -1.0 } else { 1.0 };
    let at = if length > 0.0 { (at.0 - way.1 / length * half, at.1 + way.0 / length * half) } else { at };
    ((at.0 / 256.0) as i32, (at.1 / 256.0) as i32)
}

/// Curves that turn within a pixel, as far as a cusp: what the pen sweeps over is where the model has it. Each was wrong once, by as much as
/// the width of the stroke.
#[test]
fn pens_turn_as_the_curve_does() {
    let (butt, square) = ((Cap::Butt, Join::Miter), (Cap::Square, Join::Bevel));
    for (width, style, place, path) in [
        // Nearly on one line, to and fro: the pen turns by 152 degrees, and not by more.
        (51_200, butt, (-37, -67), [(4_055, 4_695), (5_553, 3_885), (4_054, 4_696), (5_552, 3_887)]),
        (25_600, butt, (-26, 21), [(6_336, 5_579), (6_189, 4_929), (6_336, 5_578), (6_185, 4_929)]),
        (9_000, butt, (29, 25), [(4_565, 6_055), (4_193, 6_684), (4_565, 6_054), (4_191, 6_682)]),
        // Shorter than a tenth of a pixel: its lines on the grid say nothing of where it goes.
        (4_000, butt, (20, 21), [(5_998, 4_991), (6_000, 4_993), (6_012, 5_003), (6_009, 5_000)]),
        (9_000, butt, (23, 20), [(5_991, 4_993), (6_012, 5_017), (6_019, 5_000), (6_003, 5_011)]),
        (25_600, butt, (47, -19), [(5_996, 4_983), (6_009, 4_999), (6_013, 4_986), (6_018, 5_013)]),
        // A hairpin.
        (9_000, butt, (10, 25), [(6_017, 5_008), (5_999, 5_008), (5_747, 5_002), (5_765, 5_001)]),
        (25_600, butt, (-11, 38), [(6_312, 5_110), (6_068, 4_648), (6_068, 4_645), (6_310, 5_110)]),
        // Slow at its end, which is a cap.
        (9_000, butt, (12, 12), [(5_981, 5_006), (5_981, 5_011), (6_017, 4_978), (6_011, 4_981)]),
        (2_000, square, (24, 19), [(8_228, 3_165), (6_186, 4_144), (6_202, 4_152), (6_202, 4_152)]),
        // Slow at its start, and 200 pixels wide.
        (51_200, butt, (9, 9), [(6_744, 4_851), (6_744, 4_851), (6_768, 4_870), (6_076, 5_889)]),
        // Uneven: it turns back on the inner side.
        (4_000, butt, (33, 13), [(9_331, 1_880), (10_029, 2_222), (9_384, 1_992), (9_068, 2_204)]),
        (9_000, butt, (12, 25), [(6_981, 5_002), (6_402, 5_254), (6_841, 4_997), (6_432, 5_005)]),
    ] {
        let path = [Piece::Move(path[0]), Piece::Cubic(path[1], path[2], path[3])];
        let pen = Pen { width, cap: style.0, join: style.1, limit: 1_024 };
        let window = Rect::new(place.0 - 20, place.1 - 20, place.0 + 20, place.1 + 20);
        let runs = drawn(&segments(&path), &of_pen(pen), window);
        let wrong = wrong(&Model::new(&path, pen), &runs, window);
        assert!(wrong.is_empty(), "{wrong:?} {pen:?} {path:?}\n{}", picture(window, &runs));
    }
}

/// Of curves that turn sharply, in a window on their border, one in some thousands has a wrong pixel: a crack where parts of the inner
/// border overlap by less than both may be off, or a corner of a pen of 200 pixels.
#[test]
fn sharp_curves_are_within_a_seventh() {
    let mut rng = Rng::new(564);
    let (mut bad, mut inside, all) = (vec![], 0, cases(2_000));
    for _ in 0..all {
        let path = sharp_curve(&mut rng);
        let width = rng.pick(&[256, 300, 321, 400, 512, 768, 1_100, 2_000, 4_000, 9_000, 25_600, 51_200]);
        let pen = Pen { width, cap: rng.pick(&[Cap::Butt, Cap::Square, Cap::Round]), join: Join::Miter, limit: 1_024 };
        let (x, y) = place_on_border(&mut rng, &path, width);
        let window = Rect::new(x - 16, y - 12, x + 16, y + 12);
        let runs = drawn(&segments(&path), &of_pen(pen), window);
        inside += count(&runs);
        let wrong = wrong(&Model::new(&path, pen), &runs, window);
        if !wrong.is_empty() {
            bad.push(format!("{wrong:?} {pen:?} {path:?}\n{}", picture(window, &runs)));
        }
    }
    assert!(bad.len() * 1_000 <= all, "{} of {all}\n{}", bad.len(), bad.concat());
    assert!(inside > 0, "nothing is inside");
}

/// Dashes of wide strokes, in a window on their border: many of them end where the curve turns within a pixel, and take their share of
/// the turn. There a hair along the curve is a pixel at the border. One in some thousands has a wrong pixel, as without dashes.
#[test]
fn wide_dashes_are_within_a_seventh() {
    let mut rng = Rng::new(567);
    let (mut bad, mut inside, all) = (vec![], 0, cases(4_000));
    for i in 0..all {
        let path = if i % 2 == 0 { path(&mut rng) } else { sharp_curve(&mut rng) };
        let pen = Pen {
            width: rng.pick(&[512, 768, 1_100, 2_000, 4_000, 9_000]),
            cap: rng.pick(&[Cap::Butt, Cap::Square, Cap::Round]),
            join: rng.pick(&[Join::Bevel, Join::Round]),
            limit: 1_024,
        };
        let (x, y) = if i % 2 == 0 { (24, 20) } else { place_on_border(&mut rng, &path, pen.width) };
        let (count, wrong) = check_dashes(&mut rng, &path, pen, Rect::new(x - 24, y - 20, x + 24, y + 20));
        inside += count;
        bad.extend(wrong);
    }
    assert!(bad.len() * 1_000 <= all, "{} of {all}\n{}", bad.len(), bad.concat());
    assert!(inside > 0, "nothing is inside");
}

/// Random dashes of a path: how many pixels they have, and what is wrong.
fn check_dashes(rng: &mut Rng, path: &[Piece], pen: Pen, window: Rect) -> (i32, Option<String>) {
    // Of 9,000 units a pattern below 1/64 would be solid.
    let lengths: Vec<i32> = (0..2 * rng.int(1, 2)).map(|_| rng.int(71, 2_000)).collect();
    let phase = rng.int(-5_000, 5_000);
    let floats: Vec<f64> = lengths.iter().map(|&n| f64::from(n)).collect();
    let fixed: Vec<I24F8> = lengths.iter().map(|&n| I24F8::from_bits(n)).collect();
    let model = Model::dashed(path, pen, &floats, f64::from(phase));
    let runs = drawn(&segments(path), &of_pen(pen).dashed(&fixed, I24F8::from_bits(phase)), window);
    let wrong = wrong(&model, &runs, window);
    let what = || format!("{wrong:?} {pen:?} {lengths:?} from {phase} on, {path:?}\n{}", picture(window, &runs));
    (count(&runs), (!wrong.is_empty()).then(what))
}

/// Dashes of narrow strokes.
#[test]
fn dashes_are_within_a_seventh() {
    let mut rng = Rng::new(565);
    let mut inside = 0;
    for _ in 0..cases(1_000) {
        let path = path(&mut rng);
        let pen = Pen {
            width: rng.pick(&[256, 300, 321, 400]),
            cap: rng.pick(&[Cap::Butt, Cap::Square, Cap::Round]),
            join: rng.pick(&[Join::Bevel, Join::Round]),
            limit: 1_024,
        };
        let (count, wrong) = check_dashes(&mut rng, &path, pen, Rect::new(0, 0, 48, 40));
        inside += count;
        assert!(wrong.is_none(), "{}", wrong.unwrap_or_default());
    }
    assert!(inside > 0, "nothing is inside");
}

/// Around the end of a long path its dashes lie where the model has them, and there are more pixels than a few.
fn dashes_are_in_place_at(at: (i32, i32), path: &[Piece], pen: Pen, few: i32, what: &str) {
    let mut model = Model::dashed(path, pen, &[1_500.0, 1_400.0], 0.0);
    model.keep_near((f64::from(at.0), f64::from(at.1)), 14_000.0 + f64::from(pen.width));
    let (x, y) = (at.0 / 256, at.1 / 256);
    let window = Rect::new(x - 14, y - 14, x + 14, y + 14);
    let lengths = [1_500, 1_400].map(I24F8::from_bits);
    let runs = drawn(&segments(path), &of_pen(pen).dashed(&lengths, I24F8::ZERO), window);
    let wrong = wrong(&model, &runs, window);
    assert!(wrong.is_empty(), "{what}: {wrong:?}\n{}", picture(window, &runs));
    assert!(count(&runs) > few, "{what}: {}", picture(window, &runs));
}

/// At the end of paths of 60,000 pixels, to and fro, in lines or curves: dashes are where the length of all that comes before puts them.
#[test]
fn dashes_do_not_drift() {
    let mut rng = Rng::new(566);
    let pen = Pen { width: 1_024, cap: Cap::Butt, join: Join::Round, limit: 1_024 };
    for (size, is_curved) in [(1, false), (4, false), (4, true), (16, true), (100, true)] {
        let step = size * 256;
        let (mut path, mut at, mut base, mut way) = (vec![Piece::Move((0, 0))], (0, 0), 0, 1);
        for _ in 0..60_000 / size {
            if at.0 * way > 250_000 {
                (way, base) = (-way, base + 5 * step + 6_000);
            }
            let to = (at.0 + way * step, base + rng.int(-step / 2, step / 2));
            let above = base + 2 * step;
            path.push(if is_curved { Piece::Cubic((at.0, above), (to.0, above), to) } else { Piece::Line(to) });
            at = to;
        }
        dashes_are_in_place_at(at, &path, pen, 20, &format!("{size} {is_curved}"));
    }
}

/// At the end of thousands of curves of a pixel or some, which stand still for a moment or turn back: parts that end on the place where
/// they start have a length too.
#[test]
fn dashes_do_not_drift_on_cusps() {
    let mut rng = Rng::new(568);
    for (i, width) in [256, 400, 1_024, 9_000, 256, 1_024].into_iter().enumerate() {
        let pen = Pen { width, cap: Cap::Butt, join: Join::Round, limit: 1_024 };
        let (mut path, mut at) = (vec![Piece::Move((0, 0))], (0, 0));
        // No longer with more cases: all that is rounded adds up.
        for _ in 0..cases(4_000).min(4_000) {
            let step = rng.int(100, 500);
            let to = (at.0 + step, at.1 + rng.int(-step, step));
            let near = |rng: &mut Rng, p: (i32, i32)| (p.0 + rng.int(-i32::from(i > 3), 1), p.1 + rng.int(-1, 1));
            path.push(match rng.below(4) {
                0 => Piece::Cubic(near(&mut rng, at), near(&mut rng, to), to),
                1 => Piece::Quadratic((2 * to.0 - at.0, 2 * to.1 - at.1), to),
                _ => Piece::Cubic(near(&mut rng, to), near(&mut rng, at), to),
            });
            at = to;
        }
        dashes_are_in_place_at(at, &path, pen, 3, &format!("{i} {width}"));
    }
}

/// A ring whose radius is below half of its pen, all around or where it bends most, has no hole there: each place in it is within half a
/// width of some place of the ring, at a right angle to it. So it is for rings of a circle: they are discs.
#[test]
#[expect(clippy::cast_possible_truncation, reason = "a place within some hundred pixels")]
fn rings_narrower_than_half_of_their_pen_are_full() {
    let mut rng = Rng::new(569);
    let window = Rect::new(0, 0, 48, 40);
    for i in 0..cases(600) {
        let (x, y) = (rng.int(5_000, 7_000), rng.int(4_000, 6_000));
        let a = f64::from(rng.int(40, 2_000));
        let b = if i % 2 == 0 { a } else { a * rng.unit().max(0.02) };
        let (sin, cos) = (rng.unit() * 7.0).sin_cos();
        let at = |u: f64, v: f64| {
            let (u, v) = (u * a, v * b);
            (x + (u * cos - v * sin).round() as i32, y + (u * sin + v * cos).round() as i32)
        };
        let k = 0.552_284_75;
        let path = [
            Piece::Move(at(1.0, 0.0)),
            Piece::Cubic(at(1.0, k), at(k, 1.0), at(0.0, 1.0)),
            Piece::Cubic(at(-k, 1.0), at(-1.0, k), at(-1.0, 0.0)),
            Piece::Cubic(at(-1.0, -k), at(-k, -1.0), at(0.0, -1.0)),
            Piece::Cubic(at(k, -1.0), at(1.0, -k), at(1.0, 0.0)),
            Piece::Close,
        ];
        let width = (2.0 * a * (1.0 + rng.unit())) as i32 + rng.int(2, 2_000);
        let pen = Pen { width, cap: Cap::Butt, join: rng.pick(&[Join::Miter, Join::Bevel, Join::Round]), limit: 1_024 };
        let runs = drawn(&segments(&path), &of_pen(pen), window);
        let wrong = wrong(&Model::new(&path, pen), &runs, window);
        assert!(wrong.is_empty(), "{i}: {wrong:?} {pen:?} {path:?}\n{}", picture(window, &runs));
        let is_full = |r: &Run| i % 2 != 0 || runs.iter().filter(|other| other.0 == r.0).count() == 1;
        assert!(runs.iter().all(is_full), "{i}: {pen:?} {path:?}\n{}", picture(window, &runs));
    }
}

/// A round dot has the pixels of the circle, ties and all.
#[test]
fn round_dots_are_circles() {
    let mut rng = Rng::new(563);
    let window = Rect::new(0, 0, 48, 40);
    for i in 0..cases(6_000) {
        let grid = rng.pick(&[1, 128, 256]);
        let mut unit = |low: i32, high: i32| rng.int(low, high) / grid * grid;
        let (at, width) = (PointFx::from_bits(unit(0, 12_000), unit(0, 10_000)), I24F8::from_bits(unit(256, 9_000)));
        let got = drawn(&[MoveTo(at), LineTo(at)], &Stroke::new(width).with_cap(Cap::Round), window);
        let wanted = collect(window, |emit| ellipse::fill(Ellipse::splat(at, width), window, emit));
        twins::assert_runs(window, &got, &wanted, || format!("{i}: {at:?} {width}"));
    }
}

/// A circle around the centre or the corner of a pixel is the same from all sides.
#[test]
fn circles_on_the_grid_are_symmetric() {
    let window = Rect::new(0, 0, 24, 24);
    for radius in (1..2_800).chain([1_024, 1_280, 2_560]) {
        for (x, y) in [(12 * 256, 12 * 256), (11 * 256 + 128, 11 * 256 + 128), (12 * 256, 11 * 256 + 128)] {
            let circle = Ellipse::circle(PointFx::from_bits(x, y), I24F8::from_bits(radius));
            let runs = collect(window, |emit| ellipse::fill(circle, window, emit));
            let (sum_x, sum_y) = (2 * x / 256, 2 * y / 256);
            for &(row, x0, x1) in &runs {
                assert_eq!(x0 + x1, sum_x, "row {row} of radius {radius} at {x} {y}");
                assert!(runs.contains(&(sum_y - 1 - row, x0, x1)), "row {row} of radius {radius} at {x} {y}");
            }
        }
    }
    let circle = Ellipse::circle(PointFx::from_bits(1_408, 1_408), px(4));
    let runs = collect(window, |emit| ellipse::fill(circle, window, emit));
    assert!(runs.contains(&(5, 1, 10)), "{runs:?}");
}

/// Backwards, and a ring from any of its corners on.
#[test]
fn strokes_have_no_start() {
    let mut rng = Rng::new(562);
    let window = Rect::new(-2, -2, 50, 42);
    for _ in 0..cases(6_000) {
        let path = path(&mut rng);
        let pen = Pen {
            width: rng.pick(&[256, 300, 330, 512, 700, 1_500, 4_000, 9_000]),
            cap: rng.pick(&[Cap::Butt, Cap::Square, Cap::Round]),
            join: rng.pick(&[Join::Miter, Join::Bevel, Join::Round]),
            limit: rng.pick(&[256, 1_024, 5_000]),
        };
        let (stroke, forwards) = (of_pen(pen), segments(&path));
        let wanted = drawn(&forwards, &stroke, window);
        let got = drawn(&segments(&backwards(&path)), &stroke, window);
        twins::assert_runs(window, &got, &wanted, || format!("{pen:?} backwards {path:?}"));
        if path.last() == Some(&Piece::Close) {
            let got = drawn(&segments(&turned(&path)), &stroke, window);
            twins::assert_runs(window, &got, &wanted, || format!("{pen:?} from the second corner on {path:?}"));
        }
    }
}

fn end(piece: &Piece) -> (i32, i32) {
    match *piece {
        Piece::Move(a) | Piece::Line(a) | Piece::Quadratic(_, a) | Piece::Cubic(_, _, a) => a,
        Piece::Close => panic!("no end"),
    }
}

/// A path of one contour from its end to its start.
fn backwards(path: &[Piece]) -> Vec<Piece> {
    let closed = path.last() == Some(&Piece::Close);
    let open = &path[..path.len() - usize::from(closed)];
    let mut all = vec![Piece::Move(end(&open[open.len() - 1]))];
    for pair in open.windows(2).rev() {
        let to = end(&pair[0]);
        all.push(match pair[1] {
            Piece::Quadratic(c, _) => Piece::Quadratic(c, to),
            Piece::Cubic(c, d, _) => Piece::Cubic(d, c, to),
            _ => Piece::Line(to),
        });
    }
    all.extend(closed.then_some(Piece::Close));
    all
}

/// A ring from its second corner on.
fn turned(path: &[Piece]) -> Vec<Piece> {
    let (start, second) = (end(&path[0]), end(&path[1]));
    let mut all = vec![Piece::Move(second)];
    all.extend_from_slice(&path[2..path.len() - 1]);
    all.extend([Piece::Line(start), path[1].clone(), Piece::Close]);
    all
}
