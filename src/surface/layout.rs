//! [`Layout`]: how pixels lie in memory.
//!
//! | layout | what it is | who wants it |
//! |---|---|---|
//! | [`Rows`](super::Rows) | rows of a [format](crate::pixel), one after the other | most |
//! | [`Pages`](super::Pages) | eight rows to a byte | SSD1306, SH1106 and other small OLEDs |
//! | [`Packed12`](super::Packed12) | two pixels of RGB444 to three bytes | ST7789, ST7735 at 12 bits |
//! | [`Planes`](super::Planes) | two planes of one bit | e-paper in black, white and red, or in four greys |
//!
//! A layout of your own needs its [`row_bytes`](Layout::row_bytes), [`get`](Layout::get) and [`set`](Layout::set); then
//! everything that this crate draws works on it. The other functions have defaults, which go pixel by pixel: override those
//! that your program spends its time in.

use embedded_graphics_core::pixelcolor::PixelColor;

use crate::{
    pixel::rows::{mask, strip::Pairs},
    span::{Octants, Steps},
};

/// How many rows there are in memory, and how far apart they are.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Grid {
    /// Bytes from one row to the next, or from one page to the next where [rows share bytes](Layout::PAGE).
    pub stride: usize,
    /// Rows in memory.
    pub rows: usize,
}

/// A column and a row in memory, counted from 0.
pub type Place = (usize, usize);

