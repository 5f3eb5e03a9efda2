//! Pictures as PBM and PGM files: the simplest that other programs read.

use std::{ffi::OsStr, fs, io, path::Path};

use crate::{picture::Picture, svg::luma};

impl Picture {
    /// Writes a PNG, PBM or PGM file, by the end of its name; any other name stands for a PNG.
    ///
    /// # Errors
    /// As [`write_png`](Self::write_png).
    pub fn write(&self, path: impl AsRef<Path>) -> io::Result<()> {
        let path = path.as_ref();
        let end = path.extension().map(OsStr::to_ascii_lowercase);
        let bytes = match end.as_ref().and_then(|end| end.to_str()) {
            Some("pbm") => self.to_pbm(),
            Some("pgm") => self.to_pgm(),
            _ => return self.write_png(path),
        };
        fs::write(path, bytes).map_err(|error| io::Error::new(error.kind(), format!("{}: {error}", path.display())))
    }

    /// The bytes of a binary PBM file: 1 for dark pixels.
    pub fn to_pbm(&self) -> Vec<u8> {
        let mut file = format!("P4\n{} {}\n", self.width(), self.height()).into_bytes();
        let colors: Vec<bool> = self.colors().map(|color| luma(color) < 128).collect();
        for row in colors.chunks(self.width().max(1)) {
            let byte = |pixels: &[bool]| (0..8).fold(0, |byte, i| byte << 1 | u8::from(pixels.get(i) == Some(&true)));
            file.extend(row.chunks(8).map(byte));
        }
        file
    }

    /// The bytes of a binary PGM file, from 0 for black to 255 for white.
    pub fn to_pgm(&self) -> Vec<u8> {
        let mut file = format!("P5\n{} {}\n255\n", self.width(), self.height()).into_bytes();
        file.extend(self.colors().map(luma));
        file
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};

    use super::*;

    #[test]
    fn rows_begin_with_a_byte() {
        let colors = (0..20).map(|i| if i % 3 == 0 { Rgb888::BLACK } else { Rgb888::WHITE }).collect();
        let picture = Picture::from_colors(10, 2, colors);
        assert_eq!(picture.to_pbm(), b"P4\n10 2\n\x92\x40\x24\x80", "bits");
        assert_eq!(&picture.to_pgm()[..15], b"P5\n10 2\n255\n\x00\xff\xff", "bytes");
    }
}
