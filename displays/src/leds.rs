//! Matrices of addressable LEDs, WS2812 and their kin: one long strip, laid out in rows or columns.
//!
//! ```text
//!   serpentine          0  1  2  3        the same way      0  1  2  3
//!                       7  6  5  4                          4  5  6  7
//!                       8  9 10 11                          8  9 10 11
//! ```
//! [`leds`] gives the pixels of a frame in the order of the strip, for any driver that takes an iterator, such as those of
//! `smart-leds`: its `RGB8` is made by the closure. [`grb`] is the order of bytes on the wire.

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{Rgb888, RgbColor},
};
use embedded_raster::surface::{Frame, Layout};

/// How a strip runs over a matrix. By default in rows from the top left corner, each from left to right.
#[expect(clippy::struct_excessive_bools, reason = "they are independent of each other, and all sixteen are built")]
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Wiring {
    /// Every other row, or column, runs backwards: the strip turns at its end.
    pub is_serpentine: bool,
    /// The strip runs in columns.
    pub in_columns: bool,
    /// It begins at the right side.
    pub from_right: bool,
    /// It begins at the bottom.
    pub from_bottom: bool,
}

impl Wiring {
    /// A strip that turns at the end of each row, from the top left corner on: what most panels are.
    pub const SERPENTINE: Self = Self { is_serpentine: true, in_columns: false, from_right: false, from_bottom: false };

    /// Where the LED of a number is on a matrix of `width` x `height`; `None` if there is none.
    /// ```
    /// use embedded_graphics_core::geometry::Point;
    /// use embedded_raster_displays::leds::Wiring;
    /// assert_eq!(Wiring::SERPENTINE.place(7, 4, 3), Some(Point::new(0, 1)));
    /// ```
    pub fn place(self, number: u32, width: u16, height: u16) -> Option<Point> {
        let (width, height) = (u32::from(width), u32::from(height));
        let (long, lines) = if self.in_columns { (height, width) } else { (width, height) };
        let line = number.checked_div(long).filter(|&line| line < lines)?;
        let along = number.checked_rem(long)?;
        let back = |n: u32, of: u32| of.saturating_sub(1).saturating_sub(n);
        let along = if self.is_serpentine && line % 2 != 0 { back(along, long) } else { along };
        let (x, y) = if self.in_columns { (line, along) } else { (along, line) };
        let x = if self.from_right { back(x, width) } else { x };
        let y = if self.from_bottom { back(y, height) } else { y };
        Some(Point::new(i32::try_from(x).ok()?, i32::try_from(y).ok()?))
    }
}

/// The pixels of a frame in the order of the strip, each made into what a driver wants; those that the frame does not have are left dark
/// by `convert(None)`.
///
/// ```
/// use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
/// use embedded_raster::{pixel::EGA, Bitmap, Index4};
/// use embedded_raster_displays::leds::{grb, leds, Wiring};
/// let picture = Bitmap::<Index4>::new(&[0x14, 0x20], 2, 2)?;
/// let color = |index: Option<Index4>| grb(index.and_then(|index| EGA.get(index.index())).unwrap_or(Rgb888::BLACK));
/// let sent: Vec<u8> = leds(&picture, Wiring::SERPENTINE, color).flatten().collect();
/// // Blue, red, and in the second row, from the right, black and green.
/// assert_eq!(sent, [0, 0, 170, 0, 170, 0, 0, 0, 0, 170, 0, 0]);
/// # Ok::<(), embedded_raster::BufferError>(())
/// ```
pub fn leds<M: AsRef<[u8]>, L: Layout, T, C: FnMut(Option<L::Color>) -> T>(
    frame: &Frame<M, L>,
    wiring: Wiring,
    mut convert: C,
) -> impl Iterator<Item = T> + use<'_, M, L, T, C> {
    let size = frame.size();
    let [width, height] = [size.width, size.height].map(|n| u16::try_from(n).unwrap_or(u16::MAX));
    (0..u32::MAX)
        .map_while(move |number| wiring.place(number, width, height))
        .map(move |place| convert(frame.get(place)))
}

/// A colour as WS2812 wants it.
pub fn grb(color: Rgb888) -> [u8; 3] {
    [color.g(), color.r(), color.b()]
}
