//! BDF files: bitmap fonts as texts, as the X Window System has them.

use bdf_parser::{BdfFont, Property};

use crate::{Glyphs, Shape};

/// Reads the characters that are wanted, or all that have a code.
///
/// # Errors
/// If it is not a BDF file, or a glyph has fewer bytes than its box needs.
pub fn read(file: &[u8], wanted: Option<&[char]>, replacement: char) -> Result<Glyphs, String> {
    let font = BdfFont::parse(file).map_err(|error| error.to_string())?;
    let from_box = font.metadata.bounding_box;
    let property = |property, otherwise| font.properties.try_get::<i32>(property).unwrap_or(otherwise);
    let rows = (
        property(Property::FontAscent, from_box.size.y + from_box.offset.y),
        property(Property::FontDescent, -from_box.offset.y),
    );
    let mut glyphs = Glyphs {
        rows,
        copyright: font.properties.try_get::<String>(Property::Copyright).unwrap_or_default(),
        ..Glyphs::default()
    };
    for glyph in font.glyphs.iter() {
        let Some(character) = glyph.encoding else { continue };
        let is_replacement = character == replacement;
        let is_wanted = wanted.is_none_or(|wanted| wanted.contains(&character));
        if !is_wanted && !is_replacement {
            continue;
        }
        let area = glyph.bounding_box;
        let size = |n: i32| usize::try_from(n).map_err(|_| format!("the box of {character:?} has {n} columns or rows"));
        let (width, height) = (size(area.size.x)?, size(area.size.y)?);
        if glyph.bitmap.len() < width.div_ceil(8) * height {
            return Err(format!("{character:?} has {} bytes for {width} x {height} pixels", glyph.bitmap.len()));
        }
        let shape = Shape {
            advance: glyph.device_width.x,
            left: area.offset.x,
            above: area.offset.y + area.size.y,
            width,
            bits: (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(|(x, y)| glyph.pixel(x, y)).collect(),
        };
        if is_replacement {
            glyphs.replacement = shape.clone();
        }
        if is_wanted {
            glyphs.shapes.insert(character, shape);
        }
    }
    Ok(glyphs)
}
