//! Any bits in any argument: no panic, no overflow, no endless loop. Tests run with every overflow check on.
//!
//! Nothing is compared here; what comes out is the business of the other tests. Windows that are painted are small, as work
//! depends on what is visible; everything else may be as large and as wrong as the types allow.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "any bits will do"
)]

use std::{convert::Infallible, hint::black_box};

use embedded_graphics_core::{
    draw_target::DrawTarget,
    geometry::{Dimensions, Point, Size},
    image::GetPixel,
    pixelcolor::{BinaryColor, Gray2, Gray8, Rgb555, Rgb565, Rgb888, RgbColor},
    primitives::Rectangle,
    Pixel,
};
use embedded_raster::{
    buffer_bytes,
    eg::{draw_on, recolored},
    geom::{
        clip, delaunay, exact,
        polygon::{contains, crossings, is_convex, orientation, twice_area},
        triangulate::{self, SideSlot},
        Viewport,
    },
    pixel::{row_bytes, Be, Lsb0, Rgb332, Xrgb8888},
    raster::{
        arc, ellipse,
        flood::{Connectivity, FloodSlot},
        line, outline, polygon, rectangle, rounded, triangle,
    },
    surface::{paged_bytes, Counter, Paged, Rows},
    Angle, Bitmap, Canvas, Cap, ClippedSpan, EdgeSlot, Ellipse, FillRule, Framebuffer, Index1, Index2, Index4, Index8,
    Join, Mat4, Palette, Patch, Path, PathSegment, PixelFormat, PointFx, Radii, Rect, Sector, Span, Steps, Stroke,
    Surface, Vec4,
};
use fixed::types::{I16F16, I24F8};
use twins::{
    arguments::{Ground, Scratch},
    input::Input,
    memory::color,
    rng::Rng,
};

/// Numbers that break arithmetic: ends of types, centres of pixels, powers of two and their neighbours.
const EXTREMES: [i32; 21] = [
    i32::MIN,
    i32::MIN + 1,
    i32::MIN + 128,
    -(1 << 24),
    -65_537,
    -257,
    -128,
    -1,
    0,
    1,
    127,
    128,
    255,
    256,
    65_535,
    65_536,
    1 << 24,
    i32::MAX - 255,
    i32::MAX - 127,
    i32::MAX - 1,
    i32::MAX,
];

fn wild(rng: &mut Rng) -> i32 {
    match rng.below(8) {
        0 => rng.bits() as i32,
        1 | 2 => rng.int(-40, 60),
        3 => rng.int(-9_000, 9_000),
        _ => rng.pick(&EXTREMES),
    }
}

fn wild_size(rng: &mut Rng) -> usize {
    match rng.below(6) {
        0 => rng.bits() as usize,
        1 => rng.pick(&[usize::MAX, usize::MAX - 1, usize::MAX / 2, 1 << 32, 1 << 31]),
        _ => rng.index(70),
    }
}

fn wild_u16(rng: &mut Rng) -> u16 {
    if rng.one_in(3) {
        rng.pick(&[65_535, 65_534, 32_768, 256, 1, 0])
    } else {
        rng.below(20) as u16
    }
}

fn wild_rect(rng: &mut Rng) -> Rect {
    Rect::new(wild(rng), wild(rng), wild(rng), wild(rng))
}

fn wild_point(rng: &mut Rng) -> Point {
    Point::new(wild(rng), wild(rng))
}

fn wild_vertex(rng: &mut Rng) -> PointFx {
    PointFx::from_bits(wild(rng), wild(rng))
}

fn wild_rectangle(rng: &mut Rng) -> Rectangle {
    let size = Size::new(wild(rng) as u32, wild(rng) as u32);
    Rectangle::new(wild_point(rng), size)
}

/// A window of at most 16 x 16, anywhere, sometimes inside out.
fn small_window(rng: &mut Rng) -> Rect {
    let (x, y) = (wild(rng), wild(rng));
    Rect::new(x, y, x.saturating_add(rng.int(-1, 16)), y.saturating_add(rng.int(-1, 16)))
}

