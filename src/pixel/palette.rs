//! [`Palette`]: colour tables (CLUT).

use embedded_graphics_core::pixelcolor::{raw::RawU8, PixelColor, Rgb888, RgbColor};

use super::{
    channels::Channels,
    color::Rgb332,
    format::PixelFormat,
    levels::{nearest, rescale},
    rows,
};
use crate::{
    num::cast::{low_u16, low_u32, low_u8},
    tune::{keep_order, COMPACT, UNALIGNED},
};

/// A table of `N` colours that indices are shown through.
///
/// When an entry is changed, every pixel with its index looks different the next time it is shown, and no pixel has to be
/// written. That is palette animation.
/// ```
/// use embedded_graphics_core::pixelcolor::{Rgb565, Rgb888, RgbColor};
/// use embedded_raster::{pixel::EGA, Palette};
/// let mut palette: Palette<Rgb565, 16> = EGA.map(Rgb565::from);
/// assert_eq!(palette.get(4), Some(Rgb565::from(Rgb888::new(170, 0, 0))));
/// palette.set(4, Rgb565::RED);
/// palette.rotate(1..5, 1); // entry 4 moves to the front of the range
/// assert_eq!(palette.get(1), Some(Rgb565::RED));
/// ```
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Palette<C, const N: usize> {
    colors: [C; N],
}

impl<C: Copy, const N: usize> Palette<C, N> {
    /// A table of these colours.
    #[inline]
    pub const fn new(colors: [C; N]) -> Self {
        Self { colors }
    }

    /// The colours, for reading back.
    #[inline]
    pub const fn colors(&self) -> &[C; N] {
        &self.colors
    }

    /// The colour of an index; `None` beyond the table.
    #[inline]
    pub fn get(&self, index: u8) -> Option<C> {
        self.colors.get(usize::from(index)).copied()
    }

    /// Changes the colour of an index. Says whether the table has that index.
    #[inline]
    pub fn set(&mut self, index: u8, color: C) -> bool {
        self.colors.get_mut(usize::from(index)).map(|entry| *entry = color).is_some()
    }

    /// Moves the colours of a range of indices up by `by` places, those at its end to its start: colour cycling. Indices
    /// beyond the table are left out.
    pub fn rotate(&mut self, range: core::ops::Range<usize>, by: usize) {
        let end = range.end.min(N);
        let Some(colors) = self.colors.get_mut(range.start.min(end)..end) else { return };
        let Some(by) = by.checked_rem(colors.len()) else { return };
        // Three reversals: a rotation without a table of its own.
        colors.reverse();
        if let Some((front, back)) = colors.split_at_mut_checked(by) {
            front.reverse();
            back.reverse();
        }
    }

    /// The same table in another colour type.
    #[inline]
    pub fn map<D: Copy>(&self, convert: impl FnMut(C) -> D) -> Palette<D, N> {
        Palette { colors: self.colors.map(convert) }
    }
}

impl<C: PixelColor, const N: usize> Palette<C, N> {
    /// Writes the colours of a row of indices as pixels of format `O`: to send an indexed framebuffer to a display that has no
    /// colour table.
    ///
    /// * `indices`: pixels of the format `I`, of at most 8 bits (others do not compile), the first one at the first byte.
    /// * `out`: the pixels to write. The shorter of the two says how many.
    ///
    /// An index beyond the table is shown as the first colour.
    /// ```
    /// use embedded_graphics_core::pixelcolor::{Rgb565, Rgb888};
    /// use embedded_raster::{pixel::{Be, EGA}, Index4};
    /// let palette = EGA.map(Rgb565::from);
    /// let mut line = [0; 4 * 2];
    /// palette.expand::<Index4, Be<Rgb565>>(&[0x04, 0x2f], &mut line);
    /// assert_eq!(line, [0, 0, 0xa8, 0, 0x05, 0x40, 0xff, 0xff]);
    /// ```
    #[inline]
    pub fn expand<I: PixelFormat, O: PixelFormat<Color = C>>(&self, indices: &[u8], out: &mut [u8]) {
        const { assert!(I::BITS <= 8, "indices have at most 8 bits") };
        let first = self.colors.first().copied();
        let color = |index: u8| self.colors.get(usize::from(index)).copied().or(first).map_or(0, O::pack);
        match O::BITS {
            8 => expand::<I, u8, 1>(indices, out, |index| [low_u8(color(index))]),
            16 if I::BITS == 4 && BY_WORDS => {
                let mut index = 0;
                let table = [(); 16].map(|()| {
                    let bits = low_u16(color(index));
                    index = index.wrapping_add(1);
                    bits
                });
                expand_words::<I>(indices, out, &table);
            }
            16 => {
                let even = out.len() & !1;
                match out.get_mut(..even).map(bytemuck::try_cast_slice_mut) {
                    Some(Ok(out)) if BY_HALVES => {
                        expand::<I, u16, 1>(indices, out, |index| [low_u16(color(index)).to_le()]);
                    }
                    _ => expand::<I, u8, 2>(indices, out, |index| low_u16(color(index)).to_le_bytes()),
                }
            }
            24 => expand::<I, u8, 3>(indices, out, |index| {
                let [a, b, c, _] = color(index).to_le_bytes();
                [a, b, c]
            }),
            32 => expand::<I, u8, 4>(indices, out, |index| color(index).to_le_bytes()),
            _ => {
                let pixels = |bytes: usize, bits: u32| bytes.saturating_mul((8 / bits) as usize);
                let pixels = pixels(indices.len(), I::BITS).min(pixels(out.len(), O::BITS));
                for x in 0..pixels {
                    let index = low_u8(rows::get::<I>(indices, 0, x));
                    rows::set::<O>(out, 0, x, color(index));
                }
            }
        }
    }
}

