//! Rows of pixels in memory: runs, lines, circles and pictures as bytes.
//!
//! `packed` knows bytes that hold several pixels, `word` pixels that take whole bytes; here one of the two is chosen. `walk`
//! writes lines and circles, `scan` looks for pixels along a row, `mask` paints pictures of one bit in two
//! colours, and `strip` the glyphs of text.
//!
//! A place is given by the first byte of its row and the number of its pixel there.

pub(crate) mod mask;
pub(crate) mod packed;
pub(crate) mod scan;
pub(crate) mod strip;
pub(crate) mod walk;
mod word;

use super::format::{byte, has_unused_bits, PixelFormat};
use crate::tune::{COMPACT, VECTORS};

/// Whether an area of one row is filled as a run.
const RUNS: bool = !COMPACT;

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
    if RUNS && rows == 1 {
        return fill::<F>(memory, first_row, x0, x1, bits);
    }
    if F::BITS < 8 {
        return packed::fill_rows::<F>(memory, stride, (first_row, rows), (x0, x1), bits);
    }
    let last_row = first_row.wrapping_add(rows.wrapping_sub(1).wrapping_mul(stride));
    let len = byte::<F>(0, x1).wrapping_sub(byte::<F>(0, x0));
    let Some(all) = memory.get_mut(byte::<F>(first_row, x0)..byte::<F>(last_row, x1)) else { return };
    word::fill_area::<F>(all, (stride, rows), len, bits);
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

/// Reads one pixel of row y, where rows are whole pixels apart; 0 beyond the memory.
#[inline(always)]
pub(crate) fn get_whole<F: PixelFormat>(memory: &[u8], stride: usize, (x, y): (usize, usize)) -> u32 {
    match F::BITS {
        16 => u32::from(u16::from_le_bytes(word::nth(memory, stride, (x, y)))),
        32 => u32::from_le_bytes(word::nth(memory, stride, (x, y))),
        _ => get::<F>(memory, y.wrapping_mul(stride), x),
    }
}

/// Copies `n` pixels, at least one, between memories: each place is the first byte of a row and a pixel of it.
#[inline(always)]
pub(crate) fn copy<F: PixelFormat>(
    to: &mut [u8],
    to_place: (usize, usize),
    from: &[u8],
    from_place: (usize, usize),
    n: usize,
) {
    copy_rows::<F>((to, 0), to_place, (from, 0), from_place, (n, 1));
}

/// The same for rows, at least one, that start a stride apart: each memory comes with its own.
#[inline(always)]
pub(crate) fn copy_rows<F: PixelFormat>(
    (to, to_stride): (&mut [u8], usize),
    (to_row, to_x): (usize, usize),
    (from, from_stride): (&[u8], usize),
    (from_row, from_x): (usize, usize),
    (n, rows): (usize, usize),
) {
    if F::BITS < 8 {
        let (to, from) = ((to, to_stride), (from, from_stride));
        if VECTORS {
            packed::copy_bytes::<F>(to, (to_row, to_x), from, (from_row, from_x), (n, rows));
        } else {
            packed::copy_rows::<F>(to, (to_row, to_x), from, (from_row, from_x), (n, rows));
        }
        return;
    }
    let below = rows.wrapping_sub(1);
    let (start, from_start) = (byte::<F>(to_row, to_x), byte::<F>(from_row, from_x));
    let len = byte::<F>(0, n);
    let end = start.wrapping_add(below.wrapping_mul(to_stride)).wrapping_add(len);
    let from_end = from_start.wrapping_add(below.wrapping_mul(from_stride)).wrapping_add(len);
    if let (Some(to), Some(from)) = (to.get_mut(start..end), from.get(from_start..from_end)) {
        word::copy_rows((to, to_stride), (from, from_stride), (len, rows));
    }
}

