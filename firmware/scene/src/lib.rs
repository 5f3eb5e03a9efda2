//! Frames that every chip and the host draw alike: the map of the world, a scene of every way to draw, and the page of all
//! shapes that `cargo run --example shapes` shows.
//!
//! The same code everywhere, integers only: their checksums must be equal, to the bit.
#![no_std]

pub mod map;
#[path = "../../../examples/shapes/page.rs"]
pub mod page;
pub mod shapes;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::raster::flood::FloodSlot;
use embedded_raster::{EdgeSlot, Error, Framebuffer, Index1, Index4, PixelFormat};

/// Columns of the screen.
pub const WIDTH: u16 = 320;
/// Rows of the screen.
pub const HEIGHT: u16 = 240;
/// Sides that a table holds: neither a country of the map nor the page has more in a row.
pub const EDGES: usize = page::EDGES;

/// A frame that can be drawn.
pub struct Frame {
    /// What it shows.
    pub name: &'static str,
    /// How its pixels are stored.
    pub format: &'static str,
    /// Bytes of memory that it takes.
    pub bytes: usize,
    /// Draws it on that many bytes, whatever they hold.
    pub draw: fn(&mut [u8], &mut [EdgeSlot]) -> Result<(), Error>,
}

/// All of them.
pub const FRAMES: [Frame; 6] = [
    Frame { name: "map", format: "index4", bytes: map::BYTES, draw: map::draw },
    shapes::<Rgb565>("rgb565"),
    shapes::<Index4>("index4"),
    shapes::<Index1>("index1"),
    page::<Rgb565>("rgb565"),
    page::<Index4>("index4"),
];

const fn page<F: PixelFormat>(format: &'static str) -> Frame {
    let bytes = embedded_raster::buffer_bytes::<F>(WIDTH, HEIGHT);
    let draw = |memory: &mut [u8], table: &mut [EdgeSlot]| {
        let ink = |ink: page::Ink| F::unpack(u32::from(ink).wrapping_mul(0x1357) & u32::MAX >> (32 - F::BITS));
        let mut frame = Framebuffer::<F>::new(memory, WIDTH, HEIGHT)?;
        page::draw(&mut frame, table, ink)?;
        page::pour(&mut frame, &mut [FloodSlot::EMPTY; 16], ink)
    };
    Frame { name: "page", format, bytes, draw }
}

const fn shapes<F: PixelFormat>(format: &'static str) -> Frame {
    let bytes = embedded_raster::buffer_bytes::<F>(WIDTH, HEIGHT);
    Frame { name: "shapes", format, bytes, draw: shapes::draw::<F> }
}
