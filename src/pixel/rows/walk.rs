//! Lines in memory: Bresenham's steps as additions to an index.
//!
//! Where a pixel takes whole bytes and the rows are whole pixels apart, memory is a row of pixels, and a line that goes
//! down goes up in it. Cut off after the last pixel, the end of the slice is the end of the line: the one comparison
//! that guards the memory is the loop's condition too, and nothing is counted. (Only flat lines to the left run back
//! within each row; but all rows before the last lie before the last pixel, so they are walked the same way, and the
//! last row is a run.) Everywhere else, and in images built for size, the pixels are counted.

use core::num::NonZeroU32;

use bytemuck::{pod_align_to_mut, Pod};

use super::{packed, word};
use crate::{
    num::{
        cast::{low_u16, low_u8, offset},
        round::fraction,
    },
    pixel::format::{bytes_per_pixel, PixelFormat},
    span::{Octants, Steps},
    tune::{keep_branch, COMPACT, DIVIDES},
};

/// Built for size, the pixels of every line are counted: one loop for all formats.
const COUNTED: bool = COMPACT;

/// Writes `bits` along `steps`, from a row and a pixel of it, in rows `stride` bytes apart.
#[inline(always)]
pub(crate) fn draw<F: PixelFormat>(memory: &mut [u8], stride: usize, start: (usize, usize), steps: Steps, bits: u32) {
    match F::BITS {
        ..8 => {
            // Pixels are counted through the whole memory: rows start on a byte.
            let pitch = stride.wrapping_mul((8 / F::BITS) as usize);
            count(steps, start, 1, pitch, |at| packed::set::<F>(memory, 0, at, bits));
        }
        _ if COUNTED => count(steps, start, bytes_per_pixel::<F>(), stride, |at| word::set::<F>(memory, at, bits)),
        8 => draw_pixels::<1>(memory, stride, start, steps, [low_u8(bits)]),
        16 => draw_pixels::<2>(memory, stride, start, steps, low_u16(bits).to_le_bytes()),
        24 => draw_pixels::<3>(memory, stride, start, steps, word::three(bits)),
        _ => draw_pixels::<4>(memory, stride, start, steps, bits.to_le_bytes()),
    }
}

/// Writes `bits` along the outline of a circle, whose box starts at a row and a pixel of it.
#[inline(always)]
pub(crate) fn draw_octants<F: PixelFormat>(
    memory: &mut [u8],
    stride: usize,
    start: (usize, usize),
    octants: Octants,
    bits: u32,
) {
    if F::BITS < 8 {
        let pitch = stride.wrapping_mul((8 / F::BITS) as usize);
        return mirror(memory, octants, start, (1, pitch), |memory, at| packed::set::<F>(memory, 0, at, bits));
    }
    if F::BITS != 16 || !stride.is_multiple_of(2) {
        let pixel = bytes_per_pixel::<F>();
        return mirror(memory, octants, start, (pixel, stride), |memory, at| word::set::<F>(memory, at, bits));
    }
    let (_, pixels, _) = pod_align_to_mut::<u8, [u8; 2]>(memory);
    let pixel = low_u16(bits).to_le_bytes();
    mirror(pixels, octants, start, (1, stride / 2), |pixels, at| {
        if let Some(place) = pixels.get_mut(at) {
            *place = pixel;
        }
    });
}

/// Calls `set` with the places of all pixels, `pixel` apart in a row and `pitch` from row to row.
#[inline(always)]
fn mirror<T>(
    memory: &mut [T],
    octants: Octants,
    (row, x): (usize, usize),
    (pixel, pitch): (usize, usize),
    set: impl Fn(&mut [T], usize) + Copy,
) {
    let (extent, odd) = (offset(octants.extent()), offset(octants.offsets().0));
    let first = row.wrapping_mul(pitch).wrapping_add(x.wrapping_mul(pixel));
    let both = pitch.wrapping_add(pixel);
    // The first place and the last of the box together: a place and the one opposite of it.
    let sum = first.wrapping_mul(2).wrapping_add(extent.wrapping_mul(both));
    for (outwards, inwards) in [(pixel, pitch), (pitch, pixel)] {
        let left = first.wrapping_add((extent >> 1).wrapping_mul(outwards));
        let right = left.wrapping_add(odd.wrapping_mul(outwards));
        images(memory, octants, (left, right, sum), (outwards, inwards), set);
    }
}

/// Four of the eight images, two of them opposite of the others: all at once would need more registers than there are.
///
/// At every step the two move apart, and at some inwards together.
#[inline(never)]
fn images<T>(
    memory: &mut [T],
    mut octants: Octants,
    (mut left, mut right, sum): (usize, usize, usize),
    (outwards, inwards): (usize, usize),
    set: impl Fn(&mut [T], usize),
) {
    loop {
        for place in [left, right, sum.wrapping_sub(left), sum.wrapping_sub(right)] {
            set(memory, place);
        }
        let Some(inner) = octants.next_is_inner() else { return };
        (left, right) = (left.wrapping_sub(outwards), right.wrapping_add(outwards));
        if inner {
            (left, right) = (left.wrapping_add(inwards), right.wrapping_add(inwards));
            keep_branch();
        }
    }
}

