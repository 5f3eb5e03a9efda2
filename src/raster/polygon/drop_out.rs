//! Fills with drop-out control: what is too thin to hold the centre of a pixel is drawn all the same.
//!
//! A fill draws the pixels whose centres are inside. A stem that is thinner than a pixel may pass between two centres, and is
//! missing or broken then; so are letters of a few pixels. Drop-out control looks at the lines between the centres of neighbours:
//! ```text
//!      .   .   .   .        a scan line through the centres of a row: the outline goes in and out between
//!        | |                two centres, neither of which is inside. One of the two pixels is turned on.
//!    --.-|-|-.---.---.--
//!        | |
//!      .   .   .   .        The same is done along columns, for thin horizontal strokes.
//! ```
//! **The rules** are those of TrueType. Rules 1 and 2 are the fill. *Simple* drop-out control is rule 3: "If a scan line between two
//! adjacent pixel centers (either vertical or horizontal) is intersected by both an on-Transition contour and an off-Transition
//! contour, and neither of the pixels was already turned on by rules 1 and 2, turn on the left-most pixel (horizontal scan line)
//! or the bottom-most pixel (vertical scan line)". *Smart* is rule 5: "turn on the pixel whose center is closer to the midpoint
//! between the on-Transition contour and off-Transition contour". The bottom-most pixel is the lower one on the screen. Of two that
//! are as close, it is the left or the upper one. Where the outline goes in and out more than once between two centres, the first
//! way in and the last way out count; they may be the same place. Rules 4 and 6, which leave out *stubs*, are these
//! rules with another condition: "only if the two contours continue to intersect other scan lines in both directions", that is,
//! if the other three sides of each of the two squares between four centres, of which this line is a side, are intersected at
//! least twice, together.
//!
//! A crossing is exact. A centre on a side counts as everywhere: along a row as if it were moved a little to the right and much less
//! down, along a column a little down and much less to the right.
//!
//! **Order.** First the rows come, top first, and then the pixels that are turned on along columns only, column after column. Each
//! pixel comes once.
//!
//! **Work.** Twice that of a fill, by rows and by columns; and a comparison with all sides for each pixel that is turned on along a
//! column, as it may have come along its row. Without stubs there is one more for each such place. The table has to be large enough
//! for the columns too.
//!
//! Range: any `I24F8`; crossings of sides that are higher, or wider for columns, than 65,536 pixels are rounded to `2^-24` pixel.
//!
//! Source: "Instructing TrueType Glyphs", OpenType specification 1.9.1, Microsoft, "Scan converter rules".

use core::{borrow::Borrow, cmp::Ordering};

use super::{
    descend,
    edge::{EdgeSlot, END},
    edge_slots_of_sides, in_bands,
    list::get,
    EdgeSlots, Loaded, Loader, Waiting, PLACES,
};
use crate::{
    error::EdgeTableFull,
    geom::{
        bits,
        exact::{turn_at, Place},
        fill_rule::FillRule,
        polygon::each_side,
        PointFx,
    },
    num::{cast::saturate, round::first_centre_from},
    span::{Rect, Sink, Span},
};

/// Which pixels are turned on where the inside of a shape passes between two centres: see [`drop_out`](self).
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DropOut {
    /// The nearer one, by rules 5 and 6. Otherwise the left or the lower one, by rules 3 and 4.
    pub smart: bool,
    /// Also where the shape ends between the same centres, by rules 3 and 5. Otherwise not, by rules 4 and 6.
    pub stubs: bool,
}

impl DropOut {
    /// Rule 3.
    pub const SIMPLE: Self = Self { smart: false, stubs: true };
    /// Rule 4.
    pub const SIMPLE_WITHOUT_STUBS: Self = Self { smart: false, stubs: false };
    /// Rule 5.
    pub const SMART: Self = Self { smart: true, stubs: true };
    /// Rule 6.
    pub const SMART_WITHOUT_STUBS: Self = Self { smart: true, stubs: false };
}

