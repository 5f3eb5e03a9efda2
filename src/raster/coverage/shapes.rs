//! The coverage of other shapes than polygons: paths, strokes, rectangles, round shapes.

use fixed::types::I24F8;

use super::{
    fill::{fill, fill_sides, Loader},
    row::Row,
    slot::{last_row, CoverageSlot},
};
use crate::{
    error::EdgeTableFull,
    geom::{
        bits,
        fill_rule::FillRule,
        flatten::{Contours, Segments},
        PointFx,
    },
    num::cast::{low_u8, unsigned},
    raster::{
        round::smooth,
        rounded::Radii,
        stroke::{path_border, polyline_border, Dashing, Stroke},
    },
    span::{Rect, Sink},
};

/// Tells what a path covers: as [`fill`], with its curves cut finer than for plain fills. See [`flatten`](crate::geom::flatten).
///
/// # Errors
/// As for [`fill`].
#[inline]
pub fn path(
    path: impl IntoIterator<IntoIter = impl Segments>,
    rule: FillRule,
    table: &mut [CoverageSlot],
    cells: &mut [i32],
    window: Rect,
    sink: impl Sink,
) -> Result<(), EdgeTableFull> {
    any_path::<false>(path.into_iter(), rule, (table, cells), window, sink)
}

/// As [`path`], with the true area where sides cross inside of a pixel: see [`fill_true`](super::fill_true).
///
/// # Errors
/// As for [`fill`].
#[inline]
pub fn path_true(
    path: impl IntoIterator<IntoIter = impl Segments>,
    rule: FillRule,
    table: &mut [CoverageSlot],
    cells: &mut [i32],
    window: Rect,
    sink: impl Sink,
) -> Result<(), EdgeTableFull> {
    any_path::<true>(path.into_iter(), rule, (table, cells), window, sink)
}

#[inline(always)]
#[expect(clippy::needless_pass_by_value, reason = "each band takes a copy")]
fn any_path<const TRUE: bool>(
    segments: impl Segments,
    rule: FillRule,
    memory: (&mut [CoverageSlot], &mut [i32]),
    window: Rect,
    sink: impl Sink,
) -> Result<(), EdgeTableFull> {
    let load = |band: Rect, loader: &mut Loader<'_>| loader.contours(Contours::finely_within(segments.clone(), band));
    fill_sides::<TRUE>(&load, rule, memory, window, sink)
}

/// Tells what a stroked path covers. A stroke thinner than a pixel covers as much as it is wide. At the rims of joins, a pixel in
/// which pieces of the stroke overlap may count what they share twice: see [`coverage`](super) for sides that cross in a pixel.
///
/// # Errors
/// As for [`fill`]. Each line of the stroke's [border](crate::raster::stroke::border) that a row meets takes a slot.
#[inline]
pub fn stroke<D: Dashing>(
    path: impl IntoIterator<IntoIter = impl Segments>,
    stroke: &Stroke<D>,
    table: &mut [CoverageSlot],
    cells: &mut [i32],
    window: Rect,
    sink: impl Sink,
) -> Result<(), EdgeTableFull> {
    any_stroke::<D, false>(path.into_iter(), stroke, (table, cells), window, sink)
}

/// As [`stroke`], with the true area where pieces of the stroke overlap in a pixel: see [`fill_true`](super::fill_true).
///
/// # Errors
/// As for [`stroke`].
#[inline]
pub fn stroke_true<D: Dashing>(
    path: impl IntoIterator<IntoIter = impl Segments>,
    stroke: &Stroke<D>,
    table: &mut [CoverageSlot],
    cells: &mut [i32],
    window: Rect,
    sink: impl Sink,
) -> Result<(), EdgeTableFull> {
    any_stroke::<D, true>(path.into_iter(), stroke, (table, cells), window, sink)
}

#[inline(always)]
#[expect(clippy::needless_pass_by_value, reason = "each band takes a copy")]
fn any_stroke<D: Dashing, const TRUE: bool>(
    segments: impl Segments,
    stroke: &Stroke<D>,
    memory: (&mut [CoverageSlot], &mut [i32]),
    window: Rect,
    sink: impl Sink,
) -> Result<(), EdgeTableFull> {
    let stroke = &thin(stroke);
    let load = |band: Rect, loader: &mut Loader<'_>| {
        path_border(segments.clone(), stroke, band, &mut |a, b| loader.side(a, b));
    };
    fill_sides::<TRUE>(&load, FillRule::NonZero, memory, window, sink)
}

/// The same stroke without a least width: what covers little of a pixel shows little.
fn thin<D: Dashing>(stroke: &Stroke<D>) -> Stroke<D> {
    stroke.with_min_width(I24F8::ZERO)
}

