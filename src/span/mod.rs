//! What shapes and surfaces share: what a shape may say, and to whom.
//!
//! A shape knows nothing of pixels in memory and a surface nothing of shapes. Between them stands a [`Sink`]: a shape tells
//! it which pixels it has, as
//! - [spans](ClippedSpan), runs of pixels in one row,
//! - [areas](Rect), the same run in many rows,
//! - [`Steps`], the pixels of a line one pixel wide,
//! - [`Octants`], the outline of a circle,
//! - [coverage](Sink::coverage), how much of each pixel of a run is covered, and
//! - [`SoftRow`], a run between two rims that are covered in part.
//!
//! A [`Span`] may lie anywhere. Clipped once against the window of a surface it becomes a [`ClippedSpan`]. Its fields cannot be
//! set from outside of the crate, so a shape clips once. Nothing keeps a program from clipping against another rectangle and
//! calling a surface by itself; there a frame clips again.

mod octants;
mod rect;
mod row;
mod sink;
mod steps;

pub use self::{
    octants::Octants,
    rect::Rect,
    row::{ClippedSpan, SoftRow, Span},
    sink::Sink,
    steps::Steps,
};