/// Whether sixteen pixels are written at a time.
const ROUNDS: bool = !COMPACT;

/// Whether pixels of 16 bits are stored by halves of words where they are aligned. These cores would store their bytes one by one.
const BY_HALVES: bool = !UNALIGNED && !COMPACT;

/// Pixels of `N` units each, bytes or more, out of 1, 2, 4 or 8-bit indices.
#[inline(always)]
fn expand<I: PixelFormat, T: Copy, const N: usize>(indices: &[u8], out: &mut [T], pixel: impl Fn(u8) -> [T; N]) {
    let per_byte = (8 / I::BITS) as usize;
    // Sixteen pixels to a round. What is left over is shorter, and may end within a byte.
    let (bytes_per_round, size) = (2 * I::BITS as usize, N * per_byte);
    let rounds = if ROUNDS { (indices.len() / bytes_per_round).min(out.len() / (16 * N)) } else { 0 };
    let indices = indices.split_at_checked(rounds.wrapping_mul(bytes_per_round));
    let out = out.split_at_mut_checked(rounds.wrapping_mul(16 * N));
    let (Some((all_bytes, indices)), Some((all_places, out))) = (indices, out) else { return };
    if ROUNDS {
        for (bytes, round) in all_bytes.chunks_exact(bytes_per_round).zip(all_places.chunks_exact_mut(16 * N)) {
            for i in 0..bytes_per_round {
                let at = i.wrapping_mul(size);
                if let (Some(places), Some(&byte)) = (round.get_mut(at..at.wrapping_add(size)), bytes.get(i)) {
                    put::<I, T, N>(places, byte, &pixel);
                }
                // Without this the compiler loads all indices first, and there are not enough registers for them.
                if i.wrapping_add(1).wrapping_mul(per_byte).is_multiple_of(4) {
                    keep_order();
                }
            }
        }
    }
    expand_rest::<I, T, N>(indices, out, pixel);
}

/// The same byte by byte.
#[inline(always)]
fn expand_rest<I: PixelFormat, T: Copy, const N: usize>(indices: &[u8], out: &mut [T], pixel: impl Fn(u8) -> [T; N]) {
    for (places, &byte) in out.chunks_mut(N * (8 / I::BITS) as usize).zip(indices) {
        put::<I, T, N>(places, byte, &pixel);
    }
}

/// The pixels of a byte of indices, as many as there are places for.
#[inline(always)]
fn put<I: PixelFormat, T: Copy, const N: usize>(places: &mut [T], byte: u8, pixel: &impl Fn(u8) -> [T; N]) {
    // Plain indices: the counters of `enumerate` have overflow checks, and the set-up of `zip` divides.
    for i in 0..(8 / I::BITS) as usize {
        let at = i.wrapping_mul(N);
        if let Some(place) = places.get_mut(at..at.wrapping_add(N)).and_then(<[T]>::first_chunk_mut) {
            *place = pixel(low_u8(rows::packed::nth::<I>(byte, i)));
        }
    }
}

impl<C: Channels, const N: usize> Palette<C, N> {
    /// The table that is `level` of 255 parts on the way to another one, entry by entry: of each channel the nearest level. Drawn
    /// pixels fade from one picture into another.
    /// ```
    /// use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
    /// use embedded_raster::{pixel::EGA, Palette};
    /// let night = Palette::new([Rgb888::BLACK; 16]);
    /// let dusk = EGA.between(&night, 51); // a fifth of the way
    /// assert_eq!(dusk.get(7), Some(Rgb888::new(136, 136, 136)));
    /// assert_eq!((EGA.between(&night, 0), EGA.between(&night, 255)), (EGA, night));
    /// ```
    #[must_use]
    pub fn between(&self, other: &Self, level: u8) -> Self {
        let mut colors = self.colors;
        for (color, &other) in colors.iter_mut().zip(&other.colors) {
            *color = C::between([*color, other], level);
        }
        Self { colors }
    }
}

