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

use core::num::NonZeroU32;

use crate::{
    geom::{bits, Vertex},
    num::{
        cast::{signed, signed_wide, unsigned},
        round::{difference, first_centre_after, first_centre_from, floor_div_rem, floor_div_rem_wide},
        stepper::{Stepper, Walk},
    },
};

/// One slot of an edge table: a side on its way down the rows. See [`polygon::fill`](crate::raster::polygon::fill).
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Edge {
    /// `value` is the first pixel right of the edge on the row it stands on.
    pub(crate) crossing: Stepper,
    /// The row it stands on.
    pub(crate) y: i32,
    /// The row after its last.
    pub(crate) end: i32,
    /// +1 when the contour goes down along it, -1 when up.
    pub(crate) winding: i32,
}

impl Edge {
    /// An empty slot, to make a table of.
    /// ```
    /// use embedded_raster::raster::Edge;
    /// static mut TABLE: [Edge; 64] = [Edge::EMPTY; 64];
    /// ```
    pub const EMPTY: Self = Self { crossing: Stepper::ZERO, y: 0, end: 0, winding: 0 };

    /// The rows of `top..bottom` that the side from `a` to `b` crosses.
    #[inline(always)]
    pub(crate) fn rows(a: Vertex, b: Vertex, top: i32, bottom: i32) -> (i32, i32) {
        let (ay, by) = (bits(a).1, bits(b).1);
        (first_centre_from(ay.min(by)).max(top), first_centre_from(ay.max(by)).min(bottom))
    }

    /// The side from `a` to `b` as it stands on the first of the rows `y..end`, which it crosses.
    #[inline]
    pub(crate) fn new(a: Vertex, b: Vertex, (y, end): (i32, i32)) -> Self {
        let (a, b) = (bits(a), bits(b));
        let (upper, lower, winding) = if a.1 <= b.1 { (a, b, 1) } else { (b, a, -1) };
        let Some(slope) = Slope::new(upper, lower) else { return Self::EMPTY };
        let skip = y.wrapping_sub(first_centre_from(upper.1));
        Self { crossing: slope.crossing(skip, end.wrapping_sub(y)), y, end, winding }
    }
}

/// A side from its upper to its lower end.
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
        let dy = NonZeroU32::new(lower.1.abs_diff(upper.1))?;
        Some(Self { upper, lower, dy })
    }

    /// A walk over its crossings that starts `skip` rows below the first row it crosses, good for `rows` rows.
    #[inline(always)]
    pub(crate) fn crossing<W: Walk>(self, skip: i32, rows: i32) -> W {
        let width = self.lower.0.abs_diff(self.upper.0);
        let (start, step) =
            if (width | self.dy.get()) < 1 << 16 { self.small(skip, rows) } else { self.large(skip, rows) };
        W::new(self.dy, start, step)
    }

    /// (p, f, g): the pixel and fraction of the upper end, and the distance down to the first centre below it.
    #[inline(always)]
    fn start(self) -> (i32, u32, u32) {
        let (ax, ay) = self.upper;
        (first_centre_after(ax), unsigned(ax.wrapping_add(128)) & 255, 128_u32.wrapping_sub(unsigned(ay)) & 255)
    }

    /// Quotient and remainder of the first crossing, and of what a row adds to it.
    #[inline(always)]
    fn small(self, skip: i32, rows: i32) -> ((i32, u32), (i32, u32)) {
        let (p, f, g) = self.start();
        let dx = self.lower.0.wrapping_sub(self.upper.0);
        let n = signed(f.wrapping_mul(self.dy.get())).wrapping_add(signed(g).wrapping_mul(dx));
        let m = (n.wrapping_sub(1) >> 8).wrapping_add(skip.wrapping_mul(dx));
        let (k, rest) = floor_div_rem(m, self.dy);
        let step = if rows > 1 { floor_div_rem(dx, self.dy) } else { (0, 0) };
        ((p.wrapping_add(k), rest), step)
    }

    #[cold]
    #[inline(never)]
    fn large(self, skip: i32, rows: i32) -> ((i32, u32), (i32, u32)) {
        let (p, f, g) = self.start();
        let dx = difference(self.lower.0, self.upper.0);
        let n = signed_wide(u64::from(f) * u64::from(self.dy.get())).wrapping_add(dx.wrapping_mul(i64::from(g)));
        let m = (n.wrapping_sub(1) >> 8).wrapping_add(dx.wrapping_mul(i64::from(skip)));
        let (k, rest) = floor_div_rem_wide(m, self.dy);
        // A second row is a pixel lower: dy > 256, and the slope fits 32 bits with room to spare.
        let step = if rows > 1 { floor_div_rem_wide(dx, self.dy) } else { (0, 0) };
        ((p.wrapping_add(k), rest), step)
    }
}
