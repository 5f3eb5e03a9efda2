//! Makes fonts for `embedded_raster::text`: BDF and TrueType files to the bytes that its `Font` reads, or to a Rust constant.
//!
//! [`bdf`] and [`truetype`] read files, and answer with [`Glyphs`]: pictures with places. [`Glyphs::bake`] writes those as bytes,
//! [`constant`] writes the bytes as Rust.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    reason = "numbers out of files, checked where they are written"
)]

pub mod bdf;
pub mod chars;
pub mod truetype;

use std::{collections::BTreeMap, fmt::Write};

/// A character as a picture.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Shape {
    /// Columns to the next character.
    pub advance: i32,
    /// Columns from the pen to the left side of the picture.
    pub left: i32,
    /// Rows from the baseline up to the upper side of the picture: the number of rows, if it stands on the baseline.
    pub above: i32,
    /// Columns of the picture.
    pub width: usize,
    /// Its pixels, row by row.
    pub bits: Vec<bool>,
}

impl Shape {
    /// Rows of the picture.
    pub fn rows(&self) -> usize {
        self.bits.len().checked_div(self.width).unwrap_or(0)
    }

    /// The same without the empty rows and columns at its sides.
    fn tight(&self) -> Self {
        let set = |x: usize, y: usize| self.bits[y * self.width + x];
        let columns: Vec<_> = (0..self.width).filter(|&x| (0..self.rows()).any(|y| set(x, y))).collect();
        let rows: Vec<_> = (0..self.rows()).filter(|&y| (0..self.width).any(|x| set(x, y))).collect();
        let (&[x0, .., x1] | &[x0 @ x1]) = &columns[..] else {
            return Self { advance: self.advance, ..Self::default() };
        };
        let (y0, y1) = (rows[0], rows[rows.len() - 1]);
        Self {
            advance: self.advance,
            left: self.left + x0 as i32,
            above: self.above - y0 as i32,
            width: x1 + 1 - x0,
            bits: (y0..=y1).flat_map(|y| (x0..=x1).map(move |x| (x, y))).map(|(x, y)| set(x, y)).collect(),
        }
    }

    /// The same picture in a box of so many columns and rows, the first row so far above the baseline.
    fn in_box(&self, (width, rows): (usize, usize), above: i32) -> Self {
        let set = |x: i32, y: i32| {
            let (x, y) = (x - self.left, y - (above - self.above));
            let inside = x >= 0 && y >= 0 && (x as usize) < self.width && (y as usize) < self.rows();
            inside && self.bits[y as usize * self.width + x as usize]
        };
        let places = (0..rows as i32).flat_map(|y| (0..width as i32).map(move |x| (x, y)));
        Self { left: 0, above, width, bits: places.map(|(x, y)| set(x, y)).collect(), ..self.clone() }
    }

    /// Strips of eight columns, a byte for each row.
    fn strips(&self) -> Vec<u8> {
        let byte = |x: usize, y: usize| {
            let bit = |i: usize| x + i < self.width && self.bits[y * self.width + x + i];
            (0..8).fold(0, |byte, i| byte << 1 | u8::from(bit(i)))
        };
        (0..self.width).step_by(8).flat_map(|x| (0..self.rows()).map(move |y| byte(x, y))).collect()
    }
}

/// What a font is made of.
#[derive(Clone, Debug, Default)]
pub struct Glyphs {
    /// Rows above the baseline, and below it. Those of the font are as many, or as many more as its shapes need.
    pub rows: (i32, i32),
    /// Shapes by character.
    pub shapes: BTreeMap<char, Shape>,
    /// The shape for characters that the font lacks.
    pub replacement: Shape,
    /// Who made the font, and what may be done with it.
    pub copyright: String,
}

