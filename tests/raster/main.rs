//! Geometry to spans: every shape against its twin, pixel by pixel.

mod arc;
mod coverage;
mod drop_out;
mod ellipse;
mod exactly_once;
mod flood;
mod icons;
mod line;
mod line_fx;
mod mapped;
mod offsets;
mod order;
mod path;
mod polygon;
mod soft_shapes;
mod stroke;
mod triangle;
mod true_area;
mod widths;
