//! Matrices, against exact integers where they are products, and else against floats, whose own error is below a thousandth of
//! what is tested.

#![allow(
    clippy::float_arithmetic,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    clippy::cast_possible_truncation,
    reason = "the reference"
)]

use embedded_raster::{Angle, Mat4, Vec3, Vec4};
use fixed::types::I16F16;
use twins::rng::{cases, Rng};

use crate::space::{float, floats, nearest, number, ulps, vector};

type Rows = [[f64; 4]; 4];

/// The largest distance of a number from what it should be, in ulp.
fn worst(got: Mat4, wanted: Rows) -> f64 {
    let numbers = got.to_bits().into_iter().flatten().zip(wanted.into_iter().flatten());
    numbers.map(|(got, wanted)| ulps(I16F16::from_bits(got), wanted)).fold(0.0, f64::max)
}

fn normalized(v: [f64; 3]) -> [f64; 3] {
    let length = dot(v, v).sqrt();
    v.map(|x| x / length)
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn matrix(rng: &mut Rng) -> Mat4 {
    let shift = rng.below(32);
    let wild = rng.one_in(3);
    Mat4::from_bits([(); 4].map(|()| [(); 4].map(|()| if wild { number(rng) } else { rng.bits() as i32 >> shift })))
}

#[test]
fn products_of_matrices_are_rounded_once() {
    let mut rng = Rng::new(1205);
    for _ in 0..cases(200_000) {
        let (a, b, v) = (matrix(&mut rng), matrix(&mut rng), vector(&mut rng));
        let (m, n) = (a.to_bits(), b.to_bits());
        let product = |row: [i32; 4], column: [i32; 4]| {
            nearest(row.iter().zip(column).map(|(&x, y)| i128::from(x) * i128::from(y)).sum(), 1 << 16)
        };
        let wanted = m.map(|row| [0, 1, 2, 3].map(|k| product(row, n.map(|row| row[k]))));
        assert_eq!((a * b).to_bits(), wanted, "{a:?} * {b:?}");
        let [x, y, z] = v.to_bits();
        assert_eq!(a.transform_point(v).to_bits(), m.map(|row| product(row, [x, y, z, 65_536])), "{a:?} * {v:?}");
        let wanted = [0, 1, 2].map(|k| product(m[k], [x, y, z, 0]));
        assert_eq!(a.transform_direction(v).to_bits(), wanted, "{a:?} * {v:?}");
        assert_eq!((a * Mat4::IDENTITY, Mat4::IDENTITY * a), (a, a));
    }
}

#[test]
fn motions() {
    let mut rng = Rng::new(1206);
    let (mut around_axes, mut around_any) = (0.0_f64, 0.0_f64);
    for _ in 0..cases(300_000) {
        let (v, turn) = (vector(&mut rng), rng.bits() as u32 >> rng.below(30));
        let angle = Angle::from_bits(turn);
        let (s, c) = (f64::from(turn) / 4_294_967_296.0 * core::f64::consts::TAU).sin_cos();
        let last = [0.0, 0.0, 0.0, 1.0];
        let x = [[1.0, 0.0, 0.0, 0.0], [0.0, c, -s, 0.0], [0.0, s, c, 0.0], last];
        let y = [[c, 0.0, s, 0.0], [0.0, 1.0, 0.0, 0.0], [-s, 0.0, c, 0.0], last];
        let z = [[c, -s, 0.0, 0.0], [s, c, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], last];
        for (got, wanted) in [(Mat4::rotate_x(angle), x), (Mat4::rotate_y(angle), y), (Mat4::rotate_z(angle), z)] {
            around_axes = around_axes.max(worst(got, wanted));
        }
        if v == Vec3::ZERO {
            continue;
        }
        // Rodrigues: c v + s (axis x v) + (1 - c) (axis . v) axis, for each axis of the world.
        let axis = normalized(floats(v));
        let mut wanted = [[0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0], last];
        for k in 0..3 {
            let mut one = [0.0; 3];
            one[k] = 1.0;
            let turned = cross(axis, one);
            for i in 0..3 {
                wanted[i][k] = c * one[i] + s * turned[i] + (1.0 - c) * axis[k] * axis[i];
            }
        }
        around_any = around_any.max(worst(Mat4::rotate(v, angle), wanted));
        let at = vector(&mut rng);
        assert_eq!(Mat4::translate(v).transform_point(at), (at + v).with_w(I16F16::ONE));
        let [x, y, z] = [at.x, at.y, at.z];
        let scaled = Mat4::scale(v).transform_direction(at);
        assert_eq!([scaled.x, scaled.y, scaled.z], [(v * x).x, (v * y).y, (v * z).z]);
    }
    assert!(around_axes < 0.5001 && around_any < 0.501, "{around_axes}, {around_any}");
    let quarter = Angle::degrees(90);
    for (axis, rotation) in
        [(Vec3::X, Mat4::rotate_x(quarter)), (Vec3::Y, Mat4::rotate_y(quarter)), (Vec3::Z, Mat4::rotate_z(quarter))]
    {
        assert_eq!(Mat4::rotate(axis, quarter), rotation);
    }
    assert_eq!(Mat4::rotate_z(quarter).transform_direction(Vec3::X), Vec3::Y);
    assert_eq!(Mat4::rotate(Vec3::ZERO, quarter), Mat4::IDENTITY);
}

#[test]
fn cameras_look_at_what_they_are_told_to() {
    let mut rng = Rng::new(1207);
    let (mut rotation, mut translation, mut around) = (0.0_f64, 0.0_f64, 0.0_f64);
    for _ in 0..cases(500_000) {
        let [eye, target, up] = [(); 3].map(|()| vector(&mut rng));
        let (e, ahead) = (floats(eye), [0, 1, 2].map(|k| floats(target)[k] - floats(eye)[k]));
        let view = Mat4::look_at(eye, target, up);
        // Whatever it is given, it makes a rotation.
        let [x, y, z, _] = view.rows.map(|row| floats(row.xyz()));
        for (a, b, wanted) in
            [(x, x, 1.0), (y, y, 1.0), (z, z, 1.0), (x, y, 0.0), (y, z, 0.0), (z, x, 0.0), (cross(x, y), z, 1.0)]
        {
            around = around.max((dot(a, b) - wanted).abs() * 65_536.0);
        }
        assert_eq!(view.rows[3], Vec4::from_bits([0, 0, 0, 65_536]));
        let back = normalized(ahead.map(|x| -x));
        let right = cross(normalized(floats(up)), back);
        // A direction of sight too close to up is one that floats do not know well either.
        if !back[0].is_finite() || !right[0].is_finite() || dot(right, right) < 1e-3 {
            continue;
        }
        let (sine, right) = (dot(right, right).sqrt(), normalized(right));
        let axes = [right, cross(back, right), back];
        for (row, axis) in view.rows.into_iter().zip(axes) {
            for (got, wanted) in [row.x, row.y, row.z].into_iter().zip(axis) {
                rotation = rotation.max(ulps(got, wanted));
            }
            let distance = dot(e, e).sqrt();
            translation = translation.max((ulps(row.w, -dot(axis, e)) - 0.5) / distance.max(1.0) * sine);
        }
    }
    assert!(rotation < 0.51, "{rotation}");
    assert!(translation < 0.0002, "{translation}");
    assert!(around < 2.5, "{around}");
    let up = Vec3::Y;
    assert_eq!(Mat4::look_at(Vec3::ZERO, -Vec3::Z, up), Mat4::IDENTITY);
    assert_eq!(Mat4::look_at(Vec3::X, Vec3::X, up), Mat4::translate(-Vec3::X));
    assert_eq!(Mat4::look_at(Vec3::Y, Vec3::ZERO, up).transform_point(Vec3::ZERO).xyz(), -Vec3::Z);
}

/// What a projection should be, times the power of two that it was multiplied by.
fn times(rows: Rows, power: f64) -> Rows {
    rows.map(|row| row.map(|x| x * power))
}

#[test]
fn perspectives() {
    let mut rng = Rng::new(1208);
    let (mut lens, mut window, mut narrow) = (0.0_f64, 0.0_f64, 0.0_f64);
    for _ in 0..cases(500_000) {
        let near = I16F16::from_bits(rng.int(1, i32::MAX) >> rng.below(30));
        let far = near.saturating_add(I16F16::from_bits(rng.int(1, i32::MAX) >> rng.below(25)));
        if near == 0 || far == near {
            continue;
        }
        let (n, f) = (float(near), float(far));
        let z = [0.0, 0.0, -f / (f - n), -f * n / (f - n)];
        let check = |got: Mat4, x: [f64; 2], y: [f64; 2]| {
            let scale = -got.rows[3].z;
            let power = float(scale);
            assert!(scale >= 1 && scale.to_bits().count_ones() == 1, "{power}");
            let all = got.to_bits().into_iter().flatten().map(i32::unsigned_abs).max().expect("numbers");
            assert!(scale == 1 || all <= 1 << 29 && n * power < 2.0 && f * power <= 8192.0, "{got:?}");
            // Nothing is left unused.
            let fits = 2 * u64::from(all) < (1 << 29) - (1 << 14) && 2.0 * n * power < 2.0 && 2.0 * f * power < 8192.0;
            assert!(!fits || scale == 8192, "{got:?}");
            (worst(got, times([[x[0], 0.0, x[1], 0.0], [0.0, y[0], y[1], 0.0], z, [0.0, 0.0, -1.0, 0.0]], power)), all)
        };
        let aspect = I16F16::from_bits(rng.int(8_192, 524_288));
        let turn = rng.int(1 << 22, i32::MAX) as u32;
        let half = f64::from(turn) / 4_294_967_296.0 * core::f64::consts::PI;
        let cotangent = 1.0 / half.tan();
        // Beyond half an ulp, in terms of the largest number.
        let beyond = |(off, all): (f64, u32)| (off - 0.5) / f64::from(all);
        let got = Mat4::perspective(Angle::from_bits(turn), aspect, near, far);
        let off = beyond(check(got, [cotangent / float(aspect), 0.0], [cotangent, 0.0]));
        let worst = if turn > 11_930_464 { &mut lens } else { &mut narrow };
        *worst = off.max(*worst);
        let [x, y] = [(); 2].map(|()| {
            let low = rng.int(-(1 << 24), 1 << 24) >> rng.below(16);
            [low, low + (rng.int(1, 1 << 24) >> rng.below(8)).max(1)].map(I16F16::from_bits)
        });
        let side = |[low, high]: [I16F16; 2]| [2.0 * n / float(high - low), float(high + low) / float(high - low)];
        if [x, y].map(side).iter().flatten().all(|x| x.abs() < 8192.0) {
            window = window.max(beyond(check(Mat4::frustum(x, y, near, far), side(x), side(y))));
        }
    }
    let [lens, window, narrow] = [lens, window, narrow].map(f64::log2);
    assert!(lens < -22.0 && window < -29.0 && narrow < -21.0, "{lens}, {window}, {narrow}");
}

#[test]
fn planes_of_a_perspective() {
    // Depth is 0 at the near plane and 1 at the far plane, and x and y are -1 and 1 at the sides of the picture.
    for (near, far) in [(0.0625, 50.0), (0.5, 8000.0), (1.0, 100.0), (10.0, 30_000.0)] {
        let [n, f] = [near, far].map(I16F16::from_num::<f64>);
        let camera = Mat4::perspective(Angle::degrees(90), I16F16::from_num(2), n, f);
        for (distance, depth) in [(near, 0.0), (far, 1.0)] {
            let place = [2.0 * distance, -distance, -distance].map(I16F16::saturating_from_num::<f64>);
            let at = camera.transform_point(Vec3::new(place[0], place[1], place[2])).project();
            let off = [ulps(at.z, depth), ulps(at.y, -1.0)].into_iter().fold(0.0, f64::max);
            assert!(off <= 2.0, "{off} at {distance} of {near} to {far}");
        }
    }
}

#[test]
fn boxes_seen_by_parallel_lines() {
    let mut rng = Rng::new(1209);
    let mut off = 0.0_f64;
    for _ in 0..cases(300_000) {
        let [x, y, z] = [(); 3].map(|()| {
            let low = rng.int(-(1 << 28), 1 << 28) >> rng.below(20);
            let high = low + (rng.int(1, 1 << 28) >> rng.below(12)).max(1);
            (if rng.one_in(2) { [low, high] } else { [high, low] }).map(I16F16::from_bits)
        });
        let got = Mat4::orthographic(x, y, z[0], z[1]);
        let power = float(got.rows[3].w);
        let side = |[low, high]: [I16F16; 2]| [2.0 / float(high - low), -float(high + low) / float(high - low)];
        let ([xx, xw], [yy, yw], d) = (side(x), side(y), float(z[1] - z[0]));
        let wanted =
            [[xx, 0.0, 0.0, xw], [0.0, yy, 0.0, yw], [0.0, 0.0, -1.0 / d, -float(z[0]) / d], [0.0, 0.0, 0.0, 1.0]];
        if wanted.iter().flatten().all(|x| x.abs() < 8192.0) {
            off = off.max(worst(got, times(wanted, power)));
            assert!(
                got.rows[3].w == 8192
                    || got.to_bits().into_iter().flatten().any(|n| n.unsigned_abs() >= (1 << 28) - (1 << 13)),
                "{got:?}"
            );
        }
    }
    assert!(off <= 0.5001, "{off}");
}

#[test]
fn the_way_back() {
    let mut rng = Rng::new(1210);
    let mut off = 0.0_f64;
    for _ in 0..cases(300_000) {
        let to = [(); 3].map(|()| rng.int(-(1 << 24), 1 << 24));
        let there =
            Mat4::translate(Vec3::from_bits(to)) * Mat4::rotate(vector(&mut rng), Angle::from_bits(rng.bits() as u32));
        let at = Vec3::from_bits([(); 3].map(|()| rng.int(-(1 << 24), 1 << 24)));
        let back = there.inverse_rigid().transform_point(there.transform_point(at).xyz()).xyz();
        let distance =
            floats(at).into_iter().chain(to.map(|n| f64::from(n) / 65_536.0)).fold(1.0, |a: f64, x| a + x.abs());
        for (a, b) in floats(back).into_iter().zip(floats(at)) {
            off = off.max((a - b).abs() / distance * 32_768.0);
        }
    }
    assert!(off < 1.0, "{off}");
    let there = Mat4::translate(Vec3::whole(1, 2, 3)) * Mat4::rotate_z(Angle::degrees(90));
    assert_eq!(there * there.inverse_rigid(), Mat4::IDENTITY);
}

#[test]
fn normals_stay_at_right_angles() {
    let mut rng = Rng::new(1211);
    let mut off = 0.0_f64;
    for _ in 0..cases(300_000) {
        let shift = rng.below(28);
        let m = Mat4::from_bits([(); 4].map(|()| [(); 4].map(|()| rng.bits() as i32 >> shift)));
        let rows = m.rows.map(|row| floats(row.xyz()));
        let cofactors = [cross(rows[1], rows[2]), cross(rows[2], rows[0]), cross(rows[0], rows[1])];
        let det = dot(rows[0], cofactors[0]);
        let most = cofactors.iter().flatten().fold(0.0_f64, |a, x| a.max(x.abs()));
        let row = rows.iter().flatten().fold(0.0_f64, |a, x| a.max(x.abs()));
        // Nearly flat: which side is which is not known.
        if det.abs() < most * row * 1e-6 {
            continue;
        }
        let normal = m.normal_matrix();
        let largest = normal.to_bits().into_iter().take(3).flatten().map(i32::unsigned_abs).max().expect("numbers");
        assert!((1 << 21..=1 << 22).contains(&largest), "{m:?}");
        for (got, wanted) in normal.rows.into_iter().zip(cofactors) {
            for (got, wanted) in floats(got.xyz()).into_iter().zip(wanted) {
                let scaled = wanted / most * det.signum() * f64::from(largest);
                off = off.max((got * 65_536.0 - scaled).abs());
            }
        }
    }
    assert!(off < 1.1, "{off} units");
    // The same for a rotation, and a mirror leaves what looks outside looking outside.
    let turned = Mat4::rotate_y(Angle::degrees(90)) * Mat4::scale(Vec3::whole(2, 2, 2));
    assert_eq!(turned.normal_matrix().transform_direction(Vec3::Z).normalize(), Vec3::X);
    let mirror = Mat4::scale(Vec3::whole(-1, 1, 1));
    assert_eq!(mirror.normal_matrix().transform_direction(Vec3::X).normalize(), -Vec3::X);
    assert_eq!(mirror.normal_matrix().transform_direction(Vec3::Y).normalize(), Vec3::Y);
    assert_eq!(Mat4::from_bits([[0; 4]; 4]).normal_matrix().rows[0], Vec4::ZERO);
}
