//! [`ColorCube`]: the nearest entry of a palette, looked up.

use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};

use super::palette::Palette;
use crate::num::cast::low_u8;

/// For each cell of the cube of colours, the entry of a palette that is nearest to its middle: one table look-up instead of a
/// [search](Palette::nearest) through the palette.
///
/// The table has `LEN` bytes: 64, 512, 4,096 or 32,768, which are 2, 3, 4 or 5 bits of each channel; others do not compile. The finer
/// the cells, the more often it is the entry that a search finds.
/// ```
/// use embedded_graphics_core::pixelcolor::Rgb888;
/// use embedded_raster::pixel::{ColorCube, EGA};
/// let cube = ColorCube::<4096>::new(&EGA);
/// let color = Rgb888::new(250, 90, 80);
/// assert_eq!(cube.nearest(color), EGA.nearest(color));
/// ```
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct ColorCube<const LEN: usize> {
    table: [u8; LEN],
}

impl<const LEN: usize> ColorCube<LEN> {
    /// Bits of a channel.
    const BITS: u32 = {
        assert!(matches!(LEN, 64 | 512 | 4_096 | 32_768), "a cube has 64, 512, 4,096 or 32,768 cells");
        LEN.trailing_zeros() / 3
    };

    /// The table of a palette: `LEN` searches.
    pub fn new<const N: usize>(palette: &Palette<Rgb888, N>) -> Self {
        let mut table = [0; LEN];
        // Counted by hand: an open range checks for its end.
        let mut cell = 0_u32;
        for entry in &mut table {
            // Bits of the cell, then the bit of its middle.
            let channel = |shift: u32| {
                let number = cell >> (Self::BITS.wrapping_mul(shift) & 31) & ((1 << Self::BITS) - 1);
                low_u8((number << 1 | 1) << (7 - Self::BITS))
            };
            *entry = palette.nearest(Rgb888::new(channel(2), channel(1), channel(0)));
            cell = cell.wrapping_add(1);
        }
        Self { table }
    }

    /// The entry of the cell that a colour lies in.
    #[inline]
    pub fn nearest(&self, color: Rgb888) -> u8 {
        let bits = |channel: u8| u32::from(channel) >> (8 - Self::BITS);
        let cell = (bits(color.r()) << Self::BITS | bits(color.g())) << Self::BITS | bits(color.b());
        self.table.get(cell as usize).copied().unwrap_or(0)
    }
}
