//! [`Sink`]: what receives a shape.

use super::{
    octants::Octants,
    rect::Rect,
    row::{ClippedSpan, SoftRow},
    steps::Steps,
};

/// Receives a shape: everything that a shape may say to what it is drawn on.
///
/// A closure that takes spans is a sink, and so are a paint and a surface together
/// ([`Canvas::paint`](crate::Canvas::paint)). All but [`span`](Self::span) are shortcuts, for sinks that do them faster than
/// span by span.
///
/// **Order.** Shapes speak from the top down, in every build: each call begins on the row on which the call before it began, or
/// below. Spans of one row come from left to right. Two kinds of shapes follow their own path instead: lines from point to
/// point, and outlines of paths, one pixel wide.
///
/// **What is said** lies inside of the window that the shape was given, and is not empty. Filled shapes name each pixel once.
/// ```
/// use embedded_raster::{raster::rectangle, ClippedSpan, Rect};
/// let window = Rect::new(0, 0, 64, 48);
/// let mut rows = vec![];
/// rectangle::fill(Rect::new(-3, 46, 5, 90), window, |span: ClippedSpan| rows.push((span.y(), span.x0(), span.x1())));
/// assert_eq!(rows, [(46, 0, 5), (47, 0, 5)]);
/// ```
pub trait Sink {
    /// Pixels of one row.
    fn span(&mut self, span: ClippedSpan);

    /// Pixels of a rectangle. By default, row by row.
    #[inline]
    fn area(&mut self, area: Rect) {
        for y in area.y0..area.y1 {
            self.span(ClippedSpan::inside(y, area.x0, area.x1));
        }
    }

    /// Pixels of one row that a shape covers in part: of each, so many 255ths as `levels` says, from left to right. There are as
    /// many levels as pixels. By default, those that are covered by half or more, as spans: the shape without soft rims.
    #[inline]
    fn coverage(&mut self, span: ClippedSpan, levels: &[u8]) {
        span.covered(levels, |span| self.span(span));
    }

    /// Pixels of one row, covered as a whole, and rims on both sides. By default, as [coverage](Self::coverage), a
    /// [span](Self::span), and coverage.
    #[inline]
    fn soft_row(&mut self, row: SoftRow<'_>) {
        row.each(|span, levels| match levels {
            Some(levels) => self.coverage(span, levels),
            None => self.span(span),
        });
    }

    /// Pixels of a line one pixel wide. By default, row by row.
    #[inline]
    fn steps(&mut self, steps: Steps) {
        steps.spans(|span| self.span(span));
    }

    /// The outline of a circle, if the sink can draw it as a whole. If not, which is the default, it returns `false`, and is given
    /// the same pixels in spans, row by row.
    #[inline]
    fn octants(&mut self, octants: Octants) -> bool {
        let _ = octants;
        false
    }
}

impl<F: FnMut(ClippedSpan)> Sink for F {
    #[inline(always)]
    fn span(&mut self, span: ClippedSpan) {
        self(span);
    }
}