fn look(span: ClippedSpan) {
    black_box((span.y(), span.x0(), span.x1(), span.len()));
}

fn look_at_steps(mut steps: Steps) {
    black_box((steps.first(), steps.last(), steps.len(), steps.is_steep(), steps.goes_right(), steps.next_is_minor()));
    // Not all of a line from end to end.
    if steps.len() < 100 {
        steps.spans(look);
    }
}

#[test]
fn rectangles_and_spans() {
    let mut others = Rng::new(110);
    for x0 in EXTREMES {
        for y0 in EXTREMES {
            for x1 in EXTREMES {
                for y1 in EXTREMES {
                    let (a, b) = (Rect::new(x0, y0, x1, y1), wild_rect(&mut others));
                    black_box((a.is_empty(), a.contains(x1, y0), a.intersection(b), a.relative_to(b.x0, b.y0)));
                    black_box((a.width(), a.height(), Rectangle::from(a), a.union(b)));
                    black_box((a.inset(b.x0), a.translate(b.x0, b.y0)));
                    let eg = Rectangle::new(Point::new(x0, y0), Size::new(x1 as u32, y1 as u32));
                    black_box((Rect::from(eg), Rect::from_center(eg.top_left, eg.size)));
                    if let Some(span) = (Span { y: y0, x0, x1 }).clip(b) {
                        look(span);
                    }
                    let (v, w) = (PointFx::from_bits(x0, y0), PointFx::from_bits(x1, y1));
                    black_box((rectangle::pixels(v, w), v.pixel(), PointFx::px(x0, y0)));
                    black_box((PointFx::from(Point::new(x1, y1)), v + w, v - w, -v, v * w.x));
                    let (p, q) = (Angle::from_bits(x0 as u32), Angle::from_bits(y0 as u32));
                    black_box((p + q, p - q, -p, p * y0, p.to_degrees(), Angle::degrees_fx(I16F16::from_bits(x0))));
                }
            }
        }
    }
}

#[test]
fn lines() {
    let mut rng = Rng::new(111);
    for x0 in EXTREMES {
        for y0 in EXTREMES {
            for x1 in EXTREMES {
                for y1 in EXTREMES {
                    for window in [small_window(&mut rng), wild_rect(&mut rng)] {
                        if let Some(steps) = line::clip(Point::new(x0, y0), Point::new(x1, y1), window) {
                            look_at_steps(steps);
                        }
                    }
                }
            }
        }
    }
    let everything = Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX);
    for _ in 0..300_000 {
        for window in [small_window(&mut rng), wild_rect(&mut rng), everything] {
            if let Some(steps) = line::clip(wild_point(&mut rng), wild_point(&mut rng), window) {
                look_at_steps(steps);
            }
        }
    }
}

#[test]
fn triangles() {
    let mut rng = Rng::new(112);
    for _ in 0..400_000 {
        let corners = [wild_vertex(&mut rng), wild_vertex(&mut rng), wild_vertex(&mut rng)];
        let window = small_window(&mut rng);
        triangle::fill(corners, window, look);
        triangle::walk(corners, window, look);
    }
    // Any window: for triangles of less than a row it cannot matter how large it is.
    for _ in 0..100_000 {
        let (a, y) = (wild(&mut rng), wild(&mut rng));
        let corners =
            [(); 3].map(|()| PointFx::from_bits(a.saturating_add(rng.int(0, 900)), y.saturating_add(rng.int(0, 600))));
        let window = wild_rect(&mut rng);
        triangle::fill(corners, window, look);
        triangle::walk(corners, window, look);
    }
}

fn wild_ellipse(rng: &mut Rng) -> Ellipse {
    let length = |rng: &mut Rng| I24F8::from_bits(wild(rng));
    match rng.below(4) {
        0 => Ellipse::in_box(wild_rect(rng)),
        1 => Ellipse::new(wild_vertex(rng), length(rng), length(rng)),
        2 => Ellipse::circle(wild_vertex(rng), length(rng)),
        _ => Ellipse::splat(wild_vertex(rng), length(rng)),
    }
}

