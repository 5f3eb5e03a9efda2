//! Ways to fill a triangle.

use embedded_raster::{
    raster::triangle::{fill, walk},
    Canvas, ClippedSpan,
};

use super::{entry, ink, own, peers, plain, Entry, Origin};
use crate::{
    frame::{Frame, HEIGHT, WIDTH, WINDOW},
    shape::{Triangle, Units},
};

/// The corners that an engine is given, in units: how far they are from the true ones is part of its error.
pub(crate) fn given(key: &str, triangle: &Triangle) -> [Units; 3] {
    match key {
        "float" | "skia" => triangle.as_floats(),
        "walk0" => triangle.snapped(0),
        "walk4" => triangle.snapped(4),
        "eg" => triangle.at_centres(),
        _ => triangle.snapped(8),
    }
}

pub(crate) fn entries() -> Vec<Entry<Triangle>> {
    use Origin::{Crate, Peer, Textbook};
    let mut entries = vec![
        entry("float", "barycentric in f32, per pixel", Textbook, plain(|f, t: &Triangle| barycentric(f, t.floats))),
        entry(
            "walk0",
            "edge functions, 0 bits",
            Textbook,
            plain(|f, t: &Triangle| walk(t.whole, WINDOW, |s: ClippedSpan| f.span(s))),
        ),
        entry(
            "walk4",
            "edge functions, 4 bits",
            Textbook,
            plain(|f, t: &Triangle| walk(t.sixteenths, WINDOW, |s: ClippedSpan| f.span(s))),
        ),
        entry(
            "walk8",
            "edge functions, 8 bits: `triangle::walk`",
            Crate,
            plain(|f, t: &Triangle| walk(t.vertices, WINDOW, |s: ClippedSpan| f.span(s))),
        ),
        entry(
            "fill",
            "span solver: `triangle::fill`",
            Crate,
            plain(|f, t: &Triangle| fill(t.vertices, WINDOW, |s: ClippedSpan| f.span(s))),
        ),
        entry(
            "canvas",
            "`Canvas::fill_triangle_fx`",
            Crate,
            own(|f, t: &Triangle| f.fill_triangle_fx(t.vertices, ink())),
        ),
        entry("eg", "embedded-graphics", Peer, peers::graphics(|f, t: &Triangle| peers::triangle(f, t.pixels, ink()))),
        entry("skia", "tiny-skia", Peer, peers::skia(|p, t: &Triangle| peers::fill(p, t.path.as_ref()))),
    ];
    for entry in &mut entries {
        // It visits every pixel of the triangle, on the screen or not, and its products overflow.
        entry.can_hard = entry.key != "eg";
    }
    entries
}

/// The textbook's test: the three barycentric coordinates of each centre of the bounding box.
fn barycentric(frame: &mut Frame, [a, b, c]: [(f32, f32); 3]) {
    let cross = |a: (f32, f32), b: (f32, f32), p: (f32, f32)| (b.0 - a.0) * (p.1 - a.1) - (b.1 - a.1) * (p.0 - a.0);
    let area = cross(a, b, c);
    if area == 0.0 {
        return;
    }
    let (left, right) = (a.0.min(b.0).min(c.0).max(0.0), a.0.max(b.0).max(c.0).min(WIDTH as f32 - 1.0));
    let (top, bottom) = (a.1.min(b.1).min(c.1).max(0.0), a.1.max(b.1).max(c.1).min(HEIGHT as f32 - 1.0));
    for y in top as i32..=bottom as i32 {
        for x in left as i32..=right as i32 {
            let p = (x as f32 + 0.5, y as f32 + 0.5);
            let (u, v) = (cross(b, c, p) / area, cross(c, a, p) / area);
            if u >= 0.0 && v >= 0.0 && 1.0 - u - v >= 0.0 {
                frame.put(x, y);
            }
        }
    }
}
