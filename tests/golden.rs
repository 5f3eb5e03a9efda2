//! Small scenes at every depth against the pictures in `tests/golden`.
//!
//! `BLESS=1 cargo test --workspace --test golden` writes the pictures anew: look at each before committing it. On a mismatch what was
//! drawn and where it differs are written beside the picture.

#[path = "golden/letters.rs"]
mod letters;
#[path = "golden/compare.rs"]
mod pictures;

use std::{convert::Infallible, thread};

use embedded_graphics::{
    draw_target::DrawTarget,
    image::GetPixel,
    mono_font::{ascii::FONT_6X10, MonoTextStyleBuilder},
    pixelcolor::{Rgb565, Rgb888},
    prelude::*,
    text::Text,
};
use embedded_raster::{
    buffer_bytes,
    geom::{
        delaunay,
        triangulate::{self, SideSlot},
        Arc, Curves,
    },
    pixel::{Lsb0, Xrgb8888, EGA},
    px,
    raster::{
        flood::{Connectivity, FloodSlot},
        polygon::drop_out::DropOut,
    },
    surface::{paged_bytes, Bitmap, Grid, Paged, Pages, Rows},
    Affine, Align, Angle, Canvas, Cap, EdgeSlot, Ellipse, FillRule, Frame, Framebuffer, Index1, Index2, Index4, Index8,
    Join, Layout, Palette, Path, PathSegment, PixelFormat, PointFx, Radii, Rect, Sector, Stroke, Surface,
};
use embedded_raster_simulator::Picture;
use fixed::types::{I16F16, I24F8};
use pictures::{compare, is_blessing};

const WIDTH: u16 = 96;
const HEIGHT: u16 = 64;

/// Colours of the scenes, by their numbers in the EGA palette.
const GROUND: u8 = 1;
const GREY: u8 = 7;
const GREEN: u8 = 10;
const RED: u8 = 12;
const YELLOW: u8 = 14;

/// A colour that scenes are painted in at some depth.
trait Ink: PixelColor + PixelFormat<Color = Self> {
    /// What stands for an EGA colour.
    fn ega(index: u8) -> Self;

    /// What is in a framebuffer, or in pages.
    fn picture<S: GetPixel<Color = Self> + OriginDimensions>(frame: &S) -> Picture;
}

macro_rules! indexed {
    ($name:ident, $index:expr, $palette:expr) => {
        impl Ink for $name {
            fn ega(index: u8) -> Self {
                Self::new($index(index))
            }

            fn picture<S: GetPixel<Color = Self> + OriginDimensions>(frame: &S) -> Picture {
                Picture::indexed(frame, &$palette)
            }
        }
    };
}

indexed!(Index1, |index| u8::from(index > GROUND), Palette::<Rgb888, 2>::greys());
indexed!(
    Index2,
    |index| [0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2, 3, 3][usize::from(index)],
    Palette::<Rgb888, 4>::greys()
);
indexed!(Index4, |index| index, EGA);
indexed!(Index8, |index: u8| index << 4, Palette::new(std::array::from_fn::<_, 256, _>(|i| EGA.colors()[i >> 4])));

macro_rules! true_color {
    ($($name:ident),*) => {
        $(
            impl Ink for $name {
                fn ega(index: u8) -> Self {
                    EGA.colors()[usize::from(index)].into()
                }

                fn picture<S: GetPixel<Color = Self> + OriginDimensions>(frame: &S) -> Picture {
                    Picture::of(frame)
                }
            }
        )*
    };
}

true_color!(Rgb565, Rgb888, Xrgb8888);

/// A star of lines in 24 directions, lines that enter from far outside, and a frame.
fn lines<C: Ink>(surface: &mut impl Surface<Color = C>) {
    surface.fill_window(C::ega(GROUND));
    let middle = Point::new(31, 31);
    for (i, color) in (-6..6).zip([YELLOW, GREEN].into_iter().cycle()) {
        for (x, y) in [(5 * i, -30), (30, 5 * i), (-5 * i, 30), (-30, -5 * i)] {
            surface.draw_line(middle + Point::new(x, y) / 3, middle + Point::new(x, y), C::ega(color));
        }
    }
    for i in -2..3 {
        // Both ends are a billion pixels away.
        let (far, through) = (Point::new(150_000_000 * i, 1_000_000_000), Point::new(80, 12));
        surface.draw_line(through - far, through + far, C::ega(RED));
    }
    for i in 0..6 {
        surface.draw_line(Point::new(64, 8 * i + 20), Point::new(94 - 4 * i, 61), C::ega(GREY));
    }
    let corners = [(63, 0), (95, 0), (95, 63), (63, 63), (63, 0)].map(Point::from);
    surface.draw_polyline(corners, C::ega(YELLOW));
}

