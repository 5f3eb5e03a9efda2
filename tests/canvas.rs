//! Whatever is drawn goes through the traits of surfaces: a wrapper that forwards nothing but spans sees every change, and the
//! picture is the same.

#![allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "random numbers, cut on purpose")]

use embedded_graphics::{
    mono_font::{ascii::FONT_6X10, MonoTextStyle},
    pixelcolor::{Gray8, Rgb565, Rgb888},
    prelude::*,
    primitives::Rectangle,
    text::Text,
};
use embedded_raster::{
    buffer_bytes, eg,
    pixel::Rgb444,
    raster::{
        ellipse,
        flood::{Connectivity, FloodSlot},
        line, rectangle, triangle,
    },
    surface::{Grid, Packed12, Pages, Planes, Rows},
    Bitmap, Canvas, ClippedSpan, EdgeSlot, Ellipse, FillRule, Frame, Framebuffer, Index1, Index2, Index4, Layout,
    Octants, Paint, PixelFormat, PointFx, Radii, Readable, Rect, Sector, Sink, Solid, Span, Steps, Surface,
};
use twins::{rng::Rng, watched::Watched};

/// What embedded-graphics draws by its own means, and paints of the caller's, on any surface.
fn draw<F: PixelFormat, S: Readable<Color = F::Color>>(on: &mut S, rng: &mut Rng, call: usize) {
    let mut color = || F::unpack(rng.bits() as u32 & (u32::MAX >> (32 - F::BITS)));
    let (c, other) = (color(), color());
    let mut place = || PointFx::from_bits(rng.int(-2_000, 12_000), rng.int(-2_000, 9_000));
    let corners = [place(), place(), place()];
    match call {
        0 => {
            let text = Text::new("Ag", corners[0].pixel(), MonoTextStyle::new(&FONT_6X10, c));
            let Ok(_) = text.draw(&mut eg::target(on));
        }
        1 => {
            let area = Rect::new(rng.int(-5, 30), rng.int(-5, 20), rng.int(10, 45), rng.int(5, 33));
            let colors = (0..400).map(|i| if i % 3 == 0 { c } else { other });
            let Ok(()) = eg::target(on).fill_contiguous(&area.into(), colors);
        }
        _ => on.paint(Solid(c), |window, brush| triangle::walk(corners, window, brush)),
    }
}

fn check<F: PixelFormat, L: Layout<Color = F::Color>>(seed: u64) {
    let mut rng = Rng::new(seed);
    let (width, height) = (41, 29);
    let needed = L::bytes(width, Grid { stride: L::row_bytes(width), rows: height.into() });
    for round in 0..180 {
        let call = round % 3;
        let before: Vec<u8> = (0..needed).map(|_| if rng.one_in(3) { rng.bits() as u8 } else { 0 }).collect();
        let window = if rng.one_in(2) { Rect::new(0, 0, 41, 29) } else { Rect::new(3, 2, 30, 25) };
        let (mut plain, mut wrapped) = (before.clone(), before.clone());
        let mut frame = Frame::<_, L>::new(&mut plain[..], width, height).expect("the right size");
        draw::<F, _>(&mut frame.clipped(window), &mut rng.clone(), call);
        let mut frame = Frame::<_, L>::new(&mut wrapped[..], width, height).expect("the right size");
        let mut watched = Watched::new(frame.clipped(window));
        draw::<F, _>(&mut watched, &mut rng, call);
        let seen = watched.seen;
        assert!(plain == wrapped, "call {call} in {window:?} through a wrapper");
        let old = Frame::<_, L>::new(&before[..], width, height).expect("the right size");
        let new = Frame::<_, L>::new(&wrapped[..], width, height).expect("the right size");
        for (x, y) in (0..29).flat_map(|y| (0..41).map(move |x| (x, y))) {
            let at = Point::new(x, y);
            assert!(old.get(at) == new.get(at) || seen.contains(&(x, y)), "call {call} changed ({x}, {y}) unseen");
        }
    }
}

#[test]
fn a_wrapper_sees_every_change() {
    check::<Index4, Rows<Index4>>(950);
    check::<Rgb565, Rows<Rgb565>>(951);
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
    let needed = L::bytes(width, Grid { stride: L::row_bytes(width), rows: height.into() });
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
    check_careless::<Rgb565, Rows<Rgb565>>();
    check_careless::<Index1, Pages<Index1>>();
    check_careless::<Index2, Planes<Index2>>();
    check_careless::<Rgb444, Packed12>();
}

