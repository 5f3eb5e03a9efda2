//! Pictures of many colours in few: which colours are best, and the nearest of them for each pixel.
//!
//! ```text
//!   picture of colours  --->  palette of N  --->  indexed picture of 1, 2, 4 or 8 bits, or dither
//! ```
//! ```
//! use embedded_graphics_core::pixelcolor::Rgb888;
//! use embedded_raster_simulator::{quantize::palette, Picture};
//! let greys = (0..=255).map(|n| Rgb888::new(n, n, n)).collect();
//! let picture = Picture::from_colors(16, 16, greys);
//! let colors = palette(&picture, 4);
//! assert_eq!(colors.len(), 4);
//! let indexed = picture.quantized(&colors);
//! assert_eq!((indexed.index(0, 0), indexed.index(15, 15)), (Some(0), Some(3)));
//! ```

use std::collections::BTreeMap;

use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
use quantette::{palette::Srgb, ColorSpace, PalettePipeline, QuantizeMethod};

use crate::picture::Picture;

/// The colours, `count` at most, that show a picture best, from dark to bright; `count` is cut to 1 to 256.
///
/// A picture that has no more colours than that keeps them. Others are cut into boxes of colours, and the boxes are moved to where the
/// colours are; distances are those of Oklab, which is even to the eye. The same picture always gives the same colours.
///
/// Sources: X. Wu, "Color Quantization by Dynamic Programming and Principal Analysis", ACM Transactions on Graphics 11, 1992;
/// J. MacQueen, "Some Methods for Classification and Analysis of Multivariate Observations", 1967; B. Ottosson, "A perceptual color
/// space for image processing", 2020.
#[expect(clippy::doc_markdown, reason = "a name in it is written so")]
pub fn palette(picture: &Picture, count: usize) -> Vec<Rgb888> {
    let count = count.clamp(1, 256);
    let mut found = distinct(picture.colors());
    if found.len() > count {
        let colors: Vec<_> = picture.colors().map(|c| Srgb::new(c.r(), c.g(), c.b())).collect();
        found = chosen(&colors, count);
    }
    found.sort_by_key(|&color| brightness(color));
    found
}

/// What the crate chooses.
fn chosen(colors: &[Srgb<u8>], count: usize) -> Vec<Rgb888> {
    let size = u16::try_from(count).unwrap_or(u16::MAX);
    // Pictures of more than 2^32 - 1 pixels are none that fit in memory.
    let (Ok(mut pipeline), Ok(size)) = (PalettePipeline::try_from(colors), quantette::PaletteSize::try_from(size))
    else {
        return vec![];
    };
    pipeline.palette_size(size).colorspace(ColorSpace::Oklab).quantize_method(QuantizeMethod::kmeans());
    let chosen = pipeline.palette().into_iter().map(|color| Rgb888::new(color.red, color.green, color.blue));
    distinct(chosen)
}

/// Each colour once.
fn distinct(colors: impl Iterator<Item = Rgb888>) -> Vec<Rgb888> {
    let numbered: BTreeMap<_, _> = colors.map(|color| ((color.r(), color.g(), color.b()), color)).collect();
    numbered.into_values().collect()
}

/// Roughly what the eye sees of it.
fn brightness(c: Rgb888) -> (u32, u8, u8) {
    (2 * u32::from(c.r()) + 5 * u32::from(c.g()) + u32::from(c.b()), c.r(), c.g())
}

/// The entry that is nearest to a colour, as [`Palette::nearest`](embedded_raster::Palette::nearest) finds it: least sum of squared
/// differences, the first one at a tie; 0 of an empty table.
pub fn nearest(palette: &[Rgb888], color: Rgb888) -> u8 {
    let square = |a: u8, b: u8| u32::from(a.abs_diff(b)).pow(2);
    let distance = |c: &Rgb888| square(c.r(), color.r()) + square(c.g(), color.g()) + square(c.b(), color.b());
    let best = (0..=u8::MAX).zip(palette).min_by_key(|(_, entry)| distance(entry));
    best.map_or(0, |(index, _)| index)
}

