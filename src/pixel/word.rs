//! 8, 16, 24 and 32 bits per pixel: whole bytes, the least significant one first.

use super::PixelFormat;
use crate::num::cast::{low_u16, low_u8};

/// Fills whole bytes with one byte.
#[inline(always)]
pub(crate) fn fill_bytes(run: &mut [u8], byte: u8) {
    run.fill(byte);
}

/// Fills a run of whole pixels.
#[inline(always)]
pub(super) fn fill<F: PixelFormat>(run: &mut [u8], bits: u32) {
    match F::BITS {
        8 => fill_bytes(run, low_u8(bits)),
        16 => fill_pattern(run, low_u16(bits).to_le_bytes()),
        24 => {
            let [a, b, c, _] = bits.to_le_bytes();
            fill_pattern(run, [a, b, c]);
        }
        _ => fill_pattern(run, bits.to_le_bytes()),
    }
}

#[inline(always)]
fn fill_pattern<const N: usize>(run: &mut [u8], pixel: [u8; N]) {
    for place in run.chunks_exact_mut(N) {
        place.copy_from_slice(&pixel);
    }
}

/// Writes the pixel at byte `at`.
#[inline(always)]
pub(super) fn set<F: PixelFormat>(memory: &mut [u8], at: usize, bits: u32) {
    let size = super::bytes_per_pixel::<F>();
    if let Some(place) = memory.get_mut(at..at.wrapping_add(size)) {
        for (byte, value) in place.iter_mut().zip(bits.to_le_bytes()) {
            *byte = value;
        }
    }
}

/// Reads the pixel at byte `at`.
#[inline(always)]
pub(super) fn get<F: PixelFormat>(memory: &[u8], at: usize) -> u32 {
    let size = super::bytes_per_pixel::<F>();
    let mut bytes = [0; 4];
    if let Some(place) = memory.get(at..at.wrapping_add(size)) {
        for (byte, value) in bytes.iter_mut().zip(place) {
            *byte = *value;
        }
    }
    u32::from_le_bytes(bytes)
}

/// Copies bytes between runs of the same length.
#[inline(always)]
pub(super) fn copy(to: &mut [u8], from: &[u8]) {
    if to.len() == from.len() {
        to.copy_from_slice(from);
    }
}
