//! [`Surface`] and [`Readable`]: what can be drawn on, and what can be read as well.

use embedded_graphics_core::{geometry::Point, pixelcolor::PixelColor};

use super::{
    blit::Plan,
    frame::Frame,
    layout::Layout,
    rows::Rows,
    strip::{Ready, Strip},
};
use crate::{
    num::cast::{index, unsigned},
    pixel::{
        rows::{mask::one_by_one, strip::Pairs},
        PixelFormat,
    },
    span::{ClippedSpan, Octants, Rect, SoftRow, Span, Steps},
};

/// Something that can be drawn on: a [`Frame`] of memory, a [`Counter`](super::Counter) of pixels, a foreign `DrawTarget`
/// (see [`eg`](crate::eg)), or a wrapper around any of them.
///
/// It has a *window*, the pixels that it can paint, and paints spans that were clipped against that window. All other methods
/// have defaults in terms of [`fill_span`](Self::fill_span); they are there to paint the same pixels faster. So a wrapper that
/// implements only [`window`](Self::window) and [`fill_span`](Self::fill_span) sees everything that is drawn. Shapes are drawn
/// by [`Canvas`](crate::Canvas), which every surface has.
///
/// ```
/// use embedded_graphics_core::{geometry::Point, pixelcolor::BinaryColor};
/// use embedded_raster::{Canvas, ClippedSpan, Rect, Surface};
///
/// /// Keeps a list of what is painted.
/// struct Log(Vec<ClippedSpan>);
///
/// impl Surface for Log {
///     type Color = BinaryColor;
///     fn window(&self) -> Rect {
///         Rect::new(0, 0, 8, 8)
///     }
///     fn fill_span(&mut self, span: ClippedSpan, _: BinaryColor) {
///         self.0.push(span);
///     }
/// }
///
/// let mut log = Log(vec![]);
/// log.draw_line(Point::new(-9, 3), Point::new(9, 3), BinaryColor::On);
/// assert_eq!((log.0[0].x0(), log.0[0].x1()), (0, 8));
/// ```
pub trait Surface {
    /// What a pixel is painted with.
    type Color: PixelColor;

    /// The pixels that can be painted.
    fn window(&self) -> Rect;

    /// Paints the pixels of a span that was clipped against [`window`](Self::window). Nothing keeps a program from clipping it
    /// against another rectangle: a [`Frame`] paints only what lies in its window.
    #[doc(alias("hline", "h_line", "drawHLine", "drawFastHLine", "draw_hline"))]
    fn fill_span(&mut self, span: ClippedSpan, color: Self::Color);

    /// Paints the pixels of `area` that lie in the window. Shapes do it by this method; a program that wants a rectangle may call it
    /// too, or [`Canvas::fill_rectangle`](crate::Canvas::fill_rectangle), which also takes a `Rectangle` of embedded-graphics.
    #[doc(alias("fillRect", "fill_rect", "fill_rectangle", "fill_solid", "drawBox"))]
    #[inline]
    fn fill_area(&mut self, area: Rect, color: Self::Color) {
        let Rect { x0, y0, x1, y1 } = area.intersection(self.window());
        for y in y0..y1 {
            if let Some(span) = (Span { y, x0, x1 }).known_inside() {
                self.fill_span(span, color);
            }
        }
    }

    /// Paints the pixels of a line that was clipped against [`window`](Self::window).
    #[inline]
    fn fill_steps(&mut self, steps: Steps, color: Self::Color) {
        steps.spans(|span| self.fill_span(span, color));
    }

    /// Paints the outline of a circle that lies in the window as a whole, if it can do that faster than span by span. If not,
    /// it returns `false`, and is given the same pixels in spans.
    #[inline]
    fn fill_octants(&mut self, octants: Octants, color: Self::Color) -> bool {
        let _ = (octants, color);
        false
    }

    /// Paints what a method of [`Canvas`](crate::Canvas) draws in one colour. It was clipped against the window just before, so it
    /// is not clipped again. Returns what [`fill_octants`](Self::fill_octants) returns for octants, and `true` for all else.
    #[doc(hidden)]
    #[inline(always)]
    fn fill_inside(&mut self, what: Inside, color: Self::Color) -> bool {
        match what.0 {
            Said::Span(span) => self.fill_span(span, color),
            Said::Steps(steps) => self.fill_steps(steps, color),
            Said::Octants(octants) => return self.fill_octants(octants, color),
        }
        true
    }

    /// Paints one pixel; nothing if it lies outside. [`Canvas::draw_point`](crate::Canvas::draw_point) does the same and also takes
    /// `(x, y)`.
    #[doc(alias("drawPixel", "draw_pixel", "setPixel", "set_pixel", "draw_point"))]
    #[inline]
    fn set(&mut self, p: Point, color: Self::Color) {
        if self.window().contains(p.x, p.y) {
            self.fill_span(ClippedSpan::inside(p.y, p.x, p.x.wrapping_add(1)), color);
        }
    }

