//! Circles and ellipses: what they cover of each pixel, from where the curve crosses the borders of that pixel.
//! ```text
//!      hi +-------------+         u, v   distances from the centre, along the row and across it
//!         |####'.       |         P      where the curve enters the pixel: at its upper border, or at its inner one
//!         |######P--.   |         Q      where it leaves it: at its lower border, or at its outer one
//!         |##########'. |         area   what lies inside of P, the trapezoid below PQ, and what the curve bulges out beyond
//!      lo +------------Q+                the chord PQ
//!        u_in         u_out
//! ```
//! **How exact.** Where the curve crosses a border is rounded down to 1/4096 pixel. The bulge is that of the ellipse, a segment of it,
//! to 3 %. So a level is at most 0.9/255 off the true one of a circle, 1.6/255 off that of an ellipse or of a radius below 4 pixels.
//! Beyond radii of 2^18 pixels, steps are coarser, so that radii stay below 2^30 of them: levels are at most 2.5/255 off up to radii of
//! 2^22 pixels, and 4.5/255 up to 2^23, the end of the type. Boxes of pixels may be larger than that: then the curve is off by up to a
//! step, which is `2^-30` of the radius.
//!
//! **Why a pixel needs nothing but its borders.** A row below the middle, or above it, holds pieces of the curve that only rise, or only
//! fall. Each is one chord a pixel. The row of the centre is two such pieces, each with a part of the row's height; the column of the
//! centre has one on each side. Nothing is carried along a row or to the next one, so a window, a band or a strip changes nothing, and
//! there is neither a table of sides nor a cell.
//!
//! **Roots.** With a circle of radius R, the larger radius of the ellipse, u = root (R^2 - v^2) on a border. The other axis is stretched
//! to that circle and back. A root begins at a guess on the chord of its row, and Newton's step is repeated until it is right: once or
//! twice. What the guess was does not matter.
//!
//! **A segment.** Cut off by a chord that is t times the radius long, it has the area `a b t^3 / 12 (1 + 3/10 s^2 + 6/25 s^4)`, with
//! `s = t / 2`. For a quarter of an ellipse, the longest chord, that is right to 0.1 %.
//!
//! **Work.** A root for each row, and one for each border of two columns that the curve crosses.
//!
//! **A ring** is the difference of two ellipses, level by level. So it adds up with the ellipse that fills it, however thin it is.

use core::num::NonZeroU32;

use super::row::Row;
use crate::{
    num::{
        cast::{index, low_u32, low_u8, magnitude, narrow, signed, signed_wide, unsigned},
        root::square_root,
        round::div_rem_wide,
        wide::product,
    },
    raster::ellipse::Ellipse,
    span::{ClippedSpan, Rect, Sink, SoftRow},
    tune::{keep_rolled, COMPACT},
};

/// A pixel is `2^BITS` steps wide. Radii are below 2^30 steps: where they would not be, a pixel has fewer, and at least one.
const BITS: u32 = 12;

/// An area of a pixel, in squares of a step.
const FULL: u32 = 1 << (2 * BITS);

/// The most levels of a rim that are told with its row.
const CHUNK: usize = 32;

/// Tells what a circle or an ellipse covers. Where it is given by its box it touches the sides of it.
///
/// Levels of a circle are at most 0.9/255 off the true area, of any ellipse 1.6/255, up to radii of 2^18 pixels; up to 2^22 pixels
/// 2.5/255.
///
/// Work: a square root for each visible row, and for each visible border of two columns that the curve crosses.
pub fn ellipse(ellipse: Ellipse, window: Rect, mut sink: impl Sink) {
    if let Some(oval) = Oval::of(&ellipse) {
        oval.tell(window, &mut sink);
    }
}

/// The curve, in steps.
struct Oval {
    /// The pixel of the centre, and where the centre lies in it.
    centre: (i32, i32),
    inset: (i32, i32),
    /// Below 2^30, or below 2^31 where a pixel is one step.
    radii: (u32, u32),
    /// The larger one.
    circle: u32,
    /// From the shorter axis to the circle; `None` for a circle.
    stretch: Option<Stretch>,
    is_wide: bool,
    bits: u32,
    bulge: Bulge,
}

