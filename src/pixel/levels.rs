//! What colours and palettes share: levels of a channel, the nearest of several colours, and the table of the EGA.

use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};

/// `value * to_max / from_max`, rounded to nearest.
#[inline]
pub(super) const fn rescale(value: u8, from_max: u8, to_max: u8) -> u8 {
    let (value, from, to) = (value as u32, from_max as u32, to_max as u32);
    // from_max is a non-zero constant wherever this is called; `max(1)` tells the compiler.
    let from = if from == 0 { 1 } else { from };
    crate::num::cast::low_u8((2 * value * to + from) / (2 * from))
}

/// Luma of ITU-R BT.601, by the weights 77, 150 and 29 of 256, of channels below `2^16`: in their range.
#[inline]
pub(super) const fn luma([r, g, b]: [u32; 3]) -> u32 {
    let sum = r.wrapping_mul(77).wrapping_add(g.wrapping_mul(150)).wrapping_add(b.wrapping_mul(29));
    sum.wrapping_add(128) >> 8
}

/// The index of the nearest of at most 256 colours.
pub(super) fn nearest<C: RgbColor>(colors: impl Iterator<Item = C>, wanted: C) -> u8 {
    let square = |a: u8, b: u8| {
        let d = u32::from(a.abs_diff(b));
        d * d
    };
    let (mut best, mut least) = (0, u32::MAX);
    for (i, c) in (0..=u8::MAX).zip(colors) {
        let distance = square(c.r(), wanted.r()) + square(c.g(), wanted.g()) + square(c.b(), wanted.b());
        if distance < least {
            (best, least) = (i, distance);
        }
    }
    best
}

/// The colours of [`EGA`](super::EGA).
pub(super) const EGA_RGB: [Rgb888; 16] = {
    let mut colors = [Rgb888::BLACK; 16];
    let mut i = 0;
    while i < 16 {
        // Bits of an index: intensity, red, green, blue. Intensity adds a third to each channel.
        let third = if i & 8 != 0 { 85 } else { 0 };
        let r = if i & 4 != 0 { 170 + third } else { third };
        // The one exception: dark yellow is shown as brown, with half its green.
        let g = if i == 6 {
            85
        } else if i & 2 != 0 {
            170 + third
        } else {
            third
        };
        let b = if i & 1 != 0 { 170 + third } else { third };
        colors[i] = Rgb888::new(r, g, b);
        i += 1;
    }
    colors
};
