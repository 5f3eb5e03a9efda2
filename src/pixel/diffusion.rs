//! Error diffusion: what a pixel is off is made good by its neighbours.
//!
//! A colour that is not in the palette is shown as one that is; how much that is off, channel by channel, is handed to pixels that
//! come later, in parts:
//! ```text
//!   FloydSteinberg, 16ths          Atkinson, 8ths
//!              *   7                    *   1   1
//!          3   5   1                1   1   1
//!                                       1
//! ```
//! [`FloydSteinberg`] hands on all of it. [`Atkinson`] drops a quarter: light and dark areas become plain, and the rest has more
//! contrast. So much leaves a picture at its edges, too.
//!
//! The rule, in whole levels: a pixel's level is its own and the sum of the parts that it was handed, rounded to nearest, halves
//! upwards, and cut to 0..=255. The error is that level less the one that is shown.
//!
//! Pixels come in the order in which they are read, from left to right and from top to bottom, and memory for one row is enough. So a
//! diffusion is asked pixel by pixel, wherever they come from: an iterator, [`Pictures::blit_mapped`](crate::Pictures::blit_mapped),
//! [`Readable::edit_span`](crate::Readable::edit_span) for a picture that is changed in place, or [`eg::recolored_at`](crate::eg::recolored_at)
//! for images of embedded-graphics.
//! ```
//! use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
//! use embedded_raster::{buffer_bytes, pixel::{FloydSteinberg, EGA}, Bitmap, Framebuffer, Index4, Pictures};
//! let sky: Vec<u8> = (0..64 * 48).flat_map(|n| [255, (n / 64 * 5) as u8, (n % 64 * 2) as u8]).collect();
//! let picture = Bitmap::<Rgb888>::new(&sky, 64, 48)?;
//!
//! let mut ram = [0; buffer_bytes::<Index4>(64, 48)];
//! let mut frame = Framebuffer::<Index4>::new(&mut ram, 64, 48)?;
//! let mut row = [[0; 3]; 64];
//! let mut diffusion = FloydSteinberg::new(&mut row);
//! frame.blit_mapped((0, 0), &picture, |color: Rgb888| {
//!     Some(diffusion.next([color.r(), color.g(), color.b()], |[r, g, b]| {
//!         let index = EGA.nearest(Rgb888::new(r, g, b));
//!         let shown = EGA.get(index).unwrap_or_default();
//!         (Index4::new(index), [shown.r(), shown.g(), shown.b()])
//!     }))
//! });
//! # Ok::<(), embedded_raster::Error>(())
//! ```
//!
//! Sources: R. Floyd and L. Steinberg, "An Adaptive Algorithm for Spatial Greyscale", Proceedings of the SID 17(2), 1976; W. Atkinson,
//! for the Macintosh, 1984.

use crate::num::cast::low_u8;

/// Of `N` channels: the level of a pixel with what it was handed, in parts of a level, and what is chosen for it.
#[inline(always)]
fn choose<T, const N: usize, const PARTS: i16>(
    level: [u8; N],
    handed: [i16; N],
    choose: impl FnOnce([u8; N]) -> (T, [u8; N]),
) -> (T, [i16; N]) {
    let mut levels = level;
    for (level, handed) in levels.iter_mut().zip(handed) {
        // At most 255 more or less.
        let sum = i16::from(*level).wrapping_add(handed.wrapping_add(PARTS / 2) >> PARTS.trailing_zeros());
        *level = low_u8(u32::from(sum.clamp(0, 255).unsigned_abs()));
    }
    let (chosen, shown) = choose(levels);
    let mut error = [0; N];
    for (error, (level, shown)) in error.iter_mut().zip(levels.into_iter().zip(shown)) {
        *error = i16::from(level).wrapping_sub(shown.into());
    }
    (chosen, error)
}

