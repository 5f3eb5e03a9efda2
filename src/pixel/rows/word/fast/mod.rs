//! For speed: several ways, each without a loop or with a wide one.

mod column;
mod copy;
mod strips;
mod wide;
mod words;

use bytemuck::pod_align_to_mut;

pub(super) use self::column::fill_column;
pub(in crate::pixel::rows) use self::copy::copy_rows;
use self::{
    wide::{fill_long, fill_rows_wide, LONG, WIDE},
    words::fill_words,
};
use super::parts::{each_row, put_ends, turned};
use crate::{
    num::cast::low_u8,
    tune::{UNALIGNED, VECTORS},
};

/// Bytes of a run, and of each row of a rectangle, from which on `memset` pays.
const RUN: usize = 128;
const ROW: usize = 33;

/// Fills one run with a pattern of 1, 2 or 4 bytes, given as the word that starts at its first byte; the length is a
/// multiple of the pattern's.
///
/// Where words can be stored anywhere, up to 32 bytes are two halves that overlap: each store is at a fixed distance from
/// the start or from the end, so there is no loop. Longer runs overlap a word at each end with the aligned words between.
#[inline(always)]
pub(in crate::pixel::rows) fn fill_span(run: &mut [u8], word: u32) {
    if UNALIGNED && run.len() <= 32 || run.len() <= 16 {
        return fill_short(run, word);
    }
    if is_for_memset(run.len(), word, RUN) {
        return run.fill(low_u8(word));
    }
    if UNALIGNED {
        put_ends(run, word.to_le_bytes());
        let (head, middle, _) = pod_align_to_mut::<u8, u32>(run);
        fill_words(middle, turned(word, head.len()).to_le());
    } else {
        let (head, middle, tail) = pod_align_to_mut::<u8, u32>(run);
        let turned = turned(word, head.len());
        fill_end(head, word);
        fill_end(tail, turned);
        fill_words(middle, turned.to_le());
    }
}

/// Whether a run of so many bytes is filled by `memset`: on computers, where all bytes of the word are equal. It knows wider
/// vectors than those that every processor has. Shorter runs do not pay for the call.
#[inline(always)]
fn is_for_memset(len: usize, word: u32, least: usize) -> bool {
    VECTORS && len >= least && word == turned(word, 1)
}

/// 0 to 32 bytes.
#[inline(always)]
fn fill_short(run: &mut [u8], word: u32) {
    // As integers, not as arrays of bytes: those are taken apart and stored byte by byte.
    let pair = u64::from(word) << 32 | u64::from(word);
    if run.len() > 16 {
        put_ends(run, (u128::from(pair) << 64 | u128::from(pair)).to_le_bytes());
    } else if run.len() >= 8 {
        put_ends(run, pair.to_le_bytes());
    } else if run.len() >= 4 {
        put_ends(run, word.to_le_bytes());
    } else {
        fill_end(run, word);
    }
}

/// Up to three bytes.
#[inline(always)]
fn fill_end(run: &mut [u8], word: u32) {
    let [x, y, z, _] = word.to_le_bytes();
    match run {
        [a] => *a = x,
        [a, b] => (*a, *b) = (x, y),
        [a, b, c] => (*a, *b, *c) = (x, y, z),
        _ => {}
    }
}

/// The rows of a rectangle, with a pattern of 1, 2 or 4 bytes. Rows without a gap are one long run.
pub(in crate::pixel::rows) fn fill_rows(memory: &mut [u8], stride: usize, len: usize, word: u32) {
    if len == stride && is_for_memset(memory.len(), word, RUN) {
        memory.fill(low_u8(word));
    } else if is_for_memset(len, word, ROW) {
        each_row(memory, stride, len, |row| row.fill(low_u8(word)));
    } else if len == stride && UNALIGNED && memory.len() >= LONG {
        fill_long(memory, word);
    } else if len == stride {
        fill_span(memory, word);
    } else if UNALIGNED && len >= WIDE && stride.is_multiple_of(4) {
        fill_rows_wide(memory, stride, len, word);
    } else {
        each_row(memory, stride, len, |row| fill_span(row, word));
    }
}
