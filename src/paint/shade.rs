//! [`Shade`]: colours that change from pixel to pixel of a triangle.

use super::traits::Paint;
use crate::{
    error::TriangleTooLarge,
    geom::{small::Small, varying::Rows, Facet, Plane, PointFx, SmallFacet, Varying},
    num::cast::unsigned,
    raster::triangle::{self, tiny, TinySpans},
    span::{ClippedSpan, Span},
    surface::{Inside, InsideRows, Said, Surface},
    tune::COMPACT,
};

/// Whether small triangles have a loop of their own.
const SMALL: bool = !COMPACT;

/// Fills a triangle with colours that a function makes of the values at its corners.
///
/// # Errors
/// If the triangle is too large to be a facet. Then nothing is drawn.
#[inline(always)]
pub(crate) fn fill<S: Surface, V: Varying>(
    on: &mut S,
    corners: [PointFx; 3],
    values: [V; 3],
    mut color: impl FnMut(V) -> S::Color,
) -> Result<(), TriangleTooLarge> {
    let is_done = fill_small(on, (corners, || SmallFacet::new(&corners)), &values, |on, rows, values| {
        paint_rows::<S, V>(on, rows, values, &mut color);
    });
    if !is_done {
        let facet = Facet::of_any_size(corners);
        facet.fits(corners)?;
        let mut shade = Shade::over(&facet, values, color);
        triangle::fill(corners, on.window(), |span: ClippedSpan| shade.row(on, span));
    }
    Ok(())
}

/// The same for a function that may answer `None`: then the pixel stays as it is. The triangle is a facet.
#[inline(always)]
pub(crate) fn fill_some<S: Surface, V: Varying>(
    on: &mut S,
    (corners, facet): ([PointFx; 3], &Facet),
    values: [V; 3],
    mut color: impl FnMut(V) -> Option<S::Color>,
) {
    let is_done = fill_small(on, (corners, || facet.small()), &values, |on, rows, values| {
        paint_some_rows::<S, V>(on, rows, values, &mut color);
    });
    if !is_done {
        let mut shade = ShadeSome::new(Plane::new(facet, values), color);
        triangle::fill(corners, on.window(), |span: ClippedSpan| shade.row(on, span));
    }
}

/// Calls `paint` with the rows of a triangle, and the values in the first column of its box, in the first of them, if it is small, and
/// tiny in its window. If not, it returns `false`.
#[inline(always)]
fn fill_small<S: Surface, V: Varying>(
    on: &mut S,
    (corners, facet): ([PointFx; 3], impl FnOnce() -> SmallFacet),
    values: &[V; 3],
    paint: impl FnOnce(&mut S, InsideRows<'_>, V::Small),
) -> bool {
    if !SMALL || !V::Small::EXISTS {
        return false;
    }
    let facet = facet();
    if !facet.is_small() {
        return false;
    }
    let ((x, first_y), mut spans) = (facet.first(), TinySpans::new());
    let Some((y, rows)) = tiny(corners, on.window(), x, &mut spans) else { return false };
    let Some(mut small) = V::small(&facet, *values) else { return false };
    small.skip(unsigned(y.wrapping_sub(first_y)));
    paint(on, InsideRows { x, y, spans: spans.rows().get(..rows).unwrap_or_default() }, small);
    true
}

/// Paints rows of a small triangle. The values are those in column x of the first row.
// Not inlined: the loop has the registers to itself.
#[inline(never)]
pub(super) fn paint_rows<S: Surface, V: Varying>(
    on: &mut S,
    rows: InsideRows<'_>,
    mut values: V::Small,
    color: &mut impl FnMut(V) -> S::Color,
) {
    let start = |right: u8| {
        let run = values.run(right.into());
        values.below();
        run
    };
    on.write_rows_inside(rows, start, |run| {
        let value = V::value(run);
        V::step(run);
        color(value)
    });
}

/// The same in colours that may be `None`.
#[inline(never)]
fn paint_some_rows<S: Surface, V: Varying>(
    on: &mut S,
    InsideRows { x, mut y, spans }: InsideRows<'_>,
    mut values: V::Small,
    color: &mut impl FnMut(V) -> Option<S::Color>,
) {
    for &[right, pixels] in spans {
        let x0 = x.wrapping_add(right.into());
        if let Some(span) = (Span { y, x0, x1: x0.wrapping_add(pixels.into()) }).known_inside() {
            let mut run = values.run(right.into());
            on.write_inside(Inside(Said::Span(span)), |_| {
                let value = V::value(&run);
                V::step(&mut run);
                color(value)
            });
        }
        values.below();
        y = y.wrapping_add(1);
    }
}

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
        let run = rows.run(span.x0(), span.len());
        let go_on = |run: &mut V::Run, rest| {
            let x = span.x1().wrapping_sub_unsigned(rest);
            rows.go_on(run, (x, span.y()), rest);
        };
        on.write_parts_inside(Inside(Said::Span(span)), rows.reach(), run, go_on, |run| {
            let value = V::value(run);
            V::step(run);
            color(value)
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
