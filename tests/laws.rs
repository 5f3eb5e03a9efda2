//! The laws that every pixel format and every surface keeps, each against a twin that writes single bits.
//!
//! A new format is one more line in [`formats`].

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "coordinates of small windows, made to fit"
)]

mod support;

use embedded_graphics_core::{
    draw_target::DrawTarget,
    geometry::{Point, Size},
    image::GetPixel,
    pixelcolor::{
        Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666, Rgb888, RgbColor,
    },
    primitives::Rectangle,
    Pixel,
};
use embedded_raster::{
    buffer_bytes,
    pixel::{row_bytes, Be, Lsb0, Rgb332, Xrgb8888},
    surface::{paged_bytes, Counter, Paged},
    Bitmap, Canvas, Edge, Error, FillRule, Framebuffer, Index1, Index2, Index4, Index8, PixelFormat, Rect, Span,
    Surface,
};
use support::{
    corners,
    memory::{color, Naive},
    rng::Rng,
    scenes::{ends_of_line, outline, Scale},
    twins, vertices, Units,
};

/// Every law of storage for every format; those of drawing for one format of each way to store pixels (marked `shapes`),
/// as shapes see nothing else of a format.
macro_rules! formats {
    ($($name:ident: $format:ty $(, $shapes:ident)?;)*) => {$(
        mod $name {
            use super::*;

            #[test]
            fn spans() {
                every_run_is_its_pixels::<$format>();
                long_runs_are_their_pixels::<$format>();
                what_is_set_is_got::<$format>();
                areas_are_their_pixels::<$format>();
                constructors_check::<$format>();
            }

            #[test]
            fn rows_read_out() {
                rows_read_out_are_their_pixels::<$format>();
            }

            #[test]
            fn blits() {
                blits_are_their_pixels::<$format>();
            }

            #[test]
            fn moves() {
                moves_are_their_pixels::<$format>();
            }

            $(
                #[test]
                fn $shapes() {
                    views_and_clips_are_windows::<$format>();
                    bands_are_the_whole::<$format>();
                    shapes_are_their_pixels::<$format>();
                    embedded_graphics_draws_pixels::<$format>();
                }
            )?
        }
    )*};
}

formats! {
    index1: Index1, shapes;
    index1_lsb0: Lsb0<Index1>, shapes;
    binary: BinaryColor;
    binary_lsb0: Lsb0<BinaryColor>;
    index2: Index2, shapes;
    index2_lsb0: Lsb0<Index2>, shapes;
    gray2: Gray2;
    gray2_lsb0: Lsb0<Gray2>;
    index4: Index4, shapes;
    index4_lsb0: Lsb0<Index4>, shapes;
    gray4: Gray4;
    gray4_lsb0: Lsb0<Gray4>;
    index8: Index8, shapes;
    gray8: Gray8;
    rgb332: Rgb332;
    rgb555: Rgb555;
    bgr555: Bgr555;
    rgb565: Rgb565, shapes;
    bgr565: Bgr565;
    rgb555_be: Be<Rgb555>;
    bgr555_be: Be<Bgr555>;
    rgb565_be: Be<Rgb565>, shapes;
    bgr565_be: Be<Bgr565>;
    rgb666: Rgb666;
    bgr666: Bgr666;
    rgb888: Rgb888, shapes;
    bgr888: Bgr888;
    rgb666_be: Be<Rgb666>;
    bgr666_be: Be<Bgr666>;
    rgb888_be: Be<Rgb888>;
    bgr888_be: Be<Bgr888>;
    xrgb8888: Xrgb8888, shapes;
    xrgb8888_be: Be<Xrgb8888>;
}

/// Is it the same colour? (Colours need not be printable.)
fn same<F: PixelFormat>(a: Option<F::Color>, b: Option<F::Color>) -> bool {
    a == b
}

/// Every `start..end` of a row, at every alignment of the memory, with even and odd strides.
fn every_run_is_its_pixels<F: PixelFormat>() {
    let mut rng = Rng::new(50);
    let width = 27;
    for start in 0..8 {
        for gap in [0, 1, 2, 5] {
            let before = Naive::<F>::random(&mut rng, (width, 3), start, gap);
            let color = color::<F>(&mut rng);
            for x0 in 0..i32::from(width) {
                for x1 in x0 + 1..=i32::from(width) {
                    let (mut twin, mut real) = (before.clone(), before.bytes.clone());
                    let y = rng.int(0, 2);
                    twin.fill(Rect::new(x0, y, x1, y + 1), color);
                    let mut frame = before.frame(&mut real);
                    let span = Span { y, x0, x1 }.clip(frame.window()).expect("not empty");
                    frame.fill_span(span, color);
                    let colors = frame.colors(Rect::new(x0, y, x1, y + 1)).all(|c| c == color);
                    assert!(colors, "{} reads back {x0}..{x1}", std::any::type_name::<F>());
                    twin.assert_same(&real, || format!("span {x0}..{x1} of row {y}"));
                }
            }
        }
    }
}

/// Runs long enough for words, blocks of words, and whatever else makes long runs fast.
fn long_runs_are_their_pixels<F: PixelFormat>() {
    let mut rng = Rng::new(51);
    for _ in 0..300 {
        let (start, gap) = (rng.index(8), rng.pick(&[0, 0, 1, 3, 4]));
        let width = rng.pick(&[64, 127, 300, 521]);
        let before = Naive::<F>::random(&mut rng, (width, 2), start, gap);
        let color = color::<F>(&mut rng);
        let (mut twin, mut real) = (before.clone(), before.bytes.clone());
        let (x0, x1) = (rng.int(0, 70), rng.int(30, width.into()));
        let area = Rect::new(x0, rng.int(0, 1), x1, 2);
        twin.fill(area, color);
        before.frame(&mut real).fill_area(area, color);
        twin.assert_same(&real, || format!("{area:?}"));
    }
}

fn what_is_set_is_got<F: PixelFormat>() {
    let mut rng = Rng::new(52);
    for _ in 0..60 {
        let size = (rng.int(0, 20) as u16, rng.int(0, 5) as u16);
        let (start, gap) = (rng.index(8), rng.index(4));
        let mut twin = Naive::<F>::random(&mut rng, size, start, gap);
        let mut real = twin.bytes.clone();
        for _ in 0..40 {
            let (x, y, color) = (rng.int(-2, 21), rng.int(-2, 6), color::<F>(&mut rng));
            let mut frame = twin.frame(&mut real);
            frame.set(Point::new(x, y), color);
            let got = frame.get(Point::new(x, y));
            assert_eq!(frame.window(), twin.window(), "the window of a framebuffer is its screen");
            assert_eq!(frame.size(), Size::new(size.0.into(), size.1.into()), "size");
            assert_eq!(frame.stride(), twin.stride, "stride");
            twin.set(x, y, color);
            assert!(same::<F>(got, twin.get(x, y)), "{} at ({x}, {y})", std::any::type_name::<F>());
            twin.assert_same(&real, || format!("({x}, {y})"));
        }
    }
}

