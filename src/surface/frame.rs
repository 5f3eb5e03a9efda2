//! [`Frame`]: memory and a layout, which together are a surface.

use core::{fmt, marker::PhantomData, ops::Range};

use embedded_graphics_core::geometry::{Point, Size};

use super::layout::{Grid, Layout, Place};
use crate::{
    error::BufferError,
    num::cast::index,
    span::{ClippedSpan, Rect},
};

/// Pixels in memory: a whole screen, a band of one, or a view of a part.
///
/// * `M` is the memory: `&mut [u8]`, an array or a `heapless::Vec` to draw on and to read, or `&[u8]` to read only, such as a
///   picture in flash. What is `AsRef<[u8]>` can be read, what is `AsMut<[u8]>` can be drawn on.
/// * `L` says where in the memory a pixel is: see [`Layout`].
///
/// Drawing outside is clipped. [`Framebuffer`](super::Framebuffer), [`Bitmap`](super::Bitmap) and [`Paged`](super::Paged) are
/// short names for the usual ones.
pub struct Frame<M, L> {
    memory: M,
    grid: Grid,
    /// The screen, which may be larger than what is in memory.
    width: u16,
    height: u16,
    /// What may be painted: inside the screen and inside the memory.
    window: Rect,
    /// The row and column of the memory that (0, 0) falls on.
    row: i32,
    column: i32,
    layout: PhantomData<L>,
}

impl<M: Copy, L> Copy for Frame<M, L> {}

impl<M: Copy, L> Clone for Frame<M, L> {
    fn clone(&self) -> Self {
        *self
    }
}

/// Prints the sizes, not the pixels.
impl<M, L> fmt::Debug for Frame<M, L> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { grid, width, height, window, .. } = self;
        f.debug_struct("Frame")
            .field("width", width)
            .field("height", height)
            .field("window", window)
            .field("grid", grid)
            .finish_non_exhaustive()
    }
}

impl<M: AsRef<[u8]>, L: Layout> Frame<M, L> {
    /// A screen of `width` x `height` pixels without gaps between the rows.
    ///
    /// # Errors
    /// [`BufferError::TooSmall`] if `memory` is shorter than [`Layout::bytes`]; for rows of pixels
    /// [`buffer_bytes`](crate::buffer_bytes) tells the same to arrays. A longer one is fine: the rest stays untouched.
    #[inline]
    pub fn new(memory: M, width: u16, height: u16) -> Result<Self, BufferError> {
        Self::with_stride(memory, width, height, L::row_bytes(width))
    }

    /// A screen whose rows are `stride` bytes apart: for a controller that wants rows to begin at certain addresses, or a part of a
    /// wider picture. Nothing that is drawn touches what lies between the rows.
    /// ```
    /// use embedded_raster::{Canvas, Framebuffer, Index8, Rect};
    /// let mut ram = *b"....----....----....----";
    /// let mut frame = Framebuffer::<Index8>::with_stride(&mut ram, 4, 3, 8)?;
    /// frame.clear(Index8::new(b'o'));
    /// frame.fill_rectangle(Rect::new(1, 1, 9, 9), Index8::new(b'#'));
    /// assert_eq!(&ram, b"oooo----o###----o###----");
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    /// # Errors
    /// [`BufferError::StrideTooSmall`], [`BufferError::TooSmall`]. Bytes after the pixels of the last row are not needed.
    #[inline]
    pub fn with_stride(memory: M, width: u16, height: u16, stride: usize) -> Result<Self, BufferError> {
        let grid = Grid { stride, rows: height.into() };
        check::<L>(memory.as_ref().len(), width, grid)?;
        let window = Rect::new(0, 0, width.into(), height.into());
        Ok(Self { memory, grid, width, height, window, row: 0, column: 0, layout: PhantomData })
    }

    /// A screen without gaps, of memory that is known to be large enough.
    #[inline]
    pub(super) fn of_its_size(memory: M, width: u16, height: u16) -> Self {
        let grid = Grid { stride: L::row_bytes(width), rows: height.into() };
        let window = Rect::new(0, 0, width.into(), height.into());
        Self { memory, grid, width, height, window, row: 0, column: 0, layout: PhantomData }
    }

