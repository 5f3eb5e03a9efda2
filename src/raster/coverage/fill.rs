//! The fill: sides out of contours into the table, and down the rows.

use core::{borrow::Borrow, cell::Cell};

use super::{
    pair,
    row::Row,
    slot::{last_row, CoverageSlot, END},
    strip::{enough_for, level, level_of, needed, Strip},
    true_area::Pixel,
};
use crate::{
    error::EdgeTableFull,
    geom::{
        bits,
        fill_rule::FillRule,
        polygon::{bounds, each_side},
        PointFx,
    },
    num::cast::{index, index_u16, low_u32, signed, unsigned},
    raster::bands::{in_bands, Loaded, CHECKED},
    span::{Rect, Sink},
    tune::COMPACT,
};

/// Places lie in the rows and columns from `-PLACES` up to this one.
const PLACES: i32 = 1 << 23;

/// Whether rows with two sides are drawn without cells. The same pixels, and 1 to 2 kB.
const PAIRS: bool = !COMPACT;

/// Cells that are always there: for 32 pixels.
const FEWEST: usize = needed(32);

/// How many cells a window of so many columns takes, if its rows are not to be drawn in strips.
/// ```
/// use embedded_raster::raster::coverage;
/// let cells = [0; coverage::cells(320)];
/// assert_eq!(size_of_val(&cells), 1324);
/// ```
pub const fn cells(width: u16) -> usize {
    needed(width as usize)
}

/// Tells what a polygon covers of the pixels of `window`, top row first and each row from left to right.
///
/// * `contours`: closed outlines, the last vertex joined to the first; any coordinates, any order. It is iterated several
///   times, as that of [`polygon::fill`](crate::raster::polygon::fill).
/// * `table`: scratch memory. Sides that touch no row of the window take no slot; nor do sides that lie right of it, and
///   horizontal ones.
/// * `cells`: scratch memory of any length; what it holds does not matter. [`cells`] says how much is enough.
///
/// # Errors
/// [`EdgeTableFull`] if a single row is touched by more sides than `table` holds. Nothing was told then.
/// ```
/// use embedded_raster::{raster::coverage, ClippedSpan, CoverageSlot, FillRule, PointFx, Rect, Sink};
/// struct Told(Vec<(i32, Vec<u8>)>);
/// impl Sink for &mut Told {
///     fn span(&mut self, span: ClippedSpan) {
///         self.0.push((span.x0(), vec![255; span.len() as usize]));
///     }
///     fn coverage(&mut self, span: ClippedSpan, levels: &[u8]) {
///         self.0.push((span.x0(), levels.to_vec()));
///     }
/// }
/// let slope = [(0, 0), (6, 0), (3, 1), (0, 1)].map(|(x, y)| PointFx::px(x, y));
/// let mut told = Told(vec![]);
/// let (mut table, mut cells) = ([CoverageSlot::EMPTY; 4], [0; coverage::cells(8)]);
/// coverage::fill([slope], FillRule::NonZero, &mut table, &mut cells, Rect::new(0, 0, 8, 1), &mut told)?;
/// assert_eq!(told.0, [(0, vec![255; 3]), (3, vec![212, 128, 43])]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[inline]
#[expect(clippy::needless_pass_by_value, reason = "iterators are passed by value")]
pub fn fill<C>(
    contours: C,
    rule: FillRule,
    table: &mut [CoverageSlot],
    cells: &mut [i32],
    window: Rect,
    sink: impl Sink,
) -> Result<(), EdgeTableFull>
where
    C: IntoIterator + Clone,
    C::Item: IntoIterator,
    <C::Item as IntoIterator>::Item: Borrow<PointFx>,
{
    fill_sides::<false>(&|_, loader| loader.contours(contours.clone()), rule, (table, cells), window, sink)
}

