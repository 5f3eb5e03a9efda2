//! [`Channels`]: colours whose channels are numbers, so that they can be mixed.

use embedded_graphics_core::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, Gray2, Gray4, Gray8, GrayColor, PixelColor, Rgb555, Rgb565, Rgb666, Rgb888,
    RgbColor,
};

use super::{
    color::{Rgb332, Rgb444, Xrgb8888},
    levels::luma,
};
use crate::num::cast::low_u8;

/// A colour of red, green and blue, or a grey: what can be mixed, channel by channel. An index is none.
pub trait Channels: PixelColor {
    /// The colour each of whose channels is what `mix` makes of that channel of some colours. Of its answer the low bits count, as
    /// many as the channel has.
    /// ```
    /// use embedded_graphics_core::pixelcolor::Rgb565;
    /// use embedded_raster::pixel::Channels;
    /// let brighter = |[a, b]: [u8; 2]| a.max(b);
    /// let colors = [Rgb565::new(1, 20, 31), Rgb565::new(2, 10, 31)];
    /// assert_eq!(Rgb565::mixed(colors, brighter), Rgb565::new(2, 20, 31));
    /// ```
    fn mixed<const N: usize>(colors: [Self; N], mix: impl FnMut([u8; N]) -> u8) -> Self;

    /// The colour each of whose channels is what `mix` makes of that channel of this colour, of the largest number that it can have,
    /// and of the number that it has among others of red, green and blue, below `2^16`. A grey takes the luma of those: of ITU-R BT.601,
    /// with the weights 77, 150 and 29 of 256, rounded. Of the answer the low bits count.
    /// ```
    /// use embedded_graphics_core::pixelcolor::{Gray4, Rgb565};
    /// use embedded_raster::pixel::Channels;
    /// // The nearest channel to one of 8 bits, whatever was there before.
    /// let take = |_, most: u8, level: u32| ((level * u32::from(most) + 127) / 255) as u8;
    /// assert_eq!(Rgb565::new(1, 2, 3).mixed_with([255, 128, 0], take), Rgb565::new(31, 32, 0));
    /// assert_eq!(Gray4::new(1).mixed_with([255, 128, 0], take), Gray4::new(9));
    /// ```
    #[must_use]
    fn mixed_with(self, rgb: [u32; 3], mix: impl FnMut(u8, u8, u32) -> u8) -> Self;

    /// The colour that is `level` of 255 parts on the way from one colour to another: of each channel the nearest level.
    /// ```
    /// use embedded_graphics_core::pixelcolor::{Gray4, Rgb565, RgbColor};
    /// use embedded_raster::pixel::Channels;
    /// assert_eq!(Rgb565::between([Rgb565::BLACK, Rgb565::WHITE], 128), Rgb565::new(16, 32, 16));
    /// assert_eq!(Gray4::between([Gray4::new(15), Gray4::new(5)], 255), Gray4::new(5));
    /// ```
    #[inline]
    fn between(ends: [Self; 2], level: u8) -> Self {
        // No mean is half way between two levels: 255 is odd.
        let (after, before) = (u32::from(level), u32::from(!level));
        Self::mixed(ends, |[a, b]| {
            let sum = u32::from(a).wrapping_mul(before).wrapping_add(u32::from(b).wrapping_mul(after));
            low_u8(sum.wrapping_add(127) / 255)
        })
    }

    /// The colour that is `share` of 65,025 parts, `255^2`, on the way from one colour to another: of each channel the nearest
    /// level. For a product of two levels, such as a coverage and an alpha, that is rounded once.
    /// ```
    /// use embedded_graphics_core::pixelcolor::Gray8;
    /// use embedded_raster::pixel::Channels;
    /// let half_of_a_third = 128 * 85;
    /// assert_eq!(Gray8::between_fine([Gray8::new(0), Gray8::new(240)], half_of_a_third), Gray8::new(40));
    /// ```
    #[inline]
    fn between_fine(ends: [Self; 2], share: u16) -> Self {
        const ALL: u32 = 255 * 255;
        let after = u32::from(share).min(ALL);
        let before = ALL.wrapping_sub(after);
        Self::mixed(ends, |[a, b]| {
            // Below 2^24.
            let sum = u32::from(a).wrapping_mul(before).wrapping_add(u32::from(b).wrapping_mul(after));
            low_u8(sum.wrapping_add(ALL / 2) / ALL)
        })
    }
}

/// [`Channels::between`] for three channels: red and blue in one word, as a channel times 255 has 16 bits.
///
/// `(n + 128) (2^8 + 1) / 2^16` is the nearest number to n / 255 for n up to `255^2`: J. F. Blinn, "Three wrongs make a right", IEEE
/// Computer Graphics and Applications, 1995.
#[inline(always)]
fn three(ends: [[u8; 3]; 2], level: u8) -> [u8; 3] {
    let (after, before) = (u32::from(level), u32::from(!level));
    let mean = |[a, b]: [u32; 2], half: u32| {
        let sum = a.wrapping_mul(before).wrapping_add(b.wrapping_mul(after)).wrapping_add(half);
        sum.wrapping_add(sum >> 8 & 0x00ff_00ff) >> 8
    };
    let pair = mean(ends.map(|[red, _, blue]| u32::from(red) << 16 | u32::from(blue)), 0x0080_0080);
    let green = mean(ends.map(|[_, green, _]| green.into()), 0x80);
    [low_u8(pair >> 16), low_u8(green), low_u8(pair)]
}

macro_rules! rgb {
    ($($color:ty),*) => {
        $(impl Channels for $color {
            #[inline(always)]
            fn mixed<const N: usize>(colors: [Self; N], mut mix: impl FnMut([u8; N]) -> u8) -> Self {
                let [r, g, b] = [Self::r, Self::g, Self::b].map(|channel| mix(colors.each_ref().map(channel)));
                Self::new(r, g, b)
            }

            #[inline(always)]
            fn between(ends: [Self; 2], level: u8) -> Self {
                let [r, g, b] = three(ends.map(|color| [color.r(), color.g(), color.b()]), level);
                Self::new(r, g, b)
            }

            #[inline(always)]
            fn mixed_with(self, [r, g, b]: [u32; 3], mut mix: impl FnMut(u8, u8, u32) -> u8) -> Self {
                Self::new(mix(self.r(), Self::MAX_R, r), mix(self.g(), Self::MAX_G, g), mix(self.b(), Self::MAX_B, b))
            }
        })*
    };
}

macro_rules! grey {
    ($($color:ty),*) => {
        $(impl Channels for $color {
            #[inline(always)]
            fn mixed<const N: usize>(colors: [Self; N], mut mix: impl FnMut([u8; N]) -> u8) -> Self {
                Self::new(mix(colors.each_ref().map(Self::luma)))
            }

            #[inline(always)]
            fn mixed_with(self, rgb: [u32; 3], mut mix: impl FnMut(u8, u8, u32) -> u8) -> Self {
                Self::new(mix(self.luma(), Self::WHITE.luma(), luma(rgb)))
            }
        })*
    };
}

rgb!(Rgb332, Rgb444, Rgb555, Rgb565, Rgb666, Rgb888, Bgr555, Bgr565, Bgr666, Bgr888, Xrgb8888);
grey!(Gray2, Gray4, Gray8);
