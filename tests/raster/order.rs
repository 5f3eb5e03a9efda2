//! What a [`Sink`] promises, through every entry: from the top down, inside of the window, never empty, each pixel of a filled
//! shape once; and that the extent of a shape encloses it.

#![allow(clippy::cast_possible_truncation, reason = "random bits, cut on purpose")]

use std::collections::HashSet;

use embedded_graphics_core::geometry::Point;
use embedded_raster::{
    raster::{arc, ellipse, line, outline, polygon, rectangle, rounded, stroke, triangle},
    Angle, ClippedSpan, EdgeSlot, Ellipse, FillRule, Octants, Path, PathSegment, PointFx, Radii, Rect, Sector, Sink,
    Steps, Stroke,
};
use fixed::types::I24F8;
use twins::rng::{cases, Rng};

/// What a shape has said so far.
struct Said {
    window: Rect,
    /// The row on which the last call began, and where the last span ended.
    row: i32,
    x: i32,
    pixels: Vec<(i32, i32)>,
    circles: usize,
}

/// A sink that checks every call. It takes circles as a whole, or not.
struct Strict<'a> {
    said: &'a mut Said,
    takes_circles: bool,
}

impl Strict<'_> {
    fn begins(&mut self, y: i32) {
        assert!(y >= self.said.row, "row {y} after row {}", self.said.row);
        if y > self.said.row {
            (self.said.row, self.said.x) = (y, i32::MIN);
        }
    }

    fn holds(&mut self, x0: i32, x1: i32, y: i32) {
        let window = self.said.window;
        assert!(x0 < x1, "an empty span in row {y}");
        assert!(window.contains(x0, y) && window.contains(x1 - 1, y), "{x0}..{x1} of row {y} leaves {window:?}");
        self.said.pixels.extend((x0..x1).map(|x| (x, y)));
    }
}

impl Sink for Strict<'_> {
    fn span(&mut self, span: ClippedSpan) {
        self.begins(span.y());
        assert!(span.x0() >= self.said.x, "{span:?} begins before {}", self.said.x);
        self.said.x = span.x1();
        self.holds(span.x0(), span.x1(), span.y());
    }

    fn area(&mut self, area: Rect) {
        self.begins(area.y0);
        assert!(!area.is_empty(), "an empty area {area:?}");
        (area.y0..area.y1).for_each(|y| self.holds(area.x0, area.x1, y));
    }

    fn steps(&mut self, steps: Steps) {
        self.begins(steps.first().1);
        let mut spans = vec![];
        steps.spans(|span| spans.push(span));
        for span in spans {
            self.holds(span.x0(), span.x1(), span.y());
        }
    }

    fn octants(&mut self, octants: Octants) -> bool {
        if self.takes_circles {
            let ((x, y), extent) = (octants.first(), octants.extent());
            self.begins(y);
            let window = self.said.window;
            assert!(window.contains(x, y) && window.contains(x + extent, y + extent), "{octants:?} leaves {window:?}");
            self.said.circles += 1;
        }
        self.takes_circles
    }
}

/// A shape: draws itself, and tells its extent.
type Draw<'a> = Box<dyn Fn(Rect, Strict<'_>) + 'a>;

