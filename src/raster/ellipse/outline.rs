//! Outlines one pixel wide.

use core::num::Wrapping;

use super::{
    form::{mirrored, Follower, Form, Number},
    is_small_disc, size_of, Ellipse, Size,
};
use crate::{
    num::cast::{narrow, signed, unsigned},
    rect::Rect,
    span::{ClippedSpan, Span},
    target::{keep_rolled, COMPACT},
};

/// Emits the spans of the outline of the ellipse in a box that lie in `window`, top row first: one or two a row.
///
/// Cannot fail. Work: additions, as many as there are visible rows and columns.
/// ```
/// use embedded_raster::{raster::ellipse, Rect};
/// let mut spans = vec![];
/// ellipse::outline(Rect::new(0, 0, 8, 4), Rect::new(0, 0, 64, 48), |s| spans.push((s.y(), s.x0(), s.x1())));
/// assert_eq!(spans, [(0, 1, 7), (1, 0, 1), (1, 7, 8), (2, 0, 1), (2, 7, 8), (3, 1, 7)]);
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
    match circle(area, window) {
        Some(circle) if !FILLED => circle.for_each(emit),
        _ => draw_any::<FILLED>(area, clip, &mut emit),
    }
}

/// The outline of a small circle, if all of it lies in the window.
#[inline(always)]
pub(crate) fn circle(area: Rect, window: Rect) -> Option<Circle> {
    let inside = area.intersection(window) == area && !area.is_empty();
    (!COMPACT && inside && is_small_disc(area)).then(|| Circle::new(area))
}

/// The spans of a whole circle: [`draw_by`] without what clipping takes, and with fewer registers.
pub(crate) struct Circle {
    /// F of the next column at the lower end of the row, and what it gains to the one after that.
    columns: (i32, i32),
    /// The same for the midpoint to the next column, on the row.
    midpoints: (i32, i32),
    /// What `midpoints` gains to the next row.
    down: i32,
    /// The columns so far: at the upper end of the row, and the nearest one on the row.
    above: i32,
    nearest: i32,
    middle: i32,
    /// Both ends of a row together.
    sum: i32,
    x1: i32,
    y: i32,
    y1: i32,
    /// The right half of the row whose left half came last, if it is apart.
    right: (i32, i32),
}

impl Circle {
    #[inline(always)]
    fn new(area: Rect) -> Self {
        let Rect { x0, y0, x1, y1 } = area;
        let a = x1.wrapping_sub(x0).wrapping_sub(1);
        let square = |n: i32| n.wrapping_mul(n);
        let value = |u: i32, v: i32| square(u).wrapping_add(square(v)).wrapping_sub(square(a)).wrapping_sub(1) >> 2;
        // From the middle of the first row, v = -a: u = 0 or 1 for the columns, one more for the midpoint to the next.
        let odd = a & 1;
        let middle = x0.wrapping_add(x1.wrapping_sub(x0) >> 1);
        Self {
            columns: (value(odd, 1_i32.wrapping_sub(a)), odd + 1),
            midpoints: (value(odd + 1, a), odd + 2),
            down: 1_i32.wrapping_sub(a),
            above: middle,
            nearest: middle,
            middle,
            sum: x0.wrapping_add(x1),
            x1,
            y: y0,
            y1,
            right: (0, 0),
        }
    }
}

impl Iterator for Circle {
    type Item = ClippedSpan;

    #[inline(always)]
    fn next(&mut self) -> Option<ClippedSpan> {
        let (low, end) = self.right;
        if low != end {
            self.right = (0, 0);
            return Some(ClippedSpan::inside(self.y.wrapping_sub(1), low, end));
        }
        if self.y >= self.y1 {
            return None;
        }
        let below = follow(&mut self.columns, self.above, self.middle, self.x1);
        self.nearest = follow(&mut self.midpoints, self.nearest, self.middle, self.x1.wrapping_sub(1));
        let low = self.above.min(below).min(self.nearest);
        let end = self.above.max(below).max(self.nearest.wrapping_add(1));
        self.above = below;
        self.midpoints.0 = self.midpoints.0.wrapping_add(self.down);
        self.columns.0 = self.columns.0.wrapping_add(self.down).wrapping_add(1);
        self.down = self.down.wrapping_add(2);
        let y = self.y;
        self.y = y.wrapping_add(1);
        let (start, left_end) = (self.sum.wrapping_sub(end), self.sum.wrapping_sub(low));
        if left_end >= low {
            return Some(ClippedSpan::inside(y, start, end));
        }
        self.right = (low, end);
        Some(ClippedSpan::inside(y, start, left_end))
    }
}

/// Counts columns on or back until `(f, step)` is that of the first one outside: none before `from`, none from `to` on.
#[inline(always)]
fn follow((f, step): &mut (i32, i32), mut at: i32, from: i32, to: i32) -> i32 {
    while *f < 0 && at < to {
        *f = f.wrapping_add(*step);
        *step = step.wrapping_add(2);
        at = at.wrapping_add(1);
        keep_rolled();
    }
    while at > from {
        let before = f.wrapping_sub(*step).wrapping_add(2);
        if before < 0 {
            break;
        }
        *f = before;
        *step = step.wrapping_sub(2);
        at = at.wrapping_sub(1);
        keep_rolled();
    }
    at
}

#[inline(never)]
fn draw_any<const FILLED: bool>(area: Rect, clip: Rect, emit: &mut dyn FnMut(ClippedSpan)) {
    let radii = (i64::from(area.width()) - 1, i64::from(area.height()) - 1);
    match size_of(radii, 1) {
        Size::Small => draw_by::<Wrapping<i32>, FILLED>(area, radii, clip, emit),
        Size::Medium => draw_by::<Wrapping<i64>, FILLED>(area, radii, clip, emit),
        Size::Large => draw_by::<Wrapping<i128>, FILLED>(area, radii, clip, emit),
    }
}

#[inline(always)]
fn draw_by<T: Number, const FILLED: bool>(
    area: Rect,
    radii: (i64, i64),
    clip: Rect,
    mut emit: impl FnMut(ClippedSpan),
) {
    let ellipse = Ellipse::in_box(area);
    let (from, count) = mirrored(&ellipse, clip);
    let outer = from.wrapping_add(signed(count)) < area.x1;
    let mut side = Border::<T>::new(radii, (ellipse.u(from), ellipse.v(clip.y0)), count, outer);
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
pub(in crate::raster) struct Border<T> {
    columns: Follower<T>,
    nearest: Follower<T>,
    /// n at the upper end of the row.
    above: i32,
    inner: i32,
}

impl<T: Number> Border<T> {
    /// From the column at distance u on row v, for `count` columns. `outer`: there is another one beyond the last.
    #[inline(always)]
    pub(in crate::raster) fn new(radii: (i64, i64), (u, v): (i64, i64), count: u32, outer: bool) -> Self {
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
    pub(in crate::raster) fn row(&mut self) -> (i32, i32) {
        let below = signed(self.columns.row());
        let nearest = signed(self.nearest.row()).wrapping_sub(self.inner);
        let (low, high) = (self.above.min(below), self.above.max(below));
        self.above = below;
        (low.min(nearest), high.max(nearest.wrapping_add(1)))
    }
}
