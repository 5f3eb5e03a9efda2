//! [`Shade`]: colours that change from pixel to pixel of a triangle.

use super::traits::Paint;
use crate::{
    geom::{varying::Rows, Plane, Varying},
    span::ClippedSpan,
    surface::Surface,
};

/// The colours that a function makes of the values of a [`Plane`], pixel by pixel.
///
/// It is right in the triangle of the plane. [`Canvas::shade_triangle_fx`](crate::Canvas::shade_triangle_fx) draws a triangle so;
/// to draw through a `Shade` is for those who fill a part of it, such as a polygon that lies in one plane.
#[derive(Copy, Clone, Debug)]
pub struct Shade<V: Varying, F> {
    rows: Rows<V>,
    color: F,
}

impl<V: Varying, F> Shade<V, F> {
    /// `color` makes a colour of each value.
    #[inline(always)]
    pub fn new(plane: Plane<V>, color: F) -> Self {
        Self { rows: Rows::new(plane, plane.top()), color }
    }
}

impl<S: Surface, V: Varying, F: FnMut(V) -> S::Color> Paint<S> for Shade<V, F> {
    // Not inlined: the state of the loop along the row has the registers to itself.
    #[inline(never)]
    fn span(&mut self, on: &mut S, span: ClippedSpan) {
        let Self { rows, color } = self;
        rows.go_to(span.y());
        span.parts(rows.reach(), |part| {
            let mut run = rows.run(part.x0());
            on.write_span(part, |_| {
                let value = V::value(&run);
                V::step(&mut run);
                color(value)
            });
        });
    }
}

/// A [`Shade`] whose function may answer `None`: then the pixel stays as it is.
#[derive(Copy, Clone, Debug)]
pub struct ShadeSome<V: Varying, F> {
    rows: Rows<V>,
    color: F,
}

impl<V: Varying, F> ShadeSome<V, F> {
    /// `color` makes a colour of each value, or none.
    #[inline(always)]
    pub fn new(plane: Plane<V>, color: F) -> Self {
        Self { rows: Rows::new(plane, plane.top()), color }
    }
}

impl<S: Surface, V: Varying, F: FnMut(V) -> Option<S::Color>> Paint<S> for ShadeSome<V, F> {
    #[inline(never)]
    fn span(&mut self, on: &mut S, span: ClippedSpan) {
        let Self { rows, color } = self;
        rows.go_to(span.y());
        span.parts(rows.reach(), |part| {
            let mut run = rows.run(part.x0());
            on.write_some(part, |_| {
                let value = V::value(&run);
                V::step(&mut run);
                color(value)
            });
        });
    }
}
