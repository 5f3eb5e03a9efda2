//! Paths, filled, thin, with a width and with dashes, against their pieces in wide integers.
#![no_main]

mod input;

use embedded_raster::{
    px,
    raster::{
        outline, polygon,
        stroke::{self, Dashing},
    },
    Cap, ClippedSpan, EdgeSlot, FillRule, Join, Path, Rect, Stroke,
};
use fixed::types::I24F8;
use input::Input;
use libfuzzer_sys::fuzz_target;
use twins::{
    assert_runs, collect,
    curves::{outlines, outlines_for, places, segments, Piece},
    outlines::outline_pixels,
    runs_where,
    strokes::{Pattern, Pen},
    Run, Units,
};

/// What the twins, which walk the whole way, can do in time: within 512 pixels of the window.
const NEAR: i32 = 512 * 256;

fuzz_target!(|data: &[u8]| {
    let mut input = Input(data);
    let window = input.window();
    let choice = input.byte();
    let pen = pen(&mut input);
    let pattern = pattern(&mut input);
    let pieces = path(&mut input, window);
    let near = |p: &Units, q: &Units| p.0.abs_diff(q.0).max(p.1.abs_diff(q.1)) < NEAR.unsigned_abs();
    let all = [places(&pieces), vec![start(&pieces)]].concat();
    let all_near = all.iter().all(|p| near(p, &all[0]));
    match choice & 3 {
        0 => fill(&pieces, choice, window),
        1 => thin(&pieces, all_near, window),
        2 => solid(&pieces, pen, all_near, window),
        _ => dashes(&pieces, pen, &pattern, all_near, window),
    }
});

/// Where the path begins.
fn start(pieces: &[Piece]) -> Units {
    match pieces.first() {
        Some(&Piece::Move(to)) => to,
        _ => (0, 0),
    }
}

fn path(input: &mut Input<'_>, window: Rect) -> Vec<Piece> {
    let mut pieces = vec![];
    while input.goes_on() && pieces.len() < 6 {
        let kind = input.byte();
        let mut place = || input.place_near(window);
        pieces.push(match kind % 8 {
            0 => Piece::Move(place()),
            1 => Piece::Close,
            2 | 3 => Piece::Line(place()),
            4 | 5 => Piece::Quadratic(place(), place()),
            _ => Piece::Cubic(place(), place(), place()),
        });
        if pieces.len() == 1 && kind & 64 == 0 {
            pieces.insert(0, Piece::Move(input.place_near(window)));
        }
    }
    pieces
}

fn pen(input: &mut Input<'_>) -> Pen {
    let choice = usize::from(input.byte());
    let cap = [Cap::Butt, Cap::Square, Cap::Round][choice % 3];
    let join = [Join::Miter, Join::Bevel, Join::Round][choice / 3 % 3];
    let limit = [0, 256, 300, 1024, 2560, 0xffff][choice / 9 % 6];
    let width = input.near(800, 7).clamp(0, 1 << 24);
    Pen { width, cap, join, limit }
}

fn pattern(input: &mut Input<'_>) -> Pattern {
    let n = 1 + usize::from(input.byte() % 4);
    let lengths = (0..n).map(|_| input.near(900, 8)).collect();
    Pattern { lengths, phase: input.near(0, 40) }
}

fn as_stroke(pen: Pen) -> Stroke {
    let stroke = Stroke::new(I24F8::from_bits(pen.width)).with_cap(pen.cap).with_join(pen.join);
    stroke.with_miter_limit(I24F8::from_bits(pen.limit)).with_min_width(px(0))
}

/// The same of a stroke.
fn stroked<D: Dashing>(path: Path<'_>, style: &Stroke<D>, window: Rect) -> Vec<Run> {
    let mut count = 0;
    stroke::border(path, style, window, |_, _| count += 1);
    let mut table = vec![EdgeSlot::EMPTY; count];
    collect(window, |emit| stroke::fill(path, style, &mut table, window, emit).expect("enough slots"))
}

/// By a table that is as long as it takes.
fn filled<C>(contours: C, rule: FillRule, window: Rect) -> Vec<Run>
where
    C: IntoIterator + Clone,
    C::Item: IntoIterator,
    <C::Item as IntoIterator>::Item: core::borrow::Borrow<embedded_raster::PointFx>,
{
    let count = contours.clone().into_iter().map(|c| c.into_iter().count()).sum();
    let mut table = vec![EdgeSlot::EMPTY; count];
    collect(window, |emit| polygon::fill(contours, rule, &mut table, window, emit).expect("enough slots"))
}

fn fill(pieces: &[Piece], choice: u8, window: Rect) {
    let rule = if choice & 4 == 0 { FillRule::NonZero } else { FillRule::EvenOdd };
    let path = segments(pieces);
    let got = filled(Path::new(&path).contours_in(window), rule, window);
    let contours: Vec<Vec<Units>> = outlines(pieces).into_iter().map(|o| o.places).collect();
    assert_runs(window, &got, &twins::polygon(&contours, rule, window), || format!("{rule:?} {pieces:?}"));
}

fn thin(pieces: &[Piece], has_twin: bool, window: Rect) {
    let path = segments(pieces);
    let mut painted = std::collections::HashSet::new();
    outline::draw(Path::new(&path), window, |s: ClippedSpan| {
        assert!(s.x0() < s.x1() && window.contains(s.x0(), s.y()) && window.contains(s.x1() - 1, s.y()), "{s:?}");
        painted.extend((s.x0()..s.x1()).map(|x| (x, s.y())));
    });
    if has_twin {
        let wanted: std::collections::HashSet<_> = outline_pixels(pieces).into_iter().flatten().collect();
        let got = runs_where(window, |x, y| painted.contains(&(x, y)));
        let wanted = runs_where(window, |x, y| wanted.contains(&(x, y)));
        assert_runs(window, &got, &wanted, || format!("outline of {pieces:?}"));
    }
}

fn solid(pieces: &[Piece], pen: Pen, has_twin: bool, window: Rect) {
    let path = segments(pieces);
    let got = stroked(Path::new(&path), &as_stroke(pen), window);
    if has_twin {
        let wanted = twins::polygon(&pen.parts(&outlines_for(pieces, pen.width)), FillRule::NonZero, window);
        assert_runs(window, &got, &wanted, || format!("{pen:?} {pieces:?}"));
    }
}

fn dashes(pieces: &[Piece], pen: Pen, pattern: &Pattern, has_twin: bool, window: Rect) {
    let path = segments(pieces);
    let lengths: Vec<_> = pattern.lengths.iter().map(|&n| I24F8::from_bits(n)).collect();
    let stroke = as_stroke(pen).dashed(&lengths, I24F8::from_bits(pattern.phase));
    let got = stroked(Path::new(&path), &stroke, window);
    // The twin goes from dash to dash: not too many.
    let period: i64 = pattern.lengths.iter().map(|&n| i64::from(n.max(0))).sum();
    if has_twin && period > 100 {
        let wanted = twins::polygon(&pen.dashes(&outlines_for(pieces, pen.width), pattern), FillRule::NonZero, window);
        assert_runs(window, &got, &wanted, || format!("{pattern:?} {pen:?} {pieces:?}"));
    }
}
