//! What is asked of polygons, segments and viewports, by the rules, in wide integers.

use super::{shapes, wide, Units};

/// The outline without vertices that repeat the one before.
fn without_repeats(contour: &[Units]) -> Vec<Units> {
    let mut kept = contour.to_vec();
    kept.dedup();
    while kept.len() > 1 && kept.first() == kept.last() {
        kept.pop();
    }
    kept
}

/// The corners of the convex hull, in order (monotone chain, A. M. Andrew, 1979); no three on a line.
pub fn hull(contour: &[Units]) -> Vec<Units> {
    let mut places = contour.to_vec();
    places.sort_unstable();
    places.dedup();
    if places.len() < 3 {
        return places;
    }
    let half = |places: &mut dyn Iterator<Item = Units>| {
        let mut chain: Vec<Units> = vec![];
        for p in places {
            while chain.len() > 1 && shapes::twice_area(chain[chain.len() - 2], chain[chain.len() - 1], p) <= 0 {
                chain.pop();
            }
            chain.push(p);
        }
        chain.pop();
        chain
    };
    let mut hull = half(&mut places.iter().copied());
    hull.extend(half(&mut places.iter().rev().copied()));
    hull
}

/// Convex by its hull: all vertices lie on it, and come in its order, once round, in one direction or the other.
pub fn convex_twin(contour: &[Units]) -> bool {
    let contour = without_repeats(contour);
    let hull = hull(&contour);
    let n = hull.len();
    // Where on the hull: the side, and how far along it.
    let place = |p: Units| {
        (0..n).find_map(|i| {
            let (a, b) = (hull[i], hull[(i + 1) % n]);
            let within = |a: i32, b: i32, p: i32| a.min(b) <= p && p <= a.max(b);
            let on = p != b && shapes::twice_area(a, b, p) == 0 && within(a.0, b.0, p.0) && within(a.1, b.1, p.1);
            on.then(|| (i, (wide(p).0 - wide(a).0).abs() + (wide(p).1 - wide(a).1).abs()))
        })
    };
    if n < 2 {
        return true;
    }
    if n == 2 {
        // There and back: the order along the line changes its direction twice.
        let steps: Vec<bool> = (0..contour.len()).map(|i| contour[i] < contour[(i + 1) % contour.len()]).collect();
        return (0..steps.len()).filter(|&i| steps[i] != steps[(i + 1) % steps.len()]).count() == 2;
    }
    let Some(places) = contour.iter().map(|&p| place(p)).collect::<Option<Vec<_>>>() else { return false };
    let count = |step: fn(&(usize, i128), &(usize, i128)) -> bool| {
        (0..places.len()).filter(|&i| step(&places[i], &places[(i + 1) % places.len()])).count()
    };
    count(|a, b| a >= b) == 1 || count(|a, b| a <= b) == 1
}

/// A fraction with a positive denominator.
#[derive(Copy, Clone, Debug)]
pub struct Ratio(pub i128, pub i128);

impl Ratio {
    /// Of any sign.
    pub fn new(n: i128, d: i128) -> Self {
        Self(n * d.signum(), d.abs())
    }

    /// `a + (b - a) t` lies in `low..=high`?
    fn keeps(self, a: i128, b: i128, (low, high): (i128, i128)) -> bool {
        let at = a * self.1 + (b - a) * self.0;
        low * self.1 <= at && at <= high * self.1
    }

    /// `a + (b - a) t`, rounded to nearest, halves upwards.
    pub fn nearest(self, a: i128, b: i128) -> i32 {
        let twice = 2 * (a * self.1 + (b - a) * self.0) + self.1;
        i32::try_from(twice.div_euclid(2 * self.1)).expect("between the ends")
    }
}

/// The first and the last place of a segment that lie in a rectangle, out of its ends and its crossings with four lines.
pub fn clip_twin([a, b]: [Units; 2], [p, q]: [Units; 2]) -> Option<[Ratio; 2]> {
    let ((ax, ay), (bx, by)) = (wide(a), wide(b));
    let ((px, py), (qx, qy)) = (wide(p), wide(q));
    let mut all = vec![Ratio(0, 1), Ratio(1, 1)];
    for (a, b, side) in [(ax, bx, px), (ax, bx, qx), (ay, by, py), (ay, by, qy)] {
        if a != b {
            all.push(Ratio::new(side - a, b - a));
        }
    }
    all.retain(|t| 0 <= t.0 && t.0 <= t.1);
    all.retain(|t| t.keeps(ax, bx, (px.min(qx), px.max(qx))) && t.keeps(ay, by, (py.min(qy), py.max(qy))));
    let order = |s: &Ratio, t: &Ratio| (s.0 * t.1).cmp(&(t.0 * s.1));
    Some([all.iter().copied().min_by(order)?, all.iter().copied().max_by(order)?])
}

/// The rule of the documentation, in wide integers.
pub fn map_twin(v: i32, from: (i32, i32), to: (i32, i32)) -> i32 {
    let ((v, v0, v1), (p0, p1)) = ((i128::from(v), i128::from(from.0), i128::from(from.1)), wide(to));
    if v0 == v1 {
        return to.0;
    }
    let t = Ratio::new((v - v0) * (p1 - p0), v1 - v0);
    let p = p0 + (2 * t.0 + t.1).div_euclid(2 * t.1);
    p.clamp(i32::MIN.into(), i32::MAX.into()) as i32
}
