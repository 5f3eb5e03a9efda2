//! [`Recorder`]: a surface around a surface, which tells where something is drawn.
//!
//! Where something is drawn is known before it is drawn, so a recorder looks at what a shape says and hands it on as it is: spans, areas,
//! lines and circles are drawn as fast as without it, by the loops of the surface inside. What it tells costs some additions for each.
//!
//! **Lines in pieces.** The box around a diagonal line is large, and the line is not. So a line is told as the boxes of its pieces. They
//! are found without walking it: let p be the coordinate along the minor axis, t the steps along the major axis, and c(t) the straight
//! line from the first visible pixel to the last. All pixels are within 1/2 of the line that was asked for, these two as well; so c is
//! within 1/2 of it, and every pixel within 1 of c. In fixed point, with `slope = floor(2^16 sideways / left)`, the number
//! `m = floor(t slope / 2^16)` is at most c and above c - 2, as t is below 2^16. So `m - 1 <= p <= m + 2`.

use embedded_graphics_core::geometry::{Point, Size};

use super::{
    blit::Plan,
    frame::Frame,
    layout::Layout,
    rows::Rows,
    traits::{Inside, Readable, Said, Surface},
};
use crate::{
    num::cast::signed,
    pixel::PixelFormat,
    span::{ClippedSpan, Octants, Rect, Steps},
};

/// A surface that calls `record` with each rectangle that is about to be drawn in, in its own coordinates.
///
/// Every pixel that is changed through it lies in one of the rectangles; not every pixel of them is changed. None is empty, and all lie
/// in the window. [`Damage`](super::Damage) keeps them:
/// ```
/// use embedded_raster::{surface::{Damage, Recorder}, Canvas, Framebuffer, Index4, Rect};
/// let mut ram = [0; 64 * 48 / 2];
/// let mut frame = Framebuffer::<Index4>::new(&mut ram, 64, 48)?;
/// let mut damage = Damage::<8>::new();
/// let mut recorder = Recorder::new(&mut frame, |area| damage.add(area));
/// recorder.fill_rectangle(Rect::new(3, 3, 9, 9), Index4::new(7));
/// recorder.fill_ellipse(Rect::new(40, 20, 56, 36), Index4::new(8));
/// assert_eq!(damage.areas(), [Rect::new(3, 3, 9, 9), Rect::new(40, 20, 56, 36)]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
/// Around a view, `|area| damage.add(area.translate(x, y))` records in the coordinates of the screen.
pub struct Recorder<'a, S, R> {
    surface: &'a mut S,
    record: R,
}

impl<'a, S: Surface, R: FnMut(Rect)> Recorder<'a, S, R> {
    /// Tells `record` what is drawn on `surface`.
    pub const fn new(surface: &'a mut S, record: R) -> Self {
        Self { surface, record }
    }

    /// What of a rectangle lies in the window.
    #[inline]
    fn area(&mut self, area: Rect) {
        let area = area.intersection(self.surface.window());
        if !area.is_empty() {
            (self.record)(area);
        }
    }

    #[inline]
    fn plan(&mut self, plan: Option<Plan>) {
        if let Some(Plan { to, width, height, .. }) = plan {
            (self.record)(Rect::with_size(to, Size::new(width, height)));
        }
    }
}

#[inline]
fn of_span(span: ClippedSpan) -> Rect {
    Rect::new(span.x0(), span.y(), span.x1(), span.y().saturating_add(1))
}

#[inline]
fn of_octants(octants: Octants) -> Rect {
    let ((x, y), side) = (octants.first(), octants.extent().saturating_add(1));
    Rect::new(x, y, x.saturating_add(side), y.saturating_add(side))
}

/// The pixels `a..=b` in both axes, in either order.
#[inline]
fn between((ax, ay): (i32, i32), (bx, by): (i32, i32)) -> Rect {
    Rect::new(ax.min(bx), ay.min(by), ax.max(bx).saturating_add(1), ay.max(by).saturating_add(1))
}

/// Steps along the minor axis in a piece of a line: what a box of some columns and rows costs is little then.
const PIECE: u32 = 16;

/// Pieces of a line, at most.
const MOST: u32 = 16;

/// Boxes that hold every pixel of a line, each with one of them at least.
fn of_steps(steps: &Steps, mut emit: impl FnMut(Rect)) {
    let Steps { left, sideways, x_step, steep, .. } = *steps;
    let ((x, y), bounds) = (steps.first(), between(steps.first(), steps.last()));
    let pieces = (sideways / PIECE).min(MOST);
    if pieces < 2 || left > 0xffff {
        return emit(bounds);
    }
    // There are no more steps sideways than along, and more of both than pieces: neither is divided by 0.
    let (slope, length) = ((sideways << 16).checked_div(left), left.checked_div(pieces));
    let (slope, length) = (slope.unwrap_or_default(), length.unwrap_or_default());
    let place = |along: u32, aside: i32| {
        let (right, down) = if steep { (aside, signed(along)) } else { (signed(along), aside) };
        (x.saturating_add(right.wrapping_mul(x_step)), y.saturating_add(down))
    };
    let aside = |along: u32| signed(along.wrapping_mul(slope) >> 16);
    let mut start = 0;
    while start <= left {
        let end = start.saturating_add(length).min(left);
        let area = between(place(start, aside(start).wrapping_sub(1)), place(end, aside(end).wrapping_add(2)));
        emit(area.intersection(bounds));
        start = end.wrapping_add(1);
    }
}

