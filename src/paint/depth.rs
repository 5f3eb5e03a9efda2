//! [`DepthShade`]: colours of what is nearest.
//!
//! A depth buffer has a depth for each pixel. A pixel of a triangle is painted if its own depth passes a comparison with that, and
//! then its depth is kept. So triangles may come in any order, and may pass through each other.
//!
//! Depths are whole numbers, 0 for what is nearest if the comparison is [`less`]. Over a triangle a depth changes as every
//! [`Varying`] does: it is the nearest number to the exact one at the centre of the pixel. So two triangles that lie in one plane
//! have the same depth at every pixel that they share, and do not fight.
//!
//! **Which depth?** What changes linearly on the screen is 1 / z, and whatever is linear in it, such as the z of normalized device
//! coordinates; z itself is not. So depths are made of the latter. Of their steps most lie close to the near plane: with the near
//! plane at 1 and the far plane at 100, half of all 16-bit depths are nearer than 2.
//! ```
//! use embedded_graphics_core::pixelcolor::{Gray8, GrayColor};
//! use embedded_raster::{buffer_bytes, paint::depth, pixel::Depth16, surface::DepthBuffer, Canvas, Framebuffer, PointFx};
//! let (mut ram, mut depth_ram) = ([0; 25], [0; buffer_bytes::<Depth16>(5, 5)]);
//! let mut frame = Framebuffer::<Gray8>::new(&mut ram, 5, 5)?;
//! let mut depth = DepthBuffer::<Depth16>::new(&mut depth_ram, 5, 5)?;
//! depth.clear(Depth16::MAX);
//! let corners = [PointFx::px(0, 0), PointFx::px(4, 0), PointFx::px(0, 4)];
//! for (distance, gray) in [(20, 1), (10, 2), (30, 3)] {
//!     frame.depth_triangle_fx(corners, [(distance, ()); 3], &mut depth, depth::less, |()| Gray8::new(gray))?;
//! }
//! assert_eq!(ram[..5], [2, 2, 2, 0, 0]);
//! # Ok::<(), embedded_raster::Error>(())
//! ```
//!
//! Source: E. Catmull, "A Subdivision Algorithm for Computer Display of Curved Surfaces", 1974 (the z-buffer).

mod small;

use self::small::Rest;
use super::traits::Paint;
use crate::{
    error::TriangleTooLarge,
    geom::{small::Small, varying::Rows, Facet, Plane, PointFx, SmallFacet, Varying},
    num::cast::unsigned,
    raster::triangle::{self, TinySpans},
    span::ClippedSpan,
    surface::{self, Depth, DepthCell, Frame, Inside, Said, Surface},
};

/// Nearer than what is there.
#[inline(always)]
pub fn less<N: PartialOrd>(new: &N, old: &N) -> bool {
    new < old
}

/// Not farther than what is there: of equal depths, the last one is seen.
#[inline(always)]
pub fn less_equal<N: PartialOrd>(new: &N, old: &N) -> bool {
    new <= old
}

/// Farther than what is there: for depths that fall with the distance.
#[inline(always)]
pub fn greater<N: PartialOrd>(new: &N, old: &N) -> bool {
    new > old
}

/// Whatever is there.
#[inline(always)]
pub fn always<N: PartialOrd>(_: &N, _: &N) -> bool {
    true
}

/// The colours that a function makes of the values of a [`Plane`], at the pixels where a depth passes a test. Where the function
/// answers `None`, neither the colour nor the depth is painted.
#[derive(Debug)]
pub struct DepthShade<'a, M, Z: Depth, V: Varying, T, F> {
    depth: &'a mut Frame<M, surface::Rows<Z>>,
    rows: Rows<Z::Number>,
    values: Rows<V>,
    /// For how many pixels runs of both are right.
    reach: u32,
    passes: T,
    writes: bool,
    color: F,
}

impl<'a, M: AsMut<[u8]>, Z: Depth, V: Varying, T, F> DepthShade<'a, M, Z, V, T, F> {
    /// `passes` compares the depth of a pixel with the one in the buffer, as [`less`] does. `color` makes a colour of the values
    /// and the depth.
    #[inline(always)]
    pub fn new(depth: &'a mut Frame<M, surface::Rows<Z>>, plane: Plane<(Z::Number, V)>, passes: T, color: F) -> Self {
        let (depths, values) = plane.split();
        Self::of(depth, Rows::new(depths, depths.top()), Rows::new(values, values.top()), passes, color)
    }

