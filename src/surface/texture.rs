//! [`Texture`]: a picture as a function of a place in it.
//!
//! A *texel* is a pixel of the picture. Places in it are in texels: texel (i, j) is the square `i..i+1` by `j..j+1`, and its centre is
//! at (i + 1/2, j + 1/2), as with pixels of a screen. Places are given to 2^-16 texel, and all bits are places.
//!
//! - **Nearest.** The texel that contains the place: column `floor(u)`, row `floor(v)`.
//! - **Bilinear.** The mean of the four texels whose centres are around the place, each weighted by how near it is in u, times how
//!   near it is in v. Each channel is the nearest level to the exact mean, halves upwards. At the centre of a texel that is its
//!   own colour.
//! - **Outside** of the picture the rule of each axis says which texel stands there: see [`Outside`].
//!
//! Sources: E. Catmull, "A Subdivision Algorithm for Computer Display of Curved Surfaces", 1974 (textures); P. Heckbert, "Survey of
//! Texture Mapping", IEEE Computer Graphics and Applications 6, 1986.

use core::{fmt, num::NonZeroU32};

use fixed::types::I16F16;

use super::{frame::Frame, layout::Layout};
use crate::{
    num::{
        cast::{low_u32, low_u8, signed, unsigned},
        recip::Divisor,
    },
    pixel::{Channels, Palette},
};

/// What is there where a picture or a gradient has ended.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Outside {
    /// Its last column or row, its last colour.
    #[default]
    Clamp,
    /// It begins anew.
    Repeat,
    /// It goes back and forth. The last one is there twice.
    Mirror,
}

/// A picture to take colours from, at any place: see the [module](self). A place is (u, v), in texels to the right and down.
///
/// Any [`Frame`] that can be read is one. Its coordinates are those of the frame; where the window of the frame ends, the picture
/// does. So a tile of a sheet is a [`view`](Frame::view) of it.
///
/// Widths and heights may be any. To repeat a picture is fastest where both are powers of two and it is all that is in memory.
/// ```
/// use embedded_graphics_core::pixelcolor::Gray8;
/// use embedded_raster::{surface::{Outside, Texture}, Bitmap, Canvas, Framebuffer, PointFx};
/// use fixed::types::I16F16;
/// let picture = Bitmap::<Gray8>::new(&[10, 20, 30, 40], 2, 2)?;
/// let texture = Texture::new(&picture, [Outside::Repeat; 2]).expect("it has texels");
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
pub struct Texture<'a, L> {
    picture: Frame<&'a [u8], L>,
    u: Axis,
    v: Axis,
    /// Both axes repeat by masks, and the picture begins where the memory does.
    by_masks: bool,
}

impl<L> Copy for Texture<'_, L> {}

impl<L> Clone for Texture<'_, L> {
    fn clone(&self) -> Self {
        *self
    }
}

/// Prints the sizes, not the texels.
impl<L> fmt::Debug for Texture<'_, L> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { picture, u, v, .. } = self;
        f.debug_struct("Texture").field("picture", picture).field("u", &u.outside).field("v", &v.outside).finish()
    }
}

impl<'a, L: Layout> Texture<'a, L> {
    /// A picture, and what lies outside of it: to the left and right, and above and below. `None` if it has no texels.
    pub fn new<M: AsRef<[u8]>>(picture: &'a Frame<M, L>, [u, v]: [Outside; 2]) -> Option<Self> {
        let picture = picture.as_bitmap();
        let window = picture.window();
        let (width, height) = (NonZeroU32::new(window.width())?, NonZeroU32::new(window.height())?);
        let is_whole = (window.x0, window.y0) == (0, 0) && picture.place(0, 0) == (0, 0);
        let (u, v) = (Axis::new(window.x0, width, u), Axis::new(window.y0, height, v));
        let by_masks = is_whole && u.is_masked() && v.is_masked();
        Some(Self { picture, u, v, by_masks })
    }

