//! What shapes and surfaces share: runs of pixels, and the steps of a line.
//!
//! A shape knows nothing of pixels in memory and a surface nothing of shapes. A [`Span`] may lie anywhere; clipped once
//! against the window of a surface it becomes a [`ClippedSpan`], whose fields cannot be set from outside: whoever holds
//! one need not check again. [`Steps`] are the same for a line one pixel wide.

use crate::{
    num::cast::{signed, unsigned},
    rect::Rect,
};

/// Pixels `x0..x1` of row `y`, anywhere. Empty when `x0 >= x1`.
/// ```
/// use embedded_raster::{Rect, Span};
/// let window = Rect::new(0, 0, 64, 48);
/// let span = Span { y: 3, x0: -10, x1: 5 }.clip(window).unwrap();
/// assert_eq!((span.x0(), span.x1(), span.y()), (0, 5, 3));
/// assert!(Span { y: 48, x0: 0, x1: 5 }.clip(window).is_none());
/// ```
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Span {
    /// Row.
    pub y: i32,
    /// First pixel.
    pub x0: i32,
    /// The pixel after the last.
    pub x1: i32,
}

impl Span {
    /// The part of it inside `window`, if there is one.
    #[inline(always)]
    pub fn clip(self, window: Rect) -> Option<ClippedSpan> {
        if self.y < window.y0 || self.y >= window.y1 {
            return None;
        }
        self.clip_columns(window)
    }

    /// [`clip`](Self::clip) for a row that is known to lie in the window.
    #[inline(always)]
    pub(crate) fn clip_columns(self, window: Rect) -> Option<ClippedSpan> {
        let (x0, x1) = (self.x0.max(window.x0), self.x1.min(window.x1));
        (x0 < x1).then_some(ClippedSpan { y: self.y, x0, x1 })
    }

    /// [`clip`](Self::clip) for a span that is known to lie in the window if it is not empty.
    #[inline(always)]
    pub(crate) fn known_inside(self) -> Option<ClippedSpan> {
        (self.x0 < self.x1).then_some(ClippedSpan { y: self.y, x0: self.x0, x1: self.x1 })
    }
}

impl ClippedSpan {
    /// A span of a shape that lies in the window as a whole. Not empty: `x0 < x1`.
    #[inline(always)]
    pub(crate) const fn inside(y: i32, x0: i32, x1: i32) -> Self {
        Self { y, x0, x1 }
    }
}

/// A [`Span`] that has at least one pixel and lies inside the window that it was clipped against.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct ClippedSpan {
    y: i32,
    x0: i32,
    x1: i32,
}

impl ClippedSpan {
    /// Row.
    #[inline(always)]
    pub const fn y(self) -> i32 {
        self.y
    }

    /// First pixel.
    #[inline(always)]
    pub const fn x0(self) -> i32 {
        self.x0
    }

    /// The pixel after the last.
    #[inline(always)]
    pub const fn x1(self) -> i32 {
        self.x1
    }

    /// Number of pixels, at least 1.
    #[inline(always)]
    #[expect(clippy::len_without_is_empty, reason = "it is never empty")]
    pub const fn len(self) -> u32 {
        unsigned(self.x1.wrapping_sub(self.x0))
    }
}

/// The visible pixels of a one pixel wide line, from the top down: where it enters the window, where it leaves it, and when
/// it steps aside.
///
/// From pixel to pixel the line moves by one along its major axis, and sometimes by one along the minor axis too. A line
/// that was drawn upwards is turned round, with its ties.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Steps {
    pub(crate) first: (i32, i32),
    /// Visible steps along the major axis: pixels after the first.
    pub(crate) left: u32,
    /// Visible steps along the minor axis.
    pub(crate) sideways: u32,
    /// 1 to the right, -1 to the left.
    pub(crate) x_step: i32,
    pub(crate) steep: bool,
    /// Bresenham's decision: `r - da`, where `r < da` is the remainder of the minor steps made so far.
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
        Some(ClippedSpan { y, x0: x0.min(x1), x1: x0.max(x1).wrapping_add(1) })
    }

    /// Decides the step to the next pixel: does it move along the minor axis too?
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
                emit(ClippedSpan { y, x0: start.min(x), x1: start.max(x).wrapping_add(1) });
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
