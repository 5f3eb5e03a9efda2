//! [`Smooth`]: round shapes as paths, for coverage, which is the area of any outline.
//!
//! An arc becomes cubic curves of an eighth of a turn each, or of a sixteenth where a radius is above 512 pixels. A curve from angle
//! u to v has its control points on the tangents at its ends, `4/3 tan((v - u) / 4)` of a radius away. So it is off the true arc
//! by at most `4.2 10^-6` of the radius, or `6.6 10^-8`: less than 1/256 pixel, up to radii of 60,000 pixels.
//!
//! Source: M. Goldapp, "Approximation of circular arcs by cubic polynomials", Computer Aided Geometric Design 8, 1991.

use heapless::Vec;

use super::{curve::Ellipse, rounded::Radii};
use crate::{
    geom::{Angle, Path, PathSegment, PointFx},
    num::cast::{narrow, saturate},
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
        let curve = ellipse.curve();
        if curve.radii.0 <= 0 || curve.radii.1 <= 0 {
            return smooth;
        }
        // The shift is at most 9.
        let scaled = |n: i64| n << (9_u32.wrapping_sub(curve.shift) & 15);
        let oval = Oval {
            centre: (scaled(curve.centre.0), scaled(curve.centre.1)),
            radii: (scaled(curve.radii.0), scaled(curve.radii.1)),
        };
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
            // Along the tangent, which is a quarter of a turn ahead: below 1.04 times 2^30.
            let ahead = |(x, y): (i32, i32), handle: i64| {
                let part = |n: i32| narrow(handle.wrapping_mul(n.into()).wrapping_add(1 << 29) >> 30);
                oval.place((x.wrapping_sub(part(y)), y.wrapping_add(part(x))))
            };
            self.push(PathSegment::CubicTo(ahead(a, handle), ahead(b, handle.wrapping_neg()), oval.place(b)));
        }
    }

    /// There is room for all: see the capacity.
    fn push(&mut self, segment: PathSegment) {
        self.segments.push(segment).unwrap_or(());
    }
}
