//! Work, counted: what a stroke measures, goes through and offers to the edge table.

use std::{vec, vec::Vec};

use fixed::types::I24F8;
use twins::rng::Rng;

use super::*;
use crate::{
    geom::{
        Path,
        PathSegment::{self, CubicTo, LineTo, MoveTo, QuadraticTo},
    },
    num::tally,
    span::ClippedSpan,
};

const WINDOW: Rect = Rect::new(0, 0, 320, 240);

fn at(x: i32, y: i32) -> PointFx {
    PointFx::from_bits(x, y)
}

/// Square roots, points of curves, lengths of the pattern, lines of the border, bands.
fn work<D: Dashing>(path: &[PathSegment], stroke: &Stroke<D>, slots: usize) -> [usize; 5] {
    let mut table = vec![EdgeSlot::EMPTY; slots];
    let path = Path::new(path);
    let [roots, points, dashes, edges, bands, _] =
        tally::of(|| fill(path, stroke, &mut table, WINDOW, |_: ClippedSpan| {}).expect("enough slots"));
    [roots, points, dashes, edges, bands]
}

fn random_stroke(rng: &mut Rng) -> Stroke {
    Stroke::new(I24F8::from_bits(rng.int(0, 2_000)))
        .with_cap(rng.pick(&[Cap::Butt, Cap::Square, Cap::Round]))
        .with_join(rng.pick(&[Join::Miter, Join::Bevel, Join::Round]))
        .with_miter_limit(I24F8::from_bits(rng.pick(&[256, 1_024, 2_000])))
}

/// Lengths from 1/16 pixel on, from `floor` on, of which some are 0 or less.
fn random_lengths(rng: &mut Rng, floor: i32) -> Vec<I24F8> {
    let mut lengths: Vec<i32> =
        (0..rng.int(2, 9)).map(|_| floor + (rng.int(0, i32::MAX - floor) >> rng.int(0, 22))).collect();
    for _ in 0..rng.index(lengths.len()) {
        let i = rng.index(lengths.len());
        lengths[i] = rng.pick(&[0, -5, i32::MIN, lengths[i]]);
    }
    lengths.push(floor);
    lengths.into_iter().map(I24F8::from_bits).collect()
}

/// A path of lines and curves whose places are `place`.
fn random_path(rng: &mut Rng, mut place: impl FnMut(&mut Rng) -> PointFx) -> Vec<PathSegment> {
    let mut path = vec![MoveTo(place(rng))];
    for _ in 0..rng.int(1, 6) {
        path.push(match rng.below(5) {
            0 => LineTo(place(rng)),
            1 => QuadraticTo(place(rng), place(rng)),
            2 => PathSegment::Close,
            _ => CubicTo(place(rng), place(rng), place(rng)),
        });
    }
    path
}

/// On each of the four sides, and up to the ends of the type, what lies beside the window is not measured: nothing but a few
/// comparisons a segment is left, and the search for the phase in the pattern.
#[test]
fn strokes_beside_the_window_are_not_measured() {
    let mut rng = Rng::new(530);
    for i in 0..4_000 {
        let stroke = random_stroke(&mut rng);
        let place = |rng: &mut Rng| {
            let (beside, along) =
                (rng.int(20_000, i32::MAX) >> rng.int(0, 10), rng.int(i32::MIN, i32::MAX) >> rng.int(0, 20));
            let beside = beside.max(20_000);
            match i % 4 {
                0 => at(!beside, along),
                1 => at(beside.saturating_add(320 << 8), along),
                2 => at(along, !beside),
                _ => at(along, beside.saturating_add(240 << 8)),
            }
        };
        let path = random_path(&mut rng, place);
        let lengths = random_lengths(&mut rng, 512);
        let phase = I24F8::from_bits(rng.pick(&[0, -1, i32::MIN, i32::MAX, 77_777]));
        let done = work(&path, &stroke.dashed(&lengths, phase), 8);
        let steps = 2 * lengths.len();
        assert!(matches!(done, [0, 0, _, 0, 1]) && done[2] <= steps, "{done:?} of {steps} lengths, {path:?}");
        let done = work(&path, &stroke, 8);
        assert!(matches!(done, [0, _, 0, 0, 1]), "{done:?} of a solid one, {path:?}");
    }
}