    /// A band: the rows `rows` of a screen of `width` x `height` pixels, drawn in the coordinates of the screen. So a picture can
    /// be larger than the memory: draw the scene once for each band. No pixel differs from drawing it whole.
    /// ```
    /// use embedded_graphics_core::geometry::Point;
    /// use embedded_raster::{Framebuffer, Index8, Surface};
    /// let mut ram = [0; 320 * 16];
    /// let mut band = Framebuffer::<Index8>::band(&mut ram, 320, 240, 64..80)?;
    /// band.set(Point::new(1, 64), Index8::new(7));
    /// assert_eq!(ram[1], 7);
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    /// # Errors
    /// [`BufferError::BandOutsideScreen`], [`BufferError::TooSmall`], and of layouts whose rows share bytes
    /// [`BufferError::BandSplitsPage`].
    pub fn band(memory: M, width: u16, height: u16, rows: Range<u16>) -> Result<Self, BufferError> {
        let Range { start, end } = rows;
        if start > end || end > height {
            return Err(BufferError::BandOutsideScreen { start, end, height });
        }
        if L::PAGE > 1 && !(start.is_multiple_of(L::PAGE) && (end == height || end.is_multiple_of(L::PAGE))) {
            return Err(BufferError::BandSplitsPage { start, end, page: L::PAGE });
        }
        let grid = Grid { stride: L::row_bytes(width), rows: (end - start).into() };
        check::<L>(memory.as_ref().len(), width, grid)?;
        let window = Rect::new(0, start.into(), width.into(), end.into());
        let row = i32::from(start).wrapping_neg();
        Ok(Self { memory, grid, width, height, window, row, column: 0, layout: PhantomData })
    }

    /// The same pixels, borrowed to be read: as the source of a blit, for example.
    #[inline]
    pub fn as_bitmap(&self) -> Frame<&[u8], L> {
        self.with_memory(self.memory.as_ref())
    }

    /// The colours of the pixels in `area`, row by row from left to right. What lies outside is left out.
    pub fn colors(&self, area: Rect) -> impl Iterator<Item = L::Color> + use<'_, M, L> {
        let area = self.window.intersection(area);
        (area.y0..area.y1).flat_map(move |y| (area.x0..area.x1).map(move |x| self.at(x, y)))
    }

    /// The colour of a pixel; `None` if it lies outside.
    #[doc(alias("readPixel", "getPixel", "get_pixel", "pixel"))]
    #[inline]
    pub fn get(&self, p: impl Into<Point>) -> Option<L::Color> {
        let p = p.into();
        self.window.contains(p.x, p.y).then(|| self.at(p.x, p.y))
    }

    /// The colour of a pixel that lies in the window.
    #[inline(always)]
    pub(crate) fn at(&self, x: i32, y: i32) -> L::Color {
        let (memory, grid) = self.read();
        L::get(memory, grid, self.place(x, y))
    }

    /// Its memory, for the functions of the layout.
    #[inline(always)]
    pub(super) fn read(&self) -> (&[u8], Grid) {
        (self.memory.as_ref(), self.grid)
    }

    /// All of its memory: for what sends pixels to a display as they lie. Where one lies, [`place_of`](Self::place_of) and the layout tell.
    #[inline]
    pub fn memory(&self) -> &[u8] {
        self.memory.as_ref()
    }

    /// The bytes of a range of pages of `page` rows each. Rows are pages of one row.
    pub(super) fn run_of_bytes(&self, range: Range<u16>, page: u16) -> &[u8] {
        let row = |n: u16| i32::from(n).wrapping_mul(page.into());
        // The last page may have fewer rows.
        let inside = row(range.start) >= self.window.y0 && row(range.end) < self.window.y1.saturating_add(page.into());
        let byte = |n: u16| (self.y(row(n)) / usize::from(page)).wrapping_mul(self.grid.stride);
        let memory = self.memory.as_ref();
        memory.get(byte(range.start)..byte(range.end).min(memory.len())).filter(|_| inside).unwrap_or_default()
    }
}

impl<M, L> Frame<M, L> {
    /// Width and height of the screen, or of the view.
    #[inline]
    pub fn size(&self) -> Size {
        Size::new(self.width.into(), self.height.into())
    }

    /// Bytes from one row to the next, or from one page to the next.
    #[inline]
    pub const fn stride(&self) -> usize {
        self.grid.stride
    }

    /// The pixels that it has: those of the screen that are in memory and not clipped away.
    #[inline]
    pub const fn window(&self) -> Rect {
        self.window
    }

