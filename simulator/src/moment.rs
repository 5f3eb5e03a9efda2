//! [`Moment`]: a frame of a scene that moves, and what else there is to see of it.

use embedded_raster::Rect;

use crate::picture::Picture;

/// A frame.
#[derive(Clone, Debug)]
pub struct Moment {
    /// What the display shows now.
    pub picture: Picture,
    /// What it was sent for it.
    pub sent: Vec<Rect>,
    /// How often each pixel was drawn, row by row; empty if nobody counted.
    pub drawn: Vec<u16>,
    /// CRC-32 of what is shown, as a display is sent it.
    pub crc32: u32,
    /// Bytes of memory that a microcontroller would spend.
    pub ram: usize,
}
