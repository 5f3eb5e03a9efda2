//! Aligned words of one value.

use core::mem::take;

use crate::tune::{hidden_zero, keep_rolled, of_no_origin, ARMV6, ARMV7, MULTIPLE, UNALIGNED};

/// Aligned words.
#[inline(always)]
pub(super) fn fill_words(words: &mut [u32], w: u32) {
    // Single assignments: `[w; 8]` becomes a loop at opt-level "s".
    #[inline(always)]
    fn eight(words: &mut [u32], w: u32) {
        if let [a, b, c, d, e, f, g, h] = words {
            (*a, *b, *c, *d, *e, *f, *g, *h) = (w, w, w, w, w, w, w, w);
        }
    }
    #[inline(always)]
    fn sixteen(words: &mut [u32], w: u32) {
        if let Some((front, back)) = words.split_at_mut_checked(8) {
            eight(front, w);
            eight(back, w);
        }
    }
    if UNALIGNED && words.len() >= 16 {
        // Sixteen double stores a round. The last sixteen words overlap what the rounds leave, and may leave sixteen themselves.
        if let Some(last) = words.last_chunk_mut::<16>() {
            sixteen(last, w);
        }
        let mut groups = of_no_origin(words).chunks_exact_mut(32);
        for group in &mut groups {
            if let Some((front, back)) = group.split_at_mut_checked(16) {
                sixteen(front, w);
                sixteen(back, w);
            }
            keep_rolled(ARMV7);
        }
        if let Some(first) = groups.into_remainder().first_chunk_mut::<16>() {
            sixteen(first, w);
        }
        return;
    }
    if UNALIGNED && words.len() >= 8 {
        // Twice eight, which overlap.
        if let Some(last) = words.last_chunk_mut::<8>() {
            eight(last, w);
        }
        if let Some(first) = words.first_chunk_mut::<8>() {
            eight(first, w);
        }
        return;
    }
    let mut rest = words;
    if MULTIPLE && rest.len() >= 32 {
        rest = fill_multiple(rest, w);
    }
    let mut groups = rest.chunks_exact_mut(8);
    for group in &mut groups {
        eight(group, w);
        keep_rolled(ARMV6);
    }
    let mut rest = groups.into_remainder();
    if rest.len() & 4 != 0 {
        if let Some((group, after)) = take(&mut rest).split_first_chunk_mut::<4>() {
            *group = [w, w, w, w];
            rest = after;
        }
    }
    if rest.len() & 2 != 0 {
        if let Some((group, after)) = take(&mut rest).split_first_chunk_mut::<2>() {
            *group = [w, w];
            rest = after;
        }
    }
    if let Some(last) = rest.first_mut() {
        *last = w;
    }
}

/// Four words a round by a multiple store, named in the order that makes the register numbers ascend; returns the rest.
#[inline(never)]
fn fill_multiple(words: &mut [u32], w: u32) -> &mut [u32] {
    let [a, b, c, d] = four_names(w);
    let mut rounds = words.chunks_exact_mut(4);
    for round in &mut rounds {
        round.copy_from_slice(&[a, b, d, c]);
    }
    rounds.into_remainder()
}

/// A word four times, under names that a compiler cannot tell to be equal: each is made in another way from the word and
/// a [hidden zero](hidden_zero). Of values that it knows to be equal it would keep one, in one register.
#[inline(always)]
fn four_names(w: u32) -> [u32; 4] {
    let z = hidden_zero();
    [w, w ^ z, w | z, w.wrapping_add(z)]
}
