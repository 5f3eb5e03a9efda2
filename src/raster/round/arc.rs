//! Arcs, sectors and rings: the part of an ellipse that lies between two directions, or outside of another ellipse.
//!
//! A [`Sector`] goes clockwise from one [`Angle`] to another, or is a whole turn. Each angle stands for the direction vector
//! `d = (cos, sin)` that [`Angle::cos_sin`] gives in whole numbers, and a pixel belongs to the sector when its centre
//! p = (u, v), seen from the centre of the shape, lies after the first direction and before the second:
//! ```text
//!   p is less than half a turn after d:    d.x v - d.y u > 0
//! ```
//! exactly, in 64 bits. For ellipses these are the directions on the screen, not the parameter of the ellipse.
//!
//! **A pixel exactly on a ray** goes to one of the two sectors that meet there. Which one, the pixel decides, whatever the sectors
//! are: it counts as a little farther from the horizontal line through the centre (below it, if it lies on that line), and much less
//! to the right. So sectors that follow each other round draw every pixel of the ellipse once, and a single one is as symmetric as its
//! angles:
//! ```text
//!   135 to 45 degrees, 7 x 7    0 to 180 degrees: the row of the centre is in as a whole, and not in 180 to 360 degrees
//!     ..###..                     .......
//!     .#####.                     .......     The same on the left and on the right is each sector from an angle to half a turn
//!     #######                     .......     less that angle; above and below each from an angle to the opposite of it.
//!     #######                     #######
//!     ##...##                     #######
//!     .......                     .#####.
//!     .......                     ..###..
//! ```
//! The pixel around the centre of the shape counts as a little to its right and, much less, below.
//!
//! - An **arc** has the pixels of the full [outline](super::ellipse::outline) that lie in the sector.
//! - A filled **sector** has the pixels of the filled ellipse that do.
//! - A **ring** has the pixels of an ellipse that are not pixels of another one.
//!
//! Along a row, pixels change sides of a direction at most once. Bisection finds where.
//!
//! Work: that of the [ellipse](super::ellipse), of a ring that of both; and for each of its spans two bisections.
//!
//! Range: any ellipse, any angles.

use fixed::types::{I16F16, I24F8};

use super::{
    curve::{Curve, Ellipse},
    ellipse,
    form::AnyRows,
};
use crate::{
    error::EdgeTableFull,
    geom::{Angle, Curves, PointFx},
    num::cast::{signed, unsigned},
    raster::{
        polygon::EdgeSlot,
        stroke::{self, Dashing, Stroke},
    },
    span::{ClippedSpan, Rect, Sink, Span},
};

/// The directions clockwise from one angle up to another.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Sector {
    start: Angle,
    end: Angle,
    /// Their directions.
    from: (i32, i32),
    to: (i32, i32),
    extent: Extent,
}

/// How much of a turn a sector has.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) enum Extent {
    Nothing,
    /// Half a turn or less.
    Narrow,
    /// More than half a turn.
    Wide,
    Everything,
}

impl Sector {
    /// Clockwise from `start` up to `end`. From an angle to itself there is nothing: an [`Angle`] knows no whole
    /// turns. Where all of a turn can occur, as in a gauge, use [`sweep`](Self::sweep) or [`slice`](Self::slice).
    /// ```
    /// use embedded_raster::{geom::Angle, raster::arc::Sector};
    /// let lower_right = Sector::new(Angle::degrees(0), Angle::degrees(90));
    /// assert!(lower_right.contains(3, 2) && !lower_right.contains(-3, 2) && !lower_right.contains(3, -2));
    /// ```
    pub fn new(start: Angle, end: Angle) -> Self {
        let extent = match start.clockwise_to(end) {
            0 => Extent::Nothing,
            1..=0x8000_0000 => Extent::Narrow,
            _ => Extent::Wide,
        };
        Self { start, end, from: start.cos_sin(), to: end.cos_sin(), extent }
    }

