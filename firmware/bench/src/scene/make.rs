//! How the shapes of the scene are made, and how large they are.

use core::array::from_fn;

use embedded_graphics::geometry::{OriginDimensions, Point, Size};
use embedded_graphics::pixelcolor::BinaryColor;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;

use super::{Blob, Curve, Flooded, Ink, Label, Lcg, Rect, Segment, Track, Triangle, Units, HEIGHT, THICK, WIDTH};

/// The colour of single shapes: its two bytes differ, so that swapped ones would show.
pub(super) const INK: Ink = Ink(0xB6D3);

const W: i32 = WIDTH as i32;
const H: i32 = HEIGHT as i32;
const CENTRE: Point = Point::new(W / 2, H / 2);

pub(super) fn rect(random: &mut Lcg, at: Point, width: u32, height: u32) -> Rect {
    Rect::new(Rectangle::new(at, Size::new(width, height)), random.ink())
}

/// Rectangles of one size anywhere in the frame.
pub(super) fn rects<const N: usize>(random: &mut Lcg, width: i32, height: i32) -> [Rect; N] {
    from_fn(|_| {
        let at = Point::new(random.between(0, W - width + 1), random.between(0, H - height + 1));
        rect(random, at, width as u32, height as u32)
    })
}

/// Lines through the centre, from points spread evenly along the border: every slope, both ways.
pub(super) fn long_lines<const N: usize>(random: &mut Lcg) -> [Segment; N] {
    let border = 2 * (W - 1) + 2 * (H - 1);
    from_fn(|i| {
        let from = on_border(i as i32 * border / N as i32);
        Segment { ends: [from, Point::new(W - 1, H - 1) - from], ink: random.ink() }
    })
}

/// The pixel that is reached after `steps` along the border, clockwise from the top left.
fn on_border(steps: i32) -> Point {
    let (right, bottom) = (W - 1, H - 1);
    match steps {
        s if s < right => Point::new(s, 0),
        s if s < right + bottom => Point::new(right, s - right),
        s if s < 2 * right + bottom => Point::new(2 * right + bottom - s, bottom),
        s => Point::new(0, 2 * (right + bottom) - s),
    }
}

/// Lines of exactly 12 pixels, in all eight octants.
pub(super) fn short_lines<const N: usize>(random: &mut Lcg) -> [Segment; N] {
    from_fn(|i| {
        let from = Point::new(random.between(11, W - 11), random.between(11, H - 11));
        let major = if i & 1 == 0 { 11 } else { -11 };
        let minor = random.between(-11, 12);
        let step = if i & 2 == 0 { Point::new(major, minor) } else { Point::new(minor, major) };
        Segment { ends: [from, from + step], ink: random.ink() }
    })
}

pub(super) fn triangle(random: &mut Lcg, corners: [(i32, i32); 3]) -> Triangle {
    let (px, units) = both(corners.map(Point::from));
    Triangle { px, units, ink: random.ink() }
}

/// Triangles of 28.5 to 30 pixels in a box of 13, any shape and winding that this leaves.
pub(super) fn small_triangles<const N: usize>(random: &mut Lcg) -> [Triangle; N] {
    const BOX: i32 = 13;
    from_fn(|_| loop {
        let (x, y) = (random.between(0, W - BOX), random.between(0, H - BOX));
        let mut corner = || (x + random.between(0, BOX), y + random.between(0, BOX));
        let corners = [corner(), corner(), corner()];
        if (57..=60).contains(&twice_area(&corners.map(Point::from))) {
            return triangle(random, corners);
        }
    })
}

/// Needles 200 pixels long, 2 wide at one end, through the centre of the frame in all directions.
pub(super) fn slivers<const N: usize>(random: &mut Lcg) -> [Triangle; N] {
    let mut directions = circle(N as i32);
    from_fn(|_| {
        let way = directions.next().unwrap_or_default();
        let tip = CENTRE + scaled(way, 100);
        let base = CENTRE - scaled(way, 100);
        let side = base + scaled((-way.1, way.0), 2);
        triangle(random, [tip.into(), base.into(), side.into()])
    })
}

