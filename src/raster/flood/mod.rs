//! Flood fill: paints the open pixels that are connected with a seed.
//!
//! What is *open* the caller says, by a [`FloodTarget`] that also paints; a painted pixel is not open any more. Pixels are
//! connected by their sides, or by their corners too: see [`Connectivity`]. Nothing is open outside of the window.
//! ```text
//!        #########          From the seed's run of open pixels, the rows above and below are searched for runs that
//!        #...#...#          touch it; these are painted and searched from in turn. Where a run reaches beyond the one
//!        #.#.#.#.#          that it was found from, the row that the search came from is searched there too.
//!        #.#...#.#
//!        #########          Row ranges that wait for their turn are kept in a table that the caller passes in.
//! ```
//! **Memory.** The table may have any number of slots. A convex region needs one; a picture needs about as many as it has
//! branches that wait at the same time. When there is no slot left, the pixels of the range at hand are painted along their
//! walls instead, which needs no memory: see `walk`. That is slower, many times, and the result is the same: nothing that
//! was already in the picture, not even pixels of the new colour, is mistaken for what has been painted.
//!
//! **Work.** With enough slots, every pixel of the region is looked at about once, and so is what borders on it above and
//! below. Along walls, each step looks at eight pixels; a corridor is walked there and back, and each closed loop of
//! corridors costs a lap around the region.
//!
//! Sources: P. Heckbert, "A Seed Fill Algorithm", Graphics Gems, 1990 (row ranges).

use embedded_graphics_core::geometry::Point;

use crate::{
    rect::Rect,
    span::{ClippedSpan, Span},
};

mod walk;

/// Which pixels are neighbours.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Connectivity {
    /// The four that share a side.
    Sides,
    /// The eight that share a side or a corner.
    Corners,
}

/// A slot of the table of a flood fill: a range of a row that is to be searched.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct FloodSlot {
    y: i32,
    x0: i32,
    x1: i32,
    /// From where it was found: -1 from below, 1 from above.
    down: i32,
}

impl FloodSlot {
    /// To make a table of. After a fill, the slots that are not empty any more are those that it took.
    pub const EMPTY: Self = Self { y: 0, x0: 0, x1: 0, down: 0 };
}

/// Pixels that are open or not, and can be painted: what a flood fill works on.
///
/// Whoever has two colours and a way to read and write a pixel has one:
/// ```
/// use embedded_graphics_core::geometry::Point;
/// use embedded_raster::{raster::flood::{fill, FloodTarget, FloodSlot, Connectivity}, ClippedSpan, Rect};
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

    /// The first of the pixels `x0..x1` of a row, all in the window, that is open, or not; `x1` if none is.
    #[inline]
    fn find(&self, y: i32, x0: i32, x1: i32, open: bool) -> i32 {
        let mut x = x0;
        while x < x1 && self.is_open(x, y) != open {
            x = x.wrapping_add(1);
        }
        x
    }

    /// Where the open pixels begin that end before `x`, looking back as far as `x0`.
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
    /// What the fill would do too, pixel by pixel, in a third of the time.
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

/// Paints the open pixels that are connected with `seed`; none if the seed is not open or outside.
///
/// Cannot fail, however short the table is: see the module for what it is good for.
pub fn fill(field: &mut impl FloodTarget, seed: Point, reach: Connectivity, table: &mut [FloodSlot]) {
    let window = field.window();
    if !window.contains(seed.x, seed.y) || !field.is_open(seed.x, seed.y) {
        return;
    }
    let mut flood = Flood { window, reach, field, table, len: 0 };
    let (x0, x1) = flood.paint_run(seed.x, seed.y, true);
    let rows = |down: i32| FloodSlot { y: seed.y.wrapping_add(down), x0, x1, down };
    flood.put(rows(-1));
    let mut next = Some(rows(1));
    while let Some(pending) = next.or_else(|| flood.take()) {
        next = flood.search(pending);
    }
}

