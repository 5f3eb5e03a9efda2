//! [`Player`]: a program that draws frame after frame, and a display that shows its memory over time, one row after the other.
//!
//! ```text
//!   ticks  0      1,000                                        16,000
//!   display | blank | row 0 | row 1 |   ...           | last row | next refresh: buffers are exchanged
//!   program   part of a frame  |  next part  |   ...   |  finished, next frame
//! ```
//! A part of a frame is in memory from the moment on at which the program begins it. With one buffer, the display shows what is there. With
//! more it shows a frame that is finished. In bands, the display has a memory of its own, and a band is there when it is drawn.
//!
//! It is `simulator::scanout` for a page: a step is a refresh, there is no heap, and a scene is any scene.

use core::ops::Range;

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{Rgb565, Rgb888, RgbColor},
};
use embedded_raster::{
    buffer_bytes,
    pixel::{FloydSteinberg, Xrgb8888},
    present::{Buffer, Swapchain},
    Bitmap, Error, Framebuffer, Index1, Index2, Index4, Index8, Pictures, PixelFormat, Rect,
};

use crate::{
    choice::{Buffers, Choice, Colors, Dither, Scene},
    crc::crc32,
    look::{Look, Table},
    scenes::{Scratch, DEPTH_BYTES, LARGEST},
};

/// Ticks of a refresh, of which the first are blank.
const PERIOD: u32 = 16_000;
const BLANK: u32 = 1_000;
/// Parts of a frame that is drawn whole.
const PARTS: u32 = 7;
/// Bytes of the largest frame, and of what is seen of it: red, green, blue, and 255.
pub const FRAME_BYTES: usize = buffer_bytes::<Xrgb8888>(LARGEST[0], LARGEST[1]);
/// Bytes of the memory of a player.
pub const BYTES: usize = 7 * FRAME_BYTES + DEPTH_BYTES;

/// Calls something generic with the format of a depth.
macro_rules! by_depth {
    ($depth:expr, $format:ident => $result:expr) => {
        match $depth {
            1 => by_depth!(@ Index1, $format => $result),
            2 => by_depth!(@ Index2, $format => $result),
            4 => by_depth!(@ Index4, $format => $result),
            8 => by_depth!(@ Index8, $format => $result),
            16 => by_depth!(@ Rgb565, $format => $result),
            24 => by_depth!(@ Rgb888, $format => $result),
            _ => by_depth!(@ Xrgb8888, $format => $result),
        }
    };
    (@ $type:ident, $format:ident => $result:expr) => {{
        type $format = $type;
        $result
    }};
}

/// The memory of a player.
pub struct Memory<'a> {
    /// What the program draws on: frames or bands.
    buffers: [&'a mut [u8]; 3],
    /// What the display has, where it has a memory of its own.
    display: &'a mut [u8],
    /// Pictures in 24 bits, before they are dithered, and after that.
    full: &'a mut [u8],
    dithered: &'a mut [u8],
    /// What is seen.
    seen: &'a mut [u8],
    depths: &'a mut [u8],
}

impl<'a> Memory<'a> {
    /// Of [`BYTES`] bytes; `None` of fewer.
    pub fn new(bytes: &'a mut [u8]) -> Option<Self> {
        let mut rest = bytes;
        let mut cut = |bytes| {
            let (first, others) = core::mem::take(&mut rest).split_at_mut_checked(bytes)?;
            rest = others;
            Some(first)
        };
        let buffers = [cut(FRAME_BYTES)?, cut(FRAME_BYTES)?, cut(FRAME_BYTES)?];
        let [display, full] = [cut(FRAME_BYTES)?, cut(FRAME_BYTES)?];
        Some(Self {
            buffers,
            display,
            full,
            dithered: cut(FRAME_BYTES)?,
            seen: cut(FRAME_BYTES)?,
            depths: cut(DEPTH_BYTES)?,
        })
    }
}