/// A pentagram's outline, of 14,500 pixels.
pub(super) fn star() -> [Point; 10] {
    // The inner radius is the outer one divided by the golden ratio squared.
    let mut radius = [114, 43].into_iter().cycle();
    let mut directions = circle(10);
    from_fn(|_| {
        let (x, y) = directions.next().unwrap_or_default();
        CENTRE + scaled((y, -x), radius.next().unwrap_or_default())
    })
}

/// A circle with a rough edge, of 21,000 pixels.
pub(super) fn outline<const N: usize>(random: &mut Lcg) -> [Point; N] {
    let mut directions = circle(N as i32);
    from_fn(|_| CENTRE + scaled(directions.next().unwrap_or_default(), random.between(74, 91)))
}

/// One in the unit vectors of `circle`.
const ONE: i64 = 1 << 30;

/// `n` unit vectors around the circle: a rotation applied again and again, which 30 fractional bits
/// carry far enough. `n` is one of those that the scene needs.
fn circle(n: i32) -> impl Iterator<Item = (i64, i64)> {
    // Cosine and sine of a turn divided by n.
    let (cos, sin) = match n {
        8 => (759_250_125, 759_250_125),
        10 => (868_675_383, 631_129_609),
        32 => (1_053_110_176, 209_476_638),
        200 => (1_073_211_997, 33_727_046),
        _ => (ONE, 0),
    };
    let turned = move |&(x, y): &(i64, i64)| {
        let rounded = |product: i64| (product + ONE / 2) >> 30;
        Some((rounded(x * cos - y * sin), rounded(x * sin + y * cos)))
    };
    core::iter::successors(Some((ONE, 0)), turned).take(n as usize)
}

/// A vector of this length, to the nearest pixel.
fn scaled((x, y): (i64, i64), length: i32) -> Point {
    let rounded = |part: i64| ((part * i64::from(length) + ONE / 2) >> 30) as i32;
    Point::new(rounded(x), rounded(y))
}

/// Places for a picture of 64 pixels square, all at odd x.
pub(super) fn odd_places<const N: usize>(random: &mut Lcg) -> [Point; N] {
    from_fn(|_| Point::new(random.between(0, (W - 64) / 2) * 2 + 1, random.between(0, H - 63)))
}

/// Lines of 40 letters over the frame.
pub(super) fn labels<const N: usize>(random: &mut Lcg, opaque: bool) -> [Label<'static>; N] {
    const TEXTS: [&str; 2] = ["The quick brown fox jumps over the dog. ", "0123456789 (~!@#$%^&*) ABCDEFGHIJKLMNOPQ"];
    from_fn(|i| Label {
        text: TEXTS[i % TEXTS.len()],
        at: Point::new(random.between(0, W - 240), 12 + 14 * i as i32),
        ink: random.ink(),
        paper: opaque.then(|| random.ink()),
    })
}

/// Corners as pixels and as units.
pub(super) fn both<const N: usize>(px: [Point; N]) -> ([Point; N], [Units; N]) {
    (px, px.map(|p| [p.x * 256 + 128, p.y * 256 + 128]))
}

/// Pixels of a line.
pub(super) fn length([from, to]: [Point; 2]) -> u32 {
    let step = to - from;
    step.x.unsigned_abs().max(step.y.unsigned_abs()) + 1
}

/// Twice the area of a simple polygon.
pub(super) fn twice_area(corners: &[Point]) -> u32 {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(a, b)| a.x * b.y - b.x * a.y).sum::<i32>().unsigned_abs()
}

