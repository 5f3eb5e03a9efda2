//! E-paper: black and white, two planes for a third colour, seven colours in four bits.
//!
//! | panel | frame | bytes for the driver crate `epd-waveshare` |
//! |---|---|---|
//! | black, white | `Rows<BinaryColor>` or `Rows<Index1>`, 1 is white | `frame.row_bytes(0..h)` for `update_frame` |
//! | black, white, red | `Planes<Index2>`, bit 0 white, bit 1 red: [`BLACK`], [`WHITE`], [`RED`] | `frame.plane_bytes(0)` and `(1)` for `update_color_frame` |
//! | seven colours | `Rows<Index4>`, through [`SEVEN_COLORS`] | `frame.row_bytes(0..h)` for `update_frame` |
//! | a part of them | any rows | [`part`] for `update_partial_frame` |
//!
//! So a frame has the bytes that drivers ask for, and is handed to them. Without a driver, transfers of this module send them:
//! [`whole`] and [`planes`] after any command, and [`Ssd16xx`] only what is damaged, on controllers whose memory has windows.
//!
//! Nothing is seen before the controller is told to refresh; that, its waveforms and its busy line are the driver's business.

use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
use embedded_raster::{
    surface::{Frame, Planes, Rows},
    Index2, Palette, PixelFormat, Rect,
};

use crate::{
    error::Error,
    pieces::{index, Lying, Pieces},
    transfer::{Transfer, Transfers},
    windows::{number, Say, Windows},
};

/// Neither bit.
pub const BLACK: Index2 = Index2::new(0b00);
/// Bit 0, in plane 0.
pub const WHITE: Index2 = Index2::new(0b01);
/// Bit 1, in plane 1; what is in plane 0 does not count then. Yellow on panels that have it.
pub const RED: Index2 = Index2::new(0b10);

/// What the indices of a seven-colour panel look like: black, white, green, blue, red, yellow, orange, and "clean", which is no colour.
pub const SEVEN_COLORS: Palette<Rgb888, 8> = Palette::new([
    Rgb888::BLACK,
    Rgb888::WHITE,
    Rgb888::GREEN,
    Rgb888::BLUE,
    Rgb888::RED,
    Rgb888::YELLOW,
    Rgb888::new(255, 128, 0),
    Rgb888::new(128, 128, 128),
]);

/// All of a frame after a command: 0x10 is "data start transmission 1" of UC8151, UC8159 and their kin, 0x24 "write RAM" of SSD16xx.
///
/// ```
/// use embedded_raster::{Bitmap, Index4};
/// use embedded_raster_displays::{paper, Transfers};
/// let picture = Bitmap::<Index4>::new(&[0x01, 0x23], 4, 1)?; // black, white, green, blue
/// let mut transfers = paper::whole(&[0x10], &picture)?;
/// let transfer = transfers.next().expect("one piece");
/// assert_eq!((transfer.command, transfer.data), (&[0x10][..], &[0x01, 0x23][..]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
/// # Errors
/// [`Error::Misaligned`] of a view that begins inside of a byte.
pub fn whole<'a, M, F>(
    command: &'static [u8],
    frame: &'a Frame<M, Rows<F>>,
) -> Result<impl Transfers + use<'a, M, F>, Error>
where
    M: AsRef<[u8]>,
    F: PixelFormat,
{
    Ok(Windows::new([frame.window()], Lying::new(frame, F::BITS as usize)?, move |_, _| Say::Pixels(command)))
}

/// Both planes of a frame, each after its command: `[&[0x10], &[0x13]]` of UC8151 and its kin, `[&[0x24], &[0x26]]` of SSD16xx.
///
/// # Errors
/// [`Error::Misaligned`] of a view that begins inside of a byte.
pub fn planes<'a, M, F>(
    commands: [&'static [u8]; 2],
    frame: &'a Frame<M, Planes<F>>,
) -> Result<impl Transfers + use<'a, M, F>, Error>
where
    M: AsRef<[u8]>,
    F: PixelFormat,
{
    let plane = |number: usize, command: &'static [u8]| -> Result<_, Error> {
        let lying = Lying::new(frame, 1)?.in_memory(frame.plane_bytes(number));
        Ok(Windows::new([frame.window()], lying, move |_, _| Say::Pixels(command)))
    };
    Ok(Both(plane(0, commands[0])?, plane(1, commands[1])?))
}

/// The bytes of an area, one row after the other without gaps, and the area that they are of: it has grown to whole bytes. For drivers
/// that are handed a part of a frame.
///
/// ```
/// use embedded_raster::{Bitmap, Index1, Rect};
/// use embedded_raster_displays::paper;
/// let picture = Bitmap::<Index1>::new(&[1, 2, 3, 4, 5, 6], 24, 2)?;
/// let mut memory = [0; 16];
/// let (bytes, area) = paper::part(&picture, Rect::new(9, 0, 20, 2), &mut memory)?;
/// assert_eq!((bytes, area), (&[2, 3, 5, 6][..], Rect::new(8, 0, 24, 2)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
/// # Errors
/// [`Error::LineTooShort`] if they do not fit into `memory`; [`Error::Misaligned`] of a view that begins inside of a byte.
pub fn part<'a, M: AsRef<[u8]>, F: PixelFormat>(
    frame: &Frame<M, Rows<F>>,
    area: Rect,
    memory: &'a mut [u8],
) -> Result<(&'a [u8], Rect), Error> {
    let mut lying = Lying::new(frame, F::BITS as usize)?;
    let area = lying.cover(area);
    let row = index(area.x1.saturating_sub(area.x0)).saturating_mul(F::BITS as usize).div_ceil(8);
    let (needed, given) = (row.saturating_mul(index(area.y1.saturating_sub(area.y0))), memory.len());
    let needed = if area.is_empty() { 0 } else { needed };
    let Some(out) = memory.get_mut(..needed) else { return Err(Error::LineTooShort { needed, given }) };
    for (y, out) in (area.y0..area.y1).zip(out.chunks_exact_mut(row.max(1))) {
        lying.start(Rect { y0: y, y1: y.saturating_add(1), ..area });
        out.iter_mut().zip(lying.next()).for_each(|(place, &byte)| *place = byte);
    }
    Ok((out, area))
}

