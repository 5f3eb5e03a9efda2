//! Circles and ellipses against the equation of the curve at every pixel, in numbers so wide that nothing can overflow.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    clippy::cast_lossless,
    reason = "tests mix widths on purpose"
)]

use embedded_graphics_core::{geometry::Point, pixelcolor::BinaryColor};
use embedded_raster::{
    buffer_bytes,
    raster::ellipse::{self, Ellipse},
    Canvas, Framebuffer, PointFx, Rect, Surface,
};
use fixed::types::I24F8;
use twins::{
    assert_runs, collect,
    hits::Hits,
    rng::{cases, Rng},
    runs_where,
    scenes::window_near,
    tiles, Run, TILE_SIZES,
};

fn filled(ellipse: Ellipse, window: Rect) -> Vec<Run> {
    collect(window, |emit| ellipse::fill(ellipse, window, emit))
}

fn outlined(area: Rect, window: Rect) -> Vec<Run> {
    collect(window, |emit| ellipse::outline(area, window, emit))
}

fn enclosed(area: Rect, window: Rect) -> Vec<Run> {
    collect(window, |emit| ellipse::enclosed(area, window, emit))
}

/// All three shapes of a box; whether anything of the outline was seen.
fn check(area: Rect, window: Rect) -> bool {
    let fill = runs_where(window, |x, y| twins::box_ellipse_has(area, x, y));
    assert_runs(window, &filled(Ellipse::in_box(area), window), &fill, || format!("filled {area:?}"));
    let outline = runs_where(window, |x, y| twins::outline_has(area, x, y));
    assert_runs(window, &outlined(area, window), &outline, || format!("outline of {area:?}"));
    let both = runs_where(window, |x, y| twins::enclosed_has(area, x, y));
    assert_runs(window, &enclosed(area, window), &both, || format!("enclosed by {area:?}"));
    !outline.is_empty()
}

fn check_units(centre: (i32, i32), radii: (i32, i32), window: Rect) -> bool {
    let [rx, ry] = [radii.0, radii.1].map(I24F8::from_bits);
    let shape = Ellipse::new(PointFx::from_bits(centre.0, centre.1), rx, ry);
    let wide = |(a, b): (i32, i32)| (i64::from(a), i64::from(b));
    let wanted = runs_where(window, |x, y| twins::ellipse_has(wide(centre), wide(radii), 256, x, y));
    assert_runs(window, &filled(shape, window), &wanted, || format!("{centre:?} radii {radii:?}"));
    let splat = Ellipse::splat(PointFx::from_bits(centre.0, centre.1), rx);
    let twice = (2 * i64::from(centre.0), 2 * i64::from(centre.1));
    let size = i64::from(radii.0);
    let round = runs_where(window, |x, y| twins::ellipse_has(twice, (size, size), 512, x, y));
    assert_runs(window, &filled(splat, window), &round, || format!("splat at {centre:?} of {size}"));
    !wanted.is_empty()
}

/// From nothing to 120 x 120, odd and even, and again through a small window.
#[test]
fn every_box_up_to_120() {
    let (mut rng, mut choice) = (Rng::new(201), Rng::new(202));
    for width in 0..=120 {
        for height in (0..=120).filter(|_| choice.takes_case()) {
            let area = Rect::new(-3, 2, width - 3, height + 2);
            check(area, Rect::new(-4, 1, width - 1, height + 4));
            let (x, y) = (rng.range(-4, 118), rng.range(1, 122));
            check(area, window_near(&mut rng, x, y));
        }
    }
}

