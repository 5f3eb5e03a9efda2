//! [`Tft`]: colour displays whose controller speaks the MIPI display command set: ST7789, ST7735, ILI9341, ILI9488, GC9A01 and many others.
//!
//! ```text
//!   0x2a CASET  first and last column, 16 bits each, high byte first
//!   0x2b RASET  first and last row
//!   0x2c RAMWR  the pixels of that window, row by row
//! ```
//! A window is sent for each damaged rectangle, or for a band, or for the whole frame; then its pixels follow as they lie in memory, if the
//! frame has the format of the display, or through a palette. The controller is set up by somebody else, the crate `mipidsi` for example:
//! initialise it there, [`release`](https://docs.rs/mipidsi/latest/mipidsi/struct.Display.html#method.release) the bus, and send frames
//! from here; or lend its interface to a closure for each frame. One of 16 wires takes words:
//! ```
//! use embedded_raster_displays::{Transfer, Transfers};
//! use mipidsi::interface::Interface;
//! fn send<DI: Interface<Word = u16>>(transfers: impl Transfers, di: &mut DI) -> Result<(), DI::Error> {
//!     transfers.send(|Transfer { command, data }| match command {
//!         [0x2c] | [] => {
//!             command.iter().try_for_each(|&command| di.send_command(command, &[]))?;
//!             di.send_pixels(data.chunks_exact(2).map(|pixel| [u16::from_be_bytes([pixel[0], pixel[1]])]))
//!         }
//!         [command, ..] => di.send_command(*command, data),
//!     })
//! }
//! ```
//!
//! Source: "MIPI Alliance Specification for Display Command Set", as the datasheets of ST7789V and ILI9341 repeat it.

use core::marker::PhantomData;

use embedded_graphics_core::pixelcolor::{Rgb565, Rgb666, RgbColor};
use embedded_raster::{
    pixel::Be,
    surface::{Frame, Layout, Packed12, Rows},
    Palette, PixelFormat, Rect,
};

use crate::{
    error::Error,
    pieces::{converted, copied, index, through, Lines, Lying, Nothing},
    transfer::{Once, Transfers},
    windows::{ends, Say, Windows},
};

const CASET: &[u8] = &[0x2a];
const RASET: &[u8] = &[0x2b];
const RAMWR: &[u8] = &[0x2c];
const MADCTL: [u8; 1] = [0x36];

/// RGB666 as displays are sent it: a byte for each channel, red first, with six bits at its top. A format like others: frames can have it.
///
/// A frame of `Be<Rgb888>` lies as such a display wants it too: the low two bits of each byte are not looked at.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Upper666;

impl PixelFormat for Upper666 {
    type Color = Rgb666;
    const BITS: u32 = 24;

    fn pack(color: Rgb666) -> u32 {
        u32::from_le_bytes([color.r() << 2, color.g() << 2, color.b() << 2, 0])
    }

    fn unpack(bits: u32) -> Rgb666 {
        let [r, g, b, _] = bits.to_le_bytes();
        Rgb666::new(r >> 2, g >> 2, b >> 2)
    }
}

/// A display that takes RGB565, the high byte first: what most are set to.
pub type Tft565 = Tft<Rows<Be<Rgb565>>>;
/// A display that takes RGB666: ILI9488 on SPI takes nothing else.
pub type Tft666 = Tft<Rows<Upper666>>;
/// A display that takes RGB444, two pixels in three bytes: a quarter less to send than RGB565.
pub type Tft444 = Tft<Packed12>;

/// How a panel's picture lies in the controller's memory: turned, and perhaps mirrored. The registers do it, at no cost.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Orientation {
    /// Clockwise; of other numbers than 0 to 3, the low two bits.
    pub quarter_turns: u8,
    /// Left and right are exchanged, before it is turned.
    pub is_mirrored: bool,
}

impl Orientation {
    /// Whether rows are read from the bottom, columns from the right, and both exchanged: the upper three bits of MADCTL.
    const fn reversed(self) -> (bool, bool, bool) {
        let turns = self.quarter_turns & 3;
        let (rows, columns) = (turns >= 2, turns == 1 || turns == 2);
        (rows, columns != self.is_mirrored, !turns.is_multiple_of(2))
    }
}

/// The glass in front of a controller, which may have memory for more pixels. Numbers are columns and rows as the display is built, not
/// turned.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Panel {
    /// Of the controller: 240 x 320 for ST7789 and ILI9341.
    pub memory: (u16, u16),
    /// Of the glass.
    pub size: (u16, u16),
    /// The first column and row in memory that can be seen.
    pub at: (u16, u16),
}

