//! Strokes by the rule: every piece as a contour, in integers of 128 bits.

use embedded_raster::{Cap, Join};

use super::{
    curves::{Outline, Part, END, THIN},
    Units,
};

/// A stroke in plain numbers.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Pen {
    /// In 24.8 units.
    pub width: i32,
    /// At open ends.
    pub cap: Cap,
    /// At corners.
    pub join: Join,
    /// Of mitres, in 24.8.
    pub limit: i32,
}

/// Units of 2^-30.
type Unit = (i128, i128);

const ONE: i128 = 1 << 30;

fn div_up(n: i128, d: i128) -> i128 {
    -(-n).div_euclid(d)
}

/// From one place to another.
fn between(a: Units, b: Units) -> (i128, i128) {
    (i128::from(b.0) - i128::from(a.0), i128::from(b.1) - i128::from(a.1))
}

/// A scaled vector and its length.
fn scaled((mut x, mut y): (i128, i128)) -> (i128, i128, i128) {
    while x.abs().max(y.abs()) < ONE {
        (x, y) = (2 * x, 2 * y);
    }
    while x.abs().max(y.abs()) >= 2 * ONE {
        (x, y) = (x / 2, y / 2);
    }
    (x, y, (x * x + y * y).isqrt())
}

/// The direction of a side, its components rounded away from zero.
pub fn direction(a: Units, b: Units) -> Unit {
    direction_of(between(a, b))
}

/// The direction of a vector.
fn direction_of(vector: (i128, i128)) -> Unit {
    let (x, y, length) = scaled(vector);
    let share = |n: i128| n.signum() * div_up(n.abs() * ONE, length);
    (share(x), share(y))
}

/// The length of a side in 2^-20 pixel.
pub fn length(a: Units, b: Units) -> i128 {
    let d = between(a, b);
    let (x, y, length) = scaled(d);
    // By how much it was scaled: exact, but where a bit was lost.
    let (scaled, plain) = if x.abs() >= y.abs() { (x.abs(), d.0.abs()) } else { (y.abs(), d.1.abs()) };
    if plain > scaled {
        2 * (length << 12)
    } else {
        (length << 12) / (scaled / plain)
    }
}

/// To the right, as the screen shows it.
fn right(u: Unit) -> Unit {
    (-u.1, u.0)
}

fn back(u: Unit) -> Unit {
    (-u.0, -u.1)
}

fn cross(u: Unit, v: Unit) -> i128 {
    u.0 * v.1 - u.1 * v.0
}

fn dot(u: Unit, v: Unit) -> i128 {
    u.0 * v.0 + u.1 * v.1
}

impl Pen {
    /// Half a width this way, away from zero.
    fn half(&self, u: Unit) -> Unit {
        let half = |n: i128| n.signum() * div_up(i128::from(self.width) * n.abs(), 2 * ONE);
        (half(u.0), half(u.1))
    }

    /// Cosine and sine of the turn of fans.
    fn turn(&self) -> Unit {
        let j = (3..11).find(|j| 3 << (2 * j) >= i64::from(self.width)).unwrap_or(11);
        let angle = core::f64::consts::TAU / f64::from(1 << j);
        ((angle.cos() * ONE as f64).round() as i128, (angle.sin() * ONE as f64).round() as i128)
    }

    fn at(v: Units, offsets: &[Unit]) -> Vec<Units> {
        let clamp = |n: i128| n.clamp(i32::MIN.into(), i32::MAX.into()) as i32;
        offsets.iter().map(|o| (clamp(i128::from(v.0) + o.0), clamp(i128::from(v.1) + o.1))).collect()
    }

    /// From one offset to another, turning left.
    fn wedge(&self, v: Units, from: Unit, to: Unit, join: Join) -> Vec<Units> {
        let mut offsets = vec![(0, 0), self.half(from)];
        match join {
            Join::Round => {
                let (c, s) = self.turn();
                let mut o = from;
                loop {
                    let rounded = |n: i128| (2 * n + ONE).div_euclid(2 * ONE);
                    o = (rounded(o.0 * c + o.1 * s), rounded(o.1 * c - o.0 * s));
                    if cross(o, to) >= 0 {
                        break;
                    }
                    offsets.push(self.half(o));
                }
            }
            Join::Miter => {
                let c = ONE + dot(from, to).div_euclid(ONE);
                let limit = i128::from(self.limit) * i128::from(self.limit);
                if c > 0 && limit * c >= (2 * ONE) << 16 {
                    // w (p + q) / 2c, rounded to nearest.
                    let reach = |sum: i128| sum.signum() * (i128::from(self.width) * sum.abs() + c).div_euclid(2 * c);
                    offsets.push((reach(from.0 + to.0), reach(from.1 + to.1)));
                }
            }
            Join::Bevel => {}
        }
        offsets.push(self.half(to));
        Self::at(v, &offsets)
    }

