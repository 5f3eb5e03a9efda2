//! Pictures under maps: each pixel and each texel, against exact ratios; and what that means for neighbours.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "numbers of small pictures, and random ones"
)]

use embedded_graphics_core::geometry::Size;
use embedded_raster::{
    fixed::types::I16F16,
    raster::{mapped, polygon},
    Affine, Angle, ClippedSpan, EdgeSlot, FillRule, MapTooLarge, PointFx, Rect,
};
use twins::{
    pictures::texel,
    rng::{cases, Rng},
};

/// Runs of pixels as pixels with texels.
#[derive(Default)]
struct Seen(Vec<((i32, i32), (i32, i32))>);

impl Seen {
    fn run(&mut self, span: ClippedSpan, mut texels: mapped::Texels) {
        for x in span.x0()..span.x1() {
            self.0.push(((x, span.y()), texels.texel()));
        }
    }
    fn pixels(&self) -> Vec<(i32, i32)> {
        self.0.iter().map(|(pixel, _)| *pixel).collect()
    }
}

fn drawn(map: &Affine, (width, height): (u32, u32), window: Rect) -> Vec<((i32, i32), (i32, i32))> {
    let mut seen = Seen::default();
    mapped::fill(map, Size::new(width, height), window, |span, texels| seen.run(span, texels)).unwrap();
    seen.0
}

fn wanted(map: &Affine, size: (u32, u32), window: Rect) -> Vec<((i32, i32), (i32, i32))> {
    let pixels = (window.y0..window.y1).flat_map(|y| (window.x0..window.x1).map(move |x| (x, y)));
    pixels.filter_map(|pixel| Some((pixel, texel(map, size, pixel)?))).collect()
}

fn check(map: &Affine, size: (u32, u32), window: Rect) {
    assert_eq!(drawn(map, size, window), wanted(map, size, window), "{map:?} of {size:?} in {window:?}");
}

const LIMIT: i32 = 64 << 16;

/// Of a map: small and large, many of them with centres on edges, and some as large as they may be.
fn factor(rng: &mut Rng) -> i32 {
    match rng.below(9) {
        0 => rng.int(-LIMIT + 1, LIMIT - 1),
        1 => rng.pick(&[-LIMIT + 1, LIMIT - 1, 1, -1, 0]),
        2 | 3 => rng.int(-4, 4) << 15,
        4 => rng.int(-9, 9) << 16,
        5 => rng.int(-300, 300),
        _ => rng.int(-200_000, 200_000),
    }
}

fn map(rng: &mut Rng) -> Affine {
    let number = I16F16::from_bits;
    let moved = |rng: &mut Rng| match rng.below(4) {
        0 => rng.bits() as i32,
        1 => rng.int(-20, 60) << 15,
        _ => rng.int(-1_500_000, 4_000_000),
    };
    if rng.one_in(3) {
        let scale = number(rng.int(1, 300_000));
        let turned = Affine::scale(scale, scale).then(Affine::rotate(Angle::from_bits(rng.bits() as u32)));
        return Affine { dx: number(moved(rng)), dy: number(moved(rng)), ..turned };
    }
    let [xx, xy, yx, yy] = [(); 4].map(|()| number(factor(rng)));
    Affine { xx, xy, dx: number(moved(rng)), yx, yy, dy: number(moved(rng)) }
}

#[test]
fn every_pixel_has_the_texel_under_its_centre() {
    let mut rng = Rng::new(1);
    for _ in 0..cases(20_000) {
        let map = map(&mut rng);
        let size = match rng.below(5) {
            0 => (rng.int(0, 65_535) as u32, rng.int(0, 65_535) as u32),
            1 => (65_535, 65_535),
            _ => (rng.int(0, 40) as u32, rng.int(0, 40) as u32),
        };
        let (x, y) = (rng.int(-20, 40), rng.int(-20, 40));
        check(&map, size, Rect::new(x, y, x + rng.int(0, 50), y + rng.int(0, 30)));
    }
}

/// Where numbers are largest: the farthest pixels, the largest factors, the largest pictures.
#[test]
fn texels_are_right_at_the_ends_of_the_ranges() {
    let mut rng = Rng::new(2);
    for _ in 0..cases(20_000) {
        let end = rng.pick(&[LIMIT - 1, LIMIT - 2, LIMIT / 2, 3 << 20]);
        let signs = [(); 4].map(|()| if rng.one_in(2) { 1 } else { -1 });
        let [xx, xy, yx, yy] = signs.map(|sign| I16F16::from_bits(sign * (end - rng.int(0, 3))));
        let (far_x, far_y) = (rng.int(-32_000, 32_000), rng.int(-32_000, 32_000));
        let moved = |at: i32, rng: &mut Rng| I16F16::from_bits((at << 16) + rng.int(-70_000, 70_000));
        let map = Affine { xx, xy, dx: moved(far_x, &mut rng), yx, yy, dy: moved(far_y, &mut rng) };
        let from =
            if rng.one_in(2) { (far_x, far_y) } else { (rng.int(-131_100, 131_000), rng.int(-131_100, 131_000)) };
        let window = Rect::new(from.0 - 6, from.1 - 6, from.0 + 30, from.1 + 9);
        let inside = window.intersection(Rect::new(-131_072, -131_072, 131_072, 131_072));
        let size = (rng.int(65_000, 65_535) as u32, rng.int(65_000, 65_535) as u32);
        assert_eq!(drawn(&map, size, window), wanted(&map, size, inside), "{map:?} of {size:?} in {window:?}");
    }
}

