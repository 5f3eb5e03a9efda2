//! Shapes, each in the words of every engine: made ready beforehand, so that only drawing is measured.

use embedded_graphics::geometry::Point;
use embedded_raster::{PathSegment, PointFx, Rect};
use tiny_skia::{Path, PathBuilder};

/// Fractional bits of the true shapes: finer than any engine keeps, and still exact in an `f32` up to 512 pixels.
pub(crate) const BITS: u32 = 15;
/// One pixel.
pub(crate) const ONE: i64 = 1 << BITS;
/// A place in units of 2^-15 pixel.
pub(crate) type Units = (i64, i64);

/// In pixels. Exact for everything near the screen.
fn float((x, y): Units) -> (f32, f32) {
    (x as f32 / ONE as f32, y as f32 / ONE as f32)
}

/// The nearest place with so many fractional bits, in units.
pub(crate) fn snap((x, y): Units, bits: u32) -> Units {
    let cell = BITS - bits;
    let nearest = |v: i64| ((v + (1 << cell >> 1)) >> cell) << cell;
    (nearest(x), nearest(y))
}

/// As the crate takes it, after snapping to so many bits.
fn vertex(at: Units, bits: u32) -> PointFx {
    let (x, y) = snap(at, bits);
    PointFx::from_bits((x >> (BITS - 8)) as i32, (y >> (BITS - 8)) as i32)
}

fn path(corners: &[(f32, f32)]) -> Option<Path> {
    let mut path = PathBuilder::new();
    path.move_to(corners[0].0, corners[0].1);
    corners[1..].iter().for_each(|&(x, y)| path.line_to(x, y));
    path.close();
    path.finish()
}

/// A line from pixel to pixel.
#[derive(Clone, Debug)]
pub(crate) struct Line {
    pub(crate) a: Point,
    pub(crate) b: Point,
    pub(crate) path: Option<Path>,
}

impl Line {
    pub(crate) fn new(a: (i32, i32), b: (i32, i32)) -> Self {
        Self { a: a.into(), b: b.into(), path: hairline(a, b) }
    }
}

/// From just inside the first pixel to just inside the last: tiny-skia draws the columns (or rows) whose centres lie
/// between the ends, and from centre to centre it would leave one out.
fn hairline(a: (i32, i32), b: (i32, i32)) -> Option<Path> {
    let (dx, dy) = ((b.0 - a.0) as f32, (b.1 - a.1) as f32);
    let reach = 0.49 / dx.abs().max(dy.abs()).max(1.0);
    let mut path = PathBuilder::new();
    path.move_to(a.0 as f32 + 0.5 - dx * reach, a.1 as f32 + 0.5 - dy * reach);
    path.line_to(b.0 as f32 + 0.5 + dx * reach, b.1 as f32 + 0.5 + dy * reach);
    path.finish()
}

/// A triangle, true and snapped.
#[derive(Clone, Debug)]
pub(crate) struct Triangle {
    pub(crate) units: [Units; 3],
    pub(crate) floats: [(f32, f32); 3],
    /// Snapped to 0, 4 and 8 bits.
    pub(crate) whole: [PointFx; 3],
    pub(crate) sixteenths: [PointFx; 3],
    pub(crate) vertices: [PointFx; 3],
    /// The pixels that contain the corners: for an engine that joins pixels.
    pub(crate) pixels: [Point; 3],
    pub(crate) path: Option<Path>,
}

impl Triangle {
    pub(crate) fn new(units: [Units; 3]) -> Self {
        let floats = units.map(float);
        Self {
            units,
            floats,
            whole: units.map(|u| vertex(u, 0)),
            sixteenths: units.map(|u| vertex(u, 4)),
            vertices: units.map(|u| vertex(u, 8)),
            pixels: units.map(|(x, y)| Point::new((x >> BITS) as i32, (y >> BITS) as i32)),
            path: path(&floats),
        }
    }

    /// Corners in units as they are after rounding to `f32`.
    pub(crate) fn as_floats(&self) -> [Units; 3] {
        self.floats.map(|(x, y)| ((x * ONE as f32) as i64, (y * ONE as f32) as i64))
    }

    /// Corners in units after snapping.
    pub(crate) fn snapped(&self, bits: u32) -> [Units; 3] {
        self.units.map(|u| snap(u, bits))
    }

    /// Corners in units at the centres of the pixels that contain them.
    pub(crate) fn at_centres(&self) -> [Units; 3] {
        self.pixels.map(|p| (i64::from(p.x) * ONE + ONE / 2, i64::from(p.y) * ONE + ONE / 2))
    }
}

/// A polygon of one outline, its vertices in 1/256 pixel: the same for every engine.
#[derive(Clone, Debug)]
pub(crate) struct Polygon {
    pub(crate) units: Vec<Units>,
    pub(crate) floats: Vec<(f32, f32)>,
    pub(crate) vertices: Vec<PointFx>,
    pub(crate) path: Option<Path>,
}

impl Polygon {
    pub(crate) fn new(units: Vec<Units>) -> Self {
        let units: Vec<_> = units.into_iter().map(|u| snap(u, 8)).collect();
        let floats: Vec<_> = units.iter().copied().map(float).collect();
        Self { vertices: units.iter().map(|&u| vertex(u, 8)).collect(), path: path(&floats), floats, units }
    }
}

/// A cubic Bézier curve, its points in 1/256 pixel: the same for every engine.
#[derive(Clone, Debug)]
pub(crate) struct Curve {
    pub(crate) units: [Units; 4],
    pub(crate) floats: [(f32, f32); 4],
    pub(crate) segments: [PathSegment; 2],
}

