//! Lines with a width: strokes of lines, polylines and paths, as the union of small pieces.
//!
//! Every side of the path becomes a band, every vertex a join, every end a cap. All pieces turn the same way round, so
//! filled by [`NonZero`](crate::FillRule::NonZero) they are one shape: what they share is painted once.
//! ```text
//!   a+o __________ b+o    side     o = w/2 to the right of the direction, away from zero to whole units
//!      |          |
//!    a +    -->   + b     cap      Butt: none.  Square: b+o, b+o', b-o', b-o with o' = o + w/2 ahead
//!      |__________|                Round: b, b+o, the fan, b-o
//!   a-o            b-o    join     Bevel: v, v+p, v+q, p and q being the offsets of both sides on the outer side
//!                                  Miter: v, v+p, tip, v+q        Round: v, v+p, the fan, v+q
//! ```
//! **The rule.** Let d be the difference of both ends of a side. Its components are doubled until the larger one has 31 bits (or
//! halved, if it has more). The direction is `u = 2^30 d / floor(|d|)`, in units of 2^-30, where `|d|` is the length; an offset is
//! `w u / 2^31`. Both are rounded away from zero, each component by itself. A stroke is therefore never thinner than its width
//! and at most `2 sqrt(2)` units (1/90 pixel) thicker, near 45 degrees, and 2^-28 of its width, which is 1/16 unit at most. One
//! that is a pixel wide stays connected at any angle. The *tip* of a miter is `w (p + q) / (2 (1 + p q))` for directions p and q,
//! rounded to nearest; where `2 / (1 + p q)` is more than the square of the limit, the join is a bevel. A *fan* turns by `1 / 2^j`
//! of a circle from its first offset on, where j is the least from 3 to 11 with `3 * 4^j >= w`, or 11: then its chords are within 1/25
//! pixel of the circle. Vertices stop at the ends of `i32`.
//!
//! **Curves** are cut into lines as [`flatten`](crate::geom::flatten) tells, finer where the border of a wide stroke needs it. At the
//! ends of each line d is not the line but the way of the curve there, so its band is a little wider on the outer side of the bend
//! than on the inner one, bands that follow each other share their ends, and caps, joins and the ends of dashes stand at right
//! angles to the curve:
//! ```text
//!      ____---____        where the curve bends more sharply than the pen is wide, the inner border of a band goes
//!      \         /        backwards. What it encloses then belongs to the stroke too, as far as w/2 from the curve:
//!       \__---__/         it is wound around once like all others.
//! ```
//! **Where a curve turns within a hair** its lines say nothing of where it goes: at a cusp, at the tip of a hairpin, at an end whose
//! control point is near. So with a line of at most `2 sqrt(w)` units, in x and in y, the slope of the curve is looked at. It is a curve
//! of the second degree, and turns by no more than its three control points do. If those leave the angle between the ways at both ends by
//! so much that half a width that way ends more than 16 units off, if that angle is an eighth of a turn or more, or cuts 32 units off the
//! circle around the line's end, or if a way points back along the line, then the pen turns on the spot where the line starts, goes to
//! where it ends without turning, and turns there. Half of the time of the line is spent at each end, and halved until each part turns
//! evenly, or is 64 of the 2^20 that a curve has. A turn is a round join on both sides. Strokes up to 1.25 pixels wide go along the lines
//! themselves, with such joins between them.
//!
//! A contour without length is a dot: with square caps a square, with round ones the pixels of
//! [`Ellipse::circle`](crate::Ellipse::circle), with butt ones nothing.
//!
//! **Thin strokes.** A width below [`Stroke::min_width`], one pixel, counts as that: the stroke stays connected.
//!
//! An undashed stroke is the same from its end to its start, and a ring from any of its corners on.
//!
//! **Work.** Pieces outside of the window are left out, and curves are followed only near it: a few comparisons for each segment
//! of the path or side of the lines, and work for what is visible. Nothing is stored: when the edge table has no room for the
//! whole stroke, each band of rows is a window of its own, so the comparisons are made for each band, and the pieces of a band
//! are made for it and no other. Dashes need lengths besides: see [`Stroke::dashed`].
//!
//! Range: any `I24F8`; widths from 0 to 65,536 pixels, miter limits to 255.

mod border;
mod cut;
mod dash;
mod direction;
mod pen;
mod pieces;
mod quad;
mod sides;
mod style;
#[cfg(test)]
mod work;

pub use self::{
    cut::Dashing,
    dash::Dash,
    style::{Cap, Join, Stroke},
};
use self::{pen::Pen, sides::Polyline};
use super::{
    outline,
    polygon::{self, EdgeSlot, EdgeSlots, Loader},
};
use crate::{
    error::EdgeTableFull,
    geom::{fill_rule::FillRule, Contours, PathSegment, PointFx, Segments},
    num::cast::signed,
    span::{Rect, Sink},
    tune::COMPACT,
};

/// Whether lines without caps are filled without an edge table; built for size, they are polylines.
const LINES: bool = !COMPACT;