/// A fan around a sub-pixel centre, slivers, and a triangle far larger than the screen.
fn triangles<C: Ink>(surface: &mut impl Surface<Color = C>) {
    surface.fill_window(C::ega(GROUND));
    let centre = PointFx::from_bits(31 * 256 + 77, 30 * 256 + 201);
    let rim = [(30, 2), (45, 3), (58, 14), (62, 30), (55, 47), (38, 61), (20, 58), (6, 47), (1, 28), (9, 9)]
        .map(|(x, y)| PointFx::px(x, y));
    for (i, color) in (0..rim.len()).zip([GREEN, YELLOW, RED, GREY].into_iter().cycle()) {
        surface.fill_triangle_fx([centre, rim[i], rim[(i + 1) % rim.len()]], C::ega(color));
    }
    for i in 0..8 {
        // Thinner from left to right: 3 pixels, then 3/2, ... down to 3/128.
        let (x, w) = (66 * 256 + 960 * i, 768 >> i);
        let corners = [(x, 512), (x + w, 512), (x + w + 300, 30 * 256)].map(|(x, y)| PointFx::from_bits(x, y));
        surface.fill_triangle_fx(corners, C::ega(GREEN));
    }
    let huge = [PointFx::px(66, 8_000_000), PointFx::px(80, 34), PointFx::px(8_000_000, 8_000_000)];
    surface.fill_triangle_fx(huge, C::ega(RED));
}

/// The same star by both rules, a contour with two holes, and a comb.
fn polygons<C: Ink>(surface: &mut impl Surface<Color = C>) {
    surface.fill_window(C::ega(GROUND));
    let mut table = [EdgeSlot::EMPTY; 8];
    let star =
        |x: i32| [(0, -20), (12, 17), (-19, -6), (19, -6), (-12, 17)].map(|(dx, dy)| PointFx::px(x + dx, 22 + dy));
    let stars = [(22, FillRule::EvenOdd, GREEN), (70, FillRule::NonZero, YELLOW)];
    for (x, rule, color) in stars {
        surface.fill_polygon_fx(&star(x), rule, &mut table, C::ega(color)).expect("eight edges are enough");
    }
    let block = |x0, y0, x1, y1| [(x0, y0), (x1, y0), (x1, y1), (x0, y1)].map(|(x, y)| PointFx::px(x, y));
    let mut holes = [block(4, 42, 40, 61), block(8, 45, 20, 58), block(24, 45, 36, 58)];
    holes[1..].iter_mut().for_each(|hole| hole.reverse());
    surface.fill_contours_fx(&holes, FillRule::NonZero, &mut table, C::ega(RED)).expect("eight edges are enough");
    let comb: Vec<_> =
        (0..12).map(|i| PointFx::from_bits((46 + 4 * i) * 256, (44 + 16 * (i % 2)) * 256 + 64 * i)).collect();
    let closed = comb.iter().copied().chain([PointFx::px(92, 42), PointFx::px(46, 42)]).collect::<Vec<_>>();
    surface
        .fill_polygon_fx(&closed, FillRule::EvenOdd, &mut [EdgeSlot::EMPTY; 14], C::ega(GREY))
        .expect("one slot a side");
}

