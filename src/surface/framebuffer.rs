//! [`Framebuffer`]: rows of pixels in borrowed memory.

use core::{marker::PhantomData, ops::Range};

use embedded_graphics_core::geometry::{Point, Size};

use super::{Bitmap, Surface};
use crate::{
    error::BufferError,
    num::cast::index,
    octants::Octants,
    pixel::{self, row_bytes, scan, PixelFormat},
    rect::Rect,
    span::{ClippedSpan, Steps},
    target::COMPACT,
};

/// Rows of pixels in memory that the caller owns: a whole screen, a band of one, or a view of a part.
///
/// Pixel (x, y) starts at bit `x * BITS` of row y, and row y at byte `y * stride`. Drawing outside is clipped.
/// ```
/// use embedded_graphics_core::geometry::Point;
/// use embedded_raster::{Canvas, Framebuffer, Index4};
/// let mut ram = [0; 4 * 2];
/// let mut frame = Framebuffer::<Index4>::new(&mut ram, 8, 2)?;
/// frame.draw_line(Point::new(1, 0), Point::new(100, 0), Index4::new(9));
/// assert_eq!(frame.get(Point::new(7, 0)), Some(Index4::new(9)));
/// assert_eq!(ram, [0x09, 0x99, 0x99, 0x99, 0, 0, 0, 0]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Debug)]
pub struct Framebuffer<'a, F> {
    memory: &'a mut [u8],
    stride: usize,
    /// The screen, which may be larger than what is in memory.
    width: u16,
    height: u16,
    /// What may be painted: inside the screen and inside the memory.
    window: Rect,
    /// The row and column of the memory that (0, 0) falls on.
    row: i32,
    column: i32,
    format: PhantomData<F>,
}

impl<'a, F: PixelFormat> Framebuffer<'a, F> {
    /// A screen of `width` x `height` pixels without gaps between the rows.
    ///
    /// # Errors
    /// [`BufferError::TooSmall`] if `memory` is shorter than [`buffer_bytes`](crate::buffer_bytes). A longer one is fine:
    /// the rest stays untouched.
    #[inline]
    pub fn new(memory: &'a mut [u8], width: u16, height: u16) -> Result<Self, BufferError> {
        Self::with_stride(memory, width, height, row_bytes::<F>(width))
    }

    /// A screen whose rows are `stride` bytes apart.
    ///
    /// # Errors
    /// [`BufferError::StrideTooSmall`], [`BufferError::TooSmall`]. Bytes after the pixels of the last row are not needed.
    #[inline]
    pub fn with_stride(memory: &'a mut [u8], width: u16, height: u16, stride: usize) -> Result<Self, BufferError> {
        check::<F>(memory.len(), width, height, stride)?;
        let window = Rect::new(0, 0, width.into(), height.into());
        Ok(Self { memory, stride, width, height, window, row: 0, column: 0, format: PhantomData })
    }

    /// Rows `rows` of a screen of `width` x `height` pixels, drawn in screen coordinates: the way to a picture that is
    /// larger than the memory. Draw the scene once a band; no pixel differs from drawing it whole.
    /// ```
    /// use embedded_graphics_core::geometry::Point;
    /// use embedded_raster::{Framebuffer, Index8};
    /// let mut ram = [0; 320 * 16];
    /// let mut band = Framebuffer::<Index8>::band(&mut ram, 320, 240, 64..80)?;
    /// band.set(Point::new(1, 64), Index8::new(7));
    /// assert_eq!(ram[1], 7);
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    /// # Errors
    /// [`BufferError::BandOutsideScreen`], [`BufferError::TooSmall`].
    pub fn band(memory: &'a mut [u8], width: u16, height: u16, rows: Range<u16>) -> Result<Self, BufferError> {
        let Range { start, end } = rows;
        if start > end || end > height {
            return Err(BufferError::BandOutsideScreen { start, end, height });
        }
        let stride = row_bytes::<F>(width);
        check::<F>(memory.len(), width, end - start, stride)?;
        let window = Rect::new(0, start.into(), width.into(), end.into());
        let row = i32::from(start).wrapping_neg();
        Ok(Self { memory, stride, width, height, window, row, column: 0, format: PhantomData })
    }

