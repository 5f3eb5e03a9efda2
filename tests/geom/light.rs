//! Light, against floats.

#![allow(clippy::float_arithmetic, reason = "the reference")]

use embedded_raster::{
    geom::space::light::{diffuse, half_way, specular, Gloss},
    Vec3,
};
use fixed::types::I16F16;
use twins::rng::{cases, Rng};

use crate::space::{float, floats, ulps, vector};

static WOOD: Gloss = Gloss::new(10);

#[test]
fn powers_are_as_near_as_they_say() {
    for exponent in (0..300).chain([500, 999, 1_000, 4_095, 20_000, 65_535]) {
        let gloss = Gloss::new(exponent);
        let step = if exponent % 50 == 10 { 1 } else { 97 };
        let mut worst = 0.0_f64;
        let mut last = I16F16::ZERO;
        for bits in (0..=65_536).step_by(step).chain(65_300..=65_536) {
            let x = I16F16::from_bits(bits);
            let got = gloss.power(x);
            worst = worst.max((float(got) - float(x).powf(f64::from(exponent.max(1)))).abs());
            assert!(got >= last || bits == 65_300, "{exponent}: it falls at {x}");
            last = got;
        }
        assert!(worst < 0.002, "{worst} of {exponent}");
        let large = [I16F16::ONE, I16F16::from_num(2), I16F16::MAX];
        assert_eq!(large.map(|x| gloss.power(x)), [I16F16::ONE; 3]);
        assert_eq!([I16F16::ZERO, -I16F16::ONE, I16F16::MIN].map(|x| gloss.power(x)), [I16F16::ZERO; 3]);
    }
    assert_eq!(WOOD, Gloss::new(10));
}

#[test]
fn cosines_and_halves() {
    let mut rng = Rng::new(1230);
    let (mut cosine, mut half, mut shine) = (0.0_f64, 0.0_f64, 0.0_f64);
    for _ in 0..cases(300_000) {
        let [normal, light, eye] = [(); 3].map(|()| vector(&mut rng).normalize());
        let (n, l, e) = (floats(normal), floats(light), floats(eye));
        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        cosine = cosine.max(ulps(diffuse(normal, light), dot(n, l).clamp(0.0, 1.0)));
        let sum = [l[0] + e[0], l[1] + e[1], l[2] + e[2]];
        let length = dot(sum, sum).sqrt();
        let h = half_way(light, eye);
        if length == 0.0 {
            assert_eq!(h, Vec3::ZERO);
            continue;
        }
        for (got, x) in [h.x, h.y, h.z].into_iter().zip(sum) {
            half = half.max(ulps(got, x / length));
        }
        let got = float(specular(normal, light, h, &WOOD));
        // The rule, with the cosine that goes into it: a power of 10 makes ten times its error of it.
        let wanted = if diffuse(normal, light) == 0 { 0.0 } else { dot(n, floats(h)).clamp(0.0, 1.0).powi(10) };
        shine = shine.max((got - wanted).abs());
    }
    assert!(cosine <= 0.5 && half < 0.501 && shine < 0.0021, "{cosine}, {half}, {shine}");
    // Any bits.
    for _ in 0..cases(100_000) {
        let [a, b, c] = [(); 3].map(|()| vector(&mut rng));
        for x in [diffuse(a, b), specular(a, b, c, &WOOD)] {
            assert!((I16F16::ZERO..=I16F16::ONE).contains(&x), "{x}");
        }
    }
}