/// Curves one pixel wide, filled paths, strokes with every cap and join, dashes along a curve.
fn paths<C: Ink>(surface: &mut impl Surface<Color = C>) {
    surface.fill_window(C::ega(GROUND));
    let p = |x: i32, y: i32| PointFx::from_bits(128 * x, 128 * y);
    let mut table = [EdgeSlot::EMPTY; 128];
    // A heart with a hole, in half pixels.
    let heart = [
        PathSegment::MoveTo(p(32, 52)),
        PathSegment::CubicTo(p(-12, 24), p(14, -10), p(32, 14)),
        PathSegment::CubicTo(p(50, -10), p(76, 24), p(32, 52)),
        PathSegment::Close,
        PathSegment::MoveTo(p(24, 26)),
        PathSegment::QuadraticTo(p(32, 50), p(40, 26)),
        PathSegment::Close,
    ];
    surface.fill_path_fx(Path::new(&heart), FillRule::EvenOdd, &mut table, C::ega(RED)).expect("enough slots");
    // A loop, a cusp, and a curve whose control points are a million pixels away.
    surface.draw_cubic_fx([p(64, 50), p(150, 2), p(40, 2), p(118, 50)], C::ega(YELLOW));
    surface.draw_cubic_fx([p(124, 4), p(190, 50), p(124, 50), p(188, 4)], C::ega(GREEN));
    surface.draw_quadratic_fx([p(0, 60), p(96, 20), p(191, 60)], C::ega(GREY));
    let far = 1 << 30;
    surface.draw_cubic_fx(
        [p(70, 0), PointFx::from_bits(-far, far), PointFx::from_bits(far, far), p(120, 0)],
        C::ega(GREY),
    );
    for (i, (cap, join)) in
        [(Cap::Butt, Join::Miter), (Cap::Square, Join::Bevel), (Cap::Round, Join::Round)].into_iter().enumerate()
    {
        let x = 44 * i32::try_from(i).expect("three");
        let stroke = Stroke::px(5).with_cap(cap).with_join(join);
        let zigzag = [p(x + 8, 116), p(x + 18, 76), p(x + 26, 116), p(x + 38, 90)];
        surface.stroke_polyline_fx(&zigzag, false, &stroke, &mut table, C::ega(GREEN)).expect("enough slots");
        surface
            .draw_path_fx(Path::new(&[PathSegment::MoveTo(zigzag[0]), PathSegment::LineTo(zigzag[1])]), C::ega(GROUND));
    }
    let wave = [PathSegment::MoveTo(p(134, 70)), PathSegment::CubicTo(p(220, 60), p(110, 130), p(188, 120))];
    let lengths = [6, 4].map(I24F8::from_num);
    let dashes = Stroke::px(3).with_cap(Cap::Round).dashed(&lengths, I24F8::ZERO);
    surface.stroke_path_fx(Path::new(&wave), &dashes, &mut table, C::ega(YELLOW)).expect("enough slots");
    let ring = [p(140, 100), p(156, 92), p(164, 112), p(146, 120)];
    surface.stroke_polyline_fx(&ring, true, &Stroke::px(1), &mut table, C::ega(RED)).expect("enough slots");
}

/// The text of an icon at three sizes and angles, turned ellipses, an arc that is cut off, and the same thin letter without and with
/// drop-out control.
fn svg<C: Ink>(surface: &mut impl Surface<Color = C>) {
    surface.fill_window(C::ega(GROUND));
    let mut table = [EdgeSlot::EMPTY; 64];
    let number = |n: f64| I16F16::from_num(n);
    // A clock: a ring, and two hands in one.
    let clock =
        Path::svg("M12 1a11 11 0 1 1-.01 0zm0 3a8 8 0 1 0 .01 0zM11 6h2v5.5l4 2.5-1 1.7-5-3.1z").expect("a path");
    for (size, degrees, x, y, color) in
        [(1.0, 0, 1.0, 1.0, GREEN), (1.5, 30, 38.0, -2.0, YELLOW), (0.5, -90, 2.0, 40.0, GREY)]
    {
        let map = Affine::scale(number(size), number(size))
            .then(Affine::rotate(Angle::degrees(degrees)))
            .then(Affine::translate(number(x), number(y)));
        surface.fill_path_fx(clock.mapped(map), FillRule::NonZero, &mut table, C::ega(color)).expect("enough slots");
    }
    for i in 0..4 {
        let leaf = Curves::ellipse(PointFx::px(76, 20), [px(16), px(4)], Angle::degrees(45 * i + 10));
        let color = C::ega(if i % 2 == 0 { RED } else { GREY });
        surface.fill_path_fx(leaf, FillRule::EvenOdd, &mut table, color).expect("enough slots");
    }
    let (a, b) = (PointFx::px(20, 62), PointFx::px(44, 50));
    let arc = Arc { radii: [px(16), px(9)], rotation: Angle::degrees(-20), is_large: true, is_clockwise: true };
    let moon = [PathSegment::MoveTo(a)].into_iter().chain(arc.between(a, b));
    surface.fill_path_fx(moon, FillRule::NonZero, &mut table, C::ega(YELLOW)).expect("enough slots");
    // Stems of 0.4 pixels.
    let letter = Path::svg("M0 0h.4v3.2h4v-3.2h.4v8h-.4v-4.4h-4v4.4h-.4z").expect("a path");
    for (x, drop_out) in
        [(52.6, None), (62.6, Some(DropOut::SIMPLE)), (72.6, Some(DropOut::SMART)), (82.6, Some(DropOut::SMART))]
    {
        let turn = Affine::rotate(Angle::degrees(if x > 80.0 { 30 } else { 0 }));
        let path = letter.mapped(
            Affine::scale(number(1.5), number(1.5)).then(turn).then(Affine::translate(number(x), number(45.6))),
        );
        match drop_out {
            None => surface.fill_path_fx(path, FillRule::NonZero, &mut table, C::ega(GREEN)),
            Some(rule) => surface.fill_path_drop_out_fx(path, FillRule::NonZero, rule, &mut table, C::ega(GREEN)),
        }
        .expect("enough slots");
    }
}