impl<S: Surface, R: FnMut(Rect)> Surface for Recorder<'_, S, R> {
    type Color = S::Color;

    #[inline]
    fn window(&self) -> Rect {
        self.surface.window()
    }

    #[inline]
    fn fill_span(&mut self, span: ClippedSpan, color: S::Color) {
        self.area(of_span(span));
        self.surface.fill_span(span, color);
    }

    #[inline]
    fn fill_area(&mut self, area: Rect, color: S::Color) {
        self.area(area);
        self.surface.fill_area(area, color);
    }

    fn fill_steps(&mut self, steps: Steps, color: S::Color) {
        of_steps(&steps, |area| self.area(area));
        self.surface.fill_steps(steps, color);
    }

    fn fill_octants(&mut self, octants: Octants, color: S::Color) -> bool {
        let is_drawn = self.surface.fill_octants(octants, color);
        if is_drawn {
            self.area(of_octants(octants));
        }
        is_drawn
    }

    #[inline]
    fn fill_inside(&mut self, what: Inside, color: S::Color) -> bool {
        match &what.0 {
            Said::Span(span) => (self.record)(of_span(*span)),
            Said::Steps(steps) => of_steps(steps, |area| (self.record)(area)),
            Said::Octants(octants) => return self.fill_octants(*octants, color),
        }
        self.surface.fill_inside(what, color)
    }

    #[inline]
    fn set(&mut self, p: Point, color: S::Color) {
        self.area(Rect::new(p.x, p.y, p.x.saturating_add(1), p.y.saturating_add(1)));
        self.surface.set(p, color);
    }

    #[inline]
    fn write_span(&mut self, span: ClippedSpan, color_at: impl FnMut(i32) -> S::Color) {
        self.area(of_span(span));
        self.surface.write_span(span, color_at);
    }

    #[inline]
    fn write_some(&mut self, span: ClippedSpan, color_at: impl FnMut(i32) -> Option<S::Color>) {
        self.area(of_span(span));
        self.surface.write_some(span, color_at);
    }

    #[inline]
    fn write_span_inside(&mut self, what: Inside, color_at: impl FnMut(i32) -> S::Color) {
        if let Said::Span(span) = what.0 {
            (self.record)(of_span(span));
        }
        self.surface.write_span_inside(what, color_at);
    }

    #[inline]
    fn write_inside(&mut self, what: Inside, color_at: impl FnMut(i32) -> Option<S::Color>) {
        if let Said::Span(span) = what.0 {
            (self.record)(of_span(span));
        }
        self.surface.write_inside(what, color_at);
    }

    fn copy_picture<M, L>(&mut self, at: Point, picture: &Frame<M, L>, key: Option<S::Color>)
    where
        M: AsRef<[u8]>,
        L: Layout<Color = S::Color>,
    {
        self.plan(Plan::new(self.window(), at, picture.window()));
        self.surface.copy_picture(at, picture, key);
    }

    fn copy_mask<M, F>(&mut self, at: Point, mask: &Frame<M, Rows<F>>, on: S::Color, off: Option<S::Color>)
    where
        M: AsRef<[u8]>,
        F: PixelFormat,
    {
        self.plan(Plan::new(self.window(), at, mask.window()));
        self.surface.copy_mask(at, mask, on, off);
    }
}

impl<S: Readable, R: FnMut(Rect)> Readable for Recorder<'_, S, R> {
    #[inline]
    fn color_at(&self, x: i32, y: i32) -> S::Color {
        self.surface.color_at(x, y)
    }

    #[inline]
    fn read_span(&self, span: ClippedSpan, read: impl FnMut(S::Color)) {
        self.surface.read_span(span, read);
    }

    #[inline]
    fn edit_span(&mut self, span: ClippedSpan, edit: impl FnMut(i32, S::Color) -> S::Color) {
        self.area(of_span(span));
        self.surface.edit_span(span, edit);
    }

    #[inline]
    fn find(&self, span: ClippedSpan, wanted: impl Fn(S::Color) -> bool) -> i32 {
        self.surface.find(span, wanted)
    }

    #[inline]
    fn find_start(&self, span: ClippedSpan, wanted: impl Fn(S::Color) -> bool) -> i32 {
        self.surface.find_start(span, wanted)
    }

    fn fill_corridor(
        &mut self,
        from: Point,
        down: bool,
        color: S::Color,
        is_open: impl Fn(S::Color) -> bool,
    ) -> Option<i32> {
        let end = self.surface.fill_corridor(from, down, color, is_open)?;
        let (y0, y1) = if down { (from.y, end) } else { (end.saturating_add(1), from.y.saturating_add(1)) };
        self.area(Rect::new(from.x, y0, from.x.saturating_add(1), y1));
        Some(end)
    }

    fn copy_area(&mut self, area: Rect, to: Point, key: Option<S::Color>) {
        self.plan(Plan::within(self.window(), area, to));
        self.surface.copy_area(area, to, key);
    }
}
