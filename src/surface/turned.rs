//! [`Turned`]: a surface seen turned by quarters, or in a mirror.
//!
//! Eight ways there are: do both axes change places, and is either reversed? Each thing that is drawn is mapped to where it falls: a
//! rectangle to a rectangle, a run of a row to a run of a row or of a column. A glyph is mapped as a square of bits. All sums are right
//! modulo 2^32, and so they are right for what is in the window: everything is clipped before it is mapped.

use embedded_graphics_core::geometry::Point;

use super::{
    strip::{Ready, Strip},
    traits::{Inside, Readable, Said, Surface},
};
use crate::{
    pixel::rows::strip::Pairs,
    span::{ClippedSpan, Octants, Rect, Steps},
};

/// How far a drawing is turned, clockwise.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Turn {
    /// Not at all: for screens that are mirrored only, or that know when the program runs.
    #[default]
    None,
    /// By 90 degrees: what is at the top of a drawing is at the right of the screen.
    Quarter,
    /// By 180 degrees.
    Half,
    /// By 270 degrees: what is at the top of a drawing is at the left of the screen.
    ThreeQuarters,
}

/// A surface, turned by quarters or in a mirror: displays are built into devices any way round, and not every controller can turn what
/// it shows.
///
/// Turned by a quarter or by three, it is as wide as the surface is high. What is drawn on it, and read, is in its own coordinates.
///
/// **Which pixels.** A turned drawing is the drawing, turned: its pixels are found upright, by the rules of the shapes, and then moved,
/// each to its place. No tie is decided anew, as it would be if the corners of a shape were turned and the shape drawn after that.
/// ```text
///   on a screen of W x H pixels      the pixel (x, y) of a drawing falls on
///   a quarter                        (W - 1 - y, x)
///   a half                           (W - 1 - x, H - 1 - y)
///   three quarters                   (y, H - 1 - x)
///   mirrored, before any of them     x becomes (width of the drawing) - 1 - x
/// ```
/// **Cost.** Rectangles, circles and glyphs cost what they cost upright, and some tens of cycles each. Turned by a quarter, a run of a
/// row is a column, which takes a step of a stride for each pixel. Pictures, and paints with a colour for each pixel, go pixel by
/// pixel. Nothing of it is linked where nothing is turned.
/// ```
/// use embedded_graphics_core::pixelcolor::Gray8;
/// use embedded_raster::{surface::{Turn, Turned}, Canvas, Framebuffer, Rect, Surface};
/// let mut ram = [b'.'; 5 * 3];
/// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 5, 3)?;
/// let mut upright = Turned::new(&mut frame, Turn::Quarter);
/// assert_eq!(upright.window(), Rect::new(0, 0, 3, 5));
/// upright.draw_line((0, 0), (0, 3), Gray8::new(b'|')); // at its left, from the top down
/// upright.draw_line((1, 0), (2, 0), Gray8::new(b'-')); // at its top
/// assert_eq!(&ram, b".||||....-....-");
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Debug)]
pub struct Turned<'a, S: ?Sized> {
    surface: &'a mut S,
    area: Rect,
    /// Whether rows fall on columns.
    across: bool,
    /// Whether columns of the surface are counted from its right side, and rows from its bottom.
    from_right: bool,
    from_bottom: bool,
}

impl<'a, S: Surface + ?Sized> Turned<'a, S> {
    /// All of a surface that is in memory as a whole, turned.
    pub fn new(surface: &'a mut S, turn: Turn) -> Self {
        let area = surface.window();
        Self::of_area(surface, turn, area)
    }

    /// Only `area` of a surface, turned in itself: its corners fall on its corners. For a band of a screen, or a clipped part, this is
    /// the area of the whole screen; what is not in the window is clipped.
    ///
    /// Of more than `i32::MAX` columns or rows, those at one end are out of reach.
    pub fn of_area(surface: &'a mut S, turn: Turn, area: impl Into<Rect>) -> Self {
        let (across, from_right, from_bottom) = match turn {
            Turn::None => (false, false, false),
            Turn::Quarter => (true, true, false),
            Turn::Half => (false, true, true),
            Turn::ThreeQuarters => (true, false, true),
        };
        Self { surface, area: area.into(), across, from_right, from_bottom }
    }

