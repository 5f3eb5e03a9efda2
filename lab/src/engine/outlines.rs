//! Ways to draw a cubic Bézier curve one pixel wide.

use embedded_graphics::geometry::Point;
use embedded_raster::{raster::outline, Canvas, ClippedSpan, Path};

use super::{
    curves::{halve, uniform},
    entry, ink,
    lines::bresenham,
    own, peers, plain, Entry, Origin,
};
use crate::{
    frame::{Frame, WINDOW},
    shape::Thin,
};

pub(crate) fn entries() -> Vec<Entry<Thin>> {
    use Origin::{Crate, Peer, Textbook};
    vec![
        entry("points", "points closer than pixels, f32", Textbook, plain(|f, t: &Thin| points(f, t))),
        entry("uniform8", "8 lines, f32, Bresenham", Textbook, plain(|f, t: &Thin| lines::<8>(f, t))),
        entry("uniform32", "32 lines, f32, Bresenham", Textbook, plain(|f, t: &Thin| lines::<32>(f, t))),
        entry("halves", "de Casteljau, f32, Bresenham", Textbook, plain(|f, t: &Thin| halves(f, t))),
        entry(
            "draw",
            "exact lines: `outline::draw`",
            Crate,
            plain(|f, t: &Thin| outline::draw(Path::new(&t.curve.segments), WINDOW, |s: ClippedSpan| f.span(s))),
        ),
        entry(
            "canvas",
            "`Canvas::draw_path_fx`",
            Crate,
            own(|f, t: &Thin| f.draw_path_fx(Path::new(&t.curve.segments), ink())),
        ),
        entry("skia", "tiny-skia, hairline", Peer, peers::skia(|p, t: &Thin| peers::hairline(p, t.path.as_ref()))),
    ]
}

fn pixel((x, y): (f32, f32)) -> Point {
    Point::new(x.floor() as i32, y.floor() as i32)
}

/// As many places as its control polygon is long, in pixels, along the longer axis.
fn points(frame: &mut Frame, thin: &Thin) {
    let side = |l: &[(f32, f32)]| (l[1].0 - l[0].0).abs().max((l[1].1 - l[0].1).abs());
    let n: f32 = thin.curve.floats.windows(2).map(side).sum();
    uniform(n.ceil().max(1.0) as u16, &thin.curve, |p| {
        let Point { x, y } = pixel(p);
        frame.put(x, y);
    });
}

fn lines<const N: u16>(frame: &mut Frame, thin: &Thin) {
    let mut last = pixel(thin.curve.floats[0]);
    uniform(N, &thin.curve, |p| {
        let next = pixel(p);
        bresenham(frame, last, next);
        last = next;
    });
}

fn halves(frame: &mut Frame, thin: &Thin) {
    let mut last = pixel(thin.curve.floats[0]);
    let mut emit = |p| {
        let next = pixel(p);
        bresenham(frame, last, next);
        last = next;
    };
    halve(thin.curve.floats, &mut emit, 0);
}
