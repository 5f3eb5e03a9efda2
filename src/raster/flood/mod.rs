//! Flood fill: paints the open pixels that are connected with a seed.
//!
//! The caller says which pixels are *open*, by a [`FloodTarget`], which also paints. A painted pixel is not open any more. Pixels
//! are connected by their sides, or by their corners too: see [`Connectivity`]. Nothing is open outside of the window.
//! ```text
//!        #########          From the seed's run of open pixels, the rows above and below are searched for runs that
//!        #...#...#          touch it; these are painted and searched from in turn. Where a run reaches beyond the one
//!        #.#.#.#.#          that it was found from, the row that the search came from is searched there too.
//!        #.#...#.#
//!        #########          Row ranges that wait for their turn are kept in a table that the caller passes in.
//! ```
//! **Memory.** The table may have any number of slots. A convex region needs one; a picture needs about as many as it has
//! branches that wait at the same time. When there is no slot left, the pixels of the range at hand are painted along their
//! walls instead, which needs no memory: see `walk`. That is many times slower, and the result is the same: nothing that was
//! in the picture before, not even pixels of the new colour, is mistaken for a pixel that was painted.
//!
//! **Work.** With enough slots, every pixel of the region is looked at about once, and so is what borders on it above and
//! below. Along walls, each step looks at eight pixels; a corridor is walked there and back, and each closed loop of
//! corridors costs a lap around the region.
//!
//! Sources: P. Heckbert, "A Seed Fill Algorithm", Graphics Gems, 1990 (row ranges).

mod target;
mod walk;

use embedded_graphics_core::geometry::Point;

pub(crate) use self::target::corridor;
pub use self::target::{Connectivity, FloodSlot, FloodTarget};
use crate::span::{Rect, Span};

/// Paints the open pixels that are connected with `seed`; none if the seed is not open or outside.
///
/// Cannot fail, however short the table is; the module says what a longer one buys.
///
/// Returns how many slots it wanted. If the table was long enough, that is the most that were in use at once. If not, it is the
/// length of the table plus the number of times that no slot was left, each of which made it go along walls.
pub fn fill(target: &mut impl FloodTarget, seed: Point, connectivity: Connectivity, table: &mut [FloodSlot]) -> usize {
    let window = target.window();
    if !window.contains(seed.x, seed.y) || !target.is_open(seed.x, seed.y) {
        return 0;
    }
    let mut flood = Flood { window, connectivity, target, table, len: 0, most: 0, missing: 0 };
    let (x0, x1) = flood.paint_run(seed.x, seed.y, true);
    let rows = |down: i32| FloodSlot { y: seed.y.wrapping_add(down), x0, x1, down };
    flood.put(rows(-1));
    let mut next = Some(rows(1));
    while let Some(pending) = next.or_else(|| flood.take()) {
        next = flood.search(pending);
    }
    flood.most.saturating_add(flood.missing)
}

struct Flood<'f, F> {
    window: Rect,
    connectivity: Connectivity,
    target: &'f mut F,
    table: &'f mut [FloodSlot],
    len: usize,
    /// Slots that were in use at once.
    most: usize,
    /// How often there was none.
    missing: usize,
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
                self.most = self.most.max(self.len);
            }
            None => self.walk_all(pending),
        }
    }

    /// The columns of a range, with those that it touches by a corner if corners connect.
    #[inline(always)]
    fn columns(&self, pending: FloodSlot) -> (i32, i32) {
        let FloodSlot { x0, x1, .. } = pending;
        match self.connectivity {
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
        self.missing = self.missing.saturating_add(1);
        loop {
            x = self.target.find(y, x, end, true);
            if x >= end {
                return;
            }
            walk::paint(self.target, self.window, self.connectivity, (x, y));
        }
    }

    /// Paints the run of an open pixel. `back`: it may begin to the left of the pixel.
    #[inline(always)]
    fn paint_run(&mut self, x: i32, y: i32, back: bool) -> (i32, i32) {
        let x0 = if back { self.target.start(y, self.window.x0, x) } else { x };
        let x1 = self.target.find(y, x.wrapping_add(1), self.window.x1, false);
        if let Some(span) = (Span { y, x0, x1 }).clip_columns(self.window) {
            self.target.paint(span);
        }
        (x0, x1)
    }

    /// Paints the runs in a range and keeps what they lead to; returns a range to go on with.
    fn search(&mut self, pending: FloodSlot) -> Option<FloodSlot> {
        let FloodSlot { mut y, x0, x1, down } = pending;
        if x1 == x0.wrapping_add(1) && self.connectivity == Connectivity::Sides {
            y = self.target.corridor(x0, y, down);
        }
        if y < self.window.y0 || y >= self.window.y1 {
            return None;
        }
        let (from, to) = self.columns(pending);
        // By corners, a run that begins one pixel beyond the end reaches two pixels beyond it.
        let corner = i32::from(self.connectivity == Connectivity::Corners);
        let mut next: Option<FloodSlot> = None;
        let mut x = from;
        loop {
            x = self.target.find(y, x, to, true);
            if x >= to {
                return next;
            }
            let (start, end) = self.paint_run(x, y, x == from);
            if let Some(earlier) = next.replace(FloodSlot { y: y.wrapping_add(down), x0: start, x1: end, down }) {
                self.put(earlier);
            }
            // The row that this search came from may be open to the left and to the right of the range that led here. The
            // pixels next to that range are closed: it was a whole run, or lies between painted pixels.
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
