//! The laws that every pixel format and every surface keeps, each against a twin that writes single bits.
//!
//! A new format is one more line in [`formats`], a new layout one in [`layouts`].

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "coordinates of small windows, made to fit"
)]

use std::marker::PhantomData;

use embedded_graphics_core::{
    geometry::{Point, Size},
    pixelcolor::{
        Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666, Rgb888, RgbColor,
    },
    primitives::Rectangle,
};
use embedded_raster::{
    pixel::{row_bytes, Be, Lsb0, Rgb332, Rgb444, Xrgb8888},
    surface::{paged_bytes, Counter, Packed12, Paged, Pages, Planes, Rows},
    BufferError, Frame, Framebuffer, Index1, Index2, Index4, Index8, PixelFormat, Rect, Span, Surface,
};
use twins::{
    frame::{Kind, Of, Shape},
    memory::{color, pixels, Arrangement, Format, Naive},
    rng::Rng,
};

/// Every law for every format.
macro_rules! formats {
    ($($name:ident: $format:ty,)*) => {$(
        #[test]
        fn $name() {
            every_law(&Of::<Rows<$format>, $format>::rows());
            rows_read_out_are_their_pixels::<$format>();
        }
    )*};
}

/// Every law for every layout that is not rows of a format.
macro_rules! layouts {
    ($($name:ident: $layout:ty, $format:ty, $arrangement:ident, $bits:literal;)*) => {$(
        #[test]
        fn $name() {
            let format = Format::of::<$format>().arranged(Arrangement::$arrangement, $bits);
            every_law(&Of::<$layout, $format>(PhantomData, format));
        }
    )*};
}

layouts! {
    pages: Pages<Index1>, Index1, Pages, 1;
    pages_lsb0: Pages<Lsb0<BinaryColor>>, Lsb0<BinaryColor>, Pages, 1;
    planes: Planes<Index2>, Index2, Planes, 2;
    planes_lsb0: Planes<Lsb0<Gray2>>, Lsb0<Gray2>, Planes, 2;
    packed12: Packed12, Rgb444, Stream, 12;
}

formats! {
    index1: Index1,
    index1_lsb0: Lsb0<Index1>,
    binary: BinaryColor,
    binary_lsb0: Lsb0<BinaryColor>,
    index2: Index2,
    index2_lsb0: Lsb0<Index2>,
    gray2: Gray2,
    gray2_lsb0: Lsb0<Gray2>,
    index4: Index4,
    index4_lsb0: Lsb0<Index4>,
    gray4: Gray4,
    gray4_lsb0: Lsb0<Gray4>,
    index8: Index8,
    gray8: Gray8,
    rgb332: Rgb332,
    rgb444: Rgb444,
    rgb444_be: Be<Rgb444>,
    rgb555: Rgb555,
    bgr555: Bgr555,
    rgb565: Rgb565,
    bgr565: Bgr565,
    rgb555_be: Be<Rgb555>,
    bgr555_be: Be<Bgr555>,
    rgb565_be: Be<Rgb565>,
    bgr565_be: Be<Bgr565>,
    rgb666: Rgb666,
    bgr666: Bgr666,
    rgb888: Rgb888,
    bgr888: Bgr888,
    rgb666_be: Be<Rgb666>,
    bgr666_be: Be<Bgr666>,
    rgb888_be: Be<Rgb888>,
    bgr888_be: Be<Bgr888>,
    xrgb8888: Xrgb8888,
    xrgb8888_be: Be<Xrgb8888>,
}

fn every_law(kind: &dyn Kind) {
    every_run_is_its_pixels(kind);
    long_runs_are_their_pixels(kind);
    what_is_set_is_got(kind);
    areas_are_their_pixels(kind);
    views_and_clips_are_windows(kind);
    bands_are_the_whole(kind);
    shapes_are_their_pixels(kind);
    spans_of_colours_are_their_pixels(kind);
    floods_are_their_pixels(kind);
    pictures_in_rows_are_their_pixels(kind);
    blits_are_their_pixels(kind);
    every_phase_of_a_blit(kind);
    masks_are_their_pixels(kind);
    many_rows_at_once_are_their_pixels(kind);
    moves_are_their_pixels(kind);
    embedded_graphics_draws_pixels(kind);
    constructors_check(kind);
}

/// Memory of that many pixels, at any alignment, with or without gaps between the rows.
fn twin(rng: &mut Rng, kind: &dyn Kind, size: (u16, u16)) -> Naive {
    let (start, gap) = (rng.index(8), rng.pick(&[0, 0, 1, 2, 3, 5]));
    Naive::random(rng, kind.format(), size, start, gap)
}

/// Every `start..end` of a row, at every alignment of the memory, with even and odd strides.
fn every_run_is_its_pixels(kind: &dyn Kind) {
    let mut rng = Rng::new(50);
    let width = 27;
    for start in 0..8 {
        for gap in [0, 1, 2, 5] {
            let before = Naive::random(&mut rng, kind.format(), (width, 3), start, gap);
            let color = kind.format().random(&mut rng);
            for x0 in 0..i32::from(width) {
                for x1 in x0 + 1..=i32::from(width) {
                    let (mut twin, mut real) = (before.clone(), before.bytes.clone());
                    let y = rng.int(0, 2);
                    let area = Rect::new(x0, y, x1, y + 1);
                    twin.fill(area, color);
                    let mut frame = kind.open(&before, &mut real);
                    frame.fill_span(Span { y, x0, x1 }, color);
                    assert!(frame.colors(area).iter().all(|&c| c == color), "{area:?} reads back");
                    drop(frame);
                    twin.assert_same(&real, &|| format!("span {x0}..{x1} of row {y}"));
                }
            }
        }
    }
}