/// Buffers, by their numbers, and who has them.
enum Chain {
    One(Swapchain<usize, 1>),
    Two(Swapchain<usize, 2>),
    Three(Swapchain<usize, 3>),
}

/// Calls a method of a chain, however long it is.
macro_rules! each {
    ($chain:expr, $name:ident => $result:expr) => {
        match $chain {
            Chain::One($name) => $result,
            Chain::Two($name) => $result,
            Chain::Three($name) => $result,
        }
    };
}

impl Chain {
    fn new(buffers: Buffers) -> Self {
        match buffers.count() {
            1 => Self::One(Swapchain::new([0])),
            2 => Self::Two(Swapchain::new([0, 1])),
            _ => Self::Three(Swapchain::new([0, 1, 2])),
        }
    }
}

/// A frame that is being drawn.
struct Drawing {
    buffer: Buffer<usize>,
    /// Parts that have been drawn, of how many, and ticks that each takes.
    part: u32,
    parts: u32,
    ticks: u32,
}

/// What the program did.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Played {
    /// Refreshes of the display.
    pub refreshes: u32,
    /// Frames that were finished.
    pub frames: u32,
    /// Frames that were shown. The others were replaced by newer ones before that, as are some of the first ones, while nothing is shown.
    pub shown: u32,
    /// The number of the frame that is shown, counted from 1; 0 if none is.
    pub number: u32,
    /// Thousandths of a refresh that the program waited for the display.
    pub waited: u32,
    /// Pixels that the last frame painted. One that was painted twice counts twice.
    pub painted: u32,
}

/// Bytes of memory that a chip spends.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Ram {
    /// Of frames or bands, all of them.
    pub frames: usize,
    /// Of depths.
    pub depths: usize,
    /// Of tables and vertices.
    pub tables: usize,
    /// Of what error diffusion needs: rows in 24 bits, and what is handed on.
    pub dither: usize,
    /// Of a palette in 16 bits.
    pub palette: usize,
}

/// A program and a display.
pub struct Player<'a> {
    buffers: [&'a mut [u8]; 3],
    display: &'a mut [u8],
    full: &'a mut [u8],
    dithered: &'a mut [u8],
    seen: &'a mut [u8],
    scratch: Scratch<'a>,
    choice: Choice,
    look: Look,
    chain: Chain,
    drawing: Option<Drawing>,
    /// Whether a refresh began since the last frame.
    is_synced: bool,
    /// Ticks of this refresh until the program goes on.
    busy: u32,
    /// The palette of what is shown.
    table: Table,
    played: Played,
}

impl<'a> Player<'a> {
    /// Nothing has been drawn.
    pub fn new(memory: Memory<'a>, choice: Choice) -> Self {
        let Memory { buffers, display, full, dithered, seen, depths } = memory;
        let scratch = Scratch::new(depths);
        let look = Look::new(&choice, scratch.inks(choice.scene, 0));
        let (chain, table) = (Chain::new(choice.buffers), *look.table());
        let mut player = Self {
            buffers,
            display,
            full,
            dithered,
            seen,
            scratch,
            choice,
            look,
            chain,
            drawing: None,
            is_synced: false,
            busy: 0,
            table,
            played: Played::default(),
        };
        player.choose(choice);
        player
    }

    /// Begins anew, with memory that is empty.
    pub fn choose(&mut self, choice: Choice) {
        self.choice = choice;
        self.look = Look::new(&choice, self.scratch.inks(choice.scene, 0));
        self.table = *self.look.table();
        self.chain = Chain::new(choice.buffers);
        (self.drawing, self.is_synced, self.busy, self.played) = (None, false, 0, Played::default());
        for memory in self.buffers.iter_mut().chain([&mut self.display, &mut self.seen]) {
            memory.fill(0);
        }
    }

