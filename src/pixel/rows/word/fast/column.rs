//! Vertical runs.

use crate::{
    pixel::rows::word::parts::fill_every,
    tune::{keep_rolled, ARM},
};

/// The first pixel, and one every `pitch` pixels. Four quarters at a time: as long as each other, they share the index and
/// its one comparison.
#[inline(always)]
pub(in crate::pixel::rows::word) fn fill_column<P: Copy>(pixels: &mut [P], (pitch, rows): (usize, usize), pixel: P) {
    // Of the rows before the last, which ends with its pixel.
    let quarter = (rows.wrapping_sub(1) >> 2).wrapping_mul(pitch);
    let Some((a, after)) = pixels.split_at_mut_checked(quarter) else { return };
    let Some((b, after)) = after.split_at_mut_checked(quarter) else { return };
    let Some((c, after)) = after.split_at_mut_checked(quarter) else { return };
    let Some((d, after)) = after.split_at_mut_checked(quarter) else { return };
    let mut at = 0;
    while let (Some(a), Some(b), Some(c), Some(d)) = (a.get_mut(at), b.get_mut(at), c.get_mut(at), d.get_mut(at)) {
        (*a, *b, *c, *d) = (pixel, pixel, pixel, pixel);
        at = at.wrapping_add(pitch);
        keep_rolled(ARM);
    }
    fill_every(after, pitch, pixel);
}
