//! [`DepthBuffer`]: how far away what is seen is, pixel by pixel.

use super::{frame::Frame, rows::Rows};
use crate::{
    geom::Varying,
    pixel::{Depth16, Depth32, PixelFormat},
    span::ClippedSpan,
};

/// A frame of depths, beside a frame of colours: with the same size, the same band or the same view, so that both have the same
/// coordinates. [`Depth16`] and [`Depth32`] are depths.
/// ```
/// use embedded_raster::{buffer_bytes, pixel::Depth16, surface::DepthBuffer};
/// let mut ram = [0; buffer_bytes::<Depth16>(160, 16)];
/// // Rows 32 to 47 of a screen of 160 x 128 pixels.
/// let mut depth = DepthBuffer::<Depth16>::band(&mut ram, 160, 128, 32..48)?;
/// depth.clear(Depth16::MAX);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
pub type DepthBuffer<'a, Z> = Frame<&'a mut [u8], Rows<Z>>;

/// What a depth buffer holds.
pub trait Depth: PixelFormat<Color = Self> + Copy {
    /// The number that changes over a triangle.
    type Number: Varying + PartialOrd;
    /// Its place in memory.
    #[doc(hidden)]
    type Cell: bytemuck::Pod;

    /// The number in a place.
    #[doc(hidden)]
    fn load(cell: Self::Cell) -> Self::Number;

    /// The place of a number.
    #[doc(hidden)]
    fn store(number: Self::Number) -> Self::Cell;
}

macro_rules! depth {
    ($depth:ty, $number:ty, $bytes:literal) => {
        impl Depth for $depth {
            type Number = $number;
            type Cell = [u8; $bytes];

            #[inline(always)]
            fn load(cell: Self::Cell) -> $number {
                <$number>::from_le_bytes(cell)
            }

            #[inline(always)]
            fn store(number: $number) -> Self::Cell {
                number.to_le_bytes()
            }
        }
    };
}

depth!(Depth16, u16, 2);
depth!(Depth32, u32, 4);

impl<M: AsMut<[u8]>, Z: Depth> Frame<M, Rows<Z>> {
    /// The places of the depths of a span that lies in the window.
    #[inline(always)]
    pub(crate) fn cells(&mut self, span: ClippedSpan) -> Option<&mut [Z::Cell]> {
        let (y, (x0, x1)) = (self.y(span.y()), self.columns(span));
        let (memory, grid) = self.write();
        let (row, size) = (y.wrapping_mul(grid.stride), size_of::<Z::Cell>());
        let bytes = row.wrapping_add(x0.wrapping_mul(size))..row.wrapping_add(x1.wrapping_mul(size));
        let (_, cells, _) = bytemuck::pod_align_to_mut::<u8, Z::Cell>(memory.get_mut(bytes)?);
        Some(cells)
    }

    /// All depths as they lie in memory, the place of a pixel of the window among them, and how far it is to the row below. `None` where
    /// rows are not whole depths apart.
    #[inline(always)]
    pub(crate) fn all_cells(&mut self, x: i32, y: i32) -> Option<(&mut [Z::Cell], usize, usize)> {
        let (column, row) = self.place(x, y);
        let (memory, grid) = self.write();
        let pitch = grid.stride / size_of::<Z::Cell>();
        if !grid.stride.is_multiple_of(size_of::<Z::Cell>()) {
            return None;
        }
        let (_, cells, _) = bytemuck::pod_align_to_mut::<u8, Z::Cell>(memory);
        Some((cells, row.wrapping_mul(pitch).wrapping_add(column), pitch))
    }
}
