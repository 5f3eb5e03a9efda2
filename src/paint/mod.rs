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
//!
//! A paint behind a mask is clipped to a shape, or faded by one: see [`Masked`]. Any frame is a mask, drawn by whatever draws.
//! ```
//! use embedded_graphics_core::pixelcolor::{BinaryColor, Gray8, GrayColor, Rgb565, RgbColor};
//! use embedded_raster::{
//!     buffer_bytes, paint::{Cover, Linear, Masked, Outside}, raster::{coverage, rectangle}, px, Antialias, Canvas, CoverageSlot,
//!     Ellipse, FillRule, Framebuffer, PointFx, Rect,
//! };
//!
//! let (mut bits, mut shades) = ([0; buffer_bytes::<BinaryColor>(144, 48)], [0; 144 * 48]);
//! let (mut table, mut cells) = ([CoverageSlot::EMPTY; 16], [0; coverage::cells(144)]);
//! let disc = |x| Ellipse::circle(PointFx::px(x, 24), px(21));
//! let mut hard = Framebuffer::<BinaryColor>::new(&mut bits, 144, 48)?;
//! hard.fill_ellipse_fx(disc(24), BinaryColor::On);
//! let mut soft = Framebuffer::<Gray8>::new(&mut shades, 144, 48)?;
//! soft.fill_ellipse_aa(disc(72), Cover(Gray8::WHITE));
//! let fade = Linear::new([PointFx::px(99, 0), PointFx::px(141, 0)], Outside::Clamp, |level, _| Gray8::new(level));
//! soft.paint(fade, |window, brush| rectangle::fill(Rect::new(99, 3, 141, 45), window, brush));
//!
//! let mut ram = [0; buffer_bytes::<Rgb565>(144, 48)];
//! let mut frame = Framebuffer::<Rgb565>::new(&mut ram, 144, 48)?;
//! for x in (-48..144).step_by(12) {
//!     let stripe = [(x, 48), (x + 48, 0), (x + 54, 0), (x + 6, 48)].map(|(x, y)| PointFx::px(x, y));
//!     let (rule, yellow) = (FillRule::NonZero, Cover(Rgb565::YELLOW));
//!     frame.fill_polygon_aa(&stripe, rule, &mut table, &mut cells, Masked::new(hard.as_bitmap(), yellow))?;
//!     frame.fill_polygon_aa(&stripe, rule, &mut table, &mut cells, Masked::new(soft.as_bitmap(), yellow))?;
//! }
//! # Ok::<(), embedded_raster::Error>(())
//! ```
//!
//! ![Yellow stripes in a disc with hard rims, in one with soft rims, and in a box where they fade in from the left][masks]
//!
//! Shapes side by side, as the countries of a map, leave no seams if they are [added](Add) up before they are seen: see
//! [`Accumulator`](crate::surface::Accumulator).
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
pub(crate) mod shade;
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
