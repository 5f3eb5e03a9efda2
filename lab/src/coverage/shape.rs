//! [`Soft`]: an outline in 1/256 pixel, and what each engine draws of it, made beforehand.

use embedded_raster::{Ellipse, FillRule, Path, PathSegment, PointFx};
use fixed::types::I24F8;
use twins::Units;

use super::outline::{pixels, Builder, Outline};

/// A shape.
pub(crate) struct Soft {
    pub(crate) outline: Outline,
    pub(crate) rule: FillRule,
    /// For this crate.
    pub(crate) contours: Vec<Vec<PointFx>>,
    pub(crate) segments: Vec<PathSegment>,
    pub(crate) skia: Option<tiny_skia::Path>,
    #[cfg(feature = "peers-aa")]
    pub(crate) peers: super::paths::Paths,
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

fn place((x, y): Units) -> PointFx {
    PointFx::from_bits(x, y)
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
            peers: super::paths::Paths::new(&outline, rule),
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
