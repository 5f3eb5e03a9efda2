//! [`Paint`]: what happens to the pixels of a shape.

use crate::{
    span::{ClippedSpan, Octants, Rect, SoftRow, Span, Steps},
    surface::Surface,
};

/// What happens to the pixels of a shape on surfaces of the type `S`.
///
/// The methods are those of a [`Sink`](crate::Sink), with a surface to draw on; all but [`span`](Self::span) are shortcuts.
/// All pixels that it is given lie in the window of the surface.
///
/// A paint is passed by value. One that must remember something beyond the call is passed as `&mut`.
pub trait Paint<S: Surface + ?Sized> {
    /// Paints pixels of one row.
    fn span(&mut self, on: &mut S, span: ClippedSpan);

    /// Paints a rectangle. By default, row by row.
    #[inline]
    fn area(&mut self, on: &mut S, area: Rect) {
        let Rect { x0, y0, x1, y1 } = area;
        for y in y0..y1 {
            if let Some(span) = (Span { y, x0, x1 }).known_inside() {
                self.span(on, span);
            }
        }
    }

    /// Paints pixels of one row that a shape covers in part: of each, so many 255ths as `levels` says, from left to right. By
    /// default, those that are covered by half or more, as if they were covered as a whole.
    #[inline]
    fn coverage(&mut self, on: &mut S, span: ClippedSpan, levels: &[u8]) {
        span.covered(levels, |span| self.span(on, span));
    }

    /// Paints pixels of one row, and rims on both sides that are covered in part. By default, by [`coverage`](Self::coverage) and
    /// [`span`](Self::span).
    #[inline]
    fn soft_row(&mut self, on: &mut S, row: SoftRow<'_>) {
        row.each(|span, levels| match levels {
            Some(levels) => self.coverage(on, span, levels),
            None => self.span(on, span),
        });
    }

    /// Paints a line one pixel wide. By default, row by row.
    #[inline]
    fn steps(&mut self, on: &mut S, steps: Steps) {
        steps.spans(|span| self.span(on, span));
    }

    /// Paints the outline of a circle, if it can do that as a whole. If not, it returns `false`, and is given the same pixels in
    /// spans.
    #[inline]
    fn octants(&mut self, on: &mut S, octants: Octants) -> bool {
        let _ = (on, octants);
        false
    }
}

impl<S: Surface + ?Sized, P: Paint<S> + ?Sized> Paint<S> for &mut P {
    #[inline(always)]
    fn span(&mut self, on: &mut S, span: ClippedSpan) {
        (**self).span(on, span);
    }

    #[inline(always)]
    fn area(&mut self, on: &mut S, area: Rect) {
        (**self).area(on, area);
    }

    #[inline(always)]
    fn coverage(&mut self, on: &mut S, span: ClippedSpan, levels: &[u8]) {
        (**self).coverage(on, span, levels);
    }

    #[inline(always)]
    fn soft_row(&mut self, on: &mut S, row: SoftRow<'_>) {
        (**self).soft_row(on, row);
    }

    #[inline(always)]
    fn steps(&mut self, on: &mut S, steps: Steps) {
        (**self).steps(on, steps);
    }

    #[inline(always)]
    fn octants(&mut self, on: &mut S, octants: Octants) -> bool {
        (**self).octants(on, octants)
    }
}
