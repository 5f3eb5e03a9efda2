//! [`Argb8888`]: a colour with an alpha, and what becomes of a colour under it.
//!
//! A picture with an alpha says of each pixel how much of it there is, in 255ths. *Source over* is what is seen where it lies over
//! another picture, which has no holes:
//! ```text
//!   straight channels         a s + (255 - a) d         s: of the picture, d: what is under it, a: alpha
//!                             -----------------
//!                                    255
//!
//!   premultiplied channels    p + (255 - a) d / 255     p is a s / 255 already, rounded by whoever made the picture
//! ```
//! **Exact.** Levels of a channel with a largest number m, such as the 31 of five bits, are what is wanted; of the 8 bits of a picture
//! s, the channel has `m s / 255`. All is rounded once, at the end, to the nearest level: of straight channels that is the nearest
//! number to `(m a s + 255 (255 - a) d) / 255^2`, and of premultiplied ones to `(m p + (255 - a) d) / 255`. No sum lies half way
//! between two levels, as 255 and its square are odd. Numbers stay below `2^24`.
//!
//! Source: T. Porter and T. Duff, "Compositing Digital Images", SIGGRAPH 1984.

use embedded_graphics_core::pixelcolor::{
    raw::{RawData, RawU32},
    PixelColor,
};

use super::channels::Channels;
use crate::num::cast::low_u8;

/// A colour of 8 bits a channel with an alpha in the high byte: blue, green, red, alpha in memory; [`Be<Argb8888>`](super::Be) has
/// them the other way round.
///
/// Pictures of it are painted by [`Pictures::blit_with`](crate::Pictures::blit_with).
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Argb8888(RawU32);

impl PixelColor for Argb8888 {
    type Raw = RawU32;
}

impl From<RawU32> for Argb8888 {
    #[inline(always)]
    fn from(raw: RawU32) -> Self {
        Self(raw)
    }
}

impl From<Argb8888> for RawU32 {
    #[inline(always)]
    fn from(color: Argb8888) -> Self {
        color.0
    }
}

impl Argb8888 {
    /// A colour of an alpha and three channels, each of 255 levels above 0.
    #[inline]
    pub const fn new(a: u8, r: u8, g: u8, b: u8) -> Self {
        Self(RawU32::new(u32::from_le_bytes([b, g, r, a])))
    }

    /// Alpha, red, green, blue.
    #[inline(always)]
    pub fn argb(self) -> [u8; 4] {
        self.0.into_inner().to_be_bytes()
    }

    /// The colour with its channels premultiplied: each the nearest level to `a s / 255`.
    #[inline]
    #[must_use]
    pub fn premultiplied(self) -> Self {
        let [a, r, g, b] = self.argb();
        let part = |s: u8| low_u8(u32::from(s).wrapping_mul(a.into()).wrapping_add(127) / 255);
        Self::new(a, part(r), part(g), part(b))
    }

    /// What is seen where this colour, of straight channels, lies over another one: *source over*, rounded once.
    /// ```
    /// use embedded_graphics_core::pixelcolor::{Gray8, Rgb888};
    /// use embedded_raster::pixel::Argb8888;
    /// let third = Argb8888::new(85, 255, 0, 90);
    /// assert_eq!(third.over(Rgb888::new(0, 30, 30)), Rgb888::new(85, 20, 50));
    /// assert_eq!(Argb8888::new(0, 255, 0, 90).over(Gray8::new(7)), Gray8::new(7));
    /// ```
    #[inline]
    pub fn over<C: Channels>(self, under: C) -> C {
        const ALL: u32 = 255 * 255;
        let [a, r, g, b] = self.argb();
        if a == 0 {
            return under;
        }
        let (part, rest) = (u32::from(a), u32::from(!a).wrapping_mul(255));
        under.mixed_with([r, g, b].map(u32::from), |d, most, s| {
            let new = part.wrapping_mul(most.into()).wrapping_mul(s);
            let sum = new.wrapping_add(rest.wrapping_mul(d.into()));
            low_u8(sum.wrapping_add(ALL / 2) / ALL)
        })
    }

    /// What is seen where this colour, of premultiplied channels, lies over another one: *source over*, rounded once. A channel above
    /// its alpha, which no colour has, may make the sum more than there can be: then it is the most.
    /// ```
    /// use embedded_graphics_core::pixelcolor::Rgb888;
    /// use embedded_raster::pixel::Argb8888;
    /// let third = Argb8888::new(85, 255, 0, 90).premultiplied();
    /// assert_eq!(third, Argb8888::new(85, 85, 0, 30));
    /// assert_eq!(third.over_premultiplied(Rgb888::new(0, 30, 30)), Rgb888::new(85, 20, 50));
    /// ```
    #[inline]
    pub fn over_premultiplied<C: Channels>(self, under: C) -> C {
        let [a, r, g, b] = self.argb();
        if self.0.into_inner() == 0 {
            return under;
        }
        let rest = u32::from(!a);
        under.mixed_with([r, g, b].map(u32::from), |d, most, p| {
            let new = u32::from(most).wrapping_mul(p);
            let sum = new.wrapping_add(rest.wrapping_mul(d.into()));
            low_u8((sum.wrapping_add(127) / 255).min(most.into()))
        })
    }
}
