//! [`Font`]: glyphs as bytes.
//!
//! All is checked when a font is read, so that nothing is checked when it is drawn: looking a glyph up is a search in sorted ranges, an
//! entry or a product, and a slice.

use core::fmt;

use bytemuck::pod_align_to;

use crate::{
    error::FontError,
    num::cast::low_u16,
    tune::{keep_branch, COMPACT},
};

/// The first bytes of every font.
const MAGIC: [u8; 4] = *b"erf1";

/// Bytes before the ranges.
const HEADER: usize = 20;

/// Bytes of a range, and of an entry.
const RECORD: usize = 8;

/// A bitmap font: glyphs of one bit per pixel, each for some character.
///
/// It is read from bytes, which the tool `fontbake` makes: `include_bytes!`, a part of the flash, or a file. What
/// [`read`](Self::read) accepts is a font, whoever made it: nothing is checked later. Reading is `const`, so a font in
/// flash can be a constant, and its bytes are checked by the compiler.
/// ```
/// use embedded_raster::text::Font;
/// // Cells of 4 x 4; "x" is the only glyph, and stands for all others.
/// const BYTES: [u8; 20 + 8 + 3] = *b"erf1\x04\x03\x04\0\0\x03\x03\0\x01\0\0\0\x01\0\0\0x\0\0\0\x01\0\0\0\xa0\x40\xa0";
/// const FONT: Font<'static> = match Font::read(&BYTES) {
///     Ok(font) => font,
///     Err(_) => panic!("not a font"),
/// };
/// assert_eq!((FONT.height(), FONT.width("xxx")), (4, 12));
/// assert!(FONT.has('x') && !FONT.has('y'));
/// ```
///
/// # Bytes
/// Numbers of several bytes have the least significant one first.
///
/// | bytes | what |
/// |---|---|
/// | 4 | `erf1` |
/// | 1 | rows of a cell, at least 1 |
/// | 1 | rows of a cell down to the baseline, with it |
/// | 5 | the glyph that all are like: advance; columns on the left of its box (signed), rows above it; columns and rows of it |
/// | 1 | 0 if all glyphs are like that one, 1 if each has an entry of its own |
/// | 2 | glyphs, at least 1 |
/// | 2 | which of them stands for characters that the font lacks |
/// | 2 | ranges of characters |
/// | 2 | 0 |
/// | 8 for each range | the first character (4), how many there are (2), the glyph of the first (2) |
/// | 8 for each entry | where its bits begin (3), and what is said of a glyph above (5) |
/// | | bits |
///
/// Ranges are sorted and do not overlap. The bits of a glyph are those of its box, in strips of eight columns: first the strip at
/// its left, a byte for each row from the top down, with the leftmost pixel in the most significant bit; then the next strip.
/// What lies beyond the last column is 0. Without entries, bits begin where those of the glyph before end.
///
/// A box does not leave its cell upwards or downwards. To the left and to the right it may: that is how slanted letters lean over
/// their neighbours.
#[derive(Copy, Clone, PartialEq, Eq)]
pub struct Font<'a> {
    height: u8,
    baseline: u8,
    /// What is the same for all glyphs, where there are no entries.
    like: Like,
    glyphs: u16,
    replacement: u16,
    /// Whether any box leaves its cell.
    overhangs: bool,
    /// Records of eight bytes.
    ranges: &'a [u8],
    /// The same; empty if all glyphs are alike.
    entries: &'a [u8],
    bits: &'a [u8],
}

/// Prints the sizes, not the pixels.
impl fmt::Debug for Font<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { height, baseline, glyphs, .. } = self;
        f.debug_struct("Font")
            .field("height", height)
            .field("baseline", baseline)
            .field("glyphs", glyphs)
            .finish_non_exhaustive()
    }
}

/// A glyph but for its bits.
#[derive(Copy, Clone, PartialEq, Eq)]
struct Like {
    advance: u8,
    left: i8,
    top: u8,
    width: u8,
    height: u8,
}

impl Like {
    const fn read([advance, left, top, width, height]: [u8; 5]) -> Self {
        Self { advance, left: left.cast_signed(), top, width, height }
    }

    /// Bytes of its bits.
    #[inline(always)]
    const fn bytes(self) -> usize {
        (self.width as usize).div_ceil(8).wrapping_mul(self.height as usize)
    }

    /// Whether the box leaves its cell on the left or on the right.
    const fn overhangs(self) -> bool {
        (self.left as i32) < 0 || self.left as i32 + self.width as i32 > self.advance as i32
    }

    /// Whether the box is the cell of a font of so many rows.
    #[inline(always)]
    const fn fills(self, rows: u8) -> bool {
        self.left == 0 && self.top == 0 && self.width == self.advance && self.height == rows
    }
}