struct Flood<'f, F> {
    window: Rect,
    reach: Connectivity,
    field: &'f mut F,
    table: &'f mut [FloodSlot],
    len: usize,
}

impl<F: FloodTarget> Flood<'_, F> {
    fn take(&mut self) -> Option<FloodSlot> {
        self.len = self.len.checked_sub(1)?;
        self.table.get(self.len).copied()
    }

    /// Keeps a range for later. If there is no slot, paints all that it leads to at once.
    #[inline]
    fn put(&mut self, pending: FloodSlot) {
        if pending.y < self.window.y0 || pending.y >= self.window.y1 {
            return;
        }
        match self.table.get_mut(self.len) {
            Some(slot) => {
                *slot = pending;
                self.len = self.len.wrapping_add(1);
            }
            None => self.walk_all(pending),
        }
    }

    /// The columns of a range, those included that it touches by a corner.
    #[inline(always)]
    fn columns(&self, pending: FloodSlot) -> (i32, i32) {
        let FloodSlot { x0, x1, .. } = pending;
        match self.reach {
            Connectivity::Sides => (x0, x1),
            Connectivity::Corners => {
                (x0.saturating_sub(1).max(self.window.x0), x1.saturating_add(1).min(self.window.x1))
            }
        }
    }

    #[cold]
    #[inline(never)]
    fn walk_all(&mut self, pending: FloodSlot) {
        let (mut x, end) = self.columns(pending);
        let FloodSlot { y, .. } = pending;
        loop {
            x = self.field.find(y, x, end, true);
            if x >= end {
                return;
            }
            walk::paint(self.field, self.window, self.reach, (x, y));
        }
    }

    /// Paints the run of an open pixel. Looks to the left of it only if asked to.
    #[inline(always)]
    fn paint_run(&mut self, x: i32, y: i32, back: bool) -> (i32, i32) {
        let x0 = if back { self.field.start(y, self.window.x0, x) } else { x };
        let x1 = self.field.find(y, x.wrapping_add(1), self.window.x1, false);
        if let Some(span) = (Span { y, x0, x1 }).clip_columns(self.window) {
            self.field.paint(span);
        }
        (x0, x1)
    }

    /// Paints the runs in a range and keeps what they lead to; returns a range to go on with.
    fn search(&mut self, pending: FloodSlot) -> Option<FloodSlot> {
        let FloodSlot { mut y, x0, x1, down } = pending;
        if x1 == x0.wrapping_add(1) && self.reach == Connectivity::Sides {
            y = self.field.corridor(x0, y, down);
        }
        if y < self.window.y0 || y >= self.window.y1 {
            return None;
        }
        let (from, to) = self.columns(pending);
        // By corners, a run that begins one pixel beyond the end reaches two pixels beyond it.
        let corner = i32::from(self.reach == Connectivity::Corners);
        let mut next: Option<FloodSlot> = None;
        let mut x = from;
        loop {
            x = self.field.find(y, x, to, true);
            if x >= to {
                return next;
            }
            let (start, end) = self.paint_run(x, y, x == from);
            if let Some(earlier) = next.replace(FloodSlot { y: y.wrapping_add(down), x0: start, x1: end, down }) {
                self.put(earlier);
            }
            // The row that this search came from, left and right of where it came from. The pixels next to that range
            // are closed: it was a whole run, or lies between painted pixels.
            let back =
                FloodSlot { y: y.wrapping_sub(down), x0: start, x1: x0.wrapping_sub(1), down: down.wrapping_neg() };
            if back.x0 < back.x1.saturating_add(corner) && start < x0 {
                self.put(back);
            }
            let back = FloodSlot { x0: x1.wrapping_add(1), x1: end, ..back };
            if back.x0 < back.x1.saturating_add(corner) && x1 < end {
                self.put(back);
            }
            x = end.saturating_add(1);
        }
    }
}
