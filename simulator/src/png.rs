//! Pictures as PNG files: indexed ones stay indexed, with their palette and depth.

use std::{
    fs,
    io::{self, BufRead, Seek},
    path::Path,
};

use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
use png::{BitDepth, ColorType, Decoder, Encoder};

use crate::picture::{Picture, Pixels};

impl Picture {
    /// Writes a PNG file; nothing if it cannot be made.
    ///
    /// # Errors
    /// Of the file system, with the name of the file, and `InvalidInput` for a picture without pixels, which PNG does not have.
    pub fn write_png(&self, path: impl AsRef<Path>) -> io::Result<()> {
        let path = path.as_ref();
        let named = |error: io::Error| io::Error::new(error.kind(), format!("{}: {error}", path.display()));
        self.to_png().and_then(|bytes| fs::write(path, bytes)).map_err(named)
    }

    /// The bytes of a PNG file.
    ///
    /// # Errors
    /// `InvalidInput` for a picture without pixels, which PNG does not have.
    pub fn to_png(&self) -> io::Result<Vec<u8>> {
        let mut file = Vec::new();
        let encoder = encoder(self, &mut file)?;
        encoder.write_header().and_then(|mut writer| writer.write_image_data(&data(self))).map_err(invalid)?;
        Ok(file)
    }

    /// Reads a PNG file that [`write_png`](Self::write_png) could have written: indexed, or RGB of 8 bits.
    ///
    /// # Errors
    /// Of the file system, and `InvalidData` for any other file.
    pub fn read_png(path: impl AsRef<Path>) -> io::Result<Self> {
        Self::from_png(io::BufReader::new(fs::File::open(path)?))
    }

    /// Reads the bytes of a PNG file.
    ///
    /// # Errors
    /// As [`read_png`](Self::read_png).
    pub fn from_png(source: impl BufRead + Seek) -> io::Result<Self> {
        let bad = |error| io::Error::new(io::ErrorKind::InvalidData, error);
        let mut decoder = Decoder::new(source);
        decoder.set_transformations(png::Transformations::IDENTITY);
        let mut reader = decoder.read_info().map_err(bad)?;
        let mut data = vec![0; reader.output_buffer_size().unwrap_or_default()];
        let frame = reader.next_frame(&mut data).map_err(bad)?;
        let palette = reader.info().palette.as_deref().map(colors).unwrap_or_default();
        let (width, height) = (frame.width as usize, frame.height as usize);
        match (frame.color_type, frame.bit_depth) {
            (ColorType::Indexed, depth) if !palette.is_empty() => {
                let bits = depth as u8;
                Ok(Self::from_indices(width, height, bits, palette, unpacked(&data, width, bits)))
            }
            (ColorType::Rgb, BitDepth::Eight) => Ok(Self::from_colors(width, height, colors(&data))),
            _ => Err(io::Error::new(io::ErrorKind::InvalidData, "neither an indexed nor an RGB picture")),
        }
    }
}

/// What writes pictures of this size, depth and palette.
pub(crate) fn encoder<'a, W: io::Write>(picture: &Picture, file: W) -> io::Result<Encoder<'a, W>> {
    let side = |n: usize| u32::try_from(n).map_err(invalid);
    let mut encoder = Encoder::new(file, side(picture.width())?, side(picture.height())?);
    match picture.pixels() {
        Pixels::Indexed { bits, palette, .. } => {
            encoder.set_color(ColorType::Indexed);
            encoder.set_depth(BitDepth::from_u8(*bits).ok_or_else(|| invalid("a depth that PNG does not have"))?);
            encoder.set_palette(bytes(palette));
        }
        Pixels::Rgb(_) => encoder.set_color(ColorType::Rgb),
    }
    Ok(encoder)
}

/// The pixels of a picture, as such a file has them.
pub(crate) fn data(picture: &Picture) -> Vec<u8> {
    match picture.pixels() {
        Pixels::Indexed { bits, indices, .. } => packed(indices, picture.width(), *bits),
        Pixels::Rgb(colors) => bytes(colors),
    }
}

fn invalid(error: impl Into<Box<dyn std::error::Error + Send + Sync>>) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidInput, error)
}

/// Red, green and blue of each colour.
pub(crate) fn bytes(colors: &[Rgb888]) -> Vec<u8> {
    colors.iter().flat_map(|c| [c.r(), c.g(), c.b()]).collect()
}

fn colors(bytes: &[u8]) -> Vec<Rgb888> {
    bytes.chunks_exact(3).map(|c| Rgb888::new(c[0], c[1], c[2])).collect()
}

/// Rows of indices as PNG packs them: leftmost in the most significant bits, rows on byte boundaries.
fn packed(indices: &[u8], width: usize, bits: u8) -> Vec<u8> {
    let per_byte = usize::from(8 / bits);
    let byte = |group: &[u8]| (0..per_byte).fold(0, |byte, i| byte << (bits & 7) | group.get(i).unwrap_or(&0));
    indices.chunks_exact(width.max(1)).flat_map(|row| row.chunks(per_byte).map(byte)).collect()
}

/// The inverse of [`packed`].
fn unpacked(data: &[u8], width: usize, bits: u8) -> Vec<u8> {
    let per_byte = usize::from(8 / bits);
    let index = |byte: u8, i: usize| byte << (i * usize::from(bits)) >> (8 - bits);
    let row = |row: &[u8]| (0..width).map(|x| index(row[x / per_byte], x % per_byte)).collect::<Vec<_>>();
    data.chunks_exact(width.div_ceil(per_byte).max(1)).flat_map(row).collect()
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use embedded_raster::pixel::EGA;

    use super::*;

    #[test]
    fn pictures_survive_a_file() {
        for bits in [1, 2, 4, 8] {
            for width in [1, 2, 7, 8, 9, 33] {
                let indices = (0..=u8::MAX).cycle().step_by(7).map(|i| i >> (8 - bits)).take(width * 3).collect();
                let picture = Picture::from_indices(width, 3, bits, EGA.colors().to_vec(), indices);
                let file = picture.to_png().expect("it has pixels");
                // Signature, IHDR of 25 bytes: depth and colour type follow width and height.
                assert_eq!(file[24..26], [bits, 3], "an indexed file of {bits} bits");
                assert_eq!(Picture::from_png(Cursor::new(file)).ok(), Some(picture), "{bits} bits, {width} wide");
            }
        }
        let picture = Picture::from_colors(4, 4, EGA.colors().to_vec());
        let file = picture.to_png().expect("it has pixels");
        assert_eq!(Picture::from_png(Cursor::new(file)).ok(), Some(picture), "colours");
    }

    #[test]
    fn what_is_not_a_picture_is_an_error() {
        let empty = Picture::from_colors(0, 3, vec![]).to_png().map_err(|error| error.kind());
        assert_eq!(empty, Err(io::ErrorKind::InvalidInput), "no pixels");
        assert!(Picture::from_png(Cursor::new(b"GIF89a")).is_err(), "another format");
    }
}
