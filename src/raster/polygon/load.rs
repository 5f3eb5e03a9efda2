//! [`Loader`]: puts sides into an edge table, and sees to it that those of some rows find room.
//!
//! When the table is full and one more side comes, the band of rows is made lower: the lower half of its rows is left for later, and
//! the sides that begin there give their slots back. So whatever the number of sides, the table holds all sides of the first rows
//! when the last side has come.
//!
//! An error comes before the first pixel: whether every row has enough slots must be known then. So from the first side without a
//! slot on, sides are counted, too: in bucket k of rows, how many begin, in the link of slot k, and how many end there, in its first
//! edge of a bucket. Links and buckets are not needed before all sides have come.

use core::borrow::Borrow;

use super::edge::{EdgeSlot, END};
use crate::{
    geom::{bits, PointFx},
    num::{
        cast::{index, signed, unsigned},
        round::first_centre_from,
    },
    raster::bands::Loaded,
    span::Rect,
    tune::COMPACT,
};

/// Whether bands are made lower while they are loaded. If not, sides without a slot are only counted.
pub(super) const SHRINKS: bool = !COMPACT;

/// Fills the table with the sides that cross the rows of a band, but for those right of it; goes on counting when it is full. Where
/// they are to be `EXACT`, remainders of crossings can be compared, and the band stays as high as it is.
pub(crate) struct Loader<'a, const EXACT: bool = false> {
    table: &'a mut [EdgeSlot],
    rows: (i32, i32),
    /// The centres of the last column: what lies right of them has no crossing at or left of a centre.
    right: i32,
    done: Done,
    /// One if bands are made lower, none in builds where they are not.
    crowd: [Crowd; SHRINKS as usize],
}

/// What has come.
#[derive(Copy, Clone)]
struct Done {
    /// How many sides are in the table. When one finds no room, this becomes `usize::MAX` where bands are made lower, and goes on
    /// counting where they are not.
    filled: usize,
    /// How many found no room, where bands are made lower; else 0.
    others: usize,
    /// The first row of all sides, and the row after their last one.
    first: i32,
    end: i32,
}

/// A table that had too few slots.
#[derive(Copy, Clone)]
struct Crowd {
    /// How many sides were in the table when the first one found no room.
    before: usize,
    /// How many are in it now.
    filled: usize,
    /// The table holds the sides that cross the rows above this one.
    bottom: i32,
    /// Buckets have `2^shift` rows.
    shift: u32,
    /// There was no room for the sides of one row.
    failed: bool,
}

/// What is in a table.
pub(super) struct Found {
    pub(super) loaded: Loaded,
    /// The row after the last one whose sides were loaded.
    pub(super) bottom: i32,
    /// The row after the last one of all sides.
    pub(super) end: i32,
    /// Whether each row is known to have no more sides than there are slots.
    pub(super) fits: bool,
}

impl<'a, const EXACT: bool> Loader<'a, EXACT> {
    pub(super) fn new(band: Rect, table: &'a mut [EdgeSlot]) -> Self {
        #[cfg(test)]
        crate::num::tally::add(crate::num::tally::Work::Band);
        let Rect { y0: top, y1: bottom, .. } = band;
        // It is a coordinate, though the product may be 2^31.
        let right = band.x1.wrapping_mul(256).wrapping_sub(128);
        let crowd = Crowd { before: 0, filled: 0, bottom, shift: 0, failed: false };
        let done = Done { filled: 0, others: 0, first: bottom, end: top };
        Self { table, rows: (top, bottom), right, done, crowd: [crowd; SHRINKS as usize] }
    }

    /// How many sides came, whether there was room for them or not.
    pub(super) fn counted(&self) -> Loaded {
        let Done { filled, others, first, end } = self.done;
        let filled = match self.crowd.first() {
            Some(crowd) if filled == usize::MAX => crowd.before,
            _ => filled,
        };
        Loaded { count: filled.wrapping_add(others), first, end }
    }

    /// The side from a to b.
    #[inline(never)]
    pub(crate) fn side(&mut self, a: PointFx, b: PointFx) {
        let mut done = self.done;
        self.add(&mut done, (a, first_centre_from(bits(a).1)), (b, first_centre_from(bits(b).1)));
        self.done = done;
    }

    /// Closed contours.
    pub(super) fn contours<C>(&mut self, contours: C)
    where
        C: IntoIterator,
        C::Item: IntoIterator,
        <C::Item as IntoIterator>::Item: Borrow<PointFx>,
    {
        // A copy, which stays in registers.
        let mut done = self.done;
        for contour in contours {
            // By reference: it may have many words.
            let mut contour = contour.into_iter();
            let mut vertices = contour.by_ref().map(|v| (*v.borrow(), first_centre_from(bits(*v.borrow()).1)));
            let Some(first) = vertices.next() else { continue };
            let mut last = first;
            // The loop of `each_side`, written out: it would call a closure, and `done` would be in memory.
            loop {
                let next = vertices.next();
                let vertex = next.unwrap_or(first);
                self.add(&mut done, last, vertex);
                if next.is_none() {
                    break;
                }
                last = vertex;
            }
        }
        self.done = done;
    }