    /// Paints the pixels of a span from left to right, each in a colour of its own: what `color_at` gives for the column.
    #[doc(alias("pushColors", "pushPixels", "fill_contiguous"))]
    #[inline]
    fn write_span(&mut self, span: ClippedSpan, mut color_at: impl FnMut(i32) -> Self::Color)
    where
        Self: Sized,
    {
        self.write_some(span, |x| Some(color_at(x)));
    }

    /// [`write_span`](Self::write_span), but a pixel for which `color_at` gives `None` keeps its colour.
    #[inline]
    fn write_some(&mut self, span: ClippedSpan, mut color_at: impl FnMut(i32) -> Option<Self::Color>)
    where
        Self: Sized,
    {
        for x in span.x0()..span.x1() {
            if let Some(color) = color_at(x) {
                self.fill_span(ClippedSpan::inside(span.y(), x, x.wrapping_add(1)), color);
            }
        }
    }

    /// [`write_span`](Self::write_span) where this crate clipped the span just before: see [`fill_inside`](Self::fill_inside).
    #[doc(hidden)]
    #[inline(always)]
    fn write_span_inside(&mut self, what: Inside, color_at: impl FnMut(i32) -> Self::Color)
    where
        Self: Sized,
    {
        if let Said::Span(span) = what.0 {
            self.write_span(span, color_at);
        }
    }

    /// The same for a few pixels.
    #[doc(hidden)]
    #[inline(always)]
    fn write_few_inside(&mut self, what: Inside, color_at: impl FnMut(i32) -> Self::Color)
    where
        Self: Sized,
    {
        self.write_span_inside(what, color_at);
    }

    /// The same in parts of `most` pixels and a last one of as many or fewer. The first one begins with `run`; when a part is done,
    /// `go_on` takes the run to the next one, and is told how many pixels are left.
    #[doc(hidden)]
    #[inline(always)]
    fn write_parts_inside<R: Copy>(
        &mut self,
        what: Inside,
        most: u32,
        mut run: R,
        mut go_on: impl FnMut(&mut R, u32),
        mut color_at: impl FnMut(&mut R) -> Self::Color,
    ) where
        Self: Sized,
    {
        let Said::Span(span) = what.0 else { return };
        span.parts(most, |part| {
            if part.x0() != span.x0() {
                go_on(&mut run, unsigned(span.x1().wrapping_sub(part.x0())));
            }
            let mut at = run;
            self.write_span_inside(Inside(Said::Span(part)), |_| color_at(&mut at));
            run = at;
        });
    }

    /// The same in rows that follow each other. `start` is given what each row has, and answers with what its colours are made of, from
    /// left to right, by `color_at`.
    #[doc(hidden)]
    #[inline(always)]
    fn write_rows_inside<R>(
        &mut self,
        rows: InsideRows<'_>,
        mut start: impl FnMut(u8) -> R,
        mut color_at: impl FnMut(&mut R) -> Self::Color,
    ) where
        Self: Sized,
    {
        let InsideRows { x, mut y, spans } = rows;
        for &[right, pixels] in spans {
            let (mut run, x0) = (start(right), x.wrapping_add(right.into()));
            if let Some(span) = (Span { y, x0, x1: x0.wrapping_add(pixels.into()) }).known_inside() {
                self.write_few_inside(Inside(Said::Span(span)), |_| color_at(&mut run));
            }
            y = y.wrapping_add(1);
        }
    }

    /// [`write_some`](Self::write_some) where this crate clipped the span just before: see [`fill_inside`](Self::fill_inside).
    #[doc(hidden)]
    #[inline(always)]
    fn write_inside(&mut self, what: Inside, color_at: impl FnMut(i32) -> Option<Self::Color>)
    where
        Self: Sized,
    {
        if let Said::Span(span) = what.0 {
            self.write_some(span, color_at);
        }
    }

    /// Copies a picture so that its top left pixel falls on `at`, all but the pixels of the colour `key`. What lies outside
    /// is clipped. The picture may have any layout, with colours of the same type.
    #[doc(alias("bitBlt", "blit", "drawRGBBitmap", "pushImage"))]
    fn copy_picture<M, L>(&mut self, at: Point, picture: &Frame<M, L>, key: Option<Self::Color>)
    where
        Self: Sized,
        M: AsRef<[u8]>,
        L: Layout<Color = Self::Color>,
    {
        if let Some(plan) = Plan::new(self.window(), at, picture.window()) {
            copy_by_pixels(self, plan, picture, key);
        }
    }

