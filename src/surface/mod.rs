//! Spans to bytes: what can be drawn on.
//!
//! A [`Surface`] is anything that spans can be painted on. Most are a [`Frame`]: memory that the caller owns, seen through a
//! [`Layout`], which says where a pixel is. [`Framebuffer`] is the short name of the usual one, rows of pixels.
//! [`Readable`] surfaces can be read as well, which flood fills and scrolling need. A [`Counter`] paints nothing and counts. A
//! [`Turned`] one is another surface, turned by quarters or in a mirror.
//!
//! A wrapper around a surface can be a surface too, through which everything goes that is drawn. A [`Recorder`] is one: it tells
//! where something is drawn, and [`Damage`] keeps that as a short list of rectangles. A [`Stencil`] clips to a shape.

mod accumulator;
mod blit;
mod counter;
mod damage;
mod depth;
mod draw;
mod frame;
mod layout;
mod levels;
mod owned;
mod packed12;
mod pages;
mod planes;
mod recorder;
mod rows;
mod sheet;
mod stencil;
mod strip;
pub mod texture;
mod traits;
mod turned;

pub use self::{
    accumulator::{Accumulator, Sum},
    counter::Counter,
    damage::Damage,
    depth::{Depth, DepthBuffer},
    frame::Frame,
    layout::{Grid, Layout, Place},
    owned::Owned,
    packed12::Packed12,
    pages::{paged_bytes, Paged, Pages},
    planes::Planes,
    recorder::Recorder,
    rows::{Bitmap, Framebuffer, Rows},
    sheet::Sheet,
    stencil::Stencil,
    strip::{Ready, Strip},
    texture::Texture,
    traits::{Readable, Surface},
    turned::{Turn, Turned},
};
pub(crate) use self::{
    depth::DepthCell,
    levels::CHUNK,
    traits::{blit_mapped, blit_mixed, Inside, InsideRows, Said},
};
