//! [`Solid`]: one colour.

use super::traits::Paint;
use crate::{
    span::{ClippedSpan, Octants, Rect, Steps},
    surface::Surface,
};

/// One colour for all pixels.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Solid<C>(pub C);

impl<S: Surface + ?Sized> Paint<S> for Solid<S::Color> {
    #[inline(always)]
    fn span(&mut self, on: &mut S, span: ClippedSpan) {
        on.fill_span(span, self.0);
    }

    #[inline(always)]
    fn area(&mut self, on: &mut S, area: Rect) {
        on.fill_area(area, self.0);
    }

    #[inline(always)]
    fn steps(&mut self, on: &mut S, steps: Steps) {
        on.fill_steps(steps, self.0);
    }

    #[inline(always)]
    fn octants(&mut self, on: &mut S, octants: Octants) -> bool {
        on.fill_octants(octants, self.0)
    }
}
