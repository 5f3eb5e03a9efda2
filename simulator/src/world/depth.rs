//! [`Depth`]: the colours of the map at every depth.

use embedded_graphics_core::pixelcolor::{PixelColor, Rgb565, Rgb888, RgbColor};
use embedded_raster::{pixel::Xrgb8888, Framebuffer, Index1, Index2, Index4, Index8, Palette, PixelFormat};

use crate::picture::Picture;

/// What a pixel of the map can be part of.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Part {
    /// Nothing: the screen around the globe.
    Paper,
    /// The sea, and lakes.
    Sea,
    /// Meridians and parallels.
    Grid,
    /// A border with the sea.
    Coast,
    /// A border between countries.
    Border,
    /// A country.
    Land {
        /// Its number on the map.
        country: usize,
        /// Its colour, one of [`Part::LAND_COLORS`].
        color: usize,
    },
}

impl Part {
    /// How many colours countries have.
    pub const LAND_COLORS: usize = 6;

    /// Its place in [`PALETTE`].
    #[expect(clippy::cast_possible_truncation, reason = "at most 10")]
    fn index(self) -> u8 {
        match self {
            Self::Paper => 0,
            Self::Sea => 1,
            Self::Grid => 2,
            Self::Coast => 3,
            Self::Border => 4,
            Self::Land { color, .. } => 5 + (color % Self::LAND_COLORS) as u8,
        }
    }

    /// Its colour.
    pub fn rgb(self) -> Rgb888 {
        PALETTE.get(self.index()).unwrap_or(Rgb888::BLACK)
    }
}

const fn rgb(hex: u32) -> Rgb888 {
    let [_, r, g, b] = hex.to_be_bytes();
    Rgb888::new(r, g, b)
}

/// The sixteen colours of the map: paper, sea, grid, coast, border, six for countries, and five that are free.
pub const PALETTE: Palette<Rgb888, 16> = Palette::new([
    rgb(0xfb_f9_f3),
    rgb(0xb9_d8_ea),
    rgb(0xa6_cb_e1),
    rgb(0x6b_9a_bb),
    rgb(0x7a_5c_48),
    rgb(0xf4_dc_a3),
    rgb(0xc8_df_9f),
    rgb(0xf4_b8_a4),
    rgb(0xd6_c1_e4),
    rgb(0xf8_f1_ae),
    rgb(0xa5_d6_c0),
    rgb(0xff_ff_ff),
    rgb(0x9a_9a_9a),
    rgb(0x50_50_50),
    rgb(0xc0_30_20),
    rgb(0x00_00_00),
]);

/// A colour that the map can be drawn in.
pub trait Depth: PixelColor + PixelFormat<Color = Self> {
    /// What a part is painted with.
    fn ink(part: Part) -> Self;

    /// What a framebuffer of it looks like, with the colours of the countries moved on by `turns` places where there is a
    /// palette: not one byte of the framebuffer changes for it.
    fn picture(frame: &Framebuffer<'_, Self>, turns: usize) -> Picture;
}

/// Sea, and land.
impl Depth for Index1 {
    fn ink(part: Part) -> Self {
        Self::new(matches!(part, Part::Land { .. } | Part::Paper).into())
    }

    fn picture(frame: &Framebuffer<'_, Self>, turns: usize) -> Picture {
        let mut palette = Palette::new([rgb(0x1d_33_4a), rgb(0xf6_ec_cf)]);
        palette.rotate(0..2, turns);
        Picture::indexed(frame, &palette)
    }
}

/// Sea, lines, and two colours of land.
impl Depth for Index2 {
    fn ink(part: Part) -> Self {
        Self::new(match part {
            Part::Sea | Part::Grid => 0,
            Part::Coast | Part::Border => 1,
            Part::Paper => 2,
            Part::Land { color, .. } => [2, 3][color % 2],
        })
    }

    fn picture(frame: &Framebuffer<'_, Self>, turns: usize) -> Picture {
        let mut palette = Palette::new([rgb(0xb9_d8_ea), rgb(0x4a_5a_68), rgb(0xfb_f4_e0), rgb(0xee_cf_98)]);
        palette.rotate(2..4, turns);
        Picture::indexed(frame, &palette)
    }
}

/// As [`PALETTE`] says.
impl Depth for Index4 {
    fn ink(part: Part) -> Self {
        Self::new(part.index())
    }

    fn picture(frame: &Framebuffer<'_, Self>, turns: usize) -> Picture {
        let mut palette = PALETTE;
        palette.rotate(5..5 + Part::LAND_COLORS, turns);
        Picture::indexed(frame, &palette)
    }
}

/// [`PALETTE`], and then an entry for each country: a shade of its colour.
impl Depth for Index8 {
    #[expect(clippy::cast_possible_truncation, reason = "at most 255")]
    fn ink(part: Part) -> Self {
        Self::new(match part {
            Part::Land { country, color } => {
                // As many rows of six as there is room for: the entry tells the colour.
                let row = country % (240 / Part::LAND_COLORS);
                (16 + row * Part::LAND_COLORS + color % Part::LAND_COLORS) as u8
            }
            other => other.index(),
        })
    }

    fn picture(frame: &Framebuffer<'_, Self>, turns: usize) -> Picture {
        let mut colors = [Rgb888::BLACK; 256];
        let (parts, countries) = colors.split_at_mut(16);
        parts.copy_from_slice(PALETTE.colors());
        for (row, shades) in countries.chunks_exact_mut(Part::LAND_COLORS).enumerate() {
            for (shade, &color) in shades.iter_mut().zip(&PALETTE.colors()[5..]) {
                *shade = shaded(color, row);
            }
        }
        let mut palette = Palette::new(colors);
        palette.rotate(16..256, turns);
        Picture::indexed(frame, &palette)
    }
}

/// A colour darkened by one of five small steps.
fn shaded(c: Rgb888, row: usize) -> Rgb888 {
    let keep = [100, 96, 92, 98, 94][row % 5];
    let [r, g, b] =
        [c.r(), c.g(), c.b()].map(|channel| u8::try_from(u32::from(channel) * keep / 100).unwrap_or(u8::MAX));
    Rgb888::new(r, g, b)
}

macro_rules! true_color {
    ($($name:ident),*) => {
        $(
            /// The colours of [`PALETTE`] themselves.
            impl Depth for $name {
                fn ink(part: Part) -> Self {
                    part.rgb().into()
                }

                fn picture(frame: &Framebuffer<'_, Self>, _: usize) -> Picture {
                    Picture::of(frame)
                }
            }
        )*
    };
}

true_color!(Rgb565, Rgb888, Xrgb8888);