/// As [`fill`], with the true area also where sides cross inside of a pixel, or where several of them go through it. It takes longer
/// there: with k sides that meet such a row and are not right of the pixel, they are looked at k times for each of them, and for each
/// end and crossing in the pixel.
///
/// An area is off by less than `2^-14` pixel for each crossing in the pixel, which is 0.016 of a level, besides what [`fill`] is off.
///
/// # Errors
/// As for [`fill`].
/// ```
/// use embedded_raster::{raster::coverage, ClippedSpan, CoverageSlot, FillRule::NonZero, PointFx, Rect, Sink};
/// struct Told(Vec<u8>);
/// impl Sink for &mut Told {
///     fn span(&mut self, span: ClippedSpan) {
///         self.0.resize(self.0.len() + span.len() as usize, 255);
///     }
///     fn coverage(&mut self, _: ClippedSpan, levels: &[u8]) {
///         self.0.extend(levels);
///     }
/// }
/// let bow_tie = [(0, 0), (256, 256), (256, 0), (0, 256)].map(|(x, y)| PointFx::from_bits(x, y));
/// let (window, mut table) = (Rect::new(0, 0, 1, 1), [CoverageSlot::EMPTY; 4]);
/// let (mut sum, mut area) = (Told(vec![]), Told(vec![]));
/// coverage::fill([bow_tie], NonZero, &mut table, &mut [], window, &mut sum)?;
/// coverage::fill_true([bow_tie], NonZero, &mut table, &mut [], window, &mut area)?;
/// assert_eq!((sum.0, area.0), (vec![], vec![128])); // its loops cancel out
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[inline]
#[expect(clippy::needless_pass_by_value, reason = "iterators are passed by value")]
pub fn fill_true<C>(
    contours: C,
    rule: FillRule,
    table: &mut [CoverageSlot],
    cells: &mut [i32],
    window: Rect,
    sink: impl Sink,
) -> Result<(), EdgeTableFull>
where
    C: IntoIterator + Clone,
    C::Item: IntoIterator,
    <C::Item as IntoIterator>::Item: Borrow<PointFx>,
{
    fill_sides::<true>(&|_, loader| loader.contours(contours.clone()), rule, (table, cells), window, sink)
}

/// A box that encloses the pixels that a polygon touches.
/// ```
/// use embedded_raster::{raster::coverage, PointFx, Rect};
/// let kite = [(800, 0), (1536, 512), (800, 2305), (1, 512)].map(|(x, y)| PointFx::from_bits(x, y));
/// assert_eq!(coverage::extent([kite]), Rect::new(0, 0, 6, 10));
/// ```
pub fn extent<C>(contours: C) -> Rect
where
    C: IntoIterator,
    C::Item: IntoIterator,
    <C::Item as IntoIterator>::Item: Borrow<PointFx>,
{
    let Some((low, high)) = bounds(contours.into_iter().flatten()) else { return Rect::default() };
    if low.0 >= high.0 || low.1 >= high.1 {
        return Rect::default();
    }
    let end = |last: i32| last_row(last).wrapping_add(1);
    Rect { x0: low.0 >> 8, y0: low.1 >> 8, x1: end(high.0), y1: end(high.1) }
}

/// As [`fill`], for sides that come in any order: as often as a row is crossed downwards, it is crossed upwards too. They are asked
/// for by the part of the window that they are to be filled in: they may lack whatever does not touch its rows. If `TRUE`, as
/// [`fill_true`].
pub(crate) fn fill_sides<const TRUE: bool>(
    sides: &dyn Fn(Rect, &mut Loader<'_>),
    rule: FillRule,
    (table, cells): (&mut [CoverageSlot], &mut [i32]),
    window: Rect,
    mut sink: impl Sink,
) -> Result<(), EdgeTableFull> {
    let window = window.intersection(Rect { x0: -PLACES, y0: -PLACES, x1: PLACES, y1: PLACES });
    if window.is_empty() {
        return Ok(());
    }
    let mut fewest = [0; FEWEST];
    let is_short = enough_for(cells.len()) < index(signed(window.width())).min(32);
    let cells = if is_short { &mut fewest } else { cells };
    // Places in the table are 16 bits; the last one means "none".
    let slots = table.len().min(usize::from(END));
    let Some(table) = table.get_mut(..slots) else { return Ok(()) };
    let is_cut = Cell::new(false);
    in_bands(
        table,
        window,
        CHECKED,
        |band, table| {
            let mut loader = Loader::new(band, table);
            sides(band, &mut loader);
            is_cut.set(is_cut.get() | loader.is_cut);
            loader.loaded
        },
        |table, loaded| scan::<TRUE>(table, loaded, rule, (window, is_cut.get()), cells, &mut sink),
    )
}

/// Fills the table with the sides that touch the rows of a band, but for those right of it; goes on counting when it is full.
pub(crate) struct Loader<'a> {
    table: &'a mut [CoverageSlot],
    band: Rect,
    loaded: Loaded,
    /// There were some on the right: the shape is cut off there.
    is_cut: bool,
}