    /// The cap of an end in a direction.
    pub fn cap(&self, v: Units, u: Unit) -> Option<Vec<Units>> {
        let (r, l) = (right(u), back(right(u)));
        match self.cap {
            Cap::Butt => None,
            Cap::Round => Some(self.wedge(v, r, l, Join::Round)),
            Cap::Square => {
                let (right, left, ahead) = (self.half(r), self.half(l), self.half(u));
                let sum = |o: Unit| (o.0 + ahead.0, o.1 + ahead.1);
                Some(Self::at(v, &[(0, 0), right, sum(right), sum(left), left]))
            }
        }
    }

    /// What fills the gap between two sides, if there is one. `turns`: with what the pen sweeps over on the inner side.
    pub fn join(&self, v: Units, last: Unit, next: Unit, turns: bool) -> Vec<Vec<Units>> {
        let turn = cross(last, next);
        if turn == 0 && dot(last, next) > 0 {
            return vec![];
        }
        let join = if turns { Join::Round } else { self.join };
        let (from, to) = if turn > 0 { (back(right(next)), back(right(last))) } else { (right(last), right(next)) };
        let mut parts = vec![self.wedge(v, from, to, join)];
        if turns {
            parts.push(self.wedge(v, back(from), back(to), join));
        }
        parts
    }

    /// A side, as wide as the pen, which goes these ways at its ends.
    pub fn side(&self, a: Units, b: Units, [u, v]: [Unit; 2]) -> Vec<Vec<Units>> {
        if a == b {
            return self.join(a, u, v, true);
        }
        if self.width <= THIN && u != v {
            let chord = direction(a, b);
            return [self.join(a, u, chord, true), self.side(a, b, [chord; 2]), self.join(b, chord, v, true)].concat();
        }
        let (r, s) = (self.half(right(u)), self.half(right(v)));
        let [right, left] = [r, back(r)].map(|o| Self::at(a, &[o])[0]);
        let [right_end, left_end] = [s, back(s)].map(|o| Self::at(b, &[o])[0]);
        let mut parts = vec![vec![a, right, right_end, b, left_end, left]];
        // Where both ends cross, what lies behind is turned over: once back, twice more.
        let chord = between(a, b);
        let (along, behind, turn) = (cross(chord, s), cross(chord, r), cross(r, s));
        if is_tiny(a, b, self.width) && along < 0 && behind < 0 {
            // It goes backwards as a whole.
            let back = vec![right, left, left_end, right_end];
            parts.extend([back.clone(), back]);
            return parts;
        }
        if along.abs() < turn.abs() && behind.abs() < turn.abs() && (along < 0) == (behind < 0) {
            let is_right = (along < 0) == (turn < 0);
            let mut scale = 1;
            while turn.abs() / scale >= 1 << 31 {
                scale *= 2;
            }
            let before = |share: i128, v: Units, o: Unit| {
                let share = (share.abs() - 2 * i128::from(self.width)).max(0);
                let share = ((share / scale) << 31) / (turn.abs() / scale);
                let o = if is_right { o } else { back(o) };
                Self::at(v, &[((share * o.0) >> 31, (share * o.1) >> 31)])[0]
            };
            let (p, q) = (before(along, a, r), before(behind, b, s));
            let middle = |p: i32, q: i32| ((i64::from(p) + i64::from(q)) >> 1) as i32;
            let apex = (middle(p.0, q.0), middle(p.1, q.1));
            let (from, to) = if is_right { (right_end, right) } else { (left, left_end) };
            parts.extend([vec![apex, from, to], vec![apex, from, to]]);
        }
        parts
    }

    /// The pieces of contours.
    pub fn parts(&self, outlines: &[Outline]) -> Vec<Vec<Units>> {
        outlines.iter().flat_map(|outline| self.contour(outline)).collect()
    }

