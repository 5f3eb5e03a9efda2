//! 1, 2 and 4 bits per pixel: several pixels to a byte.
//! ```text
//!     Msb0   bit 7 .. 0        Lsb0   bit 7 .. 0
//!     4 bits    [0 ][1 ]              [1 ][0 ]        [n]: pixel n of the byte
//!     1 bit     [01234567]            [76543210]
//! ```
//! A run of pixels is a byte of which the run owns the end, whole bytes, and a byte of which it owns the start: masked
//! ends and a plain middle.

use super::word;
use crate::{
    num::cast::{low_u32, low_u8},
    pixel::format::PixelFormat,
    tune::COMPACT,
};

/// How many bytes are copied at once where there are as many; built for size, one after the other.
const GROUP: usize = if COMPACT { usize::MAX } else { 4 };

/// Pixels of a byte, less one: 7, 3, 1.
const fn last_in_byte<F: PixelFormat>() -> usize {
    (8 / F::BITS - 1) as usize
}

/// log2 of the pixels of a byte: 3, 2, 1.
const fn byte_shift<F: PixelFormat>() -> u32 {
    (8 / F::BITS).trailing_zeros()
}

/// How far the bits of pixel `x` stand above bit 0 of their byte.
#[inline(always)]
fn shift<F: PixelFormat>(x: usize) -> u32 {
    if F::LSB0 {
        in_byte::<F>(x)
    } else {
        8 - F::BITS - in_byte::<F>(x)
    }
}

/// Bits of the pixels before `x` in its byte.
#[inline(always)]
#[expect(clippy::cast_possible_truncation, reason = "at most 7")]
fn in_byte<F: PixelFormat>(x: usize) -> u32 {
    (x & last_in_byte::<F>()) as u32 * F::BITS
}

/// The bits of one pixel at bit 0.
const fn mask<F: PixelFormat>() -> u8 {
    0xff >> (8 - F::BITS)
}

/// A byte full of one pixel.
#[inline(always)]
pub(crate) fn repeat<F: PixelFormat>(bits: u32) -> u8 {
    low_u8(bits.wrapping_mul(0xff / ((1 << F::BITS) - 1)))
}

/// The bits of the pixels from `x` on in its byte.
#[inline(always)]
fn from_mask<F: PixelFormat>(x: usize) -> u8 {
    if F::LSB0 {
        0xff << in_byte::<F>(x)
    } else {
        0xff >> in_byte::<F>(x)
    }
}

/// The bits of the pixels up to `x` in its byte.
#[inline(always)]
fn to_mask<F: PixelFormat>(x: usize) -> u8 {
    let after = 8 - F::BITS - in_byte::<F>(x);
    if F::LSB0 {
        0xff >> after
    } else {
        0xff << after
    }
}

/// Puts the masked bits of `new` in place of those of `old`.
#[inline(always)]
pub(crate) fn merge(old: u8, new: u8, mask: u8) -> u8 {
    old ^ ((old ^ new) & mask)
}

/// Pixel `x` of a byte, for 8 bits too.
#[inline(always)]
pub(crate) fn nth<F: PixelFormat>(byte: u8, x: usize) -> u32 {
    u32::from(byte >> shift::<F>(x) & mask::<F>())
}

#[inline(always)]
pub(super) fn fill<F: PixelFormat>(memory: &mut [u8], row: usize, x0: usize, x1: usize, bits: u32) {
    let byte = repeat::<F>(bits);
    let last = x1.wrapping_sub(1);
    let bytes = row.wrapping_add(x0 >> byte_shift::<F>())..=row.wrapping_add(last >> byte_shift::<F>());
    let head_mask = from_mask::<F>(x0);
    let tail_mask = to_mask::<F>(last);
    match memory.get_mut(bytes) {
        Some([only]) => *only = merge(*only, byte, head_mask & tail_mask),
        Some([head, middle @ .., tail]) => {
            *head = merge(*head, byte, head_mask);
            word::fill_span(middle, word_of(byte));
            *tail = merge(*tail, byte, tail_mask);
        }
        _ => {}
    }
}

