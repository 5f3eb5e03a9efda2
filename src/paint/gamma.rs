//! [`Gamma`] and [`CoverGamma`]: rims that are mixed as light.
//!
//! The levels of a channel are not amounts of light: half of the light is at 188 of 255 levels by sRGB. A pixel that is half covered
//! should send out the mean of the light of both colours, and the mean of their levels is darker. So white on black looks thinner than
//! it is, black on white bolder, and thin lines get steps.
//! ```text
//!   light  |                 .           a, b    the levels of two colours, light(a) and light(b)
//!          |               .'            mean    of the light: ((255 - c) light(a) + c light(b)) / 255
//!     mean |- - - - - - -.'              result  the level whose light is nearest to it
//!          |          .-':
//!          |   ___..-'   :
//!          +-----------------
//!           a       result  b   level
//! ```
//! **How.** A [`Gamma`] is a table of the light of 256 levels, 16 bits each: 512 bytes, which stay in flash if it is a `static`. Nobody
//! has to link it who does not paint with it. The way back needs no table: the light is looked for by bisection, in eight steps. A
//! channel of other levels than 255 has the light of the nearest of the 256.
//!
//! **Exact.** The mean is rounded to the nearest number of 16 bits, and the level of the channel is the nearest one to that, the upper
//! one of two.
//!
//! Source: "IEC 61966-2-1: Default RGB colour space - sRGB", 1999.

use super::{cover::level_at, solid::in_one_color, traits::Paint};
use crate::{
    num::cast::{low_u16, low_u32, low_u8},
    pixel::{Channels, Palette},
    span::ClippedSpan,
    surface::Readable,
};

/// How much light the levels of a channel are: a table of 512 bytes.
/// ```
/// use embedded_graphics_core::pixelcolor::{Gray8, GrayColor};
/// use embedded_raster::paint::Gamma;
/// static SRGB: Gamma = Gamma::SRGB;
/// let ends = [Gray8::BLACK, Gray8::WHITE];
/// assert_eq!(SRGB.between(ends, 128), Gray8::new(188));
/// assert_eq!(Gamma::power(1, 1).between(ends, 128), Gray8::new(128)); // levels are light
/// assert_eq!(size_of::<Gamma>(), 512);
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Gamma {
    light: [u16; 256],
}

impl Gamma {
    /// That of sRGB: up to level 10 a 12.92th, above it `((level / 255 + 0.055) / 1.055)^2.4`. Each entry is the nearest number to 65,535
    /// times that.
    pub const SRGB: Self = {
        let mut light = [0; 256];
        let mut level = 0;
        while level < 256 {
            light[level as usize] = if level <= 10 {
                // 65,535 / (12.92 255), rounded.
                low_u16((level * 65_535 * 100 * 2 + 1_292 * 255) / (2 * 1_292 * 255))
            } else {
                // (level / 255 + 55 / 1,000) / (1,055 / 1,000) in whole numbers.
                power(40 * level + 561, 10_761, 12, 5)
            };
            level += 1;
        }
        Self { light }
    };

    /// A power: of each level the nearest number to `65,535 (level / 255)^(n / d)`. The power 2.2 of many displays is `power(11, 5)`. `n`
    /// is taken as 16 if it is more, and `d` as 5.
    ///
    /// It is for constants: it multiplies numbers of 256 bits, tens of thousands of times.
    pub const fn power(n: u8, d: u8) -> Self {
        let (n, d) = (if n > 16 { 16 } else { n as u32 }, if d > 5 { 5 } else { d as u32 });
        let mut light = [0; 256];
        let mut level = 0;
        while level < 256 {
            light[level as usize] = power(level, 255, n, d);
            level += 1;
        }
        Self { light }
    }

    /// A table of the light of each level, which must not fall: as a display was measured, say.
    #[inline]
    pub const fn new(light: [u16; 256]) -> Self {
        Self { light }
    }

    /// The light of each level.
    #[inline]
    pub const fn light(&self) -> &[u16; 256] {
        &self.light
    }

    /// The colour whose light is `level` of 255 parts on the way from that of one colour to that of another.
    #[inline]
    pub fn between<C: Channels>(&self, [before, after]: [C; 2], level: u8) -> C {
        // Of a channel with all bits set, the largest number.
        let most = C::mixed([after], |_| u8::MAX);
        C::mixed([before, after, most], |[a, b, most]| self.mean([a, b], most, level))
    }

    /// The table whose light is `level` of 255 parts on the way to that of another one, entry by entry: a fade that is even to the eye.
    /// [`Palette::between`] is the same of levels.
    /// ```
    /// use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
    /// use embedded_raster::{paint::Gamma, Palette};
    /// static SRGB: Gamma = Gamma::SRGB;
    /// let [day, night] = [Rgb888::WHITE, Rgb888::BLACK].map(|color| Palette::new([color; 16]));
    /// assert_eq!(SRGB.fade([&night, &day], 128).get(3), Some(Rgb888::new(188, 188, 188)));
    /// ```
    #[must_use]
    pub fn fade<C: Channels, const N: usize>(&self, [before, after]: [&Palette<C, N>; 2], level: u8) -> Palette<C, N> {
        let mut colors = *before.colors();
        for (color, &after) in colors.iter_mut().zip(after.colors()) {
            *color = self.between([*color, after], level);
        }
        Palette::new(colors)
    }