/// Rectangles of every width, one inside the other, at sub-pixel places and across the sides of the screen; points.
fn rectangles<C: Ink>(surface: &mut impl Surface<Color = C>) {
    surface.fill_window(C::ega(GROUND));
    for (i, color) in (0..7).zip([GREY, GROUND, GREEN, GROUND, YELLOW, GROUND, RED]) {
        surface.fill_rectangle_fx(
            PointFx::px(3 + 3 * i, 3 + 3 * i),
            PointFx::px(47 - 3 * i, 45 - 3 * i),
            C::ega(color),
        );
    }
    let mut x = 52;
    for width in 1..9 {
        surface.fill_rectangle_fx(PointFx::px(x, 3), PointFx::px(x + width, 3 + 3 * width), C::ega(GREEN));
        x += width;
    }
    for i in 0..8 {
        // Centres are at 128: from 0 to 224 the first column comes and goes.
        let (x, y) = ((52 + 5 * i) * 256 + 32 * i, 34 * 256);
        surface.fill_rectangle_fx(PointFx::from_bits(x, y), PointFx::from_bits(x + 640, y + 2560), C::ega(YELLOW));
        surface.draw_point_fx(PointFx::from_bits(x, y + 3200), C::ega(RED));
    }
    surface.fill_area(Rect::new(i32::MIN, 56, 7, i32::MAX), C::ega(RED));
    surface.fill_area(Rect::new(90, 60, i32::MAX, 99), C::ega(GREY));
}

/// Discs and outlines of every small size, thin and huge ellipses, sectors, rings, rounded rectangles, points.
fn rounds<C: Ink>(surface: &mut impl Surface<Color = C>) {
    surface.fill_window(C::ega(GROUND));
    let mut x = 1;
    for size in 1..9 {
        surface.fill_ellipse_fx(Ellipse::in_box(Rect::new(x, 1, x + size, 1 + size)), C::ega(GREEN));
        surface.draw_ellipse(Rect::new(x, 11, x + size, 11 + size), C::ega(YELLOW));
        surface.fill_round_point_fx(
            PointFx::from_bits(x * 256 + 64, 23 * 256),
            I24F8::from_bits(size * 128),
            C::ega(RED),
        );
        x += size + 1;
    }
    surface.draw_ellipse(Rect::new(1, 27, 42, 30), C::ega(YELLOW));
    surface.draw_ellipse(Rect::new(46, 1, 50, 40), C::ega(YELLOW));
    surface.fill_outlined_ellipse(Rect::new(1, 32, 42, 44), C::ega(GREY));
    surface.draw_ellipse(Rect::new(1, 32, 42, 44), C::ega(GREEN));
    // The rim of a circle of two million pixels.
    let far = Ellipse::circle(PointFx::px(1_500_000, 1_500_040), I24F8::from_bits(543_038_639));
    surface.fill_ellipse_fx(far, C::ega(RED));
    let angles = [0, 50, 110, 200, 320, 360].map(Angle::degrees);
    for (pair, color) in angles.windows(2).zip([GREEN, YELLOW, RED, GREY, GREEN]) {
        let sector = Sector::new(pair[0], pair[1]);
        let centre = PointFx::px(71, 18);
        let (outer, inner) =
            (Ellipse::circle(centre, I24F8::from_num(16)), Ellipse::circle(centre, I24F8::from_num(8)));
        surface.fill_ring_sector_fx(outer, inner, sector, C::ega(color));
        surface.fill_sector_fx(Ellipse::circle(centre, I24F8::from_num(6)), sector, C::ega(color));
        surface.draw_arc(Rect::new(54, 1, 89, 36), sector, C::ega(color));
    }
    let radii = Radii { top_left: 12, top_right: 3, bottom_right: 8, bottom_left: 0 };
    surface.fill_rounded(Rect::new(3, 47, 40, 62), radii, C::ega(GREEN));
    surface.draw_rounded(Rect::new(1, 45, 42, 64), radii, C::ega(YELLOW));
    surface.fill_square_point_fx(PointFx::from_bits(92 * 256, 3 * 256), I24F8::from_bits(900), C::ega(GREY));
}

