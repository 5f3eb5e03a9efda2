//! Pixel formats, and pictures packed for them.

use core::array::from_fn;

use super::{Indexed, Lcg, Sprite, HEIGHT, WIDTH};

/// How a frame stores its pixels. Rows start on a byte; the leftmost pixel of a byte is its highest.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Format {
    /// 16 bits, little-endian.
    Rgb565,
    /// 8 bits.
    Gray8,
    /// 4 bits.
    Gray4,
    /// 1 bit.
    Binary,
}

impl Format {
    /// As it appears in the table.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Rgb565 => "rgb565",
            Self::Gray8 => "gray8",
            Self::Gray4 => "gray4",
            Self::Binary => "binary",
        }
    }

    /// Bits of a pixel.
    pub const fn bits(self) -> usize {
        match self {
            Self::Rgb565 => 16,
            Self::Gray8 => 8,
            Self::Gray4 => 4,
            Self::Binary => 1,
        }
    }

    /// Bytes of a frame.
    pub const fn frame_bytes(self) -> usize {
        WIDTH * self.bits() / 8 * HEIGHT
    }
}

const SIDE: usize = Sprite::SIDE;
/// Pixels of the sprite.
pub(super) const PIXELS: u32 = (SIDE * SIDE) as u32;
/// Half of the sprite is a disc, the rest is the colour key: 25.5 squared is half of 64 squared
/// divided by pi.
const RADIUS_SQUARED: i32 = 650;

/// What is copied into a frame, in one format.
pub struct Pictures {
    /// The sprite; at less than 16 bits the end is not used.
    pub(super) sprite: [u8; SIDE * SIDE * 2],
    indices: [u8; WIDTH * HEIGHT],
    palette: [u16; 256],
}

impl Pictures {
    /// Makes all pictures, the same each time.
    pub fn new(format: Format) -> Self {
        let random = &mut Lcg::new(0xB11F);
        Self {
            sprite: sprite(random, format),
            indices: from_fn(|_| random.bits() as u8),
            palette: from_fn(|_| random.bits()),
        }
    }

    pub(super) fn indexed(&self) -> Indexed<'_> {
        Indexed { indices: &self.indices, palette: &self.palette }
    }
}

fn sprite(random: &mut Lcg, format: Format) -> [u8; SIDE * SIDE * 2] {
    let mut bytes = [0; SIDE * SIDE * 2];
    for pixel in 0..SIDE * SIDE {
        // Drawn for every pixel, so that the formats show the same picture.
        let ink = random.ink();
        let value = if is_opaque(pixel) { ink.0 } else { 0 };
        let bit = pixel * format.bits();
        match format {
            Format::Rgb565 => bytes[bit / 8..bit / 8 + 2].copy_from_slice(&value.to_le_bytes()),
            _ => {
                let low = value & ((1 << format.bits()) - 1);
                bytes[bit / 8] |= (low << (8 - format.bits() - bit % 8)) as u8;
            }
        }
    }
    bytes
}

fn is_opaque(pixel: usize) -> bool {
    let from_centre = |at: usize| at as i32 - SIDE as i32 / 2;
    from_centre(pixel % SIDE).pow(2) + from_centre(pixel / SIDE).pow(2) <= RADIUS_SQUARED
}

/// Pixels of the sprite that are not the colour key.
pub(super) fn opaque_pixels() -> u32 {
    (0..SIDE * SIDE).filter(|&pixel| is_opaque(pixel)).count() as u32
}
