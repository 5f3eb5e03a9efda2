//! Gradients through shapes, whole and in bands and views, against exact ratios; and dither, against shares of blocks.

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{Gray8, GrayColor},
};
use embedded_raster::{
    geom::{At, Facet, Plane},
    paint::{Bayer, Linear, Outside, Radial},
    raster::{ellipse, rectangle},
    Canvas, ClippedSpan, Ellipse, Framebuffer, Paint, PointFx, Rect, Surface,
};
use fixed::types::I24F8;
use twins::{
    gradients,
    rng::{cases, Rng},
    Units,
};

const OUTSIDE: [Outside; 3] = [Outside::Clamp, Outside::Repeat, Outside::Mirror];

type Frame<'a> = Framebuffer<'a, Gray8>;

/// Fills a screen and its bands, a clip and a view, and compares each pixel.
fn check<'p, P>(paint: impl Fn(i32, i32) -> P, wanted: impl Fn(i32, i32) -> u8, rng: &mut Rng, what: &str)
where
    P: for<'a> Paint<Frame<'a>> + 'p,
{
    let mut ram = [0; 40 * 24];
    let mut frame = Frame::new(&mut ram, 40, 24).unwrap();
    frame.paint(paint(0, 0), |window, brush| rectangle::fill(Rect::new(-5, -5, 90, 90), window, brush));
    for (x, y) in (0..24).flat_map(|y| (0..40).map(move |x| (x, y))) {
        let got = frame.get(Point::new(x, y)).unwrap().luma();
        assert_eq!(got, wanted(x, y), "{what} at {x}, {y}");
    }
    // A disc in a band, in a clip of a band, and in a view.
    let (left, top, first) = (rng.int(0, 30), rng.int(0, 15), rng.int(0, 2) as u16 * 8);
    let mut ram = [0; 40 * 8];
    let mut band = Frame::band(&mut ram, 40, 24, first..first + 8).unwrap();
    let disc = Ellipse::in_box(Rect::new(3, 1, 38, 22));
    band.clipped(Rect::new(left, 0, 99, 99)).paint(paint(0, 0), |window, brush| ellipse::fill(disc, window, brush));
    let mut in_disc = [false; 40 * 24];
    ellipse::fill(disc, Rect::new(0, 0, 40, 24), |span: ClippedSpan| {
        (span.x0()..span.x1()).for_each(|x| in_disc[(span.y() * 40 + x) as usize] = true);
    });
    for (x, y) in (i32::from(first)..i32::from(first) + 8).flat_map(|y| (0..40).map(move |x| (x, y))) {
        let right = if in_disc[(y * 40 + x) as usize] && x >= left { wanted(x, y) } else { 0 };
        assert_eq!(band.get(Point::new(x, y)).unwrap().luma(), right, "{what} at {x}, {y} in a band");
    }
    let mut ram = [0; 40 * 24];
    let mut other = Frame::new(&mut ram, 40, 24).unwrap();
    other
        .view(Rect::new(left, top, left + 9, top + 7))
        .paint(paint(left, top), |window, brush| rectangle::fill(window, window, brush));
    for (x, y) in (top..top + 7).flat_map(|y| (left..left + 9).map(move |x| (x, y))) {
        assert_eq!(other.get(Point::new(x, y)).unwrap().luma(), wanted(x, y), "{what} at {x}, {y} in a view");
    }
}

fn place((x, y): Units) -> PointFx {
    PointFx::from_bits(x, y)
}

/// Places near the screen, many of them at centres, corners and small distances, and far ones.
fn end(rng: &mut Rng, far: i32) -> Units {
    let near = (rng.int(-3_000, 13_000), rng.int(-3_000, 9_000));
    match rng.below(5) {
        0 => (near.0 & !127, near.1 & !127),
        1 => (rng.int(-far, far), rng.int(-far, far)),
        2 => (5 * 256 + rng.int(-3, 3), 5 * 256 + rng.int(-3, 3)),
        3 => ((near.0 & !255) | 128, 128),
        _ => near,
    }
}

