//! Strokes of true curves, in `f64`: which places lie in them. Curves are not flattened. They are looked at in many places, so
//! densely that what happens in between is far below the rounding that a rasterizer may do.

use embedded_raster::{Cap, Join};

use super::{
    curves::{bezier, Piece},
    strokes::Pen,
};

type Place = (f64, f64);

/// How often a curve is halved at most.
const DEPTH: u32 = 26;

/// A place on a path, and the direction there, of length 1.
#[derive(Copy, Clone, Debug)]
struct Sample {
    /// Of the segment.
    time: f64,
    at: Place,
    way: Place,
}

/// The stroke of a path.
#[derive(Debug)]
pub struct Model {
    pen: Pen,
    half: f64,
    /// Along each segment.
    runs: Vec<Vec<Sample>>,
    /// Where two segments meet: the place, and the directions before and after.
    corners: Vec<(Place, Place, Place)>,
    /// The ends of open contours, seen from the contour.
    ends: Vec<Sample>,
    dots: Vec<Place>,
}

fn sub(a: Place, b: Place) -> Place {
    (a.0 - b.0, a.1 - b.1)
}

fn dot(a: Place, b: Place) -> f64 {
    a.0 * b.0 + a.1 * b.1
}

fn cross(a: Place, b: Place) -> f64 {
    a.0 * b.1 - a.1 * b.0
}

fn unit(a: Place) -> Option<Place> {
    let length = a.0.hypot(a.1);
    (length > 1e-9).then(|| (a.0 / length, a.1 / length))
}

/// The samples of a segment; none if it has no length. From one to the next a curve turns by so little, or is so short, that what is in
/// between is as good as straight.
fn samples(points: &[Place], half: f64) -> Vec<Sample> {
    let n = points.len() - 1;
    if points.iter().all(|&p| p == points[0]) {
        return vec![];
    }
    // At an end where the first derivative is 0, the direction to the next control point that is elsewhere.
    let first = points.iter().find_map(|&p| unit(sub(p, points[0])));
    let last = points.iter().rev().find_map(|&p| unit(sub(points[n], p)));
    let (Some(first), Some(last)) = (first, last) else { return vec![] };
    let mut all = vec![Sample { time: 0.0, at: points[0], way: first }];
    if n > 1 {
        halve(points, Sample { time: 1.0, at: points[n], way: last }, (half, 0), &mut all);
    } else {
        all.push(Sample { time: 1.0, at: points[n], way: last });
    }
    all
}

fn slope(points: &[Place], time: f64) -> Place {
    bezier(points.windows(2).map(|p| sub(p[1], p[0])).collect(), time)
}

/// At a time; none where a curve stands still.
fn sample(points: &[Place], time: f64) -> Option<Sample> {
    Some(Sample { time, at: bezier(points.to_vec(), time), way: unit(slope(points, time))? })
}

fn angle(u: Place, v: Place) -> f64 {
    cross(u, v).atan2(dot(u, v)).abs()
}

/// From the last sample to this one.
fn halve(points: &[Place], end: Sample, (half, depth): (f64, u32), all: &mut Vec<Sample>) {
    let start = all[all.len() - 1];
    let middle = f64::midpoint(start.time, end.time);
    // The slope is a curve of the second degree, which turns by no more than its control points do.
    let [a, m, b] = [start.time, middle, end.time].map(|time| slope(points, time));
    let bend = unit((2.0 * m.0 - f64::midpoint(a.0, b.0), 2.0 * m.1 - f64::midpoint(a.1, b.1)));
    let turns = bend.map_or([7.0; 2], |bend| [angle(start.way, bend), angle(bend, end.way)]);
    let turn = turns[0] + turns[1];
    // There and back again: none of both ends tells how far it turns.
    let back = bend.filter(|&bend| cross(start.way, bend) * cross(bend, end.way) < 0.0);
    let is_uneven = back.is_some() && turns[0].min(turns[1]) * half > 2.0;
    let far = sub(end.at, start.at);
    if depth < DEPTH && (is_uneven || turn > 0.05 || turn * far.0.hypot(far.1) > 2.0) {
        if let Some(middle) = sample(points, middle).or_else(|| sample(points, middle + (middle - start.time) / 8.0)) {
            halve(points, middle, (half, depth + 1), all);
            return halve(points, end, (half, depth + 1), all);
        }
    }
    all.push(end);
}

