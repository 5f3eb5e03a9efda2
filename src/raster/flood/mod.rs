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
//! branches that wait at the same time. When there is no slot left, ranges are forgotten that nobody needs:
//! - those without an open pixel: they were painted from another side in the meantime,
//! - those from which a few steps along a wall, over open pixels, lead into another range that waits: from there they will be
//!   painted as well,
//! - small parts of the region, which a few steps lead around: they are painted at once.
//!
//! If there is still none, pixels are painted along their walls, which needs no memory, until the way leads to a range that
//! waits: see `walk`. The result is the same: nothing that was in the picture before, not even pixels of the new colour, is
//! mistaken for a pixel that was painted.
//!
//! **Work.** With enough slots, every pixel of the region is looked at about once, and so is what borders on it above and
//! below: 2 to 6 reads a pixel. With too few, scattered pixels, pillars and combs take at most 8 reads a pixel times how many times
//! too short the table is. Along walls, a step looks at eight pixels, and a corridor is walked there and back. The worst are corridors
//! one pixel wide that close to large loops: each loop costs a lap around the region, and so do the pixels between two loops. In
//! mazes of 201 x 201 pixels that wanted up to 2,000 slots, up to 550 reads a pixel were counted with 16 slots and more, and 7,700
//! with one.
//!
//! Sources: P. Heckbert, "A Seed Fill Algorithm", Graphics Gems, 1990 (row ranges).

mod target;
mod walk;

use embedded_graphics_core::geometry::Point;

pub(crate) use self::target::corridor;
pub use self::target::{Connectivity, FloodSlot, FloodTarget};
use self::walk::{Region, Seen};
use crate::span::Span;

/// Paints the open pixels that are connected with `seed`; none if the seed is not open or outside.
///
/// Cannot fail, however short the table is; the module says what a longer one buys.
///
/// Returns how many slots it wanted. If the table was long enough, that is the most that were in use at once. If not, it is the
/// length of the table plus the number of times that no slot was left.
pub fn fill(target: &mut impl FloodTarget, seed: Point, connectivity: Connectivity, table: &mut [FloodSlot]) -> usize {
    let window = target.window();
    if !window.contains(seed.x, seed.y) || !target.is_open(seed.x, seed.y) {
        return 0;
    }
    let region = Region { target, window, connectivity };
    let waiting = Waiting { table, len: 0, next: None };
    let mut flood = Flood { region, waiting, most: 0, missing: 0, uncleared: usize::MAX };
    let (x0, x1) = flood.paint_run(seed.x, seed.y, true);
    let rows = |down: i32| FloodSlot { y: seed.y.wrapping_add(down), x0, x1, down };
    let mut next = Some(rows(1));
    flood.put(rows(-1), next);
    while let Some(pending) = next.or_else(|| flood.waiting.take()) {
        next = flood.search(pending);
    }
    flood.most.saturating_add(flood.missing)
}

struct Flood<'f, F> {
    region: Region<'f, F>,
    waiting: Waiting<'f>,
    /// Slots that were in use at once.
    most: usize,
    /// How often there was none.
    missing: usize,
    /// How often there was none since the table was last cleared of ranges that are not needed.
    uncleared: usize,
}

/// The ranges that wait for their turn.
struct Waiting<'f> {
    table: &'f mut [FloodSlot],
    len: usize,
    /// The one to go on with before those in the table, known when the table is full.
    next: Option<FloodSlot>,
}

impl Waiting<'_> {
    #[inline]
    fn take(&mut self) -> Option<FloodSlot> {
        self.len = self.len.checked_sub(1)?;
        self.table.get(self.len).copied()
    }

    /// Puts a range into the table; says whether there was a slot.
    #[inline]
    fn put(&mut self, pending: FloodSlot) -> bool {
        let slot = self.table.get_mut(self.len);
        let is_free = slot.is_some();
        if let Some(slot) = slot {
            *slot = pending;
            self.len = self.len.wrapping_add(1);
        }
        is_free
    }

    /// Whether a pixel is in a range that waits.
    fn has(&self, x: i32, y: i32, connectivity: Connectivity) -> bool {
        let table = self.table.get(..self.len).unwrap_or_default();
        let corner = i32::from(connectivity == Connectivity::Corners);
        let is_in =
            |slot: &FloodSlot| y == slot.y && x >= slot.x0.saturating_sub(corner) && x < slot.x1.saturating_add(corner);
        table.iter().chain(&self.next).any(is_in)
    }
}

