//! Patches: places against exact fractions, normals against floats, meshes edge by edge, and the teapot.

#![allow(
    clippy::float_arithmetic,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    reason = "the reference"
)]

use std::collections::{HashMap, HashSet};

use embedded_raster::{
    geom::space::patch::{level, Part, Tessellation, Vertex},
    Patch, Vec3,
};
use fixed::types::I16F16;
use twins::rng::{cases, Rng};

use crate::space::{float, floats, nearest, ulps, vector};

fn patch(rng: &mut Rng) -> Patch {
    let shift = rng.below(28);
    let wild = rng.one_in(4);
    Patch {
        points: [(); 4].map(|()| {
            [(); 4].map(
                |()| {
                    if wild {
                        vector(rng)
                    } else {
                        Vec3::from_bits([(); 3].map(|()| rng.bits() as i32 >> shift))
                    }
                },
            )
        }),
    }
}

/// A fraction, and its numerator and denominator.
fn part(rng: &mut Rng) -> (Part, [i128; 2]) {
    let of = rng.pick(&[1, 2, 3, 4, 7, 16, 63, 64, 254, 255]);
    let number = match rng.below(5) {
        0 => 0,
        1 => of,
        _ => rng.below(u64::from(of) + 1) as u8,
    };
    (Part::new(number, of), [number.into(), of.into()])
}

/// The numerators of the weights of Bernstein.
fn cubic([t, n]: [i128; 2]) -> [i128; 4] {
    let s = n - t;
    [s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t]
}

/// The rule: the sum of all 16 points by their weights, divided once.
fn position_twin(patch: &Patch, u: [i128; 2], v: [i128; 2]) -> [i32; 3] {
    let mut sum = [0_i128; 3];
    for (row, b) in patch.points.iter().zip(cubic(v)) {
        for (point, a) in row.iter().zip(cubic(u)) {
            for (sum, x) in sum.iter_mut().zip(point.to_bits()) {
                *sum += a * b * i128::from(x);
            }
        }
    }
    sum.map(|sum| nearest(sum, u[1].pow(3) * v[1].pow(3)))
}

#[test]
fn places_are_the_nearest() {
    let mut rng = Rng::new(1220);
    for _ in 0..cases(100_000) {
        let patch = patch(&mut rng);
        for _ in 0..5 {
            let ((u, up), (v, vp)) = (part(&mut rng), part(&mut rng));
            assert_eq!(patch.position(u, v).to_bits(), position_twin(&patch, up, vp), "{up:?} {vp:?} of {patch:?}");
            let fixed = nearest(up[0] << 16, up[1]);
            assert_eq!(u.to_fixed().to_bits(), fixed, "{up:?}");
        }
    }
    let most = Patch { points: [[Vec3::from_bits([i32::MAX, i32::MIN, 0]); 4]; 4] };
    for _ in 0..1_000 {
        let ((u, _), (v, _)) = (part(&mut rng), part(&mut rng));
        assert_eq!(most.position(u, v), most.points[0][0]);
    }
    assert_eq!((Part::new(5, 4), Part::new(3, 0), Part::new(0, 9)), (Part::END, Part::START, Part::START));
}