/// [`copy`], but leaves the pixels of the target where the source has the colour of the bits `key`.
#[inline(always)]
pub(crate) fn copy_keyed<F: PixelFormat>(
    to: &mut [u8],
    (to_row, to_x): (usize, usize),
    from: &[u8],
    (from_row, from_x): (usize, usize),
    n: usize,
    key: u32,
) {
    if F::BITS < 8 && !has_unused_bits::<F>() {
        return packed::copy_keyed::<F>(to, (to_row, to_x), from, (from_row, from_x), n, key);
    }
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

/// Writes the pixels `x0..x1`, which are not empty, from left to right: what `next` gives.
#[inline(always)]
pub(crate) fn write_all<F: PixelFormat>(
    memory: &mut [u8],
    row: usize,
    (x0, x1): (usize, usize),
    next: impl FnMut() -> u32,
) {
    if F::BITS < 8 {
        packed::write_all::<F>(memory, row, (x0, x1), next);
    } else if let Some(run) = memory.get_mut(byte::<F>(row, x0)..byte::<F>(row, x1)) {
        word::write_all::<F>(run, next);
    }
}

/// The same where pixels take whole bytes, in parts of `most` pixels and a last one of as many or fewer: what `next` makes of a run. When
/// a part is done, `go_on` takes the run to the next one, and is told how many pixels are left.
#[inline(always)]
pub(crate) fn write_parts<F: PixelFormat, R: Copy>(
    memory: &mut [u8],
    (row, (x0, x1)): (usize, (usize, usize)),
    most: usize,
    run: R,
    go_on: impl FnMut(&mut R, usize),
    next: impl FnMut(&mut R) -> u32,
) {
    if let Some(pixels) = memory.get_mut(byte::<F>(row, x0)..byte::<F>(row, x1)) {
        word::write_parts::<F, R>(pixels, most, run, go_on, next);
    }
}

/// Writes the pixels `x0..x1`, which are not empty, from left to right: what `next` gives, or nothing where that is `None`.
#[inline(always)]
pub(crate) fn write<F: PixelFormat>(
    memory: &mut [u8],
    row: usize,
    (x0, x1): (usize, usize),
    next: impl FnMut() -> Option<u32>,
) {
    if F::BITS < 8 {
        packed::write::<F>(memory, row, (x0, x1), next);
    } else if let Some(run) = memory.get_mut(byte::<F>(row, x0)..byte::<F>(row, x1)) {
        word::write::<F>(run, next);
    }
}

/// Writes few pixels in each of some rows, `stride` bytes apart: as many as `spans` says, and so far behind a pixel of the row. `start` is
/// asked for each row what `next` makes bits of. `false`, and nothing is written, if there is no fast way.
#[inline(always)]
pub(crate) fn write_rows<F: PixelFormat, R>(
    memory: &mut [u8],
    stride: usize,
    (row, x): (usize, usize),
    spans: &[[u8; 2]],
    start: impl FnMut(u8) -> R,
    next: impl FnMut(&mut R) -> u32,
) -> bool {
    F::BITS >= 8 && word::write_rows::<F, R>(memory, (stride, row, x), spans, start, next)
}

/// Replaces the pixels `x0..x1`, which are not empty, from left to right, each by what `edit` makes of it.
#[inline(always)]
pub(crate) fn edit<F: PixelFormat>(
    memory: &mut [u8],
    row: usize,
    (x0, x1): (usize, usize),
    edit: impl FnMut(u32) -> u32,
) {
    if F::BITS < 8 {
        packed::edit::<F>(memory, row, (x0, x1), edit);
    } else if let Some(run) = memory.get_mut(byte::<F>(row, x0)..byte::<F>(row, x1)) {
        word::edit::<F>(run, edit);
    }
}

/// Replaces the pixels `x0..x1`, which are not empty, from left to right, each by what `mix` makes of it and of its level. There are as
/// many levels, or more.
#[inline(always)]
pub(crate) fn mix<F: PixelFormat>(
    memory: &mut [u8],
    row: usize,
    (x0, x1): (usize, usize),
    levels: &[u8],
    mut mix: impl FnMut(u32, u8) -> u32,
) {
    if F::BITS < 8 {
        let mut levels = levels.iter();
        packed::edit::<F>(memory, row, (x0, x1), |old| levels.next().map_or(old, |&level| mix(old, level)));
    } else if let Some(run) = memory.get_mut(byte::<F>(row, x0)..byte::<F>(row, x1)) {
        word::mix::<F>(run, levels, mix);
    }
}

/// Fills the pixels `x0..x1`, which are not empty, but for those at both ends that have levels: they are mixed as by [`mix`].
#[inline(always)]
pub(crate) fn mix_ends<F: PixelFormat>(
    memory: &mut [u8],
    row: usize,
    (x0, x1): (usize, usize),
    (left, right): (&[u8], &[u8]),
    bits: u32,
    mut mix: impl FnMut(u32, u8) -> u32,
) {
    let (from, to) = (x0.wrapping_add(left.len()), x1.wrapping_sub(right.len()));
    if F::BITS >= 8 {
        // One place to look for, and to check: the parts are cut out of it.
        let Some(run) = memory.get_mut(byte::<F>(row, x0)..byte::<F>(row, x1)) else { return };
        let Some((ends, rest)) = run.split_at_mut_checked(byte::<F>(0, left.len())) else { return };
        word::mix::<F>(ends, left, &mut mix);
        let Some((middle, ends)) = rest.split_at_mut_checked(byte::<F>(0, to.wrapping_sub(from))) else { return };
        if !middle.is_empty() {
            word::fill::<F>(middle, bits);
        }
        return word::mix::<F>(ends, right, &mut mix);
    }
    if x0 < from {
        self::mix::<F>(memory, row, (x0, from), left, &mut mix);
    }
    if from < to {
        fill::<F>(memory, row, from, to, bits);
    }
    if to < x1 {
        self::mix::<F>(memory, row, (to, x1), right, &mut mix);
    }
}