#[test]
fn linear_gradients_have_the_nearest_levels() {
    let mut rng = Rng::new(1);
    for round in 0..cases(3_000) {
        let (kind, ends) = (round % 3, [end(&mut rng, 8_000_000), end(&mut rng, 8_000_000)]);
        let moved = |x: i32, y: i32| ends.map(|(a, b)| place((a - 256 * x, b - 256 * y)));
        let paint = |x, y| Linear::new(moved(x, y), OUTSIDE[kind], |level, _| Gray8::new(level));
        check(paint, |x, y| gradients::linear(ends, kind, x, y), &mut rng, &format!("{ends:?} {:?}", OUTSIDE[kind]));
    }
}

/// A window anywhere.
struct Far {
    window: Rect,
    seen: Vec<(i32, u8)>,
}

impl Surface for Far {
    type Color = Gray8;
    fn window(&self) -> Rect {
        self.window
    }
    fn fill_span(&mut self, span: ClippedSpan, color: Gray8) {
        self.seen.push((span.x0(), color.luma()));
    }
}

#[test]
fn far_pixels_have_the_nearest_levels_too() {
    let mut rng = Rng::new(2);
    for round in 0..cases(20_000) {
        let kind = round % 3;
        let ends = [end(&mut rng, 8_000_000), end(&mut rng, 8_000_000)];
        let mut at = || rng.pick(&[i32::MIN, -70_000, 65_000, i32::MAX - 40]) + rng.int(0, 9);
        let (x, y) = (at(), at());
        let mut far = Far { window: Rect::new(x, y, x + 30, y + 1), seen: vec![] };
        let paint = Linear::new(ends.map(place), OUTSIDE[kind], |level, _| Gray8::new(level));
        far.paint(paint, |window, brush| rectangle::fill(window, window, brush));
        assert_eq!(far.seen.len(), 30);
        for (x, level) in far.seen.drain(..) {
            assert_eq!(level, gradients::linear(ends, kind, x, y), "{ends:?} {:?} at {x}, {y}", OUTSIDE[kind]);
        }
        let (centre, radius) = (ends[0], rng.pick(&[1, 255, 4_095, 4_096, 100_000, (1 << 22) - 1]));
        let paint = Radial::new(place(centre), I24F8::from_bits(radius), OUTSIDE[kind], |level, _| Gray8::new(level));
        far.paint(paint, |window, brush| rectangle::fill(window, window, brush));
        for (x, level) in far.seen {
            let wanted = gradients::radial(centre, radius, kind, x, y);
            assert_eq!(level, wanted, "{centre:?} {radius} {:?} at {x}, {y}", OUTSIDE[kind]);
        }
    }
}

/// Ends at the ends of the type: no panic, and the level but for a little.
#[test]
fn the_farthest_ends() {
    let mut rng = Rng::new(3);
    for round in 0..cases(5_000) {
        let kind = round % 3;
        let mut at = || rng.pick(&[i32::MIN, i32::MAX, 0, 1 << 24, -(1 << 24), 1 << 30, 77, rng.clone().bits() as i32]);
        let ends = [(at(), at()), (at(), at())];
        let mut far = Far { window: Rect::new(0, 0, 40, 1), seen: vec![] };
        let paint = Linear::new(ends.map(place), OUTSIDE[kind], |level, _| Gray8::new(level));
        far.paint(paint, |window, brush| rectangle::fill(window, window, brush));
        for (x, level) in far.seen {
            let wanted = gradients::linear(ends, kind, x, 0);
            let near = level.abs_diff(wanted) <= 1 || kind == 1 && level.abs_diff(wanted) >= 254;
            assert!(near, "{ends:?} {:?} at {x}: {level} for {wanted}", OUTSIDE[kind]);
        }
    }
}

