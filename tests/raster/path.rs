//! Paths: the vertices of every curve against Bernstein's polynomials in integers of 128 bits, the curves' distance from
//! their chords, and the pixels of fills and thin outlines against their rules.

#![allow(clippy::cast_possible_truncation, clippy::cast_precision_loss, reason = "a twin in wide integers and floats")]

use std::collections::HashSet;

use embedded_raster::{
    raster::{self, polygon},
    ClippedSpan, EdgeSlot, FillRule, FlattenError, Path, PointFx, Rect,
};
use twins::{
    assert_runs, collect,
    curves::{distance, flattened, outlines, places, random_path, segments, times, true_point, Outline, Piece, END},
    outlines::outline_pixels,
    rng::{cases, Rng},
    scenes::{outline, window_on, Scale},
    Run, Units,
};

fn units(v: PointFx) -> Units {
    (v.x.to_bits(), v.y.to_bits())
}

fn contours(pieces: &[Piece]) -> Vec<(Vec<Units>, bool)> {
    let path = segments(pieces);
    Path::new(&path)
        .contours()
        .map(|c| (c.is_closed(), c))
        .map(|(closed, c)| (c.map(units).collect(), closed))
        .collect()
}

fn wanted_contours(pieces: &[Piece]) -> Vec<(Vec<Units>, bool)> {
    outlines(pieces).into_iter().map(|Outline { places, closed, .. }| (places, closed)).collect()
}

fn filled(pieces: &[Piece], rule: FillRule, window: Rect, capacity: usize) -> Vec<Run> {
    let path = segments(pieces);
    let mut table = vec![EdgeSlot::EMPTY; capacity];
    collect(window, |emit| {
        let contours = Path::new(&path).contours_in(window);
        polygon::fill(contours, rule, &mut table, window, emit).expect("enough slots");
    })
}

#[test]
fn vertices_are_the_nearest_to_the_curve() {
    let mut rng = Rng::new(400);
    for scale in Scale::ALL {
        for _ in 0..if scale == Scale::Ends { 100 } else { cases(6_000) } {
            let path = random_path(&mut rng, scale, 4);
            assert_eq!(contours(&path), wanted_contours(&path), "{path:?}");
        }
    }
}

/// The same vertices, written down; or how many there are, when they are too many.
#[test]
fn outlines_are_the_contours() {
    let mut rng = Rng::new(411);
    let (mut fitted, mut many_vertices, mut many_starts) = (0, 0, 0);
    let count = cases(20_000);
    for i in 0..count {
        let (path, wanted) = (random_path(&mut rng, Scale::ALL[i % 3], 5), vec![]);
        let segments = segments(&path);
        let wanted = Path::new(&segments).contours().fold(wanted, |mut all: Vec<Vec<PointFx>>, contour| {
            all.push(contour.collect());
            all
        });
        let (vertices, further) = (wanted.concat(), wanted.len().saturating_sub(1));
        match Path::new(&segments).outlines::<40, 1>() {
            Ok(outlines) => {
                let starts: Vec<usize> = outlines.starts.iter().map(|&start| start.into()).collect();
                assert_eq!(outlines.contours().collect::<Vec<_>>(), wanted, "{path:?}");
                assert_eq!(outlines.vertices[..], vertices[..], "{path:?}");
                assert_eq!(starts, wanted.iter().skip(1).map(|_| wanted[0].len()).collect::<Vec<_>>(), "{path:?}");
                fitted += 1;
            }
            Err(FlattenError::VertexListFull { capacity, needed }) => {
                assert_eq!((capacity, needed), (40, vertices.len()), "{path:?}");
                assert!(needed > 40, "{path:?}");
                many_vertices += 1;
            }
            Err(error) => {
                assert_eq!(error, FlattenError::StartListFull { capacity: 1, needed: further }, "{path:?}");
                assert!(further > 1 && vertices.len() <= 40, "{path:?}");
                many_starts += 1;
            }
        }
    }
    let counts = [fitted, many_vertices, many_starts];
    assert!(counts.iter().all(|&n| n >= count / 100), "{counts:?}");
}

/// How far a curve gets from the chord of the piece between two times, in `f64`.
fn deviation(points: &[Units], from: f64, to: f64, chord: [Units; 2]) -> f64 {
    let as_float = |p: Units| (f64::from(p.0), f64::from(p.1));
    let places = (0..=8).map(|s| true_point(points, from + (to - from) * f64::from(s) / 8.0));
    places.map(|p| distance(p, as_float(chord[0]), as_float(chord[1]))).fold(0.0, f64::max)
}

