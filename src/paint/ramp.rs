//! [`Ramp`], [`CoverIndex`] and [`Dithered`]: soft rims where pixels are indices, or have few shades.
//!
//! The mean of two indices says nothing: what lies between two colours of a palette is another entry of it, the nearest one to the
//! mean of these colours. A [`Ramp`] has looked for the entries between one colour and one background beforehand, once for each
//! palette. [`CoverIndex`] takes the old colour from the surface, whatever it is, and looks for the nearest entry at each pixel.
//! [`Dithered`] has no colours between: it paints as many pixels of a block as are covered of it, which one bit can show.

use embedded_graphics_core::{geometry::Point, pixelcolor::RgbColor};

use super::{cover::level_at, dither::Bayer, solid::in_one_color, traits::Paint};
use crate::{
    num::cast::{low_u32, low_u8},
    pixel::{Channels, Palette},
    span::ClippedSpan,
    surface::{Readable, Surface},
};

/// The colours of a rim, from a background to the colour of a shape, in `N` steps of even size. Any surface can be painted with
/// it, as no pixel is read: rims become what they are over that background.
///
/// With a [`Palette`] its colours are the nearest entries, and it has to be built anew when the palette changes, by a search of
/// the palette for each step. Without, [`Ramp::new`] takes any colours, such as shades that somebody chose.
/// ```
/// use embedded_graphics_core::pixelcolor::Rgb888;
/// use embedded_raster::{paint::Ramp, Antialias, Framebuffer, Index4, Palette, PointFx};
/// let palette = Palette::<Rgb888, 16>::greys();
/// let mut ram = [0; 3];
/// let mut frame = Framebuffer::<Index4>::new(&mut ram, 5, 1)?;
/// let ramp = Ramp::<Index4, 17>::of_palette(&palette, [0, 15], Index4::new);
/// let corners = [(0, 0), (4, 0), (0, 1)].map(|(x, y)| PointFx::px(x, y));
/// frame.fill_triangle_aa(corners, &mut [], ramp);
/// assert_eq!(ram, [0xd9, 0x62, 0x00]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Ramp<C, const N: usize> {
    colors: [C; N],
}

impl<C: Copy, const N: usize> Ramp<C, N> {
    /// A ramp of these colours: the first one is the background, the last one the shape. There must be two at least.
    #[inline]
    pub const fn new(colors: [C; N]) -> Self {
        const { assert!(N >= 2 && N <= 256, "a ramp has 2 to 256 colours") };
        Self { colors }
    }

    /// The nearest entries of a palette to the colours between two of them: of the background, and of the shape. `index` makes an
    /// index of a number. A number beyond the palette is shown as its first entry.
    pub fn of_palette<P: RgbColor + Channels, const M: usize>(
        palette: &Palette<P, M>,
        [background, shape]: [u8; 2],
        index: impl Fn(u8) -> C,
    ) -> Self {
        let ends = [background, shape].map(|entry| palette.get(entry).or(palette.get(0)).unwrap_or(P::BLACK));
        let mut step = 0_usize;
        Self::new([(); N].map(|()| {
            // The ends are what was asked for, even where two entries have the same colour.
            let entry = match step {
                0 => background,
                _ if step.wrapping_add(1) == N => shape,
                _ => palette.nearest(P::between(ends, level_of(step, N))),
            };
            step = step.wrapping_add(1);
            index(entry)
        }))
    }

    /// The colour of a level: that of the nearest step.
    #[inline(always)]
    pub fn color(&self, level: u8) -> C {
        let step = usize::from(level).wrapping_mul(N.wrapping_sub(1)).wrapping_add(127) / 255;
        self.colors.get(step).copied().unwrap_or(self.shape())
    }

    /// The colour of the shape.
    #[inline(always)]
    fn shape(&self) -> C {
        self.colors[N - 1]
    }
}

/// The level of a step of `n`, rounded to nearest.
fn level_of(step: usize, n: usize) -> u8 {
    let last = n.wrapping_sub(1).max(1);
    low_u8(low_u32((step.wrapping_mul(255).wrapping_add(last / 2) / last) as u64))
}

