//! [`Pattern`] and [`Tiles`]: small pictures that are repeated all over a shape.
//!
//! Where the first one begins is a pixel of the screen. Left at (0, 0), the pattern is fixed to the screen: shapes that touch have
//! one pattern, without a seam, and a band shows what the whole would. Moved [to](Pattern::at) a corner of the shape, it moves as the
//! shape does.
//!
//! With one bit a pixel, patterns are what tells areas apart. The parts of a chart:
//! ```
//! use embedded_graphics_core::pixelcolor::BinaryColor;
//! use embedded_raster::{paint::pattern::{self, Pattern}, raster::rectangle, Canvas, Framebuffer, Rect};
//! let mut ram = [0; 3 * 8];
//! let mut frame = Framebuffer::<BinaryColor>::new(&mut ram, 24, 8)?;
//! for (left, rows) in (0..).step_by(8).zip([pattern::DIAGONAL, pattern::CHECKER, pattern::shade(8)]) {
//!     let paint = Pattern::new(rows, BinaryColor::On, Some(BinaryColor::Off));
//!     frame.paint(paint, |window, brush| rectangle::fill(Rect::new(left, 0, left + 8, 8), window, brush));
//! }
//! assert_eq!(frame.row_bytes(0..1), [0b0001_0001, 0b1010_1010, 0b1000_1000]);
//! # Ok::<(), embedded_raster::Error>(())
//! ```
//!
//! Source: patterns of 8 x 8 pixels are those of `QuickDraw`, Apple, 1984.

use core::fmt;

use embedded_graphics_core::{geometry::Point, pixelcolor::PixelColor};

use super::{dither::Bayer, traits::Paint};
use crate::{
    num::cast::{index, signed, unsigned},
    span::ClippedSpan,
    surface::{Frame, Layout, Surface},
};

/// Lines to the right.
pub const HORIZONTAL: [u8; 8] = [0xff, 0, 0, 0, 0xff, 0, 0, 0];
/// Lines downwards.
pub const VERTICAL: [u8; 8] = [0x88; 8];
/// Lines from the bottom left to the top right.
pub const DIAGONAL: [u8; 8] = [0x11, 0x22, 0x44, 0x88, 0x11, 0x22, 0x44, 0x88];
/// Lines from the top left to the bottom right.
pub const BACK_DIAGONAL: [u8; 8] = [0x88, 0x44, 0x22, 0x11, 0x88, 0x44, 0x22, 0x11];
/// Lines to the right and downwards.
pub const GRID: [u8; 8] = [0xff, 0x88, 0x88, 0x88, 0xff, 0x88, 0x88, 0x88];
/// Lines both ways between the corners.
pub const DIAGONAL_GRID: [u8; 8] = [0x82, 0x44, 0x28, 0x10, 0x28, 0x44, 0x82, 0x01];
/// Every other pixel.
pub const CHECKER: [u8; 8] = [0xaa, 0x55, 0xaa, 0x55, 0xaa, 0x55, 0xaa, 0x55];
/// Points, in rows that are moved against each other.
pub const DOTS: [u8; 8] = [0x88, 0, 0x22, 0, 0x88, 0, 0x22, 0];
/// A wall.
pub const BRICKS: [u8; 8] = [0xff, 0x80, 0x80, 0x80, 0xff, 0x08, 0x08, 0x08];

/// A pattern of which so many pixels of 64 are set, evenly spread: a grey out of two colours. From 0 to 64; more are all.
/// ```
/// use embedded_raster::paint::pattern;
/// let set = |of_64| pattern::shade(of_64).map(u8::count_ones).iter().sum::<u32>();
/// assert!((0..=64).all(|n| set(n) == n));
/// ```
pub fn shade(of_64: u32) -> [u8; 8] {
    let mut rows = [0; 8];
    // Counted by hand: an open range checks for its end.
    let mut y = 0_i32;
    for row in &mut rows {
        for x in 0..8 {
            let is_set = Bayer::<8>::threshold(Point::new(x, y)) < of_64;
            *row = *row << 1 | u8::from(is_set);
        }
        y = y.wrapping_add(1);
    }
    rows
}

/// Two colours in blocks of 8 x 8 pixels, or one colour and what is there.
///
/// A row of a block is a byte, with its leftmost pixel in the most significant bit.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Pattern<C> {
    rows: [u8; 8],
    on: C,
    off: Option<C>,
    origin: Point,
}

impl<C> Pattern<C> {
    /// Paints pixels whose bit is set in the colour `on`, and all others in `off`, or not at all if that is `None`. The first block
    /// begins at pixel (0, 0).
    #[inline]
    pub const fn new(rows: [u8; 8], on: C, off: Option<C>) -> Self {
        Self { rows, on, off, origin: Point::new(0, 0) }
    }

