//! Strokes: every pixel against the pieces that the rule makes in integers of 128 bits, and against the plane's own measure:
//! how far a place is from the line.

use std::collections::HashSet;

use embedded_raster::{
    px,
    raster::stroke::{self as thick, Dashing},
    Cap, ClippedSpan, EdgeSlot, FillRule, Join, Path, PathSegment, PointFx, Rect, Stroke,
};
use fixed::types::I24F8;
use twins::{
    assert_runs, collect,
    curves::{distance, outlines_for, places, random_path, segments, Outline, Piece},
    rng::{cases, Rng},
    scenes::{outline, window_on, Scale},
    strokes::{Pattern, Pen},
    vertices, Run, Units,
};

const CAPS: [Cap; 3] = [Cap::Butt, Cap::Square, Cap::Round];
const JOINS: [Join; 3] = [Join::Miter, Join::Bevel, Join::Round];
const PX: i32 = 256;

fn stroke(pen: Pen) -> Stroke {
    Stroke::new(I24F8::from_bits(pen.width))
        .with_cap(pen.cap)
        .with_join(pen.join)
        .with_miter_limit(I24F8::from_bits(pen.limit))
        .with_min_width(px(0))
}

/// By a table that is as long as it takes.
fn stroked<D: Dashing>(path: Path<'_>, stroke: &Stroke<D>, window: Rect) -> Vec<Run> {
    let mut count = 0;
    thick::border(path, stroke, window, |_, _| count += 1);
    let mut table = vec![EdgeSlot::EMPTY; count];
    collect(window, |emit| thick::fill(path, stroke, &mut table, window, emit).expect("enough slots"))
}

fn path_pixels(pieces: &[Piece], pen: Pen, window: Rect) -> Vec<Run> {
    stroked(Path::new(&segments(pieces)), &stroke(pen), window)
}

fn polyline_pixels(units: &[Units], closed: bool, pen: Pen, window: Rect) -> Vec<Run> {
    let (places, stroke) = (vertices(units), stroke(pen));
    let mut table = vec![EdgeSlot::EMPTY; polyline_lines(&places, closed, &stroke, window).len()];
    collect(window, |emit| {
        thick::fill_polyline(&places, closed, &stroke, &mut table, window, emit).expect("enough slots");
    })
}

fn polyline_lines<D: Dashing>(
    places: &[PointFx],
    closed: bool,
    stroke: &Stroke<D>,
    window: Rect,
) -> Vec<(PointFx, PointFx)> {
    let mut lines = vec![];
    thick::border_of_polyline(places, closed, stroke, window, |a, b| lines.push((a, b)));
    lines
}

fn polyline(units: &[Units], closed: bool) -> Outline {
    Outline { places: units.to_vec(), smooth: vec![false; units.len()], closed, parts: vec![] }
}

fn random_pen(rng: &mut Rng, widest: i32) -> Pen {
    let width = match rng.below(6) {
        0 => rng.pick(&[0, 1, 2, 255, 256, 257, 512]),
        1 | 2 => rng.int(1, 1_500),
        _ => rng.int(1, widest),
    };
    let limit = rng.pick(&[0, 256, 300, 1024, 1024, 2560, 0xffff]);
    Pen { width, cap: rng.pick(&CAPS), join: rng.pick(&JOINS), limit }
}

fn paths(scale: Scale, count: usize, widest: i32) {
    let mut rng = Rng::new(500 + scale as u64);
    let (count, mut seen) = (cases(count), 0);
    for _ in 0..count {
        let path = random_path(&mut rng, scale, 2);
        let pen = random_pen(&mut rng, widest);
        let window = window_on(&mut rng, &[places(&path), vec![(0, 0)]].concat());
        let contours = pen.parts(&outlines_for(&path, pen.width));
        let wanted = twins::polygon(&contours, FillRule::NonZero, window);
        let got = path_pixels(&path, pen, window);
        assert_runs(window, &got, &wanted, || format!("{pen:?} {path:?}"));
        seen += usize::from(!wanted.is_empty());
    }
    assert!(seen >= count / 8, "only {seen} strokes were seen");
}

