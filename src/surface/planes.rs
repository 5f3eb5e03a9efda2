//! [`Planes`]: two bits of a pixel in two places, as e-paper controllers want them.
//! ```text
//!   plane 0  rows of bit 0 of all pixels, eight pixels to a byte
//!   plane 1  rows of bit 1, after the last byte of plane 0
//! ```

use core::marker::PhantomData;

use super::{
    frame::Frame,
    layout::{Grid, Layout, Place},
};
use crate::pixel::{rows, Index1, Lsb0, PixelFormat};

/// Two planes of one bit, of a format of two bits per pixel: black, white and red, or four greys. The leftmost pixel of a byte
/// is in its most significant bit, or in bit 0 for [`Lsb0`] formats.
///
/// Each plane is whole: `stride * rows` bytes.
/// ```
/// use embedded_graphics_core::geometry::Point;
/// use embedded_raster::{surface::Planes, Canvas, Frame, Index2};
/// let mut ram = [0; 2 * 2];
/// let mut paper = Frame::<_, Planes<Index2>>::new(&mut ram[..], 8, 2)?;
/// paper.draw_line(Point::new(0, 0), Point::new(3, 0), Index2::new(1));
/// paper.draw_line(Point::new(2, 1), Point::new(7, 1), Index2::new(3));
/// assert_eq!(paper.plane_bytes(1), [0b0000_0000, 0b0011_1111]);
/// assert_eq!(ram, [0b1111_0000, 0b0011_1111, 0b0000_0000, 0b0011_1111]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Copy, Clone, Debug)]
pub struct Planes<F>(PhantomData<F>);

impl<F: PixelFormat> Planes<F> {
    /// Calls `f` with the first byte of row y in each plane, and the bit of a colour that belongs there.
    #[inline(always)]
    fn each(grid: Grid, y: usize, bits: u32, mut f: impl FnMut(usize, u32)) {
        let row = y.wrapping_mul(grid.stride);
        f(row, bits & 1);
        f(row.wrapping_add(plane(grid)), bits >> 1 & 1);
    }

    #[inline(always)]
    fn fill_plane(memory: &mut [u8], row: usize, (x0, x1): (usize, usize), bit: u32) {
        if F::LSB0 {
            rows::fill::<Lsb0<Index1>>(memory, row, x0, x1, bit);
        } else {
            rows::fill::<Index1>(memory, row, x0, x1, bit);
        }
    }

    #[inline(always)]
    fn bit(memory: &[u8], row: usize, x: usize) -> u32 {
        if F::LSB0 {
            rows::get::<Lsb0<Index1>>(memory, row, x)
        } else {
            rows::get::<Index1>(memory, row, x)
        }
    }
}

/// Bytes of a plane.
#[inline(always)]
fn plane(grid: Grid) -> usize {
    grid.stride.wrapping_mul(grid.rows)
}

impl<F: PixelFormat> Layout for Planes<F> {
    type Color = F::Color;

    #[inline]
    fn row_bytes(width: u16) -> usize {
        const { assert!(F::BITS == 2, "two planes hold pixels of two bits") };
        crate::pixel::row_bytes::<Index1>(width)
    }

    #[inline]
    fn bytes(_: u16, grid: Grid) -> usize {
        grid.stride.saturating_mul(grid.rows).saturating_mul(2)
    }

    #[inline]
    fn get(memory: &[u8], grid: Grid, (x, y): Place) -> F::Color {
        let row = y.wrapping_mul(grid.stride);
        F::unpack(Self::bit(memory, row, x) | Self::bit(memory, row.wrapping_add(plane(grid)), x) << 1)
    }

    #[inline]
    fn set(memory: &mut [u8], grid: Grid, (x, y): Place, color: F::Color) {
        Self::each(grid, y, F::pack(color), |row, bit| {
            if F::LSB0 {
                rows::set::<Lsb0<Index1>>(memory, row, x, bit);
            } else {
                rows::set::<Index1>(memory, row, x, bit);
            }
        });
    }

    #[inline]
    fn fill_span(memory: &mut [u8], grid: Grid, y: usize, columns: (usize, usize), color: F::Color) {
        Self::each(grid, y, F::pack(color), |row, bit| Self::fill_plane(memory, row, columns, bit));
    }
}

/// Bytes as a display wants to be sent them.
impl<M: AsRef<[u8]>, F: PixelFormat> Frame<M, Planes<F>> {
    /// The bytes of plane 0 or 1 in one piece. Empty for any other number.
    pub fn plane_bytes(&self, number: usize) -> &[u8] {
        let (memory, grid) = self.read();
        let bytes = plane(grid);
        let start = number.min(2).wrapping_mul(bytes);
        memory.get(start..start.wrapping_add(bytes)).filter(|_| number < 2).unwrap_or_default()
    }
}
