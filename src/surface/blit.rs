//! Surface to surface: [`Bitmap`] and the blits of a [`Framebuffer`].

use core::marker::PhantomData;

use embedded_graphics_core::geometry::{Point, Size};

use super::{
    framebuffer::{check, Framebuffer},
    Surface,
};
use crate::{
    error::BufferError,
    num::cast::{index, narrow, saturate},
    pixel::{self, row_bytes, PixelFormat},
    rect::Rect,
};

/// Pixels to read: a picture in flash, or a framebuffer that is not being drawn to.
/// ```
/// use embedded_graphics_core::{geometry::Point, pixelcolor::Gray8};
/// use embedded_raster::{surface::Bitmap, Framebuffer};
/// static PICTURE: [u8; 6] = [1, 2, 3, 4, 5, 6];
/// let picture = Bitmap::<Gray8>::new(&PICTURE, 3, 2)?;
/// let mut ram = [0; 4 * 2];
/// Framebuffer::<Gray8>::new(&mut ram, 4, 2)?.blit(Point::new(2, 0), &picture);
/// assert_eq!(ram, [0, 0, 1, 2, 0, 0, 4, 5]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Debug)]
pub struct Bitmap<'a, F> {
    memory: &'a [u8],
    stride: usize,
    window: Rect,
    row: i32,
    column: i32,
    format: PhantomData<F>,
}

impl<F> Copy for Bitmap<'_, F> {}

impl<F> Clone for Bitmap<'_, F> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<'a, F: PixelFormat> Bitmap<'a, F> {
    /// A picture of `width` x `height` pixels without gaps between the rows.
    ///
    /// # Errors
    /// [`BufferError::TooSmall`].
    pub fn new(memory: &'a [u8], width: u16, height: u16) -> Result<Self, BufferError> {
        Self::with_stride(memory, width, height, row_bytes::<F>(width))
    }

    /// A picture whose rows are `stride` bytes apart.
    ///
    /// # Errors
    /// [`BufferError::StrideTooSmall`], [`BufferError::TooSmall`].
    pub fn with_stride(memory: &'a [u8], width: u16, height: u16, stride: usize) -> Result<Self, BufferError> {
        check::<F>(memory.len(), width, height, stride)?;
        Ok(Self::of_memory(memory, stride, Rect::new(0, 0, width.into(), height.into()), 0, 0))
    }

    #[inline]
    pub(super) const fn of_memory(memory: &'a [u8], stride: usize, window: Rect, row: i32, column: i32) -> Self {
        Self { memory, stride, window, row, column, format: PhantomData }
    }

    /// The part of it in `area`; what lies outside of it is left out. Coordinates stay as they are.
    #[inline]
    #[must_use]
    pub fn part(&self, area: Rect) -> Self {
        Self { window: self.window.intersection(area), ..*self }
    }

    /// The pixels that it has.
    #[inline]
    pub const fn window(&self) -> Rect {
        self.window
    }

    /// Columns and rows that it has.
    #[inline]
    pub fn size(&self) -> Size {
        Size::new(self.window.width(), self.window.height())
    }

    /// The colour of a pixel; `None` if it lies outside.
    #[inline]
    pub fn get(&self, p: Point) -> Option<F::Color> {
        self.window
            .contains(p.x, p.y)
            .then(|| F::unpack(pixel::get::<F>(self.memory, self.row_start(p.y), self.x(p.x))))
    }

    /// The bytes of the pixels in `area`, row by row, widened to whole bytes. What lies outside is left out.
    pub fn bytes(&self, area: Rect) -> impl Iterator<Item = &'a [u8]> + 'a {
        let this = *self;
        let area = this.window.intersection(area);
        let byte = move |x: i32| this.x(x).wrapping_mul(F::BITS as usize);
        let rows = if area.is_empty() { 0..0 } else { area.y0..area.y1 };
        rows.map(move |y| {
            let row = this.row_start(y);
            let (start, end) = (byte(area.x0) / 8, byte(area.x1).div_ceil(8));
            this.memory.get(row.wrapping_add(start)..row.wrapping_add(end)).unwrap_or_default()
        })
    }

    #[inline(always)]
    fn row_start(&self, y: i32) -> usize {
        index(y.wrapping_add(self.row)).wrapping_mul(self.stride)
    }

    #[inline(always)]
    fn x(&self, x: i32) -> usize {
        index(x.wrapping_add(self.column))
    }
}

