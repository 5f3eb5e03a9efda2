//! Outlines one pixel wide.

use core::num::Wrapping;

use super::{
    form::{mirrored, Follower, Form, Number},
    size_of, Ellipse, Size,
};
use crate::{
    num::cast::{signed, unsigned},
    rect::Rect,
    span::{ClippedSpan, Span},
};

/// Emits the spans of the outline of the ellipse in a box that lie in `window`, top row first: one or two a row.
///
/// Cannot fail. Work: additions, as many as there are visible rows and columns.
/// ```
/// use embedded_raster::{raster::ellipse, Rect};
/// let mut spans = vec![];
/// ellipse::outline(Rect::new(0, 0, 8, 4), Rect::new(0, 0, 64, 48), |s| spans.push((s.y(), s.x0(), s.x1())));
/// assert_eq!(spans, [(0, 2, 6), (1, 0, 2), (1, 6, 8), (2, 0, 2), (2, 6, 8), (3, 2, 6)]);
/// ```
#[inline]
pub fn outline(area: Rect, window: Rect, emit: impl FnMut(ClippedSpan)) {
    draw::<false>(area, window, emit);
}

/// Emits the spans of the outline of the ellipse in a box and of all that it encloses, top row first.
///
/// These are the pixels to fill before an outline is drawn over them in another colour: those of [`fill`](super::fill)
/// are decided by a curve half a pixel larger, and some of them may lie outside of the outline.
#[inline]
pub fn enclosed(area: Rect, window: Rect, emit: impl FnMut(ClippedSpan)) {
    draw::<true>(area, window, emit);
}

#[inline(always)]
fn draw<const FILLED: bool>(area: Rect, window: Rect, mut emit: impl FnMut(ClippedSpan)) {
    let clip = area.intersection(window);
    if clip.is_empty() {
        return;
    }
    let radii = (i64::from(area.width()) - 1, i64::from(area.height()) - 1);
    match size_of(radii, 1) {
        Size::Small => draw_by::<Wrapping<i32>, FILLED>(area, radii, clip, emit),
        size => draw_large::<FILLED>(area, radii, size, clip, &mut emit),
    }
}

#[cold]
#[inline(never)]
fn draw_large<const FILLED: bool>(
    area: Rect,
    radii: (i64, i64),
    size: Size,
    clip: Rect,
    emit: &mut dyn FnMut(ClippedSpan),
) {
    if size == Size::Medium {
        draw_by::<Wrapping<i64>, FILLED>(area, radii, clip, emit);
    } else {
        draw_by::<Wrapping<i128>, FILLED>(area, radii, clip, emit);
    }
}

/// Numbers the columns from the middle outwards: column i of the right half has its mirror image in the left half.
///
/// On a row, the curve passes nearest to the columns from `low` to `high`. With `n(v)` the number of columns whose centres
/// at height v lie inside, those that the curve crosses between `v - 1` and `v + 1`, which is half a pixel each, are
/// `n(v + 1) .. n(v - 1)`: the sweep along columns. The nearest one to the crossing of the row itself is the one after the
/// last whose midpoint to the next lies inside: the sweep along rows. The two never leave a gap.
#[inline(always)]
fn draw_by<T: Number, const FILLED: bool>(
    area: Rect,
    radii: (i64, i64),
    clip: Rect,
    mut emit: impl FnMut(ClippedSpan),
) {
    let form = Form::<T>::new(radii, 1);
    let ellipse = Ellipse::in_box(area);
    let (from, count) = mirrored(&ellipse, clip);
    let (u, v) = (ellipse.u(from), ellipse.v(clip.y0));
    let mut along_columns = Follower::new(&form, (u, v.wrapping_sub(1)), 1, count);
    // From one column further in, if there is one, to one further out, as long as there is one.
    let inner = u32::from(u > 1);
    let outer = u32::from(from.wrapping_add(signed(count)) < area.x1);
    let start = u.wrapping_add(1).wrapping_sub(if inner == 1 { 2 } else { 0 });
    let most = count.wrapping_add(inner).wrapping_add(outer).wrapping_sub(1);
    let mut along_rows = Follower::new(&form, (start, v), 1, most);

    let sum = area.x0.wrapping_add(area.x1);
    let nearest_from = from.wrapping_sub(signed(inner));
    let at = |n: u32| from.wrapping_add(signed(n));
    let mut above = along_columns.row();
    for y in clip.y0..clip.y1 {
        let below = along_columns.row();
        let nearest = nearest_from.wrapping_add(signed(along_rows.row()));
        let low = at(above.min(below)).min(nearest);
        let end = at(above.max(below)).max(nearest.wrapping_add(1));
        above = below;
        if FILLED || unsigned(low.wrapping_sub(area.x0)) <= unsigned(sum.wrapping_sub(low).wrapping_sub(area.x0)) {
            // The halves touch.
            if let Some(span) = (Span { y, x0: sum.wrapping_sub(end), x1: end }).clip_columns(clip) {
                emit(span);
            }
            continue;
        }
        if let Some(span) = (Span { y, x0: sum.wrapping_sub(end), x1: sum.wrapping_sub(low) }).clip_columns(clip) {
            emit(span);
        }
        if let Some(span) = (Span { y, x0: low, x1: end }).clip_columns(clip) {
            emit(span);
        }
    }
}
