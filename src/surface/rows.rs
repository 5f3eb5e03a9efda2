//! [`Rows`]: one row of pixels after the other.

use core::{marker::PhantomData, ops::Range};

use super::{
    frame::Frame,
    layout::{each_part, Grid, Layout, Place},
};
use crate::{
    pixel::{
        rows::{
            self,
            mask::{self, Bits},
            scan,
            strip::{self, Pairs},
            walk,
        },
        PixelFormat,
    },
    span::{Octants, Rect, Steps},
    tune::COMPACT,
};

/// Whether corridors are filled in memory, where pixels take whole bytes.
const CORRIDORS: bool = !COMPACT;

/// Rows of pixels of the format `F` in borrowed memory: the usual surface.
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
pub type Framebuffer<'a, F> = Frame<&'a mut [u8], Rows<F>>;

/// Rows of pixels to read: a picture in flash, or a framebuffer that is not being drawn to.
/// ```
/// use embedded_graphics_core::{geometry::Point, pixelcolor::Gray8};
/// use embedded_raster::{Bitmap, Canvas, Framebuffer};
/// static PICTURE: [u8; 6] = [1, 2, 3, 4, 5, 6];
/// let picture = Bitmap::<Gray8>::new(&PICTURE, 3, 2)?;
/// let mut ram = [0; 4 * 2];
/// Framebuffer::<Gray8>::new(&mut ram, 4, 2)?.blit(Point::new(2, 0), &picture);
/// assert_eq!(ram, [0, 0, 1, 2, 0, 0, 4, 5]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
pub type Bitmap<'a, F> = Frame<&'a [u8], Rows<F>>;

/// Rows of pixels of the format `F`: pixel (x, y) starts at bit `x * BITS` of row y, and row y at byte `y * stride`.
#[derive(Copy, Clone, Debug)]
pub struct Rows<F>(PhantomData<F>);

/// The first byte of a row.
#[inline(always)]
fn start(grid: Grid, y: usize) -> usize {
    y.wrapping_mul(grid.stride)
}

/// Row by row. Built for speed it is a function of its own: inlined, its loop would share the registers of what is around it.
#[cfg_attr(not(embedded_raster_compact), inline(never))]
fn copy_keyed<F: PixelFormat>(
    (to, to_stride, (to_x, mut to_row)): (&mut [u8], usize, (usize, usize)),
    (from, from_stride, (from_x, mut from_row)): (&[u8], usize, (usize, usize)),
    (width, height): (usize, usize),
    key: u32,
) {
    for _ in 0..height {
        rows::copy_keyed::<F>(to, (to_row, to_x), from, (from_row, from_x), width, key);
        to_row = to_row.wrapping_add(to_stride);
        from_row = from_row.wrapping_add(from_stride);
    }
}

impl<F: PixelFormat> Layout for Rows<F> {
    type Color = F::Color;

    #[inline]
    fn row_bytes(width: u16) -> usize {
        crate::pixel::row_bytes::<F>(width)
    }

    #[inline]
    fn bytes_above(grid: Grid, y: usize) -> Option<usize> {
        Some(start(grid, y))
    }

    #[inline(always)]
    fn get(memory: &[u8], grid: Grid, (x, y): Place) -> F::Color {
        F::unpack(rows::get::<F>(memory, start(grid, y), x))
    }

    #[inline]
    fn is_whole(grid: Grid) -> bool {
        F::BITS < 8 || grid.stride.is_multiple_of((F::BITS / 8) as usize)
    }

    #[inline(always)]
    fn get_whole(memory: &[u8], grid: Grid, (x, y): Place) -> F::Color {
        F::unpack(rows::get_whole::<F>(memory, grid.stride, (x, y)))
    }

    #[inline(always)]
    fn set(memory: &mut [u8], grid: Grid, (x, y): Place, color: F::Color) {
        rows::set::<F>(memory, start(grid, y), x, F::pack(color));
    }

