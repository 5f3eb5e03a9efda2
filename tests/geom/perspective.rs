//! Values in perspective against exact ratios at every pixel.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    clippy::float_arithmetic,
    reason = "random numbers, cut on purpose; bounds of runs are irrational"
)]

use embedded_raster::{
    geom::{Facet, Fast, Perspective, Plane, Runs, Varying},
    raster::triangle,
    ClippedSpan,
};
use fixed::types::I16F16;
use twins::{
    corners, planes,
    rng::{cases, Rng},
    Units,
};

const TRIANGLES: usize = 40_000;

/// The exact value at a pixel as a ratio, both parts positive or the first one negative, from values and distances.
fn exact(units: [Units; 3], values: [i64; 3], w: [i64; 3], x: i32, y: i32) -> (i128, i128) {
    let [a, b, c] = w;
    let others = [b * c, c * a, a * b];
    let of = |i: usize| values[i] * others[i];
    let (sum, _) = planes::ratio(units, [of(0), of(1), of(2)], x, y);
    let (nearness, _) = planes::ratio(units, others, x, y);
    (sum, nearness)
}

/// Distances that differ by up to a factor.
fn distances(rng: &mut Rng, ratio: i64) -> [i64; 3] {
    let near = rng.range(1, 4_000);
    [(); 3].map(|()| {
        let any = rng.range(near, near * ratio);
        rng.pick(&[near, near * ratio, any])
    })
}

/// Random triangles, with the pixels of a window on each, row by row.
fn each_row(
    seed: u64,
    ratio: i64,
    values: impl Fn(&mut Rng) -> i64,
    mut check: impl FnMut(&Facet, [Units; 3], [i64; 3], [i64; 3], ClippedSpan),
) {
    let mut rng = Rng::new(seed);
    for kind in 0..cases(TRIANGLES) {
        let (units, window) = planes::triangle_of_kind(&mut rng, kind);
        let facet = Facet::new(corners(units)).unwrap();
        let (values, w) = ([(); 3].map(|()| values(&mut rng)), distances(&mut rng, ratio));
        triangle::fill(corners(units), window, |span: ClippedSpan| check(&facet, units, values, w, span));
    }
}

fn with<V: Copy>(values: [i64; 3], w: [i64; 3], from: impl Fn(i64) -> V) -> [Perspective<V>; 3] {
    [0, 1, 2].map(|i| Perspective { w: I16F16::from_bits(w[i] as i32), value: from(values[i]) })
}

/// Values are the nearest but for `range ratio 2^-27`, in range, constant where the corners are equal, and the same wherever a row
/// begins. Distances are right but for 2^-20.
fn check<V: Copy>(
    seed: u64,
    ratio: i64,
    values: impl Fn(&mut Rng) -> i64,
    from: impl Fn(i64) -> V + Copy,
    to: impl Fn(V) -> i64 + Copy,
) where
    Perspective<V>: Varying,
{
    let mut seen = 0;
    each_row(seed, ratio, values, |facet, units, values, w, span| {
        let plane = Plane::new(facet, with(values, w, from));
        let (least, most) = (*values.iter().min().unwrap(), *values.iter().max().unwrap());
        let mut columns = span.x0()..span.x1();
        plane.each(span.x0(), span.y(), span.len(), |at| {
            let x = columns.next().unwrap();
            let (n, d) = exact(units, values, w, x, span.y());
            let got = to(at.value);
            let off = (2 * (i128::from(got) * d - n)).abs();
            // off / (2 d) <= 1/2 + range ratio 2^-27
            let more = i128::from(most - least) * i128::from(ratio);
            assert!(
                off << 27 <= (1 << 27) * d + 2 * more * d,
                "{units:?} {values:?} {w:?} at {x}, {}: {got}",
                span.y()
            );
            assert!((least..=most).contains(&got), "{units:?} {values:?} {w:?} at {x}, {}: {got}", span.y());
            // w = 1 / sum of weights / wi = w0 w1 w2 area / nearness
            let (_, area) = planes::ratio(units, [1; 3], x, span.y());
            let distance = w.iter().map(|&w| i128::from(w)).product::<i128>() * area;
            let off = (i128::from(at.w.to_bits()) * d - distance).abs();
            assert!(
                off <= 2 * d + ((distance * i128::from(ratio)) >> 27),
                "{units:?} {w:?} at {x}, {}: w {}",
                span.y(),
                at.w
            );
            seen += 1;
            if seen % 16 == 0 {
                assert_eq!(to(plane.at(x, span.y()).value), got, "{units:?} {values:?} {w:?} at {x}");
            }
        });
    });
    assert!(seen > 10 * cases(TRIANGLES), "only {seen} pixels");
}