/// Any rectangle, inside or outside, inside out, without an end.
fn random_area(rng: &mut Rng) -> Rect {
    let side = |rng: &mut Rng| match rng.below(10) {
        0 => rng.pick(&[i32::MIN, i32::MIN + 1, i32::MAX, i32::MAX - 1]),
        1 => rng.bits() as i32,
        _ => rng.int(-6, 44),
    };
    Rect::new(side(rng), side(rng), side(rng), side(rng))
}

fn areas_are_their_pixels<F: PixelFormat>() {
    let mut rng = Rng::new(53);
    for _ in 0..300 {
        let size = (rng.int(0, 40) as u16, rng.int(0, 9) as u16);
        let (start, gap) = (rng.index(8), rng.pick(&[0, 1, 3]));
        let mut twin = Naive::<F>::random(&mut rng, size, start, gap);
        let mut real = twin.bytes.clone();
        let (area, color) = (random_area(&mut rng), color::<F>(&mut rng));
        match rng.below(4) {
            0 => {
                twin.frame(&mut real).clear(color);
                twin.fill(twin.window(), color);
            }
            1 => {
                twin.frame(&mut real).fill_window(color);
                twin.fill(twin.window(), color);
            }
            _ => {
                twin.frame(&mut real).fill_area(area, color);
                twin.fill(area, color);
            }
        }
        twin.assert_same(&real, || format!("{area:?}"));
    }
}

/// A view starts at any pixel, even within a byte; a view of a clip of a view is one too.
fn views_and_clips_are_windows<F: PixelFormat>() {
    let mut rng = Rng::new(54);
    for i in 0..400 {
        let (start, gap) = (rng.index(8), rng.pick(&[0, 1]));
        let mut twin = Naive::<F>::random(&mut rng, (37, 8), start, gap);
        let mut real = twin.bytes.clone();
        let (outer, inner, paint) = (random_area(&mut rng), random_area(&mut rng), random_area(&mut rng));
        let outer = if i < 37 { Rect { x0: i, x1: i + 9, ..outer } } else { outer };
        let color = color::<F>(&mut rng);
        let mut frame = twin.frame(&mut real);
        let mut view = frame.view(outer);
        let extent = |n: u32| n.min(65_535);
        assert_eq!(view.size(), Size::new(extent(outer.width()), extent(outer.height())), "size of {outer:?}");
        view.clipped(inner).fill_area(paint, color);
        let point = Point::new(rng.int(-3, 40), rng.int(-3, 9));
        let got = view.get(point);
        view.set(point, color);

        // The view's (0, 0) is the top left corner of `outer`, and nothing outside of `outer` or its 65,535 is painted.
        let shown = |x: i32, y: i32| {
            let (vx, vy) = (i64::from(x) - i64::from(outer.x0), i64::from(y) - i64::from(outer.y0));
            let in_view = outer.contains(x, y) && vx < 65_535 && vy < 65_535;
            in_view.then_some((vx as i32, vy as i32))
        };
        for y in 0..8 {
            for x in 0..37 {
                let Some((vx, vy)) = shown(x, y) else { continue };
                if Point::new(vx, vy) == point {
                    let before =
                        if inner.contains(vx, vy) && paint.contains(vx, vy) { Some(color) } else { twin.get(x, y) };
                    assert!(same::<F>(got, before), "{point} in {outer:?}");
                }
                if inner.contains(vx, vy) && paint.contains(vx, vy) || Point::new(vx, vy) == point {
                    twin.set(x, y, color);
                }
            }
        }
        twin.assert_same(&real, || format!("view {outer:?} clip {inner:?} paint {paint:?} point {point}"));
    }
}

/// A random shape drawn on a surface.
fn draw<S: Surface>(surface: &mut S, shape: &Shape, color: S::Color) {
    match shape {
        Shape::Line(a, b) => surface.draw_line(Point::new(a.0, a.1), Point::new(b.0, b.1), color),
        Shape::Triangle(units) => surface.fill_triangle(corners(*units), color),
        Shape::Polygon(units) => {
            let mut table = [Edge::EMPTY; 16];
            surface.fill_polygon(&vertices(units), FillRule::EvenOdd, &mut table, color).expect("enough slots");
        }
        Shape::Rectangle(units) => {
            let [a, b, _] = corners(*units);
            surface.fill_rectangle(a, b, color);
        }
    }
}

#[derive(Debug)]
enum Shape {
    Line((i32, i32), (i32, i32)),
    Triangle([Units; 3]),
    Polygon(Vec<Units>),
    Rectangle([Units; 3]),
}

impl Shape {
    fn random(rng: &mut Rng) -> Self {
        let scale = rng.pick(&Scale::ALL);
        let place = |rng: &mut Rng| (rng.int(-2_000, 14_000), rng.int(-1_500, 10_000));
        match rng.below(8) {
            0 => {
                let [a, b] = ends_of_line(rng, scale);
                Self::Line(a, b)
            }
            1 | 2 => {
                let end = |rng: &mut Rng| (rng.int(-4, 50), rng.int(-4, 40));
                let (a, b) = (end(rng), end(rng));
                match rng.below(4) {
                    0 => Self::Line(a, (b.0, a.1)),
                    1 => Self::Line(a, (a.0, b.1)),
                    _ => Self::Line(a, b),
                }
            }
            3 => Self::Triangle([place(rng), place(rng), place(rng)]),
            4 => {
                let far = outline(rng, scale, 3);
                Self::Triangle([place(rng), far[0], far[1]])
            }
            5 => Self::Rectangle([place(rng), place(rng), place(rng)]),
            _ => Self::Polygon((0..rng.range(3, 9)).map(|_| place(rng)).collect()),
        }
    }

    /// Its pixels, by the naive twins.
    fn has(&self, window: Rect) -> Vec<(i32, i32)> {
        let runs = match self {
            Self::Line(a, b) => return twins::line(*a, *b, window),
            Self::Triangle(units) => twins::triangle(*units, window),
            Self::Polygon(units) => twins::polygon(std::slice::from_ref(units), FillRule::EvenOdd, window),
            Self::Rectangle([a, b, _]) => twins::rectangle(*a, *b, window),
        };
        runs.into_iter().flat_map(|(y, x0, x1)| (x0..x1).map(move |x| (x, y))).collect()
    }
}

