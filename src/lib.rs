#![doc = include_str!("../README.md")]
#![no_std]
#![allow(clippy::doc_markdown, reason = "names of programs in the tables of the README")]

#[cfg(test)]
extern crate std;

mod canvas;
pub mod eg;
mod error;
pub mod geom;
mod num;
mod octants;
pub mod pixel;
pub mod raster;
mod rect;
mod span;
pub mod surface;
mod target;

pub use canvas::Canvas;
pub use error::{BufferError, CrossingListFull, EdgeTableFull, Error, FlattenError, TriangulateError};
pub use geom::{Angle, Path, PathSegment, PointFx, Viewport};
pub use octants::Octants;
pub use pixel::{buffer_bytes, Index1, Index2, Index4, Index8, Palette, PixelFormat};
pub use raster::{Cap, Dash, EdgeSlot, Ellipse, FillRule, Join, Radii, Sector, Stroke};
pub use rect::Rect;
pub use span::{ClippedSpan, Span, Steps};
pub use surface::{Bitmap, Framebuffer, Surface};
