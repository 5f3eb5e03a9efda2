//! Colour tables that everybody has.

use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};

use super::{levels::EGA_RGB, palette::Palette};

/// The sixteen colours of the IBM Enhanced Graphics Adapter (1984): black, blue, green, cyan, red, magenta, brown, light
/// grey, and the bright ones.
pub const EGA: Palette<Rgb888, 16> = Palette::new(EGA_RGB);

/// The inks of e-paper in black, white and red, for frames of [`Planes`](crate::surface::Planes): plane 0 is white where its bit is
/// set, and plane 1 is red where its bit is set, whatever plane 0 has.
pub const EPAPER_RED: Palette<Rgb888, 4> = Palette::new([Rgb888::BLACK, Rgb888::WHITE, Rgb888::RED, Rgb888::RED]);

/// The inks of e-paper in black, white and yellow: as [`EPAPER_RED`].
pub const EPAPER_YELLOW: Palette<Rgb888, 4> =
    Palette::new([Rgb888::BLACK, Rgb888::WHITE, Rgb888::YELLOW, Rgb888::YELLOW]);

/// The inks of e-paper in black, white, yellow and red, two bits a pixel.
pub const EPAPER_4: Palette<Rgb888, 4> = Palette::new([Rgb888::BLACK, Rgb888::WHITE, Rgb888::YELLOW, Rgb888::RED]);

/// The inks of e-paper in seven colours (`ACeP`, `Gallery`), four bits a pixel: black, white, green, blue, red, yellow, orange. Index 7
/// clears the paper, which leaves it white; what is above is no ink.
///
/// These are the names of the inks, as colours at their purest. Paper shows duller ones, and pictures that are dithered to what was
/// measured on the paper look better than those that are dithered to these.
pub const EPAPER_7: Palette<Rgb888, 8> = Palette::new([
    Rgb888::BLACK,
    Rgb888::WHITE,
    Rgb888::GREEN,
    Rgb888::BLUE,
    Rgb888::RED,
    Rgb888::YELLOW,
    Rgb888::new(255, 128, 0),
    Rgb888::WHITE,
]);
