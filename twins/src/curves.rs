//! Paths and their flattening, word for word, in integers of 128 bits.

use embedded_raster::{PathSegment, PointFx};

use super::{rng::Rng, scenes::outline, scenes::Scale, Units};

/// A segment in plain units.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Piece {
    /// Starts a contour.
    Move(Units),
    /// To a place.
    Line(Units),
    /// By a control point.
    Quadratic(Units, Units),
    /// By two control points.
    Cubic(Units, Units, Units),
    /// Back to the start of the contour.
    Close,
}

/// The same path as the crate takes it.
pub fn segments(pieces: &[Piece]) -> Vec<PathSegment> {
    let v = |p: Units| PointFx::from_bits(p.0, p.1);
    let segment = |piece: &Piece| match *piece {
        Piece::Move(a) => PathSegment::MoveTo(v(a)),
        Piece::Line(a) => PathSegment::LineTo(v(a)),
        Piece::Quadratic(a, b) => PathSegment::QuadraticTo(v(a), v(b)),
        Piece::Cubic(a, b, c) => PathSegment::CubicTo(v(a), v(b), v(c)),
        Piece::Close => PathSegment::Close,
    };
    pieces.iter().map(segment).collect()
}

/// A contour as vertices, each with whether the path is smooth there.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Outline {
    /// The vertices.
    pub places: Vec<Units>,
    /// Whether the path is smooth at each.
    pub smooth: Vec<bool>,
    /// Whether the last is joined to the first.
    pub closed: bool,
    /// For each vertex the part of a curve that ends there, if it is of interest.
    pub parts: Vec<Option<Part>>,
}

/// A part of a curve, between two times.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// The control points of the curve.
    pub points: Vec<Units>,
    /// When it begins, in units of 2^-20.
    pub from: i128,
    /// When it ends.
    pub to: i128,
}

impl Part {
    /// Its derivative at a time, in units of 2^-24, rounded towards zero.
    fn slope(&self, time: i128) -> (i128, i128) {
        let slope = |[a, b, c]: [i128; 3]| (3 * a * time * time + 2 * b * time * END + c * END * END) / (1 << 16);
        (slope(self.powers(|p| p.0)), slope(self.powers(|p| p.1)))
    }

    /// Which way it goes from a time on, for so long, is a curve of the second degree: its middle control point, as a way.
    pub fn bend_of_way(&self, from: i128, length: i128) -> (i128, i128) {
        let [a, m, b] = [0, length / 2, length].map(|time| self.slope(from + time));
        (4 * m.0 - a.0 - b.0, 4 * m.1 - a.1 - b.1)
    }

    /// Which way the curve goes at a time: its derivative; or the first that is not 0 of the
    /// second one, which before that time counts backwards, and the third.
    pub fn way(&self, time: i128, before: bool) -> (i128, i128) {
        let ([a, b, _], [d, e, _]) = (self.powers(|p| p.0), self.powers(|p| p.1));
        let bend = |a: i128, b: i128| if before { -3 * a * time - b * END } else { 3 * a * time + b * END };
        let ways = [self.slope(time), (bend(a, b), bend(d, e)), (a, d)];
        ways.into_iter().find(|&way| way != (0, 0)).unwrap_or((0, 0))
    }

    /// Which way it goes beside a place, as seen along a vector of 30 bits.
    pub fn way_beside(&self, place: Units, along: (i128, i128)) -> (i128, i128) {
        let (mut from, mut to) = (self.from, self.to);
        for _ in 0..12 {
            let middle = i128::midpoint(from, to);
            let at = point(&self.points, middle);
            let product = |n: i32, m: i32, u: i128| (i128::from(n) - i128::from(m)) * u.div_euclid(4);
            if product(at.0, place.0, along.0) + product(at.1, place.1, along.1) < 0 {
                from = middle;
            } else {
                to = middle;
            }
        }
        self.way(to, true)
    }

    /// When it has gone so far, in 2^-20 pixel.
    pub fn time_at(&self, mut s: i128) -> i128 {
        let (mut from, mut to) = (self.from, self.to);
        while to - from > 1 {
            let middle = i128::midpoint(from, to);
            let length = Self { points: self.points.clone(), from, to: middle }.length();
            if s <= length {
                to = middle;
            } else {
                (from, s) = (middle, s - length);
            }
        }
        from
    }

    /// The point at a time.
    pub fn point(&self, time: i128) -> Units {
        point(&self.points, time)
    }