/// A display that is sent windows of pixels. `L` is how it wants them: frames of that layout are sent as they lie.
///
/// It has no state but the place of its panel, and may be made anew at any time.
#[derive(Debug)]
pub struct Tft<L> {
    columns: u16,
    rows: u16,
    layout: PhantomData<L>,
}

impl<L> Copy for Tft<L> {}

impl<L> Clone for Tft<L> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<L: Layout> Default for Tft<L> {
    fn default() -> Self {
        Self::new()
    }
}

impl<L: Layout> Tft<L> {
    /// A panel whose first pixel is the controller's first.
    pub const fn new() -> Self {
        Self { columns: 0, rows: 0, layout: PhantomData }
    }

    /// A panel whose first pixel is in this column and row of the controller's memory, as the display is turned now.
    #[must_use]
    pub const fn with_offset(self, columns: u16, rows: u16) -> Self {
        Self { columns, rows, ..self }
    }

    /// A panel in an orientation: what is not seen of the memory may then lie on the other side.
    /// ```
    /// use embedded_raster_displays::{tft::{Orientation, Panel}, Tft565};
    /// // 240 x 240 pixels at the top of an ST7789's memory. Upside down, the 80 rows below them come first.
    /// let panel = Panel { memory: (240, 320), size: (240, 240), at: (0, 0) };
    /// let upside_down = Orientation { quarter_turns: 2, is_mirrored: false };
    /// assert_eq!(Tft565::of_panel(panel, upside_down).offset(), (0, 80));
    /// ```
    pub const fn of_panel(panel: Panel, orientation: Orientation) -> Self {
        let Panel { memory, size, at } = panel;
        let (rows_reversed, columns_reversed, is_swapped) = orientation.reversed();
        let columns = if columns_reversed { memory.0.saturating_sub(size.0).saturating_sub(at.0) } else { at.0 };
        let rows = if rows_reversed { memory.1.saturating_sub(size.1).saturating_sub(at.1) } else { at.1 };
        if is_swapped {
            Self::new().with_offset(rows, columns)
        } else {
            Self::new().with_offset(columns, rows)
        }
    }

    /// What is added to columns and rows.
    pub const fn offset(self) -> (u16, u16) {
        (self.columns, self.rows)
    }

    /// Turns the display: 0x36, MADCTL, whose upper three bits are rows from the bottom, columns from the right, and both exchanged. Bit 3 is
    /// the order of the colour filter: `is_bgr` where red and blue would be exchanged without.
    ///
    /// Pixels that it shows stay where they are in memory: send a frame after it.
    pub fn orientation(self, orientation: Orientation, is_bgr: bool) -> impl Transfers {
        let (rows, columns, is_swapped) = orientation.reversed();
        let bits = u8::from(rows) << 7 | u8::from(columns) << 6 | u8::from(is_swapped) << 5 | u8::from(is_bgr) << 3;
        Once::new(MADCTL, [bits])
    }

    /// The commands for a window, without pixels: for those that send them in parts, such as bands.
    ///
    /// After it, [`pixels`](Self::pixels) of bands fill the window from its top, without any more commands. So a band is on its way
    /// from the first moment on that its transfer is polled, and the next one can be drawn beside it.
    pub fn window(self, area: Rect) -> impl Transfers {
        Windows::new([area].into_iter().filter(|area| !area.is_empty()), Nothing, self.say())
    }

    /// Sends areas of a frame of any layout whose colours `convert` turns into those of the display: RGB666 of a frame of RGB565, say, or
    /// RGB444 of indices.
    ///
    /// * `line`: memory that pixels are converted in. If it holds some rows of an area, so many are sent at once.
    ///
    /// ```
    /// use embedded_graphics_core::pixelcolor::{Rgb565, Rgb666, RgbColor};
    /// use embedded_raster::{pixel::EGA, Bitmap, Index4};
    /// use embedded_raster_displays::{Tft666, Transfers};
    /// let picture = Bitmap::<Index4>::new(&[0x0c], 2, 1)?;
    /// let (mut line, mut sent) = ([0; 2 * 3], vec![]);
    /// let color = |index: Index4| EGA.get(index.index()).unwrap_or(RgbColor::BLACK).into();
    /// Tft666::new().converted(&picture, [picture.window()], color, &mut line)?.send(|transfer| {
    ///     sent.extend_from_slice(transfer.data);
    ///     Ok::<(), core::convert::Infallible>(())
    /// })?;
    /// assert_eq!(sent[8..], [0, 0, 0, 0xfc, 0x54, 0x54]); // black, and light red
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    /// # Errors
    /// [`Error::LineTooShort`] if not one pixel fits into the line, or not two of RGB444.
    pub fn converted<'a, M, K, I, C>(
        self,
        frame: &'a Frame<M, K>,
        areas: I,
        convert: C,
        line: &'a mut [u8],
    ) -> Result<impl Transfers + use<'a, L, M, K, I, C>, Error>
    where
        M: AsRef<[u8]>,
        K: Layout,
        I: IntoIterator<Item = Rect>,
        C: FnMut(K::Color) -> L::Color,
    {
        let lines = Lines::<L, _>::new(frame.window(), line, converted::<M, K, L, C>(frame, convert))?;
        Ok(Windows::new(areas, lines, self.say()))
    }

    /// The commands for a window.
    fn say(self) -> impl Fn(usize, Rect) -> Say + use<L> {
        let Self { columns, rows, .. } = self;
        move |number, area| match number {
            0 => Say::command(CASET, ends(area.x0, area.x1, columns)),
            1 => Say::command(RASET, ends(area.y0, area.y1, rows)),
            2 => Say::Pixels(RAMWR),
            _ => Say::End,
        }
    }
}

