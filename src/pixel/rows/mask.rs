//! One bit to one of two colours: glyphs, icons and cursors, painted in any format.
//!
//! Eight bits of the mask are taken at a time, put together from two bytes so that the leftmost pixel is the top bit. Where
//! pixels take whole bytes each bit chooses one of two values; 16-bit pixels go in pairs, which are looked up by two bits.
//!
//! Source: "colour expansion" of the blitters of display controllers, such as the ET4000/W32 of 1992.

use bytemuck::{pod_align_to_mut, Pod};

use super::{packed, word};
use crate::{
    num::cast::{low_u16, low_u8},
    pixel::format::{byte, PixelFormat},
    tune::{COMPACT, UNALIGNED},
};

/// Whether 16-bit pixels go in pairs: a loop of its own, and words that are stored at any address.
const PAIRS: bool = UNALIGNED && !COMPACT;

/// Eight pixels of a mask at a time, the leftmost in bit 31, from pixel `x` of the row at byte `row` on. Beyond the memory
/// all is 0.
pub(crate) struct Bits<'a> {
    bytes: &'a [u8],
    current: u32,
    shift: u32,
    lsb0: bool,
}

impl<'a> Bits<'a> {
    #[inline(always)]
    #[expect(clippy::cast_possible_truncation, reason = "at most 7")]
    pub(crate) fn new<M: PixelFormat>(memory: &'a [u8], row: usize, x: usize) -> Self {
        let bytes = memory.get(row.wrapping_add(x >> 3)..).unwrap_or_default();
        let mut bits = Self { bytes, current: 0, shift: (x & 7) as u32, lsb0: M::LSB0 };
        bits.current = bits.byte();
        bits
    }

    #[inline(always)]
    fn byte(&mut self) -> u32 {
        let Some((&byte, rest)) = self.bytes.split_first() else { return 0 };
        self.bytes = rest;
        u32::from(if self.lsb0 { byte.reverse_bits() } else { byte })
    }

    #[inline(always)]
    pub(crate) fn next(&mut self) -> u32 {
        let next = self.byte();
        let both = self.current << 24 | next << 16;
        self.current = next;
        both << self.shift
    }
}

/// One pixel of a mask at a time, where `bits` gives eight, the leftmost in bit 31.
#[inline(always)]
pub(crate) fn one_by_one(mut bits: impl FnMut() -> u32) -> impl FnMut() -> bool {
    let (mut eight, mut left) = (0_u32, 0_u32);
    move || {
        if left == 0 {
            (eight, left) = (bits(), 8);
        }
        let is_set = top(eight);
        eight <<= 1;
        left = left.wrapping_sub(1);
        is_set
    }
}

/// Writes the pixels `x0..x1` of the row that starts at byte `row`: `on` where the mask is set, `off`, or nothing, elsewhere.
/// `bits` gives eight pixels of the mask at a time, the leftmost in bit 31.
#[inline(always)]
pub(crate) fn draw<F: PixelFormat>(
    memory: &mut [u8],
    row: usize,
    (x0, x1): (usize, usize),
    mut bits: impl FnMut() -> u32,
    (on, off): (u32, Option<u32>),
) {
    if F::BITS < 8 {
        let mut x = x0;
        while x < x1 {
            let mut eight = bits();
            for x in x..x1.min(x.wrapping_add(8)) {
                if let Some(color) = if top(eight) { Some(on) } else { off } {
                    packed::set::<F>(memory, row, x, color);
                }
                eight <<= 1;
            }
            x = x.wrapping_add(8);
        }
        return;
    }
    let Some(run) = memory.get_mut(byte::<F>(row, x0)..byte::<F>(row, x1)) else { return };
    match F::BITS {
        8 => expand(run, bits, [low_u8(on)], off.map(|off| [low_u8(off)])),
        16 => expand16(run, bits, low_u16(on), off.map(low_u16)),
        24 => expand(run, bits, word::three(on), off.map(word::three)),
        _ => expand(run, bits, on.to_le_bytes(), off.map(u32::to_le_bytes)),
    }
}

/// Whether the leftmost pixel is set.
#[inline(always)]
fn top(bits: u32) -> bool {
    bits >> 31 != 0
}

/// Eight pixels at a time.
#[inline(always)]
fn expand<const N: usize>(run: &mut [u8], mut bits: impl FnMut() -> u32, on: [u8; N], off: Option<[u8; N]>)
where
    [u8; N]: Pod,
{
    let (_, pixels, _) = pod_align_to_mut::<u8, [u8; N]>(run);
    for group in pixels.chunks_mut(8) {
        put(group, bits(), on, off);
    }
}

/// Up to eight pixels.
#[inline(always)]
fn put<P: Copy>(group: &mut [P], mut eight: u32, on: P, off: Option<P>) {
    for place in group {
        if top(eight) {
            *place = on;
        } else if let Some(off) = off {
            *place = off;
        }
        eight <<= 1;
    }
}

/// Pairs of pixels by a table, where words can be stored at any address.
#[inline(always)]
fn expand16(run: &mut [u8], mut bits: impl FnMut() -> u32, on: u16, off: Option<u16>) {
    let Some(ground) = off.filter(|_| PAIRS) else {
        return expand(run, bits, on.to_le_bytes(), off.map(u16::to_le_bytes));
    };
    let pair = |left: u16, right: u16| (u32::from(right) << 16 | u32::from(left)).to_le_bytes();
    let pairs = [pair(ground, ground), pair(ground, on), pair(on, ground), pair(on, on)];
    let pair = |bits: u32| pairs[(bits >> 30 & 3) as usize];
    let mut groups = run.chunks_exact_mut(16);
    for group in &mut groups {
        let eight = bits();
        if let Some(group) = group.first_chunk_mut::<16>() {
            let [a, b, c, d]: &mut [[u8; 4]; 4] = bytemuck::cast_mut(group);
            (*a, *b, *c, *d) = (pair(eight), pair(eight << 2), pair(eight << 4), pair(eight << 6));
        }
    }
    let mut rest = groups.into_remainder().chunks_exact_mut(4);
    let mut eight = bits();
    for place in &mut rest {
        place.copy_from_slice(&pair(eight));
        eight <<= 2;
    }
    if let Some(last) = rest.into_remainder().first_chunk_mut() {
        *last = if top(eight) { on } else { ground }.to_le_bytes();
    }
}
