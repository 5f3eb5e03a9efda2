//! E-paper: black and white, two planes for a third colour, seven colours in four bits.
//!
//! | panel | frame | bytes for the driver crate `epd-waveshare` |
//! |---|---|---|
//! | black, white | `Rows<BinaryColor>` or `Rows<Index1>`, 1 is white | `frame.row_bytes(0..h)` for `update_frame` |
//! | black, white, red | `Planes<Index2>`, bit 0 white, bit 1 red: [`BLACK`], [`WHITE`], [`RED`] | `frame.plane_bytes(0)` and `(1)` for `update_color_frame` |
//! | seven colours | `Rows<Index4>`, through [`EPAPER_7`](embedded_raster::pixel::EPAPER_7) | `frame.row_bytes(0..h)` for `update_frame` |
//! | a part of them | any rows | [`part`] for `update_partial_frame` |
//!
//! So a frame has the bytes that drivers ask for, and is handed to them. Without a driver, transfers of this module send them:
//! [`whole`] and [`planes`] after any command; [`Ssd16xx`] and [`Uc8176`] only what is damaged, as their memory has windows.
//!
//! Nothing is seen before the controller is told to refresh; that, its waveforms and its busy line are the driver's business.

use embedded_raster::{
    surface::{Frame, Planes, Rows},
    Index2, PixelFormat, Rect,
};

use crate::{
    error::Error,
    pieces::{index, Lying, Pieces},
    transfer::{Transfer, Transfers},
    windows::{ends, number, Say, Windows},
};

/// Neither bit.
pub const BLACK: Index2 = Index2::new(0b00);
/// Bit 0, in plane 0.
pub const WHITE: Index2 = Index2::new(0b01);
/// Bit 1, in plane 1; what is in plane 0 does not count then. Yellow on panels that have it.
pub const RED: Index2 = Index2::new(0b10);

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
    Ok(Windows::new([frame.window()], Lying::new(frame, F::BITS as usize)?, only(command)))
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
        Ok(Windows::new([frame.window()], lying, only(command)))
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
    /// Black and white: what is to be seen.
    First,
    /// Red, or the picture before this one, which fast refreshes compare with.
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

/// No window, and a command before the pixels.
fn only(command: &'static [u8]) -> impl Fn(usize, Rect) -> Say {
    move |step, _| if step == 0 { Say::Pixels(command) } else { Say::End }
}

/// The commands for a window of SSD16xx.
fn say(ram: Ram) -> impl Fn(usize, Rect) -> Say {
    let byte = |x: i32| number(x / 8).to_le_bytes()[0];
    move |step, area| {
        let last = |n: i32| n.saturating_sub(1);
        let ([top, above], [bottom, below]) = (number(area.y0).to_le_bytes(), number(last(area.y1)).to_le_bytes());
        match step {
            0 => Say::command(&[0x44], [byte(area.x0), byte(last(area.x1))]),
            1 => Say::command(&[0x45], [top, above, bottom, below]),
            2 => Say::command(&[0x4e], [byte(area.x0)]),
            3 => Say::command(&[0x4f], [top, above]),
            4 => Say::Pixels(ram.command()),
            _ => Say::End,
        }
    }
}

/// Controllers of UltraChip whose memory has windows with columns of 16 bits: UC8176, UC8179, IL0398, of panels from 4.2 inches on.
///
/// ```text
///   0x91  a window from here on
///   0x90  first and last column, first and last row, 16 bits each, the high byte first; and 1: gates are scanned outside of it as well
///   0x13  pixels, 1 is white; 0x10 of the second memory, the picture before this one
///   0x92  no window any more
/// ```
/// Damage grows to whole bytes.
///
/// Source: UltraChip, "UC8176c", rev. 0.6.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Uc8176;

impl Uc8176 {
    /// Sends areas of a frame, as its bytes lie in memory: `[frame.window()]` is all of it. What lies outside is left out.
    ///
    /// ```
    /// use embedded_raster::{Bitmap, Index1, Rect};
    /// use embedded_raster_displays::{paper::{Ram, Uc8176}, Transfers};
    /// let picture = Bitmap::<Index1>::new(&[1, 2, 3, 4, 5, 6], 24, 2)?;
    /// let mut sent = vec![];
    /// Uc8176.frame(&picture, [Rect::new(9, 1, 12, 2)], Ram::First)?.send(|transfer| {
    ///     sent.push((transfer.command[0], transfer.data.to_vec()));
    ///     Ok::<(), core::convert::Infallible>(())
    /// })?;
    /// assert_eq!(sent[..2], [(0x91, vec![]), (0x90, vec![0, 8, 0, 15, 0, 1, 0, 1, 1])]);
    /// assert_eq!(sent[2..], [(0x13, vec![5]), (0x92, vec![])]);
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
        let pixels: &[u8] = match ram {
            Ram::First => &[0x13],
            Ram::Second => &[0x10],
        };
        let say = move |step, area: Rect| {
            let (x, y) = (ends(area.x0, area.x1, 0), ends(area.y0, area.y1, 0));
            match step {
                0 => Say::command(&[0x91], []),
                1 => Say::command(&[0x90], [x[0], x[1], x[2], x[3] | 7, y[0], y[1], y[2], y[3], 1]),
                2 => Say::Pixels(pixels),
                3 => Say::command(&[0x92], []),
                _ => Say::End,
            }
        };
        Ok(Windows::new(areas, Lying::new(frame, 1)?, say))
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
