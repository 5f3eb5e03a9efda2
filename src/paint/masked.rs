//! [`Masked`]: any paint, through a mask.
//!
//! A mask says how much of a pixel is let through, in 255ths; a shape with soft rims says how much of it there is. Of a pixel that is
//! covered by c 255ths and let through by m, the paint behind the mask is told the nearest 255th to `c m / 255`, as if a shape covered
//! so much of it. No product is half way between two, as 255 is odd. So with a mask of one bit all levels are those of the shape, and
//! a shape without soft rims has the levels of the mask.

use super::traits::Paint;
use crate::{
    num::cast::low_u8,
    pixel::PixelFormat,
    span::ClippedSpan,
    surface::{Frame, Layout, Surface, CHUNK},
};

/// A paint that is clipped to a shape, or faded by one: through a mask of one bit, or one of 2, 4 or 8 bits.
///
/// The mask is a frame of any layout, drawn by any means, with the coordinates of the surface that is painted: of a band of a
/// screen, it is that band of the mask, or all of it. Of its pixels the number is what is let through, and the largest number is all
/// of it. Where the mask has no pixels, nothing is painted.
///
/// The paint decides what becomes of a pixel that is let through in part: see the table of [`Antialias`](crate::Antialias).
/// ```
/// use embedded_graphics_core::pixelcolor::Gray8;
/// use embedded_raster::{paint::{Cover, Masked}, raster::rectangle, Antialias, Canvas, Framebuffer, PointFx, Rect};
/// let mut shades = [0, 255, 170, 85, 0];
/// let mask = Framebuffer::<Gray8>::new(&mut shades, 5, 1)?;
/// let mut ram = [100; 5];
/// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 5, 1)?;
/// let paint = Masked::new(mask.as_bitmap(), Cover(Gray8::new(200)));
/// frame.paint(paint, |window, brush| rectangle::fill(Rect::new(1, 0, 5, 1), window, brush));
/// assert_eq!(ram, [100, 200, 167, 133, 100]); // all, two thirds, one third of the way from 100 to 200
///
/// // A shape that covers half of each pixel.
/// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 5, 1)?;
/// let paint = Masked::new(mask.as_bitmap(), Cover(Gray8::new(0)));
/// frame.fill_rectangle_aa(PointFx::px(1, 0), PointFx::from_bits(5 * 256, 128), paint);
/// assert_eq!(ram, [100, 100, 111, 111, 100]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
///
/// A picture is on the page of the [module](crate::paint).
#[derive(Copy, Clone, Debug)]
pub struct Masked<'a, L, P> {
    mask: Frame<&'a [u8], L>,
    paint: P,
}

impl<'a, L: Layout, P> Masked<'a, L, P>
where
    L::Color: PixelFormat<Color = L::Color>,
{
    /// A paint behind a mask. That of a frame is its [`as_bitmap`](Frame::as_bitmap).
    #[inline]
    pub const fn new(mask: Frame<&'a [u8], L>, paint: P) -> Self {
        Self { mask, paint }
    }

    /// Paints pixels of which there is so much as `level` says: it is told the number of the pixel in the span.
    #[inline(always)]
    fn paint_through<S: Surface + ?Sized>(&mut self, on: &mut S, span: ClippedSpan, level: impl Fn(usize) -> u8)
    where
        P: Paint<S>,
    {
        let Some(seen) = span.again(self.mask.window()) else { return };
        seen.parts(CHUNK, |part| {
            let before = usize::try_from(part.x0().wrapping_sub(span.x0())).unwrap_or_default();
            let mut levels = [0; CHUNK as usize];
            let levels = self
                .mask
                .levels(&mut levels, part, (0, part.y()), |through, i| product(through, level(before.wrapping_add(i))));
            part.each_covered(levels, |run, levels| match levels {
                Some(levels) => self.paint.coverage(on, run, levels),
                None => self.paint.span(on, run),
            });
        });
    }
}

/// The nearest 255th to the product of two numbers of 255ths.
#[inline(always)]
fn product(a: u8, b: u8) -> u8 {
    low_u8(u32::from(a).wrapping_mul(b.into()).wrapping_add(127) / 255)
}

impl<S: Surface + ?Sized, L: Layout, P: Paint<S>> Paint<S> for Masked<'_, L, P>
where
    L::Color: PixelFormat<Color = L::Color>,
{
    #[inline(never)]
    fn span(&mut self, on: &mut S, span: ClippedSpan) {
        if Frame::<&[u8], L>::MASK_BITS == 1 {
            self.mask.each_set(span, |run| self.paint.span(on, run));
        } else {
            self.paint_through(on, span, |_| u8::MAX);
        }
    }

    #[inline(never)]
    fn coverage(&mut self, on: &mut S, span: ClippedSpan, levels: &[u8]) {
        self.paint_through(on, span, |i| levels.get(i).copied().unwrap_or(0));
    }
}