#[test]
fn tiny_paths() {
    paths(Scale::Tiny, 8_000, 5_000);
}

#[test]
fn screen_paths() {
    paths(Scale::Screen, 1_500, 12_000);
}

#[test]
fn paths_of_a_hundred_screens() {
    paths(Scale::Hundred, 300, 900_000);
}

#[test]
fn paths_at_the_ends_of_the_type() {
    paths(Scale::Ends, 60, 1 << 24);
}

/// As many slots as the fullest row takes, or any number between that and all: the same pixels. With one less there is an error, and
/// nothing is drawn.
#[test]
fn tables_of_every_length() {
    let mut rng = Rng::new(533);
    let mut banded = 0;
    for i in 0..cases(2_000) {
        let path = random_path(&mut rng, Scale::ALL[i % 3], 2);
        let (segments, pen) = (segments(&path), random_pen(&mut rng, 6_000));
        let window = window_on(&mut rng, &[places(&path), vec![(0, 0)]].concat());
        let lengths = [(); 2].map(|()| I24F8::from_bits(rng.int(200, 4_000)));
        let (solid, path) = (stroke(pen), Path::new(&segments));
        let dashed = solid.dashed(&lengths, I24F8::from_bits(rng.int(-4_000, 4_000)));
        banded += if i % 2 == 0 {
            every_length(&mut rng, path, &solid, window)
        } else {
            every_length(&mut rng, path, &dashed, window)
        };
    }
    assert!(banded > cases(2_000) / 2, "{banded} tables were too short for all at once");
}

/// How many tables were shorter than all sides.
fn every_length<D: Dashing>(rng: &mut Rng, path: Path<'_>, stroke: &Stroke<D>, window: Rect) -> usize {
    let slots = thick::edge_slots(path, stroke, window);
    let drawn = |len: usize| {
        let (mut table, mut result) = (vec![EdgeSlot::EMPTY; len], Ok(()));
        let runs = collect(window, |emit| result = thick::fill(path, stroke, &mut table, window, emit));
        (runs, result)
    };
    let (wanted, result) = drawn(slots.whole);
    assert_eq!(result, Ok(()), "{slots:?}");
    for _ in 0..4 {
        let len = slots.least + rng.index(slots.whole - slots.least + 1);
        let (got, result) = drawn(len);
        assert_eq!(result, Ok(()), "{len} of {slots:?}");
        assert_runs(window, &got, &wanted, || format!("{len} of {slots:?}: {:?}", path.segments()));
    }
    if let Some(fewer) = slots.least.checked_sub(1) {
        let (got, result) = drawn(fewer);
        assert!(got.is_empty() && result.is_err_and(|error| error.enough == slots.least), "{slots:?}: {got:?}");
    }
    if slots.least < slots.whole {
        4
    } else {
        0
    }
}

#[test]
fn polylines() {
    let mut rng = Rng::new(510);
    for i in 0..cases(8_000) {
        let n = 1 + rng.index(6);
        let units = outline(&mut rng, Scale::ALL[i % 4], n);
        let (pen, closed) = (random_pen(&mut rng, 6_000), rng.one_in(2));
        let window = window_on(&mut rng, &units);
        let wanted = twins::polygon(&pen.parts(&[polyline(&units, closed)]), FillRule::NonZero, window);
        let got = polyline_pixels(&units, closed, pen, window);
        assert_runs(window, &got, &wanted, || format!("{pen:?} closed {closed} {units:?}"));
    }
}

