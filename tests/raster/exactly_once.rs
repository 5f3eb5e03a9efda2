//! Meshes whose triangles share their sides paint each pixel inside exactly once: no gap, no overlap, whichever filler.
//!
//! The twin of a mesh is its outline: by the rule of polygons a pixel inside has winding number 1, one outside 0.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "coordinates of small windows, made to fit"
)]

use embedded_raster::{
    raster::{polygon, triangle},
    EdgeSlot, FillRule, Rect,
};
use twins::{
    collect, corners, crossings,
    rng::{cases, Rng},
    twice_area, vertices, Run, Units,
};

/// Corners of triangles, each turning the same way, and the outline of them all.
struct Mesh {
    triangles: Vec<[Units; 3]>,
    outline: Vec<Units>,
}

impl Mesh {
    fn is_proper(&self) -> bool {
        self.triangles.iter().all(|&[a, b, c]| twice_area(a, b, c) >= 0)
    }
}

type Filler = fn([Units; 3], Rect) -> Vec<Run>;

/// The three ways to fill a triangle.
const FILLERS: [(&str, Filler); 3] = [
    ("fill", |units, window| collect(window, |emit| triangle::fill(corners(units), window, emit))),
    ("walk", |units, window| collect(window, |emit| triangle::walk(corners(units), window, emit))),
    ("polygon", |units, window| {
        let outline = vertices(&units);
        let mut table = [EdgeSlot::EMPTY; 3];
        collect(window, |emit| {
            polygon::fill([&outline[..]], FillRule::EvenOdd, &mut table, window, emit).expect("three slots");
        })
    }),
];

/// How often each pixel is painted, a triangle that turns the other way counting as -1.
fn coverage(mesh: &Mesh, window: Rect, fill: Filler) -> Vec<i32> {
    let width = window.width() as usize;
    let mut counts = vec![0; width * window.height() as usize];
    for &[a, b, c] in &mesh.triangles {
        let sign = twice_area(a, b, c).signum() as i32;
        for (y, x0, x1) in fill([a, b, c], window) {
            for x in x0..x1 {
                counts[(y - window.y0) as usize * width + (x - window.x0) as usize] += sign;
            }
        }
    }
    counts
}

/// Says whether the mesh has no fold: then no pixel is painted twice.
fn check(mesh: &Mesh, window: Rect) -> bool {
    let outline = std::slice::from_ref(&mesh.outline);
    let wanted: Vec<i32> = (window.y0..window.y1)
        .flat_map(|y| (window.x0..window.x1).map(move |x| (x, y)))
        .map(|(x, y)| crossings(outline, x, y).0)
        .collect();
    // Outlines here turn clockwise on the screen: down on the right, up on the left, which counts -1.
    let wanted: Vec<i32> = wanted.into_iter().map(|n| -n).collect();
    for (name, fill) in FILLERS {
        let got = coverage(mesh, window, fill);
        let at = got.iter().zip(&wanted).position(|(a, b)| a != b);
        assert!(
            at.is_none(),
            "{name}: pixel {at:?} of {window:?} is painted {:?} times, not {:?}: {:?}",
            at.map(|i| got[i]),
            at.map(|i| wanted[i]),
            mesh.triangles
        );
    }
    mesh.is_proper() && wanted.iter().all(|&n| n == 0 || n == 1)
}

const WINDOW: Rect = Rect::new(-2, -2, 30, 26);

/// A grid of trouble: any unit, half pixels, centres of pixels, or corners.
fn snap(rng: &mut Rng) -> impl Fn(i32) -> i32 {
    let grid = rng.below(4);
    move |n| match grid {
        0 => n,
        1 => n & !127,
        2 => (n & !255) + 128,
        _ => n & !255,
    }
}

