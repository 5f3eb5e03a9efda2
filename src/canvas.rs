//! [`Canvas`]: shapes on surfaces, the everyday API.

mod antialias;
mod flood;
mod ink;
mod pictures;

use core::{borrow::Borrow, iter::once};

use embedded_graphics_core::geometry::Point;
use fixed::types::I24F8;

pub use self::{antialias::Antialias, pictures::Pictures};
use self::{flood::Area, ink::in_color};
use crate::{
    error::{EdgeTableFull, TriangleTooLarge},
    geom::{fill_rule::FillRule, Contours, PathSegment, PointFx, RoundCorners, Segments, Varying},
    paint::{along, depth, shade, Brush, DepthShade, Paint, Shade},
    pixel::PixelFormat,
    raster::{
        arc::{self, Sector},
        chord,
        ellipse::{self, Ellipse},
        flood::{self as pour, Connectivity, FloodSlot},
        gauge, line, line_fx, outline,
        polygon::{self, drop_out::DropOut, EdgeSlot},
        rectangle,
        rounded::{self, Align, Radii},
        stroke::{self, Dashing, Stroke},
        triangle,
    },
    span::{ClippedSpan, Rect},
    surface::{Depth, Frame, Layout, Readable, Rows, Surface},
};

/// Draws shapes on any [`Surface`]. What lies outside of its window is clipped; the pixels inside are those of the whole shape.
///
/// **Words.** `draw_` is a line one pixel wide, `fill_` the inside of a shape, `stroke_` a line with a width. `blit` copies a
/// picture.
///
/// **Pixels and places.** A method with a plain name takes pixels: a [`Point`] names one, and so do its column and row, `(x, y)`;
/// a [`Rect`] or a `Rectangle` of embedded-graphics is a box of them. The corners of a filled triangle or polygon are the centres
/// of these pixels. A method whose name ends in `_fx` takes places on the plane, to 1/256 of a pixel: a [`PointFx`], or a shape
/// made of such places, as [`Path`](crate::Path) and [`Ellipse`] are. It takes no pixels: whether the corner of a pixel is meant, as
/// [`PointFx::px`] has it, or its centre, as [`PointFx::from`] has it, makes half a pixel of difference, and the call shows it.
///
/// **Arguments.** First the shape, then options, then scratch memory, then the colour of all its pixels. Any other [`Paint`]
/// goes through [`paint`](Self::paint).
///
/// **Names.** A search in this documentation also finds methods by the names that they have in embedded-graphics, Adafruit GFX,
/// `TFT_eSPI`, u8g2 and LVGL: `fillRect`, `drawFastHLine`, `drawPixel`, `bitBlt`.
///
/// **Work.** A method costs what its function of [`raster`](crate::raster) costs, which is said there: it depends on what the window
/// shows and on how much is passed, not on how far a shape goes outside. Lines, polygons and outlines made of lines cost a line for
/// each corner. Blits and moves read and write once, at most, each pixel that lies in the window as well as in the picture.
///
/// Each method links only the code of its own shape. One that goes over a list of pixels is linked once for each kind of list:
/// of [`Point`]s, of `(x, y)`.
/// ```
/// use embedded_graphics_core::{geometry::Point, pixelcolor::Rgb565, prelude::RgbColor};
/// use embedded_raster::{buffer_bytes, Canvas, Framebuffer, PointFx};
/// let mut ram = [0; buffer_bytes::<Rgb565>(64, 48)];
/// let mut frame = Framebuffer::<Rgb565>::new(&mut ram, 64, 48)?;
/// frame.fill_triangle_fx([PointFx::px(32, 4), PointFx::px(60, 40), PointFx::px(6, 44)], Rgb565::RED);
/// frame.draw_line(Point::new(0, 0), Point::new(63, 47), Rgb565::WHITE);
/// frame.draw_line((0, 47), (63, 0), Rgb565::WHITE);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
pub trait Canvas: Surface {
    /// Draws a shape in any paint. It calls `draw` with the window and a [`Brush`], and `draw` passes both to a function of
    /// [`raster`](crate::raster). Most other methods do the same with a [`Solid`](crate::Solid) colour.
    /// ```
    /// use embedded_graphics_core::pixelcolor::Gray8;
    /// use embedded_raster::{raster::rectangle, Canvas, ClippedSpan, Framebuffer, Paint, Rect, Surface};
    ///
    /// /// Darker from left to right.
    /// struct Fade;
    ///
    /// impl<S: Surface<Color = Gray8>> Paint<S> for Fade {
    ///     fn span(&mut self, on: &mut S, span: ClippedSpan) {
    ///         on.write_span(span, |x| Gray8::new(255 - 10 * x as u8));
    ///     }
    /// }
    ///
    /// let mut ram = [0; 6];
    /// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 6, 1)?;
    /// frame.paint(Fade, |window, brush| rectangle::fill(Rect::new(1, 0, 4, 1), window, brush));
    /// assert_eq!(ram, [0, 245, 235, 225, 0, 0]);
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[inline(always)]
    fn paint<P: Paint<Self>, R>(&mut self, paint: P, draw: impl FnOnce(Rect, Brush<'_, Self, P>) -> R) -> R {
        draw(self.window(), Brush::new(self, paint))
    }

    /// Paints all pixels of the window.
    #[doc(alias("clear", "cls", "fillScreen", "fill_screen", "clearDisplay", "clearBuffer"))]
    #[inline]
    fn fill_window(&mut self, color: Self::Color) {
        self.fill_area(self.window(), color);
    }

    /// Paints a pixel.
    #[doc(alias("drawPixel", "draw_pixel", "setPixel", "set_pixel", "putPixel", "put_pixel"))]
    #[inline]
    fn draw_point(&mut self, at: impl Into<Point>, color: Self::Color) {
        self.set(at.into(), color);
    }

    /// Paints the pixel that contains a place.
    #[inline]
    fn draw_point_fx(&mut self, at: PointFx, color: Self::Color) {
        self.set(at.pixel(), color);
    }

    /// Draws a line one pixel wide, both ends included: see [`line`](crate::raster::line) for which pixels.
    #[doc(alias("drawLine", "line"))]
    #[inline]
    fn draw_line(&mut self, a: impl Into<Point>, b: impl Into<Point>, color: Self::Color) {
        let (a, b) = (a.into(), b.into());
        in_color(self, color, |window, brush| line::draw(a, b, window, brush));
    }

    /// Draws a line one pixel wide between two places: see [`line_fx`](crate::raster::line_fx) for which pixels. Between the centres
    /// of two pixels it is [`draw_line`](Self::draw_line).
    #[inline]
    fn draw_line_fx(&mut self, a: PointFx, b: PointFx, color: Self::Color) {
        in_color(self, color, |window, brush| line_fx::draw(a, b, window, brush));
    }

    /// Draws a line one pixel wide with colours that change from one end to the other: the pixels of
    /// [`draw_line_fx`](Self::draw_line_fx), each in what `color` makes of the values there. A value is the nearest one to the exact
    /// ratio along the line: see [`paint::along`](crate::paint::along).
    /// ```
    /// use embedded_graphics_core::pixelcolor::Gray8;
    /// use embedded_raster::{Canvas, Framebuffer, PointFx};
    /// let mut ram = [0; 12];
    /// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 4, 3)?;
    /// let ends = [(0, 0), (3, 2)].map(PointFx::from);
    /// frame.shade_line_fx(ends, [10, 70].map(Gray8::new), |gray| gray)?;
    /// assert_eq!(ram, [10, 0, 0, 0, 0, 30, 50, 0, 0, 0, 0, 70]);
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    ///
    /// # Errors
    /// If the box of the line is wider and higher, together, than
    /// [`Facet::MOST`](crate::geom::Facet::MOST) pixels. Then nothing is drawn.
    fn shade_line_fx<V: Varying>(
        &mut self,
        ends: [PointFx; 2],
        values: [V; 2],
        mut color: impl FnMut(V) -> Self::Color,
    ) -> Result<(), TriangleTooLarge>
    where
        Self: Sized,
    {
        along::parts(ends, values, self.window(), |plane, window| {
            let mut shade = Shade::new(plane, &mut color);
            line_fx::draw(ends[0], ends[1], window, |span: ClippedSpan| shade.row(self, span));
        })
    }

    /// [`shade_line_fx`](Self::shade_line_fx) of the pixels whose depth passes a test: see [`paint::depth`](crate::paint::depth). The
    /// ends have a depth and other values.
    ///
    /// Where `depth` has no pixel, nothing is painted.
    ///
    /// # Errors
    /// If the box of the line is wider and higher, together, than
    /// [`Facet::MOST`](crate::geom::Facet::MOST) pixels. Then nothing is drawn.
    fn depth_line_fx<M: AsMut<[u8]>, Z: Depth, V: Varying>(
        &mut self,
        ends: [PointFx; 2],
        values: [(Z::Number, V); 2],
        depth: &mut Frame<M, Rows<Z>>,
        passes: impl Fn(&Z::Number, &Z::Number) -> bool,
        mut color: impl FnMut(V) -> Self::Color,
    ) -> Result<(), TriangleTooLarge>
    where
        Self: Sized,
    {
        along::parts(ends, values, self.window().intersection(depth.window()), |plane, window| {
            let mut shade = DepthShade::new(depth, plane, &passes, |values, _| Some(color(values)));
            line_fx::draw(ends[0], ends[1], window, |span: ClippedSpan| shade.row(self, span));
        })
    }

    /// Draws lines from each point to the next. A point where two lines meet is painted twice, and a counter of pixels counts
    /// both.
    #[doc(alias("polyline", "Polyline", "drawPolyline"))]
    fn draw_polyline(&mut self, points: impl IntoIterator<Item: Into<Point>>, color: Self::Color)
    where
        Self: Sized,
    {
        let mut last = None;
        for point in points {
            let point = point.into();
            self.draw_line(last.unwrap_or(point), point, color);
            last = Some(point);
        }
    }

    /// Draws lines from each corner of a polygon to the next, and from the last one to the first. Corners are painted twice.
    /// ```
    /// use embedded_graphics_core::pixelcolor::Gray8;
    /// use embedded_raster::{Canvas, Framebuffer};
    /// let mut ram = [b'.'; 20];
    /// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 5, 4)?;
    /// frame.draw_polygon([(0, 0), (4, 0), (1, 3)], Gray8::new(b'#'));
    /// assert_eq!(&ram, b"######..#..##...#...");
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[doc(alias("drawPolygon"))]
    fn draw_polygon(&mut self, corners: impl IntoIterator<Item: Into<Point>>, color: Self::Color)
    where
        Self: Sized,
    {
        let mut corners = corners.into_iter().map(Into::<Point>::into);
        if let Some(first) = corners.next() {
            self.draw_polyline(once(first).chain(corners).chain(once(first)), color);
        }
    }

    /// Draws the outline of a triangle: lines between its corners.
    #[doc(alias("drawTriangle"))]
    #[inline]
    fn draw_triangle(&mut self, corners: [impl Into<Point>; 3], color: Self::Color) {
        let [a, b, c]: [Point; 3] = corners.map(Into::into);
        for (from, to) in [(a, b), (b, c), (c, a)] {
            self.draw_line(from, to, color);
        }
    }

    /// Draws the outline of a rectangle, one pixel wide, each pixel once.
    /// ```
    /// use embedded_graphics_core::pixelcolor::Gray8;
    /// use embedded_raster::{Canvas, Framebuffer, Rect};
    /// let mut ram = [b'.'; 20];
    /// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 5, 4)?;
    /// frame.draw_rectangle(Rect::new(1, 0, 5, 4), Gray8::new(b'#'));
    /// assert_eq!(&ram, b".####.#..#.#..#.####");
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[doc(alias("drawRect", "draw_rect", "drawFrame", "stroke_rect"))]
    #[inline]
    fn draw_rectangle(&mut self, area: impl Into<Rect>, color: Self::Color) {
        let area = area.into();
        in_color(self, color, |window, brush| rectangle::outline(area, window, brush));
    }

    /// Fills a rectangle of pixels. [`Rect::new`] takes its corners, [`Rect::with_size`] its first pixel and its size.
    ///
    /// One that is a pixel high is a horizontal line, and one that is a pixel wide a vertical one. [`draw_line`](Self::draw_line)
    /// draws the same pixels between two ends, and links the code of all lines.
    /// ```
    /// use embedded_graphics_core::{geometry::{Point, Size}, pixelcolor::Gray8};
    /// use embedded_raster::{Canvas, Framebuffer, Rect};
    /// let mut ram = [b'.'; 20];
    /// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 5, 4)?;
    /// frame.fill_rectangle(Rect::with_size(Point::new(1, 1), Size::new(3, 2)), Gray8::new(b'#'));
    /// frame.fill_rectangle(Rect::new(0, 3, 4, 4), Gray8::new(b'-')); // row 3, columns 0 to 3
    /// frame.fill_rectangle(Rect::new(4, 0, 5, 4), Gray8::new(b'|')); // column 4, rows 0 to 3
    /// assert_eq!(&ram, b"....|.###|.###|----|");
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[doc(alias(
        "fillRect",
        "fill_rect",
        "fill_solid",
        "drawBox",
        "rect",
        "hline",
        "vline",
        "h_line",
        "v_line",
        "drawHLine",
        "drawVLine",
        "drawFastHLine",
        "drawFastVLine",
        "draw_hline",
        "draw_vline"
    ))]
    #[inline]
    fn fill_rectangle(&mut self, area: impl Into<Rect>, color: Self::Color) {
        self.fill_area(area.into(), color);
    }

    /// Fills a rectangle given by two opposite corners: the pixels whose centres lie inside, those on the left and top
    /// sides included.
    #[inline]
    fn fill_rectangle_fx(&mut self, a: PointFx, b: PointFx, color: Self::Color) {
        self.fill_area(rectangle::pixels(a, b), color);
    }

    /// Fills the triangle between the centres of three pixels.
    #[doc(alias("fillTriangle"))]
    #[inline]
    fn fill_triangle(&mut self, corners: [impl Into<Point>; 3], color: Self::Color) {
        self.fill_triangle_fx(corners.map(|corner| PointFx::centre_of(corner.into())), color);
    }

    /// Fills a triangle: see [`triangle`](crate::raster::triangle) for which pixels.
    #[inline]
    fn fill_triangle_fx(&mut self, corners: [PointFx; 3], color: Self::Color) {
        in_color(self, color, |window, brush| triangle::fill(corners, window, brush));
    }

    /// Fills a triangle with colours that change from corner to corner: the pixels of
    /// [`fill_triangle_fx`](Self::fill_triangle_fx), each in what `color` makes of the values there.
    ///
    /// Values are numbers, colours, or several of them: see [`Varying`]. Each is the nearest one to the exact mean of the corners
    /// at the centre of the pixel.
    /// ```
    /// use embedded_graphics_core::pixelcolor::Gray8;
    /// use embedded_raster::{Canvas, Framebuffer, PointFx};
    /// let mut ram = [0; 15];
    /// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 5, 3)?;
    /// let corners = [PointFx::px(0, 0), PointFx::px(4, 0), PointFx::px(0, 4)];
    /// frame.shade_triangle_fx(corners, [0, 80, 0].map(Gray8::new), |gray| gray)?;
    /// assert_eq!(ram, [10, 30, 50, 0, 0, 10, 30, 0, 0, 0, 10, 0, 0, 0, 0]);
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    ///
    /// # Errors
    /// If the triangle is wider and higher, together, than
    /// [`Facet::MOST`](crate::geom::Facet::MOST) pixels. Then nothing is drawn.
    fn shade_triangle_fx<V: Varying>(
        &mut self,
        corners: [PointFx; 3],
        values: [V; 3],
        color: impl FnMut(V) -> Self::Color,
    ) -> Result<(), TriangleTooLarge>
    where
        Self: Sized,
    {
        shade::fill(self, corners, values, color)
    }

    /// [`shade_triangle_fx`](Self::shade_triangle_fx) of the pixels whose depth passes a test: see
    /// [`paint::depth`](crate::paint::depth). The corners have a depth and other values.
    ///
    /// Where `depth` has no pixel, nothing is painted.
    ///
    /// # Errors
    /// If the triangle is wider and higher, together, than
    /// [`Facet::MOST`](crate::geom::Facet::MOST) pixels. Then nothing is drawn.
    fn depth_triangle_fx<M: AsMut<[u8]>, Z: Depth, V: Varying>(
        &mut self,
        corners: [PointFx; 3],
        values: [(Z::Number, V); 3],
        depth: &mut Frame<M, Rows<Z>>,
        passes: impl Fn(&Z::Number, &Z::Number) -> bool,
        color: impl FnMut(V) -> Self::Color,
    ) -> Result<(), TriangleTooLarge>
    where
        Self: Sized,
    {
        depth::fill((self, depth), corners, values, passes, color)
    }

    /// Draws the outline, one pixel wide, of the ellipse in a box of pixels: see [`ellipse`](crate::raster::ellipse).
    #[doc(alias("circle", "drawCircle", "draw_circle", "drawEllipse"))]
    #[inline]
    fn draw_ellipse(&mut self, area: impl Into<Rect>, color: Self::Color) {
        let area = area.into();
        in_color(self, color, |window, brush| ellipse::outline(area, window, brush));
    }

    /// Fills the ellipse in a box of pixels, or the circle if that is a square: see [`ellipse`](crate::raster::ellipse).
    /// ```
    /// use embedded_graphics_core::pixelcolor::Gray8;
    /// use embedded_raster::{Canvas, Framebuffer, Rect};
    /// let mut ram = [b'.'; 20];
    /// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 5, 4)?;
    /// frame.fill_ellipse(Rect::new(0, 0, 5, 4), Gray8::new(b'#'));
    /// assert_eq!(&ram, b".###.##########.###.");
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[doc(alias("disc", "disk", "fillCircle", "fill_circle", "drawDisc", "fillEllipse", "drawFilledEllipse"))]
    #[inline]
    fn fill_ellipse(&mut self, area: impl Into<Rect>, color: Self::Color) {
        self.fill_ellipse_fx(Ellipse::in_box(area.into()), color);
    }

    /// Fills a circle or an ellipse: see [`ellipse`](crate::raster::ellipse) for which pixels.
    #[doc(alias("fillCircle", "fill_circle", "drawSpot", "fillSmoothCircle"))]
    #[inline]
    fn fill_ellipse_fx(&mut self, ellipse: Ellipse, color: Self::Color) {
        in_color(self, color, |window, brush| ellipse::fill(ellipse, window, brush));
    }

    /// Fills what [`draw_ellipse`](Self::draw_ellipse) encloses, the outline included. To have both in two colours, call this
    /// first and draw the outline over it.
    #[inline]
    fn fill_outlined_ellipse(&mut self, area: impl Into<Rect>, color: Self::Color) {
        let area = area.into();
        in_color(self, color, |window, brush| ellipse::enclosed(area, window, brush));
    }

    /// Paints a round point of any diameter: the pixels whose centres lie inside of the circle. Of a diameter in whole pixels
    /// [`px`](crate::px) makes what is asked for.
    #[inline]
    fn fill_round_point_fx(&mut self, at: PointFx, size: I24F8, color: Self::Color) {
        self.fill_ellipse_fx(Ellipse::splat(at, size), color);
    }

    /// Paints a square point of any size: the pixels whose centres lie inside, those on the left and top sides included. Of a
    /// size in whole pixels [`px`](crate::px) makes what is asked for.
    /// ```
    /// use embedded_graphics_core::{geometry::Point, pixelcolor::Gray8};
    /// use embedded_raster::{px, Canvas, Framebuffer};
    /// let mut ram = [b'.'; 20];
    /// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 5, 4)?;
    /// frame.fill_square_point_fx(Point::new(1, 1).into(), px(3), Gray8::new(b'#'));
    /// assert_eq!(&ram, b"###..###..###.......");
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[inline]
    fn fill_square_point_fx(&mut self, at: PointFx, size: I24F8, color: Self::Color) {
        self.fill_area(ellipse::square(at, size), color);
    }

    /// Draws the part of the outline of the ellipse in a box that lies in a sector: see [`arc`](crate::raster::arc).
    #[doc(alias("arc", "drawArc", "lv_draw_arc"))]
    #[inline]
    fn draw_arc(&mut self, area: impl Into<Rect>, sector: Sector, color: Self::Color) {
        let area = area.into();
        in_color(self, color, |window, brush| arc::outline(area, sector, window, brush));
    }

    /// Fills a sector of the ellipse in a box, a slice of a pie.
    /// ```
    /// use embedded_graphics_core::pixelcolor::Gray8;
    /// use embedded_raster::{Angle, Canvas, Framebuffer, Rect, Sector};
    /// let mut ram = [b'.'; 36];
    /// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 6, 6)?;
    /// let slice = Sector::new(Angle::degrees(-90), Angle::degrees(0));
    /// frame.fill_sector(Rect::new(0, 0, 6, 6), slice, Gray8::new(b'#'));
    /// assert_eq!(&ram, b"...##....###...###..................");
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[doc(alias("pie", "slice", "fillArc"))]
    #[inline]
    fn fill_sector(&mut self, area: impl Into<Rect>, sector: Sector, color: Self::Color) {
        self.fill_sector_fx(Ellipse::in_box(area.into()), sector, color);
    }

    /// Fills a sector of an ellipse.
    #[inline]
    fn fill_sector_fx(&mut self, ellipse: Ellipse, sector: Sector, color: Self::Color) {
        in_color(self, color, |window, brush| arc::fill(ellipse, sector, window, brush));
    }

    /// Fills a ring: the pixels of the ellipse in the box `outer` that are not pixels of the ellipse in the box `inner`.
    #[doc(alias("annulus", "donut", "doughnut"))]
    #[inline]
    fn fill_ring(&mut self, outer: impl Into<Rect>, inner: impl Into<Rect>, color: Self::Color) {
        self.fill_ring_fx(Ellipse::in_box(outer.into()), Ellipse::in_box(inner.into()), color);
    }

    /// Fills a ring: the pixels of the ellipse `outer` that are not pixels of `inner`.
    #[inline]
    fn fill_ring_fx(&mut self, outer: Ellipse, inner: Ellipse, color: Self::Color) {
        in_color(self, color, |window, brush| arc::ring(outer, inner, window, brush));
    }

    /// Fills the part of a ring that lies in a sector, as seen from the centre of the box `outer`.
    #[doc(alias("gauge", "drawArc", "drawSmoothArc", "lv_draw_arc"))]
    #[inline]
    fn fill_ring_sector(&mut self, outer: impl Into<Rect>, inner: impl Into<Rect>, sector: Sector, color: Self::Color) {
        self.fill_ring_sector_fx(Ellipse::in_box(outer.into()), Ellipse::in_box(inner.into()), sector, color);
    }

    /// Fills the part of a ring that lies in a sector, as seen from the centre of `outer`.
    #[inline]
    fn fill_ring_sector_fx(&mut self, outer: Ellipse, inner: Ellipse, sector: Sector, color: Self::Color) {
        in_color(self, color, |window, brush| arc::ring_sector(outer, inner, sector, window, brush));
    }

    /// Fills the part of a ring that lies in a sector, with round ends: see [`gauge`](crate::raster::gauge).
    /// ```
    /// use embedded_graphics_core::pixelcolor::Gray8;
    /// use embedded_raster::{Angle, Canvas, Framebuffer, Rect, Sector};
    /// let mut ram = [b'.'; 12 * 9];
    /// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 12, 9)?;
    /// let upper_half = Sector::new(Angle::degrees(180), Angle::degrees(0));
    /// frame.fill_gauge(Rect::new(0, 0, 12, 12), Rect::new(4, 4, 8, 8), upper_half, Gray8::new(b'#'));
    /// let rows = [
    ///     "....####....", "..########..", ".##########.", ".##########.", "#####..#####", "####....####", "####....####",
    ///     ".##......##.", "............",
    /// ];
    /// assert_eq!(std::str::from_utf8(&ram), Ok(&*rows.concat()));
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[doc(alias("gauge", "drawSmoothArc", "lv_draw_arc", "rounded_arc"))]
    #[inline]
    fn fill_gauge(&mut self, outer: impl Into<Rect>, inner: impl Into<Rect>, sector: Sector, color: Self::Color) {
        self.fill_gauge_fx(Ellipse::in_box(outer.into()), Ellipse::in_box(inner.into()), sector, color);
    }

    /// Fills the part of a ring that lies in a sector, with round ends.
    #[inline]
    fn fill_gauge_fx(&mut self, outer: Ellipse, inner: Ellipse, sector: Sector, color: Self::Color) {
        in_color(self, color, |window, brush| gauge::fill(outer, inner, sector, window, brush));
    }

    /// Fills a segment of the ellipse in a box: what the chord between the ends of a sector's arc cuts off. See
    /// [`chord`](crate::raster::chord).
    /// ```
    /// use embedded_graphics_core::pixelcolor::Gray8;
    /// use embedded_raster::{Angle, Canvas, Framebuffer, Rect, Sector};
    /// let mut ram = [b'.'; 36];
    /// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 6, 6)?;
    /// let bowl = Sector::new(Angle::degrees(20), Angle::degrees(160));
    /// frame.fill_chord(Rect::new(0, 0, 6, 6), bowl, Gray8::new(b'#'));
    /// assert_eq!(&ram, b"........................######.####.");
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[doc(alias("segment", "chord"))]
    #[inline]
    fn fill_chord(&mut self, area: impl Into<Rect>, sector: Sector, color: Self::Color) {
        self.fill_chord_fx(Ellipse::in_box(area.into()), sector, color);
    }

    /// Fills a segment of an ellipse.
    #[inline]
    fn fill_chord_fx(&mut self, ellipse: Ellipse, sector: Sector, color: Self::Color) {
        in_color(self, color, |window, brush| chord::fill(ellipse, sector, window, brush));
    }

    /// Draws the outline of a rectangle with rounded corners, one pixel wide.
    #[doc(alias("drawRoundRect", "drawRFrame", "rounded_rectangle", "RoundedRectangle"))]
    #[inline]
    fn draw_rounded(&mut self, area: impl Into<Rect>, radii: Radii, color: Self::Color) {
        let area = area.into();
        in_color(self, color, |window, brush| rounded::outline(area, radii, window, brush));
    }

    /// Fills a rectangle with rounded corners: see [`rounded`](crate::raster::rounded) for which pixels. Under an outline that is drawn by
    /// [`draw_rounded`](Self::draw_rounded), [`fill_outlined_rounded`](Self::fill_outlined_rounded) fills what that encloses.
    /// ```
    /// use embedded_graphics_core::pixelcolor::Gray8;
    /// use embedded_raster::{Canvas, Framebuffer, Radii, Rect};
    /// let mut ram = [b'.'; 28];
    /// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 7, 4)?;
    /// frame.fill_rounded(Rect::new(0, 0, 7, 4), Radii { top_right: 0, ..Radii::all(2) }, Gray8::new(b'#'));
    /// assert_eq!(&ram, b".####################.#####.");
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[doc(alias("fillRoundRect", "drawRBox", "rounded_rectangle", "RoundedRectangle", "fillSmoothRoundRect"))]
    #[inline]
    fn fill_rounded(&mut self, area: impl Into<Rect>, radii: Radii, color: Self::Color) {
        let area = area.into();
        in_color(self, color, |window, brush| rounded::fill(area, radii, window, brush));
    }

    /// Fills what [`draw_rounded`](Self::draw_rounded) encloses, the outline included. To have both in two colours, call this first
    /// and draw the outline over it.
    #[inline]
    fn fill_outlined_rounded(&mut self, area: impl Into<Rect>, radii: Radii, color: Self::Color) {
        let area = area.into();
        in_color(self, color, |window, brush| rounded::enclosed(area, radii, window, brush));
    }

    /// Draws a border of a rectangle with rounded corners, so many pixels wide: inside of it, around it, or half and half.
    #[inline]
    fn stroke_rounded(&mut self, area: impl Into<Rect>, radii: Radii, width: u32, align: Align, color: Self::Color) {
        let area = area.into();
        in_color(self, color, |window, brush| rounded::border(area, radii, width, align, window, brush));
    }

    /// Draws the ellipse in a box of pixels, or the circle if that is a square, with a line so many pixels wide: inside of the box,
    /// around it, or half and half.
    /// ```
    /// use embedded_graphics_core::pixelcolor::Gray8;
    /// use embedded_raster::{Align, Canvas, Framebuffer, Rect};
    /// let mut ram = [b'.'; 36];
    /// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 6, 6)?;
    /// frame.stroke_ellipse(Rect::new(0, 0, 6, 6), 2, Align::Inside, Gray8::new(b'#'));
    /// assert_eq!(&ram, b".####.########..####..########.####.");
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[inline]
    fn stroke_ellipse(&mut self, area: impl Into<Rect>, width: u32, align: Align, color: Self::Color) {
        let [outer, inner] = align.boxes(area.into(), width);
        self.fill_ring(outer, inner, color);
    }

    /// Draws the part of an ellipse that lies in a sector, with a line so many pixels wide: see
    /// [`stroke_ellipse`](Self::stroke_ellipse).
    #[doc(alias("gauge", "drawArc", "lv_draw_arc"))]
    #[inline]
    fn stroke_arc(&mut self, area: impl Into<Rect>, sector: Sector, width: u32, align: Align, color: Self::Color) {
        let [outer, inner] = align.boxes(area.into(), width);
        self.fill_ring_sector(outer, inner, sector, color);
    }

    /// Draws the part of an ellipse that lies in a sector, with a line so many pixels wide and round ends: see
    /// [`stroke_ellipse`](Self::stroke_ellipse) and [`gauge`](crate::raster::gauge).
    #[doc(alias("gauge", "drawSmoothArc", "rounded_arc"))]
    #[inline]
    fn stroke_round_arc(
        &mut self,
        area: impl Into<Rect>,
        sector: Sector,
        width: u32,
        align: Align,
        color: Self::Color,
    ) {
        let [outer, inner] = align.boxes(area.into(), width);
        self.fill_gauge(outer, inner, sector, color);
    }

    /// Draws the arc of an ellipse, by its centre and radii, that lies in a sector, with any width, caps and dashes: half of the width
    /// on either side of the curve. See [`arc::stroke`](crate::raster::arc::stroke).
    ///
    /// A whole turn is a closed ellipse: so this draws dashed circles too.
    ///
    /// # Errors
    /// As for [`stroke_path_fx`](Self::stroke_path_fx).
    #[doc(alias("dashed_circle", "drawSmoothArc", "arc"))]
    #[inline]
    fn stroke_arc_fx<D: Dashing>(
        &mut self,
        centre: PointFx,
        radii: [I24F8; 2],
        sector: Sector,
        stroke: &Stroke<D>,
        table: &mut [EdgeSlot],
        color: Self::Color,
    ) -> Result<(), EdgeTableFull>
    where
        Self: Sized,
    {
        self.stroke_path_fx(arc::path(centre, radii, sector), stroke, table, color)
    }

    /// Fills the polygon whose corners are the centres of these pixels; its last corner is joined to the first. `table` is
    /// scratch memory: see [`polygon::fill`].
    ///
    /// # Errors
    /// [`EdgeTableFull`] if a single row is crossed by more sides than `table` holds. Nothing is painted then.
    #[doc(alias("fillPolygon", "polygon"))]
    #[inline]
    fn fill_polygon(
        &mut self,
        corners: &[impl Into<Point> + Copy],
        rule: FillRule,
        table: &mut [EdgeSlot],
        color: Self::Color,
    ) -> Result<(), EdgeTableFull> {
        let places = corners.iter().map(|&corner| PointFx::centre_of(corner.into()));
        in_color(self, color, |window, brush| polygon::fill([places], rule, table, window, brush))
    }

    /// Fills a polygon of one contour, whose last vertex is joined to the first.
    ///
    /// # Errors
    /// As for [`fill_polygon`](Self::fill_polygon).
    #[inline]
    fn fill_polygon_fx(
        &mut self,
        contour: &[PointFx],
        rule: FillRule,
        table: &mut [EdgeSlot],
        color: Self::Color,
    ) -> Result<(), EdgeTableFull> {
        in_color(self, color, |window, brush| polygon::fill([contour], rule, table, window, brush))
    }

    /// Fills a polygon of many contours, such as a country with islands and lakes: see [`polygon::fill`].
    ///
    /// # Errors
    /// As for [`fill_polygon`](Self::fill_polygon).
    #[inline]
    fn fill_contours_fx<C>(
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
        in_color(self, color, |window, brush| polygon::fill(contours, rule, table, window, brush))
    }

    /// Draws the outline of a path, one pixel wide: see [`outline`](crate::raster::outline) for which pixels.
    #[inline]
    fn draw_path_fx(&mut self, path: impl IntoIterator<IntoIter = impl Segments>, color: Self::Color) {
        in_color(self, color, |window, brush| outline::draw(path, window, brush));
    }

    /// Fills a path: see [`flatten`](crate::geom::flatten) for how its curves become lines.
    /// ```
    /// use embedded_raster::{buffer_bytes, Canvas, EdgeSlot, FillRule, Framebuffer, Index1, Path, PathSegment::*, PointFx};
    /// let mut ram = [0; buffer_bytes::<Index1>(16, 8)];
    /// let mut frame = Framebuffer::<Index1>::new(&mut ram, 16, 8)?;
    /// let arch = [MoveTo(PointFx::px(0, 8)), QuadraticTo(PointFx::px(8, -8), PointFx::px(16, 8))];
    /// frame.fill_path_fx(Path::new(&arch), FillRule::NonZero, &mut [EdgeSlot::EMPTY; 8], Index1::MAX)?;
    /// let rows = [0b0000_0011_1100_0000_u16, 0b0000_0111_1110_0000, 0b0000_1111_1111_0000];
    /// assert_eq!(ram[..6], rows.map(u16::to_be_bytes).concat()[..]);
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`fill_polygon`](Self::fill_polygon).
    #[inline]
    fn fill_path_fx(
        &mut self,
        path: impl IntoIterator<IntoIter = impl Segments>,
        rule: FillRule,
        table: &mut [EdgeSlot],
        color: Self::Color,
    ) -> Result<(), EdgeTableFull> {
        in_color(self, color, |window, brush| polygon::fill(Contours::within(path, window), rule, table, window, brush))
    }