/// Neighbours touch, and the picture is its own mirror image both ways.
#[test]
fn outlines_are_closed_and_symmetric() {
    for width in 1..=60 {
        for height in 1..=60 {
            let area = Rect::new(0, 0, width, height);
            let mut hits = Hits::new(area);
            ellipse::outline(area, area, |span| hits.fill_span(span, BinaryColor::On));
            let on = |x: i32, y: i32| area.contains(x, y) && hits.count(x, y) == 1;
            let (mut pixels, mut reached) = (0, 0);
            for y in 0..height {
                for x in 0..width {
                    assert!(hits.count(x, y) < 2, "{width} x {height}: ({x}, {y}) twice");
                    assert_eq!(on(x, y), on(width - 1 - x, y), "{width} x {height}: left and right");
                    assert_eq!(on(x, y), on(x, height - 1 - y), "{width} x {height}: top and bottom");
                    pixels += usize::from(on(x, y));
                }
            }
            let first = (0..width).find(|&x| on(x, 0)).expect("the top row has pixels");
            let mut seen = vec![false; (width * height) as usize];
            let mut todo = vec![(first, 0)];
            while let Some((x, y)) = todo.pop() {
                if !on(x, y) || std::mem::replace(&mut seen[(y * width + x) as usize], true) {
                    continue;
                }
                reached += 1;
                todo.extend((-1..2).flat_map(|dy| (-1..2).map(move |dx| (x + dx, y + dy))));
            }
            assert_eq!(reached, pixels, "{width} x {height} is in pieces");
        }
    }
}

/// Whole circles from one octant, in memory and on surfaces that know spans only, and whole discs from their upper half: in
/// every size up to 400 and in some beyond.
#[test]
fn mirror_images_are_the_whole() {
    let (mut rng, mut choice) = (Rng::new(211), Rng::new(212));
    let sizes = (1..=400)
        .filter(|_| choice.takes_case())
        .chain((0..cases(60)).map(|_| rng.int(401, 5_000)))
        .chain([8_191, 8_192, 16_383]);
    for (i, size) in (0..).zip(sizes) {
        let area = Rect::new(3, 2, 3 + size, 2 + size);
        let window = Rect::new(0, 0, size + 5, size + 4);
        let wanted = outlined(area, window);
        if size <= 5_000 {
            let mut hits = Hits::new(window);
            hits.draw_ellipse(area, BinaryColor::On);
            assert_runs(window, &hits.runs(), &wanted, || format!("spans of a circle of {size} pixels"));
            let (ellipse, mut hits) = (Ellipse::in_box(area), Hits::new(window));
            hits.fill_ellipse_fx(ellipse, BinaryColor::On);
            assert_runs(window, &hits.runs(), &filled(ellipse, window), || format!("disc of {size} pixels"));
        }
        let side = (size + 5) as u16;
        let mut memory = vec![0; buffer_bytes::<BinaryColor>(side, side)];
        let mut frame = Framebuffer::<BinaryColor>::new(&mut memory, side, side).expect("enough memory");
        // By turns where a row is a whole number of bytes, in a view, and in a part of it.
        let (mut view, place) = match i % 3 {
            0 => (frame.view(window), area),
            1 => (frame.view(area), Rect::new(0, 0, size, size)),
            _ => (frame.clipped(area), area),
        };
        view.draw_ellipse(place, BinaryColor::On);
        let mut pixels = 0;
        for &(y, x0, x1) in &wanted {
            assert!(
                (x0..x1).all(|x| frame.get(Point::new(x, y)) == Some(BinaryColor::On)),
                "circle of {size}, row {y}"
            );
            pixels += (x1 - x0) as u32;
        }
        assert_eq!(memory.iter().map(|byte| byte.count_ones()).sum::<u32>(), pixels, "circle of {size}");
    }
}

/// Those that other libraries are known to break: semi-axes of 0 and 1, needles, products beyond 32 bits.
#[test]
fn hard_sizes_whole() {
    for (width, height) in [
        (601, 3),
        (601, 1),
        (602, 4),
        (121, 7),
        (3, 601),
        (264, 177),
        (529, 355),
        (300, 300),
        (299, 301),
        (1023, 84),
        (1024, 85),
        (1500, 1000),
        (3001, 5),
        (5, 3001),
    ] {
        let area = Rect::new(-7, 11, width - 7, height + 11);
        assert!(check(area, area), "an outline");
    }
}

