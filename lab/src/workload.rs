//! What is drawn: lists of shapes of one kind, and meshes that should cover every pixel once.

use std::f64::consts::TAU;

use embedded_graphics::geometry::Point;
use embedded_raster::Rect;
use twins::rng::Rng;

use crate::{
    frame::{HEIGHT, WIDTH},
    shape::{Blob, Curve, Job, Line, Oval, Polygon, Pool, Thick, Thin, Triangle, Units, ONE, SPRITE},
};

/// A list of shapes of one kind. The first `timed` of them are enough to measure cost; error is judged on all.
pub(crate) struct Workload<S> {
    pub(crate) name: &'static str,
    pub(crate) shapes: Vec<S>,
    pub(crate) timed: usize,
    /// Not everybody can do it, as corners lie far off the screen, or ends are round: the others sit it out.
    pub(crate) hard: bool,
}

impl<S> Workload<S> {
    fn new(
        name: &'static str,
        (timed, judged): (usize, usize),
        hard: bool,
        mut make: impl FnMut(&mut Rng) -> S,
    ) -> Self {
        let mut rng = Rng::with_state(name.bytes().map(u64::from).sum());
        Self { name, shapes: (0..judged.max(timed)).map(|_| make(&mut rng)).collect(), timed, hard }
    }

    pub(crate) fn measured(&self) -> &[S] {
        &self.shapes[..self.timed]
    }
}

/// How far off the screen "far" is: 100 screens.
const FAR: i32 = 31_000;
const CENTRE: (f64, f64) = (WIDTH as f64 / 2.0, HEIGHT as f64 / 2.0);

/// In units, from pixels.
fn units((x, y): (f64, f64)) -> Units {
    ((x * ONE as f64).round() as i64, (y * ONE as f64).round() as i64)
}

/// The place at an angle (in turns) and a distance from another.
fn polar((x, y): (f64, f64), turn: f64, radius: f64) -> (f64, f64) {
    let (sin, cos) = (turn * TAU).sin_cos();
    (x + radius * cos, y + radius * sin)
}

fn somewhere(rng: &mut Rng, margin: f64) -> (f64, f64) {
    let within = |rng: &mut Rng, size: i32| margin + rng.unit() * (f64::from(size) - 2.0 * margin);
    (within(rng, WIDTH), within(rng, HEIGHT))
}

/// How many shapes the error is judged on.
pub(crate) fn judged(full: usize, quick: bool) -> usize {
    if quick {
        full / 20 + 1
    } else {
        full
    }
}

/// Lines of 12 pixels, lines across the screen, and lines of which the screen sees a hundredth.
pub(crate) fn lines(quick: bool) -> Vec<Workload<Line>> {
    let count = judged(2_000, quick);
    vec![
        Workload::new("12 px", (400.min(count), count), false, short_line),
        Workload::new("across the screen", (60.min(count), count), false, screen_line),
        Workload::new("100 x off-screen", (12, count), true, far_line),
    ]
}

fn short_line(rng: &mut Rng) -> Line {
    let a = (rng.int(11, WIDTH - 12), rng.int(11, HEIGHT - 12));
    let (major, minor) = (if rng.int(0, 1) == 0 { 11 } else { -11 }, rng.int(-11, 11));
    let step = if rng.int(0, 1) == 0 { (major, minor) } else { (minor, major) };
    Line::new(a, (a.0 + step.0, a.1 + step.1))
}

/// From one side of the screen to the opposite one.
fn screen_line(rng: &mut Rng) -> Line {
    let (right, bottom) = (WIDTH - 1, HEIGHT - 1);
    let (a, b) = if rng.int(0, 1) == 0 {
        ((0, rng.int(0, bottom)), (right, rng.int(0, bottom)))
    } else {
        ((rng.int(0, right), 0), (rng.int(0, right), bottom))
    };
    if rng.int(0, 1) == 0 {
        Line::new(a, b)
    } else {
        Line::new(b, a)
    }
}

/// Through a pixel near the middle, both ends far away.
fn far_line(rng: &mut Rng) -> Line {
    let middle = (rng.int(WIDTH / 4, WIDTH * 3 / 4), rng.int(HEIGHT / 4, HEIGHT * 3 / 4));
    let a = if rng.int(0, 1) == 0 { (-FAR, rng.int(-FAR, FAR)) } else { (rng.int(-FAR, FAR), -FAR) };
    let back = rng.unit();
    let beyond = |m: i32, a: i32| m + (f64::from(m - a) * (0.5 + back / 2.0)).round() as i32;
    let b = (beyond(middle.0, a.0), beyond(middle.1, a.1));
    if rng.int(0, 1) == 0 {
        Line::new(a, b)
    } else {
        Line::new(b, a)
    }
}

