//! Strokes by the rule: every piece as a contour, in integers of 128 bits.

use embedded_raster::{Cap, Join};

use super::{curves::Outline, Units};

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

/// The scaled difference and its length.
fn scaled(a: Units, b: Units) -> (i128, i128, i128) {
    let (mut x, mut y) = (i128::from(b.0) - i128::from(a.0), i128::from(b.1) - i128::from(a.1));
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
    let (x, y, length) = scaled(a, b);
    let share = |n: i128| n.signum() * div_up(n.abs() * ONE, length);
    (share(x), share(y))
}

/// The length of a side in 2^-16 pixel.
pub fn length(a: Units, b: Units) -> i128 {
    let (x, y, length) = scaled(a, b);
    let d = (i128::from(b.0) - i128::from(a.0), i128::from(b.1) - i128::from(a.1));
    // By how much it was scaled: exact, but where a bit was lost.
    let (scaled, plain) = if x.abs() >= y.abs() { (x.abs(), d.0.abs()) } else { (y.abs(), d.1.abs()) };
    if plain > scaled {
        2 * (length << 8)
    } else {
        (length << 8) / (scaled / plain)
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
        let j = (3..11).find(|j| 12 << (2 * j) >= i64::from(self.width)).unwrap_or(11);
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
                Some(Self::at(v, &[right, sum(right), sum(left), left]))
            }
        }
    }

    /// What fills the gap between two sides, if there is one.
    pub fn join(&self, v: Units, last: Unit, next: Unit, smooth: bool) -> Option<Vec<Units>> {
        let turn = cross(last, next);
        if turn == 0 && dot(last, next) > 0 {
            return None;
        }
        let join = if smooth { Join::Round } else { self.join };
        Some(if turn > 0 {
            self.wedge(v, back(right(next)), back(right(last)), join)
        } else {
            self.wedge(v, right(last), right(next), join)
        })
    }

    /// A side, as wide as the pen.
    pub fn side(&self, a: Units, b: Units, u: Unit) -> Vec<Units> {
        let (r, l) = (self.half(right(u)), self.half(back(right(u))));
        [Self::at(a, &[r]), Self::at(b, &[r, l]), Self::at(a, &[l])].concat()
    }

    /// The pieces of contours.
    pub fn parts(&self, outlines: &[Outline]) -> Vec<Vec<Units>> {
        outlines.iter().flat_map(|outline| self.contour(outline)).collect()
    }

    fn contour(&self, outline: &Outline) -> Vec<Vec<Units>> {
        let Some(&start) = outline.places.first() else { return vec![] };
        let sides = sides(outline);
        let (Some(first), Some(last)) = (sides.first(), sides.last()) else {
            return [(ONE, 0), (-ONE, 0)].into_iter().filter_map(|u| self.cap(start, u)).collect();
        };
        let mut parts = vec![];
        for (i, side) in sides.iter().enumerate() {
            if i > 0 {
                parts.extend(self.join(side.a, sides[i - 1].u, side.u, side.smooth));
            }
            parts.push(self.side(side.a, side.b, side.u));
        }
        if outline.closed {
            parts.extend(self.join(start, last.u, first.u, false));
        } else {
            parts.extend(self.cap(first.a, back(first.u)));
            parts.extend(self.cap(last.b, last.u));
        }
        parts
    }
}

/// A side of a contour that has a length.
pub struct Side {
    /// Where it starts.
    pub a: Units,
    /// Where it ends.
    pub b: Units,
    /// Its direction.
    pub u: Unit,
    /// At `a`.
    pub smooth: bool,
}

/// The sides of a contour that have a length. At a place given several times the path is smooth if it is each time.
pub fn sides(outline: &Outline) -> Vec<Side> {
    let mut nodes: Vec<(Units, bool)> = vec![];
    for (&place, &smooth) in outline.places.iter().zip(&outline.smooth) {
        match nodes.last_mut() {
            Some(last) if last.0 == place => last.1 &= smooth,
            _ => nodes.push((place, smooth)),
        }
    }
    if outline.closed && nodes.len() > 1 && nodes[0].0 != nodes[nodes.len() - 1].0 {
        nodes.push((nodes[0].0, false));
    }
    nodes.windows(2).map(|n| Side { a: n[0].0, b: n[1].0, u: direction(n[0].0, n[1].0), smooth: n[0].1 }).collect()
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
        let mut lengths: Vec<i128> = pattern.lengths.iter().map(|&n| i128::from(n.max(0)) << 8).collect();
        if lengths.len() % 2 == 1 {
            lengths.extend(lengths.clone());
        }
        let period: i128 = lengths.iter().sum();
        if period < (1 << 12).max(i128::from(self.width) << 2) {
            return self.parts(outlines);
        }
        outlines
            .iter()
            .flat_map(|o| self.dashed(o, &lengths, (i128::from(pattern.phase) << 8).rem_euclid(period)))
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
        let sides = sides(outline);
        if sides.is_empty() {
            let dot = if index % 2 == 0 { self.parts(std::slice::from_ref(outline)) } else { vec![] };
            return dot;
        }
        let (mut parts, mut dash): (Vec<_>, Vec<Side>) = (vec![], vec![]);
        for side in sides {
            let length = length(side.a, side.b);
            let place = |s: i128| {
                let along = |from: i32, u: i128| {
                    let n = u.abs() * s;
                    let distance = (2 * n + (1 << 38)) >> 39;
                    (i128::from(from) + u.signum() * distance).clamp(i32::MIN.into(), i32::MAX.into()) as i32
                };
                if s == length {
                    side.b
                } else {
                    (along(side.a.0, side.u.0), along(side.a.1, side.u.1))
                }
            };
            let mut s = 0;
            while s < length {
                let end = reach.min(length);
                if index % 2 == 0 {
                    dash.push(Side { a: place(s), b: place(end), u: side.u, smooth: s == 0 && side.smooth });
                }
                s = end;
                if s == reach {
                    parts.extend(self.one_dash(&dash));
                    dash.clear();
                    index = (index + 1) % lengths.len();
                    reach += lengths[index];
                }
            }
            reach -= length;
        }
        parts.extend(self.one_dash(&dash));
        parts
    }

    fn one_dash(&self, sides: &[Side]) -> Vec<Vec<Units>> {
        let (Some(first), Some(last)) = (sides.first(), sides.last()) else { return vec![] };
        let mut parts: Vec<_> = sides.iter().map(|side| self.side(side.a, side.b, side.u)).collect();
        parts.extend(sides.windows(2).filter_map(|s| self.join(s[1].a, s[0].u, s[1].u, s[1].smooth)));
        parts.extend(self.cap(first.a, back(first.u)));
        parts.extend(self.cap(last.b, last.u));
        parts
    }
}
