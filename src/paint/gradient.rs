//! [`Linear`] and [`Radial`]: gradients for any shape.
//!
//! A gradient has a *level* from 0 to 255 at every pixel, and a function makes a colour of it. So it can be a mix of two colours
//! ([`Channels::between`](crate::pixel::Channels::between)), a row of palette entries, or anything else.
//!
//! - **Linear**, from a to b: at the centre p of a pixel it is `255 (p - a) (b - a) / |b - a|^2`, products of vectors.
//! - **Radial**, around c with radius r: it is `255 |p - c| / r`.
//!
//! The level is the nearest whole number to that, halves upwards: exactly, whatever the window, the band or the view. What lies
//! before 0 and after 255 is up to [`Outside`].
//!
//! **How.** Along a row a linear gradient is a quotient and a remainder, to which a step is added. A radial one takes a root where a
//! span begins: level n is right while `(2 n - 1)^2 r^2 <= 4 255^2 |p - c|^2 < (2 n + 1)^2 r^2`, and from pixel to pixel n moves by as
//! much as it must. Only where r is below 16 pixels, and n would move far, does each pixel take a root.
//!
//! **Range.** Pixels may be anywhere. The ends of a linear gradient are exact up to 65,535 pixels apart in x and in y; farther apart,
//! the way between them is cut to 24 bits. A radius is 16,383 pixels at most; pixels that are farther from the centre than that, in
//! x or in y, have the level of those which are just as far.

use core::num::NonZeroU32;

use embedded_graphics_core::geometry::Point;
use fixed::types::I24F8;

use super::traits::Paint;
use crate::{
    geom::{bits, PointFx},
    num::{
        cast::{low_u32, low_u64, low_u8, magnitude, narrow, saturate, signed_wide, unsigned},
        divisor::WideDivisor,
        root::square_root,
        round::difference,
    },
    span::ClippedSpan,
    surface::Surface,
};

/// What is there before the first and after the last colour of a gradient.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Outside {
    /// That colour goes on for ever.
    #[default]
    Clamp,
    /// It begins anew: of the distance in lengths of the gradient, the fraction counts.
    Repeat,
    /// It goes back and forth.
    Mirror,
}

/// A gradient along a line. See the [module](self).
/// ```
/// use embedded_graphics_core::pixelcolor::Gray8;
/// use embedded_raster::{paint::{Linear, Outside}, raster::rectangle, Canvas, Framebuffer, PointFx, Rect};
/// let mut ram = [0; 6];
/// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 6, 1)?;
/// let ends = [PointFx::px(1, 0), PointFx::px(5, 0)];
/// let paint = Linear::new(ends, Outside::Clamp, |level, _| Gray8::new(level));
/// frame.paint(paint, |window, brush| rectangle::fill(Rect::new(0, 0, 6, 1), window, brush));
/// assert_eq!(ram, [0, 32, 96, 159, 223, 255]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Copy, Clone, Debug)]
pub struct Linear<F> {
    from: (i32, i32),
    /// To the other end, in units of `2^s`, each up to 2^24; s is at most 9.
    way: (i32, i32),
    /// `2^(1 + s) |way|^2`, up to 2^59, and what it divides by.
    size: u64,
    divisor: WideDivisor,
    outside: Outside,
    color: F,
}

impl<F> Linear<F> {
    /// From one place to another. `color` makes a colour of a level and the pixel. If both places are one, all pixels have level 0.
    pub fn new([from, to]: [PointFx; 2], outside: Outside, color: F) -> Self {
        let (from, to) = (bits(from), bits(to));
        let (x, y) = (difference(to.0, from.0), difference(to.1, from.1));
        let widest = x.unsigned_abs().max(y.unsigned_abs());
        let shift = 40_u32.saturating_sub(widest.leading_zeros());
        let way = (saturate(x >> (shift & 63)), saturate(y >> (shift & 63)));
        let square = |n: i32| magnitude(i64::from(n).wrapping_mul(n.into()));
        let size = square(way.0).wrapping_add(square(way.1)) << (shift.wrapping_add(1) & 63);
        Self { from, way, size, divisor: WideDivisor::new(size), outside, color }
    }