/// `a + times b`, channel by channel.
#[inline(always)]
fn plus<const N: usize>(a: [i16; N], b: [i16; N], times: i16) -> [i16; N] {
    let mut sum = a;
    for (sum, b) in sum.iter_mut().zip(b) {
        *sum = sum.wrapping_add(b.wrapping_mul(times));
    }
    sum
}

/// Error diffusion by Floyd and Steinberg, of `N` channels: see the [module](self).
#[derive(Debug)]
pub struct FloydSteinberg<'a, const N: usize> {
    /// What each pixel of the row was handed from above; behind the current pixel, what those of the next row were.
    row: &'a mut [[i16; N]],
    x: usize,
    /// For the next pixel, and for the one below it.
    right: [i16; N],
    below_right: [i16; N],
}

impl<'a, const N: usize> FloydSteinberg<'a, N> {
    /// For pictures that are as wide as `row` is long. What is in it does not matter.
    pub fn new(row: &'a mut [[i16; N]]) -> Self {
        row.fill([0; N]);
        Self { row, x: 0, right: [0; N], below_right: [0; N] }
    }

    /// The next pixel, with its levels. `nearest` is told which levels are wanted now, and answers with what is drawn, and with the
    /// levels that it shows. Returns what is drawn.
    #[inline]
    pub fn next<T>(&mut self, level: [u8; N], nearest: impl FnOnce([u8; N]) -> (T, [u8; N])) -> T {
        let Self { row, x, right, below_right } = self;
        let above = row.get(*x).copied().unwrap_or([0; N]);
        let (chosen, error) = choose::<T, N, 16>(level, plus(above, *right, 1), nearest);
        if let Some(before) = x.checked_sub(1).and_then(|before| row.get_mut(before)) {
            *before = plus(*before, error, 3);
        }
        if let Some(here) = row.get_mut(*x) {
            *here = plus(*below_right, error, 5);
        }
        (*right, *below_right) = (plus([0; N], error, 7), error);
        *x = x.wrapping_add(1);
        if *x >= row.len() {
            (*x, *right, *below_right) = (0, [0; N], [0; N]);
        }
        chosen
    }
}

/// Error diffusion by Atkinson, of `N` channels: see the [module](self).
#[derive(Debug)]
pub struct Atkinson<'a, const N: usize> {
    /// What each pixel of the row, and the one below, was handed from above; behind the current pixel, one row further down.
    row: &'a mut [[[i16; N]; 2]],
    x: usize,
    /// For the next two pixels, and for the one below the next.
    right: [[i16; N]; 2],
    below_right: [i16; N],
}

impl<'a, const N: usize> Atkinson<'a, N> {
    /// For pictures that are as wide as `row` is long. What is in it does not matter.
    pub fn new(row: &'a mut [[[i16; N]; 2]]) -> Self {
        row.fill([[0; N]; 2]);
        Self { row, x: 0, right: [[0; N]; 2], below_right: [0; N] }
    }

    /// The next pixel: see [`FloydSteinberg::next`].
    #[inline]
    pub fn next<T>(&mut self, level: [u8; N], nearest: impl FnOnce([u8; N]) -> (T, [u8; N])) -> T {
        let Self { row, x, right, below_right } = self;
        let [above, below] = row.get(*x).copied().unwrap_or([[0; N]; 2]);
        let (chosen, error) = choose::<T, N, 8>(level, plus(above, right[0], 1), nearest);
        if let Some([before, _]) = x.checked_sub(1).and_then(|before| row.get_mut(before)) {
            *before = plus(*before, error, 1);
        }
        if let Some(here) = row.get_mut(*x) {
            *here = [plus(plus(below, *below_right, 1), error, 1), error];
        }
        (*right, *below_right) = ([plus(right[1], error, 1), error], error);
        *x = x.wrapping_add(1);
        if *x >= row.len() {
            (*x, *right, *below_right) = (0, [[0; N]; 2], [0; N]);
        }
        chosen
    }
}
