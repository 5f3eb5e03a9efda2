//! Whatever is drawn goes through the traits of surfaces: a wrapper that forwards nothing but spans sees every change, and the
//! picture is the same.

#![allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "random numbers, cut on purpose")]

use embedded_graphics::{
    mono_font::{ascii::FONT_6X10, MonoTextStyle},
    prelude::*,
    text::Text,
};
use embedded_raster::{
    eg,
    raster::{
        ellipse,
        flood::{Connectivity, FloodSlot},
        line, rectangle,
    },
    surface::{Pages, Planes, Rows},
    Angle, Bitmap, Canvas, ClippedSpan, EdgeSlot, Ellipse, FillRule, Frame, Index1, Index2, Index4, Layout, Octants,
    Paint, Path, PathSegment, PixelFormat, PointFx, Radii, Readable, Rect, Sector, Sink, Solid, Span, Steps, Stroke,
    Surface,
};
use fixed::types::I24F8;
use twins::rng::Rng;

/// Notes which pixels are painted, and forwards spans and reading: no more than it must.
struct Damage<'a, L: Layout> {
    inner: Frame<&'a mut [u8], L>,
    seen: Vec<(i32, i32)>,
}

impl<L: Layout> Surface for Damage<'_, L> {
    type Color = L::Color;

    fn window(&self) -> Rect {
        self.inner.window()
    }

    fn fill_span(&mut self, span: ClippedSpan, color: L::Color) {
        self.seen.extend((span.x0()..span.x1()).map(|x| (x, span.y())));
        self.inner.fill_span(span, color);
    }
}

impl<L: Layout> Readable for Damage<'_, L> {
    fn color_at(&self, x: i32, y: i32) -> L::Color {
        self.inner.color_at(x, y)
    }
}

/// Every call of the everyday API on any surface, by its number.
fn draw<F: PixelFormat, S: Readable<Color = F::Color>>(on: &mut S, rng: &mut Rng, call: usize) {
    let bits = F::BITS;
    let mut color = || F::unpack(rng.bits() as u32 & (u32::MAX >> (32 - bits)));
    let (c, other) = (color(), color());
    let mut place = || PointFx::from_bits(rng.int(-2_000, 12_000), rng.int(-2_000, 9_000));
    let (p, q, r) = (place(), place(), place());
    let point = |p: PointFx| p.pixel();
    let area = Rect::new(rng.int(-5, 30), rng.int(-5, 20), rng.int(10, 45), rng.int(5, 33));
    let inner = area.inset(3);
    let radii = Radii::all(rng.int(0, 9) as u32);
    let sector = Sector::new(Angle::from_bits(rng.bits() as u32), Angle::from_bits(rng.bits() as u32));
    let ellipse = Ellipse::new(p, I24F8::from_bits(rng.int(0, 4_000)), I24F8::from_bits(rng.int(0, 3_000)));
    let curve = [PathSegment::MoveTo(p), PathSegment::QuadraticTo(q, r), PathSegment::Close];
    let path = Path::new(&curve);
    let table = &mut [EdgeSlot::EMPTY; 64];
    let slots = &mut [FloodSlot::EMPTY; 3];
    let size = I24F8::from_bits(rng.int(0, 3_000));
    let stroke = Stroke::new(I24F8::from_bits(600));
    let bytes: [u8; 64] = std::array::from_fn(|_| rng.bits() as u8);
    let picture = Bitmap::<F>::new(&bytes, 5, 4).expect("enough bytes");
    let mask = Bitmap::<Index1>::new(&bytes, 11, 7).expect("enough bytes");
    let to = point(q);
    match call {
        0 => on.fill_window(c),
        1 => on.draw_point(point(p), c),
        2 => on.draw_point_fx(p, c),
        3 => on.draw_line(point(p), point(q), c),
        4 => on.draw_polyline([p, q, r].map(point), c),
        5 => on.draw_polygon([p, q, r].map(point), c),
        6 => on.draw_triangle([p, q, r].map(point), c),
        7 => on.draw_rectangle(area, c),
        8 => on.fill_rectangle(area, c),
        9 => on.fill_rectangle_fx(p, q, c),
        10 => on.fill_triangle([p, q, r].map(point), c),
        11 => on.fill_triangle_fx([p, q, r], c),
        12 => on.draw_ellipse(area, c),
        13 => on.fill_ellipse(area, c),
        14 => on.fill_ellipse_fx(ellipse, c),
        15 => on.fill_outlined_ellipse(area, c),
        16 => on.fill_round_point_fx(p, size, c),
        17 => on.fill_square_point_fx(p, size, c),
        18 => on.draw_arc(area, sector, c),
        19 => on.fill_sector(area, sector, c),
        20 => on.fill_sector_fx(ellipse, sector, c),
        21 => on.fill_ring(area, inner, c),
        22 => on.fill_ring_fx(ellipse, Ellipse::in_box(inner), c),
        23 => on.fill_ring_sector(area, inner, sector, c),
        24 => on.fill_ring_sector_fx(ellipse, Ellipse::in_box(inner), sector, c),
        25 => on.draw_rounded(area, radii, c),
        26 => on.fill_rounded(area, radii, c),
        27 => on.fill_polygon(&[p, q, r].map(point), FillRule::EvenOdd, table, c).expect("three slots"),
        28 => on.fill_polygon_fx(&[p, q, r], FillRule::NonZero, table, c).expect("three slots"),
        29 => on.fill_contours_fx([[p, q, r], [q, p, r]], FillRule::EvenOdd, table, c).expect("six slots"),
        30 => on.draw_path_fx(path, c),
        31 => on.fill_path_fx(path, FillRule::NonZero, table, c).expect("enough slots"),
        32 => on.draw_quadratic_fx([p, q, r], c),
        33 => on.draw_cubic_fx([p, q, r, p], c),
        34 => {
            let _ = on.stroke_path_fx(path, &stroke, table, c);
        }
        35 => {
            let _ = on.stroke_polyline_fx(&[p, q, r], true, &stroke, table, c);
        }
        36 => {
            let _ = on.stroke_line_fx([p, q], &stroke, table, c);
        }
        37 => on.blit(to, &picture),
        38 => on.blit_keyed(to, &picture, c),
        39 => on.blit_mask(to, &mask, c, Some(other)),
        40 => on.blit_mask(to, &mask, c, None),
        41 => on.move_area(area, to),
        42 => on.move_area_keyed(area, to, c),
        43 => {
            let _ = on.flood_fill(to, Connectivity::Sides, slots, c);
        }
        44 => {
            let _ = on.flood_fill_to(to, other, Connectivity::Corners, slots, c);
        }
        45 => on.set(to, c),
        46 => {
            let text = Text::new("Ag", point(p), MonoTextStyle::new(&FONT_6X10, c));
            let Ok(_) = text.draw(&mut eg::target(on));
        }
        47 => {
            let solid = embedded_graphics::primitives::Rectangle::from(area);
            let Ok(()) = eg::target(on).fill_contiguous(&solid, (0..400).map(|i| if i % 3 == 0 { c } else { other }));
        }
        _ => on.paint(Solid(c), |window, brush| embedded_raster::raster::triangle::walk([p, q, r], window, brush)),
    }
}

