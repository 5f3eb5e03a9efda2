//! Filled polygons: any number of contours, concave, with holes, crossing themselves.
//!
//! The scan-line algorithm: the sides *wait*, sorted by their first row; on each row those that cross it are *active*,
//! sorted by where they cross it; between them the fill rule says what is inside. Crossings move by quotient and remainder
//! ([`EdgeSlot`]), so they are exact on every row. Both orders are lists through the slots of the table: an edge that joins,
//! ends or is overtaken is linked anew, and none is ever moved.
//! ```text
//!   waiting, by first row   e -> e -> e -> e ...          the first one joins when its row comes
//!   active, by crossing     e ---> e -> e ---> e
//!                           |      |    |      |
//!   row                 ....[======]....[======]....
//! ```
//! Sides that lie right of the window as a whole are left out. They change no pixel of it, but a span that would end at one of
//! them has no right end, and goes to the side of the window.
//!
//! The table is the caller's. When more sides cross the window than it holds, the fill takes fewer rows at a time: as many as there
//! is room for, which turns out while they are loaded. It fails only when a single row has too many sides, and it finds that out before
//! it emits a span; [`edge_slots`] tells how many slots are enough.
//!
//! Memory: 32 bytes a side, at most 65,535 sides at a time. Work: sides times bands; `n log n` to sort the sides, less when
//! their first rows are spread evenly; on each row of the window the active sides, which are those that cross it and do not lie
//! right of the window, and `k log k` for the k of them that crossed another one.
//!
//! Source: W. M. Newman and R. F. Sproull, "Principles of Interactive Computer Graphics", 1979, chapter 16.

use core::{
    borrow::Borrow,
    cell::Cell,
    mem::{replace, swap},
};

pub mod drop_out;

mod edge;
mod list;
mod load;

pub use self::edge::EdgeSlot;
pub(crate) use self::load::Loader;
use self::{
    edge::{ACTIVE, END},
    list::{get, join, merge, sort},
    load::{Found, SHRINKS},
};
use super::bands::{self, most_of_a_row, Loaded, CHECKED};
use crate::{
    error::EdgeTableFull,
    geom::{polygon::bounds, PointFx},
    num::{
        cast::{index, index_u16, signed, unsigned},
        round::first_centre_from,
    },
    span::{Rect, Sink, Span},
    tune::{keep_rolled, ARMV6, COMPACT},
};

use crate::geom::fill_rule::FillRule;

/// Whether waiting edges are sorted by buckets first, and two edges that are alone are followed over many rows.
const SHORT_CUTS: bool = !COMPACT;

/// Places lie in the columns from `-PLACES` up to this one.
const PLACES: i32 = 1 << 23;

/// Emits the spans of a filled polygon that lie in `window`, top row first and each row from left to right.
///
/// * `contours`: closed outlines, the last vertex joined to the first; any coordinates, any order. It is iterated several
///   times: pass something cheap to clone, such as `[&outline[..]]` or an iterator over the rings of a map.
/// * `table`: scratch memory. Sides that touch no row of the window take no slot, so a low window needs a small table; nor do
///   sides that lie right of the window.
///
/// # Errors
/// [`EdgeTableFull`] if a single row is crossed by more sides than `table` holds, those right of the window not counted.
/// Nothing was emitted then.
/// ```
/// use embedded_raster::{raster::polygon, ClippedSpan, EdgeSlot, FillRule, PointFx, Rect};
/// let outer = [(0, 0), (6, 0), (6, 4), (0, 4)].map(|(x, y)| PointFx::px(x, y));
/// let hole = [(2, 1), (4, 1), (4, 3), (2, 3)].map(|(x, y)| PointFx::px(x, y));
/// let mut spans = vec![];
/// let mut table = [EdgeSlot::EMPTY; 4];
/// polygon::fill([outer, hole], FillRule::EvenOdd, &mut table, Rect::new(0, 0, 9, 9), |s: ClippedSpan| spans.push((s.x0(), s.x1())))?;
/// assert_eq!(spans, [(0, 6), (0, 2), (4, 6), (0, 2), (4, 6), (0, 6)]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[inline]
#[expect(clippy::needless_pass_by_value, reason = "iterators are passed by value")]
pub fn fill<C>(
    contours: C,
    rule: FillRule,
    table: &mut [EdgeSlot],
    window: Rect,
    sink: impl Sink,
) -> Result<(), EdgeTableFull>
where
    C: IntoIterator + Clone,
    C::Item: IntoIterator,
    <C::Item as IntoIterator>::Item: Borrow<PointFx>,
{
    fill_sides(&|_, loader| loader.contours(contours.clone()), rule, table, window, sink)
}

