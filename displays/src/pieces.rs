//! Pixels of an area as bytes, piece by piece: as they lie in memory ([`Lying`]), or converted on their way ([`Lines`]).
//!
//! Where pixels share bytes, whole bytes are sent, so an area grows to the next columns that begin a byte. It never shrinks, and what is
//! sent beside it are pixels of the same frame.

use core::{marker::PhantomData, ops::Range};

use embedded_raster::{
    surface::{Frame, Grid, Layout, Place, Rows},
    Palette, PixelFormat, Rect,
};

use crate::error::Error;

/// Pixels of one area after the other.
pub(crate) trait Pieces {
    /// What is sent for an area: inside of the frame, and in whole bytes.
    fn cover(&self, area: Rect) -> Rect;

    /// How many rows of an area may be sent as one window.
    fn rows_together(&self, area: Rect) -> i32 {
        let _ = area;
        i32::MAX
    }

    /// Begins with an area.
    fn start(&mut self, area: Rect);

    /// Whether all of the area has been handed out.
    fn is_done(&self) -> bool;

    /// The next bytes.
    fn next(&mut self) -> &[u8];
}

/// No pixels: windows that somebody else fills.
pub(crate) struct Nothing;

impl Pieces for Nothing {
    fn cover(&self, area: Rect) -> Rect {
        area
    }

    fn start(&mut self, _: Rect) {}

    fn is_done(&self) -> bool {
        true
    }

    fn next(&mut self) -> &[u8] {
        &[]
    }
}

/// How many pixels of so many bits fill whole bytes: the fewest.
pub(crate) const fn unit(bits: usize) -> usize {
    match bits {
        1 => 8,
        2 => 4,
        4 | 12 => 2,
        _ => 1,
    }
}

/// A coordinate that is not negative, as an index.
pub(crate) fn index(n: i32) -> usize {
    usize::try_from(n).unwrap_or_default()
}

/// A number of pixels as a distance between coordinates.
pub(crate) fn distance(n: usize) -> i32 {
    i32::try_from(n).unwrap_or(i32::MAX)
}

/// The last row of pixels that leave a byte half full must be the only one of its window: the display would read on in that byte.
fn rows_of_whole_bytes(bits: usize, area: Rect) -> i32 {
    if bits > 8 && !area.width().is_multiple_of(2) && !bits.is_multiple_of(8) {
        1
    } else {
        i32::MAX
    }
}

/// Pixels that are sent as they lie in memory, in as few pieces as possible.
pub(crate) struct Lying<'a> {
    memory: &'a [u8],
    stride: usize,
    bits: usize,
    window: Rect,
    /// Where the first pixel of the window lies.
    first: Place,
    /// What has not been handed out.
    area: Rect,
}

impl<'a> Lying<'a> {
    /// Pixels of `bits` bits, in rows.
    ///
    /// # Errors
    /// [`Error::Misaligned`] if the first pixel of the frame lies inside of a byte.
    pub(crate) fn new<M: AsRef<[u8]>, L: Layout>(frame: &'a Frame<M, L>, bits: usize) -> Result<Self, Error> {
        let lying = Self::whole_bytes(frame, bits);
        Error::check_aligned(lying.first.0, unit(bits))?;
        Ok(lying)
    }

    /// The same for pixels of whole bytes, which are aligned wherever they lie.
    pub(crate) fn whole_bytes<M: AsRef<[u8]>, L: Layout>(frame: &'a Frame<M, L>, bits: usize) -> Self {
        let window = frame.window();
        let first = frame.place_of(window.top_left()).unwrap_or_default();
        Self { memory: frame.memory(), stride: frame.stride(), bits, window, first, area: Rect::default() }
    }

    /// The same place in other memory: a plane of it.
    pub(crate) fn in_memory(self, memory: &'a [u8]) -> Self {
        Self { memory, ..self }
    }

    /// The same pixels, of which `area` is to be handed out.
    pub(crate) fn of(mut self, area: Rect) -> Self {
        self.start(area);
        self
    }

    /// Column in memory.
    fn column(&self, x: i32) -> usize {
        self.first.0.wrapping_add(index(x.wrapping_sub(self.window.x0)))
    }