    // Inlined into the loops of the shapes even at their several call sites: a call would cost as much as a short span.
    #[inline(always)]
    fn fill_span(memory: &mut [u8], grid: Grid, y: usize, (x0, x1): (usize, usize), color: F::Color) {
        rows::fill::<F>(memory, start(grid, y), x0, x1, F::pack(color));
    }

    #[inline(always)]
    fn fill_area(memory: &mut [u8], grid: Grid, (y0, y1): (usize, usize), columns: (usize, usize), color: F::Color) {
        let rows = (start(grid, y0), y1.wrapping_sub(y0));
        rows::fill_rows::<F>(memory, grid.stride, rows, columns, F::pack(color));
    }

    #[inline(always)]
    fn fill_steps(memory: &mut [u8], grid: Grid, (x, y): Place, steps: Steps, color: F::Color) -> bool {
        walk::draw::<F>(memory, grid.stride, (y, x), steps, F::pack(color));
        true
    }

    #[inline(always)]
    fn fill_octants(memory: &mut [u8], grid: Grid, (x, y): Place, octants: Octants, color: F::Color) -> bool {
        walk::draw_octants::<F>(memory, grid.stride, (y, x), octants, F::pack(color));
        true
    }

    #[inline(always)]
    fn write_span(
        memory: &mut [u8],
        grid: Grid,
        y: usize,
        columns: (usize, usize),
        mut next: impl FnMut() -> F::Color,
    ) {
        rows::write_all::<F>(memory, start(grid, y), columns, || F::pack(next()));
    }

    /// One pixel in a turn.
    #[inline(always)]
    fn write_few(memory: &mut [u8], grid: Grid, y: usize, columns: (usize, usize), mut next: impl FnMut() -> F::Color) {
        if F::BITS < 8 {
            return Self::write_span(memory, grid, y, columns, next);
        }
        rows::write::<F>(memory, start(grid, y), columns, || Some(F::pack(next())));
    }

    #[inline(always)]
    fn write_parts<R: Copy>(
        memory: &mut [u8],
        grid: Grid,
        y: usize,
        columns: (usize, usize),
        (most, run): (usize, R),
        go_on: impl FnMut(&mut R, usize),
        mut next: impl FnMut(&mut R) -> F::Color,
    ) {
        if F::BITS < 8 {
            each_part(columns, most, run, go_on, |part, run| Self::write_span(memory, grid, y, part, || next(run)));
        } else {
            rows::write_parts::<F, R>(memory, (start(grid, y), columns), most, run, go_on, |run| F::pack(next(run)));
        }
    }

    #[inline(always)]
    fn write_rows<R>(
        memory: &mut [u8],
        grid: Grid,
        (x, y): Place,
        spans: &[[u8; 2]],
        mut run: impl FnMut(u8) -> R,
        mut next: impl FnMut(&mut R) -> F::Color,
    ) {
        let place = (start(grid, y), x);
        if rows::write_rows::<F, R>(memory, grid.stride, place, spans, &mut run, |run| F::pack(next(run))) {
            return;
        }
        let mut y = y;
        for &[right, pixels] in spans {
            let (mut run, x0) = (run(right), x.wrapping_add(right.into()));
            if pixels != 0 {
                Self::write_few(memory, grid, y, (x0, x0.wrapping_add(pixels.into())), || next(&mut run));
            }
            y = y.wrapping_add(1);
        }
    }

    #[inline(always)]
    fn write_some(
        memory: &mut [u8],
        grid: Grid,
        y: usize,
        columns: (usize, usize),
        mut next: impl FnMut() -> Option<F::Color>,
    ) {
        rows::write::<F>(memory, start(grid, y), columns, || next().map(F::pack));
    }

    #[inline(always)]
    fn edit_span(
        memory: &mut [u8],
        grid: Grid,
        y: usize,
        columns: (usize, usize),
        mut edit: impl FnMut(F::Color) -> F::Color,
    ) {
        rows::edit::<F>(memory, start(grid, y), columns, |bits| F::pack(edit(F::unpack(bits))));
    }

