//! [`FloodTarget`]: what a flood fill works on, and the words for it.

use crate::span::{ClippedSpan, Rect};

/// Which pixels are neighbours.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Connectivity {
    /// The four that share a side.
    Sides,
    /// The eight that share a side or a corner.
    Corners,
}

/// A slot of the table of a flood fill: a range of a row that is to be searched.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FloodSlot {
    pub(super) y: i32,
    pub(super) x0: i32,
    pub(super) x1: i32,
    /// Where the search came from: 1 from the row above, -1 from the row below.
    pub(super) down: i32,
}

impl FloodSlot {
    /// An empty slot, to make a table of. After a fill, slots that are not empty any more were used.
    pub const EMPTY: Self = Self { y: 0, x0: 0, x1: 0, down: 0 };
}

/// Pixels that are open or not, and can be painted: what a flood fill works on.
///
/// Whatever can read and paint pixels can be one:
/// ```
/// use embedded_graphics_core::geometry::Point;
/// use embedded_raster::{raster::flood::{fill, Connectivity, FloodSlot, FloodTarget}, ClippedSpan, Rect};
/// struct Text(Vec<Vec<u8>>);
/// impl FloodTarget for Text {
///     fn window(&self) -> Rect {
///         Rect::new(0, 0, self.0[0].len() as i32, self.0.len() as i32)
///     }
///     fn is_open(&self, x: i32, y: i32) -> bool {
///         self.0[y as usize][x as usize] == b'.'
///     }
///     fn paint(&mut self, span: ClippedSpan) {
///         self.0[span.y() as usize][span.x0() as usize..span.x1() as usize].fill(b'o');
///     }
/// }
/// let mut text = Text(["..#..", ".#.#.", "..#.."].map(|row| row.into()).to_vec());
/// fill(&mut text, Point::new(2, 1), Connectivity::Sides, &mut [FloodSlot::EMPTY]);
/// assert_eq!(text.0, ["..#..", ".#o#.", "..#.."].map(|row| row.as_bytes()));
/// fill(&mut text, Point::new(0, 0), Connectivity::Corners, &mut [FloodSlot::EMPTY]);
/// assert_eq!(text.0, ["oo#..", "o#o#.", "oo#.."].map(|row| row.as_bytes()));
/// ```
pub trait FloodTarget {
    /// Where pixels may be painted.
    fn window(&self) -> Rect;

    /// Whether a pixel of the window is open.
    fn is_open(&self, x: i32, y: i32) -> bool;

    /// Paints a span. From then on its pixels must not be open.
    fn paint(&mut self, span: ClippedSpan);

    /// Paints one pixel of the window.
    #[inline]
    fn paint_pixel(&mut self, x: i32, y: i32) {
        self.paint(ClippedSpan::inside(y, x, x.wrapping_add(1)));
    }

    /// The first of the pixels `x0..x1` of a row that is open, or that is not, as `open` says; `x1` if there is none. All lie in
    /// the window.
    #[inline]
    fn find(&self, y: i32, x0: i32, x1: i32, open: bool) -> i32 {
        let mut x = x0;
        while x < x1 && self.is_open(x, y) != open {
            x = x.wrapping_add(1);
        }
        x
    }

    /// Looks back from `x`, as far as `x0`, for as long as pixels are open. Returns the first pixel of that run; `x` if the pixel
    /// before it is not open.
    #[inline]
    fn start(&self, y: i32, x0: i32, x: i32) -> i32 {
        let mut start = x;
        while start > x0 && self.is_open(start.wrapping_sub(1), y) {
            start = start.wrapping_sub(1);
        }
        start
    }

    /// Paints straight up or down from `y` on, by `down`, as long as the way is one pixel wide. Returns the row after the
    /// last pixel painted, which may lie outside of the window; `x` and the row before `y` lie inside.
    ///
    /// A shortcut: the fill would paint the same pixels one by one, in three times the time.
    #[inline]
    fn corridor(&mut self, x: i32, y: i32, down: i32) -> i32 {
        corridor(self, x, y, down)
    }
}

/// [`FloodTarget::corridor`], pixel by pixel.
#[inline(always)]
pub(crate) fn corridor(field: &mut (impl FloodTarget + ?Sized), x: i32, mut y: i32, down: i32) -> i32 {
    let window = field.window();
    let (before, after) = (x.wrapping_sub(1), x.wrapping_add(1));
    while y >= window.y0 && y < window.y1 {
        let wide = x > window.x0 && field.is_open(before, y) || after < window.x1 && field.is_open(after, y);
        if wide || !field.is_open(x, y) {
            break;
        }
        field.paint_pixel(x, y);
        y = y.wrapping_add(down);
    }
    y
}
