//! 8, 16, 24 and 32 bits per pixel: whole bytes, the least significant one first.
//!
//! A run of one colour is a pattern of 1, 2, 3 or 4 bytes. All but the third repeat in a 32-bit word, so a run is filled by
//! words: a head and a tail, and aligned words between. How the words are written is shaped by what compilers make of it
//! on small cores: see [`fill_span`] and [`fill_rows_wide`].

use core::{hint::black_box, mem::take};

use bytemuck::{cast, cast_mut, cast_ref, pod_align_to, pod_align_to_mut, Pod};

use crate::{
    num::cast::{low_u16, low_u8},
    pixel::format::{bytes_per_pixel, PixelFormat},
    tune::{keep_rolled, of_no_origin, COMPACT, MULTIPLE, UNALIGNED, VECTORS},
};

/// A word full of pixels, for the formats that repeat in one.
#[inline(always)]
fn word<F: PixelFormat>(bits: u32) -> u32 {
    match F::BITS {
        8 => u32::from(low_u8(bits)).wrapping_mul(0x0101_0101),
        16 => u32::from(low_u16(bits)).wrapping_mul(0x1_0001),
        _ => bits,
    }
}

/// Fills a run of whole pixels.
#[inline(always)]
pub(super) fn fill<F: PixelFormat>(run: &mut [u8], bits: u32) {
    if F::BITS == 24 {
        fill_span24(run, bits);
    } else {
        fill_span(run, word::<F>(bits));
    }
}

/// Fills `rows` rows of `len` bytes, the first at the start of `memory` and each `stride` bytes after the last; `memory`
/// ends with the last.
#[inline(always)]
pub(super) fn fill_area<F: PixelFormat>(memory: &mut [u8], (stride, rows): (usize, usize), len: usize, bits: u32) {
    if F::BITS == 24 && len == stride {
        fill_span24(memory, bits);
    } else if F::BITS == 24 {
        each_row(memory, stride, len, |row| fill_span24(row, bits));
    } else if len == bytes_per_pixel::<F>() && len < stride && stride.is_multiple_of(len) {
        fill_column::<F>(memory, (stride, rows), bits);
    } else {
        fill_rows(memory, stride, len, word::<F>(bits));
    }
}

/// Calls `f` with each row. Cutting the slice row by row costs 7 instructions a row on Cortex-M4, `chunks_mut` 11.
#[inline(always)]
pub(super) fn each_row(mut memory: &mut [u8], stride: usize, len: usize, mut f: impl FnMut(&mut [u8])) {
    while let Some(row) = memory.get_mut(..len) {
        f(row);
        let Some(rest) = take(&mut memory).get_mut(stride..) else { return };
        memory = rest;
    }
}

/// Fills one run with a pattern of 1, 2 or 4 bytes, given as the word that starts at its first byte; the length is a
/// multiple of the pattern's.
#[inline(always)]
pub(super) fn fill_span(run: &mut [u8], word: u32) {
    if COMPACT {
        fill_compact(run, word);
    } else {
        fill_fast(run, word);
    }
}