/// The ratio of two radii: R / r.
#[derive(Copy, Clone)]
struct Stretch {
    /// `up / 2^shift`, at least 1.
    up: u32,
    shift: u32,
    /// Its inverse, in `2^-32`.
    down: u32,
}

impl Stretch {
    fn new(large: u32, small: NonZeroU32) -> Option<Self> {
        let d = NonZeroU32::new(large)?;
        let shift = 31_u32.wrapping_add(large.leading_zeros()).wrapping_sub(small.leading_zeros()) & 31;
        // Quotients below 2^32: large / small is below 2 to the difference of the zeros and one.
        let up = div_rem_wide(u64::from(large) << shift, small).0;
        Some(Self { up, shift, down: div_rem_wide(u64::from(small.get()) << 32, d).0 })
    }

    fn up(self, n: u32) -> u32 {
        low_u32(product(n, self.up) >> (self.shift & 31))
    }

    fn down(self, n: u32) -> u32 {
        low_u32(product(n, self.down) >> 32)
    }
}

/// A piece of a row on one side of the axis along it, and the curve there, from its lower border to its upper one.
#[derive(Copy, Clone, Default)]
struct Piece {
    lo: u32,
    hi: u32,
    /// How far out the curve is at these heights: `x_lo >= x_hi`.
    x_lo: u32,
    x_hi: u32,
    /// The rise of the chord between, in `2^-16`.
    slope: u32,
}

impl Piece {
    fn new((lo, x_lo): (u32, u32), (hi, x_hi): (u32, u32)) -> Self {
        // Below 2^13 times 2^16.
        let rise = hi.wrapping_sub(lo) << 16;
        let slope = NonZeroU32::new(x_lo.wrapping_sub(x_hi)).map_or(0, |width| rise / width);
        Self { lo, hi, x_lo, x_hi, slope }
    }
}

/// On the way down the rows of a window, at the upper border of row y.
struct Walk {
    y: i32,
    end: i32,
    /// From the centre down to that border, and the same as far as the curve goes.
    below: i32,
    top: i32,
    /// How far out the curve is there, and about how far it will be at the next one.
    x_top: u32,
    guess: u32,
}

impl Walk {
    /// The next row, if there is one; else the largest number.
    fn row(&self) -> i32 {
        if self.y < self.end {
            self.y
        } else {
            i32::MAX
        }
    }

    #[inline(always)]
    fn next(&mut self, oval: &Oval) -> Cut {
        self.below = self.below.wrapping_add(1 << (oval.bits & 15));
        let bottom = oval.inside(self.below);
        let x_bottom = oval.x_at(bottom.unsigned_abs(), self.guess);
        let cut = Cut { top: self.top, x_top: self.x_top, bottom, x_bottom };
        // As far again, for the next one.
        self.guess = (x_bottom << 1).saturating_sub(self.x_top);
        (self.top, self.x_top) = (bottom, x_bottom);
        self.y = self.y.wrapping_add(1);
        cut
    }
}

/// The upper border of a row and the lower one, from the centre downwards as far as the curve goes, and how far out the curve is there.
#[derive(Copy, Clone)]
struct Cut {
    top: i32,
    x_top: u32,
    bottom: i32,
    x_bottom: u32,
}

impl Cut {
    #[inline(always)]
    fn ends(self) -> [(u32, u32); 2] {
        [(self.top.unsigned_abs(), self.x_top), (self.bottom.unsigned_abs(), self.x_bottom)]
    }

    /// The curve in a row above the centre or below it; `None` in that of the centre.
    #[inline(always)]
    fn piece(self) -> Option<Piece> {
        let [upper, lower] = self.ends();
        let (lower, upper) = if self.bottom <= 0 { (lower, upper) } else { (upper, lower) };
        (self.top >= 0 || self.bottom <= 0).then(|| Piece::new(lower, upper))
    }

    /// The curve in any row: the piece above the centre and the one below it. If the row has only one of them, that comes first, and the
    /// other one is empty.
    #[inline(always)]
    fn pieces(self, oval: &Oval) -> [Piece; 2] {
        let [upper, lower] = self.ends();
        let middle = (0, oval.radii.0);
        let above = Piece::new(if self.top < 0 && self.bottom <= 0 { lower } else { middle }, upper);
        let below = Piece::new(if self.top >= 0 { upper } else { middle }, lower);
        match (self.top < 0, self.bottom > 0) {
            (true, true) => [above, below],
            (true, false) => [above, Piece::default()],
            _ => [below, Piece::default()],
        }
    }
}

