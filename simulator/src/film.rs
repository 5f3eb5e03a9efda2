//! Pictures that move: APNG and GIF files.
//!
//! Both keep indexed pictures as they are. GIF has no more than 256 colours to a picture: of pictures with more, it shows the
//! nearest of 256 that are chosen for each.

use std::{borrow::Cow, io};

use embedded_graphics_core::pixelcolor::Rgb888;

use crate::{
    picture::{Picture, Pixels},
    png,
};

/// How long a picture is shown, in hundredths of a second.
pub(crate) const DELAY: u16 = 5;

/// The bytes of a PNG file: an animated one, if there is more than one picture.
///
/// * `count`: how many pictures there are.
/// * `next`: makes each. All have the same size, and the palette of the first.
///
/// # Errors
/// Those of `next`, and `InvalidInput` for no pictures, pictures without pixels, and pictures that are not like the first.
pub fn apng<E: From<io::Error>>(count: u16, mut next: impl FnMut(u16) -> Result<Picture, E>) -> Result<Vec<u8>, E> {
    let (first, mut file) = (some(count, &mut next)?, Vec::new());
    let mut encoder = png::encoder(&first, &mut file)?;
    if count > 1 {
        encoder.set_animated(count.into(), 0).and_then(|()| encoder.set_frame_delay(DELAY, 100)).map_err(invalid)?;
    }
    let mut writer = encoder.write_header().map_err(invalid)?;
    writer.write_image_data(&png::data(&first)).map_err(invalid)?;
    for number in 1..count {
        let picture = alike(next(number)?, &first)?;
        writer.write_image_data(&png::data(&picture)).map_err(invalid)?;
    }
    writer.finish().map_err(invalid)?;
    Ok(file)
}

/// The bytes of an animated PNG file of pictures of one size, each shown for so many hundredths of a second. A PNG has one palette: if
/// pictures have several, all are written in their colours.
pub(crate) fn timed_apng(pictures: &[(Picture, u16)]) -> io::Result<Vec<u8>> {
    let (first, _) = pictures.first().ok_or_else(|| invalid("no pictures"))?;
    let has_one = pictures.iter().all(|(picture, _)| kind(picture) == kind(first));
    let kept = |picture: &Picture| {
        if has_one {
            picture.clone()
        } else {
            Picture::from_colors(picture.width(), picture.height(), picture.colors().collect())
        }
    };
    let (first, mut file) = (kept(first), Vec::new());
    let mut encoder = png::encoder(&first, &mut file)?;
    encoder.set_animated(u32::try_from(pictures.len()).map_err(invalid)?, 0).map_err(invalid)?;
    let mut writer = encoder.write_header().map_err(invalid)?;
    for (picture, delay) in pictures {
        let picture = alike(kept(picture), &first)?;
        writer.set_frame_delay(*delay, 100).map_err(invalid)?;
        writer.write_image_data(&png::data(&picture)).map_err(invalid)?;
    }
    writer.finish().map_err(invalid)?;
    Ok(file)
}

/// The bytes of a GIF file that begins anew when it is at its end.
///
/// # Errors
/// As [`apng`], and of pictures with more than 65,535 rows or columns.
pub fn gif<E: From<io::Error>>(count: u16, mut next: impl FnMut(u16) -> Result<Picture, E>) -> Result<Vec<u8>, E> {
    let (first, mut file) = (some(count, &mut next)?, Vec::new());
    let mut gif = Gif::begin(&first, &mut file)?;
    gif.add(&first, DELAY)?;
    for number in 1..count {
        gif.add(&alike(next(number)?, &first)?, DELAY)?;
    }
    drop(gif);
    Ok(file)
}

/// The bytes of a GIF file of pictures of one size, each shown for so many hundredths of a second. Indexed pictures may have palettes of
/// their own.
pub(crate) fn timed_gif(pictures: &[(Picture, u16)]) -> io::Result<Vec<u8>> {
    let (first, _) = pictures.first().ok_or_else(|| invalid("no pictures"))?;
    let mut file = Vec::new();
    let mut gif = Gif::begin(first, &mut file)?;
    for (picture, delay) in pictures {
        gif.add(picture, *delay)?;
    }
    drop(gif);
    Ok(file)
}