/// Copying pixels in. Source and target may be views at any pixel: sub-byte formats are shifted as they are copied.
impl<F: PixelFormat> Framebuffer<'_, F> {
    /// Copies a bitmap so that its top left pixel falls on `at`. What lies outside is clipped.
    pub fn blit(&mut self, at: Point, source: &Bitmap<'_, F>) {
        let Some(plan) = Plan::new(self.window(), at, source.window) else { return };
        let to = (self.row_start(plan.to.y), self.x(plan.to.x));
        let from = (source.row_start(plan.from.y), source.x(plan.from.x));
        let (stride, size) = (self.stride(), (plan.width, index(plan.height)));
        pixel::copy_rows::<F>((self.memory(), stride), to, (source.memory, source.stride), from, size);
    }

    /// The same, but pixels of the colour `key` are transparent.
    pub fn blit_keyed(&mut self, at: Point, source: &Bitmap<'_, F>, key: F::Color) {
        let key = F::pack(key);
        self.blit_rows(at, source, |memory, to, from, n| {
            pixel::copy_keyed::<F>(memory, to, source.memory, from, n, key);
        });
    }

    /// Paints a picture of one bit per pixel in two colours: `on` where a bit is set, and `off` elsewhere, or nothing if that
    /// is `None`. Glyphs and icons are such pictures. What lies outside is clipped.
    /// ```
    /// use embedded_graphics_core::{geometry::Point, pixelcolor::BinaryColor};
    /// use embedded_raster::{Bitmap, Framebuffer, Index4};
    /// let arrow = Bitmap::<BinaryColor>::new(&[0b0100_0000, 0b1110_0000], 3, 2)?;
    /// let mut ram = [0; 2 * 2];
    /// let mut frame = Framebuffer::<Index4>::new(&mut ram, 4, 2)?;
    /// frame.blit_mask(Point::new(1, 0), &arrow, Index4::new(9), None);
    /// assert_eq!(ram, [0x00, 0x90, 0x09, 0x99]);
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    pub fn blit_mask<M: PixelFormat>(
        &mut self,
        at: Point,
        mask: &Bitmap<'_, M>,
        on: F::Color,
        off: impl Into<Option<F::Color>>,
    ) {
        const { assert!(M::BITS == 1, "a mask has one bit per pixel") };
        let colors = (F::pack(on), off.into().map(F::pack));
        self.blit_rows(at, mask, |memory, to, from, n| {
            pixel::mask::draw::<F, M>(memory, to, mask.memory, from, n, colors);
        });
    }

    /// Moves the pixels of `area` so that its top left one falls on `to`; both may overlap. What the area leaves keeps its
    /// colours, what lies outside before or after is left out: scrolling by one row is `move_area(whole, (0, -1))`.
    pub fn move_area(&mut self, area: Rect, to: Point) {
        self.move_chunks(area, to, |memory, to, chunk, n| pixel::copy::<F>(memory, to, chunk, (0, 0), n));
    }

    /// The same, but pixels of the colour `key` are not copied.
    pub fn move_area_keyed(&mut self, area: Rect, to: Point, key: F::Color) {
        let key = F::pack(key);
        self.move_chunks(area, to, |memory, to, chunk, n| {
            pixel::copy_keyed::<F>(memory, to, chunk, (0, 0), n, key);
        });
    }

    /// Calls `copy` with memory, first byte and pixel of the row here, the same of the source, and a count, for each row.
    #[inline(always)]
    fn blit_rows<S: PixelFormat>(
        &mut self,
        at: Point,
        source: &Bitmap<'_, S>,
        copy: impl Fn(&mut [u8], (usize, usize), (usize, usize), usize),
    ) {
        let Some(plan) = Plan::new(self.window(), at, source.window) else { return };
        let (x, from_x) = (self.x(plan.to.x), source.x(plan.from.x));
        for down in 0..plan.height {
            let row = self.row_start(plan.to.y.wrapping_add(down));
            let from_row = source.row_start(plan.from.y.wrapping_add(down));
            copy(self.memory(), (row, x), (from_row, from_x), plan.width);
        }
    }

    /// Takes the pixels of an area up in small chunks and puts each down with `put`, in an order in which none is painted
    /// over before it was taken up.
    fn move_chunks(&mut self, area: Rect, to: Point, put: impl Fn(&mut [u8], (usize, usize), &[u8], usize)) {
        /// Divisible by the bytes of every format.
        const CHUNK: usize = 48;
        let pixels = CHUNK * 8 / F::BITS as usize;
        let seen = area.intersection(self.window());
        // In wide numbers: an area may start at i32::MIN, far outside, and still be moved by a pixel.
        let shifted = |to: i32, area: i32, seen: i32| saturate(i64::from(to) - i64::from(area) + i64::from(seen));
        let at = Point::new(shifted(to.x, area.x0, seen.x0), shifted(to.y, area.y0, seen.y0));
        let Some(plan) = Plan::new(self.window(), at, seen) else { return };
        let (upwards, to_left) = (plan.to.y <= plan.from.y, plan.to.x <= plan.from.x);
        let (to_x, from_x) = (self.x(plan.to.x), self.x(plan.from.x));
        let chunks = plan.width.div_ceil(pixels);
        for i in 0..plan.height {
            let down = if upwards { i } else { plan.height.wrapping_sub(1).wrapping_sub(i) };
            let to_row = self.row_start(plan.to.y.wrapping_add(down));
            let from_row = self.row_start(plan.from.y.wrapping_add(down));
            for c in 0..chunks {
                let c = if to_left { c } else { chunks.wrapping_sub(1).wrapping_sub(c) };
                let right = c.wrapping_mul(pixels);
                let n = pixels.min(plan.width.wrapping_sub(right));
                let mut chunk = [0; CHUNK];
                let from = (from_row, from_x.wrapping_add(right));
                pixel::copy::<F>(&mut chunk, (0, 0), self.memory(), from, n);
                put(self.memory(), (to_row, to_x.wrapping_add(right)), &chunk, n);
            }
        }
    }
}

/// Which pixels of a window are copied from which of a source: `width` columns and `height` rows, at least one.
struct Plan {
    to: Point,
    from: Point,
    width: usize,
    height: i32,
}

impl Plan {
    fn new(window: Rect, at: Point, source: Rect) -> Option<Self> {
        // One axis: the visible start, its place in the source, and the length. In wide numbers, as the source may end
        // beyond i32::MAX.
        let clip = |low: i32, high: i32, at: i32, from: i32, from_end: i32| {
            let start = low.max(at);
            let end = i64::from(high).min(i64::from(at) + i64::from(from_end) - i64::from(from));
            let len = narrow(end - i64::from(start));
            (i64::from(start) < end).then(|| (start, start.wrapping_sub(at).wrapping_add(from), len))
        };
        let (x, from_x, width) = clip(window.x0, window.x1, at.x, source.x0, source.x1)?;
        let (y, from_y, height) = clip(window.y0, window.y1, at.y, source.y0, source.y1)?;
        Some(Self { to: Point::new(x, y), from: Point::new(from_x, from_y), width: index(width), height })
    }
}
