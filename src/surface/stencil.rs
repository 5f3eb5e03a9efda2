//! [`Stencil`]: a surface seen through a mask of one bit.

use super::{frame::Frame, layout::Layout, traits::Surface};
use crate::{
    pixel::PixelFormat,
    span::{ClippedSpan, Rect},
};

/// A surface of which only the pixels are painted whose bit is set in a mask: whatever is drawn on it is clipped to a shape.
/// Shapes, pictures, masks and the texts of embedded-graphics all are.
///
/// The mask is a frame of one bit per pixel, of any layout, with the coordinates of the surface: of a band of a screen, it is that
/// band of the mask, or all of it. Where the mask has no pixels, nothing is painted.
///
/// It cannot be read, so paints that mix with what is there do not take it: [`Masked`](crate::paint::Masked) paints through a
/// mask on the surface itself, with soft rims, and takes masks of up to 8 bits. (A flood fill goes by what it has painted already; if
/// some pixels refused to be painted it would not end.)
/// ```
/// use embedded_graphics_core::pixelcolor::{BinaryColor, Gray8};
/// use embedded_raster::{surface::Stencil, Bitmap, Canvas, Framebuffer, Rect};
/// let mask = [0b0011_1100, 0b0111_1110, 0b0011_1100];
/// let mask = Bitmap::<BinaryColor>::new(&mask, 8, 3)?;
/// let mut ram = [b'.'; 8 * 3];
/// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 8, 3)?;
/// let mut hole = Stencil::new(&mut frame, mask);
/// hole.fill_rectangle(Rect::new(0, 0, 5, 3), Gray8::new(b'#'));
/// hole.draw_line((0, 1), (7, 1), Gray8::new(b'-'));
/// assert_eq!(&ram, b"..###....------...###...");
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Debug)]
pub struct Stencil<'a, S: ?Sized, L> {
    surface: &'a mut S,
    mask: Frame<&'a [u8], L>,
}

impl<'a, S: Surface + ?Sized, L: Layout> Stencil<'a, S, L>
where
    L::Color: PixelFormat<Color = L::Color>,
{
    /// The surface, seen through a mask. That of a frame is its [`as_bitmap`](Frame::as_bitmap).
    #[inline]
    pub const fn new(surface: &'a mut S, mask: Frame<&'a [u8], L>) -> Self {
        const { assert!(Frame::<&[u8], L>::MASK_BITS == 1, "a stencil has one bit per pixel") };
        Self { surface, mask }
    }
}

impl<S: Surface, L: Layout> Surface for Stencil<'_, S, L>
where
    L::Color: PixelFormat<Color = L::Color>,
{
    type Color = S::Color;

    #[inline]
    fn window(&self) -> Rect {
        self.surface.window().intersection(self.mask.window())
    }

    #[inline]
    fn fill_span(&mut self, span: ClippedSpan, color: S::Color) {
        self.mask.each_set(span, |run| self.surface.fill_span(run, color));
    }

    #[inline]
    fn write_some(&mut self, span: ClippedSpan, mut color_at: impl FnMut(i32) -> Option<S::Color>) {
        let Some(span) = span.again(self.mask.window()) else { return };
        // The function may count its calls, so it is asked for the colours of hidden pixels, too.
        let mask = &self.mask;
        self.surface.write_some(span, |x| color_at(x).filter(|_| mask.is_set(x, span.y())));
    }
}