/// As far as a curve gets from its chords.
#[test]
fn curves_stay_within_the_tolerance() {
    let mut rng = Rng::new(401);
    let (mut farthest, mut most) = (0.0_f64, 0);
    for i in 0..6_000 {
        let scale = [Scale::Tiny, Scale::Screen, Scale::Hundred][i % 3];
        let points = outline(&mut rng, scale, 3 + i % 2);
        let vertices = flattened(&points);
        most = most.max(vertices.len());
        let chords: Vec<Units> = core::iter::once(points[0]).chain(vertices).collect();
        let ends: Vec<i128> = core::iter::once(0).chain(times(&points)).collect();
        let time = |t: i128| t as f64 / END as f64;
        for (ends, chord) in ends.windows(2).zip(chords.windows(2)) {
            let off = deviation(&points, time(ends[0]), time(ends[1]), [chord[0], chord[1]]);
            assert!(off <= 34.6, "{points:?}: {off} units off between {ends:?}");
            farthest = farthest.max(off);
        }
    }
    assert!(farthest > 32.0 && most > 300, "{farthest} units off, {most} pieces: too easy");
}

/// The fewest chords that stay within 32 units: each as long as it can be.
fn fewest(points: &[Units]) -> usize {
    let place = |t: f64| {
        let (x, y) = true_point(points, t);
        (x as i32, y as i32)
    };
    let fits = |from: f64, to: f64| deviation(points, from, to, [place(from), place(to)]) <= 33.0;
    let (mut count, mut from) = (1, 0.0);
    while !fits(from, 1.0) {
        let (mut short, mut long) = (0.0, 1e-3);
        while fits(from, from + long) {
            (short, long) = (long, 1.5 * long);
        }
        for _ in 0..8 {
            let middle = f64::midpoint(short, long);
            *(if fits(from, from + middle) { &mut short } else { &mut long }) = middle;
        }
        from += short.max(1e-4);
        count += 1;
    }
    count
}

/// How many pieces curves take, against the fewest there can be: for any, and for arcs of circles and the like.
#[test]
fn pieces_are_few() {
    let mut rng = Rng::new(406);
    let ratio = |curves: &[Vec<Units>]| {
        let (got, least) = curves.iter().fold((0, 0), |sum, c| (sum.0 + flattened(c).len(), sum.1 + fewest(c)));
        got as f64 / least as f64
    };
    let wild: Vec<_> = (0..300).map(|i| outline(&mut rng, Scale::Screen, 3 + i % 2)).collect();
    let any = ratio(&wild);
    let round = |_| {
        // A quarter of a circle; its control points 0.5523 of the radius away.
        let (x, y, r) = (rng.int(0, 60_000), rng.int(0, 60_000), rng.int(500, 50_000));
        let k = (f64::from(r) * 0.552_3) as i32;
        vec![(x + r, y), (x + r, y + k), (x + k, y + r), (x, y + r)]
    };
    let arcs: Vec<_> = (0..100).map(round).collect();
    let arcs = ratio(&arcs);
    assert!(any < 1.7 && arcs < 1.1, "{any} times as many pieces as there must be, {arcs} for arcs");
}

/// A curve has the same vertices from either end.
#[test]
fn reversed_curves_have_the_same_vertices() {
    let mut rng = Rng::new(405);
    for scale in Scale::ALL {
        for i in 0..500 {
            let mut points = outline(&mut rng, scale, 3 + i % 2);
            let vertices = |points: &[Units]| {
                let curve = match *points {
                    [_, b, c] => Piece::Quadratic(b, c),
                    _ => Piece::Cubic(points[1], points[2], points[3]),
                };
                contours(&[Piece::Move(points[0]), curve]).remove(0).0
            };
            let ahead = vertices(&points);
            points.reverse();
            let mut back = vertices(&points);
            back.reverse();
            assert_eq!(ahead, back, "{points:?}");
        }
    }
}

/// The ends of the type make the most pieces there are.
#[test]
fn the_number_of_pieces_is_bounded() {
    let (low, high) = (i32::MIN, i32::MAX);
    let worst = [(low, low), (high, high), (low, low), (high, high)];
    assert!(times(&worst).len() <= 1 << 15);
    let path = [Piece::Move(worst[0]), Piece::Cubic(worst[1], worst[2], worst[3])];
    assert_eq!(contours(&path), wanted_contours(&path));
    // As bent as it gets, and not straight.
    let path = [Piece::Move((low, high)), Piece::Cubic((high, low), (low, low), (high, high))];
    let count = wanted_contours(&path)[0].0.len();
    assert!((5_000..=1 << 15).contains(&count), "{count} pieces");
    assert_eq!(contours(&path), wanted_contours(&path));
}