    /// Paints a picture of one bit per pixel so that its top left pixel falls on `at`: a set bit in the colour `on`, any other in
    /// the colour `off`, or not at all if `off` is `None`. What lies outside is clipped.
    #[doc(alias("drawBitmap", "blit_mask", "drawXBitmap"))]
    fn copy_mask<M, F>(&mut self, at: Point, mask: &Frame<M, Rows<F>>, on: Self::Color, off: Option<Self::Color>)
    where
        Self: Sized,
        M: AsRef<[u8]>,
        F: PixelFormat,
    {
        let Some(plan) = Plan::new(self.window(), at, mask.window()) else { return };
        plan.each_row(|span, (from_x, from_y)| {
            let mut bits = mask.bits(from_x, from_y);
            let mut is_set = one_by_one(|| bits.next());
            self.write_inside(Inside(Said::Span(span)), |_| if is_set() { Some(on) } else { off });
        });
    }

    /// Paints a piece of a glyph, which lies in the window: see [`text`](crate::text). A set bit in the colour `on`, any other in
    /// the colour `off`, or not at all if `off` is `None`. `ready` has the [`pairs`](Self::pairs) of both. By default, run by run.
    #[doc(hidden)]
    fn fill_strip(&mut self, strip: Strip<'_>, on: Self::Color, off: Option<Self::Color>, _ready: Ready<'_>) {
        strip.runs(|span, is_set| {
            if let Some(color) = if is_set { Some(on) } else { off } {
                self.fill_span(span, color);
            }
        });
    }

    /// The two pixels for each two bits of a glyph, where pixels have 16 bits: a table for all opaque glyphs in the same two colours. Other
    /// surfaces do not look at it.
    #[doc(hidden)]
    fn pairs(&self, _on: Self::Color, _off: Self::Color) -> Pairs {
        Pairs::default()
    }
}

/// Pixels that lie in the window of the surface that they are given to. Others cannot make one, nor name this type.
#[derive(Debug)]
pub struct Inside(pub(crate) Said);

/// Spans in rows that follow each other, from row y on, all of which lie in the window: of each, how far it is to the right of column x,
/// which lies there too or just behind it, and its pixels, which may be none. Others cannot make one, nor name this type.
#[derive(Debug)]
pub struct InsideRows<'a> {
    pub(crate) x: i32,
    pub(crate) y: i32,
    pub(crate) spans: &'a [[u8; 2]],
}

/// What a shape says, but for areas, which every surface clips.
#[derive(Debug)]
pub(crate) enum Said {
    Span(ClippedSpan),
    Steps(Steps),
    Octants(Octants),
}

/// Paints the pixels of a picture that a plan names, one by one, each in what `color` makes of it, or not at all for `None`.
#[inline(always)]
fn copy_mapped<S, M, L>(
    to: &mut S,
    plan: Plan,
    picture: &Frame<M, L>,
    mut color: impl FnMut(L::Color) -> Option<S::Color>,
) where
    S: Surface,
    M: AsRef<[u8]>,
    L: Layout,
{
    plan.each_row(|span, (from_x, from_y)| {
        let right = from_x.wrapping_sub(span.x0());
        to.write_inside(Inside(Said::Span(span)), |x| color(picture.at(x.wrapping_add(right), from_y)));
    });
}

/// Paints a picture so that its top left pixel falls on `at`: see [`copy_mapped`].
#[inline(always)]
pub(crate) fn blit_mapped<S, M, L>(
    to: &mut S,
    at: Point,
    picture: &Frame<M, L>,
    color: impl FnMut(L::Color) -> Option<S::Color>,
) where
    S: Surface,
    M: AsRef<[u8]>,
    L: Layout,
{
    if let Some(plan) = Plan::new(to.window(), at, picture.window()) {
        copy_mapped(to, plan, picture, color);
    }
}

/// Gives each pixel that a picture falls on the colour that `mix` makes of that of the picture and the old one.
pub(crate) fn blit_mixed<S, M, L>(
    to: &mut S,
    at: Point,
    picture: &Frame<M, L>,
    mut mix: impl FnMut(L::Color, S::Color) -> S::Color,
) where
    S: Readable,
    M: AsRef<[u8]>,
    L: Layout,
{
    let Some(plan) = Plan::new(to.window(), at, picture.window()) else { return };
    plan.each_row(|span, (from_x, from_y)| {
        let right = from_x.wrapping_sub(span.x0());
        to.edit_span(span, |x, old| mix(picture.at(x.wrapping_add(right), from_y), old));
    });
}

/// Copies the pixels of a picture that a plan names, one by one, except those of the colour `key`.
#[inline(always)]
pub(super) fn copy_by_pixels<S, M, L>(to: &mut S, plan: Plan, picture: &Frame<M, L>, key: Option<S::Color>)
where
    S: Surface,
    M: AsRef<[u8]>,
    L: Layout<Color = S::Color>,
{
    copy_mapped(to, plan, picture, |color| Some(color).filter(|_| key != Some(color)));
}

