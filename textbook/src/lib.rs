//! Shaded triangles as they are usually written: in floats and in fixed point of some width. The report compares with them.
//!
//! ```text
//!  scene                    triangles with levels, depths and places in a texture at their corners
//!    |
//!  gouraud, depth, texture  one function for each way to draw them on a slice of pixels
//!    |
//!  float, fixed             a triangle to spans, with values at the first pixel of each and gains from one to the next
//!    |
//!  Span::each               the values at each pixel
//!  perspective              the same, divided by what 1 / w is there: at each pixel, or at the ends of runs
//! ```
//! All of them paint the pixels whose centres lie inside, each as well as its numbers can tell, and take values at centres where
//! they say so. There is no allocation and nothing of a host in here: a chip runs the same code as the host.
#![no_std]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    clippy::missing_panics_doc,
    reason = "this is how it is usually written; what it costs and how wrong it is are measured"
)]

pub mod depth;
pub mod fixed;
pub mod float;
pub mod gouraud;
pub mod perspective;
pub mod scene;
pub mod texture;

/// The size of what is drawn on.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Size {
    /// Pixels in a row.
    pub width: i32,
    /// Rows.
    pub height: i32,
}

/// A number that changes along a span.
pub trait Number: Copy {
    /// The sum, which wraps if it is one of integers.
    #[must_use]
    fn plus(self, by: Self) -> Self;
}

impl Number for f32 {
    #[inline(always)]
    fn plus(self, by: Self) -> Self {
        self + by
    }
}

impl Number for i32 {
    #[inline(always)]
    fn plus(self, by: Self) -> Self {
        self.wrapping_add(by)
    }
}

impl Number for i64 {
    #[inline(always)]
    fn plus(self, by: Self) -> Self {
        self.wrapping_add(by)
    }
}

/// Some pixels of a row, with N values at the first of them.
#[derive(Copy, Clone, Debug)]
pub struct Span<T, const N: usize> {
    /// The first pixel, counted in reading order.
    pub start: usize,
    /// How many pixels.
    pub len: usize,
    /// The values at the first pixel.
    pub at: [T; N],
    /// What they gain from each pixel to the next.
    pub by: [T; N],
}

impl<T: Number, const N: usize> Span<T, N> {
    /// Calls `pixel` with the values at each pixel.
    #[inline(always)]
    pub fn each(self, mut pixel: impl FnMut(usize, [T; N])) {
        let mut at = self.at;
        for place in self.start..self.start + self.len {
            pixel(place, at);
            at.iter_mut().zip(self.by).for_each(|(at, by)| *at = at.plus(by));
        }
    }
}

/// Three corners from the top down.
#[inline]
fn sorted<T: PartialOrd + Copy, V: Copy>(corners: [[T; 2]; 3], values: [V; 3]) -> [([T; 2], V); 3] {
    let mut all = [(corners[0], values[0]), (corners[1], values[1]), (corners[2], values[2])];
    for (i, j) in [(0, 1), (1, 2), (0, 1)] {
        if all[j].0[1] < all[i].0[1] {
            all.swap(i, j);
        }
    }
    all
}