    /// Fills a path with drop-out control: what is too thin to hold the centre of a pixel is drawn all the same. See
    /// [`drop_out`](polygon::drop_out) for which pixels.
    ///
    /// # Errors
    /// As for [`fill_polygon`](Self::fill_polygon), and also if too many sides cross a single column.
    #[inline]
    fn fill_path_drop_out_fx(
        &mut self,
        path: impl IntoIterator<IntoIter = impl Segments>,
        rule: FillRule,
        drop_out: DropOut,
        table: &mut [EdgeSlot],
        color: Self::Color,
    ) -> Result<(), EdgeTableFull> {
        in_color(self, color, |window, brush| {
            let contours = Contours::within(path, window.inset(-1));
            polygon::drop_out::fill(contours, rule, drop_out, table, window, brush)
        })
    }

    /// Draws a quadratic Bézier curve one pixel wide: start, control point, end.
    /// ```
    /// use embedded_graphics_core::geometry::Point;
    /// use embedded_raster::{buffer_bytes, Canvas, Framebuffer, Index1, PointFx};
    /// let mut ram = [0; buffer_bytes::<Index1>(16, 4)];
    /// let mut frame = Framebuffer::<Index1>::new(&mut ram, 16, 4)?;
    /// let [a, b] = [0, 15].map(|x| PointFx::centre_of(Point::new(x, 0)));
    /// frame.draw_quadratic_fx([a, PointFx::px(8, 7), b], Index1::MAX);
    /// let rows = [0b1000_0000_0000_0001_u16, 0b0110_0000_0000_0110, 0b0001_1000_0001_1000, 0b0000_0111_1110_0000];
    /// assert_eq!(ram, rows.map(u16::to_be_bytes).concat()[..]);
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[doc(alias("bezier", "curve"))]
    #[inline]
    fn draw_quadratic_fx(&mut self, [a, c, b]: [PointFx; 3], color: Self::Color) {
        self.draw_path_fx([PathSegment::MoveTo(a), PathSegment::QuadraticTo(c, b)], color);
    }

