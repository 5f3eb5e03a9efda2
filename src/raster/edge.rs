//! [`EdgeSlot`]: a side of a shape, as the first pixel right of it on each row.
//!
//! An edge from (ax, ay) down to (bx, by), with `dx = bx - ax` and `dy = by - ay > 0` in 24.8 units, crosses the rows whose
//! centre `cy = 256 y + 128` has `ay <= cy < by`. Of row y it leaves to its right the pixels from
//! ```text
//!     k = ceil(N / (256 dy))        N = (ax - 128) dy + (cy - ay) dx
//! ```
//! on. Writing `ax + 128 = 256 p + f` and using `ceil(n / d) = floor((n - 1) / d) + 1` and
//! `floor(floor(n / 256) / d) = floor(n / (256 d))`, this is
//! ```text
//!     k = p + floor(M / dy)         M = floor((f dy + (cy - ay) dx - 1) / 256)
//! ```
//! and one row down M grows by exactly dx: a [`Stepper`] by `dx / dy`.
//!
//! Range: any `I24F8`. While dx and dy are below 2^16 (a box of 255 pixels) and the crossing rows at most 256, M stays
//! below 2^25 and set-up is two 32-bit divisions; larger edges multiply in 64 bits and divide with
//! [`div_rem_wide`](crate::num::round::div_rem_wide). An edge that crosses one row only needs no slope.

use core::{cell::Cell, num::NonZeroU32};

use crate::{
    geom::{bits, PointFx},
    num::{
        cast::{low_u32, magnitude, signed, unsigned},
        round::{div_rem_wide, first_centre_after, floor_div_rem},
        stepper::Stepper,
    },
    target::{COMPACT, DIVIDES},
};

use super::list::END;

/// One slot of an edge table: a side on its way down the rows. See [`polygon::fill`](crate::raster::polygon::fill).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EdgeSlot {
    /// `value` is the first pixel right of the edge on the row it stands on.
    pub(crate) crossing: Cell<Stepper>,
    /// The first row it crosses, then [`ACTIVE`].
    pub(crate) y: Cell<i32>,
    /// Four times the row after its last, and in the two lowest bits the winding: 1 down, -1 up. Rows of places are below
    /// 2^24.
    end: i32,
    /// The next edge of a list.
    pub(crate) link: Cell<u16>,
    /// Nothing of this edge: the list of the bucket that has this place.
    pub(crate) bucket: Cell<u16>,
}

/// The row of all edges that are on their way: they are sorted by their crossings alone.
pub(crate) const ACTIVE: i32 = i32::MIN;

impl EdgeSlot {
    /// An empty slot, to make a table of.
    /// ```
    /// use embedded_raster::raster::EdgeSlot;
    /// static mut TABLE: [EdgeSlot; 64] = [EdgeSlot::EMPTY; 64];
    /// ```
    #[expect(clippy::declare_interior_mutable_const, reason = "it is copied into every slot")]
    pub const EMPTY: Self = Self {
        crossing: Cell::new(Stepper::still(0)),
        y: Cell::new(0),
        end: 0,
        link: Cell::new(0),
        bucket: Cell::new(0),
    };

    /// Puts the side from a to b into this slot, as it stands on the first of the rows `y..end`, which it crosses; `down` if
    /// that is where b lies.
    #[inline(always)]
    pub(crate) fn put(&mut self, a: PointFx, b: PointFx, (y, end): (i32, i32), down: bool) {
        let Some(slope) = Slope::either_way(bits(a), bits(b), down) else { return };
        // Two stores: of one, the smaller side's numbers would go by way of the stack.
        if slope.is_small() {
            self.crossing.set(slope.small(slope.down_to(y), end.wrapping_sub(y)));
        } else {
            self.crossing.set(Slope::any(slope.from, slope.to, slope.dy, y));
        }
        self.y.set(y);
        self.end = end.wrapping_mul(4) | if down { 1 } else { 3 };
        self.bucket.set(END);
    }

    /// The first pixel right of it.
    #[inline(always)]
    pub(crate) fn x(&self) -> i32 {
        self.crossing.get().value
    }

    /// The row after its last.
    #[inline(always)]
    pub(crate) fn end(&self) -> i32 {
        self.end >> 2
    }

    /// To the next row, and the first pixel right of it there.
    #[inline(always)]
    pub(crate) fn step(&self) -> i32 {
        let mut crossing = self.crossing.get();
        crossing.step();
        self.crossing.set(crossing);
        crossing.value
    }

    /// What lists are sorted by.
    #[inline(always)]
    pub(crate) fn order(&self) -> (i32, i32) {
        (self.y.get(), self.x())
    }

    /// +1 when the contour goes down along it, -1 when up.
    #[inline(always)]
    pub(crate) fn winding(&self) -> i32 {
        self.end << 30 >> 30
    }
}