/// Emits the spans of a stroked path that lie in `window`, top row first.
///
/// * `table`: scratch memory. Each line of the stroke's [border] that a row meets takes a slot.
///
/// # Errors
/// [`EdgeTableFull`] if a single row is crossed by more sides than `table` holds. Nothing was emitted then.
#[inline]
pub fn fill<D: Dashing>(
    path: impl IntoIterator<IntoIter = impl Segments>,
    stroke: &Stroke<D>,
    table: &mut [EdgeSlot],
    window: Rect,
    sink: impl Sink,
) -> Result<(), EdgeTableFull> {
    let segments = path.into_iter();
    let load = |band: Rect, loader: &mut Loader<'_>| {
        path_border(segments.clone(), stroke, band, &mut |a, b| loader.side(a, b));
    };
    polygon::fill_sides(&load, FillRule::NonZero, table, window, sink)
}

/// How many slots [`fill`] needs for a stroked path: see [`polygon::edge_slots`].
#[inline]
pub fn edge_slots<D: Dashing>(
    path: impl IntoIterator<IntoIter = impl Segments>,
    stroke: &Stroke<D>,
    window: Rect,
) -> EdgeSlots {
    let segments = path.into_iter();
    let load = |band: Rect, loader: &mut Loader<'_>| {
        path_border(segments.clone(), stroke, band, &mut |a, b| loader.side(a, b));
    };
    polygon::edge_slots_of_sides(&load, window)
}

/// Emits the spans of stroked lines: from each place to the next, and back to the first one if they are `closed`. One solid line
/// with butt caps needs no table, unless this is built for size.
///
/// # Errors
/// As for [`fill`].
#[inline]
pub fn fill_polyline<D: Dashing>(
    places: &[PointFx],
    closed: bool,
    stroke: &Stroke<D>,
    table: &mut [EdgeSlot],
    window: Rect,
    sink: impl Sink,
) -> Result<(), EdgeTableFull> {
    if let (true, false, [a, b]) = (LINES && D::IS_SOLID && stroke.cap == Cap::Butt, closed, places) {
        if [a, b].into_iter().all(|&end| !pieces::is_far_out(end)) {
            quad::fill(Pen::width(stroke), *a, *b, window, sink);
            return Ok(());
        }
    }
    let load = |band: Rect, loader: &mut Loader<'_>| {
        polyline_border(places, closed, stroke, band, &mut |a, b| loader.side(a, b));
    };
    polygon::fill_sides(&load, FillRule::NonZero, table, window, sink)
}

/// The border of a stroked path, line by line, as far as `window` shows what it encloses: from one place to another. The lines come
/// in no order, and lines that would come once in each direction may be left out; but together they are the closed borders of the
/// pieces of the stroke, and what is wound around by them, in whichever number, is the stroke.
/// ```
/// use embedded_raster::{raster::stroke, Path, PathSegment::*, PointFx, Rect, Stroke};
/// let line = [MoveTo(PointFx::px(2, 4)), LineTo(PointFx::px(9, 4))];
/// let mut lines = vec![];
/// stroke::border(Path::new(&line), &Stroke::px(2), Rect::new(0, 0, 20, 20), |a, b| lines.push([a, b]));
/// let corners = [(2, 3), (2, 5), (9, 5), (9, 3)].map(|(x, y)| PointFx::px(x, y));
/// assert_eq!(lines.len(), 4);
/// assert!((0..4).all(|i| lines.contains(&[corners[i], corners[(i + 1) % 4]])));
/// ```
pub fn border<D: Dashing>(
    path: impl IntoIterator<IntoIter = impl Segments>,
    stroke: &Stroke<D>,
    window: Rect,
    mut each: impl FnMut(PointFx, PointFx),
) {
    path_border(path.into_iter(), stroke, window, &mut each);
}

/// The [border] of stroked lines: from each place to the next, and back to the first one if they are `closed`.
pub fn border_of_polyline<D: Dashing>(
    places: &[PointFx],
    closed: bool,
    stroke: &Stroke<D>,
    window: Rect,
    mut each: impl FnMut(PointFx, PointFx),
) {
    polyline_border(places, closed, stroke, window, &mut each);
}

pub(super) fn path_border<D: Dashing>(
    path: impl Segments,
    stroke: &Stroke<D>,
    window: Rect,
    each: &mut dyn FnMut(PointFx, PointFx),
) {
    let pen = Pen::new(stroke, window);
    stroke.dash.border::<_, true>(Contours::wide(path, window, pen.reach, pen.width), &pen, each);
}

pub(super) fn polyline_border<D: Dashing>(
    places: &[PointFx],
    closed: bool,
    stroke: &Stroke<D>,
    window: Rect,
    each: &mut dyn FnMut(PointFx, PointFx),
) {
    let lines = Polyline { places: places.iter(), closed };
    stroke.dash.border::<_, false>([lines].into_iter(), &Pen::new(stroke, window), each);
}

/// A box that encloses the pixels of a stroked path: that of the path, with as much around it as a join or a cap may reach.
pub fn extent<D>(path: impl IntoIterator<Item = PathSegment>, stroke: &Stroke<D>) -> Rect {
    let Rect { x0, y0, x1, y1 } = outline::extent(path);
    if x0 >= x1 {
        return Rect::default();
    }
    // Below 2^16 pixels and the limit of a miter, 2^8 of them.
    let reach = signed(Pen::new(stroke, Rect::default()).reach.div_ceil(256));
    Rect {
        x0: x0.saturating_sub(reach),
        y0: y0.saturating_sub(reach),
        x1: x1.saturating_add(reach),
        y1: y1.saturating_add(reach),
    }
}
