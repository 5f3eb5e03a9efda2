//! [`CoverageSlot`]: a side on its way down the rows, and where it lies on each of them.
//!
//! **Symbols.** A side goes from its upper end `(ax, ay)` to its lower one `(bx, by)`, in units of 1/256 pixel, with `dx = bx - ax`
//! and `dy = by - ay > 0`. Places along a row are counted in steps of the grid, `G = 128` to a unit, from the left side of the
//! window.
//!
//! At the upper border of row y the side is at `G ax + floor((G dx (256 y - ay) + h) / dy)`, with `h = floor(dy / 2)`: the step
//! nearest to its true place. One row down adds `256 G dx / dy`. Both are kept with their remainders, so nothing drifts, and it
//! does not matter on which row the side entered the window.
//!
//! A side whose places do not fit 32 bits is *far*: each of them is computed by itself, in 64 bits. In builds for size all sides are,
//! as one way is shorter than two. The places are the same.

use core::{cell::Cell, num::NonZeroU32};

use super::strip::{Strip, GRID_BITS};
use crate::{
    num::{
        cast::{magnitude, saturate, signed, unsigned},
        round::{div_rem_wide, floor_div_rem},
        stepper::Stepper,
    },
    span::Rect,
    tune::COMPACT,
};

/// G is `2^7`: steps of the grid in a unit of 1/256 pixel.
const UNIT_BITS: u32 = GRID_BITS - 8;

/// No side: the end of a list.
pub(super) const END: u16 = u16::MAX;

/// One slot of the table of an antialiased fill: a side on its way down the rows. See
/// [`coverage::fill`](crate::raster::coverage::fill).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CoverageSlot {
    /// Where it enters the row that it stands on. Of a far side, ax.
    x: Cell<i32>,
    /// `value` is where it leaves that row, if it goes on below.
    crossing: Cell<Stepper>,
    /// Its lower end. Of a far side, bx.
    end_x: i32,
    /// ay.
    top: i32,
    /// by.
    bottom: i32,
    /// 1 when the contour goes down along it, -1 when up.
    winding: i16,
    is_far: bool,
    /// The next side of a list.
    pub(super) link: Cell<u16>,
    /// The first side in bucket k, where k is the number of this slot. It has nothing to do with the side that this slot holds.
    pub(super) bucket: Cell<u16>,
}

impl CoverageSlot {
    /// An empty slot, to make a table of.
    /// ```
    /// use embedded_raster::CoverageSlot;
    /// let table = [CoverageSlot::EMPTY; 64];
    /// assert_eq!(size_of_val(&table), 64 * 44);
    /// ```
    #[expect(clippy::declare_interior_mutable_const, reason = "it is copied into every slot")]
    pub const EMPTY: Self = Self {
        x: Cell::new(0),
        crossing: Cell::new(Stepper::still(0)),
        end_x: 0,
        top: 0,
        bottom: 0,
        winding: 0,
        is_far: false,
        link: Cell::new(0),
        bucket: Cell::new(0),
    };

    /// Puts the side from a to b into this slot, to be followed from row y on, which it meets.
    #[inline(never)]
    pub(super) fn put(&mut self, a: (i32, i32), b: (i32, i32), y: i32, window: Rect) {
        let is_down = a.1 < b.1;
        let (a, b) = if is_down { (a, b) } else { (b, a) };
        (self.top, self.bottom) = (a.1, b.1);
        self.winding = if is_down { 1 } else { -1 };
        self.bucket.set(END);
        self.crossing.set(Stepper::still(i32::MIN));
        let place = |x: i32| i64::from(x).wrapping_sub(i64::from(window.x0) << 8) << UNIT_BITS;
        let (from, to) = (place(a.0), place(b.0));
        // Left of the window it does not matter where.
        let is_left = from <= 0 && to <= 0;
        let (x, end_x) = (saturate(from), saturate(to));
        let fits = i64::from(x) == from && i64::from(end_x) == to && a.0.abs_diff(b.0) < 1 << 24;
        self.is_far = !is_left && !fits;
        if self.is_far() {
            (self.x, self.end_x) = (Cell::new(a.0), b.0);
            return;
        }
        (self.x, self.end_x) = (Cell::new(x), end_x);
        // Entering the window, it crosses the upper border of row y; else the first border that it crosses is the lower one.
        let (last, enters) = (self.last_row(), self.first_row() < y);
        let border = if enters { y } else { y.wrapping_add(1) };
        let Some(dy) = NonZeroU32::new(height(a.1, b.1)).filter(|_| !is_left && border <= last) else { return };
        let along = |down: u32| {
            let way = i64::from(b.0.wrapping_sub(a.0)).wrapping_mul(i64::from(down));
            way << UNIT_BITS
        };
        // At most 2^63 - 2^39, and less than 2^31 more.
        let (q, rest) = floor_ratio(along(height(a.1, border << 8)).wrapping_add(i64::from(dy.get() >> 1)), dy);
        let row = if border < last { floor_ratio(along(256), dy) } else { (0, 0) };
        let mut crossing = Stepper::new(dy, (x.wrapping_add(q), rest), row);
        if enters {
            self.x.set(crossing.value);
            crossing.step();
        }
        self.crossing.set(crossing);
    }

