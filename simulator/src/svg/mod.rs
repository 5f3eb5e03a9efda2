//! Paths as SVG has them, as a scene for framebuffers of any size and depth.
//! ```text
//!   "M4 4h16..."  --Path::svg, Affine-->  Shape --.
//!                                                  >--- draw: any depth, whole or band by band
//!   FILE.svg  ------- File::parse ------>  Shape --'
//! ```
//! * [`File`]: paths, basic shapes, groups, transforms and flat colours of an SVG file.
//! * [`Shape`]: a path with its colours and its stroke.
//! * [`Tone`]: a colour as a pixel of 1, 2, 4, 8, 16, 24 and 32 bits.
//! * [`pack`]: a path in few bytes, for flash.
//! * [`draw`]: shapes, one over the other, and what it took.

mod file;
mod numbers;
mod pack;
mod scene;
mod sheet;
mod tone;

pub use file::File;
pub use pack::pack;
pub use scene::{draw, slots, Drawing, Outline, Screen, Shape};
pub(crate) use tone::luma;
pub use tone::Tone;
