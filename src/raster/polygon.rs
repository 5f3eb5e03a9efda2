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
//! Memory: 32 bytes a side, at most 65,535 sides at a time. Work: sides times bands, sorting, and per row the active sides and their crossings.
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

pub use crate::geom::polygon::FillRule;

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
    // Places in the table are 16 bits; the last one means "none".
    let slots = table.len().min(usize::from(END));
    let Some(table) = table.get_mut(..slots) else { return Ok(()) };
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
            insert(table, active, edge);
            active = active.wrapping_add(1);
            waiting = waiting.wrapping_add(1);
        }
        let Some(row) = table.get_mut(..active) else { return };
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
        let was_inside = winding & rule.mask() != 0;
        winding = winding.wrapping_add(i32::from(edge.winding));
        if !was_inside {
            x0 = x;
        } else if winding & rule.mask() == 0 {
            if let Some(span) = (Span { y, x0, x1: x }).clip_columns(window) {
                emit(span);
            }
        }
    }
}

/// Moves the active edges to row `y` and drops those that ended; returns how many are left, in front and in order.
#[inline(always)]
fn descend(row: &mut [Edge], y: i32) -> usize {
    let (mut kept, mut last) = (0, i32::MIN);
    for i in 0..row.len() {
        let Some(edge) = row.get_mut(i) else { break };
        if edge.end == y {
            continue;
        }
        edge.crossing.step();
        // In its place already, unless one before it ended or was overtaken.
        if kept == i && edge.crossing.value >= last {
            last = edge.crossing.value;
        } else {
            let edge = *edge;
            insert(row, kept, edge);
            last = last.max(edge.crossing.value);
        }
        kept = kept.wrapping_add(1);
    }
    kept
}

/// Puts an edge among the first `count`, which are sorted by their crossings. The slot after them is free. From row to row
/// the order changes only where edges cross, so there is little to move.
#[inline(always)]
fn insert(table: &mut [Edge], count: usize, edge: Edge) {
    let mut at = count;
    while let Some([left, right]) = at.checked_sub(1).and_then(|before| table.get_mut(before..=at)) {
        if left.crossing.value <= edge.crossing.value {
            break;
        }
        *right = *left;
        at = at.wrapping_sub(1);
    }
    if let Some(slot) = table.get_mut(at) {
        *slot = edge;
    }
}

/// Sorts by the first row, by merging runs: `n log n` at the worst. Outlines come in few runs, as each goes up and down.
///
/// The runs are lists through `Edge::link`; when one list is left, every edge learns its place and the table is put in
/// order. Source: natural merge sort, D. E. Knuth, "The Art of Computer Programming" 3, section 5.2.4.
fn sort_by_row(table: &mut [Edge]) {
    /// Runs of 2^k merged runs each: enough for 2^16.
    const LEVELS: usize = 17;
    let mut levels = [END; LEVELS];
    let mut next = 0;
    while next < table.len() {
        let mut run;
        (run, next) = take_run(table, next);
        for level in &mut levels {
            if *level == END {
                *level = run;
                break;
            }
            run = merge(table, core::mem::replace(level, END), run);
        }
    }
    let list = levels.into_iter().fold(END, |list, level| merge(table, level, list));
    put_in_order(table, list);
}

/// No edge.
const END: u16 = u16::MAX;

/// Links the edges from `first` on that go down, or that go up, into a list; returns it and the edge after it.
fn take_run(table: &mut [Edge], first: usize) -> (u16, usize) {
    let place = |i: usize| u16::try_from(i).unwrap_or(END);
    let row = |table: &[Edge], i: usize| table.get(i).map(|edge| edge.y);
    let link = |table: &mut [Edge], from: usize, to: u16| {
        if let Some(edge) = table.get_mut(from) {
            edge.link = to;
        }
    };
    let mut i = first.wrapping_add(1);
    if row(table, i) >= row(table, first) {
        while i < table.len() && row(table, i) >= row(table, i.wrapping_sub(1)) {
            link(table, i.wrapping_sub(1), place(i));
            i = i.wrapping_add(1);
        }
        link(table, i.wrapping_sub(1), END);
        (place(first), i)
    } else {
        link(table, first, END);
        while i < table.len() && row(table, i) < row(table, i.wrapping_sub(1)) {
            link(table, i, place(i.wrapping_sub(1)));
            i = i.wrapping_add(1);
        }
        (place(i.wrapping_sub(1)), i)
    }
}

/// Merges two lists.
fn merge(table: &mut [Edge], mut a: u16, mut b: u16) -> u16 {
    let get = |table: &[Edge], i: u16| table.get(usize::from(i)).map(|edge| (edge.y, edge.link));
    let (mut head, mut tail) = (END, END);
    loop {
        let (next, rest) = match (get(table, a), get(table, b)) {
            (Some((y, link)), Some((other, _))) if y <= other => (a, (link, b)),
            (_, Some((_, link))) => (b, (a, link)),
            // The rest of a list is linked as it is.
            (_, None) => (a, (END, END)),
        };
        match table.get_mut(usize::from(tail)) {
            Some(edge) => edge.link = next,
            None => head = next,
        }
        if get(table, a).is_none() || get(table, b).is_none() {
            return head;
        }
        tail = next;
        (a, b) = rest;
    }
}

/// Moves every edge to its place in the list.
fn put_in_order(table: &mut [Edge], list: u16) {
    let (mut at, mut place) = (list, 0_u16);
    while let Some(edge) = table.get_mut(usize::from(at)) {
        (at, edge.link) = (edge.link, place);
        place = place.wrapping_add(1);
    }
    for i in 0..table.len() {
        // Each exchange brings one edge home.
        while let Some(home) = table.get(i).map(|edge| usize::from(edge.link)).filter(|&home| home != i) {
            let Ok([here, there]) = table.get_disjoint_mut([i, home]) else { break };
            core::mem::swap(here, there);
        }
    }
}
