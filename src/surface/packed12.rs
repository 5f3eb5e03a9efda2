//! [`Packed12`]: two pixels of 12 bits in three bytes, as ST7789 and ST7735 take RGB444.
//! ```text
//!   byte      0        1        2
//!           RRRRGGGG BBBBRRRR GGGGBBBB      the left pixel first, its most significant bits first
//! ```

use super::layout::{Grid, Layout, Place};
use crate::{
    num::cast::low_u8,
    pixel::{PixelFormat, Rgb444},
};

/// Two pixels to three bytes: [`Rgb444`] as display controllers want it. A row starts on a byte, so one of odd width ends with
/// half a byte of nothing.
/// ```
/// use embedded_graphics_core::{geometry::Point, pixelcolor::RgbColor};
/// use embedded_raster::{pixel::Rgb444, surface::Packed12, Canvas, Frame};
/// let mut ram = [0; 3];
/// let mut frame = Frame::<_, Packed12>::new(&mut ram[..], 2, 1)?;
/// frame.draw_point(Point::new(0, 0), Rgb444::new(1, 2, 3));
/// frame.draw_point(Point::new(1, 0), Rgb444::new(4, 5, 6));
/// assert_eq!(ram, [0x12, 0x34, 0x56]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Copy, Clone, Debug)]
pub struct Packed12;

impl Packed12 {
    /// Bytes of a screen without gaps between the rows, to size an array with. Stops at `usize::MAX`.
    pub const fn bytes_of(width: u16, height: u16) -> usize {
        // One byte and a half for each pixel. The sum could leave a `usize` of 16 bits: then no memory is large enough.
        let width = width as usize;
        width.saturating_add(width.div_ceil(2)).saturating_mul(height as usize)
    }
}

/// The three bytes of a pair of pixels of the same colour.
#[inline(always)]
fn pair(bits: u32) -> [u8; 3] {
    [low_u8(bits >> 4), low_u8(bits << 4 | bits >> 8), low_u8(bits)]
}

/// The first of the two bytes that a pixel lies in, and whether it is the right one of its pair.
#[inline(always)]
fn place(grid: Grid, (x, y): Place) -> (usize, bool) {
    (y.wrapping_mul(grid.stride).wrapping_add(x.wrapping_add(x >> 1)), x & 1 != 0)
}

impl Layout for Packed12 {
    type Color = Rgb444;

    #[inline]
    fn row_bytes(width: u16) -> usize {
        Self::bytes_of(width, 1)
    }

    #[inline]
    fn bytes_above(grid: Grid, y: usize) -> Option<usize> {
        Some(grid.stride.wrapping_mul(y))
    }

    #[inline]
    fn get(memory: &[u8], grid: Grid, at: Place) -> Rgb444 {
        let (byte, is_right) = place(grid, at);
        let Some(&[first, second]) = memory.get(byte..).and_then(<[u8]>::first_chunk) else { return Rgb444::default() };
        let both = u32::from(first) << 8 | u32::from(second);
        Rgb444::unpack(if is_right { both & 0xfff } else { both >> 4 })
    }

    #[inline]
    fn set(memory: &mut [u8], grid: Grid, at: Place, color: Rgb444) {
        let (byte, is_right) = place(grid, at);
        let Some([first, second]) = memory.get_mut(byte..).and_then(<[u8]>::first_chunk_mut) else { return };
        let [high, middle, low] = pair(Rgb444::pack(color));
        if is_right {
            (*first, *second) = (*first & 0xf0 | middle & 0x0f, low);
        } else {
            (*first, *second) = (high, middle & 0xf0 | *second & 0x0f);
        }
    }

    /// Whole pairs at a time.
    #[inline]
    fn fill_span(memory: &mut [u8], grid: Grid, y: usize, (mut x0, mut x1): (usize, usize), color: Rgb444) {
        if x0 & 1 != 0 {
            Self::set(memory, grid, (x0, y), color);
            x0 = x0.wrapping_add(1);
        }
        if x0 < x1 && x1 & 1 != 0 {
            x1 = x1.wrapping_sub(1);
            Self::set(memory, grid, (x1, y), color);
        }
        let pairs = place(grid, (x0, y)).0..place(grid, (x1, y)).0;
        let pair = pair(Rgb444::pack(color));
        for bytes in memory.get_mut(pairs).unwrap_or_default().chunks_exact_mut(3) {
            bytes.copy_from_slice(&pair);
        }
    }
}
