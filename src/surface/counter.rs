//! [`Counter`]: a surface that paints nothing and counts.

use core::marker::PhantomData;

use embedded_graphics_core::pixelcolor::PixelColor;

use super::traits::Surface;
use crate::span::{ClippedSpan, Rect};

/// Counts the pixels and spans that drawing would write: what a scene costs before there is memory for it.
/// ```
/// use embedded_graphics_core::pixelcolor::Rgb565;
/// use embedded_raster::{surface::Counter, Canvas, Rect, PointFx};
/// let mut counter = Counter::<Rgb565>::new(Rect::new(0, 0, 320, 240));
/// counter.fill_triangle_fx([PointFx::px(0, 0), PointFx::px(100, 0), PointFx::px(0, 100)], Rgb565::default());
/// assert_eq!((counter.pixels, counter.spans), (4950, 99));
/// ```
#[derive(Copy, Clone, Debug)]
pub struct Counter<C> {
    window: Rect,
    /// Pixels written. One that is written twice counts twice.
    pub pixels: u64,
    /// Spans written.
    pub spans: u64,
    color: PhantomData<C>,
}

impl<C> Counter<C> {
    /// Counts in a window of any size.
    pub const fn new(window: Rect) -> Self {
        Self { window, pixels: 0, spans: 0, color: PhantomData }
    }
}

impl<C: PixelColor> Surface for Counter<C> {
    type Color = C;

    #[inline]
    fn window(&self) -> Rect {
        self.window
    }

    #[inline]
    fn fill_span(&mut self, span: ClippedSpan, _: C) {
        self.pixels = self.pixels.saturating_add(u64::from(span.len()));
        self.spans = self.spans.saturating_add(1);
    }

    #[inline]
    fn fill_area(&mut self, area: Rect, _: C) {
        let area = area.intersection(self.window);
        if !area.is_empty() {
            let rows = u64::from(area.height());
            self.pixels = self.pixels.saturating_add(rows.saturating_mul(area.width().into()));
            self.spans = self.spans.saturating_add(rows);
        }
    }
}
