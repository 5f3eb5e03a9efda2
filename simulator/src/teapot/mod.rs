//! A body in space, such as the teapot, as a scene for framebuffers of any size and depth.
//! ```text
//!   patches --tessellate--.
//!                          >--- Mesh --- draw: Camera, View ---> any depth, whole or band by band
//!   OBJ file --triangulate-'
//! ```
//! * [`Patches`]: Bézier patches of a text, such as the 32 of M. Newell's teapot, cut into triangles as fine as asked for.
//! * [`Mesh`]: triangles, also of an [OBJ file](Mesh::parse_obj). Each is centred and scaled, so that its size does not matter.
//! * [`Camera`]: how the body is turned, and how far away it is.
//! * [`View`]: what is shown of it: its shape, or what the stages of the pipeline know of each pixel.
//! * [`Ink`]: how colours become pixels of 1, 2, 4, 8, 16, 24 and 32 bits; up to 4 bits dithered.
//! * [`draw`]: all of it together.

mod ink;
mod mesh;
mod obj;
mod patches;
mod scene;
mod view;

pub use ink::{Ink, Inks};
pub use mesh::{Corner, Mesh};
pub use patches::Patches;
pub use scene::{draw, draw_as, Camera, Drawing};
pub use view::View;

pub use crate::world::ParseError;
