//! Affine maps against their formulas in integers of 128 bits.

#![allow(clippy::cast_possible_truncation, clippy::cast_precision_loss, reason = "twins in wide integers and floats")]

use embedded_raster::{
    fixed::types::I16F16,
    Affine, Angle,
    PathSegment::{Close, CubicTo, LineTo, MoveTo, QuadraticTo},
    PointFx,
};
use twins::rng::{cases, Rng};

fn bits(map: Affine) -> [i128; 6] {
    [map.xx, map.xy, map.dx, map.yx, map.yy, map.dy].map(|n| n.to_bits().into())
}

fn of([xx, xy, dx, yx, yy, dy]: [i32; 6]) -> Affine {
    let [xx, xy, dx, yx, yy, dy] = [xx, xy, dx, yx, yy, dy].map(I16F16::from_bits);
    Affine { xx, xy, dx, yx, yy, dy }
}

/// To the nearest, halves upwards, and not beyond the ends.
fn rounded(n: i128, shift: u32) -> i32 {
    ((n + (1 << (shift - 1))) >> shift).clamp(i32::MIN.into(), i32::MAX.into()) as i32
}

fn number(rng: &mut Rng) -> i32 {
    match rng.below(6) {
        0 => rng.pick(&[0, 1, -1, 65_536, -65_536, i32::MIN, i32::MAX]),
        _ => rng.int(i32::MIN, i32::MAX) >> rng.int(0, 31),
    }
}

#[test]
fn places_are_mapped_exactly() {
    let mut rng = Rng::new(1_310);
    for _ in 0..cases(200_000) {
        let [a, b] = [(); 2].map(|()| of([(); 6].map(|()| number(&mut rng))));
        let (x, y) = (number(&mut rng), number(&mut rng));
        let [xx, xy, dx, yx, yy, dy] = bits(a);
        let (wide_x, wide_y) = (i128::from(x), i128::from(y));
        let wanted = PointFx::from_bits(
            rounded(xx * wide_x + xy * wide_y + dx * 256, 16),
            rounded(yx * wide_x + yy * wide_y + dy * 256, 16),
        );
        assert_eq!(a.apply(PointFx::from_bits(x, y)), wanted, "{a:?} of ({x}, {y})");

        let [pxx, pxy, pdx, pyx, pyy, pdy] = bits(b);
        let stop = |n: i64| n.clamp(i32::MIN.into(), i32::MAX.into()) as i32;
        let add = |n: i32, d: i128| stop(i64::from(n) + d as i64);
        let wanted = of([
            rounded(pxx * xx + pxy * yx, 16),
            rounded(pxx * xy + pxy * yy, 16),
            add(rounded(pxx * dx + pxy * dy, 16), pdx),
            rounded(pyx * xx + pyy * yx, 16),
            rounded(pyx * xy + pyy * yy, 16),
            add(rounded(pyx * dx + pyy * dy, 16), pdy),
        ]);
        assert_eq!(a.then(b), wanted, "{a:?}, then {b:?}");
    }
}

#[test]
fn quarters_of_a_turn_are_exact() {
    let place = PointFx::from_bits(7_001, -333);
    let turned = |degrees| Affine::rotate(Angle::degrees(degrees)).apply(place);
    assert_eq!(turned(90), PointFx::from_bits(333, 7_001));
    assert_eq!(turned(180), PointFx::from_bits(-7_001, 333));
    assert_eq!(turned(-90), PointFx::from_bits(-333, -7_001));
    assert_eq!(turned(0), place);
    let eighth = Affine::rotate(Angle::turns(1, 8));
    assert_eq!((eighth.xx, eighth.xy, eighth.yx), (eighth.yy, -eighth.yx, eighth.xx), "eighths have equal numbers");
}

#[test]
fn segments_are_mapped_one_by_one() {
    let p = PointFx::px;
    let path =
        [MoveTo(p(1, 2)), LineTo(p(3, 4)), QuadraticTo(p(5, 6), p(7, 8)), CubicTo(p(9, 1), p(2, 3), p(4, 5)), Close];
    let mirrored = Affine::scale(-I16F16::ONE, I16F16::from_num(2));
    let q = |x: i32, y: i32| p(-x, 2 * y);
    let wanted =
        [MoveTo(q(1, 2)), LineTo(q(3, 4)), QuadraticTo(q(5, 6), q(7, 8)), CubicTo(q(9, 1), q(2, 3), q(4, 5)), Close];
    assert!(mirrored.path(path).eq(wanted));
    let collapsed = Affine::scale(I16F16::ZERO, I16F16::ZERO);
    assert!(collapsed.path(&path).all(|segment| !matches!(segment, LineTo(place) if place != p(0, 0))));
}