/// A GIF file that is being written.
struct Gif<W: io::Write> {
    encoder: gif::Encoder<W>,
    size: (u16, u16),
    /// That of the first picture: those of others, if they differ, come with their picture.
    palette: Vec<u8>,
}

impl<W: io::Write> Gif<W> {
    fn begin(first: &Picture, file: W) -> io::Result<Self> {
        let size @ (width, height) = size(first)?;
        let palette = png::bytes(kind(first));
        let mut encoder = gif::Encoder::new(file, width, height, &palette).map_err(invalid)?;
        encoder.set_repeat(gif::Repeat::Infinite).map_err(invalid)?;
        Ok(Self { encoder, size, palette })
    }

    fn add(&mut self, picture: &Picture, delay: u16) -> io::Result<()> {
        let (width, height) = size(picture)?;
        if (width, height) != self.size {
            return Err(invalid("pictures of several sizes"));
        }
        let mut frame = match picture.pixels() {
            Pixels::Indexed { indices, palette, .. } => {
                let palette = Some(png::bytes(palette)).filter(|palette| *palette != self.palette);
                gif::Frame {
                    width,
                    height,
                    buffer: Cow::Borrowed(indices.as_slice()),
                    palette,
                    ..gif::Frame::default()
                }
            }
            Pixels::Rgb(colors) => gif::Frame::from_rgb_speed(width, height, &png::bytes(colors), 10),
        };
        frame.delay = delay;
        self.encoder.write_frame(&frame).map_err(invalid)
    }
}

/// Columns and rows that GIF has.
fn size(picture: &Picture) -> io::Result<(u16, u16)> {
    let side =
        |n: usize| u16::try_from(n).ok().filter(|&n| n > 0).ok_or_else(|| invalid("a size that GIF does not have"));
    Ok((side(picture.width())?, side(picture.height())?))
}

/// The first picture.
fn some<E: From<io::Error>>(count: u16, mut next: impl FnMut(u16) -> Result<Picture, E>) -> Result<Picture, E> {
    if count == 0 {
        return Err(invalid("no pictures").into());
    }
    next(0)
}

/// A picture, if it can follow another one.
fn alike(picture: Picture, first: &Picture) -> io::Result<Picture> {
    let same_size = (picture.width(), picture.height()) == (first.width(), first.height());
    if same_size && kind(&picture) == kind(first) {
        Ok(picture)
    } else {
        Err(invalid("pictures of several kinds"))
    }
}

/// The palette of a picture; none for colours.
fn kind(picture: &Picture) -> &[Rgb888] {
    match picture.pixels() {
        Pixels::Indexed { palette, .. } => palette,
        Pixels::Rgb(_) => &[],
    }
}