/// A window asks a curve for few of its vertices, wherever the curve goes.
#[test]
fn work_depends_on_the_window() {
    let mut rng = Rng::new(402);
    let mut most = 0;
    for _ in 0..cases(5_000) {
        let path = random_path(&mut rng, Scale::Ends, 1);
        let window = window_on(&mut rng, &[places(&path), vec![(0, 0)]].concat());
        let path = segments(&path);
        most = most.max(Path::new(&path).contours_in(window).map(Iterator::count).sum::<usize>());
    }
    assert!(most < 400, "{most} vertices for a window");
}

fn check_fill(path: &[Piece], window: Rect) -> bool {
    let contours: Vec<Vec<Units>> = outlines(path).into_iter().map(|o| o.places).collect();
    let count = contours.iter().map(Vec::len).sum();
    let mut seen = false;
    for rule in [FillRule::NonZero, FillRule::EvenOdd] {
        let wanted = twins::polygon(&contours, rule, window);
        let got = filled(path, rule, window, count);
        assert_runs(window, &got, &wanted, || format!("{rule:?} {path:?}"));
        seen |= !wanted.is_empty();
    }
    seen
}

fn fills(scale: Scale, count: usize) {
    let mut rng = Rng::new(410 + scale as u64);
    let (count, mut seen) = (cases(count), 0);
    for _ in 0..count {
        let path = random_path(&mut rng, scale, 3);
        let all = places(&path);
        let window = if all.is_empty() { Rect::new(-4, -4, 9, 9) } else { window_on(&mut rng, &all) };
        seen += usize::from(check_fill(&path, window));
    }
    assert!(seen >= count / 8, "only {seen} paths were seen");
}

#[test]
fn tiny_paths() {
    fills(Scale::Tiny, 12_000);
}

#[test]
fn screen_paths() {
    fills(Scale::Screen, 6_000);
}

#[test]
fn paths_of_a_hundred_screens() {
    fills(Scale::Hundred, 1_500);
}

#[test]
fn paths_at_the_ends_of_the_type() {
    fills(Scale::Ends, 250);
}

/// With a table for a few rows only, and in tiles: the same pixels.
#[test]
fn small_tables_and_tiles_show_the_same_path() {
    let mut rng = Rng::new(403);
    let whole = Rect::new(-3, -3, 45, 37);
    for _ in 0..300 {
        let path = random_path(&mut rng, Scale::Tiny, 4);
        let all = filled(&path, FillRule::NonZero, whole, 400);
        // A row is crossed by each curve a few times.
        assert_eq!(filled(&path, FillRule::NonZero, whole, 60), all, "{path:?}");
        for size in twins::TILE_SIZES {
            let mut hits = twins::hits::Hits::new(whole);
            for tile in twins::tiles(whole, size) {
                hits.add(&filled(&path, FillRule::NonZero, tile, 400));
            }
            assert_runs(whole, &hits.runs(), &all, || format!("{path:?} in tiles of {size:?}"));
        }
    }
}

fn drawn(path: &[Piece], window: Rect) -> Vec<(i32, i32)> {
    let path = segments(path);
    let mut pixels = vec![];
    raster::outline::draw(Path::new(&path), window, |s: ClippedSpan| {
        pixels.extend((s.x0()..s.x1()).map(|x| (x, s.y())));
    });
    assert!(pixels.iter().all(|p| window.contains(p.0, p.1)), "outside of the window");
    pixels.sort_unstable();
    pixels.dedup();
    pixels
}

fn thin(scale: Scale, count: usize) {
    let mut rng = Rng::new(420 + scale as u64);
    let (count, mut seen) = (cases(count), 0);
    for _ in 0..count {
        let mut path = random_path(&mut rng, scale, 3);
        // The twin walks the whole way, which is not to begin in the middle of the plane.
        let all = [places(&path), vec![(0, 0)]].concat();
        path.insert(0, Piece::Move(all[0]));
        let window = window_on(&mut rng, &all[..all.len().max(2) - 1]);
        let mut wanted: Vec<_> = outline_pixels(&path).concat();
        wanted.retain(|p| window.contains(p.0, p.1));
        wanted.sort_unstable();
        wanted.dedup();
        assert_eq!(drawn(&path, window), wanted, "{path:?} in {window:?}");
        seen += usize::from(!wanted.is_empty());
    }
    assert!(seen >= count / 4, "only {seen} outlines were seen");
}