/// The same for rows that start `stride` bytes apart: one column of bytes, whole bytes, or three parts a row.
pub(super) fn fill_rows<F: PixelFormat>(
    memory: &mut [u8],
    stride: usize,
    (row, rows): (usize, usize),
    (x0, x1): (usize, usize),
    bits: u32,
) {
    let byte = repeat::<F>(bits);
    let last = x1.wrapping_sub(1);
    let (first_byte, last_byte) = (x0 >> byte_shift::<F>(), last >> byte_shift::<F>());
    let end = row.wrapping_add(rows.wrapping_sub(1).wrapping_mul(stride)).wrapping_add(last_byte).wrapping_add(1);
    let Some(memory) = memory.get_mut(row.wrapping_add(first_byte)..end) else { return };
    let (head_mask, tail_mask) = (from_mask::<F>(x0), to_mask::<F>(last));
    let len = last_byte.wrapping_sub(first_byte).wrapping_add(1);
    if head_mask & tail_mask == 0xff {
        return word::fill_rows(memory, stride, len, word_of(byte));
    }
    word::each_row(memory, stride, len, |row| match row {
        [only] => *only = merge(*only, byte, head_mask & tail_mask),
        [head, middle @ .., tail] => {
            *head = merge(*head, byte, head_mask);
            word::fill_span(middle, word_of(byte));
            *tail = merge(*tail, byte, tail_mask);
        }
        [] => {}
    });
}

/// A word full of one byte.
#[inline(always)]
fn word_of(byte: u8) -> u32 {
    u32::from(byte).wrapping_mul(0x0101_0101)
}

#[inline(always)]
pub(super) fn set<F: PixelFormat>(memory: &mut [u8], row: usize, x: usize, bits: u32) {
    if let Some(byte) = memory.get_mut(row.wrapping_add(x >> byte_shift::<F>())) {
        *byte = merge(*byte, low_u8(bits << shift::<F>(x)), mask::<F>() << shift::<F>(x));
    }
}

#[inline(always)]
pub(super) fn get<F: PixelFormat>(memory: &[u8], row: usize, x: usize) -> u32 {
    let byte = memory.get(row.wrapping_add(x >> byte_shift::<F>())).copied().unwrap_or(0);
    nth::<F>(byte, x)
}

/// Writes pixels from left to right, byte by byte: what `next` gives. Whole bytes are assembled without a look at what is there.
#[inline(always)]
pub(super) fn write_all<F: PixelFormat>(
    memory: &mut [u8],
    row: usize,
    (x0, x1): (usize, usize),
    mut next: impl FnMut() -> u32,
) {
    let whole = last_in_byte::<F>().wrapping_add(1);
    each_byte::<F>(memory, row, (x0, x1), |byte, (start, end)| {
        if !COMPACT && end.wrapping_sub(start) == whole {
            *byte = low_u8(pushed::<F>(whole, &mut next));
            return;
        }
        let count = end.wrapping_sub(start);
        let new = pushed::<F>(count, &mut next);
        // Pushed in, the last pixel has the lowest bits of all, or for Lsb0 the highest ones of the byte.
        let all = u32::from(u8::MAX);
        let (first, last) = (shift::<F>(start), shift::<F>(end.wrapping_sub(1)));
        let (new, written) = if F::LSB0 {
            (new >> (8 - F::BITS).wrapping_sub(last), all << first & all >> (8 - F::BITS).wrapping_sub(last))
        } else {
            (new << last, all << last & all >> (8 - F::BITS).wrapping_sub(first))
        };
        *byte = merge(*byte, low_u8(new), low_u8(written));
    });
}

/// So many pixels, each pushed in from the right, or for Lsb0 from the left of a byte.
#[inline(always)]
fn pushed<F: PixelFormat>(count: usize, next: &mut impl FnMut() -> u32) -> u32 {
    let mut new = 0;
    for _ in 0..count {
        new = if F::LSB0 { new >> F::BITS | next() << (8 - F::BITS) } else { new << F::BITS | next() };
    }
    new
}

/// Writes pixels from left to right, byte by byte: what `next` gives, or nothing where that is `None`.
#[inline(always)]
pub(super) fn write<F: PixelFormat>(
    memory: &mut [u8],
    row: usize,
    (x0, x1): (usize, usize),
    mut next: impl FnMut() -> Option<u32>,
) {
    each_byte::<F>(memory, row, (x0, x1), |byte, (start, end)| {
        // Pixels are pushed in from the right, or for Lsb0 from the left, and moved to their place at the end.
        let (mut new, mut written) = (0_u32, 0_u32);
        let enter = if F::LSB0 { 8 - F::BITS } else { 0 };
        for _ in start..end {
            (new, written) =
                if F::LSB0 { (new >> F::BITS, written >> F::BITS) } else { (new << F::BITS, written << F::BITS) };
            if let Some(bits) = next() {
                new |= bits << enter;
                written |= u32::from(mask::<F>()) << enter;
            }
        }
        let last = shift::<F>(end.wrapping_sub(1));
        let moved = |bits: u32| low_u8(if F::LSB0 { bits >> enter.wrapping_sub(last) } else { bits << last });
        *byte = merge(*byte, moved(new), moved(written));
    });
}

