//! TrueType and OpenType files: outlines, which are filled at a size. A pixel is set where half of it is covered.
//!
//! Outlines are not hinted: below some 12 pixels a bitmap font that somebody drew looks better.

use fontdue::{Font, FontSettings};

use crate::{Glyphs, Shape};

/// Coverage from which on a pixel is set.
const HALF: u8 = 128;

/// Rasterizes characters so that the font is so many pixels high, from its highest letter to its lowest.
///
/// # Errors
/// If it is not such a file.
pub fn read(file: &[u8], size: f32, wanted: &[char], replacement: char) -> Result<Glyphs, String> {
    let font = Font::from_bytes(file, FontSettings { scale: size, ..FontSettings::default() })?;
    let lines = font.horizontal_line_metrics(size).ok_or("the font says nothing of its lines")?;
    // What is asked for is the size on the screen; that of the file is the side of a square which letters may leave.
    let scale = size * size / (lines.ascent - lines.descent);
    let rows = |height: f32| (height * scale / size).round() as i32;
    let shape = |character: char| {
        let (metrics, coverage) = font.rasterize(character, scale);
        Shape {
            advance: metrics.advance_width.round() as i32,
            left: metrics.xmin,
            above: metrics.ymin + metrics.height as i32,
            width: metrics.width,
            bits: coverage.into_iter().map(|level| level >= HALF).collect(),
        }
    };
    Ok(Glyphs {
        rows: (rows(lines.ascent), rows(-lines.descent)),
        shapes: wanted.iter().filter(|&&c| font.lookup_glyph_index(c) != 0).map(|&c| (c, shape(c))).collect(),
        replacement: shape(replacement),
        copyright: font.name().unwrap_or_default().into(),
    })
}