fn invalid(error: impl Into<Box<dyn std::error::Error + Send + Sync>>) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidInput, error)
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use embedded_graphics_core::pixelcolor::RgbColor;
    use embedded_raster::pixel::EGA;

    use super::*;

    type Next = fn(u16) -> io::Result<Picture>;

    fn indexed(index: u8) -> Picture {
        Picture::from_indices(3, 2, 4, EGA.colors().to_vec(), vec![index, 1, 2, 3, 4, 5])
    }

    fn colors(number: u16) -> Picture {
        let n = u8::try_from(number).expect("few pictures");
        Picture::from_colors(2, 2, vec![Rgb888::new(n, 0, 0), Rgb888::RED, Rgb888::GREEN, Rgb888::BLUE])
    }

    /// The pixels of all frames of an animated PNG.
    fn frames(file: &[u8]) -> Vec<Vec<u8>> {
        let mut decoder = ::png::Decoder::new(Cursor::new(file));
        decoder.set_transformations(::png::Transformations::IDENTITY);
        let mut reader = decoder.read_info().expect("a PNG file");
        let count = reader.info().animation_control().map_or(1, |control| control.num_frames);
        let mut frame = || {
            let mut data = vec![0; reader.output_buffer_size().expect("it is small")];
            reader.next_frame(&mut data).expect("as many as it says");
            data
        };
        (0..count).map(|_| frame()).collect()
    }

    #[test]
    fn all_pictures_are_in_an_apng() {
        let file = apng::<io::Error>(3, |n| Ok(indexed(u8::try_from(n).expect("few") + 7))).expect("it can be made");
        assert_eq!(
            frames(&file),
            [[0x71, 0x20, 0x34, 0x50], [0x81, 0x20, 0x34, 0x50], [0x91, 0x20, 0x34, 0x50]],
            "indices"
        );
        let file = apng::<io::Error>(2, |n| Ok(colors(n))).expect("it can be made");
        assert_eq!(frames(&file).len(), 2, "colours");
        let single = apng::<io::Error>(1, |n| Ok(colors(n))).expect("it can be made");
        assert_eq!(single, colors(0).to_png().expect("it has pixels"), "a plain PNG");
    }

    #[test]
    fn all_pictures_are_in_a_gif() {
        let file = gif::<io::Error>(3, |n| Ok(indexed(u8::try_from(n).expect("few") + 7))).expect("it can be made");
        let mut reader = ::gif::DecodeOptions::new().read_info(Cursor::new(&file)).expect("a GIF file");
        assert_eq!(reader.global_palette(), Some(&png::bytes(EGA.colors())[..]), "the palette");
        for first in 7..10 {
            let frame = reader.read_next_frame().expect("no error").expect("a picture");
            assert_eq!((&frame.buffer[..], frame.delay), (&[first, 1, 2, 3, 4, 5][..], DELAY), "indices");
        }
        assert!(reader.read_next_frame().expect("no error").is_none(), "three pictures");
        let file = gif::<io::Error>(2, |n| Ok(colors(n))).expect("it can be made");
        let mut options = ::gif::DecodeOptions::new();
        options.set_color_output(::gif::ColorOutput::RGBA);
        let mut reader = options.read_info(Cursor::new(&file)).expect("a GIF file");
        for n in 0..2 {
            let frame = reader.read_next_frame().expect("no error").expect("a picture");
            let rgba: Vec<u8> = colors(n).colors().flat_map(|c| [c.r(), c.g(), c.b(), 255]).collect();
            assert_eq!(frame.buffer[..], rgba, "few colours stay as they are");
        }
    }

    /// A picture of the indices 0 and 1 through a palette of its own.
    fn own(color: Rgb888) -> Picture {
        Picture::from_indices(2, 1, 1, vec![Rgb888::BLACK, color], vec![0, 1])
    }

    #[test]
    fn a_palette_that_changes_is_in_both() {
        let film = [(own(Rgb888::RED), 3), (own(Rgb888::BLUE), 4), (own(Rgb888::RED), 5)];
        let file = timed_gif(&film).expect("it can be made");
        let mut reader = ::gif::DecodeOptions::new().read_info(Cursor::new(&file)).expect("a GIF file");
        for (own, delay) in [(None, 3), (Some(vec![0, 0, 0, 0, 0, 255]), 4), (None, 5)] {
            let frame = reader.read_next_frame().expect("no error").expect("a picture");
            assert_eq!((&frame.buffer[..], frame.delay), (&[0, 1][..], delay), "indices stay");
            assert_eq!(frame.palette, own, "the palette, if it is not the first");
        }
        let file = timed_apng(&film).expect("it can be made");
        assert_eq!(frames(&file)[1], [0, 0, 0, 0, 0, 255], "a PNG has one palette: colours");
        let file = timed_apng(&film[..1]).expect("it can be made");
        assert_eq!(frames(&file), [[0b0100_0000]], "with one palette: indices");
        assert!(timed_gif(&[]).is_err() && timed_apng(&[]).is_err(), "no pictures");
    }

    #[test]
    fn what_cannot_be_made_is_an_error() {
        let kind = |result: io::Result<Vec<u8>>| result.map_err(|error| error.kind());
        let wrong = Err(io::ErrorKind::InvalidInput);
        let makers: [fn(u16, Next) -> _; 2] = [apng, gif];
        for make in makers {
            assert_eq!(kind(make(0, |n| Ok(colors(n)))), wrong, "no pictures");
            assert_eq!(kind(make(2, |_| Ok(Picture::from_colors(0, 3, vec![])))), wrong, "no pixels");
            assert_eq!(kind(make(2, |n| Ok(if n == 0 { colors(0) } else { indexed(1) }))), wrong, "two kinds");
            assert_eq!(
                kind(make(2, |_| Err(io::ErrorKind::NotFound.into()))),
                Err(io::ErrorKind::NotFound),
                "passed on"
            );
        }
    }
}
