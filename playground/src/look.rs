//! [`Look`]: how a colour becomes bits, by palette and dither, and what the bits look like.

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{raw::RawU16, Gray8, GrayColor, PixelColor, Rgb565, Rgb888, RgbColor},
    prelude::RawData,
};
use embedded_raster::{
    paint::Bayer,
    pixel::{ColorCube, EGA, EPAPER_4, EPAPER_7},
    Index4, Index8, Palette,
};

use crate::choice::{Choice, Colors, Dither};

/// A table of up to 256 colours; what is beyond its end repeats the first one, which nothing is nearer to.
pub type Table = [Rgb888; 256];

/// What a scene draws with: a colour, or an index into the palette of the scene.
pub trait Hue: PixelColor {
    /// The index, of those that have one.
    fn ink(self) -> Option<u8>;

    /// The colour, through the palette of the scene.
    fn color(self, inks: &Table) -> Rgb888;
}

impl Hue for Rgb888 {
    fn ink(self) -> Option<u8> {
        None
    }

    fn color(self, _: &Table) -> Rgb888 {
        self
    }
}

impl Hue for Index4 {
    fn ink(self) -> Option<u8> {
        Some(self.into())
    }

    fn color(self, inks: &Table) -> Rgb888 {
        inks[usize::from(u8::from(self))]
    }
}

impl Hue for Index8 {
    fn ink(self) -> Option<u8> {
        Some(self.into())
    }

    fn color(self, inks: &Table) -> Rgb888 {
        inks[usize::from(u8::from(self))]
    }
}

/// How colours are stored.
#[derive(Clone, Debug)]
pub struct Look {
    depth: u8,
    colors: Colors,
    dither: Dither,
    /// How far thresholds move a level: about the distance of the colours.
    spread: u8,
    /// What indices are shown through.
    table: Table,
    cube: ColorCube<4096>,
    /// The palette of the scene.
    inks: Table,
}

impl Look {
    /// That of a choice, whose scene has these colours.
    pub fn new(choice: &Choice, inks: Table) -> Self {
        let (table, spread) = match (choice.colors, choice.depth) {
            (Colors::Own, 1..=8) => (inks, 64),
            (Colors::Ega, _) => (filled(EGA.colors()), 96),
            (Colors::WebSafe, _) => (filled(Palette::<Rgb888, 216>::web_safe().colors()), 51),
            (Colors::Rgb332, _) => (*Palette::rgb332().colors(), 48),
            (Colors::Inks, 2) => (filled(EPAPER_4.colors()), 160),
            (Colors::Inks, _) => (filled(EPAPER_7.colors()), 160),
            (_, 1) => (filled(Palette::<Rgb888, 2>::greys().colors()), 255),
            (_, 2) => (filled(Palette::<Rgb888, 4>::greys().colors()), 85),
            (_, 4) => (filled(Palette::<Rgb888, 16>::greys().colors()), 17),
            _ => (*Palette::greys().colors(), 1),
        };
        let Choice { depth, colors, dither, .. } = *choice;
        let cube = if depth <= 8 && colors != Colors::Greys {
            ColorCube::new(&Palette::new(table))
        } else {
            // Nobody asks it.
            ColorCube::new(&Palette::new([Rgb888::BLACK]))
        };
        Self { depth, colors, dither, spread, table, cube, inks }
    }

    /// Of pictures in 24 bits that are dithered later.
    #[must_use]
    pub fn full(&self) -> Self {
        Self { depth: 24, dither: Dither::None, ..self.clone() }
    }

    /// Another palette of the scene.
    pub fn set_inks(&mut self, inks: Table) {
        self.inks = inks;
    }

    /// What indices are shown through.
    pub fn table(&self) -> &Table {
        &self.table
    }

    /// Whether a colour is stored the same way at every pixel.
    pub fn is_flat<C: Hue>(&self, color: C) -> bool {
        self.direct(color).is_some() || matches!(self.dither, Dither::None | Dither::FloydSteinberg) || self.depth > 16
    }

    /// The bits of a colour at a pixel. Error diffusion asks for the nearest colour.
    pub fn bits<C: Hue>(&self, color: C, at: Point) -> u32 {
        if let Some(index) = self.direct(color) {
            return index.into();
        }
        let color = color.color(&self.inks);
        let [r, g, b] = [color.r(), color.g(), color.b()];
        match self.depth {
            16 if self.dither == Dither::None || self.dither == Dither::FloydSteinberg => {
                RawU16::from(Rgb565::from(color)).into_inner().into()
            }
            16 => {
                let shade = |level, most| u32::from(self.shade(level, most, at));
                shade(r, 31) << 11 | shade(g, 63) << 5 | shade(b, 31)
            }
            24 | 32 => u32::from(r) << 16 | u32::from(g) << 8 | u32::from(b),
            _ if self.colors == Colors::Greys => {
                let most = (1_u16 << self.depth) - 1;
                self.shade(Gray8::from(color).luma(), most as u8, at).into()
            }
            _ => {
                let [r, g, b] = [r, g, b].map(|level| self.moved(level, at));
                self.cube.nearest(Rgb888::new(r, g, b)).into()
            }
        }
    }

    /// What bits look like, with indices through a table.
    pub fn shown(&self, bits: u32, table: &Table) -> Rgb888 {
        match self.depth {
            16 => Rgb565::from(RawU16::new(bits as u16)).into(),
            24 | 32 => Rgb888::new((bits >> 16) as u8, (bits >> 8) as u8, bits as u8),
            _ => table[(bits & 255) as usize],
        }
    }

    /// The index of an ink that is stored as it is.
    fn direct<C: Hue>(&self, color: C) -> Option<u8> {
        color.ink().filter(|_| self.colors == Colors::Own && self.depth <= 8)
    }

    /// The shade of a level, of 0 to `most`.
    fn shade(&self, level: u8, most: u8, at: Point) -> u8 {
        match self.dither {
            Dither::None | Dither::FloydSteinberg => ((2 * u16::from(most) * u16::from(level) + 255) / 510) as u8,
            Dither::Bayer2 => Bayer::<2>::shade(level, most, at),
            Dither::Bayer4 => Bayer::<4>::shade(level, most, at),
            Dither::Bayer8 => Bayer::<8>::shade(level, most, at),
        }
    }

    /// A level that the threshold of a pixel has moved.
    fn moved(&self, level: u8, at: Point) -> u8 {
        match self.dither {
            Dither::None | Dither::FloydSteinberg => level,
            Dither::Bayer2 => Bayer::<2>::moved(level, self.spread, at),
            Dither::Bayer4 => Bayer::<4>::moved(level, self.spread, at),
            Dither::Bayer8 => Bayer::<8>::moved(level, self.spread, at),
        }
    }
}

/// A table of these colours.
pub fn filled(colors: &[Rgb888]) -> Table {
    let mut table = [colors.first().copied().unwrap_or_default(); 256];
    for (place, &color) in table.iter_mut().zip(colors) {
        *place = color;
    }
    table
}