/// Drawn backwards, a stroke is the same.
#[test]
fn direction_does_not_matter() {
    let mut rng = Rng::new(511);
    let window = Rect::new(-2, -2, 40, 34);
    for _ in 0..cases(4_000) {
        let n = 2 + rng.index(4);
        let mut units: Vec<Units> = (0..n).map(|_| (rng.int(-500, 9_000), rng.int(-500, 8_000))).collect();
        // The fan of a round join begins on one of both sides.
        let pen = Pen { join: rng.pick(&[Join::Miter, Join::Bevel]), ..random_pen(&mut rng, 3_000) };
        let pen = Pen { cap: rng.pick(&[Cap::Butt, Cap::Square]), ..pen };
        let closed = rng.one_in(2);
        let wanted = polyline_pixels(&units, closed, pen, window);
        units.reverse();
        assert_runs(window, &polyline_pixels(&units, closed, pen, window), &wanted, || format!("{pen:?} {units:?}"));
    }
}

/// With everything round a stroke is what lies within half a width of its line. Pixels that are farther than 1/8 pixel (and the
/// rounding of vertices) from the border agree.
#[test]
fn round_strokes_are_what_is_near_the_line() {
    let mut rng = Rng::new(512);
    let window = Rect::new(0, 0, 40, 32);
    let mut far = 0;
    for _ in 0..3_000 {
        let n = 1 + rng.index(5);
        let units: Vec<Units> = (0..n).map(|_| (rng.int(-2_000, 12_000), rng.int(-2_000, 10_000))).collect();
        let pen = Pen { cap: Cap::Round, join: Join::Round, ..random_pen(&mut rng, 4_000) };
        let runs = polyline_pixels(&units, false, pen, window);
        let painted: HashSet<(i32, i32)> = runs.iter().flat_map(|r| (r.1..r.2).map(|x| (x, r.0))).collect();
        let float = |p: Units| (f64::from(p.0), f64::from(p.1));
        for y in window.y0..window.y1 {
            for x in window.x0..window.x1 {
                let centre = float((x * PX + 128, y * PX + 128));
                let near = units
                    .iter()
                    .zip(units.iter().skip(1).chain(units.last()))
                    .map(|(&a, &b)| distance(centre, float(a), float(b)))
                    .fold(f64::MAX, f64::min);
                let out = near - f64::from(pen.width) / 2.0;
                if !(-32.5..=2.0).contains(&out) {
                    assert_eq!(painted.contains(&(x, y)), out < 0.0, "({x}, {y}) {out} of {pen:?} {units:?}");
                    far += 1;
                }
            }
        }
    }
    assert!(far > 1_000_000, "only {far} pixels were far from the border");
}

/// Butt and square ends: along the line and across it.
/// At its end this curve is slow, as the last control point is near: nearly all of its turn is in the last two pixels. The true border
/// comes to row 48 at column 9, and 0.14 pixels inside of it at column 10; by the turn that the mean speed tells, it came there at column
/// 12, 0.31 pixels inside.
#[test]
fn curves_that_turn_where_they_are_slow() {
    let [a, d, b] = [(39_788, 13_521), (2_961, 12_541), (2_596, 12_831)].map(|(x, y)| PointFx::from_bits(x, y));
    let path = [PathSegment::MoveTo(a), PathSegment::CubicTo(a, d, b)];
    let runs = stroked(Path::new(&path), &Stroke::new(I24F8::from_bits(913)), Rect::new(0, 0, 60, 60));
    assert!(runs.first().is_some_and(|&(y, x0, _)| y == 48 && x0 <= 10), "{runs:?}");
}

#[test]
fn lines_are_rectangles() {
    let mut rng = Rng::new(513);
    let window = Rect::new(0, 0, 40, 32);
    for _ in 0..cases(4_000) {
        let [a, b] = [(); 2].map(|()| (rng.int(0, 10_000), rng.int(0, 8_000)));
        let pen = Pen { cap: rng.pick(&[Cap::Butt, Cap::Square]), ..random_pen(&mut rng, 3_000) };
        let runs = polyline_pixels(&[a, b], false, pen, window);
        let (dx, dy) = (f64::from(b.0 - a.0), f64::from(b.1 - a.1));
        let (length, half) = (dx.hypot(dy), f64::from(pen.width) / 2.0);
        let more = if pen.cap == Cap::Square { half } else { 0.0 };
        for y in window.y0..window.y1 {
            for x in window.x0..window.x1 {
                let (px, py) = (f64::from(x * PX + 128 - a.0), f64::from(y * PX + 128 - a.1));
                let (along, across) = ((px * dx + py * dy) / length, (px * dy - py * dx) / length);
                let out = (across.abs() - half).max(-more - along).max(along - length - more);
                if out.abs() > 2.9 {
                    let painted = runs.iter().any(|r| r.0 == y && r.1 <= x && x < r.2);
                    assert_eq!(painted, out < 0.0, "({x}, {y}) {out} of {pen:?} {a:?} {b:?}");
                }
            }
        }
    }
}