    /// The display is refreshed once, and the program goes on meanwhile.
    ///
    /// # Errors
    /// None: there is enough memory for every choice.
    pub fn refresh(&mut self) -> Result<(), Error> {
        self.is_synced = true;
        if self.choice.buffers.wait() {
            self.flip();
        }
        let rows = u32::from(self.size()[1]);
        for row in 0..rows {
            let time = BLANK + (PERIOD - BLANK) * row / rows;
            while self.busy <= time {
                self.go_on()?;
            }
            self.scan(row as u16)?;
        }
        while self.busy < PERIOD {
            self.go_on()?;
        }
        self.busy -= PERIOD;
        self.played.refreshes += 1;
        Ok(())
    }

    /// Draws the next frame whole and at once, in memory that nobody looks at: to see how long it takes.
    ///
    /// # Errors
    /// None.
    pub fn draw(&mut self) -> Result<(), Error> {
        let number = self.played.frames + 1;
        by_depth!(self.choice.depth, F => self.draw_aside::<F>(number))
    }

    /// Columns and rows of the display.
    pub fn size(&self) -> [u16; 2] {
        self.choice.scene.size()
    }

    /// What was seen in the last refresh: red, green, blue and 255 of each pixel, row by row.
    pub fn seen(&self) -> &[u8] {
        let [width, height] = self.size().map(usize::from);
        &self.seen[..4 * width * height]
    }

    /// The checksum of what was seen in the last refresh.
    pub fn seen_crc32(&self) -> u32 {
        crc32(self.seen())
    }

    /// The checksum of the memory that the display reads.
    pub fn shown_crc32(&self) -> u32 {
        crc32(&self.shown()[..self.frame_bytes()])
    }

    /// What has been done.
    pub fn played(&self) -> Played {
        self.played
    }

    /// What a chip would need.
    pub fn ram(&self) -> Ram {
        let (rows, width) = (self.rows(), self.size()[0]);
        let band = by_depth!(self.choice.depth, F => buffer_bytes::<F>(width, rows));
        let [depths, tables] = self.choice.scene.scratch_bytes(rows);
        let row = size_of::<[i16; 3]>() * usize::from(width);
        Ram {
            frames: band * self.choice.buffers.count(),
            depths,
            tables,
            dither: if self.is_diffused() { buffer_bytes::<Rgb888>(width, rows) + row } else { 0 },
            palette: if self.choice.depth <= 8 { 2 << self.choice.depth } else { 0 },
        }
    }

    /// Rows that are in memory at once.
    fn rows(&self) -> u16 {
        let height = self.size()[1];
        if self.is_in_bands() {
            self.choice.band
        } else {
            height
        }
    }

    /// Bands that are as high as the screen are the screen.
    fn is_in_bands(&self) -> bool {
        (1..self.size()[1]).contains(&self.choice.band)
    }

    /// Inks that are stored as they are leave nothing to hand on.
    fn is_diffused(&self) -> bool {
        let is_exact = match self.choice.scene {
            Scene::Cube | Scene::Clock => false,
            _ => self.choice.colors == Colors::Own && self.choice.depth <= 8,
        };
        self.choice.dither == Dither::FloydSteinberg && self.choice.depth <= 16 && !is_exact
    }

    /// Whether no pixel changes after the first frame: the palette does.
    fn is_still(&self) -> bool {
        let Choice { scene, colors, depth, .. } = self.choice;
        scene == Scene::Plasma && colors == Colors::Own && depth == 8
    }

    fn frame_bytes(&self) -> usize {
        let [width, height] = self.size();
        by_depth!(self.choice.depth, F => buffer_bytes::<F>(width, height))
    }

    /// The memory that the display reads.
    fn shown(&self) -> &[u8] {
        if self.is_in_bands() {
            return self.display;
        }
        // Of a single buffer the display goes on to show what is in it.
        let drawn =
            self.drawing.as_ref().map(|drawing| &drawing.buffer).filter(|_| self.choice.buffers == Buffers::One);
        let shown = drawn.or(each!(&self.chain, chain => chain.shown()));
        shown.map_or(self.buffers[0], |buffer| self.buffers[**buffer])
    }

