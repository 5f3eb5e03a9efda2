//! [`Screen`]: a surface around a frame, which stores what a scene draws as a [`Look`] says.
//!
//! It can paint a part of a drawing only, so that a display may be looked at in the middle: the pixels are counted as they are painted,
//! and those that are before the part, or behind it, are left as they are. Painted part by part, in their order, the frame is that of the
//! whole drawing.

use core::{marker::PhantomData, ops::Range};

use embedded_graphics_core::{geometry::Point, pixelcolor::Rgb888};
use embedded_raster::{ClippedSpan, Framebuffer, PixelFormat, Readable, Rect, Span, Surface};

use crate::look::{Hue, Look};

/// Takes colours of the type `C`, and stores pixels of the format `F`.
pub(crate) struct Screen<'a, 'm, F, C> {
    frame: &'a mut Framebuffer<'m, F>,
    look: &'a Look,
    part: Range<u32>,
    /// Pixels of the drawing so far. One that is painted twice counts twice.
    pub(crate) painted: u32,
    color: PhantomData<C>,
}

impl<'a, 'm, F: PixelFormat, C: Hue> Screen<'a, 'm, F, C> {
    /// Paints a part of a drawing: so many pixels of it, in the order in which they are painted.
    pub(crate) fn new(frame: &'a mut Framebuffer<'m, F>, look: &'a Look, part: Range<u32>) -> Self {
        Self { frame, look, part, painted: 0, color: PhantomData }
    }

    /// Counts the pixels of a span, and returns those of the part.
    fn count(&mut self, span: ClippedSpan) -> Option<ClippedSpan> {
        let first = self.painted;
        self.painted += span.len();
        let (start, end) = (self.part.start.max(first), self.part.end.min(self.painted));
        let x = |painted: u32| span.x0() + (painted - first) as i32;
        let part = (start < end).then(|| Span { y: span.y(), x0: x(start), x1: x(end) })?;
        part.clip(self.frame.window())
    }
}

impl<F: PixelFormat, C: Hue> Surface for Screen<'_, '_, F, C> {
    type Color = C;

    fn window(&self) -> Rect {
        self.frame.window()
    }

    fn fill_span(&mut self, span: ClippedSpan, color: C) {
        let Some(span) = self.count(span) else { return };
        let (look, y) = (self.look, span.y());
        if look.is_flat(color) {
            self.frame.fill_span(span, F::unpack(look.bits(color, Point::zero())));
        } else {
            self.frame.write_span(span, |x| F::unpack(look.bits(color, Point::new(x, y))));
        }
    }

    fn write_some(&mut self, span: ClippedSpan, mut color_at: impl FnMut(i32) -> Option<C>) {
        let Self { frame, look, part, painted, .. } = self;
        let y = span.y();
        // All are asked for: a paint may go from pixel to pixel.
        frame.write_some(span, |x| {
            let color = color_at(x)?;
            let is_painted = part.contains(painted);
            *painted += 1;
            is_painted.then(|| F::unpack(look.bits(color, Point::new(x, y))))
        });
    }
}

/// Only colours can be read back: an index of a scene is none of the palette.
impl<F: PixelFormat> Readable for Screen<'_, '_, F, Rgb888> {
    fn color_at(&self, x: i32, y: i32) -> Rgb888 {
        self.look.shown(F::pack(self.frame.color_at(x, y)), self.look.table())
    }
}
