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
//!
//! A [`Pattern`] tells areas apart where there are few colours, [`Tiles`] repeat a picture, and a [`RasterOp`] changes the bits of what
//! is there. [`Linear`] and [`Radial`] are gradients for any shape. What changes from corner to corner of a triangle is a
//! [`Varying`](crate::geom::Varying): [`Canvas::shade_triangle_fx`](crate::Canvas::shade_triangle_fx) draws it, by a [`Shade`].
//! ```
//! use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
//! use embedded_raster::{
//!     buffer_bytes, paint::{Linear, Outside, Radial}, pixel::Channels, px, raster::{ellipse, rectangle}, Canvas, Ellipse,
//!     Framebuffer, PointFx, Rect,
//! };
//!
//! let mut ram = [0; buffer_bytes::<Rgb565>(144, 48)];
//! let mut frame = Framebuffer::<Rgb565>::new(&mut ram, 144, 48)?;
//! let mix = |level, _| Rgb565::between([Rgb565::YELLOW, Rgb565::BLUE], level);
//!
//! let sky = Linear::new([PointFx::px(4, 4), PointFx::px(44, 44)], Outside::Clamp, mix);
//! frame.paint(sky, |window, brush| rectangle::fill(Rect::new(4, 4, 44, 44), window, brush));
//!
//! let ball = Radial::new(PointFx::px(64, 16), px(32), Outside::Clamp, mix);
//! let disc = Ellipse::in_box(Rect::new(52, 4, 92, 44));
//! frame.paint(ball, |window, brush| ellipse::fill(disc, window, brush));
//!
//! let corners = [(100, 44), (120, 4), (140, 44)].map(|(x, y)| PointFx::px(x, y));
//! frame.shade_triangle_fx(corners, [Rgb565::RED, Rgb565::GREEN, Rgb565::BLUE], |color| color)?;
//! # Ok::<(), embedded_raster::Error>(())
//! ```
//!
//! ![A square from yellow to blue, a ball with a light on it, and a triangle from red over green to blue][gradients]
#![doc = include_str!("pictures.md")]

mod add;
pub mod along;
mod brush;
pub mod colors;
mod cover;
pub mod depth;
mod dither;
mod gamma;
pub mod gradient;
mod masked;
pub mod pattern;
mod ramp;
mod raster_op;
mod shade;
mod solid;
mod traits;

pub use self::{
    add::Add,
    brush::Brush,
    cover::{Alpha, Cover, Over},
    depth::DepthShade,
    dither::Bayer,
    gamma::{CoverGamma, Gamma},
    gradient::{Linear, Outside, Radial},
    masked::Masked,
    pattern::{Pattern, Tiles},
    ramp::{CoverIndex, Dithered, Ramp},
    raster_op::RasterOp,
    shade::{Shade, ShadeSome},
    solid::Solid,
    traits::Paint,
};
