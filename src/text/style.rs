//! [`Style`]: how text looks, and how much room it takes.

use embedded_graphics_core::geometry::{Point, Size};

use super::{
    font::Font,
    line::{Lines, Pen},
};
use crate::{num::cast::saturate, span::Rect};

/// Where the lines of a text lie beside the point that it is drawn at: each line by itself.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Horizontal {
    /// The first column of each line is that of the point.
    #[default]
    Left,
    /// The column of the point is the middle one of each line. An even number of columns has no middle one: one more lies on the
    /// right of the point than on its left.
    Center,
    /// The last column of each line is that of the point.
    Right,
}

/// Which row of a text is that of the point that it is drawn at.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Vertical {
    /// The baseline of the first line.
    #[default]
    Baseline,
    /// The first row of the first line.
    Top,
    /// The middle row of the block of all lines, from its first row to its last. Of an even number, one more lies below the point.
    Middle,
    /// The last row of the last line.
    Bottom,
}

/// How text looks: a font, the colour of letters and perhaps of the ground, and where lines lie beside the point that they are drawn
/// at.
///
/// [`draw`](Self::draw) draws text on any surface. [`bounds`](Self::bounds) says where it would lie.
/// ```
/// # #[cfg(feature = "font-6x10")] {
/// use embedded_graphics_core::{pixelcolor::{BinaryColor, Gray8}};
/// use embedded_raster::{text::{Horizontal, Style, Vertical, FONT_6X10}, Framebuffer, Rect};
/// let mut ram = [0; 96 * 32];
/// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 96, 32)?;
/// let style = Style::new(&FONT_6X10, Gray8::new(255))
///     .opaque(Gray8::new(40))
///     .horizontal(Horizontal::Center)
///     .vertical(Vertical::Middle);
/// style.draw(&mut frame, (48, 16), "two\nlines");
/// assert_eq!(style.bounds((48, 16), "two\nlines"), Rect::new(34, 7, 64, 27));
/// # }
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Style<'a, C> {
    pub(super) font: &'a Font<'a>,
    pub(super) color: C,
    pub(super) ground: Option<C>,
    horizontal: Horizontal,
    vertical: Vertical,
    line_height: u16,
    tab: u16,
}

impl<'a, C: Copy> Style<'a, C> {
    /// Transparent text in one colour: lines begin at the point and stand on its row. They are as far apart as the font is high,
    /// and a tab stop comes every eight spaces.
    pub fn new(font: &'a Font<'a>, color: C) -> Self {
        let tab = u16::from(font.glyph(' ').advance) << 3;
        Self {
            font,
            color,
            ground: None,
            horizontal: Horizontal::Left,
            vertical: Vertical::Baseline,
            line_height: font.height().into(),
            tab,
        }
    }

    /// The same in another colour.
    #[must_use]
    pub const fn color(self, color: C) -> Self {
        Self { color, ..self }
    }

    /// The cells of glyphs and the room of tabs are painted too, in the colour of the ground.
    #[must_use]
    pub const fn opaque(self, ground: C) -> Self {
        Self { ground: Some(ground), ..self }
    }

    /// Where each line lies beside the point.
    #[must_use]
    pub const fn horizontal(self, horizontal: Horizontal) -> Self {
        Self { horizontal, ..self }
    }

    /// Which row is that of the point.
    #[must_use]
    pub const fn vertical(self, vertical: Vertical) -> Self {
        Self { vertical, ..self }
    }

    /// Rows from a line to the next.
    #[must_use]
    pub const fn line_height(self, rows: u16) -> Self {
        Self { line_height: rows, ..self }
    }

    /// Columns from a tab stop to the next; the first one is where the line begins. With 0, tabs take no room.
    #[must_use]
    pub const fn tab(self, columns: u16) -> Self {
        Self { tab: columns, ..self }
    }

    /// Width and height of a text: the columns of the cells of its longest line, and the rows from the first row of its first line to the last
    /// of its last. A text without characters is a line without columns. Both stop at `u32::MAX`.
    pub fn size(&self, text: &str) -> Size {
        let width = Lines(Some(text)).map(|line| self.columns(line)).max().unwrap_or(0);
        let size = |n: u64| u32::try_from(n).unwrap_or(u32::MAX);
        Size::new(size(width), size(self.rows(text)))
    }

    /// The columns and rows that the cells of a text have if it is drawn at a point, from the first of all lines to the last. Opaque text
    /// reaches all four sides. Letters that lean over the sides of their cells reach beyond.
    ///
    /// What would lie beyond the ends of `i32` is cut off. A text without columns has an empty box.
    pub fn bounds(&self, at: impl Into<Point>, text: &str) -> Rect {
        let at = at.into();
        let top = self.first_row(at.y, text);
        let (mut first, mut end) = (i64::MAX, i64::MIN);
        for columns in Lines(Some(text)).map(|line| self.columns(line)).filter(|&columns| columns > 0) {
            let start = self.start(at.x, columns);
            (first, end) = (first.min(start), end.max(start.saturating_add_unsigned(columns)));
        }
        if first > end {
            (first, end) = (at.x.into(), at.x.into());
        }
        let bottom = top.saturating_add_unsigned(self.rows(text));
        Rect::new(saturate(first), saturate(top), saturate(end), saturate(bottom))
    }

    /// Columns of the cells of a line. One function, which drawing and measuring call.
    #[inline(never)]
    pub(super) fn columns(&self, line: &str) -> u64 {
        let mut pen = self.pen();
        for character in line.chars() {
            pen.next(self.font, character);
            pen.moves_base();
        }
        pen.total().unsigned_abs()
    }

    /// Rows from the first of the first line to the last of the last.
    fn rows(&self, text: &str) -> u64 {
        // Not `count`, which checks for an end that no text has.
        let newlines = text.bytes().fold(0_u64, |n, byte| n.wrapping_add((byte == b'\n').into()));
        newlines.saturating_mul(self.line_height.into()).saturating_add(self.font.height().into())
    }

    /// The first row of a text drawn at row `y`.
    pub(super) fn first_row(&self, y: i32, text: &str) -> i64 {
        let y = i64::from(y);
        match self.vertical {
            Vertical::Top => y,
            Vertical::Baseline => y.wrapping_add(1).wrapping_sub(self.font.baseline().into()),
            Vertical::Middle => y.saturating_sub_unsigned(self.rows(text).saturating_sub(1) / 2),
            Vertical::Bottom => y.wrapping_add(1).saturating_sub_unsigned(self.rows(text)),
        }
    }

    /// Whether the columns of a line have to be counted before it is drawn.
    #[inline]
    pub(super) fn is_counted(&self) -> bool {
        self.horizontal != Horizontal::Left
    }

    /// The first column of a line of so many columns, drawn at column `x`.
    #[inline]
    pub(super) fn start(&self, x: i32, columns: u64) -> i64 {
        let x = i64::from(x);
        match self.horizontal {
            Horizontal::Left => x,
            Horizontal::Center => x.saturating_sub_unsigned(columns.saturating_sub(1) / 2),
            Horizontal::Right => x.wrapping_add(1).saturating_sub_unsigned(columns),
        }
    }

    /// Rows from a line to the next.
    #[inline]
    pub(super) const fn line_distance(&self) -> u16 {
        self.line_height
    }

    /// At the start of a line.
    #[inline]
    pub(super) const fn pen(&self) -> Pen {
        Pen::new(self.tab)
    }
}
