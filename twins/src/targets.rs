//! What the fuzz targets `shading`, `pipeline`, `texture`, `coverage`, `svg` and `packed` check, out of bytes of any kind:
//! `tests/targets.rs` gives them random
//! ones.

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{BinaryColor, Gray8, GrayColor, Rgb565, Rgb888, RgbColor},
};
use embedded_raster::{
    geom::{At, Facet, Perspective, Plane, Varying},
    paint::{depth, Add, Cover, Masked},
    pipeline::{Dot, Pipeline, Vertex},
    pixel::Depth16,
    raster::coverage,
    surface::{
        texture::{AddressMode, Clamp, Mirror, Repeat, Texture},
        Accumulator, DepthBuffer, Rows, Sum,
    },
    Antialias, Bitmap, Canvas, CoverageSlot, EdgeSlot, FillRule, Frame, Framebuffer, Path, PointFx, Rect, Vec4,
};
use fixed::types::{I16F16, I24F8};

use super::{
    clipping,
    coverage::{area, Levels, PIXEL},
    hits::Hits,
    input::Input,
    lines, packed, planes, svgs, textures, triangle_has, Units,
};

fn places<const N: usize>(units: [Units; N]) -> [PointFx; N] {
    units.map(|(x, y)| PointFx::from_bits(x, y))
}

/// Values and depths over a triangle and along a line, against exact ratios at every pixel.
pub fn shading(data: &[u8]) {
    let mut input = Input(data);
    let window = input.window();
    let mut place = || if input.one_in(8) { (input.int(), input.int()) } else { input.place_near(window) };
    let units = [place(), place(), place()];
    let mut values = || [input.int(), input.int(), input.int()];
    let [a, b, c] = [values(), values(), values()];
    triangle(units, window, a, |n| n as u8, i64::from);
    triangle(units, window, b, |n| n as u16, i64::from);
    triangle(units, window, c, |n| n, i64::from);
    line([units[0], units[1]], window, a, |n| n as u8, i64::from);
    line([units[1], units[2]], window, b, |n| n as i16, i64::from);
    line([units[2], units[0]], window, c, |n| n as u32, i64::from);
    depths([units[0], units[1]], units, [a, b]);
}

/// A triangle whose values are made of numbers, and are numbers again.
fn triangle<V: Varying>(units: [Units; 3], window: Rect, n: [i32; 3], value: fn(i32) -> V, number: fn(V) -> i64) {
    let values = n.map(value);
    let mut got = vec![];
    let result = Hits::new(window).shade_triangle_fx(
        places(units),
        values.map(|value| (At::default(), value)),
        |(at, value)| {
            got.push((at.0, i128::from(number(value))));
            BinaryColor::On
        },
    );
    if result.is_err() {
        return assert!(Facet::new(places(units)).is_err() && got.is_empty(), "{units:?} is too large and shaded");
    }
    let mut pixels = (window.y0..window.y1).flat_map(|y| (window.x0..window.x1).map(move |x| (x, y)));
    let wanted: Vec<_> = pixels
        .by_ref()
        .filter(|&(x, y)| triangle_has(units, x, y))
        .map(|(x, y)| (Point::new(x, y), planes::nearest(units, values.map(number), x, y)))
        .collect();
    assert_eq!(got, wanted, "{units:?} in {window:?}");
    perspective(units, window, n);
}

/// What is seen in perspective stays in the range of the corners.
fn perspective(units: [Units; 3], window: Rect, n: [i32; 3]) {
    let Ok(facet) = Facet::new(places(units)) else { return };
    let plane = Plane::new(&facet, n.map(|n| Perspective { w: I16F16::from_bits(n.rotate_left(7)), value: n as u8 }));
    let range = n.map(|n| n as u8);
    let (least, most) = (range.iter().min().expect("three"), range.iter().max().expect("three"));
    for (x, y) in (window.y0..window.y1).flat_map(|y| (window.x0..window.x1).map(move |x| (x, y))) {
        if triangle_has(units, x, y) {
            let value = plane.at(x, y).value;
            assert!((least..=most).contains(&&value), "{value} of {range:?} at {x}, {y} of {units:?}");
        }
    }
}