/// Replaces pixels from left to right, byte by byte, each by what `edit` makes of it.
#[inline(always)]
pub(super) fn edit<F: PixelFormat>(
    memory: &mut [u8],
    row: usize,
    (x0, x1): (usize, usize),
    mut edit: impl FnMut(u32) -> u32,
) {
    each_byte::<F>(memory, row, (x0, x1), |byte, (start, end)| {
        let mut new = *byte;
        for x in start..end {
            let bits = edit(nth::<F>(*byte, x));
            new = merge(new, low_u8(bits << shift::<F>(x)), mask::<F>() << shift::<F>(x));
        }
        *byte = new;
    });
}

/// Calls `f` with each byte that has one of the pixels `x0..x1`, and with those pixels of the range that it has.
#[inline(always)]
fn each_byte<F: PixelFormat>(
    memory: &mut [u8],
    row: usize,
    (x0, x1): (usize, usize),
    mut f: impl FnMut(&mut u8, (usize, usize)),
) {
    let bytes = row.wrapping_add(x0 >> byte_shift::<F>())..=row.wrapping_add(x1.wrapping_sub(1) >> byte_shift::<F>());
    let mut start = x0;
    for byte in memory.get_mut(bytes).unwrap_or_default() {
        let end = x1.min((start | last_in_byte::<F>()).wrapping_add(1));
        f(byte, (start, end));
        start = end;
    }
}

/// Whether the bytes that opaque strips cover are gone through column by column: what of a byte is painted is found out once, not in each
/// row, and a byte that is painted as a whole is not read.
const BY_COLUMNS: bool = !COMPACT;

/// Writes a strip of up to eight pixels in each of some rows: see [`strip`](super::strip). `skip` pixels of each byte are left out,
/// and those of `wanted`, from the left, are painted.
#[inline(always)]
pub(super) fn draw_strip<F: PixelFormat>(
    memory: &mut [u8],
    (row, stride): (usize, usize),
    x: usize,
    (strip, (skip, wanted)): (&[u8], (u32, u8)),
    (on, off): (u32, Option<u32>),
) {
    let (on, ground) = (repeat::<F>(on), repeat::<F>(off.unwrap_or(on)));
    // Eight pixels of the strip as they lie in the bytes of a row: the pixels of the first byte on top, down from bit 15.
    let before = x & last_in_byte::<F>();
    let placed = |bits: u8| u32::from(bits) << 8 >> (before & 31);
    let always = if off.is_some() { placed(wanted) } else { 0 };
    let len =
        before.wrapping_add(wanted.leading_ones() as usize).wrapping_add(last_in_byte::<F>()) >> byte_shift::<F>();
    let mut start = row.wrapping_add(x >> byte_shift::<F>());
    if BY_COLUMNS && off.is_some() {
        // How far right the pixels of the first byte are from the bits of their mask.
        let (mut painted, mut right) =
            (always, (8 - 8 / F::BITS).wrapping_add(low_u32(before as u64)).wrapping_sub(skip));
        for at in start..start.wrapping_add(len) {
            let value = |bits: u8| merge(ground, on, spread_low::<F>(u32::from(bits).rotate_right(right & 31)));
            match spread::<F>(painted) {
                0xff => down(memory, (at, stride), strip, |place, bits| *place = value(bits)),
                mask => down(memory, (at, stride), strip, |place, bits| *place = merge(*place, value(bits), mask)),
            }
            (painted, right) = (painted << (8 / F::BITS), right.wrapping_sub(8 / F::BITS));
        }
        return;
    }
    for bits in strip {
        let (mut set, mut painted) = (placed(low_u8(u32::from(*bits) << (skip & 31)) & wanted), always);
        painted |= set;
        // In most letters a third of the rows is empty.
        if painted != 0 {
            for place in memory.get_mut(start..start.wrapping_add(len)).unwrap_or_default() {
                let (ink, mask) = (spread::<F>(set), spread::<F>(painted));
                *place = merge(*place, merge(ground, on, ink), mask);
                (set, painted) = (set << (8 / F::BITS), painted << (8 / F::BITS));
            }
        }
        start = start.wrapping_add(stride);
    }
}

/// Goes down a column of bytes, from one on, with a byte of the strip for each row.
#[inline(always)]
fn down(memory: &mut [u8], (mut at, stride): (usize, usize), strip: &[u8], mut f: impl FnMut(&mut u8, u8)) {
    for bits in strip {
        let Some(place) = memory.get_mut(at) else { return };
        f(place, *bits);
        at = at.wrapping_add(stride);
    }
}