/// A place on the curve of a box, to look at.
fn on_curve(rng: &mut Rng, area: Rect) -> (i64, i64) {
    let turn = (rng.below(1 << 20) as f64) / f64::from(1 << 20) * std::f64::consts::TAU;
    let place = |from: i32, to: i32, part: f64| {
        let (from, to) = (f64::from(from), f64::from(to));
        (((from + to) + (to - from) * part) / 2.0) as i64
    };
    match rng.below(8) {
        0 => (place(area.x0, area.x1, 0.0), area.y0.into()),
        1 => (area.x0.into(), place(area.y0, area.y1, 0.0)),
        2 => (i64::from(area.x1) - 1, place(area.y0, area.y1, 0.0)),
        _ => (place(area.x0, area.x1, turn.cos()), place(area.y0, area.y1, turn.sin())),
    }
}

/// Random shapes of each kind.
const BOXES: usize = 120_000;
const SHAPES: usize = 120_000;

/// Boxes with axes around powers of two, up to all of the plane, through small windows on the curve.
#[test]
fn boxes_of_every_size() {
    let mut rng = Rng::new(202);
    let (count, mut seen) = (cases(BOXES), 0);
    let axis = |rng: &mut Rng| {
        let bits = rng.range(0, 32);
        ((1_i64 << bits) + rng.range(-3, 3)).clamp(0, (1 << 32) - 1)
    };
    for i in 0..count {
        let (width, height) = (axis(&mut rng), axis(&mut rng));
        let height = if i % 4 == 0 { width } else { height };
        let start = |rng: &mut Rng, size: i64| {
            let (low, high) = (i64::from(i32::MIN), i64::from(i32::MAX) - size);
            match rng.below(4) {
                0 => low,
                1 => high,
                2 => rng.range(-300, 300).clamp(low, high),
                _ => rng.range(low, high),
            }
        };
        let (x0, y0) = (start(&mut rng, width), start(&mut rng, height));
        let area = Rect::new(x0 as i32, y0 as i32, (x0 + width) as i32, (y0 + height) as i32);
        let (x, y) = on_curve(&mut rng, area);
        seen += usize::from(check(area, window_near(&mut rng, x, y)));
    }
    assert!(seen >= count / 2, "only {seen} were seen");
}

#[test]
fn units_of_every_size() {
    let mut rng = Rng::new(203);
    let (count, mut seen) = (cases(SHAPES), 0);
    let radius = |rng: &mut Rng| ((1_i64 << rng.range(0, 31)) + rng.range(-300, 300)).clamp(-5, i32::MAX.into()) as i32;
    for i in 0..count {
        let radii = (radius(&mut rng), radius(&mut rng));
        let radii = if i % 3 == 0 { (radii.0, radii.0) } else { radii };
        let place = |rng: &mut Rng| match rng.below(3) {
            0 => rng.bits() as i32,
            1 => rng.int(-20_000, 60_000),
            _ => rng.pick(&[i32::MIN, i32::MAX, 0, 128, -128, 256]),
        };
        let centre = (place(&mut rng), place(&mut rng));
        let clamp = |n: i64| n.clamp(i32::MIN.into(), i32::MAX.into()) as i32;
        let pixels =
            |c: i32, r: i32| (clamp((i64::from(c) - i64::from(r)) >> 8), clamp((i64::from(c) + i64::from(r)) >> 8));
        let ((x0, x1), (y0, y1)) = (pixels(centre.0, radii.0), pixels(centre.1, radii.1));
        let (x, y) = on_curve(&mut rng, Rect::new(x0, y0, x1.max(x0), y1.max(y0)));
        seen += usize::from(check_units(centre, radii, window_near(&mut rng, x, y)));
    }
    assert!(seen >= count / 3, "only {seen} were seen");
}

