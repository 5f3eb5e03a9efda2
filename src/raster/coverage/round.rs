//! The coverage of parts of ellipses: sectors, and sectors of rings.

use super::{oval, shapes::path, slot::CoverageSlot};
use crate::{
    error::EdgeTableFull,
    geom::fill_rule::FillRule,
    raster::{arc::Sector, ellipse::Ellipse, round::smooth},
    span::{Rect, Sink},
};

/// Tells what a sector of an ellipse covers, a slice of a pie. Its directions are those seen from the centre.
///
/// # Errors
/// As for [`fill`](super::fill). Eighteen slots are enough for any sector of a screen.
pub fn sector(
    ellipse: Ellipse,
    sector: Sector,
    table: &mut [CoverageSlot],
    cells: &mut [i32],
    window: Rect,
    sink: impl Sink,
) -> Result<(), EdgeTableFull> {
    if sector.is_everything() {
        oval::ellipse(ellipse, window, sink);
        return Ok(());
    }
    path(smooth::sector(&ellipse, sector), FillRule::NonZero, table, cells, window, sink)
}

/// Tells what a sector of a ring covers, as a gauge has it: from an arc of `outer` to one of `inner`, which have the same centre. If they
/// do not, the ends of each arc are where it has the directions of the sector as seen from its own centre. An inner ellipse that lies beside
/// the outer one takes nothing away from it.
///
/// # Errors
/// As for [`fill`](super::fill).
pub fn ring_sector(
    outer: Ellipse,
    inner: Ellipse,
    sector: Sector,
    (table, cells): (&mut [CoverageSlot], &mut [i32]),
    window: Rect,
    sink: impl Sink,
) -> Result<(), EdgeTableFull> {
    if sector.is_everything() {
        oval::ring(outer, inner, window, sink);
        return Ok(());
    }
    path(smooth::ring_sector(&outer, &inner, sector), FillRule::EvenOdd, table, cells, window, sink)
}
