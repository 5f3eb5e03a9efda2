//! Runs of 3-byte pixels.

use bytemuck::pod_align_to_mut;

use crate::tune::{keep_rolled, ARMV6, RISCV};

/// A run of 3-byte pixels: four of them make three words.
#[inline(never)]
pub(super) fn fill_span24(run: &mut [u8], bits: u32) {
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
        keep_rolled(ARMV6);
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
        keep_rolled(RISCV);
    }
}
