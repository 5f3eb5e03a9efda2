//! [`Naive`]: pixels in memory, bit by bit.

use std::ops::Range;

use embedded_graphics_core::geometry::Point;
use embedded_raster::{Bitmap, Framebuffer, PixelFormat, Rect};

use super::rng::Rng;

/// What there is to know of a pixel format. The twin is not generic, so that it is compiled once.
#[derive(Clone, Copy)]
pub struct Format {
    /// For failures.
    pub name: &'static str,
    /// Of a pixel.
    pub bits: usize,
    /// Whether the first pixel is in the low bits of its byte.
    pub lsb0: bool,
    /// The bits of the colour of some bits: without those that no colour has, such as the sixteenth of `Rgb555`.
    color: fn(u32) -> u32,
}

impl Format {
    /// The format of the crate.
    pub fn of<F: PixelFormat>() -> Self {
        let color = |bits| F::pack(F::unpack(bits));
        Self { name: std::any::type_name::<F>(), bits: F::BITS as usize, lsb0: F::LSB0, color }
    }

    /// The bits of any colour.
    pub fn random(self, rng: &mut Rng) -> u32 {
        (self.color)((rng.bits() & ((1 << self.bits) - 1)) as u32)
    }

    /// Bytes of a row without a gap.
    pub fn row_bytes(self, width: usize) -> usize {
        (width * self.bits).div_ceil(8)
    }

    /// The bits of pixel `x` of the row that starts at byte `row`, as (byte, bit) from its least significant one.
    fn places(self, row: usize, x: usize) -> impl Iterator<Item = (usize, usize)> {
        let first = x * self.bits;
        (0..self.bits).map(move |i| {
            if self.bits >= 8 || self.lsb0 {
                // Bits count from the least significant one of the first byte.
                (row + (first + i) / 8, (first + i) % 8)
            } else {
                // Bits count from the most significant one, and a pixel's most significant one comes first.
                let bit = first + self.bits - 1 - i;
                (row + bit / 8, 7 - bit % 8)
            }
        })
    }

    /// Pixel `x` of the row that starts at byte `row`.
    pub fn read(self, bytes: &[u8], row: usize, x: usize) -> u32 {
        let bits = self.places(row, x).enumerate();
        (self.color)(bits.map(|(i, (byte, bit))| u32::from(bytes[byte] >> bit & 1) << i).sum())
    }

    /// The same pixel in a colour of these bits.
    pub fn write(self, bytes: &mut [u8], row: usize, x: usize, bits: u32) {
        for (i, (byte, bit)) in self.places(row, x).enumerate() {
            bytes[byte] = bytes[byte] & !(1 << bit) | ((bits >> i & 1) as u8) << bit;
        }
    }
}

/// Any colour of a format.
pub fn color<F: PixelFormat>(rng: &mut Rng) -> F::Color {
    F::unpack(Format::of::<F>().random(rng))
}

/// The twin of a framebuffer: reads and writes single bits where the table of formats says they are, in a buffer with
/// bytes before, between and after the rows that nobody may touch. Colours are their bits.
#[derive(Clone)]
pub struct Naive {
    /// Of its pixels.
    pub format: Format,
    /// All the memory, the bytes around included.
    pub bytes: Vec<u8>,
    /// Where in `bytes` the framebuffer is, and how many bytes it gets.
    pub place: Range<usize>,
    /// Bytes from row to row.
    pub stride: usize,
    /// In pixels.
    pub width: u16,
    /// In rows.
    pub height: u16,
}

impl Naive {
    /// Noise everywhere: in the pixels, the gaps, and around. The memory starts `start` bytes into an allocation, so that
    /// every alignment can be had, and may be larger than it has to be.
    pub fn random(rng: &mut Rng, format: Format, (width, height): (u16, u16), start: usize, gap: usize) -> Self {
        let stride = format.row_bytes(width.into()) + gap;
        let needed = usize::from(height) * stride;
        let bytes: Vec<u8> = (0..start + needed + 24).map(|_| rng.bits() as u8).collect();
        // The gap after the last row need not be there.
        let length = match height {
            _ if rng.one_in(2) => needed + 9,
            0 => 0,
            _ => needed - gap,
        };
        Self { format, bytes, place: start..start + length, stride, width, height }
    }