    /// From `start` on, so many degrees clockwise, or the other way if negative. A full turn and more is everything.
    ///
    /// A sweep of -90 degrees from an angle is one of 90 degrees up to that angle.
    /// ```
    /// use embedded_raster::{geom::Angle, raster::arc::Sector};
    /// use fixed::types::I16F16;
    /// let gauge = |percent: i16| Sector::sweep(Angle::degrees(-90), I16F16::from_num(percent) * 36 / 10);
    /// assert!(!gauge(0).contains(0, -3)); // nothing
    /// assert!(gauge(25).contains(2, -3) && !gauge(25).contains(-2, -3));
    /// assert!(gauge(100).contains(-2, -3)); // everything
    ///
    /// let quarter = Sector::new(Angle::degrees(0), Angle::degrees(90));
    /// assert_eq!(Sector::sweep(Angle::degrees(90), I16F16::from_num(-90)), quarter);
    /// ```
    pub fn sweep(start: Angle, degrees: I16F16) -> Self {
        let end = start + Angle::degrees_fx(degrees);
        let sector = if degrees < 0 { Self::new(end, start) } else { Self::new(start, end) };
        if degrees.unsigned_abs() < 360 {
            sector
        } else {
            Self { extent: Extent::Everything, ..sector }
        }
    }

    /// From `start / of` turns on, `length / of` turns clockwise: a slice of a pie of `of` parts. A full turn and more is everything;
    /// if `of` is 0 there is nothing.
    ///
    /// Each cut is rounded for itself ([`Angle::turns`]), so slices that follow each other meet, and those of a whole pie close it:
    /// adding up a rounded angle would not.
    /// ```
    /// use embedded_raster::raster::arc::Sector;
    /// let thirds = [0, 1, 2].map(|i| Sector::slice(i, 1, 3));
    /// for (u, v) in [(1, 0), (5, -1), (-7, 12), (0, 0)] {
    ///     assert_eq!(thirds.iter().filter(|third| third.contains(u, v)).count(), 1);
    /// }
    /// assert!(Sector::slice(0, 3, 3).contains(5, -1));
    /// ```
    pub fn slice(start: u32, length: u32, of: u16) -> Self {
        let parts = u32::from(of.max(1));
        // Whole turns drop out before they are added; then the sum is below 2^17.
        let from = start % parts;
        let sector = Self::new(Angle::turns(from, of), Angle::turns(from.wrapping_add(length % parts), of));
        if length < parts || of == 0 {
            sector
        } else {
            Self { extent: Extent::Everything, ..sector }
        }
    }

    /// The directions of its rays, if it has two.
    pub(super) fn rays(&self) -> Option<[(i32, i32); 2]> {
        matches!(self.extent, Extent::Narrow | Extent::Wide).then_some([self.from, self.to])
    }

    /// Whether it has more than half a turn.
    pub(super) fn is_wide(&self) -> bool {
        matches!(self.extent, Extent::Wide | Extent::Everything)
    }

    /// Whether it is a whole turn.
    pub(crate) fn is_everything(&self) -> bool {
        self.extent == Extent::Everything
    }

    /// Its first direction, the one after its last, and how much lies between.
    #[inline]
    pub(super) const fn ends(&self) -> ((i32, i32), (i32, i32), Extent) {
        (self.from, self.to, self.extent)
    }

    /// Whether a place lies in it, as seen from the centre, for distances below `2^32`.
    pub fn contains(&self, u: i64, v: i64) -> bool {
        let after = || is_after(self.from, u, v);
        let before = || !is_after(self.to, u, v);
        match self.extent {
            Extent::Nothing => false,
            Extent::Narrow => after() && before(),
            Extent::Wide => after() || before(),
            Extent::Everything => true,
        }
    }
}

/// Whether (u, v) lies clockwise from a direction, by less than half a turn.
fn is_after((x, y): (i32, i32), u: i64, v: i64) -> bool {
    // The centre counts as (1, 0) and a little below.
    let u = if u == 0 && v == 0 { 1 } else { u };
    let cross = i64::from(x).wrapping_mul(v).wrapping_sub(i64::from(y).wrapping_mul(u));
    // Of (0, 1), or of (0, -1) above the centre, and of (1, 0) if that is on the line too.
    let tie = if x == 0 { y < 0 } else { (x > 0) == (v >= 0) };
    cross > 0 || cross == 0 && tie
}