    /// How long it is, in 2^-20 pixel: where it is short and turns back, before that and after it.
    pub fn length(&self) -> i128 {
        let (whole, start) = (self.even_length(), self.slope(self.from));
        let is_back = |time: i128| {
            let end = self.slope(time);
            let mut ways = [start.0, start.1, end.0, end.1];
            while ways.iter().any(|n| n.abs() >= 1 << 31) {
                ways = ways.map(|n| n >> 1);
            }
            ways[0] * ways[2] + ways[1] * ways[3] < 0
        };
        if whole >= 32 << 12 || !is_back(self.to) {
            return whole;
        }
        let (mut before, mut after) = (self.from, self.to);
        while after - before > 1 {
            let middle = i128::midpoint(before, after);
            if is_back(middle) {
                after = middle;
            } else {
                before = middle;
            }
        }
        let part = |from: i128, to: i128| Self { points: self.points.clone(), from, to }.even_length();
        part(self.from, before) + part(before, self.to)
    }

    /// The same by its speed at the three times of Gauss's rule.
    fn even_length(&self) -> i128 {
        let h = self.to - self.from;
        // The root of 3/5, in units of 2^-32.
        let off = (h * 3_326_808_142) >> 32;
        let [a, b, c] = [h - off, h, h + off].map(|twice| {
            let slope = self.slope(self.from + twice / 2);
            let longer = slope.0.abs().max(slope.1.abs());
            if longer == 0 {
                return 0;
            }
            // To 31 bits, and how many leading zeros of 64 there were.
            let zeros = longer.ilog2();
            let scaled = |n: i128| if zeros > 30 { n.abs() >> (zeros - 30) } else { n.abs() << (30 - zeros) };
            let length = (scaled(slope.0).pow(2) + scaled(slope.1).pow(2)).isqrt();
            (((length * h) >> (63 - zeros - 2)) + 1) >> 1
        });
        // 2^32 / 18.
        ((5 * (a + c) + 8 * b + 9) * 238_609_294) >> 32
    }

    /// One coordinate as `((a t + b) t + c) t + d`, without d.
    fn powers(&self, coordinate: fn(&Units) -> i32) -> [i128; 3] {
        let p: Vec<i128> = self.points.iter().map(|p| i128::from(coordinate(p))).collect();
        match p[..] {
            [p, q, r] => [0, p - 2 * q + r, 2 * (q - p)],
            [p, q, r, s] => [s - 3 * r + 3 * q - p, 3 * (p - 2 * q + r), 3 * (q - p)],
            _ => panic!("{p:?}"),
        }
    }
}

/// Strokes up to this width are thin: their sides are straight, but for the ends of curves.
pub const THIN: i32 = 320;

/// The contours of a path, curves flattened.
pub fn outlines(pieces: &[Piece]) -> Vec<Outline> {
    outlines_for(pieces, 0)
}

/// The same for a stroke of this width.
pub fn outlines_for(pieces: &[Piece], width: i32) -> Vec<Outline> {
    let mut all = vec![];
    let mut start = (0, 0);
    let mut open: Option<Outline> = None;
    for piece in pieces {
        if let Piece::Move(to) = piece {
            all.extend(open.take());
            start = *to;
            continue;
        }
        let outline = open.get_or_insert_with(|| Outline {
            places: vec![start],
            smooth: vec![false],
            closed: false,
            parts: vec![None],
        });
        let from = *outline.places.last().expect("it has a start");
        let points = match *piece {
            Piece::Line(a) => vec![from, a],
            Piece::Quadratic(a, b) => vec![from, a, b],
            Piece::Cubic(a, b, c) => vec![from, a, b, c],
            Piece::Close | Piece::Move(_) => {
                outline.closed = true;
                all.extend(open.take());
                continue;
            }
        };
        let places = if points.len() == 2 {
            outline.parts.push(None);
            vec![points[1]]
        } else {
            let times = times_for(&points, width);
            let starts = [0].iter().chain(&times);
            let part = |(&from, &to): (&i128, &i128)| Part { points: points.clone(), from, to };
            outline.parts.extend(starts.zip(&times).map(|ends| (width != 0).then(|| part(ends))));
            times.into_iter().map(|t| point(&points, t)).collect()
        };
        let last = places.len() - 1;
        outline.smooth.extend((0..places.len()).map(|i| i != last));
        outline.places.extend(places);
    }
    all.extend(open);
    all
}

/// The whole time of a curve.
pub const END: i128 = 1 << 20;

/// The times, in units of 2^-20, at which the pieces of a curve end.
pub fn times(points: &[Units]) -> Vec<i128> {
    times_for(points, 0)
}

/// The same for a stroke of this width, unless it is 0.
pub fn times_for(points: &[Units], width: i32) -> Vec<i128> {
    let mut all = vec![];
    halve(points, (0, END), width, &mut all);
    all
}

