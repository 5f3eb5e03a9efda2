//! Flood fills of surfaces whose pixels can be read.

use embedded_graphics_core::geometry::Point;

use crate::{
    raster::flood::{corridor, FloodTarget},
    span::{ClippedSpan, Rect},
    surface::{Inside, Readable, Said},
};

/// A surface, and which of its colours are open.
pub(super) struct Area<'f, S: Readable, P> {
    pub(super) surface: &'f mut S,
    pub(super) color: S::Color,
    pub(super) is_open: P,
}

impl<S: Readable, P: Fn(S::Color) -> bool> Area<'_, S, P> {
    #[inline(always)]
    fn span(y: i32, x0: i32, x1: i32) -> Option<ClippedSpan> {
        (x0 < x1).then_some(ClippedSpan::inside(y, x0, x1))
    }
}

impl<S: Readable, P: Fn(S::Color) -> bool> FloodTarget for Area<'_, S, P> {
    fn window(&self) -> Rect {
        self.surface.window()
    }

    #[inline]
    fn is_open(&self, x: i32, y: i32) -> bool {
        (self.is_open)(self.surface.color_at(x, y))
    }

    #[inline]
    fn paint(&mut self, span: ClippedSpan) {
        self.surface.fill_inside(Inside(Said::Span(span)), self.color);
    }

    #[inline]
    fn paint_pixel(&mut self, x: i32, y: i32) {
        self.paint(ClippedSpan::inside(y, x, x.wrapping_add(1)));
    }

    #[inline]
    fn find(&self, y: i32, x0: i32, x1: i32, open: bool) -> i32 {
        let Some(span) = Self::span(y, x0, x1) else { return x1 };
        if open {
            self.surface.find(span, |color| (self.is_open)(color))
        } else {
            self.surface.find(span, |color| !(self.is_open)(color))
        }
    }

    #[inline]
    fn start(&self, y: i32, x0: i32, x: i32) -> i32 {
        Self::span(y, x0, x).map_or(x, |span| self.surface.find_start(span, |color| (self.is_open)(color)))
    }

    #[inline]
    fn corridor(&mut self, x: i32, y: i32, down: i32) -> i32 {
        match self.surface.fill_corridor(Point::new(x, y), down > 0, self.color, |color| (self.is_open)(color)) {
            Some(end) => end,
            None => corridor(self, x, y, down),
        }
    }
}
