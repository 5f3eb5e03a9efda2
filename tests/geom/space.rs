//! Numbers and vectors in space, against exact integers and, for roots and angles, against floats whose own error is below a
//! thousandth of what is tested.

#![allow(
    clippy::float_arithmetic,
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "the reference"
)]

use embedded_raster::{
    geom::space::number::{cos_sin, divide, inverse_root, reciprocal, square_root},
    Angle, Vec3, Vec4,
};
use fixed::types::I16F16;
use twins::rng::{cases, Rng};

/// Numbers that break arithmetic, and all others.
pub(crate) fn number(rng: &mut Rng) -> i32 {
    match rng.below(8) {
        0 => rng.pick(&[i32::MIN, i32::MIN + 1, -65_537, -65_536, -1, 0, 1, 65_535, 65_536, i32::MAX - 1, i32::MAX]),
        1 => rng.bits() as i32,
        _ => rng.bits() as i32 >> rng.below(32),
    }
}

pub(crate) fn vector(rng: &mut Rng) -> Vec3 {
    let shift = rng.below(32);
    Vec3::from_bits(if rng.one_in(2) {
        [(); 3].map(|()| number(rng))
    } else {
        [(); 3].map(|()| rng.bits() as i32 >> shift)
    })
}

pub(crate) fn float(x: I16F16) -> f64 {
    x.to_num()
}

pub(crate) fn floats(v: Vec3) -> [f64; 3] {
    [v.x, v.y, v.z].map(float)
}

/// How many units of 2^-16 a number is away from what it should be, or from the end of the range that is nearest to that.
pub(crate) fn ulps(got: I16F16, wanted: f64) -> f64 {
    (float(got) - wanted.clamp(float(I16F16::MIN), float(I16F16::MAX))).abs() * 65_536.0
}

/// `n / d` rounded to the nearest number, halves upwards, cut off at the ends of the range.
pub(crate) fn nearest(n: i128, d: i128) -> i32 {
    let (n, d) = if d < 0 { (-n, -d) } else { (n, d) };
    (2 * n + d).div_euclid(2 * d).clamp(i32::MIN.into(), i32::MAX.into()) as i32
}

fn wide(v: Vec3) -> [i128; 3] {
    v.to_bits().map(i128::from)
}

#[test]
fn quotients_are_the_nearest() {
    let mut rng = Rng::new(1200);
    for _ in 0..cases(3_000_000) {
        let (a, b) = (number(&mut rng), number(&mut rng));
        let got = divide(I16F16::from_bits(a), I16F16::from_bits(b)).to_bits();
        let wanted = if b == 0 {
            a.signum().saturating_mul(i32::MAX) - i32::from(a < 0)
        } else {
            nearest(i128::from(a) << 16, b.into())
        };
        assert_eq!(got, wanted, "{a} / {b}");
    }
    // Every reciprocal that is not one of a few small numbers.
    for bits in (-200_000..200_000).filter(|&bits| bits != 0) {
        assert_eq!(reciprocal(I16F16::from_bits(bits)).to_bits(), nearest(1 << 32, bits.into()), "1 / {bits}");
    }
}

#[test]
fn roots_are_as_near_as_they_say() {
    let mut rng = Rng::new(1201);
    let (mut root, mut inverse) = (0.0_f64, 0.0_f64);
    for i in 0..cases(3_000_000) {
        let bits = if i < 300_000 { 1 + i as i32 } else { number(&mut rng).saturating_abs().max(1) };
        let x = I16F16::from_bits(bits);
        root = root.max(ulps(square_root(x), float(x).sqrt()));
        inverse = inverse.max(ulps(inverse_root(x), 1.0 / float(x).sqrt()));
    }
    assert!(root <= 0.5 && inverse < 0.52, "{root}, {inverse}");
    assert!(
        [0, -1, i32::MIN].map(I16F16::from_bits).iter().all(|&x| square_root(x) == 0 && inverse_root(x) == I16F16::MAX),
        "no root"
    );
}

