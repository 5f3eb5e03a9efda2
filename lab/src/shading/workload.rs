//! Triangles to be shaded: those whose cost is measured first, then thousands at random, on which the error is judged.

use textbook::scene::{self, Corner, Triangle};
use twins::{rng::Rng, twice_area};

use super::{Kind, Shaded};
use crate::{
    frame::{HEIGHT, WIDTH},
    workload::{judged, Workload},
};

/// How far off the screen corners may be, in pixels.
const FAR: i32 = 3_000;

/// A list that begins with some triangles; more are made until there are so many.
fn list(
    name: &'static str,
    (kind, depth_bits): (Kind, u32),
    timed: Vec<Triangle>,
    many: usize,
    hard: bool,
    make: impl Fn(&mut Rng) -> [[i32; 2]; 3],
) -> Workload<Shaded> {
    let mut rng = Rng::with_state(name.bytes().map(u64::from).sum());
    let corner = |at: [i32; 2], rng: &mut Rng| {
        // No blue of 31: a white pixel is one that nothing paints. Nor depths that are farthest, nor the last texels.
        let levels = [rng.int(0, 31), rng.int(0, 63), rng.int(0, 30)];
        let depth = rng.range(0, (1 << depth_bits) - 2) as u32;
        Corner { at, levels, depth, texel: [rng.int(0, 250), rng.int(0, 250)], w: rng.int(1, 16) }
    };
    let mut triangles = timed;
    let timed = if triangles.is_empty() { 12 } else { triangles.len() };
    while triangles.len() < many.max(timed) {
        let places = make(&mut rng);
        let [a, b, c] = places.map(|[x, y]| (x, y));
        if twice_area(a, b, c) != 0 {
            triangles.push(places.map(|at| corner(at, &mut rng)));
        }
    }
    let shapes = triangles.into_iter().map(|corners| Shaded { kind, corners }).collect();
    Workload { name, shapes, timed, hard }
}

/// A place on the screen, in 1/256 pixel.
fn place(rng: &mut Rng) -> [i32; 2] {
    [rng.int(0, WIDTH * 256), rng.int(0, HEIGHT * 256)]
}

/// In a square so many pixels wide.
fn in_square(rng: &mut Rng, side: i32) -> [[i32; 2]; 3] {
    let (x, y) = (rng.int(0, (WIDTH - side) * 256), rng.int(0, (HEIGHT - side) * 256));
    [(); 3].map(|()| [x + rng.int(0, side * 256), y + rng.int(0, side * 256)])
}

/// A quarter of the screen, or more.
fn large(rng: &mut Rng) -> [[i32; 2]; 3] {
    loop {
        let places = [(); 3].map(|()| place(rng));
        let [a, b, c] = places.map(|[x, y]| (x, y));
        // Twice the area in 1/65,536 square pixel.
        if twice_area(a, b, c).abs() > (20_000 << 17) {
            return places;
        }
    }
}

/// From anywhere to anywhere, and at most 1.5 pixels wide.
fn sliver(rng: &mut Rng) -> [[i32; 2]; 3] {
    let (a, b) = (place(rng), place(rng));
    let part = rng.int(0, 256);
    let between = |i: usize| a[i] + ((i64::from(b[i] - a[i]) * i64::from(part)) >> 8) as i32;
    let c = [between(0) + rng.int(-384, 384), between(1) + rng.int(-384, 384)];
    [a, b, c.map(|n| n.max(0)).map(|n| n.min(HEIGHT * 256))]
}

/// Around a place of the screen, and far beyond it.
fn far(rng: &mut Rng) -> [[i32; 2]; 3] {
    loop {
        let places = [(); 3].map(|()| [rng.int(-FAR * 256, FAR * 256), rng.int(-FAR * 256, FAR * 256)]);
        let ([a, b, c], p) = (places.map(|[x, y]| (x, y)), place(rng));
        let sides = [(a, b), (b, c), (c, a)].map(|(a, b)| twice_area(a, b, (p[0], p[1])).signum());
        if sides[0] == sides[1] && sides[1] == sides[2] {
            return places;
        }
    }
}

/// Four times the mesh side by side, so that it fills the screen.
fn meshes() -> Vec<Triangle> {
    let moved = |[dx, dy]: [i32; 2]| {
        let corner = move |c: Corner| Corner { at: [c.at[0] + dx * 256, c.at[1] + dy * 256], ..c };
        scene::mesh().map(|triangle| triangle.map(corner))
    };
    [[0, 0], [WIDTH / 2, 0], [0, HEIGHT / 2], [WIDTH / 2, HEIGHT / 2]].into_iter().flat_map(moved).collect()
}

/// Lists of large, of small, of thin and of far triangles.
fn lists(quick: bool, kind: (Kind, u32)) -> Vec<Workload<Shaded>> {
    let many = |full: usize| judged(full, quick);
    let small = match kind.0 {
        Kind::Depth => list("mesh of 50 px", kind, meshes(), many(5_000), false, |rng| in_square(rng, 14)),
        _ => list("100 px", kind, scene::small().to_vec(), many(2_000), false, |rng| in_square(rng, 20)),
    };
    let mut lists = vec![
        list("20,000 px", kind, scene::LARGE.to_vec(), many(60), false, large),
        small,
        list("slivers", kind, Vec::new(), many(2_000), false, sliver),
        list("off-screen", kind, Vec::new(), many(120), true, far),
    ];
    if kind.1 == 32 {
        // Those of 16 bits have all of them.
        let depth = |corner: Corner| Corner { depth: corner.depth << 16 | corner.depth, ..corner };
        lists[1].shapes[..meshes().len()].iter_mut().for_each(|s| s.corners = s.corners.map(depth));
    }
    lists
}

pub(super) fn gouraud(quick: bool) -> Vec<Workload<Shaded>> {
    lists(quick, (Kind::Levels, 16))
}

pub(super) fn depth(quick: bool, bits: u32) -> Vec<Workload<Shaded>> {
    lists(quick, (Kind::Depth, bits))
}

pub(super) fn perspective(quick: bool) -> Vec<Workload<Shaded>> {
    lists(quick, (Kind::Texels, 16))
}
