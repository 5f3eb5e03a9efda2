//! [`Edge`]: a side of a shape, as the first pixel right of it on each row.
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
    geom::{bits, Vertex},
    num::{
        cast::{signed, signed_wide, unsigned},
        round::{difference, first_centre_after, floor_div_rem, floor_div_rem_wide},
        stepper::Stepper,
    },
};

/// One slot of an edge table: a side on its way down the rows. See [`polygon::fill`](crate::raster::polygon::fill).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edge {
    /// `value` is the first pixel right of the edge on the row it stands on.
    pub(crate) crossing: Cell<Stepper>,
    /// The first row it crosses, then [`ACTIVE`].
    pub(crate) y: Cell<i32>,
    /// Twice the row after its last, and 1 more if the contour goes up along it. Rows of places are below 2^24.
    end: i32,
    /// The next edge of a list.
    pub(crate) link: Cell<u16>,
    /// Nothing of this edge: the list of the bucket that has this place.
    pub(crate) bucket: Cell<u16>,
}

/// The row of all edges that are on their way: they are sorted by their crossings alone.
pub(crate) const ACTIVE: i32 = i32::MIN;

impl Edge {
    /// An empty slot, to make a table of.
    /// ```
    /// use embedded_raster::raster::Edge;
    /// static mut TABLE: [Edge; 64] = [Edge::EMPTY; 64];
    /// ```
    #[expect(clippy::declare_interior_mutable_const, reason = "it is copied into every slot")]
    pub const EMPTY: Self = Self {
        crossing: Cell::new(Stepper::still(0)),
        y: Cell::new(0),
        end: 0,
        link: Cell::new(0),
        bucket: Cell::new(0),
    };

    /// Puts the side from `upper` to `lower` into this slot, as it stands on the first of the rows `y..end`, which it
    /// crosses, `skip` rows below the first of all that it crosses; `down` if its contour goes that way.
    #[inline(always)]
    pub(crate) fn put(&mut self, upper: Vertex, lower: Vertex, skip: i32, (y, end): (i32, i32), down: bool) {
        let Some(slope) = Slope::new(bits(upper), bits(lower)) else { return };
        let rows = end.wrapping_sub(y);
        // Two stores: of one, the smaller side's numbers would go by way of the stack.
        if slope.is_small() {
            self.crossing.set(slope.small(skip, rows));
        } else {
            self.crossing.set(slope.large(skip, rows));
        }
        self.y.set(y);
        self.end = end.wrapping_mul(2) | i32::from(!down);
    }

    /// The first pixel right of it.
    #[inline(always)]
    pub(crate) fn x(&self) -> i32 {
        self.crossing.get().value
    }

    /// The row after its last.
    #[inline(always)]
    pub(crate) fn end(&self) -> i32 {
        self.end >> 1
    }

    /// To the next row.
    #[inline(always)]
    pub(crate) fn step(&self) {
        let mut crossing = self.crossing.get();
        crossing.step();
        self.crossing.set(crossing);
    }

    /// What lists are sorted by.
    #[inline(always)]
    pub(crate) fn order(&self) -> (i32, i32) {
        (self.y.get(), self.x())
    }

    /// +1 when the contour goes down along it, -1 when up.
    #[inline(always)]
    pub(crate) fn winding(&self) -> i32 {
        self.end << 31 >> 31 | 1
    }
}

/// A side from its upper to its lower end, not horizontal.
#[derive(Copy, Clone)]
pub(crate) struct Slope {
    upper: (i32, i32),
    lower: (i32, i32),
    pub(crate) dy: NonZeroU32,
}

impl Slope {
    /// `None` if it is horizontal.
    #[inline(always)]
    pub(crate) fn new(upper: (i32, i32), lower: (i32, i32)) -> Option<Self> {
        // Not negative, so its 32 bits are the distance even beyond i32::MAX.
        let dy = NonZeroU32::new(unsigned(lower.1.wrapping_sub(upper.1)))?;
        Some(Self { upper, lower, dy })
    }

    /// Its crossings from `skip` rows below the first row it crosses, for `rows` rows; any size.
    #[inline(always)]
    pub(crate) fn stepper(self, skip: i32, rows: i32) -> Stepper {
        if self.is_small() {
            self.small(skip, rows)
        } else {
            self.large(skip, rows)
        }
    }

    /// Below 2^16 units in width and height.
    #[inline(always)]
    fn is_small(self) -> bool {
        (self.lower.0.abs_diff(self.upper.0) | self.dy.get()) < 1 << 16
    }

