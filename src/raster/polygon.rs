//! Filled polygons: any number of contours, concave, with holes, crossing themselves.
//!
//! The scan-line algorithm: a table of the sides, sorted by their first row; on each row those that cross it are *active*,
//! sorted by where; between them the fill rule says what is inside. Crossings move by quotient and remainder
//! ([`Edge`]), so they are exact on every row.
//! ```text
//!   table   [ active, by crossing | free | waiting, by first row ]
//!             |  |        |    ^              |
//!   row  .....[==]........[====]......        +--> joins when its first row comes
//! ```
//! The table is the caller's. When the sides that cross a band of rows are more than it holds, the band is halved and the
//! fill goes on; only when a single row alone overflows it the call fails, and it finds that out before it emits a span.
//!
//! Memory: 32 bytes a side. Work: sides times bands, sorting, and per row the active sides and their crossings.
//!
//! Source: W. M. Newman and R. F. Sproull, "Principles of Interactive Computer Graphics", 1979, chapter 16.

use core::borrow::Borrow;

use super::Edge;
use crate::{
    error::Error,
    geom::Vertex,
    rect::Rect,
    span::{ClippedSpan, Span},
};

/// Which regions of a contour that crosses itself, or of several contours, are inside.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub enum FillRule {
    /// Where the contours wind around the place, in either direction.
    #[default]
    NonZero,
    /// Where an odd number of sides lies to the left.
    EvenOdd,
}

impl FillRule {
    #[inline(always)]
    fn is_inside(self, winding: i32) -> bool {
        match self {
            Self::NonZero => winding != 0,
            Self::EvenOdd => winding & 1 != 0,
        }
    }
}

/// Emits the spans of a filled polygon that lie in `window`, top row first and each row from left to right.
///
/// * `contours`: closed outlines, the last vertex joined to the first; any coordinates, any order. It is iterated several
///   times: pass something cheap to clone, such as `[&outline[..]]` or an iterator over the rings of a map.
/// * `table`: scratch memory. Sides that touch no row of the window take no slot, so a low window needs a small table.
///
/// # Errors
/// [`Error::EdgeTableFull`] if a single row is crossed by more sides than `table` holds. Nothing was emitted then.
/// ```
/// use embedded_raster::{raster::{polygon, Edge, FillRule}, Rect, Vertex};
/// let outer = [(0, 0), (6, 0), (6, 4), (0, 4)].map(|(x, y)| Vertex::px(x, y));
/// let hole = [(2, 1), (4, 1), (4, 3), (2, 3)].map(|(x, y)| Vertex::px(x, y));
/// let mut spans = vec![];
/// let mut table = [Edge::EMPTY; 4];
/// polygon::fill([outer, hole], FillRule::EvenOdd, Rect::new(0, 0, 9, 9), &mut table, |s| spans.push((s.x0(), s.x1())))?;
/// assert_eq!(spans, [(0, 6), (0, 2), (4, 6), (0, 2), (4, 6), (0, 6)]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[expect(clippy::needless_pass_by_value, reason = "iterators are passed by value")]
pub fn fill<C>(
    contours: C,
    rule: FillRule,
    window: Rect,
    table: &mut [Edge],
    mut emit: impl FnMut(ClippedSpan),
) -> Result<(), Error>
where
    C: IntoIterator + Clone,
    C::Item: IntoIterator,
    <C::Item as IntoIterator>::Item: Borrow<Vertex>,
{
    if window.is_empty() {
        return Ok(());
    }
    let whole = load(contours.clone(), window.y0, window.y1, table);
    if whole.count <= table.len() {
        scan(table, whole.count, rule, window, &mut emit);
        return Ok(());
    }
    // Too many for one pass. First try all the bands, then paint them.
    for paint in [false, true] {
        let (mut y, mut rows) = (whole.first, whole.end.wrapping_sub(whole.first));
        while y < whole.end {
            let end = y.saturating_add(rows).min(whole.end);
            let band = load(contours.clone(), y, end, table);
            if band.count > table.len() {
                rows = end.wrapping_sub(y) / 2;
                if rows == 0 {
                    return Err(Error::EdgeTableFull { capacity: table.len(), needed: band.count, row: y });
                }
                continue;
            }
            if paint {
                scan(table, band.count, rule, window, &mut emit);
            }
            y = end;
            rows = rows.saturating_mul(2);
        }
    }
    Ok(())
}

/// What [`load`] found: sides that cross the band, and the rows that they cross there.
struct Loaded {
    count: usize,
    first: i32,
    end: i32,
}

