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
///
/// Stops at `usize::MAX`, which only a `usize` of 16 bits is too small for.
#[inline(always)]
pub const fn row_bytes<F: PixelFormat>(width: u16) -> usize {
    size(bytes_of_bits(width, F::BITS), usize::MAX)
}

/// Bytes of so many pixels of 1 to 32 bits, in 32 bits: saturating in bits, and dividing then, would be too few in 16.
#[inline(always)]
const fn bytes_of_bits(pixels: u16, bits: u32) -> u32 {
    (pixels as u32 * bits).div_ceil(8)
}

/// A number of bytes as a size in memory, up to the largest one there is.
#[inline(always)]
const fn size(bytes: u32, largest: usize) -> usize {
    if bytes as u64 > largest as u64 {
        largest
    } else {
        bytes as usize
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_of_every_width_have_their_bytes_or_more_than_any_memory() {
        for (width, bits) in (0..=u16::MAX).flat_map(|width| [1, 2, 4, 8, 16, 24, 32].map(|bits| (width, bits))) {
            let wanted = (u64::from(width) * u64::from(bits)).div_ceil(8);
            let bytes = bytes_of_bits(width, bits);
            assert_eq!(u64::from(bytes), wanted, "{width} pixels of {bits} bits");
            assert_eq!(size(bytes, usize::MAX) as u64, wanted, "in a large memory");
            assert_eq!(size(bytes, 0xffff) as u64, wanted.min(0xffff), "with a `usize` of 16 bits");
        }
    }
}
