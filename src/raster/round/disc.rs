//! [`Disc`]: a filled circle that lies in the window as a whole, which is what is drawn most.

use super::curve::{is_inside, is_small_circle, Ellipse};
use crate::{
    num::cast::unsigned,
    span::{ClippedSpan, Rect, Sink},
    tune::{keep_rolled, ARMV7, COMPACT},
};

/// Whether discs have a way of their own; built for size, they are ellipses.
pub(super) const DISCS: bool = !COMPACT;

/// The rows of a disc, top row first, without what clipping takes and with fewer registers.
///
/// With u of the first pixel that is not drawn and v of the row, `f = floor((u^2 + v^2 - a^2 - 1) / 4)`. From row to row f
/// gains `v + 1`. Down to the middle the rows become wider, while f is negative at their end; below it they become narrower,
/// while f is not negative one pixel further in.
#[derive(Copy, Clone)]
pub(super) struct Disc {
    f: i32,
    /// What f gains to the next pixel.
    step: i32,
    /// What f gains to the next row: `v + 1`.
    down: i32,
    /// The first pixel that is not drawn, from the one right of the middle on.
    end: i32,
    /// Both ends of a row together.
    sum: i32,
    y: i32,
    /// Rows that are left.
    left: u32,
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
            // floor((1 - odd - 2 * diameter) / 4), where diameter = 2 * half - odd.
            f: half.wrapping_neg(),
            step: 2 - odd,
            down: 2_i32.wrapping_sub(diameter),
            end: x1.wrapping_sub(half),
            sum: x0.wrapping_add(x1),
            y: y0,
            left: unsigned(diameter),
        }
    }

    /// The disc that an ellipse is, if it is small and in its box, and all of it lies in the window.
    #[inline(always)]
    pub(super) fn of(ellipse: &Ellipse, window: Rect) -> Option<Self> {
        let area = ellipse.extent();
        let is_disc = DISCS && ellipse.is_in_box() && is_inside(area, window) && is_small_circle(area);
        is_disc.then(|| Self::new(area, area.x1.wrapping_sub(area.x0)))
    }

    /// The next row. Never empty: on every row of a disc the pixels next to the middle lie inside.
    #[inline(always)]
    pub(super) fn next(&mut self) -> Option<ClippedSpan> {
        self.left = self.left.checked_sub(1)?;
        if self.is_upper() {
            while self.f < 0 {
                self.f = self.f.wrapping_add(self.step);
                self.step = self.step.wrapping_add(2);
                #[cfg(test)]
                crate::num::tally::add(crate::num::tally::Work::Step);
                self.end = self.end.wrapping_add(1);
                // Unrolled, the loop costs more than it saves: mostly it is taken once or not at all.
                keep_rolled(ARMV7);
            }
        } else {
            loop {
                let before = self.f.wrapping_sub(self.step).wrapping_add(2);
                if before < 0 {
                    break;
                }
                self.f = before;
                self.step = self.step.wrapping_sub(2);
                #[cfg(test)]
                crate::num::tally::add(crate::num::tally::Work::Step);
                self.end = self.end.wrapping_sub(1);
                keep_rolled(ARMV7);
            }
        }
        #[cfg(test)]
        crate::num::tally::add(crate::num::tally::Work::Step);
        self.f = self.f.wrapping_add(self.down);
        self.down = self.down.wrapping_add(2);
        let y = self.y;
        self.y = y.wrapping_add(1);
        Some(ClippedSpan::inside(y, self.sum.wrapping_sub(self.end), self.end))
    }

    /// Whether the next row lies above the middle or in it: v is 0 or less.
    #[inline(always)]
    pub(super) fn is_upper(&self) -> bool {
        self.down < 2
    }

    /// Goes over the rows between the halves.
    #[inline(always)]
    pub(super) fn skip_to(&mut self, y: i32) {
        self.y = y;
    }
}

/// Emits a disc: in a function of its own, with registers of its own. What is passed by value would stay in the caller's
/// memory; the copy does not.
#[inline(never)]
pub(super) fn fill(disc: &Disc, mut sink: impl Sink) {
    let mut disc = *disc;
    while let Some(span) = disc.next() {
        sink.span(span);
    }
}