/// Fills the table with the sides that cross rows `top..bottom`; goes on counting when it is full.
fn load<C>(contours: C, top: i32, bottom: i32, table: &mut [Edge]) -> Loaded
where
    C: IntoIterator,
    C::Item: IntoIterator,
    <C::Item as IntoIterator>::Item: Borrow<Vertex>,
{
    let mut loaded = Loaded { count: 0, first: bottom, end: top };
    let mut add = |a: Vertex, b: Vertex| {
        let rows = Edge::rows(a, b, top, bottom);
        if rows.0 >= rows.1 {
            return;
        }
        loaded.first = loaded.first.min(rows.0);
        loaded.end = loaded.end.max(rows.1);
        if let Some(slot) = table.get_mut(loaded.count) {
            *slot = Edge::new(a, b, rows);
        }
        loaded.count = loaded.count.wrapping_add(1);
    };
    for contour in contours {
        let mut vertices = contour.into_iter();
        let Some(first) = vertices.next().map(|v| *v.borrow()) else { continue };
        let mut last = first;
        for vertex in vertices {
            let vertex = *vertex.borrow();
            add(last, vertex);
            last = vertex;
        }
        add(last, first);
    }
    loaded
}

/// Paints the band whose sides are the first `count` of the table.
fn scan(table: &mut [Edge], count: usize, rule: FillRule, window: Rect, emit: &mut impl FnMut(ClippedSpan)) {
    let Some(table) = table.get_mut(..count) else { return };
    sort_by_row(table);
    let (mut active, mut waiting) = (0, 0);
    let mut y = 0;
    loop {
        if active == 0 {
            match table.get(waiting) {
                Some(edge) => y = edge.y,
                None => return,
            }
        }
        // The slot after the active ones is free, or is that of the next waiting edge itself.
        while let Some(&edge) = table.get(waiting).filter(|edge| edge.y == y) {
            if let Some(slot) = table.get_mut(active) {
                *slot = edge;
            }
            active = active.wrapping_add(1);
            waiting = waiting.wrapping_add(1);
        }
        let Some(row) = table.get_mut(..active) else { return };
        sort_by_crossing(row);
        spans(row, y, rule, window, emit);
        y = y.wrapping_add(1);
        active = descend(row, y);
    }
}

/// Emits what lies between the active edges of one row.
#[inline(always)]
fn spans(row: &[Edge], y: i32, rule: FillRule, window: Rect, emit: &mut impl FnMut(ClippedSpan)) {
    let (mut winding, mut x0) = (0_i32, 0);
    for edge in row {
        let x = edge.crossing.value;
        let was_inside = rule.is_inside(winding);
        winding = winding.wrapping_add(edge.winding);
        match (was_inside, rule.is_inside(winding)) {
            (false, true) => x0 = x,
            (true, false) => {
                if let Some(span) = (Span { y, x0, x1: x }).clip_columns(window) {
                    emit(span);
                }
            }
            _ => {}
        }
    }
}

/// Moves the active edges to row `y` and drops those that ended; returns how many are left, in front and in order.
#[inline(always)]
fn descend(row: &mut [Edge], y: i32) -> usize {
    let mut kept = 0;
    for i in 0..row.len() {
        let Some(edge) = row.get_mut(i) else { break };
        if edge.end == y {
            continue;
        }
        edge.crossing.step();
        if kept != i {
            let edge = *edge;
            if let Some(slot) = row.get_mut(kept) {
                *slot = edge;
            }
        }
        kept = kept.wrapping_add(1);
    }
    kept
}

/// Insertion sort: from row to row the order changes only where edges cross.
#[inline(always)]
fn sort_by_crossing(row: &mut [Edge]) {
    for i in 1..row.len() {
        let mut at = i;
        while let Some([left, right]) = at.checked_sub(1).and_then(|before| row.get_mut(before..=at)) {
            if left.crossing.value <= right.crossing.value {
                break;
            }
            core::mem::swap(left, right);
            at = at.wrapping_sub(1);
        }
    }
}

/// Heap sort by the first row: in place, and never worse than `n log n`.
fn sort_by_row(table: &mut [Edge]) {
    for root in (0..table.len() / 2).rev() {
        sift_down(table, root);
    }
    for end in (1..table.len()).rev() {
        if let Some([first, .., last]) = table.get_mut(..=end) {
            core::mem::swap(first, last);
        }
        if let Some(heap) = table.get_mut(..end) {
            sift_down(heap, 0);
        }
    }
}

/// Restores the heap order (no child starts lower than its parent) below `root`.
fn sift_down(heap: &mut [Edge], mut root: usize) {
    let row = |heap: &[Edge], i: usize| heap.get(i).map(|edge| edge.y);
    loop {
        let left = root.wrapping_mul(2).wrapping_add(1);
        let right = left.wrapping_add(1);
        let child = if row(heap, right) > row(heap, left) { right } else { left };
        if row(heap, child) <= row(heap, root) {
            return;
        }
        if let Ok([parent, child]) = heap.get_disjoint_mut([root, child]) {
            core::mem::swap(parent, child);
        }
        root = child;
    }
}