impl<F: PixelFormat> Tft<Rows<F>> {
    /// Sends areas of a frame, as its bytes lie in memory: `[frame.window()]` is all of a frame, or of a band. What lies outside is left
    /// out.
    ///
    /// Rows without gaps between them are one piece.
    /// ```
    /// use embedded_raster::{pixel::Be, BufferError, Canvas, Framebuffer, Rect};
    /// use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
    /// use embedded_raster_displays::{Spi, Tft565};
    /// # use embedded_hal::{digital::OutputPin, spi::SpiDevice};
    /// fn show<D: SpiDevice, P: OutputPin>(device: D, data_command: P) -> Result<(), Box<dyn core::error::Error>>
    /// # where D::Error: 'static, P::Error: 'static
    /// {
    ///     let mut spi = Spi::new(device, data_command);
    ///     let mut ram = [0; 240 * 240 * 2];
    ///     let mut frame = Framebuffer::<Be<Rgb565>>::new(&mut ram, 240, 240)?;
    ///     let display = Tft565::new().with_offset(0, 80);
    ///     frame.fill_triangle([(9, 9), (200, 50), (100, 220)], Rgb565::RED);
    ///     spi.send(display.frame(&frame, [frame.window()]))?; // all of it
    ///     frame.draw_line((0, 0), (20, 10), Rgb565::WHITE);
    ///     spi.send(display.frame(&frame, [Rect::new(0, 0, 21, 11)]))?; // what changed
    ///     Ok(())
    /// }
    /// ```
    pub fn frame<M, I>(self, frame: &Frame<M, Rows<F>>, areas: I) -> impl Transfers + use<'_, F, M, I>
    where
        M: AsRef<[u8]>,
        I: IntoIterator<Item = Rect>,
    {
        Windows::new(areas, Self::lying(frame), self.say())
    }