/// Triangles around one vertex, to a ring of places in the order of their angles.
fn fan(rng: &mut Rng) -> Mesh {
    let snap = snap(rng);
    let middle = (snap(rng.int(1500, 5000)), snap(rng.int(1500, 4000)));
    let mut ring: Vec<Units> = (0..rng.range(3, 14))
        .map(|_| (snap(middle.0 + rng.int(-3000, 3000)), snap(middle.1 + rng.int(-3000, 3000))))
        .filter(|&p| p != middle)
        .collect();
    ring.sort_by(|&p, &q| {
        let lower = |p: Units| (p.1 - middle.1, p.0 - middle.0) < (0, 0);
        lower(p).cmp(&lower(q)).then_with(|| twice_area(middle, q, p).cmp(&0))
    });
    let n = ring.len();
    let triangles = (0..n).map(|i| [middle, ring[i], ring[(i + 1) % n]]).collect();
    Mesh { triangles, outline: ring }
}

/// A zigzag from left to right.
fn strip(rng: &mut Rng) -> Mesh {
    let snap = snap(rng);
    let (mut upper, mut lower) = (vec![], vec![]);
    let step = rng.pick(&[40, 300, 900, 1600]);
    let (mut x, mut z) = (rng.int(-300, 900), rng.int(-300, 900));
    for _ in 0..rng.range(2, 9) {
        upper.push((snap(x), snap(rng.int(-400, 2800))));
        lower.push((snap(z), snap(rng.int(2900, 6400))));
        (x, z) = (x + rng.int(0, step), z + rng.int(0, step));
    }
    let mut triangles = vec![];
    for i in 1..upper.len() {
        triangles.push([upper[i - 1], upper[i], lower[i - 1]]);
        triangles.push([upper[i], lower[i], lower[i - 1]]);
    }
    let outline = upper.iter().copied().chain(lower.into_iter().rev()).collect();
    Mesh { triangles, outline }
}

/// A grid of places moved a little, its cells cut along one diagonal or the other, then sides flipped at random where the
/// two triangles beside them allow it: every triangulation of these places can come of it, Delaunay's too.
fn grid(rng: &mut Rng, jitter: i32, flips: usize) -> Mesh {
    let snap = snap(rng);
    let (columns, rows) = (rng.index(6) + 2, rng.index(5) + 2);
    let cell = rng.pick(&[256, 700, 1100]);
    let place = |rng: &mut Rng, i: usize, j: usize| {
        let at = |n: usize| n as i32 * cell;
        (snap(at(i) + rng.int(-jitter, jitter)), snap(at(j) + rng.int(-jitter, jitter)))
    };
    let places: Vec<Vec<Units>> = (0..rows).map(|j| (0..columns).map(|i| place(rng, i, j)).collect()).collect();
    let mut triangles = vec![];
    for (upper, lower) in places.iter().zip(&places[1..]) {
        for i in 1..columns {
            let [a, b, c, d] = [upper[i - 1], upper[i], lower[i], lower[i - 1]];
            triangles.extend(if rng.one_in(2) { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] });
        }
    }
    for _ in 0..flips {
        flip(rng, &mut triangles);
    }
    let top = places[0].iter();
    let right = places[1..rows - 1].iter().map(|row| &row[columns - 1]);
    let bottom = places[rows - 1].iter().rev();
    let left = places[1..rows - 1].iter().rev().map(|row| &row[0]);
    let outline = top.chain(right).chain(bottom).chain(left).copied().collect();
    Mesh { triangles, outline }
}

/// Replaces the side that two triangles share by the other diagonal, if their four corners are convex.
fn flip(rng: &mut Rng, triangles: &mut [[Units; 3]]) {
    let (i, k) = (rng.index(triangles.len()), rng.index(3));
    let mut first = triangles[i];
    first.rotate_left(k);
    let [a, b, c] = first;
    // The neighbour runs along b to a.
    for j in 0..triangles.len() {
        for turn in 0..3 {
            let mut second = triangles[j];
            second.rotate_left(turn);
            if j != i && second[0] == b && second[1] == a {
                let d = second[2];
                if twice_area(c, a, d) > 0 && twice_area(d, b, c) > 0 {
                    (triangles[i], triangles[j]) = ([c, a, d], [d, b, c]);
                }
                return;
            }
        }
    }
}

