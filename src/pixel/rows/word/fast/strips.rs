//! Copies of many rows, strip by strip.

use bytemuck::{cast, cast_ref, pod_align_to_mut};

use crate::tune::keep_order;

/// Rows of at least this many bytes, eight aligned words, are copied by strips.
pub(super) const STRIPS: usize = 4 * 8 + 3;

/// Strip by strip of sixteen or eight words, each from the top to the bottom: nothing has to be found out for each row, as
/// rows that are whole words apart are all aligned like the first. Pairs of aligned words are stored by one instruction,
/// words are loaded from anywhere. The ends of the rows overlap with the strips, and the last strip with the one before.
pub(super) fn copy_strips(
    (to, to_stride): (&mut [u8], usize),
    (from, from_stride): (&[u8], usize),
    (len, rows): (usize, usize),
) {
    let last = len.wrapping_sub(4);
    strip((to, to_stride), (from, from_stride), rows, copy_word);
    if let (Some(to), Some(from)) = (to.get_mut(last..), from.get(last..)) {
        strip((to, to_stride), (from, from_stride), rows, copy_word);
    }
    let (head, to, _) = pod_align_to_mut::<u8, u32>(to);
    let Some(from) = from.get(head.len()..) else { return };
    let words = len.wrapping_sub(head.len()) / 4;
    let width = if words < 16 { 8 } else { 16 };
    let mut left = 0;
    while left < words {
        let at = left.min(words.wrapping_sub(width));
        let (Some(to), Some(from)) = (to.get_mut(at..), from.get(at.wrapping_mul(4)..)) else { return };
        if width == 16 {
            strip((to, to_stride / 4), (from, from_stride), rows, copy_words::<16>);
        } else {
            strip((to, to_stride / 4), (from, from_stride), rows, copy_words::<8>);
        }
        left = left.wrapping_add(width);
    }
}

/// Calls `copy` with each row, from its start on.
#[inline(never)]
fn strip<T>(
    (to, stride): (&mut [T], usize),
    (from, from_stride): (&[u8], usize),
    rows: usize,
    copy: impl Fn(&mut [T], &[u8]),
) {
    let below = rows.wrapping_sub(1);
    let body = to.split_at_mut_checked(below.wrapping_mul(stride));
    let from_body = from.split_at_checked(below.wrapping_mul(from_stride));
    let (Some((body, last)), Some((from_body, from_last))) = (body, from_body) else { return };
    if stride >= 16 && from_stride >= 64 {
        for (to, from) in body.chunks_exact_mut(stride).zip(from_body.chunks_exact(from_stride)) {
            copy(to, from);
        }
    }
    copy(last, from_last);
}

#[inline(always)]
fn copy_word(to: &mut [u8], from: &[u8]) {
    if let (Some(to), Some(from)) = (to.first_chunk_mut::<4>(), from.first_chunk()) {
        *to = *from;
    }
}

/// The first `N` words, a multiple of four.
#[inline(always)]
fn copy_words<const N: usize>(to: &mut [u32], from: &[u8]) {
    let (Some(to), Some(from)) = (to.first_chunk_mut::<N>(), from.get(..4 * N)) else { return };
    let mut sources = from.chunks_exact(16);
    for to in to.chunks_exact_mut(4) {
        let from = sources.next().and_then(<[u8]>::first_chunk).map(cast_ref::<[u8; 16], [[u8; 4]; 4]>);
        if let ([a, b, c, d], Some([p, q, r, s])) = (to, from) {
            let (p, q, r, s) = (cast(*p), cast(*q), cast(*r), cast(*s));
            (*a, *b, *c, *d) = (p, q, r, s);
            // Stores that follow each other, with no loads between them, become double ones.
            keep_order();
        }
    }
}
