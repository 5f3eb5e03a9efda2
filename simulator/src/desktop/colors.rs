//! [`Colors`]: what the pixels of a frame are, and what they look like.

use std::{cell::RefCell, marker::PhantomData, rc::Rc};

use embedded_graphics_core::pixelcolor::Rgb888;
use embedded_raster::{
    surface::{Frame, Rows},
    Index1, Index2, Index4, Index8, Layout, Palette, PixelFormat,
};

use crate::picture::Picture;

/// How pixels lie in memory, and which colours they are shown in.
///
/// * A [`Palette`] of 2, 4, 16 or 256 colours: rows of indices of 1, 2, 4 or 8 bits.
/// * [`Memory`]: any layout whose pixels are colours, or, by [`through`](Memory::through), whose pixels are indices.
/// * A [`RefCell`] of any of them, behind a reference or an [`Rc`]: a palette that the program changes.
pub trait Colors {
    /// How pixels lie in memory.
    type Layout: Layout;

    /// What a frame shows.
    fn picture(&self, frame: &Frame<&[u8], Self::Layout>) -> Picture;
}

macro_rules! palettes {
    ($($index:ident $colors:literal),*) => {$(
        impl<C: Copy + Into<Rgb888>> Colors for Palette<C, $colors> {
            type Layout = Rows<$index>;

            fn picture(&self, frame: &Frame<&[u8], Rows<$index>>) -> Picture {
                Picture::indexed(frame, self)
            }
        }
    )*};
}

palettes!(Index1 2, Index2 4, Index4 16, Index8 256);

/// Pixels of a layout, shown in the colours that they hold.
/// ```
/// use embedded_graphics_core::pixelcolor::{BinaryColor, Rgb565, RgbColor};
/// use embedded_raster::{pixel::Lsb0, surface::{Pages, Rows}, Canvas};
/// use embedded_raster_simulator::desktop::{Desktop, Input, Memory};
/// let still = [Input::default()];
/// let tft = Desktop::new("tft", (8, 8), Memory::<Rows<Rgb565>>::new());
/// let pictures = tft.play(still.clone(), |frame, _, _| Ok(frame.draw_line((0, 0), (7, 7), Rgb565::RED)))?;
/// assert_eq!(pictures[0].color(3, 3), Some(RgbColor::RED));
/// let oled = Desktop::new("oled", (8, 8), Memory::<Pages<Lsb0<BinaryColor>>>::new());
/// let pictures = oled.play(still, |frame, _, _| Ok(frame.draw_line((0, 0), (7, 7), BinaryColor::On)))?;
/// assert_eq!(pictures[0].color(3, 3), Some(RgbColor::WHITE));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Memory<L>(PhantomData<L>);

impl<L: Layout> Memory<L> {
    /// Of this layout.
    pub const fn new() -> Self {
        Self(PhantomData)
    }

    /// Shown through a palette: pixels are indices.
    pub const fn through<C, const N: usize>(self, palette: Palette<C, N>) -> Through<L, C, N> {
        Through { palette, layout: self.0 }
    }
}

impl<L: Layout> Default for Memory<L> {
    fn default() -> Self {
        Self::new()
    }
}

impl<L: Layout<Color: Into<Rgb888>>> Colors for Memory<L> {
    type Layout = L;

    fn picture(&self, frame: &Frame<&[u8], L>) -> Picture {
        Picture::of(frame)
    }
}

/// Pixels of a layout, shown through a palette: see [`Memory::through`].
#[derive(Debug)]
pub struct Through<L, C, const N: usize> {
    palette: Palette<C, N>,
    layout: PhantomData<L>,
}

impl<L, C, const N: usize> Colors for Through<L, C, N>
where
    L: Layout<Color: PixelFormat + Into<u8>>,
    C: Copy + Into<Rgb888>,
{
    type Layout = L;

    fn picture(&self, frame: &Frame<&[u8], L>) -> Picture {
        Picture::indexed(frame, &self.palette)
    }
}

impl<T: Colors> Colors for &T {
    type Layout = T::Layout;

    fn picture(&self, frame: &Frame<&[u8], T::Layout>) -> Picture {
        T::picture(self, frame)
    }
}

impl<T: Colors> Colors for Rc<T> {
    type Layout = T::Layout;

    fn picture(&self, frame: &Frame<&[u8], T::Layout>) -> Picture {
        T::picture(self, frame)
    }
}

impl<T: Colors> Colors for RefCell<T> {
    type Layout = T::Layout;

    fn picture(&self, frame: &Frame<&[u8], T::Layout>) -> Picture {
        self.borrow().picture(frame)
    }
}