    /// What is divided for a pixel: 510 times the product of the way to its centre with the way to the other end, and half the
    /// divisor more. Below 2^76.
    fn dividend(&self, x: i32, y: i32) -> i128 {
        let to = |pixel: i32, from: i32| (i64::from(pixel) << 8).wrapping_add(128).wrapping_sub(from.into());
        let product = |n: i64, way: i32| i128::from(n).wrapping_mul(way.into());
        let dot = product(to(x, self.from.0), self.way.0).wrapping_add(product(to(y, self.from.1), self.way.1));
        dot.wrapping_mul(510).wrapping_add((self.size >> 1).into())
    }

    /// Quotient and remainder: as it stands if it has 64 bits, else digit by digit.
    fn quotient(&self, n: i128) -> (i128, u64) {
        if let Ok(n) = i64::try_from(n) {
            let (quotient, rest) = self.divisor.quotient(n);
            return (quotient.into(), rest);
        }
        // First a number of 60 bits, then eight digits of 2. A remainder is below 2^59, with a digit below 2^61.
        let (mut quotient, mut rest) = (0_i128, 0);
        for shift in [16, 14, 12, 10, 8, 6, 4, 2, 0] {
            let digit = if shift == 16 { n >> 16 } else { n >> (shift & 127) & 3 };
            let part = signed_wide(rest << 2).wrapping_add(i64::try_from(digit).unwrap_or(0));
            let (q, r) = self.divisor.quotient(part);
            (quotient, rest) = ((quotient << 2).wrapping_add(q.into()), r);
        }
        (quotient, rest)
    }
}

/// The rest of a number below 2^90, be it negative or not, divided by a period.
fn modulo(n: i128, period: u32) -> u32 {
    let mut rest = 0_u32;
    // 510 and 255 both divide what is added.
    let n = n.wrapping_add(510 << 90).cast_unsigned();
    for shift in [96, 80, 64, 48, 32, 16, 0] {
        let digits = rest << 16 | low_u32(low_u64(n >> (shift & 127))) & 0xffff;
        rest = digits.checked_rem(period).unwrap_or(0);
    }
    rest
}

impl Outside {
    /// After how many levels they come again.
    const fn period(self) -> Option<u32> {
        match self {
            Self::Clamp => None,
            Self::Repeat => Some(255),
            Self::Mirror => Some(510),
        }
    }

    /// A level of a period. `is_before` says that the true number is below the level, `is_half` that it is by just one half.
    #[inline(always)]
    fn fold(self, level: u32, is_before: bool, is_half: bool) -> u8 {
        low_u8(match (self, level) {
            // At the end of a period, not at the start of the next.
            (Self::Repeat, 0) if is_before => 255,
            // The way back is rounded upwards, too.
            (Self::Mirror, 0) if is_half => 1,
            (Self::Mirror, 256..) => 510_u32.wrapping_sub(level).wrapping_add(is_half.into()),
            _ => level,
        })
    }
}

impl<S: Surface, F: FnMut(u8, Point) -> S::Color> Paint<S> for Linear<F> {
    #[inline(never)]
    fn span(&mut self, on: &mut S, span: ClippedSpan) {
        let (y, size, outside) = (span.y(), self.size, self.outside);
        if size == 0 {
            return on.write_span(span, |x| (self.color)(0, Point::new(x, y)));
        }
        let (level, mut rest) = self.quotient(self.dividend(span.x0(), y));
        // Below 2^41, and the quotient below 2^17.
        let (by, rest_by) = self.divisor.quotient(i64::from(self.way.0).wrapping_mul(510 << 8));
        let color = &mut self.color;
        let mut carry = move || {
            rest = rest.wrapping_add(rest_by);
            let is_full = rest >= size;
            rest = rest.wrapping_sub(if is_full { size } else { 0 });
            (is_full, rest)
        };
        let Some(period) = outside.period() else {
            // Farther away than any row is long.
            let mut level = i64::try_from(level.clamp(-1 << 60, 1 << 60)).unwrap_or(0);
            return on.write_span(span, |x| {
                let here = low_u8(unsigned(narrow(level.clamp(0, 255))));
                level = level.wrapping_add(by).wrapping_add(carry().0.into());
                color(here, Point::new(x, y))
            });
        };
        let (mut level, by) = (modulo(level, period), modulo(by.into(), period));
        on.write_span(span, |x| {
            let here = outside.fold(level, rest << 1 < size, rest == 0);
            let (is_full, next) = carry();
            rest = next;
            level = level.wrapping_add(by).wrapping_add(is_full.into());
            level = level.wrapping_sub(if level >= period { period } else { 0 });
            color(here, Point::new(x, y))
        });
    }
}

