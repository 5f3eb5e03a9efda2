//! Scenes of a whole screen that are also drawn in bands: the map, a page of text, the teapot.

use core::ops::Range;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::pixel::Depth16;
use embedded_raster::surface::DepthBuffer;
use embedded_raster::{buffer_bytes, EdgeSlot, Error, Framebuffer, Index4};

use crate::{letter, map, teapot, HEIGHT, WIDTH};

/// A scene.
pub struct Banded {
    /// What it shows.
    pub name: &'static str,
    /// How its pixels are stored.
    pub format: &'static str,
    /// Bytes of the pixels of so many rows. They come first in its memory.
    pub pixels: fn(u16) -> usize,
    /// Bytes of all memory that so many rows take: with depths, where it has some.
    pub memory: fn(u16) -> usize,
    /// Draws some rows of the screen on that many bytes.
    pub draw: fn(&mut [u8], Range<u16>, &mut [EdgeSlot]) -> Result<(), Error>,
}

/// All of them.
pub const BANDED: [Banded; 3] = [
    Banded {
        name: "map",
        format: "index4",
        pixels: index4,
        memory: index4,
        draw: |memory, rows, table| map::draw_on(&mut Framebuffer::<Index4>::band(memory, WIDTH, HEIGHT, rows)?, table),
    },
    Banded {
        name: "text",
        format: "rgb565",
        pixels: rgb565,
        memory: rgb565,
        draw: |memory, rows, _| {
            letter::draw(&mut Framebuffer::<Rgb565>::band(memory, WIDTH, HEIGHT, rows)?);
            Ok(())
        },
    },
    Banded {
        name: "teapot",
        format: "rgb565",
        pixels: rgb565,
        memory: |rows| rgb565(rows) + buffer_bytes::<Depth16>(WIDTH, rows),
        draw: |memory, rows, _| {
            let (pixels, depths) = memory.split_at_mut(rgb565(rows.end - rows.start));
            teapot::draw(
                &mut Framebuffer::band(pixels, WIDTH, HEIGHT, rows.clone())?,
                &mut DepthBuffer::band(depths, WIDTH, HEIGHT, rows)?,
            )
        },
    },
];

const fn index4(rows: u16) -> usize {
    buffer_bytes::<Index4>(WIDTH, rows)
}

const fn rgb565(rows: u16) -> usize {
    buffer_bytes::<Rgb565>(WIDTH, rows)
}

/// Bytes that the largest of them takes when it is drawn at once: pixels and depths of 16 bits each.
pub const WHOLE: usize = 4 * WIDTH as usize * HEIGHT as usize;

/// The bands of a screen, of so many rows each.
pub fn bands(rows: u16) -> impl Iterator<Item = Range<u16>> {
    (0..HEIGHT).step_by(rows.max(1).into()).map(move |start| start..HEIGHT.min(start + rows))
}
