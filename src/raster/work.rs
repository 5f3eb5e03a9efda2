//! Work, counted: rounds of loops, and what a sink is told, against what the window shows of a shape. Windows as tall and as wide
//! as they get, shapes of any size up to the ends of the type.
//!
//! Floods, strokes and outlines of paths are counted in their own modules.

use std::{boxed::Box, vec, vec::Vec};

use embedded_graphics_core::geometry::Point;
use fixed::types::I24F8;
use twins::rng::Rng;

use super::{
    arc::{self, Sector},
    chord,
    coverage::{self, CoverageSlot},
    ellipse::{self, Ellipse},
    gauge, line, polygon, rectangle,
    rounded::{self, Radii},
    triangle,
};
use crate::{
    geom::{bits, fill_rule::FillRule, Angle, PointFx},
    num::tally::{self, Work},
    span::{ClippedSpan, Octants, Rect, Sink, Steps},
};

/// What a sink was told.
#[derive(Default)]
struct Told {
    calls: usize,
    pixels: u64,
}

impl Sink for &mut Told {
    fn span(&mut self, span: ClippedSpan) {
        self.calls += 1;
        self.pixels += u64::from(span.len());
    }

    fn area(&mut self, area: Rect) {
        self.calls += 1;
        self.pixels += u64::from(area.width()) * u64::from(area.height());
        assert!(!area.is_empty(), "an area without pixels");
    }

    fn steps(&mut self, steps: Steps) {
        self.calls += 1;
        self.pixels += u64::from(steps.len());
    }

    fn octants(&mut self, _: Octants) -> bool {
        false
    }
}

/// Rows and columns that a box has in a window; none of either if it has no pixel there.
fn shared(extent: Rect, window: Rect) -> (usize, usize) {
    let seen = extent.intersection(window);
    if seen.is_empty() {
        (0, 0)
    } else {
        (seen.height() as usize, seen.width() as usize)
    }
}

/// How often sides that are not right of the window cross rows of it, and how many sides there are.
fn crossings(contour: &[PointFx], window: Rect) -> usize {
    let side = |i: usize| [contour[i], contour[(i + 1) % contour.len()]];
    let rows = |[a, b]: [PointFx; 2]| {
        let row = |v: PointFx| crate::num::round::first_centre_from(bits(v).1).clamp(window.y0, window.y1);
        row(a).abs_diff(row(b)) as usize
    };
    let right = |[a, b]: [PointFx; 2]| i64::from(bits(a).0.min(bits(b).0)) > i64::from(window.x1) * 256 - 128;
    (0..contour.len()).map(side).filter(|&side| !right(side)).map(rows).sum()
}

/// How many pixels of a window sides may go through at most, those right of it left out: rows, and columns besides.
fn touched(contour: &[PointFx], window: Rect) -> (usize, usize) {
    let side = |i: usize| [contour[i], contour[(i + 1) % contour.len()]].map(bits);
    let seen = |a: i32, b: i32, low: i32, high: i32| {
        let (first, end) = ((a.min(b) >> 8).max(low), (a.max(b) >> 8).saturating_add(1).min(high));
        if first < end {
            end.abs_diff(first) as usize
        } else {
            0
        }
    };
    (0..contour.len()).map(side).filter(|[a, b]| a.0.min(b.0) >> 8 < window.x1).fold(
        (0, 0),
        |(rows, columns), [a, b]| {
            let r = seen(a.1, b.1, window.y0, window.y1);
            let c = if r > 0 { seen(a.0, b.0, window.x0, window.x1) } else { 0 };
            (rows + r, columns + c)
        },
    )
}

fn log(n: usize) -> usize {
    n.max(1).ilog2() as usize + 1
}

type Draw<'a> = Box<dyn Fn(&mut Told) + 'a>;

/// The name of a shape, how it is drawn, and how many rounds of its loops and calls of the sink that may take.
type Shape<'a> = (&'static str, Draw<'a>, usize, usize);

/// A window, and shapes.
#[derive(Debug)]
struct Scene {
    window: Rect,
    ends: [Point; 2],
    corners: [PointFx; 3],
    contour: Vec<PointFx>,
    area: Rect,
    ellipse: Ellipse,
    hole: Ellipse,
    /// Of a ring, in pixels.
    width: i32,
    sector: Sector,
    radii: Radii,
}