impl<'a> Loader<'a> {
    fn new(band: Rect, table: &'a mut [CoverageSlot]) -> Self {
        #[cfg(test)]
        crate::num::tally::add(crate::num::tally::Work::Band);
        Self { table, band, loaded: Loaded { count: 0, first: band.y1, end: band.y0 }, is_cut: false }
    }

    /// The side from a to b.
    #[inline(never)]
    pub(crate) fn side(&mut self, a: PointFx, b: PointFx) {
        self.add(bits(a), bits(b));
    }

    /// Closed contours.
    pub(crate) fn contours<C>(&mut self, contours: C)
    where
        C: IntoIterator,
        C::Item: IntoIterator,
        <C::Item as IntoIterator>::Item: Borrow<PointFx>,
    {
        for contour in contours {
            each_side(contour.into_iter().map(|v| bits(*v.borrow())), |a, b| self.add(a, b));
        }
    }

    #[inline(always)]
    fn add(&mut self, a: (i32, i32), b: (i32, i32)) {
        #[cfg(test)]
        crate::num::tally::add(crate::num::tally::Work::Edge);
        let (band, loaded) = (self.band, &mut self.loaded);
        let (top, bottom) = (a.1.min(b.1), a.1.max(b.1));
        let (y, last) = ((top >> 8).max(band.y0), last_row(bottom).min(band.y1.wrapping_sub(1)));
        if top == bottom || y > last {
            return;
        }
        if a.0.min(b.0) >> 8 >= band.x1 {
            self.is_cut = true;
            return;
        }
        loaded.first = loaded.first.min(y);
        loaded.end = loaded.end.max(last.wrapping_add(1));
        if let Some(slot) = self.table.get_mut(loaded.count) {
            slot.put(a, b, y, band);
        }
        loaded.count = loaded.count.wrapping_add(1);
    }
}

/// Sorts the sides by their first row into buckets of `2^shift` rows, fewer buckets than sides, and returns the shift.
///
/// A bucket joins the active sides as a whole, when its first row comes. So some sides are looked at before their time; on at most
/// `2^shift` rows each, which are twice the rows of the band for all sides together.
fn sort_in(table: &[CoverageSlot], loaded: &Loaded) -> u32 {
    let rows = unsigned(loaded.end.wrapping_sub(loaded.first));
    let mut shift = 0;
    while shift < 31 && index(signed(rows.wrapping_shr(shift))) >= table.len() {
        shift = shift.wrapping_add(1);
    }
    let mut place = 0;
    for side in table {
        let first = side.first_row().max(loaded.first).wrapping_sub(loaded.first);
        if let Some(slot) = table.get(index(first).wrapping_shr(shift)) {
            side.link.set(slot.bucket.replace(place));
        }
        place = index_u16(usize::from(place).wrapping_add(1));
    }
    shift
}

/// The side at a place; `None` at the end of a list.
#[inline(always)]
fn get(table: &[CoverageSlot], place: u16) -> Option<&CoverageSlot> {
    table.get(usize::from(place))
}

