//! Values over triangles against exact ratios at every pixel, up to the largest triangles that are allowed.
#![allow(
    clippy::cast_lossless,
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::missing_assert_message,
    clippy::redundant_closure,
    clippy::redundant_closure_for_method_calls,
    reason = "tests mix widths on purpose; the wide side is checked where it matters"
)]

use embedded_graphics_core::pixelcolor::{Bgr555, Rgb565, Rgb888, RgbColor};
use embedded_raster::{
    geom::{Barycentric, Facet, Fast, Plane, Varying},
    pixel::Rgb332,
    raster::triangle,
    ClippedSpan, PointFx, Rect, TriangleTooLarge,
};
use fixed::types::I16F16;
use twins::{
    corners,
    planes::{self, triangle_of_kind},
    rng::{cases, Rng},
    Units,
};

/// Triangles of each kind.
const TRIANGLES: usize = 30_000;

/// The most units that a box may have in width and height together.
const MOST: i32 = (Facet::MOST as i32) << 8;

/// Compares the values of all pixels of random triangles in a window with what is wanted. Returns how many were compared.
fn compare<V: Varying>(
    kind: impl Fn(usize) -> usize,
    seed: u64,
    values: impl Fn(&mut Rng) -> i64,
    from: impl Fn(i64) -> V,
    mut check: impl FnMut(V, (i128, i128), i128, u32) -> bool,
) -> u64 {
    let (mut rng, mut seen) = (Rng::new(seed), 0);
    for i in 0..cases(TRIANGLES) {
        let (units, window) = triangle_of_kind(&mut rng, kind(i));
        let values = [(); 3].map(|()| values(&mut rng));
        let facet = Facet::new(corners(units)).unwrap();
        let plane = Plane::new(&facet, values.map(&from));
        triangle::fill(corners(units), window, |span: ClippedSpan| {
            let mut columns = (span.x0()..span.x1()).zip(0..);
            plane.each(span.x0(), span.y(), span.len(), |got| {
                let (x, n) = columns.next().unwrap();
                let wanted = planes::nearest(units, values, x, span.y());
                let ratio = planes::ratio(units, values, x, span.y());
                assert!(check(got, ratio, wanted, n), "{units:?} with {values:?} at {x}, {}: not {wanted}", span.y());
                assert!((*values.iter().min().unwrap()..=*values.iter().max().unwrap()).contains(&(wanted as i64)));
                seen += 1;
            });
        });
    }
    seen
}

fn exact<V: Varying + Into<i128>>(seed: u64, low: i64, high: i64, from: impl Fn(i64) -> V) {
    let values = |rng: &mut Rng| {
        let n = rng.range(low, high);
        rng.pick(&[low, high, n, n])
    };
    let seen = compare(|i| i, seed, values, from, |got, _, wanted, _| got.into() == wanted);
    assert!(seen > 10 * cases(TRIANGLES) as u64, "only {seen} pixels");
}

#[test]
fn bytes_are_the_nearest_ones() {
    exact(1, 0, 255, |n| n as u8);
}

#[test]
fn numbers_of_16_bits_are_the_nearest_ones() {
    exact(2, 0, 65_535, |n| n as u16);
    exact(3, -32_768, 32_767, |n| n as i16);
}

#[test]
fn numbers_of_32_bits_are_the_nearest_ones() {
    exact(4, i32::MIN.into(), i32::MAX.into(), |n| n as i32);
    exact(5, 0, u32::MAX.into(), |n| n as u32);
    let values = |rng: &mut Rng| rng.range(-70_000, 70_000);
    compare(|i| i, 6, values, |n| I16F16::from_bits(n as i32), |got, _, wanted, _| i128::from(got.to_bits()) == wanted);
}

