//! [`Channels`]: colours whose channels are numbers, so that they can be mixed.

use embedded_graphics_core::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, Gray2, Gray4, Gray8, GrayColor, PixelColor, Rgb555, Rgb565, Rgb666, Rgb888,
    RgbColor,
};

use super::{
    color::{Rgb332, Rgb444, Xrgb8888},
    levels::luma,
};
use crate::{
    num::cast::{low_u16, low_u8},
    tune::{COMPACT, VECTORS},
};

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

/// Whether levels become shares by a table: a kilobyte of flash, and a quarter of the cycles of a pixel. Computers mix several pixels
/// at once by themselves, where there is no table.
const SHARES: bool = !VECTORS && !COMPACT;

/// [`Channels::between`] for channels of at most 5, 6 and 5 bits: red and blue in one word, as 16 bits are enough for each.
///
/// A channel a becomes `floor((a (2^k - S) + b S + 2^(k - 1)) / 2^k)`, with a share S of `2^k` parts for the level. That is rounded as
/// `(a (255 - level) + b level) / 255` is, for all a and b that there are, if S is chosen well: see [`share`]. Channels of 5 bits take k = 11,
/// those of 6 bits k = 12.
#[inline(always)]
fn small([[r, g, b], to]: [[u8; 3]; 2], level: u8) -> [u8; 3] {
    let [five, six] = SHARE_OF[usize::from(level)].map(u32::from);
    let pair = |red: u8, blue: u8| u32::from(blue) << 16 | u32::from(red);
    let mean = |[a, b]: [u32; 2], share: u32, bits: u32, half: u32| {
        let rest = (1_u32 << bits).wrapping_sub(share);
        a.wrapping_mul(rest).wrapping_add(b.wrapping_mul(share).wrapping_add(half))
    };
    let pair = mean([pair(r, b), pair(to[0], to[2])], five, 11, 0x0400_0400);
    let green = mean([g, to[1]].map(u32::from), six, 12, 1 << 11);
    [low_u8(pair >> 11) & 31, low_u8(green >> 12), low_u8(pair >> 27)]
}

/// The shares of the levels, of `2^11` and of `2^12` parts.
static SHARE_OF: [[u16; 2]; 256] = {
    let mut shares = [[0; 2]; 256];
    let (mut i, mut level) = (0, 0);
    while i < shares.len() {
        shares[i] = [share(level, 11, 31), share(level, 12, 63)];
        (i, level) = (i + 1, level + 1);
    }
    shares
};

/// The share of `2^k` parts by which all differences of at most `most`, and their opposites, are rounded as by the level of 255 parts.
/// The exact one may lie between two that are too coarse for that, but one of the two next to it is right for each level.
const fn share(level: u32, k: u32, most: u32) -> u16 {
    let mut share = (level << k) / 255;
    let mut d = 1;
    while d <= most {
        let nearest = (2 * d * level + 255) / 510;
        if (d * share).abs_diff(nearest << k) >= 1 << (k - 1) {
            (share, d) = (share + 1, 0);
        }
        d += 1;
    }
    low_u16(share)
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
                let ends = ends.map(|color| [color.r(), color.g(), color.b()]);
                let is_small = Self::MAX_R <= 31 && Self::MAX_G <= 63 && Self::MAX_B <= 31;
                let [r, g, b] = if SHARES && is_small { small(ends, level) } else { three(ends, level) };
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
            fn between(ends: [Self; 2], level: u8) -> Self {
                let [a, b] = ends.map(|color| u16::from(color.luma()));
                let (after, before) = (u16::from(level), u16::from(!level));
                // As in `three`: at most 65,153 and 254 more.
                let sum = a.wrapping_mul(before).wrapping_add(b.wrapping_mul(after)).wrapping_add(128);
                Self::new(low_u8(u32::from(sum.wrapping_add(sum >> 8) >> 8)))
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Each way for itself, whichever this machine takes.
    #[test]
    fn means_are_rounded_to_nearest() {
        for level in 0..=u8::MAX {
            let mean = |a: u8, b: u8| {
                let sum = u32::from(a) * u32::from(!level) + u32::from(b) * u32::from(level);
                (2 * sum + 255) / 510
            };
            for (a, b) in (0..64).flat_map(|a| (0..64).map(move |b| (a, b))) {
                let five = |n: u8| n & 31;
                let ends = [[five(a), a, five(b)], [five(b), b, five(a)]];
                let wanted = [0, 1, 2].map(|i| low_u8(mean(ends[0][i], ends[1][i])));
                assert_eq!(small(ends, level), wanted, "small: {ends:?} by {level}");
                assert_eq!(three(ends, level), wanted, "three: {ends:?} by {level}");
            }
            for (a, b) in [(0, 255), (255, 0), (1, 254), (255, 255), (128, 127), (3, 200)] {
                let wanted = low_u8(mean(a, b));
                assert_eq!(three([[a, b, a], [b, b, b]], level), [wanted, b, wanted], "{a} and {b} by {level}");
                assert_eq!(Gray8::between([Gray8::new(a), Gray8::new(b)], level), Gray8::new(wanted), "{a} and {b}");
            }
        }
    }
}