    #[inline(always)]
    fn mix_span(
        memory: &mut [u8],
        grid: Grid,
        y: usize,
        columns: (usize, usize),
        levels: &[u8],
        mut mix: impl FnMut(F::Color, u8) -> F::Color,
    ) {
        rows::mix::<F>(memory, start(grid, y), columns, levels, |bits, level| F::pack(mix(F::unpack(bits), level)));
    }

    #[inline(always)]
    fn mix_row(
        memory: &mut [u8],
        grid: Grid,
        y: usize,
        columns: (usize, usize),
        levels: (&[u8], &[u8]),
        color: F::Color,
        mut mix: impl FnMut(F::Color, u8) -> F::Color,
    ) {
        let mix = |bits, level| F::pack(mix(F::unpack(bits), level));
        rows::mix_ends::<F>(memory, start(grid, y), columns, levels, F::pack(color), mix);
    }

    #[inline(always)]
    fn find(memory: &[u8], grid: Grid, y: usize, columns: (usize, usize), wanted: impl Fn(F::Color) -> bool) -> usize {
        scan::find::<F>(memory, start(grid, y), columns, wanted)
    }

    #[inline(always)]
    fn find_start(
        memory: &[u8],
        grid: Grid,
        y: usize,
        columns: (usize, usize),
        wanted: impl Fn(F::Color) -> bool,
    ) -> usize {
        scan::start::<F>(memory, start(grid, y), columns, wanted)
    }

    #[inline(always)]
    fn fill_corridor(
        memory: &mut [u8],
        grid: Grid,
        (x, y): Place,
        (y0, y1): (usize, usize),
        down: bool,
        color: F::Color,
        is_open: impl Fn(F::Color) -> bool,
    ) -> Option<i32> {
        if !CORRIDORS || F::BITS < 8 {
            return None;
        }
        let place = |y: usize, x: usize| start(grid, y).wrapping_add(x.wrapping_mul((F::BITS / 8) as usize));
        // From the left neighbour in the first row to the right neighbour in the last. Where this memory ends, the corridor does.
        let (left, right) = (x.wrapping_sub(1), x.wrapping_add(2));
        let (first, at, end) = (place(y0, left), place(y, left), place(y1.wrapping_sub(1), right));
        let rows = memory.get_mut(first..end)?;
        let by = if down { grid.stride } else { grid.stride.wrapping_neg() };
        Some(scan::corridor::<F>(rows, at.wrapping_sub(first), by, F::pack(color), is_open))
    }

    #[inline(always)]
    fn copy(
        (to, to_grid, (to_x, to_y)): (&mut [u8], Grid, Place),
        (from, from_grid, (from_x, from_y)): (&[u8], Grid, Place),
        (width, height): (usize, usize),
        key: Option<F::Color>,
    ) {
        let (to_row, from_row) = (start(to_grid, to_y), start(from_grid, from_y));
        let Some(key) = key.map(F::pack) else {
            let (to, from) = ((to, to_grid.stride), (from, from_grid.stride));
            return rows::copy_rows::<F>(to, (to_row, to_x), from, (from_row, from_x), (width, height));
        };
        copy_keyed::<F>(
            (to, to_grid.stride, (to_x, to_row)),
            (from, from_grid.stride, (from_x, from_row)),
            (width, height),
            key,
        );
    }

