//! One colour to bits.
//!
//! A [`PixelFormat`] says how many bits a pixel takes in memory and how a colour becomes those bits. Every
//! embedded-graphics colour that has raw data is one, stored the usual way; two wrappers name the other way round:
//!
//! | bits | formats | memory |
//! |---|---|---|
//! | 1 | [`Index1`], `BinaryColor` | leftmost pixel in the most significant bit; [`Lsb0<C>`](Lsb0) in the least |
//! | 2 | [`Index2`], `Gray2` | the same |
//! | 4 | [`Index4`], `Gray4` | the same |
//! | 8 | [`Index8`], `Gray8`, [`Rgb332`] | a byte |
//! | 16 | `Rgb555`, `Bgr555`, `Rgb565`, `Bgr565` | little-endian; [`Be<C>`](Be) big-endian |
//! | 24 | `Rgb666`, `Bgr666`, `Rgb888`, `Bgr888` | little-endian: of `Rgb888` blue comes first; [`Be<C>`](Be) big-endian |
//! | 32 | [`Xrgb8888`] | little-endian: blue, green, red, unused; [`Be<C>`](Be) big-endian |
//!
//! (Vertical pages, eight rows to a byte, are another arrangement of *1-bit* pixels:
//! [`Paged`](crate::surface::Paged).) A format of your own is a colour type of your own: implement `PixelColor` for it and
//! conversions from and to its raw data.
//!
//! Runs of pixels are written here too: `packed` knows bytes that hold several pixels, `word` pixels that take whole bytes,
//! `walk` the steps of lines, and `mask` pictures of one bit in two colours.

use embedded_graphics_core::pixelcolor::{raw::RawData, PixelColor};

mod color;
pub(crate) mod mask;
pub(crate) mod packed;
mod palette;
pub(crate) mod scan;
pub(crate) mod walk;
mod word;

pub use color::{Index1, Index2, Index4, Index8, Rgb332, Xrgb8888};
pub use palette::{Palette, EGA};

/// How a colour is stored: its bits, and their place in memory.
pub trait PixelFormat: 'static {
    /// What is stored.
    type Color: PixelColor;

    /// Bits of a pixel in memory: 1, 2, 4, 8, 16, 24 or 32.
    const BITS: u32;

    /// Below 8 bits: whether the leftmost pixel of a byte has its least significant bits.
    const LSB0: bool = false;

    /// The bits of a colour, below `2^BITS`. From 8 bits on, the least significant byte is the one that is stored first.
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

/// Writes the same bits to pixels `x0..x1`, which are not empty, of the row that starts at byte `row`.
#[inline(always)]
pub(crate) fn fill<F: PixelFormat>(memory: &mut [u8], row: usize, x0: usize, x1: usize, bits: u32) {
    if F::BITS < 8 {
        packed::fill::<F>(memory, row, x0, x1, bits);
    } else if let Some(run) = memory.get_mut(byte::<F>(row, x0)..byte::<F>(row, x1)) {
        word::fill::<F>(run, bits);
    }
}

/// The same for `rows` rows, at least one, that start `stride` bytes apart.
#[inline(always)]
pub(crate) fn fill_rows<F: PixelFormat>(
    memory: &mut [u8],
    stride: usize,
    (first_row, rows): (usize, usize),
    (x0, x1): (usize, usize),
    bits: u32,
) {
    if rows == 1 {
        return fill::<F>(memory, first_row, x0, x1, bits);
    }
    if F::BITS < 8 {
        return packed::fill_rows::<F>(memory, stride, (first_row, rows), (x0, x1), bits);
    }
    let last_row = first_row.wrapping_add(rows.wrapping_sub(1).wrapping_mul(stride));
    let len = byte::<F>(0, x1).wrapping_sub(byte::<F>(0, x0));
    let Some(all) = memory.get_mut(byte::<F>(first_row, x0)..byte::<F>(last_row, x1)) else { return };
    word::fill_area::<F>(all, stride, len, bits);
}

/// Writes one pixel.
#[inline(always)]
pub(crate) fn set<F: PixelFormat>(memory: &mut [u8], row: usize, x: usize, bits: u32) {
    if F::BITS < 8 {
        packed::set::<F>(memory, row, x, bits);
    } else {
        word::set::<F>(memory, byte::<F>(row, x), bits);
    }
}

/// Reads one pixel; 0 beyond the memory.
#[inline(always)]
pub(crate) fn get<F: PixelFormat>(memory: &[u8], row: usize, x: usize) -> u32 {
    if F::BITS < 8 {
        packed::get::<F>(memory, row, x)
    } else {
        word::get::<F>(memory, byte::<F>(row, x))
    }
}

/// Where pixel `x` of the row at byte `row` starts, for formats of whole bytes.
#[inline(always)]
const fn byte<F: PixelFormat>(row: usize, x: usize) -> usize {
    row.wrapping_add(x.wrapping_mul(bytes_per_pixel::<F>()))
}

/// For formats of whole bytes.
#[inline(always)]
pub(crate) const fn bytes_per_pixel<F: PixelFormat>() -> usize {
    (F::BITS / 8) as usize
}

/// Copies `n` pixels, at least one, between memories: each place is the first byte of a row and a pixel of it.
#[inline(always)]
pub(crate) fn copy<F: PixelFormat>(
    to: &mut [u8],
    (to_row, to_x): (usize, usize),
    from: &[u8],
    (from_row, from_x): (usize, usize),
    n: usize,
) {
    if F::BITS < 8 {
        packed::copy::<F>(to, (to_row, to_x), from, (from_row, from_x), n);
    } else {
        let to = to.get_mut(byte::<F>(to_row, to_x)..byte::<F>(to_row, to_x.wrapping_add(n)));
        let from = from.get(byte::<F>(from_row, from_x)..byte::<F>(from_row, from_x.wrapping_add(n)));
        if let (Some(to), Some(from)) = (to, from) {
            word::copy(to, from);
        }
    }
}

/// Whether there are bits that no colour has: the sixteenth of `Rgb555`, six of `Rgb666`. A picture may hold anything there.
#[inline(always)]
fn has_unused_bits<F: PixelFormat>() -> bool {
    let all = u32::MAX >> (32 - F::BITS);
    F::pack(F::unpack(all)) != all
}

/// The same, but leaves the pixels of the target where the source has the colour of the bits `key`.
#[inline(always)]
pub(crate) fn copy_keyed<F: PixelFormat>(
    to: &mut [u8],
    (to_row, to_x): (usize, usize),
    from: &[u8],
    (from_row, from_x): (usize, usize),
    n: usize,
    key: u32,
) {
    if F::BITS >= 8 && !has_unused_bits::<F>() {
        let to = to.get_mut(byte::<F>(to_row, to_x)..byte::<F>(to_row, to_x.wrapping_add(n)));
        let from = from.get(byte::<F>(from_row, from_x)..byte::<F>(from_row, from_x.wrapping_add(n)));
        if let (Some(to), Some(from)) = (to, from) {
            word::copy_keyed::<F>(to, from, key);
        }
        return;
    }
    for i in 0..n {
        let bits = get::<F>(from, from_row, from_x.wrapping_add(i));
        if F::pack(F::unpack(bits)) != key {
            set::<F>(to, to_row, to_x.wrapping_add(i), bits);
        }
    }
}