    /// Bytes of a row from the first one of a column to the last one before another.
    fn bytes(&self, y: i32, x: Range<i32>) -> Range<usize> {
        let row = self.first.1.wrapping_add(index(y.wrapping_sub(self.window.y0))).wrapping_mul(self.stride);
        let bit = |x: i32| self.column(x).wrapping_mul(self.bits);
        row.wrapping_add(bit(x.start) / 8)..row.wrapping_add(bit(x.end).div_ceil(8))
    }
}

impl Pieces for Lying<'_> {
    fn cover(&self, area: Rect) -> Rect {
        let area = self.window.intersection(area);
        if area.is_empty() {
            return area;
        }
        let unit = unit(self.bits);
        let before = self.column(area.x0) % unit;
        let after = unit.wrapping_sub(self.column(area.x1) % unit) % unit;
        let x0 = area.x0.saturating_sub(distance(before));
        let x1 = area.x1.saturating_add(distance(after)).min(self.window.x1);
        Rect { x0, x1, ..area }
    }

    fn rows_together(&self, area: Rect) -> i32 {
        rows_of_whole_bytes(self.bits, area)
    }

    fn start(&mut self, area: Rect) {
        self.area = area;
    }

    fn is_done(&self) -> bool {
        self.area.is_empty()
    }

    fn next(&mut self) -> &[u8] {
        let Rect { x0, y0, x1, y1 } = self.area;
        let mut bytes = self.bytes(y0, x0..x1);
        let mut end = y0.saturating_add(1);
        if bytes.len() == self.stride {
            // Without gaps: all rows at once.
            bytes.end = self.bytes(y1.saturating_sub(1), x0..x1).end;
            end = y1;
        }
        self.area.y0 = end;
        self.memory.get(bytes).unwrap_or_default()
    }
}

/// Pixels that are converted on their way, by so many at a time as `line` holds: some rows if it holds one, else a part of one.
pub(crate) struct Lines<'a, L, F> {
    line: &'a mut [u8],
    /// Pixels that fit into the line.
    fits: usize,
    window: Rect,
    /// What has not been begun, and the next column of its first row.
    area: Rect,
    x: i32,
    /// Writes the pixels of some columns of a row.
    fill: F,
    layout: PhantomData<L>,
}

/// Bits of a pixel on the wire: eight pixels have as many bytes.
fn bits<L: Layout>() -> usize {
    L::row_bytes(8)
}

impl<'a, L: Layout, F: FnMut(i32, Range<i32>, &mut [u8])> Lines<'a, L, F> {
    /// # Errors
    /// [`Error::LineTooShort`] if not one pixel fits, or not as many as fill whole bytes.
    pub(crate) fn new(window: Rect, line: &'a mut [u8], fill: F) -> Result<Self, Error> {
        let (bits, given) = (bits::<L>(), line.len());
        let unit = unit(bits);
        let needed = unit.saturating_mul(bits).div_ceil(8);
        // Eight pixels at a time begin with a whole byte of indices again, if the first of them did.
        let fits = given.saturating_mul(8) / bits.max(1);
        let fits = if fits < 8 { fits / unit * unit } else { fits / 8 * 8 };
        if fits == 0 {
            return Err(Error::LineTooShort { needed, given });
        }
        Ok(Self { line, fits, window, area: Rect::default(), x: 0, fill, layout: PhantomData })
    }

    /// The same pixels, of which `area` is to be handed out.
    pub(crate) fn of(mut self, area: Rect) -> Self {
        self.start(area);
        self
    }

    /// Bytes of so many pixels.
    fn size(pixels: usize) -> usize {
        L::row_bytes(u16::try_from(pixels).unwrap_or(u16::MAX))
    }
}