    /// The same by a division a row, for sides below 2^19 units (2,048 pixels) in width and height.
    #[inline(always)]
    pub(crate) fn quotients(self, skip: i32) -> Quotients {
        let (p, m, dx) = self.numerator(skip);
        // |m| is below 2^11 dy: with 2^12 dy it is a positive number below 2^32.
        let n = unsigned(m).wrapping_add(self.dy.get() << 12);
        Quotients { n, dx, dy: self.dy, p: p.wrapping_sub(1 << 12) }
    }

    /// (p, M, dx) for sides below 2^19 units.
    #[inline(always)]
    fn numerator(self, skip: i32) -> (i32, i32, i32) {
        let (p, f, g) = self.start();
        let dx = self.lower.0.wrapping_sub(self.upper.0);
        let n = signed(f.wrapping_mul(self.dy.get())).wrapping_add(signed(g).wrapping_mul(dx));
        (p, (n.wrapping_sub(1) >> 8).wrapping_add(skip.wrapping_mul(dx)), dx)
    }

    /// (p, f, g): the pixel and fraction of the upper end, and the distance down to the first centre below it.
    #[inline(always)]
    fn start(self) -> (i32, u32, u32) {
        let (ax, ay) = self.upper;
        (first_centre_after(ax), unsigned(ax.wrapping_add(128)) & 255, 128_u32.wrapping_sub(unsigned(ay)) & 255)
    }

    #[inline(always)]
    fn small(self, skip: i32, rows: i32) -> Stepper {
        let (p, m, dx) = self.numerator(skip);
        let (k, rest) = floor_div_rem(m, self.dy);
        let slope = if rows > 1 { floor_div_rem(dx, self.dy) } else { (0, 0) };
        Stepper::new(self.dy, (p.wrapping_add(k), rest), slope)
    }

    #[cold]
    #[inline(never)]
    fn large(self, skip: i32, rows: i32) -> Stepper {
        let (p, f, g) = self.start();
        let dx = difference(self.lower.0, self.upper.0);
        let n = signed_wide(u64::from(f) * u64::from(self.dy.get())).wrapping_add(dx.wrapping_mul(i64::from(g)));
        let m = (n.wrapping_sub(1) >> 8).wrapping_add(dx.wrapping_mul(i64::from(skip)));
        let (k, rest) = floor_div_rem_wide(m, self.dy);
        // A second row is a pixel lower: then dy > 256, and the slope fits 32 bits with room to spare.
        let slope = if rows > 1 && self.dy.get() > 256 { floor_div_rem_wide(dx, self.dy) } else { (0, 0) };
        Stepper::new(self.dy, (p.wrapping_add(k), rest), slope)
    }
}

/// A way down the crossings of a side.
pub(crate) trait Crossings: Copy {
    /// Whether it is right for sides of any size, or only below 2^19 units in width and height.
    const ANY_SIZE: bool;
    /// The same pixel on every row.
    fn constant(x: i32) -> Self;
    /// From `skip` rows below the first row that the side crosses, for `rows` rows.
    fn new(side: Slope, skip: i32, rows: i32) -> Self;
    /// The first pixel right of the side on this row.
    fn x(self) -> i32;
    /// To the next row.
    fn step(&mut self);
}

impl Crossings for Stepper {
    const ANY_SIZE: bool = true;

    #[inline(always)]
    fn constant(x: i32) -> Self {
        Self::still(x)
    }

    #[inline(always)]
    fn new(side: Slope, skip: i32, rows: i32) -> Self {
        side.stepper(skip, rows)
    }

    #[inline(always)]
    fn x(self) -> i32 {
        self.value
    }

    #[inline(always)]
    fn step(&mut self) {
        self.step();
    }
}

/// Crossings as quotients: no set-up, half the state of a [`Stepper`], one division a row. The best way wherever a chip
/// divides in a few cycles and sides are too short to earn a set-up back.
#[derive(Copy, Clone)]
pub(crate) struct Quotients {
    n: u32,
    dx: i32,
    dy: NonZeroU32,
    p: i32,
}

impl Crossings for Quotients {
    const ANY_SIZE: bool = false;

    #[inline(always)]
    fn constant(x: i32) -> Self {
        Self { n: 0, dx: 0, dy: NonZeroU32::MIN, p: x }
    }

    #[inline(always)]
    fn new(side: Slope, skip: i32, _: i32) -> Self {
        side.quotients(skip)
    }

    #[inline(always)]
    fn x(self) -> i32 {
        self.p.wrapping_add(signed(self.n / self.dy))
    }

    #[inline(always)]
    fn step(&mut self) {
        self.n = self.n.wrapping_add(unsigned(self.dx));
    }
}