/// Emits the spans of a filled polygon that lie in `window`, and the pixels that drop-out control turns on.
///
/// The arguments are those of [`polygon::fill`](super::fill).
///
/// # Errors
/// [`EdgeTableFull`] if a single row or column is crossed by more sides than `table` holds. Nothing was emitted then. What it calls
/// a row may be a column.
/// ```
/// use embedded_raster::{raster::polygon::drop_out::{self, DropOut}, ClippedSpan, EdgeSlot, FillRule, PointFx, Rect};
/// // From x = 3.55 to x = 4.15, between the centres of columns 3 and 4; its middle is nearer to that of column 3.
/// let stem = [(909, 0), (1_062, 0), (1_062, 768), (909, 768)].map(|(x, y)| PointFx::from_bits(x, y));
/// let (mut table, mut pixels) = ([EdgeSlot::EMPTY; 4], vec![]);
/// let window = Rect::new(0, 0, 9, 9);
/// drop_out::fill([stem], FillRule::NonZero, DropOut::SMART, &mut table, window, |s: ClippedSpan| pixels.push((s.x0(), s.y())))?;
/// assert_eq!(pixels, [(3, 0), (3, 1), (3, 2)]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[expect(clippy::needless_pass_by_value, reason = "iterators are passed by value")]
pub fn fill<C>(
    contours: C,
    rule: FillRule,
    drop_out: DropOut,
    table: &mut [EdgeSlot],
    window: Rect,
    mut sink: impl Sink,
) -> Result<(), EdgeTableFull>
where
    C: IntoIterator + Clone,
    C::Item: IntoIterator,
    <C::Item as IntoIterator>::Item: Borrow<PointFx>,
{
    if window.is_empty() {
        return Ok(());
    }
    let along_rows = |band: Rect, table: &mut [EdgeSlot]| {
        let mut loader = Loader::<true>::new(band, table);
        loader.contours(contours.clone());
        loader.counted()
    };
    let along_columns = |band: Rect, table: &mut [EdgeSlot]| {
        let mut loader = Loader::<true>::new(band, table);
        loader.contours(flip(contours.clone()));
        loader.counted()
    };
    let columns = Rect { x0: window.y0, y0: window.x0, x1: window.y1, y1: window.x1 };
    let is_on = |gap: Gap| drop_out.stubs || goes_on(contours.clone(), gap);
    in_bands(along_columns, table, wider(columns), &[false], |_, _| {})?;
    in_bands(along_rows, table, wider(window), &[false, true], |table, band| {
        // The last pixel that was turned on: the gap after it may turn it on again.
        let mut last = None;
        scan(table, band, rule, |row, found| {
            let span = match found {
                Found::Span(x0, x1) => Span { y: row, x0, x1 },
                Found::Gap(x, is_nearer) => {
                    let x0 = if drop_out.smart && is_nearer { x } else { x.wrapping_sub(1) };
                    if last == Some((row, x0)) || !is_on(Gap { line: row, place: x, is_column: false }) {
                        return;
                    }
                    last = Some((row, x0));
                    Span { y: row, x0, x1: x0.wrapping_add(1) }
                }
            };
            if let Some(span) = span.clip(window) {
                sink.span(span);
            }
        });
    })?;
    in_bands(along_columns, table, wider(columns), &[false, true], |table, band| {
        let mut last = None;
        scan(table, band, rule, |column, found| {
            let Found::Gap(y, is_nearer) = found else { return };
            let row = if drop_out.smart && !is_nearer { y.wrapping_sub(1) } else { y };
            let pixel = Span { y: row, x0: column, x1: column.wrapping_add(1) };
            let Some(span) = pixel.clip(window).filter(|_| last != Some((column, row))) else { return };
            if is_on(Gap { line: column, place: y, is_column: true }) {
                last = Some((column, row));
                let along_row = AlongRow::new(contours.clone(), (column, row));
                let mut gaps = along_row.gaps(rule, drop_out.smart);
                let mut is_turned_on = || gaps.any(|place| is_on(Gap { line: row, place, is_column: false }));
                if !along_row.is_inside(rule) && !is_turned_on() {
                    sink.span(span);
                }
            }
        });
    })
}

/// What there is along a row at a pixel, and on both sides of it: to be asked about one pixel, where no table of the row is at hand.
struct AlongRow {
    x: i32,
    /// How the contours wind around the centre of the pixel before, of the pixel, and of the one after.
    windings: [i32; 3],
    /// The first and the last crossing between two of these.
    ends: [Option<(EdgeSlot, EdgeSlot)>; 2],
}

impl AlongRow {
    fn new<C>(contours: C, (x, row): (i32, i32)) -> Self
    where
        C: IntoIterator,
        C::Item: IntoIterator,
        <C::Item as IntoIterator>::Item: Borrow<PointFx>,
    {
        let mut gaps = Self { x, windings: [0; 3], ends: [None, None] };
        for contour in contours {
            each_side(contour.into_iter().map(|v| *v.borrow()), |a, b| {
                let [start, end] = [a, b].map(|v| first_centre_from(bits(v).1));
                if start.min(end) <= row && row < start.max(end) {
                    let mut edge = EdgeSlot::EMPTY;
                    edge.put_exact(a, b, (row, row.wrapping_add(1)), start < end);
                    gaps.add(&edge);
                }
            });
        }
        gaps
    }

