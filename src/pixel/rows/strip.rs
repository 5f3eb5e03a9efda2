//! Strips of glyphs: up to eight pixels of one bit in each of some rows, painted in any format.
//!
//! A row is a byte, so a row costs a load, a step down, and what the pixels themselves cost:
//! - Where several pixels share a byte, the bits of the mask are spread to the bits of the pixels, and each byte of memory is merged
//!   once, whole. At one bit per pixel nothing is spread: a row of a glyph is two bytes at most.
//! - Where pixels take whole bytes and the ground stays, the zeros before the next set bit are counted: work goes with lit pixels.
//! - 16-bit pixels on a ground go in pairs, looked up by two bits; how many pairs there are in a row is known to the compiler.
//!
//! Places: `memory` is a whole memory, the first row starts at byte `row`, and others a stride after it. Where all rows of a strip are in
//! memory from their first byte to the end of their stride, as they are but for gaps behind the last row, they are cut apart at once:
//! then no row asks whether it is there.

use bytemuck::{pod_align_to_mut, Pod};

use super::{packed, word};
use crate::{
    num::cast::{low_u16, low_u8},
    pixel::format::{byte, PixelFormat},
    tune::{keep_rolled, ARMV6, ARMV7, COMPACT, UNALIGNED},
};

/// Whether 16-bit pixels go in pairs: words that are stored at any address, and a loop for each number of pairs.
pub(crate) const PAIRS: bool = UNALIGNED && !COMPACT;

/// Two pixels of 16 bits for each two bits of a strip.
pub(crate) type Pairs = [[u8; 4]; 4];

/// The pairs of two colours; of other formats nobody asks for them.
#[inline(always)]
pub(crate) fn pairs<F: PixelFormat>(on: u32, ground: u32) -> Pairs {
    if F::BITS != 16 {
        return Pairs::default();
    }
    let (on, ground) = (low_u16(on), low_u16(ground));
    let pair = |left: u16, right: u16| (u32::from(right) << 16 | u32::from(left)).to_le_bytes();
    [pair(ground, ground), pair(ground, on), pair(on, ground), pair(on, on)]
}

/// Whether rows are cut apart at once. It takes a loop more, for rows that are not whole.
const AT_ONCE: bool = PAIRS;

/// Whether zeros are counted. Armv6-M has no instruction for it, and there are never more than seven.
const COUNTS: bool = !ARMV6;

/// Writes the strip: `on` where a bit is set, `off`, or nothing, elsewhere. Of each byte of `strip`, `skip` pixels are left out and
/// `width`, at least one, are wanted; the first falls on pixel `x`. Of both colours there may be [`pairs`].
#[inline(always)]
pub(crate) fn draw<F: PixelFormat>(
    memory: &mut [u8],
    (row, stride): (usize, usize),
    x: usize,
    (strip, (skip, width)): (&[u8], (u32, u32)),
    (on, off): (u32, Option<u32>),
    pairs: Option<&Pairs>,
) {
    if F::BITS < 8 {
        let wanted = low_u8(0xff00 >> (width & 31));
        return packed::draw_strip::<F>(memory, (row, stride), x, (strip, (skip, wanted)), (on, off));
    }
    let at = byte::<F>(0, x);
    if let (16, 0, Some(pairs), Some(_)) = (F::BITS, skip, pairs, off) {
        if let Some(area) = whole_rows(memory, (row, stride), strip) {
            return in_pairs(area, at, width, pairs);
        }
    }
    let place = (memory, (row, stride), at);
    let bits = (strip, skip, width);
    match F::BITS {
        8 => expand(place, bits, [low_u8(on)], off.map(|off| [low_u8(off)])),
        16 => expand(place, bits, low_u16(on).to_le_bytes(), off.map(|off| low_u16(off).to_le_bytes())),
        24 => expand(place, bits, word::three(on), off.map(word::three)),
        _ => expand(place, bits, on.to_le_bytes(), off.map(u32::to_le_bytes)),
    }
}

/// Rows of a memory, each from its first byte to the end of its stride, and a byte of a strip for each.
struct Whole<'m, 's> {
    area: &'m mut [u8],
    stride: usize,
    strip: &'s [u8],
}

impl Whole<'_, '_> {
    /// Calls `f` with `len` bytes from `at` on of each row, and its byte of the strip.
    #[inline(always)]
    fn each(self, (at, len): (usize, usize), mut f: impl FnMut(&mut [u8], u8)) {
        // All rows are as long as a stride: whether that is long enough is asked once.
        let end = at.wrapping_add(len);
        if self.stride == 0 || at > end || end > self.stride {
            return;
        }
        for (row, bits) in self.area.chunks_exact_mut(self.stride).zip(self.strip) {
            if let Some(row) = row.get_mut(at..end) {
                f(row, *bits);
            }
        }
    }
}