/// A scene of pixels and boxes, given in the forms that `pixel` and `area` make.
fn scene<P: Into<Point> + Copy, A: Into<Rect>>(pixel: impl Fn(i32, i32) -> P, area: impl Fn(Rect) -> A) -> Vec<u8> {
    let (width, height) = (60, 50);
    let mut ram = vec![0; 60 * 50];
    let mut on = Framebuffer::<Gray8>::new(&mut ram, width, height).expect("the right size");
    let picture = Bitmap::<Gray8>::new(&[1, 2, 3, 4, 5, 6], 3, 2).expect("the right size");
    let glyph = Bitmap::<Index1>::new(&[0b1010_0000, 0b0100_0000], 3, 2).expect("the right size");
    let slice = Sector::slice(0, 1, 3);
    let (at, area) = (pixel, |x, y, size| area(Rect::new(x, y, x + size, y + size)));
    let mut next = 9;
    let mut c = || {
        next += 1;
        Gray8::new(next)
    };
    let mut table = [EdgeSlot::EMPTY; 8];
    on.draw_point(at(0, 0), c());
    on.draw_line(at(2, 0), at(20, 5), c());
    on.draw_polyline([at(0, 9), at(9, 7), at(12, 14)], c());
    on.draw_polygon([at(14, 9), at(22, 7), at(20, 14)], c());
    on.draw_triangle([at(24, 1), at(30, 7), at(23, 9)], c());
    on.fill_triangle([at(34, 1), at(40, 7), at(33, 9)], c());
    on.fill_polygon(&[at(44, 1), at(50, 7), at(43, 9)], FillRule::EvenOdd, &mut table, c()).expect("enough slots");
    on.draw_rectangle(area(1, 15, 8), c());
    on.fill_rectangle(area(10, 15, 8), c());
    on.draw_ellipse(area(19, 15, 8), c());
    on.fill_ellipse(area(28, 15, 8), c());
    on.fill_outlined_ellipse(area(37, 15, 8), c());
    on.draw_arc(area(46, 15, 8), slice, c());
    on.fill_sector(area(1, 25, 8), slice, c());
    on.fill_ring(area(10, 25, 8), area(12, 27, 4), c());
    on.fill_ring_sector(area(19, 25, 8), area(21, 27, 4), slice, c());
    on.draw_rounded(area(28, 25, 8), Radii::all(3), c());
    on.fill_rounded(area(37, 25, 8), Radii::all(3), c());
    on.blit(at(46, 25), &picture);
    on.blit_keyed(at(50, 25), &picture, Gray8::new(4));
    on.blit_mask(at(54, 25), &glyph, c(), None);
    on.move_area(area(28, 15, 8), at(1, 35));
    on.move_area_keyed(area(37, 15, 8), at(10, 35), Gray8::new(0));
    on.flood_fill(at(4, 18), Connectivity::Sides, &mut [FloodSlot::EMPTY; 8], c());
    on.flood_fill_to(at(31, 28), Gray8::new(26), Connectivity::Sides, &mut [FloodSlot::EMPTY; 8], c());
    assert_eq!(on.get(at(0, 0)), Some(Gray8::new(10)), "read");
    on.view(area(20, 35, 8)).fill_window(c());
    on.clipped(area(30, 35, 8)).fill_window(c());
    let (tile, clip) = (on.as_bitmap().view(area(20, 35, 8)), on.as_bitmap().clipped(area(30, 35, 8)));
    assert_eq!([tile.window(), clip.window()], [Rect::new(0, 0, 8, 8), Rect::new(30, 35, 38, 43)], "pictures");
    // Not only what is known by name.
    let any: &mut dyn Surface<Color = Gray8> = &mut on;
    any.draw_line(at(40, 36), at(50, 40), c());
    any.fill_rectangle(area(52, 36, 5), c());
    ram
}

#[test]
fn pixels_and_boxes_are_taken_in_every_form() {
    let plain = scene(Point::new, |area| area);
    let unseen: Vec<u8> = (10..=34).filter(|color| !plain.contains(color)).collect();
    assert_eq!(unseen, Vec::<u8>::new(), "colours of the shapes");
    assert!(plain == scene(|x, y| (x, y), Rectangle::from), "columns and rows, and embedded-graphics' boxes");
    assert!(plain == scene(|x, y| [x, y], |area| area), "arrays");
}

/// [`Readable::fill_corridor`] word for word: what a view does not show is not open, whatever lies there in memory.
fn check_corridors<F: PixelFormat>(seed: u64) -> usize
where
    F::Color: PartialEq,
{
    let mut rng = Rng::new(seed);
    let [open, wall, paint] = [1, 0, u32::MAX >> (32 - F::BITS)].map(F::unpack);
    let mut taken = 0;
    for _ in 0..4_000 {
        let (width, height) = (rng.int(1, 7) as u16, rng.int(1, 9) as u16);
        let density = rng.int(1, 5) as u64;
        let mut memory = vec![0; buffer_bytes::<F>(width, height)];
        let mut frame = Framebuffer::<F>::new(&mut memory, width, height).expect("the right size");
        for (x, y) in (0..height.into()).flat_map(|y| (0..width.into()).map(move |x| (x, y))) {
            frame.set(Point::new(x, y), if rng.one_in(density) { open } else { wall });
        }
        let (x, y) = (rng.int(0, 2), rng.int(0, 2));
        let mut view = frame.clipped(Rect::new(x, y, x + rng.int(1, 6), y + rng.int(1, 8)));
        let window = view.window();
        let at = Point::new(rng.int(window.x0 - 1, window.x1), rng.int(window.y0 - 1, window.y1));
        let down = rng.one_in(2);
        let is_open = |view: &Framebuffer<F>, x, y| view.get(Point::new(x, y)) == Some(open);
        let mut end = at.y;
        while is_open(&view, at.x, end) && !is_open(&view, at.x - 1, end) && !is_open(&view, at.x + 1, end) {
            end += if down { 1 } else { -1 };
        }
        let Some(found) = view.fill_corridor(at, down, paint, |color| color == open) else { continue };
        assert_eq!(found, end, "from {at:?} in {window:?}, down: {down}");
        let painted = if down { at.y..end } else { end + 1..at.y + 1 };
        assert!(painted.into_iter().all(|y| view.get(Point::new(at.x, y)) == Some(paint)), "{at:?} to row {end}");
        taken += 1;
    }
    taken
}

#[test]
fn corridors_end_where_the_rule_says() {
    let taken = [check_corridors::<Gray8>(960), check_corridors::<Rgb565>(961), check_corridors::<Rgb888>(962)];
    assert!(taken.iter().all(|&n| n > 100), "the shortcut was taken {taken:?} times");
}