/// Runs long enough for words, blocks of words, and whatever else makes long runs fast.
fn long_runs_are_their_pixels(kind: &dyn Kind) {
    let mut rng = Rng::new(51);
    for _ in 0..300 {
        // The last: some 2,100 bytes.
        let width = rng.pick(&[64, 127, 300, 521, 16_900 / kind.format().bits as u16]);
        let mut twin = twin(&mut rng, kind, (width, 5));
        let mut real = twin.bytes.clone();
        let color = kind.format().random(&mut rng);
        let (x0, x1) = (rng.int(0, 70), rng.int(30, width.into()));
        let area = match rng.below(3) {
            0 => Rect::new(x0, rng.int(0, 4), x1, 5),
            1 => Rect::new(x0, 2, x1, 3),
            _ => Rect::new(0, rng.int(0, 4), width.into(), rng.int(1, 5)),
        };
        twin.fill(area, color);
        kind.open(&twin, &mut real).fill_area(area, color);
        twin.assert_same(&real, &|| format!("{area:?}"));
    }
}

fn what_is_set_is_got(kind: &dyn Kind) {
    let mut rng = Rng::new(52);
    for _ in 0..60 {
        let size = (rng.int(0, 20) as u16, rng.int(0, 5) as u16);
        let mut twin = twin(&mut rng, kind, size);
        let mut real = twin.bytes.clone();
        for _ in 0..40 {
            let (x, y, color) = (rng.int(-2, 21), rng.int(-2, 6), kind.format().random(&mut rng));
            let mut frame = kind.open(&twin, &mut real);
            assert_eq!(frame.get(Point::new(x, y)), twin.get(x, y), "({x}, {y}) before");
            frame.set(Point::new(x, y), color);
            twin.set(x, y, color);
            assert_eq!(frame.get(Point::new(x, y)), twin.get(x, y), "({x}, {y})");
            assert_eq!(frame.window(), twin.window(), "the window of a framebuffer is its screen");
            assert_eq!(frame.size(), Size::new(size.0.into(), size.1.into()), "its size too");
            assert_eq!(frame.stride(), twin.stride, "stride");
            drop(frame);
            twin.assert_same(&real, &|| format!("({x}, {y})"));
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

fn areas_are_their_pixels(kind: &dyn Kind) {
    let mut rng = Rng::new(53);
    for _ in 0..300 {
        let size = (rng.int(0, 40) as u16, rng.int(0, 9) as u16);
        let mut twin = twin(&mut rng, kind, size);
        let mut real = twin.bytes.clone();
        let (area, color) = (random_area(&mut rng), kind.format().random(&mut rng));
        let mut frame = kind.open(&twin, &mut real);
        let painted = match rng.below(4) {
            0 => {
                frame.clear(color);
                twin.window()
            }
            1 => {
                frame.fill_window(color);
                twin.window()
            }
            _ => {
                frame.fill_area(area, color);
                area
            }
        };
        drop(frame);
        twin.fill(painted, color);
        twin.assert_same(&real, &|| format!("{painted:?}"));
    }
}

/// A view starts at any pixel, even within a byte; a clip of a view is one too.
fn views_and_clips_are_windows(kind: &dyn Kind) {
    let mut rng = Rng::new(54);
    for i in 0..400 {
        let mut twin = twin(&mut rng, kind, (37, 8));
        let mut real = twin.bytes.clone();
        let (outer, inner, paint) = (random_area(&mut rng), random_area(&mut rng), random_area(&mut rng));
        let outer = if i < 37 { Rect { x0: i, x1: i + 9, ..outer } } else { outer };
        let color = kind.format().random(&mut rng);
        let mut frame = kind.open(&twin, &mut real);
        let mut view = frame.view(outer);
        let extent = |n: u32| n.min(65_535);
        assert_eq!(view.size(), Size::new(extent(outer.width()), extent(outer.height())), "size of {outer:?}");
        view.clipped(inner).fill_area(paint, color);

        // The view's (0, 0) is the top left corner of `outer`, and nothing outside of `outer` or its 65,535 is painted.
        let shown = |x: i32, y: i32| {
            let (vx, vy) = (i64::from(x) - i64::from(outer.x0), i64::from(y) - i64::from(outer.y0));
            let in_view = outer.contains(x, y) && vx < 65_535 && vy < 65_535;
            in_view.then_some((vx as i32, vy as i32))
        };
        let point = Point::new(rng.int(-3, 40), rng.int(-3, 9));
        let mut wanted = None;
        for (x, y) in pixels(twin.window()) {
            let Some((vx, vy)) = shown(x, y) else { continue };
            if inner.contains(vx, vy) && paint.contains(vx, vy) {
                twin.set(x, y, color);
            }
            if Point::new(vx, vy) == point {
                wanted = twin.get(x, y);
                twin.set(x, y, color);
            }
        }
        assert_eq!(view.get(point), wanted, "{point} in {outer:?}");
        view.set(point, color);
        drop(view);
        drop(frame);
        twin.assert_same(&real, &|| format!("view {outer:?} clip {inner:?} paint {paint:?} point {point}"));
    }
}

/// Shapes paint the pixels of their twins, whatever shortcut a framebuffer takes; through views too.
fn shapes_are_their_pixels(kind: &dyn Kind) {
    let mut rng = Rng::new(55);
    for _ in 0..400 {
        let mut twin = twin(&mut rng, kind, (45, 33));
        let mut real = twin.bytes.clone();
        let (shape, color) = (Shape::random(&mut rng), kind.format().random(&mut rng));
        let area = match rng.below(3) {
            0 => twin.window(),
            1 => Rect::new(rng.int(0, 20), rng.int(0, 15), rng.int(20, 45), rng.int(15, 33)),
            _ => Rect::new(rng.int(-9, 50), rng.int(-9, 40), rng.int(-9, 50), rng.int(-9, 40)),
        };
        let is_view = rng.one_in(2);
        let mut frame = kind.open(&twin, &mut real);
        let mut part = if is_view { frame.view(area) } else { frame.clipped(area) };
        part.draw(&shape, color);
        drop(part);
        drop(frame);
        let (dx, dy) = if is_view { (area.x0, area.y0) } else { (0, 0) };
        let window = area.intersection(twin.window());
        for (x, y) in shape.pixels(window.relative_to(dx, dy)) {
            twin.set(x + dx, y + dy, color);
        }
        twin.assert_same(&real, &|| format!("{shape:?} view {is_view} of {area:?}"));
    }
}

/// A scene drawn band by band is the scene.
fn bands_are_the_whole(kind: &dyn Kind) {
    let mut rng = Rng::new(56);
    let (width, height) = (41, 26);
    for _ in 0..12 {
        let shapes: Vec<_> = (0..5).map(|_| (Shape::random(&mut rng), kind.format().random(&mut rng))).collect();
        let mut whole = vec![0; kind.bytes(width, height).1];
        let mut frame = kind.packed(&mut whole, width, height).expect("the right size");
        for (shape, color) in &shapes {
            frame.draw(shape, *color);
        }
        let all = frame.colors(frame.window());
        let is_one_piece = kind.format().arrangement != Arrangement::Planes;
        drop(frame);
        let page = kind.format().page();
        for rows in [1, 2, 3, 7, 8, 16, 25, 26].into_iter().filter(|rows| page == 1 || rows % page == 0) {
            let (mut pieces, mut colors) = (vec![], vec![]);
            for start in (0..height).step_by(usize::from(rows)) {
                let end = height.min(start + rows);
                let mut memory = vec![0; kind.bytes(width, end - start).1];
                let mut band = kind.band(&mut memory, (width, height), start..end).expect("on the screen");
                assert_eq!(band.size(), Size::new(width.into(), height.into()), "a band has the size of its screen");
                assert_eq!(band.window(), Rect::new(0, start.into(), width.into(), end.into()), "and its own rows");
                for (shape, color) in &shapes {
                    band.draw(shape, *color);
                }
                colors.extend(band.colors(band.window()));
                drop(band);
                pieces.extend(memory);
            }
            assert!(colors == all, "{}: colours of bands of {rows} rows of {shapes:?}", kind.format().name);
            assert!(!is_one_piece || pieces == whole, "{}: bands of {rows} rows of {shapes:?}", kind.format().name);
        }
    }
}

/// Spans of colours, with and without holes; reading, editing and finding.
fn spans_of_colours_are_their_pixels(kind: &dyn Kind) {
    let mut rng = Rng::new(67);
    for _ in 0..400 {
        let mut twin = twin(&mut rng, kind, (45, 9));
        let mut real = twin.bytes.clone();
        let (x0, y) = (rng.int(-3, 44), rng.int(-1, 9));
        let span = Span { y, x0, x1: x0 + rng.int(0, 30) };
        let window = if rng.one_in(3) { random_area(&mut rng) } else { twin.window() };
        let seen = Rect::new(span.x0, y, span.x1, y.saturating_add(1)).intersection(window).intersection(twin.window());
        let before: Vec<u32> = pixels(seen).filter_map(|(x, y)| twin.get(x, y)).collect();
        let mut whole = kind.open(&twin, &mut real);
        let mut frame = whole.clipped(window);
        let what = || format!("{span:?} in {window:?}");
        assert_eq!(frame.read_span(span), before, "{}", what());
        let wanted = if rng.one_in(3) { kind.format().random(&mut rng) } else { before.first().copied().unwrap_or(0) };
        let first = before.iter().position(|&c| c == wanted).unwrap_or(before.len());
        let start = before.iter().rposition(|&c| c != wanted).map_or(0, |i| i + 1);
        let found = (!before.is_empty()).then(|| (seen.x0 + first as i32, seen.x0 + start as i32));
        assert_eq!(frame.find(span, wanted), found, "{wanted} in {}", what());
        if rng.one_in(2) {
            let some = |rng: &mut Rng| (!rng.one_in(3)).then(|| kind.format().random(rng));
            let all = rng.one_in(2);
            let colors: Vec<Option<u32>> =
                (0..30).map(|_| some(&mut rng).or_else(|| all.then(|| kind.format().random(&mut rng)))).collect();
            frame.write_some(span, &colors);
            for (x, y) in pixels(seen) {
                if let Some(color) = colors[(x - span.x0) as usize] {
                    twin.set(x, y, color);
                }
            }
        } else {
            let edit = |x: i32, old: u32| kind.format().color(old ^ (x as u32).wrapping_mul(0x9e37_79b9));
            frame.edit_span(span, &edit);
            for (x, y) in pixels(seen) {
                let old = twin.get(x, y).expect("inside");
                twin.set(x, y, edit(x, old));
            }
        }
        drop(frame);
        drop(whole);
        twin.assert_same(&real, &|| what());
    }
}

/// Flood fills against the spread of a colour, one neighbour at a time.
fn floods_are_their_pixels(kind: &dyn Kind) {
    let mut rng = Rng::new(68);
    for _ in 0..60 {
        let mut twin = twin(&mut rng, kind, (24, 12));
        let mut real = twin.bytes.clone();
        let [ground, wall, new] = [(); 3].map(|()| kind.format().random(&mut rng));
        for (x, y) in pixels(twin.window()) {
            twin.set(x, y, if rng.one_in(3) { wall } else { ground });
        }
        real.copy_from_slice(&twin.bytes);
        let window = Rect::new(rng.int(-2, 5), rng.int(-2, 4), rng.int(12, 30), rng.int(6, 14));
        let seed = (rng.int(-1, 24), rng.int(-1, 12));
        let boundary = rng.one_in(2).then_some(wall);
        let seen = window.intersection(twin.window());
        let old = seen.contains(seed.0, seed.1).then(|| twin.get(seed.0, seed.1)).flatten();
        let is_open = |c: u32| match boundary {
            Some(boundary) => c != boundary && c != new,
            None => Some(c) == old && c != new,
        };
        let mut open = vec![seed];
        while let Some((x, y)) = open.pop() {
            if seen.contains(x, y) && twin.get(x, y).is_some_and(is_open) {
                twin.set(x, y, new);
                open.extend([(x - 1, y), (x + 1, y), (x, y - 1), (x, y + 1)]);
            }
        }
        let slots = rng.index(6);
        kind.open(&twin, &mut real).clipped(window).flood(Point::new(seed.0, seed.1), boundary, slots, new);
        twin.assert_same(&real, &|| format!("{seed:?} in {window:?}, {boundary:?}, {slots} slots"));
    }
}

/// Pictures whose memory is arranged in another way than the frame's.
fn pictures_in_rows_are_their_pixels(kind: &dyn Kind) {
    let mut rng = Rng::new(69);
    for _ in 0..200 {
        let mut twin = twin(&mut rng, kind, (40, 7));
        let source =
            Naive::random(&mut rng, kind.format().arranged(Arrangement::Rows, kind.format().rows), (30, 6), 3, 1);
        let mut real = twin.bytes.clone();
        let (part, clip) = (random_area(&mut rng), random_area(&mut rng));
        let (part, clip) = if rng.one_in(2) { (source.window(), twin.window()) } else { (part, clip) };
        let at = Point::new(rng.int(-20, 40), rng.int(-5, 7));
        let key = key_of(&mut rng, &source);
        kind.open(&twin, &mut real).clipped(clip).blit_rows(at, &source, part, key);
        twin.blit(clip, at, &source, part, key);
        twin.assert_same(&real, &|| format!("{part:?} at {at} in {clip:?}, key {key:?}"));
    }
}

/// The colours of any area, and of rows of a format the bytes.
fn rows_read_out_are_their_pixels<F: PixelFormat>() {
    let mut rng = Rng::new(57);
    let kind = &Of::<Rows<F>, F>::rows();
    for _ in 0..200 {
        let size = (rng.int(0, 30) as u16, rng.int(0, 8) as u16);
        let twin = twin(&mut rng, kind, size);
        let mut real = twin.bytes.clone();
        let memory = &twin.bytes[twin.place.clone()];
        let frame = twin.frame::<Rows<F>>(&mut real);
        let area = random_area(&mut rng);
        let seen = area.intersection(twin.window());

        let wanted: Vec<u32> = pixels(seen).filter_map(|(x, y)| twin.get(x, y)).collect();
        assert_eq!(frame.colors(area).map(F::pack).collect::<Vec<_>>(), wanted, "colors of {area:?}");

        // From the byte of the first pixel to that of the last.
        let byte = |x: i32| x as usize * kind.format().bits;
        let rows = if seen.is_empty() { 0..0 } else { seen.y0 as usize..seen.y1 as usize };
        let row = |y: usize| y * twin.stride + byte(seen.x0) / 8..y * twin.stride + byte(seen.x1).div_ceil(8);
        let wanted: Vec<&[u8]> = rows.map(|y| &memory[row(y)]).collect();
        assert_eq!(frame.bytes(area).collect::<Vec<_>>(), wanted, "bytes of {area:?}");
        assert_eq!(twin.bitmap::<Rows<F>>().bytes(area).collect::<Vec<_>>(), wanted, "bytes of a bitmap, {area:?}");

        let (first, end) = (rng.int(0, 9) as u16, rng.int(0, 9) as u16);
        let at = |row: u16| (usize::from(row) * twin.stride).min(memory.len());
        let rows = if first <= end && end <= size.1 { &memory[at(first)..at(end)] } else { &[] };
        assert_eq!(frame.row_bytes(first..end), rows, "rows {first}..{end} of {}", size.1);

        let p = Point::new(rng.int(-2, 31), rng.int(-2, 9));
        assert_eq!(frame.place_of(p), twin.get(p.x, p.y).map(|_| (p.x as usize, p.y as usize)), "where {p} lies");
        assert_eq!(frame.memory(), memory, "all of it");
        let bitmap = kind.open(&twin, &mut twin.bytes.clone()).as_bitmap(p);
        assert_eq!(bitmap, (twin.get(p.x, p.y), frame.window(), frame.size()), "as a bitmap, {p}");
    }
}

/// A picture where one colour is frequent, so that keys hit; now and then a wide one.
fn picture(rng: &mut Rng, kind: &dyn Kind) -> Naive {
    let size = if rng.one_in(8) {
        (rng.int(200, 460) as u16, rng.int(1, 3) as u16)
    } else {
        (rng.int(0, 40) as u16, rng.int(0, 7) as u16)
    };
    let mut picture = twin(rng, kind, size);
    let key = kind.format().random(rng);
    for _ in 0..usize::from(size.0) * usize::from(size.1) / 2 {
        picture.set(rng.int(0, 39), rng.int(0, 6), key);
    }
    picture
}

/// A colour that `picture` has, or none.
fn key_of(rng: &mut Rng, picture: &Naive) -> Option<u32> {
    let (x, y) = (rng.int(0, 39), rng.int(0, 6));
    picture.get(x, y).filter(|_| rng.one_in(2))
}

/// From any pixel of a byte to any other, clipped on every side, with and without a key.
fn blits_are_their_pixels(kind: &dyn Kind) {
    let mut rng = Rng::new(58);
    for i in 0..900 {
        let (mut twin, source) = (picture(&mut rng, kind), picture(&mut rng, kind));
        let mut real = twin.bytes.clone();
        let key = key_of(&mut rng, &source);
        let (part, clip) =
            if i % 3 == 0 { (source.window(), twin.window()) } else { (random_area(&mut rng), random_area(&mut rng)) };
        let at = if rng.one_in(20) {
            Point::new(rng.bits() as i32, rng.pick(&[i32::MIN, i32::MAX, 0]))
        } else {
            Point::new(rng.int(-20, 40), rng.int(-5, 7))
        };
        kind.open(&twin, &mut real).clipped(clip).blit(at, &source, part, key);
        twin.blit(clip, at, &source, part, key);
        twin.assert_same(&real, &|| format!("{part:?} at {at} in {clip:?}, key {key:?}"));
    }
}

/// Every start within a byte on both sides, every short width, into a view.
fn every_phase_of_a_blit(kind: &dyn Kind) {
    let mut rng = Rng::new(64);
    let before = Naive::random(&mut rng, kind.format(), (40, 1), 3, 0);
    let source = Naive::random(&mut rng, kind.format(), (40, 1), 2, 0);
    for from in 0..9 {
        for to in 0..9 {
            for width in 1..28 {
                let (mut twin, mut real) = (before.clone(), before.bytes.clone());
                let part = Rect::new(from, 0, from + width, 1);
                let mut frame = kind.open(&before, &mut real);
                frame.view(Rect::new(to, 0, 40, 1)).blit(Point::new(0, 0), &source, part, None);
                drop(frame);
                twin.blit(before.window(), Point::new(to, 0), &source, part, None);
                twin.assert_same(&real, &|| format!("{width} pixels from {from} to {to}"));
            }
        }
    }
}

/// Masks in both bit orders, from any pixel of a byte to any other, clipped on every side, with and without a background.
fn masks_are_their_pixels(kind: &dyn Kind) {
    let mut rng = Rng::new(65);
    let formats = [Format::of::<Index1>(), Format::of::<Lsb0<Index1>>()];
    for i in 0..600 {
        let mut twin = picture(&mut rng, kind);
        let (start, gap) = (rng.index(4), rng.pick(&[0, 1, 3]));
        let mask = Naive::random(&mut rng, formats[i % 2], (40, 7), start, gap);
        let mut real = twin.bytes.clone();
        let off = rng.one_in(2).then(|| kind.format().random(&mut rng));
        let colors = (kind.format().random(&mut rng), off);
        let (part, clip) =
            if i % 3 == 0 { (mask.window(), twin.window()) } else { (random_area(&mut rng), random_area(&mut rng)) };
        let at = if rng.one_in(20) {
            Point::new(rng.bits() as i32, rng.pick(&[i32::MIN, i32::MAX, 0]))
        } else {
            Point::new(rng.int(-20, 40), rng.int(-5, 7))
        };
        kind.open(&twin, &mut real).clipped(clip).blit_mask(at, &mask, part, colors.0, colors.1);
        twin.blit_mask(clip, at, &mask, part, colors);
        twin.assert_same(&real, &|| format!("{part:?} of a mask at {at} in {clip:?}, {colors:?}"));
    }
}

/// Wide rows and high columns: with every other gap they are whole words apart, and what is done for many rows at once is
/// done.
fn many_rows_at_once_are_their_pixels(kind: &dyn Kind) {
    let mut rng = Rng::new(65);
    let memory = |rng: &mut Rng, size: (u16, u16)| {
        let row = kind.format().row_bytes(size.0.into());
        let (start, gap) = (rng.index(8), rng.pick(&[1, row.wrapping_neg() % 4]));
        Naive::random(rng, kind.format(), size, start, gap)
    };
    for _ in 0..300 {
        let size = |rng: &mut Rng| (rng.int(1, 150) as u16, rng.int(1, 5) as u16);
        let (to_size, from_size) = (size(&mut rng), size(&mut rng));
        let (mut twin, source) = (memory(&mut rng, to_size), memory(&mut rng, from_size));
        let mut real = twin.bytes.clone();
        let at = Point::new(rng.int(-9, 20), rng.int(-1, 2));
        kind.open(&twin, &mut real).blit(at, &source, source.window(), None);
        twin.blit(twin.window(), at, &source, source.window(), None);
        twin.assert_same(&real, &|| format!("{from_size:?} to {to_size:?} at {at}"));
    }
    for _ in 0..100 {
        let size = (rng.int(2, 30) as u16, rng.int(1, 40) as u16);
        let mut twin = memory(&mut rng, size);
        let mut real = twin.bytes.clone();
        let (x, y0, y1) = (rng.int(0, 29), rng.int(-1, 9), rng.int(5, 40));
        let (area, color) = (Rect::new(x, y0, x + 1, y1), kind.format().random(&mut rng));
        kind.open(&twin, &mut real).fill_area(area, color);
        twin.fill(area, color);
        twin.assert_same(&real, &|| format!("column {area:?} of {size:?}"));
    }
}

/// Up, down, left, right, by less than a pixel row and by more than the area, near and at the ends of `i32`.
fn moves_are_their_pixels(kind: &dyn Kind) {
    let mut rng = Rng::new(59);
    for _ in 0..900 {
        let mut twin = picture(&mut rng, kind);
        // Then wider than what is taken up at once.
        let is_wide = twin.width > 100;
        let mut real = twin.bytes.clone();
        let clip = if rng.one_in(3) { random_area(&mut rng) } else { twin.window() };
        let near = |rng: &mut Rng, n: i32| n.saturating_add(rng.int(-9, 9));
        let area = if rng.one_in(2) {
            let (x, y) = (rng.int(-3, 20), rng.int(-3, 5));
            Rect::new(x, y, x + rng.int(0, if is_wide { 440 } else { 24 }), y + rng.int(0, 6))
        } else {
            random_area(&mut rng)
        };
        let to = Point::new(near(&mut rng, area.x0), near(&mut rng, area.y0));
        let key = key_of(&mut rng, &twin);
        kind.open(&twin, &mut real).clipped(clip).move_area(area, to, key);
        twin.move_area(clip, area, to, key);
        twin.assert_same(&real, &|| format!("{area:?} to {to} in {clip:?}, key {key:?}"));
    }
}

/// What embedded-graphics calls: single pixels, solid and many-coloured rectangles, reading.
fn embedded_graphics_draws_pixels(kind: &dyn Kind) {
    let mut rng = Rng::new(60);
    for _ in 0..300 {
        let mut twin = twin(&mut rng, kind, (21, 9));
        let mut real = twin.bytes.clone();
        let corner = Point::new(rng.int(-8, 24), rng.int(-8, 11));
        let area = Rectangle::new(corner, Size::new(rng.below(30) as u32, rng.below(14) as u32));
        let places = pixels(Rect::from(area)).map(|(x, y)| Point::new(x, y));
        let colors: Vec<u32> = (0..rng.index(450)).map(|_| kind.format().random(&mut rng)).collect();
        let mut list: Vec<(Point, u32)> = places.zip(colors.iter().copied()).collect();
        let window = Rect::new(rng.int(0, 4), rng.int(0, 3), 21, 9);

        let mut frame = kind.open(&twin, &mut real);
        let mut view = frame.view(window);
        match rng.below(3) {
            0 => view.fill_contiguous(&area, &colors),
            1 => {
                rng.shuffle(&mut list);
                view.draw_iter(&list);
            }
            _ => {
                let color = kind.format().random(&mut rng);
                view.fill_solid(&area, color);
                list = pixels(Rect::from(area)).map(|(x, y)| (Point::new(x, y), color)).collect();
            }
        }
        for &(p, color) in &list {
            twin.set_in(window, p, color);
        }
        let p = Point::new(rng.int(-2, 22), rng.int(-2, 10));
        let (x, y) = (p.x + window.x0, p.y + window.y0);
        assert_eq!(view.pixel(p), twin.get(x, y).filter(|_| window.contains(x, y)), "pixel {p}");
        drop(view);
        drop(frame);
        twin.assert_same(&real, &|| format!("{area:?} with {} colours", colors.len()));
    }
}

/// The numbers in the errors are the ones that a caller can compute.
fn constructors_check(kind: &dyn Kind) {
    let mut rng = Rng::new(61);
    let enough = |needed: usize, given: usize| {
        if given < needed {
            Err(BufferError::TooSmall { needed, given })
        } else {
            Ok(())
        }
    };
    let page = kind.format().page();
    for _ in 0..500 {
        let side = |rng: &mut Rng| rng.pick(&[0, 1, 2, 7, 8, 9, 33, 255, 65_535]);
        let (width, height): (u16, u16) = (side(&mut rng), side(&mut rng));
        let row = kind.format().row_bytes(width.into());
        let bytes = |rows: u16, stride: usize| kind.format().bytes(width.into(), rows.into(), stride);
        assert_eq!(kind.bytes(width, height), (row, bytes(height, row)), "bytes of {width} x {height}");
        let given = rng.index(600);
        let mut memory = vec![0xa5; given];

        let stride = (row + rng.index(5)).saturating_sub(rng.index(5));
        let needed = bytes(height, stride);
        let narrow = Err(BufferError::StrideTooSmall { needed: row, given: stride });
        let wanted = if stride < row { narrow } else { enough(needed, given) };
        assert_eq!(kind.strided(&mut memory, width, height, stride), wanted, "{width} x {height}, stride {stride}");
        assert_eq!(kind.strided_bitmap(&memory, width, height, stride), wanted, "and a bitmap");

        let wanted = enough(bytes(height, row), given);
        assert_eq!(kind.packed(&mut memory, width, height).map(|_| ()), wanted, "{width} x {height}");
        assert_eq!(kind.packed_bitmap(&memory, width, height), wanted, "and a bitmap");

        let (start, end) = (side(&mut rng), side(&mut rng));
        let wanted = if start > end || end > height {
            Err(BufferError::BandOutsideScreen { start, end, height })
        } else if !(start.is_multiple_of(page) && (end == height || end.is_multiple_of(page))) {
            Err(BufferError::BandSplitsPage { start, end, page })
        } else {
            enough(bytes(end - start, row), given)
        };
        let band = kind.band(&mut memory, (width, height), start..end).map(|_| ());
        assert_eq!(band, wanted, "band {start}..{end} of {width} x {height}");
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
    assert_eq!(bytes::<Rgb444>(&[Rgb444::new(1, 2, 3), Rgb444::WHITE]), [0x23, 0x01, 0xff, 0x0f]);
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
    assert_eq!((Rgb444::BITS, <Be<Rgb444>>::BITS), (16, 16));
    assert_eq!([Rgb555::BITS, Bgr555::BITS, Rgb565::BITS, <Be<Bgr565>>::BITS], [16; 4]);
    assert_eq!([Rgb666::BITS, Bgr666::BITS, Rgb888::BITS, <Be<Bgr888>>::BITS], [24; 4]);
    assert_eq!([Xrgb8888::BITS, <Be<Xrgb8888>>::BITS], [32; 2]);
}

/// What displays are sent of pages and of planes.
#[test]
fn pages_and_planes_read_out_are_their_bytes() {
    let mut rng = Rng::new(62);
    for _ in 0..1_000 {
        let (width, height) = (rng.int(0, 20) as u16, rng.int(0, 30) as u16);
        let mut bytes: Vec<u8> = (0..paged_bytes(width, height) + 5).map(|_| rng.bits() as u8).collect();
        let all = bytes.clone();
        let oled = Paged::<Index1>::new(&mut bytes, width, height).expect("the right size");
        let (first, end) = (rng.below(6) as u16, rng.below(6) as u16);
        let inside = first <= end && end <= height.div_ceil(8);
        let width = usize::from(width);
        let pages = if inside { &all[usize::from(first) * width..usize::from(end) * width] } else { &[] };
        assert_eq!(oled.page_bytes(first..end), pages, "pages {first}..{end} of {height} rows");
    }
    let memory: Vec<u8> = (0..12).collect();
    let paper = Frame::<_, Planes<Index2>>::new(&memory[..], 9, 3).expect("the right size");
    assert_eq!([0, 1, 2].map(|i| paper.plane_bytes(i)), [&memory[..6], &memory[6..], &[]]);
}

#[test]
fn paged_memory_checks_its_size() {
    assert_eq!([paged_bytes(128, 64), paged_bytes(5, 9), paged_bytes(5, 0), paged_bytes(0, 9)], [1024, 10, 0, 0]);
    let mut memory = [0; 9];
    let error = Paged::<BinaryColor>::new(&mut memory, 5, 9).map(|_| ()).expect_err("one byte is missing");
    assert_eq!(error, BufferError::TooSmall { needed: 10, given: 9 });
}

#[test]
fn a_counter_counts_what_a_framebuffer_paints() {
    let mut rng = Rng::new(63);
    let window = Rect::new(0, 0, 45, 33);
    for _ in 0..3_000 {
        let shape = Shape::random(&mut rng);
        let mut counter = Counter::<Gray8>::new(window);
        shape.draw(&mut counter, Gray8::new(1));
        assert_eq!(counter.pixels, shape.pixels(window).len() as u64, "{shape:?}");
        assert_eq!(counter.window(), window);
    }
}

/// Formats that are indices or have few bits, through every expansion to every way of storing the output.
mod palettes {
    use super::*;
    use embedded_raster::{pixel::EGA, Palette};

    /// A way to expand, behind colours that are bits: `(table, indices, out)`.
    type Expand<'a> = &'a dyn Fn(&[u32], &[u8], &mut [u8]);

    /// A table of `entries` random colours, indices and room for pixels of any length, against pixel after pixel.
    fn check(rng: &mut Rng, index: Format, output: Format, entries: usize, expand: Expand<'_>) {
        for _ in 0..60 {
            let table: Vec<u32> = (0..entries).map(|_| output.random(rng)).collect();
            let indices: Vec<u8> = (0..rng.index(40)).map(|_| rng.bits() as u8).collect();
            let longest = indices.len() * output.bits / index.bits;
            let length = if rng.one_in(3) { longest } else { rng.index(longest + 9) };
            let (start, around) = (rng.index(5), 8);
            let before: Vec<u8> = (0..start + length + around).map(|_| rng.bits() as u8).collect();
            let (mut wanted, mut got) = (before.clone(), before);
            expand(&table, &indices, &mut got[start..start + length]);
            for x in 0..(indices.len() * 8 / index.bits).min(length * 8 / output.bits) {
                let color = table.get(index.read(&indices, 0, x) as usize).or(table.first());
                output.write(&mut wanted, start, x, color.copied().unwrap_or(0));
            }
            let what = || format!("{} bytes of {} to {length} of {}", indices.len(), index.name, output.name);
            assert_eq!(got, wanted, "{} through {entries} colours", what());
        }
    }

    fn check_table<I: PixelFormat, O: PixelFormat, const N: usize>(rng: &mut Rng) {
        check(rng, Format::of::<I>(), Format::of::<O>(), N, &|table, indices, out| {
            let colors = core::array::from_fn(|i| O::unpack(table[i]));
            Palette::<O::Color, N>::new(colors).expand::<I, O>(indices, out);
        });
    }

    /// From every format of indices.
    fn check_output<O: PixelFormat>(rng: &mut Rng) {
        check_table::<Index1, O, 2>(rng);
        check_table::<Lsb0<Index1>, O, 2>(rng);
        check_table::<Index2, O, 4>(rng);
        check_table::<Lsb0<Index2>, O, 4>(rng);
        check_table::<Index4, O, 16>(rng);
        check_table::<Lsb0<Index4>, O, 16>(rng);
        check_table::<Index8, O, 256>(rng);
    }

    #[test]
    fn expansion_is_pixel_after_pixel() {
        let mut rng = Rng::new(70);
        check_output::<BinaryColor>(&mut rng);
        check_output::<Lsb0<Gray2>>(&mut rng);
        check_output::<Gray4>(&mut rng);
        check_output::<Gray8>(&mut rng);
        check_output::<Rgb565>(&mut rng);
        check_output::<Be<Rgb565>>(&mut rng);
        check_output::<Rgb888>(&mut rng);
        check_output::<Be<Rgb666>>(&mut rng);
        check_output::<Xrgb8888>(&mut rng);
        check_output::<Be<Xrgb8888>>(&mut rng);
    }

    /// Tables that do not have every index, and tables that have more.
    #[test]
    fn expansion_through_short_and_long_tables() {
        let mut rng = Rng::new(71);
        check_table::<Index1, Gray8, 1>(&mut rng);
        check_table::<Index4, Rgb565, 9>(&mut rng);
        check_table::<Index8, Rgb888, 216>(&mut rng);
        check_table::<Index8, Rgb332, 0>(&mut rng);
        check_table::<Index2, Bgr555, 0>(&mut rng);
        check_table::<Index2, Gray4, 3>(&mut rng);
        check_table::<Index1, Xrgb8888, 256>(&mut rng);
        check_table::<Index4, Rgb565, 300>(&mut rng);
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
        let c = Rgb444::new(0x21, 0x32, 0x43);
        assert_eq!((c.r(), c.g(), c.b()), (1, 2, 3), "channels are cut to the bits they have");
        assert_eq!(Rgb888::from(c), Rgb888::new(17, 34, 51));
        assert_eq!(Rgb444::from(Rgb888::new(25, 26, 255)), Rgb444::new(1, 2, 15), "to nearest");
        let c = Rgb332::new(255, 254, 253);
        assert_eq!((c.r(), c.g(), c.b()), (7, 6, 1), "channels are cut to the bits they have");
        assert_eq!(Rgb332::WHITE, Rgb332::new(7, 7, 3));
        assert_eq!([Rgb332::MAX_R, Rgb332::MAX_G, Rgb332::MAX_B], [7, 7, 3]);
        assert_eq!(Rgb888::from(Rgb332::YELLOW), Rgb888::YELLOW);
        assert_eq!(Rgb565::from(Xrgb8888::CYAN), Rgb565::CYAN);
    }
}
