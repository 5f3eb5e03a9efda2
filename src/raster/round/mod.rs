//! Round shapes: ellipses, arcs, rounded rectangles.

pub mod arc;
pub mod chord;
pub mod ellipse;
pub mod gauge;
pub mod rounded;

mod curve;
mod disc;
mod form;
mod outline;
mod ray;
pub(crate) mod smooth;