    /// Some bytes seen as the surface that this is the twin of.
    pub fn frame<'a, F: PixelFormat>(&self, bytes: &'a mut [u8]) -> Framebuffer<'a, F> {
        Framebuffer::with_stride(&mut bytes[self.place.clone()], self.width, self.height, self.stride)
            .expect("the memory is as large as the twin says")
    }

    /// Its own bytes, to read.
    pub fn bitmap<F: PixelFormat>(&self) -> Bitmap<'_, F> {
        Bitmap::with_stride(&self.bytes[self.place.clone()], self.width, self.height, self.stride)
            .expect("the memory is as large as the twin says")
    }

    /// All pixels.
    pub fn window(&self) -> Rect {
        Rect::new(0, 0, self.width.into(), self.height.into())
    }

    fn row(&self, y: i32) -> usize {
        self.place.start + y as usize * self.stride
    }

    /// `None` outside.
    pub fn get(&self, x: i32, y: i32) -> Option<u32> {
        self.window().contains(x, y).then(|| self.format.read(&self.bytes, self.row(y), x as usize))
    }

    /// Nothing outside.
    pub fn set(&mut self, x: i32, y: i32, color: u32) {
        if self.window().contains(x, y) {
            let row = self.row(y);
            self.format.write(&mut self.bytes, row, x as usize, color);
        }
    }

    /// A pixel named from the corner of `window`; nothing outside of it.
    pub fn set_in(&mut self, window: Rect, p: Point, color: u32) {
        let (x, y) = (p.x + window.x0, p.y + window.y0);
        if window.contains(x, y) {
            self.set(x, y, color);
        }
    }

    /// The pixels of `area` inside of the surface.
    pub fn fill(&mut self, area: Rect, color: u32) {
        for (x, y) in pixels(area.intersection(self.window())) {
            self.set(x, y, color);
        }
    }

    /// The pixels of `source` in `part`, the top left one at `at`, except those of the colour `key`; only inside `clip`.
    pub fn blit(&mut self, clip: Rect, at: Point, source: &Self, part: Rect, key: Option<u32>) {
        let part = part.intersection(source.window());
        self.put(clip, at, part, |x, y| source.get(x, y).filter(|&color| key != Some(color)));
    }

    /// The pixels of a mask in `part`, the top left one at `at`: those that are set in one colour, the others in another or
    /// not at all; only inside `clip`.
    pub fn blit_mask(&mut self, clip: Rect, at: Point, mask: &Self, part: Rect, (on, off): (u32, Option<u32>)) {
        let part = part.intersection(mask.window());
        self.put(clip, at, part, |x, y| if mask.get(x, y) == Some(1) { Some(on) } else { off });
    }

    fn put(&mut self, clip: Rect, at: Point, part: Rect, color: impl Fn(i32, i32) -> Option<u32>) {
        for (x, y) in pixels(part) {
            let to = |at: i32, n: i32, from: i32| i32::try_from(i64::from(at) + i64::from(n) - i64::from(from));
            let (Ok(to_x), Ok(to_y)) = (to(at.x, x, part.x0), to(at.y, y, part.y0)) else { continue };
            if let Some(color) = color(x, y).filter(|_| clip.contains(to_x, to_y)) {
                self.set(to_x, to_y, color);
            }
        }
    }

    /// The pixels of `area` moved so that its top left one, seen or not, falls on `to`; only inside `clip`.
    pub fn move_area(&mut self, clip: Rect, area: Rect, to: Point, key: Option<u32>) {
        let seen = area.intersection(clip).intersection(self.window());
        let shift = |to: i32, from: i32, seen: i32| i64::from(to) + i64::from(seen) - i64::from(from);
        let (x, y) = (shift(to.x, area.x0, seen.x0), shift(to.y, area.y0, seen.y0));
        if let (Ok(x), Ok(y)) = (i32::try_from(x), i32::try_from(y)) {
            let picture = self.clone();
            self.blit(clip, Point::new(x, y), &picture, seen, key);
        }
    }

    /// Bits of a pixel that no colour has may be kept or lost by copies.
    fn without_unused_bits(&self) -> Vec<u8> {
        let mut copy = self.clone();
        for (x, y) in pixels(self.window()) {
            let color = self.get(x, y).expect("inside");
            copy.set(x, y, color);
        }
        copy.bytes
    }

    /// Every byte is what it has to be, those around the pixels included.
    #[track_caller]
    pub fn assert_same(&self, real: &[u8], what: &dyn Fn() -> String) {
        if self.bytes == real {
            return;
        }
        let real = Self { bytes: real.to_vec(), ..self.clone() };
        let (wanted, got) = (self.without_unused_bits(), real.without_unused_bits());
        let Some(at) = wanted.iter().zip(&got).position(|(a, b)| a != b) else { return };
        let near = |bytes: &[u8]| format!("{:02x?}", &bytes[at.saturating_sub(8)..bytes.len().min(at + 9)]);
        panic!(
            "{}: byte {at} differs in {} x {} {} pixels in bytes {:?}, stride {}\nwanted {}\ngot    {}",
            what(),
            self.width,
            self.height,
            self.format.name,
            self.place,
            self.stride,
            near(&wanted),
            near(&got)
        );
    }
}

/// The pixels of a rectangle, row by row.
pub fn pixels(area: Rect) -> impl Iterator<Item = (i32, i32)> {
    let columns = if area.is_empty() { 0..0 } else { area.x0..area.x1 };
    let rows = if area.is_empty() { 0..0 } else { area.y0..area.y1 };
    rows.flat_map(move |y| columns.clone().map(move |x| (x, y)))
}