impl<F: FloodTarget> Flood<'_, F> {
    /// Keeps a range of the window for later. `next` is the one to go on with.
    #[inline]
    fn put(&mut self, pending: FloodSlot, next: Option<FloodSlot>) {
        let window = self.region.window;
        if pending.y < window.y0 || pending.y >= window.y1 {
            return;
        }
        if self.waiting.put(pending) {
            self.most = self.most.max(self.waiting.len);
        } else {
            self.waiting.next = next;
            self.put_in_full_table(pending);
        }
    }

    /// The same when no slot is left.
    #[cold]
    #[inline(never)]
    fn put_in_full_table(&mut self, pending: FloodSlot) {
        self.missing = self.missing.saturating_add(1);
        self.uncleared = self.uncleared.saturating_add(1);
        if !self.must_wait(pending, false) {
            return;
        }
        // Not each time, as all of the table is looked at.
        if self.uncleared > self.waiting.table.len() / 2 {
            self.uncleared = 0;
            let full = core::mem::take(&mut self.waiting.len);
            for at in 0..full {
                let slot = self.waiting.table.get(at).copied();
                if let Some(slot) = slot.filter(|&slot| self.must_wait(slot, false)) {
                    self.waiting.put(slot);
                }
            }
        }
        if !self.waiting.put(pending) {
            self.must_wait(pending, true);
        }
    }

    /// Does without a range where that is possible, and says whether it has to wait all the same: it has open pixels, and a few
    /// steps do not lead from them to a range that waits. If the steps lead around a small part of the region, that is painted.
    /// With `at_once`, a larger part is painted too, along its walls, up to a range that waits: then this one never has to.
    fn must_wait(&mut self, pending: FloodSlot, at_once: bool) -> bool {
        let Self { region, waiting, .. } = self;
        let (y, (mut x, end)) = (pending.y, region.columns(pending));
        loop {
            x = region.target.find(y, x, end, true);
            if x >= end {
                return false;
            }
            let is_found = |x, y| waiting.has(x, y, region.connectivity);
            match region.look_along_wall((x, y), pending.down, is_found) {
                Seen::Found => {}
                Seen::Nothing if !at_once => return true,
                Seen::Nothing | Seen::Closed => {
                    let connectivity = region.connectivity;
                    region.paint_along_walls((x, y), |x, y| waiting.has(x, y, connectivity));
                }
            }
            // What is left of this run is connected with the pixel that the walk ended at.
            x = region.target.find(y, x, end, false);
        }
    }

    /// Paints the run of an open pixel. `back`: it may begin to the left of the pixel.
    #[inline(always)]
    fn paint_run(&mut self, x: i32, y: i32, back: bool) -> (i32, i32) {
        let x0 = if back { self.region.target.start(y, self.region.window.x0, x) } else { x };
        let x1 = self.region.target.find(y, x.wrapping_add(1), self.region.window.x1, false);
        if let Some(span) = (Span { y, x0, x1 }).clip_columns(self.region.window) {
            self.region.target.paint(span);
        }
        (x0, x1)
    }

    /// Paints the runs in a range and keeps what they lead to; returns a range to go on with.
    fn search(&mut self, pending: FloodSlot) -> Option<FloodSlot> {
        let FloodSlot { mut y, x0, x1, down } = pending;
        if x1 == x0.wrapping_add(1) && self.region.connectivity == Connectivity::Sides {
            y = self.region.target.corridor(x0, y, down);
        }
        if y < self.region.window.y0 || y >= self.region.window.y1 {
            return None;
        }
        let (from, to) = self.region.columns(pending);
        // By corners, a run that begins one pixel beyond the end reaches two pixels beyond it.
        let corner = i32::from(self.region.connectivity == Connectivity::Corners);
        let mut next: Option<FloodSlot> = None;
        let mut x = from;
        loop {
            x = self.region.target.find(y, x, to, true);
            if x >= to {
                return next;
            }
            let (start, end) = self.paint_run(x, y, x == from);
            if let Some(earlier) = next.replace(FloodSlot { y: y.wrapping_add(down), x0: start, x1: end, down }) {
                self.put(earlier, next);
            }
            // The row that this search came from may be open to the left and to the right of the range that led here. The
            // pixels next to that range are closed: it was a whole run, or lies between painted pixels.
            let back =
                FloodSlot { y: y.wrapping_sub(down), x0: start, x1: x0.wrapping_sub(1), down: down.wrapping_neg() };
            if back.x0 < back.x1.saturating_add(corner) && start < x0 {
                self.put(back, next);
            }
            let back = FloodSlot { x0: x1.wrapping_add(1), x1: end, ..back };
            if back.x0 < back.x1.saturating_add(corner) && x1 < end {
                self.put(back, next);
            }
            x = end.saturating_add(1);
        }
    }
}