fn wild_radii(rng: &mut Rng) -> Radii {
    let mut radius = || wild(rng) as u32;
    Radii { top_left: radius(), top_right: radius(), bottom_right: radius(), bottom_left: radius() }
}

fn wild_sector(rng: &mut Rng) -> Sector {
    let mut angle = || match rng.below(3) {
        0 => Angle::degrees(wild(rng)),
        1 => Angle::turns(wild(rng) as u32, wild_u16(rng)),
        _ => Angle::from_bits(wild(rng) as u32).plus(wild(rng)),
    };
    Sector::new(angle(), angle())
}

#[test]
fn round_shapes() {
    let mut rng = Rng::new(115);
    for _ in 0..200_000 {
        let (window, area) = (small_window(&mut rng), wild_rect(&mut rng));
        let (outer, inner) = (wild_ellipse(&mut rng), wild_ellipse(&mut rng));
        let (sector, radii) = (wild_sector(&mut rng), wild_radii(&mut rng));
        ellipse::fill(outer, window, look);
        ellipse::outline(area, window, look);
        ellipse::enclosed(area, window, look);
        rounded::fill(area, radii, window, look);
        rounded::outline(area, radii, window, look);
        arc::outline(area, sector, window, look);
        arc::fill(outer, sector, window, look);
        arc::ring_sector(outer, inner, sector, window, look);
        black_box(ellipse::square(wild_vertex(&mut rng), I24F8::from_bits(wild(&mut rng))));
        black_box(sector.contains(wild(&mut rng).into(), wild(&mut rng).into()));
    }
}

/// All of the plane at once, where little of it is seen: one row, one column.
#[test]
fn round_shapes_in_windows_without_end() {
    let mut rng = Rng::new(116);
    for _ in 0..300 {
        let (x, y) = (wild(&mut rng), wild(&mut rng));
        let near = |n: i32, rng: &mut Rng| n.saturating_add(rng.int(0, 300));
        let area = Rect::new(x, y, near(x, &mut rng), near(y, &mut rng));
        let everything = Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX);
        ellipse::fill(Ellipse::in_box(area), everything, look);
        ellipse::outline(area, everything, look);
        rounded::fill(area, wild_radii(&mut rng), everything, look);
        rounded::outline(area, wild_radii(&mut rng), everything, look);
    }
}

#[test]
fn polygons() {
    let mut rng = Rng::new(113);
    for _ in 0..150_000 {
        let outline: Vec<PointFx> = (0..rng.index(12)).map(|_| wild_vertex(&mut rng)).collect();
        let (first, second) = outline.split_at(rng.index(outline.len() + 1));
        let mut table = vec![EdgeSlot::EMPTY; rng.index(14)];
        let rule = rng.pick(&[FillRule::NonZero, FillRule::EvenOdd]);
        let window = small_window(&mut rng);
        if let Err(error) = polygon::fill([first, second], rule, &mut table, window, look) {
            black_box(format!("{error} {error:?}"));
        }
    }
}

fn wild_path(rng: &mut Rng) -> Vec<PathSegment> {
    let mut v = || wild_vertex(rng);
    let all = [
        PathSegment::MoveTo(v()),
        PathSegment::LineTo(v()),
        PathSegment::QuadraticTo(v(), v()),
        PathSegment::CubicTo(v(), v(), v()),
        PathSegment::Close,
    ];
    (0..rng.index(6)).map(|_| rng.pick(&all)).collect()
}

fn wild_stroke(rng: &mut Rng) -> Stroke {
    Stroke::new(I24F8::from_bits(wild(rng)))
        .with_cap(rng.pick(&[Cap::Butt, Cap::Square, Cap::Round]))
        .with_join(rng.pick(&[Join::Miter, Join::Bevel, Join::Round]))
        .with_miter_limit(I24F8::from_bits(wild(rng)))
}

