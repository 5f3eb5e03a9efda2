//! embedded-graphics, both ways.
//!
//! * A [`Frame`] is a `DrawTarget` and `GetPixel`: text, images and widgets made for embedded-graphics draw into it. [`target`]
//!   makes a `DrawTarget` of any other surface.
//! * [`draw_on`] makes a [`Surface`] of any other `DrawTarget`: every shape of this crate draws on it.
//! * [`Recolored`] is a `DrawTarget` that translates colours on their way to another one, so that an RGB image can be drawn into
//!   an indexed framebuffer.

use core::{
    convert::Infallible,
    iter::{repeat, FusedIterator},
    marker::PhantomData,
};

use embedded_graphics_core::{
    draw_target::DrawTarget,
    geometry::{Dimensions, OriginDimensions, Point, Size},
    image::GetPixel,
    pixelcolor::PixelColor,
    primitives::Rectangle,
    Pixel,
};

use crate::{
    span::{ClippedSpan, Rect, Span},
    surface::{Frame, Inside, Layout, Said, Surface},
};

impl<M, L: Layout> OriginDimensions for Frame<M, L>
where
    M: AsRef<[u8]>,
{
    fn size(&self) -> Size {
        Frame::size(self)
    }
}

impl<M: AsRef<[u8]>, L: Layout> GetPixel for Frame<M, L> {
    type Color = L::Color;

    #[inline]
    fn pixel(&self, p: Point) -> Option<L::Color> {
        self.get(p)
    }
}

impl<M: AsRef<[u8]> + AsMut<[u8]>, L: Layout> DrawTarget for Frame<M, L> {
    type Color = L::Color;
    type Error = Infallible;

    #[inline]
    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<L::Color>>,
    {
        pixels.into_iter().for_each(|Pixel(p, color)| self.set(p, color));
        Ok(())
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = L::Color>,
    {
        write_rows(self, area, colors);
        Ok(())
    }

    #[inline]
    fn fill_solid(&mut self, area: &Rectangle, color: L::Color) -> Result<(), Infallible> {
        self.fill_area((*area).into(), color);
        Ok(())
    }

    #[inline]
    fn clear(&mut self, color: L::Color) -> Result<(), Infallible> {
        Frame::clear(self, color);
        Ok(())
    }
}

/// Any surface as a `DrawTarget`: made by [`target`].
#[derive(Debug)]
pub struct SurfaceTarget<'a, S>(&'a mut S);

/// A `DrawTarget` that draws on a surface: text, images and widgets of embedded-graphics on a wrapper that counts, logs or
/// records what is drawn. (A [`Frame`] is a `DrawTarget` by itself.)
/// ```
/// use embedded_graphics::{pixelcolor::Gray8, prelude::*, primitives::Rectangle};
/// use embedded_raster::{eg, surface::Counter, Rect};
/// let mut counter = Counter::<Gray8>::new(Rect::new(0, 0, 64, 48));
/// eg::target(&mut counter).fill_solid(&Rectangle::new(Point::new(60, 0), Size::new(9, 2)), Gray8::new(1))?;
/// assert_eq!(counter.pixels, 8);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[inline]
pub fn target<S: Surface>(surface: &mut S) -> SurfaceTarget<'_, S> {
    SurfaceTarget(surface)
}

impl<S: Surface> Dimensions for SurfaceTarget<'_, S> {
    fn bounding_box(&self) -> Rectangle {
        self.0.window().into()
    }
}

impl<S: Surface> DrawTarget for SurfaceTarget<'_, S> {
    type Color = S::Color;
    type Error = Infallible;

    #[inline]
    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<S::Color>>,
    {
        pixels.into_iter().for_each(|Pixel(p, color)| self.0.set(p, color));
        Ok(())
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = S::Color>,
    {
        write_rows(self.0, area, colors);
        Ok(())
    }

    #[inline]
    fn fill_solid(&mut self, area: &Rectangle, color: S::Color) -> Result<(), Infallible> {
        self.0.fill_area((*area).into(), color);
        Ok(())
    }
}

/// Paints colours that fill `area` row by row.
fn write_rows<S: Surface>(surface: &mut S, area: &Rectangle, colors: impl IntoIterator<Item = S::Color>) {
    let mut colors = colors.into_iter().fuse();
    let window = surface.window();
    for_each_row(area, window, &mut colors, |span, colors| {
        surface.write_inside(Inside(Said::Span(span)), |_| colors.next());
    });
}

