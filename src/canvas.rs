//! [`Canvas`]: shapes on surfaces, the everyday API.

use core::borrow::Borrow;

use embedded_graphics_core::geometry::Point;

use crate::{
    error::Error,
    geom::Vertex,
    raster::{line, polygon, rectangle, triangle, Edge, FillRule},
    rect::Rect,
    span::ClippedSpan,
    surface::Surface,
};

/// Draws shapes on any [`Surface`]. Whatever lies outside of its window is clipped, exactly.
///
/// Lines join pixels ([`Point`]); filled shapes are given by places on the plane ([`Vertex`]). Each method links only the
/// code of its own shape.
/// ```
/// use embedded_graphics_core::{geometry::Point, pixelcolor::Rgb565, prelude::RgbColor};
/// use embedded_raster::{buffer_bytes, Canvas, Framebuffer, Vertex};
/// let mut ram = [0; buffer_bytes::<Rgb565>(64, 48)];
/// let mut frame = Framebuffer::<Rgb565>::new(&mut ram, 64, 48)?;
/// frame.fill_triangle([Vertex::px(32, 4), Vertex::px(60, 40), Vertex::px(6, 44)], Rgb565::RED);
/// frame.draw_line(Point::new(0, 0), Point::new(63, 47), Rgb565::WHITE);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
pub trait Canvas: Surface {
    /// Paints everything that can be painted.
    #[inline]
    fn fill_window(&mut self, color: Self::Color) {
        self.fill_area(self.window(), color);
    }

    /// Paints the pixel that contains a place.
    #[inline]
    fn draw_point(&mut self, at: Vertex, color: Self::Color) {
        let Point { x, y } = at.pixel();
        self.fill_area(Rect::new(x, y, x + 1, y + 1), color);
    }

    /// Draws a line one pixel wide, both ends included: see [`line`](crate::raster::line) for which pixels.
    #[inline]
    fn draw_line(&mut self, a: Point, b: Point, color: Self::Color) {
        if let Some(steps) = line::clip(a, b, self.window()) {
            self.fill_steps(steps, color);
        }
    }

    /// Draws lines from each point to the next. Inner points are painted twice, which matters to nobody but a counter.
    fn draw_polyline(&mut self, points: impl IntoIterator<Item = Point>, color: Self::Color)
    where
        Self: Sized,
    {
        let mut last = None;
        for point in points {
            self.draw_line(last.unwrap_or(point), point, color);
            last = Some(point);
        }
    }

    /// Fills a rectangle given by two opposite corners: the pixels whose centres lie inside, those on the left and top
    /// sides included.
    #[inline]
    fn fill_rectangle(&mut self, a: Vertex, b: Vertex, color: Self::Color) {
        self.fill_area(rectangle::pixels(a, b), color);
    }

    /// Fills a triangle: see [`triangle`](crate::raster::triangle) for which pixels.
    #[inline]
    fn fill_triangle(&mut self, corners: [Vertex; 3], color: Self::Color) {
        triangle::fill_to(corners, self.window(), &mut Brush { surface: self, color });
    }

    /// Fills a polygon of one contour, closed by itself. `table` is scratch memory: see [`polygon::fill`].
    ///
    /// # Errors
    /// [`Error::EdgeTableFull`] if a single row is crossed by more sides than `table` holds. Nothing is painted then.
    #[inline]
    fn fill_polygon(
        &mut self,
        outline: &[Vertex],
        rule: FillRule,
        table: &mut [Edge],
        color: Self::Color,
    ) -> Result<(), Error> {
        polygon::fill([outline], rule, self.window(), table, |span| self.fill_span(span, color))
    }

    /// Fills a polygon of many contours, such as a country with islands and lakes: see [`polygon::fill`].
    ///
    /// # Errors
    /// [`Error::EdgeTableFull`] if a single row is crossed by more sides than `table` holds. Nothing is painted then.
    #[inline]
    fn fill_contours<C>(
        &mut self,
        contours: C,
        rule: FillRule,
        table: &mut [Edge],
        color: Self::Color,
    ) -> Result<(), Error>
    where
        Self: Sized,
        C: IntoIterator + Clone,
        C::Item: IntoIterator,
        <C::Item as IntoIterator>::Item: Borrow<Vertex>,
    {
        polygon::fill(contours, rule, self.window(), table, |span| self.fill_span(span, color))
    }
}

impl<S: Surface + ?Sized> Canvas for S {}

/// A surface and the colour that spans are painted with.
struct Brush<'a, S: Surface + ?Sized> {
    surface: &'a mut S,
    color: S::Color,
}

impl<S: Surface + ?Sized> triangle::Sink for Brush<'_, S> {
    #[inline(always)]
    fn emit(&mut self, span: ClippedSpan) {
        self.surface.fill_span(span, self.color);
    }
}