/// A gradient around a place. See the [module](self).
/// ```
/// use embedded_graphics_core::pixelcolor::Gray8;
/// use embedded_raster::{paint::{Outside, Radial}, raster::rectangle, Canvas, Framebuffer, PointFx, Rect};
/// use fixed::types::I24F8;
/// let mut ram = [0; 6];
/// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 6, 1)?;
/// let centre = PointFx::from_bits(384, 128);
/// let paint = Radial::new(centre, I24F8::from_num(3), Outside::Clamp, |level, _| Gray8::new(level));
/// frame.paint(paint, |window, brush| rectangle::fill(Rect::new(0, 0, 6, 1), window, brush));
/// assert_eq!(ram, [85, 0, 85, 170, 255, 255]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Copy, Clone, Debug)]
pub struct Radial<F> {
    centre: (i32, i32),
    /// From 1 to [`MOST`](Self::MOST).
    radius: NonZeroU32,
    outside: Outside,
    color: F,
}

impl<F> Radial<F> {
    /// In units: the squares of two such sides together are below 2^45.
    const MOST: i32 = (1 << 22) - 1;

    /// Around a place, with a radius of at least 1/256. `color` makes a colour of a level and the pixel.
    pub fn new(centre: PointFx, radius: I24F8, outside: Outside, color: F) -> Self {
        let radius = unsigned(radius.to_bits().clamp(1, Self::MOST));
        Self { centre: bits(centre), radius: NonZeroU32::new(radius).unwrap_or(NonZeroU32::MIN), outside, color }
    }

    /// From the centre to the centre of a pixel, in one direction: its square.
    #[inline(always)]
    fn square(pixel: i32, centre: i32) -> u64 {
        let way = (i64::from(pixel) << 8).wrapping_add(128).wrapping_sub(centre.into());
        let way = narrow(way.min(Self::MOST.into()).max(i64::from(Self::MOST).wrapping_neg()));
        magnitude(i64::from(way).wrapping_mul(way.into()))
    }
}

/// 4 255^2, below 2^18.
const SCALE: u64 = 4 * 255 * 255;

impl<S: Surface, F: FnMut(u8, Point) -> S::Color> Paint<S> for Radial<F> {
    #[inline(never)]
    fn span(&mut self, on: &mut S, span: ClippedSpan) {
        let Self { centre, radius, outside, ref mut color } = *self;
        let (y, r) = (span.y(), u64::from(radius.get()));
        let down = Self::square(y, centre.1);
        // Below 2^63.
        let scaled = |x: i32| Self::square(x, centre.0).wrapping_add(down).wrapping_mul(SCALE);
        // (k r)^2, where k r is below 2^32.
        let bound = |k: u64| k.wrapping_mul(r).wrapping_mul(k.wrapping_mul(r));
        // floor(255 d / r + 1/2) = floor((sqrt(4 255^2 d^2) + r) / (2 r)), and the root may be cut.
        let twice = NonZeroU32::new(radius.get() << 1).unwrap_or(radius);
        let found = |n: u64| u64::from(square_root(n).wrapping_add(radius.get()) / twice);
        let most = if outside == Outside::Clamp { 255 } else { u64::MAX };
        let takes_roots = r < 16 << 8;
        let mut level = found(scaled(span.x0())).min(most);
        on.write_span(span, |x| {
            let n = scaled(x);
            if takes_roots {
                level = found(n).min(most);
            } else {
                // At most 16 levels and 1 from pixel to pixel.
                while level < most && n >= bound((level << 1).wrapping_add(1)) {
                    level = level.wrapping_add(1);
                }
                while level > 0 && n < bound((level << 1).wrapping_sub(1)) {
                    level = level.wrapping_sub(1);
                }
            }
            let here = match outside.period() {
                None => low_u8(low_u32(level)),
                Some(period) => {
                    let rest = low_u32(level).checked_rem(period).unwrap_or(0);
                    let is_half = level > 0 && n == bound((level << 1).wrapping_sub(1));
                    outside.fold(rest, n < bound(level << 1), is_half)
                }
            };
            color(here, Point::new(x, y))
        });
    }
}
