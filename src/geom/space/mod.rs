//! Places and directions in space: vectors, and what is computed from them.
//!
//! ```text
//!         y
//!         |              right-handed: x to the right, y up, z towards the viewer.
//!         |              A rotation by a positive angle is counter-clockwise as seen from the tip of its axis;
//!         +------ x      so is a triangle whose normal points to the viewer.
//!        /
//!       z
//! ```
//! Numbers are [`I16F16`](fixed::types::I16F16): 1 is 65,536 units, and "ulp" on these pages is one unit, `2^-16`. Functions
//! take any bits. What is beyond the range stops at its end; nothing wraps around, and nothing panics.
//!
//! | what | where | error of a coordinate |
//! |---|---|---|
//! | quotients, roots, sine and cosine | [`number`] | 0.5 to 0.52 ulp |
//! | sums, products, dot and cross products, lengths | [`Vec3`], [`Vec4`] | 0.5 ulp: rounded once, from the exact sum |
//! | directions of length 1 | [`Vec3::normalize`] | 0.501 ulp |
//! | motions | [`Mat4::translate`], [`Mat4::scale`], [`Mat4::rotate`] | exact, exact, 0.501 ulp |
//! | cameras | [`Mat4::look_at`], [`Mat4::perspective`], [`Mat4::frustum`], [`Mat4::orthographic`] | half an ulp and a little more |
//! | surfaces | [`patch`] | 0.5 ulp, at every level |
//! | brightness | [`light`] | 0.5 ulp; powers 0.002 |
//! | a place in clip coordinates | [`Mat4::transform_point`] | 0.5 ulp |

pub mod light;
pub mod number;
pub mod patch;

mod matrix;
mod vector;

pub use matrix::Mat4;
pub use patch::Patch;
pub use vector::{Vec3, Vec4};
