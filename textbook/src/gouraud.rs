//! Colours that change from corner to corner, on pixels of RGB565. Levels that an error takes beyond their range stop at its ends.

use crate::{
    fixed::{self, Fixed},
    float,
    scene::Triangle,
    Size,
};

/// A pixel of three levels.
#[inline(always)]
pub(crate) fn rgb565([r, g, b]: [i32; 3]) -> u16 {
    (r.clamp(0, 31) << 11 | g.clamp(0, 63) << 5 | b.clamp(0, 31)) as u16
}

/// The nearest levels.
#[inline(always)]
pub(crate) fn rounded(levels: [f32; 3]) -> [i32; 3] {
    levels.map(|level| (level + 0.5) as i32)
}

fn floats(triangle: &Triangle) -> ([[f32; 2]; 3], [[f32; 3]; 3]) {
    (places(triangle), triangle.map(|corner| corner.levels.map(|level| level as f32)))
}

/// The corners in pixels.
pub(crate) fn places(triangle: &Triangle) -> [[f32; 2]; 3] {
    triangle.map(|corner| corner.at.map(|at| at as f32 / 256.0))
}

/// `f32`, three barycentric coordinates at each pixel.
pub fn barycentric(frame: &mut [u16], size: Size, triangle: &Triangle) {
    let (corners, values) = floats(triangle);
    float::barycentric(corners, values, size, |at, levels| frame[at] = rgb565(rounded(levels)));
}

/// `f32`, row by row.
pub fn float_rows(frame: &mut [u16], size: Size, triangle: &Triangle) {
    let (corners, values) = floats(triangle);
    float::rows(corners, values, size, |span| span.each(|at, levels| frame[at] = rgb565(rounded(levels))));
}

/// Fixed point along sides and rows.
pub fn fixed_rows<const BITS: u32>(frame: &mut [u16], size: Size, triangle: &Triangle) {
    fixed::rows::<BITS, 3>(triangle.map(|c| c.at), triangle.map(|c| c.levels), size, |span| {
        span.each(|at, levels| frame[at] = rgb565(levels.map(|level| level >> BITS)));
    });
}

/// Fixed point with the gradients of the plane.
pub fn plane<T: Fixed, const BITS: u32>(frame: &mut [u16], size: Size, triangle: &Triangle) {
    fixed::plane::<T, BITS, 3>(triangle.map(|c| c.at), triangle.map(|c| c.levels), size, |span| {
        span.each(|at, levels| frame[at] = rgb565(levels.map(|level| level.whole(BITS))));
    });
}