#[test]
fn tiny_outlines() {
    thin(Scale::Tiny, 20_000);
}

#[test]
fn screen_outlines() {
    thin(Scale::Screen, 6_000);
}

#[test]
fn outlines_of_a_hundred_screens() {
    thin(Scale::Hundred, 150);
}

#[test]
fn outlines_at_the_ends_of_the_type() {
    thin(Scale::Ends, 1);
}

/// Every pixel touches the next, none is far from the curve, no part of the curve is far from a pixel.
#[test]
fn outlines_are_connected_and_close() {
    let mut rng = Rng::new(404);
    let mut farthest = 0.0_f64;
    for i in 0..3_000 {
        let size = rng.pick(&[600, 3_000, 12_000]);
        let points: Vec<Units> = (0..3 + i % 2).map(|_| (rng.int(0, size), rng.int(0, size))).collect();
        let curve = match points[..] {
            [_, b, c] => Piece::Quadratic(b, c),
            _ => Piece::Cubic(points[1], points[2], points[3]),
        };
        let path = [Piece::Move(points[0]), curve];
        let pixels = outline_pixels(&path).concat();
        assert!(
            pixels.windows(2).all(|p| (p[0].0 - p[1].0).abs() <= 1 && (p[0].1 - p[1].1).abs() <= 1),
            "a gap: {points:?} {pixels:?}"
        );
        assert_eq!(drawn(&path, Rect::new(-1, -1, 50, 50)).len(), pixels.iter().collect::<HashSet<_>>().len());
        let truth: Vec<(f64, f64)> = (0..=2_000).map(|t| true_point(&points, f64::from(t) / 2_000.0)).collect();
        let centre = |p: (i32, i32)| (f64::from(p.0) * 256.0 + 128.0, f64::from(p.1) * 256.0 + 128.0);
        for &place in truth.iter().step_by(10) {
            let near = pixels.windows(2).map(|w| distance(place, centre(w[0]), centre(w[1]))).fold(f64::MAX, f64::min);
            assert!(pixels.len() < 2 || near <= 384.0, "{place:?} of {points:?} is {near} units from the pixels");
        }
        for p in pixels {
            let centre = centre(p);
            let near = truth.windows(2).map(|w| distance(centre, w[0], w[1])).fold(f64::MAX, f64::min) / 256.0;
            assert!(near <= 0.75, "{p:?} is {near} pixels from {points:?}");
            farthest = farthest.max(near);
        }
    }
    assert!(farthest > 0.6, "{farthest} pixels at most: too easy");
}

/// Curves that break flatteners: a cusp (the speed is 0 in the middle), a loop, all control points in one place, control points
/// on the ends, a curve that goes back on itself, control points 200 pixels outside of the window.
#[test]
fn curves_that_break_flatteners() {
    let px = |x: i32, y: i32| (256 * x, 256 * y);
    let window = Rect::new(-2, -2, 42, 34);
    let curves = [
        ("cusp", [px(4, 4), px(36, 28), px(4, 28), px(36, 4)]),
        ("loop", [px(10, 28), px(60, 0), px(-20, 0), px(30, 28)]),
        ("stacked", [px(9, 9), px(9, 9), px(9, 9), px(9, 9)]),
        ("stacked on the start", [px(2, 3), px(2, 3), px(2, 3), px(30, 20)]),
        ("straight", [px(2, 3), px(12, 8), px(22, 13), px(32, 18)]),
        ("there and back", [px(2, 5), px(60, 5), px(-20, 5), px(30, 5)]),
        ("far control points", [px(5, 5), px(-200, 230), px(240, 230), px(35, 5)]),
    ];
    for (name, [a, b, c, d]) in curves {
        let path = [Piece::Move(a), Piece::Cubic(b, c, d)];
        check_fill(&path, window);
        let mut wanted = outline_pixels(&path).concat();
        wanted.retain(|p| window.contains(p.0, p.1));
        wanted.sort_unstable();
        wanted.dedup();
        assert_eq!(drawn(&path, window), wanted, "{name}");
        assert!(!wanted.is_empty(), "{name} has no outline");
    }
}