/// Shapes paint the pixels of their twins, whatever shortcut a framebuffer takes; through views too.
fn shapes_are_their_pixels<F: PixelFormat>() {
    let mut rng = Rng::new(55);
    for _ in 0..400 {
        let (start, gap) = (rng.index(8), rng.pick(&[0, 0, 1, 2]));
        let mut twin = Naive::<F>::random(&mut rng, (45, 33), start, gap);
        let mut real = twin.bytes.clone();
        let (shape, color) = (Shape::random(&mut rng), color::<F>(&mut rng));
        let area = match rng.below(3) {
            0 => twin.window(),
            1 => Rect::new(rng.int(0, 20), rng.int(0, 15), rng.int(20, 45), rng.int(15, 33)),
            _ => Rect::new(rng.int(-9, 50), rng.int(-9, 40), rng.int(-9, 50), rng.int(-9, 40)),
        };
        let is_view = rng.one_in(2);
        let mut frame = twin.frame(&mut real);
        if is_view {
            draw(&mut frame.view(area), &shape, color);
        } else {
            draw(&mut frame.clipped(area), &shape, color);
        }
        let (dx, dy) = if is_view { (area.x0, area.y0) } else { (0, 0) };
        let window = area.intersection(twin.window());
        for (x, y) in shape.has(window.relative_to(dx, dy)) {
            twin.set(x + dx, y + dy, color);
        }
        twin.assert_same(&real, || format!("{shape:?} view {is_view} of {area:?}"));
    }
}

/// A scene drawn band by band is the scene.
fn bands_are_the_whole<F: PixelFormat>() {
    let mut rng = Rng::new(56);
    for _ in 0..12 {
        let (width, height) = (41_u16, 26_u16);
        let shapes: Vec<_> = (0..5).map(|_| (Shape::random(&mut rng), color::<F>(&mut rng))).collect();
        let mut whole = vec![0; buffer_bytes::<F>(width, height)];
        let mut frame = Framebuffer::<F>::new(&mut whole, width, height).expect("the right size");
        for (shape, color) in &shapes {
            draw(&mut frame, shape, *color);
        }
        for rows in [1, 2, 3, 7, 8, 25, 26] {
            let mut pieces = vec![];
            for start in (0..height).step_by(usize::from(rows)) {
                let end = height.min(start + rows);
                let mut memory = vec![0; buffer_bytes::<F>(width, end - start)];
                let mut band = Framebuffer::<F>::band(&mut memory, width, height, start..end).expect("on the screen");
                assert_eq!(band.size(), Size::new(width.into(), height.into()), "a band has the size of its screen");
                assert_eq!(band.window(), Rect::new(0, start.into(), width.into(), end.into()), "and its own rows");
                for (shape, color) in &shapes {
                    draw(&mut band, shape, *color);
                }
                pieces.extend(memory);
            }
            assert!(
                pieces == whole,
                "bands of {rows} rows of {shapes:?}",
                shapes = shapes.iter().map(|s| &s.0).collect::<Vec<_>>()
            );
        }
    }
}

fn rows_read_out_are_their_pixels<F: PixelFormat>() {
    let mut rng = Rng::new(57);
    for _ in 0..200 {
        let size = (rng.int(0, 30) as u16, rng.int(0, 8) as u16);
        let (start, gap) = (rng.index(4), rng.index(3));
        let twin = Naive::<F>::random(&mut rng, size, start, gap);
        let mut real = twin.bytes.clone();
        let memory = &twin.bytes[twin.place.clone()];
        let frame = twin.frame(&mut real);
        let area = random_area(&mut rng);
        let seen = area.intersection(twin.window());

        let wanted: Vec<_> = if seen.is_empty() {
            vec![]
        } else {
            let pixels = || (seen.y0..seen.y1).flat_map(|y| (seen.x0..seen.x1).map(move |x| (x, y)));
            pixels().map(|(x, y)| twin.get(x, y).expect("inside")).collect()
        };
        assert!(frame.colors(area).eq(wanted), "colors of {area:?}");

        let wanted: Vec<&[u8]> = if seen.is_empty() {
            vec![]
        } else {
            let byte = |bits: i32| bits as usize * F::BITS as usize;
            (seen.y0 as usize..seen.y1 as usize)
                .map(|y| &memory[y * twin.stride + byte(seen.x0) / 8..y * twin.stride + byte(seen.x1).div_ceil(8)])
                .collect()
        };
        assert!(frame.bytes(area).eq(wanted.iter().copied()), "bytes of {area:?}");
        assert!(twin.bitmap().bytes(area).eq(wanted.iter().copied()), "bytes of a bitmap, {area:?}");

        let (first, end) = (rng.int(0, 9) as u16, rng.int(0, 9) as u16);
        let rows = if first <= end && end <= size.1 {
            let stop = (usize::from(end) * twin.stride).min(memory.len());
            &memory[(usize::from(first) * twin.stride).min(stop)..stop]
        } else {
            &[]
        };
        assert_eq!(frame.row_bytes(first..end), rows, "rows {first}..{end} of {}", size.1);
        let bitmap = frame.as_bitmap();
        let p = Point::new(rng.int(-2, 31), rng.int(-2, 9));
        assert!(same::<F>(bitmap.get(p), twin.get(p.x, p.y)), "a framebuffer's bitmap at {p}");
        assert_eq!((bitmap.window(), bitmap.size()), (frame.window(), frame.size()), "and its size");
    }
}

/// Two pictures with few colours, so that keys hit.
fn pictures<F: PixelFormat>(rng: &mut Rng) -> (Naive<F>, Naive<F>) {
    let picture = |rng: &mut Rng| {
        let size = (rng.int(0, 40) as u16, rng.int(0, 7) as u16);
        let (start, gap) = (rng.index(8), rng.pick(&[0, 0, 1, 3]));
        let mut picture = Naive::<F>::random(rng, size, start, gap);
        let key = color::<F>(rng);
        for _ in 0..usize::from(size.0) * usize::from(size.1) / 2 {
            picture.set(rng.int(0, 39), rng.int(0, 6), key);
        }
        picture
    };
    (picture(rng), picture(rng))
}

/// A colour that `picture` has.
fn key_of<F: PixelFormat>(rng: &mut Rng, picture: &Naive<F>) -> Option<F::Color> {
    let (x, y) = (rng.int(0, 39), rng.int(0, 6));
    picture.get(x, y).filter(|_| rng.one_in(2))
}