/// Pixels that embedded-graphics sets for this text.
pub(super) fn text_pixels(labels: &[Label<'_>]) -> u32 {
    let mut counter = Counter(0);
    let on = |_: Ink| BinaryColor::On;
    let Ok(()) = super::text(&mut counter, labels, on);
    counter.0
}

/// Radius of the corners of rounded rectangles.
pub(crate) const CORNER: u32 = 16;

/// Pixels whose centres lie in a circle of this diameter.
fn in_circle(diameter: u32) -> u32 {
    let d = diameter as i32;
    let inside = |x: i32, y: i32| (2 * x + 1 - d).pow(2) + (2 * y + 1 - d).pow(2) <= d * d;
    (0..d).map(|y| (0..d).filter(|&x| inside(x, y)).count() as u32).sum()
}

pub(super) fn disc_pixels(disc: &Rect) -> u32 {
    in_circle(disc.area.size.width)
}

/// Of an outline through the outermost pixels: each column and each row of an eighth has one.
pub(super) fn circle_pixels(disc: &Rect) -> u32 {
    // 4 sqrt(2) r, to the nearest pixel.
    (disc.area.size.width - 1) * 2_828_427 / 1_000_000
}

pub(super) fn rounded_pixels(rect: &Rect) -> u32 {
    let size = rect.area.size;
    size.width * size.height - 4 * CORNER * CORNER + in_circle(2 * CORNER)
}

/// Rectangles of a spiral corridor.
pub(super) const MAZE: usize = 118;

/// A corridor one pixel wide, with walls as wide, from the top left corner inwards.
pub(super) fn spiral(random: &mut Lcg) -> [Rect; MAZE] {
    let (mut left, mut top, mut right, mut bottom) = (1, 1, W - 3, H - 3);
    let ink = random.ink();
    from_fn(|i| {
        // Each arm goes on where the last one ended.
        let (a, b) = match i % 4 {
            0 => ((left - if i == 0 { 0 } else { 2 }, top), (right, top)),
            1 => ((right, top), (right, bottom)),
            2 => ((left, bottom), (right, bottom)),
            _ => ((left, top + 2), (left, bottom)),
        };
        if i % 4 == 3 {
            (left, top, right, bottom) = (left + 2, top + 2, right - 2, bottom - 2);
        }
        let size = Size::new((b.0 - a.0 + 1) as u32, (b.1 - a.1 + 1) as u32);
        Rect::new(Rectangle::new(a.into(), size), ink)
    })
}

/// Corridors and doors of [`halls`].
pub(super) const HALLS: usize = 45;

/// Corridors nine pixels wide, one below the other, with walls of one pixel and a door at alternate ends: what is flooded in a
/// window with frames, or in a drawing, is more like this than like a corridor of one pixel.
pub(super) fn halls(random: &mut Lcg) -> [Rect; HALLS] {
    const WIDE: u32 = 9;
    let ink = random.ink();
    from_fn(|i| {
        let (hall, is_door) = (i as i32 / 2, i % 2 == 1);
        let top = 1 + hall * (WIDE as i32 + 1);
        let (at, size) = if is_door {
            let x = if hall % 2 == 0 { W - 2 - WIDE as i32 } else { 1 };
            (Point::new(x, top + WIDE as i32), Size::new(WIDE, 1))
        } else {
            (Point::new(1, top), Size::new(WIDTH as u32 - 2, WIDE))
        };
        Rect::new(Rectangle::new(at, size), ink)
    })
}

/// A region to flood. Rectangles overlap, if at all, with the one before.
pub(super) fn flood(shapes: &[Rect], round: bool) -> Flooded<'_> {
    let first = shapes[0].area;
    let (seed, pixels) = if round {
        (first.center(), disc_pixels(&shapes[0]))
    } else {
        let area = |r: &Rectangle| r.size.width * r.size.height;
        let areas: u32 = shapes.iter().map(|r| area(&r.area)).sum();
        let twice: u32 = shapes.windows(2).map(|two| area(&two[0].area.intersection(&two[1].area))).sum();
        (first.top_left, areas - twice)
    };
    Flooded { shapes, round, seed, inks: [Ink(0x0861), INK, Ink(0x5A9D)], pixels }
}

/// The centre of a pixel.
fn centre(p: Point) -> Units {
    [p.x * 256 + 128, p.y * 256 + 128]
}

/// A pixel anywhere in the frame, not so near to the border.
fn inner(random: &mut Lcg) -> Point {
    Point::new(random.between(8, W - 8), random.between(8, H - 8))
}

