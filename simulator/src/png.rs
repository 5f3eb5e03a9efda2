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

    /// Reads a PNG file of any kind. Indexed ones stay indexed, all else becomes colours of 8 bits a channel. Without colours, what lets
    /// through lies on white.
    ///
    /// # Errors
    /// Of the file system, and `InvalidData` for a file that is no PNG.
    pub fn read_png(path: impl AsRef<Path>) -> io::Result<Self> {
        Self::from_png(io::BufReader::new(fs::File::open(path)?))
    }

    /// Reads the bytes of a PNG file.
    ///
    /// # Errors
    /// As [`read_png`](Self::read_png).
    pub fn from_png(mut source: impl BufRead + Seek) -> io::Result<Self> {
        let bad = |error| io::Error::new(io::ErrorKind::InvalidData, error);
        let start = source.stream_position()?;
        let mut decoder = Decoder::new(&mut source);
        decoder.set_transformations(png::Transformations::IDENTITY);
        let mut reader = decoder.read_info().map_err(bad)?;
        let info = reader.info();
        // Indices do not tell how much they let through: with transparency they become colours.
        let is_plain = info.color_type == ColorType::Indexed && info.trns.is_none();
        let palette = info.palette.as_deref().filter(|palette| is_plain && palette.len() >= 3);
        let Some(palette) = palette.map(colors) else {
            drop(reader);
            source.seek(io::SeekFrom::Start(start))?;
            return Self::colors_of_png(source);
        };
        let mut data = vec![0; room(reader.output_buffer_size())?];
        let frame = reader.next_frame(&mut data).map_err(bad)?;
        let (width, height, bits) = (frame.width as usize, frame.height as usize, frame.bit_depth as u8);
        Ok(Self::from_indices(width, height, bits, palette, unpacked(&data, width, bits)))
    }

    /// The colours of any PNG file.
    fn colors_of_png(source: impl BufRead + Seek) -> io::Result<Self> {
        let bad = |error| io::Error::new(io::ErrorKind::InvalidData, error);
        let mut decoder = Decoder::new(source);
        decoder.set_transformations(png::Transformations::EXPAND | png::Transformations::STRIP_16);
        let mut reader = decoder.read_info().map_err(bad)?;
        let mut data = vec![0; room(reader.output_buffer_size())?];
        let frame = reader.next_frame(&mut data).map_err(bad)?;
        data.truncate(frame.buffer_size());
        let colors = match frame.color_type {
            ColorType::Grayscale => data.iter().map(|&level| Rgb888::new(level, level, level)).collect(),
            ColorType::GrayscaleAlpha => data.chunks_exact(2).map(|c| on_white([c[0], c[0], c[0]], c[1])).collect(),
            ColorType::Rgb => colors(&data),
            ColorType::Rgba => data.chunks_exact(4).map(|c| on_white([c[0], c[1], c[2]], c[3])).collect(),
            ColorType::Indexed => return Err(io::Error::new(io::ErrorKind::InvalidData, "indices without a palette")),
        };
        Ok(Self::from_colors(frame.width as usize, frame.height as usize, colors))
    }
}

/// The bytes that a picture takes. The head of a file may ask for more than there is.
fn room(bytes: Option<usize>) -> io::Result<usize> {
    const MOST: usize = 1 << 30;
    let bytes = bytes.unwrap_or(usize::MAX);
    let fits = Some(bytes).filter(|&bytes| bytes <= MOST);
    fits.ok_or_else(|| io::Error::new(io::ErrorKind::InvalidData, format!("{bytes} bytes of pixels, more than {MOST}")))
}

/// A colour that covers so many parts of 255 of a white ground.
fn on_white(color: [u8; 3], alpha: u8) -> Rgb888 {
    let mixed = |level: u8| {
        let sum = u32::from(level) * u32::from(alpha) + 255 * u32::from(255 - alpha);
        u8::try_from((sum + 127) / 255).unwrap_or(255)
    };
    let [r, g, b] = color.map(mixed);
    Rgb888::new(r, g, b)
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

    /// The bytes of a file of two pixels.
    fn file(kind: ColorType, depth: BitDepth, data: &[u8]) -> Vec<u8> {
        let mut file = vec![];
        let mut encoder = Encoder::new(&mut file, 2, 1);
        encoder.set_color(kind);
        encoder.set_depth(depth);
        if kind == ColorType::Indexed {
            encoder.set_palette(vec![0, 0, 0, 9, 8, 7]);
            encoder.set_trns(vec![0, 255]);
        }
        let mut writer = encoder.write_header().expect("a header");
        writer.write_image_data(data).expect("pixels");
        writer.finish().expect("an end");
        file
    }

    #[test]
    fn pictures_of_all_kinds_can_be_read() {
        let white = [255; 3];
        for (kind, depth, data, expected) in [
            (ColorType::Grayscale, BitDepth::One, &[0b0100_0000][..], [[0; 3], white]),
            (ColorType::Grayscale, BitDepth::Four, &[0x3f], [[0x33; 3], white]),
            (ColorType::Grayscale, BitDepth::Eight, &[1, 254], [[1; 3], [254; 3]]),
            (ColorType::Grayscale, BitDepth::Sixteen, &[1, 2, 254, 3], [[1; 3], [254; 3]]),
            (ColorType::GrayscaleAlpha, BitDepth::Eight, &[10, 255, 10, 0], [[10; 3], white]),
            (ColorType::Rgb, BitDepth::Sixteen, &[1, 9, 2, 9, 3, 9, 4, 9, 5, 9, 6, 9], [[1, 2, 3], [4, 5, 6]]),
            (ColorType::Rgba, BitDepth::Eight, &[1, 2, 3, 255, 0, 100, 255, 51], [[1, 2, 3], [204, 224, 255]]),
            (ColorType::Indexed, BitDepth::Eight, &[0, 1], [white, [9, 8, 7]]),
        ] {
            let picture = Picture::from_png(Cursor::new(file(kind, depth, data))).expect("a picture");
            let expected = expected.map(|[r, g, b]| Rgb888::new(r, g, b));
            assert_eq!(picture, Picture::from_colors(2, 1, expected.to_vec()), "{kind:?} of {depth:?} bits");
        }
    }

    #[test]
    fn what_is_not_a_picture_is_an_error() {
        let empty = Picture::from_colors(0, 3, vec![]).to_png().map_err(|error| error.kind());
        assert_eq!(empty, Err(io::ErrorKind::InvalidInput), "no pixels");
        assert!(Picture::from_png(Cursor::new(b"GIF89a")).is_err(), "another format");
        let mut file = Picture::from_colors(2, 1, vec![Rgb888::WHITE; 2]).to_png().expect("it has pixels");
        // Columns and rows, and the check sum of the head.
        file[16..24].copy_from_slice(&[0, 0xff, 0xff, 0xff, 0, 0xff, 0xff, 0xff]);
        let sum = crc32(&file[12..29]).to_be_bytes();
        file[29..33].copy_from_slice(&sum);
        let error = Picture::from_png(Cursor::new(file)).map_err(|error| error.to_string());
        assert_eq!(
            error,
            Err("844424829468675 bytes of pixels, more than 1073741824".into()),
            "a head that asks for too much"
        );
    }

    fn crc32(bytes: &[u8]) -> u32 {
        let step = |crc: u32, bit: bool| (crc >> 1) ^ if (crc & 1 != 0) == bit { 0 } else { 0xedb8_8320 };
        let bits = bytes.iter().flat_map(|byte| (0..8).map(move |bit| byte >> bit & 1 != 0));
        !bits.fold(u32::MAX, step)
    }
}
