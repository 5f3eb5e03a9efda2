//! Scenes that move: each frame follows from the one before it, so it is drawn once, and a checksum is taken of what the display shows
//! then.

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::pixel::Be;
use embedded_raster::{buffer_bytes, Bitmap, Error, Framebuffer, Index4, Index8, Palette};

use crate::{plasma, scope};

/// Frames that are drawn.
pub const FRAMES: u32 = 6;
/// Bytes of a row as it is sent, in 16 bits.
pub const LINE: usize = 2 * crate::WIDTH as usize;
/// Bytes of the plasma.
pub const PLASMA_BYTES: usize = buffer_bytes::<Index8>(plasma::WIDTH, plasma::HEIGHT);
/// Bytes of each of the two buffers of the oscilloscope.
pub const SCOPE_BYTES: usize = buffer_bytes::<Index4>(scope::WIDTH, scope::HEIGHT);

/// One frame after the other.
pub trait Moving {
    /// How its pixels are stored.
    fn format(&self) -> &'static str;

    /// Draws the next frame and sends what the display is to be sent of it.
    ///
    /// # Errors
    /// There is too little memory.
    fn next(&mut self, send: impl FnMut(&[u8])) -> Result<(), Error>;

    /// Each row of what is shown, in 16 bits with the high byte first.
    fn whole(&mut self, row: impl FnMut(&[u8]));
}

/// The plasma.
pub struct Plasma<'a> {
    pixels: &'a mut [u8],
    line: &'a mut [u8],
    colors: Palette<Rgb565, 256>,
    frame: u32,
}

impl<'a> Plasma<'a> {
    /// Its pixels are drawn here.
    ///
    /// # Errors
    /// `pixels` is shorter than [`PLASMA_BYTES`].
    pub fn new(pixels: &'a mut [u8], line: &'a mut [u8]) -> Result<Self, Error> {
        let sines = plasma::Sines::new();
        let mut frame = Framebuffer::<Index8>::new(&mut *pixels, plasma::WIDTH, plasma::HEIGHT)?;
        plasma::draw(&mut frame, [plasma::WIDTH, plasma::HEIGHT], &sines);
        Ok(Self { pixels, line, colors: plasma::palette(&sines), frame: 0 })
    }

    fn send(&mut self, frame: u32, send: impl FnMut(&[u8])) -> Result<(), Error> {
        let pixels = Bitmap::<Index8>::new(&*self.pixels, plasma::WIDTH, plasma::HEIGHT)?;
        plasma::send(&pixels, &plasma::turned(&self.colors, frame), self.line, send);
        Ok(())
    }
}

impl Moving for Plasma<'_> {
    fn format(&self) -> &'static str {
        "index8"
    }

    fn next(&mut self, send: impl FnMut(&[u8])) -> Result<(), Error> {
        self.frame += 1;
        self.send(self.frame - 1, send)
    }

    fn whole(&mut self, row: impl FnMut(&[u8])) {
        // What could be wrong was wrong before.
        _ = self.send(self.frame.saturating_sub(1), row);
    }
}

/// The oscilloscope.
pub struct Scope<'a> {
    scope: scope::Scope<&'a mut [u8]>,
    line: &'a mut [u8],
    colors: Palette<Rgb565, 16>,
}

impl<'a> Scope<'a> {
    /// Nothing is drawn yet.
    pub fn new(buffers: [&'a mut [u8]; 2], line: &'a mut [u8]) -> Self {
        Self { scope: scope::Scope::new(buffers, [scope::WIDTH, scope::HEIGHT]), line, colors: scope::palette() }
    }
}

impl Moving for Scope<'_> {
    fn format(&self) -> &'static str {
        "index4"
    }

    fn next(&mut self, mut send: impl FnMut(&[u8])) -> Result<(), Error> {
        self.scope.draw()?;
        self.scope.flip(&self.colors, self.line, |_, row| send(row))?;
        Ok(())
    }

    fn whole(&mut self, mut row: impl FnMut(&[u8])) {
        let bytes = SCOPE_BYTES / usize::from(scope::HEIGHT);
        for pixels in self.scope.shown().map_or(&[][..], |shown| &**shown).chunks(bytes) {
            self.colors.expand::<Index4, Be<Rgb565>>(pixels, self.line);
            row(self.line);
        }
    }
}
