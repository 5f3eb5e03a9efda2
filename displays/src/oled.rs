//! [`Oled`]: displays of one bit a pixel whose memory is pages of eight rows: SSD1306, SSD1309, SH1106, SH1107.
//!
//! ```text
//!   SSD1306, a window:  0x21 first and last column   0x22 first and last page   then the bytes of all its pages
//!   SH1106, a page:     0xb0 + page   0x00 + low half of the column   0x10 + high half   then bytes of this page
//! ```
//! All of these are commands; they have no parameters in the sense of the data/command line. A frame of
//! [`Paged`](embedded_raster::surface::Paged) has the display's bytes. Damage grows to whole pages, and columns stay as they are.
//!
//! SSD1306 moves from page to page by itself in its horizontal addressing mode, 0x20 0x00, which its drivers choose. SH1106 has
//! pages only, and 132 columns; most panels begin at the third.
//!
//! The driver crate `sh1106` takes parts of a page through its SPI interface; its I2C interface takes whole lines of 128 bytes only.
//!
//! Sources: Solomon Systech, "SSD1306", rev. 1.1; Sino Wealth, "SH1106", V2.3.

use embedded_graphics_core::pixelcolor::PixelColor;
use embedded_raster::{
    pixel::Lsb0,
    surface::{Frame, Pages},
    PixelFormat, Rect,
};

use crate::{
    error::Error,
    pieces::{distance, index},
    transfer::{Once, Transfer, Transfers},
};

/// How an area is addressed.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
enum Addressing {
    Windows,
    Pages,
}

/// A display with pages. It has no state but the place of its panel.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Oled {
    addressing: Addressing,
    columns: u8,
    pages: u8,
}

/// Of the largest controllers, 0xb0 to 0xbf.
const MOST_PAGES: i32 = 16;

impl Oled {
    /// In horizontal addressing mode, as drivers leave it. SSD1309 and SSD1315 are the same.
    pub const SSD1306: Self = Self { addressing: Addressing::Windows, columns: 0, pages: 0 };
    /// 128 columns in the middle of 132.
    pub const SH1106: Self = Self { addressing: Addressing::Pages, columns: 2, pages: 0 };
    /// Addressed like SH1106, with a panel that shows all columns. SSD1306 in page addressing mode takes the same commands.
    pub const SH1107: Self = Self { addressing: Addressing::Pages, columns: 0, pages: 0 };

    /// A panel whose first pixel is in this column and page of the controller's memory. Displays of 72 x 40 begin at column 28.
    #[must_use]
    pub const fn with_offset(self, columns: u8, pages: u8) -> Self {
        Self { columns, pages, ..self }
    }

    /// Sends areas of a frame, as its bytes lie in memory: `[frame.window()]` is all of a frame, or of a band. What lies outside is left
    /// out.
    ///
    /// ```
    /// use embedded_graphics_core::{geometry::Point, pixelcolor::BinaryColor};
    /// use embedded_raster::{surface::{paged_bytes, Paged}, Canvas, Rect};
    /// use embedded_raster_displays::{Oled, Transfers};
    /// let mut ram = [0; paged_bytes(128, 64)];
    /// let mut frame = Paged::<BinaryColor>::new(&mut ram, 128, 64)?;
    /// frame.draw_line(Point::new(3, 6), Point::new(3, 9), BinaryColor::On);
    /// let (mut commands, mut data) = (vec![], vec![]);
    /// Oled::SSD1306.frame(&frame, [Rect::new(3, 6, 4, 10)])?.send(|transfer| {
    ///     commands.extend_from_slice(transfer.command);
    ///     data.extend_from_slice(transfer.data);
    ///     Ok::<(), core::convert::Infallible>(())
    /// })?;
    /// assert_eq!(commands, [0x21, 3, 3, 0x22, 0, 1]); // column 3 of pages 0 and 1
    /// assert_eq!(data, [0b1100_0000, 0b0000_0011]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    /// # Errors
    /// [`Error::Misaligned`] of a view whose rows are not those of pages.
    pub fn frame<M, C, I>(
        self,
        frame: &Frame<M, Pages<Lsb0<C>>>,
        areas: I,
    ) -> Result<impl Transfers + use<'_, M, C, I>, Error>
    where
        M: AsRef<[u8]>,
        C: PixelColor + PixelFormat<Color = C>,
        I: IntoIterator<Item = Rect>,
    {
        let window = frame.window();
        let (column, row) = frame.place_of(window.top_left()).unwrap_or_default();
        // Pages of the display are those of the memory, so many further down.
        let down = distance(row).saturating_sub(window.y0);
        if down.rem_euclid(8) != 0 {
            return Err(Error::Misaligned { at: row, unit: 8 });
        }
        Ok(Paged {
            oled: self,
            memory: frame.memory(),
            stride: frame.stride(),
            window,
            column,
            down: down.div_euclid(8),
            areas: areas.into_iter(),
            area: Rect::default(),
            is_open: false,
            command: [0; 6],
        })
    }

