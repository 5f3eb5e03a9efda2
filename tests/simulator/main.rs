//! What the simulator brings along: the paint program and the world.

mod paint;
mod world;