#[test]
fn paths_and_strokes() {
    let mut rng = Rng::new(115);
    for i in 0..20_000 {
        let segments = wild_path(&mut rng);
        let (path, window) = (Path::new(&segments), small_window(&mut rng));
        let mut table = vec![EdgeSlot::EMPTY; rng.index(40)];
        let rule = rng.pick(&[FillRule::NonZero, FillRule::EvenOdd]);
        black_box(polygon::fill(path.contours_in(window), rule, &mut table, window, look).is_ok());
        outline::draw(path, window, look);
        black_box(path.outlines::<50, 2>().map_err(|e| e.to_string()).is_ok());
        let stroke = wild_stroke(&mut rng);
        black_box(polygon::fill(stroke.of_path(path, window), rule, &mut table, window, look).is_ok());
        // Dashes measure the whole way: not often.
        if i % 100 == 0 {
            let lengths: Vec<I24F8> = (0..rng.index(5)).map(|_| I24F8::from_bits(wild(&mut rng))).collect();
            let dashed = stroke.dashed(&lengths, I24F8::from_bits(wild(&mut rng)));
            black_box(polygon::fill(dashed.of_path(path, window), rule, &mut table, window, look).is_ok());
        }
    }
}

/// The number that a table is too small by, and every row, when the window is as high as the type.
#[test]
fn polygons_without_a_window() {
    let mut rng = Rng::new(114);
    let everything = Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX);
    for _ in 0..20_000 {
        let (x, y) = (wild(&mut rng), wild(&mut rng));
        let near = |n: i32, rng: &mut Rng| n.saturating_add(rng.int(-2_000, 2_000));
        let outline: Vec<PointFx> = (0..9).map(|_| PointFx::from_bits(near(x, &mut rng), near(y, &mut rng))).collect();
        let mut table = vec![EdgeSlot::EMPTY; rng.index(10)];
        black_box(polygon::fill([&outline], FillRule::EvenOdd, &mut table, everything, look).is_ok());
    }
    // Rows without end, and no slot at all.
    let huge = [(i32::MIN, i32::MIN), (i32::MAX, 0), (0, i32::MAX)].map(|(x, y)| PointFx::from_bits(x, y));
    assert!(polygon::fill([&huge], FillRule::EvenOdd, &mut [], everything, look).is_err(), "no slots");
}

#[test]
fn polygon_tools() {
    let mut rng = Rng::new(115);
    for _ in 0..100_000 {
        let outline: Vec<PointFx> = (0..rng.index(9)).map(|_| wild_vertex(&mut rng)).collect();
        black_box((is_convex(&outline), twice_area(&outline), orientation(&outline)));
        black_box(contains([&outline], FillRule::NonZero, wild_vertex(&mut rng)));
        black_box(crossings::<_, 4>([&outline], I24F8::from_bits(wild(&mut rng))).map_err(|e| e.to_string()).is_ok());
        let [a, b, c, d] = [(); 4].map(|()| wild_vertex(&mut rng));
        black_box((exact::turn(a, b, c), exact::in_circle(a, b, c, d), clip::segment(a, b, [c, d])));
        let [low, high, at] = [(); 3].map(|()| [wild(&mut rng), wild(&mut rng)]);
        let view = Viewport::from_bits(low, high, wild_rect(&mut rng)).with_y_up();
        black_box((view.bits_to_screen(at), view.to_plane_bits(a), view.to_plane(b)));
    }
}

/// Contours in any pieces, tables of any size, and triangles that are none.
#[test]
fn triangulations() {
    let mut rng = Rng::new(116);
    for _ in 0..60_000 {
        let coarse = rng.one_in(2);
        let place = |rng: &mut Rng| if coarse { PointFx::px(rng.int(0, 3), rng.int(0, 3)) } else { wild_vertex(rng) };
        let vertices: Vec<PointFx> = (0..rng.index(12)).map(|_| place(&mut rng)).collect();
        let starts: Vec<u16> =
            (0..rng.index(4)).map(|_| if rng.one_in(9) { wild_u16(&mut rng) } else { rng.below(13) as u16 }).collect();
        let mut nodes = vec![SideSlot::EMPTY; rng.index(60)];
        let mut triangles = vec![[0; 3]; rng.index(40)];
        black_box(triangulate::to_vec::<9>(&vertices, &starts, &mut nodes).is_ok());
        match triangulate::list(&vertices, &starts, &mut nodes, &mut triangles) {
            Ok(count) => triangles.truncate(count),
            Err(error) => {
                black_box(format!("{error} {error:?}"));
                // What is no triangulation is refined, too.
                triangles.fill_with(|| [(); 3].map(|()| rng.below(14) as u16));
            }
        }
        let mut neighbours = vec![[0; 3]; rng.index(50)];
        black_box(delaunay::refine(&vertices, &mut triangles, &mut neighbours).is_ok());
    }
}

