//! [`Solid`]: one colour.

use super::traits::Paint;
use crate::surface::Surface;

/// The methods of a paint that has one colour wherever a shape covers pixels as a whole: it is told how to find the colour.
macro_rules! in_one_color {
    (|$paint:ident| $color:expr) => {
        #[inline(always)]
        fn span(&mut self, on: &mut S, span: $crate::span::ClippedSpan) {
            let $paint = &*self;
            on.fill_span(span, $color);
        }

        #[inline(always)]
        fn area(&mut self, on: &mut S, area: $crate::span::Rect) {
            let $paint = &*self;
            on.fill_area(area, $color);
        }

        #[inline(always)]
        fn steps(&mut self, on: &mut S, steps: $crate::span::Steps) {
            let $paint = &*self;
            on.fill_steps(steps, $color);
        }

        #[inline(always)]
        fn octants(&mut self, on: &mut S, octants: $crate::span::Octants) -> bool {
            let $paint = &*self;
            on.fill_octants(octants, $color)
        }
    };
}
pub(super) use in_one_color;

/// One colour for all pixels.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Solid<C>(pub C);

impl<S: Surface + ?Sized> Paint<S> for Solid<S::Color> {
    in_one_color!(|paint| paint.0);
}