impl Scene {
    fn random(rng: &mut Rng) -> Self {
        let shift = rng.int(0, 24);
        let number = |rng: &mut Rng| match rng.below(8) {
            0 => rng.pick(&[i32::MIN, i32::MAX, 0, -1]),
            _ => rng.int(i32::MIN, i32::MAX) >> shift,
        };
        let place = |rng: &mut Rng| PointFx::from_bits(number(rng), number(rng));
        let point = |rng: &mut Rng| Point::new(number(rng), number(rng));
        let area = |rng: &mut Rng| {
            let [a, b] = [point(rng), point(rng)];
            Rect::new(a.x.min(b.x), a.y.min(b.y), a.x.max(b.x), a.y.max(b.y))
        };
        let radius = |rng: &mut Rng| I24F8::from_bits(number(rng).saturating_abs());
        let angle = |rng: &mut Rng| Angle::from_bits(rng.int(i32::MIN, i32::MAX).cast_unsigned());
        let corners = [(); 3].map(|()| place(rng));
        let outer = area(rng);
        let ellipse = Ellipse::new(place(rng), radius(rng), radius(rng));
        let (w, h) = match rng.below(20) {
            0 => (2, 65_535),
            1 => (65_535, 2),
            _ => (rng.int(1, 90), rng.int(1, 70)),
        };
        let at = match rng.below(4) {
            0 => Point::new(-w / 2, -h / 2),
            1 => Point::new(rng.pick(&[i32::MIN, i32::MAX - w]), rng.pick(&[i32::MIN, i32::MAX - h])),
            2 => outer.top_left(),
            _ => Point::new(bits(corners[0]).0 >> 8, bits(corners[0]).1 >> 8),
        };
        Self {
            window: Rect::new(at.x, at.y, at.x.saturating_add(w), at.y.saturating_add(h)),
            ends: [point(rng), point(rng)],
            corners,
            contour: (0..rng.range(2, 40)).map(|_| place(rng)).collect(),
            area: outer,
            ellipse,
            hole: if rng.one_in(2) { Ellipse::in_box(area(rng)) } else { ellipse },
            width: rng.int(0, 90) >> rng.int(0, 6),
            sector: Sector::new(angle(rng), angle(rng)),
            radii: Radii { top_left: rng.int(0, 90).unsigned_abs(), ..Radii::all(number(rng).unsigned_abs()) },
        }
    }