/// The dashes of a contour, and whether one is all of a ring.
fn dashes(runs: &[Vec<Sample>], closed: bool, lengths: &[f64], phase: f64) -> Vec<(Vec<Vec<Sample>>, bool)> {
    let (mut index, mut left) = (0, lengths[0] - phase.rem_euclid(lengths.iter().sum()));
    while left <= 0.0 {
        index = (index + 1) % lengths.len();
        left += lengths[index];
    }
    let starts_on = index % 2 == 0;
    let (mut all, mut dash): (Vec<Vec<Vec<Sample>>>, Vec<Vec<Sample>>) = (vec![], vec![]);
    for run in runs {
        if index % 2 == 0 {
            dash.push(vec![run[0]]);
        }
        for pair in run.windows(2) {
            let chord = sub(pair[1].at, pair[0].at);
            // As long as the curve.
            let length = chord.0.hypot(chord.1) * (1.0 + angle(pair[0].way, pair[1].way).powi(2).min(1.0) / 24.0);
            let mut done = 0.0;
            while length - done >= left {
                done += left;
                let mix = |a: f64, b: f64| a + (b - a) * done / length.max(1e-12);
                let mixed = |a: Place, b: Place| (mix(a.0, b.0), mix(a.1, b.1));
                let way = unit(mixed(pair[0].way, pair[1].way)).unwrap_or(pair[0].way);
                let cut = Sample { time: mix(pair[0].time, pair[1].time), at: mixed(pair[0].at, pair[1].at), way };
                if index % 2 == 0 {
                    dash.last_mut().expect("a run").push(cut);
                    all.push(std::mem::take(&mut dash));
                } else {
                    dash = vec![vec![cut]];
                }
                index = (index + 1) % lengths.len();
                left = lengths[index];
            }
            left -= length - done;
            if index % 2 == 0 {
                dash.last_mut().expect("a run").push(pair[1]);
            }
        }
    }
    let goes_on = closed && starts_on && !dash.is_empty();
    if goes_on && all.is_empty() {
        return vec![(dash, true)];
    }
    if goes_on {
        dash.append(&mut all[0]);
        all[0] = dash;
    } else if !dash.is_empty() {
        all.push(dash);
    }
    all.into_iter().map(|dash| (dash, false)).collect()
}

impl Model {
    /// The stroke of a path by a pen. All lengths are in units.
    pub fn new(pieces: &[Piece], pen: Pen) -> Self {
        Self::dashed(pieces, pen, &[], 0.0)
    }

    /// The same with gaps: lengths on and off, all above 0, and how far into them each contour starts; none for a solid one.
    pub fn dashed(pieces: &[Piece], pen: Pen, lengths: &[f64], phase: f64) -> Self {
        let half = f64::from(pen.width) / 2.0;
        let mut model = Self { pen, half, runs: vec![], corners: vec![], ends: vec![], dots: vec![] };
        let float = |p: (i32, i32)| (f64::from(p.0), f64::from(p.1));
        let (mut start, mut contour) = ((0.0, 0.0), None::<(Place, Vec<Vec<Sample>>)>);
        for piece in pieces.iter().chain([&Piece::Move((0, 0))]) {
            let at = contour.as_ref().map_or(start, |(at, _)| *at);
            let points = match *piece {
                Piece::Move(a) => {
                    model.add(contour.take(), start, false, (lengths, phase));
                    start = float(a);
                    continue;
                }
                Piece::Close => {
                    let (_, mut runs) = contour.take().unwrap_or((at, vec![]));
                    runs.push(samples(&[at, start], half));
                    model.add(Some((start, runs)), start, true, (lengths, phase));
                    continue;
                }
                Piece::Line(a) => vec![at, float(a)],
                Piece::Quadratic(a, b) => vec![at, float(a), float(b)],
                Piece::Cubic(a, b, c) => vec![at, float(a), float(b), float(c)],
            };
            let (to, runs) = contour.get_or_insert_with(|| (at, vec![]));
            runs.push(samples(&points, half));
            *to = points[points.len() - 1];
        }
        model
    }

    fn add(
        &mut self,
        contour: Option<(Place, Vec<Vec<Sample>>)>,
        start: Place,
        closed: bool,
        (lengths, phase): (&[f64], f64),
    ) {
        let Some((_, mut runs)) = contour else { return };
        runs.retain(|run| !run.is_empty());
        if runs.is_empty() {
            self.dots.push(start);
        } else if lengths.is_empty() {
            self.line(runs, closed);
        } else {
            for (dash, closed) in dashes(&runs, closed, lengths, phase) {
                self.line(dash, closed);
            }
        }
    }

    /// A contour, or a dash of it.
    fn line(&mut self, runs: Vec<Vec<Sample>>, closed: bool) {
        let (first, last) = (runs[0][0], runs[runs.len() - 1][runs[runs.len() - 1].len() - 1]);
        for pair in runs.windows(2) {
            self.corners.push((pair[1][0].at, pair[0][pair[0].len() - 1].way, pair[1][0].way));
        }
        if closed {
            self.corners.push((first.at, last.way, first.way));
        } else {
            self.ends.extend([Sample { way: (-first.way.0, -first.way.1), ..first }, last]);
        }
        self.runs.extend(runs);
    }

