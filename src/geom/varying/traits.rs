//! [`Varying`]: what changes over a triangle from corner to corner.

use core::fmt::Debug;

use crate::geom::{
    facet::{Facet, SmallFacet},
    small::Small,
};

/// What changes over a triangle: a number, a colour, or several of them in an array or a tuple.
///
/// Numbers are taken by their bits: of an `I16F16` the nearest one is the nearest multiple of 2^-16.
/// ```
/// use embedded_raster::{geom::{Facet, Plane}, PointFx};
/// let facet = Facet::new([PointFx::px(0, 0), PointFx::px(4, 0), PointFx::px(0, 4)])?;
/// let plane = Plane::new(&facet, [(0_u8, 1000_u16), (80, 1000), (0, 1000)]);
/// assert_eq!([0, 1, 2].map(|x| plane.at(x, 0)), [(10, 1000), (30, 1000), (50, 1000)]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
pub trait Varying: Copy {
    /// How it changes over a triangle.
    type Slopes: Copy + Debug;
    /// Its value in the first column of a row.
    type Row: Copy + Debug;
    /// Its value at one pixel, with what it gains from each to the next.
    type Run: Copy + Debug;
    /// How it changes over a small triangle; `NoSmall` if that has no form of its own.
    type Small: Small<Self::Run>;

    /// How it changes over a triangle where it has these values at the corners.
    fn slopes(facet: &Facet, corners: [Self; 3]) -> Self::Slopes;

    /// The same at the first pixel of the box of a small triangle, in the form for that, if there is one.
    #[inline(always)]
    fn small(facet: &SmallFacet, corners: [Self; 3]) -> Option<Self::Small> {
        let _ = (facet, corners);
        None
    }

    /// A row so many pixels below the first row of the triangle's box.
    fn row(slopes: &Self::Slopes, down: u32) -> Self::Row;

    /// To the row below.
    fn below(slopes: &Self::Slopes, row: &mut Self::Row);

    /// A pixel of a row so many pixels to the right of the first column of the triangle's box.
    fn run(slopes: &Self::Slopes, row: &Self::Row, right: u32) -> Self::Run;

    /// [`run`](Self::run), where so many pixels of the row are asked for from there on: at least 1. The run is right for
    /// [`reach`](Self::reach) of them.
    #[inline(always)]
    fn stretch(slopes: &Self::Slopes, row: &Self::Row, right: u32, pixels: u32) -> Self::Run {
        let _ = pixels;
        Self::run(slopes, row, right)
    }

    /// Takes a run on that has gone through all the pixels for which it is right, where so many more are asked for.
    #[inline(always)]
    fn go_on(slopes: &Self::Slopes, run: &mut Self::Run, (right, down): (u32, u32), pixels: u32) {
        *run = Self::stretch(slopes, &Self::row(slopes, down), right, pixels);
    }

    /// The value.
    fn value(run: &Self::Run) -> Self;

    /// To the next pixel on the right.
    fn step(run: &mut Self::Run);

    /// For how many pixels a run is right, at least 1. Then another has to be made.
    #[inline(always)]
    fn reach(slopes: &Self::Slopes) -> u32 {
        let _ = slopes;
        u32::MAX
    }
}