/// The columns from `first` to `end` are not empty, those from `full` to `rest`, if there are any, full.
#[derive(Copy, Clone)]
struct Columns {
    first: i32,
    full: i32,
    rest: i32,
    end: i32,
}

impl Columns {
    const NONE: Self = Self { first: i32::MAX, full: 0, rest: 0, end: i32::MIN };

    /// The level of a column if it is empty or full, and the column up to which that is so.
    fn plain(&self, x: i32) -> Option<(u8, i32)> {
        if x < self.first {
            Some((0, self.first))
        } else if x >= self.end {
            Some((0, i32::MAX))
        } else if self.full <= x && x < self.rest {
            Some((u8::MAX, self.rest))
        } else {
            None
        }
    }
}

/// Tells a row that some curves go through. `level` makes one level of those that the curves have in a pixel. Where each curve is full
/// or empty it has to be full or empty too: then many pixels are told at once.
#[inline(never)]
fn tell_row<const N: usize>(
    curves: [(&Oval, [Piece; 2]); N],
    level: impl Fn([u8; N]) -> u8,
    y: i32,
    window: Rect,
    sink: &mut impl Sink,
) {
    let columns = curves.map(|(oval, pieces)| oval.columns(&pieces, window));
    let mut x = columns.iter().fold(i32::MAX, |first, columns| first.min(columns.first));
    let end = columns.iter().fold(i32::MIN, |end, columns| end.max(columns.end));
    let mut row = Row::new(sink, y, x);
    while x < end {
        let (mut levels, mut next) = ([0; N], end);
        for ((place, (oval, pieces)), columns) in levels.iter_mut().zip(&curves).zip(&columns) {
            let (found, until) = columns.plain(x).unwrap_or_else(|| (oval.level(pieces, x), x.wrapping_add(1)));
            (*place, next) = (found, next.min(until));
        }
        match level(levels) {
            level @ (0 | u8::MAX) if next > x.wrapping_add(1) => row.run_to(next, level),
            level => row.put(level),
        }
        x = next;
    }
    row.tell();
}

/// Tells what lies in one of two ellipses and not in both: a ring, if one lies in the other. What one of them has of a pixel is taken
/// away from what the other one has; if none of them has the centre of the other one, it is added.
///
/// Levels are as exact as those of both [ellipses](ellipse) together. An ellipse beside a ring that it fills adds up to 255 with it.
///
/// Work: as for both of them.
pub fn ring(outer: Ellipse, inner: Ellipse, window: Rect, mut sink: impl Sink) {
    let are_near = are_near(&outer, &inner);
    let (outer, inner) = match [outer, inner].map(|ellipse| Oval::of(&ellipse)) {
        [Some(outer), Some(inner)] => (outer, inner),
        [one, other] => {
            if let Some(oval) = one.or(other) {
                oval.tell(window, &mut sink);
            }
            return;
        }
    };
    let [mut a, mut b] = [&outer, &inner].map(|oval| oval.walk(window));
    loop {
        let y = a.row().min(b.row());
        if y == i32::MAX {
            return;
        }
        let pieces = |walk: &mut Walk, oval: &Oval| {
            if walk.row() == y {
                walk.next(oval).pieces(oval)
            } else {
                [Piece::default(); 2]
            }
        };
        let curves = [(&outer, pieces(&mut a, &outer)), (&inner, pieces(&mut b, &inner))];
        let level = |[a, b]: [u8; 2]| {
            let sum = u32::from(a).wrapping_add(u32::from(b));
            if are_near {
                a.abs_diff(b)
            } else {
                low_u8(sum.min(510_u32.wrapping_sub(sum)))
            }
        };
        tell_row(curves, level, y, window, &mut sink);
    }
}

/// Whether the centre of one of two ellipses may lie in the other one: it lies in the box around it.
fn are_near(a: &Ellipse, b: &Ellipse) -> bool {
    let (Some((a, r)), Some((b, s))) = (a.on_grid(), b.on_grid()) else { return false };
    let is_near = |a: i64, b: i64, r: i64| a.wrapping_sub(b).unsigned_abs() < r.unsigned_abs();
    is_near(a.0, b.0, r.0.max(s.0)) && is_near(a.1, b.1, r.1.max(s.1))
}