/// The bits of the pixels of a byte that are set in a mask: that of the leftmost pixel is its bit 15. Bits above do not matter.
#[inline(always)]
fn spread<F: PixelFormat>(mask: u32) -> u8 {
    spread_low::<F>(mask >> (16 - 8 / F::BITS))
}

/// The same for a mask of which the bit of the rightmost pixel is bit 0.
#[inline(always)]
fn spread_low<F: PixelFormat>(mask: u32) -> u8 {
    if F::BITS == 1 {
        let bits = low_u8(mask);
        return if F::LSB0 { bits.reverse_bits() } else { bits };
    }
    let table = const { spreads(F::BITS, F::LSB0) };
    table[mask as usize & last_of_table::<F>()]
}

/// The last entry of [`spreads`] that is needed: a bit for each pixel of a byte.
const fn last_of_table<F: PixelFormat>() -> usize {
    ((1 << (8 / F::BITS)) - 1) & 15
}

/// For the bits of the pixels of a byte, the leftmost one on top, all bits of those that are set.
const fn spreads(bits: u32, lsb0: bool) -> [u8; 16] {
    let mut table = [0; 16];
    let mut set = 0;
    while set < 16 {
        let (mut byte, mut pixel) = (0_u8, 0);
        while pixel < 8 / bits {
            if set >> (8 / bits - 1 - pixel) & 1 != 0 {
                byte |= (0xff_u8 >> (8 - bits)) << (8 - bits - bits * pixel);
            }
            pixel += 1;
        }
        table[set] = if lsb0 { byte.reverse_bits() } else { byte };
        set += 1;
    }
    table
}

/// Copies pixels.
#[inline(always)]
pub(super) fn copy<F: PixelFormat>(
    to: &mut [u8],
    to_place: (usize, usize),
    from: &[u8],
    from_place: (usize, usize),
    n: usize,
) {
    copy_masked::<F>(to, to_place, from, from_place, n, |_| u32::MAX);
}

/// Copies rows, at least one, that start a stride apart: each memory comes with its own.
#[inline(always)]
pub(super) fn copy_rows<F: PixelFormat>(
    (to, to_stride): (&mut [u8], usize),
    (to_row, to_x): (usize, usize),
    (from, from_stride): (&[u8], usize),
    (from_row, from_x): (usize, usize),
    (n, rows): (usize, usize),
) {
    for i in 0..rows {
        let to_row = to_row.wrapping_add(i.wrapping_mul(to_stride));
        let from_row = from_row.wrapping_add(i.wrapping_mul(from_stride));
        copy::<F>(to, (to_row, to_x), from, (from_row, from_x), n);
    }
}

/// The same on computers: bytes that hold the same pixels in both memories are copied as bytes.
pub(super) fn copy_bytes<F: PixelFormat>(
    (to, to_stride): (&mut [u8], usize),
    (to_row, to_x): (usize, usize),
    (from, from_stride): (&[u8], usize),
    (from_row, from_x): (usize, usize),
    (n, rows): (usize, usize),
) {
    let mut columns = |x: usize, n: usize| {
        let (to_place, from_place) = ((to_row, to_x.wrapping_add(x)), (from_row, from_x.wrapping_add(x)));
        copy_rows::<F>((to, to_stride), to_place, (from, from_stride), from_place, (n, rows));
    };
    // Pixels before the first whole byte, and after the last.
    let head = to_x.wrapping_neg() & last_in_byte::<F>();
    let whole = n.saturating_sub(head) >> byte_shift::<F>();
    if whole == 0 || in_byte::<F>(to_x) != in_byte::<F>(from_x) {
        return columns(0, n);
    }
    let after = head.wrapping_add(whole << byte_shift::<F>());
    if head > 0 {
        columns(0, head);
    }
    if after < n {
        columns(after, n.wrapping_sub(after));
    }
    let start = |row: usize, x: usize| row.wrapping_add(x.wrapping_add(head) >> byte_shift::<F>());
    let len = |stride: usize| rows.wrapping_sub(1).wrapping_mul(stride).wrapping_add(whole);
    let (start, from_start) = (start(to_row, to_x), start(from_row, from_x));
    let to = to.get_mut(start..start.wrapping_add(len(to_stride)));
    let from = from.get(from_start..from_start.wrapping_add(len(from_stride)));
    if let (Some(to), Some(from)) = (to, from) {
        word::copy_rows((to, to_stride), (from, from_stride), (whole, rows));
    }
}