    /// Of lines.
    fn straight(&self) -> Vec<Shape<'_>> {
        let Self { window: w, ends: [a, b], area, corners, ref contour, .. } = *self;
        let outer = triangle::extent(corners);
        // A triangle or a polygon is followed over its rows even beside the window.
        let beside = |extent: Rect| shared(Rect { x0: i32::MIN, x1: i32::MAX, ..extent }, w).0;
        let (rows, (walked, columns)) = (beside(outer), shared(outer, w));
        let (n, crossed) = (contour.len(), crossings(contour, w));
        let (soft_rows, soft_columns) = touched(contour, w);
        let tall = shared(coverage::extent([contour]), Rect { x0: i32::MIN, x1: i32::MAX, ..w }).0;
        let words = tall * (w.width() as usize).div_ceil(32);
        vec![
            ("line", Box::new(move |s| line::draw(a, b, w, s)), 0, 1),
            ("rectangle", Box::new(move |s| rectangle::fill(area, w, s)), 0, 1),
            ("rectangle, outline", Box::new(move |s| rectangle::outline(area, w, s)), 0, 4),
            // The sides may change places, once for each block of rows.
            ("triangle", Box::new(move |s| triangle::fill(corners, w, s)), rows + rows / 64 + 3, rows),
            ("triangle, walked", Box::new(move |s| triangle::walk(corners, w, s)), walked * (columns + 1), walked),
            // Each edge is looked at on each row, and once in a span; edges are sorted when they come, and when they cross.
            (
                "polygon",
                Box::new(move |s| {
                    let mut table = [polygon::EdgeSlot::EMPTY; 40];
                    polygon::fill([&contour[..]], FillRule::EvenOdd, &mut table, w, s).expect("enough slots");
                }),
                n + 2 * crossed + 3 * (n + crossed.min(n * n)) * log(n),
                crossed,
            ),
            // A side is looked at on each row that it touches, and before, on two rows for each of the shape. It goes through a pixel
            // on each of them, and one more for each column; and a row has a word for each 32 pixels.
            (
                "coverage",
                Box::new(move |s| {
                    let (mut table, mut cells) = ([CoverageSlot::EMPTY; 40], vec![0; coverage::cells(65_535)]);
                    coverage::fill([&contour[..]], FillRule::EvenOdd, &mut table, &mut cells, w, s)
                        .expect("enough slots");
                }),
                n + 2 * tall + 2 * soft_rows + soft_columns + words,
                3 * (soft_rows + soft_columns) + words + tall,
            ),
        ]
    }

    /// Of curves.
    fn round(&self) -> Vec<Shape<'_>> {
        let Self { window: w, area, ellipse, hole, width, sector, radii, .. } = *self;
        let in_box = Ellipse::in_box(area);
        let (rows, columns) = shared(area, w);
        let [both, free, hidden] = [area, ellipse.extent(), hole.extent()].map(|extent| {
            let (rows, columns) = shared(extent, w);
            rows + columns
        });
        let bisected = 4 * rows * log(columns);
        let free_rows = shared(ellipse.extent(), w).0;
        // A disc of a gauge has a part of a ray as its diameter, so it reaches beyond the box of the ring by half of a radius at most.
        let inner = Ellipse::in_box(area.inset(width));
        let beyond = i32::try_from(area.width().max(area.height()) / 4).expect("below 2^30") + 1;
        let (gauge_rows, gauge_columns) = shared(area.inset(-beyond), w);
        vec![
            ("ellipse", Box::new(move |s| ellipse::fill(ellipse, w, s)), 2 * free, free_rows),
            ("ellipse, in a box", Box::new(move |s| ellipse::fill(in_box, w, s)), 2 * both, rows),
            ("ellipse, outline", Box::new(move |s| ellipse::outline(area, w, s)), 4 * both + 9, 2 * rows),
            ("arc", Box::new(move |s| arc::outline(area, sector, w, s)), 4 * both + 9 + bisected, 6 * rows),
            ("ring", Box::new(move |s| arc::ring(in_box, hole, w, s)), 2 * (both + hidden), 2 * rows),
            (
                "ring sector",
                Box::new(move |s| arc::ring_sector(in_box, hole, sector, w, s)),
                2 * (both + hidden) + bisected,
                6 * rows,
            ),
            // A bisection for each row that the chord crosses.
            ("chord", Box::new(move |s| chord::fill(in_box, sector, w, s)), 2 * both + rows * log(columns), rows),
            // That of the sector of the ring, and of two discs; then all rows are gone through together.
            (
                "gauge",
                Box::new(move |s| gauge::fill(in_box, inner, sector, w, s)),
                8 * (gauge_rows + gauge_columns) + bisected,
                8 * gauge_rows,
            ),
            ("rounded", Box::new(move |s| rounded::fill(area, radii, w, s)), 3 * rows + 8 * columns, rows),
            (
                "rounded, outline",
                Box::new(move |s| rounded::outline(area, radii, w, s)),
                5 * rows + 16 * columns + 9,
                2 * rows,
            ),
        ]
    }
}

#[test]
fn work_is_bounded_by_what_the_window_shows() {
    let mut rng = Rng::new(550);
    // How often a shape was seen, and the most of a bound that was needed, in hundredths.
    let (mut shown, mut used) = (vec![0_usize; 17], vec![0_usize; 17]);
    for _ in 0..5_000 {
        let scene = Scene::random(&mut rng);
        for (i, (name, draw, most, calls)) in scene.straight().into_iter().chain(scene.round()).enumerate() {
            let mut told = Told::default();
            let done = tally::of(|| draw(&mut told))[Work::Step as usize];
            assert!(done <= most, "{name}: {done} rounds, at most {most}: {scene:?}");
            assert!(told.calls <= calls, "{name}: {} calls, at most {calls}: {scene:?}", told.calls);
            assert!(told.pixels >= told.calls as u64, "{name}: calls without pixels: {scene:?}");
            shown[i] += usize::from(told.pixels > 0);
            if most > 99 {
                used[i] = used[i].max(done * 100 / most);
            }
        }
    }
    assert!(shown.iter().all(|&n| n > 80), "too few were seen: {shown:?}");
    // The first three have no loops.
    assert!(used.iter().skip(3).all(|&hundredths| hundredths > 30), "bounds that say nothing: {used:?}");
}
