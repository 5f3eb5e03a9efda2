//! [`Grain`]: damage in the pieces that a display takes.
//!
//! Many displays cannot be sent single pixels: a byte holds several of them, columns come in pairs, an OLED has pages of eight rows. So
//! a rectangle is made larger until it starts and ends between such *grains*, and rectangles that then lie side by side are joined.
//! ```text
//!   damage            grains of 8 rows      jobs
//!   row  5  +--+      row 0   +--+
//!   row  9  +--+ +-+          |  |+-+  ->   one rectangle of rows 0 to 15
//!   row 12       +-+  row 16  +--+
//! ```

use crate::{
    span::Rect,
    surface::{Damage, Layout},
};

/// The columns and rows that a display takes at once: what is sent to it starts and ends at multiples of both, or where the screen ends.
///
/// | display | grain |
/// |---|---|
/// | ST7789, ILI9341, GC9A01 with 16 bits per pixel | `Grain::new(1, 1)` |
/// | SSD1306, SH1106: pages | `Grain::new(1, 8)` |
/// | CO5300, RM67162 and other AMOLEDs: pairs of columns and of rows | `Grain::new(2, 2)` |
/// | SSD1322, SSD1327: a column address for two or four pixels | `Grain::new(2, 1)`, `Grain::new(4, 1)` |
/// | e-paper with eight pixels to a byte | `Grain::new(8, 1)` |
/// | Sharp's memory displays: whole rows | `Grain::new(u16::MAX, 1)` |
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Grain {
    columns: u16,
    rows: u16,
}

impl Grain {
    /// So many columns and rows; 0 counts as 1.
    pub const fn new(columns: u16, rows: u16) -> Self {
        Self { columns, rows }
    }

    /// What starts and ends with whole bytes in memory of this layout: for displays that are sent bytes as they lie there.
    /// ```
    /// use embedded_graphics_core::pixelcolor::{Gray4, BinaryColor};
    /// use embedded_raster::{present::Grain, surface::{Packed12, Pages, Rows}};
    /// assert_eq!(Grain::of::<Rows<Gray4>>(), Grain::new(2, 1));
    /// assert_eq!(Grain::of::<Pages<BinaryColor>>(), Grain::new(1, 8));
    /// assert_eq!(Grain::of::<Packed12>(), Grain::new(2, 1));
    /// ```
    pub fn of<L: Layout>() -> Self {
        // The fewest columns of which eight times as many take eight times as many bytes: they end where a byte does.
        let are_whole =
            |&columns: &u16| L::row_bytes(columns).saturating_mul(8) == L::row_bytes(columns.saturating_mul(8));
        Self { columns: (1..8).find(are_whole).unwrap_or(8), rows: L::PAGE }
    }

    /// The smallest rectangle of whole grains that holds `area`, as far as it lies on the screen.
    #[must_use]
    pub fn around(self, area: Rect, screen: Rect) -> Rect {
        let Self { columns, rows } = self;
        let area = area.intersection(screen);
        if area.is_empty() {
            return area;
        }
        let (x0, y0) = (floor(area.x0, columns), floor(area.y0, rows));
        // From the grain of the last pixel on.
        let end = |end: i32, grain: u16| floor(end.wrapping_sub(1), grain).saturating_add(grain.max(1).into());
        Rect::new(x0, y0, end(area.x1, columns), end(area.y1, rows)).intersection(screen)
    }

    /// What is to be sent so that all damage is: rectangles of whole grains, the topmost first. Empty if nothing has changed.
    ///
    /// ```
    /// use embedded_raster::{present::Grain, surface::Damage, Rect};
    /// let mut damage = Damage::<8>::new();
    /// damage.add(Rect::new(90, 25, 97, 27));
    /// damage.add(Rect::new(3, 5, 7, 9));
    /// let jobs = Grain::new(1, 8).jobs(&damage, Rect::new(0, 0, 128, 64));
    /// assert!(jobs.eq([Rect::new(3, 0, 7, 16), Rect::new(90, 24, 97, 32)]));
    /// ```
    pub fn jobs<const N: usize>(self, damage: &Damage<N>, screen: Rect) -> Jobs<N> {
        let mut left = Damage::new();
        for &area in damage.areas() {
            left.insert(self.around(area, screen));
        }
        Jobs { left }
    }
}

/// The last multiple of a grain that is not after n.
fn floor(n: i32, grain: u16) -> i32 {
    n.saturating_sub(n.checked_rem_euclid(grain.into()).unwrap_or(0))
}

/// What is to be sent to a display: see [`Grain::jobs`].
#[derive(Clone, Debug)]
pub struct Jobs<const N: usize> {
    left: Damage<N>,
}

impl<const N: usize> Iterator for Jobs<N> {
    type Item = Rect;

    fn next(&mut self) -> Option<Rect> {
        let areas = (0..N).zip(self.left.areas());
        let (_, _, topmost) = areas.map(|(at, area)| (area.y0, area.x0, at)).min()?;
        Some(self.left.take(topmost))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (self.left.areas().len(), Some(self.left.areas().len()))
    }
}

impl<const N: usize> ExactSizeIterator for Jobs<N> {}