fn bytes(rng: &mut Rng) -> i64 {
    let n = rng.range(0, 255);
    rng.pick(&[0, 255, n, n])
}

#[test]
fn bytes_in_perspective_are_the_nearest_ones() {
    check(1, 16, bytes, |n| n as u8, i64::from);
    check(2, 1, bytes, |n| n as u8, i64::from);
    check(3, 1000, bytes, |n| n as u8, i64::from);
    // What is equal is constant.
    let mut rng = Rng::new(4);
    each_row(5, 100, bytes, |facet, units, _, w, span| {
        let value = rng.int(0, 255);
        let plane = Plane::new(facet, with([value.into(); 3], w, |n| (n as u8, -n as i32)));
        plane.each(span.x0(), span.y(), span.len(), |at| {
            assert_eq!(at.value, (value as u8, -value), "{units:?} {w:?} in row {}", span.y());
        });
    });
}

#[test]
fn numbers_in_perspective_are_the_nearest_ones() {
    check(10, 16, |rng| rng.range(0, 65_535), |n| n as u16, i64::from);
    check(11, 16, |rng| rng.range(-32_768, 32_767), |n| n as i16, i64::from);
    let texels = |rng: &mut Rng| rng.range(-(1 << 23), 1 << 23);
    check(12, 16, texels, |n| I16F16::from_bits(n as i32), |n| n.to_bits().into());
    let pair = |n: i64| (I16F16::from_bits(n as i32), I16F16::from_bits(-n as i32));
    check(13, 16, texels, |n| Fast(pair(n)), |n: Fast<_>| n.0 .0.to_bits().into());
    check(14, 16, texels, |n| Fast(pair(n)), |n: Fast<_>| -i64::from(n.0 .1.to_bits()));
}

/// However far away, up to the largest distance that there is: within half a step of a byte and 1/256.
#[test]
fn bytes_are_the_nearest_ones_from_any_distance() {
    let mut rng = Rng::new(15);
    for kind in 0..cases(TRIANGLES) {
        let (units, window) = planes::triangle_of_kind(&mut rng, kind);
        let bits = rng.int(0, 27);
        let near = rng.range(1 << bits, (2 << bits) - 1);
        let w = [(); 3].map(|()| {
            let any = rng.range(near, near * 16);
            rng.pick(&[near, near * 16, any]).min(i32::MAX.into())
        });
        let (values, facet) = ([(); 3].map(|()| bytes(&mut rng)), Facet::new(corners(units)).unwrap());
        let plane = Plane::new(&facet, with(values, w, |n| n as u8));
        triangle::fill(corners(units), window, |span: ClippedSpan| {
            let mut columns = span.x0()..span.x1();
            plane.each(span.x0(), span.y(), span.len(), |at| {
                let x = columns.next().unwrap();
                // The share of each corner: its weight, divided by its distance. Below 2^43 times 2^62.
                let share = |i: usize| {
                    let (weight, _) = planes::ratio(units, [0, 1, 2].map(|j| i64::from(i == j)), x, span.y());
                    weight * i128::from(w[(i + 1) % 3]) * i128::from(w[(i + 2) % 3])
                };
                let shares = [share(0), share(1), share(2)];
                let sum: i128 = (0..3).map(|i| shares[i] * i128::from(i64::from(at.value) - values[i])).sum();
                let off = 256 * sum.abs();
                assert!(off <= 129 * shares.iter().sum::<i128>(), "{units:?} {values:?} {w:?} at {x}, {}", span.y());
            });
        });
    }
}

