//! For images built for size: one short loop for each kind of work.

use bytemuck::{pod_align_to, pod_align_to_mut};

use super::parts::{copy_each, each_pair_of_rows, each_row, fill_every, put_ends, turned};
use crate::tune::UNALIGNED;

/// Fills one run with a pattern of 1, 2 or 4 bytes, given as the word that starts at its first byte; the length is a
/// multiple of the pattern's. The loop is that of all formats: aligned words, and at the ends either words that overlap with
/// them or bytes.
#[inline(never)]
pub(in crate::pixel::rows) fn fill_span(run: &mut [u8], word: u32) {
    /// Returns the word that starts at the byte after the last.
    #[inline(never)]
    fn fill_bytes(run: &mut [u8], mut word: u32) -> u32 {
        for place in run {
            [*place, _, _, _] = word.to_le_bytes();
            word = word.rotate_right(8);
        }
        word
    }
    if UNALIGNED && run.len() < 4 {
        fill_bytes(run, word);
        return;
    }
    if UNALIGNED {
        put_ends(run, word.to_le_bytes());
    }
    let (head, words, tail) = pod_align_to_mut::<u8, u32>(run);
    let word = if UNALIGNED { turned(word, head.len()) } else { fill_bytes(head, word) };
    let mut groups = words.chunks_exact_mut(4);
    for group in &mut groups {
        if let [a, b, c, d] = group {
            let w = word.to_le();
            (*a, *b, *c, *d) = (w, w, w, w);
        }
    }
    for place in groups.into_remainder() {
        *place = word.to_le();
    }
    if !UNALIGNED {
        fill_bytes(tail, word);
    }
}

/// The rows of a rectangle, with a pattern of 1, 2 or 4 bytes. Rows without a gap are one long run.
pub(in crate::pixel::rows) fn fill_rows(memory: &mut [u8], stride: usize, len: usize, word: u32) {
    let len = if len == stride { memory.len() } else { len };
    each_row(memory, stride, len, |row| fill_span(row, word));
}

/// A vertical run: the first pixel, and one every `pitch` pixels.
#[inline(always)]
pub(super) fn fill_column<P: Copy>(pixels: &mut [P], (pitch, _): (usize, usize), pixel: P) {
    fill_every(pixels, pitch, pixel);
}

/// Copies `rows` rows of `len` bytes, the first ones at the start of each memory and the others a stride after the last;
/// both memories end with the last row.
#[inline(never)]
pub(in crate::pixel::rows) fn copy_rows(to: (&mut [u8], usize), from: (&[u8], usize), size: (usize, usize)) {
    each_pair_of_rows(to, from, size, copy);
}

/// Copies bytes between runs of the same length: unit by unit, the widest that both runs allow.
///
/// `copy_from_slice` calls a `memcpy` that on small cores goes byte by byte when the alignments differ.
#[inline(always)]
fn copy(to: &mut [u8], from: &[u8]) {
    if UNALIGNED {
        let (_, words, rest) = pod_align_to_mut::<u8, [u8; 4]>(to);
        let (_, from, from_rest) = pod_align_to::<u8, [u8; 4]>(from);
        copy_each(words, from.iter().copied());
        return copy_each(rest, from_rest.iter().copied());
    }
    match (pod_align_to_mut::<u8, u16>(to), pod_align_to::<u8, u16>(from)) {
        (([], halves, rest), ([], from, from_rest)) => {
            copy_each(halves, from.iter().copied());
            copy_each(rest, from_rest.iter().copied());
        }
        _ => copy_each(to, from.iter().copied()),
    }
}