/// Emits the pixels of the outline of the ellipse in a box that lie in a sector and in `window`, top row first.
/// ```
/// use embedded_raster::{geom::Angle, raster::arc::{self, Sector}, ClippedSpan, Rect};
/// let quarter = Sector::new(Angle::degrees(180), Angle::degrees(270));
/// let mut spans = vec![];
/// arc::outline(Rect::new(0, 0, 9, 9), quarter, Rect::new(0, 0, 64, 48), |s: ClippedSpan| spans.push((s.y(), s.x0(), s.x1())));
/// assert_eq!(spans, [(0, 3, 4), (1, 1, 3), (2, 1, 2), (3, 0, 1)]); // the row of the centre is below it
/// ```
pub fn outline(area: Rect, sector: Sector, window: Rect, mut sink: impl Sink) {
    let curve = Ellipse::in_box(area).curve();
    ellipse::outline(area, window, |span: ClippedSpan| split(&curve, &sector, span, &mut sink));
}

/// Emits the spans of a sector of a filled ellipse (a slice of a pie) that lie in `window`, top row first.
pub fn fill(ellipse: Ellipse, sector: Sector, window: Rect, mut sink: impl Sink) {
    let curve = ellipse.curve();
    ellipse::fill(ellipse, window, |span: ClippedSpan| split(&curve, &sector, span, &mut sink));
}

/// Emits the spans of the pixels of `outer` that are not pixels of `inner`, top row first.
///
/// If both have the same centre, this is a ring. If `inner` lies inside of `outer`, the ring and `inner` together draw each pixel
/// of `outer` once.
/// ```
/// use embedded_raster::{raster::arc, ClippedSpan, Ellipse, Rect};
/// let (outer, inner) = (Rect::new(0, 0, 7, 7), Rect::new(2, 2, 5, 5));
/// let mut widths = vec![];
/// arc::ring(Ellipse::in_box(outer), Ellipse::in_box(inner), outer, |s: ClippedSpan| widths.push(s.len()));
/// assert_eq!(widths, [3, 5, 2, 2, 2, 2, 2, 2, 5, 3]);
/// ```
pub fn ring(outer: Ellipse, inner: Ellipse, window: Rect, mut sink: impl Sink) {
    let hole = inner.extent().intersection(window);
    let mut rows = if hole.is_empty() { None } else { Some((hole.y0, AnyRows::new(&inner, hole))) };
    ellipse::fill(outer, window, |span: ClippedSpan| {
        let y = span.y();
        let mut ends = None;
        if let Some((next, rows)) = rows.as_mut().filter(|_| hole.y0 <= y && y < hole.y1) {
            while *next <= y {
                ends = Some(rows.row());
                *next = next.wrapping_add(1);
            }
        }
        let (x0, x1) = ends.filter(|(x0, x1)| x0 < x1).unwrap_or((span.x1(), span.x1()));
        let part = |x0: i32, x1: i32| Span { y, x0, x1 }.clip(window);
        if let Some(left) = part(span.x0(), span.x1().min(x0)) {
            sink.span(left);
        }
        if let Some(right) = part(span.x0().max(x1), span.x1()) {
            sink.span(right);
        }
    });
}

/// Emits the spans of a sector of a ring, top row first. The sector's centre is that of `outer`.
pub fn ring_sector(outer: Ellipse, inner: Ellipse, sector: Sector, window: Rect, mut sink: impl Sink) {
    let curve = outer.curve();
    ring(outer, inner, window, |span: ClippedSpan| split(&curve, &sector, span, &mut sink));
}

