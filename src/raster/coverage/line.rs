//! Lines one pixel wide, with soft rims.
//!
//! The line from a to b is the rectangle one pixel wide around it, cut off at right angles at a and at b. What it covers of the pixels
//! across it adds up to a pixel at any angle, and it is as bright at one angle as at another.
//!
//! **How.** What a band of parallel sides covers of a pixel depends on one number, how far the pixel's centre is from the middle of the
//! band. A step along a row, or to the next one, changes that number by the sine or the cosine of the line's direction. So there
//! are no sides, no cells and no division: [`Band`] makes a level of each distance.
//! ```text
//!     d           The share of a pixel beyond a side, by the distance u from where the side meets its first corner.
//!    .-+---+      With a >= b, the cosine and the sine of the direction in some order:
//!    | |###|        u in 0..b        a triangle     u^2 / (2 a b)
//!    +-+---+        u in b..a        a trapezoid    (u - b / 2) / a
//!     u             u in a..a + b    all but a triangle
//! ```
//! Where an end of the line goes through a pixel, of which there are at most four at each end, the pixel is cut by the sides and the
//! end, corner by corner.
//!
//! **How exact.** Distances are sums of steps of `2^-44` pixel, and no sum depends on where the window is. They are rounded to `2^-16`
//! pixel, areas are off by less than `2^-14` pixel, and levels are rounded once more: at most 0.51 off the true one.
//!
//! **Work.** A look at each pixel that is touched and at one or two beside it in each row; a division where the window cuts off the
//! beginning, and one for each corner of an end.

use core::num::NonZeroU32;

use super::strip::{level_of, AREA_BITS};
use crate::{
    geom::{bits, PointFx},
    num::{
        cast::{low_u32, magnitude, narrow, signed, signed_wide, unsigned},
        recip::inverse_root_wide,
        round::div_rem_wide,
    },
    span::{ClippedSpan, Rect, Sink},
    tune::{keep_rolled, COMPACT},
};

/// The most levels that are told in one call.
const CHUNK: usize = 32;

/// Tells what a line one pixel wide covers, from one place to another; nothing if they are the same.
///
/// Each pixel is told once.
pub fn line(a: PointFx, b: PointFx, window: Rect, mut sink: impl Sink) {
    let (a, b) = (bits(a), bits(b));
    let (a, b) = if (a.1, a.0) <= (b.1, b.0) { (a, b) } else { (b, a) };
    if let Some(line) = Line::new(a, b) {
        line.tell(window, &mut sink);
    }
}

/// A place in units of 1/256 pixel, or a pixel.
type Place = (i32, i32);

/// The columns, or the rows, of the pixels that lie less than half a pixel from a place along one axis: one or two.
#[inline(always)]
fn near(place: i32) -> (i32, i32) {
    (place.saturating_sub(128) >> 8, place.saturating_add(127) >> 8)
}

#[inline(always)]
fn is_in(n: i32, (first, last): (i32, i32)) -> bool {
    first <= n && n <= last
}

#[inline(always)]
fn is_near(place: Place, (x, y): Place) -> bool {
    is_in(y, near(place.1)) && is_in(x, near(place.0))
}

/// A line from its upper end to its lower one; from left to right if both lie in one row.
struct Line {
    a: Place,
    b: Place,
    /// Its direction, in `2^-44`. The sine is not negative.
    cos: i64,
    sin: i64,
    band: Band,
}

/// From a place to the centre of a pixel: to the right, and down, in units.
#[inline(always)]
fn way(from: Place, (x, y): Place) -> (i64, i64) {
    let centre = |n: i32| (i64::from(n) << 8).wrapping_add(128);
    (centre(x).wrapping_sub(from.0.into()), centre(y).wrapping_sub(from.1.into()))
}

/// The whole part of a distance in `2^-52` pixel: `2^-20` pixel.
#[inline(always)]
fn short(distance: i64) -> i32 {
    narrow(distance >> 32)
}

/// A pixel is `2^SHORT_BITS` of these.
const SHORT_BITS: u32 = 20;