/// How pixels lie in memory: which bytes a pixel has, and how runs of pixels are written.
///
/// Columns and rows are counted in memory, and lie inside of it: a [`Frame`](super::Frame) clips coordinates first, and moves
/// them to where a band or a view lies. Ranges are half-open and not empty.
///
/// A layout has no state; it is a name for functions. What is not overridden goes pixel by pixel.
/// ```
/// use embedded_graphics_core::{geometry::Point, pixelcolor::Gray8};
/// use embedded_raster::{surface::Grid, Canvas, Frame, Layout, Rect};
/// /// Columns of bytes, from right to left.
/// struct Columns;
/// impl Layout for Columns {
///     type Color = Gray8;
///     fn row_bytes(width: u16) -> usize {
///         width.into()
///     }
///     fn get(memory: &[u8], grid: Grid, (x, y): (usize, usize)) -> Gray8 {
///         let last = memory.len() - 1;
///         Gray8::new(memory[last - (x * grid.rows + y)])
///     }
///     fn set(memory: &mut [u8], grid: Grid, (x, y): (usize, usize), color: Gray8) {
///         let last = memory.len() - 1;
///         memory[last - (x * grid.rows + y)] = embedded_graphics_core::prelude::GrayColor::luma(&color);
///     }
/// }
/// let mut ram = [b'.'; 3 * 2];
/// let mut frame = Frame::<_, Columns>::new(&mut ram[..], 3, 2)?;
/// frame.draw_line(Point::new(0, 0), Point::new(2, 1), Gray8::new(b'#'));
/// assert_eq!(&ram, b"#.#..#");
/// # Ok::<(), embedded_raster::Error>(())
/// ```
pub trait Layout: 'static {
    /// What a pixel holds.
    type Color: PixelColor;

    /// How many rows share their bytes. A band starts at a multiple of it.
    const PAGE: u16 = 1;

    /// Bytes of a row of `width` pixels, or of [`PAGE`](Self::PAGE) rows that share bytes.
    fn row_bytes(width: u16) -> usize;

    /// Bytes of a screen or a band, from its first to its last; stops at `usize::MAX`. By default the last row needs the bytes of
    /// its pixels only, not a whole stride.
    #[inline]
    fn bytes(width: u16, grid: Grid) -> usize {
        match grid.rows.div_ceil(usize::from(Self::PAGE)).checked_sub(1) {
            Some(before) => grid.stride.saturating_mul(before).saturating_add(Self::row_bytes(width)),
            None => 0,
        }
    }

    /// How many bytes lie before row y, if they are those of all rows above it and of no other; y is a multiple of
    /// [`PAGE`](Self::PAGE). `None`, by default, if rows do not lie like that: then memory cannot be cut between two rows.
    #[inline]
    fn bytes_above(grid: Grid, y: usize) -> Option<usize> {
        let _ = (grid, y);
        None
    }

    /// Reads a pixel.
    fn get(memory: &[u8], grid: Grid, at: Place) -> Self::Color;

    /// Whether [`get_whole`](Self::get_whole) may be asked for pixels.
    #[doc(hidden)]
    #[inline]
    fn is_whole(grid: Grid) -> bool {
        let _ = grid;
        true
    }

    /// [`get`](Self::get) where rows are whole pixels apart: where that is faster, it takes another way.
    #[doc(hidden)]
    #[inline(always)]
    fn get_whole(memory: &[u8], grid: Grid, at: Place) -> Self::Color {
        Self::get(memory, grid, at)
    }

    /// Writes a pixel.
    fn set(memory: &mut [u8], grid: Grid, at: Place, color: Self::Color);

    /// Writes one colour to the pixels `x0..x1` of row y.
    #[inline]
    fn fill_span(memory: &mut [u8], grid: Grid, y: usize, (x0, x1): (usize, usize), color: Self::Color) {
        for x in x0..x1 {
            Self::set(memory, grid, (x, y), color);
        }
    }

    /// Writes one colour to the pixels `x0..x1` of the rows `y0..y1`.
    #[inline]
    fn fill_area(memory: &mut [u8], grid: Grid, (y0, y1): (usize, usize), columns: (usize, usize), color: Self::Color) {
        for y in y0..y1 {
            Self::fill_span(memory, grid, y, columns, color);
        }
    }

    /// Writes one colour along a line whose first pixel lies at `start`. `false` if the layout has no faster way than spans; then
    /// nothing is written.
    #[inline]
    fn fill_steps(memory: &mut [u8], grid: Grid, start: Place, steps: Steps, color: Self::Color) -> bool {
        let _ = (memory, grid, start, steps, color);
        false
    }

    /// Writes one colour along a circle whose box starts at `start`. `false` if the layout has no faster way than spans; then
    /// nothing is written.
    #[inline]
    fn fill_octants(memory: &mut [u8], grid: Grid, start: Place, octants: Octants, color: Self::Color) -> bool {
        let _ = (memory, grid, start, octants, color);
        false
    }

    /// Writes the pixels `x0..x1` of row y from left to right, each in the colour that `next` gives.
    #[inline]
    fn write_span(
        memory: &mut [u8],
        grid: Grid,
        y: usize,
        columns: (usize, usize),
        mut next: impl FnMut() -> Self::Color,
    ) {
        Self::write_some(memory, grid, y, columns, || Some(next()));
    }

    /// [`write_span`](Self::write_span) of a few pixels: a way that has less to prepare, if there is one.
    #[inline(always)]
    fn write_few(memory: &mut [u8], grid: Grid, y: usize, columns: (usize, usize), next: impl FnMut() -> Self::Color) {
        Self::write_span(memory, grid, y, columns, next);
    }

    /// [`write_span`](Self::write_span) in parts of `most` pixels and a last one of as many or fewer: the first one is what `next` makes
    /// of `run`. When a part is done, `go_on` takes the run to the next one, and is told how many pixels are left.
    #[doc(hidden)]
    #[inline(always)]
    fn write_parts<R: Copy>(
        memory: &mut [u8],
        grid: Grid,
        y: usize,
        columns: (usize, usize),
        (most, run): (usize, R),
        go_on: impl FnMut(&mut R, usize),
        mut next: impl FnMut(&mut R) -> Self::Color,
    ) {
        each_part(columns, most, run, go_on, |part, run| Self::write_span(memory, grid, y, part, || next(run)));
    }

    /// Writes few pixels in each of some rows that follow each other, from row y on. Of each row, `spans` has how far they are to the right
    /// of column x, and how many they are, which may be none. `start` is given the former, and answers with what `next` makes colours of,
    /// from left to right.
    #[doc(hidden)]
    #[inline(always)]
    fn write_rows<R>(
        memory: &mut [u8],
        grid: Grid,
        (x, mut y): Place,
        spans: &[[u8; 2]],
        mut start: impl FnMut(u8) -> R,
        mut next: impl FnMut(&mut R) -> Self::Color,
    ) {
        for &[right, pixels] in spans {
            let (mut run, x0) = (start(right), x.wrapping_add(right.into()));
            if pixels != 0 {
                Self::write_few(memory, grid, y, (x0, x0.wrapping_add(pixels.into())), || next(&mut run));
            }
            y = y.wrapping_add(1);
        }
    }

    /// Writes the pixels `x0..x1` of row y from left to right. For each, `next` gives a colour, or `None` to leave it as it is.
    #[inline]
    fn write_some(
        memory: &mut [u8],
        grid: Grid,
        y: usize,
        (x0, x1): (usize, usize),
        mut next: impl FnMut() -> Option<Self::Color>,
    ) {
        for x in x0..x1 {
            if let Some(color) = next() {
                Self::set(memory, grid, (x, y), color);
            }
        }
    }

    /// Replaces the pixels `x0..x1` of row y from left to right: `edit` is given the old colour and returns the new one.
    #[inline]
    fn edit_span(
        memory: &mut [u8],
        grid: Grid,
        y: usize,
        (x0, x1): (usize, usize),
        mut edit: impl FnMut(Self::Color) -> Self::Color,
    ) {
        for x in x0..x1 {
            let color = edit(Self::get(memory, grid, (x, y)));
            Self::set(memory, grid, (x, y), color);
        }
    }

    /// Replaces the pixels `x0..x1` of row y from left to right: `mix` is given the old colour and a level, and returns the new colour.
    /// There are as many levels as pixels, or more.
    #[inline]
    fn mix_span(
        memory: &mut [u8],
        grid: Grid,
        y: usize,
        columns: (usize, usize),
        levels: &[u8],
        mut mix: impl FnMut(Self::Color, u8) -> Self::Color,
    ) {
        let mut levels = levels.iter();
        Self::edit_span(memory, grid, y, columns, |old| levels.next().map_or(old, |&level| mix(old, level)));
    }

    /// Writes one colour to the pixels `x0..x1` of row y, but for the first and the last ones of them, which have levels: they are mixed
    /// as by [`mix_span`](Self::mix_span). There are no fewer pixels than levels.
    #[inline]
    fn mix_row(
        memory: &mut [u8],
        grid: Grid,
        y: usize,
        (x0, x1): (usize, usize),
        (left, right): (&[u8], &[u8]),
        color: Self::Color,
        mut mix: impl FnMut(Self::Color, u8) -> Self::Color,
    ) {
        let (from, to) = (x0.wrapping_add(left.len()), x1.wrapping_sub(right.len()));
        if x0 < from {
            Self::mix_span(memory, grid, y, (x0, from), left, &mut mix);
        }
        if from < to {
            Self::fill_span(memory, grid, y, (from, to), color);
        }
        if to < x1 {
            Self::mix_span(memory, grid, y, (to, x1), right, &mut mix);
        }
    }

    /// The first of the pixels `x0..x1` of row y whose colour is wanted; `x1` if none is.
    #[inline]
    fn find(
        memory: &[u8],
        grid: Grid,
        y: usize,
        (x0, x1): (usize, usize),
        wanted: impl Fn(Self::Color) -> bool,
    ) -> usize {
        let mut x = x0;
        while x < x1 && !wanted(Self::get(memory, grid, (x, y))) {
            x = x.wrapping_add(1);
        }
        x
    }

    /// Looks back in row y, from `x1` as far as `x0`, for as long as colours are wanted. Returns the first column of that run;
    /// `x1` if the pixel before `x1` is not wanted.
    #[inline]
    fn find_start(
        memory: &[u8],
        grid: Grid,
        y: usize,
        (x0, x1): (usize, usize),
        wanted: impl Fn(Self::Color) -> bool,
    ) -> usize {
        let mut x = x1;
        while x > x0 && wanted(Self::get(memory, grid, (x.wrapping_sub(1), y))) {
            x = x.wrapping_sub(1);
        }
        x
    }

    /// Paints from `at` straight down, or up, in the rows `y0..y1`. It goes on while the pixel is open and its left and right
    /// neighbours, which lie in memory, are not. Returns how many pixels were painted, or `None` if the layout has no faster way
    /// than pixel by pixel. Flood fills of mazes use it.
    #[inline]
    fn fill_corridor(
        memory: &mut [u8],
        grid: Grid,
        at: Place,
        rows: (usize, usize),
        down: bool,
        color: Self::Color,
        is_open: impl Fn(Self::Color) -> bool,
    ) -> Option<i32> {
        let _ = (memory, grid, at, rows, down, color, is_open);
        None
    }

    /// Copies `width` x `height` pixels from one memory to another of the same layout, except those of the colour `key`.
    #[inline]
    fn copy(
        (to, to_grid, (to_x, to_y)): (&mut [u8], Grid, Place),
        (from, from_grid, (from_x, from_y)): (&[u8], Grid, Place),
        (width, height): (usize, usize),
        key: Option<Self::Color>,
    ) {
        for down in 0..height {
            for right in 0..width {
                let place = (from_x.wrapping_add(right), from_y.wrapping_add(down));
                let color = Self::get(from, from_grid, place);
                if key != Some(color) {
                    let place = (to_x.wrapping_add(right), to_y.wrapping_add(down));
                    Self::set(to, to_grid, place, color);
                }
            }
        }
    }

    /// Copies `width` x `height` pixels within a memory, except those of the colour `key`. Both areas may overlap.
    #[inline]
    fn move_area(
        memory: &mut [u8],
        grid: Grid,
        (to_x, to_y): Place,
        (from_x, from_y): Place,
        (width, height): (usize, usize),
        key: Option<Self::Color>,
    ) {
        // In an order in which each pixel is read before it is painted over.
        let place = |i: usize, n: usize, backwards: bool| if backwards { n.wrapping_sub(1).wrapping_sub(i) } else { i };
        for i in 0..height {
            let down = place(i, height, to_y > from_y);
            for i in 0..width {
                let right = place(i, width, to_x > from_x);
                let color = Self::get(memory, grid, (from_x.wrapping_add(right), from_y.wrapping_add(down)));
                if key != Some(color) {
                    Self::set(memory, grid, (to_x.wrapping_add(right), to_y.wrapping_add(down)), color);
                }
            }
        }
    }

    /// Writes a row of a picture of one bit per pixel to the pixels `x0..x1` of row y, from left to right. A set bit becomes
    /// `on`. Any other becomes `off`, or leaves the pixel as it is if `off` is `None`.
    ///
    /// `bits` gives eight pixels at a time, the leftmost in bit 31.
    #[inline]
    fn fill_mask(
        memory: &mut [u8],
        grid: Grid,
        y: usize,
        columns: (usize, usize),
        bits: impl FnMut() -> u32,
        (on, off): (Self::Color, Option<Self::Color>),
    ) {
        let mut is_set = mask::one_by_one(bits);
        Self::write_some(memory, grid, y, columns, || if is_set() { Some(on) } else { off });
    }
    /// Writes up to eight columns of a picture of one bit per pixel, the top left pixel at `at`. A set bit becomes `on`. Any other
    /// becomes `off`, or leaves the pixel as it is if `off` is `None`.
    ///
    /// `rows` has a byte for each row, from the top down, the leftmost pixel in its most significant bit. Of each, `skip` pixels are
    /// left out and `width`, at least one, are wanted. All glyphs are written by this function. `pairs` are those that
    /// [`pairs`](Self::pairs) made of both colours, or nothing.
    #[inline]
    fn fill_strip(
        memory: &mut [u8],
        grid: Grid,
        (x, mut y): Place,
        (rows, (skip, width)): (&[u8], (u32, u32)),
        colors: (Self::Color, Option<Self::Color>),
        _pairs: Option<&Pairs>,
    ) {
        for &byte in rows {
            let bits = u32::from(byte).wrapping_shl(skip.wrapping_add(24));
            Self::fill_mask(memory, grid, y, (x, x.wrapping_add(width as usize)), || bits, colors);
            y = y.wrapping_add(1);
        }
    }

    /// As [`Surface::pairs`](super::Surface::pairs).
    #[doc(hidden)]
    #[inline(always)]
    fn pairs(_on: Self::Color, _off: Self::Color) -> Pairs {
        Pairs::default()
    }
}

/// Calls `write` with the parts of some columns, which are not empty, from left to right: of `most` pixels, but for the last one. The first
/// one is made of `run`; when a part is done, `go_on` takes the run to the next one, and is told how many pixels are left.
#[inline(always)]
pub(super) fn each_part<R: Copy>(
    (mut x0, x1): (usize, usize),
    most: usize,
    mut run: R,
    mut go_on: impl FnMut(&mut R, usize),
    mut write: impl FnMut((usize, usize), &mut R),
) {
    loop {
        let end = x1.min(x0.saturating_add(most));
        // A copy, which has registers.
        let mut at = run;
        write((x0, end), &mut at);
        if end >= x1 {
            return;
        }
        (x0, run) = (end, at);
        go_on(&mut run, x1.wrapping_sub(x0));
    }
}