/// As [`fill`], for sides that come in any order: as often as a row is crossed downwards, it is crossed upwards too. They are asked
/// for by the part of the window that they are to be filled in: they may lack whatever does not touch its rows.
pub(crate) fn fill_sides(
    sides: &dyn Fn(Rect, &mut Loader<'_>),
    rule: FillRule,
    table: &mut [EdgeSlot],
    window: Rect,
    mut sink: impl Sink,
) -> Result<(), EdgeTableFull> {
    // There are sides in the columns of places only, and no pixel beside them is inside.
    let window = Rect { x1: window.x1.min(PLACES), ..window };
    if window.is_empty() || window.x1 <= -PLACES {
        return Ok(());
    }
    if SHRINKS {
        return fill_once(sides, rule, table, window, sink);
    }
    let load = |band: Rect, table: &mut [EdgeSlot]| {
        let mut loader = Loader::new(band, table);
        sides(band, &mut loader);
        loader.counted()
    };
    let scan = |table: &[EdgeSlot], band: &Loaded| scan(table, band, rule, window, &mut sink);
    in_bands(load, table, window, CHECKED, scan)
}

/// Loads and paints band after band, each as high as there is room in the table. So the sides are asked for once for each band, and
/// once more for a window of so many rows that their counts in the table do not tell whether each has enough slots.
#[inline(always)]
fn fill_once(
    sides: &dyn Fn(Rect, &mut Loader<'_>),
    rule: FillRule,
    table: &mut [EdgeSlot],
    window: Rect,
    mut sink: impl Sink,
) -> Result<(), EdgeTableFull> {
    // Places in the table are 16 bits; the last one means "none".
    let slots = table.len().min(usize::from(END));
    let Some(table) = table.get_mut(..slots) else { return Ok(()) };
    let (mut band, mut all) = (window, None);
    loop {
        let mut loader = Loader::new(band, table);
        sides(band, &mut loader);
        let found = loader.found();
        let end = *all.get_or_insert(found.end);
        if !found.fits && band == window {
            check_rows(sides, table.len(), window)?;
        }
        let Found { loaded, bottom, .. } = found;
        scan(table, &loaded, rule, window, &mut sink);
        if bottom >= end {
            return Ok(());
        }
        // The first rows may have no side.
        let rows = bottom.wrapping_sub(band.y0.max(loaded.first.min(bottom)));
        let rows = bands::shared(end.wrapping_sub(bottom), rows, slots, loaded.count);
        band = Rect { y0: bottom, y1: bottom.saturating_add(rows).min(end), ..window };
    }
}

/// Finds the row that has too many sides, if there is one.
#[cold]
#[inline(never)]
fn check_rows(sides: &dyn Fn(Rect, &mut Loader<'_>), slots: usize, window: Rect) -> Result<(), EdgeTableFull> {
    let count = |band: Rect, _: &mut [()]| {
        let mut loader = Loader::new(band, &mut []);
        sides(band, &mut loader);
        loader.counted()
    };
    // Slots of no size, as nothing is put into them: only their number matters.
    let mut table = [(); END as usize];
    bands::in_bands(table.get_mut(..slots).unwrap_or_default(), window, &[false], count, |_, _| {})
}

/// [`bands::in_bands`], of as much of the table as places in it can name.
#[inline(always)]
fn in_bands(
    load: impl Fn(Rect, &mut [EdgeSlot]) -> Loaded,
    table: &mut [EdgeSlot],
    window: Rect,
    passes: &[bool],
    scan: impl FnMut(&[EdgeSlot], &Loaded),
) -> Result<(), EdgeTableFull> {
    // Places in the table are 16 bits; the last one means "none".
    let slots = table.len().min(usize::from(END));
    let Some(table) = table.get_mut(..slots) else { return Ok(()) };
    bands::in_bands(table, window, passes, load, scan)
}

/// How many slots an edge table needs for a polygon or a stroke.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EdgeSlots {
    /// With so many, everything is filled at once.
    pub whole: usize,
    /// With so many, no row has too many sides: the fill takes fewer rows at a time. With fewer it fails.
    pub least: usize,
}

/// How many slots [`fill`] needs for a polygon, so that a program can have a table of the right size, or a test can tell that it is
/// large enough.
///
/// Work: that of loading the table for the window and then, where a row may have more sides than all above it, for fewer rows.
/// ```
/// use embedded_raster::{raster::polygon::{edge_slots, EdgeSlots}, PointFx, Rect};
/// let zigzag: Vec<PointFx> = (0..10).map(|i| PointFx::px(i % 2 * 9, i)).collect();
/// assert_eq!(edge_slots([&zigzag], Rect::new(0, 0, 16, 16)), EdgeSlots { whole: 10, least: 2 });
/// ```
#[inline]
#[expect(clippy::needless_pass_by_value, reason = "iterators are passed by value")]
pub fn edge_slots<C>(contours: C, window: Rect) -> EdgeSlots
where
    C: IntoIterator + Clone,
    C::Item: IntoIterator,
    <C::Item as IntoIterator>::Item: Borrow<PointFx>,
{
    edge_slots_of_sides(&|_, loader| loader.contours(contours.clone()), window)
}

/// As [`edge_slots`], for sides as [`fill_sides`] asks for them.
pub(crate) fn edge_slots_of_sides(sides: &dyn Fn(Rect, &mut Loader<'_>), window: Rect) -> EdgeSlots {
    let window = Rect { x1: window.x1.min(PLACES), ..window };
    if window.is_empty() || window.x1 <= -PLACES {
        return EdgeSlots::default();
    }
    let count = |y0: i32, y1: i32| {
        let band = Rect { y0, y1, ..window };
        let mut loader = Loader::new(band, &mut []);
        sides(band, &mut loader);
        loader.counted()
    };
    let whole = count(window.y0, window.y1);
    let least = most_of_a_row(whole.first, whole.end, 0, |y0, y1| count(y0, y1).count);
    EdgeSlots { whole: whole.count, least }
}

/// A box that encloses the pixels of a polygon: those with a centre between the outermost coordinates of its vertices.
/// ```
/// use embedded_raster::{raster::polygon, PointFx, Rect};
/// let kite = [(3, 0), (6, 2), (3, 9), (0, 2)].map(|(x, y)| PointFx::px(x, y));
/// assert_eq!(polygon::extent([kite]), Rect::new(0, 0, 6, 9));
/// ```
pub fn extent<C>(contours: C) -> Rect
where
    C: IntoIterator,
    C::Item: IntoIterator,
    <C::Item as IntoIterator>::Item: Borrow<PointFx>,
{
    let Some((low, high)) = bounds(contours.into_iter().flatten()) else { return Rect::default() };
    let pixel = first_centre_from;
    Rect { x0: pixel(low.0), y0: pixel(low.1), x1: pixel(high.0), y1: pixel(high.1) }
}

/// The edges whose first row is still to come, in buckets of `2^shift` rows.
///
/// Bucket k is a list that starts in slot k of the table, `EdgeSlot::bucket`: there are no more buckets than edges. One bucket
/// at a time is sorted. Where the rows are as many as the edges, there is little left to sort.
struct Waiting {
    /// The next edges, sorted.
    list: u16,
    /// The first row of the next edge; `i32::MAX` if there is none.
    row: i32,
    /// The first bucket after those of the list.
    bucket: usize,
}

impl Waiting {
    fn new(table: &[EdgeSlot], loaded: &Loaded) -> Self {
        let mut waiting = Self { list: END, row: i32::MAX, bucket: 0 };
        let rows = unsigned(loaded.end.wrapping_sub(loaded.first));
        // Without the short cut there is one bucket.
        let mut shift = if SHORT_CUTS { 0 } else { 31 };
        while shift < 31 && index(signed(rows.wrapping_shr(shift))) >= table.len() {
            shift = shift.wrapping_add(1);
            keep_rolled(ARMV6);
        }
        let mut place = 0;
        for edge in table {
            let bucket = index(edge.y.get().wrapping_sub(loaded.first)).wrapping_shr(shift);
            if let Some(slot) = table.get(bucket) {
                edge.link.set(slot.bucket.replace(place));
            }
            place = index_u16(usize::from(place).wrapping_add(1));
        }
        waiting.refill(table);
        waiting
    }

    /// Sorts the next bucket that is not empty.
    fn refill(&mut self, table: &[EdgeSlot]) {
        (self.list, self.row) = (END, i32::MAX);
        while let Some(slot) = table.get(self.bucket) {
            self.bucket = self.bucket.wrapping_add(1);
            let list = slot.bucket.get();
            if let Some(edge) = get(table, list) {
                self.list = if edge.link.get() == END { list } else { sort(table, list) };
                self.row = get(table, self.list).map_or(i32::MAX, |edge| edge.y.get());
                return;
            }
            keep_rolled(ARMV6);
        }
    }

    /// Cuts off the edges of the next row.
    fn take(&mut self, table: &[EdgeSlot]) -> u16 {
        let list = self.list;
        let Some(mut last) = get(table, list) else { return END };
        loop {
            last.y.set(ACTIVE);
            self.list = last.link.get();
            let Some(edge) = get(table, self.list) else {
                self.refill(table);
                return list;
            };
            let row = edge.y.get();
            if row != self.row {
                self.row = row;
                last.link.set(END);
                return list;
            }
            last = edge;
        }
    }
}

/// Paints the band whose sides were loaded.
///
/// While only two edges are active, a round of the outer loop takes many rows, down to where one of them ends or another joins:
/// two that enclose a span, or one whose span goes to the side of the window.
fn scan(table: &[EdgeSlot], loaded: &Loaded, rule: FillRule, window: Rect, sink: &mut impl Sink) {
    let Some(table) = table.get(..loaded.count) else { return };
    let mut waiting = Waiting::new(table, loaded);
    let beyond = EdgeSlot::beyond();
    let (mut active, mut y) = (END, waiting.row);
    loop {
        let joining = if waiting.row == y { waiting.take(table) } else { END };
        active = descend(table, active, joining, y);
        if active == END {
            if waiting.row == i32::MAX {
                return;
            }
            y = waiting.row;
            continue;
        }
        let end = if SHORT_CUTS { last_of_two(table, active, y, waiting.row, rule) } else { y.wrapping_add(1) };
        let mut at = usize::from(active);
        while let Some((mut left, mut right)) = next_pair(table, &beyond, &mut at, rule) {
            let mut row = y;
            loop {
                if let Some(span) = (Span { y: row, x0: left.x(), x1: right.x() }).clip_columns(window) {
                    sink.span(span);
                }
                #[cfg(test)]
                crate::num::tally::add(crate::num::tally::Work::Step);
                row = row.wrapping_add(1);
                if row >= end {
                    break;
                }
                left.step();
                right.step();
                if left.x() > right.x() {
                    // They crossed, and change places.
                    right.link.set(replace(&mut active, left.link.replace(END)));
                    swap(&mut left, &mut right);
                }
            }
        }
        y = end;
    }
}

/// The edges at the ends of the next span of a row, from the edge `at` on; `at` moves behind them. If its right end is not in
/// the table, that is `beyond`.
#[inline(always)]
fn next_pair<'a>(
    table: &'a [EdgeSlot],
    beyond: &'a EdgeSlot,
    at: &mut usize,
    rule: FillRule,
) -> Option<(&'a EdgeSlot, &'a EdgeSlot)> {
    let left = table.get(*at)?;
    let mut winding = left.winding();
    *at = usize::from(left.link.get());
    while let Some(edge) = table.get(*at) {
        winding = winding.wrapping_add(edge.winding());
        *at = usize::from(edge.link.get());
        if winding & rule.mask() == 0 {
            return Some((left, edge));
        }
    }
    Some((left, beyond))
}

/// The row after the last one on which the first span of a list is the only one and has the same edges, from row y on.
#[inline(always)]
fn last_of_two(table: &[EdgeSlot], list: u16, y: i32, row: i32, rule: FillRule) -> i32 {
    let Some(left) = get(table, list) else { return y };
    match get(table, left.link.get()) {
        None => row.min(left.end()),
        Some(right) if right.link.get() == END && left.winding().wrapping_add(right.winding()) & rule.mask() == 0 => {
            row.min(left.end()).min(right.end())
        }
        Some(_) => y.wrapping_add(1),
    }
}

/// Moves the active edges to row `y`: drops those that ended, lets the joining ones in, and restores the order.
#[inline(always)]
fn descend(table: &[EdgeSlot], active: u16, joining: u16, y: i32) -> u16 {
    let (list, mut overtaken) = (Cell::new(active), END);
    let (mut end, mut last) = (&list, i32::MIN);
    while let Some(edge) = get(table, end.get()) {
        #[cfg(test)]
        crate::num::tally::add(crate::num::tally::Work::Step);
        if edge.end() <= y {
            end.set(edge.link.get());
            continue;
        }
        let x = edge.step();
        if x < last {
            overtaken = end.replace(edge.link.replace(overtaken));
            continue;
        }
        last = x;
        end = &edge.link;
    }
    let list = if joining == END { list.get() } else { join(table, list.get(), joining) };
    if overtaken == END {
        return list;
    }
    merge(table, list, sort(table, overtaken))
}