    /// A side between two places and the first rows whose centres are not above them.
    #[inline(always)]
    fn add(&mut self, done: &mut Done, (a, ay): (PointFx, i32), (b, by): (PointFx, i32)) {
        #[cfg(test)]
        crate::num::tally::add(crate::num::tally::Work::Edge);
        let (y, end) = (ay.min(by).max(self.rows.0), ay.max(by).min(self.rows.1));
        if y >= end || bits(a).0.min(bits(b).0) > self.right {
            return;
        }
        done.first = done.first.min(y);
        done.end = done.end.max(end);
        if let Some(slot) = self.table.get_mut(done.filled) {
            done.filled = done.filled.wrapping_add(1);
            if EXACT {
                slot.put_exact(a, b, (y, end), ay < by);
            } else {
                slot.put(a, b, (y, end), ay < by);
            }
        } else if SHRINKS && !EXACT {
            done.others = done.others.wrapping_add(1);
            self.done = *done;
            self.squeeze(a, b, (y, end), ay < by);
            done.filled = usize::MAX;
        } else {
            done.filled = done.filled.wrapping_add(1);
        }
    }

    /// Takes a side for which there is no slot left.
    #[cold]
    #[inline(never)]
    fn squeeze(&mut self, a: PointFx, b: PointFx, (y, end): (i32, i32), down: bool) {
        let Some(crowd) = self.crowd.first_mut() else { return };
        let table = &mut *self.table;
        if table.is_empty() {
            crowd.failed = true;
            return;
        }
        let (top, bottom) = self.rows;
        if self.done.filled != usize::MAX {
            (crowd.filled, crowd.before) = (table.len(), table.len());
            crowd.start(table, (top, bottom));
        }
        crowd.count(table, top, (y, end));
        if crowd.filled == table.len() && y < crowd.bottom {
            crowd.make_room(table, (top, self.done.first));
        }
        if y < crowd.bottom {
            if let Some(slot) = table.get_mut(crowd.filled) {
                crowd.filled = crowd.filled.wrapping_add(1);
                // `put` overwrites the bucket, which still counts ends of sides.
                let bucket = slot.bucket.get();
                slot.put(a, b, (y, end.min(crowd.bottom)), down);
                slot.bucket.set(bucket);
            }
        }
    }

    /// What is in the table now that all sides have come.
    pub(super) fn found(self) -> Found {
        let Done { filled, first, end, .. } = self.done;
        let Some(crowd) = self.crowd.first().filter(|_| filled == usize::MAX) else {
            return Found { loaded: self.counted(), bottom: self.rows.1, end, fits: true };
        };
        let fits = !crowd.failed && most_at_once(self.table) <= self.table.len();
        for slot in &*self.table {
            slot.bucket.set(END);
        }
        let loaded = Loaded { count: crowd.filled, first, end: end.min(crowd.bottom) };
        Found { loaded, bottom: crowd.bottom, end, fits }
    }
}

impl Crowd {
    /// Counts the sides that are in the table.
    fn start(&mut self, table: &[EdgeSlot], (top, bottom): (i32, i32)) {
        let rows = unsigned(bottom.wrapping_sub(top));
        while self.shift < 31 && index(signed(rows.wrapping_shr(self.shift))) >= table.len() {
            self.shift = self.shift.wrapping_add(1);
        }
        for slot in table {
            slot.link.set(0);
            slot.bucket.set(0);
        }
        for slot in table {
            self.count(table, top, (slot.y.get(), slot.end()));
        }
    }

    /// Counts a side.
    fn count(&self, table: &[EdgeSlot], top: i32, (y, end): (i32, i32)) {
        let bucket = |y: i32| table.get(index(signed(unsigned(y.wrapping_sub(top)).wrapping_shr(self.shift))));
        if let (Some(first), Some(last)) = (bucket(y), bucket(end.wrapping_sub(1))) {
            first.link.set(first.link.get().saturating_add(1));
            last.bucket.set(last.bucket.get().saturating_add(1));
        }
    }

    /// Takes fewer rows, until a slot is free: each time half of those from the first side on.
    fn make_room(&mut self, table: &mut [EdgeSlot], (top, first): (i32, i32)) {
        while self.filled == table.len() {
            let bottom = first.wrapping_add(signed(unsigned(self.bottom.wrapping_sub(first)) >> 1));
            if bottom <= top {
                self.failed = true;
                return;
            }
            self.bottom = bottom;
            self.filled = 0;
            for i in 0..table.len() {
                let Some(slot) = table.get(i).filter(|slot| slot.y.get() < self.bottom) else { continue };
                let side = slot.side_above(self.bottom);
                if let Some(place) = table.get_mut(self.filled) {
                    place.take_over(side);
                }
                self.filled = self.filled.wrapping_add(1);
            }
        }
    }
}

/// How many sides a bucket of rows has at the most, those that go through it and those that begin or end in it.
fn most_at_once(table: &[EdgeSlot]) -> usize {
    let (mut now, mut most) = (0_usize, 0);
    for slot in table {
        now = now.wrapping_add(slot.link.get().into());
        most = most.max(now);
        now = now.wrapping_sub(slot.bucket.get().into());
    }
    most
}