/// Large, small and thin triangles, corners on centres and sides, and triangles of which the screen sees a small part.
pub(crate) fn triangles(quick: bool) -> Vec<Workload<Triangle>> {
    let count = judged(300, quick);
    vec![
        Workload::new("20,000 px", (12, count), false, large_triangle),
        Workload::new("30 px", (200, 5 * count), false, |rng| small_triangle(rng, units)),
        Workload::new("sliver 200 x 2 px", (60, count), false, sliver),
        Workload::new("30 px, corners on half pixels", (200, 5 * count), false, |rng| small_triangle(rng, half_pixels)),
        Workload::new("100 x off-screen", (12, count / 2), true, far_triangle),
    ]
}

fn twice_area([a, b, c]: [(f64, f64); 3]) -> f64 {
    ((b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0)).abs()
}

fn large_triangle(rng: &mut Rng) -> Triangle {
    loop {
        let corners = [(); 3].map(|()| somewhere(rng, 0.0));
        if (38_000.0..42_000.0).contains(&twice_area(corners)) {
            return Triangle::new(corners.map(units));
        }
    }
}

fn small_triangle(rng: &mut Rng, place: impl Fn((f64, f64)) -> Units) -> Triangle {
    loop {
        let (x, y) = somewhere(rng, 7.0);
        let corners = [(); 3].map(|()| (x + 13.0 * rng.unit() - 6.5, y + 13.0 * rng.unit() - 6.5));
        if (57.0..63.0).contains(&twice_area(corners)) {
            return Triangle::new(corners.map(&place));
        }
    }
}

/// The nearest corner or centre of a pixel: where samples lie exactly on sides.
fn half_pixels((x, y): (f64, f64)) -> Units {
    ((x * 2.0).round() as i64 * (ONE / 2), (y * 2.0).round() as i64 * (ONE / 2))
}

fn sliver(rng: &mut Rng) -> Triangle {
    let (turn, middle) = (rng.unit(), (CENTRE.0 + rng.unit(), CENTRE.1 + rng.unit()));
    let (tip, base) = (polar(middle, turn, 100.0), polar(middle, turn + 0.5, 100.0));
    Triangle::new([tip, base, polar(base, turn + 0.25, 2.0)].map(units))
}

fn far_triangle(rng: &mut Rng) -> Triangle {
    let (tip, turn) = (somewhere(rng, 20.0), rng.unit());
    let width = 0.05 + 0.3 * rng.unit();
    let far = f64::from(FAR) * 0.9;
    Triangle::new([tip, polar(tip, turn, far), polar(tip, turn + width, far * (0.3 + 0.7 * rng.unit()))].map(units))
}

/// Stars, rough outlines, combs of fine teeth, and stars of which the screen sees the middle.
pub(crate) fn polygons(quick: bool) -> Vec<Workload<Polygon>> {
    let count = judged(100, quick);
    vec![
        Workload::new("star, 10 vertices", (12.min(count), count), false, |rng| star(rng, 114.0, 10)),
        Workload::new("outline, 200 vertices", (4, count / 2), false, |rng| star(rng, 91.0, 200)),
        Workload::new("outline, 2,000 vertices", (1, count / 10), false, |rng| star(rng, 91.0, 2_000)),
        Workload::new("comb, teeth of 1 to 40/256 px", (2, count / 10), false, comb),
        Workload::new("100 x off-screen", (12.min(count), count), true, |rng| star(rng, f64::from(FAR), 10)),
    ]
}

/// Vertices around the centre. Ten make a five-pointed star, 200 a circle with a rough edge.
fn star(rng: &mut Rng, radius: f64, count: u32) -> Polygon {
    let (start, middle) = (rng.unit(), (CENTRE.0 + rng.unit(), CENTRE.1 + rng.unit()));
    let corner = |i: u32| {
        // The inner radius of a pentagram is the outer one divided by the golden ratio squared; far ones cut the screen.
        let inner = if radius > 1_000.0 { 0.002 } else { 0.382 };
        let share = if count > 10 {
            0.8 + 0.2 * rng.unit()
        } else if i.is_multiple_of(2) {
            1.0
        } else {
            inner
        };
        units(polar(middle, start + f64::from(i) / f64::from(count), radius * share))
    };
    Polygon::new((0..count).map(corner).collect())
}

