//! [`DepthBuffer`]: how far away what is seen is, pixel by pixel.

use core::marker::PhantomData;

use super::{frame::Frame, rows::Rows};
use crate::{
    geom::Varying,
    pixel::{Depth16, Depth32, PixelFormat},
    span::ClippedSpan,
    tune::UNALIGNED,
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
    /// Its place in memory, at any address.
    #[doc(hidden)]
    type Cell: DepthCell<Self::Number>;
    /// The same for small triangles: a word, if the chip loads words only at multiples of their size.
    #[doc(hidden)]
    type Word: DepthCell<Self::Number>;
}

/// A place in memory for a number.
pub trait DepthCell<N>: bytemuck::Pod {
    /// The number that is there.
    #[doc(hidden)]
    fn load(self) -> N;

    /// What has to be there for a number.
    #[doc(hidden)]
    fn store(number: N) -> Self;
}

/// One of two types: see [`Choose`].
pub trait Choice {
    /// This one.
    type Chosen;
}

/// The first type, or the second one: where what is known of the chip decides what lies in memory.
#[derive(Debug)]
pub struct Choose<const FIRST: bool, A, B>(PhantomData<(A, B)>);

impl<A, B> Choice for Choose<true, A, B> {
    type Chosen = A;
}

impl<A, B> Choice for Choose<false, A, B> {
    type Chosen = B;
}

macro_rules! depth {
    ($depth:ty, $number:ty, $bytes:literal) => {
        impl Depth for $depth {
            type Number = $number;
            type Cell = [u8; $bytes];
            type Word = <Choose<UNALIGNED, [u8; $bytes], $number> as Choice>::Chosen;
        }

        impl DepthCell<$number> for [u8; $bytes] {
            #[inline(always)]
            fn load(self) -> $number {
                <$number>::from_le_bytes(self)
            }

            #[inline(always)]
            fn store(number: $number) -> Self {
                number.to_le_bytes()
            }
        }

        impl DepthCell<$number> for $number {
            #[inline(always)]
            fn load(self) -> $number {
                Self::from_le(self)
            }

            #[inline(always)]
            fn store(number: $number) -> Self {
                number.to_le()
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

    /// Whether the chip loads each depth at once, and rows are whole depths apart.
    #[inline(always)]
    pub(crate) fn is_aligned(&mut self) -> bool {
        let (memory, grid) = self.write();
        grid.stride.is_multiple_of(size_of::<Z::Word>()) && memory.as_ptr().cast::<Z::Word>().is_aligned()
    }

    /// All depths as they lie in memory, if it [is aligned](Self::is_aligned), the place of a pixel of the window among them, and how far
    /// it is to the row below.
    #[inline(always)]
    pub(crate) fn words(&mut self, x: i32, y: i32) -> (&mut [Z::Word], usize, usize) {
        let (column, row) = self.place(x, y);
        let (memory, grid) = self.write();
        let pitch = grid.stride / size_of::<Z::Word>();
        let (_, words, _) = bytemuck::pod_align_to_mut::<u8, Z::Word>(memory);
        (words, row.wrapping_mul(pitch).wrapping_add(column), pitch)
    }
}
