//! Shapes with soft rims: those whose cost is measured first, then many at random, on which the error is judged.

use embedded_raster::FillRule;
use textbook::scene;
use twins::{rng::Rng, twice_area, Units};

use super::{outline::Outline, shape::Soft};
use crate::{
    frame::{HEIGHT, WIDTH},
    workload::{judged, Workload},
};

/// A list that begins with some shapes; more are made until there are so many. Of none, twelve are timed.
fn list(
    name: &'static str,
    timed: Vec<Outline>,
    many: usize,
    hard: bool,
    rule: FillRule,
    mut make: impl FnMut(&mut Rng) -> Outline,
) -> Workload<Soft> {
    let mut rng = Rng::with_state(name.bytes().map(u64::from).sum());
    let mut outlines = timed;
    let timed = if outlines.is_empty() { 12 } else { outlines.len() };
    while outlines.len() < many.max(timed) {
        outlines.push(make(&mut rng));
    }
    Workload { name, shapes: outlines.into_iter().map(|outline| Soft::new(outline, rule)).collect(), timed, hard }
}

/// A place on the screen.
fn place(rng: &mut Rng) -> Units {
    (rng.int(0, WIDTH * 256), rng.int(0, HEIGHT * 256))
}

/// A corner of a square so many pixels wide.
fn square(rng: &mut Rng, side: i32) -> Units {
    (rng.int(0, (WIDTH - side) * 256), rng.int(0, (HEIGHT - side) * 256))
}

/// A polygon of places in a square.
fn in_square(rng: &mut Rng, side: i32, corners: usize) -> Outline {
    let (x, y) = square(rng, side);
    Outline::Polygon(vec![(0..corners).map(|_| (x + rng.int(0, side * 256), y + rng.int(0, side * 256))).collect()])
}

/// A quarter of the screen, or more.
fn large(rng: &mut Rng) -> Outline {
    loop {
        let [a, b, c] = [(); 3].map(|()| place(rng));
        if twice_area(a, b, c).abs() > (20_000 << 17) {
            return Outline::Polygon(vec![vec![a, b, c]]);
        }
    }
}

/// From anywhere to anywhere, and at most a pixel and a half wide.
fn sliver(rng: &mut Rng) -> Outline {
    let (a, b) = (place(rng), place(rng));
    let part = i64::from(rng.int(0, 256));
    let between = |a: i32, b: i32| a + ((i64::from(b - a) * part) >> 8) as i32;
    let c = (between(a.0, b.0) + rng.int(-384, 384), between(a.1, b.1) + rng.int(-384, 384));
    Outline::Polygon(vec![vec![a, b, (c.0.clamp(0, WIDTH * 256), c.1.clamp(0, HEIGHT * 256))]])
}

fn circle(rng: &mut Rng) -> Outline {
    let radius = rng.int(300, 14_000);
    let within = |rng: &mut Rng, size: i32| rng.int(radius, size * 256 - radius);
    Outline::Circle((within(rng, WIDTH), within(rng, HEIGHT)), radius)
}

/// Eight curves around a place, each going on as the one before.
fn blob(rng: &mut Rng) -> Outline {
    let middle = (rng.int(110 * 256, 210 * 256), rng.int(110 * 256, 130 * 256));
    let turns: Vec<_> = (0..8).map(|i| (f64::from(i) / 8.0 * std::f64::consts::TAU).sin_cos()).collect();
    let radii: Vec<_> = (0..8).map(|_| f64::from(rng.int(60, 100) * 256)).collect();
    let at = |i: usize, out: f64, along: f64| {
        let (sin, cos) = turns[i % 8];
        (middle.0 + (out * cos - along * sin) as i32, middle.1 + (out * sin + along * cos) as i32)
    };
    let corner = |i: usize, along: f64| at(i, radii[i % 8], along * radii[i % 8] / 4.0);
    Outline::Curves((0..8).map(|i| [corner(i, 0.0), corner(i, 1.0), corner(i + 1, -1.0), corner(i + 1, 0.0)]).collect())
}

/// Between places at least ten pixels apart.
fn line(rng: &mut Rng) -> Outline {
    let inner = |rng: &mut Rng| (rng.int(512, (WIDTH - 2) * 256), rng.int(512, (HEIGHT - 2) * 256));
    loop {
        let (a, b) = (inner(rng), inner(rng));
        if (a.0 - b.0).abs() + (a.1 - b.1).abs() > 2_560 {
            return Outline::Line(a, b);
        }
    }
}

pub(super) fn all(quick: bool) -> Vec<Workload<Soft>> {
    let many = |full: usize| judged(full, quick);
    let triangle =
        |t: &scene::Triangle| Outline::Polygon(vec![t.iter().map(|corner| (corner.at[0], corner.at[1])).collect()]);
    let rule = FillRule::NonZero;
    vec![
        list("20,000 px", scene::LARGE.iter().map(triangle).collect(), many(40), false, rule, large),
        list("100 px", scene::small().iter().map(triangle).collect(), many(4_000), false, rule, |rng| {
            in_square(rng, 20, 3)
        }),
        list("slivers", Vec::new(), many(1_500), false, rule, sliver),
        list("circles", vec![Outline::Circle((160 * 256, 120 * 256), 50 * 256)], many(300), false, rule, circle),
        list("8 curves", Vec::new(), many(60), false, rule, blob),
        list("lines", Vec::new(), many(400), true, rule, line),
        list("crossings", Vec::new(), many(4_000), false, rule, |rng| in_square(rng, 6, 7)),
    ]
}
