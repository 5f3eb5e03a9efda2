//! [`Texture`]: a picture as a function of a place in it.
//!
//! A *texel* is a pixel of the picture. Places in it are in texels: texel (i, j) is the square `i..i+1` by `j..j+1`, and its centre is
//! at (i + 1/2, j + 1/2), as with pixels of a screen. Places are given to 2^-16 texel, and all bits are places.
//!
//! - **Nearest.** The texel that contains the place: column `floor(u)`, row `floor(v)`.
//! - **Bilinear.** The mean of the four texels whose centres are around the place, each weighted by how near it is in u, times how
//!   near it is in v. Each channel is the nearest level to the exact mean, halves upwards. At the centre of a texel that is its
//!   own colour.
//! - **Outside** of the picture each axis has a rule, an [`AddressMode`]: [`Clamp`], [`Repeat`], [`Mirror`] or [`Tile`].
//!
//! ```
//! use embedded_graphics_core::pixelcolor::Gray4;
//! use embedded_raster::{
//!     buffer_bytes, surface::texture::{Clamp, Mirror, Repeat, Texture}, Bitmap, Canvas, Error, Framebuffer, PointFx,
//! };
//! use fixed::types::I16F16;
//!
//! // The letter F, 8 x 8 pixels of 4 bits.
//! const F: [u8; 32] = [
//!     0x44, 0x44, 0x44, 0x44, 0x4f, 0xff, 0xff, 0xf4, 0x4f, 0x44, 0x44, 0x44, 0x4f, 0xff, 0xf4, 0x44, //
//!     0x4f, 0x44, 0x44, 0x44, 0x4f, 0x44, 0x44, 0x44, 0x4f, 0x44, 0x44, 0x44, 0x44, 0x44, 0x44, 0x44, //
//! ];
//! let letter = Bitmap::<Gray4>::new(&F, 8, 8)?;
//! let repeat = Texture::new(&letter, (Repeat, Repeat)).expect("it has texels");
//! let mirror = Texture::new(&letter, (Mirror, Mirror)).expect("it has texels");
//! let clamp = Texture::new(&letter, (Clamp, Clamp)).expect("it has texels");
//!
//! let mut ram = [0; buffer_bytes::<Gray4>(204, 68)];
//! let mut frame = Framebuffer::<Gray4>::new(&mut ram, 204, 68)?;
//! // A square of two triangles, 64 pixels wide, shows 24 texels: from 8 before the picture to 8 behind it.
//! let mut square = |left: i32, color: &dyn Fn(I16F16, I16F16) -> Gray4| {
//!     let place = |(x, y)| PointFx::px(left + 64 * x, 2 + 64 * y);
//!     let texel = |(x, y)| (I16F16::from_num(24 * x - 8), I16F16::from_num(24 * y - 8));
//!     for corners in [[(0, 0), (1, 0), (0, 1)], [(1, 1), (0, 1), (1, 0)]] {
//!         frame.shade_triangle_fx(corners.map(place), corners.map(texel), |(u, v)| color(u, v))?;
//!     }
//!     Ok::<(), Error>(())
//! };
//! square(2, &|u, v| repeat.nearest(u, v))?;
//! square(70, &|u, v| mirror.nearest(u, v))?;
//! square(138, &|u, v| clamp.bilinear(u, v))?;
//! # Ok::<(), embedded_raster::Error>(())
//! ```
//!
//! ![Three squares: with nine letters, with letters of which every other one is turned over, and with a blurred one][address-modes]
//!
//! Sources: E. Catmull, "A Subdivision Algorithm for Computer Display of Curved Surfaces", 1974 (textures); P. Heckbert, "Survey of
//! Texture Mapping", IEEE Computer Graphics and Applications 6, 1986.
#![doc = include_str!("texture.md")]

use core::{fmt, num::NonZeroU32};

use fixed::types::I16F16;

use super::{frame::Frame, layout::Layout};
use crate::{
    num::{
        cast::{index, low_u32, low_u8, signed, unsigned},
        recip::Divisor,
        wide::{high_word, product},
    },
    pixel::{Channels, Palette},
    tune::LONG_PRODUCTS,
};

