//! Spans to bytes.
//!
//! A [`Surface`] is anything that spans can be painted on: a [`Framebuffer`], a band of one, [`Paged`] memory as small
//! OLEDs have it, a [`Counter`] of pixels, or any embedded-graphics `DrawTarget` (see [`eg`](crate::eg)). It has a
//! *window*, the pixels that it can paint, and paints spans that were clipped against that window.

mod blit;
mod counter;
mod framebuffer;
mod paged;

use embedded_graphics_core::pixelcolor::PixelColor;

pub use self::{
    blit::Bitmap,
    counter::Counter,
    framebuffer::Framebuffer,
    paged::{paged_bytes, Paged},
};
use crate::{
    octants::Octants,
    rect::Rect,
    span::{ClippedSpan, Span, Steps},
};

/// Something that spans can be painted on.
///
/// ```
/// use embedded_graphics_core::{geometry::Point, pixelcolor::BinaryColor};
/// use embedded_raster::{Canvas, ClippedSpan, Rect, Surface};
///
/// /// Keeps a list of what is painted.
/// struct Log(Vec<ClippedSpan>);
///
/// impl Surface for Log {
///     type Color = BinaryColor;
///     fn window(&self) -> Rect {
///         Rect::new(0, 0, 8, 8)
///     }
///     fn fill_span(&mut self, span: ClippedSpan, _: BinaryColor) {
///         self.0.push(span);
///     }
/// }
///
/// let mut log = Log(vec![]);
/// log.draw_line(Point::new(-9, 3), Point::new(9, 3), BinaryColor::On);
/// assert_eq!((log.0[0].x0(), log.0[0].x1()), (0, 8));
/// ```
pub trait Surface {
    /// What a pixel is painted with.
    type Color: PixelColor;

    /// The pixels that can be painted.
    fn window(&self) -> Rect;

    /// Paints the pixels of a span that was clipped against [`window`](Self::window).
    fn fill_span(&mut self, span: ClippedSpan, color: Self::Color);

    /// Paints the pixels of `area` that lie in the window.
    #[inline]
    fn fill_area(&mut self, area: Rect, color: Self::Color) {
        let area = area.intersection(self.window());
        for y in area.y0..area.y1 {
            if let Some(span) = (Span { y, x0: area.x0, x1: area.x1 }).clip_columns(area) {
                self.fill_span(span, color);
            }
        }
    }

    /// Paints the pixels of a line that was clipped against [`window`](Self::window).
    #[inline]
    fn fill_steps(&mut self, steps: Steps, color: Self::Color) {
        steps.spans(|span| self.fill_span(span, color));
    }

    /// Paints the outline of a circle that lies in the window as a whole.
    #[inline]
    fn fill_octants(&mut self, octants: Octants, color: Self::Color) {
        octants.spans(|span| self.fill_span(span, color));
    }
}
