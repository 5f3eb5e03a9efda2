//! HUB75: matrices of LEDs that are on or off, and have colours by binary code modulation.
//!
//! ```text
//!   pins    R1 G1 B1   of row y in the upper half       bits 0 to 2 of a byte
//!           R2 G2 B2   of row y + height / 2            bits 3 to 5
//!   clock   a column for each pulse, from left to right; then the row is latched, and lit
//!   plane   bit b of all channels, lit for 2^b units of time: together they are the levels
//! ```
//! [`row_pair`] makes the bytes of a pair of rows for all planes, out of any frame. The conversion from pixels to light is a closure: it looks
//! into a palette, and corrects for the eye, which sees half the light as three quarters. DMA or a program shifts the bytes out, and
//! adds what belongs to the board: the clock, the latch, output enable and the address of the row.

use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
use embedded_raster::{
    surface::{Frame, Layout},
    Rect,
};

use crate::{error::Error, pieces::index};

/// Writes the bytes of rows `y` and `y + height / 2` of a frame: `width` bytes for the plane of the lowest bit, as many for the next one,
/// and so on up to bit 7.
///
/// * `light`: the levels of a pixel, 0 to 255 for each channel.
/// * `planes`: of how many bits, 1 to 8; the uppermost ones of the levels.
///
/// Pixels that the frame does not have are dark. Returns the bytes that were written, one plane after the other.
/// ```
/// use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
/// use embedded_raster::{pixel::EGA, Bitmap, Index4};
/// use embedded_raster_displays::hub75;
/// // Light red over dark blue.
/// let picture = Bitmap::<Index4>::new(&[0xc0, 0x10], 2, 2)?;
/// let light = |index: Index4| EGA.get(index.index()).unwrap_or(Rgb888::BLACK);
/// let mut memory = [0; 2 * 8];
/// let planes = hub75::row_pair(&picture, 0, light, 8, &mut memory)?;
/// // 255 85 85 over 0 0 170: the lowest bits of the left column, and those above.
/// assert_eq!((planes[0], planes[2]), (0b000_111, 0b100_001));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
/// # Errors
/// [`Error::LineTooShort`] if `out` does not hold all planes.
pub fn row_pair<'a, M: AsRef<[u8]>, L: Layout>(
    frame: &Frame<M, L>,
    y: u16,
    mut light: impl FnMut(L::Color) -> Rgb888,
    planes: usize,
    out: &'a mut [u8],
) -> Result<&'a [u8], Error> {
    let size = frame.size();
    let (width, planes) = (usize::try_from(size.width).unwrap_or_default(), planes.clamp(1, 8));
    let (needed, given) = (width.saturating_mul(planes), out.len());
    let Some(out) = out.get_mut(..needed) else { return Err(Error::LineTooShort { needed, given }) };
    out.fill(0);
    let lower = i32::try_from(size.height / 2).unwrap_or_default();
    for (y, place) in [(i32::from(y), 0), (i32::from(y).saturating_add(lower), 3)] {
        let row = Rect::new(0, y, i32::MAX, y.saturating_add(1)).intersection(frame.window());
        for (column, color) in (index(row.x0)..).zip(frame.colors(row)) {
            let color = light(color);
            let levels = [color.r(), color.g(), color.b()];
            for plane in 0..planes {
                let bit = 8_usize.wrapping_sub(planes).wrapping_add(plane);
                let bits = levels.iter().rev().fold(0, |bits, level| bits << 1 | level >> bit & 1);
                if let Some(byte) = out.get_mut(plane.wrapping_mul(width).wrapping_add(column)) {
                    *byte |= bits << place;
                }
            }
        }
    }
    Ok(out)
}
