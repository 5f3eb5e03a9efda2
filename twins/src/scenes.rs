//! Random shapes and the windows to look at them through, with a liking for trouble.

use embedded_raster::Rect;

use super::{rng::Rng, Units};

/// How far the vertices of a shape lie apart.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Scale {
    /// A few pixels.
    Tiny,
    /// A screen.
    Screen,
    /// A hundred screens.
    Hundred,
    /// Anywhere up to the ends of the type.
    Ends,
}

impl Scale {
    /// From small to large.
    pub const ALL: [Self; 4] = [Self::Tiny, Self::Screen, Self::Hundred, Self::Ends];

    /// How far from its anchor a shape goes, in pixels.
    const fn pixels(self) -> i64 {
        match self {
            Self::Tiny => 7,
            Self::Screen => 320,
            Self::Hundred => 32_000,
            Self::Ends => 1 << 32,
        }
    }
}

fn clamp(n: i64) -> i32 {
    n.clamp(i32::MIN.into(), i32::MAX.into()) as i32
}

/// A place that a shape is drawn around, for numbers from `-2^bits` on: near zero, far away, at the ends.
fn anchor(rng: &mut Rng, end: i64) -> i64 {
    match rng.below(6) {
        0 | 1 => rng.range(-4, 40).min(end),
        2 => rng.range(-40, 4),
        3 => rng.range(-end, end),
        4 => end - rng.range(0, 40),
        _ => -end + rng.range(0, 40),
    }
}

/// Numbers at the ends of the type.
fn extreme(rng: &mut Rng) -> i32 {
    let near = rng.int(0, 600);
    match rng.below(4) {
        0 => i32::MIN + near,
        1 => i32::MAX - near,
        2 => rng.pick(&[i32::MIN, i32::MIN + 1, i32::MAX - 1, i32::MAX, -1, 0, 1, 128, -128]),
        _ => rng.bits() as i32,
    }
}

/// Puts a number of units on a grid that makes trouble: anywhere, half pixels, corners, centres of pixels, quarters.
fn snapped(n: i64, grid: u64) -> i64 {
    match grid {
        0 => n,
        1 => n & !127,
        2 => n & !255,
        3 => (n & !255) + 128,
        _ => n & !63,
    }
}

/// The vertices of a random shape, in 24.8 units.
pub fn outline(rng: &mut Rng, scale: Scale, n: usize) -> Vec<Units> {
    let anchor = (anchor(rng, 8_388_000) * 256, anchor(rng, 8_388_000) * 256);
    let reach = scale.pixels() * 256;
    // Narrow shapes are likelier to fail than round ones.
    let reach =
        (rng.pick(&[reach, reach, reach, 300, 2]).min(reach), rng.pick(&[reach, reach, reach, 300, 2]).min(reach));
    let grid = rng.below(7);
    let mut places: Vec<Units> = Vec::with_capacity(n);
    for _ in 0..n {
        let place = if scale == Scale::Ends && !rng.one_in(8) {
            (extreme(rng), extreme(rng))
        } else {
            let x = snapped(anchor.0 + rng.range(-reach.0, reach.0), grid);
            (clamp(x), clamp(snapped(anchor.1 + rng.range(-reach.1, reach.1), grid)))
        };
        let place = related(rng, &places, place);
        places.push(place);
    }
    places
}

/// Now and then a vertex shares something with those before it: itself, a coordinate, the line through two of them.
fn related(rng: &mut Rng, places: &[Units], place: Units) -> Units {
    let Some(last) = places.len().checked_sub(1) else { return place };
    let other = places[rng.index(places.len())];
    match rng.below(24) {
        0 => other,
        1 => (other.0, place.1),
        2 | 3 => (place.0, other.1),
        4 | 5 if last > 0 => {
            let (x, y) = between(rng, other, places[last]);
            (clamp(x + rng.range(-1, 1)), clamp(y + rng.range(-1, 1)))
        }
        6 if last > 0 => {
            // Exactly in the middle, when there is such a place: collinear.
            let (p, q) = (places[last], places[last - 1]);
            (i32::midpoint(p.0, q.0), i32::midpoint(p.1, q.1))
        }
        _ => place,
    }
}

/// A place on the side from a to b.
fn between(rng: &mut Rng, a: Units, b: Units) -> (i64, i64) {
    let t = i128::from(rng.below(1 << 32));
    let mix = |a: i32, b: i32| (i128::from(a) + (i128::from(b) - i128::from(a)) * t / (1 << 32)) as i64;
    (mix(a.0, b.0), mix(a.1, b.1))
}

/// A window near a pixel: from 1 x 1 to 48 x 40, the small ones more often.
pub fn window_near(rng: &mut Rng, x: i64, y: i64) -> Rect {
    let (width, height) = match rng.below(16) {
        0 => (1, 1),
        1 => (1, rng.range(1, 40)),
        2 => (rng.range(1, 48), 1),
        3 => (rng.range(1, 48), rng.range(1, 40)),
        4..=9 => (rng.range(1, 8), rng.range(1, 6)),
        _ => (rng.range(2, 20), rng.range(2, 16)),
    };
    let start = |rng: &mut Rng, at: i64, size: i64| {
        (at - rng.range(-1, size)).clamp(i32::MIN.into(), i64::from(i32::MAX) - size) as i32
    };
    let (x0, y0) = (start(rng, x, width), start(rng, y, height));
    Rect::new(x0, y0, x0 + width as i32, y0 + height as i32)
}

/// A window where a shape is likely to be seen: over one of its sides, a vertex, or between its vertices.
pub fn window_on(rng: &mut Rng, outline: &[Units]) -> Rect {
    let (a, b, c) = (rng.pick(outline), rng.pick(outline), rng.pick(outline));
    let i = rng.index(outline.len());
    let place = match rng.below(10) {
        0 => (a.0.into(), a.1.into()),
        1 => (i64::from(a.0 >> 1) + i64::from(b.0 >> 1), i64::from(b.1 >> 1) + i64::from(c.1 >> 1)),
        _ => between(rng, outline[i], outline[(i + 1) % outline.len()]),
    };
    window_near(rng, place.0 >> 8, place.1 >> 8)
}

/// The ends of a random line, in pixels.
pub fn ends_of_line(rng: &mut Rng, scale: Scale) -> [(i32, i32); 2] {
    if scale == Scale::Ends {
        return [(extreme(rng), extreme(rng)), (extreme(rng), extreme(rng))];
    }
    let end = i64::from(i32::MAX);
    let at = (anchor(rng, end), anchor(rng, end));
    let reach = scale.pixels();
    let flat = (rng.pick(&[reach, reach, reach, 1, 0]), rng.pick(&[reach, reach, reach, 1, 0]));
    let mut place = || (clamp(at.0 + rng.range(-flat.0, flat.0)), clamp(at.1 + rng.range(-flat.1, flat.1)));
    [place(), place()]
}

/// A window on a line or beside it.
pub fn window_on_line(rng: &mut Rng, [a, b]: [(i32, i32); 2]) -> Rect {
    let (x, y) = match rng.below(8) {
        0 => (a.0.into(), a.1.into()),
        1 => (b.0.into(), b.1.into()),
        _ => between(rng, a, b),
    };
    window_near(rng, x, y)
}
