//! Arithmetic of places, angles and rectangles, against wide integers and against sets of pixels.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "wide numbers that were checked to fit"
)]

use std::collections::BTreeSet;

use embedded_graphics_core::{
    geometry::{Point, Size},
    primitives::Rectangle,
};
use embedded_raster::{px, Angle, PointFx, Rect};
use fixed::types::{I16F16, I24F8};
use twins::rng::Rng;

const CENTRE: PointFx = PointFx::centre_of(Point::new(i32::MAX, i32::MIN));
const RIGHT_ANGLE: Angle = Angle::degrees_fx(I16F16::from_bits(90 << 16));
const WINDOW: Rect = Rect::from_center(Point::new(160, 120), Size::new(320, 240)).translate(1, 1).inset(1);
const ENDS: [i32; 9] = [i32::MIN, i32::MIN + 1, -256, -1, 0, 1, 128, i32::MAX - 1, i32::MAX];

fn number(rng: &mut Rng) -> i32 {
    match rng.below(4) {
        0 => rng.pick(&ENDS),
        1 => rng.int(-1_000, 1_000),
        2 => rng.int(-1_000_000, 1_000_000),
        _ => rng.bits() as i32,
    }
}

/// Known when a program is compiled, as tables in flash must be.
const LENGTHS: [I24F8; 2] = [px(6), px(-3)];

/// The nearest `i32`.
fn stop(n: i64) -> i32 {
    n.clamp(i32::MIN.into(), i32::MAX.into()) as i32
}

#[test]
fn whole_pixels_stop_at_the_ends() {
    assert_eq!(LENGTHS.map(I24F8::to_bits), [1_536, -768]);
    let mut rng = Rng::new(901);
    let mut stopped = 0;
    for _ in 0..10_000 {
        let [x, y] = [(); 2].map(|()| number(&mut rng));
        let bits = [x, y].map(|n| stop(i64::from(n) * 256));
        assert_eq!([px(x), px(y)], bits.map(I24F8::from_bits), "{x} and {y}");
        assert_eq!(PointFx::px(x, y), PointFx::new(px(x), px(y)), "{x} and {y}");
        stopped += usize::from(i64::from(bits[0]) != i64::from(x) * 256);
    }
    assert!(stopped > 1_000, "{stopped} of them stop at an end");
}

#[test]
fn places_are_added_and_scaled_and_stop_at_the_ends() {
    let mut rng = Rng::new(900);
    let mut stopped = 0;
    for _ in 0..200_000 {
        let [ax, ay, bx, by, f] = [(); 5].map(|()| number(&mut rng));
        let (a, b, factor) = (PointFx::from_bits(ax, ay), PointFx::from_bits(bx, by), I24F8::from_bits(f));
        let each = |rule: &dyn Fn(i64, i64) -> i64| {
            PointFx::from_bits(stop(rule(ax.into(), bx.into())), stop(rule(ay.into(), by.into())))
        };
        assert_eq!(a + b, each(&|a, b| a + b), "{a:?} + {b:?}");
        assert_eq!(a - b, each(&|a, b| a - b), "{a:?} - {b:?}");
        assert_eq!(-a, each(&|a, _| -a), "-{a:?}");
        // Nearest, halves up: floor(a f / 256 + 1/2).
        let product = each(&|a, _| (a * i64::from(f) + 128).div_euclid(256));
        assert_eq!(a * factor, product, "{a:?} * {factor}");
        stopped += usize::from(product.x == I24F8::MAX || product.x == I24F8::MIN);
        let (mut sum, mut rest) = (a, a);
        sum += b;
        rest -= b;
        assert_eq!((sum, rest), (a + b, a - b));
    }
    assert!((10_000..190_000).contains(&stopped), "{stopped} products stopped at an end");
}

#[test]
fn a_point_becomes_the_centre_of_its_pixel() {
    for n in [-8_388_608, -3, -1, 0, 1, 7, 8_388_607] {
        let pixel = Point::new(n, -1 - n);
        let centre = PointFx::from(pixel);
        assert_eq!(centre, PointFx::px(pixel.x, pixel.y) + PointFx::from_bits(128, 128), "{pixel:?}");
        assert_eq!(centre.pixel(), pixel);
    }
    assert_eq!(CENTRE, PointFx::from_bits(i32::MAX, i32::MIN));
}