fn halve(points: &[Units], (from, to): (i128, i128), width: i32, all: &mut Vec<i128>) {
    let pieces =
        if width == 0 { parts(points, from, to) } else { is_flat_beside(points, (from, to), width).then_some(1) };
    match pieces {
        None => {
            let middle = from + (to - from) / 2;
            halve(points, (from, middle), width, all);
            halve(points, (middle, to), width, all);
        }
        // To the nearest; there is no half.
        Some(m) => all.extend((1..=m).map(|i| from + (2 * i * (to - from) + m) / (2 * m))),
    }
}

/// `h^2 P''/2` at one and two thirds of a part of a curve, rounded down.
fn bends(points: &[Units], from: i128, to: i128) -> [(i128, i128); 2] {
    let length = to - from;
    // Of h^2 P''/2, at a time in units of 2^-20 / 3.
    let bend = |time: i128, coordinate: fn(&Units) -> i32| {
        let p: Vec<i128> = points.iter().map(|p| i128::from(coordinate(p))).collect();
        let second = |i: usize| p[i] - 2 * p[i + 1] + p[i + 2];
        // P'' is 2 times the second difference of a quadratic curve; of a cubic one 6 times what lies between its two.
        let half =
            if p.len() == 3 { 3 * END * second(0) } else { 3 * ((3 * END - time) * second(0) + time * second(1)) };
        (half * length * length).div_euclid(3 * END * END * END)
    };
    [3 * from + length, 3 * from + 2 * length].map(|time| (bend(time, |p| p.0), bend(time, |p| p.1)))
}

/// Whether the coordinates of a bend fit 16 bits.
fn is_small(w: &(i128, i128)) -> bool {
    [w.0, w.1].iter().all(|n| (-(1 << 15)..1 << 15).contains(n))
}

/// The chord of a part, halved until it fits 15 bits and a sign, and its factor.
fn chord(points: &[Units], from: i128, to: i128) -> ((i128, i128), i128) {
    let (a, b) = (point(points, from), point(points, to));
    let mut chord = (i128::from(b.0) - i128::from(a.0), i128::from(b.1) - i128::from(a.1));
    let mut scale = 1;
    while chord.0.abs().max(chord.1.abs()) >= 1 << 15 {
        (chord, scale) = ((chord.0 / 2, chord.1 / 2), 2 * scale);
    }
    (chord, scale)
}

/// Whether a part of a curve is flat, and the borders of a stroke beside it.
fn is_flat_beside(points: &[Units], (from, to): (i128, i128), width: i32) -> bool {
    let [u, v] = bends(points, from, to);
    if !is_small(&u) || !is_small(&v) {
        return false;
    }
    let (c, scale) = chord(points, from, to);
    let (square, longer) = (c.0 * c.0 + c.1 * c.1, c.0.abs().max(c.1.abs()));
    if [u, v].iter().all(|w| w.0 * w.0 + w.1 * w.1 <= 64) {
        return true;
    }
    let along = |w: (i128, i128)| w.0 * c.0 + w.1 * c.1;
    let across = |w: (i128, i128)| (w.0 * c.1 - w.1 * c.0).abs();
    if square == 0 || [u, v].iter().any(|&w| along(w).abs() / scale > square) {
        return false;
    }
    // The ways at the ends, as seen along the chord.
    let speeds = [square - along(u).div_euclid(scale), square + along(v).div_euclid(scale)];
    let mut angles = vec![];
    for (speed, w) in speeds.into_iter().zip([u, v]) {
        let across = (across(w) + c.0.abs() + c.1.abs()) * 4096 / scale;
        if speed <= 0 || across >= speed * 4096 {
            return false;
        }
        angles.push(across / speed);
    }
    let (wide, most) = (i128::from(width), angles[0].max(angles[1]));
    let is_slow = speeds.iter().any(|speed| speed * 4 < square * 3);
    let is_sharp = wide * (angles[0] + angles[1]) / 8192 / scale >= longer;
    if (is_slow || is_sharp) && wide * (angles[0] - angles[1]).abs() > 64 * 4096 {
        return false;
    }
    let rest = 128 - most * most * wide / if width <= THIN { 1 << 20 } else { 1 << 24 };
    rest >= 32 && [u, v].iter().all(|&w| across(w).pow(2) <= rest.pow(2) * square)
}