/// The borders of a side are as far from each other as it is wide, or up to 2 sqrt(2) units and a 2^28th farther: measured across
/// the side, in every direction, in integers.
#[test]
#[expect(clippy::cast_precision_loss, reason = "only to say how near to the limit it comes")]
fn a_side_is_as_thick_as_it_is_wide() {
    let mut rng = Rng::new(517);
    let window = Rect::new(-(1 << 23), -(1 << 23), 1 << 23, 1 << 23);
    let (mut most, mut least) = (0.0_f64, f64::MAX);
    for i in 0..cases(400_000) {
        let far = 1_i32 << rng.int(0, 30);
        let (x, y) = (rng.int(-far, far), rng.int(-far, far));
        let hair = rng.int(-3, 3);
        let d = match i % 4 {
            // Near 45 degrees, and near the axes.
            0 => (x, rng.pick(&[x, -x]).saturating_add(hair)),
            1 => rng.pick(&[(x, hair), (hair, y)]),
            _ => (x, y),
        };
        // Half a width fits beside both ends.
        let end = i32::MAX - (1 << 24);
        let mut a = (rng.int(-end, end), rng.int(-end, end));
        let mut b = (a.0.saturating_add(d.0).clamp(-end, end), a.1.saturating_add(d.1).clamp(-end, end));
        if i % 4 == 3 {
            b = (rng.int(-end, end), rng.int(-end, end));
            a = rng.pick(&[a, (b.1, b.0), (-b.0, -b.1), (-end, -end)]);
        }
        if a == b {
            continue;
        }
        let width = rng.int(0, 1 << 24) >> rng.int(0, 24);
        let stroke = Stroke::new(I24F8::from_bits(width));
        // The first line goes across, from the left to the right, perhaps by the middle.
        let corners = polyline_lines(&vertices(&[a, b]), false, &stroke.with_min_width(px(0)), window);
        let (q, middle) = corners[0];
        let p = if middle == PointFx::from_bits(a.0, a.1) && width > 0 { corners[1].1 } else { middle };
        let bits = |v: PointFx| (i128::from(v.x.to_bits()), i128::from(v.y.to_bits()));
        // The thickness is `across / |d|`.
        let ((px, py), (qx, qy)) = (bits(p), bits(q));
        let (dx, dy) = (twins::wide(b).0 - twins::wide(a).0, twins::wide(b).1 - twins::wide(a).1);
        let (across, square, w) = ((dx * (py - qy) - dy * (px - qx)).abs(), dx * dx + dy * dy, i128::from(width));
        assert!(across * across >= w * w * square, "thinner than {width}: {a:?} {b:?} {corners:?}");
        // |d| times 2^scale, rounded up to a whole number of 63 bits; and 2^28 sqrt(8), rounded down.
        let scale = (square.leading_zeros() - 2) / 2;
        let length = (square << (2 * scale)).isqrt() + 1;
        let limit = (w << 28) + w + 759_250_124;
        assert!(across << scale << 28 <= limit * length, "thicker than {width}: {a:?} {b:?} {corners:?}");
        let excess = across as f64 / (square as f64).sqrt() - f64::from(width);
        (most, least) = (most.max(excess), least.min(excess));
    }
    assert!(most > 2.7 && least < 0.01, "{least} to {most} units thicker");
}

