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
//! Where an end of the line goes through a pixel, of which there are at most four at each end, the line is the difference of quarters of
//! the plane, one at each of its corners: [`Band::quarter`] says what one of them covers of a pixel, in a closed form too.
//!
//! **How exact.** Distances are sums of steps of `2^-44` pixel, and no sum depends on where the window is. They are rounded to `2^-16`
//! pixel, areas are off by less than `2^-14` pixel, and levels are rounded once more: at most 0.51 off the true one.
//!
//! **Work.** A look at each pixel that is touched and at one or two beside it in each row; to find the first one, as many steps as the
//! rows and the columns of the window have bits.

use core::num::NonZeroU32;

use super::strip::{level_of, AREA_BITS};
use crate::{
    geom::{bits, PointFx},
    num::{
        cast::{index, low_u32, narrow, signed, signed_wide, unsigned},
        recip::inverse_root_wide,
        wide::product,
    },
    span::{ClippedSpan, Rect, Sink},
    tune::{keep_rolled, COMPACT},
};

/// The most levels that are told in one call. One at a time is smaller.
const CHUNK: usize = if COMPACT { 1 } else { 32 };

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
        if x | y == 0 {
            return None;
        }
        // With 32 bits in the larger one. Halved, the sum of the squares is at least 2^60 and below 2^63.
        let up = (x | y).leading_zeros() & 31;
        let (x, y) = (x << up, y << up);
        let square = product(x >> 1, x >> 1).wrapping_add(product(y >> 1, y >> 1));
        // 1 / length is `root 2^(shift / 2 - 63)`, with a shift of 0 or 2. It may be off by `2^-29` of itself, for the sine and for the
        // cosine alike: so the direction is exact.
        let (root, shift) = inverse_root_wide(square);
        let root = if shift == 0 { root >> 1 } else { root };
        let [cos, sin] = [x, y].map(|n| product(n, root).wrapping_add(1 << 17) >> 18);
        let band = Band::new([cos, sin].map(|n| low_u32(n.wrapping_add(1 << 27) >> 28)), a.0 <= b.0);
        let (cos, sin) = (signed_wide(cos), signed_wide(sin));
        let cos = if a.0 <= b.0 { cos } else { cos.wrapping_neg() };
        Some(Self { a, b, cos, sin, band })
    }

    /// How far the centre of a pixel lies beside the line, on the left positive, in `2^-52` pixel. Of what is far away the highest bits are
    /// lost.
    #[inline(always)]
    fn beside(&self, pixel: Place) -> i64 {
        let (right, down) = way(self.a, pixel);
        self.cos.wrapping_mul(down).wrapping_sub(self.sin.wrapping_mul(right))
    }

    /// The same in `2^-38` pixel, which no place is too far away for.
    #[inline(never)]
    fn about_beside(&self, pixel: Place) -> i64 {
        let (right, down) = way(self.a, pixel);
        (self.cos >> 14).wrapping_mul(down).wrapping_sub((self.sin >> 14).wrapping_mul(right))
    }

    /// The first pixel to look at in a window, and the box of all that may be touched there. `None` if the line is not seen.
    ///
    /// The pixel is at most three pixels beside the line, in the first row that the line touches or above it, and it is the first one that it
    /// touches there or lies left of that.
    fn first(&self, window: Rect) -> Option<(Place, [Place; 2])> {
        // A pixel whose centre is more than 1.21 pixels beside the line is not touched.
        const NEAR: i64 = 3 << 37;
        let (a, b) = (self.a, self.b);
        let (x0, x1) = (near(a.0.min(b.0)).0.max(window.x0), near(a.0.max(b.0)).1.min(window.x1.saturating_sub(1)));
        let (y0, y1) = (near(a.1).0.max(window.y0), near(b.1).1.min(window.y1.saturating_sub(1)));
        if x0 > x1 || y0 > y1 {
            return None;
        }
        // Further down the line lies further right, or left. In the first row that it is seen in, the pixels on the other side of the window
        // are left of it, or right of it.
        let before =
            if self.cos >= 0 { self.about_beside((x0, y0)).wrapping_neg() } else { self.about_beside((x1, y0)) };
        let steps = |before: i64, part: i64, from: i32, to: i32| {
            let most = unsigned(to.wrapping_sub(from));
            from.wrapping_add_unsigned(steps_until(before.wrapping_sub(NEAR), part >> 14 << 8, most))
        };
        let y = steps(before, signed_wide(self.cos.unsigned_abs()), y0, y1);
        let x = steps(self.about_beside((x0, y)), self.sin, x0, x1);
        (self.about_beside((x, y)).unsigned_abs() < NEAR.unsigned_abs() << 1).then_some(((x, y), [(x0, y0), (x1, y1)]))
    }

    #[inline(always)]
    fn tell(&self, window: Rect, sink: &mut impl Sink) {
        let Some(((mut x, mut y), [(first_x, _), (last_x, last_y)])) = self.first(window) else { return };
        let (mut beside, right, down) = (self.beside((x, y)), self.sin << 8, self.cos << 8);
        let reach = self.band.reach();
        // Up to the first of these, and from the second one on, the line may end in a pixel.
        let rows = (near(self.a.1).1, near(self.b.1).0);
        let columns = (near(self.a.0.min(self.b.0)).1, near(self.a.0.max(self.b.0)).0);
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
            let meets_end = y <= rows.0 || y >= rows.1;
            let columns = if meets_end { columns } else { (i32::MIN, i32::MAX) };
            let (mut at, mut d) = (x, beside);
            loop {
                let most = index(last_x.wrapping_sub(at).wrapping_add(1));
                let len = if COMPACT || meets_end {
                    self.levels_at_end((at, y), d, columns, most, &mut levels)
                } else {
                    self.levels(d, most, &mut levels, |_, d| self.band.area(d))
                };
                at = at.wrapping_add_unsigned(low_u32(len as u64));
                self.tell_some(levels.get(..len).unwrap_or_default(), (at, y), sink);
                if len < CHUNK {
                    break;
                }
                d = d.wrapping_sub(right << CHUNK.trailing_zeros());
            }
            // Where a row has no pixel, the line goes on below, or beside the window.
            let is_gone = at == x && if down >= 0 { x > last_x } else { short(beside) <= reach.wrapping_neg() };
            if is_gone || y == last_y {
                return;
            }
            (y, beside) = (y.wrapping_add(1), beside.wrapping_add(down));
        }
    }

    /// The levels of pixels that are touched, from one on that lies so far beside the line: `most` of them if there are so many. Returns how
    /// many there are.
    #[inline(always)]
    fn levels(&self, mut d: i64, most: usize, levels: &mut [u8; CHUNK], area: impl Fn(usize, i32) -> u32) -> usize {
        let (beyond, right) = (self.band.reach().wrapping_neg(), self.sin << 8);
        let Some(levels) = levels.get_mut(..most.min(CHUNK)) else { return 0 };
        let all = levels.len();
        let mut left = levels.iter_mut();
        while short(d) > beyond {
            keep_rolled(true);
            let len = all.wrapping_sub(left.len());
            let Some(level) = left.next() else { return all };
            *level = level_of(area(len, short(d)));
            d = d.wrapping_sub(right);
        }
        all.wrapping_sub(left.len())
    }

    /// The same of a row in which the line may end: in columns up to the first one of two, and from the second one on.
    #[cfg_attr(not(embedded_raster_compact), inline(never))]
    #[cfg_attr(embedded_raster_compact, inline(always))]
    fn levels_at_end(
        &self,
        (at, y): Place,
        d: i64,
        columns: (i32, i32),
        most: usize,
        levels: &mut [u8; CHUNK],
    ) -> usize {
        self.levels(d, most, levels, |i, d| {
            let x = at.wrapping_add_unsigned(low_u32(i as u64));
            if x <= columns.0 || x >= columns.1 {
                self.area_at_end((x, y), d)
            } else {
                self.band.area(d)
            }
        })
    }

    /// Tells the levels of the pixels before a pixel. The line may cover less than half a level of the first and of the last one.
    #[inline(always)]
    fn tell_some(&self, mut levels: &[u8], (mut end, y): Place, sink: &mut impl Sink) {
        if let (true, &[level]) = (COMPACT, levels) {
            match level {
                0 => (),
                u8::MAX => sink.span(before(levels, (end, y))),
                _ => sink.coverage(before(levels, (end, y)), levels),
            }
            return;
        }
        if !COMPACT && self.band.is_straight() {
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

    /// What the line covers of a pixel that lies so far beside it, wherever its ends are: what lies ahead of the first end, without what
    /// lies ahead of the last one, left of its right side, without what lies left of its left side.
    #[inline(never)]
    fn area_at_end(&self, pixel: Place, beside: i32) -> u32 {
        let beside = beside.wrapping_add(8) >> 4;
        let [cos, sin] = [self.cos, self.sin].map(|n| narrow(n >> 29));
        let mut area = 0_i32;
        for end in [self.b, self.a] {
            // Up to 4 pixels away; what is further lies far ahead, or behind.
            let away = |centre: i32, end: i32| (centre << 8 | 128).saturating_sub(end).clamp(-1_024, 1_024);
            let (right, down) = (away(pixel.0, end.0), away(pixel.1, end.1));
            let along = cos.wrapping_mul(right).wrapping_add(sin.wrapping_mul(down)).wrapping_add(64) >> 7;
            let [left, right] = [HALF, HALF.wrapping_neg()]
                .map(|side| self.band.quarter(side.wrapping_sub(beside), along.wrapping_neg(), cos >= 0));
            area = right.wrapping_sub(left).wrapping_sub(area);
        }
        unsigned(area.max(0))
    }
}

/// How many steps down it takes from a value to one below zero, but no more than `most`, a number below 2^25.
#[inline(never)]
fn steps_until(mut value: i64, step: i64, most: u32) -> u32 {
    let (mut steps, mut bit) = (0, 32_u32.wrapping_sub(most.leading_zeros()));
    while bit > 0 {
        bit = bit.wrapping_sub(1);
        let part = step << (bit & 31);
        if value >= part {
            (value, steps) = (value.wrapping_sub(part), steps | 1_u32 << (bit & 31));
        }
    }
    u32::from(value >= 0).wrapping_add(steps).min(most)
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
    /// Where the trapezoid would have no area left: a + b / 2 - i.
    middle: u32,
    /// 1 / (2 a b), divided by `2^shift`.
    over_ab: u32,
    shift: u32,
    /// The cosine and the sine, the other way round if the line goes to the left.
    parts: [u32; 2],
}

impl Band {
    #[inline(always)]
    fn new([cos, sin]: [u32; 2], goes_right: bool) -> Self {
        // Their sum is at least 1, and none of them above it: so i is not above b / 2.
        let (a, b) = (cos.max(sin), cos.min(sin));
        let over = |n: u32, d: u32| NonZeroU32::new(d).map_or(0, |d| n / d);
        let product = a.wrapping_mul(b);
        let zeros = product.leading_zeros();
        // At least 2^15, if b is not 0: then the quotient is at most 2^16.
        let short = product << (zeros & 31) >> 16;
        let inner = a.wrapping_add(b).wrapping_sub(1 << 16) >> 1;
        let last = a.wrapping_sub(inner);
        Self {
            inner,
            first: b.wrapping_sub(inner),
            last,
            end: last.wrapping_add(b),
            over_a: over(1 << 31, a),
            middle: last.wrapping_add(b >> 1),
            over_ab: over((1 << 31) + (short >> 1), short),
            shift: 16_u32.wrapping_sub(zeros),
            parts: if goes_right { [cos, sin] } else { [sin, cos] },
        }
    }

    /// Whether it lies so nearly along an axis that it may cover pixels as a whole.
    #[inline(always)]
    fn is_straight(&self) -> bool {
        self.parts[0].min(self.parts[1]) < 1 << 9
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
            self.middle.wrapping_sub(t).wrapping_mul(self.over_a) >> (31 - AREA_BITS)
        } else {
            let beyond = if t < self.inner { self.corner(self.inner.wrapping_sub(t)) } else { 0 };
            (1_u32 << AREA_BITS).wrapping_sub(self.corner(t.wrapping_add(self.inner))).wrapping_sub(beyond)
        }
    }

    /// How far a corner of a pixel may be from its centre, across the line or along it: (a + b) / 2.
    #[inline(always)]
    fn most(&self) -> i32 {
        signed(self.parts[0].wrapping_add(self.parts[1]) >> 1)
    }

    /// What lies beyond a straight line across a pixel, or along it, so far from its centre.
    #[inline(never)]
    fn half(&self, u: i32) -> i32 {
        let size = u.unsigned_abs();
        let [p, q] = self.parts;
        let rest = if size > p.abs_diff(q) >> 1 {
            self.corner(unsigned(self.most()).saturating_sub(size))
        } else {
            // 1/2 - u / a.
            (1_u32 << 30).wrapping_sub(size.wrapping_mul(self.over_a)) >> (31 - AREA_BITS)
        };
        signed(if u < 0 { (1_u32 << AREA_BITS).wrapping_sub(rest) } else { rest })
    }

    /// What lies beyond two of them, one u across the line and one v along it: a quarter of the plane.
    ///
    /// Let p and q be the sine and the cosine, and U half of their sum. Where the corner of the quarter lies outside of the pixel, one of the
    /// four quarters around it has nothing of the pixel, and the others are found from the two halves. Inside, the area changes by the
    /// length of a side of the quarter where that moves. From 0 at a corner of the pixel, at u = U and v = (p - q) / 2, that is
    /// ```text
    ///     (U - u) (U - v) - p q / 2 + f((p - q) / 2 + u) - f((p - q) / 2 - v)
    ///     f(z)   z^2 q / 2 p      for z >= 0
    ///           -z^2 p / 2 q      below
    /// ```
    /// for a line to the right, and with the cosine for p for one to the left.
    #[inline(never)]
    fn quarter(&self, u: i32, v: i32, goes_right: bool) -> i32 {
        let [q, p] = self.parts;
        let most = self.most();
        let [u, v] = [u, v].map(|n| n.max(most.wrapping_neg()).min(most));
        // Where the corner is, in 2^-30.
        let [cos, sin] = if goes_right { [q, p] } else { [p.wrapping_neg(), q] }.map(|n| signed(n) >> 1);
        let (x, y) = (
            cos.wrapping_mul(v >> 1).wrapping_sub(sin.wrapping_mul(u >> 1)),
            cos.wrapping_mul(u >> 1).wrapping_add(sin.wrapping_mul(v >> 1)),
        );
        let is_beside = x.unsigned_abs() >= 1 << 29;
        if is_beside || y.unsigned_abs() >= 1 << 29 {
            let (beyond_u, beyond_v) = (self.half(u), self.half(v));
            return if is_beside == goes_right {
                beyond_u.min(beyond_v)
            } else {
                beyond_u.wrapping_add(beyond_v).wrapping_sub(1 << AREA_BITS).max(0)
            };
        }
        let bend = |z: i32| {
            let part = z.unsigned_abs().wrapping_mul(if z < 0 { p } else { q }).wrapping_add(1 << 15) >> 16;
            let area = signed(self.corner(part));
            if z < 0 {
                area.wrapping_neg()
            } else {
                area
            }
        };
        let middle = signed(p.wrapping_sub(q)) >> 1;
        let box_of = product(unsigned(most.wrapping_sub(u)), unsigned(most.wrapping_sub(v))) >> (32 - AREA_BITS);
        let bends = bend(middle.wrapping_add(u)).wrapping_sub(bend(middle.wrapping_sub(v)));
        signed(low_u32(box_of)).wrapping_sub(signed(p.wrapping_mul(q) >> (33 - AREA_BITS))).wrapping_add(bends)
    }
}

/// Half a pixel.
const HALF: i32 = 1 << 15;