/// From any pixel of a byte to any other, clipped on every side, with and without a key, through views.
fn blits_are_their_pixels<F: PixelFormat>() {
    let mut rng = Rng::new(58);
    for i in 0..900 {
        let (mut twin, source) = pictures::<F>(&mut rng);
        let mut real = twin.bytes.clone();
        let key = key_of(&mut rng, &source);
        let (part, clip) =
            if i % 3 == 0 { (source.window(), twin.window()) } else { (random_area(&mut rng), random_area(&mut rng)) };
        let at = if rng.one_in(20) {
            Point::new(rng.bits() as i32, rng.pick(&[i32::MIN, i32::MAX, 0]))
        } else {
            Point::new(rng.int(-20, 40), rng.int(-5, 7))
        };
        let bitmap = source.bitmap().part(part);
        let mut frame = twin.frame(&mut real);
        let mut target = frame.clipped(clip);
        match key {
            Some(key) => target.blit_keyed(at, &bitmap, key),
            None => target.blit(at, &bitmap),
        }
        twin.blit(clip, at, &source, part, key);
        twin.assert_same(&real, || format!("{part:?} at {at} in {clip:?}, key {}", key.is_some()));
    }
    every_phase::<F>(&mut rng);
}

/// Every start within a byte on both sides, every short width.
fn every_phase<F: PixelFormat>(rng: &mut Rng) {
    let before = Naive::<F>::random(rng, (40, 1), 3, 0);
    let source = Naive::<F>::random(rng, (40, 1), 2, 0);
    for from in 0..9 {
        for to in 0..9 {
            for width in 1..28 {
                let (mut twin, mut real) = (before.clone(), before.bytes.clone());
                let part = Rect::new(from, 0, from + width, 1);
                // A view of the target and one of the source give the same.
                let mut frame = before.frame(&mut real);
                let mut view = frame.view(Rect::new(to, 0, 40, 1));
                view.blit(Point::new(0, 0), &source.bitmap().part(part));
                twin.blit(before.window(), Point::new(to, 0), &source, part, None);
                twin.assert_same(&real, || format!("{width} pixels from {from} to {to}"));
            }
        }
    }
}

/// Up, down, left, right, by less than a pixel row and by more than the area, near and at the ends of `i32`.
fn moves_are_their_pixels<F: PixelFormat>() {
    let mut rng = Rng::new(59);
    for i in 0..900 {
        let (mut twin, _) = pictures::<F>(&mut rng);
        if i % 10 == 0 {
            // Wider than what is taken up at once.
            let (start, gap) = (rng.index(8), rng.index(2));
            twin = Naive::random(&mut rng, (450, 3), start, gap);
        }
        let mut real = twin.bytes.clone();
        let clip = if rng.one_in(3) { random_area(&mut rng) } else { twin.window() };
        let (area, to) = if rng.one_in(2) {
            let wide = if i % 10 == 0 { 430 } else { 24 };
            let (x, y) = (rng.int(-3, 20), rng.int(-3, 5));
            let area = Rect::new(x, y, x + rng.int(0, wide), y + rng.int(0, 6));
            (area, Point::new(x + rng.int(-9, 9), y + rng.int(-3, 3)))
        } else {
            let area = random_area(&mut rng);
            let near = |n: i32, rng: &mut Rng| n.saturating_add(rng.int(-9, 9));
            (area, Point::new(near(area.x0, &mut rng), near(area.y0, &mut rng)))
        };
        let key = key_of(&mut rng, &twin);
        let mut frame = twin.frame(&mut real);
        let mut target = frame.clipped(clip);
        match key {
            Some(key) => target.move_area_keyed(area, to, key),
            None => target.move_area(area, to),
        }
        twin.move_area(clip, area, to, key);
        twin.assert_same(&real, || format!("{area:?} to {to} in {clip:?}, key {}", key.is_some()));
    }
}

/// What embedded-graphics calls: single pixels, solid and many-coloured rectangles, clear, reading.
fn embedded_graphics_draws_pixels<F: PixelFormat>() {
    let mut rng = Rng::new(60);
    for _ in 0..200 {
        let (start, gap) = (rng.index(8), rng.index(3));
        let mut twin = Naive::<F>::random(&mut rng, (21, 9), start, gap);
        let mut real = twin.bytes.clone();
        let corner = Point::new(rng.int(-8, 24), rng.int(-8, 11));
        let area = Rectangle::new(corner, Size::new(rng.below(30) as u32, rng.below(14) as u32));
        let shift = (rng.int(0, 4), rng.int(0, 3));
        let window = Rect::new(shift.0, shift.1, 21, 9);
        let mut frame = twin.frame(&mut real);
        let mut view = frame.view(window);
        let colors: Vec<F::Color> = (0..rng.index(450)).map(|_| color::<F>(&mut rng)).collect();
        let places: Vec<Point> = (0..area.size.height as i32)
            .flat_map(|y| (0..area.size.width as i32).map(move |x| corner + Point::new(x, y)))
            .collect();
        match rng.below(3) {
            0 => view.fill_contiguous(&area, colors.iter().copied()).expect("infallible"),
            1 => {
                let pixels = places.iter().zip(&colors).map(|(&p, &c)| Pixel(p, c));
                view.draw_iter(pixels).expect("infallible");
            }
            _ => {
                view.fill_solid(&area, colors.first().copied().unwrap_or(F::unpack(0))).expect("infallible");
                let solid = colors.first().copied().unwrap_or(F::unpack(0));
                for p in &places {
                    twin.set_in(window, *p, solid);
                }
                twin.assert_same(&real, || format!("fill_solid {area:?}"));
                continue;
            }
        }
        let p = Point::new(rng.int(-2, 22), rng.int(-2, 10));
        let got = view.pixel(p);
        for (p, c) in places.iter().zip(&colors) {
            twin.set_in(window, *p, *c);
        }
        let wanted = (p.x >= 0 && p.y >= 0).then(|| twin.get(p.x + shift.0, p.y + shift.1)).flatten();
        assert!(same::<F>(got, wanted), "pixel {p}");
        twin.assert_same(&real, || format!("{area:?} with {} colours", colors.len()));
    }
}

