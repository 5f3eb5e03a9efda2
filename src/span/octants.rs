//! [`Octants`]: the outline of a circle by one eighth of it and seven mirror images.
//! ```text
//!       .  0 1 2 .         the steps of one octant, and the same mirrored in both axes and in the diagonals
//!     .  .       3 .
//!    .             4
//! ```
//! In half pixels from the centre, the centres of the outermost pixels of a box of `a + 1` pixels lie on the circle
//! `u^2 + v^2 = a^2`; u and v are even if a is, odd if a is. The pixel of column u nearest to the curve, the outer one of
//! two, is the first from outside with `u^2 + (v - 1)^2 <= a^2`. From `v = a` at the middle down to the diagonal, `u <= v`,
//! it moves inwards by one pixel a column at most: if (u, v) is nearest then
//! `(u + 2)^2 + (v - 3)^2 <= a^2 + 4 (u - v) + 12`, and u is less than v - 2 unless the diagonal is next.
//!
//! **The mirror images are all.** By the rule of outlines (see [`ellipse`](crate::raster::ellipse)) the pixel nearest to
//! the crossing of every column and of every row is drawn. Let (k, v) be that of a column beyond the diagonal, v < k, the
//! curve crossing the column at y, so that `(v - 1)^2 <= y^2`. On the row v the curve is at x with
//! `x^2 = k^2 + y^2 - v^2 >= k^2 + 1 - 2 v >= k^2 + 5 - 2 k > (k - 1)^2`: no further in than half a pixel from k. And if x is
//! beyond k, it is so by no more than y is below or above v, as the curve is steep there. So (k, v) is nearest along the row
//! too: the mirror image, in the diagonal, of the pixel of column v.
//!
//! Source: J. E. Bresenham, "A linear algorithm for incremental digital display of circular arcs", Communications of the
//! ACM 20(2), 1977.

use super::rect::Rect;

/// The outline, one pixel wide, of a circle that lies in the window as a whole.
///
/// It starts at the middle of the top row, in units of half a pixel from the centre, and goes to the diagonal.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Octants {
    /// First column and first row of the box.
    x0: i32,
    y0: i32,
    /// Its width and height less one.
    extent: i32,
    /// Twice the distance of the column from the middle, and of the row.
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

    /// To the next column; whether its pixel is one row further in. `None` if it lies beyond the diagonal.
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