impl Oval {
    fn of(ellipse: &Ellipse) -> Option<Self> {
        let (centre, radii) = ellipse.on_grid()?;
        // They come in 1/512 pixel, below 2^42.
        let zeros = signed_wide(magnitude(radii.0.max(radii.1))).leading_zeros();
        let bits = zeros.saturating_sub(25).min(BITS);
        // To the nearest step; where a pixel is a single step, down, so that the curve in a box of pixels stays in it.
        let half = if bits > 0 { 256 >> (bits & 31) } else { 0 };
        let scaled = |n: i64| {
            if bits >= 9 {
                n << (bits.wrapping_sub(9) & 31)
            } else {
                n.wrapping_add(half) >> (9_u32.wrapping_sub(bits) & 31)
            }
        };
        let [rx, ry] = [radii.0, radii.1].map(|n| distance(scaled(n)));
        let (large, small) = (rx.max(ry), NonZeroU32::new(rx.min(ry))?);
        let stretch = if rx == ry { None } else { Stretch::new(large, small) };
        let bulge = Bulge::new(stretch, rx >= ry, small, BITS.wrapping_sub(bits));
        let [x, y] = [centre.0, centre.1].map(scaled);
        let pixel = |place: i64| narrow(place >> bits);
        let inset = |place: i64| signed(distance(place & (1_i64 << bits).wrapping_sub(1)));
        let centre = (pixel(x), pixel(y));
        let inset = (inset(x), inset(y));
        Some(Self { centre, inset, radii: (rx, ry), circle: large, stretch, is_wide: rx >= ry, bits, bulge })
    }

    /// How far along one axis the curve is at a place on the other one: `floor(root (R^2 - t^2))` on the circle.
    #[cfg_attr(not(embedded_raster_compact), inline(always))]
    #[cfg_attr(embedded_raster_compact, inline(never))]
    fn across(&self, place: u32, on_short_axis: bool, guess: u32) -> u32 {
        let (t, guess) = match self.stretch {
            None => (place, guess),
            Some(stretch) if on_short_axis => (stretch.up(place), guess),
            Some(stretch) => (place, stretch.up(guess)),
        };
        let (t, guess) = (t.min(self.circle), guess.min(self.circle));
        let square = product(self.circle.wrapping_sub(t), self.circle.wrapping_add(t));
        let mut root = near_root(square, guess);
        // Where a step is a 128th of a pixel or more, the nearest one.
        if self.bulge.up > 4 && square.wrapping_sub(product(root, root)) > u64::from(root) {
            root = root.wrapping_add(1);
        }
        match self.stretch {
            Some(stretch) if !on_short_axis => stretch.down(root),
            _ => root,
        }
    }

    /// How far out the curve is at a height.
    fn x_at(&self, v: u32, guess: u32) -> u32 {
        if v >= self.radii.1 {
            return 0;
        }
        self.across(v, self.is_wide, guess).min(self.radii.0)
    }

    /// How high the curve is on the border of two columns that it crosses in a piece.
    fn border(&self, piece: &Piece, u: u32) -> u32 {
        // Below the rise times 2^16.
        let along = piece.x_lo.wrapping_sub(u).wrapping_mul(piece.slope) >> 16;
        let v = self.across(u.min(self.radii.0), !self.is_wide, piece.lo.wrapping_add(along));
        v.max(piece.lo).min(piece.hi)
    }

    fn tell(&self, window: Rect, sink: &mut impl Sink) {
        let mut rims = [[0; CHUNK]; 2];
        let mut walk = self.walk(window);
        while walk.y < walk.end {
            let y = walk.y;
            let cut = walk.next(self);
            if COMPACT || !cut.piece().is_some_and(|piece| self.short_row(&piece, (y, window), &mut rims, sink)) {
                tell_row([(self, cut.pieces(self))], |[level]| level, y, window, sink);
            }
        }
    }

