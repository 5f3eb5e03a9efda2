//! Scenes that move: each frame follows from the one before it, so it is drawn once. It goes to an ST7789, or another controller of its
//! kind, through the adapters of `embedded-raster-displays`. Checksums are taken of what the display shows then, and of all that it was sent.

use embedded_graphics::pixelcolor::Rgb565;
use embedded_hal::digital::OutputPin;
use embedded_hal::spi::SpiDevice;
use embedded_raster::pixel::Be;
use embedded_raster::{buffer_bytes, Bitmap, BufferError, Framebuffer, Index4, Index8, Palette};
use embedded_raster_displays::{BusError, Error, Spi, Tft565};

use crate::{plasma, scope};

/// Frames that are drawn.
pub const FRAMES: u32 = 6;
/// Bytes of a row as it is sent, in 16 bits.
pub const LINE: usize = 2 * crate::WIDTH as usize;
/// Bytes of the plasma.
pub const PLASMA_BYTES: usize = buffer_bytes::<Index8>(plasma::WIDTH, plasma::HEIGHT);
/// Bytes of each of the two buffers of the oscilloscope.
pub const SCOPE_BYTES: usize = buffer_bytes::<Index4>(scope::WIDTH, scope::HEIGHT);

/// There is too little memory, or the bus has failed.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Failed;

impl From<BufferError> for Failed {
    fn from(_: BufferError) -> Self {
        Self
    }
}

impl From<Error> for Failed {
    fn from(_: Error) -> Self {
        Self
    }
}

impl<B, P> From<BusError<B, P>> for Failed {
    fn from(_: BusError<B, P>) -> Self {
        Self
    }
}

/// One frame after the other.
pub trait Moving {
    /// How its pixels are stored.
    fn format(&self) -> &'static str;

    /// Draws the next frame, which is shown from then on.
    ///
    /// # Errors
    /// There is too little memory.
    fn draw(&mut self) -> Result<(), Failed>;

    /// Sends what the display is to be sent of it: the same each time, until the next one is drawn.
    ///
    /// # Errors
    /// There is too little memory, or the bus fails.
    fn send<D: SpiDevice, P: OutputPin>(&mut self, spi: &mut Spi<D, P>) -> Result<(), Failed>;

    /// Each row of what is shown, in 16 bits with the high byte first.
    fn whole(&mut self, row: impl FnMut(&[u8]));
}

/// The plasma.
pub struct Plasma<'a> {
    pixels: &'a mut [u8],
    line: &'a mut [u8],
    colors: Palette<Rgb565, 256>,
    /// Frames that were drawn.
    frames: u32,
}

impl<'a> Plasma<'a> {
    /// Its pixels are drawn here.
    ///
    /// # Errors
    /// `pixels` is shorter than [`PLASMA_BYTES`].
    pub fn new(pixels: &'a mut [u8], line: &'a mut [u8]) -> Result<Self, Failed> {
        let sines = plasma::Sines::new();
        let mut frame = Framebuffer::<Index8>::new(&mut *pixels, plasma::WIDTH, plasma::HEIGHT)?;
        plasma::draw(&mut frame, [plasma::WIDTH, plasma::HEIGHT], &sines);
        Ok(Self { pixels, line, colors: plasma::palette(&sines), frames: 0 })
    }

    /// The colours that are shown.
    fn shown(&self) -> Palette<Rgb565, 256> {
        plasma::turned(&self.colors, self.frames.saturating_sub(1))
    }
}

impl Moving for Plasma<'_> {
    fn format(&self) -> &'static str {
        "index8"
    }

    fn draw(&mut self) -> Result<(), Failed> {
        self.frames += 1;
        Ok(())
    }

    fn send<D: SpiDevice, P: OutputPin>(&mut self, spi: &mut Spi<D, P>) -> Result<(), Failed> {
        let palette = self.shown();
        let frame = Bitmap::<Index8>::new(&*self.pixels, plasma::WIDTH, plasma::HEIGHT)?;
        spi.send(Tft565::new().through(&frame, [frame.window()], &palette, self.line)?)?;
        Ok(())
    }

    fn whole(&mut self, row: impl FnMut(&[u8])) {
        let palette = self.shown();
        if let Ok(frame) = Bitmap::new(&*self.pixels, plasma::WIDTH, plasma::HEIGHT) {
            plasma::send(&frame, &palette, self.line, row);
        }
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

    fn draw(&mut self) -> Result<(), Failed> {
        self.scope.draw()?;
        self.scope.flip();
        Ok(())
    }

    fn send<D: SpiDevice, P: OutputPin>(&mut self, spi: &mut Spi<D, P>) -> Result<(), Failed> {
        let Self { scope, line, colors } = self;
        let sent = scope.send(|frame, jobs| -> Result<(), Failed> {
            spi.send(Tft565::new().through(frame, jobs, colors, line)?)?;
            Ok(())
        })?;
        sent.unwrap_or(Ok(()))
    }

    fn whole(&mut self, mut row: impl FnMut(&[u8])) {
        let bytes = SCOPE_BYTES / usize::from(scope::HEIGHT);
        for pixels in self.scope.pixels().map_or(&[][..], |pixels| &**pixels).chunks(bytes) {
            self.colors.expand::<Index4, Be<Rgb565>>(pixels, self.line);
            row(self.line);
        }
    }
}
