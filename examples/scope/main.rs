//! An oscilloscope: thousands of line segments a frame, of which only what they touch is drawn anew and sent to the display.
//!
//! `cargo run --release --example scope` writes `scope.png`; `-- --help` tells the rest. What is drawn stands in `scene.rs`, which chips draw
//! too, to the same bytes.

#[expect(clippy::cast_possible_truncation, reason = "bytes of a table")]
#[expect(unreachable_pub, reason = "it is public in its own crate")]
#[path = "../../firmware/board/src/crc.rs"]
mod crc;
mod scene;

use std::{error::Error, process::ExitCode};

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::{buffer_bytes, pixel::Be, Framebuffer, Index4, Palette, Rect};
use embedded_raster_simulator::{
    finish,
    heat::Heat,
    moving::{run, Moment, Moving, Options, USAGE},
    Picture,
};

fn main() -> ExitCode {
    finish("scope", go())
}

fn go() -> Result<String, Box<dyn Error>> {
    match Options::from_command_line("scope", [scene::WIDTH, scene::HEIGHT])? {
        Some(options) => run("scope", &options, Scope::new(options.size)),
        None => {
            Ok(format!("usage: scope [--size WxH] [--frames N] [--out FILE.png|.apng|.gif] [--window]\n\n{USAGE}\n"))
        }
    }
}

/// An oscilloscope and its display.
#[expect(clippy::struct_field_names, reason = "the scene has the name of the program")]
struct Scope {
    size: [u16; 2],
    scope: scene::Scope<Vec<u8>>,
    signals: scene::Signals,
    palette: Palette<Rgb565, 16>,
    line: Vec<u8>,
    /// What the display has, in 16 bits with the high byte first.
    display: Vec<u8>,
    frame: u32,
}

impl Scope {
    fn new(size @ [width, height]: [u16; 2]) -> Self {
        let buffers = [(); 2].map(|()| vec![0; buffer_bytes::<Index4>(width, height)]);
        Self {
            size,
            scope: scene::Scope::new(buffers, size),
            signals: scene::Signals::new(),
            palette: scene::palette(),
            line: vec![0; 2 * usize::from(width)],
            display: vec![0; buffer_bytes::<Rgb565>(width, height)],
            frame: 0,
        }
    }

    /// How often the traces of a frame touch each pixel.
    fn drawn(&self) -> Result<Vec<u16>, embedded_raster::Error> {
        let [width, height] = self.size;
        let mut drawn = vec![0; usize::from(width) * usize::from(height)];
        let mut memory = vec![0; buffer_bytes::<Index4>(width, height)];
        let mut frame = Framebuffer::<Index4>::new(&mut memory, width, height)?;
        let mut counted = Heat::new(&mut frame, width.into(), &mut drawn);
        scene::trace(&mut counted, self.size, &self.signals, self.frame);
        Ok(drawn)
    }
}

impl Moving for Scope {
    fn next(&mut self) -> Result<Moment, embedded_raster::Error> {
        let [width, height] = self.size;
        let (mut sent, row_bytes) = (Vec::<Rect>::new(), self.line.len());
        self.frame += 1;
        self.scope.draw()?;
        self.scope.flip();
        self.scope.send_rows(&self.palette, &mut self.line, |row, bytes| {
            let place = |n: i32| usize::try_from(n).unwrap_or(0);
            let start = place(row.y0) * row_bytes + 2 * place(row.x0);
            self.display[start..start + bytes.len()].copy_from_slice(bytes);
            // Rows of a rectangle follow each other.
            match sent.last_mut() {
                Some(last) if (last.x0, last.x1, last.y1) == (row.x0, row.x1, row.y0) => last.y1 = row.y1,
                _ => sent.push(row),
            }
        })?;
        let bytes = self.scope.pixels().map_or(0, Vec::len);
        Ok(Moment {
            crc32: crc::crc32(&self.display),
            picture: Picture::of(&Framebuffer::<Be<Rgb565>>::new(&mut self.display, width, height)?),
            sent,
            drawn: self.drawn()?,
            ram: 2 * bytes + self.line.len() + size_of_val(&self.scope),
        })
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::pixelcolor::Rgb888;

    use super::*;

    /// The colours of the whole picture of a frame, drawn anew.
    fn whole(scope: &Scope) -> Vec<Rgb888> {
        let [width, height] = scope.size;
        let mut memory = vec![0xA5; buffer_bytes::<Index4>(width, height)];
        let mut frame = Framebuffer::<Index4>::new(&mut memory, width, height).unwrap();
        scene::grid(&mut frame, scope.size);
        scene::trace(&mut frame, scope.size, &scope.signals, scope.frame);
        Picture::indexed(&frame, &scope.palette).colors().collect()
    }

    #[test]
    fn what_the_display_has_is_the_whole_frame() {
        for size in [[320, 240], [101, 63], [16, 9], [1, 1]] {
            let mut scope = Scope::new(size);
            for _ in 0..12 {
                let moment = scope.next().unwrap();
                assert!(moment.picture.colors().eq(whole(&scope)), "frame {} of {size:?}", scope.frame);
            }
        }
    }

    #[test]
    fn little_is_sent() {
        let mut scope = Scope::new([320, 240]);
        for number in 0..12 {
            let moment = scope.next().unwrap();
            let pixels: u32 = moment.sent.iter().map(|area| area.width() * area.height()).sum();
            assert!((number == 0) == (pixels == 320 * 240), "{pixels} pixels in frame {number}");
            assert!(number == 0 || pixels < 320 * 240 / 2, "{pixels} pixels in frame {number}");
        }
    }
}