/// One short loop for all formats: aligned words, and at the ends either words that overlap with them or bytes.
#[inline(never)]
fn fill_compact(run: &mut [u8], word: u32) {
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

/// In several ways, each without a loop or with a wide one.
///
/// Where words can be stored anywhere, up to 32 bytes are two halves that overlap: each store is at a fixed distance from
/// the start or from the end, so there is no loop. Longer runs overlap a word at each end with the aligned words between.
#[inline(always)]
fn fill_fast(run: &mut [u8], word: u32) {
    if UNALIGNED && run.len() <= 32 || run.len() <= 16 {
        return fill_short(run, word);
    }
    if UNALIGNED {
        let bytes = word.to_le_bytes();
        if let Some(first) = run.first_chunk_mut() {
            *first = bytes;
        }
        if let Some(last) = run.last_chunk_mut() {
            *last = bytes;
        }
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

/// The word that starts `bytes` further on in the pattern. In memory it is `to_le` of it.
#[inline(always)]
#[expect(clippy::cast_possible_truncation, reason = "at most 3")]
fn turned(word: u32, bytes: usize) -> u32 {
    word.rotate_right(bytes as u32 * 8)
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

/// Stores at the first and the last bytes of the run.
#[inline(always)]
fn put_ends<const N: usize>(run: &mut [u8], bytes: [u8; N]) {
    if let Some(first) = run.first_chunk_mut() {
        *first = bytes;
    }
    if let Some(last) = run.last_chunk_mut() {
        *last = bytes;
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

/// Aligned words.
#[inline(always)]
fn fill_words(words: &mut [u32], w: u32) {
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
            keep_rolled();
        }
        if let Some(first) = groups.into_remainder().first_chunk_mut::<16>() {
            sixteen(first, w);
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
        keep_rolled();
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
    let [a, b, c, d, ..] = nine_names(w);
    let mut rounds = words.chunks_exact_mut(4);
    for round in &mut rounds {
        round.copy_from_slice(&[a, b, d, c]);
        keep_rolled();
    }
    rounds.into_remainder()
}

/// A word nine times, under names that a compiler cannot tell to be equal: each is made in another way from the word and
/// a zero whose value is hidden. Of values that it knows to be equal it would keep one, in one register.
#[inline(always)]
fn nine_names(w: u32) -> [u32; 9] {
    let z = black_box(0_u32);
    [
        w,
        w ^ z,
        w | z,
        w.wrapping_add(z),
        w.wrapping_sub(z),
        w & !z,
        w.wrapping_shl(z),
        w.wrapping_shr(z),
        w.rotate_right(z),
    ]
}

/// Rows of at least this many bytes are filled by multiple stores.
const WIDE: usize = 4 * 40 + 8;

/// The rows of a rectangle, with a pattern of 1, 2 or 4 bytes. Rows without a gap are one long run.
pub(super) fn fill_rows(memory: &mut [u8], stride: usize, len: usize, word: u32) {
    if COMPACT {
        let len = if len == stride { memory.len() } else { len };
        each_row(memory, stride, len, |row| fill_compact(row, word));
    } else if len == stride && UNALIGNED && memory.len() >= LONG {
        fill_long(memory, word);
    } else if len == stride {
        fill_fast(memory, word);
    } else if UNALIGNED && len >= WIDE && stride.is_multiple_of(4) {
        fill_rows_wide(memory, stride, len, word);
    } else {
        each_row(memory, stride, len, |row| fill_fast(row, word));
    }
}

/// Wide rows, by multiple stores: Cortex-M stores eight registers with one instruction, if there are eight registers.
///
/// The order of the names makes the register numbers ascend, as the instruction needs them; it was read off the assembly.
/// Another order would cost speed, not pixels. Rows that are whole words apart are all aligned like the first.
#[inline(never)]
fn fill_rows_wide(memory: &mut [u8], stride: usize, len: usize, word: u32) {
    let bytes = word.to_le_bytes();
    let w = turned(word, pod_align_to_mut::<u8, u32>(memory).0.len()).to_le();
    let v = nine_names(w);
    let group = [v[7], v[2], v[1], v[0], v[5], v[4], v[3], v[6]];
    each_row(memory, stride, len, |row| {
        put_ends(row, bytes);
        let (_, words, _) = pod_align_to_mut::<u8, u32>(row);
        for five in words.chunks_exact_mut(40) {
            five.chunks_exact_mut(8).for_each(|place| place.copy_from_slice(&group));
            keep_rolled();
        }
        if let Some(last) = words.last_chunk_mut::<40>() {
            last.chunks_exact_mut(8).for_each(|place| place.copy_from_slice(&group));
        }
    });
}

/// Runs of at least this many bytes are filled by [`fill_long`].
const LONG: usize = 4 * 4 * 126;

/// One long run, such as a whole screen: nine registers at a time, fourteen times a round.
fn fill_long(run: &mut [u8], word: u32) {
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
        keep_rolled();
    }
}

/// A run of 3-byte pixels: four of them make three words.
#[inline(never)]
fn fill_span24(run: &mut [u8], bits: u32) {
    let [r, g, b, _] = bits.to_le_bytes();
    let ring = [[r, g, b, r], [g, b, r, g], [b, r, g, b]].map(u32::from_ne_bytes);
    let (head, words, tail) = pod_align_to_mut::<u8, u32>(run);
    // The word that starts at byte k of the run is ring[k % 3].
    let [x, y, z] = match head.len() {
        1 => [ring[1], ring[2], ring[0]],
        2 => [ring[2], ring[0], ring[1]],
        _ => ring,
    };
    put_first(head, [r, g, b, r]);
    let after = match words.len() % 3 {
        0 => x,
        1 => y,
        _ => z,
    };
    let mut groups = words.chunks_exact_mut(12);
    for group in &mut groups {
        if let Some(group) = group.first_chunk_mut() {
            *group = [x, y, z, x, y, z, x, y, z, x, y, z];
        }
        keep_rolled();
    }
    for group in groups.into_remainder().chunks_mut(3) {
        put_first(group, [x, y, z]);
    }
    put_first(tail, after.to_ne_bytes());
}

/// As many of the values as there are places.
#[inline(always)]
fn put_first<T: Copy, const N: usize>(places: &mut [T], values: [T; N]) {
    for (place, value) in places.iter_mut().zip(values) {
        *place = value;
        keep_rolled();
    }
}

/// A vertical run: the first pixel of the memory, and one every `stride` bytes, a multiple of the pixel's.
#[inline(always)]
fn fill_column<F: PixelFormat>(memory: &mut [u8], (stride, rows): (usize, usize), bits: u32) {
    match F::BITS {
        8 => column(memory, (stride, rows), [low_u8(bits)]),
        16 => column(memory, (stride, rows), low_u16(bits).to_le_bytes()),
        _ => column(memory, (stride, rows), bits.to_le_bytes()),
    }
}

/// Four quarters at a time: as long as each other, they share the index and its one comparison.
fn column<const N: usize>(memory: &mut [u8], (stride, rows): (usize, usize), pixel: [u8; N])
where
    [u8; N]: Pod,
{
    let (_, pixels, _) = pod_align_to_mut::<u8, [u8; N]>(memory);
    let pitch = stride / N;
    let mut rest = pixels;
    if !COMPACT {
        // Of the rows before the last, which ends with its pixel.
        let quarter = (rows.wrapping_sub(1) >> 2).wrapping_mul(pitch);
        let Some((a, after)) = take(&mut rest).split_at_mut_checked(quarter) else { return };
        let Some((b, after)) = after.split_at_mut_checked(quarter) else { return };
        let Some((c, after)) = after.split_at_mut_checked(quarter) else { return };
        let Some((d, after)) = after.split_at_mut_checked(quarter) else { return };
        let mut at = 0;
        while let (Some(a), Some(b), Some(c), Some(d)) = (a.get_mut(at), b.get_mut(at), c.get_mut(at), d.get_mut(at)) {
            (*a, *b, *c, *d) = (pixel, pixel, pixel, pixel);
            at = at.wrapping_add(pitch);
            keep_rolled();
        }
        rest = after;
    }
    let mut at = 0;
    while let Some(place) = rest.get_mut(at) {
        *place = pixel;
        at = at.wrapping_add(pitch);
        keep_rolled();
    }
}

/// Writes the pixel at byte `at`.
#[inline(always)]
pub(super) fn set<F: PixelFormat>(memory: &mut [u8], at: usize, bits: u32) {
    fn put<const N: usize>(memory: &mut [u8], at: usize, pixel: [u8; N]) {
        if let Some(place) = memory.get_mut(at..at.wrapping_add(N)).and_then(<[u8]>::first_chunk_mut) {
            *place = pixel;
        }
    }
    match F::BITS {
        8 => put(memory, at, [low_u8(bits)]),
        16 => put(memory, at, low_u16(bits).to_le_bytes()),
        24 => put(memory, at, three(bits)),
        _ => put(memory, at, bits.to_le_bytes()),
    }
}

/// The low three bytes, the least significant one first.
#[inline(always)]
pub(super) const fn three(bits: u32) -> [u8; 3] {
    let [a, b, c, _] = bits.to_le_bytes();
    [a, b, c]
}

/// Reads the pixel at byte `at`.
#[inline(always)]
pub(super) fn get<F: PixelFormat>(memory: &[u8], at: usize) -> u32 {
    fn pixel<const N: usize>(memory: &[u8], at: usize) -> [u8; N] {
        let place = memory.get(at..at.wrapping_add(N)).and_then(<[u8]>::first_chunk);
        place.copied().unwrap_or([0; N])
    }
    match F::BITS {
        8 => u32::from(pixel::<1>(memory, at)[0]),
        16 => u32::from(u16::from_le_bytes(pixel(memory, at))),
        24 => {
            let [a, b, c] = pixel(memory, at);
            u32::from_le_bytes([a, b, c, 0])
        }
        _ => u32::from_le_bytes(pixel(memory, at)),
    }
}

/// Copies the pixels of a run that differ from `key`.
#[inline(always)]
pub(super) fn copy_keyed<F: PixelFormat>(to: &mut [u8], from: &[u8], key: u32) {
    /// Whole pixels as numbers, one comparison for all of a pixel.
    #[inline(always)]
    fn copy<const N: usize, T: Copy + PartialEq>(
        (to, from): (&mut [u8], &[u8]),
        key: T,
        (number, bytes): (impl Fn([u8; N]) -> T, impl Fn(T) -> [u8; N]),
    ) where
        [u8; N]: Pod,
    {
        let (_, to, _) = pod_align_to_mut::<u8, [u8; N]>(to);
        let (_, from, _) = pod_align_to::<u8, [u8; N]>(from);
        for (place, pixel) in to.iter_mut().zip(from) {
            let new = number(*pixel);
            if VECTORS {
                *place = bytes(if new == key { number(*place) } else { new });
            } else if new != key {
                *place = *pixel;
            }
        }
    }
    let runs = (to, from);
    match F::BITS {
        8 => copy(runs, low_u8(key), (u8::from_le_bytes, u8::to_le_bytes)),
        16 => copy(runs, low_u16(key), (u16::from_le_bytes, u16::to_le_bytes)),
        24 => copy(runs, three(key), (|pixel| pixel, |pixel| pixel)),
        _ => copy(runs, key, (u32::from_le_bytes, u32::to_le_bytes)),
    }
}

/// Copies `rows` rows of `len` bytes, the first ones at the start of each memory and the others a stride after the last;
/// both memories end with the last row.
#[inline(never)]
pub(super) fn copy_rows(
    (mut to, to_stride): (&mut [u8], usize),
    (mut from, from_stride): (&[u8], usize),
    (len, rows): (usize, usize),
) {
    if !COMPACT && UNALIGNED && len >= STRIPS && to_stride >= 64 && from_stride >= 64 && to_stride.is_multiple_of(4) {
        return copy_strips((to, to_stride), (from, from_stride), (len, rows));
    }
    // Counted: the stride of a single row may be 0.
    for _ in 0..rows {
        let (Some(row), Some(source)) = (to.get_mut(..len), from.get(..len)) else { return };
        copy(row, source);
        let Some(next) = take(&mut to).get_mut(to_stride..) else { return };
        let Some(next_source) = from.get(from_stride..) else { return };
        (to, from) = (next, next_source);
    }
}

/// Rows of at least this many bytes, eight aligned words, are copied by strips.
const STRIPS: usize = 4 * 8 + 3;

/// Strip by strip of sixteen or eight words, each from the top to the bottom: nothing has to be found out for each row, as
/// rows that are whole words apart are all aligned like the first. Pairs of aligned words are stored by one instruction,
/// words are loaded from anywhere. The ends of the rows overlap with the strips, and the last strip with the one before.
fn copy_strips((to, to_stride): (&mut [u8], usize), (from, from_stride): (&[u8], usize), (len, rows): (usize, usize)) {
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

#[inline(always)]
fn copy_word(to: &mut [u8], from: &[u8]) {
    if let (Some(to), Some(from)) = (to.first_chunk_mut::<4>(), from.first_chunk()) {
        *to = *from;
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
            keep_rolled();
        }
    }
    copy(last, from_last);
}

/// Copies bytes between runs of the same length.
///
/// `copy_from_slice` calls a `memcpy` that on small cores goes byte by byte when the alignments differ.
#[inline(always)]
fn copy(to: &mut [u8], from: &[u8]) {
    if COMPACT {
        copy_compact(to, from);
    } else if UNALIGNED {
        copy_unaligned(to, from);
    } else {
        copy_aligned(to, from);
    }
}

/// Unit by unit, the widest that both runs allow.
#[inline(always)]
fn copy_compact(to: &mut [u8], from: &[u8]) {
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
                // Keeps the loads of the second half from crowding the registers.
                keep_rolled();
                if let (Some(to), Some(from)) = (to.last_chunk_mut(), from.last_chunk()) {
                    put16(to, from);
                }
                keep_rolled();
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

/// The first `N` words, a multiple of four.
#[inline(always)]
fn copy_words<const N: usize>(to: &mut [u32], from: &[u8]) {
    let (Some(to), Some(from)) = (to.first_chunk_mut::<N>(), from.get(..4 * N)) else { return };
    let mut sources = from.chunks_exact(16);
    for to in to.chunks_exact_mut(4) {
        let from = sources.next().and_then(<[u8]>::first_chunk).map(cast_ref::<[u8; 16], [[u8; 4]; 4]>);
        if let ([a, b, c, d], Some([p, q, r, s])) = (to, from) {
            let (p, q, r, s) = (cast(*p), cast(*q), cast(*r), cast(*s));
            // Stores that follow each other become double ones.
            keep_rolled();
            (*a, *b, *c, *d) = (p, q, r, s);
            keep_rolled();
        }
    }
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
            keep_rolled();
        }
        copy_each(groups.into_remainder(), from_groups.remainder().iter().copied());
    } else if let ([], from, []) = pod_align_to::<u8, [u16; 2]>(from_words) {
        copy_each(words, from.iter().map(|&pair| cast(pair)));
    } else {
        copy_each(words, from_words.chunks_exact(4).map(|b| b.first_chunk().copied().map_or(0, u32::from_ne_bytes)));
    }
}

#[inline(always)]
fn copy_each<T>(to: &mut [T], from: impl Iterator<Item = T>) {
    for (place, value) in to.iter_mut().zip(from) {
        *place = value;
        keep_rolled();
    }
}

/// Writes a run from left to right: what `next` gives, or nothing where that is `None`. One store a pixel.
#[inline(always)]
pub(super) fn write<F: PixelFormat>(run: &mut [u8], mut next: impl FnMut() -> Option<u32>) {
    match F::BITS {
        8 => each(run, |place| put(place, next().map(|bits| [low_u8(bits)]))),
        16 => each(run, |place| put(place, next().map(|bits| low_u16(bits).to_le_bytes()))),
        24 => each(run, |place| put(place, next().map(three))),
        _ => each(run, |place| put(place, next().map(u32::to_le_bytes))),
    }
}

/// Replaces each pixel of a run by what `edit` makes of it.
#[inline(always)]
pub(super) fn edit<F: PixelFormat>(run: &mut [u8], mut edit: impl FnMut(u32) -> u32) {
    match F::BITS {
        8 => each(run, |[a]: &mut [u8; 1]| *a = low_u8(edit(u32::from(*a)))),
        16 => each(run, |place| *place = low_u16(edit(u16::from_le_bytes(*place).into())).to_le_bytes()),
        24 => each(run, |place: &mut [u8; 3]| {
            let [a, b, c] = *place;
            *place = three(edit(u32::from_le_bytes([a, b, c, 0])));
        }),
        _ => each(run, |place| *place = edit(u32::from_le_bytes(*place)).to_le_bytes()),
    }
}

/// Calls `f` with each pixel of a run.
#[inline(always)]
fn each<const N: usize>(run: &mut [u8], f: impl FnMut(&mut [u8; N]))
where
    [u8; N]: Pod,
{
    let (_, pixels, _) = pod_align_to_mut::<u8, [u8; N]>(run);
    pixels.iter_mut().for_each(f);
}

#[inline(always)]
fn put<const N: usize>(place: &mut [u8; N], pixel: Option<[u8; N]>) {
    if let Some(pixel) = pixel {
        *place = pixel;
    }
}
