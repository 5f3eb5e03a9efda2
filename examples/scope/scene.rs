//! The scene: an oscilloscope with two channels. Each trace is a thousand line segments and more, new in every frame; the grid behind
//! them stays. So only the traces are erased and drawn, and only what they have touched is sent to the display.
//! ```text
//!   buffer of frame n     holds frame n - 2:   erase its trace, draw that of n       Damage of the trace that is in it
//!   display               holds frame n - 1:   send both traces, n - 1 and n         History
//! ```
//! Integers only and no heap: a chip draws it with this same code.
#![allow(unreachable_pub, reason = "firmwares have this scene as a module of a library")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "samples of 16 bits"
)]

use embedded_graphics_core::pixelcolor::{Rgb565, Rgb888};
use embedded_raster::{
    pixel::Be,
    present::{Grain, History, Jobs, Swapchain},
    surface::{Damage, Recorder, Rows},
    Angle, Bitmap, BufferError, Canvas, Framebuffer, Index4, Palette, PointFx, Rect, Surface,
};

/// Columns of the screen, unless told.
pub const WIDTH: u16 = 320;
/// Rows of the screen, unless told.
pub const HEIGHT: u16 = 240;
/// Samples of a channel in each column: as many segments.
pub const SAMPLES: u16 = 4;

/// Rectangles that hold a trace.
const AREAS: usize = 40;

/// Background, grid, and the two channels.
pub static PALETTE: [Rgb888; 4] =
    [Rgb888::new(4, 12, 20), Rgb888::new(28, 60, 72), Rgb888::new(255, 220, 64), Rgb888::new(64, 216, 255)];
const BACKGROUND: Index4 = Index4::new(0);
const GRID: Index4 = Index4::new(1);
const CHANNELS: [Index4; 2] = [Index4::new(2), Index4::new(3)];

/// The colours as a display is sent them.
pub fn palette() -> Palette<Rgb565, 16> {
    let mut palette = Palette::new([Rgb565::new(0, 0, 0); 16]);
    for (index, &color) in (0..).zip(&PALETTE) {
        palette.set(index, color.into());
    }
    palette
}

/// What is measured: a carrier in packets, and a square wave that overshoots.
#[derive(Clone, Debug)]
pub struct Signals {
    /// Sines of 1,024 angles of a turn, times 2^14.
    sines: [i16; 1024],
}

impl Signals {
    /// The table of sines.
    pub fn new() -> Self {
        let (mut sines, mut angle) = ([0; 1024], 0);
        for place in &mut sines {
            *place = (Angle::turns(angle, 1024).cos_sin().1 >> 16) as i16;
            angle += 1;
        }
        Self { sines }
    }

    /// Of so many 1,024ths of a turn.
    fn sine(&self, angle: i32) -> i32 {
        self.sines[(angle & 1023) as usize].into()
    }

    /// A sample of a channel in a frame, from -2^14 to 2^14.
    fn sample(&self, channel: usize, sample: i32, frame: u32) -> i32 {
        let time = frame as i32 & 0xffff;
        let noise = noise((sample as u32) << 16 ^ frame << 1 ^ channel as u32);
        if channel == 0 {
            // The carrier stands, its envelope wanders.
            let envelope = self.sine(sample * 2 + time * 24).max(0);
            ((self.sine(sample * 9) * (envelope >> 4)) >> 10) + noise
        } else {
            let place = sample & 511;
            let level: i32 = if place < 256 { 9_000 } else { -9_000 };
            // Rings after each edge, less and less.
            let (after, width) = (place & 255, 120 + self.sine(time * 16) / 400);
            let ringing = if after < width { self.sine(after * 40 + 256) * (width - after) / (width * 3) } else { 0 };
            level + ringing * level.signum() + noise / 2
        }
    }
}

impl Default for Signals {
    fn default() -> Self {
        Self::new()
    }
}

/// A few hundred up or down, of a hash of numbers.
fn noise(of: u32) -> i32 {
    let mut hash = of.wrapping_mul(0x9E37_79B1);
    hash ^= hash >> 15;
    hash = hash.wrapping_mul(0x85EB_CA77);
    (hash >> 23) as i32 - 256
}

/// Pixels, and where in them the traces are.
#[derive(Debug)]
pub struct Screen<M> {
    /// Memory of a frame in [`Index4`].
    pub pixels: M,
    traces: Damage<AREAS>,
}

impl<M: AsMut<[u8]>> Screen<M> {
    /// Nothing is known of what is in the memory.
    pub fn new(pixels: M, size: [u16; 2]) -> Self {
        let mut traces = Damage::new();
        traces.add(screen(size));
        Self { pixels, traces }
    }

    /// Draws a frame where another one is.
    ///
    /// # Errors
    /// The memory is too small.
    pub fn draw(&mut self, size: [u16; 2], signals: &Signals, frame: u32) -> Result<(), BufferError> {
        let [width, height] = size;
        let mut on = Framebuffer::<Index4>::new(self.pixels.as_mut(), width, height)?;
        for &area in self.traces.areas() {
            grid(&mut on.clipped(area), size);
        }
        self.traces.clear();
        let mut recorder = Recorder::new(&mut on, |area| self.traces.add(area));
        trace(&mut recorder, size, signals, frame);
        Ok(())
    }
}

fn screen([width, height]: [u16; 2]) -> Rect {
    Rect::new(0, 0, width.into(), height.into())
}

