//! [`Smooth`]: round shapes as paths, for coverage, which is the area of any outline.
//!
//! An arc becomes cubic curves of an eighth of a turn each, or of a sixteenth where a radius is above 512 pixels. A curve from angle
//! u to v has its control points on the tangents at its ends, `4/3 tan((v - u) / 4)` of a radius away. So it is off the true arc
//! by at most `4.2 10^-6` of the radius, or `6.6 10^-8`: less than 1/256 pixel, up to radii of 60,000 pixels.
//!
//! **Sectors.** The part of an ellipse from one direction to another begins with such curves, from its first direction on, until
//! less than one of them is left. The last one, of an angle a, has `4/3 tan(a / 4)` by a series of `t = tan(a / 2)`, which is the
//! sine of a divided by 1 and its cosine: `tan(a / 4) = t / 2 (1 - t^2 / 4 + t^4 / 8 - 5/64 t^6 + 7/128 t^8 - 21/512 t^10 ...)`, up to
//! t = 0.42 and to `2 10^-7`.
//!
//! Source: M. Goldapp, "Approximation of circular arcs by cubic polynomials", Computer Aided Geometric Design 8, 1991.

use core::num::NonZeroU32;

use heapless::Vec;

use super::{
    arc::{Extent, Sector},
    curve::Ellipse,
    rounded::Radii,
};
use crate::{
    geom::{Angle, Path, PathSegment, PointFx},
    num::{
        cast::{low_u32, narrow, saturate, signed, unsigned},
        recip::{inverse_root_wide, Divisor},
    },
    span::Rect,
};

/// A round shape as the segments of a path: of places to 1/256 pixel. What lies beyond the range of places is pressed to its end.
#[derive(Clone, Debug)]
pub(crate) struct Smooth {
    /// At most a move, four sides, four times four curves, and the closing side.
    segments: Vec<PathSegment, 22>,
}

/// Centre and radii of an ellipse, in units of 1/512 pixel.
#[derive(Copy, Clone)]
struct Oval {
    centre: (i64, i64),
    radii: (i64, i64),
}

impl Oval {
    /// That of an ellipse, if it has area.
    fn of(ellipse: &Ellipse) -> Option<Self> {
        ellipse.on_grid().map(|(centre, radii)| Self { centre, radii })
    }

    /// Whether the boxes around two of them have anything in common.
    fn meets(self, other: Self) -> bool {
        let is_near = |a: i64, b: i64, radii: i64| a.wrapping_sub(b).unsigned_abs() < radii.unsigned_abs();
        is_near(self.centre.0, other.centre.0, self.radii.0.wrapping_add(other.radii.0))
            && is_near(self.centre.1, other.centre.1, self.radii.1.wrapping_add(other.radii.1))
    }

    /// The place on the circle of radius 1 that the ellipse has in a direction, as seen on the screen: both in units of `2^-30`.
    fn on_circle(self, (x, y): (i32, i32)) -> (i32, i32) {
        if self.radii.0 == self.radii.1 {
            return (x, y);
        }
        // In the direction of (x / rx, y / ry), and of (x ry, y rx): below 2^62.
        let radius = |n: i64| u64::from(low_u32(n.min((1 << 32) - 1).unsigned_abs()));
        let wide = |n: i32, r: i64| radius(r).wrapping_mul(n.unsigned_abs().into());
        let (u, v) = (wide(x, self.radii.1), wide(y, self.radii.0));
        // 30 bits of the larger one: the sum of the squares is at least 2^58, and below 2^61.
        let up = (u | v).leading_zeros() & 63;
        let (u, v) = ((u << up) >> 34, (v << up) >> 34);
        let (inverse, shift) = inverse_root_wide(u.wrapping_mul(u).wrapping_add(v.wrapping_mul(v)).max(1));
        let down = 32_u32.wrapping_sub(shift >> 1) & 63;
        let part = |n: u64, sign: i32| {
            let size = signed(low_u32(n.wrapping_mul(inverse.into()).wrapping_add(1 << 31 >> (shift >> 1)) >> down));
            if sign < 0 {
                size.wrapping_neg()
            } else {
                size
            }
        };
        (part(u, x), part(v, y))
    }

    /// The place in a direction: so many `2^-30` of its radii from its centre.
    fn place(self, (x, y): (i32, i32)) -> PointFx {
        // Radii are below 2^32, so products are below 2^63.
        let along = |centre: i64, radius: i64, part: i32| {
            let away = radius.min((1 << 32) - 1).wrapping_mul(part.into()).wrapping_add(1 << 29) >> 30;
            saturate(centre.wrapping_add(away).wrapping_add(1) >> 1)
        };
        PointFx::from_bits(along(self.centre.0, self.radii.0, x), along(self.centre.1, self.radii.1, y))
    }

