//! Lists of edges: places in a table, joined by [`EdgeSlot::link`]. Edges are linked anew, never moved.
//!
//! The order is by row, then by crossing. Sorting is a merge of natural runs: `n log n` at the worst, and one look at each
//! edge where there is nothing to do. Putting an edge into a list is changing a link: the one to the first edge, or that of the
//! edge before.
//!
//! Source: D. E. Knuth, "The Art of Computer Programming" 3, section 5.2.4, algorithm L and exercise 12.

use core::{cell::Cell, mem::replace};

use super::edge::{EdgeSlot, END};
use crate::tune::COMPACT;

/// Sorting merges runs in pairs, what comes out in pairs again, and so on. These levels are enough for 2^16 runs.
const LEVELS: usize = 17;

/// The edge at a place; `None` at the end of a list.
#[inline(always)]
pub(super) fn get(table: &[EdgeSlot], place: u16) -> Option<&EdgeSlot> {
    table.get(usize::from(place))
}

/// Merges two sorted lists: the edges of the second one are linked into the first.
#[inline(never)]
pub(super) fn merge(table: &[EdgeSlot], a: u16, b: u16) -> u16 {
    merge_by(EdgeSlot::order, table, a, b)
}

/// The same for edges that are on their way, which are all of one row. Most edges are looked at here.
#[cfg_attr(not(embedded_raster_compact), inline(never))]
#[cfg_attr(embedded_raster_compact, inline)]
pub(super) fn join(table: &[EdgeSlot], a: u16, b: u16) -> u16 {
    if COMPACT {
        return merge(table, a, b);
    }
    merge_by(EdgeSlot::x, table, a, b)
}

#[inline(always)]
fn merge_by<K: PartialOrd>(order: impl Fn(&EdgeSlot) -> K, table: &[EdgeSlot], a: u16, mut b: u16) -> u16 {
    let first = Cell::new(a);
    let mut end = &first;
    while let Some(edge) = get(table, b) {
        #[cfg(test)]
        crate::num::tally::add(crate::num::tally::Work::Step);
        let key = order(edge);
        while let Some(left) = get(table, end.get()).filter(|left| order(left) <= key) {
            #[cfg(test)]
            crate::num::tally::add(crate::num::tally::Work::Step);
            end = &left.link;
        }
        b = edge.link.replace(end.replace(b));
        end = &edge.link;
    }
    first.get()
}

/// Sorts a list.
#[inline(never)]
pub(super) fn sort(table: &[EdgeSlot], list: u16) -> u16 {
    let (mut run, mut rest) = take_run(table, list);
    if rest == END {
        return run;
    }
    let mut levels = [END; LEVELS];
    while run != END {
        for level in &mut levels {
            if *level == END {
                *level = run;
                break;
            }
            run = merge(table, replace(level, END), run);
        }
        (run, rest) = take_run(table, rest);
    }
    // `merge` takes empty lists too, but most levels are empty. By reference: by value, they would be on the stack twice.
    levels.iter().filter(|&&level| level != END).fold(END, |list, &level| merge(table, level, list))
}

/// Cuts a run off the front of a list: as many edges as each belong behind all the edges before them, or in front of all. Returns
/// the run, sorted, and the rest.
#[cfg_attr(not(embedded_raster_compact), inline(always))]
#[cfg_attr(embedded_raster_compact, inline(never))]
fn take_run(table: &[EdgeSlot], list: u16) -> (u16, u16) {
    let Some(mut last) = get(table, list) else { return (END, END) };
    let (mut first, mut low) = (list, last);
    let mut rest = last.link.get();
    while let Some(edge) = get(table, rest) {
        #[cfg(test)]
        crate::num::tally::add(crate::num::tally::Work::Step);
        let next = edge.link.get();
        if edge.order() >= last.order() {
            last.link.set(rest);
            last = edge;
        } else if edge.order() < low.order() {
            edge.link.set(first);
            (first, low) = (rest, edge);
        } else {
            break;
        }
        rest = next;
    }
    last.link.set(END);
    (first, rest)
}