    /// Turns the display upside down, or mirrors it, by its registers: 0xa0 or 0xa1 for the order of columns, 0xc0 or 0xc8 for that of rows.
    /// Without either, it shows the picture as most modules are built, with their pins at the top.
    ///
    /// Columns count for what is sent after it: send a frame.
    /// ```
    /// use embedded_raster_displays::{Oled, Transfers};
    /// let mut turn = Oled::SH1106.orientation(true, false);
    /// assert_eq!(turn.next().map(|transfer| transfer.command.to_vec()), Some(vec![0xa0, 0xc0]));
    /// ```
    pub fn orientation(self, is_upside_down: bool, is_mirrored: bool) -> impl Transfers {
        let command = [0xa0 | u8::from(is_upside_down == is_mirrored), 0xc0 | u8::from(!is_upside_down) << 3];
        Once::new(command, [])
    }
}

/// The transfers of some areas.
struct Paged<'a, I> {
    oled: Oled,
    memory: &'a [u8],
    stride: usize,
    window: Rect,
    /// Where the first column of the window lies.
    column: usize,
    /// How many pages the memory is ahead.
    down: i32,
    areas: I,
    /// What has not been sent: columns, and pages in the place of rows.
    area: Rect,
    /// Whether the area has been addressed.
    is_open: bool,
    command: [u8; 6],
}

/// A column or a page, which fits.
fn byte(n: i32) -> u8 {
    u8::try_from(n).unwrap_or(u8::MAX)
}

impl<I: Iterator<Item = Rect>> Paged<'_, I> {
    /// The pages of the next area that has some.
    fn open(&mut self) -> Option<()> {
        let Oled { columns, pages, .. } = self.oled;
        let most = Rect::new(0, 0, 0x100 - i32::from(columns), (MOST_PAGES - i32::from(pages)) * 8);
        let window = self.window.intersection(most);
        while self.area.is_empty() {
            let Rect { x0, x1, y0, y1 } = self.areas.next()?.intersection(window);
            self.area = if y0 < y1 { Rect::new(x0, y0 / 8, x1, (y1 + 7) / 8) } else { Rect::default() };
            self.is_open = false;
        }
        Some(())
    }

    /// The command before the next bytes: its length.
    fn address(&mut self) -> usize {
        let Oled { addressing, columns, pages } = self.oled;
        let Rect { x0, y0, x1, y1 } = self.area;
        let (column, last_column) = (byte(x0).saturating_add(columns), byte(x1 - 1).saturating_add(columns));
        let (page, last_page) = (byte(y0).saturating_add(pages), byte(y1 - 1).saturating_add(pages));
        match addressing {
            Addressing::Windows if self.is_open => 0,
            Addressing::Windows => {
                self.command = [0x21, column, last_column, 0x22, page, last_page];
                6
            }
            Addressing::Pages => {
                self.command = [0xb0 | page, column & 0x0f, 0x10 | column >> 4, 0, 0, 0];
                3
            }
        }
    }

    /// The bytes of a page in memory.
    fn bytes(&self, page: i32) -> core::ops::Range<usize> {
        let row = index(page.saturating_add(self.down)).wrapping_mul(self.stride);
        let column = |x: i32| self.column.wrapping_add(index(x.wrapping_sub(self.window.x0)));
        row.wrapping_add(column(self.area.x0))..row.wrapping_add(column(self.area.x1))
    }
}

impl<I: Iterator<Item = Rect>> Transfers for Paged<'_, I> {
    fn next(&mut self) -> Option<Transfer<'_>> {
        self.open()?;
        let length = self.address();
        let Rect { y0, y1, .. } = self.area;
        let mut bytes = self.bytes(y0);
        self.area.y0 = y0.saturating_add(1);
        if self.oled.addressing == Addressing::Windows && bytes.len() == self.stride {
            // Without gaps: all pages at once.
            bytes.end = self.bytes(y1.saturating_sub(1)).end;
            self.area.y0 = y1;
        }
        self.is_open = true;
        let command = self.command.get(..length).unwrap_or_default();
        Some(Transfer { command, data: self.memory.get(bytes).unwrap_or_default() })
    }
}