/// The rows of a strip; `None` if one of them is not whole, or so long that nobody has it.
#[inline(always)]
fn whole_rows<'m, 's>(memory: &'m mut [u8], (row, stride): (usize, usize), strip: &'s [u8]) -> Option<Whole<'m, 's>> {
    // Numbers so small that the compiler knows: their product by one of them is the other. Nothing is divided.
    let (rows, stride) = (u8::try_from(strip.len()).ok()?, u16::try_from(stride).ok()?);
    let (rows, stride) = (usize::from(rows), usize::from(stride));
    let area = memory.get_mut(row..row.wrapping_add(rows.wrapping_mul(stride)))?;
    Some(Whole { area, stride, strip })
}

/// Calls `f` with `len` bytes of each row, and its byte of the strip.
#[inline(always)]
fn each_row(
    (memory, (row, stride), at): (&mut [u8], (usize, usize), usize),
    len: usize,
    strip: &[u8],
    mut f: impl FnMut(&mut [u8], u8),
) {
    if AT_ONCE {
        if let Some(area) = whole_rows(memory, (row, stride), strip) {
            return area.each((at, len), f);
        }
    }
    let mut start = row.wrapping_add(at);
    for bits in strip {
        let Some(row) = memory.get_mut(start..).and_then(|row| row.get_mut(..len)) else { return };
        f(row, *bits);
        start = start.wrapping_add(stride);
    }
}

/// Pixels of `N` bytes.
#[inline(always)]
fn expand<const N: usize>(
    place: (&mut [u8], (usize, usize), usize),
    (strip, skip, width): (&[u8], u32, u32),
    on: [u8; N],
    off: Option<[u8; N]>,
) where
    [u8; N]: Pod,
{
    // The leftmost pixel that is wanted in bit 31. Bits that follow the wanted ones lie beyond the end of a row.
    let shift = skip.wrapping_add(24) & 31;
    let len = (width as usize).wrapping_mul(N);
    match off {
        Some(off) => each_row(place, len, strip, |row, bits| {
            let mut bits = u32::from(bits) << shift;
            let (_, pixels, _) = pod_align_to_mut::<u8, [u8; N]>(row);
            for place in pixels {
                *place = if bits >> 31 != 0 { on } else { off };
                bits <<= 1;
            }
        }),
        // Letters are seldom cut on their left. A shift that is known takes no register, of which the loop over letters has none to spare.
        None if AT_ONCE && skip == 0 => each_row(place, len, strip, |row, bits| light(row, u32::from(bits) << 24, on)),
        None => each_row(place, len, strip, |row, bits| light(row, u32::from(bits) << shift, on)),
    }
}

/// The set pixels of a row. In most letters a third of the rows has none.
#[inline(always)]
fn light<const N: usize>(row: &mut [u8], mut bits: u32, on: [u8; N])
where
    [u8; N]: Pod,
{
    if bits == 0 {
        return;
    }
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

/// Pixels of 16 bits on a ground, in pairs, and the last column by itself if there is one more.
#[inline(always)]
fn in_pairs(area: Whole<'_, '_>, at: usize, width: u32, pairs: &Pairs) {
    match width {
        1 => rows_of_pairs::<0, true>(area, at, pairs),
        2 => rows_of_pairs::<1, false>(area, at, pairs),
        3 => rows_of_pairs::<1, true>(area, at, pairs),
        4 => rows_of_pairs::<2, false>(area, at, pairs),
        5 => rows_of_pairs::<2, true>(area, at, pairs),
        6 => rows_of_pairs::<3, false>(area, at, pairs),
        7 => rows_of_pairs::<3, true>(area, at, pairs),
        8 => rows_of_pairs::<4, false>(area, at, pairs),
        _ => {}
    }
}

/// `N` pairs in each row, and one pixel more if the width is odd.
#[inline(always)]
fn rows_of_pairs<const N: usize, const ODD: bool>(area: Whole<'_, '_>, at: usize, pairs: &Pairs) {
    let len = N.wrapping_mul(4).wrapping_add(if ODD { 2 } else { 0 });
    area.each((at, len), |row, bits| {
        let pair = |shift: u32| pairs[(u32::from(bits) >> (shift & 31) & 3) as usize];
        let (_, places, one_more) = pod_align_to_mut::<u8, [u8; 4]>(row);
        let mut shift = 6;
        for place in places {
            *place = pair(shift);
            shift = shift.wrapping_sub(2) & 7;
        }
        if let (true, Some(place)) = (ODD, one_more.first_chunk_mut()) {
            let [low, high, ..] = pair(shift);
            *place = [low, high];
        }
        // Four rows in a turn would leave two or three of most letters to be drawn one by one.
        keep_rolled(ARMV7);
    });
}
