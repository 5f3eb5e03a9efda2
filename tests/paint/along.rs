//! Values and depths along lines, against exact ratios at every pixel.

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{Gray8, Rgb565, RgbColor},
};
use embedded_raster::{
    geom::{At, Facet, Perspective, Varying},
    paint::depth,
    pixel::{Depth16, Depth32},
    surface::{Depth, DepthBuffer},
    Canvas, ClippedSpan, Error, Framebuffer, PointFx, Rect, Surface, TriangleTooLarge,
};
use fixed::types::I16F16;
use twins::{
    lines,
    rng::{cases, Rng},
    scenes::{outline, window_on, Scale},
    tiles, Units, TILE_SIZES,
};

/// A surface without memory, anywhere.
struct Window(Rect);

impl Surface for Window {
    type Color = Gray8;

    fn window(&self) -> Rect {
        self.0
    }

    fn write_span(&mut self, span: ClippedSpan, mut color_at: impl FnMut(i32) -> Gray8) {
        for x in span.x0()..span.x1() {
            color_at(x);
        }
    }

    fn fill_span(&mut self, _: ClippedSpan, _: Gray8) {}
}

fn place((x, y): Units) -> PointFx {
    PointFx::from_bits(x, y)
}

/// A pixel, and its value.
type Pixel<V> = ((i32, i32), V);

/// Each pixel of a line in a window, with its value, from the top down.
fn shaded<V: Varying>(ends: [Units; 2], values: [V; 2], window: Rect) -> Result<Vec<Pixel<V>>, TriangleTooLarge> {
    let mut seen = vec![];
    Window(window).shade_line_fx(ends.map(place), values.map(|value| (At::default(), value)), |(At(at), value)| {
        seen.push(((at.x, at.y), value));
        Gray8::new(0)
    })?;
    seen.sort_unstable_by_key(|&((x, y), _)| (y, x));
    Ok(seen)
}

fn check<V: Varying>(ends: [Units; 2], values: [V; 2], window: Rect, number: impl Fn(V) -> i64) {
    let [a, b] = ends;
    // Those that a place can name.
    let named = -(1 << 23)..1 << 23;
    let mut wanted: Vec<_> = lines::line_fx(a, b, window)
        .into_iter()
        .filter(|(x, y)| named.contains(x) && named.contains(y))
        .map(|pixel| (pixel, lines::nearest_along(a, b, values.map(&number), pixel)))
        .collect();
    wanted.sort_unstable_by_key(|&((x, y), _)| (y, x));
    let got = shaded(ends, values, window).expect("it is short enough");
    let got: Vec<_> = got.into_iter().map(|(pixel, value)| (pixel, i128::from(number(value)))).collect();
    assert_eq!(got, wanted, "{ends:?} {:?} in {window:?}", values.map(&number));
}

/// Ends near a window, or as far away as they may be.
fn ends(rng: &mut Rng) -> [Units; 2] {
    let scale = rng.pick(&[Scale::Tiny, Scale::Screen, Scale::Screen, Scale::Hundred]);
    let places = outline(rng, scale, 2);
    let (a, mut b) = (places[0], places[1]);
    // In reach of a facet.
    let most = rng.pick(&[1_500_000, 1_560_000, 3_000_000]);
    let near = |from: i32, to: i32, most: i32| {
        (i64::from(to)).clamp(i64::from(from) - i64::from(most), i64::from(from) + i64::from(most)) as i32
    };
    b = if most > 2_000_000 {
        let (flat, short) = (rng.one_in(2), 100_000);
        (near(a.0, b.0, if flat { most } else { short }), near(a.1, b.1, if flat { short } else { most }))
    } else {
        (near(a.0, b.0, most), near(a.1, b.1, most))
    };
    [a, b]
}

