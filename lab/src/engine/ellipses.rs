//! Ways to fill an ellipse in a box of pixels.

use embedded_graphics::{
    prelude::*,
    primitives::{Ellipse as GraphicsEllipse, PrimitiveStyle, Rectangle},
};
use embedded_raster::{raster::ellipse, Canvas, ClippedSpan, Ellipse};

use super::{entry, ink, own, peers, plain, Entry, Origin};
use crate::{
    frame::{Frame, HEIGHT, WIDTH, WINDOW},
    shape::Oval,
};

pub(crate) fn entries() -> Vec<Entry<Oval>> {
    use Origin::{Crate, Peer, Textbook};
    vec![
        entry("float", "equation in f32, per pixel", Textbook, plain(|f, o: &Oval| per_pixel(f, o))),
        entry("root", "square root in f32, per row", Textbook, plain(|f, o: &Oval| per_row(f, o))),
        entry("midpoint", "midpoint in 32 bits, two regions", Textbook, plain(|f, o: &Oval| midpoint(f, o))),
        entry(
            "fill",
            "two sweeps: `ellipse::fill`",
            Crate,
            plain(|f, o: &Oval| ellipse::fill(Ellipse::in_box(o.area), WINDOW, |s: ClippedSpan| f.span(s))),
        ),
        entry("canvas", "`Canvas::fill_ellipse`", Crate, own(|f, o: &Oval| f.fill_ellipse(o.area, ink()))),
        entry(
            "eg",
            "embedded-graphics",
            Peer,
            peers::graphics(|f, o: &Oval| {
                let style = PrimitiveStyle::with_fill(ink());
                let Rectangle { top_left, size } = o.area.into();
                let Ok(()) = GraphicsEllipse::new(top_left, size).into_styled(style).draw(f);
            }),
        ),
        entry("skia", "tiny-skia", Peer, peers::skia(|p, o: &Oval| peers::fill(p, o.path.as_ref()))),
    ]
}

/// Centre and semi-axes in pixels.
fn floats(oval: &Oval) -> [f32; 4] {
    let area = oval.area;
    let half = |low: i32, high: i32| (f32::midpoint(low as f32, high as f32), (high as f32 - low as f32) / 2.0);
    let ((x, a), (y, b)) = (half(area.x0, area.x1), half(area.y0, area.y1));
    [x, y, a, b]
}

fn per_pixel(frame: &mut Frame, oval: &Oval) {
    let [cx, cy, a, b] = floats(oval);
    let area = oval.area.intersection(WINDOW);
    for y in area.y0..area.y1 {
        for x in area.x0..area.x1 {
            let (u, v) = ((x as f32 + 0.5 - cx) / a, (y as f32 + 0.5 - cy) / b);
            if u * u + v * v <= 1.0 {
                frame.put(x, y);
            }
        }
    }
}

fn per_row(frame: &mut Frame, oval: &Oval) {
    let [cx, cy, a, b] = floats(oval);
    let area = oval.area.intersection(WINDOW);
    for y in area.y0..area.y1 {
        let v = (y as f32 + 0.5 - cy) / b;
        let half = a * (1.0 - v * v).max(0.0).sqrt();
        row(frame, y, (cx - half - 0.5).ceil() as i32, (cx + half - 0.5).floor() as i32 + 1);
    }
}

fn row(frame: &mut Frame, y: i32, x0: i32, x1: i32) {
    let (x0, x1) = (x0.max(0), x1.min(WIDTH));
    if (0..HEIGHT).contains(&y) && x0 < x1 {
        frame.row(y, x0, x1);
    }
}

/// The textbook's: whole numbers as semi-axes, one region where the curve is flat and one where it is steep, products of 32
/// bits. It draws an ellipse of odd size around a pixel.
fn midpoint(frame: &mut Frame, oval: &Oval) {
    let area = oval.area;
    let (a, b) = ((area.width() as i32 - 1) / 2, (area.height() as i32 - 1) / 2);
    let (cx, cy) = (area.x0 + a, area.y0 + b);
    let (a2, b2) = (a.wrapping_mul(a), b.wrapping_mul(b));
    let mut rows = |x: i32, y: i32| {
        row(frame, cy - y, cx - x, cx + x + 1);
        row(frame, cy + y, cx - x, cx + x + 1);
    };
    let (mut x, mut y) = (0, b);
    let mut p = b2.wrapping_sub(a2.wrapping_mul(b)).wrapping_add(a2 / 4);
    while b2.wrapping_mul(x) < a2.wrapping_mul(y) {
        x += 1;
        if p < 0 {
            p = p.wrapping_add(b2.wrapping_mul(2 * x + 1));
        } else {
            rows(x - 1, y);
            y -= 1;
            p = p.wrapping_add(b2.wrapping_mul(2 * x + 1)).wrapping_sub(a2.wrapping_mul(2 * y));
        }
    }
    let square = |n: i32| n.wrapping_mul(n);
    p = (b2.wrapping_mul(square(2 * x + 1)) / 4)
        .wrapping_add(a2.wrapping_mul(square(y - 1)))
        .wrapping_sub(a2.wrapping_mul(b2));
    while y >= 0 {
        rows(x, y);
        y -= 1;
        if p > 0 {
            p = p.wrapping_add(a2.wrapping_mul(1 - 2 * y));
        } else {
            x += 1;
            p = p.wrapping_add(b2.wrapping_mul(2 * x)).wrapping_add(a2.wrapping_mul(1 - 2 * y));
        }
    }
}