/// Every centre of a grid with every radius: centres of pixels exactly on the curve, everywhere.
#[test]
fn ties_in_units() {
    let window = Rect::new(-8, -8, 9, 9);
    for radius in (0..=1920).step_by(64) {
        for x in (-128..=256).step_by(32) {
            for y in (-128..=256).step_by(64) {
                check_units((x, y), (radius, radius), window);
                check_units((x, y), (radius, 1280), window);
            }
        }
    }
}

/// Two halves of a ring and its disc meet without gap or overlap: a centre on a curve lies on one side of it only.
#[test]
fn squares() {
    let mut rng = Rng::new(204);
    for _ in 0..cases(20_000) {
        let (x, y, size) = (rng.int(-3_000, 3_000), rng.int(-3_000, 3_000), rng.int(-20, 3_000));
        let got = ellipse::square(PointFx::from_bits(x, y), I24F8::from_bits(size));
        let window = Rect::new(-20, -20, 20, 20);
        let inside = |c: i32, at: i32| {
            let twice = 2 * (256 * c + 128);
            2 * at - size <= twice && twice < 2 * at + size
        };
        let wanted = runs_where(window, |px, py| inside(px, x) && inside(py, y));
        assert_eq!(runs_where(window, |px, py| got.contains(px, py)), wanted, "({x}, {y}) of {size}");
    }
}

#[test]
fn tiles_of_every_size_show_the_same_ellipse() {
    let mut rng = Rng::new(205);
    let whole = Rect::new(-9, -5, 39, 31);
    for i in 0..60 {
        let mut at = |low, high| rng.int(low, high);
        let (x, y) = (at(-30, 30), at(-30, 20));
        let area = Rect::new(x, y, x + at(1, 60), y + at(1, 50));
        let units = Ellipse::new(
            PointFx::from_bits(at(-4_000, 9_000), at(-3_000, 8_000)),
            I24F8::from_bits(at(1, 9_000)),
            I24F8::from_bits(at(1, 7_000)),
        );
        let shapes: [&dyn Fn(Rect) -> Vec<Run>; 4] = [
            &|window| filled(Ellipse::in_box(area), window),
            &|window| outlined(area, window),
            &|window| enclosed(area, window),
            &|window| filled(units, window),
        ];
        for (kind, shape) in shapes.iter().enumerate() {
            let wanted = shape(whole);
            for size in TILE_SIZES {
                let mut hits = Hits::new(whole);
                for tile in tiles(whole, size) {
                    hits.add(&shape(tile));
                }
                assert_runs(whole, &hits.runs(), &wanted, || format!("{i}: kind {kind} of {area:?} in {size:?}"));
            }
        }
    }
}

/// The pictures of the documentation.
#[test]
fn pictures() {
    let draw = |shape: fn(Rect) -> Vec<Run>, width: i32, height: i32| {
        let area = Rect::new(0, 0, width, height);
        twins::picture(area, &shape(area))
    };
    let fill = |area| filled(Ellipse::in_box(area), area);
    let outline = |area| outlined(area, area);
    assert_eq!(draw(fill, 6, 6), ".####.\n######\n######\n######\n######\n.####.\n");
    assert_eq!(draw(outline, 6, 6), ".####.\n#....#\n#....#\n#....#\n#....#\n.####.\n");
    assert_eq!(draw(fill, 7, 7), "..###..\n.#####.\n#######\n#######\n#######\n.#####.\n..###..\n");
    assert_eq!(draw(outline, 7, 7), "..###..\n.#...#.\n#.....#\n#.....#\n#.....#\n.#...#.\n..###..\n");
    let (top, middle) = ("...#######...\n", "#############\n");
    assert_eq!(draw(fill, 13, 6), [top, ".###########.\n", middle, middle, ".###########.\n", top].concat());
    let (flat, sides) = (".##.......##.\n", "#...........#\n");
    assert_eq!(draw(outline, 13, 6), [top, flat, sides, sides, flat, top].concat());
    assert_eq!(draw(outline, 8, 2), "########\n########\n");
}
