//! Drawing on a [`Frame`]: functions of its layout, called with coordinates in memory.

use core::any::TypeId;

use embedded_graphics_core::geometry::Point;

use super::{
    blit::Plan,
    frame::Frame,
    layout::Layout,
    rows::Rows,
    strip::{Ready, Strip},
    traits::{copy_by_pixels, Inside, InsideRows, Readable, Said, Surface},
};
use crate::{
    num::cast::{index, low_u32},
    pixel::{rows::strip::Pairs, PixelFormat},
    span::{ClippedSpan, Octants, Rect, SoftRow, Steps},
    tune::COMPACT,
};

/// Whether a line that stays in its row is drawn as a span.
const FLAT_AS_SPANS: bool = !COMPACT;

impl<M: AsMut<[u8]>, L: Layout> Surface for Frame<M, L> {
    type Color = L::Color;

    #[inline(always)]
    fn window(&self) -> Rect {
        Frame::window(self)
    }

    #[inline]
    fn fill_span(&mut self, span: ClippedSpan, color: L::Color) {
        if let Some(span) = self.again(span) {
            self.fill_span_inside(span, color);
        }
    }

    #[inline]
    fn fill_area(&mut self, area: Rect, color: L::Color) {
        if let Some((rows, columns)) = self.places(area) {
            let (memory, grid) = self.write();
            L::fill_area(memory, grid, rows, columns, color);
        }
    }

    #[inline]
    fn fill_steps(&mut self, steps: Steps, color: L::Color) {
        let (window, (x0, y0), (x1, y1)) = (self.window(), steps.first(), steps.last());
        if window.contains(x0, y0) && window.contains(x1, y1) {
            self.fill_steps_inside(steps, color);
        } else {
            steps.spans(|span| self.fill_span(span, color));
        }
    }

    #[inline]
    fn fill_octants(&mut self, octants: Octants, color: L::Color) -> bool {
        let (window, (x, y), extent) = (self.window(), octants.first(), octants.extent());
        window.contains(x, y)
            && window.contains(x.wrapping_add(extent), y.wrapping_add(extent))
            && self.fill_octants_inside(octants, color)
    }

    // Inlined into the loops of the shapes even at their several call sites: a call would cost as much as a short span.
    #[inline(always)]
    fn fill_inside(&mut self, what: Inside, color: L::Color) -> bool {
        match what.0 {
            Said::Span(span) => self.fill_span_inside(span, color),
            Said::Steps(steps) => self.fill_steps_inside(steps, color),
            Said::Octants(octants) => return self.fill_octants_inside(octants, color),
        }
        true
    }

    #[inline]
    fn set(&mut self, p: Point, color: L::Color) {
        if self.window().contains(p.x, p.y) {
            let place = self.place(p.x, p.y);
            let (memory, grid) = self.write();
            L::set(memory, grid, place, color);
        }
    }

    #[inline(always)]
    fn write_span(&mut self, span: ClippedSpan, color_at: impl FnMut(i32) -> L::Color) {
        if let Some(span) = self.again(span) {
            self.write_span_inside(Inside(Said::Span(span)), color_at);
        }
    }

    #[inline(always)]
    fn write_span_inside(&mut self, what: Inside, mut color_at: impl FnMut(i32) -> L::Color) {
        let Said::Span(span) = what.0 else { return };
        let (y, columns, mut x) = (self.y(span.y()), self.columns(span), span.x0());
        let (memory, grid) = self.write();
        L::write_span(memory, grid, y, columns, || {
            let color = color_at(x);
            x = x.wrapping_add(1);
            color
        });
    }

    #[inline(always)]
    fn write_few_inside(&mut self, what: Inside, mut color_at: impl FnMut(i32) -> L::Color) {
        let Said::Span(span) = what.0 else { return };
        let (y, columns, mut x) = (self.y(span.y()), self.columns(span), span.x0());
        let (memory, grid) = self.write();
        L::write_few(memory, grid, y, columns, || {
            let color = color_at(x);
            x = x.wrapping_add(1);
            color
        });
    }

    #[inline(always)]
    fn write_parts_inside<R: Copy>(
        &mut self,
        what: Inside,
        most: u32,
        run: R,
        mut go_on: impl FnMut(&mut R, u32),
        color_at: impl FnMut(&mut R) -> L::Color,
    ) {
        let Said::Span(span) = what.0 else { return };
        let (y, columns) = (self.y(span.y()), self.columns(span));
        let (memory, grid) = self.write();
        let go_on = |run: &mut R, rest: usize| go_on(run, low_u32(rest as u64));
        L::write_parts(memory, grid, y, columns, (most as usize, run), go_on, color_at);
    }

