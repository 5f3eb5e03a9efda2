//! Fonts out of files: what is baked is what is in the file.
#![allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap, reason = "glyphs are small")]
#![allow(missing_docs, reason = "tests")]

use std::{collections::BTreeMap, fs, path::Path};

use embedded_raster::text::{Font, Glyph, FONT_6X10, FONT_8X13};
use fontbake::{bdf, chars, constant, truetype, Glyphs, Shape};

fn file(name: &str) -> Vec<u8> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("fonts").join(name);
    fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn is_set(glyph: &Glyph<'_>, x: usize, y: usize) -> bool {
    x < usize::from(glyph.width) && glyph.strips[x / 8 * usize::from(glyph.height) + y] >> (7 - x % 8) & 1 != 0
}

/// The set pixels of a glyph, by the column from the pen and the row above the baseline.
fn pixels(font: &Font<'_>, character: char) -> Vec<(i32, i32)> {
    let glyph = font.glyph(character);
    let box_of = |y: u8| (0..glyph.width).map(move |x| (x, y));
    (0..glyph.height)
        .flat_map(box_of)
        .filter(|&(x, y)| is_set(&glyph, x.into(), y.into()))
        .map(|(x, y)| {
            let row = i32::from(font.baseline()) - i32::from(glyph.top) - i32::from(y);
            (i32::from(glyph.left) + i32::from(x), row)
        })
        .collect()
}

fn of_shape(shape: &Shape) -> Vec<(i32, i32)> {
    let set = shape.bits.iter().enumerate().filter(|(_, is_set)| **is_set);
    set.map(|(i, _)| (shape.left + (i % shape.width) as i32, shape.above - (i / shape.width) as i32)).collect()
}

fn has_its_shapes(glyphs: &Glyphs) -> Vec<u8> {
    let bytes = glyphs.bake().expect("a font");
    let font = Font::read(&bytes).expect("a font");
    for (&character, shape) in &glyphs.shapes {
        assert_eq!(i32::from(font.glyph(character).advance), shape.advance, "{character}");
        assert_eq!(pixels(&font, character), of_shape(shape), "{character}");
    }
    assert_eq!(pixels(&font, '\u{10fffe}'), of_shape(&glyphs.replacement), "the replacement");
    bytes
}

#[test]
fn the_fonts_of_the_crate_are_made_of_their_files() {
    for (name, font) in [("6x10", FONT_6X10), ("8x13", FONT_8X13)] {
        let glyphs = bdf::read(&file(&format!("{name}.bdf")), None, '?').expect("a BDF");
        let bytes = has_its_shapes(&glyphs);
        assert_eq!(Font::read(&bytes), Ok(font), "{name}");
        let path = format!("{}/../src/text/fonts/{name}.erf", env!("CARGO_MANIFEST_DIR"));
        assert!(fs::read(path).expect("a font") == bytes, "{name}.erf is made by the command in its README");
        assert!(glyphs.copyright.starts_with("Public domain"), "{}", glyphs.copyright);
    }
}

#[test]
fn outlines_become_pixels() {
    let wanted: Vec<char> = "Agjf0_ é".chars().collect();
    for size in [9.0, 16.0, 40.0] {
        let glyphs = truetype::read(dejavu::sans::oblique(), size, &wanted, '?').expect("a font");
        assert_eq!(glyphs.shapes.len(), wanted.len());
        let bytes = has_its_shapes(&glyphs);
        let font = Font::read(&bytes).expect("a font");
        assert!((f32::from(font.height()) - size).abs() <= 2.0, "{size}: {} rows", font.height());
        assert!(pixels(&font, 'A').iter().all(|&(_, row)| row > 0), "it stands on the baseline");
        assert!(pixels(&font, 'g').iter().any(|&(_, row)| row <= 0), "it reaches below");
        assert!(pixels(&font, ' ').is_empty(), "a space is empty");
    }
}

/// Wide, leaning and empty shapes, of different widths.
#[test]
fn any_shape_is_kept() {
    let shape = |advance, left, above, width: usize, rows: usize| Shape {
        advance,
        left,
        above,
        width,
        bits: (0..width * rows).map(|i| i % 3 != 1).collect(),
    };
    let shapes = [
        ('!', shape(3, -2, 5, 9, 4)),
        ('a', shape(20, 4, 1, 17, 12)),
        ('b', shape(0, 0, 0, 0, 0)),
        ('\u{1f600}', shape(9, 0, 9, 8, 9)),
    ];
    let glyphs = Glyphs { rows: (7, 2), shapes: BTreeMap::from(shapes), ..Glyphs::default() };
    let bytes = has_its_shapes(&glyphs);
    let font = Font::read(&bytes).expect("a font");
    assert_eq!((font.height(), font.baseline(), font.len()), (9 + 11, 9, 4));
    assert!(font.overhangs());
}

#[test]
fn what_is_too_large_is_told() {
    let shape = Shape { advance: 256, ..Shape::default() };
    let glyphs = Glyphs { rows: (9, 1), shapes: BTreeMap::from([('a', shape)]), ..Glyphs::default() };
    assert_eq!(glyphs.bake(), Err("columns of a cell: 256 is not in 0..=255".into()));
    assert_eq!(Glyphs::default().bake(), Err("the font has none of these characters".into()));
    assert!(bdf::read(b"STARTFONT 2.1\n", None, '?').is_err());
    assert!(truetype::read(b"no font", 12.0, &['a'], '?').is_err());
}

#[test]
fn characters_are_asked_for_by_code() {
    assert_eq!(chars::parse("0x41-0x43, 97,U+20AC").expect("codes"), ['A', 'B', 'C', 'a', '€']);
    assert_eq!(chars::parse("0xd7ff-0xe000").expect("codes").len(), 2, "surrogates are no characters");
    for (text, error) in [
        ("0x43-0x41", "\"0x43-0x41\" ends before it begins"),
        ("", "\"\" is not a character code"),
        ("0x110000", "\"0x110000\" is not a character code"),
    ] {
        assert_eq!(chars::parse(text), Err(error.into()));
    }
}

#[test]
fn a_constant_is_the_font() {
    let text = constant("TINY", "Two lines.\n\nOf text.", &[1, 2, 255]);
    let start = "/// Two lines.\n///\n/// Of text.\npub const TINY: embedded_raster::text::Font<'static> = {\n";
    assert!(text.starts_with(start), "{text}");
    assert!(text.contains("const BYTES: [u8; 3] = [\n        1, 2, 255,\n    ];"), "{text}");
}
