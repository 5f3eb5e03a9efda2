//! Numbers out of the fuzzer's bytes.
#![allow(dead_code, reason = "every target takes what it needs")]

use embedded_raster::Rect;

/// Takes numbers off the front; zeros when the bytes are used up.
pub(crate) struct Input<'a>(pub(crate) &'a [u8]);

impl Input<'_> {
    pub(crate) fn byte(&mut self) -> u8 {
        let Some((&first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        first
    }

    /// Small or large, by the bits of a first byte, so that short inputs already say something.
    pub(crate) fn int(&mut self) -> i32 {
        let kind = self.byte();
        let mut bytes = |n: usize| (0..n).fold(0_u32, |bits, _| bits << 8 | u32::from(self.byte()));
        match kind >> 6 {
            0 => i32::from(kind & 63) * 128,
            1 => i32::from(bytes(2) as i16),
            2 => bytes(4) as i32,
            _ => [i32::MIN, i32::MAX, -1, 0][usize::from(kind & 3)].wrapping_add(i32::from(bytes(1) as i8)),
        }
    }

    /// A window of at most 16 x 16 pixels, anywhere.
    pub(crate) fn window(&mut self) -> Rect {
        let (x, y, size) = (self.int(), self.int(), self.byte());
        let (width, height) = (i32::from(size & 15) + 1, i32::from(size >> 4) + 1);
        Rect::new(x, y, x.saturating_add(width), y.saturating_add(height))
    }

    /// Mostly near another number, so that shapes and windows meet.
    pub(crate) fn near(&mut self, at: i32, step: i32) -> i32 {
        match self.byte() as i8 {
            i8::MIN => self.int(),
            n => at.saturating_add(i32::from(n).saturating_mul(step)),
        }
    }

    /// Corners in any order, mostly of a window or a few pixels off.
    pub(crate) fn area_near(&mut self, window: Rect) -> Rect {
        let (x0, y0) = (self.near(window.x0, 1), self.near(window.y0, 1));
        Rect::new(x0, y0, self.near(x0, 1), self.near(y0, 1))
    }

    /// A place in 24.8 units, mostly near a window.
    pub(crate) fn place_near(&mut self, window: Rect) -> (i32, i32) {
        let units = |n: i32| n.saturating_mul(256);
        let fine = self.byte();
        let mut near = |n: i32| self.near(units(n), 67).saturating_add((fine & 3).into());
        (near(window.x0), near(window.y0))
    }

    /// Whether there is more to read.
    pub(crate) fn goes_on(&self) -> bool {
        !self.0.is_empty()
    }
}