    #[inline(always)]
    fn write_rows_inside<R>(
        &mut self,
        rows: InsideRows<'_>,
        start: impl FnMut(u8) -> R,
        color_at: impl FnMut(&mut R) -> L::Color,
    ) {
        let place = self.place(rows.x, rows.y);
        let (memory, grid) = self.write();
        L::write_rows(memory, grid, place, rows.spans, start, color_at);
    }

    #[inline(always)]
    fn write_some(&mut self, span: ClippedSpan, color_at: impl FnMut(i32) -> Option<L::Color>) {
        if let Some(span) = self.again(span) {
            self.write_inside(Inside(Said::Span(span)), color_at);
        }
    }

    #[inline(always)]
    fn write_inside(&mut self, what: Inside, mut color_at: impl FnMut(i32) -> Option<L::Color>) {
        let Said::Span(span) = what.0 else { return };
        let (y, columns, mut x) = (self.y(span.y()), self.columns(span), span.x0());
        let (memory, grid) = self.write();
        L::write_some(memory, grid, y, columns, || {
            let color = color_at(x);
            x = x.wrapping_add(1);
            color
        });
    }

    fn copy_picture<N, K>(&mut self, at: Point, picture: &Frame<N, K>, key: Option<L::Color>)
    where
        N: AsRef<[u8]>,
        K: Layout<Color = L::Color>,
    {
        let Some(plan) = Plan::new(self.window(), at, picture.window()) else { return };
        // Whether both layouts are the same is known when the program is compiled: only one of the two ways is linked.
        if TypeId::of::<K>() == TypeId::of::<L>() {
            let (from, from_grid) = picture.read();
            let from = (from, from_grid, picture.place(plan.from.x, plan.from.y));
            let to = self.place(plan.to.x, plan.to.y);
            let (memory, grid) = self.write();
            return L::copy((memory, grid, to), from, (plan.width as usize, plan.height as usize), key);
        }
        copy_by_pixels(self, plan, picture, key);
    }

    fn copy_mask<N, F>(&mut self, at: Point, mask: &Frame<N, Rows<F>>, on: L::Color, off: Option<L::Color>)
    where
        N: AsRef<[u8]>,
        F: PixelFormat,
    {
        let Some(plan) = Plan::new(self.window(), at, mask.window()) else { return };
        plan.each_row(|span, (from_x, from_y)| {
            let mut bits = mask.bits(from_x, from_y);
            let (y, columns) = (self.y(span.y()), self.columns(span));
            let (memory, grid) = self.write();
            L::fill_mask(memory, grid, y, columns, || bits.next(), (on, off));
        });
    }

    // Built for speed, a part of the loop over the letters of a line: a call would cost as much as the pixels of a small letter.
    #[cfg_attr(embedded_raster_compact, inline)]
    #[cfg_attr(not(embedded_raster_compact), inline(always))]
    fn fill_strip(&mut self, strip: Strip<'_>, on: L::Color, off: Option<L::Color>, ready: Ready<'_>) {
        let ((x, y), (rows, columns)) = (strip.first(), strip.bytes());
        let place = self.place(x, y);
        let (memory, grid) = self.write();
        L::fill_strip(memory, grid, place, (rows, columns), (on, off), ready.pairs());
    }

    #[inline(always)]
    fn pairs(&self, on: L::Color, off: L::Color) -> Pairs {
        L::pairs(on, off)
    }
}

impl<M: AsMut<[u8]>, L: Layout> Frame<M, L> {
    /// The part of a span in this window: whoever calls may have clipped it against another one.
    #[inline(always)]
    pub(super) fn again(&self, span: ClippedSpan) -> Option<ClippedSpan> {
        span.again(self.window())
    }

    #[inline(always)]
    fn fill_span_inside(&mut self, span: ClippedSpan, color: L::Color) {
        let (y, columns) = (self.y(span.y()), self.columns(span));
        let (memory, grid) = self.write();
        L::fill_span(memory, grid, y, columns, color);
    }

    #[inline]
    fn fill_steps_inside(&mut self, steps: Steps, color: L::Color) {
        if let Some(span) = steps.one_row().filter(|_| FLAT_AS_SPANS) {
            return self.fill_span_inside(span, color);
        }
        let (x, y) = steps.first();
        let start = self.place(x, y);
        let (memory, grid) = self.write();
        if !L::fill_steps(memory, grid, start, steps, color) {
            steps.spans(|span| self.fill_span_inside(span, color));
        }
    }

