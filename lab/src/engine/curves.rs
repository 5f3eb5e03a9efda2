//! Ways to turn a cubic Bézier curve into lines.
//!
//! Those in `f32` leave places in `f32`, this crate's leave vertices of 1/256 pixel.

use embedded_raster::{Path, PointFx};

use super::{entry, Engine, Entry, Origin};
use crate::{judge::Polyline, shape::Curve};

type Place = (f32, f32);

pub(crate) fn entries() -> Vec<Entry<Curve, Polyline>> {
    use Origin::{Crate, Textbook};
    vec![
        entry("uniform4", "4 lines of equal time, f32", Textbook, floats(|out, c| uniform(4, c, |p| out.push(p)))),
        entry("uniform8", "8 lines, f32", Textbook, floats(|out, c| uniform(8, c, |p| out.push(p)))),
        entry("uniform16", "16 lines, f32", Textbook, floats(|out, c| uniform(16, c, |p| out.push(p)))),
        entry("uniform32", "32 lines, f32", Textbook, floats(|out, c| uniform(32, c, |p| out.push(p)))),
        entry(
            "halves",
            "de Casteljau, halved until flat, f32",
            Textbook,
            floats(|out, c| {
                out.push(c.floats[0]);
                halve(c.floats, &mut |p| out.push(p), 0);
            }),
        ),
        entry(
            "crate",
            "halved until flat: `Path::contours`",
            Crate,
            flattener(
                |out: &mut Vec<PointFx>, c| out.extend(Path::new(&c.segments).contours().flatten()),
                |v| (v.x.to_num(), v.y.to_num()),
            ),
        ),
    ]
}

/// Keeps the lines of the last curve.
struct Flattener<P, F, G> {
    places: Vec<P>,
    flatten: F,
    place: G,
}

fn flattener<P, F: FnMut(&mut Vec<P>, &Curve), G: Fn(&P) -> (f64, f64)>(flatten: F, place: G) -> Flattener<P, F, G> {
    Flattener { places: Vec::with_capacity(1 << 12), flatten, place }
}

fn floats(flatten: impl FnMut(&mut Vec<Place>, &Curve)) -> impl Engine<Curve, Polyline> {
    flattener(flatten, |p: &Place| (p.0.into(), p.1.into()))
}

impl<P, F: FnMut(&mut Vec<P>, &Curve), G: Fn(&P) -> (f64, f64)> Engine<Curve, Polyline> for Flattener<P, F, G> {
    fn draw(&mut self, shapes: &[Curve]) {
        for curve in shapes {
            self.places.clear();
            (self.flatten)(&mut self.places, curve);
        }
    }

    fn clear(&mut self) {
        self.places.clear();
    }

    fn painted(&self) -> Polyline {
        self.places.iter().map(&self.place).collect()
    }
}

/// The ends of n lines: the curve at n + 1 times, by Bernstein's polynomials.
#[inline(always)]
pub(super) fn uniform(n: u16, curve: &Curve, mut emit: impl FnMut(Place)) {
    let [a, c, d, b] = curve.floats;
    for i in 0..=n {
        let t = f32::from(i) / f32::from(n);
        let s = 1.0 - t;
        let (p, q, r, w) = (s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t);
        emit((p * a.0 + q * c.0 + r * d.0 + w * b.0, p * a.1 + q * c.1 + r * d.1 + w * b.1));
    }
}

/// As this crate's: 34.6/256 pixel.
const TOLERANCE: f32 = 34.6 / 256.0;

/// The ends of lines after the first, each within the tolerance: by halves until both control points are so near to the
/// chord that the curve, which keeps 3/4 of their distance at most, stays within it.
pub(super) fn halve([a, c, d, b]: [Place; 4], emit: &mut impl FnMut(Place), depth: u32) {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let square = dx * dx + dy * dy;
    // Of a loop, whose ends are the same place, the control points must be near to that.
    let off = |p: Place| {
        let (px, py) = (p.0 - a.0, p.1 - a.1);
        let (across, along) = (px * dy - py * dx, px * dx + py * dy);
        if along < 0.0 || along >= square {
            px * px + py * py
        } else {
            across * across / square.max(f32::MIN_POSITIVE)
        }
    };
    let far = TOLERANCE * TOLERANCE * (16.0 / 9.0);
    if depth == 16 || off(c).max(off(d)) <= far {
        return emit(b);
    }
    let middle = |p: Place, q: Place| (f32::midpoint(p.0, q.0), f32::midpoint(p.1, q.1));
    let (ac, cd, db) = (middle(a, c), middle(c, d), middle(d, b));
    let (left, right) = (middle(ac, cd), middle(cd, db));
    let at = middle(left, right);
    halve([a, ac, left, at], emit, depth + 1);
    halve([at, right, db, b], emit, depth + 1);
}