/// The numbers in the errors are the ones that a caller can compute.
fn constructors_check<F: PixelFormat>() {
    let mut rng = Rng::new(61);
    for _ in 0..500 {
        let side = |rng: &mut Rng| rng.pick(&[0, 1, 2, 7, 8, 9, 33, 255, 65_535]);
        let (width, height): (u16, u16) = (side(&mut rng), side(&mut rng));
        let row = (usize::from(width) * F::BITS as usize).div_ceil(8);
        assert_eq!(row_bytes::<F>(width), row, "bytes of {width} pixels");
        assert_eq!(buffer_bytes::<F>(width, height), row * usize::from(height), "bytes of {width} x {height}");
        let given = rng.index(600);
        let mut memory = vec![0xa5; given];
        let stride = (row + rng.index(5)).saturating_sub(rng.index(5));
        let needed = if height == 0 { 0 } else { stride * (usize::from(height) - 1) + row };
        let strided = if stride < row {
            Err(Error::StrideTooSmall { needed: row, given: stride })
        } else if given < needed {
            Err(Error::BufferTooSmall { needed, given })
        } else {
            Ok(())
        };
        let frame = Framebuffer::<F>::with_stride(&mut memory, width, height, stride).map(|_| ());
        assert_eq!(frame, strided, "{width} x {height} stride {stride} in {given}");
        assert_eq!(Bitmap::<F>::with_stride(&memory, width, height, stride).map(|_| ()), strided, "and a bitmap");
        let needed = row * usize::from(height);
        let packed = if given < needed { Err(Error::BufferTooSmall { needed, given }) } else { Ok(()) };
        assert_eq!(
            Framebuffer::<F>::new(&mut memory, width, height).map(|_| ()),
            packed,
            "{width} x {height} in {given}"
        );
        assert_eq!(Bitmap::<F>::new(&memory, width, height).map(|_| ()), packed, "and a bitmap");
        let (start, end) = (side(&mut rng), side(&mut rng));
        let wanted = if start > end || end > height {
            Err(Error::BandOutsideScreen { start, end, height })
        } else if given < row * usize::from(end - start) {
            Err(Error::BufferTooSmall { needed: row * usize::from(end - start), given })
        } else {
            Ok(())
        };
        let band = Framebuffer::<F>::band(&mut memory, width, height, start..end).map(|_| ());
        assert_eq!(band, wanted, "band {start}..{end} of {width} x {height} in {given}");
        assert!(memory.iter().all(|&b| b == 0xa5), "constructors do not touch the memory");
    }
}

/// Bytes as the table of formats has them, written by hand.
#[test]
fn bytes_in_memory() {
    fn bytes<F: PixelFormat>(colors: &[F::Color]) -> Vec<u8> {
        let mut memory = vec![0; row_bytes::<F>(colors.len() as u16)];
        let mut frame = Framebuffer::<F>::new(&mut memory, colors.len() as u16, 1).expect("the right size");
        for (x, &color) in colors.iter().enumerate() {
            frame.set(Point::new(x as i32, 0), color);
        }
        memory
    }
    let on_off = |bits: [u8; 10]| bits.map(|b| BinaryColor::from(b == 1));
    assert_eq!(bytes::<BinaryColor>(&on_off([1, 0, 0, 0, 0, 0, 1, 0, 1, 0])), [0b1000_0010, 0b1000_0000]);
    assert_eq!(bytes::<Lsb0<BinaryColor>>(&on_off([1, 0, 0, 0, 0, 0, 1, 0, 1, 0])), [0b0100_0001, 0b0000_0001]);
    assert_eq!(bytes::<Index1>(&[0, 1, 1].map(Index1::new)), [0b0110_0000]);
    assert_eq!(bytes::<Index2>(&[1, 2, 3, 0, 2].map(Index2::new)), [0b0110_1100, 0b1000_0000]);
    assert_eq!(bytes::<Lsb0<Index2>>(&[1, 2, 3, 0, 2].map(Index2::new)), [0b0011_1001, 0b0000_0010]);
    assert_eq!(bytes::<Gray2>(&[1, 2, 3, 0].map(Gray2::new)), [0b0110_1100]);
    assert_eq!(bytes::<Index4>(&[1, 2, 15].map(Index4::new)), [0x12, 0xf0]);
    assert_eq!(bytes::<Lsb0<Index4>>(&[1, 2, 15].map(Index4::new)), [0x21, 0x0f]);
    assert_eq!(bytes::<Gray4>(&[9, 4].map(Gray4::new)), [0x94]);
    assert_eq!(bytes::<Index8>(&[9, 255].map(Index8::new)), [9, 255]);
    assert_eq!(bytes::<Gray8>(&[9, 255].map(Gray8::new)), [9, 255]);
    assert_eq!(bytes::<Rgb332>(&[Rgb332::new(7, 0, 0), Rgb332::new(0, 5, 2)]), [7 << 5, 5 << 2 | 2]);
    assert_eq!(bytes::<Rgb565>(&[Rgb565::RED, Rgb565::new(1, 2, 3)]), [0x00, 0xf8, 0x43, 0x08]);
    assert_eq!(bytes::<Be<Rgb565>>(&[Rgb565::RED, Rgb565::new(1, 2, 3)]), [0xf8, 0x00, 0x08, 0x43]);
    assert_eq!(bytes::<Bgr565>(&[Bgr565::RED, Bgr565::BLUE]), [0x1f, 0x00, 0x00, 0xf8]);
    assert_eq!(bytes::<Be<Bgr565>>(&[Bgr565::RED]), [0x00, 0x1f]);
    assert_eq!(bytes::<Rgb555>(&[Rgb555::RED, Rgb555::GREEN]), [0x00, 0x7c, 0xe0, 0x03]);
    assert_eq!(bytes::<Be<Rgb555>>(&[Rgb555::RED]), [0x7c, 0x00]);
    assert_eq!(bytes::<Bgr555>(&[Bgr555::BLUE]), [0x00, 0x7c]);
    assert_eq!(bytes::<Be<Bgr555>>(&[Bgr555::GREEN]), [0x03, 0xe0]);
    assert_eq!(bytes::<Rgb888>(&[Rgb888::new(1, 2, 3)]), [3, 2, 1]);
    assert_eq!(bytes::<Be<Rgb888>>(&[Rgb888::new(1, 2, 3)]), [1, 2, 3]);
    assert_eq!(bytes::<Bgr888>(&[Bgr888::new(1, 2, 3)]), [1, 2, 3]);
    assert_eq!(bytes::<Be<Bgr888>>(&[Bgr888::new(1, 2, 3)]), [3, 2, 1]);
    assert_eq!(bytes::<Rgb666>(&[Rgb666::RED, Rgb666::BLUE]), [0x00, 0xf0, 0x03, 0x3f, 0x00, 0x00]);
    assert_eq!(bytes::<Be<Rgb666>>(&[Rgb666::RED]), [0x03, 0xf0, 0x00]);
    assert_eq!(bytes::<Bgr666>(&[Bgr666::RED]), [0x3f, 0x00, 0x00]);
    assert_eq!(bytes::<Xrgb8888>(&[Xrgb8888::new(1, 2, 3)]), [3, 2, 1, 0]);
    assert_eq!(bytes::<Be<Xrgb8888>>(&[Xrgb8888::new(1, 2, 3)]), [0, 1, 2, 3]);
}