/// The pixels are those of the polygon with the same corners.
#[test]
fn a_picture_covers_the_pixels_of_its_outline() {
    let mut rng = Rng::new(3);
    for _ in 0..cases(20_000) {
        // Corners at 1/256 of a pixel, half of them at centres and edges of pixels.
        let step = rng.pick(&[1 << 8, 1 << 15, 1 << 16]);
        let number = |rng: &mut Rng| I16F16::from_bits(rng.int(-400_000 / step, 400_000 / step) * step);
        let [xx, xy, yx, yy] = [(); 4].map(|()| number(&mut rng));
        let map = Affine { xx, xy, dx: number(&mut rng), yx, yy, dy: number(&mut rng) };
        let (width, height) = (rng.int(1, 9), rng.int(1, 9));
        let corners = [(0, 0), (width, 0), (width, height), (0, height)].map(|(x, y)| map.apply(PointFx::px(x, y)));
        let window = Rect::new(-20, -20, 40, 40);
        let mut filled = vec![];
        polygon::fill([&corners[..]], FillRule::NonZero, &mut [EdgeSlot::EMPTY; 8], window, |span: ClippedSpan| {
            filled.extend((span.x0()..span.x1()).map(|x| (x, span.y())));
        })
        .unwrap();
        let mut seen = Seen::default();
        let size = Size::new(width as u32, height as u32);
        mapped::fill(&map, size, window, |span, texels| seen.run(span, texels)).unwrap();
        assert_eq!(seen.pixels(), filled, "{map:?} of {width} x {height}");
    }
}

/// Tiles that share their edges: no pixel twice, none left out, under any map and in any window.
#[test]
fn neighbours_neither_gap_nor_overlap() {
    let mut rng = Rng::new(4);
    for _ in 0..cases(3_000) {
        let map = map(&mut rng);
        let window = Rect::new(0, 0, 40, 30);
        let whole = drawn(&map, (12, 10), window);
        let mut parts = vec![];
        for (x, y) in [(0, 0), (6, 0), (0, 5), (6, 5)] {
            let number = |n: i32| I16F16::from_num(n);
            let moved = Affine::translate(number(x), number(y)).then(map);
            // Where the product of both maps is no longer exact, they are two maps.
            let exact = |n: i64| i32::try_from(n).ok();
            let bits = |n: I16F16| i64::from(n.to_bits());
            let (x, y) = (i64::from(x), i64::from(y));
            let dx = exact(bits(map.xx) * x + bits(map.xy) * y + bits(map.dx));
            let dy = exact(bits(map.yx) * x + bits(map.yy) * y + bits(map.dy));
            let (Some(dx), Some(dy)) = (dx, dy) else { break };
            assert_eq!((moved.dx.to_bits(), moved.dy.to_bits()), (dx, dy), "{map:?}");
            let part = drawn(&moved, (6, 5), window).into_iter();
            parts.extend(part.map(|(pixel, (column, row))| (pixel, (column + x as i32, row + y as i32))));
        }
        if parts.len() >= whole.len() {
            parts.sort_by_key(|((x, y), _)| (*y, *x));
            assert_eq!(parts, whole, "{map:?}");
        }
    }
}

#[test]
fn factors_have_a_limit() {
    for (bits, factor) in [(LIMIT, 64), (-LIMIT, -64), (i32::MAX, 32_767), (i32::MIN, -32_768)] {
        let map = Affine { yx: I16F16::from_bits(bits), ..Affine::IDENTITY };
        let drawn = mapped::fill(&map, Size::new(9, 9), Rect::new(0, 0, 9, 9), |_, _| panic!("drawn"));
        assert_eq!(drawn, Err(MapTooLarge { factor, limit: 64 }));
    }
}

#[test]
fn a_box_is_filled_by_ratios() {
    let mut rng = Rng::new(5);
    for _ in 0..cases(20_000) {
        let (x, y) = (rng.int(-30, 30), rng.int(-30, 30));
        let area = match rng.below(4) {
            0 => Rect::new(
                x - rng.int(0, 1 << 30),
                y - rng.int(0, 1 << 30),
                x + rng.int(0, 1 << 30),
                y + rng.int(0, 1 << 30),
            ),
            1 => Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX),
            _ => Rect::new(x, y, x + rng.int(0, 40), y + rng.int(0, 40)),
        };
        let window = Rect::new(rng.int(-20, 0), rng.int(-20, 0), rng.int(1, 30), rng.int(1, 30));
        let size = if rng.one_in(4) { (65_535, 65_535) } else { (rng.int(0, 40) as u32, rng.int(0, 40) as u32) };
        let mut seen = Seen::default();
        mapped::stretch(area, Size::new(size.0, size.1), window, |span, texels| seen.run(span, texels));
        let inside = area.intersection(window);
        let along = |at: i32, low: i32, high: i32, texels: u32| {
            let length = i128::from(high) - i128::from(low);
            ((2 * (i128::from(at) - i128::from(low)) + 1) * i128::from(texels) / (2 * length)) as i32
        };
        let pixels = (inside.y0..inside.y1).flat_map(|y| (inside.x0..inside.x1).map(move |x| (x, y)));
        let texel = |(x, y)| (along(x, area.x0, area.x1, size.0), along(y, area.y0, area.y1, size.1));
        let wanted: Vec<_> = pixels.filter(|_| size.0 > 0 && size.1 > 0).map(|pixel| (pixel, texel(pixel))).collect();
        assert_eq!(seen.0, wanted, "{size:?} in {area:?} of {window:?}");
    }
}