/// A picture to take colours from, at any place: see the [module](self). A place is (u, v), in texels to the right and down.
///
/// Any [`Frame`] that can be read is one, or what its window shows of it: the top left corner of the window is at (0, 0). So a tile
/// of a sheet is a [`view`](Frame::view) of it. Widths and heights may be any.
/// ```
/// use embedded_graphics_core::pixelcolor::Gray8;
/// use embedded_raster::{surface::texture::{Repeat, Texture}, Bitmap, Canvas, Framebuffer, PointFx};
/// use fixed::types::I16F16;
/// let picture = Bitmap::<Gray8>::new(&[10, 20, 30, 40], 2, 2)?;
/// let texture = Texture::new(&picture, (Repeat, Repeat)).expect("it has texels");
/// let at = |u: f32, v: f32| (I16F16::from_num(u), I16F16::from_num(v));
/// let (u, v) = at(1.25, 0.5);
/// assert_eq!(texture.nearest(u, v), Gray8::new(20));
/// assert_eq!(texture.bilinear(u, v), Gray8::new(18)); // 1/4 of the way back from 20 to 10: 17.5
///
/// // Twice as large on a screen: half a texel from pixel to pixel.
/// let mut ram = [0; 16];
/// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 4, 4)?;
/// let corners = [PointFx::px(0, 0), PointFx::px(4, 0), PointFx::px(0, 4)];
/// frame.shade_triangle_fx(corners, [at(0.0, 0.0), at(2.0, 0.0), at(0.0, 2.0)], |(u, v)| texture.nearest(u, v))?;
/// assert_eq!(ram, [10, 10, 20, 0, 10, 10, 0, 0, 30, 0, 0, 0, 0, 0, 0, 0]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
pub struct Texture<'a, L, U: AddressMode, V: AddressMode> {
    picture: Frame<&'a [u8], L>,
    u: U::Axis,
    v: V::Axis,
}

impl<L, U: AddressMode, V: AddressMode> Copy for Texture<'_, L, U, V> {}

impl<L, U: AddressMode, V: AddressMode> Clone for Texture<'_, L, U, V> {
    fn clone(&self) -> Self {
        *self
    }
}

/// Prints the sizes, not the texels.
impl<L, U: AddressMode, V: AddressMode> fmt::Debug for Texture<'_, L, U, V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Texture").field("picture", &self.picture).field("u", &self.u).field("v", &self.v).finish()
    }
}

impl<'a, L: Layout, U: AddressMode, V: AddressMode> Texture<'a, L, U, V> {
    /// A picture, and what lies outside of it: to the left and right, and above and below.
    ///
    /// `None` if it has no texels, or if an axis is a [`Tile`] and the picture cannot be one.
    pub fn new<M: AsRef<[u8]>>(picture: &'a Frame<M, L>, _: (U, V)) -> Option<Self> {
        let picture = picture.as_bitmap();
        let window = picture.window();
        let (width, height) = (NonZeroU32::new(window.width())?, NonZeroU32::new(window.height())?);
        let (x, y) = picture.place(window.x0, window.y0);
        if V::WHOLE && !L::is_whole(picture.read().1) {
            return None;
        }
        Some(Self { picture, u: U::axis(x, width)?, v: V::axis(y, height)? })
    }

    /// The texel in a column and a row, which may lie outside. Less than 2^16 each, be it negative or not.
    #[inline(always)]
    fn texel(&self, i: i32, j: i32) -> L::Color {
        let (memory, grid) = self.picture.read();
        let place = (U::place(&self.u, i), V::place(&self.v, j));
        if V::WHOLE {
            L::get_whole(memory, grid, place)
        } else {
            L::get(memory, grid, place)
        }
    }

    /// The texel that contains a place.
    #[inline(always)]
    pub fn nearest(&self, u: I16F16, v: I16F16) -> L::Color {
        self.texel(u.to_bits() >> 16, v.to_bits() >> 16)
    }

    /// [`nearest`](Self::nearest), but `None` where the texel has the colour `key`: for
    /// [`DepthShade`](crate::paint::DepthShade) and [`write_some`](crate::Surface::write_some), which leave such pixels as they are.
    #[inline(always)]
    pub fn nearest_keyed(&self, u: I16F16, v: I16F16, key: L::Color) -> Option<L::Color> {
        Some(self.nearest(u, v)).filter(|&texel| texel != key)
    }