    /// The same by way of a line: rows of small areas are sent many at a time, and DMA that cannot reach the memory of the frame, an
    /// external one or one of the core's own, reads the line.
    ///
    /// * `line`: memory that pixels are copied to. If it holds some rows of an area, so many are sent at once.
    ///
    /// # Errors
    /// [`Error::LineTooShort`] if not one pixel fits into the line.
    pub fn copied<'a, M, I>(
        self,
        frame: &'a Frame<M, Rows<F>>,
        areas: I,
        line: &'a mut [u8],
    ) -> Result<impl Transfers + use<'a, F, M, I>, Error>
    where
        M: AsRef<[u8]>,
        I: IntoIterator<Item = Rect>,
    {
        const { assert!(F::BITS.is_multiple_of(8), "pixels of whole bytes") };
        let lines = Lines::<Rows<F>, _>::new(frame.window(), line, copied(frame, (F::BITS / 8) as usize))?;
        Ok(Windows::new(areas, lines, self.say()))
    }

    /// Sends the pixels of a frame or a band without a [`window`](Self::window), for the rows that follow those before.
    pub fn pixels<M: AsRef<[u8]>>(self, frame: &Frame<M, Rows<F>>) -> impl Transfers + use<'_, F, M> {
        Windows::new([], Self::lying(frame).of(frame.window()), self.say())
    }

    /// Sends areas of a frame of indices, each pixel as the palette's colour.
    ///
    /// * `line`: memory that pixels are written in. If it holds some rows of an area, so many are sent at once.
    ///
    /// An index beyond the palette is shown as its first colour.
    /// ```
    /// use embedded_graphics_core::pixelcolor::Rgb565;
    /// use embedded_raster::{pixel::EGA, Bitmap, Index4};
    /// use embedded_raster_displays::{Tft565, Transfers};
    /// let picture = Bitmap::<Index4>::new(&[0x04, 0x2f], 4, 1)?;
    /// let (palette, mut line, mut sent) = (EGA.map(Rgb565::from), [0; 320 * 2], vec![]);
    /// Tft565::new().through(&picture, [picture.window()], &palette, &mut line)?.send(|transfer| {
    ///     sent.extend_from_slice(transfer.data);
    ///     Ok::<(), core::convert::Infallible>(())
    /// })?;
    /// assert_eq!(sent[8..], [0, 0, 0xa8, 0, 0x05, 0x40, 0xff, 0xff]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    /// # Errors
    /// [`Error::LineTooShort`] if not one pixel fits into the line.
    pub fn through<'a, M, J, I, const N: usize>(
        self,
        frame: &'a Frame<M, Rows<J>>,
        areas: I,
        palette: &'a Palette<F::Color, N>,
        line: &'a mut [u8],
    ) -> Result<impl Transfers + use<'a, F, M, J, I, N>, Error>
    where
        M: AsRef<[u8]>,
        J: PixelFormat,
        I: IntoIterator<Item = Rect>,
    {
        let lines = Lines::<Rows<F>, _>::new(frame.window(), line, through::<M, J, F, N>(frame, palette))?;
        Ok(Windows::new(areas, lines, self.say()))
    }

    /// The same for the pixels of a frame or a band without a [`window`](Self::window).
    ///
    /// # Errors
    /// [`Error::LineTooShort`] if not one pixel fits into the line.
    pub fn pixels_through<'a, M: AsRef<[u8]>, J: PixelFormat, const N: usize>(
        self,
        frame: &'a Frame<M, Rows<J>>,
        palette: &'a Palette<F::Color, N>,
        line: &'a mut [u8],
    ) -> Result<impl Transfers + use<'a, F, M, J, N>, Error> {
        let lines = Lines::<Rows<F>, _>::new(frame.window(), line, through::<M, J, F, N>(frame, palette))?;
        Ok(Windows::new([], lines.of(frame.window()), self.say()))
    }

    fn lying<M: AsRef<[u8]>>(frame: &Frame<M, Rows<F>>) -> Lying<'_> {
        const { assert!(F::BITS.is_multiple_of(8), "pixels of whole bytes") };
        Lying::whole_bytes(frame, F::BITS as usize)
    }
}

impl Tft<Packed12> {
    /// Sends areas of a frame of RGB444, as its bytes lie in memory. They grow to whole pairs of pixels.
    ///
    /// A window of odd width is sent row by row: the display would take the half byte at the end of a row for the next pixel.
    /// ```
    /// use embedded_raster::{surface::Packed12, Frame};
    /// use embedded_raster_displays::{Tft444, Transfers};
    /// let picture = Frame::<_, Packed12>::new([0x12, 0x34, 0x56], 2, 1)?;
    /// let mut sent = vec![];
    /// Tft444::new().frame(&picture, [picture.window()])?.send(|transfer| {
    ///     sent.extend_from_slice(transfer.data);
    ///     Ok::<(), core::convert::Infallible>(())
    /// })?;
    /// assert_eq!(sent[8..], [0x12, 0x34, 0x56]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    /// # Errors
    /// [`Error::Misaligned`] of a view that begins in an odd column. [`converted`](Self::converted) sends it.
    pub fn frame<M, I>(self, frame: &Frame<M, Packed12>, areas: I) -> Result<impl Transfers + use<'_, M, I>, Error>
    where
        M: AsRef<[u8]>,
        I: IntoIterator<Item = Rect>,
    {
        Ok(Windows::new(areas, Lying::new(frame, 12)?, self.say()))
    }

    /// Sends the pixels of a frame or a band without a [`window`](Self::window), for the rows that follow those before.
    ///
    /// # Errors
    /// [`Error::Misaligned`] of a view that begins in an odd column, or if the last column of the frame is not the right one of a pair:
    /// rows would not follow each other.
    pub fn pixels<M: AsRef<[u8]>>(self, frame: &Frame<M, Packed12>) -> Result<impl Transfers + use<'_, M>, Error> {
        let (lying, window) = (Lying::new(frame, 12)?, frame.window());
        Error::check_aligned(index(window.x1.saturating_sub(window.x0)), 2)?;
        Ok(Windows::new([], lying.of(window), self.say()))
    }
}