const CALLS: usize = 49;

fn check<F: PixelFormat, L: Layout<Color = F::Color>>(seed: u64) {
    let mut rng = Rng::new(seed);
    let (width, height) = (41, 29);
    let row = L::row_bytes(width);
    let needed = L::bytes(width, embedded_raster::surface::Grid { stride: row, rows: height.into() });
    for round in 0..60 * CALLS {
        let call = round % CALLS;
        let before: Vec<u8> = (0..needed).map(|_| if rng.one_in(3) { rng.bits() as u8 } else { 0 }).collect();
        let window = if rng.one_in(2) { Rect::new(0, 0, 41, 29) } else { Rect::new(3, 2, 30, 25) };
        let (mut plain, mut watched) = (before.clone(), before.clone());
        let mut frame = Frame::<_, L>::new(&mut plain[..], width, height).expect("the right size");
        draw::<F, _>(&mut frame.clipped(window), &mut rng.clone(), call);
        let mut frame = Frame::<_, L>::new(&mut watched[..], width, height).expect("the right size");
        let mut damage = Damage { inner: frame.clipped(window), seen: vec![] };
        draw::<F, _>(&mut damage, &mut rng, call);
        let seen: std::collections::HashSet<_> = damage.seen.into_iter().collect();
        assert!(plain == watched, "call {call} in {window:?} through a wrapper");
        let old = Frame::<_, L>::new(&before[..], width, height).expect("the right size");
        let new = Frame::<_, L>::new(&watched[..], width, height).expect("the right size");
        for (x, y) in (0..29).flat_map(|y| (0..41).map(move |x| (x, y))) {
            let at = Point::new(x, y);
            assert!(old.get(at) == new.get(at) || seen.contains(&(x, y)), "call {call} changed ({x}, {y}) unseen");
        }
    }
}

