//! [`PixelFormat`]: how a colour becomes bits, and where they lie in their bytes.

use embedded_graphics_core::pixelcolor::{raw::RawData, PixelColor};

/// How a colour is stored: its bits, and their place in memory.
pub trait PixelFormat: 'static {
    /// What is stored.
    type Color: PixelColor;

    /// Bits of a pixel in memory: 1, 2, 4, 8, 16, 24 or 32.
    const BITS: u32;

    /// Below 8 bits: whether the leftmost pixel of a byte has its least significant bits.
    const LSB0: bool = false;

    /// The bits of a colour, below `2^BITS`. Of several bytes, the least significant one is stored first.
    fn pack(color: Self::Color) -> u32;

    /// The colour of some bits, below `2^BITS`.
    fn unpack(bits: u32) -> Self::Color;
}

impl<C> PixelFormat for C
where
    C: PixelColor + Into<C::Raw> + From<C::Raw> + 'static,
    C::Raw: RawData,
    <C::Raw as RawData>::Storage: Into<u32>,
{
    type Color = C;
    #[expect(clippy::cast_possible_truncation, reason = "at most 32")]
    const BITS: u32 = <C::Raw as RawData>::BITS_PER_PIXEL as u32;

    #[inline(always)]
    fn pack(color: C) -> u32 {
        let raw: C::Raw = color.into();
        raw.into_inner().into()
    }

    #[inline(always)]
    fn unpack(bits: u32) -> C {
        C::Raw::from_u32(bits).into()
    }
}

/// A colour of 16, 24 or 32 bits stored with its most significant byte first, as most displays on SPI want it.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Be<C>(core::marker::PhantomData<C>);

impl<C: PixelColor + PixelFormat<Color = C>> PixelFormat for Be<C> {
    type Color = C;
    const BITS: u32 = C::BITS;

    #[inline(always)]
    fn pack(color: C) -> u32 {
        C::pack(color).swap_bytes() >> (32 - C::BITS.next_multiple_of(8))
    }

    #[inline(always)]
    fn unpack(bits: u32) -> C {
        C::unpack(bits.swap_bytes() >> (32 - C::BITS.next_multiple_of(8)))
    }
}

/// A colour of 1, 2 or 4 bits stored with the leftmost pixel in the least significant bits of its byte.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Lsb0<C>(core::marker::PhantomData<C>);

impl<C: PixelColor + PixelFormat<Color = C>> PixelFormat for Lsb0<C> {
    type Color = C;
    const BITS: u32 = C::BITS;
    const LSB0: bool = true;

    #[inline(always)]
    fn pack(color: C) -> u32 {
        C::pack(color)
    }

    #[inline(always)]
    fn unpack(bits: u32) -> C {
        C::unpack(bits)
    }
}

/// Bytes of a row of `width` pixels: rows start on a byte boundary.
pub const fn row_bytes<F: PixelFormat>(width: u16) -> usize {
    (width as usize).saturating_mul(F::BITS as usize).div_ceil(8)
}

/// Bytes of a framebuffer of `width` x `height` pixels without gaps between the rows, to size an array with.
///
/// Stops at `usize::MAX`, which no chip has.
/// ```
/// use embedded_raster::{buffer_bytes, Index4};
/// static RAM: [u8; buffer_bytes::<Index4>(320, 240)] = [0; buffer_bytes::<Index4>(320, 240)];
/// assert_eq!(RAM.len(), 38_400);
/// ```
pub const fn buffer_bytes<F: PixelFormat>(width: u16, height: u16) -> usize {
    row_bytes::<F>(width).saturating_mul(height as usize)
}

/// Where pixel `x` of the row at byte `row` starts, for formats of whole bytes.
#[inline(always)]
pub(super) const fn byte<F: PixelFormat>(row: usize, x: usize) -> usize {
    row.wrapping_add(x.wrapping_mul(bytes_per_pixel::<F>()))
}

/// For formats of whole bytes.
#[inline(always)]
pub(crate) const fn bytes_per_pixel<F: PixelFormat>() -> usize {
    (F::BITS / 8) as usize
}

/// Whether a pixel has bits that belong to no channel, as one of `Rgb555` has one, and one of `Rgb666` six. A picture may hold
/// anything there.
#[inline(always)]
pub(super) fn has_unused_bits<F: PixelFormat>() -> bool {
    let all = u32::MAX >> (32 - F::BITS);
    F::pack(F::unpack(all)) != all
}
