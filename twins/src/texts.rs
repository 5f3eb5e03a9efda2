//! Text pixel by pixel: letters of any shape, written as the bytes of a font by the table of its documentation, and the rule of
//! `embedded_raster::text` word for word.

use std::collections::BTreeMap;

use embedded_graphics_core::{
    geometry::{Point, Size},
    pixelcolor::Gray8,
};
use embedded_raster::{
    text::{Font, Horizontal, Style, Vertical},
    ClippedSpan, Rect, Surface,
};

use super::input::Input;

/// Characters of one to four bytes, in order.
const CHARACTERS: [char; 12] = [' ', '!', '"', '0', '1', '2', 'A', '~', 'é', '€', '\u{fffd}', '😀'];

/// A picture of a character.
#[derive(Clone, Debug)]
pub struct Letter {
    /// Columns of its cell.
    pub advance: u8,
    left: i8,
    top: u8,
    width: u8,
    height: u8,
    /// Row by row.
    bits: Vec<bool>,
}

/// Letters with places, and which characters have which.
#[derive(Clone, Debug)]
#[expect(clippy::struct_field_names, reason = "letters are letters")]
pub struct Letters {
    rows: u8,
    baseline: u8,
    is_fixed: bool,
    letters: Vec<Letter>,
    /// The first character, how many, and the number of the letter of the first.
    ranges: Vec<(char, u16, u16)>,
    replacement: u16,
    /// What stands in strips beyond the last column of a letter.
    garbage: bool,
}

/// How a text is set.
#[derive(Clone, Copy, Debug)]
pub struct Setting {
    /// Of lines.
    pub horizontal: Horizontal,
    /// Of the block.
    pub vertical: Vertical,
    /// From line to line.
    pub line_height: u16,
    /// From tab stop to tab stop.
    pub tab: u16,
    /// With a ground.
    pub opaque: bool,
}

impl Letters {
    /// Letters of any shape.
    pub fn of(input: &mut Input<'_>) -> Self {
        let rows = input.within(1, 20) as u8;
        let (is_fixed, overhangs) = (input.one_in(2), input.one_in(3));
        let mut letter = || {
            let advance = input.within(i32::from(!overhangs), 19) as u8;
            let is_cell = input.one_in(3);
            let (mut left, mut width) = (0, i32::from(advance));
            let (mut top, mut height) = (0, i32::from(rows));
            if overhangs && !is_cell {
                (left, width) = (input.within(-9, 9), input.within(0, 20));
            } else if !is_cell {
                left = input.within(0, width);
                width = input.within(0, width - left);
            }
            if !is_cell {
                top = input.within(0, height);
                height = input.within(0, height - top);
            }
            let bits = (0..width * height).map(|_| input.one_in(2)).collect();
            Letter { advance, left: left as i8, top: top as u8, width: width as u8, height: height as u8, bits }
        };
        let first = letter();
        let count = input.within(1, 7) as usize;
        let mut letters = vec![first.clone()];
        while letters.len() < count {
            let bits = (0..first.bits.len()).map(|_| input.one_in(2)).collect();
            letters.push(if is_fixed { Letter { bits, ..first.clone() } } else { Self::any(input, rows, overhangs) });
        }
        let mut ranges = vec![];
        let mut place = 0;
        while place < CHARACTERS.len() {
            // Characters that follow each other share a range, now and then.
            let first = CHARACTERS[place];
            let mut len = 1;
            while place + len < CHARACTERS.len()
                && CHARACTERS[place + len] as usize == first as usize + len
                && len < letters.len()
                && !input.one_in(4)
            {
                len += 1;
            }
            if !input.one_in(3) {
                ranges.push((first, len as u16, input.within(0, (letters.len() - len) as i32) as u16));
            }
            place += len;
        }
        let replacement = input.index(letters.len()) as u16;
        let (baseline, garbage) = (input.within(0, rows.into()) as u8, input.one_in(4));
        Self { rows, baseline, is_fixed, letters, ranges, replacement, garbage }
    }

    fn any(input: &mut Input<'_>, rows: u8, overhangs: bool) -> Letter {
        let advance = input.within(0, 19);
        let (left, width) = if overhangs {
            (input.within(-9, 9), input.within(0, 20))
        } else {
            let left = input.within(0, advance);
            (left, input.within(0, advance - left))
        };
        let top = input.within(0, rows.into());
        let height = input.within(0, i32::from(rows) - top);
        let bits = (0..width * height).map(|_| input.one_in(2)).collect();
        Letter {
            advance: advance as u8,
            left: left as i8,
            top: top as u8,
            width: width as u8,
            height: height as u8,
            bits,
        }
    }