    fn contour(&self, outline: &Outline) -> Vec<Vec<Units>> {
        let Some(&start) = outline.places.first() else { return vec![] };
        let sides = sides(outline, self.width);
        if sides.is_empty() {
            return match self.cap {
                Cap::Round => self.disc(start),
                _ => [(ONE, 0), (-ONE, 0)].into_iter().filter_map(|u| self.cap(start, u)).collect(),
            };
        }
        let ends = if outline.closed { Ends::Joined } else { Ends::Capped };
        let sides: Vec<Side> = sides.iter().flat_map(|side| side.turned(self.width)).collect();
        self.run(&sides, ends)
    }

    /// A circle: on each row of pixels, whose centre is not farther away than half a width, what lies between both crossings.
    fn disc(&self, (x, y): Units) -> Vec<Vec<Units>> {
        let (x, y, width) = (i128::from(x), i128::from(y), i128::from(self.width));
        let (first, end) = ((y - width / 2).div_euclid(256) - 1, (y + width / 2).div_euclid(256) + 2);
        let closed = x % 128 == 0 && y % 128 == 0;
        let mut rows = vec![];
        for row in first..end {
            let centre = 256 * row + 128;
            let square = width * width - 4 * (centre - y) * (centre - y);
            if square < 0 {
                continue;
            }
            // Twice the distance of each place of a row from the middle is at most the root.
            let reach = square.isqrt() / 2;
            let more = i128::from(closed || 4 * reach * reach != square);
            let corners = [
                (x - reach, centre),
                (x - reach, centre + 1),
                (x + reach + more, centre + 1),
                (x + reach + more, centre),
            ];
            rows.push(Self::at((0, 0), &corners));
        }
        rows
    }

    /// The pieces of sides that follow each other.
    fn run(&self, sides: &[Side], ends: Ends) -> Vec<Vec<Units>> {
        let (Some(first), Some(last)) = (sides.first(), sides.last()) else { return vec![] };
        let mut parts: Vec<_> = sides.iter().flat_map(|side| self.side(side.a, side.b, side.ways)).collect();
        parts.extend(sides.windows(2).flat_map(|s| self.join(s[1].a, s[0].ways[1], s[1].ways[0], s[1].smooth)));
        match ends {
            Ends::Joined => parts.extend(self.join(first.a, last.ways[1], first.ways[0], false)),
            Ends::Capped => {
                parts.extend(self.cap(first.a, back(first.ways[0])));
                parts.extend(self.cap(last.b, last.ways[1]));
            }
        }
        parts
    }
}

/// What is at both ends of sides.
#[derive(Copy, Clone)]
enum Ends {
    Capped,
    Joined,
}

/// A side of a contour that has a length.
#[derive(Clone)]
pub struct Side {
    /// Where it starts.
    pub a: Units,
    /// Where it ends.
    pub b: Units,
    /// The direction at both ends.
    pub ways: [Unit; 2],
    /// At `a`.
    pub smooth: bool,
    /// What it is of a curve.
    pub part: Option<Part>,
    /// Whether it is so short that what it turns by has to be looked at.
    pub is_tiny: bool,
    /// How long the parts of curves are that came before it, and ended where they started.
    pub still: i128,
}

impl Side {
    /// The same in sides that can be drawn.
    fn turned(&self, width: i32) -> Vec<Self> {
        match &self.part {
            Some(part) if self.is_tiny => turn(part, (self.a, self.b), self.smooth, width),
            _ => vec![self.clone()],
        }
    }
}

/// Whether a side is so short, beside the width of its stroke, that what it turns by has to be looked at.
fn is_tiny(a: Units, b: Units, width: i32) -> bool {
    let (x, y) = between(a, b);
    x.abs().max(y.abs()).pow(2) <= 4 * i128::from(width)
}