    fn add(&mut self, edge: &EdgeSlot) {
        let Self { x, windings: [before, at, after], ends: [left, right] } = self;
        let (crossing, winding) = (edge.x(), edge.winding());
        if crossing > x.wrapping_add(1) {
            return;
        }
        *after = after.wrapping_add(winding);
        let ends = if crossing > *x {
            right
        } else {
            *at = at.wrapping_add(winding);
            if crossing < *x {
                *before = before.wrapping_add(winding);
                return;
            }
            left
        };
        match ends {
            None => *ends = Some((edge.clone(), edge.clone())),
            Some((first, _)) if is_before(edge, first) => *first = edge.clone(),
            Some((_, last)) if is_before(last, edge) => *last = edge.clone(),
            Some(_) => {}
        }
    }

    /// Whether the pixel is inside. It may be, where its centre is on a side: then it is not along its column.
    fn is_inside(&self, rule: FillRule) -> bool {
        let [_, at, _] = self.windings;
        at & rule.mask() != 0
    }

    /// The places of the gaps that turn the pixel on, but for stubs.
    fn gaps(&self, rule: FillRule, is_smart: bool) -> impl Iterator<Item = i32> {
        let [before, at, after] = self.windings.map(|winding| winding & rule.mask() != 0);
        let chosen = |ends: &Option<(EdgeSlot, EdgeSlot)>, is_second: bool| {
            ends.as_ref().is_some_and(|(first, last)| (is_smart && is_nearer(first, last)) == is_second)
        };
        let [left, right] = &self.ends;
        let left = (!before && !at && chosen(left, true)).then_some(self.x);
        let right = (!at && !after && chosen(right, false)).then_some(self.x.wrapping_add(1));
        left.into_iter().chain(right)
    }
}

/// How many slots [`fill`] needs for a polygon: see [`polygon::edge_slots`](super::edge_slots).
#[expect(clippy::needless_pass_by_value, reason = "iterators are passed by value")]
pub fn edge_slots<C>(contours: C, window: Rect) -> EdgeSlots
where
    C: IntoIterator + Clone,
    C::Item: IntoIterator,
    <C::Item as IntoIterator>::Item: Borrow<PointFx>,
{
    let columns = Rect { x0: window.y0, y0: window.x0, x1: window.y1, y1: window.x1 };
    let along_rows = super::edge_slots(contours.clone(), wider(window));
    let along_columns = edge_slots_of_sides(&|_, loader| loader.contours(flip(contours.clone())), wider(columns));
    EdgeSlots { whole: along_rows.whole.max(along_columns.whole), least: along_rows.least.max(along_columns.least) }
}

/// Contours with x and y exchanged.
fn flip<C>(contours: C) -> impl Iterator<Item = impl Iterator<Item = PointFx>>
where
    C: IntoIterator,
    C::Item: IntoIterator,
    <C::Item as IntoIterator>::Item: Borrow<PointFx>,
{
    contours.into_iter().map(|contour| contour.into_iter().map(|v| flipped(*v.borrow())))
}

/// A place, with x and y exchanged.
fn flipped(v: PointFx) -> PointFx {
    PointFx { x: v.y, y: v.x }
}

/// With one more column on the right. The gap between it and the one before belongs to a pixel of the window too.
fn wider(window: Rect) -> Rect {
    Rect { x1: window.x1.saturating_add(1).min(PLACES), ..window }
}

/// A part of a scan line, from the centre of the pixel before a place to that of the pixel at that place.
#[derive(Copy, Clone)]
struct Gap {
    /// The row, or the column.
    line: i32,
    /// The pixel on it.
    place: i32,
    is_column: bool,
}

/// What there is on a scan line, in order.
enum Found {
    /// Pixels with their centres inside, from the first to the one behind the last.
    Span(i32, i32),
    /// A way in and a way out between the centres of a pixel and of the one before it, and both centres are outside; and
    /// whether their middle is nearer to the pixel than to the one before.
    Gap(i32, bool),
}