    /// The same in a mirror: what is on the left of a drawing is on its right, before it is turned.
    #[must_use]
    pub fn mirrored(self) -> Self {
        // The columns of the drawing run along the rows of the surface, or along its columns.
        let (from_right, from_bottom) =
            if self.across { (self.from_right, !self.from_bottom) } else { (!self.from_right, self.from_bottom) };
        Self { from_right, from_bottom, ..self }
    }

    /// The pixels of the surface that some pixels in the window fall on.
    #[inline]
    fn map(&self, Rect { x0, y0, x1, y1 }: Rect) -> Rect {
        let (columns, rows) = if self.across { ((y0, y1), (x0, x1)) } else { ((x0, x1), (y0, y1)) };
        let (x0, x1) = along((self.area.x0, self.area.x1), columns, self.from_right);
        let (y0, y1) = along((self.area.y0, self.area.y1), rows, self.from_bottom);
        Rect { x0, y0, x1, y1 }
    }

    /// The same of one pixel.
    #[inline]
    fn map_pixel(&self, x: i32, y: i32) -> Point {
        self.map(Rect { x0: x, y0: y, x1: x.wrapping_add(1), y1: y.wrapping_add(1) }).top_left()
    }

    /// Paints pixels that lie in the window.
    #[inline]
    fn fill(&mut self, area: Rect, color: S::Color) {
        let area = self.map(area);
        self.surface.fill_area(area, color);
    }

    /// Paints pixels of a span one by one, from left to right.
    #[inline]
    fn each_pixel(&mut self, span: ClippedSpan, mut color_at: impl FnMut(i32) -> Option<S::Color>) {
        for x in span.x0()..span.x1() {
            if let Some(color) = color_at(x) {
                let at = self.map_pixel(x, span.y());
                self.surface.set(at, color);
            }
        }
    }
}

/// A range along one axis of an area, counted from its start or from its end. Right modulo 2^32, so it is right where it lies in `i32`.
#[inline]
const fn along((start, end): (i32, i32), (from, to): (i32, i32), from_end: bool) -> (i32, i32) {
    if from_end {
        (end.wrapping_sub(to), end.wrapping_sub(from))
    } else {
        (start.wrapping_add(from), start.wrapping_add(to))
    }
}

/// How far the ends of a range lie from the start of an axis, or from its end. What is further than `i32::MAX` is cut off.
#[inline]
const fn back((start, end): (i32, i32), (from, to): (i32, i32), from_end: bool) -> (i32, i32) {
    if from_end {
        (end.saturating_sub(to), end.saturating_sub(from))
    } else {
        (from.saturating_sub(start), to.saturating_sub(start))
    }
}

