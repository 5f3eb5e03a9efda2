//! The political map of the world, as a scene for framebuffers of any size and depth.
//! ```text
//!   text --parse--> Map --project--> World --draw--> any surface
//!                   |                  |
//!                   colors, borders    pixels of each country
//! ```
//! * [`Map`]: countries and their rings, in hundredths of a degree.
//! * [`Projection`]: a place on the globe to a [`PointFx`](embedded_raster::PointFx) on the screen, in integers.
//! * [`World`]: the map projected, and how to [draw](World::draw) it with this library.
//! * [`Depth`]: what each [`Part`] of it is painted with at 1, 2, 4, 8, 16, 24 and 32 bits per pixel.

mod depth;
mod map;
mod projection;
mod scene;

pub use depth::{Depth, Part, PALETTE};
pub use map::{Border, Country, Map, ParseError, Place};
pub use projection::{Projection, Screen};
pub use scene::{Layer, World};