    /// The part of it in `area`, as a surface of its own whose (0, 0) is the top left corner of `area`.
    ///
    /// What lies outside of this surface is clipped; the size is that of `area` all the same, up to 65,535.
    #[must_use]
    pub fn view(&mut self, area: Rect) -> Framebuffer<'_, F> {
        let size = |n: u32| u16::try_from(n).unwrap_or(u16::MAX);
        let (width, height) = (size(area.width()), size(area.height()));
        let here = Rect { x1: area.x0.saturating_add(width.into()), y1: area.y0.saturating_add(height.into()), ..area };
        Framebuffer {
            window: here.intersection(self.window).relative_to(area.x0, area.y0),
            row: self.row.wrapping_add(area.y0),
            column: self.column.wrapping_add(area.x0),
            memory: self.memory,
            stride: self.stride,
            width,
            height,
            format: PhantomData,
        }
    }

    /// The same surface, with drawing restricted to `area`; coordinates stay as they are.
    #[must_use]
    pub fn clipped(&mut self, area: Rect) -> Framebuffer<'_, F> {
        Framebuffer {
            window: self.window.intersection(area),
            row: self.row,
            column: self.column,
            memory: self.memory,
            stride: self.stride,
            width: self.width,
            height: self.height,
            format: PhantomData,
        }
    }

    /// Width and height of the screen.
    #[inline]
    pub fn size(&self) -> Size {
        Size::new(self.width.into(), self.height.into())
    }

    /// Bytes from one row to the next.
    #[inline]
    pub const fn stride(&self) -> usize {
        self.stride
    }

    /// Paints one pixel; nothing if it lies outside.
    #[inline]
    pub fn set(&mut self, p: Point, color: F::Color) {
        if self.window.contains(p.x, p.y) {
            let (row, x) = (self.row_start(p.y), self.x(p.x));
            pixel::set::<F>(self.memory, row, x, F::pack(color));
        }
    }

    /// The colour of a pixel; `None` if it lies outside.
    #[inline]
    pub fn get(&self, p: Point) -> Option<F::Color> {
        self.window
            .contains(p.x, p.y)
            .then(|| F::unpack(pixel::get::<F>(self.memory, self.row_start(p.y), self.x(p.x))))
    }

    /// Paints everything. Bytes between the rows of a larger stride stay untouched.
    #[inline]
    pub fn clear(&mut self, color: F::Color) {
        self.fill_area(self.window, color);
    }

    /// The bytes of the pixels of some rows in `columns`, row by row, widened to whole bytes: what a display wants to be
    /// sent. Nothing for what lies outside.
    pub fn bytes(&self, area: Rect) -> impl Iterator<Item = &[u8]> + '_ {
        self.as_bitmap().bytes(area)
    }

    /// The bytes of whole rows as they lie in memory, gaps of the stride included, in one piece: for DMA. Empty if a row
    /// lies outside.
    pub fn row_bytes(&self, rows: Range<u16>) -> &[u8] {
        let inside = i32::from(rows.start) >= self.window.y0 && i32::from(rows.end) <= self.window.y1;
        let (start, end) = (self.row_start(rows.start.into()), self.row_start(rows.end.into()));
        let end = end.min(self.memory.len());
        self.memory.get(start..end).filter(|_| inside).unwrap_or_default()
    }

    /// The colours of the pixels in `area`, row by row from left to right. What lies outside is left out.
    pub fn colors(&self, area: Rect) -> impl Iterator<Item = F::Color> + '_ {
        let area = self.window.intersection(area);
        (area.y0..area.y1).flat_map(move |y| {
            let row = self.row_start(y);
            (area.x0..area.x1).map(move |x| F::unpack(pixel::get::<F>(self.memory, row, self.x(x))))
        })
    }

    /// It as a source of blits.
    #[inline]
    pub fn as_bitmap(&self) -> Bitmap<'_, F> {
        Bitmap::of_memory(self.memory, self.stride, self.window, self.row, self.column)
    }

    /// Paints the start of a row of colours: takes exactly `span.len()` of them, or all there are.
    #[inline]
    pub(crate) fn write_span(&mut self, span: ClippedSpan, colors: &mut impl Iterator<Item = F::Color>) {
        let row = self.row_start(span.y());
        for x in self.x(span.x0())..self.x(span.x1()) {
            let Some(color) = colors.next() else { return };
            pixel::set::<F>(self.memory, row, x, F::pack(color));
        }
    }

    /// The first of the pixels `x0..x1` of a row, all in the window, whose bits are wanted; `x1` if none is.
    #[inline(always)]
    pub(crate) fn find(&self, y: i32, x0: i32, x1: i32, wanted: impl Fn(u32) -> bool) -> i32 {
        let start = self.x(x0);
        let found = scan::find::<F>(self.memory, self.row_start(y), (start, self.x(x1)), wanted);
        x0.wrapping_add(distance(start, found))
    }

    /// Where the pixels begin that end before `x`, not before `x0`, and whose bits are all wanted.
    #[inline(always)]
    pub(crate) fn start(&self, y: i32, x0: i32, x: i32, wanted: impl Fn(u32) -> bool) -> i32 {
        let end = self.x(x);
        let found = scan::start::<F>(self.memory, self.row_start(y), (self.x(x0), end), wanted);
        x.wrapping_sub(distance(found, end))
    }

    /// Paints down from a pixel of the window, or up, where the way is one pixel wide: see `FloodTarget::corridor`. `None` where
    /// that has to be found out pixel by pixel: at the sides of the window, and where pixels share a byte.
    #[inline(always)]
    pub(crate) fn corridor(
        &mut self,
        (x, y): (i32, i32),
        down: bool,
        bits: u32,
        is_open: impl Fn(u32) -> bool,
    ) -> Option<i32> {
        let Rect { x0, x1, y0, y1 } = self.window;
        if COMPACT || F::BITS < 8 || x <= x0 || x >= x1.wrapping_sub(1) {
            return None;
        }
        let (left, right) = (self.x(x.wrapping_sub(1)), self.x(x.wrapping_add(2)));
        let place = |y: i32, x: usize| self.row_start(y).wrapping_add(x.wrapping_mul(pixel::bytes_per_pixel::<F>()));
        // The memory from the first row of the window to its last: beyond it the corridor ends.
        let (first, at, end) = (place(y0, left), place(y, left), place(y1.wrapping_sub(1), right));
        let rows = self.memory.get_mut(first..end)?;
        let by = if down { self.stride } else { self.stride.wrapping_neg() };
        let painted = scan::corridor::<F>(rows, at.wrapping_sub(first), by, bits, is_open);
        Some(if down { y.wrapping_add(painted) } else { y.wrapping_sub(painted) })
    }

    /// Writes a pixel that lies in the window.
    #[inline(always)]
    pub(crate) fn put(&mut self, x: i32, y: i32, bits: u32) {
        let (row, x) = (self.row_start(y), self.x(x));
        pixel::set::<F>(self.memory, row, x, bits);
    }

    /// The bits of a pixel that lies in the window.
    #[inline(always)]
    pub(crate) fn bits(&self, x: i32, y: i32) -> u32 {
        scan::used::<F>(pixel::get::<F>(self.memory, self.row_start(y), self.x(x)))
    }

    /// First byte of a row that lies in the window.
    #[inline(always)]
    pub(super) fn row_start(&self, y: i32) -> usize {
        index(y.wrapping_add(self.row)).wrapping_mul(self.stride)
    }

    /// Place in its row in memory of a column that lies in the window.
    #[inline(always)]
    pub(super) fn x(&self, x: i32) -> usize {
        index(x.wrapping_add(self.column))
    }

    #[inline(always)]
    pub(super) fn memory(&mut self) -> &mut [u8] {
        self.memory
    }
}

