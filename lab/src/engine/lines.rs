//! Ways to draw a line: from the textbook's first to this crate's.
//!
//! The plain ones meet the screen in one of two ways: *tested*, they walk the whole line and test each pixel; *moved*, they
//! first move the ends to the border of the screen (Cohen and Sutherland), rounded to pixels, and draw another line.

use embedded_graphics::geometry::Point;
use embedded_raster::{raster::line, Canvas, ClippedSpan};

use super::{entry, ink, own, peers, plain, Entry, Origin};
use crate::{
    frame::{Frame, HEIGHT, WIDTH, WINDOW},
    shape::Line,
};

pub(crate) fn entries() -> Vec<Entry<Line>> {
    use Origin::{Crate, Peer, Textbook};
    vec![
        entry("slope", "slope and round in f32, tested", Textbook, plain(|f, l: &Line| slope_and_round(f, l.a, l.b))),
        entry(
            "slope-moved",
            "slope and round in f32, moved",
            Textbook,
            plain(|f, l: &Line| moved(f, l, slope_and_round)),
        ),
        entry("dda16", "DDA in 16.16, tested", Textbook, plain(|f, l: &Line| dda::<16>(f, l.a, l.b))),
        entry("dda8", "DDA in 24.8, tested", Textbook, plain(|f, l: &Line| dda::<8>(f, l.a, l.b))),
        entry("bresenham", "Bresenham, tested", Textbook, plain(|f, l: &Line| bresenham(f, l.a, l.b))),
        entry("bresenham-moved", "Bresenham, moved", Textbook, plain(|f, l: &Line| moved(f, l, bresenham))),
        entry("spans", "`line::draw`, span by span", Crate, plain(|f, l: &Line| spans(f, l.a, l.b))),
        entry("canvas", "`Canvas::draw_line`", Crate, own(|f, l: &Line| f.draw_line(l.a, l.b, ink()))),
        entry("eg", "embedded-graphics", Peer, peers::graphics(|f, l: &Line| peers::line(f, l.a, l.b, ink()))),
        entry("skia", "tiny-skia, hairline", Peer, peers::skia(|p, l: &Line| peers::hairline(p, l.path.as_ref()))),
    ]
}

/// The textbook's first method: for each step along the longer axis, slope times distance, rounded. It counts from the
/// first end, which is kinder to `f32` than `m x + b`.
fn slope_and_round(frame: &mut Frame, a: Point, b: Point) {
    let (dx, dy) = (b.x - a.x, b.y - a.y);
    if dx.abs() >= dy.abs() {
        let slope = if dx == 0 { 0.0 } else { dy as f32 / dx as f32 };
        for x in a.x.min(b.x)..=a.x.max(b.x) {
            frame.put(x, (a.y as f32 + slope * (x - a.x) as f32).round() as i32);
        }
    } else {
        let slope = dx as f32 / dy as f32;
        for y in a.y.min(b.y)..=a.y.max(b.y) {
            frame.put((a.x as f32 + slope * (y - a.y) as f32).round() as i32, y);
        }
    }
}

/// A digital differential analyser: one rounded slope, added again and again.
fn dda<const FRACTION: u32>(frame: &mut Frame, a: Point, b: Point) {
    let (dx, dy) = (b.x - a.x, b.y - a.y);
    let n = dx.abs().max(dy.abs());
    let nearest = |d: i32| ((i64::from(d) << (FRACTION + 1)) + i64::from(n)).div_euclid(2 * i64::from(n)) as i32;
    let slope = |d: i32| if n == 0 { 0 } else { nearest(d) };
    let centre = |v: i32| (v << FRACTION) + (1 << (FRACTION - 1));
    let (slope_x, slope_y) = (slope(dx), slope(dy));
    let (mut x, mut y) = (centre(a.x), centre(a.y));
    for _ in 0..=n {
        frame.put(x >> FRACTION, y >> FRACTION);
        (x, y) = (x + slope_x, y + slope_y);
    }
}

/// Bresenham's loop for all octants.
pub(super) fn bresenham(frame: &mut Frame, a: Point, b: Point) {
    let (dx, dy) = ((b.x - a.x).abs(), (b.y - a.y).abs());
    let (step_x, step_y) = ((b.x - a.x).signum(), (b.y - a.y).signum());
    let (Point { mut x, mut y }, steep) = (a, dy > dx);
    let (da, db) = if steep { (dy, dx) } else { (dx, dy) };
    let mut p = 2 * db - da;
    for _ in 0..=da {
        frame.put(x, y);
        let minor = p >= 0;
        p += 2 * db - if minor { 2 * da } else { 0 };
        if minor || !steep {
            x += step_x;
        }
        if minor || steep {
            y += step_y;
        }
    }
}

/// This crate's spans, on the plain frame.
fn spans(frame: &mut Frame, a: Point, b: Point) {
    line::draw(a, b, WINDOW, |span: ClippedSpan| frame.span(span));
}

/// Draws the line between the ends moved to the border.
#[inline(always)]
fn moved(frame: &mut Frame, line: &Line, draw: impl Fn(&mut Frame, Point, Point)) {
    if let Some([a, b]) = move_ends([line.a, line.b]) {
        draw(frame, a, b);
    }
}

/// Sides of the screen that a point lies beyond: left, right, top, bottom.
fn outcode(p: Point) -> [bool; 4] {
    [p.x < 0, p.x >= WIDTH, p.y < 0, p.y >= HEIGHT]
}

/// Cohen's and Sutherland's clipping, to the nearest pixels.
fn move_ends(ends: [Point; 2]) -> Option<[Point; 2]> {
    let [mut a, mut b] = ends;
    loop {
        let (out_a, out_b) = (outcode(a), outcode(b));
        if out_a == [false; 4] && out_b == [false; 4] {
            return Some([a, b]);
        }
        if out_a.iter().zip(out_b).any(|(&a, b)| a && b) {
            return None;
        }
        if out_a == [false; 4] {
            b = to_border(b, a, out_b);
        } else {
            a = to_border(a, b, out_a);
        }
    }
}

/// Where the line from p to q crosses the first side that p lies beyond.
fn to_border(p: Point, q: Point, [left, right, top, _]: [bool; 4]) -> Point {
    let ratio = |distance: i32, rise: i32, run: i32| {
        let (n, d) = (2 * i64::from(distance) * i64::from(rise) * i64::from(run.signum()), 2 * i64::from(run.abs()));
        (n + d / 2).div_euclid(d) as i32
    };
    if left || right {
        let x = if left { 0 } else { WIDTH - 1 };
        Point::new(x, p.y + ratio(x - p.x, q.y - p.y, q.x - p.x))
    } else {
        let y = if top { 0 } else { HEIGHT - 1 };
        Point::new(p.x + ratio(y - p.y, q.x - p.x, q.y - p.y), y)
    }
}