/// Forty pixels of teeth, each 1 to 40 units of 1/256 pixel wide, as are the gaps.
fn comb(rng: &mut Rng) -> Polygon {
    let unit = ONE / 256;
    let (left, top) = (20 * ONE + rng.range(0, 255) * unit, 20 * ONE + rng.range(0, 255) * unit);
    let mut x = left;
    let mut outline = vec![(left, top)];
    while x < left + 40 * ONE {
        let (tooth, gap) = (rng.range(1, 40) * unit, rng.range(1, 40) * unit);
        let tip = 180 * ONE + rng.range(0, 20 * ONE);
        outline.extend([(x, top + 8 * ONE), (x + tooth / 2, tip), (x + tooth, top + 8 * ONE)]);
        x += tooth + gap;
    }
    outline.push((x, top));
    Polygon::new(outline)
}

/// Large and small circles, ellipses of all sizes, thin ones, and ones of which the screen sees a part.
pub(crate) fn ellipses(quick: bool) -> Vec<Workload<Oval>> {
    let count = judged(200, quick);
    let sized = |rng: &mut Rng, width: i32, height: i32| {
        let (x, y) = (rng.int(0, (WIDTH - width).max(0)), rng.int(0, (HEIGHT - height).max(0)));
        Oval::new(Rect::new(x, y, x + width, y + height))
    };
    vec![
        Workload::new("circles of 101 px", (12, count), false, |rng| sized(rng, 101, 101)),
        Workload::new("circles of 13 px", (100, count), false, |rng| sized(rng, 13, 13)),
        Workload::new("any, odd sizes", (40, count), false, |rng| {
            let (width, height) = (2 * rng.int(1, 130) + 1, 2 * rng.int(1, 100) + 1);
            sized(rng, width, height)
        }),
        Workload::new("3 px thin", (40, count), false, |rng| {
            let width = 2 * rng.int(20, 150) + 1;
            sized(rng, width, 3)
        }),
        Workload::new("3,001 x 2,001 px", (12, count), true, |rng| {
            let (x, y) = (rng.int(-3_000, 0), rng.int(-2_000, 0));
            Oval::new(Rect::new(x, y, x + 3_001, y + 2_001))
        }),
    ]
}

/// Four places around another, shaken.
fn bent(rng: &mut Rng, middle: (f64, f64), radius: f64) -> [Units; 4] {
    [(); 4].map(|()| units(polar(middle, rng.unit(), radius * rng.unit().sqrt())))
}

/// Curves of the size of letters, curves across the screen, ones that come back to where they were, and large ones.
pub(crate) fn curves(quick: bool) -> Vec<Workload<Curve>> {
    let count = judged(100, quick);
    vec![
        Workload::new("within 20 px", (100.min(count), count), false, |rng| Curve::new(bent(rng, CENTRE, 10.0))),
        Workload::new("within 200 px", (100.min(count), count), false, |rng| Curve::new(bent(rng, CENTRE, 100.0))),
        Workload::new("loops of 200 px", (100.min(count), count), false, |rng| {
            let [a, c, d, _] = bent(rng, CENTRE, 100.0);
            Curve::new([a, c, d, a])
        }),
        Workload::new("within 2,000 px", (100.min(count), count), false, |rng| Curve::new(bent(rng, CENTRE, 1_000.0))),
    ]
}

/// The same, one pixel wide, and curves of which the screen sees a hundredth.
pub(crate) fn outlines(quick: bool) -> Vec<Workload<Thin>> {
    let count = judged(100, quick);
    vec![
        Workload::new("within 20 px", (100.min(count), count), false, |rng| {
            let middle = somewhere(rng, 12.0);
            Thin::new(bent(rng, middle, 10.0))
        }),
        Workload::new("within 200 px", (30.min(count), count), false, |rng| Thin::new(bent(rng, CENTRE, 100.0))),
        Workload::new("100 x off-screen", (12.min(count), count), true, far_curve),
    ]
}

/// Half of it before and half of it after a place on the screen.
fn far_curve(rng: &mut Rng) -> Thin {
    let (middle, turn) = (somewhere(rng, 40.0), rng.unit());
    let far = f64::from(FAR) * 0.9;
    let (a, c) = (polar(middle, turn, far), polar(middle, turn + 0.1, far / 2.0));
    let d = polar(middle, turn + 0.4 * rng.unit(), far / 2.0);
    // The curve at half of its time is (a + 3 c + 3 d + b) / 8.
    let end = |m: f64, a: f64, c: f64, d: f64| 8.0 * m - a - 3.0 * (c + d);
    let b = (end(middle.0, a.0, c.0, d.0), end(middle.1, a.1, c.1, d.1));
    Thin::new([a, c, d, b].map(units))
}

