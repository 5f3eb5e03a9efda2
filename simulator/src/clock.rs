//! An analogue clock with soft rims, on four kinds of screens: each takes another paint, and the drawing is the same.

mod face;

use embedded_graphics_core::{
    pixelcolor::{BinaryColor, Gray4, Gray8, Rgb565},
    prelude::PixelColor,
};
use embedded_raster::{
    paint::{Cover, CoverIndex, Dithered},
    raster::coverage,
    CoverageSlot, Error, Framebuffer, Index4, Paint, PixelFormat,
};

pub use self::face::Time;
use self::face::{palette, rgb, Face, Ink};
use crate::{bands::in_bands, Picture};

/// What the clock is shown on.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Screen {
    /// One bit per pixel, dithered.
    Mono,
    /// Sixteen greys.
    Gray4,
    /// Sixteen colours of a palette.
    Palette16,
    /// 16 bits.
    Rgb565,
}

impl Screen {
    /// All of them, with their names.
    pub const ALL: [(&'static str, Self); 4] =
        [("mono", Self::Mono), ("gray4", Self::Gray4), ("palette16", Self::Palette16), ("rgb565", Self::Rgb565)];
}

/// Draws the clock in a square of so many pixels, in bands of so many rows.
///
/// # Errors
/// If scratch memory is too small, which is a mistake of this function.
pub fn clock(screen: Screen, size: u16, time: Time, rows: u16) -> Result<Picture, Error> {
    let face = Face { size, time };
    let palette = palette();
    let entry = |ink| palette.nearest(rgb(ink));
    match screen {
        Screen::Mono => {
            let on = |ink| BinaryColor::from(!matches!(ink, Ink::Ground | Ink::Dial));
            let mut ram = bands::<BinaryColor, _>(face, rows, on(Ink::Ground), |ink| Dithered::<_, 4>(on(ink)))?;
            Ok(Picture::of(&Framebuffer::<BinaryColor>::new(&mut ram[..], size, size)?))
        }
        Screen::Gray4 => {
            let gray = |ink| Gray4::from(Gray8::from(rgb(ink)));
            let mut ram = bands::<Gray4, _>(face, rows, gray(Ink::Ground), |ink| Cover(gray(ink)))?;
            Ok(Picture::of(&Framebuffer::<Gray4>::new(&mut ram[..], size, size)?))
        }
        Screen::Palette16 => {
            let index = |ink| Index4::new(entry(ink));
            let make: fn(u8) -> Index4 = Index4::new;
            let paint = |ink| CoverIndex::new(&palette, index(ink), make);
            let mut ram = bands::<Index4, _>(face, rows, index(Ink::Ground), paint)?;
            Ok(Picture::indexed(&Framebuffer::<Index4>::new(&mut ram[..], size, size)?, &palette))
        }
        Screen::Rgb565 => {
            let color = |ink| Rgb565::from(rgb(ink));
            let mut ram = bands::<Rgb565, _>(face, rows, color(Ink::Ground), |ink| Cover(color(ink)))?;
            Ok(Picture::of(&Framebuffer::<Rgb565>::new(&mut ram[..], size, size)?))
        }
    }
}

/// The bytes of the screen, drawn band by band.
fn bands<C, P>(face: Face, rows: u16, ground: C, paint: impl Fn(Ink) -> P) -> Result<Vec<u8>, Error>
where
    C: PixelColor + PixelFormat<Color = C>,
    P: for<'a> Paint<Framebuffer<'a, C>>,
{
    let (table, cells) = (&mut [CoverageSlot::EMPTY; face::SLOTS], &mut vec![0; coverage::cells(face.size)]);
    in_bands::<C, Error>((face.size, face.size), rows, |band| {
        band.clear(ground);
        Ok(face.draw(band, table, cells, &paint)?)
    })
}
