//! One colour to bits.
//!
//! A [`PixelFormat`] says how many bits a pixel takes in memory and how a colour becomes those bits. Every
//! embedded-graphics colour that has raw data is one, stored the usual way; two wrappers store it in the other order:
//!
//! | bits | formats | memory |
//! |---|---|---|
//! | 1 | [`Index1`], `BinaryColor` | leftmost pixel in the most significant bit; [`Lsb0<C>`](Lsb0) in the least |
//! | 2 | [`Index2`], `Gray2` | the same |
//! | 4 | [`Index4`], `Gray4` | the same |
//! | 8 | [`Index8`], `Gray8`, [`Rgb332`] | a byte |
//! | 16 | [`Rgb444`], `Rgb555`, `Bgr555`, `Rgb565`, `Bgr565` | little-endian; [`Be<C>`](Be) big-endian |
//! | 24 | `Rgb666`, `Bgr666`, `Rgb888`, `Bgr888` | little-endian: of `Rgb888` blue comes first; [`Be<C>`](Be) big-endian |
//! | 16, 32 | [`Depth16`], [`Depth32`], [`Id16`], [`Id32`] | no colours: depths, and numbers of triangles |
//! | 32 | [`Xrgb8888`] | little-endian: blue, green, red, unused; [`Be<C>`](Be) big-endian |
//! | 32 | [`Argb8888`] | pictures with an alpha: blue, green, red, alpha; [`Be<C>`](Be) big-endian |
//!
//! This is the order of pixels within a row. Where rows lie is the business of a [`Layout`](crate::Layout): in vertical pages,
//! [`Pages`](crate::surface::Pages), a byte holds eight rows.
//!
//! A format of your own is a colour type of your own: implement `PixelColor` for it, and conversions from and to its raw data.

mod argb;
mod channels;
mod color;
mod cube;
pub mod diffusion;
mod format;
mod levels;
mod palette;
pub(crate) mod rows;
mod tables;

pub use self::{
    argb::Argb8888,
    channels::Channels,
    color::{Depth16, Depth32, Id16, Id32, Index1, Index2, Index4, Index8, Rgb332, Rgb444, Xrgb8888},
    cube::ColorCube,
    diffusion::{Atkinson, FloydSteinberg},
    format::{buffer_bytes, row_bytes, Be, Lsb0, PixelFormat},
    palette::Palette,
    tables::{EGA, EPAPER_4, EPAPER_7, EPAPER_RED, EPAPER_YELLOW},
};