impl Curve {
    pub(crate) fn new(units: [Units; 4]) -> Self {
        let units = units.map(|u| snap(u, 8));
        let [a, c, d, b] = units.map(|u| vertex(u, 8));
        let segments = [PathSegment::MoveTo(a), PathSegment::CubicTo(c, d, b)];
        Self { units, floats: units.map(float), segments }
    }
}

/// The outline of a curve, one pixel wide.
#[derive(Clone, Debug)]
pub(crate) struct Thin {
    pub(crate) curve: Curve,
    pub(crate) path: Option<Path>,
}

impl Thin {
    pub(crate) fn new(units: [Units; 4]) -> Self {
        let curve = Curve::new(units);
        let mut path = PathBuilder::new();
        path.move_to(curve.floats[0].0, curve.floats[0].1);
        cubic_to(&mut path, curve.floats);
        Self { curve, path: path.finish() }
    }
}

fn cubic_to(path: &mut PathBuilder, [_, c, d, b]: [(f32, f32); 4]) {
    path.cubic_to(c.0, c.1, d.0, d.1, b.0, b.1);
}

/// What cubic curves enclose, each from the end of the one before.
#[derive(Clone, Debug)]
pub(crate) struct Blob {
    pub(crate) curves: Vec<Curve>,
    pub(crate) segments: Vec<PathSegment>,
    pub(crate) path: Option<Path>,
}

impl Blob {
    pub(crate) fn new(curves: Vec<Curve>) -> Self {
        let mut segments = vec![curves[0].segments[0]];
        segments.extend(curves.iter().map(|curve| curve.segments[1]));
        let mut path = PathBuilder::new();
        path.move_to(curves[0].floats[0].0, curves[0].floats[0].1);
        for curve in &curves {
            cubic_to(&mut path, curve.floats);
        }
        path.close();
        Self { curves, segments, path: path.finish() }
    }
}

/// Lines with a width, from the centre of each pixel to that of the next. Ends and corners are round, or there are two
/// pixels and nothing beyond them.
#[derive(Clone, Debug)]
pub(crate) struct Thick {
    pub(crate) pixels: Vec<Point>,
    pub(crate) vertices: Vec<PointFx>,
    pub(crate) width: u16,
    pub(crate) round: bool,
    pub(crate) path: Option<Path>,
}

impl Thick {
    pub(crate) fn new(pixels: Vec<Point>, width: u16, round: bool) -> Self {
        let mut path = PathBuilder::new();
        for (i, p) in pixels.iter().enumerate() {
            let (x, y) = (p.x as f32 + 0.5, p.y as f32 + 0.5);
            if i == 0 {
                path.move_to(x, y);
            } else {
                path.line_to(x, y);
            }
        }
        let vertices = pixels.iter().map(|&p| PointFx::centre_of(p)).collect();
        Self { pixels, vertices, width, round, path: path.finish() }
    }
}

/// An ellipse in a box of pixels.
#[derive(Clone, Debug)]
pub(crate) struct Oval {
    pub(crate) area: Rect,
    pub(crate) path: Option<Path>,
}

impl Oval {
    pub(crate) fn new(area: Rect) -> Self {
        let path = tiny_skia::Rect::from_ltrb(area.x0 as f32, area.y0 as f32, area.x1 as f32, area.y1 as f32)
            .and_then(PathBuilder::from_oval);
        Self { area, path }
    }
}

/// A picture of walls, and where a fill starts.
#[derive(Clone, Debug)]
pub(crate) struct Pool {
    pub(crate) walls: Vec<bool>,
    /// The same, eight to a byte.
    pub(crate) bits: Vec<u8>,
    pub(crate) seed: Point,
}

impl Pool {
    pub(crate) fn new(walls: Vec<bool>, seed: Point) -> Self {
        let byte = |walls: &[bool]| walls.iter().fold(0, |byte, &wall| byte << 1 | u8::from(wall));
        Self { bits: walls.chunks(8).map(byte).collect(), walls, seed }
    }
}

/// Columns and rows of the picture of the blits.
pub(crate) const SPRITE: i32 = 64;

/// What memory is filled with otherwise than by shapes at 16 bits.
#[derive(Clone, Debug)]
pub(crate) enum Job {
    /// At one bit per pixel.
    BitLine(Line),
    BitRectangle(Rect),
    BitTriangle(Triangle),
    /// A picture with its top left pixel here, its holes black.
    Blit(Point),
    /// The same, its holes transparent.
    BlitKeyed(Point),
    /// A label with its background, drawn by embedded-graphics on whatever target; only the letters count as pixels.
    Text(Point),
    /// The same label, drawn by this crate as masks of one bit.
    Glyphs(Point),
}

impl Job {
    /// Whether the picture has ink in this place: a ring.
    pub(crate) const fn sprite_has(x: i32, y: i32) -> bool {
        let (dx, dy) = (2 * x + 1 - SPRITE, 2 * y + 1 - SPRITE);
        let distance = dx * dx + dy * dy;
        distance < SPRITE * SPRITE && 4 * distance > SPRITE * SPRITE
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn snapping_goes_to_the_nearest() {
        assert_eq!(snap((ONE + ONE / 2 - 1, -ONE / 2 - 1), 0), (ONE, -ONE));
        assert_eq!(snap((ONE / 16 + 5, -5), 4), (ONE / 16, 0));
        assert_eq!(snap((12_345, -77), BITS), (12_345, -77));
    }

    #[test]
    fn floats_are_exact_on_the_screen() {
        let corners = [(320 * ONE - 1, 1), (7, 240 * ONE - 1), (-12_345, 5 * ONE + 1)];
        assert_eq!(Triangle::new(corners).as_floats(), corners);
    }
}
