//! [`Bayer`]: few shades that look like many.

use embedded_graphics_core::geometry::Point;

use crate::num::cast::{low_u8, signed, unsigned};

/// Ordered dither in blocks of N x N pixels; N is 2, 4 or 8.
///
/// A level that lies between two shades is shown as a mix of both: of the `N^2` pixels of a block so many have the upper one that
/// their share is the nearest to where the level lies. Each pixel decides by itself, by a threshold that its place in the block has.
/// So neither windows nor bands nor neighbours matter. Of 2 x 2 and 4 x 4 pixels the thresholds are
/// ```text
///     0 2      0  8  2 10
///     3 1     12  4 14  6
///              3 11  1  9
///             15  7 13  5
/// ```
/// and a level at `n + f`, with f from 0 to 1, becomes `n + 1` where `f + (threshold + 1/2) / N^2` is 1 or more.
///
/// It is for the functions that make colours. Gradients tell them the pixel; triangles do if [`At`](crate::geom::At) is among their
/// values.
/// ```
/// use embedded_graphics_core::pixelcolor::Gray4;
/// use embedded_raster::{paint::{Bayer, Linear, Outside}, raster::rectangle, Canvas, Framebuffer, PointFx, Rect};
/// let mut ram = [0; 8];
/// let mut frame = Framebuffer::<Gray4>::new(&mut ram, 8, 2)?;
/// let ends = [PointFx::px(0, 0), PointFx::px(8, 0)];
/// let color = |level, at| Gray4::new(Bayer::<2>::shade(level, 15, at));
/// frame.paint(Linear::new(ends, Outside::Clamp, color), |window, brush| {
///     rectangle::fill(Rect::new(0, 0, 8, 2), window, brush)
/// });
/// assert_eq!(ram, [0x13, 0x47, 0x8a, 0xce, 0x13, 0x56, 0x9a, 0xde]);
///
/// use embedded_raster::geom::At;
/// let mut ram = [0; 8];
/// let mut frame = Framebuffer::<Gray4>::new(&mut ram, 4, 4)?;
/// let corners = [PointFx::px(0, 0), PointFx::px(8, 0), PointFx::px(0, 8)];
/// let values = [8, 8, 8].map(|level| (level, At::default()));
/// frame.shade_triangle_fx(corners, values, |(level, At(at))| Gray4::new(Bayer::<4>::shade(level, 15, at)))?;
/// assert_eq!(ram, [0x01, 0x01, 0x10, 0x10, 0x01, 0x01, 0x10, 0x10]); // 8 of 17: half of the pixels
/// # Ok::<(), embedded_raster::Error>(())
/// ```
///
/// Source: B. Bayer, "An Optimum Method for Two-Level Rendition of Continuous-Tone Pictures", ICC 1973.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Bayer<const N: u32>;

impl<const N: u32> Bayer<N> {
    /// Bits of a place in a block: 1, 2 or 3.
    const BITS: u32 = {
        assert!(N == 2 || N == 4 || N == 8, "blocks are 2, 4 or 8 pixels wide");
        N.trailing_zeros()
    };

    /// The threshold of a pixel, below `N^2`: each of a block has one of its own.
    #[inline(always)]
    pub fn threshold(at: Point) -> u32 {
        let (x, y) = (unsigned(at.x), unsigned(at.y));
        let (mut threshold, cross) = (0, x ^ y);
        // The lowest bits of the place become the highest ones.
        for i in 0..Self::BITS {
            threshold = threshold << 2 | (cross >> i & 1) << 1 | y >> i & 1;
        }
        threshold
    }

    /// The shade of a level: of 0 to `most` where 255 is `most`.
    #[inline(always)]
    pub fn shade(level: u8, most: u8, at: Point) -> u8 {
        // Below 2^24: 255 255 128 + 255 127.
        let n = u32::from(level).wrapping_mul(most.into());
        let n = n.wrapping_mul(2 * N * N).wrapping_add(Self::offset(at).wrapping_mul(255));
        low_u8(n / (255 * 2 * N * N))
    }

    /// The shade of a finer level: of 0 to `most` where 65,535 is `most`.
    /// ```
    /// use embedded_graphics_core::geometry::Point;
    /// use embedded_raster::paint::Bayer;
    /// // A quarter of the way from shade 1 to shade 2: at one of four pixels.
    /// let at = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(x, y)| Point::new(x, y));
    /// assert_eq!(at.map(|at| Bayer::<2>::fine_shade(65_535 / 12 * 5, 3, at)), [1, 1, 2, 1]);
    /// ```
    #[inline(always)]
    pub fn fine_shade(level: u16, most: u8, at: Point) -> u8 {
        // Below 2^31: 65,535 255 128 + 65,535 127.
        let n = u32::from(level).wrapping_mul(most.into());
        let n = n.wrapping_mul(2 * N * N).wrapping_add(Self::offset(at).wrapping_mul(65_535));
        low_u8(n / (65_535 * 2 * N * N))
    }

    /// A level moved up or down by up to half of `spread`, by the threshold of the pixel: for a palette, whose nearest entry is looked
    /// for after that. A good spread is about the distance of its colours.
    /// ```
    /// use embedded_graphics_core::geometry::Point;
    /// use embedded_raster::paint::Bayer;
    /// let at = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(x, y)| Point::new(x, y));
    /// assert_eq!(at.map(|at| Bayer::<2>::moved(100, 80, at)), [70, 110, 130, 90]);
    /// ```
    #[inline(always)]
    pub fn moved(level: u8, spread: u8, at: Point) -> u8 {
        // From -255 to 255: of N^2 steps, the middle of the one that the threshold names.
        let steps = signed(Self::offset(at)).wrapping_sub(signed(N * N));
        let by = steps.wrapping_mul(spread.into()) >> (2 * Self::BITS + 1);
        low_u8(unsigned(i32::from(level).wrapping_add(by).clamp(0, 255)))
    }

    /// Twice the threshold, and 1.
    #[inline(always)]
    fn offset(at: Point) -> u32 {
        Self::threshold(at) << 1 | 1
    }
}
