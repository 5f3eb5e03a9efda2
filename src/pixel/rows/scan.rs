//! Looking for pixels along a row in memory.

use super::{get, word};
use crate::pixel::format::{byte, bytes_per_pixel, PixelFormat};

/// The first of pixels `x0..x1` of the row that starts at byte `row` whose colour is wanted; `x1` if none is.
#[inline(always)]
pub(crate) fn find<F: PixelFormat>(
    memory: &[u8],
    row: usize,
    (x0, x1): (usize, usize),
    wanted: impl Fn(F::Color) -> bool,
) -> usize {
    let mut x = x0;
    match (F::BITS, memory.get(byte::<F>(row, x0)..byte::<F>(row, x1))) {
        (16, Some(run)) => {
            for pixel in run.chunks_exact(2) {
                if pixel.first_chunk().is_some_and(|&p| wanted(F::unpack(u16::from_le_bytes(p).into()))) {
                    return x;
                }
                x = x.wrapping_add(1);
            }
        }
        (8, Some(run)) => {
            for &pixel in run {
                if wanted(F::unpack(pixel.into())) {
                    return x;
                }
                x = x.wrapping_add(1);
            }
        }
        _ => {
            while x < x1 && !wanted(F::unpack(get::<F>(memory, row, x))) {
                x = x.wrapping_add(1);
            }
        }
    }
    x
}

/// Where the pixels begin that end before pixel `x`, from `x0` on, and are all wanted.
#[inline(always)]
pub(crate) fn start<F: PixelFormat>(
    memory: &[u8],
    row: usize,
    (x0, mut x): (usize, usize),
    wanted: impl Fn(F::Color) -> bool,
) -> usize {
    while x > x0 && wanted(F::unpack(get::<F>(memory, row, x.wrapping_sub(1)))) {
        x = x.wrapping_sub(1);
    }
    x
}

/// Paints pixels `by` bytes apart for as long as they are open and the pixels left and right of each are not. Returns how
/// many; `at` is the byte of the first one's left neighbour. Stops at the ends of the memory. For formats of whole bytes.
#[inline(always)]
pub(crate) fn corridor<F: PixelFormat>(
    memory: &mut [u8],
    mut at: usize,
    by: usize,
    bits: u32,
    is_open: impl Fn(F::Color) -> bool,
) -> i32 {
    let (pixel, mut painted) = (bytes_per_pixel::<F>(), 0_i32);
    // Three pixels cut out at once: one check of the memory for all.
    while let Some(three) = memory.get_mut(at..).and_then(|rest| rest.get_mut(..3 * pixel)) {
        let is_open = |byte: usize| is_open(F::unpack(word::get::<F>(three, byte)));
        if !is_open(pixel) || is_open(0) || is_open(2 * pixel) {
            break;
        }
        word::set::<F>(three, pixel, bits);
        painted = painted.wrapping_add(1);
        at = at.wrapping_add(by);
    }
    painted
}