    /// The way down its rows in a window, of which there may be none.
    #[inline(always)]
    fn walk(&self, window: Rect) -> Walk {
        let ry = signed(self.radii.1);
        let pixel = 1_i32 << (self.bits & 15);
        let row = |down: i32| self.centre.1.saturating_add(self.inset.1.wrapping_add(down) >> (self.bits & 15));
        let y = row(ry.wrapping_neg()).max(window.y0);
        let end = row(ry.wrapping_add(pixel).wrapping_sub(1)).min(window.y1);
        let end = if window.x0 < window.x1 { end } else { y };
        let below = (y.wrapping_sub(self.centre.1) << (self.bits & 15)).wrapping_sub(self.inset.1);
        let top = self.inside(below);
        Walk { y, end, below, top, x_top: self.x_at(top.unsigned_abs(), self.radii.0), guess: self.radii.0 }
    }

    /// From the centre down to a border of rows, as far as the curve goes.
    #[inline(always)]
    fn inside(&self, below: i32) -> i32 {
        let ry = signed(self.radii.1);
        below.max(ry.wrapping_neg()).min(ry)
    }

    /// The distance from the centre to the left border of a column.
    #[inline(always)]
    fn right(&self, column: i32) -> i32 {
        (column.wrapping_sub(self.centre.0) << (self.bits & 15)).wrapping_sub(self.inset.0)
    }

    /// The column of a place, so far right of the centre.
    #[inline(always)]
    fn column(&self, right: i32) -> i32 {
        self.centre.0.wrapping_add(self.inset.0.wrapping_add(right) >> (self.bits & 15))
    }

    /// Tells a row in one call, if it is one piece, lies in the window as a whole, and has full pixels in its middle. `false`, and nothing
    /// is told, if it is another one.
    #[inline(always)]
    fn short_row(
        &self,
        piece: &Piece,
        (y, window): (i32, Rect),
        [before, behind]: &mut [[u8; CHUNK]; 2],
        sink: &mut impl Sink,
    ) -> bool {
        let [outer, inner] = [piece.x_lo, piece.x_hi].map(signed);
        // The columns that the curve goes through. On a border of columns, one beside it that is empty or full may come with them.
        let left = (self.column(outer.wrapping_neg()), self.column(inner.wrapping_neg()));
        let right = (self.column(inner), self.column(outer));
        if left.0 < window.x0 || right.1 >= window.x1 || piece.x_hi >> (self.bits & 15) == 0 {
            return false;
        }
        let columns = |(first, last): (i32, i32)| index(last.wrapping_sub(first)).wrapping_add(1);
        let (Some(before), Some(behind)) = (before.get_mut(..columns(left)), behind.get_mut(..columns(right))) else {
            return false;
        };
        let (x0, x1) = (left.0, right.1.wrapping_add(1));
        let outermost = (self.right(x0).unsigned_abs(), self.right(x1).unsigned_abs());
        self.rim(piece, outermost.0, before);
        if outermost.0 == outermost.1 && before.len() == behind.len() {
            for (place, &level) in behind.iter_mut().rev().zip(&*before) {
                keep_rolled(true);
                *place = level;
            }
        } else {
            self.rim(piece, outermost.1, behind);
            behind.reverse();
        }
        // The first one and the last one may be empty, those in the middle full.
        let (mut before, mut behind, mut x0, mut x1) = (&*before, &*behind, x0, x1);
        while let Some((0, rest)) = before.split_first() {
            keep_rolled(true);
            (before, x0) = (rest, x0.wrapping_add(1));
        }
        while let Some((&u8::MAX, rest)) = before.split_last() {
            keep_rolled(true);
            before = rest;
        }
        while let Some((0, rest)) = behind.split_last() {
            keep_rolled(true);
            (behind, x1) = (rest, x1.wrapping_sub(1));
        }
        while let Some((&u8::MAX, rest)) = behind.split_first() {
            keep_rolled(true);
            behind = rest;
        }
        if x0 < x1 {
            sink.soft_row(SoftRow::inside(ClippedSpan::inside(y, x0, x1), before, behind));
        }
        true
    }

    /// The levels of the pixels that a piece goes through on one side, from the outermost one inwards.
    #[inline(never)]
    fn rim(&self, piece: &Piece, mut u_out: u32, levels: &mut [u8]) {
        let mut v_out = piece.lo;
        for level in levels {
            let u_in = u_out.wrapping_sub(1 << (self.bits & 15));
            let v_in = if piece.x_hi >= u_in { piece.hi } else { self.border(piece, u_in) };
            *level = level_of(self.part(piece, (u_in, u_out), (v_in, v_out)));
            (u_out, v_out) = (u_in, v_in);
        }
    }

