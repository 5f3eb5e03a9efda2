//! [`Outline`]: what is filled, in 1/256 pixel, and how it is told to whatever builds a path of it.

use twins::Units;

/// What is filled.
#[derive(Clone, Debug)]
pub(crate) enum Outline {
    /// Closed contours of straight sides.
    Polygon(Vec<Vec<Units>>),
    /// A centre and a radius.
    Circle(Units, i32),
    /// Closed cubic curves, each from the end of the one before.
    Curves(Vec<[Units; 4]>),
    /// One pixel wide, its ends cut off at right angles.
    Line(Units, Units),
}

/// What builders of paths have in common.
pub(crate) trait Builder {
    fn start(&mut self, at: [f32; 2]);
    fn line(&mut self, to: [f32; 2]);
    fn cubic(&mut self, c: [f32; 2], d: [f32; 2], b: [f32; 2]);
    /// The side back to the start.
    fn close(&mut self);
}

pub(super) fn pixels((x, y): Units) -> [f32; 2] {
    [x as f32 / 256.0, y as f32 / 256.0]
}

impl Outline {
    /// Tells a builder. Circles become four cubic curves, within 1/3700 of the radius: for whom has none.
    pub(crate) fn tell(&self, path: &mut impl Builder) {
        match self {
            Self::Polygon(contours) => {
                for contour in contours {
                    path.start(pixels(contour[0]));
                    contour[1..].iter().for_each(|&v| path.line(pixels(v)));
                    path.close();
                }
            }
            Self::Circle(centre, radius) => {
                let ([x, y], r) = (pixels(*centre), *radius as f32 / 256.0);
                let k = r * 0.552_284_8;
                path.start([x + r, y]);
                path.cubic([x + r, y + k], [x + k, y + r], [x, y + r]);
                path.cubic([x - k, y + r], [x - r, y + k], [x - r, y]);
                path.cubic([x - r, y - k], [x - k, y - r], [x, y - r]);
                path.cubic([x + k, y - r], [x + r, y - k], [x + r, y]);
                path.close();
            }
            Self::Curves(curves) => {
                path.start(pixels(curves[0][0]));
                for &[_, c, d, b] in curves {
                    path.cubic(pixels(c), pixels(d), pixels(b));
                }
                path.close();
            }
            Self::Line(a, b) => {
                path.start(pixels(*a));
                path.line(pixels(*b));
            }
        }
    }
}