    /// [`nearest`](Self::nearest) of a picture of indices, through a palette. `None` where the palette has no such index.
    /// ```
    /// use embedded_graphics_core::pixelcolor::{Rgb565, Rgb888};
    /// use embedded_raster::{pixel::EGA, surface::texture::{Mirror, Texture}, Bitmap, Index4, Palette};
    /// use fixed::types::I16F16;
    /// let picture = Bitmap::<Index4>::new(&[0x4f], 2, 1)?;
    /// let texture = Texture::new(&picture, (Mirror, Mirror)).expect("it has texels");
    /// let palette: Palette<Rgb565, 16> = EGA.map(Rgb565::from);
    /// let color = texture.nearest_through(I16F16::from_num(-0.5), I16F16::ZERO, &palette);
    /// assert_eq!(color, Some(Rgb565::from(Rgb888::new(170, 0, 0))));
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[inline(always)]
    pub fn nearest_through<C: Copy, const N: usize>(&self, u: I16F16, v: I16F16, palette: &Palette<C, N>) -> Option<C>
    where
        L::Color: Into<u8>,
    {
        palette.get(self.nearest(u, v).into())
    }

    /// The mean of the four texels around a place.
    #[inline]
    pub fn bilinear(&self, u: I16F16, v: I16F16) -> L::Color
    where
        L::Color: Channels,
    {
        let (texels, parts) = self.around(u, v);
        mean(texels, parts)
    }

    /// [`bilinear`](Self::bilinear), but `None` where the nearest texel has the colour `key`. Where another one of the four has it,
    /// it is as if it had the colour of the nearest.
    #[inline]
    pub fn bilinear_keyed(&self, u: I16F16, v: I16F16, key: L::Color) -> Option<L::Color>
    where
        L::Color: Channels,
    {
        let nearest = self.nearest_keyed(u, v, key)?;
        let (texels, parts) = self.around(u, v);
        Some(mean(texels.map(|texel| if texel == key { nearest } else { texel }), parts))
    }

    /// [`bilinear`](Self::bilinear) of a picture of indices: the mean of the colours that a palette has for them. `None` where it has
    /// none for the nearest; where it has none for another one of the four, it is as if it had the colour of the nearest.
    #[inline]
    pub fn bilinear_through<C: Channels, const N: usize>(
        &self,
        u: I16F16,
        v: I16F16,
        palette: &Palette<C, N>,
    ) -> Option<C>
    where
        L::Color: Into<u8>,
    {
        let nearest = self.nearest_through(u, v, palette)?;
        let (texels, parts) = self.around(u, v);
        Some(mean(texels.map(|texel| palette.get(texel.into()).unwrap_or(nearest)), parts))
    }

    /// The four texels around a place: the upper two, then the lower two, and how far the place is from the first of them, in 2^-16.
    #[inline(always)]
    fn around(&self, u: I16F16, v: I16F16) -> ([L::Color; 4], (u32, u32)) {
        let ((i, right), (j, down)) = (from_centre(u), from_centre(v));
        let (next, below) = (i.wrapping_add(1), j.wrapping_add(1));
        ([(i, j), (next, j), (i, below), (next, below)].map(|(i, j)| self.texel(i, j)), (right, down))
    }
}

/// `x - 1/2` as a whole number and 2^-16: the last texel whose centre is not beyond x, and how far x is from there.
#[inline(always)]
fn from_centre(x: I16F16) -> (i32, u32) {
    let bits = x.to_bits();
    let is_before = (bits >> 15 & 1) == 0;
    ((bits >> 16).wrapping_sub(is_before.into()), (unsigned(bits) ^ 0x8000) & 0xffff)
}

/// The mean of four colours, in two rows of two, at a place between them in 2^-16.
#[inline(always)]
fn mean<C: Channels>(colors: [C; 4], (right, down): (u32, u32)) -> C {
    let mix = |a: u32, b: u32| a.wrapping_mul(0x1_0000_u32.wrapping_sub(right)).wrapping_add(b.wrapping_mul(right));
    C::mixed(colors, |levels| {
        let [a, b, c, d] = levels.map(u32::from);
        // Below 2^24 each.
        let (upper, lower) = (mix(a, b), mix(c, d));
        low_u8(if LONG_PRODUCTS {
            // Below 2^40.
            let sum = product(upper, 0x1_0000_u32.wrapping_sub(down)).wrapping_add(product(lower, down));
            low_u32(sum.wrapping_add(1 << 31) >> 32)
        } else {
            // From the upper mean, a part of the way to the lower one, from products of halves. Cutting off the lowest 16 bits first does not
            // change how the rest is rounded.
            let way = lower.wrapping_sub(upper);
            let low = (way & 0xffff).wrapping_mul(down) >> 16;
            let part = unsigned(signed(way) >> 16).wrapping_mul(down).wrapping_add(low);
            upper.wrapping_add(part).wrapping_add(1 << 15) >> 16
        })
    })
}