/// Splits colours that fill `area` row by row into the spans that lie in `window`, skipping what does not.
///
/// Work depends on the visible part: colours that are not shown are skipped in one call. The iterator has to be fused, as one
/// that went on after its end would paint rows further down.
fn for_each_row<I: FusedIterator>(
    area: &Rectangle,
    window: Rect,
    colors: &mut I,
    mut write: impl FnMut(ClippedSpan, &mut I),
) {
    let area_rect = Rect::from(*area);
    let seen = area_rect.intersection(window);
    if seen.is_empty() {
        return;
    }
    // All below 2^64. A width counts in full even where the rectangle is cut off at the end of i32.
    let width = u64::from(area.size.width);
    let column = |x: i32| (i64::from(x) - i64::from(area_rect.x0)).unsigned_abs();
    let (before, shown) = (column(seen.x0), u64::from(seen.width()));
    let rows_above = (i64::from(seen.y0) - i64::from(area_rect.y0)).unsigned_abs();
    let mut skip = rows_above.wrapping_mul(width).wrapping_add(before);
    for y in seen.y0..seen.y1 {
        if !advance(colors, skip) {
            return;
        }
        if let Some(span) = (Span { y, x0: seen.x0, x1: seen.x1 }).clip(seen) {
            write(span, colors);
        }
        skip = width.wrapping_sub(shown);
    }
}

/// Drops `n` items. `false` if there were fewer.
fn advance(items: &mut impl Iterator, n: u64) -> bool {
    let mut left = n;
    while let Some(last) = left.checked_sub(1) {
        let step = usize::try_from(last).unwrap_or(usize::MAX);
        if items.nth(step).is_none() {
            return false;
        }
        left = last.wrapping_sub(step as u64);
    }
    true
}

/// Draws with this crate's shapes on any embedded-graphics target. Each span becomes a `fill_solid` of one row; rows of the same
/// columns that follow each other become one, and so do the pixels of a line that lie below each other.
///
/// **Work.** The window is the box that the target says it has. That is only a claim, and all of it counts as visible: a shape as
/// high as a claim of 65,535 rows is followed over these rows, whether they have memory or not. Beyond that a shape costs what it
/// costs on a frame, and the target gets at most one call for each span that a [`Counter`](crate::surface::Counter) with this
/// window counts. A rectangle, the whole window, a horizontal or vertical line is one call.
///
/// # Errors
/// The first error of the target. Nothing is sent to the target after it.
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor};
/// use embedded_raster::{eg::draw_on, Canvas, PointFx};
/// let mut display = MockDisplay::new();
/// draw_on(&mut display, |canvas| {
///     canvas.fill_triangle_fx([PointFx::px(0, 0), PointFx::px(4, 0), PointFx::px(0, 4)], BinaryColor::On);
/// })?;
/// display.assert_pattern(&["###", "## ", "#  "]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
pub fn draw_on<D: DrawTarget, R>(target: &mut D, draw: impl FnOnce(&mut Target<'_, D>) -> R) -> Result<R, D::Error> {
    let window = target.bounding_box().into();
    let mut surface = Target { display: target, window, next: None, error: None };
    let result = draw(&mut surface);
    surface.flush();
    match surface.error {
        Some(error) => Err(error),
        None => Ok(result),
    }
}

/// A `DrawTarget` as a [`Surface`]: made by [`draw_on`].
#[derive(Debug)]
pub struct Target<'a, D: DrawTarget> {
    display: &'a mut D,
    window: Rect,
    /// What is to be sent, once it is known that it does not go on below.
    next: Option<(Rect, D::Color)>,
    error: Option<D::Error>,
}

impl<D: DrawTarget> Target<'_, D> {
    fn send(&mut self, area: Rect, color: D::Color) {
        if let Some((above, its_color)) = &mut self.next {
            if (above.x0, above.x1, above.y1) == (area.x0, area.x1, area.y0) && *its_color == color {
                above.y1 = area.y1;
                return;
            }
        }
        self.flush();
        self.next = Some((area, color));
    }

    fn flush(&mut self) {
        if let Some((area, color)) = self.next.take().filter(|_| self.error.is_none()) {
            self.error = self.display.fill_solid(&area.into(), color).err();
        }
    }
}

impl<D: DrawTarget> Surface for Target<'_, D> {
    type Color = D::Color;

    /// Empty after an error, so that nothing is drawn any more.
    #[inline]
    fn window(&self) -> Rect {
        if self.error.is_none() {
            self.window
        } else {
            Rect::default()
        }
    }

    #[inline]
    fn fill_span(&mut self, span: ClippedSpan, color: D::Color) {
        self.send(Rect::new(span.x0(), span.y(), span.x1(), span.y().saturating_add(1)), color);
    }

    fn fill_area(&mut self, area: Rect, color: D::Color) {
        let area = area.intersection(self.window());
        if !area.is_empty() {
            self.send(area, color);
        }
    }
}

/// A `DrawTarget` of colours `C` that draws on a target of other colours: see [`recolored`].
#[derive(Debug)]
pub struct Recolored<'a, D, C, M> {
    target: &'a mut D,
    convert: M,
    color: PhantomData<C>,
}

