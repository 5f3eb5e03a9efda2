//! A plasma whose pixels are drawn once: what moves are its 256 colours.
//!
//! `cargo run --release --example plasma` writes `plasma.png`; `-- --help` tells the rest. What is drawn stands in `scene.rs`, which
//! chips draw too, to the same bytes.

#[expect(clippy::cast_possible_truncation, reason = "bytes of a table")]
#[expect(unreachable_pub, reason = "it is public in its own crate")]
#[path = "../../firmware/board/src/crc.rs"]
mod crc;
mod scene;

use std::{error::Error, process::ExitCode};

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::{pixel::Be, Bitmap, Framebuffer, Index8, Palette, Rect};
use embedded_raster_simulator::{
    finish,
    heat::Heat,
    moving::{run, Moment, Moving, Options, USAGE},
    Picture,
};

fn main() -> ExitCode {
    finish("plasma", go())
}

fn go() -> Result<String, Box<dyn Error>> {
    match Options::from_command_line("plasma", [scene::WIDTH, scene::HEIGHT])? {
        Some(options) => run("plasma", &options, Plasma::new(options.size)?),
        None => {
            Ok(format!("usage: plasma [--size WxH] [--frames N] [--out FILE.png|.apng|.gif] [--window]\n\n{USAGE}\n"))
        }
    }
}

/// Pixels that are drawn, and how often each of them was.
struct Plasma {
    size: [u16; 2],
    pixels: Vec<u8>,
    drawn: Vec<u16>,
    colors: Palette<Rgb565, 256>,
    frame: u32,
}

impl Plasma {
    fn new(size @ [width, height]: [u16; 2]) -> Result<Self, embedded_raster::Error> {
        let count = usize::from(width) * usize::from(height);
        let (mut pixels, mut drawn, sines) = (vec![0; count], vec![0; count], scene::Sines::new());
        let mut frame = Framebuffer::<Index8>::new(&mut pixels, width, height)?;
        // Counting takes one pixel at a time, and draws the same.
        scene::draw(&mut Heat::new(&mut frame, width.into(), &mut drawn), size, &sines);
        Ok(Self { size, pixels, drawn, colors: scene::palette(&sines), frame: 0 })
    }
}

impl Moving for Plasma {
    fn next(&mut self) -> Result<Moment, embedded_raster::Error> {
        let [width, height] = self.size;
        let palette = scene::turned(&self.colors, self.frame);
        self.frame += 1;
        let (mut line, mut display) = (vec![0; 2 * usize::from(width)], vec![]);
        scene::send(&Bitmap::new(&self.pixels, width, height)?, &palette, &mut line, |row| {
            display.extend_from_slice(row);
        });
        let crc32 = crc::crc32(&display);
        let ram = self.pixels.len() + line.len() + 2 * size_of_val(&self.colors);
        Ok(Moment {
            picture: Picture::of(&Framebuffer::<Be<Rgb565>>::new(&mut display, width, height)?),
            sent: vec![Rect::new(0, 0, width.into(), height.into())],
            // All of them before the first frame, and none later.
            drawn: std::mem::take(&mut self.drawn),
            crc32,
            ram,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sixteen bits of a pixel, through the palette of a frame.
    fn color(plasma: &Plasma, frame: u32, x: i32, y: i32) -> Option<Rgb565> {
        let [width, height] = plasma.size;
        let pixels = Bitmap::<Index8>::new(&plasma.pixels, width, height).unwrap();
        scene::turned(&plasma.colors, frame).get(pixels.get((x, y))?.into())
    }

    #[test]
    fn the_colours_move_and_the_pixels_stay() {
        let mut plasma = Plasma::new([64, 48]).unwrap();
        let before = plasma.pixels.clone();
        let moments = [(); 3].map(|()| plasma.next().unwrap());
        assert_eq!(plasma.pixels, before);
        assert!(moments[0].drawn.iter().all(|&n| n == 1) && moments[1].drawn.is_empty());
        assert_eq!(moments.iter().filter(|moment| moment.crc32 == moments[0].crc32).count(), 1);
        for (frame, moment) in (0..).zip(&moments) {
            for at in [(0_i32, 0_i32), (63, 47), (20, 31)] {
                let shown = moment.picture.color(at.0.unsigned_abs() as usize, at.1.unsigned_abs() as usize);
                assert_eq!(shown, color(&plasma, frame, at.0, at.1).map(Into::into), "{at:?} in frame {frame}");
            }
        }
        // 3 places a frame: after 256 frames everything is as it was.
        assert_eq!(scene::turned(&plasma.colors, 256), plasma.colors);
    }

    #[test]
    fn bands_are_the_whole() {
        let sines = scene::Sines::new();
        let whole = Plasma::new([64, 48]).unwrap().pixels;
        let mut bands = vec![0; whole.len()];
        for start in (0..48).step_by(5) {
            let rows = start..48.min(start + 5);
            let memory = &mut bands[usize::from(start) * 64..];
            scene::draw(&mut Framebuffer::<Index8>::band(memory, 64, 48, rows).unwrap(), [64, 48], &sines);
        }
        assert!(bands == whole);
    }
}