/// Each format has the bits that the table says.
#[test]
fn bits_per_pixel() {
    assert_eq!([Index1::BITS, <Lsb0<BinaryColor>>::BITS, Index2::BITS, Gray2::BITS], [1, 1, 2, 2]);
    assert_eq!([Index4::BITS, Gray4::BITS, Index8::BITS, Gray8::BITS, Rgb332::BITS], [4, 4, 8, 8, 8]);
    assert_eq!([Rgb555::BITS, Bgr555::BITS, Rgb565::BITS, <Be<Bgr565>>::BITS], [16; 4]);
    assert_eq!([Rgb666::BITS, Bgr666::BITS, Rgb888::BITS, <Be<Bgr888>>::BITS], [24; 4]);
    assert_eq!([Xrgb8888::BITS, <Be<Xrgb8888>>::BITS], [32; 2]);
}

/// The twin of paged memory: a byte holds eight rows, the top one in bit 0.
struct NaivePages {
    bytes: Vec<u8>,
    width: u16,
    height: u16,
}

impl NaivePages {
    fn random(rng: &mut Rng) -> Self {
        let (width, height) = (rng.int(0, 20) as u16, rng.int(0, 30) as u16);
        let bytes = (0..paged_bytes(width, height) + 5).map(|_| rng.bits() as u8).collect();
        Self { bytes, width, height }
    }

    fn window(&self) -> Rect {
        Rect::new(0, 0, self.width.into(), self.height.into())
    }

    fn byte(&self, x: i32, y: i32) -> usize {
        y as usize / 8 * usize::from(self.width) + x as usize
    }

    fn get(&self, x: i32, y: i32) -> Option<bool> {
        self.window().contains(x, y).then(|| self.bytes[self.byte(x, y)] >> (y % 8) & 1 == 1)
    }

    fn set(&mut self, x: i32, y: i32, on: bool) {
        if self.window().contains(x, y) {
            let at = self.byte(x, y);
            self.bytes[at] = self.bytes[at] & !(1 << (y % 8)) | u8::from(on) << (y % 8);
        }
    }
}

#[test]
fn paged_memory_is_its_pixels() {
    let mut rng = Rng::new(62);
    for _ in 0..6_000 {
        let mut twin = NaivePages::random(&mut rng);
        let mut real = twin.bytes.clone();
        let (area, clip, on) = (random_area(&mut rng), random_area(&mut rng), rng.one_in(2));
        let shape = Shape::random(&mut rng);
        let p = Point::new(rng.int(-3, 22), rng.int(-3, 33));
        let mut oled = Paged::<BinaryColor>::new(&mut real, twin.width, twin.height).expect("the right size");
        assert_eq!(oled.size(), Size::new(twin.width.into(), twin.height.into()));
        let color = BinaryColor::from(on);
        let pixels: Vec<(i32, i32)> = match rng.below(5) {
            0 => {
                oled.clear(color);
                all_pixels(twin.window())
            }
            1 => {
                oled.clipped(clip).fill_area(area, color);
                all_pixels(twin.window().intersection(clip).intersection(area))
            }
            2 => {
                oled.set(p, color);
                vec![(p.x, p.y)]
            }
            3 => {
                draw(&mut oled.clipped(clip), &shape, color);
                shape.has(twin.window().intersection(clip))
            }
            _ => {
                let solid = Rectangle::new(p, Size::new(rng.below(20) as u32, rng.below(20) as u32));
                let colors = core::iter::repeat_n(color, 400);
                oled.fill_contiguous(&solid, colors).expect("infallible");
                all_pixels(Rect::from(solid).intersection(twin.window()))
            }
        };
        for (x, y) in pixels {
            twin.set(x, y, on);
        }
        let q = Point::new(rng.int(-3, 22), rng.int(-3, 33));
        let oled = Paged::<Index1>::new(&mut real, twin.width, twin.height).expect("the right size");
        assert_eq!(oled.get(q), twin.get(q.x, q.y).map(|on| Index1::new(on.into())), "at {q}");
        assert_eq!(oled.pixel(q), oled.get(q));
        let (first, end) = (rng.below(6) as u16, rng.below(6) as u16);
        let inside = first <= end && end <= twin.height.div_ceil(8);
        let width = usize::from(twin.width);
        let pages = if inside { &twin.bytes[usize::from(first) * width..usize::from(end) * width] } else { &[] };
        assert_eq!(oled.page_bytes(first..end), pages, "pages {first}..{end} of {} rows", twin.height);
        assert_eq!(real, twin.bytes, "{} x {} {shape:?} {area:?} {clip:?}", twin.width, twin.height);
    }
}

fn all_pixels(area: Rect) -> Vec<(i32, i32)> {
    if area.is_empty() {
        return vec![];
    }
    (area.y0..area.y1).flat_map(|y| (area.x0..area.x1).map(move |x| (x, y))).collect()
}

#[test]
fn paged_memory_checks_its_size() {
    assert_eq!([paged_bytes(128, 64), paged_bytes(5, 9), paged_bytes(5, 0), paged_bytes(0, 9)], [1024, 10, 0, 0]);
    let mut memory = [0; 9];
    let error = Paged::<BinaryColor>::new(&mut memory, 5, 9).map(|_| ()).expect_err("one byte is missing");
    assert_eq!(error, Error::BufferTooSmall { needed: 10, given: 9 });
}

#[test]
fn a_counter_counts_what_a_framebuffer_paints() {
    let mut rng = Rng::new(63);
    let window = Rect::new(0, 0, 45, 33);
    for _ in 0..3_000 {
        let shape = Shape::random(&mut rng);
        let mut counter = Counter::<Gray8>::new(window);
        draw(&mut counter, &shape, Gray8::new(1));
        assert_eq!(counter.pixels, shape.has(window).len() as u64, "{shape:?}");
        assert_eq!(counter.window(), window);
    }
}

/// Formats that are indices or have few bits, through every expansion to every way of storing the output.
mod palettes {
    use super::*;
    use embedded_graphics_core::pixelcolor::PixelColor;
    use embedded_raster::{pixel::EGA, Palette};

    /// Writes the colours of the indices one by one.
    fn expand_by_pixel<I: PixelFormat, O: PixelFormat>(table: &[O::Color], indices: &[u8], out: &mut [u8])
    where
        I::Color: Into<u8>,
    {
        let pixels = (indices.len() * 8 / I::BITS as usize).min(out.len() * 8 / O::BITS as usize).min(65_535) as u16;
        let from = Bitmap::<I>::new(indices, pixels, 1).expect("as many as there are");
        let mut to = Framebuffer::<O>::new(out, pixels, 1).expect("as many as there is room for");
        for x in 0..i32::from(pixels) {
            let index: u8 = from.get(Point::new(x, 0)).expect("inside").into();
            if let Some(color) = table.get(usize::from(index)).or(table.first()) {
                to.set(Point::new(x, 0), *color);
            } else {
                to.set(Point::new(x, 0), O::unpack(0));
            }
        }
    }