    /// Draws a cubic Bézier curve one pixel wide: start, two control points, end.
    #[doc(alias("bezier", "curve", "spline"))]
    #[inline]
    fn draw_cubic_fx(&mut self, [a, c, d, b]: [PointFx; 4], color: Self::Color) {
        self.draw_path_fx([PathSegment::MoveTo(a), PathSegment::CubicTo(c, d, b)], color);
    }

    /// Draws the outline of a path with a width: see [`stroke`](crate::raster::stroke).
    ///
    /// # Errors
    /// [`EdgeTableFull`] if a single row is crossed by more sides than `table` holds. Nothing is painted then. Each line of the
    /// stroke's [border](crate::raster::stroke::border) that a row meets takes a slot.
    #[inline]
    fn stroke_path_fx<D: Dashing>(
        &mut self,
        path: impl IntoIterator<IntoIter = impl Segments>,
        stroke: &Stroke<D>,
        table: &mut [EdgeSlot],
        color: Self::Color,
    ) -> Result<(), EdgeTableFull>
    where
        Self: Sized,
    {
        in_color(self, color, |window, brush| stroke::fill(path, stroke, table, window, brush))
    }

    /// Draws lines with a width from each place to the next, and back to the first one if they are `closed`.
    ///
    /// # Errors
    /// As for [`stroke_path_fx`](Self::stroke_path_fx).
    #[inline]
    fn stroke_polyline_fx<D: Dashing>(
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
        in_color(self, color, |window, brush| stroke::fill_polyline(places, closed, stroke, table, window, brush))
    }