#[test]
fn values_are_the_nearest() {
    let mut rng = Rng::new(1);
    for _ in 0..cases(40_000) {
        let ends = ends(&mut rng);
        let window = window_on(&mut rng, &ends);
        let mut any = || {
            let bits = rng.bits();
            rng.pick(&[bits, bits, bits, 0, u64::MAX])
        };
        let (a, b) = (any(), any());
        check(ends, [a as u8, b as u8], window, i64::from);
        check(ends, [a as u16, b as u16], window, i64::from);
        check(ends, [a as i16, b as i16], window, i64::from);
        check(ends, [a as i32, b as i32], window, i64::from);
        check(ends, [a as u32, b as u32], window, i64::from);
        let color = |n: u64| Rgb565::new(n as u8 & 31, (n >> 8) as u8 & 63, (n >> 16) as u8 & 31);
        check(ends, [color(a), color(b)], window, |c| c.r().into());
        check(ends, [color(a), color(b)], window, |c| c.g().into());
        check(ends, [color(a), color(b)], window, |c| c.b().into());
        check(ends, [[a as u8, b as u8], [b as u8, a as u8]], window, |[_, second]| second.into());
    }
}

/// All ends on a grid of quarters of pixels: middles beyond the ends, single columns, single places.
#[test]
fn values_on_a_small_grid() {
    let all = || (0..11).flat_map(|y| (0..11).map(move |x| (64 * x - 1, 64 * y)));
    for (a, b) in all().flat_map(|a| all().map(move |b| (a, b))) {
        check([a, b], [0_u8, 255], Rect::new(-2, -2, 8, 8), i64::from);
        check([a, b], [60_000_u16, 7], Rect::new(1, 1, 4, 3), i64::from);
    }
}

/// What is equal at both ends is constant, and perspective values stay between those of the ends.
#[test]
fn values_stay_between_those_of_the_ends() {
    let mut rng = Rng::new(2);
    for _ in 0..cases(5_000) {
        let ends = ends(&mut rng);
        let window = window_on(&mut rng, &ends);
        let [low, high] = [rng.int(0, 255) as u8, rng.int(0, 255) as u8];
        let mut w = || I16F16::from_bits(rng.int(1, 1 << 24));
        let seen = [low, high].map(|value| Perspective { w: w(), value });
        for (pixel, Perspective { value, .. }) in shaded(ends, seen, window).unwrap() {
            assert!((low.min(high)..=low.max(high)).contains(&value), "{ends:?} at {pixel:?}: {value}");
        }
        let same = [low; 2].map(|value| Perspective { w: w(), value });
        assert!(shaded(ends, same, window).unwrap().into_iter().all(|(_, seen)| seen.value == low));
    }
}

#[test]
fn what_is_too_long_is_an_error() {
    let line = |x: i32, y: i32| shaded([(0, 0), (x * 256, y * 256)], [0_u8, 9], Rect::new(0, 0, 5, 5)).map(|_| ());
    let most = Facet::MOST.cast_signed();
    assert_eq!(line(most - 1, 0), Ok(()));
    assert_eq!(line(0, 1 - most), Ok(()));
    assert_eq!(line(most / 2 - 1, most / 2 - 1), Ok(()));
    let error = TriangleTooLarge { width: 12_289, height: 1, most: 12_288 };
    assert_eq!(line(most + 1, 0), Err(error));
    assert_eq!(
        Error::from(error).to_string(),
        "triangle or line too large: 12289 x 1 pixels, shades take 12288 for both together"
    );
    assert!(shaded([(i32::MIN, i32::MIN), (i32::MAX, i32::MAX)], [0_u8, 9], Rect::new(0, 0, 5, 5)).is_err());
}