    /// The same with the top left pixel of a block at a place.
    #[must_use]
    #[inline]
    pub fn at(self, origin: impl Into<Point>) -> Self {
        Self { origin: origin.into(), ..self }
    }
}

impl<S: Surface> Paint<S> for Pattern<S::Color> {
    // Not inlined into the loops of shapes: they have no registers to spare.
    #[inline(never)]
    fn span(&mut self, on: &mut S, span: ClippedSpan) {
        let (right, down) = (span.x0().wrapping_sub(self.origin.x), span.y().wrapping_sub(self.origin.y));
        let mut row = self.rows[index(down & 7)].rotate_left(unsigned(right) & 7);
        let mut next = || {
            let is_set = row & 0x80 != 0;
            row = row.rotate_left(1);
            is_set
        };
        let color = self.on;
        match self.off {
            Some(off) => on.write_span(span, |_| if next() { color } else { off }),
            None => on.write_some(span, |_| next().then_some(color)),
        }
    }
}

/// A picture, repeated to the right and downwards: `color` makes colours of its pixels, or `None` to leave what is there.
/// ```
/// use embedded_graphics_core::{geometry::Point, pixelcolor::{Rgb565, Rgb888}};
/// use embedded_raster::{
///     buffer_bytes, paint::Tiles, pixel::EGA, raster::ellipse, Bitmap, Canvas, Ellipse, Framebuffer, Index2, Palette, Rect,
/// };
/// // Two pixels of two bits, through a palette.
/// let tile = Bitmap::<Index2>::new(&[0b01_10_00_00], 2, 1)?;
/// let palette: Palette<Rgb565, 16> = EGA.map(Rgb565::from);
/// let mut ram = [0; buffer_bytes::<Rgb565>(6, 4)];
/// let mut frame = Framebuffer::<Rgb565>::new(&mut ram, 6, 4)?;
/// let paint = Tiles::new(&tile, |index: Index2| palette.get(index.into()));
/// frame.paint(paint, |window, brush| ellipse::fill(Ellipse::in_box(Rect::new(0, 0, 6, 4)), window, brush));
/// assert_eq!(frame.get(Point::new(4, 1)), palette.get(1));
/// assert_eq!(frame.get(Point::new(5, 1)), palette.get(2));
/// # Ok::<(), embedded_raster::Error>(())
/// ```
pub struct Tiles<'a, L, F> {
    picture: Frame<&'a [u8], L>,
    origin: Point,
    color: F,
}

/// Prints the picture and its place.
impl<L, F> fmt::Debug for Tiles<'_, L, F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Tiles").field("picture", &self.picture).field("origin", &self.origin).finish_non_exhaustive()
    }
}

impl<'a, L: Layout, F> Tiles<'a, L, F> {
    /// Of what the window of a picture shows, with the first tile at pixel (0, 0). A picture without pixels paints nothing.
    #[inline]
    pub fn new<M: AsRef<[u8]>>(picture: &'a Frame<M, L>, color: F) -> Self {
        Self { picture: picture.as_bitmap(), origin: Point::new(0, 0), color }
    }

    /// The same with the top left pixel of a tile at a place.
    #[must_use]
    #[inline]
    pub fn at(self, origin: impl Into<Point>) -> Self {
        Self { origin: origin.into(), ..self }
    }
}

/// The column or row of a tile that lies at a pixel; `None` if there are none.
#[inline]
fn within(at: i32, origin: i32, size: u32) -> Option<i32> {
    // Sizes are below 2^16. Each rest by itself, as the difference may not be a number of 32 bits.
    let size = signed(size);
    let (at, origin) = (at.checked_rem_euclid(size)?, origin.checked_rem_euclid(size)?);
    let within = at.wrapping_sub(origin);
    Some(if within < 0 { within.wrapping_add(size) } else { within })
}

impl<S, L, C, F> Paint<S> for Tiles<'_, L, F>
where
    S: Surface<Color = C>,
    L: Layout,
    C: PixelColor,
    F: FnMut(L::Color) -> Option<C>,
{
    #[inline(never)]
    fn span(&mut self, on: &mut S, span: ClippedSpan) {
        let window = self.picture.window();
        let column = within(span.x0(), self.origin.x, window.width());
        let row = within(span.y(), self.origin.y, window.height());
        let (Some(column), Some(row)) = (column, row) else { return };
        let (mut x, y) = (window.x0.wrapping_add(column), window.y0.wrapping_add(row));
        let (picture, color) = (&self.picture, &mut self.color);
        on.write_some(span, |_| {
            let texel = picture.at(x, y);
            x = x.wrapping_add(1);
            if x == window.x1 {
                x = window.x0;
            }
            color(texel)
        });
    }
}
