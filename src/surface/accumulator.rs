//! [`Accumulator`]: the coverage of shapes side by side, added up before anything is seen.
//!
//! Where two shapes share a side, a pixel on it belongs to both: covered by c of one and 1 - c of the other. Painted one after the other,
//! each leaves the rest of the pixel to what was there before, and of that `c (1 - c)` shines through: a seam along each border, of up to
//! a quarter of the background. No order of painting avoids it. What avoids it is to add up what all shapes cover of a pixel, and then
//! to mix once:
//! ```text
//!     painted one by one    (1 - c) (c a + (1 - c) background) + ...      background shows, though all is covered
//!     added up              c a + (1 - c) b                               as the shapes are
//! ```
//! Coverage is rounded to 255ths, so the two add up to 254 to 256 of 255. So a pixel is full from 254 on: then only the shapes are mixed, each
//! by its part of the sum. Beyond 255, what a further shape covers is left out: where shapes overlap, the one that was added first
//! is in front.
//!
//! Source: M. Woo et al., "OpenGL Programming Guide", on antialiasing polygons: blending with `GL_SRC_ALPHA_SATURATE`.

use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};

use super::traits::{Readable, Surface};
use crate::{
    error::BufferError,
    num::cast::{index, low_u8},
    pixel::Channels,
    span::{ClippedSpan, Rect, Span},
};

/// So much of a pixel counts as all of it.
const ALMOST: u8 = 254;

/// What shapes cover of a pixel, and their colours: eight bytes.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Sum {
    /// In 255ths.
    covered: u8,
    /// Red, green and blue, times what is covered: at most 255 times 255.
    colors: [u16; 3],
}

impl Sum {
    /// Nothing.
    pub const EMPTY: Self = Self { covered: 0, colors: [0; 3] };

    /// How much of the pixel is covered, in 255ths.
    #[inline]
    pub const fn covered(self) -> u8 {
        self.covered
    }

    /// The colour of the pixel over what was there before: the mean of the shapes and of the rest, rounded once to the nearest level of
    /// each channel. Of a pixel that is covered by 254 or 255 there is no rest.
    #[inline]
    pub fn over<C: Channels>(self, under: C) -> C {
        let Self { covered, colors } = self;
        if covered == 0 {
            return under;
        }
        // Of a channel whose largest number is m: m sum of 255^2 parts, and the old number in what is left of 255.
        let rest = u32::from(!covered).wrapping_mul(255);
        under.mixed_with(colors.map(u32::from), |old, most, sum| {
            let new = sum.wrapping_mul(most.into());
            low_u8(if covered == ALMOST {
                new.wrapping_add(255 * 127) / (255 * 254)
            } else {
                new.wrapping_add(rest.wrapping_mul(old.into())).wrapping_add(255 * 255 / 2) / (255 * 255)
            })
        })
    }

    /// Adds so many 255ths of a colour, as far as there is room.
    #[inline(always)]
    fn add(&mut self, color: Rgb888, level: u8) {
        let level = level.min(!self.covered);
        self.covered = self.covered.wrapping_add(level);
        let mut channels = [color.r(), color.g(), color.b()].into_iter();
        for sum in &mut self.colors {
            let channel = channels.next().unwrap_or(0);
            *sum = sum.wrapping_add(u16::from(channel).wrapping_mul(level.into()));
        }
    }
}

/// A sum for each pixel of a window: shapes are added to it, and then it is shown, once. Memory for the screen as a whole is
/// not needed: a band of it will do, band after band.
///
/// It is a surface. Shapes with soft rims are added by the paint [`Add`](crate::paint::Add); shapes of whole pixels, by any method of
/// [`Canvas`](crate::Canvas), fill what is left of a pixel.
/// ```
/// use embedded_graphics_core::pixelcolor::{Gray8, Rgb888};
/// use embedded_raster::{paint::{Add, Cover}, surface::{Accumulator, Sum}, Antialias, Framebuffer, PointFx, Rect};
/// // Two triangles share a slope. Together they cover all of the first four pixels.
/// let [a, b, c, d] = [(0, 0), (4, 0), (4, 1), (0, 1)].map(|(x, y)| PointFx::px(x, y));
/// let (dark, light) = (Rgb888::new(40, 40, 40), Rgb888::new(80, 80, 80));
/// let mut memory = [Sum::EMPTY; 5];
/// let mut sums = Accumulator::new(&mut memory, Rect::new(0, 0, 5, 1))?;
/// sums.fill_triangle_aa([a, b, d], &mut [], Add(dark));
/// sums.fill_triangle_aa([b, c, d], &mut [], Add(light));
/// let mut ram = [255; 5];
/// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 5, 1)?;
/// sums.show(&mut frame, Sum::over);
/// assert_eq!(ram, [45, 55, 65, 75, 255]);
///
/// // One after the other: the white of the ground shines through.
/// let mut ram = [255; 5];
/// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 5, 1)?;
/// frame.fill_triangle_aa([a, b, d], &mut [], Cover(Gray8::new(40)));
/// frame.fill_triangle_aa([b, c, d], &mut [], Cover(Gray8::new(80)));
/// assert_eq!(ram, [69, 106, 115, 99, 255]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Debug)]
pub struct Accumulator<'a> {
    sums: &'a mut [Sum],
    window: Rect,
}

