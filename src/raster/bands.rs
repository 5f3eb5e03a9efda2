//! Bands: a table that is too small for all sides of a shape takes fewer rows at a time.
//!
//! How many rows fit is known only when their sides were counted. So a band is loaded, and where it has too many sides, a lower
//! one is. Every band is loaded before the first pixel is painted: a row that has too many sides by itself is an error, and an
//! error comes before the first pixel.

use core::num::NonZeroU32;

use crate::{
    error::EdgeTableFull,
    num::cast::{signed, unsigned},
    span::Rect,
};

/// What was found in a band: sides that cross it or lie left of it, and the rows that they cross there.
pub(super) struct Loaded {
    pub(super) count: usize,
    pub(super) first: i32,
    pub(super) end: i32,
}

/// The passes of a fill: the first one finds out whether every band can be loaded, the second one paints.
pub(super) const CHECKED: &[bool] = &[false, true];

/// Loads the sides of a window and paints them, in as many bands as the table asks for. If there are bands, they are gone through for
/// each of `passes`, and painted in those that are `true`.
///
/// * `load`: fills the table with the sides of a band. When the table is full it goes on counting.
/// * `paint`: paints the band whose sides were loaded last.
#[inline(always)]
pub(super) fn in_bands<T>(
    table: &mut [T],
    window: Rect,
    passes: &[bool],
    load: impl Fn(Rect, &mut [T]) -> Loaded,
    mut paint: impl FnMut(&[T], &Loaded),
) -> Result<(), EdgeTableFull> {
    let whole = load(window, table);
    if whole.count <= table.len() {
        if passes.last() == Some(&true) {
            paint(table, &whole);
        }
        return Ok(());
    }
    for &is_painted in passes {
        let (mut y, mut rows) = (whole.first, whole.end.wrapping_sub(whole.first));
        let mut count = whole.count;
        while y < whole.end {
            rows = shared(whole.end.wrapping_sub(y), rows, table.len(), count);
            let end = y.saturating_add(rows).min(whole.end);
            // What is not painted is only counted.
            let slots = if is_painted { table.len() } else { 0 };
            let band = load(Rect { y0: y, y1: end, ..window }, table.get_mut(..slots).unwrap_or_default());
            (rows, count) = (end.wrapping_sub(y), band.count);
            if count > table.len() {
                if rows == 1 {
                    let others = |y0, y1| load(Rect { y0, y1, ..window }, &mut []).count;
                    let enough = most_of_a_row(end, whole.end, count, others);
                    return Err(EdgeTableFull { capacity: table.len(), needed: count, row: y, enough });
                }
                continue;
            }
            if is_painted {
                paint(table, &band);
            }
            y = end;
        }
    }
    Ok(())
}

/// How many rows to take next, when `rows` rows had `count` sides: of the rows that are left as large a part as may fit with 1/8 of
/// the capacity to spare, and parts of one size.
pub(super) fn shared(left: i32, rows: i32, capacity: usize, count: usize) -> i32 {
    let [capacity, count] = [capacity, count].map(|n| u32::try_from(n).unwrap_or(u32::MAX));
    let Some(count) = NonZeroU32::new(count) else { return left };
    // Below 2^15 times 2^16.
    let fit = unsigned(rows.min(0x7fff)).wrapping_mul(capacity.wrapping_sub(capacity >> 3)) / count;
    let left = unsigned(left);
    let parts = left.checked_sub(1).and_then(|n| n.checked_div(fit)).map_or(left, |n| n.wrapping_add(1));
    left.checked_div(parts).map_or(1, signed)
}

/// The most sides that a row has, of those from `y` to `end`, or `most` if none has more. Where many rows together have no more,
/// none of them has.
pub(super) fn most_of_a_row(mut y: i32, end: i32, mut most: usize, count: impl Fn(i32, i32) -> usize) -> usize {
    let mut rows = 1_i32;
    while y < end {
        let next = y.saturating_add(rows).min(end);
        let sides = count(y, next);
        if sides <= most {
            (y, rows) = (next, rows.saturating_mul(2));
        } else if rows == 1 {
            (y, most) = (next, sides);
        } else {
            rows >>= 1;
        }
    }
    most
}