#[test]
fn angles_wrap_at_whole_turns() {
    let mut rng = Rng::new(901);
    let turn = 1_i128 << 32;
    for _ in 0..100_000 {
        let (a, b, n) = (number(&mut rng) as u32, number(&mut rng) as u32, number(&mut rng));
        let (p, q) = (Angle::from_bits(a), Angle::from_bits(b));
        let wrapped = |n: i128| Angle::from_bits(n.rem_euclid(turn) as u32);
        let (a, b) = (i128::from(a), i128::from(b));
        assert_eq!(p + q, wrapped(a + b), "{p:?} + {q:?}");
        assert_eq!(p - q, wrapped(a - b), "{p:?} - {q:?}");
        assert_eq!(-p, wrapped(-a), "-{p:?}");
        assert_eq!(p * n, wrapped(a * i128::from(n)), "{p:?} * {n}");
        let (mut sum, mut rest) = (p, p);
        sum += q;
        rest -= q;
        assert_eq!((sum, rest), (p + q, p - q));
        assert_eq!(p.plus(q.to_signed()), p + q);
        assert_eq!(Angle::from_bits(p.clockwise_to(q)), q - p);
    }
}

#[test]
fn degrees_are_the_nearest_units() {
    let mut rng = Rng::new(902);
    let (turn, full) = (1_i128 << 32, 360_i128 << 16);
    for _ in 0..200_000 {
        let d = I16F16::from_bits(number(&mut rng));
        let bits = i128::from(d.to_bits());
        // Nearest: floor(bits turn / full + 1/2).
        let wanted = (2 * bits * turn + full).div_euclid(2 * full).rem_euclid(turn);
        let angle = Angle::degrees_fx(d);
        assert_eq!(i128::from(angle.to_bits()), wanted, "{d} degrees");
        assert_eq!(i128::from(angle.to_degrees().to_bits()), bits.rem_euclid(full), "{d} degrees and back");

        let units = number(&mut rng) as u32;
        let wanted = (2 * i128::from(units) * full + turn).div_euclid(2 * turn).rem_euclid(full);
        assert_eq!(i128::from(Angle::from_bits(units).to_degrees().to_bits()), wanted, "{units} units");
    }
    for whole in -32_768..=32_767 {
        assert_eq!(Angle::degrees_fx(I16F16::from_num(whole)), Angle::degrees(whole), "{whole} degrees");
    }
    assert_eq!(RIGHT_ANGLE.to_bits(), 1 << 30);
}

type Pixels = BTreeSet<(i64, i64)>;

/// The pixels of a small rectangle.
fn pixels(r: Rect) -> Pixels {
    let (width, height) = (i64::from(r.x1) - i64::from(r.x0), i64::from(r.y1) - i64::from(r.y0));
    assert!(width < 50 && height < 50, "{r:?} is not small");
    let rows = i64::from(r.y0)..i64::from(r.y1);
    rows.flat_map(|y| (i64::from(r.x0)..i64::from(r.x1)).map(move |x| (x, y))).collect()
}

/// Those that a rectangle can hold: the last column and row of `i32` are never inside of one.
fn possible(all: impl Iterator<Item = (i64, i64)>) -> Pixels {
    let possible = |n: i64| i64::from(i32::MIN) <= n && n < i64::from(i32::MAX);
    all.filter(|&(x, y)| possible(x) && possible(y)).collect()
}

/// Small, somewhere on the plane, often at its ends, sometimes empty or inside out.
fn small(rng: &mut Rng) -> Rect {
    let start = |rng: &mut Rng| rng.pick(&[i32::MIN, i32::MIN + 2, -3, 0, i32::MAX - 6, i32::MAX]);
    let (x, y) = (start(rng), start(rng));
    let mut end = |n: i32| n.saturating_add(rng.int(-1, 6));
    Rect::new(x, y, end(x), end(y))
}