/// A surface whose pixels can be read: what flood fills, scrolling and blending need. A foreign `DrawTarget` is none.
pub trait Readable: Surface {
    /// The colour of a pixel that lies in the window.
    #[doc(alias("readPixel", "getPixel", "get_pixel"))]
    fn color_at(&self, x: i32, y: i32) -> Self::Color;

    /// The colour of a pixel; `None` if it lies outside.
    #[doc(alias("readPixel", "getPixel", "get_pixel", "pixel"))]
    #[inline]
    fn get(&self, p: Point) -> Option<Self::Color> {
        self.window().contains(p.x, p.y).then(|| self.color_at(p.x, p.y))
    }

    /// Calls `read` with the colours of a span, from left to right.
    #[doc(alias("readRect"))]
    #[inline]
    fn read_span(&self, span: ClippedSpan, mut read: impl FnMut(Self::Color))
    where
        Self: Sized,
    {
        for x in span.x0()..span.x1() {
            read(self.color_at(x, span.y()));
        }
    }

    /// Replaces the colours of a span, from left to right: what `edit` makes of the column and the old colour.
    #[inline]
    fn edit_span(&mut self, span: ClippedSpan, mut edit: impl FnMut(i32, Self::Color) -> Self::Color)
    where
        Self: Sized,
    {
        for x in span.x0()..span.x1() {
            let color = edit(x, self.color_at(x, span.y()));
            self.fill_span(ClippedSpan::inside(span.y(), x, x.wrapping_add(1)), color);
        }
    }

    /// Replaces the colours of a span that is covered in part, from left to right: what `mix` makes of the old colour and of the level
    /// of the pixel. There are as many levels as pixels.
    #[inline]
    fn mix_span(&mut self, span: ClippedSpan, levels: &[u8], mut mix: impl FnMut(Self::Color, u8) -> Self::Color)
    where
        Self: Sized,
    {
        // By the column: what lies outside of the window may be left out.
        self.edit_span(span, |x, old| mix(old, levels.get(index(x.wrapping_sub(span.x0()))).copied().unwrap_or(0)));
    }

    /// Paints a row, and replaces the colours of its rims by what `mix` makes of them and of the levels.
    #[inline]
    fn mix_row(&mut self, row: SoftRow<'_>, color: Self::Color, mut mix: impl FnMut(Self::Color, u8) -> Self::Color)
    where
        Self: Sized,
    {
        row.each(|span, levels| match levels {
            Some(levels) => self.mix_span(span, levels, &mut mix),
            None => self.fill_span(span, color),
        });
    }

    /// The first column of a span whose colour is wanted; the column after its last if there is none.
    #[inline]
    fn find(&self, span: ClippedSpan, wanted: impl Fn(Self::Color) -> bool) -> i32
    where
        Self: Sized,
    {
        let mut x = span.x0();
        while x < span.x1() && !wanted(self.color_at(x, span.y())) {
            x = x.wrapping_add(1);
        }
        x
    }

    /// Looks back from the end of a span, for as long as colours are wanted. Returns the first column of that run; the column
    /// after the span if its last pixel is not wanted.
    #[inline]
    fn find_start(&self, span: ClippedSpan, wanted: impl Fn(Self::Color) -> bool) -> i32
    where
        Self: Sized,
    {
        let mut x = span.x1();
        while x > span.x0() && wanted(self.color_at(x.wrapping_sub(1), span.y())) {
            x = x.wrapping_sub(1);
        }
        x
    }

    /// Paints straight down or up from a pixel, while the pixel lies in the window and is open, and its left and right
    /// neighbours are not open. Returns the row after the last one painted. `None`, by default, if there is no faster way than
    /// pixel by pixel. A shortcut for flood fills of mazes.
    #[inline]
    fn fill_corridor(
        &mut self,
        from: Point,
        down: bool,
        color: Self::Color,
        is_open: impl Fn(Self::Color) -> bool,
    ) -> Option<i32>
    where
        Self: Sized,
    {
        let _ = (from, down, color, is_open);
        None
    }

    /// Copies the pixels of `area` so that the top left one falls on `to`, except those of the colour `key`. Both areas may
    /// overlap. Pixels that lie outside of the window, before or after, are left out.
    #[doc(alias("scroll", "move_area", "copy_rect"))]
    fn copy_area(&mut self, area: Rect, to: Point, key: Option<Self::Color>) {
        let Some(plan) = Plan::within(self.window(), area, to) else { return };
        plan.each_pixel(|(to_x, to_y), (from_x, from_y)| {
            let color = self.color_at(from_x, from_y);
            if key != Some(color) {
                self.fill_span(ClippedSpan::inside(to_y, to_x, to_x.wrapping_add(1)), color);
            }
        });
    }
}
