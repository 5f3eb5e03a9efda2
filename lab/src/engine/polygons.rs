//! Ways to fill a polygon by the even-odd rule.

use embedded_raster::{raster::polygon, Canvas, ClippedSpan, EdgeSlot, FillRule::EvenOdd};

use super::{entry, ink, own, peers, plain, Entry, Origin};
use crate::{
    frame::{Frame, HEIGHT, WIDTH, WINDOW},
    shape::Polygon,
};

/// Slots of the edge table: more than any shape here has sides.
const TABLE: usize = 2048;

pub(crate) fn entries() -> Vec<Entry<Polygon>> {
    use Origin::{Crate, Peer, Textbook};
    let mut crossings = Vec::new();
    let mut table = vec![EdgeSlot::EMPTY; TABLE];
    let mut exact = move |f: &mut Frame, p: &Polygon| {
        let filled = polygon::fill([&p.vertices[..]], EvenOdd, &mut table, WINDOW, |s: ClippedSpan| f.span(s));
        filled.expect("the table is larger than the outline");
    };
    let mut scratch = vec![EdgeSlot::EMPTY; TABLE];
    vec![
        entry(
            "float",
            "f32 crossings, every side on every row",
            Textbook,
            plain(move |f, p: &Polygon| every_side(f, p, &mut crossings)),
        ),
        entry("float-edges", "f32 edge table, x += slope", Textbook, plain(|f, p: &Polygon| edge_table(f, &p.floats))),
        entry("fill", "exact edge table: `polygon::fill`", Crate, plain(move |f, p: &Polygon| exact(f, p))),
        entry(
            "canvas",
            "`Canvas::fill_polygon_fx`",
            Crate,
            own(move |f, p: &Polygon| {
                f.fill_polygon_fx(&p.vertices, EvenOdd, &mut scratch, ink())
                    .expect("the table is larger than the outline");
            }),
        ),
        entry("skia", "tiny-skia", Peer, peers::skia(|f, p: &Polygon| peers::fill_even_odd(f, p.path.as_ref()))),
    ]
}

/// The first pixel whose centre is at or right of x, on the screen.
fn first_pixel(x: f32) -> i32 {
    ((x - 0.5).ceil() as i32).clamp(0, WIDTH)
}

/// Paints between the first crossing and the second, between the third and the fourth ...
fn fill_pairs(frame: &mut Frame, y: i32, crossings: &mut [f32]) {
    crossings.sort_unstable_by(f32::total_cmp);
    for pair in crossings.chunks_exact(2) {
        let (x0, x1) = (first_pixel(pair[0]), first_pixel(pair[1]));
        if x0 < x1 {
            frame.row(y, x0, x1);
        }
    }
}

/// Rows of the screen that the outline touches.
fn rows(corners: &[(f32, f32)]) -> std::ops::Range<i32> {
    let heights = || corners.iter().map(|v| v.1);
    let (top, bottom) = (heights().fold(f32::MAX, f32::min), heights().fold(f32::MIN, f32::max));
    top.max(0.0) as i32..(bottom.ceil() as i32).min(HEIGHT)
}

/// The textbook's loop: on each row all sides are tried, the crossings sorted, every second gap filled.
fn every_side(frame: &mut Frame, polygon: &Polygon, crossings: &mut Vec<f32>) {
    let corners = &polygon.floats;
    for y in rows(corners) {
        let centre = y as f32 + 0.5;
        crossings.clear();
        let mut a = corners[corners.len() - 1];
        for &b in corners {
            if (a.1 <= centre) != (b.1 <= centre) {
                crossings.push(a.0 + (centre - a.1) * (b.0 - a.0) / (b.1 - a.1));
            }
            a = b;
        }
        fill_pairs(frame, y, crossings);
    }
}

/// A side on its way down: where it is, how far it moves a row, and the row after its last.
struct FloatEdge {
    x: f32,
    slope: f32,
    first: i32,
    end: i32,
}

/// The textbook's edge table: crossings move from row to row by adding the slope.
pub(super) fn edge_table(frame: &mut Frame, corners: &[(f32, f32)]) {
    let mut waiting = float_edges(corners);
    waiting.sort_unstable_by_key(|edge| edge.first);
    let (mut active, mut crossings) = (Vec::<FloatEdge>::new(), Vec::new());
    let mut waiting = waiting.into_iter().peekable();
    for y in rows(corners) {
        active.retain(|edge| edge.end > y);
        while let Some(edge) = waiting.next_if(|edge| edge.first <= y) {
            active.push(edge);
        }
        crossings.clear();
        crossings.extend(active.iter().map(|edge| edge.x));
        fill_pairs(frame, y, &mut crossings);
        for edge in &mut active {
            edge.x += edge.slope;
        }
    }
}

/// The sides that cross a row of the screen, each at its first one.
fn float_edges(corners: &[(f32, f32)]) -> Vec<FloatEdge> {
    let next = corners.iter().cycle().skip(1);
    let edge = |(&a, &b): (&(f32, f32), &(f32, f32))| {
        let (a, b) = if a.1 <= b.1 { (a, b) } else { (b, a) };
        let row = |y: f32| ((y - 0.5).ceil() as i32).clamp(0, HEIGHT);
        let (first, end) = (row(a.1), row(b.1));
        let slope = (b.0 - a.0) / (b.1 - a.1);
        (first < end).then_some(FloatEdge { x: a.0 + (first as f32 + 0.5 - a.1) * slope, slope, first, end })
    };
    corners.iter().zip(next).filter_map(edge).collect()
}