fn line<V: Varying>(
    [a, b]: [Units; 2],
    window: Rect,
    [first, last, _]: [i32; 3],
    value: fn(i32) -> V,
    number: fn(V) -> i64,
) {
    let values = [first, last].map(value);
    let mut got = vec![];
    let result =
        Hits::new(window).shade_line_fx(places([a, b]), values.map(|value| (At::default(), value)), |(at, value)| {
            got.push((at.0.y, at.0.x, i128::from(number(value))));
            BinaryColor::On
        });
    if result.is_err() {
        return assert!(got.is_empty(), "{a:?} to {b:?} is too long and shaded");
    }
    let nearest = |pixel| lines::nearest_along(a, b, values.map(number), pixel);
    let mut wanted: Vec<_> = lines::line_fx(a, b, window).into_iter().map(|(x, y)| (y, x, nearest((x, y)))).collect();
    wanted.sort_unstable();
    got.sort_unstable();
    assert_eq!(got, wanted, "{a:?} to {b:?} in {window:?}");
}

/// A triangle and a line that hide each other, against a loop over pixels.
fn depths([a, b]: [Units; 2], units: [Units; 3], [n, m]: [[i32; 3]; 2]) {
    let (line_depths, depths) = ([n[0], n[1]].map(|n| n as u16), m.map(|m| m as u16));
    let (mut ram, mut depth_ram) = ([0; 16 * 16], [0x7f; 16 * 16 * 2]);
    let mut frame = Framebuffer::<Gray8>::new(&mut ram, 16, 16).expect("the right size");
    let mut buffer = DepthBuffer::<Depth16>::new(&mut depth_ram, 16, 16).expect("the right size");
    let near = |(x, y): Units| (x.rem_euclid(6_000) - 1_000, y.rem_euclid(6_000) - 1_000);
    let (a, b, units) = (near(a), near(b), units.map(near));
    let drawn = frame
        .depth_triangle_fx(places(units), depths.map(|d| (d, ())), &mut buffer, depth::less, |()| Gray8::new(1))
        .and_then(|()| {
            let ends = line_depths.map(|d| (d, ()));
            frame.depth_line_fx(places([a, b]), ends, &mut buffer, depth::less_equal, |()| Gray8::new(2))
        });
    drawn.expect("both are small");
    let pixels = lines::line_fx(a, b, Rect::new(0, 0, 16, 16));
    for (x, y) in (0..16).flat_map(|y| (0..16).map(move |x| (x, y))) {
        let (mut color, mut nearest) = (0, 0x7f7f);
        if triangle_has(units, x, y) {
            let depth = planes::nearest(units, depths.map(i64::from), x, y);
            (color, nearest) = if depth < nearest { (1, depth) } else { (color, nearest) };
        }
        if pixels.contains(&(x, y)) {
            let depth = lines::nearest_along(a, b, line_depths.map(i64::from), (x, y));
            (color, nearest) = if depth <= nearest { (2, depth) } else { (color, nearest) };
        }
        let at = Point::new(x, y);
        assert_eq!(frame.get(at).map(|c| c.luma()), Some(color), "{units:?}, {a:?} to {b:?} at {at}");
        assert_eq!(buffer.get(at).map(|d| i128::from(d.0)), Some(nearest), "{units:?}, {a:?} to {b:?} at {at}");
    }
}

