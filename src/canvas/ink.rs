//! [`in_color`]: the shapes of a canvas, clipped once.

use crate::{
    span::{ClippedSpan, Octants, Rect, Sink, Steps},
    surface::{Inside, Said, Surface},
};

/// Draws a shape in one colour.
///
/// It does what [`Canvas::paint`](super::Canvas::paint) does with a [`Solid`](crate::Solid) colour. But there a caller can give
/// the brush spans of any other window, so a frame clips them again. Here, `draw` is always a function of `raster`, which is
/// given this window and keeps to it.
#[inline(always)]
pub(super) fn in_color<S: Surface + ?Sized, R>(
    surface: &mut S,
    color: S::Color,
    draw: impl FnOnce(Rect, Ink<'_, S>) -> R,
) -> R {
    draw(surface.window(), Ink { surface, color })
}

/// A surface, and a colour to fill pixels with that lie in its window.
pub(super) struct Ink<'a, S: Surface + ?Sized> {
    surface: &'a mut S,
    color: S::Color,
}

impl<S: Surface + ?Sized> Sink for Ink<'_, S> {
    #[inline(always)]
    fn span(&mut self, span: ClippedSpan) {
        self.surface.fill_inside(Inside(Said::Span(span)), self.color);
    }

    #[inline(always)]
    fn area(&mut self, area: Rect) {
        self.surface.fill_area(area, self.color);
    }

    #[inline(always)]
    fn steps(&mut self, steps: Steps) {
        self.surface.fill_inside(Inside(Said::Steps(steps)), self.color);
    }

    #[inline(always)]
    fn octants(&mut self, octants: Octants) -> bool {
        self.surface.fill_inside(Inside(Said::Octants(octants)), self.color)
    }
}