/// How many pieces the pixels fall into, corners counting as neighbours.
pub(crate) fn islands(runs: &[Run]) -> usize {
    let mut left: HashSet<(i32, i32)> = runs.iter().flat_map(|r| (r.1..r.2).map(|x| (x, r.0))).collect();
    let mut count = 0;
    while let Some(&start) = left.iter().next() {
        count += 1;
        let mut stack = vec![start];
        left.remove(&start);
        while let Some((x, y)) = stack.pop() {
            for (dx, dy) in [(-1, -1), (0, -1), (1, -1), (-1, 0), (1, 0), (-1, 1), (0, 1), (1, 1)] {
                if left.remove(&(x + dx, y + dy)) {
                    stack.push((x + dx, y + dy));
                }
            }
        }
    }
    count
}

/// One pixel wide, at any angle and any place: never a gap. From each pixel of a side or near its ends, as far as caps,
/// bevels and round joins go, one of the next two along the side is painted too. Only the tip of a long miter, thinner than a
/// pixel, may hit a pixel that stands alone.
#[test]
fn a_width_of_one_pixel_stays_connected() {
    let mut rng = Rng::new(514);
    let window = Rect::new(-4, -4, 60, 52);
    for i in 0..cases(40_000) {
        let n = if i % 2 == 0 { 2 } else { 2 + rng.index(4) };
        let mut units: Vec<Units> = (0..n).map(|_| (rng.int(0, 14_000), rng.int(0, 12_000))).collect();
        if rng.one_in(3) {
            // Nearly horizontal, vertical, diagonal.
            let (x, y) = (rng.int(-3, 3), rng.int(-3, 3));
            let far = rng.int(500, 5_000);
            let (dx, dy) = rng.pick(&[(far, 0), (0, far), (far, far)]);
            units = vec![units[0], (units[0].0 + dx + x, units[0].1 + dy + y)];
        }
        let pen = Pen { width: 256, cap: rng.pick(&CAPS), join: rng.pick(&JOINS[1..]), limit: 1024 };
        let runs = polyline_pixels(&units, false, pen, window);
        assert!(islands(&runs) <= 1, "{pen:?} {units:?}\n{}", twins::picture(window, &runs));
    }
}

/// Overlaps are painted once, and tiles show the same.
#[test]
fn tiles_show_the_same_stroke() {
    let mut rng = Rng::new(515);
    let whole = Rect::new(-3, -3, 45, 37);
    for _ in 0..150 {
        let path = random_path(&mut rng, Scale::Tiny, 3);
        let pen = random_pen(&mut rng, 3_000);
        let all = path_pixels(&path, pen, whole);
        for size in twins::TILE_SIZES {
            let mut hits = twins::hits::Hits::new(whole);
            for tile in twins::tiles(whole, size) {
                hits.add(&path_pixels(&path, pen, tile));
            }
            assert_runs(whole, &hits.runs(), &all, || format!("{pen:?} {path:?} in tiles of {size:?}"));
        }
    }
}

/// Pieces that a window does not show are not made.
#[test]
fn work_depends_on_the_window() {
    let mut rng = Rng::new(516);
    let mut most = 0;
    for _ in 0..2_000 {
        let path = segments(&random_path(&mut rng, Scale::Ends, 1));
        let pen = Pen { width: 1000, ..random_pen(&mut rng, 1000) };
        let window = Rect::new(0, 0, 48, 40);
        let mut count = 0;
        thick::border(Path::new(&path), &stroke(pen), window, |_, _| count += 1);
        most = most.max(count);
    }
    assert!(most < 1_200, "{most} lines for a window");
}

