//! Colours of what is nearest, with a depth buffer beside the pixels.

use crate::{
    fixed, float,
    gouraud::{places, rgb565, rounded},
    scene::Triangle,
    Size,
};

/// Depths in `f32`, row by row: 24 bits of them are right.
pub fn float_rows(frame: &mut [u16], depths: &mut [f32], size: Size, triangle: &Triangle) {
    let values = triangle.map(|corner| {
        let [r, g, b] = corner.levels.map(|level| level as f32);
        [r, g, b, corner.depth as f32]
    });
    float::rows(places(triangle), values, size, |span| {
        span.each(|at, [r, g, b, depth]| {
            if depth < depths[at] {
                depths[at] = depth;
                frame[at] = rgb565(rounded([r, g, b]));
            }
        });
    });
}

/// The same, three barycentric coordinates at each pixel.
pub fn barycentric(frame: &mut [u16], depths: &mut [f32], size: Size, triangle: &Triangle) {
    let values = triangle.map(|corner| {
        let [r, g, b] = corner.levels.map(|level| level as f32);
        [r, g, b, corner.depth as f32]
    });
    float::barycentric(places(triangle), values, size, |at, [r, g, b, depth]| {
        if depth < depths[at] {
            depths[at] = depth;
            frame[at] = rgb565(rounded([r, g, b]));
        }
    });
}

/// Bits of the fraction of depths of 16 bits, in numbers of 32.
const BITS: u32 = 14;

/// Depths of 16 bits in fixed point, along sides and rows.
pub fn fixed_rows(frame: &mut [u16], depths: &mut [u16], size: Size, triangle: &Triangle) {
    let values = triangle.map(|corner| {
        let [r, g, b] = corner.levels;
        [r, g, b, corner.depth as i32]
    });
    fixed::rows::<BITS, 4>(triangle.map(|c| c.at), values, size, |span| {
        span.each(|at, [r, g, b, depth]| {
            let depth = (depth >> BITS).clamp(0, 0xffff) as u16;
            if depth < depths[at] {
                depths[at] = depth;
                frame[at] = rgb565([r, g, b].map(|level| level >> BITS));
            }
        });
    });
}
