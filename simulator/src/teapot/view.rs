//! [`View`]: what is shown of a body, and in which colours.

use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
use embedded_raster::Palette;

/// What is shown of a body.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum View {
    /// The sides of its triangles that no other triangle hides: bright where its front is seen, and dark where its back is.
    Wire,
    /// Each triangle in one brightness.
    Flat,
    /// Brightness changes smoothly from corner to corner.
    Gouraud,
    /// A chequerboard on it.
    Textured,
    /// How far away it is: what is near is bright.
    Depth,
    /// The triangles, told apart by colours: numbers are drawn first, and coloured then.
    Id,
    /// The direction in which it looks: red to the right, green up, blue towards the viewer.
    Normal,
    /// Where a pixel lies in its triangle: red, green and blue are the shares of the three corners.
    Barycentric,
    /// How often a pixel is painted, if no triangle hides another one.
    Overdraw,
}

impl View {
    /// All of them.
    pub const ALL: [Self; 9] = [
        Self::Wire,
        Self::Flat,
        Self::Gouraud,
        Self::Textured,
        Self::Depth,
        Self::Id,
        Self::Normal,
        Self::Barycentric,
        Self::Overdraw,
    ];

    /// Its name on a command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Wire => "wire",
            Self::Flat => "flat",
            Self::Gouraud => "gouraud",
            Self::Textured => "textured",
            Self::Depth => "depth",
            Self::Id => "id",
            Self::Normal => "normal",
            Self::Barycentric => "barycentric",
            Self::Overdraw => "overdraw",
        }
    }

    /// Sixteen colours that are enough for it: the background, and fifteen more.
    pub fn palette(self) -> Palette<Rgb888, 16> {
        let mut colors = [BACKGROUND; 16];
        let some = |i: usize| u8::try_from(i).unwrap_or(u8::MAX);
        for (i, color) in colors.iter_mut().skip(1).enumerate() {
            *color = match self {
                Self::Wire => [FRONT, BACK][i % 2],
                // From 0 to 255 in fifteen steps, 255 / 14 = 18.2.
                Self::Flat | Self::Gouraud => lit(CLAY, some(i * 255 / 14)),
                Self::Textured => match i {
                    0..8 => lit(LIGHT, some(i * 255 / 7)),
                    _ => lit(DARK, some((i - 8) * 255 / 6)),
                },
                Self::Depth => grey(some(i * 255 / 14)),
                Self::Id => TOLD_APART[i],
                Self::Normal => NORMALS[i],
                Self::Barycentric => WEIGHTS[i],
                Self::Overdraw => heat(some(i + 1)),
            };
        }
        Palette::new(colors)
    }
}

/// Where nothing is seen.
pub(super) const BACKGROUND: Rgb888 = rgb(0x14_18_20);
/// Lines of a front, and of a back.
pub(super) const FRONT: Rgb888 = rgb(0xff_ff_ff);
pub(super) const BACK: Rgb888 = rgb(0x48_58_70);
/// What the teapot is made of, and the squares of its chequerboard.
pub(super) const CLAY: Rgb888 = rgb(0xe0_8c_50);
pub(super) const LIGHT: Rgb888 = rgb(0xf0_e4_c8);
pub(super) const DARK: Rgb888 = rgb(0x30_68_a8);

/// Fifteen colours that nobody takes for each other.
const TOLD_APART: [Rgb888; 15] = [
    rgb(0xe6_19_4b),
    rgb(0x3c_b4_4b),
    rgb(0xff_e1_19),
    rgb(0x43_63_d8),
    rgb(0xf5_82_31),
    rgb(0x91_1e_b4),
    rgb(0x46_f0_f0),
    rgb(0xf0_32_e6),
    rgb(0xbc_f6_0c),
    rgb(0xfa_be_be),
    rgb(0x00_80_80),
    rgb(0xe6_be_ff),
    rgb(0x9a_63_24),
    rgb(0xff_fa_c8),
    rgb(0x80_80_00),
];

/// Around all directions that look towards the viewer: corners of boxes that hold the half of a ball.
const NORMALS: [Rgb888; 15] = [
    rgb(0x00_00_ff),
    rgb(0x80_00_ff),
    rgb(0xff_00_ff),
    rgb(0x00_80_ff),
    rgb(0x80_80_ff),
    rgb(0xff_80_ff),
    rgb(0x00_ff_ff),
    rgb(0x80_ff_ff),
    rgb(0xff_ff_ff),
    rgb(0x00_00_80),
    rgb(0xff_00_80),
    rgb(0x00_80_80),
    rgb(0xff_80_80),
    rgb(0x00_ff_80),
    rgb(0xff_ff_80),
];

/// All shares in quarters.
const WEIGHTS: [Rgb888; 15] = [
    rgb(0xff_00_00),
    rgb(0xbf_40_00),
    rgb(0xbf_00_40),
    rgb(0x80_80_00),
    rgb(0x80_40_40),
    rgb(0x80_00_80),
    rgb(0x40_bf_00),
    rgb(0x40_80_40),
    rgb(0x40_40_80),
    rgb(0x40_00_bf),
    rgb(0x00_ff_00),
    rgb(0x00_bf_40),
    rgb(0x00_80_80),
    rgb(0x00_40_bf),
    rgb(0x00_00_ff),
];

/// Once, twice, ... fifteen times and more: from cold to white-hot.
const HEAT: [Rgb888; 15] = [
    rgb(0x1c_2c_84),
    rgb(0x1c_5c_c8),
    rgb(0x14_a0_c8),
    rgb(0x14_b4_78),
    rgb(0x50_c8_28),
    rgb(0xa0_dc_14),
    rgb(0xf0_e6_14),
    rgb(0xff_be_00),
    rgb(0xff_8c_00),
    rgb(0xff_50_00),
    rgb(0xf0_14_14),
    rgb(0xff_46_78),
    rgb(0xff_82_b4),
    rgb(0xff_be_dc),
    rgb(0xff_ff_ff),
];

/// The colour of a triangle, by its number.
pub(super) fn told_apart(number: u32) -> Rgb888 {
    TOLD_APART[number as usize % TOLD_APART.len()]
}

/// The colour of a pixel that is painted so often.
pub(super) fn heat(times: u8) -> Rgb888 {
    match usize::from(times) {
        0 => BACKGROUND,
        times => HEAT[(times - 1).min(HEAT.len() - 1)],
    }
}

/// A material in a brightness: black, its own colour at three quarters, and white where the light is reflected.
pub(super) fn lit(material: Rgb888, tone: u8) -> Rgb888 {
    const OWN: u32 = 192;
    let channel = |c: u8| {
        let (c, tone) = (u32::from(c), u32::from(tone));
        let lit = if tone <= OWN { c * tone / OWN } else { c + (255 - c) * (tone - OWN) / (255 - OWN) };
        u8::try_from(lit).unwrap_or(u8::MAX)
    };
    Rgb888::new(channel(material.r()), channel(material.g()), channel(material.b()))
}

pub(super) const fn grey(level: u8) -> Rgb888 {
    Rgb888::new(level, level, level)
}

const fn rgb(hex: u32) -> Rgb888 {
    let [_, r, g, b] = hex.to_be_bytes();
    Rgb888::new(r, g, b)
}