#[test]
fn a_wrapper_sees_every_change() {
    check::<Index4, Rows<Index4>>(950);
    check::<embedded_graphics::pixelcolor::Rgb565, Rows<embedded_graphics::pixelcolor::Rgb565>>(951);
    check::<Index1, Pages<Index1>>(952);
    check::<Index2, Planes<Index2>>(953);
}

/// Gives what shapes say in a window of its own to the surface of a smaller one, as safe code can.
struct Careless<'a, 'b, L: Layout>(&'a mut Frame<&'b mut [u8], L>, L::Color);

impl<L: Layout> Sink for Careless<'_, '_, L> {
    fn span(&mut self, span: ClippedSpan) {
        let color = self.1;
        self.0.fill_span(span, color);
        self.0.write_span(span, |_| color);
        self.0.write_some(span, |_| Some(color));
        self.0.edit_span(span, |_, _| color);
        Solid(color).span(self.0, span);
    }

    fn area(&mut self, area: Rect) {
        self.0.fill_area(area, self.1);
        self.0.paint(Solid(self.1), |_, mut brush| brush.area(area));
        (area.y0..area.y1)
            .for_each(|y| self.span(Span { y, x0: area.x0, x1: area.x1 }.clip(area).expect("a row of it")));
    }

    fn steps(&mut self, steps: Steps) {
        self.0.fill_steps(steps, self.1);
        self.0.paint(Solid(self.1), |_, mut brush| brush.steps(steps));
    }

    fn octants(&mut self, octants: Octants) -> bool {
        let color = self.1;
        self.0.fill_octants(octants, color) | self.0.paint(Solid(color), |_, mut brush| brush.octants(octants))
    }
}

/// A shape, told to whoever is careless.
type Shape<'s, L> = &'s dyn Fn(Careless<'_, '_, L>);

fn check_careless<F: PixelFormat, L: Layout<Color = F::Color>>() {
    let (width, height) = (40, 32);
    let needed = L::bytes(width, embedded_raster::surface::Grid { stride: L::row_bytes(width), rows: height.into() });
    let [paper, ink] = [0, 1].map(F::unpack);
    let view = Rect::new(7, 5, 27, 25);
    let anywhere = Rect::new(-100, -100, 100, 100);
    let shapes: [Shape<'_, L>; 7] = [
        &|mut sink| sink.span(Span { y: 0, x0: -5, x1: 90 }.clip(anywhere).expect("inside of that")),
        &|sink| rectangle::fill(Rect::new(-50, -50, 15, 90), anywhere, sink),
        &|sink| line::draw(Point::new(-9, -30), Point::new(35, 60), anywhere, sink),
        &|sink| line::draw(Point::new(-60, 12), Point::new(70, 3), anywhere, sink),
        &|sink| line::draw(Point::new(-60, 7), Point::new(70, 7), anywhere, sink),
        &|sink| ellipse::outline(Rect::new(-4, -3, 27, 28), anywhere, sink),
        &|sink| ellipse::fill(Ellipse::in_box(Rect::new(-4, -3, 60, 28)), anywhere, sink),
    ];
    for (i, shape) in shapes.iter().enumerate() {
        let mut memory = vec![0; needed];
        let mut frame = Frame::<_, L>::new(&mut memory[..], width, height).expect("the right size");
        frame.fill_window(paper);
        // Coordinates of a view begin at its corner, and those of a clip at the corner of the frame.
        for clipped in [false, true] {
            let mut part = if clipped { frame.clipped(view) } else { frame.view(view) };
            shape(Careless(&mut part, ink));
        }
        for at in (0..32).flat_map(|y| (0..40).map(move |x| Point::new(x, y))) {
            let changed = frame.get(at) != Some(paper);
            assert!(!changed || view.contains(at.x, at.y), "shape {i} painted {at} outside of {view:?}");
        }
        let seen = (0..32).flat_map(|y| (0..40).map(move |x| Point::new(x, y))).any(|at| frame.get(at) == Some(ink));
        assert!(seen, "shape {i} painted what lies inside");
    }
}

#[test]
fn nothing_outside_of_a_view_is_painted_whatever_it_is_told() {
    check_careless::<Index1, Rows<Index1>>();
    check_careless::<Index4, Rows<Index4>>();
    check_careless::<embedded_graphics::pixelcolor::Rgb565, Rows<embedded_graphics::pixelcolor::Rgb565>>();
    check_careless::<Index1, Pages<Index1>>();
    check_careless::<Index2, Planes<Index2>>();
    check_careless::<embedded_raster::pixel::Rgb444, embedded_raster::surface::Packed12>();
}