/// Both ends of each number.
#[test]
fn the_whole_range_is_kept() {
    let mut rng = Rng::new(20);
    let ends = |rng: &mut Rng| {
        let any = rng.range(i32::MIN.into(), i32::MAX.into());
        rng.pick(&[i32::MIN.into(), i32::MAX.into(), any])
    };
    for kind in 0..cases(TRIANGLES) {
        let (units, window) = planes::triangle_of_kind(&mut rng, kind);
        let (values, w) = ([(); 3].map(|()| ends(&mut rng)), [(); 3].map(|()| rng.bits() as i32));
        let (least, most) = (*values.iter().min().unwrap(), *values.iter().max().unwrap());
        let facet = Facet::new(corners(units)).unwrap();
        let at = |i: usize| Perspective { w: I16F16::from_bits(w[i]), value: values[i] as i32 };
        let plane = Plane::new(&facet, [at(0), at(1), at(2)]);
        let run = |i: usize| Runs::<_, 16> { w: at(i).w, value: at(i).value };
        let runs = Plane::new(&facet, [run(0), run(1), run(2)]);
        triangle::fill(corners(units), window, |span: ClippedSpan| {
            let inside = |n: i32| assert!((least..=most).contains(&i64::from(n)), "{units:?} {values:?} {w:?}: {n}");
            plane.each(span.x0(), span.y(), span.len(), |at| inside(at.value));
            runs.each(span.x0(), span.y(), span.len(), |at| inside(at.value));
        });
    }
}

/// Runs of N pixels: within their bound, which is that of the ratio of w along them, and below 3 % of the change.
fn runs<const N: u32, V: Copy>(
    seed: u64,
    ratio: i64,
    values: impl Fn(&mut Rng) -> i64,
    from: impl Fn(i64) -> V + Copy,
    to: impl Fn(V) -> i64,
    rounding: f64,
) where
    Runs<V, N>: Varying,
{
    let (mut seen, mut worst) = (0, 0.0_f64);
    each_row(seed, ratio, values, |facet, units, values, w, span| {
        let of = |i: usize| Runs { w: I16F16::from_bits(w[i] as i32), value: from(values[i]) };
        let plane = Plane::new(facet, [of(0), of(1), of(2)]);
        let real = |x: i32| {
            let (n, d) = exact(units, values, w, x, span.y());
            (n as f64 / d as f64, d as f64)
        };
        let range = values.iter().max().unwrap() - values.iter().min().unwrap();
        let near = (range * ratio) as f64 / f64::from(1 << 27);
        // The row as a whole, and what is left of it from the first third on.
        for start in [span.x0(), span.x0() + span.x1().abs_diff(span.x0()) as i32 / 3] {
            let mut columns = start..span.x1();
            plane.each(start, span.y(), span.x1().abs_diff(start), |at| {
                let x = columns.next().unwrap();
                // The run that the pixel lies in, if it has N pixels; shorter ones have less of an error.
                let x0 = start + (x - start) / N as i32 * N as i32;
                let (first, last) = (real(x0), real((x0 + N as i32).min(span.x1() - 1)));
                let r = (first.1 / last.1).max(last.1 / first.1).sqrt();
                let most = ((r - 1.0) / (r + 1.0)).min(0.03) * (last.0 - first.0).abs();
                let off = (to(at.value) as f64 - real(x).0).abs();
                let slack = near + if x == x0 { 0.5 } else { rounding };
                assert!(off <= most + slack, "{units:?} {values:?} {w:?} at {x}, {}: {off} > {most}", span.y());
                worst = worst.max((off - rounding) / (last.0 - first.0).abs().max(1.0));
                seen += 1;
            });
        }
    });
    assert!(seen > 10 * cases(TRIANGLES), "only {seen} pixels");
    assert!(ratio < 10 || worst > 0.001, "runs are no approximation: {worst}");
}

#[test]
fn runs_are_within_their_bound() {
    runs::<16, _>(30, 16, bytes, |n| n as u8, i64::from, 0.5);
    runs::<8, _>(31, 16, |rng| rng.range(0, 65_535), |n| n as u16, i64::from, 0.5);
    runs::<32, _>(32, 100, |rng| rng.range(-32_768, 32_767), |n| n as i16, i64::from, 0.5);
    let texels = |rng: &mut Rng| rng.range(-(1 << 23), 1 << 23);
    runs::<16, _>(33, 16, texels, |n| I16F16::from_bits(n as i32), |n| n.to_bits().into(), 0.5);
    let pair = |n: i64| (I16F16::from_bits(-n as i32), I16F16::from_bits(n as i32));
    // Whole bits are added.
    runs::<16, _>(34, 16, texels, |n| Fast(pair(n)), |n: Fast<_>| n.0 .1.to_bits().into(), 16.0);
}