/// The sides of a contour that have a length, and those where a curve turns, with ways that mean nothing. At a place given several times
/// the path is smooth if it is each time.
pub fn sides(outline: &Outline, width: i32) -> Vec<Side> {
    let (Some(&start), Some(&smooth)) = (outline.places.first(), outline.smooth.first()) else { return vec![] };
    let (mut all, mut last, mut still) = (vec![], (start, smooth), 0);
    for (i, (&b, &smooth)) in outline.places.iter().zip(&outline.smooth).enumerate().skip(1) {
        let (a, part) = (last.0, outline.parts.get(i).and_then(Option::as_ref));
        match part {
            Some(part) if width > THIN && is_tiny(a, b, width) && (a != b || part.way(0, false) != (0, 0)) => {
                let (part, still) = (Some(part.clone()), std::mem::take(&mut still));
                all.push(Side { a, b, ways: [(ONE, 0); 2], smooth: last.1, part, is_tiny: true, still });
                last = (b, smooth);
            }
            _ if a == b => {
                last.1 &= smooth;
                still += part.map_or(0, Part::length);
            }
            _ => {
                let chord = direction(a, b);
                let way = |part: &Part, (time, before): (i128, bool)| match part.way(time, before) {
                    (0, 0) => chord,
                    _ if width <= THIN && time != 0 && time != END => chord,
                    way => direction_of(way),
                };
                let ways = part.map_or([chord; 2], |part| [(part.from, false), (part.to, true)].map(|t| way(part, t)));
                let (part, still) = (part.cloned(), std::mem::take(&mut still));
                all.push(Side { a, b, ways, smooth: last.1, part, is_tiny: false, still });
                last = (b, smooth);
            }
        }
    }
    if outline.closed && !all.is_empty() && last.0 != start {
        let chord = direction(last.0, start);
        all.push(Side { a: last.0, b: start, ways: [chord; 2], smooth: last.1, part: None, is_tiny: false, still });
    }
    all
}

/// A tiny part of a curve: a side, or turns where it starts, a way straight to where it ends, and turns there.
fn turn(part: &Part, (a, b): (Units, Units), smooth: bool, width: i32) -> Vec<Side> {
    let width = i128::from(width);
    let of = |way: (i128, i128)| (way != (0, 0)).then(|| direction_of(way));
    let way = |time: i128, before: bool| of(part.way(time, before)).unwrap_or((ONE, 0));
    let leads = |u: Unit| {
        let chord = between(a, b);
        chord.0 * u.0 + chord.1 * u.1 > 0
    };
    let is_even = |u: Unit, time: i128, length: i128, v: Unit| {
        let Some(bend) = of(part.bend_of_way(time, length)) else { return false };
        let (p, q) = (cross(u, bend), cross(bend, v));
        let is_back = (p < 0) != (q < 0) && (p.abs().min(q.abs()) / ONE) * width > 64 * ONE;
        dot(u, v).div_euclid(ONE) > 759_250_125 && dot(u, bend) > 0 && dot(bend, v) > 0 && !is_back
    };
    let (mut u, last) = (way(part.from, false), way(part.to, true));
    let side = |a, b, ways, smooth| Side { a, b, ways, smooth, part: None, is_tiny: false, still: 0 };
    if part.from == part.to {
        return vec![side(a, b, [u; 2], smooth)];
    }
    let turns_much = ((ONE * ONE - dot(u, last)).max(0) / ONE) * width > 256 * ONE;
    if a != b && leads(u) && leads(last) && !turns_much && is_even(u, part.from, part.to - part.from, last) {
        return vec![side(a, b, [u, last], smooth)];
    }
    let (mut all, mut time): (Vec<Side>, _) = (vec![], part.from);
    for (place, until) in [(a, part.from + (part.to - part.from) / 2), (b, part.to)] {
        if place == b && a != b {
            let smooth = smooth || !all.is_empty();
            all.push(side(a, b, [u; 2], smooth));
        }
        while time < until {
            // The longest that halving makes here.
            let mut length = 1;
            while 2 * length <= until - time && time % (2 * length) == 0 {
                length *= 2;
            }
            while length > 64 && !is_even(u, time, length, way(time + length, true)) {
                length /= 2;
            }
            let smooth = smooth || !all.is_empty();
            all.push(side(place, place, [u, way(time + length, true)], smooth));
            time += length;
            u = way(time, false);
        }
    }
    all
}

/// Lengths on and off, and how far into them a contour starts.
#[derive(Clone, Debug)]
pub struct Pattern {
    /// In 24.8 units, the first one on.
    pub lengths: Vec<i32>,
    /// In 24.8 units.
    pub phase: i32,
}