/// The arc of an ellipse that lies in a sector, by its centre and radii, as segments of a path: a curve of no width, which begins at the
/// first ray. Of a whole turn it is the closed ellipse. This is what [`stroke`](fn@stroke) draws with a width, and
/// [`coverage::stroke`](crate::raster::coverage::stroke) with soft rims.
pub fn path(centre: PointFx, radii: [I24F8; 2], sector: Sector) -> Curves {
    let angles = match sector.extent {
        Extent::Nothing => [sector.start; 2],
        _ => [sector.start, sector.end],
    };
    Curves::between_directions(centre, radii, angles, sector.extent == Extent::Everything)
}

/// Emits the spans of the arc of an ellipse that lies in a sector, with a width, caps and dashes, top row first: the stroke of the
/// curve itself, which is half on either side of it. Dashes begin at the first ray; caps stand at right angles to the curve. Of a
/// whole turn, both ends are joined.
///
/// For a gauge whose width is in whole pixels, [`ring_sector`] and [`gauge::fill`](super::gauge::fill) need no table.
///
/// # Errors
/// As for [`stroke::fill`](crate::raster::stroke::fill).
/// ```
/// use embedded_raster::{px, raster::arc, Angle, Cap, ClippedSpan, EdgeSlot, PointFx, Rect, Sector, Stroke};
/// let half = Sector::new(Angle::degrees(180), Angle::degrees(0));
/// let (mut table, mut rows) = ([EdgeSlot::EMPTY; 32], vec![]);
/// let window = Rect::new(0, 0, 14, 9);
/// let stroke = Stroke::px(2).with_cap(Cap::Square);
/// arc::stroke(PointFx::px(7, 7), [px(6); 2], half, &stroke, &mut table, window, |s: ClippedSpan| rows.push((s.y(), s.x0(), s.x1())))?;
/// assert_eq!(rows[0], (0, 4, 10)); // the top
/// assert_eq!(rows[rows.len() - 2..], [(7, 0, 2), (7, 12, 14)]); // the caps, a row below the centre
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[inline]
pub fn stroke<D: Dashing>(
    centre: PointFx,
    radii: [I24F8; 2],
    sector: Sector,
    stroke: &Stroke<D>,
    table: &mut [EdgeSlot],
    window: Rect,
    sink: impl Sink,
) -> Result<(), EdgeTableFull> {
    stroke::fill(path(centre, radii, sector), stroke, table, window, sink)
}

/// Emits the parts of a span that lie in a sector: two at most.
fn split(curve: &Curve, sector: &Sector, span: ClippedSpan, sink: &mut impl Sink) {
    match sector.extent {
        Extent::Nothing => return,
        Extent::Everything => return sink.span(span),
        Extent::Narrow | Extent::Wide => {}
    }
    let (x0, x1, y) = (span.x0(), span.x1(), span.y());
    let v = curve.v(y);
    let change = |direction: (i32, i32)| {
        let at_start = is_after(direction, curve.u(x0), v);
        // The first pixel that lies on the other side of the direction than pixel x0.
        let (mut low, mut high) = (x0, x1);
        while low < high {
            #[cfg(test)]
            crate::num::tally::add(crate::num::tally::Work::Step);
            let middle = low.wrapping_add(span_half(low, high));
            if is_after(direction, curve.u(middle), v) == at_start {
                low = middle.wrapping_add(1);
            } else {
                high = middle;
            }
        }
        low
    };
    // In most spans nothing changes: then the last pixel is on the side of the first.
    let last = x1.wrapping_sub(1);
    let same = |d| is_after(d, curve.u(x0), v) == is_after(d, curve.u(last), v);
    let place = |d| if same(d) { x1 } else { change(d) };
    let (a, b) = (place(sector.from), place(sector.to));
    let window = Rect { x0, y0: y, x1, y1: y.wrapping_add(1) };
    let mut start = x0;
    for end in [a.min(b), a.max(b), x1] {
        if start < end && sector.contains(curve.u(start), v) {
            if let Some(part) = (Span { y, x0: start, x1: end }).clip_columns(window) {
                sink.span(part);
            }
        }
        start = end;
    }
}

/// Half of the distance between two pixels, rounded down.
fn span_half(low: i32, high: i32) -> i32 {
    signed(unsigned(high.wrapping_sub(low)) >> 1)
}
