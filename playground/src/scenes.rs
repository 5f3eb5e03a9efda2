//! The scenes: those of the examples and firmwares, drawn on a `Screen`.

use core::ops::Range;

use embedded_graphics_core::pixelcolor::Rgb888;
use embedded_raster::{
    paint::Cover,
    pipeline::Pipeline,
    pixel::{row_bytes, Depth16, EGA},
    raster::coverage,
    surface::DepthBuffer,
    text::FONT_8X13,
    Angle, Canvas, CoverageSlot, EdgeSlot, Error, Framebuffer, Index4, Index8, Palette, PixelFormat, Rect,
};
use scene::{cube, page, plasma, scope};

use crate::{
    choice::Scene,
    clock::{self, Face, Ink},
    look::{filled, Look, Table},
    screen::Screen,
    text,
};

/// Columns and rows of the largest scenes.
pub const LARGEST: [u16; 2] = [page::WIDTH, page::HEIGHT];
/// Columns and rows of the clock.
const CLOCK: u16 = 160;
/// Bytes of the depths of the largest band of the cube.
pub const DEPTH_BYTES: usize = row_bytes::<Depth16>(cube::WIDTH) * cube::HEIGHT as usize;

/// Memory that scenes draw with, beside frames.
pub struct Scratch<'a> {
    edges: [EdgeSlot; page::EDGES],
    slots: [CoverageSlot; clock::SLOTS],
    cells: [i32; coverage::cells(CLOCK)],
    signals: scope::Signals,
    sines: plasma::Sines,
    waves: Palette<Rgb888, 256>,
    depths: &'a mut [u8],
}

impl<'a> Scratch<'a> {
    /// With [`DEPTH_BYTES`] for the depths of the cube.
    pub fn new(depths: &'a mut [u8]) -> Self {
        let sines = plasma::Sines::new();
        Self {
            edges: [EdgeSlot::EMPTY; page::EDGES],
            slots: [CoverageSlot::EMPTY; clock::SLOTS],
            cells: [0; coverage::cells(CLOCK)],
            signals: scope::Signals::new(),
            waves: plasma::palette(&sines).map(Rgb888::from),
            sines,
            depths,
        }
    }

    /// The palette of a scene in a frame.
    pub fn inks(&self, scene: Scene, frame: u32) -> Table {
        match scene {
            Scene::Page => filled(&page::COLORS),
            Scene::Cube => filled(&[cube::BACKGROUND]),
            Scene::Plasma => *turned(self.waves, frame).colors(),
            Scene::Scope => filled(&scope::PALETTE),
            Scene::Text => filled(EGA.colors()),
            Scene::Clock => filled(clock::palette().colors()),
        }
    }
}

/// As the plasma turns its palette.
fn turned(mut waves: Palette<Rgb888, 256>, frame: u32) -> Palette<Rgb888, 256> {
    waves.rotate(0..256, frame as usize % 256 * plasma::STEP);
    waves
}

impl Scene {
    /// Columns and rows.
    pub fn size(self) -> [u16; 2] {
        match self {
            Self::Page => [page::WIDTH, page::HEIGHT],
            Self::Cube => [cube::WIDTH, cube::HEIGHT],
            Self::Plasma => [plasma::WIDTH, plasma::HEIGHT],
            Self::Scope => [scope::WIDTH, scope::HEIGHT],
            Self::Text => [text::WIDTH, text::HEIGHT],
            Self::Clock => [CLOCK; 2],
        }
    }

    /// Bytes that a chip spends on drawing so many rows, beside the frame: of depths, and of tables and vertices.
    pub fn scratch_bytes(self, rows: u16) -> [usize; 2] {
        let tables = match self {
            Self::Page => size_of::<[EdgeSlot; page::EDGES]>(),
            Self::Cube => size_of::<cube::Scene<Rgb888>>(),
            Self::Plasma => size_of::<plasma::Sines>(),
            Self::Scope => size_of::<scope::Signals>(),
            Self::Text => 0,
            Self::Clock => size_of::<[CoverageSlot; clock::SLOTS]>() + size_of::<[i32; coverage::cells(CLOCK)]>(),
        };
        let depths = if self == Self::Cube { row_bytes::<Depth16>(cube::WIDTH) * usize::from(rows) } else { 0 };
        [depths, tables]
    }

    /// Draws a part of a frame, so many of its pixels in the order in which they are painted, on a whole screen or a band of it. Returns
    /// how many pixels the whole drawing paints.
    ///
    /// # Errors
    /// None: all tables are as large as the scenes need.
    pub fn draw<F: PixelFormat>(
        self,
        number: u32,
        frame: &mut Framebuffer<'_, F>,
        look: &Look,
        part: Range<u32>,
        scratch: &mut Scratch<'_>,
    ) -> Result<u32, Error> {
        let (size, rows) = (self.size(), rows(frame.window()));
        match self {
            Self::Page => {
                let mut screen = Screen::<F, Index4>::new(frame, look, part);
                page::draw(&mut screen, &mut scratch.edges, Index4::new)?;
                Ok(screen.painted)
            }
            Self::Cube => {
                // As it stands at the moments of the firmware, sixty times as slowly.
                let turn = Angle::degrees(30) + Angle::turns(number % 480, 480);
                let scene = cube::Scene::new(Pipeline::new(size[0], size[1])?, size, turn, |color| color);
                let mut depths = DepthBuffer::<Depth16>::band(&mut *scratch.depths, size[0], size[1], rows)?;
                let mut screen = Screen::<F, Rgb888>::new(frame, look, part);
                scene.draw(&mut screen, &mut depths, cube::BACKGROUND, |_, color| color);
                Ok(screen.painted)
            }
            Self::Plasma => {
                let mut screen = Screen::<F, Index8>::new(frame, look, part);
                plasma::draw(&mut screen, size, &scratch.sines);
                Ok(screen.painted)
            }
            Self::Scope => {
                let mut screen = Screen::<F, Index4>::new(frame, look, part);
                scope::grid(&mut screen, size);
                scope::trace(&mut screen, size, &scratch.signals, number);
                Ok(screen.painted)
            }
            Self::Text => {
                let mut screen = Screen::<F, Index4>::new(frame, look, part);
                text::page(&mut screen, &FONT_8X13, "two\nlines");
                Ok(screen.painted)
            }
            Self::Clock => {
                let mut screen = Screen::<F, Rgb888>::new(frame, look, part);
                screen.fill_window(clock::rgb(Ink::Ground));
                let face = Face { size: CLOCK, time: time(number) };
                face.draw(&mut screen, &mut scratch.slots, &mut scratch.cells, &|ink| Cover(clock::rgb(ink)))?;
                Ok(screen.painted)
            }
        }
    }
}

/// The rows of a frame or a band.
fn rows(window: Rect) -> Range<u16> {
    window.y0 as u16..window.y1 as u16
}

/// A second later with each frame, from 10:09:36 on.
fn time(number: u32) -> clock::Time {
    let seconds = number.wrapping_add(36_576);
    ((seconds / 3600 % 24) as u8, (seconds / 60 % 60) as u8, (seconds % 60) as u8)
}