    /// The columns of a window that the curve goes through in a row, and those between that are full.
    fn columns(&self, pieces: &[Piece; 2], window: Rect) -> Columns {
        if pieces[0].hi == 0 {
            return Columns::NONE;
        }
        let outer = signed(pieces[0].x_lo.max(pieces[1].x_lo));
        let inner = match pieces {
            [piece, Piece { hi: 0, .. }] => signed(piece.x_hi),
            [a, b] => signed(a.x_hi.min(b.x_hi)),
        };
        let inside = |column: i32| column.max(window.x0).min(window.x1);
        let first = inside(self.column(outer.wrapping_neg()));
        let (full, rest) = (inside(self.column(inner.wrapping_neg()).wrapping_add(1)), inside(self.column(inner)));
        let end = inside(self.column(outer).saturating_add(1));
        if first < end {
            Columns { first, full, rest, end }
        } else {
            Columns::NONE
        }
    }

    /// The level of any column.
    fn level(&self, pieces: &[Piece; 2], x: i32) -> u8 {
        let right = self.right(x);
        let next = right.wrapping_add(1 << (self.bits & 15));
        let mut area = 0_u32;
        for piece in pieces {
            for (from, to) in [(right, next), (next.wrapping_neg(), right.wrapping_neg())] {
                if to > 0 {
                    area = area.wrapping_add(self.side(piece, (unsigned(from.max(0)), unsigned(to))));
                }
            }
        }
        level_of(area)
    }

    /// What a piece covers of a column, or of a part of it, on one side of the centre.
    fn side(&self, piece: &Piece, (u_in, u_out): (u32, u32)) -> u32 {
        if u_out <= piece.x_hi {
            return self.scaled(u_out.wrapping_sub(u_in).wrapping_mul(piece.hi.wrapping_sub(piece.lo)) << 1);
        }
        if u_in >= piece.x_lo {
            return 0;
        }
        let v_in = if piece.x_hi >= u_in { piece.hi } else { self.border(piece, u_in) };
        let v_out = if piece.x_lo <= u_out { piece.lo } else { self.border(piece, u_out) };
        self.part(piece, (u_in, u_out), (v_in, v_out))
    }

    /// What a piece covers of a column that it goes through: the heights are those of the curve on the borders of the column, where it
    /// crosses them.
    #[inline(always)]
    fn part(&self, piece: &Piece, (u_in, u_out): (u32, u32), (v_in, v_out): (u32, u32)) -> u32 {
        let from = piece.x_hi.max(u_in).min(u_out);
        let to = piece.x_lo.min(u_out).max(from);
        let (wide, high) = (to.wrapping_sub(from), v_in.wrapping_sub(v_out));
        let before = from.wrapping_sub(u_in).wrapping_mul(piece.hi.wrapping_sub(piece.lo));
        let heights = v_in.wrapping_add(v_out).wrapping_sub(piece.lo << 1);
        let twice = (before << 1).wrapping_add(wide.wrapping_mul(heights));
        self.scaled(twice).wrapping_add(self.bulge.area(wide, high))
    }

    /// An area of the pixel in squares of `2^-BITS` of it, by twice that area in squares of a step.
    #[inline(always)]
    fn scaled(&self, twice: u32) -> u32 {
        twice << (self.bulge.up << 1 & 31) >> 1
    }
}

/// A distance that is not negative.
#[inline(always)]
fn distance(n: i64) -> u32 {
    low_u32(magnitude(n))
}

/// The level of an area.
#[inline(always)]
fn level_of(area: u32) -> u8 {
    // Below 2^32: 255 times 2^24 and a half.
    low_u8(area.min(FULL).wrapping_mul(255).wrapping_add(FULL / 2) >> (2 * BITS))
}

/// The area between a chord and the curve. Both ends are measured in units of the shorter radius r: then a length T is T / r radii.
#[derive(Copy, Clone)]
struct Bulge {
    /// `r / rx` and `r / ry` in `2^-16`: one of them is 1.
    parts: (u32, u32),
    /// `R / (12 r^2)`, with which a segment has `T^3` times that: in `2^-12` of a pixel's inverse.
    factor: u32,
    /// `r^2 / 2^14`, at least 1, where the series has more than one part, or where steps are coarser.
    small: Option<NonZeroU32>,
    /// A step is `2^up` of those of `2^-BITS` pixel, in which all else is.
    up: u32,
}