/// Dials as people draw them: gauges with round ends and a hand, segments, arcs with caps and with dashes, rings and boxes with
/// borders of a width on each side of the edge, and lines and polygons with round corners.
fn dials<C: Ink>(surface: &mut impl Surface<Color = C>) {
    let mut table = [EdgeSlot::EMPTY; 200];
    let sector = |from, to| Sector::new(Angle::degrees(from), Angle::degrees(to));
    surface.fill_window(C::ega(GROUND));
    let (outer, inner) = (Rect::new(1, 1, 33, 33), Rect::new(6, 6, 28, 28));
    surface.fill_gauge(outer, inner, sector(135, 45), C::ega(GREY));
    surface.fill_gauge(outer, inner, sector(135, 320), C::ega(GREEN));
    surface.fill_chord(Rect::new(9, 9, 25, 25), sector(20, 160), C::ega(YELLOW));
    surface.fill_chord(Rect::new(9, 9, 25, 25), sector(200, 340), C::ega(RED));
    let hand = Stroke::px(3).with_cap(Cap::Round);
    let ends = [PointFx::px(17, 17), PointFx::from_bits(17 * 256 + 2_100, 17 * 256 - 1_700)];
    surface.stroke_line_fx(ends, &hand, &mut table, C::ega(RED)).expect("enough slots");
    for (i, (cap, color)) in (0..).zip([(Cap::Butt, GREEN), (Cap::Square, YELLOW), (Cap::Round, RED)]) {
        let (centre, radius) = (PointFx::px(47, 17), px(14 - 5 * i));
        let stroke = Stroke::px(3).with_cap(cap);
        surface
            .stroke_arc_fx(centre, [radius; 2], sector(190, 80), &stroke, &mut table, C::ega(color))
            .expect("enough slots");
    }
    let (centre, lengths) = (PointFx::px(79, 17), [4, 3].map(px));
    let dashed = Stroke::px(3).dashed(&lengths, px(0));
    surface
        .stroke_arc_fx(
            centre,
            [px(14); 2],
            Sector::sweep(Angle::degrees(0), I16F16::from_num(360)),
            &dashed,
            &mut table,
            C::ega(YELLOW),
        )
        .expect("enough slots");
    let dashed = Stroke::px(2).with_cap(Cap::Round).dashed(&lengths, px(1));
    let radii = [px(10), px(5)];
    surface.stroke_arc_fx(centre, radii, sector(30, 300), &dashed, &mut table, C::ega(GREEN)).expect("enough slots");
    surface.stroke_round_arc(Rect::new(77, 15, 82, 20), sector(45, 315), 2, Align::Inside, C::ega(RED));
    let aligns = [(Align::Inside, GREEN), (Align::Centred, YELLOW), (Align::Outside, RED)];
    for (i, (align, color)) in (0..).zip(aligns) {
        let area = Rect::new(3 + 16 * i, 38, 14 + 16 * i, 47);
        surface.stroke_rounded(area, Radii { top_right: 1, ..Radii::all(4) }, 3, align, C::ega(color));
        surface.stroke_ellipse(Rect { y0: 52, y1: 61, ..area }, 3, align, C::ega(color));
        surface.draw_rounded(area, Radii { top_right: 1, ..Radii::all(4) }, C::ega(GREY));
        surface.draw_ellipse(Rect { y0: 52, y1: 61, ..area }, C::ega(GREY));
    }
    let bell = [(53, 61), (53, 38), (66, 58), (72, 36)].map(|(x, y)| PointFx::px(x, y));
    surface
        .stroke_round_polyline_fx(&bell, false, px(5), &Stroke::px(3), &mut table, C::ega(GREEN))
        .expect("enough slots");
    let arrow = [(77, 62), (84, 50), (76, 37), (94, 50)].map(|(x, y)| PointFx::px(x, y));
    surface.fill_round_polygon_fx(&arrow, px(3), FillRule::NonZero, &mut table, C::ega(YELLOW)).expect("enough slots");
    surface.fill_outlined_rounded(Rect::new(82, 46, 90, 54), 3.into(), C::ega(RED));
    surface.draw_rounded(Rect::new(82, 46, 90, 54), 3.into(), C::ega(GROUND));
}

