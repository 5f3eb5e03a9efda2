//! LTDC, the display controller of STM32F4, F7, H7 and others: it reads the framebuffer itself, so nothing is sent. What it is told is where
//! the pixels lie, and their colours.
//!
//! ```text
//!   LxWHPCR  last column << 16 | first column     counted from the horizontal synchronisation on
//!   LxWVPCR  last row << 16 | first row           counted from the vertical synchronisation on
//!   LxPFCR   format of the pixels                 0 XRGB8888, 1 RGB888, 2 RGB565, 5 indices of 8 bits
//!   LxCFBAR  address of the first byte            the program's
//!   LxCFBLR  bytes to the next row << 16 | bytes of a row + a constant
//!   LxCFBLNR rows
//!   LxCLUTWR index << 24 | red << 16 | green << 8 | blue
//! ```
//! A layer of indices is a frame of [`Index8`] and its palette: cycling colours writes some of 256 words, and no
//! pixel. With `embassy-stm32`, [`colors`] are what `Ltdc::init_layer` takes as its table, and the address of
//! [`Frame::memory`] what `set_buffer` takes: `displays/embassy` in the repository does it with that crate's types.
//!
//! Source: STMicroelectronics, RM0090, "LCD-TFT controller", LTDC registers.

use embedded_graphics_core::pixelcolor::{Rgb565, Rgb888, RgbColor};
use embedded_raster::{
    pixel::Xrgb8888,
    surface::{Frame, Rows},
    Index8, Palette, PixelFormat,
};

/// A format that layers can have.
pub trait LayerFormat: PixelFormat {
    /// In the register LxPFCR.
    const CODE: u32;
}

impl LayerFormat for Xrgb8888 {
    const CODE: u32 = 0;
}

impl LayerFormat for Rgb888 {
    const CODE: u32 = 1;
}

impl LayerFormat for Rgb565 {
    const CODE: u32 = 2;
}

impl LayerFormat for Index8 {
    const CODE: u32 = 5;
}

/// What the registers of a layer have to hold.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Layer {
    /// LxWHPCR: columns of the window.
    pub horizontal_position: u32,
    /// LxWVPCR: rows of the window.
    pub vertical_position: u32,
    /// LxPFCR: format of the pixels.
    pub pixel_format: u32,
    /// LxCFBLR: bytes of a row, and to the next one.
    pub line_length: u32,
    /// LxCFBLNR: rows.
    pub line_number: u32,
}

/// What is added to the bytes of a row: 3 on STM32F4, F7 and L4, 7 on STM32H7 and U5, whose bus is wider.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Bus {
    /// Of 32 bits: F4, F7, L4.
    Bits32,
    /// Of 64 bits: H7, U5, N6.
    Bits64,
}

impl Layer {
    /// A layer that shows a frame. The frame is a screen, not a view: a register holds the address of its first pixel.
    ///
    /// * `at`: column and row of the picture that its first pixel is shown at.
    /// * `porch`: the accumulated back porch of the display, horizontal and vertical: what LTDC_BPCR holds.
    ///
    /// ```
    /// use embedded_raster::{Bitmap, Index8};
    /// use embedded_raster_displays::ltdc::{Bus, Layer};
    /// static PIXELS: [u8; 480 * 272] = [0; 480 * 272];
    /// let frame = Bitmap::<Index8>::new(&PIXELS, 480, 272)?;
    /// let layer = Layer::of(&frame, (0, 0), (42, 11), Bus::Bits32);
    /// assert_eq!(layer.horizontal_position, 522 << 16 | 43);
    /// assert_eq!((layer.pixel_format, layer.line_length, layer.line_number), (5, 480 << 16 | 483, 272));
    /// # Ok::<(), embedded_raster::BufferError>(())
    /// ```
    pub fn of<M: AsRef<[u8]>, F: LayerFormat>(
        frame: &Frame<M, Rows<F>>,
        at: (u16, u16),
        porch: (u16, u16),
        bus: Bus,
    ) -> Self {
        let size = frame.size();
        let ends = |first: u16, porch: u16, count: u32| {
            let first = u32::from(first).saturating_add(porch.into()).saturating_add(1);
            first.saturating_add(count).saturating_sub(1) << 16 | first
        };
        let bytes = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
        let more = match bus {
            Bus::Bits32 => 3,
            Bus::Bits64 => 7,
        };
        let row = size.width.saturating_mul(F::BITS / 8);
        Self {
            horizontal_position: ends(at.0, porch.0, size.width),
            vertical_position: ends(at.1, porch.1, size.height),
            pixel_format: F::CODE,
            line_length: bytes(frame.stride()) << 16 | row.saturating_add(more),
            line_number: size.height,
        }
    }
}

/// The words to write to LxCLUTWR, one after the other, for all indices of a palette. Then bit 4 of LxCR enables the table, and LTDC_SRCR
/// loads it at the next vertical blanking.
///
/// ```
/// use embedded_raster::pixel::EGA;
/// use embedded_raster_displays::ltdc;
/// let words: Vec<u32> = ltdc::clut(&EGA).collect();
/// assert_eq!((words.len(), words[1]), (16, 0x01_0000aa)); // index 1 is blue
/// ```
pub fn clut<C: RgbColor + Into<Rgb888>, const N: usize>(palette: &Palette<C, N>) -> impl Iterator<Item = u32> + '_ {
    const { assert!(N <= 256, "the table has 256 entries") };
    (0..=u8::MAX).zip(colors(palette)).map(|(index, [r, g, b])| u32::from_be_bytes([index, r, g, b]))
}

/// Red, green and blue of all indices of a palette, in eight bits each.
pub fn colors<C: RgbColor + Into<Rgb888>, const N: usize>(
    palette: &Palette<C, N>,
) -> impl Iterator<Item = [u8; 3]> + '_ {
    palette.colors().iter().map(|&color| {
        let color: Rgb888 = color.into();
        [color.r(), color.g(), color.b()]
    })
}
