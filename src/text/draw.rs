//! Drawing text: lines to cells, cells to strips of glyphs.
//!
//! Each thing is clipped where it is known: rows once a line, as all cells of a line have the same; columns once a glyph. What is
//! left of a glyph goes to the surface in strips of up to eight columns, which lie in its window: see
//! [`strip`](crate::pixel::rows::strip).
//!
//! A line may begin far outside of what `i32` holds, and reach into it. Where its base falls is a wide number; from there on columns
//! have 32 bits, and the sides of the window are as far from the base as they are, or out of reach.

use core::ops::Range;

use embedded_graphics_core::geometry::Point;

use super::{font::Glyph, line::Lines, style::Style};
use crate::{
    num::cast::{index, low_u32, low_u8, narrow, saturate, unsigned},
    span::Rect,
    surface::{Ready, Strip, Surface},
    tune::COMPACT,
};

/// No box begins further on the left of its cell than this.
const OVERHANG: i32 = 128;

/// Further from its base than any glyph.
const OUT_OF_REACH: i64 = 1 << 30;

impl<C: Copy> Style<'_, C> {
    /// Draws a text at a point: see [`text`](crate::text) for which pixels.
    ///
    /// Cannot fail. What lies outside of the window is clipped.
    #[doc(alias("drawString", "draw_string", "print", "drawStr", "Text", "draw_text"))]
    pub fn draw<S: Surface<Color = C> + ?Sized>(&self, on: &mut S, at: impl Into<Point>, text: &str) {
        let at = at.into();
        // Where no cell may hide what leans into it, all of the ground of a line comes first.
        let ground = || self.ground.filter(|_| !self.font.overhangs());
        match ground() {
            // Two loops, each with what it needs in registers; built for size, one.
            Some(color) if !COMPACT => {
                let pairs = on.pairs(self.color, color);
                self.draw_lines(on, at, text, || (Some(color), Ready::of(&pairs)));
            }
            None if !COMPACT => self.draw_lines(on, at, text, || (None, Ready::nothing())),
            _ => self.draw_lines(on, at, text, || (ground(), Ready::nothing())),
        }
    }

    /// All lines. `ground` is asked for that of cells in each of them, so that it need not be kept.
    #[inline(always)]
    fn draw_lines<'r, S: Surface<Color = C> + ?Sized>(
        &self,
        on: &mut S,
        at: Point,
        text: &str,
        ground: impl Fn() -> (Option<C>, Ready<'r>),
    ) {
        let window = on.window();
        let mut top = self.first_row(at.y, text);
        for line in Lines(Some(text)) {
            #[cfg(test)]
            crate::num::tally::add(crate::num::tally::Work::Step);
            if top >= i64::from(window.y1) {
                return;
            }
            if let Some(rows) = Rows::of(top, self.font.height(), window) {
                let columns = if self.is_counted() { self.columns(line) } else { 0 };
                self.draw_line(on, self.start(at.x, columns), line, rows, ground());
            }
            top = top.wrapping_add(self.line_distance().into());
        }
    }

    /// A line of which some rows are visible.
    #[inline(always)]
    fn draw_line<S: Surface<Color = C> + ?Sized>(
        &self,
        on: &mut S,
        start: i64,
        line: &str,
        rows: Rows,
        ground: (Option<C>, Ready<'_>),
    ) {
        if let (Some(color), true) = (self.ground, self.font.overhangs()) {
            let end = start.saturating_add_unsigned(self.columns(line));
            rows.fill(on, start..end, rows.top..rows.bottom, color);
        }
        self.draw_cells(on, start, line, rows, ground);
    }

    /// The cells of a line: glyphs, and the ground of those that do not fill theirs.
    #[inline(always)]
    fn draw_cells<S: Surface<Color = C> + ?Sized>(
        &self,
        on: &mut S,
        start: i64,
        line: &str,
        rows: Rows,
        (ground, ready): (Option<C>, Ready<'_>),
    ) {
        let mut pen = self.pen();
        let mut row = Row::of(rows, start.saturating_add(pen.base()));
        for character in line.chars() {
            let cell = pen.column();
            if cell >= row.end.wrapping_add(OVERHANG) {
                return;
            }
            match (pen.next(self.font, character), ground) {
                (Some(glyph), ground) => {
                    if let Some(color) = ground.filter(|_| !glyph.fills_cell) {
                        row.surround(on, cell, glyph, color);
                    }
                    row.draw(on, cell, glyph, self.color, (ground, ready));
                }
                (None, Some(color)) => row.fill(on, cell..pen.column(), rows.top..rows.bottom, color),
                (None, None) => {}
            }
            if pen.moves_base() {
                row = Row::of(rows, start.saturating_add(pen.base()));
            }
        }
    }
}

/// The visible rows of a line of cells. By value everywhere: what a call is lent lies in memory, and is loaded for each letter.
#[derive(Copy, Clone)]
struct Rows {
    window: Rect,
    /// The row of the first row of cells. It may lie above all numbers; as an `i32` it is right modulo 2^32.
    first: i32,
    /// Rows of cells that are visible. In eight bits, so that a strip is known to have no more than 255 rows.
    top: u8,
    bottom: u8,
}

impl Rows {
    /// Cells of so many rows, the first of them in row `first`. `None` if none is visible.
    #[inline]
    fn of(first: i64, rows: u8, window: Rect) -> Option<Self> {
        let row = |y: i32| low_u8(low_u32(i64::from(y).saturating_sub(first).clamp(0, rows.into()).unsigned_abs()));
        let (top, bottom) = (row(window.y0), row(window.y1));
        let is_visible = top < bottom && window.x0 < window.x1;
        is_visible.then(|| Self { window, first: narrow(first), top, bottom })
    }

    /// The part of some rows of a cell that is visible.
    #[inline(always)]
    fn seen(self, rows: Range<u8>) -> Range<u8> {
        rows.start.max(self.top)..rows.end.min(self.bottom)
    }

    /// Paints columns, wherever they are, in rows of cells.
    fn fill<S: Surface + ?Sized>(self, on: &mut S, columns: Range<i64>, rows: Range<u8>, color: S::Color) {
        let Range { start, end } = self.seen(rows);
        let row = |row: u8| self.first.wrapping_add(row.into());
        if start < end {
            on.fill_area(Rect::new(saturate(columns.start), row(start), saturate(columns.end), row(end)), color);
        }
    }
}

/// A row of cells near the base of a pen: columns are counted from there.
#[derive(Copy, Clone)]
struct Row {
    rows: Rows,
    base: i64,
    /// The first column of the window, and the one after its last.
    start: i32,
    end: i32,
}

impl Row {
    /// With the base in a column of the surface.
    #[inline]
    fn of(rows: Rows, base: i64) -> Self {
        let distance = |x: i32| narrow(i64::from(x).saturating_sub(base).clamp(-OUT_OF_REACH, OUT_OF_REACH));
        Self { rows, base, start: distance(rows.window.x0), end: distance(rows.window.x1) }
    }

    /// Paints columns in rows of cells.
    fn fill<S: Surface + ?Sized>(self, on: &mut S, columns: Range<i32>, rows: Range<u8>, color: S::Color) {
        let column = |x: i32| self.base.saturating_add(x.into());
        self.rows.fill(on, column(columns.start)..column(columns.end), rows, color);
    }

    /// Paints what lies in a cell around the box of its glyph.
    #[inline(never)]
    fn surround<S: Surface + ?Sized>(self, on: &mut S, cell: i32, glyph: Glyph<'_>, color: S::Color) {
        let end = cell.wrapping_add(glyph.advance.into());
        let left = cell.wrapping_add(glyph.left.into());
        let right = left.wrapping_add(glyph.width.into());
        // The box lies in the rows of the cell.
        let (above, below) = (glyph.top, glyph.top.saturating_add(glyph.height));
        let parts = [
            (cell..end, 0..above),
            (cell..left, above..below),
            (right..end, above..below),
            (cell..end, below..self.rows.bottom),
        ];
        for (columns, rows) in parts {
            self.fill(on, columns, rows, color);
        }
    }

    /// Paints the box of a glyph whose cell begins in a column.
    #[cfg_attr(embedded_raster_compact, inline)]
    #[cfg_attr(not(embedded_raster_compact), inline(always))]
    fn draw<S: Surface + ?Sized>(
        self,
        on: &mut S,
        cell: i32,
        glyph: Glyph<'_>,
        color: S::Color,
        (ground, ready): (Option<S::Color>, Ready<'_>),
    ) {
        let x = cell.wrapping_add(glyph.left.into());
        // Columns of the box that are visible, and its rows.
        let mut first = self.start.wrapping_sub(x).max(0);
        let end = self.end.wrapping_sub(x).min(glyph.width.into());
        let rows = self.rows.seen(glyph.top..glyph.top.saturating_add(glyph.height));
        if first >= end || rows.start >= rows.end {
            return;
        }
        let (x, y) = (narrow(self.base).wrapping_add(x), self.rows.first.wrapping_add(rows.start.into()));
        let (skip, len) = (rows.start.saturating_sub(glyph.top), rows.end.saturating_sub(rows.start));
        let (skip, len) = (usize::from(skip), usize::from(len));
        loop {
            // One strip: eight columns, of which those from `first` on are visible, and those up to `end`.
            let strip = first & !7;
            let bits = index(strip >> 3).wrapping_mul(glyph.height.into()).wrapping_add(skip);
            let Some(bytes) = glyph.strips.get(bits..bits.wrapping_add(len)) else { return };
            let columns = (unsigned(first & 7), unsigned(end.wrapping_sub(strip).min(8)));
            on.fill_strip(Strip::inside(x.wrapping_add(strip), y, columns, bytes), color, ground, ready);
            first = strip.wrapping_add(8);
            if first >= end {
                return;
            }
        }
    }
}
