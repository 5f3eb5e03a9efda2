//! Colours of a texture, which repeats.

use crate::{fixed, float, gouraud::places, perspective, scene::Triangle, Size, Span};

/// A square texture whose side is a power of two.
#[derive(Copy, Clone, Debug)]
pub struct Tile<'a> {
    /// Row by row.
    pub texels: &'a [u16],
    /// The side is `1 << bits`.
    pub bits: u32,
}

impl Tile<'_> {
    #[inline(always)]
    fn texel(&self, [u, v]: [i32; 2]) -> u16 {
        let mask = (1 << self.bits) - 1;
        self.texels[((v & mask) << self.bits | u & mask) as usize]
    }
}

/// Fixed point along sides and rows, without perspective.
pub fn affine<const BITS: u32>(frame: &mut [u16], size: Size, triangle: &Triangle, tile: Tile<'_>) {
    fixed::rows::<BITS, 2>(triangle.map(|c| c.at), triangle.map(|c| c.texel), size, |span| {
        // The half that is there for rounding is taken away: the texel that contains the place is asked for.
        let at = span.at.map(|t| t - (1 << (BITS - 1)));
        Span { at, ..span }.each(|at, place| frame[at] = tile.texel(place.map(|t| t >> BITS)));
    });
}

fn divided(triangle: &Triangle) -> [[f32; 3]; 3] {
    triangle.map(|corner| {
        let nearness = 1.0 / corner.w as f32;
        [corner.texel[0] as f32 * nearness, corner.texel[1] as f32 * nearness, nearness]
    })
}

/// `f32`, a division at each pixel.
pub fn each(frame: &mut [u16], size: Size, triangle: &Triangle, tile: Tile<'_>) {
    float::rows(places(triangle), divided(triangle), size, |span| {
        perspective::each(span, |at, place| frame[at] = tile.texel(place));
    });
}

/// `f32`, a division at the ends of runs of N pixels.
pub fn runs<const N: usize>(frame: &mut [u16], size: Size, triangle: &Triangle, tile: Tile<'_>) {
    float::rows(places(triangle), divided(triangle), size, |span| {
        perspective::runs::<N>(span, |at, place| frame[at] = tile.texel(place));
    });
}
