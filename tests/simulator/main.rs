//! What the simulator brings along: the paint program, the teapot, and the world.

mod paint;
mod teapot;
mod world;