    /// The bytes of the font, by the table in the documentation of fonts.
    pub fn bytes(&self) -> Vec<u8> {
        let said = |l: &Letter| [l.advance, l.left as u8, l.top, l.width, l.height];
        let mut bytes = b"erf1".to_vec();
        bytes.extend([self.rows, self.baseline]);
        bytes.extend(said(&self.letters[0]));
        bytes.push(u8::from(!self.is_fixed));
        bytes.extend((self.letters.len() as u16).to_le_bytes());
        bytes.extend(self.replacement.to_le_bytes());
        bytes.extend((self.ranges.len() as u16).to_le_bytes());
        bytes.extend([0, 0]);
        for &(first, count, letter) in &self.ranges {
            bytes.extend(u32::from(first).to_le_bytes());
            bytes.extend(count.to_le_bytes());
            bytes.extend(letter.to_le_bytes());
        }
        let mut bits: Vec<u8> = vec![];
        for letter in &self.letters {
            if !self.is_fixed {
                bytes.extend(&(bits.len() as u32).to_le_bytes()[..3]);
                bytes.extend(said(letter));
            }
            let (width, height) = (usize::from(letter.width), usize::from(letter.height));
            for x in (0..width).step_by(8) {
                for y in 0..height {
                    let bit = |i: usize| if x + i < width { letter.bits[y * width + x + i] } else { self.garbage };
                    bits.push((0..8).map(|i| u8::from(bit(i)) << (7 - i)).sum());
                }
            }
        }
        bytes.extend(bits);
        bytes
    }

    fn letter(&self, character: char) -> &Letter {
        let range = self.ranges.iter().find(|&&(first, count, _)| {
            (u32::from(first)..u32::from(first) + u32::from(count)).contains(&u32::from(character))
        });
        let number = range.map_or(self.replacement.into(), |&(first, _, letter)| {
            u32::from(letter) + u32::from(character) - u32::from(first)
        });
        &self.letters[number as usize]
    }

    /// Where the cells of the characters of a line begin and end, counted from its start.
    fn cells<'a>(&'a self, line: &'a str, tab: u16) -> Vec<(i64, i64, Option<&'a Letter>)> {
        let mut column = 0;
        let mut cells = vec![];
        for character in line.chars() {
            let start = column;
            let letter = (!['\t', '\r'].contains(&character)).then(|| self.letter(character));
            match (character, letter) {
                ('\t', _) if tab > 0 => column = (column / i64::from(tab) + 1) * i64::from(tab),
                (_, Some(letter)) => column += i64::from(letter.advance),
                _ => {}
            }
            cells.push((start, column, letter));
        }
        cells
    }

    fn columns(&self, line: &str, tab: u16) -> i64 {
        self.cells(line, tab).last().map_or(0, |cell| cell.1)
    }

    /// Columns and rows of a text.
    pub fn size(&self, setting: &Setting, text: &str) -> (i64, i64) {
        let columns = text.split('\n').map(|line| self.columns(line, setting.tab)).max().expect("a line");
        let rows = (text.split('\n').count() as i64 - 1) * i64::from(setting.line_height) + i64::from(self.rows);
        (columns, rows)
    }

    /// All pixels of a text: `true` where letters are, `false` for the ground.
    pub fn pixels(&self, setting: &Setting, at: Point, text: &str) -> BTreeMap<(i64, i64), bool> {
        let (x, y) = (i64::from(at.x), i64::from(at.y));
        let (_, rows) = self.size(setting, text);
        let mut top = match setting.vertical {
            Vertical::Baseline => y + 1 - i64::from(self.baseline),
            Vertical::Top => y,
            Vertical::Middle => y - (rows - 1) / 2,
            Vertical::Bottom => y + 1 - rows,
        };
        let mut pixels = BTreeMap::new();
        for line in text.split('\n') {
            let columns = self.columns(line, setting.tab);
            let start = match setting.horizontal {
                Horizontal::Left => x,
                Horizontal::Center => x - (columns - 1).max(0) / 2,
                Horizontal::Right => x + 1 - columns,
            };
            if setting.opaque {
                for (column, row) in (0..columns).flat_map(|x| (0..i64::from(self.rows)).map(move |y| (x, y))) {
                    pixels.insert((start + column, top + row), false);
                }
            }
            for (cell, _, letter) in self.cells(line, setting.tab) {
                let Some(letter) = letter else { continue };
                for (i, _) in letter.bits.iter().enumerate().filter(|(_, is_set)| **is_set) {
                    let (column, row) = (i as i64 % i64::from(letter.width), i as i64 / i64::from(letter.width));
                    let x = start + cell + i64::from(letter.left) + column;
                    pixels.insert((x, top + i64::from(letter.top) + row), true);
                }
            }
            top += i64::from(setting.line_height);
        }
        pixels
    }
}

