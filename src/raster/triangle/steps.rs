//! Triangles by quotient and remainder: any size, on any chip.

use crate::{
    num::round::first_centre_from,
    raster::slope::Slope,
    span::{Rect, Sink, Span},
};

/// Triangles of any size, in two blocks of rows: above and below the middle corner.
#[inline(always)]
pub(super) fn fill([a, b, c]: [(i32, i32); 3], window: Rect, mut sink: impl Sink) {
    let (y0, y1) = (first_centre_from(a.1).max(window.y0), first_centre_from(c.1).min(window.y1));
    if y0 >= y1 {
        return;
    }
    let turn = first_centre_from(b.1).min(y1);
    let start = |upper, lower, (y, end): (i32, i32)| {
        Slope::new(upper, lower).map(|side| side.stepper_at(y, end.wrapping_sub(y)))
    };
    let Some(mut long) = start(a, c, (y0, y1)) else { return };
    let mut y = y0;
    while y < y1 {
        let (upper, lower, end) = if y < turn { (a, b, turn) } else { (b, c, y1) };
        let Some(mut short) = start(upper, lower, (y, end)) else { return };
        while y < end {
            #[cfg(test)]
            crate::num::tally::add(crate::num::tally::Work::Step);
            let (x0, x1) = (long.value.min(short.value), long.value.max(short.value));
            if let Some(span) = (Span { y, x0, x1 }).clip_columns(window) {
                sink.span(span);
            }
            long.step();
            short.step();
            y = y.wrapping_add(1);
        }
    }
}