    /// Copies chunks of pixels by way of the stack, in an order in which each pixel is read before it is painted over.
    #[inline(always)]
    fn move_area(
        memory: &mut [u8],
        grid: Grid,
        (to_x, to_y): Place,
        (from_x, from_y): Place,
        (width, height): (usize, usize),
        key: Option<F::Color>,
    ) {
        /// Divisible by the bytes of every format.
        const CHUNK: usize = 48;
        let pixels = CHUNK * 8 / F::BITS as usize;
        let key = key.map(F::pack);
        let (upwards, to_left) = (to_y <= from_y, to_x <= from_x);
        let chunks = width.div_ceil(pixels);
        for i in 0..height {
            let down = if upwards { i } else { height.wrapping_sub(1).wrapping_sub(i) };
            let (to_row, from_row) = (start(grid, to_y.wrapping_add(down)), start(grid, from_y.wrapping_add(down)));
            for c in 0..chunks {
                let c = if to_left { c } else { chunks.wrapping_sub(1).wrapping_sub(c) };
                let right = c.wrapping_mul(pixels);
                let n = pixels.min(width.wrapping_sub(right));
                let mut chunk = [0; CHUNK];
                rows::copy::<F>(&mut chunk, (0, 0), memory, (from_row, from_x.wrapping_add(right)), n);
                let to = (to_row, to_x.wrapping_add(right));
                match key {
                    Some(key) => rows::copy_keyed::<F>(memory, to, &chunk, (0, 0), n, key),
                    None => rows::copy::<F>(memory, to, &chunk, (0, 0), n),
                }
            }
        }
    }

    #[inline(always)]
    fn fill_mask(
        memory: &mut [u8],
        grid: Grid,
        y: usize,
        columns: (usize, usize),
        bits: impl FnMut() -> u32,
        (on, off): (F::Color, Option<F::Color>),
    ) {
        mask::draw::<F>(memory, start(grid, y), columns, bits, (F::pack(on), off.map(F::pack)));
    }

    #[cfg_attr(embedded_raster_compact, inline)]
    #[cfg_attr(not(embedded_raster_compact), inline(always))]
    fn fill_strip(
        memory: &mut [u8],
        grid: Grid,
        (x, y): Place,
        rows: (&[u8], (u32, u32)),
        (on, off): (F::Color, Option<F::Color>),
        pairs: Option<&Pairs>,
    ) {
        let (place, colors) = ((start(grid, y), grid.stride), (F::pack(on), off.map(F::pack)));
        strip::draw::<F>(memory, place, x, rows, colors, pairs);
    }

    #[inline(always)]
    fn pairs(on: F::Color, off: F::Color) -> Pairs {
        strip::pairs::<F>(F::pack(on), F::pack(off))
    }
}

/// Bytes as a display wants to be sent them.
impl<M: AsRef<[u8]>, F: PixelFormat> Frame<M, Rows<F>> {
    /// The pixels of one bit from a pixel of the window on, eight at a time.
    #[inline(always)]
    pub(super) fn bits(&self, x: i32, y: i32) -> Bits<'_> {
        let (memory, grid) = self.read();
        Bits::new::<F>(memory, start(grid, self.y(y)), self.x(x))
    }

    /// The bytes of the pixels in `area`, a slice for each row. Where pixels share bytes, a slice begins and ends with whole bytes,
    /// which may hold pixels beside the area. Rows and columns outside of the window are left out.
    pub fn bytes(&self, area: Rect) -> impl Iterator<Item = &[u8]> {
        let (memory, grid) = self.read();
        let area = self.window().intersection(area);
        let rows = if area.is_empty() { 0..0 } else { area.y0..area.y1 };
        let bit = |x: i32| self.x(x).wrapping_mul(F::BITS as usize);
        let (first, end) = if area.is_empty() { (0, 0) } else { (bit(area.x0) / 8, bit(area.x1).div_ceil(8)) };
        rows.map(move |y| {
            let row = start(grid, self.y(y));
            memory.get(row.wrapping_add(first)..row.wrapping_add(end)).unwrap_or_default()
        })
    }

    /// The bytes of whole rows as they lie in memory, gaps of the stride included, in one piece: for DMA. Empty if a row
    /// lies outside.
    pub fn row_bytes(&self, rows: Range<u16>) -> &[u8] {
        self.run_of_bytes(rows, 1)
    }
}