    /// Parts of a turn that are one curve each, and `4/3 tan(turn / (4 parts))` in units of `2^-30`.
    fn parts(self) -> (u16, i64) {
        if self.radii.0.max(self.radii.1) <= 512 << 9 {
            (8, 284_774_038)
        } else {
            (16, 141_005_785)
        }
    }
}

impl Smooth {
    /// An ellipse. Without area it has no segments.
    pub(crate) fn ellipse(ellipse: &Ellipse) -> Self {
        let mut smooth = Self { segments: Vec::new() };
        let Some(oval) = Oval::of(ellipse) else { return smooth };
        smooth.begin(oval.place((1 << 30, 0)));
        for quarter in 0..4 {
            smooth.quarter(oval, quarter);
        }
        smooth.push(PathSegment::Close);
        smooth
    }

    /// A rectangle of pixels with rounded corners.
    pub(crate) fn rounded(area: Rect, radii: Radii) -> Self {
        let mut smooth = Self { segments: Vec::new() };
        if area.is_empty() {
            return smooth;
        }
        let Radii { top_left, top_right, bottom_right, bottom_left } = radii.limited(area);
        let units = |n: i32| i64::from(n) << 9;
        let corner = |(x, y): (i32, i32), right: i64, down: i64, radius: u32| {
            let radius = i64::from(radius) << 9;
            let centre =
                (units(x).wrapping_add(radius.wrapping_mul(right)), units(y).wrapping_add(radius.wrapping_mul(down)));
            Oval { centre, radii: (radius, radius) }
        };
        // Clockwise, from the right end of the lower right corner on; each quarter ends a quarter of a turn later.
        let corners = [
            corner((area.x1, area.y1), -1, -1, bottom_right),
            corner((area.x0, area.y1), 1, -1, bottom_left),
            corner((area.x0, area.y0), 1, 1, top_left),
            corner((area.x1, area.y0), -1, 1, top_right),
        ];
        for (quarter, oval) in (0..).zip(corners) {
            let start = oval.place(Angle::turns(quarter, 4).cos_sin());
            if quarter == 0 {
                smooth.begin(start);
            } else {
                smooth.push(PathSegment::LineTo(start));
            }
            if oval.radii.0 > 0 {
                smooth.quarter(oval, quarter);
            }
        }
        smooth.push(PathSegment::Close);
        smooth
    }

    /// A sector of an ellipse: from its centre to the arc, along it, and back.
    pub(crate) fn sector(ellipse: &Ellipse, sector: Sector) -> Self {
        let (from, to, extent) = sector.ends();
        let mut smooth = Self { segments: Vec::new() };
        let is_wide = match extent {
            Extent::Nothing => return smooth,
            Extent::Everything => return Self::ellipse(ellipse),
            Extent::Narrow => false,
            Extent::Wide => true,
        };
        let Some(oval) = Oval::of(ellipse) else { return smooth };
        smooth.begin(oval.place((0, 0)));
        let [from, to] = [from, to].map(|direction| oval.on_circle(direction));
        smooth.push(PathSegment::LineTo(oval.place(from)));
        smooth.arc(oval, (from, to), is_wide);
        smooth.push(PathSegment::Close);
        smooth
    }

    /// A sector of what lies between two ellipses: the arc along the outer one, and what follows it, along the inner one and back. Of the
    /// inner one directions are those seen from its own centre. If it has no area or lies beside the outer one, this is a sector of the outer
    /// one, and no more is drawn than its box has room for.
    pub(crate) fn ring_sector(outer: &Ellipse, inner: &Ellipse, sector: Sector) -> [Self; 2] {
        let nothing = || Self { segments: Vec::new() };
        let (from, to, extent) = sector.ends();
        let is_wide = match extent {
            Extent::Nothing => return [nothing(), nothing()],
            Extent::Everything => return [outer, inner].map(Self::ellipse),
            Extent::Narrow => false,
            Extent::Wide => true,
        };
        let Some(large) = Oval::of(outer) else { return [nothing(), nothing()] };
        let Some(small) = Oval::of(inner).filter(|&small| small.meets(large)) else {
            return [Self::sector(outer, sector), nothing()];
        };
        let (mut there, mut back) = (nothing(), nothing());
        let ends = |oval: Oval| (oval.on_circle(from), oval.on_circle(to));
        there.begin(large.place(ends(large).0));
        there.arc(large, ends(large), is_wide);
        back.begin(small.place(ends(small).0));
        back.arc(small, ends(small), is_wide);
        back.turn_round();
        [there, back]
    }

