//! Geometry to spans.
//!
//! **Fills.** A pixel belongs to a shape when its centre lies inside. A centre exactly on an edge counts as if it stood a
//! little to the right and, much less, down: at (+e, +e^2). For triangles that is the *top-left rule*; for polygons it
//! reads: an edge from `y0` to `y1` crosses the rows with `y0 <= cy < y1`, and of a row the pixels with `x0 <= cx < x1`
//! are drawn. So shapes that share an edge draw every pixel along it exactly once.
//!
//! **Fill rules.** Walking along a row, [`NonZero`](crate::FillRule::NonZero) adds 1 at an edge that goes down, subtracts 1 at
//! one that goes up, and draws where the sum is not 0; [`EvenOdd`](crate::FillRule::EvenOdd) draws where the count of edges is odd.
//!
//! **Soft rims.** [`coverage`] has the same shapes with how much of each pixel they cover.
//!
//! **Lines** join two *pixels* and draw both: see [`mod@line`]. Between *places*, to 1/256 pixel: [`line_fx`].
//!
//! Every function takes its shape, then options, then scratch memory, then the window that may be drawn, and a
//! [`Sink`](crate::Sink), which receives what lies in the window, and says in which order.
//!
//! **Work** depends on the window, not on the size of the coordinates, and no coordinate is moved into the window to achieve that.
//! Each module says how much it is; tests count it. Besides the pixels and the length of what is passed, the rows and columns of
//! the window that a shape's box shares may count: a shape is followed over these rows, even if it lies between the pixels there.
//!
//! Functions named `extent` return a box that encloses a shape, without drawing it.

pub mod coverage;
pub mod flood;
pub mod line;
pub mod line_fx;
pub mod mapped;
pub mod outline;
pub mod polygon;
pub mod rectangle;
pub mod stroke;
pub mod triangle;

mod bands;
mod round;
mod slope;
mod sum;
#[cfg(test)]
mod work;

pub use self::round::{arc, chord, ellipse, gauge, rounded};