/// Where sides meet, nothing goes across, and the inner side of the corner is cut short.
#[test]
fn lines_of_a_border() {
    let lines = |cap, join| {
        let corner = [PointFx::px(0, 0), PointFx::px(10, 0), PointFx::px(10, 10)];
        let stroke = Stroke::px(2).with_cap(cap).with_join(join);
        polyline_lines(&corner, false, &stroke, Rect::new(0, 0, 20, 20))
    };
    let px = |list: &[(i32, i32)]| -> Vec<(PointFx, PointFx)> {
        list.chunks(2).map(|ends| (PointFx::px(ends[0].0, ends[0].1), PointFx::px(ends[1].0, ends[1].1))).collect()
    };
    let start = px(&[(0, -1), (0, 1)]);
    let first = px(&[(0, 1), (10, 1), (10, -1), (0, -1)]);
    let second = px(&[(10, 1), (9, 0), (9, 0), (9, 10), (11, 10), (11, 0)]);
    let end = px(&[(9, 10), (11, 10)]);
    let bevel = px(&[(11, 0), (10, -1)]);
    let all = |start: &[_], join: &[_], end: &[_]| [start, &first, join, &second, end].concat();
    assert_eq!(lines(Cap::Butt, Join::Bevel), all(&start, &bevel, &end));
    let miter = px(&[(11, 0), (11, -1), (11, -1), (10, -1)]);
    assert_eq!(lines(Cap::Butt, Join::Miter), all(&start, &miter, &end));
    let caps = [
        px(&[(0, -1), (-1, -1), (-1, -1), (-1, 1), (-1, 1), (0, 1)]),
        px(&[(9, 10), (9, 11), (9, 11), (11, 11), (11, 11), (11, 10)]),
    ];
    assert_eq!(lines(Cap::Square, Join::Miter), all(&caps[0], &miter, &caps[1]));
}

fn dashed_pixels(pieces: &[Piece], pen: Pen, pattern: &Pattern, window: Rect) -> Vec<Run> {
    let path = segments(pieces);
    let lengths: Vec<I24F8> = pattern.lengths.iter().map(|&n| I24F8::from_bits(n)).collect();
    stroked(Path::new(&path), &stroke(pen).dashed(&lengths, I24F8::from_bits(pattern.phase)), window)
}

fn dashes(scale: Scale, count: usize, (least, most): (i32, i32)) {
    let mut rng = Rng::new(520 + scale as u64);
    let (count, mut seen) = (cases(count), 0);
    for _ in 0..count {
        let mut path = random_path(&mut rng, scale, 2);
        let all = [places(&path), vec![(0, 0)]].concat();
        path.insert(0, Piece::Move(all[0]));
        let pen = random_pen(&mut rng, 2_000);
        let n = 1 + rng.index(5);
        let mut lengths: Vec<i32> = (0..n).map(|_| rng.int(least, most)).collect();
        if n > 1 && rng.one_in(3) {
            lengths[n - 1] = rng.pick(&[0, -5]);
        }
        let phase = if rng.one_in(3) { 0 } else { rng.int(-3 * most.min(1 << 29), 3 * most.min(1 << 29)) };
        let pattern = Pattern { lengths, phase };
        let window = window_on(&mut rng, &all[..all.len().max(2) - 1]);
        let wanted = twins::polygon(&pen.dashes(&outlines_for(&path, pen.width), &pattern), FillRule::NonZero, window);
        let got = dashed_pixels(&path, pen, &pattern, window);
        assert_runs(window, &got, &wanted, || format!("{pattern:?} {pen:?} {path:?}"));
        seen += usize::from(!wanted.is_empty());
    }
    assert!(seen >= count / 10, "only {seen} strokes were seen");
}

#[test]
fn dashes_on_tiny_paths() {
    dashes(Scale::Tiny, 2_500, (17, 900));
}

#[test]
fn dashes_on_a_screen() {
    dashes(Scale::Screen, 300, (500, 9_000));
}

#[test]
fn dashes_on_a_hundred_screens() {
    dashes(Scale::Hundred, 100, (50_000, 900_000));
}

#[test]
fn dashes_at_the_ends_of_the_type() {
    dashes(Scale::Ends, 40, (1 << 24, i32::MAX));
}

