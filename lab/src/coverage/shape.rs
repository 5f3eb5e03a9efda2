//! [`Soft`]: an outline in 1/256 pixel, and what each engine draws of it, made beforehand.

use embedded_raster::{Ellipse, FillRule, Path, PathSegment, PointFx};
use fixed::types::I24F8;
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

/// A shape.
pub(crate) struct Soft {
    pub(crate) outline: Outline,
    pub(crate) rule: FillRule,
    /// For this crate.
    pub(crate) contours: Vec<Vec<PointFx>>,
    pub(crate) segments: Vec<PathSegment>,
    pub(crate) skia: Option<tiny_skia::Path>,
    #[cfg(feature = "peers-aa")]
    pub(crate) peers: super::peers::Paths,
}

/// What builders of paths have in common.
pub(crate) trait Builder {
    fn start(&mut self, at: [f32; 2]);
    fn line(&mut self, to: [f32; 2]);
    fn cubic(&mut self, c: [f32; 2], d: [f32; 2], b: [f32; 2]);
    /// The side back to the start.
    fn close(&mut self);
}

impl Builder for tiny_skia::PathBuilder {
    fn start(&mut self, [x, y]: [f32; 2]) {
        self.move_to(x, y);
    }

    fn line(&mut self, [x, y]: [f32; 2]) {
        self.line_to(x, y);
    }

    fn cubic(&mut self, c: [f32; 2], d: [f32; 2], b: [f32; 2]) {
        self.cubic_to(c[0], c[1], d[0], d[1], b[0], b[1]);
    }

    fn close(&mut self) {
        Self::close(self);
    }
}

pub(crate) fn pixels((x, y): Units) -> [f32; 2] {
    [x as f32 / 256.0, y as f32 / 256.0]
}

fn place((x, y): Units) -> PointFx {
    PointFx::from_bits(x, y)
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

impl Soft {
    pub(crate) fn new(outline: Outline, rule: FillRule) -> Self {
        let (mut contours, mut segments) = (Vec::new(), Vec::new());
        match &outline {
            Outline::Polygon(all) => contours = all.iter().map(|c| c.iter().copied().map(place).collect()).collect(),
            Outline::Curves(curves) => {
                segments.push(PathSegment::MoveTo(place(curves[0][0])));
                let cubic = |&[_, c, d, b]: &[Units; 4]| PathSegment::CubicTo(place(c), place(d), place(b));
                segments.extend(curves.iter().map(cubic));
            }
            Outline::Circle(..) | Outline::Line(..) => {}
        }
        let skia = if let Outline::Circle(centre, radius) = outline {
            let [x, y] = pixels(centre);
            tiny_skia::PathBuilder::from_circle(x, y, radius as f32 / 256.0)
        } else {
            let mut builder = tiny_skia::PathBuilder::new();
            outline.tell(&mut builder);
            builder.finish()
        };
        Self {
            #[cfg(feature = "peers-aa")]
            peers: super::peers::Paths::new(&outline, rule),
            outline,
            rule,
            contours,
            segments,
            skia,
        }
    }

    pub(crate) fn path(&self) -> Path<'_> {
        Path::new(&self.segments)
    }

    /// The line or the circle that it is.
    pub(crate) fn ends(&self) -> Option<[PointFx; 2]> {
        if let Outline::Line(a, b) = self.outline {
            Some([place(a), place(b)])
        } else {
            None
        }
    }

    pub(crate) fn circle(&self) -> Option<Ellipse> {
        let Outline::Circle(centre, radius) = self.outline else { return None };
        Some(Ellipse::circle(place(centre), I24F8::from_bits(radius)))
    }
}
