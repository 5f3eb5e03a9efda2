//! Small triangles with depths: those of a mesh.
//!
//! In a mesh, most triangles are hidden as a whole, and of the others most rows are seen from end to end. So a triangle is gone through
//! up to three times, each time in a loop that has the registers to itself.
//! ```text
//!     skip_hidden_rows   up to the first row in which a pixel passes, compares depths and nothing else
//!     keep               from there on, compares depths and keeps them; of the span of each row, what passes is left
//!     paint_rows         gives those pixels their colours, as if there were no depths
//! ```

use core::slice::IterMut;

use crate::{
    geom::{small::Small, PointFx, SmallFacet, Varying},
    num::cast::{low_u32, low_u8, unsigned},
    paint::shade::paint_rows,
    raster::triangle::{tiny, TinySpan, TinySpans},
    span::{ClippedSpan, Rect},
    surface::{self, Depth, DepthCell, Frame, Inside, InsideRows, Said, Surface},
    tune::{keep_rolled, COMPACT},
};

/// Whether small triangles have a loop of their own.
pub(super) const SMALL: bool = !COMPACT;

/// What is left of a small triangle.
pub(super) struct Rest<'a, Z: Depth> {
    /// The spans of the rows that are left.
    spans: &'a mut [TinySpan],
    /// The first column of the triangle's box, and the next row.
    x: i32,
    y: i32,
    /// The depths in that column of that row, and what there is in memory.
    depths: <Z::Number as Varying>::Small,
    cells: &'a mut [Z::Word],
    /// Their place in memory, and from there to the row below.
    place: usize,
    pitch: usize,
}

impl<'a, Z: Depth> Rest<'a, Z> {
    /// All of a triangle. `None` if it is not small, or not tiny in the window.
    #[inline(always)]
    pub(super) fn new<M: AsMut<[u8]>>(
        spans: &'a mut TinySpans,
        depth: &'a mut Frame<M, surface::Rows<Z>>,
        window: Rect,
        (corners, facet): ([PointFx; 3], &SmallFacet),
        depths: [Z::Number; 3],
    ) -> Option<Self> {
        if !<<Z::Number as Varying>::Small as Small<_>>::EXISTS {
            return None;
        }
        let (x, first_y) = facet.first();
        let (y, rows) = tiny(corners, window, x, spans)?;
        let mut depths = Z::Number::small(facet, depths)?;
        depths.skip(unsigned(y.wrapping_sub(first_y)));
        let (cells, place, pitch) = depth.words(x, y);
        Some(Self { spans: spans.rows().get_mut(..rows)?, x, y, depths, cells, place, pitch })
    }

    /// The next row.
    #[inline(always)]
    pub(super) const fn y(&self) -> i32 {
        self.y
    }

    /// Goes on to the first row in which a pixel passes. Whether there is none.
    // Not inlined: the loop has the registers to itself.
    #[inline(never)]
    pub(super) fn skip_hidden_rows(&mut self, passes: &impl Fn(&Z::Number, &Z::Number) -> bool) -> bool {
        let Self { ref spans, mut depths, ref cells, mut place, pitch, .. } = *self;
        let mut rows = spans.iter();
        while let Some(&[right, pixels]) = rows.next() {
            let first = place.wrapping_add(right.into());
            let mut z = depths.run(right.into());
            let is_seen = cells.get(first..first.wrapping_add(pixels.into())).is_some_and(|cells| {
                cells.iter().any(|&cell| {
                    let passes = passes(&Z::Number::value(&z), &cell.load());
                    Z::Number::step(&mut z);
                    passes
                })
            });
            if is_seen {
                (self.depths, self.place) = (depths, place);
                let row = spans.len().wrapping_sub(rows.len()).wrapping_sub(1);
                self.y = self.y.wrapping_add_unsigned(low_u32(row as u64));
                let spans = core::mem::take(&mut self.spans);
                self.spans = spans.get_mut(row..).unwrap_or_default();
                return false;
            }
            depths.below();
            place = place.wrapping_add(pitch);
        }
        true
    }

    /// Keeps the depths of all pixels that pass. Of each row, the first run of such pixels is left. `more` is called with all others:
    /// how many rows below the next one they are, and where.
    // Not inlined: the loop has the registers to itself.
    #[inline(never)]
    fn keep(&mut self, passes: &impl Fn(&Z::Number, &Z::Number) -> bool, mut more: impl FnMut(usize, TinySpan)) {
        let Self { ref mut spans, mut depths, ref mut cells, mut place, pitch, .. } = *self;
        for (row, span) in spans.iter_mut().enumerate() {
            let [right, pixels] = *span;
            let (first, mut z) = (place.wrapping_add(right.into()), depths.run(right.into()));
            if let Some(cells) = cells.get_mut(first..first.wrapping_add(pixels.into())) {
                let mut rest = cells.iter_mut();
                let end = right.wrapping_add(pixels);
                *span = keep_run::<Z>(&mut rest, &mut z, passes, end);
                if rest.len() > 0 {
                    keep_runs::<Z>(rest, z, passes, end, |run| more(row, run));
                }
            }
            depths.below();
            place = place.wrapping_add(pitch);
        }
    }