/// A curve between the ends of the type, of which a window shows one end, or nothing though it goes all around: it is measured
/// from its start to where it is last seen, not behind.
#[test]
fn a_curve_is_measured_up_to_where_it_is_last_seen() {
    let (low, high) = (i32::MIN, i32::MAX);
    let lengths = [1_000; 2].map(I24F8::from_bits);
    let dashed = Stroke::px(3).dashed(&lengths, I24F8::ZERO);
    let front = [MoveTo(at(20_000, 20_000)), CubicTo(at(high, low), at(low, low), at(high, high))];
    // For each end of a dash that is seen, 12 points: where on the curve it is.
    let done = work(&front, &dashed, 2_000);
    assert!(done[0] < 250 && done[1] < 500 && done[2] < 400, "{done:?}");
    let around = [MoveTo(at(low, high)), CubicTo(at(high, low), at(low, low), at(high, high))];
    let done = work(&around, &dashed, 2_000);
    assert!(done[0] < 40 && done[1] < 80, "{done:?}");
    // What comes before must be measured: by a square root a side, and no step a dash.
    let [a, CubicTo(b, c, d)] = [front[0], front[1]] else { panic!("a curve") };
    let MoveTo(a) = a else { panic!("a start") };
    let back = [MoveTo(d), CubicTo(c, b, a)];
    let done = work(&back, &dashed, 2_000);
    assert!(done[0] > 5_000 && done[2] < 400, "{done:?}");
}

/// Lines between the ends of the type, past the window by a hair or through it at any angle, with dashes of 1/16 pixel: as many
/// steps as the view is long, and a few periods.
#[test]
fn lines_are_followed_where_they_are_seen() {
    let mut rng = Rng::new(531);
    let mut most = 0;
    for _ in 0..3_000 {
        let lengths: Vec<I24F8> = (0..rng.int(2, 7)).map(|_| I24F8::from_bits(rng.int(8, 40))).collect();
        let shift = rng.int(0, 18);
        let far = [(); 2].map(|()| rng.int(-i32::MAX, i32::MAX) >> shift);
        let (x, y) = (rng.int(-50_000, 130_000), rng.int(-50_000, 110_000));
        let flat = rng.int(0, 30);
        let (dx, dy) = if rng.one_in(2) { (far[0], far[1] >> flat) } else { (far[0] >> flat, far[1]) };
        let (a, b) = (at(x.saturating_sub(dx), y.saturating_sub(dy)), at(x.saturating_add(dx), y.saturating_add(dy)));
        let stroke = Stroke::px(1).dashed(&lengths, I24F8::from_bits(rng.int(-90_000, 90_000)));
        let [roots, _, steps, ..] = work(&[MoveTo(a), LineTo(b)], &stroke, 40_000);
        let shortest = lengths.iter().map(|n| n.to_bits().unsigned_abs() as usize).sum::<usize>() / lengths.len();
        // The diagonal of the window is 400 pixels.
        assert!(roots <= 2 && steps <= 404 * 256 / shortest + 60, "{roots} {steps} {a:?} {b:?} {lengths:?}");
        most = most.max(steps);
    }
    assert!(most > 2_000, "{most} steps at most: too easy");
}

/// Twenty loops out of the window and back, with 200 slots: in each band of rows the pieces of that band are made, no others.
#[test]
fn bands_make_the_pieces_that_they_show() {
    let px = PointFx::px;
    let mut path = vec![MoveTo(px(10, 10))];
    path.extend((0..20).map(|i| CubicTo(px(3_000, 10 + i), px(3_000, 200), px(10 + i, 20 + 10 * i))));
    let lengths = [1_000, 600].map(I24F8::from_bits);
    let stroke = Stroke::new(I24F8::from_bits(800));
    let dashed = stroke.dashed(&lengths, I24F8::ZERO);
    let (whole, bands) = (work(&path, &dashed, 60_000), work(&path, &dashed, 200));
    assert_eq!([whole[4], bands[4]], [1, 41], "bands");
    assert!(bands[3] < 6 * whole[3] && bands[2] < 8 * whole[2], "{whole:?} {bands:?}");
    let (whole, bands) = (work(&path, &stroke, 60_000), work(&path, &stroke, 200));
    assert!(bands[3] < 5 * whole[3] && bands[0] < 5 * whole[0], "{whole:?} {bands:?}");
}