/// Shapes with a smooth edge, large, of the size of letters, and larger than the screen.
pub(crate) fn paths(quick: bool) -> Vec<Workload<Blob>> {
    let count = judged(60, quick);
    vec![
        Workload::new("8 cubics, 200 px", (12.min(count), count), false, |rng| blob(rng, CENTRE, 110.0, 8)),
        Workload::new("6 cubics, 20 px", (60.min(count), count), false, |rng| {
            let middle = somewhere(rng, 14.0);
            blob(rng, middle, 11.0, 6)
        }),
        Workload::new("32 cubics, 200 px", (6.min(count), count), false, |rng| blob(rng, CENTRE, 110.0, 32)),
        Workload::new("8 cubics, 4,000 px", (6.min(count), count), true, |rng| blob(rng, CENTRE, 2_000.0, 8)),
    ]
}

/// Curves from corner to corner around a place, all of them smooth. Every other corner of a large one lies near the screen.
fn blob(rng: &mut Rng, middle: (f64, f64), radius: f64, count: u32) -> Blob {
    let (start, step) = (rng.unit(), 1.0 / f64::from(count));
    let corner = |i: u32, rng: &mut Rng| {
        let inner = if radius > 1_000.0 && i.is_multiple_of(2) { 0.05 } else { 1.0 };
        (start + f64::from(i) * step, radius * inner * (0.5 + 0.5 * rng.unit()))
    };
    let corners: Vec<_> = (0..count).map(|i| corner(i, rng)).collect();
    let curve = |i: usize| {
        let ((turn, r), (next, s)) = (corners[i], corners[(i + 1) % corners.len()]);
        // Control points along the circle through the corner.
        let pull = TAU * step / 3.0;
        let (a, b) = (polar(middle, turn, r), polar(middle, next, s));
        Curve::new([a, polar(a, turn + 0.25, r * pull), polar(b, next - 0.25, s * pull), b].map(units))
    };
    Blob::new((0..corners.len()).map(curve).collect())
}

/// Lines with a width: without ends, and with round ones; lines around corners.
pub(crate) fn strokes(quick: bool) -> Vec<Workload<Thick>> {
    let count = judged(60, quick);
    let line = |rng: &mut Rng, length: f64, width: u16, round: bool| {
        let (middle, turn) = (somewhere(rng, length / 2.0 + f64::from(width)), rng.unit());
        let end = |turn: f64| pixel(polar(middle, turn, length / 2.0));
        Thick::new(vec![end(turn), end(turn + 0.5)], width, round)
    };
    vec![
        Workload::new("100 x 3 px", (60.min(count), count), false, |rng| line(rng, 100.0, 3, false)),
        Workload::new("100 x 12 px", (30.min(count), count), false, |rng| line(rng, 100.0, 12, false)),
        Workload::new("100 x 7 px, round ends", (30.min(count), count), true, |rng| line(rng, 100.0, 7, true)),
        Workload::new("8 lines, 6 px, round corners", (12.min(count), count), true, |rng| {
            Thick::new((0..9).map(|_| pixel(somewhere(rng, 8.0))).collect(), 6, true)
        }),
    ]
}

/// The pixel that contains a place.
fn pixel((x, y): (f64, f64)) -> Point {
    Point::new(x.floor() as i32, y.floor() as i32)
}

/// Open water, one corridor, and a maze.
pub(crate) fn floods(quick: bool) -> Vec<Workload<Pool>> {
    let count = judged(20, quick);
    let walls = |has: &dyn Fn(i32, i32) -> bool| -> Vec<bool> {
        (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y))).map(|(x, y)| has(x, y)).collect()
    };
    vec![
        Workload::new("disc of 31,000 px", (1, count), false, |rng| {
            let (cx, cy) = (rng.int(110, 200), rng.int(105, 130));
            Pool::new(walls(&|x, y| (x - cx).pow(2) + (y - cy).pow(2) > 9_900), Point::new(cx, cy))
        }),
        // To and fro, with a turn at the end of every other row.
        Workload::new("one corridor", (1, count), false, |rng| {
            let gap = rng.int(0, 1);
            let turn = |y: i32| if (y / 2) % 2 == gap { 0 } else { WIDTH - 1 };
            Pool::new(walls(&|x, y| y % 2 == 1 && x != turn(y)), Point::new(5, 0))
        }),
        Workload::new("random maze", (1, count), false, |rng| {
            // Cells of two pixels; each has a wall to its right or below it.
            let open: Vec<bool> = (0..WIDTH * HEIGHT / 4).map(|_| rng.int(0, 1) == 0).collect();
            let cell = |x: i32, y: i32| open[(y / 2 * (WIDTH / 2) + x / 2) as usize];
            let wall = |x: i32, y: i32| match (x % 2, y % 2) {
                (0, 0) => false,
                (1, 0) => !cell(x, y),
                (0, 1) => cell(x, y),
                _ => true,
            };
            Pool::new(walls(&wall), Point::new(0, 0))
        }),
    ]
}

