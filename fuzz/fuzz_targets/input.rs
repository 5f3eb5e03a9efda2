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

    /// Whether there is more to read.
    pub(crate) fn goes_on(&self) -> bool {
        !self.0.is_empty()
    }
}
