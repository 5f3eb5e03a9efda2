//! [`Antialias`]: shapes with soft rims on surfaces, one line each, as in `canvas.rs`: the shape from [`coverage`], a paint, and the
//! surface.

use core::borrow::Borrow;

use embedded_graphics_core::geometry::Point;

use crate::{
    error::EdgeTableFull,
    geom::{fill_rule::FillRule, flatten::Segments, PointFx},
    paint::{Brush, Paint},
    pixel::PixelFormat,
    raster::{
        arc::Sector,
        coverage::{self, CoverageSlot},
        ellipse::Ellipse,
        rounded::Radii,
        stroke::{Dashing, Stroke},
    },
    span::Rect,
    surface::{Frame, Layout, Surface},
};

/// Draws shapes with soft rims on any [`Surface`]: antialiasing. Each pixel is painted by how much of it the shape covers: see
/// [`coverage`](crate::raster::coverage).
///
/// **Words** are those of [`Canvas`](crate::Canvas). All methods take places, to 1/256 of a pixel, as those do whose names end in
/// `_fx`; these end in `_aa`.
///
/// **Arguments.** First the shape, then options, then scratch memory for sides and for cells, then the [`Paint`], which says what
/// becomes of a pixel that is covered in part:
///
/// | paint | on | a pixel that is covered in part |
/// |---|---|---|
/// | [`Cover`](crate::paint::Cover), [`Alpha`](crate::paint::Alpha) | surfaces that can be read | is mixed with what is there |
/// | [`Over`](crate::paint::Over) | any surface | is mixed with a background of one colour |
/// | [`Ramp`](crate::paint::Ramp) | any surface; indices | gets a colour between shape and background, found beforehand |
/// | [`CoverIndex`](crate::paint::CoverIndex) | indices that can be read | gets the nearest entry of the palette |
/// | [`Dithered`](crate::paint::Dithered) | any surface; one bit | is painted or not, as many of a block as are covered of it |
/// | [`Solid`](crate::Solid), and any other | any surface | is painted if half of it is covered |
/// | [`Masked`](crate::paint::Masked) | as the paint behind it | is painted by that, as far as a mask lets it through |
///
/// **Memory.** `cells` may have any length, even 0: [`coverage::cells`] says how many let a row be drawn at once.
/// ```
/// use embedded_graphics_core::{pixelcolor::Rgb565, prelude::RgbColor};
/// use embedded_raster::{
///     buffer_bytes, paint::Cover, px, raster::coverage, Antialias, CoverageSlot, Ellipse, FillRule, Framebuffer, PointFx,
/// };
/// let mut ram = [0; buffer_bytes::<Rgb565>(64, 48)];
/// let mut frame = Framebuffer::<Rgb565>::new(&mut ram, 64, 48)?;
/// frame.fill_ellipse_aa(Ellipse::circle(PointFx::px(32, 24), px(20)), Cover(Rgb565::RED));
/// let (mut table, mut cells) = ([CoverageSlot::EMPTY; 16], [0; coverage::cells(64)]);
/// let kite = [(32, 8), (40, 24), (32, 40), (24, 24)].map(|(x, y)| PointFx::px(x, y));
/// frame.fill_polygon_aa(&kite, FillRule::NonZero, &mut table, &mut cells, Cover(Rgb565::WHITE))?;
/// # Ok::<(), embedded_raster::Error>(())
/// ```
pub trait Antialias: Surface {
    /// Draws a line one pixel wide from one place to another, as bright at any angle: see [`coverage::line`].
    #[doc(alias("drawSmoothLine", "anti_aliased_line"))]
    #[inline]
    fn draw_line_aa(&mut self, a: PointFx, b: PointFx, paint: impl Paint<Self>) {
        coverage::line(a, b, self.window(), Brush::new(self, paint));
    }

    /// Fills a rectangle given by two opposite corners.
    #[inline]
    fn fill_rectangle_aa(&mut self, a: PointFx, b: PointFx, paint: impl Paint<Self>) {
        coverage::rectangle(a, b, self.window(), Brush::new(self, paint));
    }

    /// Fills a triangle.
    #[inline]
    fn fill_triangle_aa(&mut self, corners: [PointFx; 3], cells: &mut [i32], paint: impl Paint<Self>) {
        coverage::triangle(corners, cells, self.window(), Brush::new(self, paint));
    }