impl<S: Surface + ?Sized> Surface for Turned<'_, S> {
    type Color = S::Color;

    #[inline]
    fn window(&self) -> Rect {
        let Rect { x0, y0, x1, y1 } = self.area.intersection(self.surface.window());
        if x0 >= x1 || y0 >= y1 {
            return Rect::default();
        }
        let (columns, rows) = (
            back((self.area.x0, self.area.x1), (x0, x1), self.from_right),
            back((self.area.y0, self.area.y1), (y0, y1), self.from_bottom),
        );
        let ((x0, x1), (y0, y1)) = if self.across { (rows, columns) } else { (columns, rows) };
        Rect { x0, y0, x1, y1 }
    }

    #[inline]
    fn fill_span(&mut self, span: ClippedSpan, color: S::Color) {
        if let Some(span) = span.again(self.window()) {
            let y = span.y();
            self.fill(Rect { x0: span.x0(), y0: y, x1: span.x1(), y1: y.wrapping_add(1) }, color);
        }
    }

    #[inline]
    fn fill_area(&mut self, area: Rect, color: S::Color) {
        let area = area.intersection(self.window());
        if !area.is_empty() {
            self.fill(area, color);
        }
    }

    /// Lines along an axis are rectangles; others go run by run.
    fn fill_steps(&mut self, steps: Steps, color: S::Color) {
        let ((x0, y0), (x1, y1)) = (steps.first(), steps.last());
        if x0 == x1 || y0 == y1 {
            let (x0, x1) = (x0.min(x1), x0.max(x1).saturating_add(1));
            return self.fill_area(Rect { x0, y0, x1, y1: y1.saturating_add(1) }, color);
        }
        steps.spans(|span| self.fill_span(span, color));
    }

    /// A circle is the same from all sides.
    fn fill_octants(&mut self, octants: Octants, color: S::Color) -> bool {
        let ((x0, y0), extent) = (octants.first(), octants.extent());
        let end = |start: i32| start.wrapping_add(extent);
        let window = self.window();
        let inside = window.contains(x0, y0) && window.contains(end(x0), end(y0));
        let area = Rect { x0, y0, x1: end(x0).wrapping_add(1), y1: end(y0).wrapping_add(1) };
        let octants = Octants::new(self.map(area));
        inside && self.surface.fill_octants(octants, color)
    }

    #[inline]
    fn set(&mut self, p: Point, color: S::Color) {
        if self.window().contains(p.x, p.y) {
            let at = self.map_pixel(p.x, p.y);
            self.surface.set(at, color);
        }
    }

    fn write_some(&mut self, span: ClippedSpan, color_at: impl FnMut(i32) -> Option<S::Color>)
    where
        Self: Sized,
    {
        if let Some(span) = span.again(self.window()) {
            self.each_pixel(span, color_at);
        }
    }

    fn write_inside(&mut self, what: Inside, color_at: impl FnMut(i32) -> Option<S::Color>)
    where
        Self: Sized,
    {
        if let Said::Span(span) = what.0 {
            self.each_pixel(span, color_at);
        }
    }

    /// Eight rows of a glyph at a time are a square of bits, which is turned in two registers.
    fn fill_strip(&mut self, strip: Strip<'_>, on: S::Color, off: Option<S::Color>, ready: Ready<'_>) {
        let Rect { x0, mut y0, x1, .. } = strip.area();
        let (rows, (skip, width)) = strip.bytes();
        for rows in rows.chunks(8) {
            let mut square = [0; 8];
            for (row, bits) in square.iter_mut().zip(rows) {
                *row = bits.wrapping_shl(skip);
            }
            let height = rows.len();
            let y1 = y0.wrapping_add(i32::try_from(height).unwrap_or(8));
            let (columns, rows) = if self.across {
                square = transposed(square);
                (height, width as usize)
            } else {
                (width as usize, height)
            };
            let columns = u32::try_from(columns).unwrap_or(8);
            if self.from_right {
                square = square.map(|bits| bits.reverse_bits().wrapping_shl(8_u32.wrapping_sub(columns)));
            }
            let turned = square.get_mut(..rows).unwrap_or_default();
            if self.from_bottom {
                turned.reverse();
            }
            let first = self.map(Rect { x0, y0, x1, y1 }).top_left();
            self.surface.fill_strip(Strip::inside(first.x, first.y, (0, columns), turned), on, off, ready);
            y0 = y1;
        }
    }

    fn pairs(&self, on: S::Color, off: S::Color) -> Pairs {
        self.surface.pairs(on, off)
    }
}

impl<S: Readable + ?Sized> Readable for Turned<'_, S> {
    #[inline]
    fn color_at(&self, x: i32, y: i32) -> S::Color {
        let p = self.map_pixel(x, y);
        self.surface.color_at(p.x, p.y)
    }
}

/// Rows of eight bits as columns: pairs of bits change places, then squares of four bits, then the two halves of all.
///
/// Source: H. S. Warren, "Hacker's Delight", section 7-3.
const fn transposed([a, b, c, d, e, f, g, h]: [u8; 8]) -> [u8; 8] {
    let (mut upper, mut lower) = (u32::from_be_bytes([a, b, c, d]), u32::from_be_bytes([e, f, g, h]));
    upper = exchanged(exchanged(upper, 7, 0x00aa_00aa), 14, 0x0000_cccc);
    lower = exchanged(exchanged(lower, 7, 0x00aa_00aa), 14, 0x0000_cccc);
    let left = upper & 0xf0f0_f0f0 | lower >> 4 & 0x0f0f_0f0f;
    let right = upper << 4 & 0xf0f0_f0f0 | lower & 0x0f0f_0f0f;
    let ([a, b, c, d], [e, f, g, h]) = (left.to_be_bytes(), right.to_be_bytes());
    [a, b, c, d, e, f, g, h]
}

/// The bits of a mask change places with those so much higher.
const fn exchanged(bits: u32, distance: u32, mask: u32) -> u32 {
    let differ = (bits ^ bits >> distance) & mask;
    bits ^ differ ^ differ << distance
}