/// Regions flooded by colour and up to a boundary, through corners and with tables that are too short.
fn floods<C: Ink>(frame: &mut Framebuffer<'_, C>) {
    frame.clear(C::ega(GROUND));
    for i in 0..5 {
        frame.draw_ellipse(Rect::new(2 + 4 * i, 2 + 3 * i, 60 - 4 * i, 61 - 3 * i), C::ega(YELLOW));
    }
    frame.draw_line(Point::new(0, 31), Point::new(62, 35), C::ega(YELLOW));
    frame.flood_fill(Point::new(30, 5), Connectivity::Sides, &mut [FloodSlot::EMPTY], C::ega(GREEN));
    frame.flood_fill_to(
        Point::new(30, 28),
        C::ega(YELLOW),
        Connectivity::Sides,
        &mut [FloodSlot::EMPTY; 4],
        C::ega(RED),
    );
    frame.flood_fill(Point::new(0, 63), Connectivity::Sides, &mut [], C::ega(GREY));
    for i in 0..30 {
        frame.set(Point::new(64 + i, 2 + (i * 7) % 28), C::ega(YELLOW));
        frame.set(Point::new(64 + i, 33 + i % 2), C::ega(YELLOW));
    }
    frame.flood_fill(Point::new(64, 33), Connectivity::Corners, &mut [FloodSlot::EMPTY; 2], C::ega(RED));
}

/// Text of embedded-graphics, clear and on a background, across the sides of the screen too.
fn text<C: Ink>(target: &mut impl DrawTarget<Color = C, Error = Infallible>) {
    let Ok(()) = target.clear(C::ega(GROUND));
    let style = |color, background| {
        let builder = MonoTextStyleBuilder::new().font(&FONT_6X10).text_color(C::ega(color));
        match background {
            Some(background) => builder.background_color(C::ega(background)).build(),
            None => builder.build(),
        }
    };
    let Ok(_) = Text::new("0123456789abcdef", Point::new(0, 8), style(YELLOW, None)).draw(target);
    let Ok(_) = Text::new("Grumpy wizards\nmake toxic brew", Point::new(3, 20), style(GREEN, None)).draw(target);
    let Ok(_) = Text::new(" inverse ", Point::new(5, 44), style(GROUND, Some(GREY))).draw(target);
    let Ok(_) = Text::new("over the edges", Point::new(-7, 58), style(RED, None)).draw(target);
    let Ok(_) = Text::new("down", Point::new(75, 66), style(YELLOW, None)).draw(target);
}