/// Triangles, lines and points of any bits through the pipeline: corners are those of exact ratios, no pixel of a triangle is painted
/// twice, and none outside.
pub fn pipeline(data: &[u8]) {
    let mut input = Input(data);
    let side = |input: &mut Input<'_>| (input.int().unsigned_abs() % 4_097) as u16;
    let size = if input.byte() & 1 == 0 { (48, 36) } else { (side(&mut input), side(&mut input)) };
    let pipeline = Pipeline::new(size.0, size.1).unwrap();
    let mut corner = || {
        let w = if input.one_in(4) { input.int() } else { input.int() & 0x3_ffff };
        let mut part = || if input.one_in(4) { input.int() } else { input.int() & 0x7_ffff };
        Vertex::new(Vec4::from_bits([part(), part(), part(), w]), input.int())
    };
    let triangle = [corner(), corner(), corner()];
    let bits = triangle.map(|corner| corner.position.to_bits());
    let numbers = |vertex: &Vertex<i32>| {
        let [x, y, z, w] = vertex.position.to_bits().map(i64::from);
        [x, y, z, w, vertex.values.into()]
    };
    let between = |weights: [i128; 3]| -> [i64; 5] {
        let all = triangle.each_ref().map(numbers);
        core::array::from_fn(|i| clipping::mean(weights, all.map(|numbers| numbers[i])))
    };
    let left: Vec<_> = clipping::corners(bits, size).into_iter().map(between).collect();
    let window = Rect::new(0, 0, size.0.min(48).into(), size.1.min(36).into());
    let mut hits = Hits::new(window);
    pipeline.triangles(
        [triangle],
        |vertex| vertex,
        |piece| {
            for corner in piece.corners().each_ref().map(numbers) {
                assert!(left.contains(&corner), "{triangle:?} {size:?}: {corner:?} is none of {left:?}");
            }
            piece.fill(&mut hits, |_| Some(BinaryColor::On));
        },
    );
    for (x, y) in (window.y0..window.y1).flat_map(|y| (window.x0..window.x1).map(move |x| (x, y))) {
        assert!(hits.count(x, y) <= 1, "{bits:?} {size:?}: {x}, {y} is painted {} times", hits.count(x, y));
    }
    let ends = [triangle[0], triangle[1]];
    let left = clipping::line([bits[0], bits[1]], size);
    let (mut ram, mut depth_ram) = ([0; 48 * 36], [0x80; 48 * 36 * 2]);
    let mut frame = Framebuffer::<Gray8>::new(&mut ram, 48, 36).expect("the right size");
    let mut buffer = DepthBuffer::<Depth16>::new(&mut depth_ram, 48, 36).expect("the right size");
    pipeline.lines(
        [ends],
        |vertex| vertex,
        |line| {
            let wanted = left.expect("something is left").map(|[a, b]| between([a, b, 0]));
            assert_eq!(line.ends().each_ref().map(numbers), wanted, "{ends:?} {size:?}");
            line.draw_depth(&mut frame, &mut buffer, depth::less, |fragment| Some(Gray8::new(fragment.values as u8)));
        },
    );
    let dot = I24F8::from_bits(input.int());
    let dot = if input.byte() & 1 == 0 { Dot::Round(dot) } else { Dot::Square(dot) };
    pipeline.points(
        triangle,
        |vertex| vertex,
        |point| {
            point.draw_depth(dot, &mut frame, &mut buffer, depth::less, |fragment| {
                Some(Gray8::new(fragment.values as u8))
            });
        },
    );
}

/// What polygons cover, against exact areas at every pixel, with little memory and with enough; and what paints make of it behind a mask,
/// and added up.
pub fn coverage(data: &[u8]) {
    let mut input = Input(data);
    let window = input.window();
    let (slots, cells) = (input.index(20), input.index(60));
    let corners = 3 + input.index(6);
    let contour: Vec<Units> = (0..corners)
        .map(|_| if input.one_in(8) { (input.int(), input.int()) } else { input.place_near(window) })
        .collect();
    let rule = if input.byte() & 1 == 0 { FillRule::NonZero } else { FillRule::EvenOdd };
    let vertices = super::vertices(&contour);
    let told = |slots: usize, cells: usize| {
        let (mut table, mut cells) = (vec![CoverageSlot::EMPTY; slots], vec![0x1234_5678; cells]);
        let mut levels = Levels::new(window);
        let result = coverage::fill([&vertices], rule, &mut table, &mut cells, window, &mut levels);
        assert!(result.is_ok() || levels.calls == 0, "something was told before {result:?}");
        result.is_ok().then_some(levels)
    };
    let enough = told(corners, 80).expect("a slot for each side is enough");
    if let Some(few) = told(slots, cells) {
        assert!(few.levels == enough.levels, "{slots} slots and {cells} cells: {contour:?} in {window:?}");
    }
    let contours = [contour];
    let pixels = || (window.y0..window.y1).flat_map(|y| (window.x0..window.x1).map(move |x| (x, y)));
    for (x, y) in pixels() {
        let (exact, found) = (area(&contours, rule, (x, y)), i128::from(enough.at(x, y)));
        let error = (exact * 255 - found * PIXEL).abs() * 1_000_000 / PIXEL;
        assert!(error <= 500_000 + 8_300 * corners as i128, "{error} millionths at ({x}, {y}): {contours:?}");
        let tiny = corners as i128;
        assert!(exact > tiny || found == 0, "an empty pixel is tinted: ({x}, {y}) of {contours:?}");
        assert!(exact < PIXEL - tiny || found == 255, "a full pixel is tinted: ({x}, {y}) of {contours:?}");
    }
    behind_a_mask(&mut input, &vertices, rule);
}

