//! [`Dashing`]: how a contour becomes the border of a stroke, in one way for solid strokes and in another for dashes.

use super::{
    border::Border,
    pen::Pen,
    sides::{follow, Whole},
};
use crate::geom::PointFx;

/// What cuts a stroke into dashes, or leaves it alone: `()` or a [`Dash`](super::Dash).
pub trait Dashing: Cut {}

impl<D: Cut> Dashing for D {}

/// What [`Dashing`] does, where users of the crate do not see it.
pub trait Cut: Copy {
    /// Whether there are no dashes at all.
    const IS_SOLID: bool = false;

    /// The border of contours, line by line; they may be `CURVED`.
    fn border<O: Whole, const CURVED: bool>(
        self,
        contours: impl Iterator<Item = O>,
        pen: &Pen,
        each: &mut dyn FnMut(PointFx, PointFx),
    );
}

/// No dashes.
impl Cut for () {
    const IS_SOLID: bool = true;

    #[inline]
    #[expect(clippy::while_let_on_iterator, reason = "a `for` loop moves each outline, which may have many words")]
    fn border<O: Whole, const CURVED: bool>(
        self,
        mut contours: impl Iterator<Item = O>,
        pen: &Pen,
        each: &mut dyn FnMut(PointFx, PointFx),
    ) {
        let mut border = Border::<CURVED>::new(pen, each);
        while let Some(ref mut outline) = contours.next() {
            follow(outline, &pen.sight, pen.width, &mut border);
        }
    }
}