    /// Column and row in memory of a pixel, counted from 0; `None` if it lies outside. In bands and views they are not its coordinates.
    /// ```
    /// use embedded_raster::{Framebuffer, Index4};
    /// let mut ram = [0; 160 * 16];
    /// let mut band = Framebuffer::<Index4>::band(&mut ram, 320, 240, 64..80)?;
    /// assert_eq!(band.place_of((5, 66)), Some((5, 2)));
    /// assert_eq!(band.view(embedded_raster::Rect::new(4, 65, 9, 70)).place_of((1, 1)), Some((5, 2)));
    /// assert_eq!(band.place_of((5, 80)), None);
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[inline]
    pub fn place_of(&self, p: impl Into<Point>) -> Option<Place> {
        let p = p.into();
        self.window.contains(p.x, p.y).then(|| self.place(p.x, p.y))
    }

    /// Column and row in memory of a pixel that lies in the window.
    #[inline(always)]
    pub(super) fn place(&self, x: i32, y: i32) -> Place {
        (self.x(x), self.y(y))
    }

    /// Row in memory of a row that lies in the window.
    #[inline(always)]
    pub(super) fn y(&self, y: i32) -> usize {
        index(y.wrapping_add(self.row))
    }

    /// Column in memory of a column that lies in the window.
    #[inline(always)]
    pub(super) fn x(&self, x: i32) -> usize {
        index(x.wrapping_add(self.column))
    }

    /// Columns in memory of a span.
    #[inline(always)]
    pub(super) fn columns(&self, span: ClippedSpan) -> (usize, usize) {
        (self.x(span.x0()), self.x(span.x1()))
    }

    /// Rows and columns in memory of the part of `area` that lies in the window.
    #[inline(always)]
    pub(super) fn places(&self, area: Rect) -> Option<((usize, usize), (usize, usize))> {
        let Rect { x0, y0, x1, y1 } = area.intersection(self.window);
        let is_empty = x0 >= x1 || y0 >= y1;
        (!is_empty).then(|| ((self.y(y0), self.y(y1)), (self.x(x0), self.x(x1))))
    }

    /// The same frame around another form of the same bytes.
    #[inline(always)]
    fn with_memory<N>(&self, memory: N) -> Frame<N, L> {
        let Self { grid, width, height, window, row, column, layout, .. } = *self;
        Frame { memory, grid, width, height, window, row, column, layout }
    }

    /// The same frame, restricted to `area`.
    #[inline(always)]
    fn within(self, area: Rect) -> Self {
        Self { window: self.window.intersection(area), ..self }
    }

    /// The same frame with (0, 0) at the corner of `area`, and restricted to `area`.
    #[inline]
    fn seen_from(self, area: Rect) -> Self {
        let size = |n: u32| u16::try_from(n).unwrap_or(u16::MAX);
        let (width, height) = (size(area.width()), size(area.height()));
        let here = Rect { x1: area.x0.saturating_add(width.into()), y1: area.y0.saturating_add(height.into()), ..area };
        Self {
            window: here.intersection(self.window).relative_to(area.x0, area.y0),
            row: self.row.wrapping_add(area.y0),
            column: self.column.wrapping_add(area.x0),
            width,
            height,
            ..self
        }
    }
}

impl<M: AsMut<[u8]>, L: Layout> Frame<M, L> {
    /// Its memory, for the functions of the layout.
    #[inline(always)]
    pub(super) fn write(&mut self) -> (&mut [u8], Grid) {
        (self.memory.as_mut(), self.grid)
    }

    /// The same pixels, borrowed to be drawn on: to pass a frame on and have it back.
    #[inline]
    pub fn as_mut(&mut self) -> Frame<&mut [u8], L> {
        let Self { grid, width, height, window, row, column, layout, .. } = *self;
        Frame { memory: self.memory.as_mut(), grid, width, height, window, row, column, layout }
    }

    /// Paints all pixels of the window. Bytes between the rows of a larger stride stay untouched.
    #[doc(alias("fillScreen", "fill_screen", "fill_window", "clearDisplay", "clearBuffer", "cls"))]
    #[inline]
    pub fn clear(&mut self, color: L::Color) {
        if let Some((rows, columns)) = self.places(self.window) {
            let (memory, grid) = self.write();
            L::fill_area(memory, grid, rows, columns, color);
        }
    }
}