/// The picture of a character: where its box lies in its cell, and its bits.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Glyph<'a> {
    /// Columns of the cell: from the pen to that of the next glyph.
    pub advance: u8,
    /// Columns of the cell on the left of the box; negative if the box begins before the cell does.
    pub left: i8,
    /// Rows of the cell above the box.
    pub top: u8,
    /// Columns of the box.
    pub width: u8,
    /// Rows of the box.
    pub height: u8,
    /// Whether the box is the whole cell.
    pub fills_cell: bool,
    /// The bits of the box in strips of eight columns, one after the other: a byte for each row, the leftmost pixel in its most
    /// significant bit.
    pub strips: &'a [u8],
}

impl<'a> Font<'a> {
    /// Reads a font. Bytes after its end do not matter.
    ///
    /// Work goes with the numbers of ranges and glyphs.
    ///
    /// # Errors
    /// [`FontError`], if the bytes are none that `fontbake` could have made.
    pub const fn read(bytes: &'a [u8]) -> Result<Self, FontError> {
        let Some((header, rest)) = bytes.split_first_chunk::<HEADER>() else {
            return Err(FontError::TooShort { needed: HEADER, given: bytes.len() });
        };
        let [m0, m1, m2, m3, height, baseline, a, b, c, d, e, kind, glyphs0, glyphs1, r0, r1, n0, n1, z0, z1] = *header;
        let magic = [m0, m1, m2, m3];
        if u32::from_be_bytes(magic) != u32::from_be_bytes(MAGIC) || kind > 1 || z0 != 0 || z1 != 0 {
            return Err(FontError::Unknown { start: magic, kind });
        }
        let (glyphs, replacement) = (u16::from_le_bytes([glyphs0, glyphs1]), u16::from_le_bytes([r0, r1]));
        if replacement >= glyphs {
            return Err(FontError::NoGlyph { number: replacement as u32, glyphs });
        }
        let like = Like::read([a, b, c, d, e]);
        let has_entries = kind == 1;
        // Saturating for a `usize` of 16 bits; in 32 bits the sum stays below 2^30.
        let ranges_len = RECORD.saturating_mul(u16::from_le_bytes([n0, n1]) as usize);
        let entries_len = if has_entries { RECORD.saturating_mul(glyphs as usize) } else { 0 };
        let bits_len = if has_entries { 0 } else { like.bytes().saturating_mul(glyphs as usize) };
        let needed = HEADER.saturating_add(ranges_len).saturating_add(entries_len).saturating_add(bits_len);
        let too_short = FontError::TooShort { needed, given: bytes.len() };
        let Some((ranges, rest)) = rest.split_at_checked(ranges_len) else { return Err(too_short) };
        let Some((entries, bits)) = rest.split_at_checked(entries_len) else { return Err(too_short) };
        if bits.len() < bits_len {
            return Err(too_short);
        }
        if let Err(error) = check_ranges(ranges, glyphs) {
            return Err(error);
        }
        let mut font = Self { height, baseline, like, glyphs, replacement, overhangs: false, ranges, entries, bits };
        if has_entries {
            match font.check_entries(bytes.len().wrapping_sub(bits.len()), bytes.len()) {
                Ok(overhangs) => font.overhangs = overhangs,
                Err(error) => return Err(error),
            }
        } else if let Err(error) = font.check_glyph(0, like) {
            return Err(error);
        } else {
            font.overhangs = like.overhangs();
        }
        Ok(font)
    }

    /// Whether the boxes of all glyphs lie in their cells and their bits in the bytes, of which `before` are before the bits. Answers
    /// whether any box leaves its cell sideways.
    const fn check_entries(&self, before: usize, given: usize) -> Result<bool, FontError> {
        let (mut rest, mut number, mut overhangs) = (self.entries, 0_u32, false);
        while let Some((entry, after)) = rest.split_first_chunk::<RECORD>() {
            let (start, like) = read_entry(*entry);
            if let Err(error) = self.check_glyph(number, like) {
                return Err(error);
            }
            let end = start.saturating_add(like.bytes());
            if end > self.bits.len() {
                return Err(FontError::TooShort { needed: before.saturating_add(end), given });
            }
            overhangs |= like.overhangs();
            (rest, number) = (after, number.wrapping_add(1));
        }
        Ok(overhangs)
    }

    /// Whether a box lies in the rows of a cell, and the baseline too.
    const fn check_glyph(&self, number: u32, like: Like) -> Result<(), FontError> {
        let end = like.top as u16 + like.height as u16;
        if end > self.height as u16 || self.baseline > self.height || self.height == 0 {
            return Err(FontError::OutsideCell { glyph: number, end, baseline: self.baseline, rows: self.height });
        }
        Ok(())
    }

    /// Rows of a cell: the distance of lines that touch.
    #[inline(always)]
    pub const fn height(&self) -> u8 {
        self.height
    }

    /// Rows of a cell down to the baseline, with it: the height of what stands on the baseline.
    #[inline(always)]
    pub const fn baseline(&self) -> u8 {
        self.baseline
    }

    /// How many glyphs it has.
    #[inline]
    pub const fn len(&self) -> u16 {
        self.glyphs
    }

