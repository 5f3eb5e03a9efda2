//! [`Sheet`]: a picture of 1, 2, 4 or 8 bits, drawn through the public interface of this library alone.

use embedded_graphics_core::{geometry::Point, pixelcolor::Rgb888};
use embedded_raster::{
    buffer_bytes,
    pixel::EGA,
    raster::flood::{Connectivity, FloodSlot},
    Canvas, EdgeSlot, Error, FillRule, Framebuffer, Index1, Index2, Index4, Index8, Palette, PixelFormat, PointFx,
    Rect, Surface,
};

use super::command::Command;
use crate::picture::Picture;

/// A picture and its palette.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sheet {
    /// Columns and rows.
    pub size: (u16, u16),
    /// 1, 2, 4 or 8.
    pub bits: u8,
    /// The framebuffer.
    pub ram: Vec<u8>,
    /// Colours of the indices. Those beyond the depth are not shown.
    pub palette: Palette<Rgb888, 256>,
}

/// How many slots flood fills may take, and edges polygons.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Scratch {
    /// Slots of 16 bytes.
    pub slots: usize,
    /// Edges of 32 bytes.
    pub edges: usize,
}

/// What a command paints with.
#[derive(Copy, Clone)]
pub(super) struct Ink {
    pub(super) color: u8,
    pub(super) filled: bool,
    pub(super) scratch: Scratch,
}

/// Calls `$draw` with the colour type of a depth.
macro_rules! at_depth {
    ($bits:expr, $draw:ident($($argument:expr),*)) => {
        match $bits {
            1 => $draw::<Index1>($($argument),*),
            2 => $draw::<Index2>($($argument),*),
            4 => $draw::<Index4>($($argument),*),
            _ => $draw::<Index8>($($argument),*),
        }
    };
}

impl Sheet {
    /// A sheet of colour 0.
    pub fn new((width, height): (u16, u16), bits: u8) -> Self {
        let ram = vec![0; at_depth!(bits, buffer_bytes(width, height))];
        Self { size: (width, height), bits, ram, palette: standard(bits) }
    }

    /// How many colours it has.
    pub fn colors(&self) -> usize {
        1 << self.bits
    }

    /// What it looks like through a palette.
    pub fn picture(&self, palette: &Palette<Rgb888, 256>) -> Picture {
        // Framebuffers borrow mutably, to read too.
        let mut ram = self.ram.clone();
        at_depth!(self.bits, picture(&mut ram, self.size, palette))
    }

    /// How many pixels of another sheet of the same size and depth differ; all if it is of another.
    pub fn differing(&self, other: &Self) -> usize {
        if (self.size, self.bits) != (other.size, other.bits) {
            return usize::from(self.size.0) * usize::from(self.size.1);
        }
        let places = (0..8 / self.bits).map(|i| u8::MAX >> (8 - self.bits) << (i * self.bits));
        let differing = |(a, b): (&u8, &u8)| places.clone().filter(|place| (a ^ b) & place != 0).count();
        self.ram.iter().zip(&other.ram).map(differing).sum()
    }

    /// Paints a shape, and returns how many slots a flood fill took. After an error nothing is painted.
    pub(super) fn draw(&mut self, command: &Command, ink: Ink) -> Result<usize, Error> {
        at_depth!(self.bits, draw(&mut self.ram, self.size, command, ink))
    }
}

fn picture<C>(ram: &mut [u8], (width, height): (u16, u16), palette: &Palette<Rgb888, 256>) -> Picture
where
    C: PixelFormat<Color = C> + embedded_graphics_core::pixelcolor::PixelColor + Into<u8>,
{
    let frame = Framebuffer::<C>::new(ram, width, height).expect("a sheet has the bytes that it needs");
    Picture::indexed(&frame, palette)
}

fn draw<C: PixelFormat>(
    ram: &mut [u8],
    (width, height): (u16, u16),
    command: &Command,
    ink: Ink,
) -> Result<usize, Error> {
    let mut frame = Framebuffer::<C>::new(ram, width, height)?;
    let color = C::unpack(u32::from(ink.color) & ((1 << C::BITS) - 1));
    match command {
        Command::Clear => frame.clear(color),
        Command::Pencil(points) => frame.draw_polyline(points.iter().copied(), color),
        Command::Line([a, b]) => frame.draw_line(*a, *b, color),
        Command::Ellipse(corners) if ink.filled => frame.fill_outlined_ellipse(area(*corners), color),
        Command::Ellipse(corners) => frame.draw_ellipse(area(*corners), color),
        Command::Rectangle(corners) if ink.filled => frame.fill_area(area(*corners), color),
        Command::Rectangle(corners) => frame.draw_rectangle(area(*corners), color),
        Command::Polygon(corners) => {
            if ink.filled {
                let outline: Vec<_> = corners.iter().map(|&corner| PointFx::centre_of(corner)).collect();
                let mut table = vec![EdgeSlot::EMPTY; ink.scratch.edges];
                frame.fill_polygon_fx(&outline, FillRule::EvenOdd, &mut table, color)?;
            }
            // The pixels that were clicked on belong to it.
            frame.draw_polygon(corners.iter().copied(), color);
        }
        Command::Fill(seed) => {
            let mut table = vec![FloodSlot::EMPTY; ink.scratch.slots];
            return Ok(frame.flood_fill(*seed, Connectivity::Sides, &mut table, color));
        }
        _ => {}
    }
    Ok(0)
}

/// The pixels between two corners, both included.
fn area([a, b]: [Point; 2]) -> Rect {
    let end = |a: i32, b: i32| a.max(b).saturating_add(1);
    Rect::new(a.x.min(b.x), a.y.min(b.y), end(a.x, b.x), end(a.y, b.y))
}

/// Black and white; four greys; EGA; EGA and then the web-safe colours and 24 greys.
fn standard(bits: u8) -> Palette<Rgb888, 256> {
    let (web, greys) = (Palette::web_safe(), Palette::<_, 24>::greys());
    let all: Vec<Rgb888> = match bits {
        1 => Palette::<_, 2>::greys().colors().into(),
        2 => Palette::<_, 4>::greys().colors().into(),
        _ => [&EGA.colors()[..], web.colors(), greys.colors()].concat(),
    };
    Palette::new(std::array::from_fn(|i| all[i % all.len()]))
}
