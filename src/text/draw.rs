//! Drawing text: lines to cells, cells to strips of glyphs.
//!
//! Each thing is clipped where it is known: rows once a line, as all cells of a line have the same; columns once a glyph. What is
//! left of a glyph goes to the surface in strips of up to eight columns, which lie in its window: see
//! [`strip`](crate::pixel::rows::strip).

use core::ops::Range;

use embedded_graphics_core::geometry::Point;

use super::{font::Glyph, line::Lines, style::Style};
use crate::{
    num::cast::{index, narrow, saturate, unsigned},
    span::Rect,
    surface::{Strip, Surface},
};

/// No box begins further on the left of its cell than this.
const OVERHANG: i64 = 128;

impl<S: Copy> Style<'_, S> {
    /// Draws a text at a point: see [`text`](crate::text) for which pixels.
    ///
    /// Cannot fail. What lies outside of the window is clipped.
    #[doc(alias("drawString", "draw_string", "print", "drawStr", "Text", "draw_text"))]
    pub fn draw<T: Surface<Color = S> + ?Sized>(&self, on: &mut T, at: impl Into<Point>, text: &str) {
        let (at, window) = (at.into(), on.window());
        let mut top = self.first_row(at.y, text);
        for line in Lines(Some(text)) {
            if top >= i64::from(window.y1) {
                return;
            }
            if let Some(row) = Row::of(top, self.font.height(), window) {
                let columns = if self.is_counted() { self.columns(line) } else { 0 };
                self.draw_line(on, self.start(at.x, columns), line, &row);
            }
            top = top.wrapping_add(self.line_distance().into());
        }
    }

    /// A line of which some rows are visible.
    fn draw_line<T: Surface<Color = S> + ?Sized>(&self, on: &mut T, start: i64, line: &str, row: &Row) {
        let mut ground = self.ground;
        if self.font.overhangs() {
            // No cell may hide what leans into it: all of the ground comes first.
            if let Some(color) = ground.take() {
                let end = start.saturating_add_unsigned(self.columns(line));
                row.fill(on, start..end, row.top..row.bottom, color);
            }
        }
        let mut pen = self.pen(start);
        for character in line.chars() {
            let start = pen.column();
            if start >= row.window_end {
                return;
            }
            match (pen.next(self.font, character), ground) {
                (Some(glyph), ground) if glyph.fills_cell => row.draw(on, start, &glyph, self.color, ground),
                (Some(glyph), ground) => {
                    if let Some(color) = ground {
                        row.surround(on, start, &glyph, color);
                    }
                    row.draw(on, start, &glyph, self.color, ground);
                }
                (None, Some(color)) => row.fill(on, start..pen.column(), row.top..row.bottom, color),
                (None, None) => {}
            }
        }
    }
}

/// The visible part of a row of cells.
struct Row {
    window: Rect,
    /// The column from which on no cell is visible, nor the box of a glyph that begins there.
    window_end: i64,
    /// The row of the first row of cells. It may lie above all numbers, as an `i32` it is right modulo 2^32.
    first: i32,
    /// Rows of cells that are visible.
    top: i32,
    bottom: i32,
}

impl Row {
    /// Cells of so many rows, the first of them in row `first`. `None` if none is visible.
    #[inline]
    fn of(first: i64, rows: u8, window: Rect) -> Option<Self> {
        let top = i64::from(window.y0).saturating_sub(first).max(0);
        let bottom = i64::from(window.y1).saturating_sub(first).min(rows.into());
        let window_end = i64::from(window.x1).wrapping_add(OVERHANG);
        let is_visible = top < bottom && window.x0 < window.x1;
        is_visible.then(|| Self { window, window_end, first: narrow(first), top: narrow(top), bottom: narrow(bottom) })
    }

    /// The part of some rows of a cell that is visible.
    #[inline(always)]
    fn seen(&self, rows: Range<i32>) -> Range<i32> {
        rows.start.max(self.top)..rows.end.min(self.bottom)
    }

    /// Paints columns, wherever they are, in rows of cells.
    #[inline]
    fn fill<T: Surface + ?Sized>(&self, on: &mut T, columns: Range<i64>, rows: Range<i32>, color: T::Color) {
        let Range { start, end } = self.seen(rows);
        let row = |row: i32| self.first.wrapping_add(row);
        if start < end {
            on.fill_area(Rect::new(saturate(columns.start), row(start), saturate(columns.end), row(end)), color);
        }
    }

    /// Paints what lies in a cell around the box of its glyph.
    fn surround<T: Surface + ?Sized>(&self, on: &mut T, start: i64, glyph: &Glyph<'_>, color: T::Color) {
        let end = start.wrapping_add(glyph.advance.into());
        let left = start.wrapping_add(glyph.left.into());
        let right = left.wrapping_add(glyph.width.into());
        let above = i32::from(glyph.top);
        let below = above.wrapping_add(glyph.height.into());
        self.fill(on, start..end, 0..above, color);
        self.fill(on, start..left, above..below, color);
        self.fill(on, right..end, above..below, color);
        self.fill(on, start..end, below..self.bottom, color);
    }

    /// Paints the box of a glyph whose cell begins in a column.
    #[inline]
    fn draw<T: Surface + ?Sized>(
        &self,
        on: &mut T,
        start: i64,
        glyph: &Glyph<'_>,
        color: T::Color,
        ground: Option<T::Color>,
    ) {
        let x = start.wrapping_add(glyph.left.into());
        // Columns of the box that are visible: below 256, if there are any.
        let first = i64::from(self.window.x0).wrapping_sub(x).max(0);
        let end = narrow(i64::from(self.window.x1).wrapping_sub(x).min(glyph.width.into()));
        let above = i32::from(glyph.top);
        let rows = self.seen(above..above.wrapping_add(glyph.height.into()));
        if first >= i64::from(end) || rows.is_empty() {
            return;
        }
        let (mut first, y) = (narrow(first), self.first.wrapping_add(rows.start));
        let (skip, len) = (index(rows.start.wrapping_sub(above)), index(rows.end.wrapping_sub(rows.start)));
        while first < end {
            // One strip: eight columns, of which those from `first` on are visible, and those up to `end`.
            let strip = first & !7;
            let bits = index(strip >> 3).wrapping_mul(glyph.height.into()).wrapping_add(skip);
            let bytes = glyph.strips.get(bits..bits.wrapping_add(len)).unwrap_or_default();
            let columns = (unsigned(first & 7), unsigned(end.wrapping_sub(strip).min(8)));
            on.fill_strip(Strip::inside(narrow(x).wrapping_add(strip), y, columns, bytes), color, ground);
            first = strip.wrapping_add(8);
        }
    }
}
