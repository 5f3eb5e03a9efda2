//! What is read as a font, and what is not.

use embedded_raster::{
    text::{Font, FONT_6X10, FONT_8X13},
    FontError,
};
use twins::{
    input::Input,
    rng::{cases, Rng},
    texts::Letters,
};

/// Cells of 4 x 4 with two glyphs: `x`, and `y` and `z`, which are the same.
const SMALL: &[u8] =
    b"erf1\x04\x03\x04\0\0\x03\x03\0\x02\0\0\0\x02\0\0\0x\0\0\0\x01\0\0\0y\0\0\0\x02\0\0\0\xa0\x40\xa0\xe0\xa0\xe0";

/// The error of the bytes with some of them replaced.
fn error(at: usize, bytes: &[u8]) -> FontError {
    let mut font = SMALL.to_vec();
    font[at..at + bytes.len()].copy_from_slice(bytes);
    Font::read(&font).expect_err("not a font")
}

#[test]
fn errors_carry_numbers() {
    assert!(Font::read(SMALL).is_ok());
    for given in 0..SMALL.len() {
        let needed = if given < 20 { 20 } else { 42 };
        assert_eq!(Font::read(&SMALL[..given]), Err(FontError::TooShort { needed, given }));
    }
    assert_eq!(error(0, b"ERF1"), FontError::Unknown { start: *b"ERF1", kind: 0 });
    assert_eq!(error(11, &[2]), FontError::Unknown { start: *b"erf1", kind: 2 });
    assert_eq!(error(14, &[2]), FontError::NoGlyph { number: 2, glyphs: 2 }, "as a replacement");
    assert_eq!(error(34, &[1]), FontError::NoGlyph { number: 2, glyphs: 2 }, "of a range");
    assert_eq!(error(28, b"x"), FontError::RangeOutOfOrder { range: 1, first: 0x78, free: 0x79 });
    let first = 0x10_ffff;
    assert_eq!(error(28, &[0xff, 0xff, 0x10]), FontError::RangeOutOfOrder { range: 1, first, free: 0x79 });
    assert_eq!(error(8, &[2]), FontError::OutsideCell { glyph: 0, end: 5, baseline: 3, rows: 4 });
    assert_eq!(error(5, &[5]), FontError::OutsideCell { glyph: 0, end: 3, baseline: 5, rows: 4 });
    assert_eq!(FontError::TooShort { needed: 42, given: 3 }.to_string(), "font too short: 42 bytes needed, 3 given");
}

#[test]
fn entries_end_in_the_bits() {
    // One glyph with an entry that begins at byte 1 of its two bytes, two rows high.
    let font = b"erf1\x04\x03\0\0\0\0\0\x01\x01\0\0\0\0\0\0\0\x01\0\0\x04\0\0\x03\x02\xff\xff";
    assert_eq!(Font::read(font), Err(FontError::TooShort { needed: 31, given: 30 }));
    let mut longer = font.to_vec();
    longer.push(0);
    assert_eq!(Font::read(&longer).expect("a font").glyph('?').strips, [0xff, 0]);
}

/// Any bytes are refused or drawn: nothing panics, and nothing runs away.
#[test]
fn damaged_fonts_are_fonts_or_errors() {
    let mut rng = Rng::new(1_700);
    let mut read = 0;
    for _ in 0..cases(4_000) {
        let bytes: Vec<u8> = (0..500).map(|_| rng.bits() as u8).collect();
        let mut font = Letters::of(&mut Input(&bytes)).bytes();
        for _ in 0..rng.below(4) {
            let at = rng.index(font.len());
            font[at] = rng.bits() as u8;
        }
        font.truncate(if rng.one_in(4) { rng.index(font.len()) } else { font.len() });
        twins::texts::target(&font);
        read += usize::from(Font::read(&font).is_ok());
    }
    assert!(read > cases(1_000), "only {read} were fonts");
}

#[test]
fn the_fonts_have_ascii_and_degrees() {
    for (font, size) in [(&FONT_6X10, (6, 10)), (&FONT_8X13, (8, 13))] {
        for character in (' '..='~').chain("°±µ×".chars()) {
            let glyph = font.glyph(character);
            assert!(font.has(character), "{character}");
            assert_eq!((glyph.advance, font.height()), size, "{character}");
            assert!(character == ' ' || glyph.strips.iter().any(|&row| row != 0), "{character} is empty");
        }
        assert!(!font.has('\u{7f}') && !font.has('ß') && !font.has('\u{10ffff}'));
        assert_eq!(font.glyph('ß'), font.glyph('?'), "the replacement");
        assert!(!font.overhangs());
        assert_eq!(font.width("23 °C"), 5 * u32::from(size.0));
    }
}
