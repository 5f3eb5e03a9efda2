//! What the simulator brings along: the paint program, the teapot, and the world.

mod clock;
mod gauge;
mod paint;
#[path = "../golden/compare.rs"]
mod pictures;
mod scanout;
mod teapot;
mod world;