    /// Keeps the depths of all pixels that pass, and paints them.
    #[inline(always)]
    pub(super) fn paint<S: Surface, V: Varying>(
        &mut self,
        on: &mut S,
        values: V::Small,
        passes: &impl Fn(&Z::Number, &Z::Number) -> bool,
        color: &mut impl FnMut(V) -> S::Color,
    ) {
        let (x, y) = (self.x, self.y);
        self.keep(passes, |down, span| {
            let (mut values, down) = (values, low_u32(down as u64));
            values.skip(down);
            let y = y.wrapping_add_unsigned(down);
            paint_rows::<S, V>(on, InsideRows { x, y, spans: &[span] }, values, color);
        });
        paint_rows::<S, V>(on, InsideRows { x, y, spans: self.spans }, values, color);
    }

    /// The same in colours that may be `None`: then neither colour nor depth is painted.
    // Not inlined: the loop has the registers to itself.
    #[inline(never)]
    pub(super) fn paint_some<S: Surface, V: Varying>(
        &mut self,
        on: &mut S,
        mut values: V::Small,
        passes: &impl Fn(&Z::Number, &Z::Number) -> bool,
        color: &mut impl FnMut(V, Z::Number) -> Option<S::Color>,
    ) {
        let Self { ref spans, x, mut y, mut depths, ref mut cells, mut place, pitch } = *self;
        for &[right, pixels] in spans.iter() {
            let first = place.wrapping_add(right.into());
            if let Some(cells) =
                cells.get_mut(first..first.wrapping_add(pixels.into())).filter(|cells| !cells.is_empty())
            {
                let (mut z, mut at, mut cells) = (depths.run(right.into()), values.run(right.into()), cells.iter_mut());
                let x0 = x.wrapping_add(right.into());
                let span = ClippedSpan::inside(y, x0, x0.wrapping_add(pixels.into()));
                on.write_inside(Inside(Said::Span(span)), |_| {
                    let number = Z::Number::value(&z);
                    let painted = cells.next().filter(|cell| passes(&number, &cell.load())).and_then(|cell| {
                        let color = color(V::value(&at), number)?;
                        *cell = Z::Word::store(number);
                        Some(color)
                    });
                    Z::Number::step(&mut z);
                    V::step(&mut at);
                    painted
                });
            }
            depths.below();
            values.below();
            (place, y) = (place.wrapping_add(pitch), y.wrapping_add(1));
        }
    }
}

/// Goes on in a row to the first pixel that passes, and keeps depths up to the next one that does not: where these pixels are, if the
/// row ends at `end`, and how many.
#[inline(always)]
fn keep_run<Z: Depth>(
    rest: &mut IterMut<'_, Z::Word>,
    z: &mut <Z::Number as Varying>::Run,
    passes: &impl Fn(&Z::Number, &Z::Number) -> bool,
    end: u8,
) -> TinySpan {
    let few = |n: usize| low_u8(low_u32(n as u64));
    for cell in rest.by_ref() {
        keep_rolled(true);
        let number = Z::Number::value(z);
        Z::Number::step(z);
        if passes(&number, &cell.load()) {
            *cell = Z::Word::store(number);
            let left = few(rest.len()).wrapping_add(1);
            let right = end.wrapping_sub(left);
            while let Some(cell) = rest.next() {
                keep_rolled(true);
                let number = Z::Number::value(z);
                Z::Number::step(z);
                if !passes(&number, &cell.load()) {
                    return [right, left.wrapping_sub(few(rest.len())).wrapping_sub(1)];
                }
                *cell = Z::Word::store(number);
            }
            return [right, left];
        }
    }
    [0, 0]
}

/// Calls `seen` with all runs that are left in a row. A second one is rare.
#[inline(never)]
fn keep_runs<Z: Depth>(
    mut rest: IterMut<'_, Z::Word>,
    mut z: <Z::Number as Varying>::Run,
    passes: &impl Fn(&Z::Number, &Z::Number) -> bool,
    end: u8,
    mut seen: impl FnMut(TinySpan),
) {
    while rest.len() > 0 {
        let run = keep_run::<Z>(&mut rest, &mut z, passes, end);
        if run[1] > 0 {
            seen(run);
        }
    }
}
