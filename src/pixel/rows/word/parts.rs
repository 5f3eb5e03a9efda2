//! What both ways are made of: rows, the ends of a run, and loops of one store.

use core::mem::take;

use crate::tune::{keep_copying, keep_rolled, ARM};

/// Calls `f` with each row. Cutting the slice row by row costs 7 instructions a row on Cortex-M4, `chunks_mut` 11.
#[inline(always)]
pub(in crate::pixel::rows) fn each_row(mut memory: &mut [u8], stride: usize, len: usize, mut f: impl FnMut(&mut [u8])) {
    while let Some(row) = memory.get_mut(..len) {
        f(row);
        let Some(rest) = take(&mut memory).get_mut(stride..) else { return };
        memory = rest;
    }
}

/// Calls `f` with each row of two memories, `rows` rows of `len` bytes: the first ones at the start of each memory, and the
/// others a stride after the last.
#[inline(always)]
pub(super) fn each_pair_of_rows(
    (mut to, to_stride): (&mut [u8], usize),
    (mut from, from_stride): (&[u8], usize),
    (len, rows): (usize, usize),
    mut f: impl FnMut(&mut [u8], &[u8]),
) {
    // Counted: the stride of a single row may be 0.
    for _ in 0..rows {
        let (Some(row), Some(source)) = (to.get_mut(..len), from.get(..len)) else { return };
        f(row, source);
        let Some(next) = take(&mut to).get_mut(to_stride..) else { return };
        let Some(next_source) = from.get(from_stride..) else { return };
        (to, from) = (next, next_source);
    }
}

/// The word that starts `bytes` further on in the pattern. In memory it is `to_le` of it.
#[inline(always)]
#[expect(clippy::cast_possible_truncation, reason = "at most 3")]
pub(super) fn turned(word: u32, bytes: usize) -> u32 {
    word.rotate_right(bytes as u32 * 8)
}

/// Stores at the first and the last bytes of the run.
#[inline(always)]
pub(super) fn put_ends<const N: usize>(run: &mut [u8], bytes: [u8; N]) {
    if let Some(first) = run.first_chunk_mut() {
        *first = bytes;
    }
    if let Some(last) = run.last_chunk_mut() {
        *last = bytes;
    }
}

/// Writes the first pixel and every one that is a multiple of `pitch` behind it.
#[inline(always)]
pub(super) fn fill_every<P: Copy>(pixels: &mut [P], pitch: usize, pixel: P) {
    let mut at = 0;
    while let Some(place) = pixels.get_mut(at) {
        *place = pixel;
        at = at.wrapping_add(pitch);
        keep_rolled(ARM);
    }
}

#[inline(always)]
pub(super) fn copy_each<T>(to: &mut [T], from: impl Iterator<Item = T>) {
    for (place, value) in to.iter_mut().zip(from) {
        *place = value;
        keep_copying();
    }
}