/// A polygon behind a mask of random levels, and the same one added up over a ground.
fn behind_a_mask(input: &mut Input<'_>, vertices: &[PointFx], rule: FillRule) {
    let window = Rect::new(0, 0, 16, 12);
    let (mut table, mut cells) = (vec![CoverageSlot::EMPTY; vertices.len()], [0; 20]);
    let mut levels = Levels::new(window);
    coverage::fill([vertices], rule, &mut table, &mut cells, window, &mut levels).expect("enough slots");
    let (mut ram, mut shades, mut memory) = ([9; 16 * 12], [0; 16 * 12], [Sum::EMPTY; 16 * 12]);
    shades.fill_with(|| input.byte());
    let mask = Bitmap::<Gray8>::new(&shades, 16, 12).expect("the right size");
    let (color, old) = (input.byte(), input.byte());
    let mut frame = Framebuffer::<Gray8>::new(&mut ram, 16, 12).expect("the right size");
    frame.clear(Gray8::new(old));
    let paint = Masked::new(mask, Cover(Gray8::new(color)));
    frame.fill_polygon_aa(vertices, rule, &mut table, &mut cells, paint).expect("enough slots");
    let mut sums = Accumulator::new(&mut memory, window).expect("the right size");
    let add = Add(Rgb888::new(color, color, color));
    sums.fill_polygon_aa(vertices, rule, &mut table, &mut cells, add).expect("enough slots");
    // Of `all`, which is odd, so much is the new colour.
    let mean = |part: u32, all: u32| (2 * (u32::from(old) * (all - part) + u32::from(color) * part) + all) / (2 * all);
    for (x, y) in (0..12).flat_map(|y| (0..16).map(move |x| (x, y))) {
        let (level, through) = (u32::from(levels.at(x, y)), u32::from(shades[(y * 16 + x) as usize]));
        let wanted = mean((2 * level * through + 255) / 510, 255);
        let got = frame.get((x, y)).expect("a pixel").luma();
        assert_eq!(u32::from(got), wanted, "({x}, {y}), covered by {level}, let through by {through}");
        let wanted = if level == 254 { u32::from(color) } else { mean(level, 255) };
        let got = sums.at(x, y).over(Gray8::new(old)).luma();
        assert_eq!(u32::from(got), wanted, "the sum at ({x}, {y}), covered by {level}");
    }
}

/// Texels at any place of a picture, against a sum over four of them.
pub fn texture(data: &[u8]) {
    let mut input = Input(data);
    let (width, height) = (u16::from(input.byte() % 20) + 1, u16::from(input.byte() % 12) + 1);
    let mut ram = vec![0; usize::from(width) * usize::from(height) * 2];
    for byte in &mut ram {
        *byte = input.byte();
    }
    let picture = Frame::<_, Rows<Rgb565>>::new(&ram[..], width, height).expect("the right size");
    for _ in 0..8 {
        let (u, v) = (input.wild().wrapping_shl(input.byte().into()), input.wild().wrapping_shl(input.byte().into()));
        sample(&picture, (u, v), (Clamp, Repeat), [0, 1]);
        sample(&picture, (u, v), (Mirror, Clamp), [2, 0]);
        sample(&picture, (u, v), (Repeat, Mirror), [1, 2]);
    }
}