    /// Draws lines with a width whose corners are pieces of circles of this radius: see [`corners`](crate::geom::corners). One pixel
    /// wide they are `draw_path_fx(RoundCorners::new(places, closed, radius), color)`.
    ///
    /// # Errors
    /// As for [`stroke_path_fx`](Self::stroke_path_fx).
    #[inline]
    fn stroke_round_polyline_fx<D: Dashing>(
        &mut self,
        places: &[PointFx],
        closed: bool,
        radius: I24F8,
        stroke: &Stroke<D>,
        table: &mut [EdgeSlot],
        color: Self::Color,
    ) -> Result<(), EdgeTableFull>
    where
        Self: Sized,
    {
        self.stroke_path_fx(RoundCorners::new(places, closed, radius), stroke, table, color)
    }

    /// Fills a polygon whose corners are pieces of circles of this radius: see [`corners`](crate::geom::corners).
    ///
    /// # Errors
    /// As for [`fill_polygon`](Self::fill_polygon).
    #[inline]
    fn fill_round_polygon_fx(
        &mut self,
        contour: &[PointFx],
        radius: I24F8,
        rule: FillRule,
        table: &mut [EdgeSlot],
        color: Self::Color,
    ) -> Result<(), EdgeTableFull> {
        self.fill_path_fx(RoundCorners::new(contour, true, radius), rule, table, color)
    }