impl Line {
    #[inline(always)]
    fn new(a: Place, b: Place) -> Option<Self> {
        let (x, y) = (b.0.abs_diff(a.0), b.1.abs_diff(a.1));
        // With 32 bits in the larger one. Halved, the sum of the squares is at least 2^60 and below 2^63.
        let up = (x | y).leading_zeros();
        let scaled = |n: u32| u64::from(n.checked_shl(up).unwrap_or(0));
        let (x, y) = (scaled(x), scaled(y));
        let square = (x >> 1).wrapping_mul(x >> 1).wrapping_add((y >> 1).wrapping_mul(y >> 1));
        if square == 0 {
            return None;
        }
        // 1 / length is `root 2^(shift / 2 - 63)`, with a shift of 0 or 2. It may be off by `2^-30` of itself, for the sine and for the
        // cosine alike: so the direction is exact.
        let (root, shift) = inverse_root_wide(square);
        let to_44 = 19_u32.wrapping_sub(shift >> 1) & 63;
        let part = |n: u64| n.wrapping_mul(root.into()).wrapping_add((1 << to_44) >> 1) >> to_44;
        let (cos, sin) = (part(x), part(y));
        let [large, small] = [cos.max(sin), cos.min(sin)].map(|n| low_u32(n.wrapping_add(1 << 27) >> 28));
        let (cos, sin) = (signed_wide(cos), signed_wide(sin));
        let cos = if a.0 <= b.0 { cos } else { cos.wrapping_neg() };
        Some(Self { a, b, cos, sin, band: Band::new(large, small) })
    }

    /// How far the centre of a pixel lies beside the line, on the left positive, in `2^-52` pixel. Of what is far away the highest bits are
    /// lost.
    #[inline(always)]
    fn beside(&self, pixel: Place) -> i64 {
        let (right, down) = way(self.a, pixel);
        self.cos.wrapping_mul(down).wrapping_sub(self.sin.wrapping_mul(right))
    }

    /// The first pixel to look at in a window, and the box of all that may be touched there. `None` if the line is not seen.
    ///
    /// The pixel is at most four pixels away from the line, in the first row that the line touches or above it, and the line lies as far
    /// ahead along the row as it may go: right of it if the line goes to the right.
    fn first(&self, window: Rect) -> Option<(Place, [Place; 2])> {
        let (a, b) = (self.a, self.b);
        let (x0, x1) = (near(a.0.min(b.0)).0.max(window.x0), near(a.0.max(b.0)).1.min(window.x1.saturating_sub(1)));
        let (y0, y1) = (near(a.1).0.max(window.y0), near(b.1).1.min(window.y1.saturating_sub(1)));
        if x0 > x1 || y0 > y1 {
            return None;
        }
        // Where the window cuts off the beginning: the line goes so far one way while it goes `along` the other way. Two pixels less both
        // ways is at least 1.4 pixels beside the line, and it touches no pixel whose centre is more than 1.21 away.
        let crossing = |along: i64, (to, of): (u32, u32)| {
            const MARGIN: i64 = 512;
            let along = u64::from(low_u32(magnitude(along.wrapping_sub(MARGIN).max(0))));
            let far = NonZeroU32::new(of).map_or(0, |of| div_rem_wide(along.wrapping_mul(to.into()), of).0);
            i64::from(far).wrapping_sub(MARGIN)
        };
        let pixel = |from: i32, way: i64| narrow(i64::from(from).wrapping_add(way) >> 8);
        let (wide, high) = (b.0.abs_diff(a.0), b.1.abs_diff(a.1));
        let goes_right = self.cos >= 0;
        let start = if goes_right { x0 } else { x1 };
        let (right, _) = way(a, (start, y0));
        let y = pixel(a.1, crossing(if goes_right { right } else { right.wrapping_neg() }, (high, wide))).max(y0);
        let along = crossing(way(a, (start, y)).1, (wide, high));
        let x = if goes_right { pixel(a.0, along).max(x0) } else { pixel(a.0, along.wrapping_neg()).min(x1) };
        (y <= y1 && x0 <= x && x <= x1).then_some(((x, y), [(x0, y0), (x1, y1)]))
    }

    #[inline(always)]
    fn tell(&self, window: Rect, sink: &mut impl Sink) {
        let Some(((mut x, mut y), [(first_x, _), (last_x, last_y)])) = self.first(window) else { return };
        let (mut beside, right, down) = (self.beside((x, y)), self.sin << 8, self.cos << 8);
        let reach = self.band.reach();
        let mut levels = [0; CHUNK];
        loop {
            // To the first pixel of the row.
            while x <= last_x && short(beside) >= reach {
                keep_rolled(true);
                (x, beside) = (x.wrapping_add(1), beside.wrapping_sub(right));
            }
            while x > first_x && short(beside.wrapping_add(right)) < reach {
                keep_rolled(true);
                (x, beside) = (x.wrapping_sub(1), beside.wrapping_add(right));
            }
            let meets_end = is_in(y, near(self.a.1)) || is_in(y, near(self.b.1));
            let (mut at, mut d, mut len) = (x, beside, CHUNK);
            while len == CHUNK {
                len = 0;
                for level in &mut levels {
                    if at > last_x || short(d) <= reach.wrapping_neg() {
                        break;
                    }
                    let ends = meets_end && (is_near(self.a, (at, y)) || is_near(self.b, (at, y)));
                    let area = if ends { self.area_at_end((at, y), short(d)) } else { self.band.area(short(d)) };
                    *level = level_of(area);
                    len = len.wrapping_add(1);
                    (at, d) = (at.wrapping_add(1), d.wrapping_sub(right));
                }
                self.tell_some(levels.get(..len).unwrap_or_default(), (at, y), sink);
            }
            // Below, it goes on beside the window.
            let is_gone = if down >= 0 { x > last_x } else { short(beside) <= reach.wrapping_neg() };
            if is_gone || y == last_y {
                return;
            }
            (y, beside) = (y.wrapping_add(1), beside.wrapping_add(down));
        }
    }

