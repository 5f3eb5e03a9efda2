//! [`Add`]: shapes that are added up before they are seen.

use embedded_graphics_core::pixelcolor::Rgb888;

use super::traits::Paint;
use crate::{
    span::ClippedSpan,
    surface::{Accumulator, Surface},
};

/// Adds a colour to an [`Accumulator`]: where a shape covers a pixel in part, that part of it.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Add(pub Rgb888);

impl Paint<Accumulator<'_>> for Add {
    #[inline]
    fn span(&mut self, on: &mut Accumulator<'_>, span: ClippedSpan) {
        on.fill_span(span, self.0);
    }

    #[inline(never)]
    fn coverage(&mut self, on: &mut Accumulator<'_>, span: ClippedSpan, levels: &[u8]) {
        on.add(span, self.0, |i| levels.get(i).copied().unwrap_or(0));
    }
}
