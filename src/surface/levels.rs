//! Frames as masks: how much of each pixel there is.
//!
//! Of pixels of 1, 2, 4 or 8 bits the number is a level: 0 is nothing, and the largest number all of a pixel. In 255ths that is the
//! number times 255, 85, 17 or 1, so nothing is rounded. Glyphs with soft rims are such masks, whoever made them, and so is
//! whatever a program draws into a frame of `Gray8` or `BinaryColor`: a shape to clip by.
//!
//! A mask is told to a [`Sink`] as shapes with soft rims are. So all paints take it, on all surfaces.
//! [`Masked`](crate::paint::Masked) paints through one.

use embedded_graphics_core::geometry::Point;

use super::{blit::Plan, frame::Frame, layout::Layout};
use crate::{
    num::cast::{index, low_u32, low_u8},
    pixel::PixelFormat,
    span::{ClippedSpan, Rect, Sink},
};

/// So many levels are told at a time.
pub(crate) const CHUNK: u32 = 32;

impl<M: AsRef<[u8]>, L: Layout> Frame<M, L>
where
    L::Color: PixelFormat<Color = L::Color>,
{
    /// Bits of a pixel of a mask.
    pub(crate) const MASK_BITS: u32 = {
        let bits = <L::Color as PixelFormat>::BITS;
        assert!(bits <= 8, "a mask has pixels of 1, 2, 4 or 8 bits");
        bits
    };

    /// Tells a sink how much there is of each pixel of this mask if its top left pixel falls on `at`: what
    /// [`Antialias::blit_mask_aa`](crate::Antialias::blit_mask_aa) paints. Of pixels of 1, 2, 4 or 8 bits the number is the level, and
    /// the largest number all of the pixel. What lies outside of `window` is left out.
    ///
    /// Work: a look at each pixel of the mask that lies in the window.
    pub fn tell_levels(&self, at: Point, window: Rect, mut sink: impl Sink) {
        let Some(plan) = Plan::new(window, at, self.window()) else { return };
        plan.each_row(|span, (from_x, from_y)| {
            let right = from_x.wrapping_sub(span.x0());
            span.parts(CHUNK, |part| {
                let mut levels = [0; CHUNK as usize];
                let levels = self.levels(&mut levels, part, (right, from_y), |level, _| level);
                part.each_covered(levels, |run, levels| match levels {
                    Some(levels) => sink.coverage(run, levels),
                    None => sink.span(run),
                });
            });
        });
    }

    /// The levels of the pixels in row y that a span has when it is moved by so many columns, each changed by `change`, which is told
    /// its number in the span. The span has [`CHUNK`] pixels at most, and moved it lies in the window.
    #[inline(always)]
    pub(crate) fn levels<'a>(
        &self,
        levels: &'a mut [u8; CHUNK as usize],
        span: ClippedSpan,
        (right, y): (i32, i32),
        change: impl Fn(u8, usize) -> u8,
    ) -> &'a [u8] {
        let len = index(span.x1().wrapping_sub(span.x0()));
        let levels = levels.get_mut(..len).unwrap_or_default();
        let (memory, grid) = self.read();
        let (mut x, y) = (self.x(span.x0().wrapping_add(right)), self.y(y));
        for (place, i) in levels.iter_mut().zip(0..) {
            let bits = <L::Color as PixelFormat>::pack(L::get(memory, grid, (x, y)));
            *place = change(low_u8(bits.wrapping_mul(255 / (u32::MAX >> (32 - Self::MASK_BITS)))), i);
            x = x.wrapping_add(1);
        }
        levels
    }

    /// Whether a pixel that lies in the window has a level.
    #[inline(always)]
    pub(super) fn is_set(&self, x: i32, y: i32) -> bool {
        <L::Color as PixelFormat>::pack(self.at(x, y)) != 0
    }

    /// Calls `f` with the runs of a span, which may reach beyond the window, whose pixels have a level, from left to right.
    #[inline(always)]
    pub(crate) fn each_set(&self, span: ClippedSpan, mut f: impl FnMut(ClippedSpan)) {
        let Some(span) = span.again(self.window()) else { return };
        let (memory, grid) = self.read();
        let ((first, end), y) = (self.columns(span), self.y(span.y()));
        let is_set = |color| <L::Color as PixelFormat>::pack(color) != 0;
        // In columns of the memory; `x` is the column of the surface.
        let column = |place: usize| span.x0().wrapping_add_unsigned(low_u32(place.wrapping_sub(first) as u64));
        let mut next = first;
        while next < end {
            let from = L::find(memory, grid, y, (next, end), is_set);
            if from >= end {
                return;
            }
            next = L::find(memory, grid, y, (from, end), |color| !is_set(color));
            f(ClippedSpan::inside(span.y(), column(from), column(next)));
        }
    }
}