    /// Turns an arc that begins with a move so that it goes the other way: from a line to its last place to its first one, which closes
    /// the path before it.
    fn turn_round(&mut self) {
        let mut back: Vec<PathSegment, 22> = Vec::new();
        // The handles of the curve that was looked at last: it ends where the next one begins.
        let mut handles = None;
        for &segment in self.segments.iter().rev() {
            let (end, own) = match segment {
                PathSegment::CubicTo(a, b, end) => (end, Some((a, b))),
                PathSegment::MoveTo(end) | PathSegment::LineTo(end) => (end, None),
                _ => continue,
            };
            let next = match handles {
                Some((a, b)) => PathSegment::CubicTo(b, a, end),
                None => PathSegment::LineTo(end),
            };
            back.push(next).unwrap_or(());
            handles = own;
        }
        back.push(PathSegment::Close).unwrap_or(());
        self.segments = back;
    }

    /// The curves from one place on the circle clockwise to another, by more than half a turn or not.
    fn arc(&mut self, oval: Oval, (from, to): ((i32, i32), (i32, i32)), is_wide: bool) {
        /// Directions are off by less than this after all of the steps.
        const NEAR: i64 = 64;
        let (parts, handle) = oval.parts();
        let step = Angle::turns(1, parts).cos_sin();
        let mut at = from;
        for part in 0..=parts {
            let (cos, sin) = (dot(at, to), dot(at, (to.1, to.0.wrapping_neg())));
            let is_last = cos >= i64::from(step.0).wrapping_sub(NEAR) && sin >= -NEAR;
            if is_last && !(is_wide && part < parts / 2) {
                self.curve(oval, (at, to), handle_of(narrow(cos), narrow(sin)));
                return;
            }
            let next = turned(at, step);
            self.curve(oval, (at, next), handle);
            at = next;
        }
    }

    /// One curve between places on the circle.
    fn curve(&mut self, oval: Oval, (from, to): ((i32, i32), (i32, i32)), handle: i64) {
        // Along the tangent, which is a quarter of a turn ahead: below 1.04 times 2^30.
        let ahead = |(x, y): (i32, i32), handle: i64| {
            let part = |n: i32| narrow(handle.wrapping_mul(n.into()).wrapping_add(1 << 29) >> 30);
            oval.place((x.wrapping_sub(part(y)), y.wrapping_add(part(x))))
        };
        self.push(PathSegment::CubicTo(ahead(from, handle), ahead(to, handle.wrapping_neg()), oval.place(to)));
    }

    /// The path, for as long as this lives.
    pub(crate) fn path(&self) -> Path<'_> {
        Path::new(&self.segments)
    }

    fn begin(&mut self, at: PointFx) {
        self.push(PathSegment::MoveTo(at));
    }

    /// The curves of a quarter of a turn, from its start on.
    fn quarter(&mut self, oval: Oval, quarter: u32) {
        let (parts, handle) = oval.parts();
        let each = u32::from(parts) / 4;
        for part in 0..each {
            let from = quarter.wrapping_mul(each).wrapping_add(part);
            let [a, b] = [from, from.wrapping_add(1)].map(|n| Angle::turns(n, parts).cos_sin());
            self.curve(oval, (a, b), handle);
        }
    }

    /// There is room for all: see the capacity.
    fn push(&mut self, segment: PathSegment) {
        self.segments.push(segment).unwrap_or(());
    }
}

/// The product of two directions in `2^-30`: the cosine of the angle between them.
fn dot((a, b): (i32, i32), (x, y): (i32, i32)) -> i64 {
    let sum = i64::from(a).wrapping_mul(x.into()).wrapping_add(i64::from(b).wrapping_mul(y.into()));
    sum.wrapping_add(1 << 29) >> 30
}

/// A direction, turned clockwise by another.
fn turned((x, y): (i32, i32), (cos, sin): (i32, i32)) -> (i32, i32) {
    (narrow(dot((x, y), (cos, sin.wrapping_neg()))), narrow(dot((x, y), (sin, cos))))
}

/// `4/3 tan(a / 4)` of an angle from 0 to an eighth of a turn and a little, by its cosine and its sine: all in units of `2^-30`.
fn handle_of(cos: i32, sin: i32) -> i64 {
    let below = unsigned(cos.max(0)).wrapping_add(1 << 30);
    let divisor = Divisor::new(NonZeroU32::new(below).unwrap_or(NonZeroU32::MIN));
    let t = i64::from(divisor.div_rem(u64::from(unsigned(sin.max(0))) << 30).0);
    let times = |a: i64, b: i64| a.wrapping_mul(b).wrapping_add(1 << 29) >> 30;
    let square = times(t, t);
    // 2^30 times 1, 1/4, 1/8, 5/64, 7/128 and 21/512, with changing signs: from the last one on.
    let series = [58_720_256, -83_886_080, 134_217_728, -268_435_456, 1 << 30]
        .into_iter()
        .fold(-44_040_192, |sum, factor| times(sum, square).wrapping_add(factor));
    // 4/3 of a half.
    i64::from(narrow(times(t, series)).wrapping_mul(2) / 3)
}