    /// Without what is farther than this from a place.
    pub fn keep_near(&mut self, at: Place, far: f64) {
        let near = |p: Place| (p.0 - at.0).hypot(p.1 - at.1) < far;
        self.runs.retain(|run| run.iter().any(|sample| near(sample.at)));
        self.corners.retain(|corner| near(corner.0));
        self.ends.retain(|end| near(end.at));
        self.dots.retain(|&dot| near(dot));
    }

    /// Whether a place lies in the stroke.
    pub fn contains(&self, p: Place) -> bool {
        self.runs.iter().any(|run| self.is_beside(run, p))
            || self.corners.iter().any(|&(at, before, after)| self.is_in_join(sub(p, at), before, after))
            || self.ends.iter().any(|end| self.is_in_cap(sub(p, end.at), end.way))
            || self.dots.iter().any(|&at| match self.pen.cap {
                Cap::Butt => false,
                Cap::Square => (p.0 - at.0).abs() <= self.half && (p.1 - at.1).abs() <= self.half,
                Cap::Round => (p.0 - at.0).hypot(p.1 - at.1) <= self.half,
            })
    }

    /// Whether it is within half a width of a segment, at a right angle to it.
    fn is_beside(&self, run: &[Sample], p: Place) -> bool {
        run.windows(2).any(|s| {
            let along = [0, 1].map(|i| dot(sub(p, s[i].at), s[i].way));
            if along[0] * along[1] > 0.0 {
                return false;
            }
            // Where in between it is at a right angle.
            let length = along[0] - along[1];
            let t = if length.abs() > 0.0 { along[0] / length } else { 0.0 };
            let at = (s[0].at.0 + t * (s[1].at.0 - s[0].at.0), s[0].at.1 + t * (s[1].at.1 - s[0].at.1));
            (p.0 - at.0).hypot(p.1 - at.1) <= self.half
        })
    }

    fn is_in_cap(&self, p: Place, way: Place) -> bool {
        let (along, across) = (dot(p, way), cross(p, way).abs());
        match self.pen.cap {
            Cap::Butt => false,
            Cap::Square => (0.0..=self.half).contains(&along) && across <= self.half,
            Cap::Round => along >= 0.0 && p.0.hypot(p.1) <= self.half,
        }
    }

    fn is_in_join(&self, p: Place, before: Place, after: Place) -> bool {
        // Seen from the corner: ahead of the end of the one side, behind the start of the other, is on its outer side.
        let outer = if cross(before, after) > 0.0 { -1.0 } else { 1.0 };
        let normal = |way: Place| (-way.1 * outer, way.0 * outer);
        let (m, n) = (normal(before), normal(after));
        let angle = cross(m, n);
        if angle.abs() < 1e-12 && dot(before, after) > 0.0 {
            return false;
        }
        let (a, b) = if angle.abs() < 1e-12 {
            (dot(p, before), -dot(p, after))
        } else {
            (cross(p, n) / angle, cross(m, p) / angle)
        };
        if a < 0.0 || b < 0.0 {
            return false;
        }
        let is_round = p.0.hypot(p.1) <= self.half;
        // Of a way back there is no bevel.
        let is_bevel = angle.abs() >= 1e-12 && a + b <= self.half;
        match self.pen.join {
            Join::Round => is_round,
            Join::Bevel => is_bevel,
            Join::Miter => {
                let limit = f64::from(self.pen.limit) / 256.0;
                if limit * limit * (1.0 + dot(before, after)) >= 2.0 {
                    dot(p, m) <= self.half && dot(p, n) <= self.half
                } else {
                    is_bevel
                }
            }
        }
    }

    /// Whether the miter limit decides about a join by a hair.
    pub fn is_near_limit(&self) -> bool {
        let limit = f64::from(self.pen.limit) / 256.0;
        self.pen.join == Join::Miter
            && self.corners.iter().any(|c| (limit * limit * (1.0 + dot(c.1, c.2)) / 2.0 - 1.0).abs() < 0.02)
    }

    /// Whether some place not farther than this from p is in the stroke, or out of it, as asked.
    pub fn has_near(&self, p: Place, reach: f64, inside: bool) -> bool {
        (1..=4).any(|ring| {
            (0..48).any(|i| {
                let (angle, far) = (f64::from(i) / 48.0 * core::f64::consts::TAU, reach * f64::from(ring) / 4.0);
                self.contains((p.0 + far * angle.cos(), p.1 + far * angle.sin())) == inside
            })
        })
    }
}
