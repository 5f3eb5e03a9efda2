//! Outlines one pixel wide.

use core::num::Wrapping;

use super::{
    curve::{is_inside, is_small_circle, size_of, Ellipse, Size},
    form::{mirrored, Follower, Form, Number, NARROW},
};
use crate::{
    num::cast::{narrow, signed, unsigned},
    span::{ClippedSpan, Octants, Rect, Sink, Span},
};

/// Emits the spans of the outline of the ellipse in a box that lie in `window`, top row first: one or two a row.
///
/// Cannot fail. Work: additions, as many as there are visible rows and columns.
/// ```
/// use embedded_raster::{raster::ellipse, ClippedSpan, Rect};
/// let mut spans = vec![];
/// ellipse::outline(Rect::new(0, 0, 8, 4), Rect::new(0, 0, 64, 48), |s: ClippedSpan| spans.push((s.y(), s.x0(), s.x1())));
/// assert_eq!(spans, [(0, 1, 7), (1, 0, 1), (1, 7, 8), (2, 0, 1), (2, 7, 8), (3, 1, 7)]);
/// ```
#[inline]
pub fn outline(area: Rect, window: Rect, mut sink: impl Sink) {
    // A small circle that is seen as a whole, which is what is drawn most.
    if is_inside(area, window) && is_small_circle(area) && sink.octants(Octants::new(area)) {
        return;
    }
    draw::<false>(area, window, sink);
}

/// Emits the spans of the outline of the ellipse in a box and of all that it encloses, top row first.
///
/// Fill these before an outline is drawn over them in another colour. [`fill`](super::ellipse::fill) has a curve that is half a
/// pixel larger, so some of its pixels may lie outside of the outline.
#[inline]
pub fn enclosed(area: Rect, window: Rect, sink: impl Sink) {
    draw::<true>(area, window, sink);
}

#[inline(always)]
fn draw<const FILLED: bool>(area: Rect, window: Rect, mut sink: impl Sink) {
    let clip = area.intersection(window);
    if !clip.is_empty() {
        draw_any::<FILLED>(area, clip, &mut |span| sink.span(span));
    }
}

/// Numbers of all widths share one copy of the sink's code: that is what the `dyn` is for.
#[inline(never)]
fn draw_any<const FILLED: bool>(area: Rect, clip: Rect, emit: &mut dyn FnMut(ClippedSpan)) {
    let radii = (i64::from(area.width()) - 1, i64::from(area.height()) - 1);
    match size_of(radii, 1) {
        Size::Small if NARROW => draw_by::<Wrapping<i32>, FILLED>(area, radii, clip, emit),
        Size::Large => draw_by::<Wrapping<i128>, FILLED>(area, radii, clip, emit),
        _ => draw_by::<Wrapping<i64>, FILLED>(area, radii, clip, emit),
    }
}

#[inline(always)]
fn draw_by<T: Number, const FILLED: bool>(
    area: Rect,
    radii: (i64, i64),
    clip: Rect,
    emit: &mut dyn FnMut(ClippedSpan),
) {
    let curve = Ellipse::in_box(area).curve();
    let (from, count) = mirrored(&curve, clip);
    let outer = from.wrapping_add(signed(count)) < area.x1;
    let mut side = Border::<T>::new(radii, (curve.u(from), curve.v(clip.y0)), count, outer);
    let sum = area.x0.wrapping_add(area.x1);
    for y in clip.y0..clip.y1 {
        let (low, end) = side.row();
        let (low, end) = (from.wrapping_add(low), from.wrapping_add(end));
        let touch = unsigned(low.wrapping_sub(area.x0)) <= unsigned(area.x1.wrapping_sub(low));
        // The left half, and the right one if they are apart.
        let first_end = if FILLED || touch { end } else { sum.wrapping_sub(low) };
        if let Some(span) = (Span { y, x0: sum.wrapping_sub(end), x1: first_end }).clip_columns(clip) {
            emit(span);
        }
        if first_end != end {
            if let Some(span) = (Span { y, x0: low, x1: end }).clip_columns(clip) {
                emit(span);
            }
        }
    }
}

/// The outline on one side of the middle, its columns counted from a visible one outwards.
///
/// With `n(v)` the number of columns whose centres at height v lie inside, the columns that the curve crosses within half a
/// pixel of a row are `n(v + 1) .. n(v - 1)`: the sweep along columns. The column nearest to the crossing of the row itself is
/// the one after the last whose midpoint to the next lies inside: the sweep along rows. The two never leave a gap.
pub(super) struct Border<T> {
    columns: Follower<T>,
    nearest: Follower<T>,
    /// n at the upper end of the row.
    above: i32,
    inner: i32,
}

impl<T: Number> Border<T> {
    /// From the column at distance u on row v, for `count` columns. `outer`: the ellipse has a column beyond the last of them.
    #[inline(always)]
    pub(super) fn new(radii: (i64, i64), (u, v): (i64, i64), count: u32, outer: bool) -> Self {
        let form = Form::<T>::new(radii, 1);
        let mut columns = Follower::new(&form, (u, v.wrapping_sub(1)), 1, count);
        // From one column further in, if there is one, to one further out.
        let inner = i64::from(u > 1);
        let most = count.wrapping_add(u32::from(u > 1)).wrapping_add(outer.into()).wrapping_sub(1);
        let start = u.wrapping_add(1).wrapping_sub(2 * inner);
        let nearest = Follower::new(&form, (start, v), 1, most);
        let above = signed(columns.row());
        Self { columns, nearest, above, inner: narrow(inner) }
    }

    /// First column and the one after the last of this row; goes to the next.
    #[inline(always)]
    pub(super) fn row(&mut self) -> (i32, i32) {
        let below = signed(self.columns.row());
        let nearest = signed(self.nearest.row()).wrapping_sub(self.inner);
        let (low, high) = (self.above.min(below), self.above.max(below));
        self.above = below;
        (low.min(nearest), high.max(nearest.wrapping_add(1)))
    }
}