    /// Tells the levels of the pixels before a pixel. The line may cover less than half a level of the first and of the last one.
    #[inline(always)]
    fn tell_some(&self, mut levels: &[u8], (mut end, y): Place, sink: &mut impl Sink) {
        if COMPACT || self.band.is_straight {
            return tell_runs(levels, (end, y), sink);
        }
        while let Some((0, rest)) = levels.split_last() {
            keep_rolled(true);
            (levels, end) = (rest, end.wrapping_sub(1));
        }
        while let Some((0, rest)) = levels.split_first() {
            keep_rolled(true);
            levels = rest;
        }
        if !levels.is_empty() {
            sink.coverage(before(levels, (end, y)), levels);
        }
    }

    /// What the line covers of a pixel that one of its ends may go through, and that lies so far beside it: what is left of the pixel
    /// when all is cut off that lies beyond the sides and the ends.
    #[inline(never)]
    fn area_at_end(&self, pixel: Place, beside: i32) -> u32 {
        let [cos, sin] = [self.cos, self.sin].map(|n| narrow(n.wrapping_add(1 << 28) >> 29));
        let beside = beside.wrapping_add(1 << 4) >> 5;
        let mut shape = Corners { at: [(0, 0); 8], len: 0 };
        for corner in [(0, 0), (ONE, 0), (ONE, ONE), (0, ONE)] {
            shape.push(corner);
        }
        shape.cut(HALF.wrapping_add(beside), (sin.wrapping_neg(), cos));
        shape.cut(HALF.wrapping_sub(beside), (sin, cos.wrapping_neg()));
        // At most 384 units away in each direction.
        let along = |from: Place| {
            let (right, down) = way(from, pixel);
            cos.wrapping_mul(narrow(right)).wrapping_add(sin.wrapping_mul(narrow(down))).wrapping_add(128) >> 8
        };
        if is_near(self.a, pixel) {
            shape.cut(along(self.a), (cos, sin));
        }
        if is_near(self.b, pixel) {
            shape.cut(along(self.b).wrapping_neg(), (cos.wrapping_neg(), sin.wrapping_neg()));
        }
        shape.area()
    }
}

/// The pixels that have these levels, before a pixel.
#[inline(always)]
fn before(levels: &[u8], (end, y): Place) -> ClippedSpan {
    ClippedSpan::inside(y, end.wrapping_sub_unsigned(low_u32(levels.len() as u64)), end)
}

/// Tells pixels of any levels, also those that are full and those that are empty.
#[inline(never)]
fn tell_runs(levels: &[u8], end: Place, sink: &mut impl Sink) {
    before(levels, end).each_covered(levels, |run, levels| match levels {
        Some(levels) => sink.coverage(run, levels),
        None => sink.span(run),
    });
}

/// What a band one pixel wide covers of pixels, by how far t their centres are from its middle. Lengths are in `2^-16` pixel.
///
/// With i = (a + b - 1) / 2, what is beyond the side on the pixel's own side begins at u = t + i, and what is beyond the other one at
/// i - t, if that is positive.
struct Band {
    /// i.
    inner: u32,
    /// Where the triangle becomes a trapezoid: b - i.
    first: u32,
    /// Where the trapezoid becomes all but a triangle: a - i.
    last: u32,
    /// Where nothing is left: a + b - i.
    end: u32,
    /// 1 / a, in `2^-15`.
    over_a: u32,
    /// The area of the trapezoid at t = 0, in `2^-31`.
    middle: u32,
    /// 1 / (2 a b), divided by `2^shift`.
    over_ab: u32,
    shift: u32,
    /// It lies so nearly along an axis that it may cover pixels as a whole.
    is_straight: bool,
}