    /// Draws a line with a width: see [`stroke`](crate::raster::stroke) for which pixels.
    ///
    /// # Errors
    /// As for [`stroke_path_fx`](Self::stroke_path_fx). A solid line with butt caps takes none, or 4 if this is built for size; with
    /// square ones it takes 8.
    #[doc(alias("thick_line", "wide_line", "drawThickLine", "drawWideLine", "dashed_line", "stroke_width"))]
    #[inline]
    fn stroke_line_fx<D: Dashing>(
        &mut self,
        [a, b]: [PointFx; 2],
        stroke: &Stroke<D>,
        table: &mut [EdgeSlot],
        color: Self::Color,
    ) -> Result<(), EdgeTableFull>
    where
        Self: Sized,
    {
        self.stroke_polyline_fx(&[a, b], false, stroke, table, color)
    }

    /// Copies a picture so that its top left pixel falls on `at`. What lies outside is clipped. The picture may have any
    /// layout, with colours of the same type; a view of one may start at any pixel, even within a byte.
    #[doc(alias(
        "bitBlt",
        "bitblt",
        "drawRGBBitmap",
        "pushImage",
        "draw_image",
        "drawImage",
        "lv_draw_image",
        "sprite"
    ))]
    #[inline]
    fn blit<M, L>(&mut self, at: impl Into<Point>, picture: &Frame<M, L>)
    where
        Self: Sized,
        M: AsRef<[u8]>,
        L: Layout<Color = Self::Color>,
    {
        self.copy_picture(at.into(), picture, None);
    }

    /// [`blit`](Self::blit), but pixels of the colour `key` are transparent.
    #[doc(alias("transparent", "color_key", "pushToSprite", "pushImage", "sprite"))]
    #[inline]
    fn blit_keyed<M, L>(&mut self, at: impl Into<Point>, picture: &Frame<M, L>, key: Self::Color)
    where
        Self: Sized,
        M: AsRef<[u8]>,
        L: Layout<Color = Self::Color>,
    {
        self.copy_picture(at.into(), picture, Some(key));
    }

    /// Paints a picture of one bit per pixel: a set bit in the colour `on`, any other in the colour `off`, or not at all if
    /// `off` is `None`. Glyphs and icons are such pictures. What lies outside is clipped.
    /// ```
    /// use embedded_graphics_core::{geometry::Point, pixelcolor::BinaryColor};
    /// use embedded_raster::{Bitmap, Canvas, Framebuffer, Index4};
    /// let arrow = Bitmap::<BinaryColor>::new(&[0b0100_0000, 0b1110_0000], 3, 2)?;
    /// let mut ram = [0; 2 * 2];
    /// let mut frame = Framebuffer::<Index4>::new(&mut ram, 4, 2)?;
    /// frame.blit_mask(Point::new(1, 0), &arrow, Index4::new(9), None);
    /// assert_eq!(ram, [0x00, 0x90, 0x09, 0x99]);
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[doc(alias("drawBitmap", "drawXBitmap", "drawXBM", "draw_glyph", "drawChar", "icon"))]
    #[inline]
    fn blit_mask<M, F>(
        &mut self,
        at: impl Into<Point>,
        mask: &Frame<M, Rows<F>>,
        on: Self::Color,
        off: impl Into<Option<Self::Color>>,
    ) where
        Self: Sized,
        M: AsRef<[u8]>,
        F: PixelFormat,
    {
        const { assert!(F::BITS == 1, "a mask has one bit per pixel") };
        self.copy_mask(at.into(), mask, on, off.into());
    }

    /// Copies the pixels of `area` so that the top left one falls on `to`. Both areas may overlap. Pixels that nothing is copied
    /// to keep their colours; pixels that lie outside of the window, before or after, are left out. To scroll up by one row,
    /// move the whole window to `Point::new(0, -1)`. A [view](crate::Frame::view) of the region that scrolls keeps what is around it.
    /// ```
    /// use embedded_graphics_core::pixelcolor::Gray8;
    /// use embedded_raster::{Canvas, Framebuffer, Rect, Surface};
    /// let mut ram = *b"+--++aa++bb++cc++--+";
    /// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 4, 5)?;
    /// let mut list = frame.view(Rect::new(1, 1, 3, 4));
    /// list.move_area(list.window(), (0, -1));
    /// list.fill_rectangle(Rect::new(0, 2, 2, 3), Gray8::new(b'd'));
    /// assert_eq!(&ram, b"+--++bb++cc++dd++--+");
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[doc(alias("scroll", "copy_rect", "copyRect"))]
    #[inline]
    fn move_area(&mut self, area: impl Into<Rect>, to: impl Into<Point>)
    where
        Self: Readable,
    {
        self.copy_area(area.into(), to.into(), None);
    }

    /// [`move_area`](Self::move_area), but pixels of the colour `key` are not copied.
    #[inline]
    fn move_area_keyed(&mut self, area: impl Into<Rect>, to: impl Into<Point>, key: Self::Color)
    where
        Self: Readable,
    {
        self.copy_area(area.into(), to.into(), Some(key));
    }

    /// Paints the pixels of the seed's colour that are connected with it. Nothing is painted if the seed lies outside of the
    /// window, or has the new colour already.
    ///
    /// `table` is scratch memory of any length; what it holds does not matter. Returns how many slots the fill wanted. If
    /// that is more than `table` has, the fill took longer and painted the same. See [`flood`](crate::raster::flood).
    /// ```
    /// use embedded_graphics_core::{geometry::Point, pixelcolor::BinaryColor};
    /// use embedded_raster::{raster::flood::{Connectivity, FloodSlot}, Canvas, Framebuffer};
    /// let mut ram = [0b0010_0000, 0b0101_0000, 0b0010_0000];
    /// let mut frame = Framebuffer::<BinaryColor>::new(&mut ram, 8, 3)?;
    /// frame.flood_fill(Point::new(0, 0), Connectivity::Sides, &mut [FloodSlot::EMPTY; 8], BinaryColor::On);
    /// assert_eq!(ram, [0b1110_0000, 0b1101_0000, 0b1110_0000]);
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[doc(alias("floodFill", "bucket", "seed_fill"))]
    fn flood_fill(
        &mut self,
        seed: impl Into<Point>,
        connectivity: Connectivity,
        table: &mut [FloodSlot],
        color: Self::Color,
    ) -> usize
    where
        Self: Readable + Sized,
    {
        let seed = seed.into();
        let Some(old) = self.get(seed).filter(|&old| old != color) else { return 0 };
        let mut area = Area { surface: self, color, is_open: |pixel| pixel == old };
        pour::fill(&mut area, seed, connectivity, table)
    }

    /// Paints the pixels of any colour that are connected with the seed, up to pixels of the colour `boundary`. Pixels that
    /// have the new colour already are a boundary too, as nothing tells them from pixels that were painted.
    ///
    /// `table` and the result are as for [`flood_fill`](Self::flood_fill).
    #[doc(alias("boundary_fill", "floodFill"))]
    fn flood_fill_to(
        &mut self,
        seed: impl Into<Point>,
        boundary: Self::Color,
        connectivity: Connectivity,
        table: &mut [FloodSlot],
        color: Self::Color,
    ) -> usize
    where
        Self: Readable + Sized,
    {
        let mut area = Area { surface: self, color, is_open: |pixel| pixel != boundary && pixel != color };
        pour::fill(&mut area, seed.into(), connectivity, table)
    }
}

impl<S: Surface + ?Sized> Canvas for S {}