/// The background with ten divisions to the right and eight down.
pub fn grid<S: Surface<Color = Index4>>(on: &mut S, [width, height]: [u16; 2]) {
    let (right, below) = (i32::from(width) - 1, i32::from(height) - 1);
    on.fill_window(BACKGROUND);
    for i in 0..=10 {
        let x = right * i / 10;
        on.draw_line((x, 0), (x, below), GRID);
    }
    for i in 0..=8 {
        let y = below * i / 8;
        on.draw_line((0, y), (right, y), GRID);
    }
    // Five marks to a division, on both axes.
    for i in 1..50 {
        let (x, y) = (right * i / 50, below / 2);
        on.draw_line((x, y - 2), (x, y + 2), GRID);
    }
    for i in 1..40 {
        let (x, y) = (right / 2, below * i / 40);
        on.draw_line((x - 2, y), (x + 2, y), GRID);
    }
}

/// Both channels, segment by segment.
pub fn trace<S: Surface<Color = Index4>>(on: &mut S, [width, height]: [u16; 2], signals: &Signals, frame: u32) {
    let samples = i32::from(width) * i32::from(SAMPLES);
    for (channel, color) in CHANNELS.into_iter().enumerate() {
        // A quarter of the screen above and below its middle, which is at a quarter and at three quarters.
        let (middle, high) = (i32::from(height) * if channel == 0 { 64 } else { 192 }, i32::from(height) * 58);
        let place = |sample: i32| {
            let level = signals.sample(channel, sample, frame);
            PointFx::from_bits(sample * (256 / i32::from(SAMPLES)) + 128, middle - ((high * (level >> 4)) >> 10))
        };
        let mut last = place(0);
        for sample in 1..samples {
            let next = place(sample);
            on.draw_line_fx(last, next, color);
            last = next;
        }
    }
}

/// An oscilloscope with two buffers, and a display that keeps what it was sent.
#[derive(Debug)]
pub struct Scope<M> {
    size: [u16; 2],
    signals: Signals,
    chain: Swapchain<Screen<M>, 2>,
    history: History<AREAS, 2>,
    /// Where the traces of the last frame are.
    last: Damage<AREAS>,
    /// The frame that is shown, and the one before it, which the display has.
    shown: Option<u32>,
    sent: Option<u32>,
}

impl<M: AsMut<[u8]>> Scope<M> {
    /// Nothing is shown.
    pub fn new(buffers: [M; 2], size: [u16; 2]) -> Self {
        Self {
            size,
            signals: Signals::new(),
            chain: Swapchain::new(buffers.map(|pixels| Screen::new(pixels, size))),
            history: History::new(),
            last: Damage::new(),
            shown: None,
            sent: None,
        }
    }

    /// Draws the next frame.
    ///
    /// # Errors
    /// The memory of a buffer is too small.
    pub fn draw(&mut self) -> Result<(), BufferError> {
        // A flip follows each frame, so that one of the two is free.
        let Some(mut buffer) = self.chain.begin() else { return Ok(()) };
        let frame = buffer.frame();
        buffer.draw(self.size, &self.signals, frame)?;
        // It differs from the frame before it where that had its traces, and where this one has its own.
        let mut changed = buffer.traces.clone();
        changed.add_all(&self.last);
        self.history.record(frame, &changed);
        self.last.clone_from(&buffer.traces);
        self.chain.finish(buffer);
        Ok(())
    }
}

impl<M: AsRef<[u8]> + AsMut<[u8]>> Scope<M> {
    /// The display is between two pictures: the frame that was drawn is shown.
    pub fn flip(&mut self) {
        if let Some(shown) = self.chain.flip() {
            self.sent = self.shown;
            self.shown = Some(shown.frame());
        }
    }

    /// Calls `send` with the frame that is shown, and with the rectangles in which it differs from the one before it: in whole bytes, the
    /// topmost first. Until the next frame is drawn they are the same each time.
    ///
    /// # Errors
    /// The memory of a buffer is too small.
    pub fn send<T>(&self, send: impl FnOnce(&Bitmap<'_, Index4>, Jobs<AREAS>) -> T) -> Result<Option<T>, BufferError> {
        let ([width, height], screen) = (self.size, screen(self.size));
        let Some(shown) = self.chain.shown() else { return Ok(None) };
        let frame = Bitmap::<Index4>::new(shown.pixels.as_ref(), width, height)?;
        let changed = self.history.since(self.sent, screen);
        Ok(Some(send(&frame, Grain::of::<Rows<Index4>>().jobs(&changed, screen))))
    }

    /// The same for those who send row by row: with the place of each row of a rectangle, and its bytes, in 16 bits with the high byte first;
    /// `line` has the bytes of a row of the screen.
    ///
    /// # Errors
    /// The memory of a buffer is too small.
    pub fn send_rows(
        &self,
        palette: &Palette<Rgb565, 16>,
        line: &mut [u8],
        mut send: impl FnMut(Rect, &[u8]),
    ) -> Result<(), BufferError> {
        self.send(|frame, jobs| {
            for job in jobs {
                for (y, row) in (job.y0..).zip(frame.bytes(job)) {
                    let Some(line) = line.get_mut(..2 * job.width() as usize) else { continue };
                    palette.expand::<Index4, Be<Rgb565>>(row, line);
                    send(Rect { y0: y, y1: y + 1, ..job }, line);
                }
            }
        })?;
        Ok(())
    }

    /// The pixels that are shown.
    pub fn pixels(&self) -> Option<&M> {
        self.chain.shown().map(|buffer| &buffer.pixels)
    }
}