#[test]
fn every_shape_keeps_the_promises_of_a_sink() {
    let mut rng = Rng::new(900);
    for round in 0..cases(6_000) {
        let place = |rng: &mut Rng| PointFx::from_bits(rng.int(-3_000, 15_000), rng.int(-3_000, 12_000));
        let point = |rng: &mut Rng| Point::new(rng.int(-10, 60), rng.int(-10, 45));
        let places: Vec<PointFx> = (0..rng.range(1, 8)).map(|_| place(&mut rng)).collect();
        let (a, b) = (point(&mut rng), point(&mut rng));
        let (x, y, w, h) = (rng.int(-9, 40), rng.int(-9, 30), rng.int(0, 40), rng.int(0, 40));
        let area = Rect::new(x, y, x + w, y + if rng.one_in(2) { w } else { h });
        let inner = Rect::new(x + w / 4, y + h / 4, x + w - w / 4, y + h - h / 4);
        let radius = I24F8::from_bits(rng.int(0, 6_000));
        let circle = Ellipse::circle(places[0], radius);
        let ellipse = if rng.one_in(2) { Ellipse::in_box(area) } else { circle };
        let sector = Sector::new(Angle::from_bits(rng.bits() as u32), Angle::from_bits(rng.bits() as u32));
        let mut radii = Radii::all(rng.int(0, 20).unsigned_abs());
        if rng.one_in(2) {
            radii.top_left = rng.int(0, 20).unsigned_abs();
        }
        let corners = [place(&mut rng), place(&mut rng), place(&mut rng)];
        let rule = rng.pick(&[FillRule::NonZero, FillRule::EvenOdd]);
        let curve = [
            PathSegment::MoveTo(places[0]),
            PathSegment::CubicTo(corners[0], corners[1], corners[2]),
            PathSegment::Close,
        ];
        let path = Path::new(&curve);
        let pen = Stroke::new(I24F8::from_bits(rng.int(0, 2_000)));
        let slots = if rng.one_in(2) { 400 } else { 24 };
        let table = || vec![EdgeSlot::EMPTY; slots];
        let filled: Vec<(&str, Rect, Draw<'_>)> = vec![
            ("rectangle", area, Box::new(|w, s| rectangle::fill(area, w, s))),
            ("rectangle, outline", area, Box::new(|w, s| rectangle::outline(area, w, s))),
            ("line", line::extent(a, b), Box::new(|w, s| line::draw(a, b, w, s))),
            ("triangle", triangle::extent(corners), Box::new(|w, s| triangle::fill(corners, w, s))),
            ("triangle, in blocks", triangle::extent(corners), Box::new(|w, s| triangle::walk_blocks(corners, w, s))),
            ("triangle, walked", triangle::extent(corners), Box::new(|w, s| triangle::walk(corners, w, s))),
            ("ellipse", ellipse.extent(), Box::new(|w, s| ellipse::fill(ellipse, w, s))),
            ("ellipse, outline", area, Box::new(|w, s| ellipse::outline(area, w, s))),
            ("ellipse, enclosed", area, Box::new(|w, s| ellipse::enclosed(area, w, s))),
            ("arc", area, Box::new(|w, s| arc::outline(area, sector, w, s))),
            ("sector", ellipse.extent(), Box::new(|w, s| arc::fill(ellipse, sector, w, s))),
            ("ring", ellipse.extent(), Box::new(|w, s| arc::ring(ellipse, Ellipse::in_box(inner), w, s))),
            (
                "ring sector",
                ellipse.extent(),
                Box::new(|w, s| arc::ring_sector(ellipse, Ellipse::in_box(inner), sector, w, s)),
            ),
            ("rounded", area, Box::new(|w, s| rounded::fill(area, radii, w, s))),
            ("rounded, enclosed", area, Box::new(|w, s| rounded::enclosed(area, radii, w, s))),
            ("rounded, outline", area, Box::new(|w, s| rounded::outline(area, radii, w, s))),
            (
                "polygon",
                polygon::extent([&places[..]]),
                Box::new(|w, s| polygon::fill([&places[..]], rule, &mut table(), w, s).expect("enough slots")),
            ),
            (
                "path",
                outline::extent(path),
                Box::new(|w, s| {
                    let _ = polygon::fill(path.contours_in(w), rule, &mut table(), w, s);
                }),
            ),
            (
                "stroke",
                stroke::extent(path, &pen),
                Box::new(|w, s| {
                    let _ = stroke::fill(path, &pen, &mut table(), w, s);
                }),
            ),
            (
                "stroked polyline",
                Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX),
                Box::new(|w, s| {
                    let _ = stroke::fill_polyline(&places, true, &pen, &mut table(), w, s);
                }),
            ),
        ];
        let window = match round % 3 {
            0 => Rect::new(-40, -40, 120, 120),
            1 => Rect::new(0, 0, 48, 36),
            _ => Rect::new(rng.int(-5, 30), rng.int(-5, 20), rng.int(0, 60), rng.int(0, 45)),
        };
        for (name, extent, draw) in &filled {
            for takes_circles in [false, true] {
                let mut said = Said { window, row: i32::MIN, x: i32::MIN, pixels: vec![], circles: 0 };
                draw(window, Strict { said: &mut said, takes_circles });
                let all: HashSet<_> = said.pixels.iter().copied().collect();
                assert_eq!(all.len(), said.pixels.len(), "{name}: pixels said twice");
                assert!(all.iter().all(|&(x, y)| extent.contains(x, y)), "{name} leaves its extent {extent:?}");
                assert!(said.circles == 0 || said.pixels.is_empty(), "{name}: a circle and its pixels");
            }
        }
        // A path's outline follows the path.
        let mut pixels = vec![];
        outline::draw(path, window, |s: ClippedSpan| pixels.extend((s.x0()..s.x1()).map(|x| (x, s.y()))));
        let extent = outline::extent(path);
        assert!(pixels.iter().all(|&(x, y)| extent.contains(x, y) && window.contains(x, y)), "outline in {extent:?}");
    }
}