/// From one place in a row to another, less than a row of 65,535 pixels away.
#[inline(always)]
fn distance(from: usize, to: usize) -> i32 {
    i32::try_from(to.wrapping_sub(from)).unwrap_or_default()
}

/// Do `height` rows `stride` bytes apart fit into `given` bytes?
#[inline]
pub(super) fn check<F: PixelFormat>(given: usize, width: u16, height: u16, stride: usize) -> Result<(), BufferError> {
    let row = row_bytes::<F>(width);
    if stride < row {
        return Err(BufferError::StrideTooSmall { needed: row, given: stride });
    }
    let needed = match height {
        0 => 0,
        _ => stride.saturating_mul(usize::from(height) - 1).saturating_add(row),
    };
    if given < needed {
        return Err(BufferError::TooSmall { needed, given });
    }
    Ok(())
}

impl<F: PixelFormat> Surface for Framebuffer<'_, F> {
    type Color = F::Color;

    #[inline(always)]
    fn window(&self) -> Rect {
        self.window
    }

    // Inlined into the loops of the shapes even at their several call sites: a call would cost as much as a short span.
    #[inline(always)]
    fn fill_span(&mut self, span: ClippedSpan, color: F::Color) {
        let row = self.row_start(span.y());
        let (x0, x1) = (self.x(span.x0()), self.x(span.x1()));
        pixel::fill::<F>(self.memory, row, x0, x1, F::pack(color));
    }

    #[inline]
    fn fill_area(&mut self, area: Rect, color: F::Color) {
        let area = area.intersection(self.window);
        if area.is_empty() {
            return;
        }
        let columns = (self.x(area.x0), self.x(area.x1));
        let row = self.row_start(area.y0);
        pixel::fill_rows::<F>(self.memory, self.stride, (row, area.height() as usize), columns, F::pack(color));
    }

    #[inline]
    fn fill_steps(&mut self, steps: Steps, color: F::Color) {
        if let Some(span) = steps.one_row().filter(|_| !COMPACT) {
            return self.fill_span(span, color);
        }
        let (x, y) = steps.first();
        let start = (index(y.wrapping_add(self.row)), self.x(x));
        pixel::walk::draw::<F>(self.memory, self.stride, start, steps, F::pack(color));
    }

    #[inline]
    fn fill_octants(&mut self, octants: Octants, color: F::Color) {
        let (x, y) = octants.first();
        let start = (index(y.wrapping_add(self.row)), self.x(x));
        pixel::walk::draw_octants::<F>(self.memory, self.stride, start, octants, F::pack(color));
    }
}