fn sample<U: AddressMode, V: AddressMode>(
    picture: &Frame<&[u8], Rows<Rgb565>>,
    (u, v): (i32, i32),
    modes: (U, V),
    outside: [usize; 2],
) {
    let texture = Texture::new(picture, modes).expect("it has texels");
    let Rect { x1: width, y1: height, .. } = picture.window();
    let texel = |i: i64, j: i64| {
        let x = textures::column(i, width.into(), outside[0]) as i32;
        picture.get(Point::new(x, textures::column(j, height.into(), outside[1]) as i32)).expect("it is inside")
    };
    let fixed = (I16F16::from_bits(u), I16F16::from_bits(v));
    let (u, v) = (i64::from(u), i64::from(v));
    assert_eq!(texture.nearest(fixed.0, fixed.1), texel(u >> 16, v >> 16), "{u}, {v} of {width} x {height}");
    let level = |of: fn(Rgb565) -> u8| textures::bilinear(u, v, |i, j| of(texel(i, j)).into()) as u8;
    let wanted = Rgb565::new(level(|c| c.r()), level(|c| c.g()), level(|c| c.b()));
    assert_eq!(texture.bilinear(fixed.0, fixed.1), wanted, "{u}, {v} of {width} x {height} {outside:?}");
    let key = texel(0, 0);
    let nearest = Some(texel(u >> 16, v >> 16)).filter(|&color| color != key);
    assert_eq!(texture.nearest_keyed(fixed.0, fixed.1, key), nearest, "{u}, {v} of {width} x {height}, key {key:?}");
}

/// Any text as SVG path data, and what of it makes sense, against another reader.
pub fn svg(data: &[u8]) {
    /// Letters of path data, so that more of a text makes sense.
    const LETTERS: &[u8; 64] = b"MmLlHhVvCcSsQqTtAaZz01234567890123456789....----++eE,,      \n\tMZ";
    let text = String::from_utf8_lossy(data);
    svgs::check(&text);
    let text: String = data.iter().map(|&byte| char::from(LETTERS[usize::from(byte & 63)])).collect();
    for text in [format!("M1 2{text}"), text] {
        if !svgs::check(&text) {
            let end = Path::svg(&text).map_or_else(|error| error.position, |_| text.len());
            let letter = |c: char| c.is_ascii_alphabetic() && !matches!(c, 'e' | 'E');
            svgs::check(&text[..text[..end].rfind(letter).unwrap_or(0)]);
        }
    }
}

/// Any bytes as a packed path, and those that make sense of them, against their table and as they are drawn.
pub fn packed(data: &[u8]) {
    packed_path(data);
    let mut bytes = data.to_vec();
    if let [fraction, first, ..] = &mut bytes[..] {
        (*fraction, *first) = (*fraction % 9, 32 | *first & 31);
    }
    if let Some(end) = packed_path(&bytes) {
        bytes.truncate(end);
        packed_path(&bytes);
    }
}

/// Where a packed path makes no sense.
fn packed_path(bytes: &[u8]) -> Option<usize> {
    let (got, wanted) = (Path::packed(bytes), packed::read(bytes));
    let path = match (got, wanted) {
        (Ok(path), Ok(wanted)) => {
            assert!(path.iter().eq(wanted.iter().copied()), "{bytes:?}");
            path
        }
        (Err(error), Err(position)) => {
            assert_eq!(error.position, position, "{bytes:?}");
            return Some(position);
        }
        (got, wanted) => panic!("{got:?} {wanted:?} of {bytes:?}"),
    };
    assert!(path.len() < bytes.len().max(1), "a segment takes a byte: {bytes:?}");
    let (segments, window) = (path.iter().collect::<Vec<_>>(), Rect::new(-9, -7, 40, 33));
    let (mut hits, mut others) = (Hits::new(window), Hits::new(window));
    let mut table = vec![EdgeSlot::EMPTY; 40];
    let filled = hits.fill_path_fx(path, FillRule::EvenOdd, &mut table, BinaryColor::On);
    let same = others.fill_path_fx(Path::new(&segments), FillRule::EvenOdd, &mut table, BinaryColor::On);
    assert_eq!((filled, hits.runs()), (same, others.runs()), "{bytes:?}");
    None
}