/// Memory at 16 bits and at one.
pub(crate) fn memory(quick: bool) -> Vec<Workload<Job>> {
    let count = judged(100, quick);
    let label = |rng: &mut Rng| Point::new(rng.int(0, 150), rng.int(10, HEIGHT - 10));
    let near = |rng: &mut Rng| Point::new(rng.int(0, WIDTH - SPRITE), rng.int(0, HEIGHT - SPRITE));
    vec![
        Workload::new("lines, 1 bit", (40, count), false, |rng| Job::BitLine(screen_line(rng))),
        Workload::new("rectangles, 1 bit", (40, count), false, |rng| {
            let (x, y) = (rng.int(0, 60), rng.int(0, 60));
            Job::BitRectangle(Rect::new(x, y, x + rng.int(150, 250), y + rng.int(100, 170)))
        }),
        Workload::new("triangles of 20,000 px, 1 bit", (12, count), false, |rng| Job::BitTriangle(large_triangle(rng))),
        Workload::new("blit 64 x 64", (40, count), false, |rng| Job::Blit(near(rng))),
        Workload::new("blit 64 x 64, colour key", (40, count), false, |rng| Job::BlitKeyed(near(rng))),
        Workload::new("opaque text", (12, count), false, |rng| Job::Text(label(rng))),
        Workload::new("opaque text as masks", (12, count), false, |rng| Job::Glyphs(label(rng))),
    ]
}

/// Triangles that cover every pixel of the screen exactly once, if their shared sides are drawn by one of them only.
pub(crate) struct Mesh {
    pub(crate) name: &'static str,
    /// Several ones, each a cover of its own.
    pub(crate) covers: Vec<Vec<Triangle>>,
    pub(crate) far: bool,
}

pub(crate) fn meshes(quick: bool) -> Vec<Mesh> {
    let copies = if quick { 1 } else { 10 };
    let fans = if quick { 4 } else { 60 };
    vec![
        Mesh { name: "random mesh", covers: (0..copies).map(|i| grid(i, units)).collect(), far: false },
        Mesh {
            name: "corners on half pixels",
            covers: (0..copies).map(|i| grid(i, half_pixels)).collect(),
            far: false,
        },
        Mesh { name: "fans 100 x off-screen", covers: (0..fans).map(fan).collect(), far: true },
    ]
}

/// Cells of 20 pixels with shaken corners, each cut along one of its diagonals; it reaches beyond the screen all round.
fn grid(seed: u64, place: impl Fn((f64, f64)) -> Units) -> Vec<Triangle> {
    let mut rng = Rng::with_state(seed);
    let (columns, rows) = (WIDTH / 20 + 3, HEIGHT / 20 + 3);
    let mut shaken = |i: i32| f64::from(20 * (i - 1)) + 8.0 * rng.unit() - 4.0;
    let corners: Vec<Vec<_>> =
        (0..=rows).map(|j| (0..=columns).map(|i| place((shaken(i), shaken(j)))).collect()).collect();
    let cell = |(i, j): (usize, usize)| {
        let [a, b, c, d] = [corners[j][i], corners[j][i + 1], corners[j + 1][i + 1], corners[j + 1][i]];
        if (i + j) % 2 == 0 {
            [[a, b, c], [c, d, a]]
        } else {
            [[b, c, d], [d, a, b]]
        }
    };
    let (columns, rows) = (columns as usize, rows as usize);
    (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j))).flat_map(cell).map(Triangle::new).collect()
}

/// Twenty-four triangles around a place on the screen, each reaching far off it.
fn fan(seed: u64) -> Vec<Triangle> {
    let mut rng = Rng::with_state(seed);
    let (middle, start) = (somewhere(&mut rng, 20.0), rng.unit());
    let mut rim: Vec<_> = (0..24).map(|i| units(polar(middle, start + f64::from(i) / 24.0, 28_000.0))).collect();
    rim.push(rim[0]);
    rim.windows(2).map(|side| Triangle::new([units(middle), side[0], side[1]])).collect()
}