/// Goes through the rows of a band whose sides were loaded.
fn scan(table: &[EdgeSlot], loaded: &Loaded, rule: FillRule, mut emit: impl FnMut(i32, Found)) {
    let Some(table) = table.get(..loaded.count) else { return };
    let mut waiting = Waiting::new(table, loaded);
    let (mut active, mut y) = (END, waiting.row);
    loop {
        let joining = if waiting.row == y { waiting.take(table) } else { END };
        active = descend(table, active, joining, y);
        if active != END {
            scan_row(table, active, rule, |found| emit(y, found));
            y = y.wrapping_add(1);
        } else if waiting.row == i32::MAX {
            return;
        } else {
            y = waiting.row;
        }
    }
}

/// What there is on a row with some active edges: those with the same first pixel right of them lie in one gap, in any order.
fn scan_row(table: &[EdgeSlot], active: u16, rule: FillRule, mut emit: impl FnMut(Found)) {
    let (mut at, mut winding, mut start) = (active, 0_i32, 0);
    while let Some(edge) = get(table, at) {
        let x = edge.x();
        let was_inside = winding & rule.mask() != 0;
        let (mut first, mut last) = (edge, edge);
        while let Some(edge) = get(table, at).filter(|edge| edge.x() == x) {
            first = if is_before(edge, first) { edge } else { first };
            last = if is_before(last, edge) { edge } else { last };
            winding = winding.wrapping_add(edge.winding());
            at = edge.link.get();
        }
        match (was_inside, winding & rule.mask() != 0) {
            (false, true) => start = x,
            (true, false) => emit(Found::Span(start, x)),
            (false, false) => emit(Found::Gap(x, is_nearer(first, last))),
            (true, true) => {}
        }
    }
    if winding & rule.mask() != 0 {
        // Its end is right of the window, and was left out.
        emit(Found::Span(start, i32::MAX));
    }
}

/// How far two crossings are from the first centre of their gap: `(rest + 1) / d` each, as products that can be compared.
fn is_before(a: &EdgeSlot, b: &EdgeSlot) -> bool {
    let ((a, d), (b, e)) = (a.remainder(), b.remainder());
    u64::from(a).wrapping_add(1).wrapping_mul(e.into()) < u64::from(b).wrapping_add(1).wrapping_mul(d.into())
}

/// Whether the middle between two crossings is nearer to the second centre of their gap: their distances from the first one are more
/// than 1 together.
fn is_nearer(a: &EdgeSlot, b: &EdgeSlot) -> bool {
    let ((a, d), (b, e)) = (a.remainder(), b.remainder());
    // What b lacks to the second centre.
    let lack = u64::from(e.wrapping_sub(b)).wrapping_sub(1);
    u64::from(a).wrapping_add(1).wrapping_mul(e.into()) > lack.wrapping_mul(d.into())
}

/// Whether the other sides of both squares at a gap are intersected at least twice.
fn goes_on<C>(contours: C, gap: Gap) -> bool
where
    C: IntoIterator,
    C::Item: IntoIterator,
    <C::Item as IntoIterator>::Item: Borrow<PointFx>,
{
    let Gap { line, place, is_column } = gap;
    // Crossings of the squares before and behind the line.
    let (mut before, mut behind) = (0_u32, 0_u32);
    let mut add = |a: PointFx, b: PointFx| {
        let (a, b) = if is_column { (flipped(a), flipped(b)) } else { (a, b) };
        let along = |line: i32| u32::from(crosses(bits(a), bits(b), line, place));
        let (a, b) = (flipped(a), flipped(b));
        let across = |place: i32, line: i32| u32::from(crosses(bits(a), bits(b), place, line));
        let both = |line: i32| across(place.wrapping_sub(1), line).wrapping_add(across(place, line));
        before = before.saturating_add(along(line.wrapping_sub(1))).saturating_add(both(line));
        behind = behind.saturating_add(along(line.wrapping_add(1))).saturating_add(both(line.wrapping_add(1)));
    };
    for contour in contours {
        each_side(contour.into_iter().map(|v| *v.borrow()), &mut add);
    }
    before >= 2 && behind >= 2
}

/// Whether a side crosses a row behind the centre of the pixel before x, and not behind that of the pixel x.
fn crosses(a: Place, b: Place, row: i32, x: i32) -> bool {
    let centre = |n: i32| saturate((i64::from(n) << 8).wrapping_add(128));
    let y = centre(row);
    if (a.1 <= y) == (b.1 <= y) {
        return false;
    }
    let (upper, lower) = if a.1 < b.1 { (a, b) } else { (b, a) };
    let is_before = |x: i32| turn_at(upper, lower, (centre(x), y)) != Ordering::Greater;
    is_before(x) && !is_before(x.wrapping_sub(1))
}
