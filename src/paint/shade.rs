//! [`Shade`]: colours that change from pixel to pixel of a triangle.

use super::traits::Paint;
use crate::{
    geom::{varying::Rows, Facet, Plane, Varying},
    num::cast::unsigned,
    span::ClippedSpan,
    surface::{Inside, Said, Surface},
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

    /// Of a triangle with these values at its corners.
    #[inline(always)]
    pub(crate) fn over(facet: &Facet, corners: [V; 3], color: F) -> Self {
        Self { rows: Rows::over(facet, corners), color }
    }
}

impl<V: Varying, F> Shade<V, F> {
    /// Paints pixels of one row that lie in the window of the surface.
    #[inline(always)]
    pub(crate) fn row<S: Surface>(&mut self, on: &mut S, span: ClippedSpan)
    where
        F: FnMut(V) -> S::Color,
    {
        if span.len() > self.rows.reach() {
            self.parts(on, span);
        } else {
            self.run(on, span);
        }
    }

    /// A row in which one run is right to its end.
    // Not inlined: the state of the loop along the row has the registers to itself.
    #[inline(never)]
    fn run<S: Surface>(&mut self, on: &mut S, span: ClippedSpan)
    where
        F: FnMut(V) -> S::Color,
    {
        self.rows.go_to(span.y());
        let (mut run, color) = (self.rows.run(span.x0(), span.len()), &mut self.color);
        on.write_span_inside(Inside(Said::Span(span)), |_| {
            let value = V::value(&run);
            V::step(&mut run);
            color(value)
        });
    }

    /// A row in which a run is not right to its end.
    #[inline(never)]
    fn parts<S: Surface>(&mut self, on: &mut S, span: ClippedSpan)
    where
        F: FnMut(V) -> S::Color,
    {
        let Self { rows, color } = self;
        rows.go_to(span.y());
        let (mut run, mut rest) = (rows.run(span.x0(), span.len()), false);
        span.parts(rows.reach(), |part| {
            if core::mem::replace(&mut rest, true) {
                rows.go_on(&mut run, (part.x0(), part.y()), unsigned(span.x1().wrapping_sub(part.x0())));
            }
            let mut at = run;
            on.write_span_inside(Inside(Said::Span(part)), |_| {
                let value = V::value(&at);
                V::step(&mut at);
                color(value)
            });
            run = at;
        });
    }
}

impl<S: Surface, V: Varying, F: FnMut(V) -> S::Color> Paint<S> for Shade<V, F> {
    #[inline]
    fn span(&mut self, on: &mut S, span: ClippedSpan) {
        if let Some(span) = span.again(on.window()) {
            self.row(on, span);
        }
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

    /// Paints pixels of one row that lie in the window of the surface.
    #[inline(never)]
    pub(crate) fn row<S: Surface>(&mut self, on: &mut S, span: ClippedSpan)
    where
        F: FnMut(V) -> Option<S::Color>,
    {
        let Self { rows, color } = self;
        rows.go_to(span.y());
        let mut run = rows.run(span.x0(), span.len());
        span.parts(rows.reach(), |part| {
            if part.x0() != span.x0() {
                rows.go_on(&mut run, (part.x0(), part.y()), unsigned(span.x1().wrapping_sub(part.x0())));
            }
            let mut at = run;
            on.write_inside(Inside(Said::Span(part)), |_| {
                let value = V::value(&at);
                V::step(&mut at);
                color(value)
            });
            run = at;
        });
    }
}

impl<S: Surface, V: Varying, F: FnMut(V) -> Option<S::Color>> Paint<S> for ShadeSome<V, F> {
    #[inline]
    fn span(&mut self, on: &mut S, span: ClippedSpan) {
        if let Some(span) = span.again(on.window()) {
            self.row(on, span);
        }
    }
}