/// Random meshes of a kind, a good part of them without a fold.
fn many(seed: u64, meshes: usize, make: impl Fn(&mut Rng) -> Mesh) {
    let (meshes, mut rng) = (cases(meshes), Rng::new(seed));
    let proper = (0..meshes).filter(|_| check(&make(&mut rng), WINDOW)).count();
    assert!(proper >= meshes / 4, "only {proper} of {meshes} meshes have no fold");
}

#[test]
fn fans() {
    many(90, 4_000, fan);
}

#[test]
fn strips() {
    many(91, 4_000, strip);
}

#[test]
fn grids_moved_a_little() {
    many(92, 3_000, |rng| grid(rng, 90, 0));
}

#[test]
fn grids_with_flipped_sides() {
    many(93, 3_000, |rng| grid(rng, 100, 60));
}

/// Folded meshes: what is painted twice by triangles that turn one way is taken off by those that turn the other.
#[test]
fn folded_meshes_cancel_out() {
    let mut rng = Rng::new(94);
    for _ in 0..cases(3_000) {
        check(&grid(&mut rng, 2_000, 0), WINDOW);
    }
}

/// The same far from the origin, and so large that only a corner of the mesh is seen.
#[test]
fn large_meshes_far_away() {
    let mut rng = Rng::new(95);
    for _ in 0..cases(3_000) {
        let mut mesh = if rng.one_in(2) { fan(&mut rng) } else { grid(&mut rng, 90, 30) };
        let scale = rng.pick(&[1, 37, 9_999, 200_000]);
        let (x, y) = (rng.int(-500_000_000, 500_000_000), rng.int(-500_000_000, 500_000_000));
        let put = |p: Units| (p.0 * scale + x, p.1 * scale + y);
        mesh.outline.iter_mut().for_each(|p| *p = put(*p));
        mesh.triangles.iter_mut().for_each(|t| *t = t.map(put));
        let seen = rng.pick(&mesh.triangles);
        let at = rng.pick(&seen);
        let (column, row) = (at.0 >> 8, at.1 >> 8);
        check(&mesh, Rect::new(column - 9, row - 7, column + 9, row + 7));
    }
}

/// Two shapes that share a crooked border, such as two countries, and their union.
#[test]
fn polygons_along_a_common_border() {
    let mut rng = Rng::new(96);
    for _ in 0..cases(4_000) {
        let snap = snap(&mut rng);
        let border: Vec<Units> =
            (0..rng.range(2, 14)).map(|_| (snap(rng.int(900, 5_000)), snap(rng.int(0, 6_000)))).collect();
        let (top, bottom) = ((3_000, -900), (3_000, 6_900));
        let inner = || [top].into_iter().chain(border.iter().copied()).chain([bottom]);
        let left: Vec<Units> = inner().chain([(-400, 6_900), (-400, -900)]).collect();
        let right: Vec<Units> = inner().chain([(7_000, 6_900), (7_000, -900)]).collect();
        let painted = |outline: &[Units]| {
            let outline = vertices(outline);
            let mut table = [EdgeSlot::EMPTY; 20];
            collect(WINDOW, |emit| {
                polygon::fill([&outline[..]], FillRule::EvenOdd, &mut table, WINDOW, emit).expect("enough slots");
            })
        };
        let mut counts = twins::hits::Hits::new(WINDOW);
        counts.add(&painted(&left));
        counts.add(&painted(&right));
        let whole = [(-400, -900), (7_000, -900), (7_000, 6_900), (-400, 6_900)];
        // Even-odd: the border may cross itself, what it encloses changes sides but is on one of them.
        assert_eq!(counts.runs(), painted(&whole), "{border:?}");
    }
}