    /// Fills a polygon of one contour, whose last vertex is joined to the first: see [`coverage::fill`].
    ///
    /// # Errors
    /// [`EdgeTableFull`] if a single row is touched by more sides than `table` holds. Nothing is painted then.
    #[inline]
    fn fill_polygon_aa(
        &mut self,
        contour: &[PointFx],
        rule: FillRule,
        table: &mut [CoverageSlot],
        cells: &mut [i32],
        paint: impl Paint<Self>,
    ) -> Result<(), EdgeTableFull> {
        coverage::fill([contour], rule, table, cells, self.window(), Brush::new(self, paint))
    }

    /// Fills a polygon of many contours, such as a country with islands and lakes.
    ///
    /// # Errors
    /// As for [`fill_polygon_aa`](Self::fill_polygon_aa).
    #[inline]
    fn fill_contours_aa<C>(
        &mut self,
        contours: C,
        rule: FillRule,
        table: &mut [CoverageSlot],
        cells: &mut [i32],
        paint: impl Paint<Self>,
    ) -> Result<(), EdgeTableFull>
    where
        C: IntoIterator + Clone,
        C::Item: IntoIterator,
        <C::Item as IntoIterator>::Item: Borrow<PointFx>,
    {
        coverage::fill(contours, rule, table, cells, self.window(), Brush::new(self, paint))
    }

    /// Fills a path.
    ///
    /// # Errors
    /// As for [`fill_polygon_aa`](Self::fill_polygon_aa).
    #[inline]
    fn fill_path_aa(
        &mut self,
        path: impl IntoIterator<IntoIter = impl Segments>,
        rule: FillRule,
        table: &mut [CoverageSlot],
        cells: &mut [i32],
        paint: impl Paint<Self>,
    ) -> Result<(), EdgeTableFull> {
        coverage::path(path, rule, table, cells, self.window(), Brush::new(self, paint))
    }

    /// Fills a circle or an ellipse. One that is turned is a path: [`Curves::ellipse`](crate::geom::Curves::ellipse).
    #[doc(alias("fillSmoothCircle"))]
    #[inline]
    fn fill_ellipse_aa(&mut self, ellipse: Ellipse, paint: impl Paint<Self>) {
        coverage::ellipse(ellipse, self.window(), Brush::new(self, paint));
    }

    /// Fills a sector of a circle or an ellipse, a slice of a pie.
    ///
    /// # Errors
    /// As for [`fill_polygon_aa`](Self::fill_polygon_aa).
    #[inline]
    fn fill_sector_aa(
        &mut self,
        ellipse: Ellipse,
        sector: Sector,
        table: &mut [CoverageSlot],
        cells: &mut [i32],
        paint: impl Paint<Self>,
    ) -> Result<(), EdgeTableFull> {
        coverage::sector(ellipse, sector, table, cells, self.window(), Brush::new(self, paint))
    }

    /// Fills what lies between two circles or ellipses: see [`coverage::ring`].
    #[inline]
    fn fill_ring_aa(&mut self, outer: Ellipse, inner: Ellipse, paint: impl Paint<Self>) {
        coverage::ring(outer, inner, self.window(), Brush::new(self, paint));
    }

    /// Fills the part of a ring that lies in a sector: see [`coverage::ring_sector`].
    ///
    /// # Errors
    /// As for [`fill_polygon_aa`](Self::fill_polygon_aa).
    #[doc(alias("gauge", "drawSmoothArc", "lv_draw_arc"))]
    #[inline]
    fn fill_ring_sector_aa(
        &mut self,
        [outer, inner]: [Ellipse; 2],
        sector: Sector,
        table: &mut [CoverageSlot],
        cells: &mut [i32],
        paint: impl Paint<Self>,
    ) -> Result<(), EdgeTableFull> {
        coverage::ring_sector(outer, inner, sector, (table, cells), self.window(), Brush::new(self, paint))
    }

    /// Fills a rectangle of pixels with rounded corners.
    ///
    /// # Errors
    /// As for [`fill_polygon_aa`](Self::fill_polygon_aa).
    #[doc(alias("fillSmoothRoundRect"))]
    #[inline]
    fn fill_rounded_aa(
        &mut self,
        area: impl Into<Rect>,
        radii: Radii,
        table: &mut [CoverageSlot],
        cells: &mut [i32],
        paint: impl Paint<Self>,
    ) -> Result<(), EdgeTableFull> {
        coverage::rounded(area.into(), radii, table, cells, self.window(), Brush::new(self, paint))
    }