    /// Shows the frame that waits, and its palette with it.
    fn flip(&mut self) {
        let shown = each!(&mut self.chain, chain => chain.flip()).map(Buffer::frame);
        if let Some(number) = shown {
            self.played.shown += 1;
            self.played.number = number;
            if self.is_still() {
                self.table = self.scratch.inks(self.choice.scene, number);
            }
        }
    }

    /// What the program does next, and how long that takes.
    fn go_on(&mut self) -> Result<(), Error> {
        match self.drawing.take() {
            None => self.begin(),
            Some(drawing) if drawing.part < drawing.parts => {
                by_depth!(self.choice.depth, F => self.draw_part::<F>(&drawing))?;
                self.busy += drawing.ticks;
                self.drawing = Some(Drawing { part: drawing.part + 1, ..drawing });
                Ok(())
            }
            Some(drawing) => {
                each!(&mut self.chain, chain => chain.finish(drawing.buffer));
                self.played.frames += 1;
                if !self.choice.buffers.wait() || self.is_in_bands() {
                    self.flip();
                }
                Ok(())
            }
        }
    }

    /// Begins a frame, or waits for the display.
    fn begin(&mut self) -> Result<(), Error> {
        // What is sent to a display in bands is sent in step with it.
        let is_free = !self.is_in_bands() || !self.choice.buffers.wait() || core::mem::take(&mut self.is_synced);
        let Some(buffer) = is_free.then(|| each!(&mut self.chain, chain => chain.begin())).flatten() else {
            self.played.waited += (PERIOD - self.busy) * 1000 / PERIOD;
            self.busy = PERIOD;
            return Ok(());
        };
        let is_drawn = self.is_still() && (buffer.age().is_some() || self.is_in_bands() && buffer.frame() > 1);
        if !self.is_still() {
            let inks = self.scratch.inks(self.choice.scene, buffer.frame());
            self.look.set_inks(inks);
        }
        self.played.painted = 0;
        let height = self.size()[1];
        let (parts, time) = if is_drawn {
            (1, PERIOD / 16)
        } else {
            let parts = if self.is_in_bands() { height.div_ceil(self.rows()).into() } else { PARTS };
            // A refresh takes 50/3 milliseconds.
            (parts, u32::from(self.choice.time) * PERIOD * 3 / 50)
        };
        if !is_drawn {
            self.played.painted = by_depth!(self.choice.depth, F => self.prepare::<F>(&buffer))?;
        }
        self.drawing = Some(Drawing { buffer, part: is_drawn.into(), parts, ticks: time / parts });
        if is_drawn {
            self.busy += time;
        }
        Ok(())
    }

    /// Counts the pixels of a frame. One that is to be diffused is drawn here, as that goes from row to row.
    fn prepare<F: PixelFormat>(&mut self, buffer: &Buffer<usize>) -> Result<u32, Error> {
        let number = buffer.frame();
        if self.is_diffused() {
            self.draw_aside::<F>(number)?;
        }
        let [width, height] = self.size();
        // Nothing is painted.
        let mut frame = Framebuffer::<F>::new(&mut *self.buffers[**buffer], width, height)?;
        self.choice.scene.draw(number, &mut frame, &self.look, 0..0, &mut self.scratch)
    }