    /// Of a triangle with these depths and values at its corners.
    #[inline(always)]
    pub(crate) fn over(
        depth: &'a mut Frame<M, surface::Rows<Z>>,
        facet: &Facet,
        corners: [(Z::Number, V); 3],
        passes: T,
        color: F,
    ) -> Self {
        let depths = Rows::over(facet, corners.each_ref().map(|corner| corner.0));
        Self::of(depth, depths, Rows::over(facet, corners.map(|corner| corner.1)), passes, color)
    }

    #[inline(always)]
    fn of(
        depth: &'a mut Frame<M, surface::Rows<Z>>,
        rows: Rows<Z::Number>,
        values: Rows<V>,
        passes: T,
        color: F,
    ) -> Self {
        let reach = rows.reach().min(values.reach());
        Self { depth, rows, values, reach, passes, writes: true, color }
    }

    /// Without keeping the depths of what it paints: for what is transparent.
    #[must_use]
    pub const fn read_only(mut self) -> Self {
        self.writes = false;
        self
    }
}

impl<M: AsMut<[u8]>, Z: Depth, V: Varying, T: Fn(&Z::Number, &Z::Number) -> bool, F> DepthShade<'_, M, Z, V, T, F> {
    /// Paints pixels of one row that lie in the windows of the surface and of the depths.
    #[inline(always)]
    pub(crate) fn row<S: Surface>(&mut self, on: &mut S, span: ClippedSpan)
    where
        F: FnMut(V, Z::Number) -> Option<S::Color>,
    {
        span.parts(self.reach, |part| self.part(on, part));
    }

    /// Paints pixels for which runs are right.
    #[inline(never)]
    fn part<S: Surface>(&mut self, on: &mut S, part: ClippedSpan)
    where
        F: FnMut(V, Z::Number) -> Option<S::Color>,
    {
        let Self { depth, rows, values, passes, writes, color, .. } = self;
        rows.go_to(part.y());
        test(depth, part, rows.run(part.x0(), part.len()), &*passes, |seen, cells, z| {
            values.go_to(seen.y());
            let at = values.run(seen.x0(), seen.len());
            paint::<S, Z, V>(on, (seen, cells), (z, at), (&*passes, *writes), color);
        });
    }
}

/// Looks at the depths of one row. What is hidden often lies side by side: up to the first pixel that passes, depths are compared
/// and nothing else is computed. `seen` is given what begins there: the pixels, their places, and their depths.
#[inline(always)]
fn test<M: AsMut<[u8]>, Z: Depth>(
    depth: &mut Frame<M, surface::Rows<Z>>,
    span: ClippedSpan,
    mut z: <Z::Number as Varying>::Run,
    passes: &impl Fn(&Z::Number, &Z::Number) -> bool,
    seen: impl FnOnce(ClippedSpan, &mut [Z::Cell], <Z::Number as Varying>::Run),
) {
    let Some(cells) = depth.cells(span) else { return };
    let hidden = cells.iter().take_while(|cell| {
        let is_hidden = !passes(&Z::Number::value(&z), &cell.load());
        if is_hidden {
            Z::Number::step(&mut z);
        }
        is_hidden
    });
    let hidden = hidden.count();
    let (Some(cells), Some(span)) = (cells.get_mut(hidden..), span.without(hidden)) else { return };
    seen(span, cells, z);
}

/// Paints pixels of one row whose depths pass.
#[inline(always)]
fn paint<S: Surface, Z: Depth, V: Varying>(
    on: &mut S,
    (span, cells): (ClippedSpan, &mut [Z::Cell]),
    (mut z, mut at): (<Z::Number as Varying>::Run, V::Run),
    (passes, writes): (&impl Fn(&Z::Number, &Z::Number) -> bool, bool),
    color: &mut impl FnMut(V, Z::Number) -> Option<S::Color>,
) {
    let mut cells = cells.iter_mut();
    on.write_inside(Inside(Said::Span(span)), |_| {
        let number = Z::Number::value(&z);
        let painted = cells.next().filter(|cell| passes(&number, &cell.load())).and_then(|cell| {
            let color = color(V::value(&at), number)?;
            if writes {
                *cell = Z::Cell::store(number);
            }
            Some(color)
        });
        Z::Number::step(&mut z);
        V::step(&mut at);
        painted
    });
}

