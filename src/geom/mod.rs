//! Shapes as numbers: places, angles and paths, and what can be computed from them without drawing.
//!
//! ```text
//!      0   1   2   3   x        pixel (x, y) is the square [x, x+1) x [y, y+1)
//!    0 +---+---+---+---          its centre is (x + 1/2, y + 1/2)
//!      | . | . | . |             y points down
//!    1 +---+---+---+---
//!      | . | . | o |   a Point names a square: o is Point::new(2, 1)
//!    2 +---*---+---+---
//!      | . | . | . |   a PointFx names a place: * is PointFx::px(1, 2), a corner of four squares
//!    y
//! ```
//! To make a place of a pixel is to take its centre: `PointFx::from(Point::new(2, 1))` is the middle of the square o.

pub mod affine;
pub mod arc;
pub mod clip;
pub mod corners;
pub mod delaunay;
pub mod exact;
pub mod facet;
pub mod flatten;
pub mod packed;
pub mod perspective;
pub mod polygon;
pub mod small;
pub mod space;
pub mod svg;
pub mod triangulate;
pub mod varying;

mod angle;
pub(crate) mod fill_rule;
mod mix;
mod outlines;
mod path;
mod point;
mod view;
mod viewport;

pub use affine::Affine;
pub use angle::Angle;
pub(crate) use arc::on_ellipse;
pub use arc::{Arc, Curves};
pub use corners::RoundCorners;
pub use facet::{Barycentric, Facet, SmallFacet};
pub use flatten::{Contours, Segments};
pub use mix::{At, Mix};
pub use outlines::Outlines;
pub use packed::PackedPath;
pub use path::{Path, PathSegment};
pub use perspective::{Perspective, Runs};
pub(crate) use point::bits;
pub use point::{px, PointFx};
pub use svg::Svg;
pub use varying::{Fast, Plane, Varying};
pub(crate) use view::View;
pub use viewport::Viewport;