/// Everything that a framebuffer of a format can be asked to do.
fn framebuffer<F: PixelFormat>(seed: u64) {
    let mut rng = Rng::new(seed);
    for _ in 0..12_000 {
        let (width, height) = (rng.below(17) as u16, rng.below(17) as u16);
        let mut memory = vec![0; buffer_bytes::<F>(width, height) + rng.index(9)];
        let (mut other, color) = (memory.clone(), color::<F>(&mut rng));
        let mut frame = Framebuffer::<F>::new(&mut memory, width, height).expect("it is large enough");
        let mut source = Framebuffer::<F>::new(&mut other, width, height).expect("it is large enough");
        let source = source.view(wild_rect(&mut rng));
        let mut view = frame.view(wild_rect(&mut rng));
        let mut view = view.clipped(wild_rect(&mut rng));
        let mut view = if rng.one_in(2) { view.view(wild_rect(&mut rng)) } else { view };
        shapes(&mut view, &mut rng, color);
        reads(&view, &mut rng);
        copies(&mut view, &source.as_bitmap(), &mut rng, color);
        embedded_graphics(&mut view, &mut rng, color);
        // Spans and steps that were clipped against the window of something else.
        let larger = Rect::new(-50, -50, 300, 300);
        if let Some(span) =
            (Span { y: wild(&mut rng), x0: wild(&mut rng), x1: wild(&mut rng) }).clip(wild_rect(&mut rng))
        {
            view.fill_span(span, color);
        }
        if let Some(steps) = line::clip(wild_point(&mut rng), wild_point(&mut rng), larger) {
            view.fill_steps(steps, color);
        }
    }
    constructors::<F>(&mut rng);
}

fn shapes<S: Surface>(surface: &mut S, rng: &mut Rng, color: S::Color) {
    surface.fill_window(color);
    surface.fill_area(wild_rect(rng), color);
    surface.draw_point_fx(wild_vertex(rng), color);
    surface.draw_line(wild_point(rng), wild_point(rng), color);
    surface.draw_polygon((0..4).map(|_| wild_point(rng)).collect::<Vec<_>>(), color);
    surface.draw_rectangle(wild_rect(rng), color);
    surface.draw_polyline((0..4).map(|_| wild_point(rng)).collect::<Vec<_>>(), color);
    surface.fill_rectangle_fx(wild_vertex(rng), wild_vertex(rng), color);
    surface.fill_triangle_fx([wild_vertex(rng), wild_vertex(rng), wild_vertex(rng)], color);
    surface.fill_ellipse_fx(wild_ellipse(rng), color);
    surface.draw_ellipse(wild_rect(rng), color);
    surface.fill_outlined_ellipse(wild_rect(rng), color);
    surface.fill_round_point_fx(wild_vertex(rng), I24F8::from_bits(wild(rng)), color);
    surface.fill_square_point_fx(wild_vertex(rng), I24F8::from_bits(wild(rng)), color);
    surface.fill_rounded(wild_rect(rng), wild_radii(rng), color);
    surface.draw_rounded(wild_rect(rng), wild_radii(rng), color);
    surface.draw_arc(wild_rect(rng), wild_sector(rng), color);
    surface.fill_sector_fx(wild_ellipse(rng), wild_sector(rng), color);
    surface.fill_ring_fx(wild_ellipse(rng), wild_ellipse(rng), color);
    surface.fill_ring_sector_fx(wild_ellipse(rng), wild_ellipse(rng), wild_sector(rng), color);
    let outline: Vec<PointFx> = (0..rng.index(9)).map(|_| wild_vertex(rng)).collect();
    let mut table = vec![EdgeSlot::EMPTY; rng.index(9)];
    black_box(surface.fill_polygon_fx(&outline, FillRule::NonZero, &mut table, color).is_ok());
    black_box(surface.fill_contours_fx([&outline, &outline], FillRule::EvenOdd, &mut table, color).is_ok());
    if rng.one_in(40) {
        let segments = wild_path(rng);
        black_box(surface.fill_path_fx(Path::new(&segments), FillRule::NonZero, &mut table, color).is_ok());
        surface.draw_path_fx(Path::new(&segments), color);
    }
}