/// A picture copied to every place within a byte, whole and with transparent pixels, clipped at all sides; a part that is
/// moved over itself, and one with transparent pixels.
fn blits<C: Ink>(frame: &mut Framebuffer<'_, C>) {
    frame.clear(C::ega(GROUND));
    frame.fill_area(Rect::new(0, 0, 96, 14), C::ega(GREY));
    frame.fill_area(Rect::new(0, 19, 96, 22), C::ega(GREY));
    let mut sprite_ram = [0; 13 * 11 * 4];
    let mut sprite = Framebuffer::<C>::new(&mut sprite_ram, 13, 11).expect("four bytes a pixel are enough");
    sprite.clear(C::ega(GROUND));
    sprite.fill_triangle_fx([PointFx::px(1, 10), PointFx::px(6, 0), PointFx::px(12, 10)], C::ega(YELLOW));
    sprite.draw_line(Point::new(0, 0), Point::new(12, 10), C::ega(GROUND));
    let sprite: Bitmap<'_, C> = sprite.as_bitmap();
    for i in 0..7 {
        frame.blit(Point::new(1 + 13 * i + i / 4, 2), &sprite.clipped(Rect::new(i, 0, 13, 11)));
        frame.blit_keyed(Point::new(1 + 13 * i + i / 2, 15), &sprite, C::ega(GROUND));
    }
    for (x, y) in [(-6, 30), (89, 30), (40, -7), (-7, 58), (88, 57)] {
        frame.blit(Point::new(x, y), &sprite);
    }
    frame.fill_area(Rect::new(12, 30, 24, 42), C::ega(RED));
    frame.draw_line(Point::new(12, 41), Point::new(23, 30), C::ega(GROUND));
    frame.move_area(Rect::new(12, 30, 24, 42), Point::new(19, 35));
    frame.move_area_keyed(Rect::new(0, 0, 40, 27), Point::new(49, 36), C::ega(GREY));
}

/// A leaf with a hole and an island in it that touches, on the left as its ears were cut, on the right refined.
fn triangulation<C: Ink>(surface: &mut impl Surface<Color = C>) {
    surface.fill_window(C::ega(GROUND));
    let leaf =
        [(4, 2), (12, 8), (24, 3), (34, 9), (45, 6), (42, 22), (45, 36), (38, 61), (26, 52), (3, 60), (9, 40), (2, 26)];
    let hole = [(10, 14), (32, 14), (36, 34), (26, 46), (14, 40), (17, 28)];
    let island = [(17, 28), (24, 20), (29, 30), (22, 38)];
    let all = [&leaf[..], &hole, &island].concat();
    let vertices: Vec<_> = all.iter().map(|&(x, y)| PointFx::px(x, y)).collect();
    let (mut nodes, mut triangles) = ([SideSlot::EMPTY; 26], [[0; 3]; 24]);
    let count = triangulate::list(&vertices, &[12, 18], &mut nodes, &mut triangles).expect("enough nodes");
    let triangles = &mut triangles[..count];
    for right in [0, 48] {
        if right > 0 {
            delaunay::refine(&vertices, triangles, &mut [[0; 3]; 24]).expect("a slot for each");
        }
        let place = |i: u16| (all[usize::from(i)].0 + right, all[usize::from(i)].1);
        for (corners, color) in triangles.iter().zip([GREEN, YELLOW, RED, GREY].into_iter().cycle()) {
            surface.fill_triangle_fx(corners.map(place).map(|(x, y)| PointFx::px(x, y)), C::ega(color));
        }
        for [a, b, c] in triangles.iter().map(|corners| corners.map(place).map(Point::from)) {
            surface.draw_polyline([a, b, c, a], C::ega(GROUND));
        }
    }
}