impl<'a> Accumulator<'a> {
    /// Sums for the pixels of a window, empty at first.
    ///
    /// # Errors
    /// [`BufferError::TooSmall`], in bytes, if there are fewer sums than pixels.
    pub fn new(sums: &'a mut [Sum], window: Rect) -> Result<Self, BufferError> {
        let pixels = u64::from(window.width()).saturating_mul(window.height().into());
        let pixels = usize::try_from(pixels).unwrap_or(usize::MAX);
        let (needed, given) = (pixels.saturating_mul(size_of::<Sum>()), size_of_val(sums));
        if given < needed {
            return Err(BufferError::TooSmall { needed, given });
        }
        let mut accumulator = Self { sums, window };
        accumulator.clear();
        Ok(accumulator)
    }

    /// Empties all sums.
    pub fn clear(&mut self) {
        self.sums.fill(Sum::EMPTY);
    }

    /// The sum of a pixel; empty outside of the window.
    #[inline]
    pub fn at(&self, x: i32, y: i32) -> Sum {
        let sum = self.window.contains(x, y).then(|| self.sums.get(self.place(x, y))).flatten();
        sum.copied().unwrap_or(Sum::EMPTY)
    }

    /// Shows the pixels of which something is covered, as far as `on` has them: each in the colour that `mix` makes of its sum and of the
    /// old colour. For red, green and blue and for greys that is [`Sum::over`]; for indices, `mix` looks for the
    /// [nearest](crate::Palette::nearest) entry. What cannot be read is painted by [`Surface::write_span`] and [`at`](Self::at).
    pub fn show<S: Readable>(&self, on: &mut S, mut mix: impl FnMut(Sum, S::Color) -> S::Color) {
        let Rect { x0, y0, x1, y1 } = self.window.intersection(on.window());
        for y in y0..y1 {
            let Some(span) = (Span { y, x0, x1 }).known_inside() else { return };
            on.edit_span(span, |x, old| match self.at(x, y) {
                Sum { covered: 0, .. } => old,
                sum => mix(sum, old),
            });
        }
    }

    /// Adds a colour to the pixels of a span, as much of it as `level` says: it is told the number of the pixel in the span.
    #[inline(always)]
    pub(crate) fn add(&mut self, span: ClippedSpan, color: Rgb888, level: impl Fn(usize) -> u8) {
        let Some(seen) = span.again(self.window) else { return };
        let before = index(seen.x0().wrapping_sub(span.x0()));
        let (first, len) = (self.place(seen.x0(), seen.y()), index(seen.x1().wrapping_sub(seen.x0())));
        let sums = self.sums.get_mut(first..first.wrapping_add(len)).unwrap_or_default();
        for (sum, i) in sums.iter_mut().zip(before..) {
            sum.add(color, level(i));
        }
    }

    /// Where the sum of a pixel of the window is.
    #[inline(always)]
    fn place(&self, x: i32, y: i32) -> usize {
        let Rect { x0, y0, .. } = self.window;
        let (right, down) = (index(x.wrapping_sub(x0)), index(y.wrapping_sub(y0)));
        down.wrapping_mul(self.window.width() as usize).wrapping_add(right)
    }
}

impl Surface for Accumulator<'_> {
    type Color = Rgb888;

    #[inline]
    fn window(&self) -> Rect {
        self.window
    }

    #[inline]
    fn fill_span(&mut self, span: ClippedSpan, color: Rgb888) {
        self.add(span, color, |_| u8::MAX);
    }
}
