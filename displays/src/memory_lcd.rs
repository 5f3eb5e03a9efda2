//! Sharp's memory LCDs, LS013B7DH03, LS027B7DH01 and others: lines of one bit a pixel, each with its address.
//!
//! ```text
//!   mode   0x80 + 0x40 if VCOM is high
//!   line   its number from 1 on, lowest bit first; the pixels from left to right, 1 is white; eight bits of nothing
//!   line   ...
//!   end    eight bits of nothing
//! ```
//! The display reads lowest bits first, and SPI sends highest bits first: so the number of a line is reversed, and so are the bytes of a
//! frame whose format is [`Lsb0`](embedded_raster::pixel::Lsb0); other frames have the leftmost pixel in the highest bit already. All of a
//! packet is one transfer, as the chip select ends it; it is high while the display is selected: see [`ActiveHigh`](crate::ActiveHigh).
//!
//! VCOM has to change once a second or more often, whether something is sent or not: by its pin, or by the bit in each mode byte.
//!
//! Source: Sharp, "LS027B7DH01 Specification", 6-5, "Input signal and display".

use embedded_raster::{
    surface::{Frame, Rows},
    PixelFormat, Rect,
};

use crate::{
    error::Error,
    pieces::{distance, index},
    transfer::{Once, Transfer, Transfers},
};

const UPDATE: u8 = 0x80;
const VCOM: u8 = 0x40;
const CLEAR: u8 = 0x20;

/// Sends the lines of a frame that have pixels in some areas: `[frame.window()]` is all of a frame, or of a band. The display has as many
/// columns as the frame, and 255 lines at most.
///
/// * `vcom`: to be changed from time to time.
/// * `packet`: memory for a packet, at least four bytes more than those of a line. With two more bytes for each further line, and those of its
///   pixels, so many lines are sent at once.
///
/// ```
/// use embedded_graphics_core::pixelcolor::BinaryColor;
/// use embedded_raster::{Bitmap, Rect};
/// use embedded_raster_displays::{memory_lcd, Transfers};
/// let picture = Bitmap::<BinaryColor>::new(&[0xf0, 0x01, 0xaa, 0x55], 16, 2)?;
/// let mut packet = [0; 6];
/// let mut lines = memory_lcd::lines(&picture, [Rect::new(3, 1, 5, 2)], false, &mut packet)?;
/// // Line 2 of the display.
/// assert_eq!(lines.next().map(|transfer| transfer.data), Some(&[0x80, 0x40, 0xaa, 0x55, 0, 0][..]));
/// assert!(lines.next().is_none());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
/// # Errors
/// [`Error::LineTooShort`] if `packet` does not hold a line; [`Error::Misaligned`] of a view that begins inside of a byte.
pub fn lines<'a, M, F, I>(
    frame: &'a Frame<M, Rows<F>>,
    areas: I,
    vcom: bool,
    packet: &'a mut [u8],
) -> Result<impl Transfers + use<'a, M, F, I>, Error>
where
    M: AsRef<[u8]>,
    F: PixelFormat,
    I: IntoIterator<Item = Rect>,
{
    const { assert!(F::BITS == 1, "pixels of one bit") };
    let window = frame.window();
    let (column, row) = frame.place_of(window.top_left()).unwrap_or_default();
    let left = column.wrapping_sub(index(window.x0));
    Error::check_aligned(left, 8)?;
    let width = u16::try_from(frame.size().width).unwrap_or(u16::MAX);
    let bytes = embedded_raster::pixel::row_bytes::<F>(width);
    let (needed, given) = (bytes.saturating_add(4), packet.len());
    if given < needed {
        return Err(Error::LineTooShort { needed, given });
    }
    Ok(Lines {
        memory: frame.memory(),
        stride: frame.stride(),
        left: left / 8,
        down: distance(row).saturating_sub(window.y0),
        bytes,
        is_reversed: F::LSB0,
        window: window.intersection(Rect { y0: 0, y1: 255, ..window }),
        areas: areas.into_iter(),
        rows: (0, 0),
        mode: mode(UPDATE, vcom),
        packet,
    })
}

/// Makes all of the display white.
///
/// ```
/// use embedded_raster_displays::{memory_lcd, Transfers};
/// assert_eq!(memory_lcd::clear(true).next().map(|transfer| transfer.data.to_vec()), Some(vec![0x60, 0]));
/// ```
pub fn clear(vcom: bool) -> impl Transfers {
    Once::new([], [mode(CLEAR, vcom), 0])
}

/// Sends VCOM and no pixels: while nothing changes.
pub fn hold(vcom: bool) -> impl Transfers {
    Once::new([], [mode(0, vcom), 0])
}

fn mode(bits: u8, vcom: bool) -> u8 {
    bits | if vcom { VCOM } else { 0 }
}

/// The packets of some areas.
struct Lines<'a, I> {
    memory: &'a [u8],
    stride: usize,
    /// The byte of a row in memory that a line begins with, and how many rows the memory is ahead.
    left: usize,
    down: i32,
    /// Bytes of a line.
    bytes: usize,
    is_reversed: bool,
    window: Rect,
    areas: I,
    /// Rows that have not been sent.
    rows: (i32, i32),
    mode: u8,
    packet: &'a mut [u8],
}

impl<I> Lines<'_, I> {
    /// Writes a line with its number at `at`.
    fn write(&mut self, at: usize, y: i32) {
        let start = index(y.saturating_add(self.down)).wrapping_mul(self.stride).wrapping_add(self.left);
        let pixels = self.memory.get(start..start.wrapping_add(self.bytes)).unwrap_or_default();
        let line = self.packet.get_mut(at..).and_then(|rest| rest.get_mut(..self.bytes.saturating_add(2)));
        let Some([address, places @ .., nothing]) = line else { return };
        *address = u8::try_from(y.saturating_add(1)).unwrap_or(u8::MAX).reverse_bits();
        *nothing = 0;
        for (place, &byte) in places.iter_mut().zip(pixels) {
            *place = if self.is_reversed { byte.reverse_bits() } else { byte };
        }
    }
}

impl<I: Iterator<Item = Rect>> Transfers for Lines<'_, I> {
    fn next(&mut self) -> Option<Transfer<'_>> {
        while self.rows.0 >= self.rows.1 {
            let area = self.areas.next()?.intersection(self.window);
            self.rows = if area.is_empty() { (0, 0) } else { (area.y0, area.y1) };
        }
        if let Some(first) = self.packet.first_mut() {
            *first = self.mode;
        }
        let mut end = 1_usize;
        let line = self.bytes.saturating_add(2);
        while self.rows.0 < self.rows.1 && end.saturating_add(line) < self.packet.len() {
            self.write(end, self.rows.0);
            self.rows.0 = self.rows.0.saturating_add(1);
            end = end.saturating_add(line);
        }
        if let Some(nothing) = self.packet.get_mut(end) {
            *nothing = 0;
        }
        Some(Transfer { command: &[], data: self.packet.get(..=end).unwrap_or_default() })
    }
}