/// Draws every scene in framebuffers of the colour type and compares.
fn check<C: Ink>(depth: &str) {
    let mut ram = vec![0; buffer_bytes::<C>(WIDTH, HEIGHT)];
    let mut frame = Framebuffer::<C>::new(&mut ram, WIDTH, HEIGHT).expect("it has the bytes that it needs");
    let mut wrong = vec![];
    let mut compare =
        |name, frame: &Framebuffer<'_, C>| wrong.extend(compare(&format!("{name}-{depth}"), &C::picture(frame)));
    lines(&mut frame);
    compare("lines", &frame);
    triangles(&mut frame);
    compare("triangles", &frame);
    polygons(&mut frame);
    compare("polygons", &frame);
    paths(&mut frame);
    compare("paths", &frame);
    svg(&mut frame);
    compare("svg", &frame);
    rectangles(&mut frame);
    compare("rectangles", &frame);
    text(&mut frame);
    compare("text", &frame);
    blits(&mut frame);
    compare("blits", &frame);
    rounds(&mut frame);
    compare("rounds", &frame);
    dials(&mut frame);
    compare("dials", &frame);
    floods(&mut frame);
    compare("floods", &frame);
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn one_bit() {
    check::<Index1>("1");
}

#[test]
fn two_bits() {
    check::<Index2>("2");
}

#[test]
fn four_bits() {
    check::<Index4>("4");
}

#[test]
fn eight_bits() {
    check::<Index8>("8");
}

#[test]
fn sixteen_bits() {
    check::<Rgb565>("16");
}

#[test]
fn twenty_four_bits() {
    check::<Rgb888>("24");
}

#[test]
fn thirty_two_bits() {
    check::<Xrgb8888>("32");
}

/// Geometry knows no depths: one is enough.
#[test]
fn triangles_of_a_polygon() {
    let mut ram = vec![0; buffer_bytes::<Index4>(WIDTH, HEIGHT)];
    let mut frame = Framebuffer::<Index4>::new(&mut ram, WIDTH, HEIGHT).expect("it has the bytes that it needs");
    triangulation(&mut frame);
    assert_eq!(compare("triangulation-4", &Index4::picture(&frame)), None, "at four bits");
}

/// Pages hold the same pixels as rows: no pictures of their own.
#[test]
fn pages() {
    type Pages<'a> = Paged<'a, Index1>;
    type Scene = fn(&mut Pages<'_>);
    if is_blessing() {
        return;
    }
    let mut ram = vec![0; paged_bytes(WIDTH, HEIGHT)];
    let mut pages = Pages::new(&mut ram, WIDTH, HEIGHT).expect("it has the bytes that it needs");
    let scenes: [(&str, Scene); 9] = [
        ("rounds-1", |pages| rounds(pages)),
        ("dials-1", |pages| dials(pages)),
        ("lines-1", |pages| lines(pages)),
        ("triangles-1", |pages| triangles(pages)),
        ("polygons-1", |pages| polygons(pages)),
        ("paths-1", |pages| paths(pages)),
        ("svg-1", |pages| svg(pages)),
        ("rectangles-1", |pages| rectangles(pages)),
        ("text-1", |pages| text(pages)),
    ];
    for (name, draw) in scenes {
        draw(&mut pages);
        assert_eq!(compare(name, &Index1::picture(&pages)), None, "in pages");
    }
}

/// Scenes that do not read what was drawn before: what they draw in a part of a frame is what they draw in all of it.
macro_rules! drawn_only {
    () => {
        [
            ("lines", |on| lines(on)),
            ("triangles", |on| triangles(on)),
            ("polygons", |on| polygons(on)),
            ("paths", |on| paths(on)),
            ("svg", |on| svg(on)),
            ("rectangles", |on| rectangles(on)),
            ("rounds", |on| rounds(on)),
            ("dials", |on| dials(on)),
            ("text", |on| text(on)),
        ]
    };
}

/// A scene on a layout.
type On<L> = fn(&mut Frame<&mut [u8], L>);

fn open<L: Layout>(memory: &mut [u8]) -> Frame<&mut [u8], L> {
    Frame::new(memory, WIDTH, HEIGHT).expect("it has the bytes that it needs")
}

/// Every scene in one part to eight, each part in a thread: the bytes of the whole.
fn in_parts<L: Layout + Send>(scenes: [(&str, On<L>); 9]) {
    let bytes = L::bytes(WIDTH, Grid { stride: L::row_bytes(WIDTH), rows: HEIGHT.into() });
    for (name, draw) in scenes {
        let mut whole = vec![0xA5; bytes];
        draw(&mut open(&mut whole));
        for parts in 1..=8 {
            let mut memory = vec![0xA5; bytes];
            let mut rest = open::<L>(&mut memory);
            thread::scope(|scope| {
                for part in 1..parts {
                    let row = i32::from(HEIGHT * part / parts / L::PAGE * L::PAGE);
                    let (mut above, below) = rest.split_at_row(row).expect("no row shares its bytes with another part");
                    scope.spawn(move || draw(&mut above));
                    rest = below;
                }
                draw(&mut rest);
            });
            assert!(memory == whole, "{name} in {parts} parts");
        }
    }
}

#[test]
fn many_cores_draw_the_same() {
    in_parts::<Rows<Index1>>(drawn_only!());
    in_parts::<Rows<Index4>>(drawn_only!());
    in_parts::<Rows<Rgb565>>(drawn_only!());
    in_parts::<Pages<Lsb0<Index1>>>(drawn_only!());
}