/// Tells what stroked lines cover: from each place to the next, and back to the first one if they are `closed`.
///
/// # Errors
/// As for [`stroke`].
#[inline]
pub fn stroke_polyline<D: Dashing>(
    places: &[PointFx],
    closed: bool,
    stroke: &Stroke<D>,
    (table, cells): (&mut [CoverageSlot], &mut [i32]),
    window: Rect,
    sink: impl Sink,
) -> Result<(), EdgeTableFull> {
    let stroke = &thin(stroke);
    let load = |band: Rect, loader: &mut Loader<'_>| {
        polyline_border(places, closed, stroke, band, &mut |a, b| loader.side(a, b));
    };
    fill_sides::<false>(&load, FillRule::NonZero, (table, cells), window, sink)
}

/// Tells what a rectangle of pixels with rounded corners covers. Radii are limited as those of
/// [`rounded::fill`](crate::raster::rounded::fill).
///
/// # Errors
/// As for [`fill`].
pub fn rounded(
    area: Rect,
    radii: Radii,
    table: &mut [CoverageSlot],
    cells: &mut [i32],
    window: Rect,
    sink: impl Sink,
) -> Result<(), EdgeTableFull> {
    path(smooth::rounded(area, radii), FillRule::NonZero, table, cells, window, sink)
}

/// Tells what a triangle covers: as [`fill`], without an error, as three slots are enough.
#[inline]
pub fn triangle(corners: [PointFx; 3], cells: &mut [i32], window: Rect, sink: impl Sink) {
    let mut table = [CoverageSlot::EMPTY; 3];
    fill([corners], FillRule::NonZero, &mut table, cells, window, sink).unwrap_or(());
}

/// Tells what a rectangle between two opposite corners covers: exactly, and without scratch memory.
///
/// Work: three spans a row at most; of one whose left and right sides are borders of pixels, an area and two rows.
/// ```
/// use embedded_raster::{raster::coverage, ClippedSpan, PointFx, Rect, Sink};
/// struct Told(Vec<(i32, Vec<u8>)>);
/// impl Sink for &mut Told {
///     fn span(&mut self, span: ClippedSpan) {
///         self.0.push((span.y(), vec![255; span.len() as usize]));
///     }
///     fn coverage(&mut self, span: ClippedSpan, levels: &[u8]) {
///         self.0.push((span.y(), levels.to_vec()));
///     }
/// }
/// let mut told = Told(vec![]);
/// let corners = [PointFx::from_bits(64, 128), PointFx::from_bits(640, 512)];
/// coverage::rectangle(corners[0], corners[1], Rect::new(0, 0, 9, 9), &mut told);
/// let rows = [(0, vec![96, 128, 64]), (1, vec![191]), (1, vec![255]), (1, vec![128])];
/// assert_eq!(told.0, rows);
/// ```
pub fn rectangle(a: PointFx, b: PointFx, window: Rect, mut sink: impl Sink) {
    let ((ax, ay), (bx, by)) = (bits(a), bits(b));
    let (x, y) = (Range::new(ax, bx), Range::new(ay, by));
    let seen = Rect { x0: x.first, y0: y.first, x1: x.end, y1: y.end }.intersection(window);
    let full = Rect { x0: x.full.0, y0: y.full.0, x1: x.full.1, y1: y.full.1 }.intersection(window);
    let mut row = seen.y0;
    while row < seen.y1 {
        let is_full = full.y0 <= row && row < full.y1;
        if is_full && !full.is_empty() && full.x0 == seen.x0 && full.x1 == seen.x1 {
            sink.area(full);
            row = full.y1;
            continue;
        }
        // The columns on the left and on the right that are covered in part, and those between.
        let height = y.part(row);
        let mut pixels = Row::new(&mut sink, row, seen.x0);
        let mut from = seen.x0;
        while from < seen.x1 {
            let width = x.part(from);
            let end = if width == 256 { full.x1.min(seen.x1) } else { from.wrapping_add(1) };
            let level = low_u8(width.wrapping_mul(height).wrapping_mul(255).wrapping_add(1 << 15) >> 16);
            pixels.run_to(end, level);
            from = end.max(from.wrapping_add(1));
        }
        pixels.tell();
        row = row.wrapping_add(1);
    }
}

/// The pixels along one axis that lie between two places: from the first to the last, and those that do as a whole.
struct Range {
    low: i32,
    high: i32,
    first: i32,
    end: i32,
    full: (i32, i32),
}

impl Range {
    fn new(a: i32, b: i32) -> Self {
        let (low, high) = (a.min(b), a.max(b));
        let end = if low < high { last_row(high).wrapping_add(1) } else { low >> 8 };
        // Upwards for the first, downwards for the last.
        let first = low >> 8;
        let up = first.wrapping_add(i32::from(low & 255 != 0));
        Self { low, high, first, end, full: (up, high >> 8) }
    }

    /// How much of a pixel lies between them, in units, for pixels from the first to the last.
    fn part(&self, pixel: i32) -> u32 {
        let start = if pixel == self.first { unsigned(self.low) & 255 } else { 0 };
        let end = if pixel == self.high >> 8 { unsigned(self.high) & 255 } else { 256 };
        end.wrapping_sub(start)
    }
}