    fn check<I: PixelFormat, O: PixelFormat, const N: usize>(rng: &mut Rng)
    where
        I::Color: Into<u8>,
        O::Color: PixelColor,
    {
        for _ in 0..60 {
            let palette = Palette::<O::Color, N>::new([(); N].map(|()| color::<O>(rng)));
            let indices: Vec<u8> = (0..rng.index(40)).map(|_| rng.bits() as u8).collect();
            let longest = indices.len() * O::BITS as usize / I::BITS as usize;
            let length = if rng.one_in(3) { longest } else { rng.index(longest + 9) };
            let (start, around) = (rng.index(5), 8);
            let before: Vec<u8> = (0..start + length + around).map(|_| rng.bits() as u8).collect();
            let (mut wanted, mut got) = (before.clone(), before);
            expand_by_pixel::<I, O>(palette.colors(), &indices, &mut wanted[start..start + length]);
            palette.expand::<I, O>(&indices, &mut got[start..start + length]);
            assert_eq!(
                got,
                wanted,
                "{} bytes of {} to {length} of {} through {N} colours",
                indices.len(),
                std::any::type_name::<I>(),
                std::any::type_name::<O>()
            );
        }
    }

    fn check_output<O: PixelFormat>(rng: &mut Rng) {
        check::<Index1, O, 2>(rng);
        check::<Lsb0<Index1>, O, 2>(rng);
        check::<Index2, O, 4>(rng);
        check::<Lsb0<Index2>, O, 4>(rng);
        check::<Index4, O, 16>(rng);
        check::<Lsb0<Index4>, O, 16>(rng);
        check::<Index8, O, 256>(rng);
        // Tables that do not have every index.
        check::<Index1, O, 1>(rng);
        check::<Index4, O, 9>(rng);
        check::<Index8, O, 216>(rng);
        check::<Index8, O, 0>(rng);
        check::<Index2, O, 0>(rng);
    }

    #[test]
    fn expansion_to_less_than_a_byte() {
        let mut rng = Rng::new(70);
        check_output::<BinaryColor>(&mut rng);
        check_output::<Lsb0<Gray2>>(&mut rng);
        check_output::<Gray4>(&mut rng);
    }

    #[test]
    fn expansion_to_bytes() {
        let mut rng = Rng::new(71);
        check_output::<Gray8>(&mut rng);
        check_output::<Rgb332>(&mut rng);
    }

    #[test]
    fn expansion_to_words() {
        let mut rng = Rng::new(72);
        check_output::<Rgb565>(&mut rng);
        check_output::<Be<Rgb565>>(&mut rng);
        check_output::<Bgr555>(&mut rng);
    }

    #[test]
    fn expansion_to_more_than_words() {
        let mut rng = Rng::new(73);
        check_output::<Rgb888>(&mut rng);
        check_output::<Be<Rgb666>>(&mut rng);
        check_output::<Xrgb8888>(&mut rng);
        check_output::<Be<Xrgb8888>>(&mut rng);
    }

    #[test]
    fn rotation_is_that_of_slices() {
        let mut rng = Rng::new(74);
        let colors: [u8; 23] = core::array::from_fn(|i| i as u8);
        for start in 0..26 {
            for end in 0..28 {
                for by in [0, 1, 2, 5, 22, 23, 24, 1000, usize::MAX, rng.bits() as usize] {
                    let mut palette = Palette::new(colors);
                    palette.rotate(start..end, by);
                    let mut wanted = colors;
                    if let Some(range) = wanted.get_mut(start..end.min(23)).filter(|r| !r.is_empty()) {
                        range.rotate_right(by % range.len());
                    }
                    assert_eq!(palette.colors(), &wanted, "{start}..{end} by {by}");
                }
            }
        }
    }

    #[test]
    fn the_nearest_entry_is_the_nearest() {
        let mut rng = Rng::new(75);
        for _ in 0..2_000 {
            let palette = Palette::<Rgb888, 37>::new([(); 37].map(|()| color::<Rgb888>(&mut rng)));
            let wanted = color::<Rgb888>(&mut rng);
            let distance = |c: &Rgb888| {
                let square = |a: u8, b: u8| (i32::from(a) - i32::from(b)).pow(2);
                square(c.r(), wanted.r()) + square(c.g(), wanted.g()) + square(c.b(), wanted.b())
            };
            let least = palette.colors().iter().map(distance).min();
            let first = palette.colors().iter().position(|c| Some(distance(c)) == least);
            assert_eq!(Some(usize::from(palette.nearest(wanted))), first, "{wanted:?}");
        }
        assert_eq!(Palette::<Rgb888, 0>::new([]).nearest(Rgb888::RED), 0);
        // More entries than an index reaches: those count that it does.
        let mut many = [Rgb888::RED; 300];
        many[255] = Rgb888::GREEN;
        many[280] = Rgb888::BLUE;
        assert_eq!(Palette::new(many).nearest(Rgb888::GREEN), 255);
        assert_eq!(Palette::new(many).nearest(Rgb888::BLUE), 0);
    }

    #[test]
    fn entries_are_set_and_read_back() {
        let mut palette = Palette::new([Rgb565::BLACK; 4]);
        assert!(palette.set(3, Rgb565::RED));
        assert!(!palette.set(4, Rgb565::RED));
        assert_eq!([palette.get(3), palette.get(0), palette.get(4)], [Some(Rgb565::RED), Some(Rgb565::BLACK), None]);
        assert_eq!(palette.colors(), &[Rgb565::BLACK, Rgb565::BLACK, Rgb565::BLACK, Rgb565::RED]);
        assert_eq!(palette.map(Rgb888::from).get(3), Some(Rgb888::RED));
    }

