//! What gives the pixels of a shape their colours.
//!
//! A shape names pixels, and a [`Paint`] says what happens to them on a surface. A paint and a surface together are a [`Brush`],
//! which receives a shape; [`Canvas::paint`](crate::Canvas::paint) makes one. [`Solid`] paints in one colour, and most programs
//! need no other paint.
//! ```
//! use embedded_graphics_core::pixelcolor::{Gray8, GrayColor};
//! use embedded_raster::{raster::ellipse, Canvas, ClippedSpan, Ellipse, Framebuffer, Paint, Readable, Rect, Surface};
//!
//! /// Turns the picture under a shape into its negative.
//! struct Negative;
//!
//! impl<S: Readable<Color = Gray8>> Paint<S> for Negative {
//!     fn span(&mut self, on: &mut S, span: ClippedSpan) {
//!         on.edit_span(span, |_, old| Gray8::new(!old.luma()));
//!     }
//! }
//!
//! let mut ram = [1; 5 * 4];
//! let mut frame = Framebuffer::<Gray8>::new(&mut ram, 5, 4)?;
//! let disc = Ellipse::in_box(Rect::new(0, 0, 5, 4));
//! frame.paint(Negative, |window, brush| ellipse::fill(disc, window, brush));
//! assert_eq!(ram[..10], [1, 254, 254, 254, 1, 254, 254, 254, 254, 254]);
//! # Ok::<(), embedded_raster::Error>(())
//! ```

mod brush;
pub mod colors;
pub mod depth;
mod dither;
pub mod gradient;
mod shade;
mod solid;
mod traits;

pub use self::{
    brush::Brush,
    depth::DepthShade,
    dither::Bayer,
    gradient::{Linear, Outside, Radial},
    shade::{Shade, ShadeSome},
    solid::Solid,
    traits::Paint,
};
