//! [`Antialias`]: shapes with soft rims on surfaces, one line each, as in `canvas.rs`: the shape from [`coverage`], a paint, and the
//! surface.

use core::borrow::Borrow;

use crate::{
    error::EdgeTableFull,
    geom::{fill_rule::FillRule, flatten::Segments, PointFx},
    paint::{Brush, Paint},
    raster::{
        coverage::{self, CoverageSlot},
        ellipse::Ellipse,
        rounded::Radii,
        stroke::{Dashing, Stroke},
    },
    span::Rect,
    surface::Surface,
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
///
/// **Memory.** `cells` may have any length, even 0: [`coverage::cells`] says how many let a row be drawn at once.
/// ```
/// use embedded_graphics_core::{pixelcolor::Rgb565, prelude::RgbColor};
/// use embedded_raster::{buffer_bytes, paint::Cover, raster::coverage, Antialias, CoverageSlot, Ellipse, Framebuffer, PointFx, px};
/// let mut ram = [0; buffer_bytes::<Rgb565>(64, 48)];
/// let mut frame = Framebuffer::<Rgb565>::new(&mut ram, 64, 48)?;
/// let (mut table, mut cells) = ([CoverageSlot::EMPTY; 16], [0; coverage::cells(64)]);
/// let disc = Ellipse::circle(PointFx::px(32, 24), px(20));
/// frame.fill_ellipse_aa(disc, &mut table, &mut cells, Cover(Rgb565::RED))?;
/// # Ok::<(), embedded_raster::Error>(())
/// ```
pub trait Antialias: Surface {
    /// Draws a line one pixel wide from one place to another, as bright at any angle: see [`coverage::line`].
    #[doc(alias("drawSmoothLine", "anti_aliased_line"))]
    #[inline]
    fn draw_line_aa(&mut self, a: PointFx, b: PointFx, cells: &mut [i32], paint: impl Paint<Self>) {
        coverage::line(a, b, cells, self.window(), Brush::new(self, paint));
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

    /// Fills a circle or an ellipse.
    ///
    /// # Errors
    /// As for [`fill_polygon_aa`](Self::fill_polygon_aa). Sixteen slots are enough for any ellipse of a screen.
    #[doc(alias("fillSmoothCircle"))]
    #[inline]
    fn fill_ellipse_aa(
        &mut self,
        ellipse: Ellipse,
        table: &mut [CoverageSlot],
        cells: &mut [i32],
        paint: impl Paint<Self>,
    ) -> Result<(), EdgeTableFull> {
        coverage::ellipse(ellipse, table, cells, self.window(), Brush::new(self, paint))
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
}

impl<S: Surface + ?Sized> Antialias for S {}