fn reads<F: PixelFormat>(frame: &Framebuffer<'_, F>, rng: &mut Rng) {
    black_box((frame.window(), frame.size(), frame.stride()));
    black_box(frame.get(wild_point(rng)).is_some());
    let area = wild_rect(rng);
    black_box(frame.bytes(area).map(<[u8]>::len).sum::<usize>());
    black_box(frame.colors(area).count());
    black_box(frame.row_bytes(wild_u16(rng)..wild_u16(rng)).len());
    let bitmap = frame.as_bitmap().clipped(wild_rect(rng));
    black_box((bitmap.window(), bitmap.size(), bitmap.get(wild_point(rng)).is_some()));
    black_box(bitmap.bytes(wild_rect(rng)).count());
}

fn copies<F: PixelFormat>(frame: &mut Framebuffer<'_, F>, source: &Bitmap<'_, F>, rng: &mut Rng, key: F::Color) {
    let part = source.clipped(wild_rect(rng));
    for source in [source, &part] {
        frame.blit(wild_point(rng), source);
        frame.blit_keyed(wild_point(rng), source, key);
    }
    let bytes: [u8; 27] = std::array::from_fn(|_| rng.bits() as u8);
    if let Ok(mask) = Bitmap::<Index1>::with_stride(&bytes, 20, 9, 3) {
        let off = rng.one_in(2).then_some(key);
        frame.blit_mask(wild_point(rng), &mask.clipped(wild_rect(rng)), key, off);
    }
    frame.move_area(wild_rect(rng), wild_point(rng));
    frame.move_area_keyed(wild_rect(rng), wild_point(rng), key);
    frame.set(wild_point(rng), key);
    let mut table = vec![FloodSlot::EMPTY; rng.index(4)];
    frame.flood_fill(Point::new(rng.int(-1, 17), rng.int(-1, 17)), Connectivity::Corners, &mut table, key);
    frame.flood_fill_to(wild_point(rng), key, Connectivity::Sides, &mut table, key);
    frame.clear(key);
}

fn embedded_graphics<D>(target: &mut D, rng: &mut Rng, color: <D as DrawTarget>::Color)
where
    D: DrawTarget<Error = Infallible> + GetPixel<Color = <D as DrawTarget>::Color>,
{
    let pixels = [wild_point(rng), wild_point(rng)].map(|p| Pixel(p, color));
    let Ok(()) = target.draw_iter(pixels);
    let Ok(()) = target.fill_solid(&wild_rectangle(rng), color);
    let Ok(()) = target.fill_contiguous(&wild_rectangle(rng), core::iter::repeat(color));
    let Ok(()) = target.fill_contiguous(&wild_rectangle(rng), core::iter::repeat_n(color, rng.index(300)));
    let Ok(()) = target.clear(color);
    black_box(target.pixel(wild_point(rng)).is_some());
    // Through the crate's own adapters, there and back. Not often: a view may claim to be 65,535 rows high, and draws all.
    if rng.one_in(20) {
        let Ok(()) = draw_on(target, |surface| shapes(surface, rng, color));
    }
    let mut recolored = recolored(target, |_: BinaryColor| color);
    black_box(recolored.bounding_box());
    let Ok(()) = recolored.fill_solid(&wild_rectangle(rng), BinaryColor::On);
    let Ok(()) = recolored.fill_contiguous(&wild_rectangle(rng), core::iter::repeat_n(BinaryColor::On, 99));
    let Ok(()) = recolored.draw_iter([Pixel(wild_point(rng), BinaryColor::Off)]);
    let Ok(()) = recolored.clear(BinaryColor::Off);
}

