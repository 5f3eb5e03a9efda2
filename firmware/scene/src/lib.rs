//! Frames that every chip and the host draw alike: the map of the world, and a scene of all shapes.
//!
//! The same code everywhere, integers only: their checksums must be equal, to the bit.
#![no_std]

pub mod map;
pub mod shapes;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::{Edge, Error, Index1, Index4, PixelFormat};

/// Columns of the screen.
pub const WIDTH: u16 = 320;
/// Rows of the screen.
pub const HEIGHT: u16 = 240;
/// Sides that a table holds: a country of the map has more in no row.
pub const EDGES: usize = 80;

/// A frame that can be drawn.
pub struct Frame {
    /// What it shows.
    pub name: &'static str,
    /// How its pixels are stored.
    pub format: &'static str,
    /// Bytes of memory that it takes.
    pub bytes: usize,
    /// Draws it on that many bytes, whatever they hold.
    pub draw: fn(&mut [u8], &mut [Edge]) -> Result<(), Error>,
}

/// All of them.
pub const FRAMES: [Frame; 4] = [
    Frame { name: "map", format: "index4", bytes: map::BYTES, draw: map::draw },
    shapes::<Rgb565>("rgb565"),
    shapes::<Index4>("index4"),
    shapes::<Index1>("index1"),
];

const fn shapes<F: PixelFormat>(format: &'static str) -> Frame {
    let bytes = embedded_raster::buffer_bytes::<F>(WIDTH, HEIGHT);
    Frame { name: "shapes", format, bytes, draw: shapes::draw::<F> }
}