#[inline(always)]
fn draw_pixels<const N: usize>(memory: &mut [u8], stride: usize, (row, x): (usize, usize), steps: Steps, pixel: [u8; N])
where
    [u8; N]: Pod,
{
    // In rows of a single pixel a step down and aside would be no step at all.
    if !stride.is_multiple_of(N) || stride <= N {
        let set = |at: usize| {
            if let Some(place) = memory.get_mut(at..at.wrapping_add(N)).and_then(<[u8]>::first_chunk_mut) {
                *place = pixel;
            }
        };
        return count(steps, (row, x), N, stride, set);
    }
    let (_, pixels, _) = pod_align_to_mut::<u8, [u8; N]>(memory);
    let pitch = stride / N;
    let first = row.wrapping_mul(pitch).wrapping_add(x);
    if steps.steep {
        down(pixels, first, pitch, steps, pixel);
    } else {
        across(pixels, first, pitch, steps, pixel);
    }
}

/// A line of which every pixel has a row of its own.
#[inline(always)]
fn down<P: Copy>(pixels: &mut [P], first: usize, pitch: usize, steps: Steps, pixel: P) {
    let Steps { x_step, left, sideways, minor, major, rest, .. } = steps;
    let (left, sideways, one) = (left as usize, sideways as usize, offset(x_step));
    let last = first.wrapping_add(left.wrapping_mul(pitch)).wrapping_add(sideways.wrapping_mul(one));
    let Some(pixels) = pixels.get_mut(..last.wrapping_add(1)) else { return };
    // On a chip that divides in software the two divisions cost more than they save on any but the longest lines.
    if DIVIDES && left > 15 {
        if let Some(major) = NonZeroU32::new(major).filter(|&n| n.get() < 1 << 16 && minor != 0 && minor != n.get()) {
            let (part, step) = (fraction(rest.wrapping_add(major.get()), major), fraction(minor, major));
            let (base, part, step) =
                if x_step > 0 { (pitch, part, step) } else { (pitch.wrapping_sub(1), !part, step.wrapping_neg()) };
            return glide(pixels, first, base, part, step, pixel);
        }
    }
    walk(pixels, first, (pitch, one), (rest, minor, major), pixel);
}

/// A line with runs of pixels in a row.
#[inline(always)]
fn across<P: Copy>(pixels: &mut [P], first: usize, pitch: usize, steps: Steps, pixel: P) {
    let Steps { x_step, left, sideways, minor, major, rest, .. } = steps;
    let (left, sideways, one) = (left as usize, sideways as usize, offset(x_step));
    let last = first.wrapping_add(left.wrapping_mul(one)).wrapping_add(sideways.wrapping_mul(pitch));
    // The commoner step is the unconditional one. In the complement, the steps without a move aside are those that carry.
    let (by, decision) = if minor <= major >> 1 {
        ((one, pitch), (rest, minor, major))
    } else {
        let complement = (!rest.wrapping_add(major), major.wrapping_sub(minor), major);
        ((pitch.wrapping_add(one), pitch.wrapping_neg()), complement)
    };
    if x_step > 0 {
        let Some(pixels) = pixels.get_mut(..last.wrapping_add(1)) else { return };
        walk(pixels, first, by, decision, pixel);
    } else {
        let Some((before, from_last)) = pixels.split_at_mut_checked(last) else { return };
        let at = walk(before, first, by, decision, pixel);
        for place in from_last.get_mut(..=at.wrapping_sub(last)).unwrap_or_default() {
            *place = pixel;
        }
    }
}

/// Bresenham's loop: moves by `step`, and when `rest + add` carries by `extra` too. Returns the first index outside.
#[inline]
fn walk<P: Copy>(
    pixels: &mut [P],
    mut at: usize,
    (step, extra): (usize, usize),
    (mut rest, add, take): (u32, u32, u32),
    pixel: P,
) -> usize {
    while let Some(place) = pixels.get_mut(at) {
        *place = pixel;
        at = at.wrapping_add(step);
        let (sum, carry) = rest.overflowing_add(add);
        rest = sum;
        if carry {
            rest = rest.wrapping_sub(take);
            at = at.wrapping_add(extra);
            // Made conditional, the instructions above would cost every pixel.
            keep_branch();
        }
    }
    at
}

/// The steep loop in five instructions: index and 32-bit fraction are one number, so a step is one addition.
///
/// `step = ceil(2^32 db / da)` is too large by less than 1, and so is `part` for the remainder at the first pixel: after
/// k steps by less than k + 1 <= da. What would have to be added for a wrong carry is 2^32 / da or more, and
/// `da^2 <= 2^32`. To the left, part and step are negated: a carry is a row without a move.
#[inline]
fn glide<P: Copy>(pixels: &mut [P], at: usize, base: usize, part: u32, step: u32, pixel: P) {
    let mut at = (at as u64) << 32 | u64::from(part);
    let by = (base as u64) << 32 | u64::from(step);
    while let Some(place) = usize::try_from(at >> 32).ok().and_then(|i| pixels.get_mut(i)) {
        *place = pixel;
        at = at.wrapping_add(by);
    }
}

/// Any memory, with a counter: positions are `pixel` apart in a row and `pitch` from row to row.
#[inline(always)]
fn count(mut steps: Steps, (row, x): (usize, usize), pixel: usize, pitch: usize, mut set: impl FnMut(usize)) {
    let mut at = row.wrapping_mul(pitch).wrapping_add(x.wrapping_mul(pixel));
    let aside = offset(steps.x_step).wrapping_mul(pixel);
    let (major, minor) = if steps.steep { (pitch, aside) } else { (aside, pitch) };
    let mut left = steps.left;
    loop {
        set(at);
        if left == 0 {
            break;
        }
        left = left.wrapping_sub(1);
        at = at.wrapping_add(major);
        if steps.next_is_minor() {
            at = at.wrapping_add(minor);
            keep_branch();
        }
    }
}
