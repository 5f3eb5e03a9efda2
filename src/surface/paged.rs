//! [`Paged`]: eight rows to a byte, as the memory of SSD1306-class OLEDs is arranged.
//! ```text
//!            x = 0  1  2 ..           byte x of page p holds pixels (x, 8 p) .. (x, 8 p + 7),
//!   page 0  [b0]  [b0] [b0]           the top one in bit 0
//!           [..]  [..] [..]
//!           [b7]  [b7] [b7]
//!   page 1  [b0]  ...
//! ```

use core::ops::Range;

use embedded_graphics_core::{
    geometry::{Point, Size},
    pixelcolor::PixelColor,
};

use super::Surface;
use crate::{
    error::BufferError,
    num::cast::{index, low_u8},
    pixel::{packed::merge, PixelFormat},
    rect::Rect,
    span::ClippedSpan,
};

/// Bytes of a paged screen: a byte holds eight rows.
pub const fn paged_bytes(width: u16, height: u16) -> usize {
    (width as usize).saturating_mul((height as usize).div_ceil(8))
}

/// One-bit pixels in vertical bytes: pages of eight rows. `C` is any 1-bit colour.
/// ```
/// use embedded_graphics_core::{geometry::Point, pixelcolor::BinaryColor};
/// use embedded_raster::{surface::{paged_bytes, Paged}, Canvas};
/// let mut ram = [0; paged_bytes(128, 64)];
/// let mut oled = Paged::<BinaryColor>::new(&mut ram, 128, 64)?;
/// oled.draw_line(Point::new(3, 6), Point::new(3, 9), BinaryColor::On);
/// assert_eq!((ram[3], ram[128 + 3]), (0b1100_0000, 0b0000_0011));
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Debug)]
pub struct Paged<'a, C> {
    memory: &'a mut [u8],
    width: u16,
    height: u16,
    window: Rect,
    color: core::marker::PhantomData<C>,
}

impl<'a, C: PixelColor + PixelFormat<Color = C>> Paged<'a, C> {
    /// A screen of `width` x `height` pixels; a last page of fewer than eight rows takes whole bytes all the same.
    ///
    /// # Errors
    /// [`BufferError::TooSmall`] if `memory` is shorter than [`paged_bytes`].
    pub fn new(memory: &'a mut [u8], width: u16, height: u16) -> Result<Self, BufferError> {
        const { assert!(C::BITS == 1, "a paged surface holds 1-bit colours") };
        let (needed, given) = (paged_bytes(width, height), memory.len());
        if given < needed {
            return Err(BufferError::TooSmall { needed, given });
        }
        let window = Rect::new(0, 0, width.into(), height.into());
        Ok(Self { memory, width, height, window, color: core::marker::PhantomData })
    }

    /// The same surface, with drawing restricted to `area`; coordinates stay as they are.
    #[must_use]
    pub fn clipped(&mut self, area: Rect) -> Paged<'_, C> {
        Paged { window: self.window.intersection(area), memory: self.memory, ..*self }
    }

    /// Width and height of the screen.
    #[inline]
    pub fn size(&self) -> Size {
        Size::new(self.width.into(), self.height.into())
    }

    /// Paints one pixel; nothing if it lies outside.
    #[inline]
    pub fn set(&mut self, p: Point, color: C) {
        if self.window.contains(p.x, p.y) {
            let at = self.byte(p.x, p.y);
            if let Some(byte) = self.memory.get_mut(at) {
                *byte = merge(*byte, ink(color), 1 << (p.y & 7));
            }
        }
    }

    /// The colour of a pixel; `None` if it lies outside.
    #[inline]
    pub fn get(&self, p: Point) -> Option<C> {
        let byte = self.memory.get(self.byte(p.x, p.y)).filter(|_| self.window.contains(p.x, p.y))?;
        Some(C::unpack(u32::from(byte >> (p.y & 7) & 1)))
    }

    /// Paints everything.
    pub fn clear(&mut self, color: C) {
        self.fill_area(self.window, color);
    }

    /// The bytes of some pages in one piece, to be sent to the display. Empty if a page lies outside.
    pub fn page_bytes(&self, pages: Range<u16>) -> &[u8] {
        let at = |page: u16| usize::from(page).wrapping_mul(usize::from(self.width));
        let end = at(pages.end);
        let inside = end <= paged_bytes(self.width, self.height);
        self.memory.get(at(pages.start)..end).filter(|_| inside).unwrap_or_default()
    }

    #[inline(always)]
    fn byte(&self, x: i32, y: i32) -> usize {
        index(y >> 3).wrapping_mul(usize::from(self.width)).wrapping_add(index(x))
    }

    /// Paints the pixels of the columns `x0..x1` whose rows are set in `mask`, in the page of row `y`.
    #[inline(always)]
    fn fill_page(&mut self, y: i32, columns: Range<i32>, mask: u8, byte: u8) {
        let (start, end) = (self.byte(columns.start, y), self.byte(columns.end, y));
        let Some(run) = self.memory.get_mut(start..end) else { return };
        if mask == 0xff {
            run.fill(byte);
        } else {
            for place in run {
                *place = merge(*place, byte, mask);
            }
        }
    }
}

/// A byte full of a colour.
#[inline(always)]
fn ink<C: PixelColor + PixelFormat<Color = C>>(color: C) -> u8 {
    low_u8(C::pack(color).wrapping_neg())
}

impl<C: PixelColor + PixelFormat<Color = C>> Surface for Paged<'_, C> {
    type Color = C;

    #[inline]
    fn window(&self) -> Rect {
        self.window
    }

    #[inline]
    fn fill_span(&mut self, span: ClippedSpan, color: C) {
        self.fill_page(span.y(), span.x0()..span.x1(), 1 << (span.y() & 7), ink(color));
    }

    /// Eight rows at a time.
    fn fill_area(&mut self, area: Rect, color: C) {
        let area = area.intersection(self.window);
        let mut y = area.y0;
        while y < area.y1 && area.x0 < area.x1 {
            let next = (y | 7).wrapping_add(1).min(area.y1);
            let mask = 0xff_u8 << (y & 7) & 0xff >> (7 - (next.wrapping_sub(1) & 7));
            self.fill_page(y, area.x0..area.x1, mask, ink(color));
            y = next;
        }
    }
}
