//! [`Shade`]: colours that change from pixel to pixel of a triangle.

use super::traits::Paint;
use crate::{
    geom::{Plane, Varying},
    span::ClippedSpan,
    surface::Surface,
};

/// The colours that a function makes of the values of a [`Plane`], pixel by pixel.
///
/// It is right in the triangle of the plane. [`Canvas::shade_triangle_fx`](crate::Canvas::shade_triangle_fx) draws a triangle so;
/// to draw through a `Shade` is for those who fill a part of it, such as a polygon that lies in one plane.
#[derive(Copy, Clone, Debug)]
pub struct Shade<V: Varying, F> {
    plane: Plane<V>,
    color: F,
}

impl<V: Varying, F> Shade<V, F> {
    /// `color` makes a colour of each value.
    #[inline(always)]
    pub const fn new(plane: Plane<V>, color: F) -> Self {
        Self { plane, color }
    }
}

impl<S: Surface, V: Varying, F: FnMut(V) -> S::Color> Paint<S> for Shade<V, F> {
    #[inline(always)]
    fn span(&mut self, on: &mut S, span: ClippedSpan) {
        span.parts(self.plane.reach(), |part| {
            write_run(on, part, self.plane.run(part.x0(), part.y()), &mut self.color);
        });
    }
}

/// The loop along a row: a function of its own, so that the state of the row has the registers to itself.
#[inline(never)]
fn write_run<S: Surface, V: Varying>(
    on: &mut S,
    span: ClippedSpan,
    mut run: V::Run,
    color: &mut impl FnMut(V) -> S::Color,
) {
    on.write_span(span, move |_| {
        let value = V::value(&run);
        V::step(&mut run);
        color(value)
    });
}