/// The triangles at the bound of the proof: the largest area, one unit of value in it, and rows as long as they get.
#[test]
fn the_largest_triangles_are_exact() {
    let half = MOST / 2;
    for units in [
        [(0, 0), (half, 0), (0, half)],
        [(0, 0), (half, half), (0, half)],
        [(0, 0), (half, 0), (half - 1, half)],
        [(0, 1), (MOST - 300, 0), (MOST - 700, 299)],
        [(0, 0), (255, MOST - 256), (1, MOST - 300)],
        [(-half, -half), (0, -1), (-1, 0)],
    ] {
        for values in [[0, 1, 0], [0, 255, 254], [255, 254, 255], [7, 7, 8], [0, 255, 0], [13, 13, 13]] {
            let facet = Facet::new(corners(units)).unwrap();
            let bytes = Plane::new(&facet, values.map(|n: i64| n as u8));
            let words = Plane::new(&facet, values.map(|n| n as u32));
            let rows = (units.iter().map(|p| p.1 >> 8).min().unwrap(), units.iter().map(|p| p.1 >> 8).max().unwrap());
            for y in (rows.0..=rows.1).step_by(((rows.1 - rows.0) / 9).max(1) as usize) {
                let window = Rect::new(-20_000, y, 20_000, y + 1);
                triangle::fill(corners(units), window, |span: ClippedSpan| {
                    let mut row = vec![];
                    bytes.each(span.x0(), y, span.len(), |byte| row.push(u32::from(byte)));
                    let mut columns = (span.x0()..span.x1()).zip(row);
                    words.each(span.x0(), y, span.len(), |word| {
                        let (x, byte) = columns.next().unwrap();
                        let wanted = planes::nearest(units, values, x, y);
                        assert_eq!(i128::from(byte), wanted, "{units:?} {values:?} at {x}, {y}");
                        assert_eq!(i128::from(word), wanted, "{units:?} {values:?} at {x}, {y}");
                    });
                });
            }
        }
    }
}

#[test]
fn fast_values_stay_in_their_bound_and_in_range() {
    // |got - n / d| is at most 1/2 + steps 2^-16, and one unit more for where the row starts.
    let bound = |got: i128, (n, d): (i128, i128), steps: u32| {
        (got * d - n).abs() << 17 <= d * (65_536 + 2 * (i128::from(steps) + 1))
    };
    let byte = |rng: &mut Rng| rng.range(0, 255);
    for (seed, kinds) in [(7, 6), (8, 4)] {
        let (mut wrong, kind) = (0, |i| i % kinds + i / kinds % 8 * 6);
        let seen = compare(
            kind,
            seed,
            byte,
            |n| Fast(n as u8),
            |Fast(got), ratio, wanted, steps| {
                wrong += u64::from(i128::from(got) != wanted);
                bound(got.into(), ratio, steps)
            },
        );
        println!("{wrong} of {seen} fast values are not the nearest ones");
        // On a screen of 300 x 300 pixels; one in a hundred in rows of up to 12,288.
        let most = if kinds == 4 { 3 } else { 10 };
        assert!(wrong * 1000 <= seen * most, "{wrong} of {seen} values are not the nearest ones");
    }
    let word = |rng: &mut Rng| rng.range(0, 65_535);
    compare(|i| i, 9, word, |n| Fast(n as u16), |Fast(got), ratio, _, steps| bound(got.into(), ratio, steps));
}

#[test]
fn arrays_and_tuples_are_their_parts() {
    let facet = Facet::new([PointFx::px(3, 2), PointFx::px(90, 31), PointFx::px(40, 77)]).unwrap();
    let plane =
        Plane::new(&facet, [(1_u8, [5_u16, 6, 7], -4_i32), (200, [1000, 0, 7], 9), (60, [60_000, 8, 7], 1 << 30)]);
    let byte = Plane::new(&facet, [1_u8, 200, 60]);
    let words = [[5_u16, 1000, 60_000], [6, 0, 8], [7, 7, 7]].map(|values| Plane::new(&facet, values));
    let number = Plane::new(&facet, [-4_i32, 9, 1 << 30]);
    for (x, y) in [(40, 30), (41, 60), (60, 33)] {
        let (a, b, c) = plane.at(x, y);
        assert_eq!((a, c), (byte.at(x, y), number.at(x, y)));
        assert_eq!(b, words.each_ref().map(|word| word.at(x, y)));
    }
}

/// Cut where the values are whole, a triangle shows the same.
#[test]
fn a_split_triangle_shows_the_whole() {
    let (mut rng, mut seen) = (Rng::new(9), 0);
    for _ in 0..cases(3000) {
        // Corners and values that are multiples of 8: halves, quarters and eighths of a side are places with whole values.
        let mut corner = || ((rng.int(-20, 60) * 256, rng.int(-20, 60) * 256), rng.range(0, 31) * 8);
        let [a, b, c] = [corner(), corner(), corner()];
        let part = i32::from(rng.int(1, 7) as i16);
        let on = |a: i32, b: i32| a + (b - a) * part / 8;
        let cut = ((on(b.0 .0, c.0 .0), on(b.0 .1, c.0 .1)), b.1 + (c.1 - b.1) * i64::from(part) / 8);
        let draw = |parts: &[[(Units, i64); 3]]| {
            let mut pixels = vec![];
            for part in parts {
                let facet = Facet::new(corners(part.map(|p| p.0))).unwrap();
                let plane = Plane::new(&facet, part.map(|p| (p.1 as u8, p.1 as i32, I16F16::from_num(p.1))));
                triangle::fill(corners(part.map(|p| p.0)), Rect::new(0, 0, 40, 40), |span: ClippedSpan| {
                    let mut columns = span.x0()..span.x1();
                    plane.each(span.x0(), span.y(), span.len(), |value| {
                        pixels.push((span.y(), columns.next().unwrap(), value));
                    });
                });
            }
            pixels.sort_unstable();
            pixels
        };
        let whole = draw(&[[a, b, c]]);
        assert_eq!(whole, draw(&[[a, b, cut], [cut, a, c]]), "{a:?} {b:?} {c:?} at {cut:?}");
        seen += whole.len();
    }
    assert!(seen > 1000);
}