impl Picture {
    /// The nearest of these colours for each pixel, in as few bits as they need: 1, 2, 4 or 8. Dither makes more of them: see the
    /// example `dither`.
    ///
    /// # Panics
    /// If there are no colours, or more than 256.
    #[must_use]
    pub fn quantized(&self, palette: &[Rgb888]) -> Self {
        let bits = [1, 2, 4, 8].into_iter().find(|bits| palette.len() <= 1 << bits).expect("256 colours at most");
        let indices = self.colors().map(|color| nearest(palette, color)).collect();
        Self::from_indices(self.width(), self.height(), bits, palette.to_vec(), indices)
    }

    /// How far another picture of the same size is from this one: the mean of the squared differences of all channels of all pixels.
    pub fn mean_square_error(&self, other: &Self) -> f64 {
        let square = |a: u8, b: u8| u64::from(a.abs_diff(b)).pow(2);
        let pair = |(a, b): (Rgb888, Rgb888)| square(a.r(), b.r()) + square(a.g(), b.g()) + square(a.b(), b.b());
        let sum: u64 = self.colors().zip(other.colors()).map(pair).sum();
        #[expect(clippy::cast_precision_loss, reason = "a mean")]
        let mean = sum as f64 / (3 * self.width() * self.height()).max(1) as f64;
        mean
    }
}

#[cfg(test)]
mod tests {
    use embedded_raster::{pixel::EGA, Palette};

    use super::*;

    /// A picture with a soft course of all hues, and a small part that is red.
    fn hues() -> Picture {
        let level = |n: i32| u8::try_from(n.clamp(0, 255)).expect("a level");
        let colors = (0..64 * 64).map(|at: i32| {
            let (x, y) = (at % 64, at / 64);
            match (x - 50).pow(2) + (y - 12).pow(2) {
                0..40 => Rgb888::new(250, 10, 30),
                _ => Rgb888::new(level(x * 3), level(y * 4), level(200 - x - y)),
            }
        });
        Picture::from_colors(64, 64, colors.collect())
    }

    #[test]
    fn few_colors_are_kept() {
        let ega = Picture::from_colors(4, 4, EGA.colors().to_vec());
        for count in [16, 17, 256, 999] {
            let colors = palette(&ega, count);
            assert_eq!(colors.len(), 16, "no more than there are");
            let quantized = ega.quantized(&colors);
            assert!(quantized.colors().eq(ega.colors()), "nothing changes");
        }
        assert_eq!(palette(&ega, 0).len(), 1, "at least one");
        assert_eq!(palette(&Picture::from_colors(0, 0, vec![]), 4), [], "of nothing, nothing");
    }

    #[test]
    fn more_colors_are_nearer() {
        let picture = hues();
        let mut last = f64::INFINITY;
        for count in [2, 4, 8, 16, 32, 64, 128, 256] {
            let colors = palette(&picture, count);
            assert!(colors.len() <= count && colors.len() > count / 2, "{} of {count}", colors.len());
            assert!(colors.windows(2).all(|pair| brightness(pair[0]) <= brightness(pair[1])), "from dark to bright");
            let error = picture.mean_square_error(&picture.quantized(&colors));
            assert!(error < last, "{count} colours: {error} after {last}");
            last = error;
        }
        assert!(last < 20.0, "256 colours: {last}");
        assert_eq!(palette(&picture, 16), palette(&picture, 16), "the same every time");
    }

    /// What is made for a picture is better than what is made for any.
    #[test]
    fn colors_of_the_picture_are_better_than_those_of_a_table() {
        let picture = hues();
        let error = |colors: &[Rgb888]| picture.mean_square_error(&picture.quantized(colors));
        let own = error(&palette(&picture, 16));
        assert!(4.0 * own < error(EGA.colors()), "{own} against {}", error(EGA.colors()));
        let red = palette(&picture, 16).into_iter().map(|c| c.r().abs_diff(250).max(c.g().abs_diff(10))).min();
        assert!(red.is_some_and(|away| away < 30), "a small part is not forgotten: {red:?}");
        let (own, table) = (error(&palette(&picture, 256)), error(Palette::<Rgb888, 256>::rgb332().colors()));
        assert!(4.0 * own < table, "{own} against {table}");
    }

    #[test]
    fn nearest_is_that_of_palettes() {
        for color in hues().colors().step_by(7) {
            assert_eq!(nearest(EGA.colors(), color), EGA.nearest(color), "{color:?}");
        }
        assert_eq!(nearest(&[], Rgb888::RED), 0, "of nothing");
    }
}
