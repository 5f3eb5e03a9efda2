//! [`Canvas`]: shapes on surfaces, the everyday API.

mod flood;

use core::{borrow::Borrow, iter::once};

use embedded_graphics_core::geometry::Point;
use fixed::types::I24F8;

use crate::{
    error::EdgeTableFull,
    geom::{Path, PathSegment, PointFx},
    raster::{
        arc,
        ellipse::{self, Disc},
        line, outline, polygon, rectangle, rounded,
        stroke::Dashing,
        triangle, EdgeSlot, Ellipse, FillRule, Radii, Sector, Stroke,
    },
    rect::Rect,
    span::ClippedSpan,
    surface::Surface,
};

/// Draws shapes on any [`Surface`]. Whatever lies outside of its window is clipped, exactly.
///
/// Lines join pixels ([`Point`]); filled shapes are given by places on the plane ([`PointFx`]). Each method links only the
/// code of its own shape.
/// ```
/// use embedded_graphics_core::{geometry::Point, pixelcolor::Rgb565, prelude::RgbColor};
/// use embedded_raster::{buffer_bytes, Canvas, Framebuffer, PointFx};
/// let mut ram = [0; buffer_bytes::<Rgb565>(64, 48)];
/// let mut frame = Framebuffer::<Rgb565>::new(&mut ram, 64, 48)?;
/// frame.fill_triangle([PointFx::px(32, 4), PointFx::px(60, 40), PointFx::px(6, 44)], Rgb565::RED);
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
    fn draw_point(&mut self, at: PointFx, color: Self::Color) {
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

    /// Draws lines from each corner of a polygon to the next, and from the last one to the first. Corners are painted twice.
    /// ```
    /// use embedded_graphics_core::{geometry::Point, pixelcolor::Gray8};
    /// use embedded_raster::{Canvas, Framebuffer};
    /// let mut ram = [b'.'; 20];
    /// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 5, 4)?;
    /// frame.draw_polygon([(0, 0), (4, 0), (1, 3)].map(Point::from), Gray8::new(b'#'));
    /// assert_eq!(&ram, b"######..#..##...#...");
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    fn draw_polygon(&mut self, corners: impl IntoIterator<Item = Point>, color: Self::Color)
    where
        Self: Sized,
    {
        let mut corners = corners.into_iter();
        if let Some(first) = corners.next() {
            self.draw_polyline(once(first).chain(corners).chain(once(first)), color);
        }
    }

    /// Draws the outline of a box of pixels, one pixel wide, each pixel once.
    /// ```
    /// use embedded_graphics_core::pixelcolor::Gray8;
    /// use embedded_raster::{Canvas, Framebuffer, Rect};
    /// let mut ram = [b'.'; 20];
    /// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 5, 4)?;
    /// frame.draw_rectangle(Rect::new(1, 0, 5, 4), Gray8::new(b'#'));
    /// assert_eq!(&ram, b".####.#..#.#..#.####");
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[inline]
    fn draw_rectangle(&mut self, area: Rect, color: Self::Color) {
        for side in rectangle::sides(area) {
            self.fill_area(side, color);
        }
    }

    /// Fills a rectangle given by two opposite corners: the pixels whose centres lie inside, those on the left and top
    /// sides included.
    #[inline]
    fn fill_rectangle(&mut self, a: PointFx, b: PointFx, color: Self::Color) {
        self.fill_area(rectangle::pixels(a, b), color);
    }

    /// Fills a triangle: see [`triangle`](crate::raster::triangle) for which pixels.
    #[inline]
    fn fill_triangle(&mut self, corners: [PointFx; 3], color: Self::Color) {
        triangle::fill_to(corners, self.window(), &mut Brush { surface: self, color });
    }

    /// Fills a circle or an ellipse: see [`ellipse`](crate::raster::ellipse) for which pixels.
    /// ```
    /// use embedded_graphics_core::pixelcolor::Gray8;
    /// use embedded_raster::{Canvas, Ellipse, Framebuffer, Rect};
    /// let mut ram = [b'.'; 20];
    /// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 5, 4)?;
    /// frame.fill_ellipse(Ellipse::in_box(Rect::new(0, 0, 5, 4)), Gray8::new(b'#'));
    /// assert_eq!(&ram, b".###.##########.###.");
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[inline]
    fn fill_ellipse(&mut self, ellipse: Ellipse, color: Self::Color) {
        // The loop over a small disc is compiled together with the surface's code.
        match ellipse::disc(&ellipse, self.window()) {
            Some(disc) => fill_mirrored(self, disc, color),
            None => ellipse::fill(ellipse, self.window(), |span| self.fill_span(span, color)),
        }
    }

    /// Draws the outline, one pixel wide, of the ellipse in a box of pixels.
    #[inline]
    fn draw_ellipse(&mut self, area: Rect, color: Self::Color) {
        match ellipse::octants(area, self.window()) {
            Some(octants) => self.fill_octants(octants, color),
            None => ellipse::outline(area, self.window(), |span| self.fill_span(span, color)),
        }
    }

    /// Fills what [`draw_ellipse`](Self::draw_ellipse) encloses, the outline included.
    #[inline]
    fn fill_enclosed(&mut self, area: Rect, color: Self::Color) {
        ellipse::enclosed(area, self.window(), |span| self.fill_span(span, color));
    }

    /// Paints a round point of any diameter: the pixels whose centres lie inside of the circle.
    #[inline]
    fn draw_round_point(&mut self, at: PointFx, size: I24F8, color: Self::Color) {
        self.fill_ellipse(Ellipse::splat(at, size), color);
    }

    /// Paints a square point of any size: the pixels whose centres lie inside, those on the left and top sides included.
    #[inline]
    fn draw_square_point(&mut self, at: PointFx, size: I24F8, color: Self::Color) {
        self.fill_area(ellipse::square(at, size), color);
    }

    /// Draws the part of the outline of the ellipse in a box that lies in a sector: see [`arc`](crate::raster::arc).
    #[inline]
    fn draw_arc(&mut self, area: Rect, sector: Sector, color: Self::Color) {
        arc::outline(area, sector, self.window(), |span| self.fill_span(span, color));
    }

    /// Fills a sector of an ellipse, a slice of a pie.
    /// ```
    /// use embedded_graphics_core::pixelcolor::Gray8;
    /// use embedded_raster::{Angle, Canvas, Ellipse, Framebuffer, Rect, Sector};
    /// let mut ram = [b'.'; 36];
    /// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 6, 6)?;
    /// let slice = Sector::new(Angle::degrees(-90), Angle::degrees(0));
    /// frame.fill_sector(Ellipse::in_box(Rect::new(0, 0, 6, 6)), slice, Gray8::new(b'#'));
    /// assert_eq!(&ram, b"...##....###...###..................");
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[inline]
    fn fill_sector(&mut self, ellipse: Ellipse, sector: Sector, color: Self::Color) {
        arc::fill(ellipse, sector, self.window(), |span| self.fill_span(span, color));
    }

    /// Fills what lies inside of `outer` and not inside of `inner`.
    #[inline]
    fn fill_ring(&mut self, outer: Ellipse, inner: Ellipse, color: Self::Color) {
        arc::ring(outer, inner, self.window(), |span| self.fill_span(span, color));
    }

    /// Fills a sector of a ring.
    #[inline]
    fn fill_ring_sector(&mut self, outer: Ellipse, inner: Ellipse, sector: Sector, color: Self::Color) {
        arc::ring_sector(outer, inner, sector, self.window(), |span| self.fill_span(span, color));
    }

    /// Fills a rectangle with rounded corners: see [`rounded`](crate::raster::rounded) for which pixels.
    /// ```
    /// use embedded_graphics_core::pixelcolor::Gray8;
    /// use embedded_raster::{Canvas, Framebuffer, Radii, Rect};
    /// let mut ram = [b'.'; 28];
    /// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 7, 4)?;
    /// frame.fill_rounded(Rect::new(0, 0, 7, 4), Radii { top_right: 0, ..Radii::all(2) }, Gray8::new(b'#'));
    /// assert_eq!(&ram, b".####################.#####.");
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[inline]
    fn fill_rounded(&mut self, area: Rect, radii: Radii, color: Self::Color) {
        // The rows between the corners at once.
        let (window, middle) = (self.window(), rounded::straight(area, radii));
        self.fill_area(middle, color);
        if let Some(corners) = rounded::corners(area, radii, window) {
            return fill_mirrored(self, corners, color);
        }
        for part in [Rect { y1: window.y1.min(middle.y0), ..window }, Rect { y0: window.y0.max(middle.y1), ..window }] {
            rounded::fill(area, radii, part, |span| self.fill_span(span, color));
        }
    }

    /// Draws the outline of a rectangle with rounded corners, one pixel wide.
    #[inline]
    fn draw_rounded(&mut self, area: Rect, radii: Radii, color: Self::Color) {
        rounded::outline(area, radii, self.window(), |span| self.fill_span(span, color));
    }

    /// Fills a polygon of one contour, closed by itself. `table` is scratch memory: see [`polygon::fill`].
    ///
    /// # Errors
    /// [`EdgeTableFull`] if a single row is crossed by more sides than `table` holds. Nothing is painted then.
    #[inline]
    fn fill_polygon(
        &mut self,
        outline: &[PointFx],
        rule: FillRule,
        table: &mut [EdgeSlot],
        color: Self::Color,
    ) -> Result<(), EdgeTableFull> {
        polygon::fill([outline], rule, self.window(), table, |span| self.fill_span(span, color))
    }

    /// Fills a polygon of many contours, such as a country with islands and lakes: see [`polygon::fill`].
    ///
    /// # Errors
    /// [`EdgeTableFull`] if a single row is crossed by more sides than `table` holds. Nothing is painted then.
    #[inline]
    fn fill_contours<C>(
        &mut self,
        contours: C,
        rule: FillRule,
        table: &mut [EdgeSlot],
        color: Self::Color,
    ) -> Result<(), EdgeTableFull>
    where
        Self: Sized,
        C: IntoIterator + Clone,
        C::Item: IntoIterator,
        <C::Item as IntoIterator>::Item: Borrow<PointFx>,
    {
        polygon::fill(contours, rule, self.window(), table, |span| self.fill_span(span, color))
    }

    /// Fills a path: see [`flatten`](crate::geom::flatten) for how its curves become lines.
    /// ```
    /// use embedded_raster::{buffer_bytes, Canvas, EdgeSlot, FillRule, Framebuffer, Index1, Path, PathSegment::*, PointFx};
    /// let mut ram = [0; buffer_bytes::<Index1>(16, 8)];
    /// let mut frame = Framebuffer::<Index1>::new(&mut ram, 16, 8)?;
    /// let arch = [MoveTo(PointFx::px(0, 8)), QuadraticTo(PointFx::px(8, -8), PointFx::px(16, 8))];
    /// frame.fill_path(Path::new(&arch), FillRule::NonZero, &mut [EdgeSlot::EMPTY; 8], Index1::MAX)?;
    /// let rows = [0b0000_0011_1100_0000_u16, 0b0000_0111_1110_0000, 0b0000_1111_1111_0000];
    /// assert_eq!(ram[..6], rows.map(u16::to_be_bytes).concat()[..]);
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`EdgeTableFull`] if a single row is crossed by more sides than `table` holds. Nothing is painted then.
    #[inline]
    fn fill_path(
        &mut self,
        path: Path<'_>,
        rule: FillRule,
        table: &mut [EdgeSlot],
        color: Self::Color,
    ) -> Result<(), EdgeTableFull> {
        let window = self.window();
        polygon::fill(path.contours_in(window), rule, window, table, |span| self.fill_span(span, color))
    }

    /// Draws the outline of a path, one pixel wide: see [`outline`](crate::raster::outline) for which pixels.
    #[inline]
    fn draw_path(&mut self, path: Path<'_>, color: Self::Color) {
        outline::draw(path, self.window(), |span| self.fill_span(span, color));
    }

    /// Draws a quadratic Bézier curve one pixel wide: start, control point, end.
    /// ```
    /// use embedded_graphics_core::geometry::Point;
    /// use embedded_raster::{buffer_bytes, Canvas, Framebuffer, Index1, PointFx};
    /// let mut ram = [0; buffer_bytes::<Index1>(16, 4)];
    /// let mut frame = Framebuffer::<Index1>::new(&mut ram, 16, 4)?;
    /// let [a, b] = [0, 15].map(|x| PointFx::centre_of(Point::new(x, 0)));
    /// frame.draw_quadratic([a, PointFx::px(8, 7), b], Index1::MAX);
    /// let rows = [0b1000_0000_0000_0001_u16, 0b0110_0000_0000_0110, 0b0001_1000_0001_1000, 0b0000_0111_1110_0000];
    /// assert_eq!(ram, rows.map(u16::to_be_bytes).concat()[..]);
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[inline]
    fn draw_quadratic(&mut self, [a, c, b]: [PointFx; 3], color: Self::Color) {
        self.draw_path(Path::new(&[PathSegment::MoveTo(a), PathSegment::QuadraticTo(c, b)]), color);
    }

    /// Draws a cubic Bézier curve one pixel wide: start, two control points, end.
    #[inline]
    fn draw_cubic(&mut self, [a, c, d, b]: [PointFx; 4], color: Self::Color) {
        self.draw_path(Path::new(&[PathSegment::MoveTo(a), PathSegment::CubicTo(c, d, b)]), color);
    }

    /// Draws the outline of a path with a width: see [`stroke`](crate::raster::stroke).
    ///
    /// # Errors
    /// [`EdgeTableFull`] if a single row is crossed by more sides than `table` holds. Nothing is painted then. Each
    /// piece of the stroke that a row meets takes two slots.
    #[inline]
    fn stroke_path<D: Dashing>(
        &mut self,
        path: Path<'_>,
        stroke: &Stroke<D>,
        table: &mut [EdgeSlot],
        color: Self::Color,
    ) -> Result<(), EdgeTableFull>
    where
        Self: Sized,
    {
        let window = self.window();
        let parts = stroke.of_path(path, window);
        polygon::fill(parts, FillRule::NonZero, window, table, |span| self.fill_span(span, color))
    }

    /// Draws lines with a width from each place to the next, and back to the first one if they are `closed`.
    ///
    /// # Errors
    /// As for [`stroke_path`](Self::stroke_path).
    #[inline]
    fn stroke_polyline<D: Dashing>(
        &mut self,
        places: &[PointFx],
        closed: bool,
        stroke: &Stroke<D>,
        table: &mut [EdgeSlot],
        color: Self::Color,
    ) -> Result<(), EdgeTableFull>
    where
        Self: Sized,
    {
        let window = self.window();
        let parts = stroke.of_polyline(places, closed, window);
        polygon::fill(parts, FillRule::NonZero, window, table, |span| self.fill_span(span, color))
    }

    /// Draws a line with a width, in pieces that turn the same way: see [`stroke`](crate::raster::stroke).
    ///
    /// # Errors
    /// As for [`stroke_path`](Self::stroke_path). A solid line takes 4 slots with butt caps, 12 with square ones.
    #[inline]
    fn stroke_line<D: Dashing>(
        &mut self,
        [a, b]: [PointFx; 2],
        stroke: &Stroke<D>,
        table: &mut [EdgeSlot],
        color: Self::Color,
    ) -> Result<(), EdgeTableFull>
    where
        Self: Sized,
    {
        self.stroke_polyline(&[a, b], false, stroke, table, color)
    }
}

impl<S: Surface + ?Sized> Canvas for S {}

/// Fills a disc or the corners of a rounded rectangle: two rows at a time, the middle one once.
#[inline(never)]
fn fill_mirrored<S: Surface + ?Sized>(surface: &mut S, disc: Disc, color: S::Color) {
    for [upper, lower] in disc {
        surface.fill_span(upper, color);
        if lower.y() != upper.y() {
            surface.fill_span(lower, color);
        }
    }
}

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