    /// `false`: a font has a glyph at least, that for characters which it lacks.
    #[inline]
    pub const fn is_empty(&self) -> bool {
        self.glyphs == 0
    }

    /// Whether any glyph reaches beyond the left or the right side of its cell.
    #[inline(always)]
    pub const fn overhangs(&self) -> bool {
        self.overhangs
    }

    /// Whether it has a glyph for this character.
    pub fn has(&self, character: char) -> bool {
        self.number(character).is_some()
    }

    /// The glyph of a character; the replacement glyph if it has none.
    #[cfg_attr(embedded_raster_compact, inline)]
    #[cfg_attr(not(embedded_raster_compact), inline(always))]
    pub fn glyph(&self, character: char) -> Glyph<'a> {
        let number = usize::from(self.number(character).unwrap_or(self.replacement));
        let (start, like) = match pod_align_to::<u8, [u8; RECORD]>(self.entries).1.get(number) {
            Some(entry) => read_entry(*entry),
            None => (number.wrapping_mul(self.like.bytes()), self.like),
        };
        let Like { advance, left, top, width, height } = like;
        let strips = self.bits.get(start..start.wrapping_add(like.bytes()));
        let strips = strips.unwrap_or_else(|| {
            // No glyph lies outside. As a choice, this would cost all of them both ways.
            keep_branch();
            &[]
        });
        Glyph { advance, left, top, width, height, fills_cell: like.fills(self.height), strips }
    }

    /// Columns of the cells of a line: of all characters but tabs, which a [`Style`](super::Style) knows, and newlines.
    /// Stops at `u32::MAX`.
    pub fn width(&self, line: &str) -> u32 {
        let advances =
            line.chars().filter(|c| !['\n', '\r', '\t'].contains(c)).map(|c| u32::from(self.glyph(c).advance));
        advances.fold(0, u32::saturating_add)
    }

    /// The number of the glyph of a character. Most texts are in the first range: that is looked at first, then the middle one of those
    /// that are left.
    #[cfg_attr(embedded_raster_compact, inline)]
    #[cfg_attr(not(embedded_raster_compact), inline(always))]
    fn number(&self, character: char) -> Option<u16> {
        let (_, mut ranges, _) = pod_align_to::<u8, [u8; RECORD]>(self.ranges);
        let mut probe = 0;
        if !COMPACT {
            // In front of the loop: then it lies at a place that is known.
            let (first, number) = look_up(ranges.first()?, character);
            if number.is_some() {
                return number;
            }
            if u32::from(character) < first {
                return None;
            }
            ranges = ranges.get(1..)?;
            probe = ranges.len() / 2;
        }
        while let Some(range) = ranges.get(probe) {
            let (first, number) = look_up(range, character);
            if number.is_some() {
                return number;
            }
            let (before, after) = ranges.split_at_checked(probe).unwrap_or_default();
            ranges = if u32::from(character) < first { before } else { after.get(1..).unwrap_or_default() };
            probe = ranges.len() / 2;
        }
        None
    }
}

/// The first character of a range, and the number of the glyph of a character that lies in it.
#[inline(always)]
fn look_up(&[a, b, c, d, count0, count1, glyph0, glyph1]: &[u8; RECORD], character: char) -> (u32, Option<u16>) {
    // Two words, as they are two loads.
    let first = u32::from_le_bytes([a, b, c, d]);
    let both = u32::from_le_bytes([count0, count1, glyph0, glyph1]);
    let place = u32::from(character).wrapping_sub(first);
    let number = (place < both & 0xffff).then(|| low_u16((both >> 16).wrapping_add(place)));
    (first, number)
}

/// Where the bits of a glyph begin, and what else is said of it.
#[inline(always)]
const fn read_entry([a, b, c, advance, left, top, width, height]: [u8; RECORD]) -> (usize, Like) {
    (u32::from_le_bytes([a, b, c, 0]) as usize, Like::read([advance, left, top, width, height]))
}

/// Whether ranges are sorted, do not overlap, and have glyphs.
const fn check_ranges(mut ranges: &[u8], glyphs: u16) -> Result<(), FontError> {
    let (mut number, mut free) = (0_u32, 0);
    while let Some((range, after)) = ranges.split_first_chunk::<RECORD>() {
        let [a, b, c, d, count0, count1, glyph0, glyph1] = *range;
        let first = u32::from_le_bytes([a, b, c, d]);
        let (count, glyph) = (u16::from_le_bytes([count0, count1]) as u32, u16::from_le_bytes([glyph0, glyph1]) as u32);
        let end = first.saturating_add(count);
        if first < free || end > char::MAX as u32 + 1 {
            return Err(FontError::RangeOutOfOrder { range: number, first, free });
        }
        if glyph + count > glyphs as u32 {
            return Err(FontError::NoGlyph { number: glyph.wrapping_add(count).wrapping_sub(1), glyphs });
        }
        (ranges, number, free) = (after, number.wrapping_add(1), end);
    }
    Ok(())
}