#[test]
fn rectangles_are_sets_of_pixels() {
    let mut rng = Rng::new(903);
    for _ in 0..40_000 {
        let a = small(&mut rng);
        // Near the first one, so that both together are small.
        let near = |n: i32, by: i32| n.saturating_add(by);
        let mut by = || rng.int(-5, 9);
        let b = Rect::new(near(a.x0, by()), near(a.y0, by()), near(a.x0, by()), near(a.y0, by()));
        let both: Pixels = pixels(a).union(&pixels(b)).copied().collect();
        let held = |all: &Pixels, pick: fn(&(i64, i64)) -> i64| {
            all.iter().map(pick).min().zip(all.iter().map(pick).max()).map_or(0..0, |(low, high)| low..high + 1)
        };
        let (columns, rows) = (held(&both, |p| p.0), held(&both, |p| p.1));
        let wanted: Pixels = rows.flat_map(|y| columns.clone().map(move |x| (x, y))).collect();
        assert_eq!(pixels(a.union(b)), wanted, "{a:?} and {b:?}");
        let common: Pixels = pixels(a).intersection(&pixels(b)).copied().collect();
        assert_eq!(pixels(a.intersection(b)), common, "{a:?} and {b:?}");

        let (dx, dy) = (number(&mut rng), number(&mut rng));
        let moved = possible(pixels(a).into_iter().map(|(x, y)| (x + i64::from(dx), y + i64::from(dy))));
        assert_eq!(pixels(a.translate(dx, dy)), moved, "{a:?} moved by {dx} {dy}");

        let n = rng.int(-4, 4);
        let around = |(x, y): (i64, i64)| {
            let reach = i64::from(n.abs());
            (y - reach..=y + reach).flat_map(move |v| (x - reach..=x + reach).map(move |u| (u, v)))
        };
        let all = pixels(a);
        let wanted = if n < 0 {
            possible(all.iter().flat_map(|&p| around(p)))
        } else {
            all.iter().copied().filter(|&p| around(p).all(|q| all.contains(&q))).collect()
        };
        let inner = a.inset(n);
        assert_eq!(pixels(inner), wanted, "{a:?} inset by {n}");
        assert!(all.is_empty() || (inner.x0 <= inner.x1 && inner.y0 <= inner.y1), "{inner:?} is inside out");
    }
}

#[test]
fn wide_rectangles_are_inset() {
    let everything = Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX);
    assert_eq!(everything.inset(i32::MAX), Rect::new(-1, -1, 0, 0));
    assert_eq!(everything.inset(i32::MIN), everything);
    let row = Rect::new(i32::MIN, 5, i32::MAX, 6);
    assert_eq!(row.inset(-2), Rect::new(i32::MIN, 3, i32::MAX, 8));
    assert!(row.inset(1).is_empty() && row.inset(i32::MAX).is_empty(), "one row");
    assert_eq!(Rect::new(0, 0, 1, 1).inset(i32::MIN), everything);
}

#[test]
fn rectangles_by_size() {
    let mut rng = Rng::new(904);
    for _ in 0..100_000 {
        let at = Point::new(number(&mut rng), number(&mut rng));
        let size = if rng.one_in(2) {
            Size::new(rng.below(9) as u32, rng.below(9) as u32)
        } else {
            Size::new(number(&mut rng) as u32, number(&mut rng) as u32)
        };
        let (x, y, w, h) = (i64::from(at.x), i64::from(at.y), i64::from(size.width), i64::from(size.height));
        let sides = |x: i64, y: i64| Rect::new(stop(x), stop(y), stop(x + w), stop(y + h));
        let corner = Rect::with_size(at, size);
        assert_eq!(corner, sides(x, y), "{size:?} at {at:?}");
        assert_eq!(corner.top_left(), at);
        assert_eq!(Rect::from(Rectangle::new(at, size)), corner);
        let (left, above) = ((w - 1).max(0) / 2, (h - 1).max(0) / 2);
        let around = Rect::from_center(at, size);
        assert_eq!(around, sides(x - left, y - above), "{size:?} around {at:?}");
        // Where nothing is cut off, it is what embedded-graphics says.
        let is_i32 = |n: i64| i32::try_from(n).is_ok();
        let fits = |at: i64, n: i64| is_i32(at - n / 2 - 1) && is_i32(at + n / 2 + 1) && is_i32(n);
        if fits(x, w) && fits(y, h) {
            assert_eq!(around.size(), size, "{size:?} around {at:?}");
            assert_eq!(Rectangle::from(around), Rectangle::with_center(at, size), "{size:?} around {at:?}");
        }
    }
    assert_eq!(WINDOW, Rect::new(3, 3, 321, 241));
}
