//! [`Dashing`]: how a contour becomes pieces, in one way for solid strokes and in another for dashes.

use super::{
    pen::{Pen, Piece},
    sides::{Outline, Pieces, Sides},
};

/// What cuts a stroke into dashes, or leaves it alone: `()` or a [`Dash`](super::Dash).
pub trait Dashing: Cut {}

impl<D: Cut> Dashing for D {}

/// What [`Dashing`] does, where users of the crate do not see it.
pub trait Cut: Copy {
    /// What is the same for all contours.
    fn ready(self, width: u32) -> impl Ready;
}

/// Ready to cut.
pub trait Ready: Copy {
    /// The pieces of a contour.
    fn pieces<O: Outline>(self, outline: O, pen: Pen) -> impl Iterator<Item = Piece> + Clone;
}

/// No dashes.
impl Cut for () {
    #[inline]
    fn ready(self, _: u32) -> impl Ready {}
}

impl Ready for () {
    #[inline]
    fn pieces<O: Outline>(self, outline: O, pen: Pen) -> impl Iterator<Item = Piece> + Clone {
        Pieces::new(Sides::new(outline, pen.sight), pen)
    }
}