/// Whether indices of 4 bits are taken out of words, and colours stored two at a time: where words lie at any address.
const BY_WORDS: bool = UNALIGNED && !COMPACT;

/// Pixels of 16 bits out of 4-bit indices, eight to a round. The table has them as they are stored, so that nothing is converted at a
/// pixel. It takes 16 conversions, which a row of a screen has back many times.
///
/// Four indices are taken out of a word before their colours are looked up: loads that follow each other overlap on Cortex-M4, and none
/// waits for an address that was computed just before it.
fn expand_words<I: PixelFormat>(indices: &[u8], out: &mut [u8], table: &[u16; 16]) {
    let color = |index: u8| table.get(usize::from(index & 15)).copied().unwrap_or_default();
    let rounds = (indices.len() / 4).min(out.len() / 16);
    let indices = indices.split_at_checked(rounds.wrapping_mul(4));
    let out = out.split_at_mut_checked(rounds.wrapping_mul(16));
    let (Some((all_bytes, indices)), Some((all_places, out))) = (indices, out) else { return };
    for (bytes, round) in all_bytes.chunks_exact(4).zip(all_places.chunks_exact_mut(16)) {
        let Some(bytes) = bytes.first_chunk() else { continue };
        let word = u32::from_le_bytes(*bytes);
        for (half, four) in [word, word >> 16].into_iter().zip(round.chunks_exact_mut(8)) {
            let [first, second] = [low_u8(half), low_u8(half >> 8)];
            let places = [(first, 0), (first, 1), (second, 0), (second, 1)];
            let [a, b, c, d] = places.map(|(byte, i)| low_u8(rows::packed::nth::<I>(byte, i)));
            let [a, b, c, d] = [a, b, c, d].map(|index| u32::from(color(index)));
            for (pair, place) in [a | b << 16, c | d << 16].into_iter().zip(four.chunks_exact_mut(4)) {
                if let Some(place) = place.first_chunk_mut() {
                    *place = pair.to_le_bytes();
                }
            }
            keep_order();
        }
    }
    expand_rest::<I, u8, 2>(indices, out, |index| color(index).to_le_bytes());
}

impl<C: RgbColor, const N: usize> Palette<C, N> {
    /// The index of the entry nearest to a colour: least sum of squared channel differences, the first one at a tie.
    /// Channels are compared in units of their own type. 0 for an empty table.
    /// ```
    /// use embedded_graphics_core::pixelcolor::Rgb888;
    /// use embedded_raster::pixel::EGA;
    /// assert_eq!(EGA.nearest(Rgb888::new(250, 90, 80)), 12); // light red
    /// ```
    pub fn nearest(&self, color: C) -> u8 {
        nearest(self.colors.iter().copied(), color)
    }
}

impl<const N: usize> Palette<Rgb888, N> {
    /// Greys from black to white in even steps.
    pub const fn greys() -> Self {
        let mut colors = [Rgb888::BLACK; N];
        let mut i = 0;
        while i < N {
            let last = if N > 1 { N - 1 } else { 1 };
            #[expect(clippy::cast_possible_truncation, reason = "at most 255")]
            let grey = ((2 * i * 255 + last) / (2 * last)) as u8;
            colors[i] = Rgb888::new(grey, grey, grey);
            i += 1;
        }
        Self { colors }
    }
}

impl Palette<Rgb888, 256> {
    /// Every RGB332 colour at the index that has its bits.
    pub fn rgb332() -> Self {
        let mut index = 0;
        Self {
            colors: [(); 256].map(|()| {
                let color = Rgb332::from(RawU8::new(index)).into();
                index = index.wrapping_add(1);
                color
            }),
        }
    }
}

impl Palette<Rgb888, 216> {
    /// The web-safe colours: six levels a channel, index `36 r + 6 g + b`.
    pub const fn web_safe() -> Self {
        let mut colors = [Rgb888::BLACK; 216];
        let mut i = 0;
        while i < 216 {
            let n = low_u32(i as u64);
            colors[i] = Rgb888::new(
                rescale(low_u8(n / 36), 5, 255),
                rescale(low_u8(n / 6 % 6), 5, 255),
                rescale(low_u8(n % 6), 5, 255),
            );
            i += 1;
        }
        Self { colors }
    }
}