#[test]
fn sides_depend_on_their_own_points_and_have_no_direction() {
    let mut rng = Rng::new(1221);
    for _ in 0..cases(20_000) {
        let (one, mut other) = (patch(&mut rng), patch(&mut rng));
        let side = rng.index(4);
        // The other patch has this side as its bottom, the other way.
        let [a, b, c, d] = one.side(side);
        other.points[0] = [d, c, b, a];
        for of in [1, 2, 5, 16, 64] {
            for k in 0..=of {
                let (t, back) = (Part::new(k, of), Part::new(of - k, of));
                let (u, v) = [(t, Part::START), (Part::END, t), (back, Part::END), (Part::START, back)][side];
                assert_eq!(one.position(u, v), other.position(back, Part::START), "{k} of {of} of side {side}");
            }
        }
    }
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn length(v: [f64; 3]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// The tangent along u, times 1/3.
fn tangent(points: &[[[f64; 3]; 4]; 4], u: f64, v: f64) -> [f64; 3] {
    let quadratic = [(1.0 - u) * (1.0 - u), 2.0 * u * (1.0 - u), u * u];
    let cubic = [(1.0 - v).powi(3), 3.0 * v * (1.0 - v).powi(2), 3.0 * v * v * (1.0 - v), v.powi(3)];
    let mut sum = [0.0; 3];
    for (row, b) in points.iter().zip(cubic) {
        for (k, a) in quadratic.into_iter().enumerate() {
            for (sum, x) in sum.iter_mut().zip(minus(row[k + 1], row[k])) {
                *sum += a * b * x;
            }
        }
    }
    sum
}

fn transposed<T: Copy>(points: &[[T; 4]; 4]) -> [[T; 4]; 4] {
    [0, 1, 2, 3].map(|i| [0, 1, 2, 3].map(|j| points[j][i]))
}

#[test]
fn normals_are_as_near_as_they_say() {
    let mut rng = Rng::new(1222);
    let (mut worst, mut seen) = (0.0_f64, 0);
    for _ in 0..cases(300_000) {
        let patch = patch(&mut rng);
        let ((u, up), (v, vp)) = (part(&mut rng), part(&mut rng));
        let [s, t] = [up, vp].map(|[k, n]| k as f64 / n as f64);
        let points = patch.points.map(|row| row.map(floats));
        let (a, b) = (tangent(&points, s, t), tangent(&transposed(&points), t, s));
        let longest = points.iter().flatten().map(|p| length(*p)).fold(0.0, f64::max);
        let normal = cross(a, b);
        // Short tangents lose bits, and nearly parallel ones.
        if length(a).min(length(b)) < longest / 16.0 || length(normal) < length(a) * length(b) / 16.0 {
            continue;
        }
        let got = patch.normal(u, v);
        for (got, wanted) in [got.x, got.y, got.z].into_iter().zip(normal) {
            worst = worst.max(ulps(got, wanted / length(normal)));
        }
        seen += 1;
    }
    assert!(worst < 0.51 && seen > cases(100_000), "{worst}, {seen}");
}

/// What a mesh must be, wherever its vertices are: a disc whose border is the sides.
fn check_mesh(levels: [u8; 4]) {
    let flat = Patch { points: [0, 1, 2, 3].map(|y| [0, 1, 2, 3].map(|x| Vec3::whole(x * 1000, y * 1000, 0))) };
    let mesh = Tessellation::new(&flat, levels);
    let mut vertices: Vec<Vertex> = vec![];
    mesh.each_vertex(|vertex| vertices.push(vertex));
    assert_eq!(vertices.len(), mesh.vertex_count() as usize, "{levels:?}");
    for _ in 0..9 {
        let k = Rng::new(vertices.len() as u64).index(vertices.len());
        assert_eq!(mesh.vertex(k as u16), vertices[k], "{levels:?}");
    }
    let places: HashSet<Vec3> = vertices.iter().map(|vertex| vertex.position).collect();
    assert_eq!(places.len(), vertices.len(), "two vertices at one place, {levels:?}");
    let (mut edges, mut used, mut area) = (HashSet::new(), HashSet::new(), 0);
    mesh.each_triangle(|corners| {
        let [a, b, c] = corners.map(|k| vertices[usize::from(k)].position.to_bits().map(i128::from));
        let twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        assert!(twice > 0, "{corners:?} turns the wrong way, {levels:?}");
        area += twice;
        let [a, b, c] = corners;
        for edge in [(a, b), (b, c), (c, a)] {
            assert!(edges.insert(edge), "{edge:?} twice, {levels:?}");
        }
        used.extend(corners);
    });
    // They cover the square, and as none is turned over, each place once.
    assert_eq!(area, 2 * (3000_i128 << 16).pow(2), "{levels:?}");
    assert_eq!(used.len(), vertices.len(), "a vertex without a triangle, {levels:?}");
    let around: u32 = levels.iter().map(|&level| u32::from(level)).sum();
    let border: HashSet<(u16, u16)> = (0..around).map(|k| (k as u16, ((k + 1) % around) as u16)).collect();
    let single: HashSet<(u16, u16)> = edges.iter().filter(|(a, b)| !edges.contains(&(*b, *a))).copied().collect();
    assert_eq!(single, border, "{levels:?}");
}

#[test]
fn meshes_are_whole() {
    for code in 0..6_u32.pow(4) {
        check_mesh([0, 1, 2, 3].map(|k| (code / 6_u32.pow(k) % 6) as u8 + 1));
    }
    let mut rng = Rng::new(1223);
    for _ in 0..cases(200) {
        check_mesh([(); 4].map(|()| if rng.one_in(2) { rng.int(1, 64) } else { rng.int(1, 12) } as u8));
    }
    check_mesh([64; 4]);
    check_mesh([255; 4]);
    check_mesh([255, 1, 3, 254]);
    let flat = Patch { points: [[Vec3::ZERO; 4]; 4] };
    assert_eq!(Tessellation::new(&flat, [0; 4]).vertex_count(), 4);
    assert_eq!(Tessellation::new(&flat, [255; 4]).vertex_count(), 65_536);
}

#[test]
fn levels_keep_to_their_tolerance() {
    let mut rng = Rng::new(1224);
    for _ in 0..cases(3_000) {
        let shift = rng.below(14) + 4;
        let side = [(); 4].map(|()| Vec3::from_bits([(); 3].map(|()| rng.bits() as i32 >> shift)));
        let tolerance = I16F16::from_bits(rng.int(1, 1 << 20) >> rng.below(18));
        let n = level(side, tolerance);
        let [a, b, c, d] = side;
        assert_eq!(level([d, c, b, a], tolerance), n, "backwards");
        if n == u8::MAX {
            continue;
        }
        let points = side.map(floats);
        let curve = |t: f64| {
            let w = [(1.0 - t).powi(3), 3.0 * t * (1.0 - t).powi(2), 3.0 * t * t * (1.0 - t), t.powi(3)];
            [0, 1, 2].map(|k| points.iter().zip(w).map(|(p, w)| p[k] * w).sum::<f64>())
        };
        for k in 0..n {
            let [from, to] = [k, k + 1].map(|k| f64::from(k) / f64::from(n));
            let (p, q) = (curve(from), curve(to));
            for share in [0.25, 0.5, 0.75] {
                let on_chord = [0, 1, 2].map(|i| p[i] + (q[i] - p[i]) * share);
                let off = length(minus(curve(from + (to - from) * share), on_chord));
                assert!(off <= float(tolerance) + 1e-4, "{off} at {k} of {n}, {side:?}");
            }
        }
    }
}

/// The patches in `assets`: lines `v x y z`, then `p` with 16 numbers of vertices from 1 on.
pub(crate) fn teapot() -> Vec<Patch> {
    let mut points = vec![];
    let mut patches = vec![];
    for line in include_str!("../../assets/teapot-patches.txt").lines() {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => {
                let at: Vec<I16F16> = words.map(|word| word.parse().expect("a decimal number")).collect();
                points.push(Vec3::new(at[0], at[1], at[2]));
            }
            Some("p") => {
                let mut numbers = words.map(|word| word.parse::<usize>().expect("a number"));
                let mut point = || points[numbers.next().expect("16 numbers") - 1];
                patches.push(Patch { points: [(); 4].map(|()| [(); 4].map(|()| point())) });
            }
            _ => {}
        }
    }
    patches
}

/// The same for a side and for its opposite direction.
fn key(side: [Vec3; 4]) -> [[i32; 3]; 4] {
    let [a, b, c, d] = side.map(Vec3::to_bits);
    [a, b, c, d].min([d, c, b, a])
}

#[test]
fn the_teapot_has_no_cracks() {
    let patches = teapot();
    assert_eq!(patches.len(), 32);
    let mut sides: HashMap<[[i32; 3]; 4], usize> = HashMap::new();
    for patch in &patches {
        (0..4).for_each(|k| *sides.entry(key(patch.side(k))).or_default() += 1);
    }
    let point = |side: &[[i32; 3]; 4]| side.iter().all(|p| *p == side[0]);
    let shared = sides.iter().filter(|(side, n)| **n == 2 && !point(side)).count();
    assert!(shared >= 48, "only {shared} sides are shared");
    assert!(sides.iter().all(|(side, n)| *n <= 2 || point(side)), "three patches at one side");
    let mut rng = Rng::new(1225);
    for round in 0..cases(40) {
        // A level for each side, the same for both patches; in the first rounds the same for all.
        let mut levels = HashMap::new();
        let mut chosen: Vec<_> = sides.keys().copied().collect();
        chosen.sort_unstable();
        for side in chosen {
            levels.insert(side, if round < 8 { 1 << round.min(6) } else { rng.int(1, 16) as u8 });
        }
        let mut edges: HashMap<([i32; 3], [i32; 3]), i32> = HashMap::new();
        let mut on_border: HashSet<([i32; 3], [i32; 3])> = HashSet::new();
        let mut flat = 0;
        for patch in &patches {
            let of_side = [0, 1, 2, 3].map(|k| levels[&key(patch.side(k))]);
            let mesh = Tessellation::new(patch, of_side);
            let mut vertices = vec![];
            mesh.each_vertex(|vertex| vertices.push(vertex.position.to_bits()));
            mesh.each_triangle(|corners| {
                let [a, b, c] = corners.map(|k| vertices[usize::from(k)]);
                flat += usize::from(a == b || b == c || c == a);
                for (from, to) in [(a, b), (b, c), (c, a)] {
                    if from != to {
                        *edges.entry((from, to)).or_default() += 1;
                    }
                }
            });
            // What no other patch has.
            let around: usize = of_side.iter().map(|&level| usize::from(level)).sum();
            let mut first = 0;
            for (k, level) in of_side.into_iter().enumerate() {
                let alone = sides[&key(patch.side(k))] == 1;
                for i in first..first + usize::from(level) {
                    let edge = (vertices[i], vertices[(i + 1) % around]);
                    if alone && edge.0 != edge.1 {
                        on_border.insert(edge);
                    }
                }
                first += usize::from(level);
            }
        }
        // Each edge is met by its opposite as often, but at the borders of the surface.
        for (&(from, to), &n) in &edges {
            let back = edges.get(&(to, from)).copied().unwrap_or(0);
            let is_border = on_border.contains(&(from, to)) || on_border.contains(&(to, from));
            assert!(n == back || is_border, "{from:?} to {to:?} {n} times, and back {back} times, {levels:?}");
        }
        assert!(!on_border.is_empty() && flat > 0, "a teapot has a rim, and a knob where sides are points");
    }
}

#[test]
fn the_teapot_has_the_surface_of_a_teapot() {
    // Chords cut off corners: the error goes down with the square of the level.
    let all = [4, 16, 64].map(|level| {
        let (mut area, mut wrong, mut all) = (0.0, 0_u32, 0_u32);
        for patch in teapot() {
            let mesh = Tessellation::new(&patch, [level; 4]);
            let mut vertices = vec![];
            mesh.each_vertex(|vertex| vertices.push(vertex));
            assert!(vertices.iter().all(|vertex| (length(floats(vertex.normal)) - 1.0).abs() < 4e-5), "of length 1");
            mesh.each_triangle(|corners| {
                let corners = corners.map(|k| vertices[usize::from(k)]);
                let [a, b, c] = corners.map(|vertex| floats(vertex.position));
                let normal = cross(minus(b, a), minus(c, a));
                area += length(normal) / 2.0;
                // Where it has an area, normals at its corners point to its own side.
                if length(normal) > 1e-6 {
                    for corner in corners {
                        let n = floats(corner.normal);
                        all += 1;
                        wrong += u32::from(n[0] * normal[0] + n[1] * normal[1] + n[2] * normal[2] <= 0.0);
                    }
                }
            });
        }
        (area, wrong, all)
    });
    let [(coarse, some, _), (fine, none, _), (finest, none_still, corners)] = all;
    assert!(fine - coarse < coarse / 30.0 && finest > fine && finest - fine < (fine - coarse) / 12.0, "{all:?}");
    // A coarse mesh leaves sharp bends out.
    assert!(some <= 6 && none == 0 && none_still == 0 && corners > 700_000, "{all:?}");
    // Knob and bottom are flat in the middle.
    for patch in teapot() {
        let side = patch.side(0);
        if side == [side[0]; 4] {
            for k in 0..=8 {
                let normal = patch.normal(Part::new(k, 8), Part::START);
                assert!(normal == Vec3::Z || normal == -Vec3::Z, "{normal:?}");
            }
        }
    }
}
