//! [`Ink`]: colours as pixels of every depth.
//!
//! Where there are few colours, a pixel has one of them by a rule that depends on where it is, so that pixels beside each other have
//! the colour in the mean: ordered dither. No pixel knows of another one, so bands show what the whole shows.
//! ```text
//!    0 32  8 40      The number of a pixel says which share of the colour has to be there before this pixel is brighter:
//!   48 16 56 24      the first rows of `Bayer::<8>`.
//!   12 44  4 36
//!   60 28 52 20
//! ```
//! Greys have an even scale: one comparison is enough. For a palette, sixteen colours of it are found that are right in the mean; they
//! are put in order by their brightness, and the number of the pixel takes one.
//!
//! Source: T. Knoll, "Pattern dithering", US patent 6,606,166, 1999 (expired).

use std::{cell::RefCell, collections::HashMap};

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{PixelColor, Rgb565, Rgb888, RgbColor},
};
use embedded_raster::{
    paint::Bayer, pixel::Xrgb8888, Framebuffer, Index1, Index2, Index4, Index8, Palette, PixelFormat,
};

use crate::picture::Picture;

/// What colours are made of where there are only sixteen.
#[derive(Clone, Debug)]
pub struct Inks {
    palette: Palette<Rgb888, 16>,
    /// Colours that were asked for: sixteen indices that are right in the mean, the darkest first.
    known: RefCell<HashMap<[u8; 3], [u8; 16]>>,
}

impl Inks {
    /// Of a palette.
    pub fn new(palette: Palette<Rgb888, 16>) -> Self {
        Self { palette, known: RefCell::default() }
    }

    /// The index for a pixel.
    fn index(&self, color: Rgb888, at: Point) -> u8 {
        let pattern = *self.known.borrow_mut().entry(channels(color)).or_insert_with(|| self.pattern(color));
        pattern[(Bayer::<8>::threshold(at) >> 2) as usize]
    }

    /// Sixteen indices that are right in the mean.
    fn pattern(&self, color: Rgb888) -> [u8; 16] {
        let wanted = channels(color).map(i32::from);
        let mut owed = [0; 3];
        let mut pattern = [0; 16].map(|_: u8| {
            let goal = [0, 1, 2].map(|i| wanted[i] + owed[i]);
            let (index, chosen) = self.nearest(goal);
            owed = [0, 1, 2].map(|i| goal[i] - chosen[i]);
            index
        });
        pattern.sort_by_key(|&index| self.palette.get(index).map_or(0, luma));
        pattern
    }

    /// The entry that is nearest to a colour, which may be outside of all colours.
    fn nearest(&self, goal: [i32; 3]) -> (u8, [i32; 3]) {
        let entries = (0..).zip(self.palette.colors().iter().map(|&color| channels(color).map(i32::from)));
        let distance = |&(_, entry): &(u8, [i32; 3])| (0..3).map(|i| (goal[i] - entry[i]).pow(2)).sum::<i32>();
        entries.min_by_key(distance).unwrap_or_default()
    }
}

fn channels(c: Rgb888) -> [u8; 3] {
    [c.r(), c.g(), c.b()]
}

/// From 0 to 255.
fn luma(c: Rgb888) -> u32 {
    // Parts of 256 of BT.601.
    (77 * u32::from(c.r()) + 150 * u32::from(c.g()) + 29 * u32::from(c.b()) + 128) >> 8
}

/// The grey of a pixel: one of `steps + 1`.
fn grey(color: Rgb888, steps: u32, at: Point) -> u8 {
    // The middle between two numbers of the matrix: 0 is black everywhere, 255 white.
    let level = (luma(color) * steps * 128 / 255 + 127 - (2 * Bayer::<8>::threshold(at) + 1) + 1) / 128;
    u8::try_from(level.min(steps)).unwrap_or(u8::MAX)
}

/// A pixel that the scene can be drawn with.
pub trait Ink: PixelColor + PixelFormat<Color = Self> {
    /// A colour at a place: dithered, where there are few.
    fn ink(color: Rgb888, at: Point, inks: &Inks) -> Self;