    #[inline(always)]
    fn is_far(&self) -> bool {
        COMPACT || self.is_far
    }

    /// The first row that it meets.
    #[inline(always)]
    pub(super) fn first_row(&self) -> i32 {
        self.top >> 8
    }

    /// The columns that it meets from its row on, counted from the left side of the window, and the column after the last.
    pub(super) fn columns(&self, window: Rect) -> (i32, i32) {
        let (a, b) = (self.x.get(), self.end_x);
        let column = |x: i32| {
            if self.is_far() {
                saturate(i64::from(x >> 8).wrapping_sub(window.x0.into()))
            } else {
                x >> GRID_BITS
            }
        };
        (column(a.min(b)), column(a.max(b)).saturating_add(1))
    }

    /// The last row that it meets.
    #[inline(always)]
    pub(super) fn last_row(&self) -> i32 {
        last_row(self.bottom)
    }

    /// Whether it goes through row y from border to border, and on, in steps.
    #[inline(always)]
    pub(super) fn passes(&self, y: i32) -> bool {
        !self.is_far() && self.top <= y << 8 && y < self.last_row()
    }

    /// Where it enters its row, and where it leaves it, as long as it goes on below.
    #[inline(always)]
    pub(super) fn state(&self) -> (i32, Stepper) {
        (self.x.get(), self.crossing.get())
    }

    /// Where it is some rows below.
    #[inline(always)]
    pub(super) fn set_state(&self, (x, crossing): (i32, Stepper)) {
        self.x.set(x);
        self.crossing.set(crossing);
    }

    /// Whether the sides go in opposite directions.
    #[inline(always)]
    pub(super) fn is_opposite(&self, other: &Self) -> bool {
        self.winding != other.winding
    }

    /// Its upper and its lower end on row y, in units below the upper border of the row.
    #[inline(always)]
    fn heights(&self, y: i32) -> (u32, u32) {
        let inside = |v: i32| unsigned(v.wrapping_sub(y << 8));
        let above = if y == self.first_row() { inside(self.top) } else { 0 };
        (above, if y == self.last_row() { inside(self.bottom) } else { 256 })
    }

    /// Where it goes through row y, along the row from the left side of the window, which is `window` steps from column 0.
    pub(super) fn across(&self, y: i32, window: i64) -> Across {
        let (x, next) = if self.is_far() {
            let [x, next] = self.far_ends(y);
            (x.wrapping_sub(window), next.wrapping_sub(window))
        } else {
            let next = if y == self.last_row() { self.end_x } else { self.crossing.get().value };
            (self.x.get().into(), next.into())
        };
        let (above, below) = self.heights(y);
        let [top, bottom] = [above, below].map(|units| signed(units << UNIT_BITS));
        let winding = self.winding.into();
        Across { from: x.min(next), to: x.max(next), is_rightward: x <= next, top, bottom, winding }
    }

    /// Steps down from row y.
    pub(super) fn step(&self, y: i32) {
        if !self.is_far() {
            let mut crossing = self.crossing.get();
            self.x.set(if y == self.last_row() { self.end_x } else { crossing.value });
            crossing.step();
            self.crossing.set(crossing);
        }
    }