/// Lines without end cost what the window shows of them, down to dashes of 1/16 pixel.
#[test]
fn dashes_beside_the_window_are_skipped() {
    let mut rng = Rng::new(521);
    let window = Rect::new(0, 0, 48, 40);
    let lengths = [8, 8].map(I24F8::from_bits);
    for _ in 0..2_000 {
        let far = |rng: &mut Rng| rng.pick(&[i32::MIN, i32::MAX, -(1 << 30), 5_000, 1 << 24]);
        let line = [(); 2].map(|()| PointFx::from_bits(far(&mut rng), far(&mut rng)));
        let stroke = Stroke::px(3).dashed(&lengths, I24F8::ZERO);
        let count = polyline_lines(&line, false, &stroke, window).len();
        assert!(count < 4 * 16 * 150, "{count} lines of {line:?}");
    }
}

/// What the twin makes of dashes, without the pieces that lie beside the window: there may be very many of them.
fn dashes_near(outlines: &[Outline], pen: Pen, pattern: &Pattern, window: Rect) -> Vec<Run> {
    let mut parts = pen.dashes(outlines, pattern);
    parts.retain(|part| {
        let beside = |n: fn(&Units) -> i32, low: i32, high: i32| {
            let (low, high) = (i64::from(low) << 8, i64::from(high) << 8);
            part.iter().all(|p| i64::from(n(p)) < low) || part.iter().all(|p| i64::from(n(p)) > high)
        };
        !beside(|p| p.0, window.x0, window.x1) && !beside(|p| p.1, window.y0, window.y1)
    });
    twins::polygon(&parts, FillRule::NonZero, window)
}

/// Thousands of dashes before the window, beside it, and on their way to the next side: skipped, and the others are where a walk
/// from dash to dash would have them.
#[test]
fn skipped_dashes_move_nothing() {
    let mut rng = Rng::new(522);
    let mut seen = 0;
    for i in 0..cases(400) {
        let (scale, shift) = if i % 2 == 0 { (Scale::Hundred, 0) } else { (Scale::Ends, 10) };
        let mut path = random_path(&mut rng, scale, 1);
        let all = [places(&path), vec![(0, 0)]].concat();
        path.insert(0, Piece::Move(all[0]));
        let mut lengths: Vec<i32> = (0..rng.int(1, 5)).map(|_| rng.int(900, 8_000) << shift).collect();
        if rng.one_in(3) {
            lengths[0] = rng.pick(&[0, -5]);
            lengths.push(rng.int(900, 8_000) << shift);
        }
        let pen = random_pen(&mut rng, 2_000);
        let any = rng.int(i32::MIN, i32::MAX);
        let pattern = Pattern { lengths, phase: rng.pick(&[0, 1, -1, i32::MIN, i32::MAX, any, any]) };
        let window = window_on(&mut rng, &all[..all.len().max(2) - 1]);
        let wanted = dashes_near(&outlines_for(&path, pen.width), pen, &pattern, window);
        let got = dashed_pixels(&path, pen, &pattern, window);
        assert_runs(window, &got, &wanted, || format!("{pattern:?} {pen:?} {path:?}"));
        seen += usize::from(!wanted.is_empty());
    }
    assert!(seen * 10 >= cases(400), "only {seen} strokes were seen");
}

