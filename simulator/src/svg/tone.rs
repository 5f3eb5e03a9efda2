//! [`Tone`]: colours as pixels of every depth, the nearest there is: no pattern, so that edges stay as they are.

use embedded_graphics_core::pixelcolor::{PixelColor, Rgb565, Rgb888, RgbColor};
use embedded_raster::{
    pixel::{Xrgb8888, EGA},
    Framebuffer, Index1, Index2, Index4, Index8, Palette, PixelFormat,
};

use crate::picture::Picture;

/// A pixel that shapes can be drawn in.
pub trait Tone: PixelColor + PixelFormat<Color = Self> {
    /// The one that is nearest to a colour.
    fn of(color: Rgb888) -> Self;

    /// What a framebuffer of it looks like.
    fn picture(frame: &Framebuffer<'_, Self>) -> Picture;
}

/// How bright a colour is, from 0 to 255.
pub(crate) fn luma(c: Rgb888) -> u8 {
    let sum = 299 * u32::from(c.r()) + 587 * u32::from(c.g()) + 114 * u32::from(c.b());
    u8::try_from((sum + 500) / 1000).unwrap_or(u8::MAX)
}

/// The step of a scale from 0 to `steps` that is nearest to a brightness.
fn step(level: u8, steps: u32) -> u8 {
    u8::try_from((u32::from(level) * steps + 127) / 255).unwrap_or(u8::MAX)
}

/// Greys from black to white.
fn greys<const N: usize>() -> Palette<Rgb888, N> {
    let mut colors = [Rgb888::BLACK; N];
    for (i, color) in colors.iter_mut().enumerate() {
        let level = u8::try_from(i * 255 / (N - 1)).unwrap_or(u8::MAX);
        *color = Rgb888::new(level, level, level);
    }
    Palette::new(colors)
}

/// Black and white.
impl Tone for Index1 {
    fn of(color: Rgb888) -> Self {
        Self::new(step(luma(color), 1))
    }

    fn picture(frame: &Framebuffer<'_, Self>) -> Picture {
        Picture::indexed(frame, &greys::<2>())
    }
}

/// Four greys.
impl Tone for Index2 {
    fn of(color: Rgb888) -> Self {
        Self::new(step(luma(color), 3))
    }

    fn picture(frame: &Framebuffer<'_, Self>) -> Picture {
        Picture::indexed(frame, &greys::<4>())
    }
}

/// The sixteen colours of the EGA.
impl Tone for Index4 {
    fn of(color: Rgb888) -> Self {
        let far = |c: Rgb888| {
            let by = |a: u8, b: u8| u32::from(a.abs_diff(b)).pow(2);
            by(c.r(), color.r()) + by(c.g(), color.g()) + by(c.b(), color.b())
        };
        let nearest = (0..16).min_by_key(|&index| EGA.get(index).map_or(u32::MAX, far));
        Self::new(nearest.unwrap_or(0))
    }

    fn picture(frame: &Framebuffer<'_, Self>) -> Picture {
        Picture::indexed(frame, &EGA)
    }
}

/// Six steps of red, of green and of blue, and 40 greys.
impl Tone for Index8 {
    fn of(color: Rgb888) -> Self {
        let (r, g, b) = (color.r(), color.g(), color.b());
        if r == g && g == b {
            return Self::new(216 + step(r, 39));
        }
        let [r, g, b] = [r, g, b].map(|level| step(level, 5));
        Self::new(36 * r + 6 * g + b)
    }

    fn picture(frame: &Framebuffer<'_, Self>) -> Picture {
        let mut colors = [Rgb888::BLACK; 256];
        for (color, index) in colors.iter_mut().zip(0_u8..=255) {
            let grey = |n: u8| u8::try_from(u32::from(n) * 255 / 39).unwrap_or(u8::MAX);
            *color = match index.checked_sub(216).map(grey) {
                Some(level) => Rgb888::new(level, level, level),
                None => Rgb888::new(index / 36 * 51, index / 6 % 6 * 51, index % 6 * 51),
            };
        }
        Picture::indexed(frame, &Palette::new(colors))
    }
}

macro_rules! true_color {
    ($($name:ident),*) => {
        $(
            /// The colour itself.
            impl Tone for $name {
                fn of(color: Rgb888) -> Self {
                    color.into()
                }

                fn picture(frame: &Framebuffer<'_, Self>) -> Picture {
                    Picture::of(frame)
                }
            }
        )*
    };
}

true_color!(Rgb565, Rgb888, Xrgb8888);