#[test]
fn too_large_a_triangle_is_an_error_with_its_numbers() {
    let at = PointFx::from_bits;
    let error = Facet::new([at(0, 0), at(MOST, 1), at(5, 0)]).unwrap_err();
    assert_eq!(error, TriangleTooLarge { width: 12_288, height: 1, most: 12_288 });
    assert_eq!(error.to_string(), "triangle or line too large: 12288 x 1 pixels, shades take 12288 for both together");
    let error = Facet::new([at(i32::MIN, 0), at(i32::MAX, i32::MIN), at(5, i32::MAX)]).unwrap_err();
    assert_eq!(error, TriangleTooLarge { width: 1 << 24, height: 1 << 24, most: 12_288 });
    // Anywhere on the plane.
    let far = i32::MAX - MOST;
    assert!(Facet::new([at(far, far), at(i32::MAX, far), at(far + 9, far)]).is_ok());
    assert!(Facet::new([at(i32::MIN, 0), at(i32::MIN, MOST), at(i32::MIN, 9)]).is_ok());
}

/// The triangle, and the places, of the lecture.
#[test]
fn weights_of_the_lecture() {
    let corners = [PointFx::px(10, 5), PointFx::px(20, 15), PointFx::px(5, 15)];
    for corners in [corners, [corners[0], corners[2], corners[1]]] {
        let facet = Facet::new(corners).unwrap();
        let at = |x, y| facet.weights(PointFx::px(x, y));
        assert_eq!(at(10, 5).parts(), [I16F16::ONE, I16F16::ZERO, I16F16::ZERO]);
        assert!(at(10, 12).is_strictly_inside());
        assert!(at(10, 5).is_inside() && !at(10, 5).is_strictly_inside());
        assert!(!at(5, 5).is_inside() && !at(25, 13).is_inside());
    }
    // Fifths, from u = 1 down to -0.2 and from v = 1.2 down to -0.2.
    let grid = (-1..=5).flat_map(|u| (-1..=6).map(move |v| Barycentric { weights: [u, v, 5 - u - v], total: 5 }));
    assert_eq!(grid.clone().count(), 56);
    assert_eq!(grid.clone().filter(Barycentric::is_inside).count(), 21);
    assert_eq!(grid.filter(Barycentric::is_strictly_inside).count(), 6);
    // In tenths and in hundredths.
    let mix = |weights, vectors: [[i32; 3]; 3]| {
        let place = Barycentric { weights, total: 10 };
        [0, 1, 2].map(|i| place.mix(vectors.map(|v| v[i])))
    };
    assert_eq!(mix([2, 3, 5], [[0, 0, 10], [10, 0, 10], [0, 10, 10]]), [3, 5, 10]);
    assert_eq!(mix([1, 7, 2], [[10, 0, 8], [20, 0, 8], [10, 10, 8]]), [17, 2, 8]);
    assert_eq!(mix([2, 3, 5], [[100, 0, 0], [100, 20, 0], [100, 0, 20]]), [100, 6, 10]);
}

