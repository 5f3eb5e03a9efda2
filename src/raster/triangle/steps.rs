//! Triangles by quotient and remainder: any size, on any chip.

use crate::{
    num::{round::first_centre_from, stepper::Stepper},
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
    let Some(long) = Slope::new(a, c) else { return };
    let mut sides = [long.stepper_at(y0, y1.wrapping_sub(y0)), Stepper::still(0)];
    let mut y = y0;
    while y < y1 {
        let (upper, lower, end) = if y < turn { (a, b, turn) } else { (b, c, y1) };
        let Some(short) = Slope::new(upper, lower) else { return };
        sides[1] = short.stepper_at(y, end.wrapping_sub(y));
        while y < end {
            #[cfg(test)]
            crate::num::tally::add(crate::num::tally::Work::Step);
            let [long, short] = [sides[0].value, sides[1].value];
            let (x0, x1) = (long.min(short), long.max(short));
            if let Some(span) = (Span { y, x0, x1 }).clip_columns(window) {
                sink.span(span);
            }
            for side in &mut sides {
                side.step();
            }
            y = y.wrapping_add(1);
        }
    }
}