/// A side from one end to the other, not horizontal.
#[derive(Copy, Clone)]
pub(crate) struct Slope {
    from: (i32, i32),
    to: (i32, i32),
    /// From the upper end to the lower one, whichever of them it starts at. Modulo 2^32.
    dx: i32,
    pub(crate) dy: NonZeroU32,
}

impl Slope {
    /// `None` if it is horizontal.
    #[inline(always)]
    pub(crate) fn new(upper: (i32, i32), lower: (i32, i32)) -> Option<Self> {
        Self::either_way(upper, lower, true)
    }

    /// From a to b, which is `down` or up from it. `None` if it is horizontal.
    #[inline(always)]
    fn either_way(a: (i32, i32), b: (i32, i32), down: bool) -> Option<Self> {
        let (dx, dy) = (b.0.wrapping_sub(a.0), b.1.wrapping_sub(a.1));
        let (dx, dy) = if down { (dx, dy) } else { (dx.wrapping_neg(), dy.wrapping_neg()) };
        // Not negative, so its 32 bits are the distance even beyond i32::MAX.
        Some(Self { from: a, to: b, dx, dy: NonZeroU32::new(unsigned(dy))? })
    }

    /// Its crossings from row y, which it crosses, for `rows` rows; any size.
    #[inline(always)]
    pub(crate) fn stepper_at(self, y: i32, rows: i32) -> Stepper {
        if self.is_small() {
            self.small(self.down_to(y), rows)
        } else {
            Self::any(self.from, self.to, self.dy, y)
        }
    }

    /// Below 2^16 units in width and height.
    #[inline(always)]
    fn is_small(self) -> bool {
        !COMPACT && (self.to.0.abs_diff(self.from.0) | self.dy.get()) < 1 << 16
    }

    /// From where it starts down to the centre of row y, which it crosses: at most dy, and negative if it goes up.
    #[inline(always)]
    fn down_to(self, y: i32) -> i32 {
        (y << 8).wrapping_add(128).wrapping_sub(self.from.1)
    }

    /// (p, M) for sides below 2^19 units. The end that it starts at is a; were it the other one, p would differ and M by as
    /// many times dy, so that crossing and remainder are the same.
    #[inline(always)]
    fn numerator(self, down: i32) -> (i32, i32) {
        let (ax, dx) = (self.from.0, self.dx);
        let (p, f) = (first_centre_after(ax), unsigned(ax.wrapping_add(128)) & 255);
        let (rows, g) = (down >> 8, down & 255);
        let n = signed(f.wrapping_mul(self.dy.get())).wrapping_add(g.wrapping_mul(dx));
        (p, (n.wrapping_sub(1) >> 8).wrapping_add(rows.wrapping_mul(dx)))
    }

    #[inline(always)]
    fn small(self, down: i32, rows: i32) -> Stepper {
        let (p, m) = self.numerator(down);
        let (k, rest) = self.ratio(m);
        let slope = if rows > 1 { self.ratio(self.dx) } else { (0, 0) };
        Stepper::new(self.dy, (p.wrapping_add(k), rest), slope)
    }

    /// n / dy, rounded down, and the rest, for quotients from -512 on: those of M, as the crossing lies between the ends, and
    /// of dx where there is a second row, as dy is above 2^8 then.
    #[inline(always)]
    fn ratio(self, n: i32) -> (i32, u32) {
        if !DIVIDES {
            // Division bit by bit is done sooner with a small number.
            return floor_div_rem(n, self.dy);
        }
        let n = unsigned(n).wrapping_add(self.dy.get() << 9);
        (signed(n / self.dy).wrapping_sub(512), n % self.dy)
    }

    /// Any size, with one product that needs 64 bits: the crossing in units, `x + r / dy`, is found from the end that is
    /// further left, so that nothing is negative.
    ///
    /// With one unit less in x where r = 0, `k = floor((x + 128) / 256)` and `M mod dy = floor((f dy + r - 1) / 256)`, f
    /// being the remainder of that division and r - 1 being taken modulo dy.
    #[cfg_attr(not(compact), cold)]
    #[inline(never)]
    fn any(from: (i32, i32), to: (i32, i32), height: NonZeroU32, y: i32) -> Stepper {
        let ((ax, ay), (bx, _)) = if from.1 < to.1 { (from, to) } else { (to, from) };
        let dy = height.get();
        let down = unsigned((y << 8).wrapping_add(128).wrapping_sub(ay));
        let (width, leftward) = (bx.abs_diff(ax), bx < ax);
        let (left, along) = if leftward { (bx, dy.wrapping_sub(down)) } else { (ax, down) };
        let (q, r) = div_rem_wide(u64::from(along) * u64::from(width), height);
        let x = left.wrapping_add(signed(q));
        let half = if r == 0 { 127 } else { 128 };
        let k = (x >> 8) + (((x & 255) + half) >> 8);
        let f = unsigned(x.wrapping_add(half)) & 255;
        let r = if r == 0 { dy } else { r }.wrapping_sub(1);
        // (f dy + r) / 256 in parts that fit.
        let low = f.wrapping_mul(dy & 255).wrapping_add(r & 255) >> 8;
        let rest = f.wrapping_mul(dy >> 8).wrapping_add(r >> 8).wrapping_add(low);
        // As in `floor_div_rem`: to the left, the complement of the quotient.
        let (q, r) = div_rem_wide(u64::from(width.wrapping_sub(leftward.into())), height);
        let slope = if leftward { (!signed(q), dy.wrapping_sub(1).wrapping_sub(r)) } else { (signed(q), r) };
        Stepper::new(height, (k, rest), slope)
    }
}

