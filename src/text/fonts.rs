//! The fonts that come with the crate: cut out of the public domain fonts of the X Window System, of which `fonts/README.md` tells.
//! The tool `fontbake` made their bytes, and a test makes them again.

use super::font::Font;

/// Bytes that the tool made.
const fn read(bytes: &'static [u8]) -> Font<'static> {
    match Font::read(bytes) {
        Ok(font) => font,
        Err(_) => panic!("a font of the crate is not a font"),
    }
}

/// Cells of 6 x 10 pixels: the printable characters of ASCII, and `°`, `±`, `µ`, `×`. 1,042 bytes.
#[cfg(feature = "font-6x10")]
pub const FONT_6X10: Font<'static> = read(include_bytes!("fonts/6x10.erf"));

/// Cells of 8 x 13 pixels: the printable characters of ASCII, and `°`, `±`, `µ`, `×`. 1,339 bytes.
#[cfg(feature = "font-8x13")]
pub const FONT_8X13: Font<'static> = read(include_bytes!("fonts/8x13.erf"));
