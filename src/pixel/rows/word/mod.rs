//! 8, 16, 24 and 32 bits per pixel: whole bytes, the least significant one first.
//!
//! A run of one colour is a pattern of 1, 2, 3 or 4 bytes. All but the third repeat in a 32-bit word, so a run is filled by
//! words: a head and a tail, and aligned words between. How the words are written is shaped by what compilers make of it on
//! small cores: `compact` has one short loop for each kind of work, `fast` has several ways, and here one of the two is chosen.

#[cfg(embedded_raster_compact)]
mod compact;
#[cfg(not(embedded_raster_compact))]
mod fast;
mod parts;
mod pixels;
mod three;

use bytemuck::{pod_align_to_mut, Pod};

use crate::{
    num::cast::{low_u16, low_u8},
    pixel::format::{bytes_per_pixel, PixelFormat},
};

#[cfg(embedded_raster_compact)]
use self::compact as chosen;
#[cfg(not(embedded_raster_compact))]
use self::fast as chosen;

use self::three::fill_span24;
pub(super) use self::{
    chosen::{copy_rows, fill_rows, fill_span},
    parts::each_row,
    pixels::{copy_keyed, edit, get, mix, nth, set, three, write, write_all, write_parts, write_rows},
};

/// A word full of pixels, for the formats that repeat in one.
#[inline(always)]
fn word<F: PixelFormat>(bits: u32) -> u32 {
    match F::BITS {
        8 => u32::from(low_u8(bits)).wrapping_mul(0x0101_0101),
        16 => u32::from(low_u16(bits)).wrapping_mul(0x1_0001),
        _ => bits,
    }
}

/// Fills a run of whole pixels.
#[inline(always)]
pub(super) fn fill<F: PixelFormat>(run: &mut [u8], bits: u32) {
    if F::BITS == 24 {
        fill_span24(run, bits);
    } else {
        fill_span(run, word::<F>(bits));
    }
}

/// Fills `rows` rows of `len` bytes, the first at the start of `memory` and each `stride` bytes after the last; `memory`
/// ends with the last.
#[inline(always)]
pub(super) fn fill_area<F: PixelFormat>(memory: &mut [u8], (stride, rows): (usize, usize), len: usize, bits: u32) {
    if F::BITS == 24 && len == stride {
        fill_span24(memory, bits);
    } else if F::BITS == 24 {
        each_row(memory, stride, len, |row| fill_span24(row, bits));
    } else if len == bytes_per_pixel::<F>() && len < stride && stride.is_multiple_of(len) {
        fill_column::<F>(memory, (stride, rows), bits);
    } else {
        fill_rows(memory, stride, len, word::<F>(bits));
    }
}

/// A vertical run: the first pixel of the memory, and one every `stride` bytes, a multiple of the pixel's.
#[inline(always)]
fn fill_column<F: PixelFormat>(memory: &mut [u8], (stride, rows): (usize, usize), bits: u32) {
    match F::BITS {
        8 => column(memory, (stride, rows), [low_u8(bits)]),
        16 => column(memory, (stride, rows), low_u16(bits).to_le_bytes()),
        _ => column(memory, (stride, rows), bits.to_le_bytes()),
    }
}

/// The same for pixels of `N` bytes.
fn column<const N: usize>(memory: &mut [u8], (stride, rows): (usize, usize), pixel: [u8; N])
where
    [u8; N]: Pod,
{
    let (_, pixels, _) = pod_align_to_mut::<u8, [u8; N]>(memory);
    chosen::fill_column(pixels, (stride / N, rows), pixel);
}
