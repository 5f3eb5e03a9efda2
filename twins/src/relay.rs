//! [`Relay`]: any sink, as one type.

use embedded_raster::{ClippedSpan, Octants, Rect, Sink, SoftRow, Steps};

/// Hands on what a shape says. A test that tries a hundred paints on a shape compiles the shape once, and not for each of them.
pub struct Relay<'a>(pub &'a mut dyn Sink);

impl Sink for Relay<'_> {
    fn span(&mut self, span: ClippedSpan) {
        self.0.span(span);
    }

    fn area(&mut self, area: Rect) {
        self.0.area(area);
    }

    fn coverage(&mut self, span: ClippedSpan, levels: &[u8]) {
        self.0.coverage(span, levels);
    }

    fn soft_row(&mut self, row: SoftRow<'_>) {
        self.0.soft_row(row);
    }

    fn steps(&mut self, steps: Steps) {
        self.0.steps(steps);
    }

    fn octants(&mut self, octants: Octants) -> bool {
        self.0.octants(octants)
    }
}
