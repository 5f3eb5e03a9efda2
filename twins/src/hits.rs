//! [`Hits`]: a surface that counts how often each pixel is painted.

use embedded_graphics_core::pixelcolor::BinaryColor;
use embedded_raster::{ClippedSpan, Rect, Surface};

use super::{runs_where, Run};

/// Notices overlaps (a count above 1) and spans that leave the window (it panics).
pub struct Hits {
    window: Rect,
    counts: Vec<u32>,
}

impl Hits {
    /// Nothing is painted yet.
    pub fn new(window: Rect) -> Self {
        let size = window.width() as usize * window.height() as usize;
        Self { window, counts: vec![0; size] }
    }

    fn at(&self, x: i32, y: i32) -> usize {
        assert!(self.window.contains(x, y), "({x}, {y}) is painted outside of {:?}", self.window);
        let (column, row) = (i64::from(x) - i64::from(self.window.x0), i64::from(y) - i64::from(self.window.y0));
        row as usize * self.window.width() as usize + column as usize
    }

    /// How often a pixel was painted.
    pub fn count(&self, x: i32, y: i32) -> u32 {
        self.counts[self.at(x, y)]
    }

    /// Paints some runs.
    pub fn add(&mut self, runs: &[Run]) {
        for &(y, x0, x1) in runs {
            for x in x0..x1 {
                let at = self.at(x, y);
                self.counts[at] += 1;
            }
        }
    }

    /// The painted pixels. Fails if one was painted twice.
    pub fn runs(&self) -> Vec<Run> {
        runs_where(self.window, |x, y| {
            let count = self.count(x, y);
            assert!(count < 2, "({x}, {y}) is painted {count} times");
            count == 1
        })
    }
}

impl Surface for Hits {
    type Color = BinaryColor;

    fn window(&self) -> Rect {
        self.window
    }

    fn fill_span(&mut self, span: ClippedSpan, _: BinaryColor) {
        self.add(&[(span.y(), span.x0(), span.x1())]);
    }
}