impl<L: Layout> Frame<&mut [u8], L> {
    /// The part of it in `area`, as a surface of its own whose (0, 0) is the top left corner of `area`.
    ///
    /// Its size is that of `area`, up to 65,535 each way. Where `area` reaches beyond this surface, pixels are clipped.
    ///
    /// Views and [clips](Self::clipped) are values that borrow what they are made of. One inside of the other is a stack of viewports,
    /// without pushing and popping: when the inner one is gone, the outer one is there as it was.
    /// ```
    /// use embedded_graphics_core::pixelcolor::Gray8;
    /// use embedded_raster::{Canvas, Framebuffer, Rect};
    /// let mut ram = [b'.'; 8 * 4];
    /// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 8, 4)?;
    /// let mut window = frame.view(Rect::new(1, 1, 7, 4));
    /// {
    ///     let mut list = window.clipped(Rect::new(1, 0, 5, 2)); // the (0, 0) of the window, fewer pixels
    ///     list.fill_window(Gray8::new(b'-'));
    ///     list.view(Rect::new(3, 1, 9, 9)).fill_window(Gray8::new(b'#')); // nothing outside of the list
    /// }
    /// window.draw_line((0, 0), (0, 9), Gray8::new(b'|')); // outside of the list, inside of the window
    /// assert_eq!(&ram, b".........|----...|--##...|......");
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[must_use]
    pub fn view(&mut self, area: impl Into<Rect>) -> Frame<&mut [u8], L> {
        self.as_mut().seen_from(area.into())
    }

    /// The same surface, with drawing restricted to `area`; coordinates stay as they are.
    #[must_use]
    pub fn clipped(&mut self, area: impl Into<Rect>) -> Frame<&mut [u8], L> {
        self.as_mut().within(area.into())
    }
}

impl<L: Layout> Frame<&mut [u8], L> {
    /// Cuts it above a row: what lies above, and what lies below with that row. Both keep the coordinates of the whole, and have no
    /// memory in common, so two cores can draw on them at once. Where the row lies outside of what is in memory, one of them is empty.
    /// ```
    /// use embedded_raster::{Canvas, Framebuffer, Index8};
    /// let mut ram = [0; 64 * 48];
    /// let screen = Framebuffer::<Index8>::new(&mut ram, 64, 48)?;
    /// let (mut above, mut below) = screen.split_at_row(20)?;
    /// // On another core, or in another thread:
    /// above.fill_triangle([(5, 3), (60, 20), (20, 45)], Index8::new(7));
    /// below.fill_triangle([(5, 3), (60, 20), (20, 45)], Index8::new(7));
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    /// # Errors
    /// [`BufferError::CutInPage`] between rows that share bytes; [`BufferError::RowsApart`] if rows do not lie one after the other in
    /// memory, as in [`Planes`](super::Planes), or if the layout does not [say so](Layout::bytes_above).
    pub fn split_at_row(self, row: i32) -> Result<(Self, Self), BufferError> {
        let Self { memory, grid, width, height, window, row: offset, column, layout } = self;
        let y = index(row.saturating_add(offset).max(0)).min(grid.rows);
        if y != grid.rows && !y.is_multiple_of(L::PAGE.into()) {
            return Err(BufferError::CutInPage { row, page: L::PAGE });
        }
        let bytes = L::bytes_above(grid, y).ok_or(BufferError::RowsApart { row })?;
        // The last row may end before its stride does.
        let (upper, lower) = memory.split_at_mut(bytes.min(memory.len()));
        let (Rect { y0, y1, .. }, rows) = (window, grid.rows.wrapping_sub(y));
        let window = |y0: i32, y1: i32| Rect { y0, y1, ..window };
        let grid = |rows: usize| Grid { rows, ..grid };
        let below = offset.wrapping_sub(i32::try_from(y).unwrap_or(i32::MAX));
        Ok((
            Frame {
                memory: upper,
                grid: grid(y),
                width,
                height,
                window: window(y0, y1.min(row)),
                row: offset,
                column,
                layout,
            },
            Frame {
                memory: lower,
                grid: grid(rows),
                width,
                height,
                window: window(y0.max(row), y1),
                row: below,
                column,
                layout,
            },
        ))
    }
}

impl<L: Layout> Frame<&[u8], L> {
    /// The part of it in `area`, as a picture of its own whose (0, 0) is the top left corner of `area`: a tile of a sheet, say.
    #[must_use]
    pub fn view(&self, area: impl Into<Rect>) -> Self {
        self.seen_from(area.into())
    }

    /// The part of it in `area`; what lies outside is left out. Coordinates stay as they are.
    #[inline]
    #[must_use]
    pub fn clipped(&self, area: impl Into<Rect>) -> Self {
        self.within(area.into())
    }
}

/// Do the pixels fit into `given` bytes?
#[inline]
fn check<L: Layout>(given: usize, width: u16, grid: Grid) -> Result<(), BufferError> {
    let row = L::row_bytes(width);
    if grid.stride < row {
        return Err(BufferError::StrideTooSmall { needed: row, given: grid.stride });
    }
    let needed = L::bytes(width, grid);
    if given < needed {
        return Err(BufferError::TooSmall { needed, given });
    }
    Ok(())
}