impl Setting {
    /// Any one.
    pub fn of(input: &mut Input<'_>) -> Self {
        Self {
            horizontal: input.pick(&[Horizontal::Left, Horizontal::Left, Horizontal::Center, Horizontal::Right]),
            vertical: input.pick(&[Vertical::Baseline, Vertical::Top, Vertical::Middle, Vertical::Bottom]),
            line_height: input.pick(&[0, 1, 7, 20, 21, 300]),
            tab: input.pick(&[0, 1, 7, 64]),
            opaque: input.one_in(2),
        }
    }

    /// The style with these settings.
    pub fn style<'a, C: Copy>(&self, font: &'a Font<'a>, color: C, ground: C) -> Style<'a, C> {
        let style = Style::new(font, color)
            .horizontal(self.horizontal)
            .vertical(self.vertical)
            .line_height(self.line_height)
            .tab(self.tab);
        if self.opaque {
            style.opaque(ground)
        } else {
            style
        }
    }
}

/// Some characters.
pub fn text(input: &mut Input<'_>) -> String {
    let count = input.below(12);
    (0..count)
        .map(|_| if input.one_in(5) { input.pick(&['\n', '\t', '\r', 'x', 'ß']) } else { input.pick(&CHARACTERS) })
        .collect()
}

/// A surface that keeps the last colour of each pixel, and fails where one is painted outside of its window.
pub(crate) struct Last(pub(crate) Rect, pub(crate) BTreeMap<(i64, i64), Gray8>);

impl Surface for Last {
    type Color = Gray8;

    fn window(&self) -> Rect {
        self.0
    }

    fn fill_span(&mut self, span: ClippedSpan, color: Gray8) {
        for x in span.x0()..span.x1() {
            assert!(self.0.contains(x, span.y()), "({x}, {}) is outside of {:?}", span.y(), self.0);
            self.1.insert((x.into(), span.y().into()), color);
        }
    }
}

/// What the fuzz target `text` checks: a text anywhere, in any font, against the twin; and bytes that are no font at all.
pub fn target(data: &[u8]) {
    let _ = Font::read(data).map(|font| draw_any(&font, data));
    let mut input = Input(data);
    let (letters, setting, text) = (Letters::of(&mut input), Setting::of(&mut input), text(&mut input));
    let window = input.window();
    let at = Point::new(input.near(window.x0, 1), input.near(window.y0, 1));
    let bytes = letters.bytes();
    let font = Font::read(&bytes).unwrap_or_else(|error| panic!("{error}: {letters:?}"));
    let [color, ground] = [1, 0].map(Gray8::new);
    let style = setting.style(&font, color, ground);
    let mut surface = Last(window, BTreeMap::new());
    style.draw(&mut surface, at, &text);
    let all = letters.pixels(&setting, at, &text);
    let is_inside = |&(x, y): &(i64, i64)| {
        let (x, y) = (i32::try_from(x), i32::try_from(y));
        x.is_ok_and(|x| y.is_ok_and(|y| window.contains(x, y)))
    };
    let wanted: BTreeMap<_, _> = all
        .iter()
        .filter(|(place, _)| is_inside(place))
        .map(|(&place, &is_set)| (place, if is_set { color } else { ground }))
        .collect();
    assert!(
        surface.1 == wanted,
        "{text:?} at {at} in {window:?}, {setting:?}, {letters:?}\ngot {:?}\nwanted {wanted:?}",
        surface.1
    );

    let (columns, rows) = letters.size(&setting, &text);
    assert_eq!(style.size(&text), Size::new(columns as u32, rows as u32), "{text:?}, {setting:?}");
    // Opaque text reaches all sides of its bounds, unless lines are apart and the first or the last has no columns.
    if setting.opaque && !font.overhangs() && columns > 0 && text.lines().all(|line| !line.trim().is_empty()) {
        let cut = |n: i64| n.clamp(i32::MIN.into(), i32::MAX.into()) as i32;
        let side = |f: fn(&(i64, i64)) -> i64| {
            let numbers = || all.keys().map(f);
            (cut(numbers().min().expect("pixels")), cut(numbers().max().expect("pixels") + 1))
        };
        let ((x0, x1), (y0, y1)) = (side(|p| p.0), side(|p| p.1));
        let empty_ends = text.split('\n').any(|line| letters.columns(line, setting.tab) == 0);
        let bounds = style.bounds(at, &text);
        assert_eq!((bounds.x0, bounds.x1), (x0, x1), "{text:?} at {at}, {setting:?}");
        assert!(empty_ends || (bounds.y0, bounds.y1) == (y0, y1), "{text:?} at {at}, {setting:?}: {bounds:?}");
    }
}

/// Draws with a font of unknown origin: it may look like anything.
fn draw_any(font: &Font<'_>, data: &[u8]) {
    let mut surface = Last(Rect::new(-8, -8, 8, 8), BTreeMap::new());
    let text = String::from_utf8_lossy(data.get(data.len().saturating_sub(40)..).unwrap_or(data));
    Style::new(font, Gray8::new(1)).opaque(Gray8::new(0)).draw(&mut surface, (0, 0), &text);
}