fn constructors<F: PixelFormat>(rng: &mut Rng) {
    let mut memory = vec![0; 600];
    for _ in 0..5_000 {
        let (width, height) = (wild_u16(rng), wild_u16(rng));
        black_box((row_bytes::<F>(width), buffer_bytes::<F>(width, height), paged_bytes(width, height)));
        let length = rng.index(601);
        let (memory, stride) = (&mut memory[..length], wild_size(rng));
        black_box(Bitmap::<F>::new(memory, width, height).is_ok());
        let bitmap = Bitmap::<F>::with_stride(memory, width, height, stride);
        let Ok(bitmap) = bitmap else {
            black_box(bitmap.map_err(|e| e.to_string()).is_ok());
            continue;
        };
        black_box(bitmap.bytes(wild_rect(rng)).map(<[u8]>::len).sum::<usize>());
        black_box(bitmap.get(wild_point(rng)).is_some());
        // A stride without end is fine as long as there is one row, or none.
        let mut other = memory.to_vec();
        let mut frame = Framebuffer::<F>::with_stride(&mut other, width, height, stride).expect("like the bitmap");
        let color = color::<F>(rng);
        if width < 100 && height < 100 {
            shapes(&mut frame, rng, color);
            copies(&mut frame, &bitmap, rng, color);
        }
        reads(&frame, rng);
        black_box(Framebuffer::<F>::band(memory, width, height, wild_u16(rng)..wild_u16(rng)).is_ok());
    }
}

#[test]
fn framebuffers_of_bits() {
    framebuffer::<Index1>(120);
    framebuffer::<Lsb0<Index2>>(121);
    framebuffer::<Index4>(122);
}

#[test]
fn framebuffers_of_bytes() {
    framebuffer::<Gray8>(123);
    framebuffer::<Rgb565>(124);
    framebuffer::<Be<Rgb555>>(125);
}

#[test]
fn framebuffers_of_words() {
    framebuffer::<Be<Rgb888>>(126);
    framebuffer::<Xrgb8888>(127);
}

#[test]
fn bands() {
    let mut rng = Rng::new(128);
    let mut memory = vec![0; 65_535 * 3];
    for _ in 0..400 {
        let (width, height, start) = (wild_u16(&mut rng), wild_u16(&mut rng), wild_u16(&mut rng));
        let rows = start..start.saturating_add(rng.below(4) as u16);
        let Ok(mut band) = Framebuffer::<Gray8>::band(&mut memory, width, height, rows) else { continue };
        shapes(&mut band, &mut rng, Gray8::new(3));
        reads(&band, &mut rng);
        let mut view = band.view(wild_rect(&mut rng));
        shapes(&mut view, &mut rng, Gray8::new(4));
    }
}

#[test]
fn pages() {
    let mut rng = Rng::new(129);
    for _ in 0..10_000 {
        let (width, height) = (rng.below(20) as u16, rng.below(33) as u16);
        let mut memory = vec![0; paged_bytes(width, height) + rng.index(5)];
        let mut oled = Paged::<BinaryColor>::new(&mut memory, width, height).expect("it is large enough");
        let mut oled = oled.clipped(wild_rect(&mut rng));
        shapes(&mut oled, &mut rng, BinaryColor::On);
        embedded_graphics(&mut oled, &mut rng, BinaryColor::On);
        oled.set(wild_point(&mut rng), BinaryColor::On);
        oled.clear(BinaryColor::Off);
        black_box((
            oled.size(),
            oled.get(wild_point(&mut rng)),
            oled.page_bytes(wild_u16(&mut rng)..wild_u16(&mut rng)),
        ));
        if let Some(span) =
            (Span { y: wild(&mut rng), x0: wild(&mut rng), x1: wild(&mut rng) }).clip(wild_rect(&mut rng))
        {
            oled.fill_span(span, BinaryColor::On);
        }
        let length = rng.index(memory.len() + 1);
        black_box(Paged::<Index1>::new(&mut memory[..length], wild_u16(&mut rng), wild_u16(&mut rng)).is_ok());
    }
}