    /// Draws the outline of a path with a width: see [`coverage::stroke`].
    ///
    /// # Errors
    /// As for [`fill_polygon_aa`](Self::fill_polygon_aa). Each line of the stroke's border that a row meets takes a slot.
    #[doc(alias("drawSmoothArc", "drawWideLine"))]
    #[inline]
    fn stroke_path_aa<D: Dashing>(
        &mut self,
        path: impl IntoIterator<IntoIter = impl Segments>,
        stroke: &Stroke<D>,
        table: &mut [CoverageSlot],
        cells: &mut [i32],
        paint: impl Paint<Self>,
    ) -> Result<(), EdgeTableFull> {
        coverage::stroke(path, stroke, table, cells, self.window(), Brush::new(self, paint))
    }

    /// Draws lines with a width from each place to the next, and back to the first one if they are `closed`.
    ///
    /// # Errors
    /// As for [`stroke_path_aa`](Self::stroke_path_aa).
    #[inline]
    fn stroke_polyline_aa<D: Dashing>(
        &mut self,
        places: &[PointFx],
        closed: bool,
        stroke: &Stroke<D>,
        table: &mut [CoverageSlot],
        cells: &mut [i32],
        paint: impl Paint<Self>,
    ) -> Result<(), EdgeTableFull> {
        let memory = (table, cells);
        coverage::stroke_polyline(places, closed, stroke, memory, self.window(), Brush::new(self, paint))
    }

    /// Draws a line with a width.
    ///
    /// # Errors
    /// As for [`stroke_path_aa`](Self::stroke_path_aa). A solid line takes 4 slots with butt caps, 8 with square ones.
    #[inline]
    fn stroke_line_aa<D: Dashing>(
        &mut self,
        [a, b]: [PointFx; 2],
        stroke: &Stroke<D>,
        table: &mut [CoverageSlot],
        cells: &mut [i32],
        paint: impl Paint<Self>,
    ) -> Result<(), EdgeTableFull> {
        self.stroke_polyline_aa(&[a, b], false, stroke, table, cells, paint)
    }

    /// Paints a mask so that its top left pixel falls on `at`: a glyph with soft rims, or a picture that has nothing but an alpha. Of
    /// pixels of 1, 2, 4 or 8 bits the number says how much of the pixel is painted, and the largest number is all of it. What lies
    /// outside is clipped. The mask may have any layout; a view of one may start at any pixel, even within a byte.
    /// ```
    /// use embedded_graphics_core::pixelcolor::{BinaryColor, Gray2, Gray8};
    /// use embedded_raster::{paint::{Cover, Dithered}, Antialias, Bitmap, Framebuffer};
    /// let glyph = Bitmap::<Gray2>::new(&[0b00_01_10_11, 0b11_10_01_00], 4, 2)?;
    /// let mut ram = [100; 5 * 2];
    /// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 5, 2)?;
    /// frame.blit_mask_aa((1, 0), &glyph, Cover(Gray8::new(250)));
    /// assert_eq!(ram, [100, 100, 150, 200, 250, 100, 250, 200, 150, 100]);
    ///
    /// let mut ram = [0; 2];
    /// let mut screen = Framebuffer::<BinaryColor>::new(&mut ram, 5, 2)?;
    /// screen.blit_mask_aa((0, 0), &glyph, Dithered::<_, 2>(BinaryColor::On));
    /// assert_eq!(ram, [0b0001_0000, 0b1110_0000]);
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[doc(alias("drawAlpha", "draw_glyph", "drawChar", "lv_draw_letter", "A8", "A4"))]
    #[inline]
    fn blit_mask_aa<M, L>(&mut self, at: impl Into<Point>, mask: &Frame<M, L>, paint: impl Paint<Self>)
    where
        M: AsRef<[u8]>,
        L: Layout,
        L::Color: PixelFormat<Color = L::Color>,
    {
        mask.tell_levels(at.into(), self.window(), Brush::new(self, paint));
    }
}

impl<S: Surface + ?Sized> Antialias for S {}