/// Crossings of small sides in columns `0..1024`, as 10 bits of pixel and 22 of fraction: a step is one addition.
///
/// M / dy is a multiple of 1 / dy, so its floor stays right while what is stored is not below it, and above it by less than
/// 1 / dy.
#[derive(Copy, Clone, Default)]
pub(crate) struct Sum {
    at: u32,
    by: u32,
}

impl Sum {
    /// Columns from 0 on.
    pub(crate) const COLUMNS: i32 = 1 << (32 - Self::BITS);
    /// Width and height together of a side that may be called tiny: 54 pixels.
    pub(crate) const TINY: u32 = 54 * 256;
    /// Bits of the fraction.
    const BITS: u32 = 22;

    /// From row y, which the side crosses; less than 2^16 units high.
    ///
    /// Start and step are too large by at most `2^-22` each, k rows down by `(k + 1) 2^-22`: less than 1 / dy in the first
    /// [`reach`](Self::reach) rows.
    #[inline(always)]
    pub(crate) fn new(side: Slope, y: i32) -> Self {
        let (p, m) = side.numerator(side.down_to(y));
        // |M| is below 2^12 dy, and |dx| too where there is a second row: then dy is above 2^8.
        let ratio = |n: i32| {
            let n = unsigned(n).wrapping_add(side.dy.get() << 12);
            let (q, r) = (n / side.dy, n % side.dy);
            let (high, rest) = ((r << 16) / side.dy, (r << 16) % side.dy);
            let low = (rest << (Self::BITS - 16)) / side.dy;
            (q << Self::BITS | high << (Self::BITS - 16) | low).wrapping_add(1)
        };
        Self { at: (unsigned(p) << Self::BITS).wrapping_add(ratio(m)), by: ratio(side.dx) }
    }

    /// For how many rows a side of at most this height is right: 64 or more.
    #[inline(always)]
    pub(crate) fn reach(height: NonZeroU32) -> i32 {
        signed(((1 << Self::BITS) - 1) / height)
    }

    /// The same in tiny triangles, with one division.
    ///
    /// With `i = floor((2^32 - 1) / dy)`, M i and its steps dx i are wide of `2^32 M / dy` by at most |M|, M being that of the
    /// row, and cutting off 10 bits takes up to `2^10` more each time. Half of i is added at the start; so all is well while
    /// `|M| + 2^10 (k + 1) <= i / 2` in row k. As |M| is at most `dy (256 + |dx|) / 256` and k at most `dy / 256 + 1`, it is
    /// enough that `dy^2 (1280 + |dx|) <= 2^39 - 2^19.1 dy`. With `|dx| + dy = s` the left side is at most
    /// `4 (1280 + s)^3 / 27`, below `2^38.9` for s up to [`TINY`](Self::TINY). (Where dy is 1, M is 0 or -1, there is one
    /// row, and half of i will do.)
    #[inline(always)]
    pub(crate) fn tiny(side: Slope, y: i32) -> Self {
        let Slope { from, dx, dy, .. } = side;
        let ax = from.0.wrapping_add(128);
        let (p, f) = (ax >> 8, unsigned(ax) & 255);
        let n = f.wrapping_mul(dy.get()).wrapping_add(unsigned(side.down_to(y).wrapping_mul(dx)));
        let m = signed(n).wrapping_sub(1) >> 8;
        let i = (u32::MAX / dy) & (u32::MAX >> 1);
        let times = |n: i32| i64::from(n).wrapping_mul(i64::from(i));
        let cut = |n: i64| low_u32(magnitude(n >> (32 - Self::BITS)));
        let start = i64::from(p) << 32 | i64::from(i >> 1);
        Self { at: cut(start.wrapping_add(times(m))), by: cut(times(dx)) }
    }

    /// The first pixel right of the side on this row.
    #[inline(always)]
    pub(crate) fn x(self) -> i32 {
        signed(self.at >> Self::BITS)
    }

    /// To the next row.
    #[inline(always)]
    pub(crate) fn step(&mut self) {
        self.at = self.at.wrapping_add(self.by);
    }
}
