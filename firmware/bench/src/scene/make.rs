//! How the shapes of the scene are made, and how large they are.

use core::array::from_fn;

use embedded_graphics::geometry::{OriginDimensions, Point, Size};
use embedded_graphics::pixelcolor::BinaryColor;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;

use super::{Flooded, Ink, Label, Lcg, Rect, Segment, Triangle, Units, HEIGHT, WIDTH};

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
    let Ok(()) = crate::eg::text(&mut counter, labels, on);
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

/// A region to flood; rectangles overlap in one pixel, at corners.
pub(super) fn flood(shapes: &[Rect], round: bool) -> Flooded<'_> {
    let first = shapes[0].area;
    let (seed, pixels) = if round {
        (first.center(), disc_pixels(&shapes[0]))
    } else {
        let areas: u32 = shapes.iter().map(|r| r.area.size.width * r.area.size.height).sum();
        (first.top_left, areas - shapes.len() as u32 + 1)
    };
    Flooded { shapes, round, seed, inks: [Ink(0x0861), INK, Ink(0x5A9D)], pixels }
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
