//! Wide rows and long runs: Cortex-M stores eight registers with one instruction, if there are eight registers.

use bytemuck::pod_align_to_mut;

use super::words::{fill_words, nine_names};
use crate::{
    pixel::rows::word::parts::{each_row, put_ends, turned},
    tune::{keep_rolled, ARMV7},
};

/// Rows of at least this many bytes are filled by multiple stores.
pub(super) const WIDE: usize = 4 * 40 + 8;

/// Wide rows, by multiple stores.
///
/// The order of the names makes the register numbers ascend, as the instruction needs them; it was read off the assembly.
/// Another order would cost speed, not pixels. Rows that are whole words apart are all aligned like the first.
#[inline(never)]
pub(super) fn fill_rows_wide(memory: &mut [u8], stride: usize, len: usize, word: u32) {
    let bytes = word.to_le_bytes();
    let w = turned(word, pod_align_to_mut::<u8, u32>(memory).0.len()).to_le();
    let v = nine_names(w);
    let group = [v[7], v[2], v[1], v[0], v[5], v[4], v[3], v[6]];
    each_row(memory, stride, len, |row| {
        put_ends(row, bytes);
        let (_, words, _) = pod_align_to_mut::<u8, u32>(row);
        for five in words.chunks_exact_mut(40) {
            five.chunks_exact_mut(8).for_each(|place| place.copy_from_slice(&group));
            keep_rolled(ARMV7);
        }
        if let Some(last) = words.last_chunk_mut::<40>() {
            last.chunks_exact_mut(8).for_each(|place| place.copy_from_slice(&group));
        }
    });
}

/// Runs of at least this many bytes are filled by [`fill_long`].
pub(super) const LONG: usize = 4 * 4 * 126;

/// One long run, such as a whole screen: nine registers at a time, fourteen times a round.
pub(super) fn fill_long(run: &mut [u8], word: u32) {
    put_ends(run, word.to_le_bytes());
    let (head, words, _) = pod_align_to_mut::<u8, u32>(run);
    let w = turned(word, head.len()).to_le();
    let rounds = words.len() - words.len() % 126;
    if let Some((long, rest)) = words.split_at_mut_checked(rounds) {
        fill_rounds(long, w);
        fill_words(rest, w);
    }
}

/// Whole rounds of 126 words. It is alone in its function so that every register is free.
#[inline(never)]
fn fill_rounds(words: &mut [u32], w: u32) {
    let v = nine_names(w);
    let group = [v[7], v[0], v[6], v[2], v[1], v[8], v[4], v[3], v[5]];
    for round in words.chunks_exact_mut(126) {
        round.chunks_exact_mut(9).for_each(|place| place.copy_from_slice(&group));
    }
}