/// Draws the rows of the band whose sides were loaded.
fn scan<const TRUE: bool>(
    table: &[CoverageSlot],
    loaded: &Loaded,
    rule: FillRule,
    (window, is_cut): (Rect, bool),
    cells: &mut [i32],
    sink: &mut impl Sink,
) {
    let Some(table) = table.get(..loaded.count) else { return };
    let shift = sort_in(table, loaded);
    let active = Cell::new(END);
    // Left of all sides, and right of them, there is nothing.
    let (mut first, mut end) = (i32::MAX, if is_cut { i32::MAX } else { 0 });
    for side in table {
        let (from, to) = side.columns(window);
        (first, end) = (first.min(from), end.max(to));
    }
    let (first, width) = (unsigned(first.max(0)), unsigned(end).min(window.width()));
    // Made when the first row comes that takes cells.
    let (mut strip, mut cells) = (None, Some(cells));
    let (mut y, mut joins) = (loaded.first, loaded.first);
    while y < loaded.end {
        let passed = unsigned(y.wrapping_sub(loaded.first));
        if y == joins {
            join(table, &active, index(signed(passed.wrapping_shr(shift))));
            joins = y.saturating_add(signed(1_u32.wrapping_shl(shift))).min(loaded.end);
        }
        if PAIRS && !TRUE {
            if let Some((sides, end)) = two_sides(table, &active, y) {
                let next = pair::rows(sides, (y, end.min(joins)), window, sink);
                if next > y {
                    y = next;
                    continue;
                }
            }
        }
        let mut from = first;
        let pixels = index(signed(width.saturating_sub(first)));
        let strip = strip.get_or_insert_with(|| Strip::new(cells.take().unwrap_or_default(), pixels));
        while from < width && active.get() != END {
            from = strip.move_to(window.x0, from, width);
            cover(table, &active, y, strip, from >= width && !TRUE);
            let (mut row, start) = (Row::new(sink, y, strip.column), unsigned(strip.column.wrapping_sub(window.x0)));
            if TRUE {
                let area = |cell: usize| {
                    let column = start.wrapping_add(low_u32(cell as u64));
                    Pixel::new(table, active.get(), (window.x0, y), column).area(rule)
                };
                strip.sum_up(|sum, cell| area(cell).map_or_else(|| level(sum, rule), level_of), &mut row);
            } else {
                strip.sum_up(|sum, _| level(sum, rule), &mut row);
            }
            row.tell();
        }
        if TRUE {
            step_down(table, &active, y);
        }
        y = y.wrapping_add(1);
    }
}

/// The sides that go through row y, if they are two, in opposite directions, and go on below it; and the row up to which there are no
/// others.
#[inline(never)]
fn two_sides<'t>(table: &'t [CoverageSlot], active: &Cell<u16>, y: i32) -> Option<([&'t CoverageSlot; 2], i32)> {
    let (mut sides, mut end) = ([None; 2], i32::MAX);
    let mut place = active.get();
    while let Some(side) = get(table, place) {
        place = side.link.get();
        if side.first_row() > y {
            end = end.min(side.first_row());
            continue;
        }
        if sides[0].is_some() || !side.passes(y) {
            return None;
        }
        end = end.min(side.last_row());
        sides = [sides[1], Some(side)];
    }
    let [Some(a), Some(b)] = sides else { return None };
    a.is_opposite(b).then_some(([a, b], end))
}

/// Lets the sides of a bucket join the active ones.
fn join(table: &[CoverageSlot], active: &Cell<u16>, bucket: usize) {
    let first = table.get(bucket).map_or(END, |slot| slot.bucket.get());
    let Some(mut last) = get(table, first) else { return };
    while let Some(side) = get(table, last.link.get()) {
        #[cfg(test)]
        crate::num::tally::add(crate::num::tally::Work::Step);
        last = side;
    }
    last.link.set(active.replace(first));
}

/// Lets all active sides step down from row y. Those that end there are dropped.
fn step_down(table: &[CoverageSlot], active: &Cell<u16>, y: i32) {
    let mut end = active;
    while let Some(side) = get(table, end.get()) {
        if side.first_row() <= y {
            if side.last_row() == y {
                end.set(side.link.get());
                continue;
            }
            side.step(y);
        }
        end = &side.link;
    }
}

/// Adds what all active sides cover in a strip of row y. With the last strip, sides that end here are dropped.
#[inline(never)]
fn cover(table: &[CoverageSlot], active: &Cell<u16>, y: i32, strip: &mut Strip<'_>, is_last_strip: bool) {
    let mut end = active;
    while let Some(side) = get(table, end.get()) {
        #[cfg(test)]
        crate::num::tally::add(crate::num::tally::Work::Step);
        if side.first_row() <= y {
            side.cover(y, strip, is_last_strip);
            if is_last_strip && side.last_row() == y {
                end.set(side.link.get());
                continue;
            }
        }
        end = &side.link;
    }
}
