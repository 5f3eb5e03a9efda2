//! The screen that everything is drawn on, as plain as possible, and which of its pixels are painted.

use embedded_raster::{ClippedSpan, Rect};

pub(crate) const WIDTH: i32 = 320;
pub(crate) const HEIGHT: i32 = 240;
/// The whole screen.
pub(crate) const WINDOW: Rect = Rect::new(0, 0, WIDTH, HEIGHT);
const SIZE: usize = (WIDTH * HEIGHT) as usize;

/// The colour of everything: its two bytes differ, as those of most colours do.
pub(crate) const INK: u16 = 0xb6d3;

/// RGB565 pixels in a vector: what the textbook algorithms draw on.
pub(crate) struct Frame(Vec<u16>);

impl Frame {
    pub(crate) fn new() -> Self {
        Self(vec![0; SIZE])
    }

    pub(crate) fn clear(&mut self) {
        self.0.fill(0);
    }

    /// White walls on black.
    pub(crate) fn load(&mut self, walls: &[bool]) {
        self.0.iter_mut().zip(walls).for_each(|(pixel, &wall)| *pixel = if wall { 0xffff } else { 0 });
    }

    /// Whether a pixel lies on the screen and is black.
    #[inline(always)]
    pub(crate) fn is_empty(&self, x: i32, y: i32) -> bool {
        (x as u32) < WIDTH as u32 && (y as u32) < HEIGHT as u32 && self.0[(y * WIDTH + x) as usize] == 0
    }

    /// Paints a pixel if it lies on the screen.
    #[inline(always)]
    pub(crate) fn put(&mut self, x: i32, y: i32) {
        // One comparison a side: negative numbers become large ones.
        if (x as u32) < WIDTH as u32 && (y as u32) < HEIGHT as u32 {
            self.0[(y * WIDTH + x) as usize] = INK;
        }
    }

    /// Paints pixels `x0..x1` of a row, all of which lie on the screen.
    #[inline(always)]
    pub(crate) fn row(&mut self, y: i32, x0: i32, x1: i32) {
        let start = y * WIDTH;
        self.0[(start + x0) as usize..(start + x1) as usize].fill(INK);
    }

    #[inline(always)]
    pub(crate) fn span(&mut self, span: ClippedSpan) {
        self.row(span.y(), span.x0(), span.x1());
    }

    pub(crate) fn painted(&self) -> Mask {
        Mask(self.0.iter().map(|&p| p == INK).collect())
    }
}

/// Which pixels of the screen are painted.
#[derive(Clone, PartialEq, Eq)]
pub(crate) struct Mask(Vec<bool>);

impl Mask {
    /// From the pixels in reading order.
    pub(crate) fn from_pixels(pixels: impl Iterator<Item = bool>) -> Self {
        let mask = Self(pixels.collect());
        assert_eq!(mask.0.len(), SIZE, "one for each pixel of the screen");
        mask
    }

    pub(crate) fn has(&self, x: i32, y: i32) -> bool {
        WINDOW.contains(x, y) && self.0[(y * WIDTH + x) as usize]
    }

    pub(crate) fn bits(&self) -> &[bool] {
        &self.0
    }

    /// The painted pixels.
    pub(crate) fn pixels(&self) -> impl Iterator<Item = (i32, i32)> + '_ {
        (0..HEIGHT).flat_map(move |y| (0..WIDTH).map(move |x| (x, y))).filter(|&(x, y)| self.has(x, y))
    }
}