    /// Of two levels of a channel whose largest one is `most`.
    fn mean(&self, [a, b]: [u8; 2], most: u8, level: u8) -> u8 {
        if a == b {
            return a;
        }
        let light = |channel: u8| u32::from(self.light_of(channel, most));
        let (before, after) = (light(a).wrapping_mul((!level).into()), light(b).wrapping_mul(level.into()));
        self.level_of(before.wrapping_add(after).wrapping_add(127) / 255, most)
    }

    /// The light of a level of a channel whose largest one is `most`.
    #[inline]
    fn light_of(&self, level: u8, most: u8) -> u16 {
        let most = u32::from(most.max(1));
        let level = u32::from(level).wrapping_mul(255).wrapping_add(most >> 1) / most;
        self.light.get(level as usize).copied().unwrap_or(u16::MAX)
    }

    /// The level of a channel whose light is nearest.
    fn level_of(&self, light: u32, most: u8) -> u8 {
        // The last of the 256 levels that has no more light, or the first of all.
        let mut at = 0_usize;
        for bit in [128, 64, 32, 16, 8, 4, 2, 1] {
            if self.light.get(at | bit).is_some_and(|&it| u32::from(it) <= light) {
                at |= bit;
            }
        }
        // Of the channel, the last level whose nearest one of the 256 is that or one before: 255 n / most < at + 1/2, and never equal, as
        // `most` is odd.
        let at = low_u32(at as u64).wrapping_mul(2).wrapping_add(1);
        let low = low_u8(at.wrapping_mul(most.into()) / 510).min(most);
        let high = low.saturating_add(1).min(most);
        let [below, above] = [low, high].map(|level| u32::from(self.light_of(level, most)));
        if light.wrapping_sub(below) < above.wrapping_sub(light) {
            low
        } else {
            high
        }
    }
}

/// The nearest number to `65,535 (x / whole)^(n / d)`: y where `((2 y - 1) / 2)^d whole^n <= 65,535^d x^n < ((2 y + 1) / 2)^d whole^n`.
const fn power(x: u32, whole: u32, n: u32, d: u32) -> u16 {
    let wanted = Large::ONE.times(2 * 65_535, d).times(x, n);
    let unit = Large::ONE.times(whole, n);
    let (mut y, mut bit) = (0, 1 << 15);
    while bit > 0 {
        if unit.times(2 * (y + bit) - 1, d).is_at_most(&wanted) {
            y += bit;
        }
        bit >>= 1;
    }
    low_u16(y)
}

/// A number of 256 bits, of the lowest 32 on: only constants are made of it.
#[derive(Copy, Clone)]
struct Large([u32; 8]);

impl Large {
    const ONE: Self = Self([1, 0, 0, 0, 0, 0, 0, 0]);

    /// Times a number, so many times. All here stays below `2^246`.
    const fn times(self, factor: u32, times: u32) -> Self {
        let Self(mut words) = self;
        let mut done = 0;
        while done < times {
            let (mut carry, mut i) = (0, 0);
            while i < 8 {
                let sum = words[i] as u64 * factor as u64 + carry;
                (words[i], carry) = (low_u32(sum), sum >> 32);
                i += 1;
            }
            done += 1;
        }
        Self(words)
    }

    const fn is_at_most(&self, other: &Self) -> bool {
        let mut i = 8;
        while i > 0 {
            i -= 1;
            if self.0[i] != other.0[i] {
                return self.0[i] < other.0[i];
            }
        }
        true
    }
}

/// One colour, with soft rims that are mixed as light: [`Cover`](super::Cover) with a [`Gamma`].
///
/// A pixel takes two searches of a table for each channel: some ten times what `Cover` takes. Where a pixel is covered as a whole, it
/// takes what any colour does.
/// ```
/// use embedded_graphics_core::pixelcolor::{Gray8, GrayColor};
/// use embedded_raster::{paint::{CoverGamma, Gamma}, Antialias, Framebuffer, PointFx};
/// static SRGB: Gamma = Gamma::SRGB;
/// let mut ram = [0; 5];
/// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 5, 1)?;
/// let corners = [(0, 0), (4, 0), (0, 1)].map(|(x, y)| PointFx::px(x, y));
/// frame.fill_triangle_aa(corners, &mut [], CoverGamma { color: Gray8::WHITE, gamma: &SRGB });
/// assert_eq!(ram, [240, 207, 165, 99, 0]); // 223, 159, 96 and 32 by `Cover`
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Copy, Clone, Debug)]
pub struct CoverGamma<'a, C> {
    /// The colour of the shape.
    pub color: C,
    /// How much light its levels are.
    pub gamma: &'a Gamma,
}

impl<S: Readable> Paint<S> for CoverGamma<'_, S::Color>
where
    S::Color: Channels,
{
    in_one_color!(|paint| paint.color);

    #[inline(never)]
    fn coverage(&mut self, on: &mut S, span: ClippedSpan, levels: &[u8]) {
        let Self { color, gamma } = *self;
        on.edit_span(span, |x, old| match level_at(levels, span, x) {
            0 => old,
            level => gamma.between([old, color], level),
        });
    }
}
