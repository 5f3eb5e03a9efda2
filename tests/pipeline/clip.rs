//! Clipping against exact ratios: each corner is rounded once, however many planes cut.

use embedded_raster::{
    pipeline::{Pipeline, Vertex},
    Vec4,
};
use fixed::types::I16F16;
use twins::{
    clipping,
    rng::{cases, Rng},
};

use crate::stages::corner;

/// What changes over a triangle: numbers of all kinds, at their ends more often than not.
type Values = (u8, [u16; 2], (i32, u32, I16F16));

fn values(rng: &mut Rng) -> Values {
    let mut bits = || {
        let any = rng.bits();
        rng.pick(&[0, u64::MAX, 1 << 31, any, any])
    };
    let (a, b, c) = (bits(), bits(), bits());
    (a as u8, [b as u16, c as u16], (a as i32, b as u32, I16F16::from_bits(c as i32)))
}

/// A vertex as numbers.
fn numbers(vertex: &Vertex<Values>) -> [i64; 10] {
    let [x, y, z, w] = vertex.position.to_bits().map(i64::from);
    let (a, [b, c], (d, e, f)) = vertex.values;
    [x, y, z, w, a.into(), b.into(), c.into(), d.into(), e.into(), f.to_bits().into()]
}

/// What lies between some vertices: each number is rounded once.
fn between<const N: usize>(weights: [i128; N], vertices: [Vertex<Values>; N]) -> [i64; 10] {
    let all = vertices.map(|vertex| numbers(&vertex));
    core::array::from_fn(|i| clipping::mean(weights, all.map(|numbers| numbers[i])))
}

/// Any size of a picture, the ends more often than not.
fn size(rng: &mut Rng) -> (u16, u16) {
    let side = |rng: &mut Rng| {
        let any = rng.int(1, 4_096) as u16;
        rng.pick(&[1, 48, 4_096, any])
    };
    (side(rng), side(rng))
}

/// Corners that several planes cut: at the corner of the guard band, or of the near plane and the guard band.
fn deep(rng: &mut Rng) -> Vec4 {
    let w = rng.int(-3_000, 200_000);
    let far = rng.pick(&[1 << 20, 1 << 24, i32::MAX]);
    Vec4::from_bits([rng.int(-far, far), rng.int(-far, far), rng.int(-90_000, 250_000), w])
}

#[test]
fn corners_are_rounded_once() {
    let (mut rng, mut of_two_planes, mut cut) = (Rng::new(11), 0, 0);
    for round in 0..cases(60_000) {
        let size = size(&mut rng);
        let mut vertex =
            || Vertex::new(if round % 2 == 0 { corner(&mut rng) } else { deep(&mut rng) }, values(&mut rng));
        let triangle = [vertex(), vertex(), vertex()];
        let left = clipping::corners(triangle.map(|vertex| vertex.position.to_bits()), size);
        let wanted: Vec<_> = left.iter().map(|&weights| (between(weights, triangle), weights)).collect();
        Pipeline::new(size.0, size.1).unwrap().triangles(
            [triangle],
            |vertex| vertex,
            |piece| {
                for corner in piece.corners().each_ref().map(numbers) {
                    let found = wanted.iter().find(|(numbers, _)| *numbers == corner);
                    let (_, weights) =
                        found.unwrap_or_else(|| panic!("{triangle:?} {size:?}: {corner:?} is none of {wanted:?}"));
                    of_two_planes += u32::from(weights.iter().all(|&weight| weight > 0));
                    cut += u32::from(weights.iter().filter(|&&weight| weight > 0).count() == 2);
                }
            },
        );
    }
    let few = cases(60_000) as u32 / 30;
    assert!(of_two_planes > few && cut > few, "{of_two_planes} corners between planes, {cut} on sides");
}

#[test]
fn ends_of_lines_are_rounded_once() {
    let (mut rng, mut cut) = (Rng::new(12), 0);
    for round in 0..cases(100_000) {
        let size = size(&mut rng);
        let mut vertex =
            || Vertex::new(if round % 2 == 0 { corner(&mut rng) } else { deep(&mut rng) }, values(&mut rng));
        let ends = [vertex(), vertex()];
        let left = clipping::line(ends.map(|vertex| vertex.position.to_bits()), size);
        let wanted = left.map(|left| left.map(|weights| between(weights, ends)));
        let mut got = None;
        Pipeline::new(size.0, size.1).unwrap().lines(
            [ends],
            |vertex| vertex,
            |line| got = Some(line.ends().each_ref().map(numbers)),
        );
        // Where all is 0, there is no place.
        let has_w = wanted.is_some_and(|ends| ends.iter().all(|end| end[3] > 0));
        assert_eq!(got, wanted.filter(|_| has_w), "{ends:?} {size:?}");
        cut += u32::from(got.is_some() && got != Some(ends.each_ref().map(numbers)));
    }
    assert!(cut as usize > cases(100_000) / 20, "{cut} lines were cut");
}

/// What is equal at all corners stays so, and nothing leaves the range of the corners.
#[test]
fn nothing_leaves_the_range_of_the_corners() {
    let mut rng = Rng::new(13);
    for _ in 0..cases(20_000) {
        let same = values(&mut rng);
        let triangle = [(); 3].map(|()| (deep(&mut rng), rng.int(-1_000_000, 1_000_000)));
        Pipeline::new(48, 36).unwrap().triangles(
            [triangle],
            |(at, number)| Vertex::new(at, (same, number)),
            |piece| {
                for corner in piece.corners() {
                    let range = triangle.map(|(_, number)| number);
                    assert_eq!(corner.values.0, same);
                    assert!(
                        range.iter().min() <= Some(&corner.values.1) && Some(&corner.values.1) <= range.iter().max()
                    );
                }
            },
        );
    }
}
