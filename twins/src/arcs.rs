//! Elliptic arcs by the formulas of SVG 2, appendix B.2, in floats, and how far curves are from them.

/// A place in pixels.
pub type Place = [f64; 2];

/// An arc as SVG has it: radii, degrees, flags.
#[derive(Copy, Clone, Debug)]
pub struct Arc {
    /// Half of the width and of the height, before it is turned.
    pub radii: [f64; 2],
    /// Clockwise, as seen on the screen.
    pub degrees: f64,
    /// More than half of the ellipse.
    pub is_large: bool,
    /// Clockwise, as seen on the screen.
    pub is_clockwise: bool,
}

/// The ellipse of an arc, and the part of it: angles of the circle that it is before it is stretched and turned.
#[derive(Copy, Clone, Debug)]
pub struct Centred {
    /// Its middle.
    pub centre: Place,
    /// Enlarged, if need be.
    pub radii: [f64; 2],
    /// Clockwise, as seen on the screen.
    pub degrees: f64,
    /// Where the arc begins, and how far it goes, in radians: negative for an arc that goes anticlockwise.
    pub angles: [f64; 2],
}

impl Arc {
    /// Its ellipse; `None` for a line or nothing.
    pub fn centred(&self, from: Place, to: Place) -> Option<Centred> {
        let [mut rx, mut ry] = self.radii.map(f64::abs);
        if from[0].to_bits() == to[0].to_bits() && from[1].to_bits() == to[1].to_bits() || rx == 0.0 || ry == 0.0 {
            return None;
        }
        let (sin, cos) = self.degrees.to_radians().sin_cos();
        let (dx, dy) = ((from[0] - to[0]) / 2.0, (from[1] - to[1]) / 2.0);
        let (x, y) = (cos * dx + sin * dy, cos * dy - sin * dx);
        let square = (x / rx).powi(2) + (y / ry).powi(2);
        if square > 1.0 {
            (rx, ry) = (rx * square.sqrt(), ry * square.sqrt());
        }
        let factor = ((1.0 - square) / square).max(0.0).sqrt();
        let factor = if self.is_large == self.is_clockwise { -factor } else { factor };
        let (cx, cy) = (factor * rx * y / ry, -factor * ry * x / rx);
        let middle = [0, 1].map(|i| f64::midpoint(from[i], to[i]));
        let centre = [cos * cx - sin * cy + middle[0], sin * cx + cos * cy + middle[1]];
        let start = ((y - cy) / ry).atan2((x - cx) / rx);
        let end = ((-y - cy) / ry).atan2((-x - cx) / rx);
        let turn = core::f64::consts::TAU;
        let angle = (end - start).rem_euclid(turn);
        let angle = if self.is_clockwise { angle } else { angle - turn };
        Some(Centred { centre, radii: [rx, ry], degrees: self.degrees, angles: [start, angle] })
    }
}

impl Centred {
    /// A place on the circle that the ellipse is made of.
    pub fn on_circle(&self, place: Place) -> Place {
        let (sin, cos) = self.degrees.to_radians().sin_cos();
        let (x, y) = (place[0] - self.centre[0], place[1] - self.centre[1]);
        [(cos * x + sin * y) / self.radii[0], (cos * y - sin * x) / self.radii[1]]
    }

    /// How far a place is from the ellipse, nearly: by the value of its equation and the slope of that.
    pub fn distance(&self, place: Place) -> f64 {
        let [u, v] = self.on_circle(place);
        let slope = (2.0 * u / self.radii[0]).hypot(2.0 * v / self.radii[1]);
        (u * u + v * v - 1.0).abs() / slope
    }

    /// How far along the arc a place is, from 0 at its start to 1 at its end; a bit before the start is a bit below 0.
    pub fn progress(&self, place: Place) -> f64 {
        let [u, v] = self.on_circle(place);
        let turn = core::f64::consts::TAU;
        let [start, angle] = self.angles;
        let done = ((v.atan2(u) - start) * angle.signum()).rem_euclid(turn);
        // Halfway in what is left out of the whole turn, before and behind change.
        let done = if done > f64::midpoint(turn, angle.abs()) { done - turn } else { done };
        done / angle.abs()
    }
}