    /// The texel in a column and a row, which may lie outside. Less than 2^17 each, be it negative or not.
    #[inline(always)]
    fn texel(&self, i: i32, j: i32) -> L::Color {
        let (memory, grid) = self.picture.read();
        let place = if self.by_masks {
            ((unsigned(i) & self.u.mask) as usize, (unsigned(j) & self.v.mask) as usize)
        } else {
            self.picture.place(self.u.inside(i), self.v.inside(j))
        };
        L::get(memory, grid, place)
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
    /// use embedded_raster::{pixel::EGA, surface::{Outside, Texture}, Bitmap, Index4, Palette};
    /// use fixed::types::I16F16;
    /// let picture = Bitmap::<Index4>::new(&[0x4f], 2, 1)?;
    /// let texture = Texture::new(&picture, [Outside::Mirror; 2]).expect("it has texels");
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
    let product = |a: u32, b: u32| u64::from(a).wrapping_mul(b.into());
    C::mixed(colors, |levels| {
        let [a, b, c, d] = levels.map(u32::from);
        // Below 2^24 each, then 2^40.
        let (upper, lower) = (mix(a, b), mix(c, d));
        let sum = product(upper, 0x1_0000_u32.wrapping_sub(down)).wrapping_add(product(lower, down));
        low_u8(low_u32(sum.wrapping_add(1 << 31) >> 32))
    })
}

/// The columns or the rows of a picture.
#[derive(Copy, Clone, Debug)]
struct Axis {
    outside: Outside,
    first: i32,
    /// The number of the last one, counted from the first.
    last: u32,
    /// The last one, if their number is a power of two; else 0.
    mask: u32,
    /// After how many they come again.
    period: u32,
    /// A multiple of the period, from 2^17 to 2^18.
    bias: u32,
    /// `floor(2^(31 + s) / period) + 1`, where `2^s` is the highest power of two that is not above the period, and s the shift.
    ///
    /// So `n inverse / 2^(31 + s)` is above `n / period` by at most `n / 2^(31 + s)`. For n below 2^19 that is less than
    /// `1 / period`, and both have the same whole part.
    inverse: u32,
    shift: u32,
}

impl Axis {
    fn new(first: i32, size: NonZeroU32, outside: Outside) -> Self {
        let last = size.get().wrapping_sub(1);
        let period = if outside == Outside::Mirror { NonZeroU32::new(size.get() << 1).unwrap_or(size) } else { size };
        let shift = 31_u32.wrapping_sub(period.leading_zeros());
        let divisor = Divisor::new(period);
        let (inverse, _) = divisor.div_rem(1 << 31_u32.wrapping_add(shift));
        let (times, _) = divisor.div_rem((1 << 17) + u64::from(period.get()));
        Self {
            outside,
            first,
            last,
            mask: if size.is_power_of_two() { last } else { 0 },
            period: period.get(),
            bias: times.wrapping_mul(period.get()),
            inverse: inverse.wrapping_add(1),
            shift,
        }
    }

    /// Whether a mask is all that it takes to repeat.
    fn is_masked(&self) -> bool {
        self.outside == Outside::Repeat && self.mask == self.last
    }

    /// The one that stands in the place of number i, which may lie outside. `i - first` is less than 2^17, be it negative or not.
    #[inline(always)]
    fn inside(&self, i: i32) -> i32 {
        let at = i.wrapping_sub(self.first);
        let at = match self.outside {
            Outside::Clamp => unsigned(at.clamp(0, signed(self.last))),
            Outside::Repeat => self.rest(at),
            Outside::Mirror => {
                let at = self.rest(at);
                at.min(self.period.wrapping_sub(1).wrapping_sub(at))
            }
        };
        self.first.wrapping_add(signed(at))
    }

    /// The rest of a division by the period.
    #[inline(always)]
    fn rest(&self, at: i32) -> u32 {
        let n = unsigned(at).wrapping_add(self.bias);
        let product = u64::from(n << 1).wrapping_mul(self.inverse.into());
        n.wrapping_sub((low_u32(product >> 32) >> self.shift).wrapping_mul(self.period))
    }
}