impl Band {
    #[inline(always)]
    fn new(a: u32, b: u32) -> Self {
        let over_a = NonZeroU32::new(a).map_or(0, |a| (1 << 31) / a);
        let product = a.wrapping_mul(b);
        let zeros = product.leading_zeros();
        // At least 2^15, if b is not 0: then the quotient is at most 2^16.
        let short = NonZeroU32::new(product.checked_shl(zeros).unwrap_or(0) >> 16);
        let over_ab = short.map_or(0, |short| ((1 << 31) + (short.get() >> 1)) / short);
        let inner = a.wrapping_add(b).saturating_sub(1 << 16) >> 1;
        // 1 - (i - b / 2) / a, where i is not above b / 2.
        let rise = (b >> 1).saturating_sub(inner).wrapping_mul(over_a);
        Self {
            inner,
            first: b.saturating_sub(inner),
            last: a.saturating_sub(inner),
            end: a.wrapping_add(b).wrapping_sub(inner),
            over_a,
            middle: (1_u32 << 31).wrapping_add(rise),
            over_ab,
            shift: 16_u32.saturating_sub(zeros),
            is_straight: b < 1 << 9,
        }
    }

    /// No pixel is touched whose centre is so far from the middle: in `2^-20` pixel.
    #[inline(always)]
    fn reach(&self) -> i32 {
        signed(self.end.wrapping_add(1) << (SHORT_BITS - 16))
    }

    /// The area of a corner that a side cuts off, so far in: at most b.
    #[inline(always)]
    fn corner(&self, x: u32) -> u32 {
        // x / (2 a b) times x: below 1 and below 1/2.
        (x.wrapping_mul(self.over_ab) >> (self.shift & 31)).wrapping_mul(x) >> (32 - AREA_BITS)
    }

    /// What it covers of a pixel whose centre is so far from its middle, in `2^-20` pixel.
    #[inline(always)]
    fn area(&self, beside: i32) -> u32 {
        let t = beside.unsigned_abs().wrapping_add(8) >> 4;
        if t > self.last {
            self.corner(self.end.saturating_sub(t))
        } else if t >= self.first {
            // Up to 1, which is 2^31.
            self.middle.wrapping_sub(t.wrapping_mul(self.over_a)) >> (31 - AREA_BITS)
        } else {
            let beyond = if t < self.inner { self.corner(self.inner.wrapping_sub(t)) } else { 0 };
            (1_u32 << AREA_BITS).wrapping_sub(self.corner(t.wrapping_add(self.inner))).wrapping_sub(beyond)
        }
    }
}

/// A pixel, in steps of its corners.
const ONE: i32 = 1 << 15;
const HALF: i32 = 1 << 14;

/// The corners of what is left of a pixel: four, and one more for each cut.
struct Corners {
    at: [Place; 8],
    len: usize,
}

impl Corners {
    #[inline(always)]
    fn push(&mut self, corner: Place) {
        if let Some(place) = self.at.get_mut(self.len) {
            *place = corner;
            self.len = self.len.wrapping_add(1);
        }
    }

    /// Cuts off what lies beyond a side: the centre of the pixel lies so far on this side of it, and that grows by the slope.
    #[inline(never)]
    fn cut(&mut self, centre: i32, slope: Place) {
        let inside = |(x, y): Place| {
            let part = |n: i32, slope: i32| n.wrapping_sub(HALF).wrapping_mul(slope);
            // Below 1.5 times 2^29.
            centre.wrapping_add(part(x, slope.0).wrapping_add(part(y, slope.1)).wrapping_add(HALF) >> 15)
        };
        let old = self.at;
        let Some(old) = old.get(..self.len) else { return };
        let Some(&(mut before)) = old.last() else { return };
        self.len = 0;
        for &corner in old {
            let (from, to) = (inside(before), inside(corner));
            if (from < 0) != (to < 0) {
                // At most 2^16 of each.
                let (part, all) = (from.unsigned_abs(), from.abs_diff(to));
                let between = |from: i32, to: i32| {
                    let way = from.abs_diff(to).wrapping_mul(part).wrapping_add(all >> 1);
                    let way = NonZeroU32::new(all).map_or(0, |all| signed(way / all));
                    if from < to {
                        from.wrapping_add(way)
                    } else {
                        from.wrapping_sub(way)
                    }
                };
                self.push((between(before.0, corner.0), between(before.1, corner.1)));
            }
            if to >= 0 {
                self.push(corner);
            }
            before = corner;
        }
    }

    /// The area of what is left.
    fn area(&self) -> u32 {
        let Some(corners) = self.at.get(..self.len) else { return 0 };
        let Some(&(mut before)) = corners.last() else { return 0 };
        // Twice the area is 2^31 at most; what is between may be any number.
        let mut twice = 0_u32;
        for &corner in corners {
            let product = |x: i32, y: i32| unsigned(x.wrapping_mul(y));
            twice = twice.wrapping_add(product(before.0, corner.1)).wrapping_sub(product(corner.0, before.1));
            before = corner;
        }
        twice >> (31 - AREA_BITS)
    }
}