    /// Adds what it covers of a strip of row y. With the last strip of the row it steps down to the next one.
    #[inline(always)]
    pub(super) fn cover(&self, y: i32, strip: &mut Strip<'_>, is_last_strip: bool) {
        let ends = y == self.last_row();
        let (above, below) = self.heights(y);
        let height = below.wrapping_sub(above) << UNIT_BITS;
        if self.is_far() {
            return self.cover_far(y, height, strip);
        }
        let (x, mut crossing) = (self.x.get(), self.crossing.get());
        let next = if ends { self.end_x } else { crossing.value };
        if is_last_strip {
            self.x.set(next);
            crossing.step();
            self.crossing.set(crossing);
        }
        strip.cover(x.min(next), x.max(next), height, self.winding.into());
    }

    /// Where a far side enters row y, and where it leaves it, in steps from column 0.
    fn far_ends(&self, y: i32) -> [i64; 2] {
        let (from, to) = ((self.x.get(), self.top), (self.end_x, self.bottom));
        let x = if y == self.first_row() { i64::from(from.0) << UNIT_BITS } else { far_crossing(from, to, y) };
        let ends = y == self.last_row();
        [x, if ends { i64::from(to.0) << UNIT_BITS } else { far_crossing(from, to, y.wrapping_add(1)) }]
    }

    #[cold]
    #[inline(never)]
    fn cover_far(&self, y: i32, height: u32, strip: &mut Strip<'_>) {
        let [x, next] = self.far_ends(y);
        let left = strip.far_left();
        strip.cover_far(x.min(next).wrapping_sub(left), x.max(next).wrapping_sub(left), height, self.winding.into());
    }
}

/// A side on its way through a row.
pub(super) struct Across {
    /// Its left and its right end.
    pub(super) from: i64,
    pub(super) to: i64,
    /// Whether the left end is the upper one.
    pub(super) is_rightward: bool,
    /// Its ends in steps below the upper border of the row.
    pub(super) top: i32,
    pub(super) bottom: i32,
    pub(super) winding: i32,
}

impl Across {
    #[inline]
    pub(super) fn height(&self) -> u32 {
        unsigned(self.bottom.wrapping_sub(self.top))
    }
}

/// The last row that a side with this lower end meets.
#[inline(always)]
pub(super) fn last_row(bottom: i32) -> i32 {
    bottom.wrapping_sub(1) >> 8
}

/// From one place down to another: below 2^32.
#[inline(always)]
fn height(top: i32, bottom: i32) -> u32 {
    unsigned(bottom.wrapping_sub(top))
}

/// `n / d`, rounded down, and the remainder, for quotients that fit.
fn floor_ratio(n: i64, d: NonZeroU32) -> (i32, u32) {
    if let Ok(n) = i32::try_from(n) {
        return floor_div_rem(n, d);
    }
    // Of a negative n its complement is divided, as in `floor_div_rem`.
    let sign = n >> 63;
    let (q, r) = div_rem_wide(magnitude(n ^ sign), d);
    if sign < 0 {
        (!signed(q), d.get().wrapping_sub(1).wrapping_sub(r))
    } else {
        (signed(q), r)
    }
}

/// Where a side is at the upper border of row y, for any places, counted from column 0.
fn far_crossing(a: (i32, i32), b: (i32, i32), y: i32) -> i64 {
    let Some(dy) = NonZeroU32::new(height(a.1, b.1)) else { return 0 };
    let (q, r) = div_rem_wide(u64::from(a.0.abs_diff(b.0)).wrapping_mul(u64::from(height(a.1, y << 8))), dy);
    // G q, and what G r adds to it: less than 128 steps.
    let (whole, rest) = (i64::from(q) << UNIT_BITS, i64::from(r) << UNIT_BITS);
    let half = i64::from(dy.get() >> 1);
    let (whole, rest) = if a.0 <= b.0 { (whole, rest) } else { (whole.wrapping_neg(), rest.wrapping_neg()) };
    let (steps, _) = floor_ratio(half.wrapping_add(rest), dy);
    (i64::from(a.0) << UNIT_BITS).wrapping_add(whole).wrapping_add(i64::from(steps))
}
