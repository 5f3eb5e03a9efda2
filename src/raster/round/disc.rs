//! [`Disc`]: a filled circle that lies in the window as a whole, which is what is drawn most.

use super::curve::{is_inside, is_small_circle, Ellipse};
use crate::{
    num::cast::unsigned,
    span::{ClippedSpan, Rect, Sink},
    tune::{keep_rolled, COMPACT},
};

/// Whether discs have a way of their own; built for size, they are ellipses.
pub(super) const DISCS: bool = !COMPACT;

/// The rows of a disc, top row first, without what clipping takes and with fewer registers.
///
/// With u of the first pixel that is not drawn and v of the row, `f = floor((u^2 + v^2 - a^2 - 1) / 4)`. From the top to the
/// middle the rows become wider, while f is negative at their end. From the middle to the bottom all goes backwards: the same
/// additions are taken back, while f stays positive one pixel further in.
pub(super) struct Disc {
    f: i32,
    /// What f gains to the next pixel.
    step: i32,
    /// What f gains to the next row.
    down: i32,
    /// The first pixel that is not drawn, from the one right of the middle on.
    end: i32,
    /// Both ends of a row together.
    sum: i32,
    y: i32,
    /// Rows that are left down to the middle, that one included.
    upper: u32,
    /// Rows that are left below it.
    lower: u32,
}

impl Disc {
    /// By its box, at most 32,768 pixels wide. In a larger box it is the four corners: the halves of the disc are moved
    /// apart, and the rows between are left out.
    #[inline(always)]
    pub(super) fn new(Rect { x0, y0, x1, .. }: Rect, diameter: i32) -> Self {
        // From the middle, u = 0 or 1, on the first row, v = 1 - a.
        let odd = diameter & 1;
        let half = diameter.wrapping_add(odd) >> 1;
        Self {
            f: (1 - odd).wrapping_sub(diameter.wrapping_mul(2)) >> 2,
            step: 2 - odd,
            down: 2_i32.wrapping_sub(diameter),
            end: x1.wrapping_sub(half),
            sum: x0.wrapping_add(x1),
            y: y0,
            upper: unsigned(half),
            lower: unsigned(half.wrapping_sub(odd)),
        }
    }

    /// The disc that an ellipse is, if it is small and in its box, and all of it lies in the window.
    #[inline(always)]
    pub(super) fn of(ellipse: &Ellipse, window: Rect) -> Option<Self> {
        let area = ellipse.extent();
        let is_disc = DISCS && ellipse.is_in_box() && is_inside(area, window) && is_small_circle(area);
        is_disc.then(|| Self::new(area, area.x1.wrapping_sub(area.x0)))
    }

    /// The next row of the upper half.
    #[inline(always)]
    pub(super) fn next_upper(&mut self) -> Option<ClippedSpan> {
        self.upper = self.upper.checked_sub(1)?;
        while self.f < 0 {
            self.f = self.f.wrapping_add(self.step);
            self.step = self.step.wrapping_add(2);
            self.end = self.end.wrapping_add(1);
            // Unrolled, the loop costs more than it saves: mostly it is taken once or not at all.
            keep_rolled();
        }
        // A disc of odd width has a row in the middle that nothing mirrors; its steps are odd.
        if self.upper > 0 || self.step & 1 == 0 {
            self.f = self.f.wrapping_add(self.down);
            self.down = self.down.wrapping_add(2);
        }
        Some(self.row())
    }

    /// The next row of the lower half, which mirrors one of the upper.
    #[inline(always)]
    pub(super) fn next_lower(&mut self) -> Option<ClippedSpan> {
        self.lower = self.lower.checked_sub(1)?;
        self.down = self.down.wrapping_sub(2);
        self.f = self.f.wrapping_sub(self.down);
        loop {
            let step = self.step.wrapping_sub(2);
            let before = self.f.wrapping_sub(step);
            if before < 0 {
                return Some(self.row());
            }
            (self.f, self.step) = (before, step);
            self.end = self.end.wrapping_sub(1);
            keep_rolled();
        }
    }

    /// Goes over the rows between the halves.
    #[inline(always)]
    pub(super) fn skip_to(&mut self, y: i32) {
        self.y = y;
    }

    /// Never empty: on every row of a disc the pixels next to the middle lie inside.
    #[inline(always)]
    fn row(&mut self) -> ClippedSpan {
        let y = self.y;
        self.y = y.wrapping_add(1);
        ClippedSpan::inside(y, self.sum.wrapping_sub(self.end), self.end)
    }
}

/// Emits a disc: in a function of its own, with registers of its own.
#[inline(never)]
pub(super) fn fill(mut disc: Disc, mut sink: impl Sink) {
    while let Some(span) = if disc.upper > 0 { disc.next_upper() } else { disc.next_lower() } {
        sink.span(span);
    }
}