/// Lines and what is seen of them, whole and in bands, with every test and depth: as a loop over pixels has it.
fn depths<Z>(seed: u64, most: u32, number: impl Fn(u32) -> Z::Number + Copy, pack: impl Fn(u32) -> Z)
where
    Z: Depth + PartialEq + core::fmt::Debug,
{
    const SIZE: (u16, u16) = (40, 24);
    let mut rng = Rng::new(seed);
    for round in 0..cases(1_000) {
        let shapes: Vec<([Units; 2], [u32; 2], u8)> = (0..rng.int(1, 12))
            .map(|n| {
                let reach = rng.pick(&[0, 3_000, 500_000]);
                let ends = [(); 2].map(|()| (rng.int(-reach, 40 * 256 + reach), rng.int(-reach, 24 * 256 + reach)));
                let any = rng.range(0, most.into()) as u32;
                (ends, [rng.pick(&[0, most, most / 2, any]), rng.pick(&[0, most, most / 2, any])], n as u8 + 1)
            })
            .collect();
        let (test, start): (fn(u32, u32) -> bool, u32) = match round % 4 {
            0 => (|new, old| new < old, most),
            1 => (|new, old| new <= old, most),
            2 => (|new, old| new > old, 0),
            _ => (|_, _| true, most / 3),
        };
        let mut wanted = vec![(0, start); 40 * 24];
        for &([a, b], values, color) in &shapes {
            for (x, y) in lines::line_fx(a, b, Rect::new(0, 0, 40, 24)) {
                let depth = lines::nearest_along(a, b, values.map(i64::from), (x, y)) as u32;
                let pixel = &mut wanted[(y * 40 + x) as usize];
                if test(depth, pixel.1) {
                    *pixel = (color, depth);
                }
            }
        }
        for rows in [SIZE.1, 7, 1] {
            for first in (0..SIZE.1).step_by(rows.into()) {
                let band = first..(first + rows).min(SIZE.1);
                let (mut ram, mut depth_ram) = (vec![0; 40 * 24], vec![0; 40 * 24 * 4]);
                let mut frame = Framebuffer::<Gray8>::band(&mut ram, SIZE.0, SIZE.1, band.clone()).unwrap();
                let mut buffer = DepthBuffer::<Z>::band(&mut depth_ram, SIZE.0, SIZE.1, band.clone()).unwrap();
                buffer.clear(pack(start));
                for &(ends, values, color) in &shapes {
                    let values = values.map(|depth| (number(depth), ()));
                    let paint = |()| Gray8::new(color);
                    let (places, on) = (ends.map(place), &mut buffer);
                    match round % 4 {
                        0 => frame.depth_line_fx(places, values, on, depth::less, paint),
                        1 => frame.depth_line_fx(places, values, on, depth::less_equal, paint),
                        2 => frame.depth_line_fx(places, values, on, depth::greater, paint),
                        _ => frame.depth_line_fx(places, values, on, depth::always, paint),
                    }
                    .unwrap();
                }
                for y in band {
                    for x in 0..40 {
                        let (at, (color, depth)) = (Point::new(x, y.into()), wanted[usize::from(y) * 40 + x as usize]);
                        assert_eq!(frame.get(at), Some(Gray8::new(color)), "{shapes:?} at {at}");
                        assert_eq!(buffer.get(at), Some(pack(depth)), "{shapes:?} at {at}");
                    }
                }
            }
        }
    }
}

#[test]
fn depths_of_16_bits() {
    depths::<Depth16>(3, 0xffff, |n| n as u16, |n| Depth16(n as u16));
}

#[test]
fn depths_of_32_bits() {
    depths::<Depth32>(4, u32::MAX, |n| n, Depth32);
}

/// Tiles show what the whole shows.
#[test]
fn tiles_of_every_size_show_the_same_values() {
    let mut rng = Rng::new(5);
    let whole = Rect::new(-13, -7, 35, 33);
    for _ in 0..cases(300) {
        let ends = [(); 2].map(|()| (rng.int(-15_000, 23_000), rng.int(-15_000, 23_000)));
        let values = [rng.bits() as u16, rng.bits() as u16];
        let wanted = shaded(ends, values, whole).unwrap();
        for size in TILE_SIZES {
            let mut pieces: Vec<_> =
                tiles(whole, size).into_iter().flat_map(|tile| shaded(ends, values, tile).unwrap()).collect();
            pieces.sort_unstable_by_key(|&((x, y), _)| (y, x));
            assert_eq!(pieces, wanted, "{ends:?} in tiles of {size:?}");
        }
    }
}