/// Corners beside the window whose miters reach into it, while nothing else of the sides does.
#[test]
fn tips_of_dashes_beside_the_window() {
    let mut rng = Rng::new(523);
    let (window, mut tips) = (Rect::new(0, 0, 20, 16), 0);
    for i in 0..cases(6_000) {
        let pen = Pen { width: rng.int(300, 3_000), cap: rng.pick(&CAPS), join: Join::Miter, limit: 0xffff };
        // A corner to the right of the window, its sides far to the right: the tip points to the left.
        let corner = (20 * PX + rng.int(0, 6 * pen.width), rng.int(-500, 16 * PX + 500));
        let far = |rng: &mut Rng| (corner.0 + rng.int(5_000, 90_000), corner.1 + rng.int(-9_000, 9_000));
        let mut units = vec![far(&mut rng), corner, far(&mut rng)];
        for place in &mut units {
            for _ in 0..i % 4 {
                // A quarter of a turn around the middle of a window of 20 x 20.
                *place = (20 * PX - place.1, place.0);
            }
        }
        let closed = rng.one_in(2);
        let lengths = [rng.int(200, 9_000), rng.int(200, 3_000)];
        let pattern = Pattern { lengths: lengths.to_vec(), phase: rng.int(-20_000, 20_000) };
        let wanted = dashes_near(&[polyline(&units, closed)], pen, &pattern, window);
        let mut path: Vec<Piece> = units.iter().map(|&p| Piece::Line(p)).collect();
        path[0] = Piece::Move(units[0]);
        path.extend(closed.then_some(Piece::Close));
        let got = dashed_pixels(&path, pen, &pattern, window);
        assert_runs(window, &got, &wanted, || format!("{pattern:?} {pen:?} {path:?}"));
        let lengths = lengths.map(I24F8::from_bits);
        let (places, stroke) = (vertices(&units), stroke(pen).dashed(&lengths, I24F8::from_bits(pattern.phase)));
        let mut table = vec![EdgeSlot::EMPTY; 1_000];
        let got = collect(window, |emit| {
            thick::fill_polyline(&places, closed, &stroke, &mut table, window, emit).expect("enough slots");
        });
        assert_runs(window, &got, &wanted, || format!("{pattern:?} {pen:?} closed {closed} {units:?}"));
        tips += usize::from(!wanted.is_empty());
    }
    assert!(tips * 10 > cases(6_000), "only {tips} tips were seen");
}

/// A dash ends out of sight on a curve that comes back: the next one does not begin with a join to it.
#[test]
fn dashes_that_end_out_of_sight() {
    let curve = Piece::Cubic((1_376_258, 166_522), (1_379_338, 172_282), (1_376_526, 163_842));
    let path = [Piece::Move((1_376_256, 163_840)), curve];
    let pen = Pen { width: 793, cap: Cap::Butt, join: Join::Bevel, limit: 2560 };
    let pattern = Pattern { lengths: vec![892, 892, 900, 900], phase: 5040 };
    let window = Rect::new(5376, 640, 5385, 654);
    let wanted = twins::polygon(&pen.dashes(&outlines_for(&path, pen.width), &pattern), FillRule::NonZero, window);
    assert_runs(window, &dashed_pixels(&path, pen, &pattern, window), &wanted, || "dashes".into());
}

/// A miter limit says how long tips may be. Of what is not a tip it changes nothing: not which sides, caps and dashes are looked
/// at, and so not how many slots they take.
#[test]
fn a_miter_limit_widens_nothing_but_tips() {
    let window = Rect::new(0, 0, 320, 240);
    let stroke = |limit: i32| Stroke::px(50).with_miter_limit(I24F8::from_bits(limit));
    let limits = [4 << 8, 16 << 8, 255 << 8, 0xffff, i32::MAX];
    let dashes = [I24F8::from_num(6), I24F8::from_num(4)];
    let line = [PointFx::px(-4_000, -3_000), PointFx::px(4_000, 3_000)];
    let lines = |limit: i32| polyline_lines(&line, false, &stroke(limit).dashed(&dashes, I24F8::ZERO), window).len();
    let slots = |limit: i32| {
        let (stroke, mut table) = (stroke(limit).dashed(&dashes, I24F8::ZERO), [EdgeSlot::EMPTY; 200]);
        thick::fill_polyline(&line, false, &stroke, &mut table, window, |_: ClippedSpan| {})
    };
    for limit in limits {
        assert_eq!(lines(limit), lines(256), "lines at limit {limit}");
        assert_eq!(slots(limit), Ok(()), "200 slots at limit {limit}");
    }
    // Right angles far outside: tips of less than 36 pixels, whatever the limit allows.
    let zigzag: Vec<PointFx> = (0..10_000).map(|i| PointFx::px(500 + 20 * (i % 2), 20 * (i % 12))).collect();
    for limit in limits {
        let stroke = Stroke::px(3).with_miter_limit(I24F8::from_bits(limit));
        assert_eq!(polyline_lines(&zigzag, false, &stroke, window), []);
    }
}