    /// A colour that is the same everywhere.
    fn plain(color: Rgb888, inks: &Inks) -> Self;

    /// What a framebuffer of it looks like.
    fn picture(frame: &Framebuffer<'_, Self>, inks: &Inks) -> Picture;
}

macro_rules! greys {
    ($($name:ident, $colors:literal, $what:literal;)*) => {
        $(
            #[doc = $what]
            impl Ink for $name {
                fn ink(color: Rgb888, at: Point, _: &Inks) -> Self {
                    Self::new(grey(color, $colors - 1, at))
                }

                fn plain(color: Rgb888, _: &Inks) -> Self {
                    Self::new(u8::try_from((luma(color) * ($colors - 1) + 127) / 255).unwrap_or(u8::MAX))
                }

                fn picture(frame: &Framebuffer<'_, Self>, _: &Inks) -> Picture {
                    Picture::indexed(frame, &Palette::<Rgb888, $colors>::greys())
                }
            }
        )*
    };
}

greys! {
    Index1, 2, "Black and white, dithered.";
    Index2, 4, "Four greys, dithered.";
    Index8, 256, "256 greys.";
}

/// Sixteen colours, dithered.
impl Ink for Index4 {
    fn ink(color: Rgb888, at: Point, inks: &Inks) -> Self {
        Self::new(inks.index(color, at))
    }

    fn plain(color: Rgb888, inks: &Inks) -> Self {
        Self::new(inks.palette.nearest(color))
    }

    fn picture(frame: &Framebuffer<'_, Self>, inks: &Inks) -> Picture {
        Picture::indexed(frame, &inks.palette)
    }
}

macro_rules! true_color {
    ($($name:ident),*) => {
        $(
            /// The colour itself.
            impl Ink for $name {
                fn ink(color: Rgb888, _: Point, _: &Inks) -> Self {
                    color.into()
                }

                fn plain(color: Rgb888, _: &Inks) -> Self {
                    color.into()
                }

                fn picture(frame: &Framebuffer<'_, Self>, _: &Inks) -> Picture {
                    Picture::of(frame)
                }
            }
        )*
    };
}

true_color!(Rgb565, Rgb888, Xrgb8888);

#[cfg(test)]
mod tests {
    use super::*;

    fn square() -> impl Iterator<Item = Point> {
        (0..8).flat_map(|y| (-8..0).map(move |x| Point::new(x, y)))
    }

    #[test]
    fn greys_are_right_in_the_mean() {
        for steps in [1, 3, 255] {
            for n in 0..=u8::MAX {
                let sum: u32 = square().map(|at| u32::from(grey(Rgb888::new(n, n, n), steps, at))).sum();
                let wanted = u32::from(n) * steps * 64;
                assert!((sum * 255).abs_diff(wanted) <= 255, "{n} of {steps} steps: {sum}");
            }
            let ends =
                [Rgb888::BLACK, Rgb888::WHITE].map(|c| square().map(|at| u32::from(grey(c, steps, at))).sum::<u32>());
            assert_eq!(ends, [0, 64 * steps], "the ends are plain");
        }
    }

    #[test]
    fn a_palette_is_right_in_the_mean() {
        let inks = Inks::new(embedded_raster::pixel::EGA);
        for index in 0..16 {
            let color = embedded_raster::pixel::EGA.colors()[usize::from(index)];
            assert!(square().all(|at| inks.index(color, at) == index), "entry {index} is plain");
        }
        // Mixtures of the entries: what is brighter, they cannot make.
        for n in (0..=170).step_by(5) {
            let color = Rgb888::new(n, 170 - n, 100);
            let all = square().map(|at| embedded_raster::pixel::EGA.colors()[usize::from(inks.index(color, at))]);
            let sum = all.map(channels).fold([0; 3], |sum, c| [0, 1, 2].map(|i| sum[i] + i32::from(c[i])));
            let off = [0, 1, 2].map(|i| (sum[i] / 64 - i32::from(channels(color)[i])).abs());
            // What is owed after sixteen entries is at most half of the largest gap.
            assert!(off.iter().all(|&off| off <= 8), "{color:?}: {off:?}");
        }
    }
}