impl Glyphs {
    /// The bytes that `embedded_raster::text::Font` reads. Glyphs that all advance by the same and keep to their cells are
    /// stored as whole cells, if that takes no more bytes than to store where each lies.
    ///
    /// # Errors
    /// If there is no glyph, or something is too large for its byte.
    pub fn bake(&self) -> Result<Vec<u8>, String> {
        if self.shapes.is_empty() {
            return Err("the font has none of these characters".into());
        }
        let mut shapes: Vec<Shape> = self.shapes.values().map(Shape::tight).collect();
        let replacement = self.replacement.tight();
        let place = shapes.iter().position(|shape| *shape == replacement).unwrap_or_else(|| {
            shapes.push(replacement);
            shapes.len() - 1
        });
        let above = shapes.iter().map(|s| s.above).max().unwrap_or(0).max(self.rows.0);
        let below = shapes.iter().map(|s| s.rows() as i32 - s.above).max().unwrap_or(0).max(self.rows.1);
        let (advance, rows) = (shapes[0].advance, (above + below) as usize);
        let cells_hold =
            shapes.iter().all(|s| s.advance == advance && s.left >= 0 && s.left + s.width as i32 <= advance);
        let cell = (advance.max(0) as usize, rows);
        let size = |shape: &Shape| shape.width.div_ceil(8) * shape.rows();
        let all_cells = shapes.len() * cell.0.div_ceil(8) * rows;
        let is_fixed = cells_hold && all_cells <= shapes.iter().map(|s| 8 + size(s)).sum();
        if is_fixed {
            shapes = shapes.iter().map(|shape| shape.in_box(cell, above)).collect();
        }

        let ranges = self.ranges();
        let mut bytes = b"erf1".to_vec();
        bytes.extend([byte("rows of a line", rows as i64)?, byte("rows above the baseline", above.into())?]);
        bytes.extend(if is_fixed { described(&shapes[0], above)? } else { [0; 5] });
        bytes.push(u8::from(!is_fixed));
        bytes.extend(half("glyphs", shapes.len())?);
        bytes.extend(half("glyphs", place)?);
        bytes.extend(half("ranges of characters", ranges.len())?);
        bytes.extend([0, 0]);
        for (first, count, glyph) in ranges {
            bytes.extend(u32::from(first).to_le_bytes());
            bytes.extend(half("characters of a range", count)?);
            bytes.extend(half("glyphs", glyph)?);
        }
        if !is_fixed {
            let mut start = 0_u32;
            for shape in &shapes {
                let [a, b, c, 0] = start.to_le_bytes() else { return Err("more than 16 MiB of bits".into()) };
                bytes.extend([a, b, c]);
                bytes.extend(described(shape, above)?);
                start += size(shape) as u32;
            }
        }
        bytes.extend(shapes.iter().flat_map(Shape::strips));
        Ok(bytes)
    }

    /// Runs of characters that follow each other: the first, how many, and the number of the first's glyph.
    fn ranges(&self) -> Vec<(char, usize, usize)> {
        let mut ranges: Vec<(char, usize, usize)> = vec![];
        for (number, &character) in self.shapes.keys().enumerate() {
            match ranges.last_mut() {
                Some((first, count, _)) if u32::from(*first) as usize + *count == u32::from(character) as usize => {
                    *count += 1;
                }
                _ => ranges.push((character, 1, number)),
            }
        }
        ranges
    }
}

/// What is said of a glyph in a font whose cells have so many rows above the baseline.
fn described(shape: &Shape, above: i32) -> Result<[u8; 5], String> {
    let left = i8::try_from(shape.left).map_err(|_| format!("a glyph begins {} columns from its pen", shape.left))?;
    let top = if shape.bits.is_empty() { 0 } else { above - shape.above };
    Ok([
        byte("columns of a cell", shape.advance.into())?,
        left.to_le_bytes()[0],
        byte("rows above a glyph", top.into())?,
        byte("columns of a glyph", shape.width as i64)?,
        byte("rows of a glyph", shape.rows() as i64)?,
    ])
}

fn byte(what: &str, number: i64) -> Result<u8, String> {
    u8::try_from(number).map_err(|_| format!("{what}: {number} is not in 0..=255"))
}

fn half(what: &str, number: usize) -> Result<[u8; 2], String> {
    Ok(u16::try_from(number).map_err(|_| format!("{what}: {number} is not in 0..=65535"))?.to_le_bytes())
}

/// A font as a Rust constant of this name.
pub fn constant(name: &str, about: &str, bytes: &[u8]) -> String {
    let mut text = String::new();
    for line in about.lines() {
        text += format!("/// {line}").trim_end();
        text.push('\n');
    }
    let _ = write!(
        text,
        "pub const {name}: embedded_raster::text::Font<'static> = {{\n    #[rustfmt::skip]\n    const BYTES: [u8; {}] = [\n",
        bytes.len()
    );
    for row in bytes.chunks(20) {
        let row: Vec<String> = row.iter().map(u8::to_string).collect();
        let _ = writeln!(text, "        {},", row.join(", "));
    }
    text += "    ];\n    match embedded_raster::text::Font::read(&BYTES) {\n        Ok(font) => font,\n        Err(_) => panic!(\"not a font\"),\n    }\n};\n";
    text
}