    #[inline]
    fn fill_octants_inside(&mut self, octants: Octants, color: L::Color) -> bool {
        let (x, y) = octants.first();
        let start = self.place(x, y);
        let (memory, grid) = self.write();
        L::fill_octants(memory, grid, start, octants, color)
    }
}

impl<M: AsRef<[u8]> + AsMut<[u8]>, L: Layout> Readable for Frame<M, L> {
    #[inline(always)]
    fn color_at(&self, x: i32, y: i32) -> L::Color {
        self.at(x, y)
    }

    #[inline]
    fn edit_span(&mut self, span: ClippedSpan, mut edit: impl FnMut(i32, L::Color) -> L::Color) {
        let Some(span) = self.again(span) else { return };
        let (y, columns, mut x) = (self.y(span.y()), self.columns(span), span.x0());
        let (memory, grid) = self.write();
        L::edit_span(memory, grid, y, columns, |old| {
            let new = edit(x, old);
            x = x.wrapping_add(1);
            new
        });
    }

    #[inline]
    fn mix_span(&mut self, span: ClippedSpan, levels: &[u8], mix: impl FnMut(L::Color, u8) -> L::Color) {
        let Some(seen) = self.again(span) else { return };
        let skipped = index(seen.x0().wrapping_sub(span.x0()));
        let Some(levels) = levels.get(skipped..) else { return };
        let (y, columns) = (self.y(seen.y()), self.columns(seen));
        let (memory, grid) = self.write();
        L::mix_span(memory, grid, y, columns, levels, mix);
    }

    #[inline(always)]
    fn mix_row(&mut self, row: SoftRow<'_>, color: L::Color, mut mix: impl FnMut(L::Color, u8) -> L::Color) {
        let span = row.span();
        if !span.lies_in(self.window()) {
            return row.each(|span, levels| match levels {
                Some(levels) => self.mix_span(span, levels, &mut mix),
                None => self.fill_span(span, color),
            });
        }
        let (y, columns) = (self.y(span.y()), self.columns(span));
        let (memory, grid) = self.write();
        L::mix_row(memory, grid, y, columns, (row.left(), row.right()), color, mix);
    }

    #[inline(always)]
    fn find(&self, span: ClippedSpan, wanted: impl Fn(L::Color) -> bool) -> i32 {
        let (memory, grid) = self.read();
        let (start, end) = self.columns(span);
        let found = L::find(memory, grid, self.y(span.y()), (start, end), wanted);
        span.x0().wrapping_add(distance(start, found))
    }

    #[inline(always)]
    fn find_start(&self, span: ClippedSpan, wanted: impl Fn(L::Color) -> bool) -> i32 {
        let (memory, grid) = self.read();
        let (start, end) = self.columns(span);
        let found = L::find_start(memory, grid, self.y(span.y()), (start, end), wanted);
        span.x1().wrapping_sub(distance(found, end))
    }

    #[inline(always)]
    fn fill_corridor(
        &mut self,
        Point { x, y }: Point,
        down: bool,
        color: L::Color,
        is_open: impl Fn(L::Color) -> bool,
    ) -> Option<i32> {
        let Rect { x0, x1, y0, y1 } = self.window();
        if x <= x0 || x >= x1.wrapping_sub(1) || y < y0 || y >= y1 {
            return None;
        }
        let (at, rows) = (self.place(x, y), (self.y(y0), self.y(y1)));
        let (memory, grid) = self.write();
        let painted = L::fill_corridor(memory, grid, at, rows, down, color, is_open)?;
        Some(if down { y.wrapping_add(painted) } else { y.wrapping_sub(painted) })
    }

    fn copy_area(&mut self, area: Rect, to: Point, key: Option<L::Color>) {
        let Some(plan) = Plan::within(self.window(), area, to) else { return };
        let (to, from) = (self.place(plan.to.x, plan.to.y), self.place(plan.from.x, plan.from.y));
        let (memory, grid) = self.write();
        L::move_area(memory, grid, to, from, (plan.width as usize, plan.height as usize), key);
    }
}

/// From one place in a row to another, less than a row of 65,535 pixels away.
#[inline(always)]
fn distance(from: usize, to: usize) -> i32 {
    i32::try_from(to.wrapping_sub(from)).unwrap_or_default()
}
