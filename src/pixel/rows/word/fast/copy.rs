//! Copies of runs and of rows.

use bytemuck::{cast, cast_mut, cast_ref, pod_align_to, pod_align_to_mut};

use super::strips::{copy_strips, STRIPS};
use crate::{
    pixel::rows::word::parts::{copy_each, each_pair_of_rows},
    tune::{UNALIGNED, VECTORS},
};

/// Computers copy rows of at least this many bytes by `memcpy`: shorter ones do not pay for the call.
const CALL: usize = 32;

/// Copies `rows` rows of `len` bytes, the first ones at the start of each memory and the others a stride after the last;
/// both memories end with the last row.
#[inline(never)]
pub(in crate::pixel::rows) fn copy_rows(to: (&mut [u8], usize), from: (&[u8], usize), (len, rows): (usize, usize)) {
    if VECTORS && len >= CALL {
        // Rows without gaps are one long run.
        let run = len == to.1 && len == from.1;
        let (len, rows) = if run { (len.wrapping_mul(rows), 1) } else { (len, rows) };
        each_pair_of_rows(to, from, (len, rows), |to, from| to.copy_from_slice(from));
    } else if UNALIGNED && len >= STRIPS && to.1 >= 64 && from.1 >= 64 && to.1.is_multiple_of(4) {
        copy_strips(to, from, (len, rows));
    } else if UNALIGNED {
        each_pair_of_rows(to, from, (len, rows), copy_unaligned);
    } else {
        each_pair_of_rows(to, from, (len, rows), copy_aligned);
    }
}

/// Copies bytes between runs of the same length.
///
/// `copy_from_slice` calls a `memcpy` that on small cores goes byte by byte when the alignments differ.
#[inline(always)]
fn copy_unaligned(to: &mut [u8], from: &[u8]) {
    match to.len() {
        16.. => {
            let mut sources = from.chunks_exact(32);
            for to in to.chunks_exact_mut(32) {
                let Some(from) = sources.next() else { break };
                if let (Some(to), Some(from)) = (to.first_chunk_mut(), from.first_chunk()) {
                    put16(to, from);
                }
                if let (Some(to), Some(from)) = (to.last_chunk_mut(), from.last_chunk()) {
                    put16(to, from);
                }
            }
            match (to.last_chunk_mut::<32>(), from.last_chunk::<32>()) {
                (Some(to), Some(from)) => copy_ends(to, from, put16),
                _ => copy_ends(to, from, put16),
            }
        }
        8.. => copy_ends(to, from, put8),
        4.. => copy_ends::<4>(to, from, |to, from| *to = *from),
        2.. => copy_ends::<2>(to, from, |to, from| *to = *from),
        _ => copy_ends::<1>(to, from, |to, from| *to = *from),
    }
}

/// Copies the first and the last `N` bytes; they may overlap, so there is no loop and no branch per bit of the length.
#[inline(always)]
fn copy_ends<const N: usize>(to: &mut [u8], from: &[u8], put: impl Fn(&mut [u8; N], &[u8; N])) {
    if let (Some(to), Some(from)) = (to.first_chunk_mut(), from.first_chunk()) {
        put(to, from);
    }
    if let (Some(to), Some(from)) = (to.last_chunk_mut(), from.last_chunk()) {
        put(to, from);
    }
}

/// Word by word on purpose: `*to = *from` is a call of `memcpy` at "s", and from 32 bytes on at 3.
#[inline(always)]
fn put16(to: &mut [u8; 16], from: &[u8; 16]) {
    let [a, b, c, d]: &mut [[u8; 4]; 4] = cast_mut(to);
    let [p, q, r, s]: &[[u8; 4]; 4] = cast_ref(from);
    (*a, *b, *c, *d) = (*p, *q, *r, *s);
}

#[inline(always)]
fn put8(to: &mut [u8; 8], from: &[u8; 8]) {
    let [a, b]: &mut [[u8; 4]; 2] = cast_mut(to);
    let [p, q]: &[[u8; 4]; 2] = cast_ref(from);
    (*a, *b) = (*p, *q);
}

/// Aligned stores, and the widest loads that the source allows.
#[inline(never)]
fn copy_aligned(to: &mut [u8], from: &[u8]) {
    let (head, words, tail) = pod_align_to_mut::<u8, u32>(to);
    let Some((from_head, from)) = from.split_at_checked(head.len()) else { return };
    let Some((from_words, from_tail)) = from.split_at_checked(words.len().wrapping_mul(4)) else { return };
    copy_each(head, from_head.iter().copied());
    copy_each(tail, from_tail.iter().copied());
    if let ([], from, []) = pod_align_to::<u8, u32>(from_words) {
        let (mut groups, mut from_groups) = (words.chunks_exact_mut(4), from.chunks_exact(4));
        for (to, from) in (&mut groups).zip(&mut from_groups) {
            if let ([a, b, c, d], [p, q, r, s]) = (to, from) {
                (*a, *b, *c, *d) = (*p, *q, *r, *s);
            }
        }
        copy_each(groups.into_remainder(), from_groups.remainder().iter().copied());
    } else if let ([], from, []) = pod_align_to::<u8, [u16; 2]>(from_words) {
        copy_each(words, from.iter().map(|&pair| cast(pair)));
    } else {
        copy_each(words, from_words.chunks_exact(4).map(|b| b.first_chunk().copied().map_or(0, u32::from_ne_bytes)));
    }
}
