//! Strips of glyphs: up to eight pixels of one bit in each of some rows, painted in any format.
//!
//! A row is a byte, so a row costs a load, a step down, and what the pixels themselves cost:
//! - Where several pixels share a byte, the bits of the mask are spread to the bits of the pixels, and each byte of memory is merged
//!   once, whole. At one bit per pixel nothing is spread: a row of a glyph is two bytes at most.
//! - Where pixels take whole bytes and the ground stays, the zeros before the next set bit are counted: work goes with lit pixels.
//! - 16-bit pixels on a ground go in pairs, looked up by two bits; how many pairs there are in a row is known to the compiler.
//!
//! Places: `memory` is a whole memory, the first row starts at byte `row`, and others a stride after it.

use core::mem::take;

use bytemuck::{pod_align_to_mut, Pod};

use super::{packed, word};
use crate::{
    num::cast::{low_u16, low_u8},
    pixel::format::{byte, PixelFormat},
    tune::{ARMV6, COMPACT, UNALIGNED},
};

/// Whether 16-bit pixels go in pairs: words that are stored at any address, and a loop for each number of pairs.
const PAIRS: bool = UNALIGNED && !COMPACT;

/// Whether zeros are counted. Armv6-M has no instruction for it, and there are never more than seven.
const COUNTS: bool = !ARMV6;

/// Writes the strip: `on` where a bit is set, `off`, or nothing, elsewhere. Of each byte of `strip`, `skip` pixels are left out and
/// `width`, at least one, are wanted; the first falls on pixel `x`.
#[inline(always)]
pub(crate) fn draw<F: PixelFormat>(
    memory: &mut [u8],
    (row, stride): (usize, usize),
    x: usize,
    (strip, (skip, width)): (&[u8], (u32, u32)),
    (on, off): (u32, Option<u32>),
) {
    if F::BITS < 8 {
        let wanted = low_u8(0xff00 >> (width & 31));
        return packed::draw_strip::<F>(memory, (row, stride), x, (strip, (skip, wanted)), (on, off));
    }
    let Some(memory) = memory.get_mut(byte::<F>(row, x)..) else { return };
    if let (16, true, Some(off)) = (F::BITS, PAIRS && skip == 0, off) {
        return in_pairs((memory, stride), width, strip, low_u16(on), low_u16(off));
    }
    // The leftmost pixel that is wanted in bit 31. Bits that follow the wanted ones lie beyond the end of a row.
    let rows = strip.iter().map(|bits| u32::from(*bits) << 24 << (skip & 31));
    match F::BITS {
        8 => expand((memory, stride), width, rows, [low_u8(on)], off.map(|off| [low_u8(off)])),
        16 => {
            expand((memory, stride), width, rows, low_u16(on).to_le_bytes(), off.map(|off| low_u16(off).to_le_bytes()));
        }
        24 => expand((memory, stride), width, rows, word::three(on), off.map(word::three)),
        _ => expand((memory, stride), width, rows, on.to_le_bytes(), off.map(u32::to_le_bytes)),
    }
}

/// Calls `f` with `len` bytes of each row, and its bits.
#[inline(always)]
fn each_row(
    (mut memory, stride): (&mut [u8], usize),
    len: usize,
    rows: impl Iterator<Item = u32>,
    mut f: impl FnMut(&mut [u8], u32),
) {
    for bits in rows {
        let Some(row) = memory.get_mut(..len) else { return };
        f(row, bits);
        // The last row may end before its stride does.
        let Some(rest) = take(&mut memory).get_mut(stride..) else { return };
        memory = rest;
    }
}

/// Pixels of `N` bytes.
#[inline(always)]
fn expand<const N: usize>(
    memory: (&mut [u8], usize),
    width: u32,
    rows: impl Iterator<Item = u32>,
    on: [u8; N],
    off: Option<[u8; N]>,
) where
    [u8; N]: Pod,
{
    let len = (width as usize).wrapping_mul(N);
    match off {
        Some(off) => each_row(memory, len, rows, |row, mut bits| {
            let (_, pixels, _) = pod_align_to_mut::<u8, [u8; N]>(row);
            for place in pixels {
                *place = if bits >> 31 != 0 { on } else { off };
                bits <<= 1;
            }
        }),
        None => each_row(memory, len, rows, |row, bits| light(row, bits, on)),
    }
}

/// The set pixels of a row.
#[inline(always)]
fn light<const N: usize>(row: &mut [u8], mut bits: u32, on: [u8; N])
where
    [u8; N]: Pod,
{
    let (_, pixels, _) = pod_align_to_mut::<u8, [u8; N]>(row);
    if COUNTS {
        while bits != 0 {
            let before = bits.leading_zeros();
            if let Some(place) = pixels.get_mut(before as usize) {
                *place = on;
            }
            bits &= !(0x8000_0000 >> (before & 31));
        }
    } else {
        for place in pixels {
            if bits >> 31 != 0 {
                *place = on;
            }
            bits <<= 1;
        }
    }
}

/// Pixels of 16 bits on a ground, in whole pairs, and the last column by itself if there is one more.
#[inline(always)]
fn in_pairs((memory, stride): (&mut [u8], usize), width: u32, strip: &[u8], on: u16, ground: u16) {
    let pair = |left: u16, right: u16| (u32::from(right) << 16 | u32::from(left)).to_le_bytes();
    let pairs = [pair(ground, ground), pair(ground, on), pair(on, ground), pair(on, on)];
    if width & 1 != 0 {
        let last = width.wrapping_sub(1);
        if let Some(memory) = memory.get_mut((last as usize).wrapping_mul(2)..) {
            let rows = strip.iter().map(|bits| u32::from(*bits) << 24 << (last & 31));
            expand((memory, stride), 1, rows, on.to_le_bytes(), Some(ground.to_le_bytes()));
        }
    }
    match width >> 1 {
        1 => rows_of_pairs::<1>((memory, stride), strip, &pairs),
        2 => rows_of_pairs::<2>((memory, stride), strip, &pairs),
        3 => rows_of_pairs::<3>((memory, stride), strip, &pairs),
        4 => rows_of_pairs::<4>((memory, stride), strip, &pairs),
        _ => {}
    }
}

/// `N` pairs in each row.
#[inline(always)]
fn rows_of_pairs<const N: usize>(memory: (&mut [u8], usize), strip: &[u8], pairs: &[[u8; 4]; 4]) {
    each_row(memory, N.wrapping_mul(4), strip.iter().map(|bits| u32::from(*bits)), |row, bits| {
        let (_, places, _) = pod_align_to_mut::<u8, [u8; 4]>(row);
        let Some(places) = places.first_chunk_mut::<N>() else { return };
        let mut shift = 6;
        for place in places {
            *place = pairs[(bits >> (shift & 31) & 3) as usize];
            shift = u32::wrapping_sub(shift, 2) & 7;
        }
    });
}
