//! Round shapes as paths, for coverage, which is the area of any outline.
//!
//! An arc becomes cubic curves of an eighth of a turn each, or of less where a radius is above 512 pixels: see [`Oval::parts`].
//! A curve from angle u to v has its control points on the tangents at its ends, `4/3 tan((v - u) / 4)` of a radius away. So it is off
//! the true arc by at most `4.2 10^-6` of the radius, or 64 times less with twice as many curves: less than 1/512 pixel, as far as places
//! go.
//!
//! **Sectors.** The part of an ellipse from one direction to another begins with such curves, from its first direction on, until
//! less than one of them is left. The last one, of an angle a, has `4/3 tan(a / 4)` by a series of `t = tan(a / 2)`, which is the
//! sine of a divided by 1 and its cosine: `tan(a / 4) = t / 2 (1 - t^2 / 4 + t^4 / 8 - 5/64 t^6 + 7/128 t^8 - 21/512 t^10 ...)`, up to
//! t = 0.42 and to `2 10^-7`.
//!
//! Nothing is stored: each curve is found when it is asked for, from the first direction of its arc and its number.
//!
//! Source: M. Goldapp, "Approximation of circular arcs by cubic polynomials", Computer Aided Geometric Design 8, 1991.

use core::num::NonZeroU32;

use super::{
    arc::{Extent, Sector},
    curve::Ellipse,
    rounded::Radii,
};
use crate::{
    geom::{flatten::Segments, Angle, PathSegment, PointFx},
    num::{
        cast::{low_u32, narrow, saturate, signed, unsigned},
        recip::{inverse_root_wide, Divisor},
    },
    span::Rect,
};

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
        const PIXEL: i64 = 512;
        const CURVES: [(i64, u16, i64); 3] =
            [(PIXEL << 9, 8, 284_774_038), (PIXEL << 14, 16, 141_005_785), (PIXEL << 20, 32, 70_332_738)];
        let radius = self.radii.0.max(self.radii.1);
        let enough = CURVES.iter().find(|&&(most, ..)| radius <= most);
        enough.map_or((64, 35_145_176), |&(_, parts, handle)| (parts, handle))
    }
}

/// A place on the circle of radius 1, in units of `2^-30`.
type Direction = (i32, i32);

/// An arc, clockwise from one place to another: its curves, from the first one on or from the last one back.
#[derive(Clone)]
struct Arc {
    oval: Oval,
    from: Direction,
    to: Direction,
    /// How many curves it has, and which of them are left.
    curves: u16,
    left: (u16, u16),
    is_back: bool,
}

impl Arc {
    /// From one place to another, by more than half a turn or not.
    fn new(oval: Oval, from: Direction, to: Direction, is_wide: bool) -> Self {
        /// Directions are off by less than this.
        const NEAR: i64 = 64;
        let (parts, _) = oval.parts();
        let step = i64::from(Angle::turns(1, parts).cos_sin().0);
        let mut arc = Self { oval, from, to, curves: 1, left: (0, 1), is_back: false };
        for curves in 1..=parts.wrapping_add(1) {
            arc.curves = curves;
            let at = arc.place_before(curves);
            let (cos, sin) = (dot(at, to), dot(at, (to.1, to.0.wrapping_neg())));
            let is_last = cos >= step.wrapping_sub(NEAR) && sin >= NEAR.wrapping_neg();
            if is_last && !(is_wide && curves <= parts / 2) {
                break;
            }
        }
        arc.left = (0, arc.curves);
        arc
    }

    /// The same the other way.
    fn back(self) -> Self {
        Self { is_back: true, ..self }
    }

    /// Where a curve begins: the first one has the number 1.
    fn place_before(&self, curve: u16) -> Direction {
        let (parts, _) = self.oval.parts();
        turned(self.from, Angle::turns(curve.wrapping_sub(1).into(), parts).cos_sin())
    }

    fn begin(&self) -> PointFx {
        self.oval.place(self.from)
    }

    fn end(&self) -> PointFx {
        self.oval.place(self.to)
    }

