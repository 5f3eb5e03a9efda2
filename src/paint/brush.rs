//! [`Brush`]: a paint and a surface, which together receive a shape.

use super::traits::Paint;
use crate::{
    span::{ClippedSpan, Octants, Rect, Sink, SoftRow, Steps},
    surface::Surface,
};

/// A paint on a surface: the [`Sink`] that shapes are drawn with.
#[derive(Debug)]
pub struct Brush<'a, S: ?Sized, P> {
    surface: &'a mut S,
    paint: P,
}

impl<'a, S: Surface + ?Sized, P: Paint<S>> Brush<'a, S, P> {
    /// The sink that draws on `surface` in this paint.
    #[inline(always)]
    pub fn new(surface: &'a mut S, paint: P) -> Self {
        Self { surface, paint }
    }
}

impl<S: Surface + ?Sized, P: Paint<S>> Sink for Brush<'_, S, P> {
    #[inline(always)]
    fn span(&mut self, span: ClippedSpan) {
        self.paint.span(self.surface, span);
    }

    #[inline(always)]
    fn area(&mut self, area: Rect) {
        self.paint.area(self.surface, area);
    }

    #[inline(always)]
    fn coverage(&mut self, span: ClippedSpan, levels: &[u8]) {
        self.paint.coverage(self.surface, span, levels);
    }

    #[inline(always)]
    fn soft_row(&mut self, row: SoftRow<'_>) {
        self.paint.soft_row(self.surface, row);
    }

    #[inline(always)]
    fn steps(&mut self, steps: Steps) {
        self.paint.steps(self.surface, steps);
    }

    #[inline(always)]
    fn octants(&mut self, octants: Octants) -> bool {
        self.paint.octants(self.surface, octants)
    }
}
