//! Round shapes: ellipses, arcs, rounded rectangles.

pub mod arc;
pub mod ellipse;
pub mod rounded;

mod curve;
mod disc;
mod form;
mod outline;
mod smooth;

pub(crate) use self::smooth::Smooth;