/// How many pieces of equal time a part of a curve is cut into, as `geom::flatten` tells; `None` if it is halved instead.
fn parts(points: &[Units], from: i128, to: i128) -> Option<i128> {
    let [u, v] = bends(points, from, to);
    if !is_small(&u) || !is_small(&v) {
        return None;
    }
    let (chord, scale) = chord(points, from, to);
    let square = chord.0 * chord.0 + chord.1 * chord.1;
    let four_d = 4 * 32;
    let cross = |w: (i128, i128)| w.0 * chord.1 - w.1 * chord.0;
    let flat = [u, v].iter().all(|&w| {
        if square >= four_d * four_d {
            let along = w.0 * chord.0 + w.1 * chord.1;
            (cross(w).abs() / four_d).pow(2) <= square && along.abs() / scale <= square
        } else {
            w.0 * w.0 + w.1 * w.1 <= four_d * four_d
        }
    });
    if flat {
        return Some(1);
    }
    let ends = [(2 * u.0 - v.0, 2 * u.1 - v.1), (2 * v.0 - u.0, 2 * v.1 - u.1)];
    let longer = ends.map(|w| w.0 * w.0 + w.1 * w.1).into_iter().max()?;
    if !ends.iter().all(is_small) {
        return None;
    }
    let m = (1..=16).find(|m| (four_d * m * m).pow(2) >= longer)?;
    // (4 |W x c|)^2 against the other one.
    let across = |w: (i128, i128)| (cross(w).pow(2) > (longer * square) / 16).then_some(cross(w) < 0);
    let even = across(ends[0]).is_some() && across(ends[0]) == across(ends[1]);
    (m == 2 || even).then_some(m)
}

/// The vertices of a curve after the first: the point at the end of each piece, rounded to nearest, halves upwards.
pub fn flattened(points: &[Units]) -> Vec<Units> {
    times(points).into_iter().map(|t| point(points, t)).collect()
}

/// The point of a curve at `t / 2^20`, by Bernstein's polynomials.
fn point(points: &[Units], t: i128) -> Units {
    let s = (1 << 20) - t;
    let weights = match points.len() {
        3 => vec![s * s, 2 * s * t, t * t],
        _ => vec![s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t],
    };
    let one = weights.iter().sum::<i128>();
    let sum = |coordinate: fn(&Units) -> i32| {
        let sum: i128 = points.iter().zip(&weights).map(|(p, w)| i128::from(coordinate(p)) * w).sum();
        (2 * sum + one).div_euclid(2 * one) as i32
    };
    (sum(|p| p.0), sum(|p| p.1))
}

/// A point of a curve in `f64`.
pub fn true_point(points: &[Units], t: f64) -> (f64, f64) {
    bezier(points.iter().map(|p| (f64::from(p.0), f64::from(p.1))).collect(), t)
}

/// A point of a curve in any units, by de Casteljau's construction.
pub fn bezier(mut p: Vec<(f64, f64)>, t: f64) -> (f64, f64) {
    while p.len() > 1 {
        p = p.windows(2).map(|w| (w[0].0 + (w[1].0 - w[0].0) * t, w[0].1 + (w[1].1 - w[0].1) * t)).collect();
    }
    p[0]
}

/// How far a place is from the line between two others.
#[inline]
pub fn distance(p: (f64, f64), a: (f64, f64), b: (f64, f64)) -> f64 {
    let (dx, dy, px, py) = (b.0 - a.0, b.1 - a.1, p.0 - a.0, p.1 - a.1);
    let square = dx * dx + dy * dy;
    let t = if square == 0.0 { 0.0 } else { ((px * dx + py * dy) / square).clamp(0.0, 1.0) };
    (px - t * dx).hypot(py - t * dy)
}

/// A path of a few pieces, with a liking for trouble: points that coincide, moves and closes at odd places.
pub fn random_path(rng: &mut Rng, scale: Scale, most: usize) -> Vec<Piece> {
    let n = 1 + rng.index(most);
    let places = outline(rng, scale, 3 * n + 1);
    let mut pieces = if rng.one_in(12) { vec![] } else { vec![Piece::Move(places[0])] };
    for p in places[1..].chunks(3) {
        match rng.below(14) {
            0 => pieces.push(Piece::Move(p[0])),
            1 => pieces.push(Piece::Close),
            2 | 3 => pieces.push(Piece::Line(p[0])),
            4 => pieces.extend([Piece::Line(p[0]), Piece::Cubic(p[0], p[1], p[1])]),
            5..=8 => pieces.push(Piece::Quadratic(p[0], p[1])),
            _ => pieces.push(Piece::Cubic(p[0], p[1], p[2])),
        }
    }
    if rng.one_in(3) {
        pieces.push(Piece::Close);
    }
    pieces
}

/// Some place that a path names.
pub fn places(pieces: &[Piece]) -> Vec<Units> {
    let mut all = vec![];
    for piece in pieces {
        match *piece {
            Piece::Move(a) | Piece::Line(a) => all.push(a),
            Piece::Quadratic(a, b) => all.extend([a, b]),
            Piece::Cubic(a, b, c) => all.extend([a, b, c]),
            Piece::Close => {}
        }
    }
    all
}