    /// A curve, the first one having the number 1.
    fn curve(&self, number: u16) -> PathSegment {
        let from = self.place_before(number);
        let (to, handle) = if number < self.curves {
            (self.place_before(number.wrapping_add(1)), self.oval.parts().1)
        } else {
            let (cos, sin) = (dot(from, self.to), dot(from, (self.to.1, self.to.0.wrapping_neg())));
            (self.to, handle_of(narrow(cos), narrow(sin)))
        };
        // Along the tangent, which is a quarter of a turn ahead: below 1.04 times 2^30.
        let ahead = |(x, y): Direction, handle: i64| {
            let part = |n: i32| narrow(handle.wrapping_mul(n.into()).wrapping_add(1 << 29) >> 30);
            self.oval.place((x.wrapping_sub(part(y)), y.wrapping_add(part(x))))
        };
        let (a, b) = (ahead(from, handle), ahead(to, handle.wrapping_neg()));
        if self.is_back {
            PathSegment::CubicTo(b, a, self.oval.place(from))
        } else {
            PathSegment::CubicTo(a, b, self.oval.place(to))
        }
    }
}

impl Iterator for Arc {
    type Item = PathSegment;

    #[inline(never)]
    fn next(&mut self) -> Option<PathSegment> {
        let (done, end) = self.left;
        if done >= end {
            return None;
        }
        if self.is_back {
            self.left.1 = end.wrapping_sub(1);
            Some(self.curve(end))
        } else {
            self.left.0 = done.wrapping_add(1);
            Some(self.curve(done.wrapping_add(1)))
        }
    }
}

/// A rectangle of pixels with rounded corners.
pub(crate) fn rounded(area: Rect, radii: Radii) -> impl Segments {
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
    let is_there = !area.is_empty();
    let quarters = (0..if is_there { 4_u32 } else { 0 }).zip(corners).flat_map(|(quarter, oval)| {
        let [from, to] = [quarter, quarter.wrapping_add(1)].map(|n| Angle::turns(n, 4).cos_sin());
        let arc = Arc::new(oval, from, to, false);
        let start = if quarter == 0 { PathSegment::MoveTo } else { PathSegment::LineTo };
        [start(arc.begin())].into_iter().chain(Some(arc).filter(|_| oval.radii.0 > 0).into_iter().flatten())
    });
    quarters.chain(is_there.then_some(PathSegment::Close))
}

/// A sector of an ellipse, less than all of it: from its centre to the arc, along it, and back.
pub(crate) fn sector(ellipse: &Ellipse, sector: Sector) -> impl Segments {
    let (from, to, extent) = sector.ends();
    let arc = Oval::of(ellipse).filter(|_| extent != Extent::Nothing).map(|oval| {
        let [from, to] = [from, to].map(|direction| oval.on_circle(direction));
        Arc::new(oval, from, to, extent == Extent::Wide)
    });
    let start = arc.as_ref().map(|arc| [PathSegment::MoveTo(arc.oval.place((0, 0))), PathSegment::LineTo(arc.begin())]);
    let close = start.map(|_| PathSegment::Close);
    start.into_iter().flatten().chain(arc.into_iter().flatten()).chain(close)
}

/// A sector of what lies between two ellipses, less than all of it: the arc along the outer one, and what follows it, along the inner one
/// and back. Of the inner one directions are those seen from its own centre. If it has no area or lies beside the outer one, this is a
/// sector of the outer one, and no more is drawn than its box has room for.
pub(crate) fn ring_sector(outer: &Ellipse, inner: &Ellipse, sector: Sector) -> impl Segments {
    let (from, to, extent) = sector.ends();
    let of = |oval: Oval| Arc::new(oval, oval.on_circle(from), oval.on_circle(to), extent == Extent::Wide);
    let large = Oval::of(outer).filter(|_| extent != Extent::Nothing);
    let small = Oval::of(inner).zip(large).filter(|(small, large)| small.meets(*large)).map(|(small, _)| of(small));
    let there = large.map(of);
    let start = there.as_ref().map(|arc| PathSegment::MoveTo(arc.begin()));
    // To the end of the inner arc, or to the centre.
    let turn = there.as_ref().map(|arc| small.as_ref().map_or_else(|| arc.oval.place((0, 0)), Arc::end));
    let there = start.into_iter().chain(there.into_iter().flatten());
    let close = start.map(|_| PathSegment::Close);
    there.chain(turn.map(PathSegment::LineTo)).chain(small.map(Arc::back).into_iter().flatten()).chain(close)
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