impl Bulge {
    fn new(stretch: Option<Stretch>, is_wide: bool, small: NonZeroU32, up: u32) -> Self {
        const ONE: u32 = 1 << 16;
        // 2^24 / 12, and 1.2 % more, as lengths are that much too short on average.
        const TWELFTH: u32 = 1_414_878;
        let (stretched, shift, down) = stretch.map_or((1, 0, ONE), |s| (s.up, s.shift, s.down >> 16));
        let ratio = product(stretched, TWELFTH) >> (shift.wrapping_add(up) & 63);
        let factor = if ratio >> 32 >= u64::from(small.get()) { u32::MAX } else { div_rem_wide(ratio, small).0 };
        // The square of it fits.
        let fine = (u64::from(small.get()) << (up & 15)).min((1 << 23) - 1);
        let squared = low_u32(fine.wrapping_mul(fine) >> 14);
        Self {
            parts: if is_wide { (down, ONE) } else { (ONE, down) },
            factor,
            small: NonZeroU32::new(squared.max(1)).filter(|_| fine < 1 << 14 || up > 0),
            up,
        }
    }

    /// Of a chord of at most a pixel in each direction.
    #[inline(always)]
    fn area(&self, wide: u32, high: u32) -> u32 {
        let (wide, high) = (wide << (self.up & 15), high << (self.up & 15));
        let (p, q) = (wide.wrapping_mul(self.parts.0) >> 16, high.wrapping_mul(self.parts.1) >> 16);
        let square = p.wrapping_mul(p).wrapping_add(q.wrapping_mul(q));
        // The root of it to 3 %: 1, or 7/8 of the larger one and 1/2 of the smaller one.
        let (large, less) = (p.max(q), p.min(q));
        let length = large.max(large.wrapping_sub(large >> 3).wrapping_add(less >> 1));
        // At most 2^15 times 2^12.5, in 2^-26.
        let cube = (square >> 10).wrapping_mul(length);
        let area = product(cube, self.factor) >> 14;
        let Some(small) = self.small else { return low_u32(area) };
        // What lies beyond the chord is half of its box at most. The ends are rounded, to steps that are wide for a small ellipse.
        let half = wide.wrapping_mul(high) >> 1;
        let area = low_u32(area.min(half.into()));
        // s^2 in 2^-16, at most a half.
        let s = square / small;
        let more = s.wrapping_mul(15_729) >> 16;
        let series = (1_u32 << 16).wrapping_add(s.wrapping_mul(more.wrapping_add(19_661)) >> 16);
        (area >> 8).wrapping_mul(series) >> 8
    }
}

/// `floor(root n)` for roots below 2^31, from a place near it, which matters only for the time that it takes. Up to 2^30 that is short.
#[cfg_attr(not(embedded_raster_compact), inline(always))]
#[cfg_attr(embedded_raster_compact, inline(never))]
fn near_root(n: u64, guess: u32) -> u32 {
    let mut root = guess.max(1);
    for _ in 0..4 {
        let rest = signed_wide(n.wrapping_sub(product(root, root)));
        let (Ok(rest), Some(twice)) = (i32::try_from(rest), NonZeroU32::new(root << 1)) else { break };
        let step = rest.unsigned_abs() / twice;
        let way = if rest < 0 { signed(step).wrapping_neg() } else { signed(step) };
        root = root.wrapping_add_signed(way);
        if step < 1 << 15 && step.wrapping_mul(step) <= root && root < (1 << 30) - 4 {
            // What is left of n, off by 2 roots at most.
            let square = signed(step.wrapping_mul(step));
            let mut left = rest.wrapping_sub(way.wrapping_mul(signed(twice.get()))).wrapping_sub(square);
            while left < 0 {
                keep_rolled(true);
                root = root.wrapping_sub(1);
                left = left.wrapping_add(signed(root << 1 | 1));
            }
            while left > signed(root << 1) {
                keep_rolled(true);
                left = left.wrapping_sub(signed(root << 1 | 1));
                root = root.wrapping_add(1);
            }
            return root;
        }
    }
    square_root(n)
}