impl<L: Layout, F: FnMut(i32, Range<i32>, &mut [u8])> Pieces for Lines<'_, L, F> {
    fn cover(&self, area: Rect) -> Rect {
        self.window.intersection(area)
    }

    fn rows_together(&self, area: Rect) -> i32 {
        rows_of_whole_bytes(bits::<L>(), area)
    }

    fn start(&mut self, area: Rect) {
        (self.area, self.x) = (area, area.x0);
    }

    fn is_done(&self) -> bool {
        self.area.is_empty()
    }

    fn next(&mut self) -> &[u8] {
        let Rect { x0, x1, y0, y1 } = self.area;
        let row = Self::size(index(x1.wrapping_sub(x0)));
        let mut used = 0_usize;
        if self.x == x0 && row <= self.line.len() {
            for (out, y) in self.line.chunks_exact_mut(row.max(1)).zip(y0..y1) {
                (self.fill)(y, x0..x1, out);
                used = used.wrapping_add(row);
                self.area.y0 = y.saturating_add(1);
            }
        } else {
            let end = self.x.saturating_add(distance(self.fits)).min(x1);
            used = Self::size(index(end.wrapping_sub(self.x)));
            if let Some(out) = self.line.get_mut(..used) {
                (self.fill)(y0, self.x..end, out);
            }
            self.x = end;
            if end >= x1 {
                self.start(Rect { y0: y0.saturating_add(1), ..self.area });
            }
        }
        self.line.get(..used).unwrap_or_default()
    }
}

/// Copies pixels of whole bytes as they lie.
pub(crate) fn copied<M: AsRef<[u8]>, L: Layout>(
    frame: &Frame<M, L>,
    bytes: usize,
) -> impl FnMut(i32, Range<i32>, &mut [u8]) + use<'_, M, L> {
    move |y, x, out| {
        let Some((column, row)) = frame.place_of((x.start, y)) else { return };
        let start = row.wrapping_mul(frame.stride()).wrapping_add(column.wrapping_mul(bytes));
        let pixels = frame.memory().get(start..start.wrapping_add(out.len())).unwrap_or_default();
        out.iter_mut().zip(pixels).for_each(|(place, &byte)| *place = byte);
    }
}

/// Writes pixels through a palette.
pub(crate) fn through<'a, M: AsRef<[u8]>, I: PixelFormat, O: PixelFormat, const N: usize>(
    frame: &'a Frame<M, Rows<I>>,
    palette: &'a Palette<O::Color, N>,
) -> impl FnMut(i32, Range<i32>, &mut [u8]) + use<'a, M, I, O, N> {
    const { assert!(I::BITS <= 8 && O::BITS % 8 == 0, "indices of at most 8 bits to pixels of whole bytes") };
    let (in_byte, size) = ((8 / I::BITS) as usize, (O::BITS / 8) as usize);
    move |y, x, out| {
        let Some((column, row)) = frame.place_of((x.start, y)) else { return };
        let byte = row.wrapping_mul(frame.stride()).wrapping_add(column / in_byte);
        let mut bytes = frame.memory().get(byte..).unwrap_or_default();
        let mut out = out;
        let before = column % in_byte;
        if let (1.., Some((first, rest))) = (before, bytes.split_first()) {
            // The first pixels are the last ones of a byte.
            let mut pixels = [0; 8 * 4];
            palette.expand::<I, O>(&[*first], &mut pixels);
            let pixels = pixels.get(before.wrapping_mul(size)..in_byte.wrapping_mul(size)).unwrap_or_default();
            let (head, tail) = out.split_at_mut(pixels.len().min(out.len()));
            head.iter_mut().zip(pixels).for_each(|(place, byte)| *place = *byte);
            (bytes, out) = (rest, tail);
        }
        palette.expand::<I, O>(bytes, out);
    }
}

/// Writes pixels of the layout `L` that are made of those of a frame.
pub(crate) fn converted<M: AsRef<[u8]>, K: Layout, L: Layout, C: FnMut(K::Color) -> L::Color>(
    frame: &Frame<M, K>,
    mut convert: C,
) -> impl FnMut(i32, Range<i32>, &mut [u8]) + use<'_, M, K, L, C> {
    move |y, x, out| {
        let row = Rect::new(x.start, y, x.end, y.saturating_add(1));
        let grid = Grid { stride: out.len(), rows: 1 };
        let mut colors = frame.colors(row).map(&mut convert);
        L::write_some(out, grid, 0, (0, index(x.end.wrapping_sub(x.start))), || colors.next());
    }
}
