//! [`Naive`]: pixels in memory, bit by bit.

use std::{marker::PhantomData, ops::Range};

use embedded_graphics_core::geometry::Point;
use embedded_raster::{pixel, Bitmap, Framebuffer, PixelFormat, Rect};

use super::rng::Rng;

/// The twin of a framebuffer: reads and writes single bits where the table of formats says they are, in a buffer with
/// bytes before, between and after the rows that nobody may touch.
pub(crate) struct Naive<F> {
    pub(crate) bytes: Vec<u8>,
    /// Where in `bytes` the framebuffer is, and how many bytes it gets.
    pub(crate) place: Range<usize>,
    pub(crate) stride: usize,
    pub(crate) width: u16,
    pub(crate) height: u16,
    format: PhantomData<F>,
}

/// By hand: a format need not be one that can be cloned.
impl<F> Clone for Naive<F> {
    fn clone(&self) -> Self {
        Self { bytes: self.bytes.clone(), place: self.place.clone(), ..*self }
    }
}

/// Any colour of a format.
pub(crate) fn color<F: PixelFormat>(rng: &mut Rng) -> F::Color {
    F::unpack((rng.bits() & ((1 << F::BITS) - 1)) as u32)
}

impl<F: PixelFormat> Naive<F> {
    /// Noise everywhere: in the pixels, the gaps, and around. The memory starts `start` bytes into an allocation, so that
    /// every alignment can be had, and may be larger than it has to be.
    pub(crate) fn random(rng: &mut Rng, (width, height): (u16, u16), start: usize, gap: usize) -> Self {
        let stride = pixel::row_bytes::<F>(width) + gap;
        let needed = usize::from(height) * stride;
        let exact = rng.one_in(2);
        let bytes: Vec<u8> = (0..start + needed + 24).map(|_| rng.bits() as u8).collect();
        // The gap after the last row need not be there.
        let length = if !exact {
            needed + 9
        } else if height == 0 {
            0
        } else {
            needed - gap
        };
        Self { bytes, place: start..start + length, stride, width, height, format: PhantomData }
    }

