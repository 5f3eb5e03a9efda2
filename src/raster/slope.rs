//! [`Slope`]: a side of a shape, as the first pixel right of it on each row.
//!
//! An edge from (ax, ay) down to (bx, by), with `dx = bx - ax` and `dy = by - ay > 0` in 24.8 units, crosses the rows whose
//! centre `cy = 256 y + 128` has `ay <= cy < by`. On row y, the first pixel whose centre lies at or right of it is
//! ```text
//!     k = ceil(N / (256 dy))        N = (ax - 128) dy + (cy - ay) dx
//! ```
//! Writing `ax + 128 = 256 p + f` and using `ceil(n / d) = floor((n - 1) / d) + 1` and
//! `floor(floor(n / 256) / d) = floor(n / (256 d))`, this is
//! ```text
//!     k = p + floor(M / dy)         M = floor((f dy + (cy - ay) dx - 1) / 256)
//! ```
//! One row down, M grows by exactly dx, so k is kept by a [`Stepper`] that adds `dx / dy`.
//!
//! Range: any `I24F8`. While dx and dy are below 2^16 (a box of 255 pixels) and the crossing rows at most 256, M stays
//! below 2^25 and set-up is two 32-bit divisions; larger edges multiply in 64 bits and divide with
//! [`div_rem_wide`](crate::num::round::div_rem_wide). An edge that crosses one row only needs no slope.

use core::num::NonZeroU32;

use crate::{
    num::{
        cast::{signed, unsigned},
        round::{div_rem_wide, first_centre_after, floor_div_rem},
        stepper::Stepper,
    },
    tune::{COMPACT, DIVIDES},
};

/// Whether small sides have a way of their own, in 32 bits.
const NARROW: bool = !COMPACT;

/// A side from one end to the other, not horizontal.
#[derive(Copy, Clone)]
pub(super) struct Slope {
    pub(super) from: (i32, i32),
    to: (i32, i32),
    /// From the upper end to the lower one, whichever of them is `from`. Modulo 2^32.
    pub(super) dx: i32,
    pub(super) dy: NonZeroU32,
}

impl Slope {
    /// `None` if it is horizontal.
    #[inline(always)]
    pub(super) fn new(upper: (i32, i32), lower: (i32, i32)) -> Option<Self> {
        Self::either_way(upper, lower, true)
    }

    /// From a to b, which is `down` or up from it. `None` if it is horizontal.
    #[inline(always)]
    pub(super) fn either_way(a: (i32, i32), b: (i32, i32), down: bool) -> Option<Self> {
        let (dx, dy) = (b.0.wrapping_sub(a.0), b.1.wrapping_sub(a.1));
        let (dx, dy) = if down { (dx, dy) } else { (dx.wrapping_neg(), dy.wrapping_neg()) };
        // Not negative, so its 32 bits are the distance even beyond i32::MAX.
        Some(Self { from: a, to: b, dx, dy: NonZeroU32::new(unsigned(dy))? })
    }

    /// Its crossings from row y, which it crosses, for `rows` rows; any size.
    #[inline(always)]
    pub(super) fn stepper_at(self, y: i32, rows: i32) -> Stepper {
        if self.is_small() {
            self.small_at(y, rows)
        } else {
            self.any_at(y)
        }
    }

    /// The same below 2^16 units in width and height.
    #[inline(always)]
    pub(super) fn small_at(self, y: i32, rows: i32) -> Stepper {
        self.small(self.down_to(y), rows)
    }

    /// The same for any size and any number of rows.
    #[inline(always)]
    pub(super) fn any_at(self, y: i32) -> Stepper {
        Self::any(self.from, self.to, self.dy, y)
    }

    /// Below 2^16 units in width and height.
    #[inline(always)]
    pub(super) fn is_small(self) -> bool {
        NARROW && (self.to.0.abs_diff(self.from.0) | self.dy.get()) < 1 << 16
    }

    /// From where it starts down to the centre of row y, which it crosses: at most dy, and negative if it goes up.
    #[inline(always)]
    pub(super) fn down_to(self, y: i32) -> i32 {
        (y << 8).wrapping_add(128).wrapping_sub(self.from.1)
    }

    /// p and M, for sides below 2^19 units. The end `from` is a, even if it is the lower one. Seen from the other end, p would
    /// be larger by some n and M smaller by n dy, so that crossing and remainder are the same.
    #[inline(always)]
    pub(super) fn numerator(self, down: i32) -> (i32, i32) {
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

    /// n / dy, rounded down, and the remainder, for quotients of -512 or more. M has such a quotient, as the crossing lies between
    /// the ends of the side. So has dx where there is a second row, as dy is above 2^8 then.
    #[inline(always)]
    fn ratio(self, n: i32) -> (i32, u32) {
        if !DIVIDES {
            // A division bit by bit takes less time for a smaller number.
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
    #[cold]
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