/// Controllers of Solomon Systech whose memory has windows: SSD1608, SSD1675, SSD1680, SSD1681 and others, with data entry mode 3.
///
/// ```text
///   0x44  first and last byte of a row           0x4e  the byte to begin with
///   0x45  first and last row, low byte first     0x4f  the row to begin with
///   0x24  pixels, 1 is white                     0x26  pixels of the second plane, 1 is red
/// ```
/// Damage grows to whole bytes. A refresh shows the window that was sent, and what was sent before: the panel keeps the rest.
///
/// Source: Solomon Systech, "SSD1680", rev. 0.14.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Ssd16xx;

/// Memory of a controller.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Ram {
    /// 0x24: black and white.
    First,
    /// 0x26: red, or the picture before this one, which fast refreshes compare with.
    Second,
}

impl Ram {
    const fn command(self) -> &'static [u8] {
        match self {
            Self::First => &[0x24],
            Self::Second => &[0x26],
        }
    }
}

impl Ssd16xx {
    /// Sends areas of a frame, as its bytes lie in memory: `[frame.window()]` is all of it. What lies outside is left out.
    ///
    /// ```
    /// use embedded_raster::{Bitmap, Index1, Rect};
    /// use embedded_raster_displays::{paper::{Ram, Ssd16xx}, Transfers};
    /// let picture = Bitmap::<Index1>::new(&[1, 2, 3, 4, 5, 6], 24, 2)?;
    /// let mut sent = vec![];
    /// Ssd16xx.frame(&picture, [Rect::new(9, 1, 12, 2)], Ram::First)?.send(|transfer| {
    ///     sent.push((transfer.command[0], transfer.data.to_vec()));
    ///     Ok::<(), core::convert::Infallible>(())
    /// })?;
    /// assert_eq!(sent[..2], [(0x44, vec![1, 1]), (0x45, vec![1, 0, 1, 0])]);
    /// assert_eq!(sent[2..], [(0x4e, vec![1]), (0x4f, vec![1, 0]), (0x24, vec![5])]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    /// # Errors
    /// [`Error::Misaligned`] of a view that begins inside of a byte.
    pub fn frame<M, F, I>(
        self,
        frame: &Frame<M, Rows<F>>,
        areas: I,
        ram: Ram,
    ) -> Result<impl Transfers + use<'_, M, F, I>, Error>
    where
        M: AsRef<[u8]>,
        F: PixelFormat,
        I: IntoIterator<Item = Rect>,
    {
        const { assert!(F::BITS == 1, "pixels of one bit") };
        Ok(Windows::new(areas, Lying::new(frame, 1)?, say(ram)))
    }

    /// Sends areas of both planes of a frame: plane 0 to the first memory, plane 1 to the second.
    ///
    /// # Errors
    /// [`Error::Misaligned`] of a view that begins inside of a byte.
    pub fn planes<M, F, I>(
        self,
        frame: &Frame<M, Planes<F>>,
        areas: I,
    ) -> Result<impl Transfers + use<'_, M, F, I>, Error>
    where
        M: AsRef<[u8]>,
        F: PixelFormat,
        I: IntoIterator<Item = Rect, IntoIter: Clone>,
    {
        let areas = areas.into_iter();
        let plane = |number: usize, ram: Ram| -> Result<_, Error> {
            let lying = Lying::new(frame, 1)?.in_memory(frame.plane_bytes(number));
            Ok(Windows::new(areas.clone(), lying, say(ram)))
        };
        Ok(Both(plane(0, Ram::First)?, plane(1, Ram::Second)?))
    }
}

/// The commands for a window.
fn say(ram: Ram) -> impl Fn(usize, Rect) -> Say {
    let low = |n: u16| n.to_le_bytes()[0];
    move |step, area| {
        let bytes = |x: i32| low(number(x / 8));
        let last = |n: i32| n.saturating_sub(1);
        let ([top, above], [bottom, below]) = (number(area.y0).to_le_bytes(), number(last(area.y1)).to_le_bytes());
        match step {
            0 => Say::Command(&[0x44], [bytes(area.x0), bytes(last(area.x1)), 0, 0], 2),
            1 => Say::Command(&[0x45], [top, above, bottom, below], 4),
            2 => Say::Command(&[0x4e], [bytes(area.x0), 0, 0, 0], 1),
            3 => Say::Command(&[0x4f], [top, above, 0, 0], 2),
            _ => Say::Pixels(ram.command()),
        }
    }
}

/// Some transfers after others.
struct Both<A, B>(A, B);

impl<A: Transfers, B: Transfers> Transfers for Both<A, B> {
    fn next(&mut self) -> Option<Transfer<'_>> {
        if let Some(transfer) = self.0.next() {
            return Some(transfer);
        }
        self.1.next()
    }
}
