//! Strokes against what a stroke is: the places within half a width of the true curve, at right angles to it, and caps and joins
//! that stand on its tangents. Every pixel whose centre is farther than 0.14 pixel from the border is right.

use crate::stroke::islands;
use embedded_raster::{
    px,
    raster::{ellipse, stroke as thick},
    Cap, EdgeSlot, Ellipse, Join, Path, PathSegment, PointFx, Rect, Stroke,
};
use fixed::types::I24F8;
use twins::{
    collect,
    curves::{segments, Piece},
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
        for y in window.y0..window.y1 {
            for x in window.x0..window.x1 {
                let centre = (f64::from(x * 256 + 128), f64::from(y * 256 + 128));
                let got = runs.iter().any(|r| r.0 == y && r.1 <= x && x < r.2);
                inside += usize::from(got);
                let wanted = model.contains(centre);
                if wanted != got && !model.has_near(centre, REACH, got) {
                    let what = || format!("({x}, {y}) is {got}: {pen:?} {path:?}\n{}", picture(window, &runs));
                    assert!(wanted, "{}", what());
                    cracks.push(what());
                }
            }
        }
    }
    assert!(cracks.len() * 20_000 <= inside, "{} of {inside}\n{}", cracks.len(), cracks.concat());
    assert!(inside > 50_000 || cases(300) < 300, "{inside}");
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