#[test]
fn counters() {
    let mut rng = Rng::new(130);
    for _ in 0..20_000 {
        let mut counter = Counter::<Rgb565>::new(small_window(&mut rng));
        shapes(&mut counter, &mut rng, Rgb565::RED);
        black_box((counter.pixels, counter.spans));
    }
    // One row as long as rows get.
    let mut counter = Counter::<Rgb565>::new(Rect::new(i32::MIN, 5, i32::MAX, 6));
    counter.fill_window(Rgb565::RED);
    counter.draw_line(Point::new(i32::MIN, 5), Point::new(i32::MIN + 1000, 5), Rgb565::RED);
    assert_eq!(counter.pixels, u64::from(u32::MAX) + 1001);
}

#[test]
fn palettes_and_colours() {
    let mut rng = Rng::new(131);
    for _ in 0..20_000 {
        let mut palette = Palette::new([(); 16].map(|()| color::<Rgb888>(&mut rng)));
        palette.rotate(wild_size(&mut rng)..wild_size(&mut rng), wild_size(&mut rng));
        black_box((palette.get(rng.bits() as u8), palette.set(rng.bits() as u8, Rgb888::RED)));
        black_box(palette.nearest(color::<Rgb888>(&mut rng)));
        let (indices, mut out) = (vec![rng.bits() as u8; rng.index(20)], vec![0; rng.index(90)]);
        palette.expand::<Index1, Rgb888>(&indices, &mut out);
        palette.expand::<Lsb0<Index2>, Be<Rgb888>>(&indices, &mut out);
        palette.expand::<Index4, Rgb888>(&indices, &mut out);
        palette.expand::<Index8, Rgb888>(&indices, &mut out);
        palette.map(Rgb565::from).expand::<Index8, Rgb565>(&indices, &mut out);
        palette.map(Rgb332::from).expand::<Gray8, Rgb332>(&indices, &mut out);
        palette.map(Gray2::from).expand::<Index8, Gray2>(&indices, &mut out);
        palette.map(Gray2::from).expand::<Index2, Lsb0<Gray2>>(&indices, &mut out);
        palette.map(Xrgb8888::from).expand::<Index4, Xrgb8888>(&indices, &mut out);
    }
}

#[test]
fn what_computes_in_space() {
    let mut rng = Rng::new(890);
    for _ in 0..twins::rng::cases(3_000) {
        let mut number = || I16F16::from_bits(wild(&mut rng));
        let mut place = || Vec4::new(number(), number(), number(), number());
        let arguments = calls::space::Arguments {
            numbers: [(); 6].map(|()| place().x),
            vectors: [(); 3].map(|()| place().xyz()),
            places: [(); 2].map(|()| place()),
            matrices: [(); 2].map(|()| Mat4 { rows: [(); 4].map(|()| place()) }),
            angle: Angle::from_bits(number().to_bits() as u32),
            patch: Patch {
                points: [(); 4].map(|()| [(); 4].map(|()| Vec4::new(number(), number(), number(), number()).xyz())),
            },
            levels: [(); 4].map(|()| if rng.one_in(400) { 255 } else { rng.below(9) as u8 }),
            parts: [(); 2].map(|()| [rng.below(70) as u8, rng.bits() as u8]),
            index: rng.bits() as u16,
        };
        for k in 0..=calls::space::NAMES.len() {
            black_box(calls::space::call(&arguments, k));
        }
    }
}

#[test]
fn values_over_triangles() {
    let (mut rng, mut scratch) = (Rng::new(891), Scratch::new(891));
    for _ in 0..twins::rng::cases(10_000) {
        let bytes: Vec<u8> = (0..150).flat_map(|_| rng.bits().to_le_bytes()).collect();
        let (width, height) = (rng.below(9) as u16, rng.below(9) as u16);
        let texels = Bitmap::<Rgb565>::new(&bytes, width, height).expect("enough bytes");
        for number in 0..=calls::shading::NAMES.len() {
            let mut arguments =
                scratch.arguments::<Rows<Index1>>(&mut Input(&bytes), Ground::Wild, [Index1::new(0); 2]);
            black_box(calls::shading::call(&texels, &mut arguments, number));
        }
    }
}
