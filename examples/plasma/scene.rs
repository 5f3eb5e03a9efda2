//! The scene: a plasma, sums of waves that are drawn once, in indices of 8 bits. What moves are the colours: the palette is turned by a few
//! places for each frame, and no pixel is written again. Integers only and no heap: a chip draws it with this same code.
#![allow(unreachable_pub, reason = "firmwares have this scene as a module of a library")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::integer_division,
    reason = "levels of 8 bits, out of sums of a few of them"
)]

use embedded_graphics_core::pixelcolor::{Rgb565, Rgb888};
use embedded_raster::{pixel::Be, Angle, Bitmap, Index8, Palette, Span, Surface};

/// Columns of the screen, unless told.
pub const WIDTH: u16 = 320;
/// Rows of the screen, unless told.
pub const HEIGHT: u16 = 240;

/// How many places the palette turns from frame to frame.
pub const STEP: usize = 3;

/// Sines of 256 angles of a turn, times 127.
#[derive(Clone, Debug)]
pub struct Sines([i8; 256]);

impl Sines {
    /// The table.
    pub fn new() -> Self {
        let (mut table, mut angle) = ([0; 256], 0);
        for place in &mut table {
            let (_, sine) = Angle::turns(angle, 256).cos_sin();
            // From 2.30, rounded.
            *place = (((sine >> 7) * 127 + (1 << 22)) >> 23) as i8;
            angle += 1;
        }
        Self(table)
    }

    /// Of so many 256ths of a turn.
    fn at(&self, angle: i32) -> i32 {
        self.0[(angle & 255) as usize].into()
    }
}

impl Default for Sines {
    fn default() -> Self {
        Self::new()
    }
}

/// Draws the waves on a screen, or a part of it; `[width, height]` are those of the whole.
pub fn draw<S: Surface<Color = Index8>>(on: &mut S, [width, height]: [u16; 2], sines: &Sines) {
    let window = on.window();
    let (middle_x, middle_y) = (i32::from(width) * 3 / 5, i32::from(height) * 2 / 5);
    for y in window.y0..window.y1 {
        let Some(span) = (Span { y, x0: window.x0, x1: window.x1 }).clip(window) else { continue };
        // What is the same in all of the row.
        let (bend, level) = (sines.at(y * 2) / 3, sines.at(y * 3 + 64) + sines.at(y) / 2);
        on.write_span(span, |x| {
            let (dx, dy) = (x - middle_x, y - middle_y);
            let ring = (dx * dx + dy * dy).unsigned_abs().isqrt() as i32;
            let sum = level + sines.at(x * 2 + bend) + sines.at((x + y) * 3 / 2 + 20) + sines.at(ring * 3);
            Index8::new((sum / 2) as u8)
        });
    }
}

/// The colours of frame 0: three waves around the table, so that its end meets its beginning.
pub fn palette(sines: &Sines) -> Palette<Rgb565, 256> {
    let mut palette = Palette::new([Rgb565::new(0, 0, 0); 256]);
    for i in 0..=255 {
        let level = |angle: i32| (sines.at(angle) + 128) as u8;
        let at = i32::from(i);
        // Dark where red and blue are low at once; green is a thin line of light.
        let green = level(at * 2 + 150);
        let color =
            Rgb888::new(level(at), ((u16::from(green) * u16::from(level(at + 30))) >> 8) as u8, level(at + 100));
        palette.set(i, Rgb565::from(color));
    }
    palette
}

/// The colours of a frame: those of frame 0, turned.
pub fn turned(palette: &Palette<Rgb565, 256>, frame: u32) -> Palette<Rgb565, 256> {
    let mut turned = *palette;
    turned.rotate(0..256, frame as usize % 256 * STEP);
    turned
}

/// Hands each row to `send` as a display is sent it, in 16 bits with the high byte first. `line` has the bytes of a row.
pub fn send(pixels: &Bitmap<'_, Index8>, palette: &Palette<Rgb565, 256>, line: &mut [u8], mut send: impl FnMut(&[u8])) {
    for row in pixels.bytes(pixels.window()) {
        palette.expand::<Index8, Be<Rgb565>>(row, line);
        send(line);
    }
}
