//! Places in a texture from `u / w`, `v / w` and `1 / w`, which change evenly on the screen.
//!
//! Source: C. Hecker, "Perspective Texture Mapping", Game Developer, 1995.

use crate::Span;

/// Whole texels from 16 bits of fraction.
const BITS: u32 = 16;

/// A division at each pixel.
#[inline(always)]
pub fn each(span: Span<f32, 3>, mut pixel: impl FnMut(usize, [i32; 2])) {
    span.each(|place, [u, v, nearness]| {
        let w = 1.0 / nearness;
        pixel(place, [floor(u * w), floor(v * w)]);
    });
}

/// A division at the ends of runs of N pixels; between them, places go evenly, with 16 bits of fraction.
#[inline(always)]
pub fn runs<const N: usize>(span: Span<f32, 3>, mut pixel: impl FnMut(usize, [i32; 2])) {
    let Span { start, len, mut at, by } = span;
    let place = |[u, v, nearness]: [f32; 3]| {
        let w = 65_536.0 / nearness;
        [(u * w) as i32, (v * w) as i32]
    };
    let mut from = place(at);
    let mut done = 0;
    while done < len {
        let n = N.min(len - done);
        at.iter_mut().zip(by).for_each(|(at, by)| *at += by * n as f32);
        // The end of the last run lies beyond the triangle by at most a pixel.
        let to = place(at);
        let gain = [0, 1].map(|i| to[i].wrapping_sub(from[i]) / n as i32);
        let mut texel = from;
        for i in 0..n {
            pixel(start + done + i, texel.map(|t| t >> BITS));
            texel = [0, 1].map(|i| texel[i].wrapping_add(gain[i]));
        }
        from = to;
        done += n;
    }
}

/// The largest whole number that is not above.
#[inline(always)]
fn floor(x: f32) -> i32 {
    let cut = x as i32;
    cut - i32::from(x < cut as f32)
}