/// Copies the pixels that differ from `key`.
#[inline(always)]
pub(super) fn copy_keyed<F: PixelFormat>(
    to: &mut [u8],
    to_place: (usize, usize),
    from: &[u8],
    from_place: (usize, usize),
    n: usize,
    key: u32,
) {
    let keys = word_of(repeat::<F>(key));
    copy_masked::<F>(to, to_place, from, from_place, n, |bits| filled::<F>(bits ^ keys));
}

/// All bits of the pixels that are not 0.
#[inline(always)]
fn filled<F: PixelFormat>(pixels: u32) -> u32 {
    // The lowest bit of each pixel becomes the OR of all.
    let pairs = if F::BITS >= 2 { pixels | pixels >> 1 } else { pixels };
    let any = if F::BITS >= 4 { pairs | pairs >> 2 } else { pairs };
    let lowest = word_of(repeat::<F>(1));
    (any & lowest).wrapping_mul(u32::from(mask::<F>()))
}

/// Copies the bits that `opaque` says of the pixels. Where their places in the bytes differ, every byte is put together
/// from two of the source.
#[inline(always)]
fn copy_masked<F: PixelFormat>(
    to: &mut [u8],
    (to_row, to_x): (usize, usize),
    from: &[u8],
    (from_row, from_x): (usize, usize),
    n: usize,
    opaque: impl Fn(u32) -> u32,
) {
    let last = to_x.wrapping_add(n).wrapping_sub(1);
    let bytes = to_row.wrapping_add(to_x >> byte_shift::<F>())..=to_row.wrapping_add(last >> byte_shift::<F>());
    let Some(run) = to.get_mut(bytes) else { return };
    // The pixel of the source for the first place of the first byte. It may lie up to a byte before the row: one byte is
    // added here and taken off below, and a byte that is not there reads as 0 and is masked out.
    let aligned = from_x.wrapping_add(8 / F::BITS as usize).wrapping_sub(to_x & last_in_byte::<F>());
    let at = from_row.wrapping_add(aligned >> byte_shift::<F>()).wrapping_sub(1);
    let skip = in_byte::<F>(aligned);
    let byte = |at: usize| from.get(at).copied().unwrap_or(0);
    let put = |place: &mut u8, current: u8, next: u8, mask: u8| {
        let (first, second) = (u32::from(current), u32::from(next));
        // With skip = 0 the second byte is shifted out.
        let new = low_u8(if F::LSB0 { (second << 8 | first) >> skip } else { (first << 8 | second) << skip >> 8 });
        *place = merge(*place, new, low_u8(opaque(new.into())) & mask);
    };
    let (head_mask, tail_mask) = (from_mask::<F>(to_x), to_mask::<F>(last));
    let (mut current, next) = (byte(at), byte(at.wrapping_add(1)));
    match run {
        [only] => put(only, current, next, head_mask & tail_mask),
        [head, middle @ .., tail] => {
            put(head, current, next, head_mask);
            current = next;
            // The pixels of whole bytes are all there, and so are their bytes and the one that follows.
            let (start, end) = (at.wrapping_add(2), at.wrapping_add(2).wrapping_add(middle.len()));
            let mut sources = from.get(start..end).unwrap_or_default();
            let mut groups = middle.chunks_exact_mut(GROUP);
            for group in &mut groups {
                let (Some(place), Some((word, after))) = (group.first_chunk_mut(), sources.split_first_chunk()) else {
                    break;
                };
                current = put_word::<F>(place, current, *word, skip, &opaque);
                sources = after;
            }
            for place in groups.into_remainder() {
                let Some((&next, after)) = sources.split_first() else { break };
                put(place, current, next, 0xff);
                (current, sources) = (next, after);
            }
            put(tail, current, byte(end), tail_mask);
        }
        [] => {}
    }
}

/// The same for four bytes at once, between the byte before and the last of `next`, which is returned.
#[inline(always)]
fn put_word<F: PixelFormat>(
    place: &mut [u8; 4],
    current: u8,
    next: [u8; 4],
    skip: u32,
    opaque: impl Fn(u32) -> u32,
) -> u8 {
    let load = |bytes| if F::LSB0 { u32::from_le_bytes(bytes) } else { u32::from_be_bytes(bytes) };
    let (first, second) = (u32::from(current), load(next));
    let (beyond, back) = (24_u32.wrapping_add(skip), 8_u32.wrapping_sub(skip));
    let new = if F::LSB0 {
        first.wrapping_shr(skip) | second.wrapping_shl(back)
    } else {
        first.wrapping_shl(beyond) | second.wrapping_shr(back)
    };
    let old = load(*place);
    let merged = old ^ ((old ^ new) & opaque(new));
    *place = if F::LSB0 { merged.to_le_bytes() } else { merged.to_be_bytes() };
    next[3]
}
