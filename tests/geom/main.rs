//! Shapes as numbers, against their rules in wide integers.

mod light;
mod matrix;
mod patch;
mod perspective;
mod space;
mod tools;
mod triangulate;
mod values;
mod varying;
