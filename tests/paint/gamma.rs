//! Light: tables against floating point, and means against a search of all levels.

use embedded_graphics_core::pixelcolor::{Gray2, Gray4, Gray8, GrayColor, Rgb565, RgbColor};
use embedded_raster::{
    paint::{CoverGamma, Gamma},
    pixel::Channels,
    raster::coverage,
    Antialias, Frame, Palette, PointFx, Rect,
};
use twins::{
    coverage::Levels,
    rng::{cases, Rng},
};

static SRGB: Gamma = Gamma::SRGB;
static POWER: Gamma = Gamma::power(11, 5);

/// The nearest number to 65,535 times the light, where floating point can tell.
fn check(gamma: &Gamma, light: impl Fn(f64) -> f64) {
    for (level, &got) in (0_u8..=255).zip(gamma.light()) {
        let wanted = 65_535.0 * light(f64::from(level) / 255.0);
        assert!((f64::from(got) - wanted).abs() <= 0.500_001, "{got} for {wanted} at {level}");
    }
}

#[test]
fn tables_are_the_nearest_numbers() {
    check(&SRGB, |v| if v <= 0.040_45 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) });
    for (n, d) in [(1, 1), (2, 1), (3, 1), (16, 1), (11, 5), (9, 5), (12, 5), (1, 5), (16, 5), (1, 2), (5, 3), (7, 4)] {
        check(&Gamma::power(n, d), |v| v.powf(f64::from(n) / f64::from(d)));
    }
    assert_eq!(Gamma::power(200, 9), Gamma::power(16, 5), "what is too much");
}

/// The level whose light is the nearest to the mean, the last one of two, by looking at all.
fn mean(gamma: &Gamma, [a, b]: [u8; 2], most: u8, level: u8) -> u8 {
    let of = |n: u8| {
        let level = (2 * u32::from(n) * 255 + u32::from(most)) / (2 * u32::from(most));
        i64::from(gamma.light()[level as usize])
    };
    if a == b {
        return a;
    }
    let sum = of(a) * i64::from(255 - level) + of(b) * i64::from(level);
    let light = (2 * sum + 255) / 510;
    (0..=most).rev().min_by_key(|&n| (of(n) - light).abs()).expect("there are levels")
}

/// Light that never rises at some levels, and that starts above 0.
fn odd() -> Gamma {
    Gamma::new(std::array::from_fn(|i| (900 + (i / 3) * (i / 3) * 8) as u16))
}

#[test]
fn means_of_light_are_the_nearest() {
    let mut rng = Rng::new(1_710);
    let odd = odd();
    for i in 0..cases(60_000) {
        let (gamma, is_strict) = [(&SRGB, true), (&POWER, true), (&odd, false)][i % 3];
        let (a, b, any) = (rng.bits() as u8, rng.bits() as u8, rng.bits() as u8);
        let level = rng.pick(&[0, 1, 127, 128, 254, 255, any, any]);
        let same = |got: u8, most: u8, ends: [u8; 2]| {
            let wanted = mean(gamma, ends, most, level);
            // Where several levels have the same light, any of them is right.
            let light =
                |n: u8| gamma.light()[((2 * u32::from(n) * 255 + u32::from(most)) / (2 * u32::from(most))) as usize];
            assert!(
                got == wanted || !is_strict && light(got) == light(wanted),
                "{got}, {wanted}: {ends:?} {level} {most}"
            );
        };
        let between = |ends: [u8; 2]| gamma.between(ends.map(Gray8::new), level).luma();
        same(between([a, b]), 255, [a, b]);
        let got = gamma.between([a, b].map(|n| Gray4::new(n & 15)), level).luma();
        same(got, 15, [a & 15, b & 15]);
        let got = gamma.between([a, b].map(|n| Gray2::new(n & 3)), level).luma();
        same(got, 3, [a & 3, b & 3]);
        let got = gamma.between([a, b].map(|n| Rgb565::new(n & 31, n & 63, !n & 31)), level);
        same(got.r(), 31, [a & 31, b & 31]);
        same(got.g(), 63, [a & 63, b & 63]);
        same(got.b(), 31, [!a & 31, !b & 31]);
    }
}

#[test]
fn what_is_light_stays_so() {
    // By light that is the level, it is what `between` does; and the ends are kept.
    let line = Gamma::power(1, 1);
    for (a, level) in (0..=255).flat_map(|a| (0..=255).map(move |level| (a, level))) {
        let ends = [Gray8::new(a), Gray8::new(200)];
        assert_eq!(line.between(ends, level), Gray8::between(ends, level), "{level} from {a} to 200");
        assert_eq!([SRGB.between(ends, 0), SRGB.between(ends, 255)], ends, "the ends");
        let tables = [Palette::new(ends), Palette::new([ends[1], ends[0]])];
        let faded = Palette::new([SRGB.between(ends, level), SRGB.between([ends[1], ends[0]], level)]);
        assert_eq!(SRGB.fade([&tables[0], &tables[1]], level), faded, "entry by entry");
    }
}

#[test]
fn rims_are_mixed_as_light() {
    let mut rng = Rng::new(1_720);
    let window = Rect::new(0, 0, 13, 9);
    for _ in 0..cases(200) {
        let corners = [(); 3].map(|()| PointFx::from_bits(rng.int(-900, 4_000), rng.int(-900, 3_000)));
        let mut levels = Levels::new(window);
        coverage::triangle(corners, &mut [], window, &mut levels);
        let memory: Vec<u8> = (0..13 * 9).map(|_| rng.bits() as u8).collect();
        let mut frame = Frame::<_, embedded_raster::surface::Rows<Gray8>>::new(memory.clone(), 13, 9).expect("memory");
        let color = rng.bits() as u8;
        frame.fill_triangle_aa(corners, &mut [], CoverGamma { color: Gray8::new(color), gamma: &SRGB });
        for (x, y) in (0..9).flat_map(|y| (0..13).map(move |x| (x, y))) {
            let old = memory[(y * 13 + x) as usize];
            let wanted = match levels.at(x, y) {
                0 => old,
                255 => color,
                level => mean(&SRGB, [old, color], 255, level),
            };
            assert_eq!(frame.get((x, y)), Some(Gray8::new(wanted)), "({x}, {y}), covered by {}", levels.at(x, y));
        }
    }
}
