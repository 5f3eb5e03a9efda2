//! [`Picture`]: pixels that outlive their framebuffer.

use embedded_graphics_core::{
    geometry::{OriginDimensions, Point},
    image::GetPixel,
    pixelcolor::{Rgb888, RgbColor},
};
use embedded_raster::{Palette, PixelFormat, Rect};

/// A copy of what a framebuffer showed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    width: usize,
    height: usize,
    pixels: Pixels,
}

/// The pixels of a [`Picture`], row by row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Pixels {
    /// Indices of `bits` bits, one a byte, and the `2^bits` colours that they stand for.
    Indexed {
        /// 1, 2, 4 or 8.
        bits: u8,
        /// A colour for every index.
        palette: Vec<Rgb888>,
        /// Each below `2^bits`.
        indices: Vec<u8>,
    },
    /// Colours.
    Rgb(Vec<Rgb888>),
}

impl Picture {
    /// What a framebuffer, or anything else that can be read, shows by the colours it holds.
    ///
    /// Pixels that are not in memory, those of other bands, are black.
    pub fn of<S>(source: &S) -> Self
    where
        S: GetPixel + OriginDimensions,
        S::Color: Into<Rgb888>,
    {
        let (width, height, points) = points(source);
        let pixels = points.map(|p| source.pixel(p).map_or(Rgb888::BLACK, Into::into)).collect();
        Self { width, height, pixels: Pixels::Rgb(pixels) }
    }

    /// What a framebuffer of indices shows through a palette.
    ///
    /// An index beyond the palette is shown as its first colour; pixels that are not in memory have index 0.
    ///
    /// # Panics
    /// If the palette is empty.
    pub fn indexed<S, C, const N: usize>(source: &S, palette: &Palette<C, N>) -> Self
    where
        S: GetPixel + OriginDimensions,
        S::Color: PixelFormat + Into<u8>,
        C: Copy + Into<Rgb888>,
    {
        let bits = u8::try_from(<S::Color as PixelFormat>::BITS).expect("formats have at most 32 bits");
        let (width, height, points) = points(source);
        let indices = points.map(|p| source.pixel(p).map_or(0, Into::into)).collect();
        let colors = palette.colors().iter().map(|&color| color.into()).collect();
        Self::from_indices(width, height, bits, colors, indices)
    }

    /// A picture of indices of `bits` bits, with a palette that is cut or filled up to the length it needs.
    pub(crate) fn from_indices(
        width: usize,
        height: usize,
        bits: u8,
        mut palette: Vec<Rgb888>,
        indices: Vec<u8>,
    ) -> Self {
        let first = *palette.first().expect("a palette has a colour");
        palette.resize(1 << bits, first);
        Self { width, height, pixels: Pixels::Indexed { bits, palette, indices } }
    }

    /// A picture of colours.
    pub fn from_colors(width: usize, height: usize, colors: Vec<Rgb888>) -> Self {
        Self { width, height, pixels: Pixels::Rgb(colors) }
    }

