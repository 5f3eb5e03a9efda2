//! Wide rows and long runs: thirty-two stores a round.
//!
//! A store of one word takes one cycle on Cortex-M4. Two of them are cheaper than a double store, which takes three, and sixteen
//! cheaper than two multiple stores of eight, which take eighteen and two more for their addresses.

use bytemuck::{cast_slice_mut, pod_align_to_mut};

use super::words::fill_words;
use crate::{
    pixel::rows::word::parts::{each_row, put_ends, turned},
    tune::{keep_rolled, of_no_origin, ARMV7},
};

/// Rows of at least this many bytes are filled by [`fill_rows_wide`].
pub(super) const WIDE: usize = ROUND + 8;

/// Bytes of a round. The offsets of so many words fit into instructions of 16 bits.
const ROUND: usize = 4 * 32;

/// Wide rows. Rows that are whole words apart are all aligned like the first.
#[inline(never)]
pub(super) fn fill_rows_wide(memory: &mut [u8], stride: usize, len: usize, word: u32) {
    let bytes = word.to_le_bytes();
    let w = turned(word, pod_align_to_mut::<u8, u32>(memory).0.len()).to_le();
    each_row(memory, stride, len, |row| {
        put_ends(row, bytes);
        let (_, words, _) = pod_align_to_mut::<u8, u32>(row);
        let bytes = of_no_origin(cast_slice_mut::<u32, u8>(words));
        if let Some(last) = bytes.last_chunk_mut::<ROUND>() {
            each_alone(last, w);
        }
        for round in bytes.chunks_exact_mut(ROUND) {
            each_alone(round, w);
            keep_rolled(ARMV7);
        }
    });
}

/// Runs of at least this many bytes are filled by [`fill_long`].
pub(super) const LONG: usize = 16 * ROUND;

/// One long run, such as a whole screen.
pub(super) fn fill_long(run: &mut [u8], word: u32) {
    put_ends(run, word.to_le_bytes());
    let (head, words, _) = pod_align_to_mut::<u8, u32>(run);
    let w = turned(word, head.len()).to_le();
    let rounds = words.len() - words.len() % (ROUND / 4);
    if let Some((long, rest)) = words.split_at_mut_checked(rounds) {
        fill_rounds(long, w);
        fill_words(rest, w);
    }
}

/// Whole rounds. It is alone in its function so that every register is free.
#[inline(never)]
fn fill_rounds(words: &mut [u32], w: u32) {
    for round in of_no_origin(cast_slice_mut::<u32, u8>(words)).chunks_exact_mut(ROUND) {
        each_alone(round, w);
        keep_rolled(ARMV7);
    }
}

/// Words, each by a store of its own. As bytes, so that the compiler does not know that they are aligned: else it would make a
/// double store of each two.
#[inline(always)]
fn each_alone(words: &mut [u8], w: u32) {
    words.chunks_exact_mut(4).for_each(|place| place.copy_from_slice(&w.to_ne_bytes()));
}