/// Cubic curves whose points lie anywhere in the frame.
pub(super) fn curves<const N: usize>(random: &mut Lcg) -> [Curve; N] {
    from_fn(|_| Curve { units: from_fn(|_| centre(inner(random))), ink: random.ink() })
}

/// Around the centre; every second corner is further in.
pub(super) fn blob() -> [[Units; 4]; Blob::CURVES] {
    let mut directions = circle(Blob::CURVES as i32);
    let ways: [(i64, i64); Blob::CURVES] = from_fn(|_| directions.next().unwrap_or_default());
    let corner = |i: usize| {
        let (x, y) = ways[i % Blob::CURVES];
        let radius = if i % 2 == 0 { 110 } else { 80 };
        // Where the corner is, and how the curve goes on from there: around the centre.
        (CENTRE + scaled((x, y), radius), scaled((-y, x), radius / 4))
    };
    from_fn(|i| {
        let ((a, out), (b, back)) = (corner(i), corner(i + 1));
        [a, a + out, b - back, b].map(centre)
    })
}

/// Lines between pixels anywhere.
pub(super) fn thick_lines<const N: usize>(random: &mut Lcg) -> [Segment; N] {
    from_fn(|_| Segment { ends: [inner(random), inner(random)], ink: random.ink() })
}

/// To and fro, from the left to the right.
pub(super) fn track(random: &mut Lcg) -> [Units; Track::PLACES] {
    from_fn(|i| {
        let y = if i % 2 == 0 { random.between(10, 90) } else { random.between(150, H - 10) };
        centre(Point::new(15 + 26 * i as i32, y))
    })
}

/// A curve at `t / 64`, in units.
fn curve_at(points: &[Units; 4], t: i64) -> [i64; 2] {
    let s = 64 - t;
    let weights = [s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t];
    let sum = |axis: usize| points.iter().zip(weights).map(|(p, w)| i64::from(p[axis]) * w).sum::<i64>() >> 18;
    [sum(0), sum(1)]
}

/// Of a line along a curve, in 64 pieces: steps along the longer axis.
pub(super) fn curve_pixels(points: &[Units; 4]) -> u32 {
    let step = |t: i64| {
        let (a, b) = (curve_at(points, t), curve_at(points, t + 1));
        (b[0] - a[0]).abs().max((b[1] - a[1]).abs())
    };
    ((0..64).map(step).sum::<i64>() / 256) as u32 + 1
}

/// The area, each curve being 64 lines.
pub(super) fn blob_pixels(curves: &[[Units; 4]]) -> u32 {
    let twice = |curve: &[Units; 4]| {
        let cross = |t: i64| {
            let (a, b) = (curve_at(curve, t), curve_at(curve, t + 1));
            a[0] * b[1] - b[0] * a[1]
        };
        (0..64).map(cross).sum::<i64>()
    };
    (curves.iter().map(twice).sum::<i64>().unsigned_abs() >> 17) as u32
}

/// Its area.
pub(super) fn thick_pixels([from, to]: [Point; 2]) -> u32 {
    let [a, b] = [centre(from), centre(to)];
    side(a, b) * THICK / 256
}

/// The areas of its lines, without the gaps.
pub(super) fn track_pixels(track: &Track<'_>) -> u32 {
    let length: u32 = track.units.windows(2).map(|ends| side(ends[0], ends[1])).sum();
    let area = length * u32::from(track.width) / 256;
    track.dashes.map_or(area, |[on, off]| area * u32::from(on) / u32::from(on + off))
}

/// Its length in units.
fn side(a: Units, b: Units) -> u32 {
    let square = |axis: usize| i64::from(a[axis] - b[axis]).pow(2) as u64;
    (square(0) + square(1)).isqrt() as u32
}

/// A frame that only counts.
struct Counter(u32);

impl OriginDimensions for Counter {
    fn size(&self) -> Size {
        Size::new(WIDTH as u32, HEIGHT as u32)
    }
}

impl DrawTarget for Counter {
    type Color = BinaryColor;
    type Error = core::convert::Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Self::Error>
    where
        I: IntoIterator<Item = Pixel<Self::Color>>,
    {
        self.0 += pixels.into_iter().count() as u32;
        Ok(())
    }
}