/// A target for colours `C`: `convert` turns each into a colour of `target`, which is painted. An example is an RGB image that is
/// drawn with the nearest colours of a palette.
/// ```
/// use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
/// use embedded_raster::{eg::recolored, pixel::EGA, Framebuffer, Index4};
/// let mut ram = [0; 4];
/// let mut frame = Framebuffer::<Index4>::new(&mut ram, 8, 1).unwrap();
/// recolored(&mut frame, |c: Rgb888| Index4::new(EGA.nearest(c))).clear(Rgb888::WHITE).unwrap();
/// assert_eq!(ram, [0xff; 4]);
/// ```
pub fn recolored<D, C, M>(target: &mut D, convert: M) -> Recolored<'_, D, C, M>
where
    D: DrawTarget,
    C: PixelColor,
    M: Fn(C) -> D::Color,
{
    Recolored { target, convert, color: PhantomData }
}

impl<D: Dimensions, C, M> Dimensions for Recolored<'_, D, C, M> {
    fn bounding_box(&self) -> Rectangle {
        self.target.bounding_box()
    }
}

impl<D, C, M> DrawTarget for Recolored<'_, D, C, M>
where
    D: DrawTarget,
    C: PixelColor,
    M: Fn(C) -> D::Color,
{
    type Color = C;
    type Error = D::Error;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), D::Error>
    where
        I: IntoIterator<Item = Pixel<C>>,
    {
        let convert = &self.convert;
        self.target.draw_iter(pixels.into_iter().map(|Pixel(p, color)| Pixel(p, convert(color))))
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), D::Error>
    where
        I: IntoIterator<Item = C>,
    {
        self.target.fill_contiguous(area, colors.into_iter().map(&self.convert))
    }

    fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), D::Error> {
        self.target.fill_solid(area, (self.convert)(color))
    }

    fn clear(&mut self, color: C) -> Result<(), D::Error> {
        self.target.clear((self.convert)(color))
    }
}

/// A `DrawTarget` of colours `C` that draws on a target of other colours, and knows where: see [`recolored_at`].
#[derive(Debug)]
pub struct RecoloredAt<'a, D, C, M> {
    target: &'a mut D,
    convert: M,
    color: PhantomData<C>,
}

/// [`recolored`], for what depends on the place of a pixel, or on the pixels before it: dither. `convert` is asked for every pixel of an
/// image in the order in which it is drawn, from left to right and from top to bottom, seen or not.
/// ```
/// use embedded_graphics::{pixelcolor::{Gray8, Gray4}, prelude::*, primitives::Rectangle};
/// use embedded_raster::{eg::recolored_at, paint::Bayer, Framebuffer};
/// let mut ram = [0; 2];
/// let mut frame = Framebuffer::<Gray4>::new(&mut ram, 2, 2).unwrap();
/// let mut dithered = recolored_at(&mut frame, |at, grey: Gray8| Gray4::new(Bayer::<2>::shade(grey.luma(), 15, at)));
/// // Half way between two shades.
/// dithered.fill_contiguous(&Rectangle::new(Point::zero(), Size::new(2, 2)), [Gray8::new(25); 4]).unwrap();
/// assert_eq!(ram, [0x12, 0x21]);
/// ```
pub fn recolored_at<D, C, M>(target: &mut D, convert: M) -> RecoloredAt<'_, D, C, M>
where
    D: DrawTarget,
    C: PixelColor,
    M: FnMut(Point, C) -> D::Color,
{
    RecoloredAt { target, convert, color: PhantomData }
}

impl<D: Dimensions, C, M> Dimensions for RecoloredAt<'_, D, C, M> {
    fn bounding_box(&self) -> Rectangle {
        self.target.bounding_box()
    }
}

impl<D, C, M> DrawTarget for RecoloredAt<'_, D, C, M>
where
    D: DrawTarget,
    C: PixelColor,
    M: FnMut(Point, C) -> D::Color,
{
    type Color = C;
    type Error = D::Error;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), D::Error>
    where
        I: IntoIterator<Item = Pixel<C>>,
    {
        let convert = &mut self.convert;
        self.target.draw_iter(pixels.into_iter().map(|Pixel(p, color)| Pixel(p, convert(p, color))))
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), D::Error>
    where
        I: IntoIterator<Item = C>,
    {
        let convert = &mut self.convert;
        let (Point { x, mut y }, width) = (area.top_left, area.size.width);
        let mut column = 0_u32;
        let colors = colors.into_iter().map(|color| {
            let at = Point::new(x.wrapping_add_unsigned(column), y);
            column = column.wrapping_add(1);
            if column >= width {
                (column, y) = (0, y.wrapping_add(1));
            }
            convert(at, color)
        });
        self.target.fill_contiguous(area, colors)
    }

    /// Pixels that are not seen are left out: they have one colour.
    fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), D::Error> {
        let seen = Rect::from(*area).intersection(self.bounding_box().into());
        self.fill_contiguous(&seen.into(), repeat(color))
    }
}
