//! How often something is done, for tests that count work. Other builds know nothing of it.

use std::{cell::Cell, thread_local};

/// What is counted, by each thread for itself.
#[derive(Copy, Clone, Debug)]
pub(crate) enum Work {
    /// Square roots: sides that were measured.
    Root,
    /// Points of curves.
    Point,
    /// Lengths of a dash pattern that were gone through, one by one.
    Dash,
    /// Sides of pieces that were offered to an edge table.
    Edge,
    /// Times that all pieces were gone through.
    Band,
    /// Rounds of the loops of all other shapes: rows, columns, pixels, or edges that were looked at; lines and characters of a text.
    Step,
}

thread_local! {
    static DONE: Cell<[usize; 6]> = const { Cell::new([0; 6]) };
}

pub(crate) fn add(work: Work) {
    let mut done = DONE.get();
    done[work as usize] += 1;
    DONE.set(done);
}

/// What was done by a call, in the order of [`Work`].
pub(crate) fn of(call: impl FnOnce()) -> [usize; 6] {
    DONE.set([0; 6]);
    call();
    DONE.get()
}
