//! [`Steps`]: a line one pixel wide, as what it does from pixel to pixel.

use super::row::ClippedSpan;
use crate::num::cast::signed;

/// The visible pixels of a one pixel wide line, from the top down: where it enters the window, where it leaves it, and when
/// it steps aside.
///
/// From pixel to pixel the line moves by one along its major axis, and sometimes by one along the minor axis too. A line that
/// was drawn upwards is given here from its other end; where two pixels are equally near, the choice is still the one of the
/// caller's direction.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Steps {
    pub(crate) first: (i32, i32),
    /// Visible steps along the major axis: pixels after the first.
    pub(crate) left: u32,
    /// Visible steps along the minor axis.
    pub(crate) sideways: u32,
    /// 1 to the right, -1 to the left.
    pub(crate) x_step: i32,
    pub(crate) steep: bool,
    /// Bresenham's decision: `r - major` modulo 2^32, where `r < major` is the remainder of the division that says how many
    /// minor steps were made so far (see `raster::line`). So adding `minor` carries when the next step is a minor one too.
    pub(crate) rest: u32,
    /// Length along the minor axis of the whole line.
    pub(crate) minor: u32,
    /// Length along the major axis of the whole line.
    pub(crate) major: u32,
}

impl Steps {
    /// Column and row of the first visible pixel.
    #[inline(always)]
    pub const fn first(&self) -> (i32, i32) {
        self.first
    }

    /// Column and row of the last visible pixel, which is not above the first.
    #[inline(always)]
    pub const fn last(&self) -> (i32, i32) {
        let (along, aside) = (self.left, self.sideways);
        let (dx, dy) = if self.steep { (aside, along) } else { (along, aside) };
        let dx = signed(dx).wrapping_mul(self.x_step);
        (self.first.0.wrapping_add(dx), self.first.1.wrapping_add(signed(dy)))
    }

    /// Number of visible pixels, at least 1.
    #[inline(always)]
    #[expect(clippy::len_without_is_empty, reason = "it is never empty")]
    pub const fn len(&self) -> u32 {
        self.left.wrapping_add(1)
    }

    /// Whether `y` is the major axis: every pixel has a row of its own.
    #[inline(always)]
    pub const fn is_steep(&self) -> bool {
        self.steep
    }

    /// Whether steps along x go to the right.
    #[inline(always)]
    pub const fn goes_right(&self) -> bool {
        self.x_step > 0
    }

    /// The visible pixels as a span, if they lie in one row.
    #[inline(always)]
    pub(crate) fn one_row(&self) -> Option<ClippedSpan> {
        if self.steep && self.left > 0 || self.sideways > 0 {
            return None;
        }
        let ((x0, y), (x1, _)) = (self.first, self.last());
        Some(ClippedSpan::inside(y, x0.min(x1), x0.max(x1).wrapping_add(1)))
    }

    /// Decides the step to the next pixel: does it move along the minor axis too?
    #[doc(hidden)]
    #[inline(always)]
    pub fn next_is_minor(&mut self) -> bool {
        let (rest, carry) = self.rest.overflowing_add(self.minor);
        self.rest = if carry { rest.wrapping_sub(self.major) } else { rest };
        carry
    }

    /// Emits the pixels as spans, top row first: one pixel a row for a steep line, runs for a flat one.
    pub fn spans(mut self, mut emit: impl FnMut(ClippedSpan)) {
        let (mut x, mut y) = self.first;
        let mut start = x;
        for left in (0..=self.left).rev() {
            let minor = self.next_is_minor();
            if left == 0 || minor || self.steep {
                emit(ClippedSpan::inside(y, start.min(x), start.max(x).wrapping_add(1)));
            }
            if !self.steep || minor {
                x = x.wrapping_add(self.x_step);
            }
            if self.steep || minor {
                (y, start) = (y.wrapping_add(1), x);
            }
        }
    }
}