#[test]
fn weights_are_exact_anywhere_and_parts_sum_to_one() {
    let mut rng = Rng::new(10);
    for i in 0..cases(100_000) {
        let (units, window) = triangle_of_kind(&mut rng, i % 48);
        let at = if rng.one_in(9) {
            (i32::MIN, i32::MAX)
        } else {
            (window.x0 * 256 + rng.int(0, 5000), window.y0 * 256 + rng.int(0, 700))
        };
        let got = Facet::new(corners(units)).unwrap().weights(PointFx::from_bits(at.0, at.1));
        let twice = |a, b, c| twins::twice_area(a, b, c);
        let [a, b, c] = units;
        let sign = if twice(a, b, c) < 0 { -1 } else { 1 };
        let wanted = [twice(b, c, at), twice(c, a, at), twice(a, b, at)].map(|w| w * sign);
        assert_eq!(got.weights.map(i128::from), wanted, "{units:?} at {at:?}");
        assert_eq!(i128::from(got.total), wanted.iter().sum::<i128>());
        let parts = got.parts().map(|part| part.to_bits());
        let total = i128::from(got.total);
        if total > 0 && wanted.iter().all(|w| w.abs() >> 15 < total) {
            assert_eq!(parts.iter().map(|&p| i64::from(p)).sum::<i64>(), 65_536, "{units:?} at {at:?}");
            for (part, wanted) in parts.iter().zip(wanted) {
                let off = (i128::from(*part) * total - (wanted << 16)).abs();
                assert!(off <= total, "{units:?} at {at:?}: {part}");
            }
        }
        let values = [(); 3].map(|()| rng.int(i32::MIN, i32::MAX));
        if total > 0 {
            let sum: i128 = wanted.iter().zip(values).map(|(w, v)| w * i128::from(v)).sum();
            let mean = (2 * sum + total).div_euclid(2 * total).clamp(i32::MIN.into(), i32::MAX.into());
            assert_eq!(i128::from(got.mix(values)), mean, "{units:?} at {at:?} of {values:?}");
        }
    }
}

/// Pixels that lie far in their row and just short of the next level: a run that went on for too long would have reached it.
#[test]
fn colors_of_long_rows_are_the_nearest_ones() {
    for (units, values, y, x) in [
        ([(717_943, 687_199), (986_983, 1_198_265), (17_000, 1_214_700)], [29, 16, 28], 4178, 3212),
        ([(1_238_193, 634_168), (184_418, 52_546), (1_084_504, 88_896)], [22, 5, 19], 1000, 2551),
        ([(1_128_048, 1_329_180), (624_524, 927_619), (1_202_956, 199_866)], [3, 11, 12], 4089, 4371),
    ] {
        let plane = Plane::new(&Facet::new(corners(units)).unwrap(), values.map(|n: u8| Rgb565::new(n, n, n)));
        triangle::fill(corners(units), Rect::new(0, y, 20_000, y + 1), |span: ClippedSpan| {
            let mut row = vec![];
            plane.each(span.x0(), y, span.len(), |color| row.push(color));
            let (got, wanted) = (row[(x - span.x0()) as usize], planes::nearest(units, values.map(i64::from), x, y));
            assert_eq!([got.r(), got.g(), got.b()].map(i128::from), [wanted; 3], "{units:?} at {x}, {y}");
        });
    }
}

/// Each channel of a colour by itself, in all their packings.
#[test]
fn colors_have_the_nearest_levels() {
    fn levels<C: Varying + RgbColor>(seed: u64, kinds: &[usize], from: impl Fn([u8; 3]) -> C) {
        let (mut rng, mut seen) = (Rng::new(seed), 0);
        for i in 0..cases(TRIANGLES) {
            let (units, window) = triangle_of_kind(&mut rng, kinds[i % kinds.len()]);
            let colors = [(); 3].map(|()| from([(); 3].map(|()| rng.int(0, 255) as u8)));
            let plane = Plane::new(&Facet::new(corners(units)).unwrap(), colors);
            triangle::fill(corners(units), window, |span: ClippedSpan| {
                let mut columns = span.x0()..span.x1();
                plane.each(span.x0(), span.y(), span.len(), |got| {
                    let x = columns.next().unwrap();
                    for channel in [C::r, C::g, C::b] {
                        let values = colors.each_ref().map(|c| i64::from(channel(c)));
                        let wanted = planes::nearest(units, values, x, span.y());
                        assert_eq!(i128::from(channel(&got)), wanted, "{units:?} with {values:?} at {x}, {}", span.y());
                    }
                    seen += 1;
                });
            });
        }
        assert!(seen > cases(TRIANGLES));
    }
    let all: Vec<usize> = (0..48).collect();
    levels(11, &all, |[r, g, b]| Rgb565::new(r, g, b));
    levels(12, &all, |[r, g, b]| Rgb888::new(r, g, b));
    levels(13, &all, |[r, g, b]| Rgb332::new(r, g, b));
    levels(14, &all, |[r, g, b]| Bgr555::new(r, g, b));
    // Large triangles only: runs of a few pixels, and of one.
    let large: Vec<usize> = (0..48).filter(|kind| kind % 6 >= 3).collect();
    levels(15, &large, |[r, g, b]| Rgb565::new(r, g, b));
}