#[test]
fn cosine_and_sine_are_as_near_as_they_say() {
    let mut rng = Rng::new(1202);
    let mut worst = 0.0_f64;
    for _ in 0..cases(1_000_000) {
        let turn = rng.bits() as u32;
        let (x, y) = cos_sin(Angle::from_bits(turn));
        let angle = f64::from(turn) / 4_294_967_296.0 * core::f64::consts::TAU;
        worst = worst.max(ulps(x, angle.cos())).max(ulps(y, angle.sin()));
    }
    assert!(worst < 0.5001, "{worst}");
    assert_eq!(cos_sin(Angle::degrees(180)), (-I16F16::ONE, I16F16::ZERO));
}

#[test]
fn products_of_vectors_are_rounded_once() {
    let mut rng = Rng::new(1203);
    for _ in 0..cases(1_000_000) {
        let (a, b, factor) = (vector(&mut rng), vector(&mut rng), number(&mut rng));
        let ([ax, ay, az], [bx, by, bz]) = (wide(a), wide(b));
        let rounded = |n: i128| nearest(n, 1 << 16);
        assert_eq!(a.dot(b).to_bits(), rounded(ax * bx + ay * by + az * bz), "{a:?} . {b:?}");
        let cross = [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx].map(rounded);
        assert_eq!(a.cross(b).to_bits(), cross, "{a:?} x {b:?}");
        let scaled = [ax, ay, az].map(|x| rounded(x * i128::from(factor)));
        assert_eq!((a * I16F16::from_bits(factor)).to_bits(), scaled, "{a:?} * {factor}");
        let (v, w) = (number(&mut rng), number(&mut rng));
        let (p, q) = (a.with_w(I16F16::from_bits(v)), b.with_w(I16F16::from_bits(w)));
        let sum = ax * bx + ay * by + az * bz + i128::from(v) * i128::from(w);
        assert_eq!(p.dot(q).to_bits(), rounded(sum), "{p:?} . {q:?}");
        let saturated = |n: i128| n.clamp(i32::MIN.into(), i32::MAX.into()) as i32;
        assert_eq!((a - b).to_bits(), [ax - bx, ay - by, az - bz].map(saturated));
        assert_eq!((p + q).xyz(), a + b);
        assert_eq!((-p).xyz().to_bits(), [ax, ay, az].map(|x| saturated(-x)));
        if w != 0 {
            let wanted = [bx, by, bz].map(|x| nearest(x << 16, w.into()));
            assert_eq!(q.project().to_bits(), wanted, "{q:?}");
        }
    }
    assert_eq!(Vec4::whole(1, 0, -1, 0).project(), Vec3::new(I16F16::MAX, I16F16::ZERO, I16F16::MIN));
    let most = Vec4::from_bits([i32::MIN; 4]);
    assert_eq!((most.dot(most), most.dot(-most)), (I16F16::MAX, I16F16::MIN));
}

#[test]
fn lengths_and_directions() {
    let mut rng = Rng::new(1204);
    let (mut length, mut direction) = (0.0_f64, 0.0_f64);
    for _ in 0..cases(2_000_000) {
        let v = vector(&mut rng);
        let square: i128 = wide(v).iter().map(|x| x * x).sum();
        if square == 0 {
            continue;
        }
        // Floats err by 2^-52 of a number below 2^17.
        let wanted = (square as f64).sqrt() / 65_536.0;
        length = length.max(ulps(v.length(), wanted));
        for (got, x) in v.normalize().to_bits().into_iter().zip(floats(v)) {
            direction = direction.max(ulps(I16F16::from_bits(got), x / wanted));
        }
    }
    assert!(length <= 0.5 && direction < 0.501, "{length}, {direction}");
    for bits in (0..31).map(|k| 1 << k).chain([i32::MAX, 3, 12_345]) {
        assert_eq!(Vec3::from_bits([bits, 0, 0]).normalize(), Vec3::X);
        assert_eq!(Vec3::from_bits([0, 0, -bits]).normalize(), -Vec3::Z);
    }
}
