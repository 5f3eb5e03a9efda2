//! [`Cover`], [`Alpha`] and [`Over`]: one colour, and what becomes of pixels that it covers in part.
//!
//! Of a pixel that is covered by c 255ths, each channel becomes the nearest level to `((255 - c) old + c new) / 255`. A colour that
//! lets through what is under it has an alpha besides; then c times alpha of `255^2` parts are new. Both are rounded once. No mean
//! lies half way between two levels, as 255 and its square are odd.
//!
//! The old colour is read from the surface. Where nothing can be read, as on a display behind a driver, [`Over`] takes the colour
//! of the background instead.

use super::{solid::in_one_color, traits::Paint};
use crate::{
    num::cast::index,
    pixel::Channels,
    span::{ClippedSpan, SoftRow},
    surface::{Readable, Surface},
};

/// The level of the pixel in column x of a span.
#[inline(always)]
pub(super) fn level_at(levels: &[u8], span: ClippedSpan, x: i32) -> u8 {
    levels.get(index(x.wrapping_sub(span.x0()))).copied().unwrap_or(0)
}

/// One colour, with soft rims: where a shape covers a pixel in part, the colour is mixed with what is there.
/// ```
/// use embedded_graphics_core::pixelcolor::Gray8;
/// use embedded_raster::{paint::Cover, Antialias, Framebuffer, PointFx};
/// let mut ram = [100; 5];
/// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 5, 1)?;
/// let corners = [(0, 0), (4, 0), (0, 1)].map(|(x, y)| PointFx::px(x, y));
/// frame.fill_triangle_aa(corners, &mut [], Cover(Gray8::new(200)));
/// assert_eq!(ram, [187, 162, 138, 113, 100]); // 7/8, 5/8, 3/8 and 1/8 of the way from 100 to 200
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Cover<C>(pub C);

impl<S: Readable> Paint<S> for Cover<S::Color>
where
    S::Color: Channels,
{
    in_one_color!(|paint| paint.0);

    // Not inlined: the loops of a shape have no registers to spare, and there is a call of this for each rim only.
    #[inline(never)]
    fn coverage(&mut self, on: &mut S, span: ClippedSpan, levels: &[u8]) {
        let color = self.0;
        on.mix_span(span, levels, |old, level| Channels::between([old, color], level));
    }

    #[inline(never)]
    fn soft_row(&mut self, on: &mut S, row: SoftRow<'_>) {
        let color = self.0;
        on.mix_row(row, color, |old, level| Channels::between([old, color], level));
    }
}

/// One colour that lets through what is under it: of `alpha` 255ths it covers that, and of less at soft rims.
/// ```
/// use embedded_graphics_core::pixelcolor::Gray8;
/// use embedded_raster::{paint::Alpha, raster::rectangle, Canvas, Framebuffer, Rect};
/// let mut ram = [0, 50, 100, 255];
/// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 4, 1)?;
/// let glass = Alpha { color: Gray8::new(200), alpha: 51 };
/// frame.paint(glass, |window, brush| rectangle::fill(Rect::new(0, 0, 4, 1), window, brush));
/// assert_eq!(ram, [40, 80, 120, 244]); // a fifth of the way to 200
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Alpha<C> {
    /// The colour, as it is where nothing shows through.
    pub color: C,
    /// How much of it there is, in 255ths.
    pub alpha: u8,
}

impl<S: Readable> Paint<S> for Alpha<S::Color>
where
    S::Color: Channels,
{
    #[inline(never)]
    fn span(&mut self, on: &mut S, span: ClippedSpan) {
        let Self { color, alpha } = *self;
        on.edit_span(span, |_, old| Channels::between([old, color], alpha));
    }

    #[inline(never)]
    fn coverage(&mut self, on: &mut S, span: ClippedSpan, levels: &[u8]) {
        let Self { color, alpha } = *self;
        let share = |x| u16::from(level_at(levels, span, x)).wrapping_mul(alpha.into());
        on.edit_span(span, |x, old| Channels::between_fine([old, color], share(x)));
    }
}

/// One colour with soft rims over a background of one colour, on surfaces that cannot be read.
/// ```
/// use embedded_graphics_core::pixelcolor::{Gray8, GrayColor};
/// use embedded_raster::{paint::Over, Antialias, ClippedSpan, PointFx, Rect, Surface};
/// /// A display behind a driver: it takes pixels and gives none back.
/// struct Display([u8; 5]);
/// impl Surface for Display {
///     type Color = Gray8;
///     fn window(&self) -> Rect {
///         Rect::new(0, 0, 5, 1)
///     }
///     fn fill_span(&mut self, span: ClippedSpan, color: Gray8) {
///         self.0[span.x0() as usize..span.x1() as usize].fill(color.luma());
///     }
/// }
/// let mut display = Display([9; 5]);
/// let corners = [(0, 0), (4, 0), (0, 1)].map(|(x, y)| PointFx::px(x, y));
/// display.fill_triangle_aa(corners, &mut [], Over { color: Gray8::new(200), background: Gray8::new(100) });
/// assert_eq!(display.0, [187, 162, 138, 113, 9]);
/// ```
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Over<C> {
    /// The colour of the shape.
    pub color: C,
    /// What it is drawn on: pixels that are covered in part become a mix of both, whatever they were before.
    pub background: C,
}

impl<S: Surface> Paint<S> for Over<S::Color>
where
    S::Color: Channels,
{
    in_one_color!(|paint| paint.color);

    #[inline(never)]
    fn coverage(&mut self, on: &mut S, span: ClippedSpan, levels: &[u8]) {
        let ends = [self.background, self.color];
        on.write_span(span, |x| Channels::between(ends, level_at(levels, span, x)));
    }
}
