//! [`Octants`]: the outline of a circle by one eighth of it and seven mirror images.
//! ```text
//!       .  0 1 2 .         the steps of one octant, and the same mirrored in both axes and in the diagonals
//!     .  .       3 .
//!    .             4
//! ```
//! Distances u and v are measured from the centre of the circle, in half pixels: u to the centre of a column, v to that of a
//! row. In a box of `a + 1` pixels the curve runs through the centres of the outermost pixels, so it is `u^2 + v^2 = a^2`. All u
//! and v are even if a is even, and odd if a is odd.
//!
//! **The steps.** In column u, the pixel nearest to the curve (the outer one of two that are equally near) is the first one from
//! outside with `u^2 + (v - 1)^2 <= a^2`. The octant goes from the middle, where `v = a`, to the diagonal, where `u = v`. From a
//! column to the next, the pixel moves inwards by one row at most. For if (u, v) is nearest, then
//! `(u + 2)^2 + (v - 3)^2 <= a^2 + 4 (u - v) + 12`. Unless the next column is at the diagonal or beyond it, `u < v - 2`, which
//! is `u <= v - 4`, so the right side is below `a^2`: (u + 2, v - 2) passes the test.
//!
//! **The eight parts are the whole outline.** By the rule of outlines (see [`ellipse`](crate::raster::ellipse)) the pixel
//! nearest to the curve is drawn in every column and in every row. Let (k, v) be that of a column beyond the diagonal, `v < k`.
//! It has to be shown that it is also the one of its row; then it is the mirror image, in the diagonal, of the pixel of column v.
//! The curve crosses the column at a height y with `(v - 1)^2 <= y^2`. On row v it is at x, with
//! `x^2 = k^2 + y^2 - v^2 >= k^2 + 1 - 2 v >= k^2 + 5 - 2 k > (k - 1)^2`: it is not further in than half a pixel from k. If it is
//! further out than k, then by no more than y differs from v, as the curve is steep there. So (k, v) is nearest along its row.
//!
//! Source: J. E. Bresenham, "A linear algorithm for incremental digital display of circular arcs", Communications of the
//! ACM 20(2), 1977.

use super::rect::Rect;

/// The outline, one pixel wide, of a circle that lies in the window as a whole.
///
/// It is walked from the middle of the top row to the diagonal. Distances from the centre are in half pixels.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Octants {
    /// First column and first row of the box.
    x0: i32,
    y0: i32,
    /// Its width and height, less one.
    extent: i32,
    /// Distances from the centre: of the column, and of the row.
    u: i32,
    v: i32,
    /// Bresenham's decision: `floor((u^2 + (v - 1)^2 - a^2 - 1) / 4)`, below 0 while the row stays.
    decision: i32,
}

impl Octants {
    /// For a square box of `extent + 1` pixels inside the window, at most 32,768.
    #[inline(always)]
    pub(crate) const fn new(area: Rect) -> Self {
        let extent = area.x1.wrapping_sub(area.x0).wrapping_sub(1);
        let u = extent & 1;
        let decision = u.wrapping_sub(extent.wrapping_mul(2)) >> 2;
        Self { x0: area.x0, y0: area.y0, extent, u, v: extent, decision }
    }

    /// First column and first row of the box of pixels that the circle touches.
    #[inline(always)]
    pub const fn first(&self) -> (i32, i32) {
        (self.x0, self.y0)
    }

    /// Its width and height, less one.
    #[inline(always)]
    pub const fn extent(&self) -> i32 {
        self.extent
    }

    /// The distances of this pixel from the centre, in half pixels: of its column, and of its row, which is not less.
    #[inline(always)]
    pub(crate) const fn offsets(&self) -> (i32, i32) {
        (self.u, self.v)
    }

    /// Goes to the next column, and says whether its pixel is one row further in. `None` beyond the diagonal.
    #[inline(always)]
    pub(crate) fn next_is_inner(&mut self) -> Option<bool> {
        self.decision = self.decision.wrapping_add(self.u).wrapping_add(1);
        self.u = self.u.wrapping_add(2);
        let inner = self.decision >= 0;
        if inner {
            self.v = self.v.wrapping_sub(2);
            self.decision = self.decision.wrapping_sub(self.v);
        }
        (self.u <= self.v).then_some(inner)
    }
}
