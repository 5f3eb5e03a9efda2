//! [`Watched`]: a wrapper around memory that does no more than a surface must.

use std::collections::BTreeSet;

use embedded_raster::{ClippedSpan, Frame, Layout, Readable, Rect, Surface};

/// Notes which pixels are painted, and forwards spans and reading; all else is left to the defaults of the traits.
pub struct Watched<'a, L: Layout> {
    inner: Frame<&'a mut [u8], L>,
    /// Columns and rows.
    pub seen: BTreeSet<(i32, i32)>,
}

impl<'a, L: Layout> Watched<'a, L> {
    /// Nothing was painted yet.
    pub fn new(inner: Frame<&'a mut [u8], L>) -> Self {
        Self { inner, seen: BTreeSet::new() }
    }
}

impl<L: Layout> Surface for Watched<'_, L> {
    type Color = L::Color;

    fn window(&self) -> Rect {
        self.inner.window()
    }

    fn fill_span(&mut self, span: ClippedSpan, color: L::Color) {
        self.seen.extend((span.x0()..span.x1()).map(|x| (x, span.y())));
        self.inner.fill_span(span, color);
    }
}

impl<L: Layout> Readable for Watched<'_, L> {
    fn color_at(&self, x: i32, y: i32) -> L::Color {
        self.inner.color_at(x, y)
    }
}