    #[test]
    fn standard_tables() {
        let rgb = |r, g, b| Some(Rgb888::new(r, g, b));
        #[rustfmt::skip]
        let ega = [
            (0, 0, 0), (0, 0, 170), (0, 170, 0), (0, 170, 170), (170, 0, 0), (170, 0, 170), (170, 85, 0), (170, 170, 170),
            (85, 85, 85), (85, 85, 255), (85, 255, 85), (85, 255, 255), (255, 85, 85), (255, 85, 255), (255, 255, 85),
            (255, 255, 255),
        ];
        assert_eq!(EGA.colors(), &ega.map(|(r, g, b)| Rgb888::new(r, g, b)));

        let web = Palette::web_safe();
        assert_eq!(
            [web.get(0), web.get(215), web.get(36), web.get(7)],
            [rgb(0, 0, 0), rgb(255, 255, 255), rgb(51, 0, 0), rgb(0, 51, 51)]
        );
        for (i, c) in web.colors().iter().enumerate() {
            let level = |n: usize| (n * 51) as u8;
            assert_eq!(*c, Rgb888::new(level(i / 36), level(i / 6 % 6), level(i % 6)), "{i}");
        }

        let table = Palette::rgb332();
        for (i, c) in table.colors().iter().enumerate() {
            let nearest = |n: usize, max: u32| (f64::from(n as u32 * 255) / f64::from(max)).round() as u8;
            assert_eq!(*c, Rgb888::new(nearest(i >> 5, 7), nearest(i >> 2 & 7, 7), nearest(i & 3, 3)), "{i}");
        }

        let grey = |n| Rgb888::new(n, n, n);
        assert_eq!(Palette::<Rgb888, 2>::greys().colors(), &[0, 255].map(grey));
        assert_eq!(Palette::<Rgb888, 4>::greys().colors(), &[0, 85, 170, 255].map(grey));
        assert_eq!(Palette::<Rgb888, 3>::greys().colors(), &[0, 128, 255].map(grey));
        assert_eq!(Palette::<Rgb888, 1>::greys().colors(), &[0].map(grey));
        assert_eq!(Palette::<Rgb888, 0>::greys().colors(), &[]);
        assert!(Palette::<Rgb888, 256>::greys().colors().iter().enumerate().all(|(i, c)| *c == grey(i as u8)));
        let sixteen = Palette::<Rgb888, 16>::greys();
        assert!(sixteen.colors().iter().enumerate().all(|(i, c)| *c == grey(i as u8 * 17)));
    }
}

/// What an index looks like by the standard table of its size, and back.
mod conversions {
    use super::*;
    use embedded_graphics_core::pixelcolor::raw::{RawData, RawU1, RawU2, RawU4, RawU8};
    use embedded_raster::{pixel::EGA, Palette};

    #[test]
    fn indices_there_and_back() {
        for i in 0..=255 {
            assert_eq!(Index8::from(Rgb888::from(Index8::new(i))), Index8::new(i), "{i}");
            assert_eq!(Rgb888::from(Index8::new(i)), Palette::rgb332().colors()[usize::from(i)], "{i}");
            assert_eq!(u8::from(Index8::new(i)), i);
            assert_eq!((Index1::new(i).index(), Index2::new(i).index()), (i & 1, i & 3), "the low bits of {i}");
            assert_eq!((Index4::new(i).index(), Index8::new(i).index()), (i & 15, i), "the low bits of {i}");
            assert_eq!(RawU8::from(Index8::from(RawU8::new(i))).into_inner(), i);
            assert_eq!(RawU4::from(Index4::from(RawU4::new(i))).into_inner(), i & 15);
            assert_eq!(RawU2::from(Index2::from(RawU2::new(i))).into_inner(), i & 3);
            assert_eq!(RawU1::from(Index1::from(RawU1::new(i))).into_inner(), i & 1);
        }
        for i in 0..16 {
            let index = Index4::new(i);
            assert_eq!(Rgb888::from(index), EGA.colors()[usize::from(i)], "{i}");
            assert_eq!(Index4::from(Rgb888::from(index)), index);
            assert_eq!(Index4::from(Rgb565::from(index)), index);
            assert_eq!(Index4::from(Rgb555::from(index)), index);
        }
        for i in 0..4 {
            assert_eq!(Rgb888::from(Index2::new(i)), Rgb888::new(i * 85, i * 85, i * 85));
            assert_eq!(Index2::from(Rgb888::from(Index2::new(i))), Index2::new(i));
            assert_eq!(Index2::from(Rgb565::from(Index2::new(i))), Index2::new(i));
        }
        assert_eq!([0, 1].map(|i| Rgb888::from(Index1::new(i))), [Rgb888::BLACK, Rgb888::WHITE]);
        assert_eq!([Rgb888::BLACK, Rgb888::WHITE].map(Index1::from), [0, 1].map(Index1::new));
        assert_eq!(
            [Index1::MAX.index(), Index2::MAX.index(), Index4::MAX.index(), Index8::MAX.index()],
            [1, 3, 15, 255]
        );
        let on = BinaryColor::On;
        assert_eq!((Index1::from(on), Index2::from(on)), (Index1::MAX, Index2::MAX));
        assert_eq!((Index4::from(on), Index8::from(on)), (Index4::MAX, Index8::MAX));
        assert_eq!(Index8::from(BinaryColor::Off), Index8::new(0));
    }

    #[test]
    fn rgb_goes_to_the_nearest() {
        let mut rng = Rng::new(76);
        for _ in 0..20_000 {
            let c = color::<Rgb888>(&mut rng);
            assert_eq!(Index4::from(c).index(), EGA.nearest(c), "{c:?}");
            // Each channel on its own: the level whose value lies nearest, the upper one at a tie.
            let level = |v: u8, max: u8| (f64::from(v) * f64::from(max) / 255.0).round() as u8;
            let wanted = Rgb332::new(level(c.r(), 7), level(c.g(), 7), level(c.b(), 3));
            assert_eq!(Rgb332::from(c), wanted, "{c:?}");
            assert_eq!(Index8::from(c).index(), wanted.r() << 5 | wanted.g() << 2 | wanted.b(), "{c:?}");
            assert_eq!(Rgb888::from(Xrgb8888::from(c)), c);
        }
        for grey in 0..=255 {
            let c = Rgb888::new(grey, grey, grey);
            assert_eq!(Index1::from(c).index(), u8::from(grey > 127), "{grey}");
            assert_eq!(Index2::from(c).index(), (f64::from(grey) / 85.0).round() as u8, "{grey}");
        }
    }

    #[test]
    fn channels() {
        let c = Xrgb8888::new(1, 2, 3);
        assert_eq!((c.r(), c.g(), c.b()), (1, 2, 3));
        let c = Rgb332::new(255, 254, 253);
        assert_eq!((c.r(), c.g(), c.b()), (7, 6, 1), "channels are cut to the bits they have");
        assert_eq!(Rgb332::WHITE, Rgb332::new(7, 7, 3));
        assert_eq!([Rgb332::MAX_R, Rgb332::MAX_G, Rgb332::MAX_B], [7, 7, 3]);
        assert_eq!(Rgb888::from(Rgb332::YELLOW), Rgb888::YELLOW);
        assert_eq!(Rgb565::from(Xrgb8888::CYAN), Rgb565::CYAN);
    }
}
