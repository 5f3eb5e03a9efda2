//! Shapes as numbers, against their rules in wide integers.

mod tools;
mod triangulate;
mod values;
mod varying;
