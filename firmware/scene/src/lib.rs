//! Frames that every chip and the host draw alike: the map of the world, a scene of every way to draw, the page of all
//! shapes that `cargo run --example shapes` shows, the cube of `cargo run --example cube`, the scenes that move: `plasma` and
//! `scope`, and those of which bands are measured: the map, a page of text and the teapot.
//!
//! The same code everywhere, integers only: their checksums must be equal, to the bit.
#![no_std]

pub mod bands;
#[path = "../../../examples/cube/scene.rs"]
pub mod cube;
#[path = "../../../examples/shapes/hatched.rs"]
pub mod hatched;
pub mod letter;
pub mod map;
pub mod moving;
#[path = "../../../examples/shapes/page.rs"]
pub mod page;
#[path = "../../../examples/plasma/scene.rs"]
pub mod plasma;
#[path = "../../../examples/scope/scene.rs"]
pub mod scope;
pub mod shapes;
pub mod teapot;
pub mod wire;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::pipeline::Pipeline;
use embedded_raster::raster::flood::FloodSlot;
use embedded_raster::surface::DepthBuffer;
use embedded_raster::{Angle, EdgeSlot, Error, Framebuffer, Index1, Index4, PixelFormat};

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
pub const FRAMES: [Frame; 7] = [
    Frame { name: "map", format: "index4", bytes: map::BYTES, draw: map::draw },
    shapes::<Rgb565>("rgb565"),
    shapes::<Index4>("index4"),
    shapes::<Index1>("index1"),
    page::<Rgb565>("rgb565"),
    page::<Index4>("index4"),
    Frame {
        name: "page",
        format: "index1",
        bytes: embedded_raster::buffer_bytes::<Index1>(WIDTH, HEIGHT),
        draw: hatched,
    },
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

fn hatched(memory: &mut [u8], table: &mut [EdgeSlot]) -> Result<(), Error> {
    let mut frame = Framebuffer::<Index1>::new(memory, WIDTH, HEIGHT)?;
    hatched::draw(&mut frame, table)?;
    hatched::pour(&mut frame, &mut [FloodSlot::EMPTY; 16])
}

const fn shapes<F: PixelFormat>(format: &'static str) -> Frame {
    let bytes = embedded_raster::buffer_bytes::<F>(WIDTH, HEIGHT);
    Frame { name: "shapes", format, bytes, draw: shapes::draw::<F> }
}

/// Moments at which the cube is drawn: so many to a turn.
pub const MOMENTS: u16 = 8;

/// Bytes of so many rows of the cube's screen: those of colours, and as many for depths.
pub const fn cube_bytes(rows: u16) -> usize {
    embedded_raster::buffer_bytes::<Rgb565>(cube::WIDTH, rows)
}

/// Draws the cube at a moment, in bands of `rows` rows, and hands each band to `send` before the next one is drawn on the same
/// memory.
///
/// # Errors
/// `colors` or `depths` is shorter than [`cube_bytes`] of the rows.
pub fn draw_cube(
    moment: u16,
    rows: u16,
    colors: &mut [u8],
    depths: &mut [u8],
    mut send: impl FnMut(&[u8]),
) -> Result<(), Error> {
    let (width, height) = (cube::WIDTH, cube::HEIGHT);
    let turn = Angle::degrees(30) + Angle::turns(moment.into(), MOMENTS);
    let scene = cube::Scene::new(Pipeline::new(width, height)?, [width, height], turn, Rgb565::from);
    for start in (0..height).step_by(rows.into()) {
        let band = start..height.min(start + rows);
        let mut frame = Framebuffer::<Rgb565>::band(&mut *colors, width, height, band.clone())?;
        let mut depths = DepthBuffer::band(&mut *depths, width, height, band.clone())?;
        scene.draw(&mut frame, &mut depths, Rgb565::from(cube::BACKGROUND), |_, color| color);
        send(frame.row_bytes(band));
    }
    Ok(())
}
