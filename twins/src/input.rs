//! [`Input`]: numbers out of bytes, those of a fuzzer or random ones.

use embedded_raster::Rect;

/// Numbers that break arithmetic: ends of types, centres of pixels, powers of two and their neighbours.
pub const EXTREMES: [i32; 21] = [
    i32::MIN,
    i32::MIN + 1,
    i32::MIN + 128,
    -(1 << 24),
    -65_537,
    -257,
    -128,
    -1,
    0,
    1,
    127,
    128,
    255,
    256,
    65_535,
    65_536,
    1 << 24,
    i32::MAX - 255,
    i32::MAX - 127,
    i32::MAX - 1,
    i32::MAX,
];

/// Takes numbers off the front; zeros when the bytes are used up.
#[derive(Clone)]
pub struct Input<'a>(pub &'a [u8]);

impl Input<'_> {
    /// The next byte.
    pub fn byte(&mut self) -> u8 {
        let Some((&first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        first
    }

    fn bytes(&mut self, n: usize) -> u32 {
        (0..n).fold(0, |bits, _| bits << 8 | u32::from(self.byte()))
    }

    /// Small or large, by the bits of a first byte, so that short inputs already say something.
    pub fn int(&mut self) -> i32 {
        let kind = self.byte();
        match kind >> 6 {
            0 => i32::from(kind & 63) * 128,
            1 => i32::from(self.bytes(2) as i16),
            2 => self.bytes(4) as i32,
            _ => [i32::MIN, i32::MAX, -1, 0][usize::from(kind & 3)].wrapping_add(i32::from(self.bytes(1) as i8)),
        }
    }

    /// Any number, mostly one that breaks arithmetic.
    pub fn wild(&mut self) -> i32 {
        match self.byte() {
            0..32 => self.bytes(4) as i32,
            32..96 => self.within(-40, 60),
            96..128 => self.within(-9_000, 9_000),
            n => EXTREMES[usize::from(n) % EXTREMES.len()],
        }
    }

    /// `0..n`, up to 65,536.
    pub fn below(&mut self, n: u32) -> u32 {
        let bits = if n <= 256 { 8 } else { 16 };
        (self.bytes(bits / 8) * n) >> bits
    }

    /// `0..n`, as an index.
    pub fn index(&mut self, n: usize) -> usize {
        self.below(n as u32) as usize
    }

    /// `low..=high`, no more than 65,536 numbers.
    pub fn within(&mut self, low: i32, high: i32) -> i32 {
        low + self.below((high - low + 1) as u32) as i32
    }

    /// True once in `n` times.
    pub fn one_in(&mut self, n: u32) -> bool {
        self.below(n) == 0
    }

    /// One of some.
    pub fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[self.index(from.len())]
    }

    /// A window of at most 16 x 16 pixels, anywhere.
    pub fn window(&mut self) -> Rect {
        let (x, y, size) = (self.int(), self.int(), self.byte());
        let (width, height) = (i32::from(size & 15) + 1, i32::from(size >> 4) + 1);
        Rect::new(x, y, x.saturating_add(width), y.saturating_add(height))
    }

    /// Mostly near another number, so that shapes and windows meet.
    pub fn near(&mut self, at: i32, step: i32) -> i32 {
        match self.byte() as i8 {
            i8::MIN => self.int(),
            n => at.saturating_add(i32::from(n).saturating_mul(step)),
        }
    }

    /// Corners in any order, mostly of a window or a few pixels off.
    pub fn area_near(&mut self, window: Rect) -> Rect {
        let (x0, y0) = (self.near(window.x0, 1), self.near(window.y0, 1));
        Rect::new(x0, y0, self.near(x0, 1), self.near(y0, 1))
    }

    /// A place in 24.8 units, mostly near a window.
    pub fn place_near(&mut self, window: Rect) -> (i32, i32) {
        let units = |n: i32| n.saturating_mul(256);
        let fine = self.byte();
        let mut near = |n: i32| self.near(units(n), 67).saturating_add((fine & 3).into());
        (near(window.x0), near(window.y0))
    }

    /// Whether there is more to read.
    pub fn goes_on(&self) -> bool {
        !self.0.is_empty()
    }
}