#[test]
fn radial_gradients_have_the_nearest_levels() {
    let mut rng = Rng::new(4);
    for round in 0..cases(3_000) {
        let (kind, centre) = (round % 3, end(&mut rng, 4_000_000));
        let radius = match rng.below(4) {
            0 => rng.int(1, 600),
            1 => rng.int(4_090, 4_100),
            // Squares of whole distances: ties.
            2 => rng.pick(&[255 * 2, 255 * 128, 510 * 128, 255 * 256]),
            _ => rng.int(1, 1 << 22) - 1,
        }
        .max(1);
        let paint = |x: i32, y: i32| {
            let centre = place((centre.0 - 256 * x, centre.1 - 256 * y));
            Radial::new(centre, I24F8::from_bits(radius), OUTSIDE[kind], |level, _| Gray8::new(level))
        };
        let what = format!("{centre:?} {radius} {:?}", OUTSIDE[kind]);
        check(paint, |x, y| gradients::radial(centre, radius, kind, x, y), &mut rng, &what);
    }
}

#[test]
fn gradients_tell_the_pixel() {
    let mut ram = [0; 40 * 4];
    let mut frame = Frame::new(&mut ram, 40, 4).unwrap();
    let paint = Linear::new([PointFx::px(0, 0); 2], Outside::Repeat, |level, at: Point| {
        Gray8::new(level + (at.x + 40 * at.y) as u8)
    });
    frame.paint(paint, |window, brush| rectangle::fill(window, window, brush));
    assert!((0..160).all(|i| ram[i] == i as u8), "{ram:?}");
}

/// Of the pixels of a block, the share of the upper shade is the nearest to where the level lies.
fn shares<const N: u32>() {
    let n = i32::try_from(N).unwrap();
    for corner in [0, 7, -9, i32::MIN, i32::MAX - 7] {
        let block: Vec<Point> = (0..n)
            .flat_map(|y| {
                (0..n).map(move |x| Point::new(corner.wrapping_add(x), 3_i32.wrapping_sub(corner).wrapping_add(y)))
            })
            .collect();
        let mut thresholds: Vec<u32> = block.iter().map(|&at| Bayer::<N>::threshold(at)).collect();
        thresholds.sort_unstable();
        assert!(thresholds.iter().copied().eq(0..N * N), "{thresholds:?}");
        let count = |most: u8, exact: (u32, u32), shade: &dyn Fn(Point) -> u8| {
            // Twice the sum of the shades, in halves of a pixel, next to twice the exact one.
            let sum: u32 = block.iter().map(|&at| u32::from(shade(at))).sum();
            let (level, all) = exact;
            let wanted =
                (2 * u64::from(level) * u64::from(most) * u64::from(N * N) + u64::from(all)) / (2 * u64::from(all));
            assert_eq!(u64::from(sum), wanted, "level {level} of {all} in shades to {most}, blocks of {N}");
            let lower = level * u32::from(most) / all;
            assert!(
                block.iter().all(|&at| [lower, lower + 1].contains(&shade(at).into())),
                "level {level}: other shades"
            );
        };
        for most in [1, 3, 15, 31, 63, 255] {
            for level in 0..=255 {
                count(most, (level.into(), 255), &|at| Bayer::<N>::shade(level, most, at));
            }
            for level in (0..=65_535).step_by(97).chain([65_535]) {
                count(most, (level.into(), 65_535), &|at| Bayer::<N>::fine_shade(level, most, at));
            }
        }
    }
}

#[test]
fn each_shade_has_its_share_of_a_block() {
    shares::<2>();
    shares::<4>();
    shares::<8>();
    // The matrix of the paper.
    let rows = (0..4).map(|y| (0..4).map(|x| Bayer::<4>::threshold(Point::new(x, y))).collect::<Vec<_>>());
    assert_eq!(rows.collect::<Vec<_>>(), [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]]);
}

#[test]
fn a_triangle_knows_its_pixels() {
    let facet = Facet::new([(-900, 33), (5_000, -700), (900, 8_000)].map(place)).unwrap();
    let plane = Plane::new(&facet, [At::default(); 3]);
    for (x, y) in (-1..20).flat_map(|x| (-1..30).map(move |y| (x, y))) {
        assert_eq!(plane.at(x, y), At(Point::new(x, y)));
    }
}