    /// The same bytes seen as another surface that starts there and has these columns and rows.
    pub(crate) fn frame<'a>(&self, bytes: &'a mut [u8]) -> Framebuffer<'a, F> {
        Framebuffer::with_stride(&mut bytes[self.place.clone()], self.width, self.height, self.stride)
            .expect("the memory is as large as the twin says")
    }

    pub(crate) fn bitmap(&self) -> Bitmap<'_, F> {
        Bitmap::with_stride(&self.bytes[self.place.clone()], self.width, self.height, self.stride)
            .expect("the memory is as large as the twin says")
    }

    pub(crate) fn window(&self) -> Rect {
        Rect::new(0, 0, self.width.into(), self.height.into())
    }

    /// The bits of a pixel, as (byte, bit) from its least significant one.
    fn places(&self, x: i32, y: i32) -> impl Iterator<Item = (usize, u32)> {
        let row = self.place.start + y as usize * self.stride;
        let first = x as usize * F::BITS as usize;
        (0..F::BITS as usize).map(move |i| {
            if F::BITS >= 8 || F::LSB0 {
                // Bits count from the least significant one of the first byte.
                (row + (first + i) / 8, ((first + i) % 8) as u32)
            } else {
                // Bits count from the most significant one, and a pixel's most significant one comes first.
                let bit = first + F::BITS as usize - 1 - i;
                (row + bit / 8, 7 - (bit % 8) as u32)
            }
        })
    }

    pub(crate) fn bits(&self, x: i32, y: i32) -> u32 {
        self.places(x, y).enumerate().map(|(i, (byte, bit))| u32::from(self.bytes[byte] >> bit & 1) << i).sum()
    }

    pub(crate) fn set_bits(&mut self, x: i32, y: i32, bits: u32) {
        let places: Vec<_> = self.places(x, y).collect();
        for (i, (byte, bit)) in places.into_iter().enumerate() {
            self.bytes[byte] = self.bytes[byte] & !(1 << bit) | ((bits >> i & 1) as u8) << bit;
        }
    }

    pub(crate) fn get(&self, x: i32, y: i32) -> Option<F::Color> {
        self.window().contains(x, y).then(|| F::unpack(self.bits(x, y)))
    }

    /// Nothing outside.
    pub(crate) fn set(&mut self, x: i32, y: i32, color: F::Color) {
        if self.window().contains(x, y) {
            self.set_bits(x, y, F::pack(color));
        }
    }

    /// A pixel named from the corner of `window`; nothing outside of it.
    pub(crate) fn set_in(&mut self, window: Rect, p: Point, color: F::Color) {
        let (x, y) = (p.x + window.x0, p.y + window.y0);
        if window.contains(x, y) {
            self.set(x, y, color);
        }
    }

    /// The pixels of `area` inside of the surface.
    pub(crate) fn fill(&mut self, area: Rect, color: F::Color) {
        let area = area.intersection(self.window());
        for y in area.y0..area.y1 {
            for x in area.x0..area.x1 {
                self.set(x, y, color);
            }
        }
    }

    /// The pixels of `source` in `part`, the top left one at `at`, except those of the colour `key`; only inside `clip`.
    pub(crate) fn blit(&mut self, clip: Rect, at: Point, source: &Self, part: Rect, key: Option<F::Color>) {
        let part = part.intersection(source.window());
        let picture = source.clone();
        for y in part.y0..part.y1 {
            for x in part.x0..part.x1 {
                let color = picture.get(x, y).expect("inside");
                let to = |at: i32, n: i32, from: i32| i32::try_from(i64::from(at) + i64::from(n) - i64::from(from));
                let (Ok(to_x), Ok(to_y)) = (to(at.x, x, part.x0), to(at.y, y, part.y0)) else { continue };
                if clip.contains(to_x, to_y) && key != Some(color) {
                    self.set(to_x, to_y, color);
                }
            }
        }
    }

    /// The pixels of `area` moved so that its top left one, seen or not, falls on `to`; only inside `clip`.
    pub(crate) fn move_area(&mut self, clip: Rect, area: Rect, to: Point, key: Option<F::Color>) {
        let seen = area.intersection(clip).intersection(self.window());
        let shift = |to: i32, from: i32, seen: i32| i64::from(to) + i64::from(seen) - i64::from(from);
        let (x, y) = (shift(to.x, area.x0, seen.x0), shift(to.y, area.y0, seen.y0));
        if let (Ok(x), Ok(y)) = (i32::try_from(x), i32::try_from(y)) {
            let picture = self.clone();
            self.blit(clip, Point::new(x, y), &picture, seen, key);
        }
    }

    /// Bits of a pixel that no colour has (the sixteenth of `Rgb555`) may be kept or lost by copies.
    fn without_unused_bits(&self) -> Vec<u8> {
        let mut copy = self.clone();
        for y in 0..i32::from(self.height) {
            for x in 0..i32::from(self.width) {
                let bits = F::pack(F::unpack(copy.bits(x, y)));
                copy.set_bits(x, y, bits);
            }
        }
        copy.bytes
    }

    /// Every byte is what it has to be, those around the pixels included.
    #[track_caller]
    pub(crate) fn assert_same(&self, real: &[u8], what: impl FnOnce() -> String) {
        if self.bytes != real {
            let real = Self { bytes: real.to_vec(), ..self.clone() };
            let (wanted, got) = (self.without_unused_bits(), real.without_unused_bits());
            let Some(at) = wanted.iter().zip(&got).position(|(a, b)| a != b) else { return };
            let near = |bytes: &[u8]| format!("{:02x?}", &bytes[at.saturating_sub(8)..bytes.len().min(at + 9)]);
            panic!(
                "{}: byte {at} differs in {} x {} {} pixels in bytes {:?}, stride {}\nwanted {}\ngot    {}",
                what(),
                self.width,
                self.height,
                std::any::type_name::<F>(),
                self.place,
                self.stride,
                near(&wanted),
                near(&got)
            );
        }
    }
}
