//! Shapes as numbers, against their rules in wide integers.

mod affine;
mod arc;
mod light;
mod matrix;
mod packed;
mod patch;
mod perspective;
mod space;
mod svg;
mod tools;
mod triangulate;
mod values;
mod varying;