impl<S: Surface, const N: usize> Paint<S> for Ramp<S::Color, N> {
    in_one_color!(|paint| paint.shape());

    #[inline(never)]
    fn coverage(&mut self, on: &mut S, span: ClippedSpan, levels: &[u8]) {
        on.write_span(span, |x| self.color(level_at(levels, span, x)));
    }
}

/// An index with soft rims over anything: where a shape covers a pixel in part, it gets the entry of the palette that is nearest to
/// the mean of its old colour and the new one. That takes a search of the palette for each such pixel.
/// ```
/// use embedded_graphics_core::pixelcolor::Rgb888;
/// use embedded_raster::{paint::CoverIndex, Antialias, Framebuffer, Index4, Palette, PointFx};
/// let palette = Palette::<Rgb888, 16>::greys();
/// let mut ram = [0x00, 0xff, 0x77];
/// let mut frame = Framebuffer::<Index4>::new(&mut ram, 6, 1)?;
/// let corners = [(0, 0), (6, 0), (6, 1), (0, 1)].map(|(x, y)| PointFx::px(x, y));
/// let half = [corners[0], corners[1], PointFx::from_bits(0, 256)];
/// frame.fill_triangle_aa(half, &mut [], CoverIndex::new(&palette, Index4::new(15), Index4::new));
/// assert_eq!(ram, [0xeb, 0xff, 0x98]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Copy, Clone, Debug)]
pub struct CoverIndex<'a, P, const N: usize, C, F> {
    palette: &'a Palette<P, N>,
    color: C,
    index: F,
}

impl<'a, P, const N: usize, C, F: Fn(u8) -> C> CoverIndex<'a, P, N, C, F> {
    /// The entry `color` of a palette. `index` makes an index of a number.
    #[inline]
    pub const fn new(palette: &'a Palette<P, N>, color: C, index: F) -> Self {
        Self { palette, color, index }
    }
}

impl<S: Readable, P, const N: usize, F> Paint<S> for CoverIndex<'_, P, N, S::Color, F>
where
    S::Color: Into<u8>,
    P: RgbColor + Channels,
    F: Fn(u8) -> S::Color,
{
    in_one_color!(|paint| paint.color);

    #[inline(never)]
    fn coverage(&mut self, on: &mut S, span: ClippedSpan, levels: &[u8]) {
        let entry = |color: S::Color| self.palette.get(color.into()).or(self.palette.get(0)).unwrap_or(P::BLACK);
        on.edit_span(span, |x, old| match level_at(levels, span, x) {
            u8::MAX => self.color,
            0 => old,
            level => (self.index)(self.palette.nearest(P::between([entry(old), entry(self.color)], level))),
        });
    }
}

/// One colour in ordered dither: of each block of N x N pixels it paints as many as are covered of it; N is 2, 4 or 8. Rims are
/// soft on one bit per pixel so, as seen from some way off.
/// ```
/// use embedded_graphics_core::pixelcolor::BinaryColor;
/// use embedded_raster::{paint::Dithered, Antialias, Framebuffer, PointFx};
/// let mut ram = [0; 2];
/// let mut frame = Framebuffer::<BinaryColor>::new(&mut ram, 8, 2)?;
/// let corners = [(0, 0), (8, 0), (0, 2)].map(|(x, y)| PointFx::px(x, y));
/// frame.fill_triangle_aa(corners, &mut [], Dithered::<_, 2>(BinaryColor::On));
/// assert_eq!(ram, [0b1111_0100, 0b1010_0000]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Dithered<C, const N: u32>(pub C);

impl<S: Surface, const N: u32> Paint<S> for Dithered<S::Color, N> {
    in_one_color!(|paint| paint.0);

    #[inline(never)]
    fn coverage(&mut self, on: &mut S, span: ClippedSpan, levels: &[u8]) {
        on.write_some(span, |x| {
            let shade = Bayer::<N>::shade(level_at(levels, span, x), 1, Point::new(x, span.y()));
            (shade != 0).then_some(self.0)
        });
    }
}
