//! [`pack`]: a path as the bytes that `embedded_raster::geom::packed` reads.

use embedded_raster::{PathSegment, PointFx};

/// A place in units.
type Place = (i64, i64);

/// Packs a path into the fewest bits behind the point with which no place is farther off than `tolerance`, along x or along y, in
/// units of 1/256 pixel.
///
/// # Errors
/// If two places that follow each other are farther apart than a packed path can say, which is half of the plane.
pub fn pack(path: impl IntoIterator<Item = PathSegment>, tolerance: u32) -> Result<Vec<u8>, String> {
    let segments: Vec<PathSegment> = path.into_iter().collect();
    let fits = |shift: u32| {
        let off = |n: i64| (round(n, shift) << shift).abs_diff(n);
        segments.iter().flat_map(places).all(|at| off(at.0).max(off(at.1)) <= u64::from(tolerance))
    };
    let shift = (0..=8).rev().find(|&shift| fits(shift)).unwrap_or(0);
    Packer::new(shift, tolerance).pack(&segments).ok_or_else(|| "places are too far apart".into())
}

/// The nearest multiple of `2^shift`, as a number of these.
fn round(n: i64, shift: u32) -> i64 {
    (n + (1 << shift >> 1)) >> shift
}

fn units(at: PointFx) -> Place {
    (at.x.to_bits().into(), at.y.to_bits().into())
}

/// The places of a segment.
fn places(segment: &PathSegment) -> Vec<Place> {
    match *segment {
        PathSegment::MoveTo(a) | PathSegment::LineTo(a) => vec![units(a)],
        PathSegment::QuadraticTo(c, a) => vec![units(c), units(a)],
        PathSegment::CubicTo(c, d, a) => vec![units(c), units(d), units(a)],
        PathSegment::Close => vec![],
    }
}

/// The numbers of the commands.
const MOVE: u8 = 1;
const LINE: u8 = 2;
const HORIZONTAL: u8 = 3;
const VERTICAL: u8 = 4;
const QUADRATIC: u8 = 5;
const CUBIC: u8 = 6;
const SMOOTH: u8 = 7;

struct Packer {
    bytes: Vec<u8>,
    shift: u32,
    tolerance: i64,
    at: Place,
    start: Place,
    /// The control point of a cubic curve that goes on smoothly.
    control: Place,
}

impl Packer {
    fn new(shift: u32, tolerance: u32) -> Self {
        let bytes = vec![u8::try_from(8 - shift).unwrap_or(0)];
        Self { bytes, shift, tolerance: tolerance.into(), at: (0, 0), start: (0, 0), control: (0, 0) }
    }

    fn pack(mut self, segments: &[PathSegment]) -> Option<Vec<u8>> {
        if !matches!(segments.first(), None | Some(PathSegment::MoveTo(_))) {
            // A path that does not begin with a move begins at (0, 0).
            self.put(MOVE, &[0, 0])?;
        }
        for segment in segments {
            self.segment(segment)?;
        }
        Some(self.bytes)
    }

    fn segment(&mut self, segment: &PathSegment) -> Option<()> {
        let exact = places(segment);
        let rounded: Vec<Place> = exact.iter().map(|at| (round(at.0, self.shift), round(at.1, self.shift))).collect();
        let (from, mirrored) = (self.at, self.control);
        let to = rounded.last().copied().unwrap_or(self.start);
        (self.at, self.control) = (to, to);
        match *segment {
            PathSegment::Close => self.bytes.push(0),
            PathSegment::MoveTo(_) => {
                self.start = to;
                self.put(MOVE, &steps(from, &rounded))?;
            }
            PathSegment::LineTo(_) if to.1 == from.1 => self.put(HORIZONTAL, &[to.0 - from.0])?,
            PathSegment::LineTo(_) if to.0 == from.0 => self.put(VERTICAL, &[to.1 - from.1])?,
            PathSegment::LineTo(_) => self.put(LINE, &steps(from, &rounded))?,
            PathSegment::QuadraticTo(..) => self.put(QUADRATIC, &steps(from, &rounded))?,
            PathSegment::CubicTo(..) => {
                let last = rounded[1];
                self.control = (2 * to.0 - last.0, 2 * to.1 - last.1);
                let off = |mirrored: i64, exact: i64| ((mirrored << self.shift) - exact).abs();
                if off(mirrored.0, exact[0].0).max(off(mirrored.1, exact[0].1)) <= self.tolerance {
                    self.put(SMOOTH, &steps(mirrored, &rounded[1..]))?;
                } else {
                    self.put(CUBIC, &steps(from, &rounded))?;
                }
            }
        }
        Some(())
    }

    /// A command and its numbers, each with as many bits as the longest needs.
    fn put(&mut self, command: u8, numbers: &[i64]) -> Option<()> {
        let bits = |n: &i64| 65 - (n ^ (n >> 63)).leading_zeros();
        let width = numbers.iter().map(bits).max().unwrap_or(1);
        if width > 32 {
            return None;
        }
        self.bytes.push(command << 5 | u8::try_from(width - 1).ok()?);
        let mut text: Vec<bool> =
            numbers.iter().flat_map(|&n| (0..width).rev().map(move |i| n >> i & 1 != 0)).collect();
        text.resize(text.len().next_multiple_of(8), false);
        self.bytes.extend(text.chunks(8).map(|bits| bits.iter().fold(0, |byte, &bit| byte << 1 | u8::from(bit))));
        Some(())
    }
}

/// How far each place is from the one before it.
fn steps(from: Place, places: &[Place]) -> Vec<i64> {
    let before = std::iter::once(&from).chain(places);
    before.zip(places).flat_map(|(a, b)| [b.0 - a.0, b.1 - a.1]).collect()
}