/// What is there where a picture has ended. It is a type, so that a program links only the code that it uses.
pub trait AddressMode: Copy {
    /// What is known of the columns or the rows of a picture.
    type Axis: Copy + fmt::Debug;

    /// Whether rows have to be whole pixels apart.
    #[doc(hidden)]
    const WHOLE: bool = false;

    /// Of so many, from a place in memory on.
    #[doc(hidden)]
    fn axis(start: usize, size: NonZeroU32) -> Option<Self::Axis>;

    /// Where in memory number i is, which may lie outside: less than 2^16, be it negative or not.
    #[doc(hidden)]
    fn place(axis: &Self::Axis, i: i32) -> usize;
}

/// The last column or row goes on for ever.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Clamp;

/// The picture begins anew.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Repeat;

/// The picture goes back and forth. The last column or row is there twice.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Mirror;

/// [`Repeat`], fastest: for a picture whose size is a power of two, and which begins in the first column and row in memory. Its rows
/// have to be whole pixels apart, as they are unless a stride says otherwise.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Tile;

/// Where columns or rows lie in memory, and the last one.
#[derive(Copy, Clone, Debug)]
pub struct Ends {
    start: usize,
    last: i32,
}

impl AddressMode for Clamp {
    type Axis = Ends;

    #[inline]
    fn axis(start: usize, size: NonZeroU32) -> Option<Ends> {
        Some(Ends { start, last: signed(size.get().wrapping_sub(1)) })
    }

    #[inline(always)]
    fn place(axis: &Ends, i: i32) -> usize {
        axis.start.wrapping_add(index(i.min(axis.last).max(0)))
    }
}

impl AddressMode for Tile {
    type Axis = u32;
    const WHOLE: bool = true;

    #[inline]
    fn axis(start: usize, size: NonZeroU32) -> Option<u32> {
        (start == 0 && size.is_power_of_two()).then(|| size.get().wrapping_sub(1))
    }

    #[inline(always)]
    fn place(mask: &u32, i: i32) -> usize {
        (unsigned(i) & mask) as usize
    }
}

/// What repeats.
#[derive(Copy, Clone, Debug)]
pub struct Period {
    start: usize,
    /// After how many they come again.
    length: u32,
    /// A multiple of the length, from 2^17 to 2^18.
    bias: u32,
    /// `floor(2^(31 + s) / length) + 1`, where `2^s` is the highest power of two that is not above the length, and s the shift.
    ///
    /// So `n inverse / 2^(31 + s)` is above `n / length` by at most `n / 2^(31 + s)`. For n below 2^19 that is less than
    /// `1 / length`, and both have the same whole part.
    inverse: u32,
    shift: u32,
}

impl Period {
    /// Of at most 2^17.
    fn new(start: usize, period: NonZeroU32) -> Self {
        let shift = 31_u32.wrapping_sub(period.leading_zeros());
        let divisor = Divisor::new(period);
        let (inverse, _) = divisor.div_rem(1 << 31_u32.wrapping_add(shift));
        let (times, _) = divisor.div_rem(u64::from(period.get()).wrapping_add(1 << 17));
        let length = period.get();
        Self { start, length, bias: times.wrapping_mul(length), inverse: inverse.wrapping_add(1), shift }
    }

    /// The rest of a division by the period.
    #[inline(always)]
    fn rest(&self, i: i32) -> u32 {
        let n = unsigned(i).wrapping_add(self.bias);
        let quotient = high_word(n << 1, self.inverse) >> (self.shift & 31);
        n.wrapping_sub(quotient.wrapping_mul(self.length))
    }
}

impl AddressMode for Repeat {
    type Axis = Period;

    #[inline]
    fn axis(start: usize, size: NonZeroU32) -> Option<Period> {
        Some(Period::new(start, size))
    }

    #[inline(always)]
    fn place(axis: &Period, i: i32) -> usize {
        axis.start.wrapping_add(axis.rest(i) as usize)
    }
}

impl AddressMode for Mirror {
    type Axis = Period;

    #[inline]
    fn axis(start: usize, size: NonZeroU32) -> Option<Period> {
        Some(Period::new(start, size.saturating_add(size.get())))
    }

    #[inline(always)]
    fn place(axis: &Period, i: i32) -> usize {
        let at = axis.rest(i);
        axis.start.wrapping_add(at.min(axis.length.wrapping_sub(1).wrapping_sub(at)) as usize)
    }
}