impl Pen {
    /// The pieces of dashed contours, dash by dash.
    pub fn dashes(&self, outlines: &[Outline], pattern: &Pattern) -> Vec<Vec<Units>> {
        let mut lengths: Vec<i128> = pattern.lengths.iter().map(|&n| i128::from(n.max(0)) << 12).collect();
        if lengths.len() % 2 == 1 {
            lengths.extend(lengths.clone());
        }
        let period: i128 = lengths.iter().sum();
        if period < (1 << 16).max(i128::from(self.width) << 6) {
            return self.parts(outlines);
        }
        outlines
            .iter()
            .flat_map(|o| self.dashed(o, &lengths, (i128::from(pattern.phase) << 12).rem_euclid(period)))
            .collect()
    }

    fn dashed(&self, outline: &Outline, lengths: &[i128], phase: i128) -> Vec<Vec<Units>> {
        // How far the present length reaches, from the start of the present side.
        let (mut index, mut reach) = (0, lengths[0] - phase);
        while reach < 0 || (reach == 0 && phase > 0 && lengths[index] > 0) {
            index = (index + 1) % lengths.len();
            reach += lengths[index];
            if reach > 0 || lengths[index] == 0 && reach == 0 {
                break;
            }
        }
        let sides = sides(outline, self.width);
        if sides.is_empty() {
            let dot = if index % 2 == 0 { self.parts(std::slice::from_ref(outline)) } else { vec![] };
            return dot;
        }
        let starts_on = outline.closed && index % 2 == 0;
        let (mut dashes, mut dash): (Vec<Vec<Side>>, Vec<Side>) = (vec![], vec![]);
        // Whether a dash ended where the last side did.
        let mut goes_on = false;
        for side in sides {
            let straight = if side.a == side.b { 0 } else { length(side.a, side.b) };
            let length = side.part.as_ref().map_or(straight, Part::length) + side.still;
            let u = if side.a == side.b || side.part.is_none() { side.ways[0] } else { direction(side.a, side.b) };
            let place = |s: i128| {
                let along = |from: i32, u: i128| {
                    let n = u.abs() * s;
                    let distance = (2 * n + (1 << 42)) >> 43;
                    (i128::from(from) + u.signum() * distance).clamp(i32::MIN.into(), i32::MAX.into()) as i32
                };
                if s >= straight.min(length) {
                    side.b
                } else {
                    (along(side.a.0, u.0), along(side.a.1, u.1))
                }
            };
            let way = |s: i128| match &side.part {
                _ if s == 0 => side.ways[0],
                Some(part) if side.ways[0] != side.ways[1] && s != length => match part.way_beside(place(s), u) {
                    (0, 0) => u,
                    way => direction_of(way),
                },
                _ => side.ways[1],
            };
            // The sides between two distances from the start.
            let sides_between = |s: i128, end: i128| match &side.part {
                Some(part) if side.is_tiny => {
                    let at = |s: i128| (part.time_at(s), part.point(part.time_at(s)));
                    let (from, a) = if s == 0 { (part.from, side.a) } else { at(s) };
                    let (to, b) = if end == length { (part.to, side.b) } else { at(end) };
                    turn(&Part { points: part.points.clone(), from, to }, (a, b), s == 0 && side.smooth, self.width)
                }
                _ => {
                    let (a, b, ways) = (place(s), place(end), [way(s), way(end)]);
                    vec![Side { a, b, ways, smooth: s == 0 && side.smooth, part: None, is_tiny: false, still: 0 }]
                }
            };
            let mut s = 0;
            loop {
                let end = reach.min(length);
                if index % 2 == 0 {
                    dash.extend(sides_between(s, end));
                }
                s = end;
                goes_on = s == reach && index % 2 == 0;
                if s == reach {
                    if index % 2 == 0 {
                        dashes.push(std::mem::take(&mut dash));
                    }
                    index = (index + 1) % lengths.len();
                    reach += lengths[index];
                }
                if s == length {
                    break;
                }
            }
            reach -= length;
        }
        let mut parts = vec![];
        if goes_on && dash.is_empty() {
            dash = dashes.pop().unwrap_or_default();
        }
        // A ring that is on at both ends has no end there.
        if starts_on && !dash.is_empty() {
            let whole = dashes.is_empty();
            if !whole {
                dash.append(&mut dashes[0]);
                dashes[0] = vec![];
            }
            parts.extend(self.run(&dash, if whole { Ends::Joined } else { Ends::Capped }));
        } else {
            parts.extend(self.run(&dash, Ends::Capped));
        }
        parts.extend(dashes.iter().flat_map(|dash| self.run(dash, Ends::Capped)));
        parts
    }
}
