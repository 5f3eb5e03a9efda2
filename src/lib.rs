#![doc = include_str!("tour.md")]
#![no_std]
#![allow(clippy::doc_markdown, reason = "names of displays and chips on the page of the crate")]

#[cfg(test)]
extern crate std;

mod canvas;
pub mod eg;
mod error;
pub mod geom;
mod num;
pub mod paint;
pub mod pipeline;
pub mod pixel;
pub mod present;
pub mod raster;
mod span;
pub mod surface;
pub mod text;
mod tune;

pub use canvas::{Antialias, Canvas, Pictures};
pub use error::{
    BufferError, CrossingListFull, EdgeTableFull, Error, FlattenError, FontError, MapTooLarge, PackedError,
    PackedFault, PictureTooLarge, SvgError, SvgExpected, TriangleTooLarge, TriangulateError,
};
pub use geom::{
    fill_rule::FillRule,
    px,
    space::{Mat4, Patch, Vec3, Vec4},
    Affine, Angle, PackedPath, Path, PathSegment, PointFx, Svg, Viewport,
};
pub use paint::{Paint, Solid};
pub use pixel::{buffer_bytes, Index1, Index2, Index4, Index8, Palette, PixelFormat};
pub use raster::{
    arc::Sector,
    coverage::CoverageSlot,
    ellipse::Ellipse,
    polygon::EdgeSlot,
    rounded::{Align, Radii},
    stroke::{Cap, Dash, Join, Stroke},
};
pub use span::{ClippedSpan, Octants, Rect, Sink, SoftRow, Span, Steps};
pub use surface::{Bitmap, Frame, Framebuffer, Layout, Readable, Surface};

/// The crate whose points, sizes, rectangles and colours this one speaks, in the version that it speaks.
pub use embedded_graphics_core;
/// The crate whose `I24F8` are places and widths, in the version that fits: a program that takes it from here need not name one.
/// Whole numbers become an `I24F8` by [`px`].
pub use fixed;