    /// Draws a part of a frame.
    fn draw_part<F: PixelFormat>(&mut self, drawing: &Drawing) -> Result<(), Error> {
        let Drawing { buffer, part, parts, .. } = drawing;
        let ([width, height], band) = (self.size(), self.rows());
        let (is_in_bands, is_diffused) = (self.is_in_bands(), self.is_diffused());
        let (memory, scene, number) = (&mut *self.buffers[**buffer], self.choice.scene, buffer.frame());
        let row_bytes = buffer_bytes::<F>(width, 1);
        if is_in_bands {
            let rows = *part as u16 * band..height.min((*part as u16 + 1) * band);
            let bytes = usize::from(rows.start) * row_bytes..usize::from(rows.end) * row_bytes;
            if is_diffused {
                self.display[bytes.clone()].copy_from_slice(&self.dithered[bytes]);
            } else {
                let mut frame = Framebuffer::<F>::band(memory, width, height, rows.clone())?;
                scene.draw(number, &mut frame, &self.look, 0..u32::MAX, &mut self.scratch)?;
                self.display[bytes].copy_from_slice(frame.row_bytes(rows));
            }
        } else if is_diffused {
            let bytes = share(u32::from(height), *part, *parts);
            let bytes = bytes.start as usize * row_bytes..bytes.end as usize * row_bytes;
            memory[bytes.clone()].copy_from_slice(&self.dithered[bytes]);
        } else {
            let part = share(self.played.painted, *part, *parts);
            let mut frame = Framebuffer::<F>::new(memory, width, height)?;
            scene.draw(number, &mut frame, &self.look, part, &mut self.scratch)?;
        }
        Ok(())
    }

    /// Draws a frame where nobody looks: diffused, if it is to be.
    fn draw_aside<F: PixelFormat>(&mut self, number: u32) -> Result<(), Error> {
        let ([width, height], band, scene) = (self.size(), self.rows(), self.choice.scene);
        let row_bytes = buffer_bytes::<F>(width, 1);
        let is_diffused = self.is_diffused();
        let (look, table, full) = (&self.look, self.look.table(), self.look.full());
        let mut row = [[0; 3]; LARGEST[0] as usize];
        let mut diffusion = FloydSteinberg::new(&mut row[..usize::from(width)]);
        for start in (0..height).step_by(band.into()) {
            let rows = start..height.min(start + band);
            let memory = &mut self.dithered[usize::from(start) * row_bytes..];
            let mut frame = Framebuffer::<F>::band(memory, width, height, rows.clone())?;
            if !is_diffused {
                scene.draw(number, &mut frame, look, 0..u32::MAX, &mut self.scratch)?;
                continue;
            }
            let mut picture = Framebuffer::<Rgb888>::band(&mut *self.full, width, height, rows)?;
            scene.draw(number, &mut picture, &full, 0..u32::MAX, &mut self.scratch)?;
            frame.blit_mapped((0, i32::from(start)), &picture, |color| {
                Some(diffusion.next([color.r(), color.g(), color.b()], |[r, g, b]| {
                    let bits = look.bits(Rgb888::new(r, g, b), Point::default());
                    let shown = look.shown(bits, table);
                    (F::unpack(bits), [shown.r(), shown.g(), shown.b()])
                }))
            });
        }
        Ok(())
    }

    /// The display shows a row.
    fn scan(&mut self, row: u16) -> Result<(), Error> {
        by_depth!(self.choice.depth, F => {
            let [width, height] = self.size();
            let bytes = 4 * usize::from(width);
            // Taken out, as what is shown is behind `self` too.
            let seen = core::mem::take(&mut self.seen);
            let place = &mut seen[usize::from(row) * bytes..][..bytes];
            let frame = Bitmap::<F>::new(self.shown(), width, height)?;
            let area = Rect::new(0, row.into(), width.into(), i32::from(row) + 1);
            for (place, color) in place.chunks_exact_mut(4).zip(frame.colors(area)) {
                let color = self.look.shown(F::pack(color), &self.table);
                place.copy_from_slice(&[color.r(), color.g(), color.b(), 255]);
            }
            self.seen = seen;
        });
        Ok(())
    }
}

/// A part of so many things, which are dealt out as evenly as can be.
fn share(things: u32, part: u32, parts: u32) -> Range<u32> {
    let place = |part: u32| (u64::from(things) * u64::from(part) / u64::from(parts.max(1))) as u32;
    place(part)..place(part + 1)
}