    /// Columns.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> usize {
        self.height
    }

    /// The pixels as they are kept.
    pub fn pixels(&self) -> &Pixels {
        &self.pixels
    }

    /// The colour that a pixel is shown in; `None` outside.
    pub fn color(&self, x: usize, y: usize) -> Option<Rgb888> {
        let at = self.at(x, y)?;
        match &self.pixels {
            Pixels::Indexed { palette, indices, .. } => palette.get(usize::from(*indices.get(at)?)).copied(),
            Pixels::Rgb(colors) => colors.get(at).copied(),
        }
    }

    /// The colours of all pixels, row by row.
    pub fn colors(&self) -> impl Iterator<Item = Rgb888> + '_ {
        (0..self.height).flat_map(move |y| (0..self.width).filter_map(move |x| self.color(x, y)))
    }

    /// The index of a pixel; `None` outside and in a picture of colours.
    pub fn index(&self, x: usize, y: usize) -> Option<u8> {
        match &self.pixels {
            Pixels::Indexed { indices, .. } => indices.get(self.at(x, y)?).copied(),
            Pixels::Rgb(_) => None,
        }
    }

    /// Every pixel as a square of `zoom` x `zoom` pixels.
    #[must_use]
    pub fn zoomed(&self, zoom: usize) -> Self {
        let (width, height) = (self.width * zoom, self.height * zoom);
        let from = |at: usize| at / width / zoom * self.width + at % width / zoom;
        let all = 0..width * height;
        let pixels = match &self.pixels {
            Pixels::Indexed { bits, palette, indices } => Pixels::Indexed {
                bits: *bits,
                palette: palette.clone(),
                indices: all.map(|at| indices[from(at)]).collect(),
            },
            Pixels::Rgb(colors) => Pixels::Rgb(all.map(|at| colors[from(at)]).collect()),
        };
        Self { width, height, pixels }
    }

    /// In colours, with a frame one pixel wide just inside of each rectangle.
    #[must_use]
    pub fn outlined(&self, areas: &[Rect], color: Rgb888) -> Self {
        let inside = |area: &Rect, x: i32, y: i32| area.contains(x, y) && !area.inset(1).contains(x, y);
        let is_on = |at: usize| {
            let [x, y] = [at % self.width, at / self.width].map(|n| i32::try_from(n).unwrap_or(i32::MAX));
            areas.iter().any(|area| inside(area, x, y))
        };
        let colors = self.colors().enumerate().map(|(at, old)| if is_on(at) { color } else { old });
        Self::from_colors(self.width, self.height, colors.collect())
    }

    fn at(&self, x: usize, y: usize) -> Option<usize> {
        (x < self.width && y < self.height).then(|| y * self.width + x)
    }
}

/// Width, height, and every point of a source row by row.
fn points(source: &impl OriginDimensions) -> (usize, usize, impl Iterator<Item = Point>) {
    let size = source.size();
    let [width, height] = [size.width, size.height].map(|n| i32::try_from(n).unwrap_or(i32::MAX));
    let points = (0..height).flat_map(move |y| (0..width).map(move |x| Point::new(x, y)));
    (size.width as usize, size.height as usize, points)
}

#[cfg(test)]
mod tests {
    use embedded_graphics_core::pixelcolor::{BinaryColor, Gray4, Rgb565};
    use embedded_raster::{pixel::EGA, surface::Paged, Framebuffer, Index2};

    use super::*;

    #[test]
    fn indices_keep_their_palette() {
        let mut ram = [0b00_01_10_11];
        let frame = Framebuffer::<Index2>::new(&mut ram, 4, 1).expect("it fits");
        let picture = Picture::indexed(&frame, &EGA);
        assert_eq!([0, 1, 2, 3].map(|x| picture.index(x, 0)), [Some(0), Some(1), Some(2), Some(3)], "indices");
        assert_eq!(picture.color(2, 0), EGA.get(2), "colours");
        assert_eq!((picture.index(4, 0), picture.color(0, 1)), (None, None), "outside");
        let Pixels::Indexed { bits, palette, .. } = picture.pixels() else { panic!("not indexed") };
        assert_eq!((*bits, &palette[..]), (2, &EGA.colors()[..4]), "as long as the indices need");
    }

    #[test]
    fn colors_of_any_depth() {
        let mut ram = [0x0f];
        let grey = Picture::of(&Framebuffer::<Gray4>::new(&mut ram, 2, 1).expect("it fits"));
        assert_eq!(grey.color(0, 0), Some(Rgb888::BLACK), "black");
        assert_eq!(grey.color(1, 0), Some(Rgb888::WHITE), "white");
        let mut ram = [0x00, 0xf8];
        let red = Picture::of(&Framebuffer::<Rgb565>::new(&mut ram, 1, 1).expect("it fits"));
        assert_eq!(red.color(0, 0), Some(Rgb888::RED), "red");
        let mut ram = [0b10];
        let oled = Picture::of(&Paged::<BinaryColor>::new(&mut ram, 1, 2).expect("it fits"));
        assert_eq!(oled.color(0, 1), Some(Rgb888::WHITE), "paged");
        assert_eq!(oled.zoomed(2).color(1, 2), Some(Rgb888::WHITE), "zoomed");
    }
}