/// Fills a triangle with colours that a function makes of the values at its corners, where its depths pass a test, and keeps these.
///
/// # Errors
/// If the triangle is too large to be a facet. Then nothing is drawn.
#[inline(always)]
pub(crate) fn fill<S: Surface, M: AsMut<[u8]>, Z: Depth, V: Varying>(
    (on, depth): (&mut S, &mut Frame<M, surface::Rows<Z>>),
    corners: [PointFx; 3],
    values: [(Z::Number, V); 3],
    passes: impl Fn(&Z::Number, &Z::Number) -> bool,
    mut color: impl FnMut(V) -> S::Color,
) -> Result<(), TriangleTooLarge> {
    let small = || SmallFacet::new(&corners);
    let is_done = fill_small((&mut *on, &mut *depth), (corners, small), &values, &passes, |on, rest, values| {
        rest.paint::<S, V>(on, values, &passes, &mut color);
    });
    if !is_done {
        let facet = Facet::of_any_size(corners);
        facet.fits(corners)?;
        fill_any((on, depth), (corners, &facet), values, passes, |values, _| Some(color(values)));
    }
    Ok(())
}

/// The same where the function may answer `None`: then colour and depth of the pixel stay as they are. The triangle is a facet.
#[inline(always)]
pub(crate) fn fill_some<S: Surface, M: AsMut<[u8]>, Z: Depth, V: Varying>(
    (on, depth): (&mut S, &mut Frame<M, surface::Rows<Z>>),
    (corners, facet): ([PointFx; 3], &Facet),
    values: [(Z::Number, V); 3],
    passes: impl Fn(&Z::Number, &Z::Number) -> bool,
    mut color: impl FnMut(V, Z::Number) -> Option<S::Color>,
) {
    let small = || facet.small();
    let is_done = fill_small((&mut *on, &mut *depth), (corners, small), &values, &passes, |on, rest, values| {
        rest.paint_some::<S, V>(on, values, &passes, &mut color);
    });
    if !is_done {
        fill_any((on, depth), (corners, facet), values, passes, color);
    }
}

/// The same for any triangle.
#[inline(always)]
fn fill_any<S: Surface, M: AsMut<[u8]>, Z: Depth, V: Varying>(
    (on, depth): (&mut S, &mut Frame<M, surface::Rows<Z>>),
    (corners, facet): ([PointFx; 3], &Facet),
    values: [(Z::Number, V); 3],
    passes: impl Fn(&Z::Number, &Z::Number) -> bool,
    color: impl FnMut(V, Z::Number) -> Option<S::Color>,
) {
    let window = on.window().intersection(depth.window());
    if window.is_empty() {
        return;
    }
    let mut shade = DepthShade::over(depth, facet, values, passes, color);
    triangle::fill(corners, window, |span: ClippedSpan| shade.row(on, span));
}

/// Calls `paint` with the rows of a triangle from the first one on in which a pixel passes, if there is one, and with the values there.
/// If the triangle is not small, or not tiny in its window, it is not called, and the answer is `false`.
#[inline(always)]
fn fill_small<S: Surface, M: AsMut<[u8]>, Z: Depth, V: Varying>(
    (on, depth): (&mut S, &mut Frame<M, surface::Rows<Z>>),
    (corners, facet): ([PointFx; 3], impl FnOnce() -> SmallFacet),
    corner_values: &[(Z::Number, V); 3],
    passes: &impl Fn(&Z::Number, &Z::Number) -> bool,
    paint: impl FnOnce(&mut S, &mut Rest<'_, Z>, V::Small),
) -> bool {
    if !small::SMALL || !V::Small::EXISTS || !depth.is_aligned() {
        return false;
    }
    let facet = facet();
    if !facet.is_small() {
        return false;
    }
    let window = on.window().intersection(depth.window());
    if window.is_empty() {
        return true;
    }
    let depths = corner_values.each_ref().map(|corner| corner.0);
    let mut spans = TinySpans::new();
    let Some(mut rest) = Rest::new(&mut spans, depth, window, (corners, &facet), depths) else { return false };
    if rest.skip_hidden_rows(passes) {
        return true;
    }
    let Some(mut values) = V::small(&facet, corner_values.each_ref().map(|corner| corner.1)) else { return false };
    values.skip(unsigned(rest.y().wrapping_sub(facet.first().1)));
    paint(on, &mut rest, values);
    true
}

impl<S, M, Z, V, T, F> Paint<S> for DepthShade<'_, M, Z, V, T, F>
where
    S: Surface,
    M: AsMut<[u8]>,
    Z: Depth,
    V: Varying,
    T: Fn(&Z::Number, &Z::Number) -> bool,
    F: FnMut(V, Z::Number) -> Option<S::Color>,
{
    #[inline]
    fn span(&mut self, on: &mut S, span: ClippedSpan) {
        // Where there are no depths, nothing is painted.
        if let Some(span) = span.again(on.window().intersection(self.depth.window())) {
            self.row(on, span);
        }
    }
}
