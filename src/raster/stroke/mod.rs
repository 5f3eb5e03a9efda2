//! Lines with a width: strokes of lines, polylines and paths, as the union of small convex pieces.
//!
//! Every side of the path becomes a parallelogram, every vertex a join, every end a cap. All pieces turn the same way round, so
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
//! halved, if it has 32). The direction is `u = 2^30 d / floor(|d|)`, in units of 2^-30, where `|d|` is the length; an offset is
//! `w u / 2^31`. Both are rounded away from zero, each component by itself. A stroke is therefore never thinner than its width
//! and at most `2 sqrt(2)` units (1/90 pixel) thicker, near 45 degrees, and 2^-28 of its width, which is 1/16 unit at most. One
//! that is a pixel wide stays connected at any angle. The *tip* of a miter is `w (p + q) / (2 (1 + p q))` for directions p and q,
//! rounded to nearest; where `2 / (1 + p q)` is more than the square of the limit, the join is a bevel. A *fan* turns by `1 / 2^j`
//! of a circle from its first offset on, where j is the least from 3 to 11 with `12 * 4^j >= w`: then its chords are within 1/8
//! pixel of the circle. Vertices stop at the ends of `i32`.
//!
//! Between the lines that a curve was cut into, joins are always round. Mostly such a join is one triangle without a fan.
//!
//! **Work.** Pieces outside of the window are left out, and curves are followed only near it: a few comparisons for each segment
//! of the path or side of the lines, and work for what is visible. Nothing is stored: when the edge table has no room for the
//! whole stroke, each band of rows is a window of its own, so the comparisons are made for each band, and the pieces of a band
//! are made for it and no other. Dashes need lengths besides: see [`Stroke::dashed`].
//!
//! Range: any `I24F8`; widths from 0 to 65,536 pixels, miter limits to 255.

mod cut;
mod dash;
mod direction;
mod pen;
mod sides;
mod style;
#[cfg(test)]
mod work;

pub use self::{
    cut::Dashing,
    dash::Dash,
    pen::Piece,
    style::{Cap, Join, Stroke},
};
use self::{cut::Ready, pen::Pen, sides::Polyline};
use super::{
    outline,
    polygon::{self, EdgeSlot, EdgeSlots},
};
use crate::{
    error::EdgeTableFull,
    geom::{fill_rule::FillRule, Contours, PathSegment, PointFx, Segments},
    num::cast::signed,
    span::{Rect, Sink},
};

/// Emits the spans of a stroked path that lie in `window`, top row first.
///
/// * `table`: scratch memory. Each piece of the stroke that a row meets takes two slots.
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
    polygon::fill_bands(|band| stroke.of_path(segments.clone(), band), FillRule::NonZero, table, window, sink)
}

/// How many slots [`fill`] needs for a stroked path: see [`polygon::edge_slots`].
#[inline]
pub fn edge_slots<D: Dashing>(
    path: impl IntoIterator<IntoIter = impl Segments>,
    stroke: &Stroke<D>,
    window: Rect,
) -> EdgeSlots {
    let segments = path.into_iter();
    polygon::edge_slots_of_bands(|band| stroke.of_path(segments.clone(), band), window)
}

/// Emits the spans of stroked lines: from each place to the next, and back to the first one if they are `closed`.
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
    polygon::fill_bands(|band| stroke.of_polyline(places, closed, band), FillRule::NonZero, table, window, sink)
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

impl<D: Dashing> Stroke<D> {
    /// The pieces of a stroked path that `window` may show, as closed contours for [`polygon::fill`](super::polygon::fill)
    /// by [`NonZero`](crate::FillRule::NonZero).
    pub fn of_path<P>(self, path: P, window: Rect) -> impl Iterator<Item = Piece> + Clone + use<P, D>
    where
        P: IntoIterator<IntoIter: Segments>,
    {
        let pen = Pen::new(&self, window);
        let contours = Contours::near(path, window, pen.reach);
        let cut = self.dash.ready(pen.width);
        let stroke = move |contour| cut.pieces(contour, pen);
        OneByOne { contours, stroke, parts: None }
    }

    /// The pieces of stroked lines: from each place to the next, and back to the first one if they are `closed`.
    pub fn of_polyline(
        self,
        places: &[PointFx],
        closed: bool,
        window: Rect,
    ) -> impl Iterator<Item = Piece> + Clone + use<'_, D> {
        let pen = Pen::new(&self, window);
        self.dash.ready(pen.width).pieces(Polyline { places: places.iter(), closed }, pen)
    }
}

/// The pieces of one contour after the other: a `flat_map` of half the size, as it is never read from its end.
#[derive(Clone, Debug)]
struct OneByOne<C, F, P> {
    contours: C,
    stroke: F,
    parts: Option<P>,
}

impl<C, F, P> Iterator for OneByOne<C, F, P>
where
    C: Iterator,
    F: FnMut(C::Item) -> P,
    P: Iterator<Item = Piece>,
{
    type Item = Piece;

    fn next(&mut self) -> Option<Piece> {
        loop {
            if let Some(part) = self.parts.as_mut().and_then(Iterator::next) {
                return Some(part);
            }
            self.parts = Some((self.stroke)(self.contours.next()?));
        }
    }
}
