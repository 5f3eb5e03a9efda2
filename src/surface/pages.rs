//! [`Pages`]: eight rows to a byte, as the memory of SSD1306-class OLEDs is arranged.
//! ```text
//!            x = 0  1  2 ..           byte x of page p holds pixels (x, 8 p) .. (x, 8 p + 7):
//!   page 0  [b0]  [b0] [b0]           with Lsb0<C> the topmost in bit 0, as shown;
//!           [..]  [..] [..]           with C alone the topmost in bit 7
//!           [b7]  [b7] [b7]
//!   page 1  [b0]  ...
//! ```

use core::{marker::PhantomData, ops::Range};

use super::{
    frame::Frame,
    layout::{Grid, Layout, Place},
};
use crate::{
    num::cast::low_u8,
    pixel::{rows::packed::merge, Lsb0, PixelFormat},
};

/// One-bit pixels in pages of eight rows, the topmost row in bit 0, as SSD1306-class OLEDs have them. See [`Pages`].
pub type Paged<'a, C> = Frame<&'a mut [u8], Pages<Lsb0<C>>>;

/// Vertical bytes: pages of eight rows, of a format of one bit per pixel. The topmost pixel of a byte is in its most
/// significant bit, or in bit 0 for [`Lsb0`](crate::pixel::Lsb0) formats, which is what OLEDs want.
/// ```
/// use embedded_graphics_core::{geometry::Point, pixelcolor::BinaryColor};
/// use embedded_raster::{surface::{paged_bytes, Paged}, Canvas};
/// let mut ram = [0; paged_bytes(128, 64)];
/// let mut oled = Paged::<BinaryColor>::new(&mut ram, 128, 64)?;
/// oled.draw_line(Point::new(3, 6), Point::new(3, 9), BinaryColor::On);
/// assert_eq!((ram[3], ram[128 + 3]), (0b1100_0000, 0b0000_0011));
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Copy, Clone, Debug)]
pub struct Pages<F>(PhantomData<F>);

/// Bytes of a paged screen; a last page of fewer than eight rows takes whole bytes all the same.
pub const fn paged_bytes(width: u16, height: u16) -> usize {
    (width as usize).saturating_mul((height as usize).div_ceil(8))
}

/// A byte full of a colour.
#[inline(always)]
fn full<F: PixelFormat>(color: F::Color) -> u8 {
    low_u8(F::pack(color).wrapping_neg())
}

/// The bits of the rows `y0..=y1` of a page.
#[inline(always)]
fn mask<F: PixelFormat>(y0: usize, y1: usize) -> u8 {
    if F::LSB0 {
        0xff << (y0 & 7) & 0xff >> (7 - (y1 & 7))
    } else {
        0xff >> (y0 & 7) & 0xff << (7 - (y1 & 7))
    }
}

#[inline(always)]
fn byte(grid: Grid, x: usize, y: usize) -> usize {
    (y >> 3).wrapping_mul(grid.stride).wrapping_add(x)
}

/// Writes one colour to the rows of a mask in the page of row y.
#[inline(always)]
fn fill(memory: &mut [u8], grid: Grid, y: usize, (x0, x1): (usize, usize), (mask, full): (u8, u8)) {
    let Some(run) = memory.get_mut(byte(grid, x0, y)..byte(grid, x1, y)) else { return };
    if mask == 0xff {
        run.fill(full);
    } else {
        for place in run {
            *place = merge(*place, full, mask);
        }
    }
}

impl<F: PixelFormat> Layout for Pages<F> {
    type Color = F::Color;

    const PAGE: u16 = {
        assert!(F::BITS == 1, "pages hold pixels of one bit");
        8
    };

    #[inline]
    fn row_bytes(width: u16) -> usize {
        width.into()
    }

    #[inline]
    fn bytes_above(grid: Grid, y: usize) -> Option<usize> {
        Some(grid.stride.wrapping_mul(y.div_ceil(Self::PAGE.into())))
    }

    #[inline]
    fn get(memory: &[u8], grid: Grid, (x, y): Place) -> F::Color {
        let byte = memory.get(byte(grid, x, y)).copied().unwrap_or(0);
        F::unpack(u32::from(byte & mask::<F>(y, y) != 0))
    }

    #[inline]
    fn set(memory: &mut [u8], grid: Grid, (x, y): Place, color: F::Color) {
        if let Some(place) = memory.get_mut(byte(grid, x, y)) {
            *place = merge(*place, full::<F>(color), mask::<F>(y, y));
        }
    }

    #[inline]
    fn fill_span(memory: &mut [u8], grid: Grid, y: usize, columns: (usize, usize), color: F::Color) {
        let (mask, full) = (mask::<F>(y, y), full::<F>(color));
        for place in memory.get_mut(byte(grid, columns.0, y)..byte(grid, columns.1, y)).unwrap_or_default() {
            *place = merge(*place, full, mask);
        }
    }

    /// Eight rows at a time.
    fn fill_area(memory: &mut [u8], grid: Grid, (y0, y1): (usize, usize), columns: (usize, usize), color: F::Color) {
        let mut y = y0;
        while y < y1 {
            let next = (y | 7).wrapping_add(1).min(y1);
            fill(memory, grid, y, columns, (mask::<F>(y, next.wrapping_sub(1)), full::<F>(color)));
            y = next;
        }
    }
}

/// Bytes as a display wants to be sent them.
impl<M: AsRef<[u8]>, F: PixelFormat> Frame<M, Pages<F>> {
    /// The bytes of some pages in one piece. Empty if a page lies outside.
    pub fn page_bytes(&self, pages: Range<u16>) -> &[u8] {
        self.run_of_bytes(pages, 8)
    }
}
