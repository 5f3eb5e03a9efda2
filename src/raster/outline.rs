//! Outlines of paths, one pixel wide.
//!
//! Curves become lines as [`flatten`](crate::geom::flatten) tells. A line is followed along its longer axis. Lines that come one
//! after the other and go the same way along the same axis are a *run*:
//! ```text
//!     +-----+-----+-----+-----+-----+    a run along x, of two lines. Where they pass the centre of a column (.), the pixel
//!     |  .  |  .  |  .  |  .__|-b.  |    of that column is drawn in the row where they are. If the run starts behind the
//!     +-----+-----+---__+--'--+-----+    centre of its column, or ends before or on one, the pixel of that end is drawn too.
//!     |  a--+-----+--'  |  .  |  .  |
//!     +-----+-----+-----+-----+-----+    here: two pixels below, then two above, then that of b
//! ```
//! So each pixel of an outline touches the next one, from run to run too. Where runs meet, a pixel may be the corner of an L: the
//! pixels before and after it touch without it. Then it is left out, unless the pixel before it was such a corner too. Every
//! pixel has its centre within 0.75 pixels of the true curve: half a pixel from a line and 0.136 of tolerance; or, at the end of
//! a run, half the diagonal of a pixel from that end, which is on the curve.
//!
//! **Work.** A few comparisons for each line, and additions, as many as it has pixels in the window, and 24 more at most. Of a line
//! are followed: its part in the window with 4 pixels before and 4 after, and as many at its ends, where they are not further
//! outside. What is left out cannot change a pixel inside, as the rule looks two pixels back and one ahead. Curves add the lines
//! that they become, which [`flatten`](crate::geom::flatten) bounds.
//!
//! Range: any `I24F8`.

use core::num::NonZeroU32;

use crate::{
    geom::{bits, Contours, PathSegment, PointFx, Segments, View},
    num::{
        cast::{signed, unsigned},
        round::{div_rem_wide, first_centre_after, first_centre_from},
        stepper::Stepper,
    },
    span::{Rect, Sink, Span},
};

/// Pixels before and after those in a window that decide what is drawn inside, and one more.
const MARGIN: i32 = 4;

/// Emits the pixels of a path's outline that lie in `window`, as spans in the order of the path. A pixel that the path comes
/// back to is emitted again.
///
/// Cannot fail, for any coordinates and any window.
/// ```
/// use embedded_graphics_core::geometry::Point;
/// use embedded_raster::{raster::outline, ClippedSpan, Path, PathSegment::*, PointFx, Rect};
/// let at = |x, y| PointFx::centre_of(Point::new(x, y));
/// let arch = [MoveTo(at(0, 5)), QuadraticTo(at(5, -5), at(10, 5))];
/// let mut rows = [[b'.'; 11]; 6];
/// outline::draw(Path::new(&arch), Rect::new(0, 0, 11, 6), |s: ClippedSpan| {
///     (s.x0()..s.x1()).for_each(|x| rows[s.y() as usize][x as usize] = b'#');
/// });
/// assert_eq!(rows.map(|r| String::from_utf8(r.to_vec()).unwrap()), [
///     "....###....",
///     "...#...#...",
///     "..#.....#..",
///     ".#.......#.",
///     ".#.......#.",
///     "#.........#",
/// ]);
/// ```
pub fn draw(path: impl IntoIterator<IntoIter = impl Segments>, window: Rect, sink: impl Sink) {
    if window.is_empty() {
        return;
    }
    let reach = unsigned(MARGIN) << 8;
    let view = View::of(window, reach);
    let run = Span { y: 0, x0: 0, x1: 0 };
    let mut trace = Trace { window, sink, way: None, end: None, before: None, last: None, bent: false, run };
    for mut contour in Contours::near(path, window, reach) {
        let closed = contour.is_closed();
        let Some(start) = contour.next() else { continue };
        trace.start(start);
        let mut from = start;
        for to in contour.chain(closed.then_some(start)) {
            if !view.hides(from, to, 0) {
                trace.line(from, to);
            }
            from = to;
        }
        trace.finish();
    }
}

/// A box that encloses a path: the pixels that its ends and control points lie in, and all between them. It holds the outline
/// and the filled path; what a stroke of it may cover [`stroke::extent`](super::stroke::extent) tells.
pub fn extent(path: impl IntoIterator<Item = PathSegment>) -> Rect {
    let (mut low, mut high) = ((i32::MAX, i32::MAX), (i32::MIN, i32::MIN));
    let mut hold = |place: PointFx| {
        let (x, y) = bits(place);
        low = (low.0.min(x >> 8), low.1.min(y >> 8));
        high = (high.0.max(x >> 8), high.1.max(y >> 8));
    };
    let mut is_first = true;
    for segment in path {
        // A path that does not begin with a move begins at (0, 0).
        if is_first && !matches!(segment, PathSegment::MoveTo(_)) {
            hold(PointFx::from_bits(0, 0));
        }
        is_first = false;
        match segment {
            PathSegment::MoveTo(a) | PathSegment::LineTo(a) => hold(a),
            PathSegment::QuadraticTo(c, a) => [c, a].into_iter().for_each(&mut hold),
            PathSegment::CubicTo(c, d, a) => [c, d, a].into_iter().for_each(&mut hold),
            PathSegment::Close => {}
        }
    }
    if low.0 > high.0 {
        return Rect::default();
    }
    Rect { x0: low.0, y0: low.1, x1: high.0.wrapping_add(1), y1: high.1.wrapping_add(1) }
}

/// Quotient and remainder of `s n / d`, or of its negative, rounded down, for `s n / d < 2^32`.
fn ratio(s: u32, n: u32, d: NonZeroU32, negative: bool) -> (i32, u32) {
    let (q, r) = div_rem_wide(u64::from(s).wrapping_mul(u64::from(n)), d);
    match (negative, r) {
        (false, _) => (signed(q), r),
        (true, 0) => (signed(q).wrapping_neg(), 0),
        (true, _) => (!signed(q), d.get().wrapping_sub(r)),
    }
}

/// A line along its longer axis: its columns are rows of pixels if it is steep.
struct Line {
    /// Where it starts and ends along that axis.
    a: i32,
    b: i32,
    /// The same across it.
    m: i32,
    n: i32,
    length: NonZeroU32,
    steep: bool,
    /// Whether columns grow on the way.
    up: bool,
}

impl Line {
    /// `None` if it has no length.
    fn new(a: PointFx, b: PointFx) -> Option<Self> {
        let ((ax, ay), (bx, by)) = (bits(a), bits(b));
        let steep = ay.abs_diff(by) > ax.abs_diff(bx);
        let ((a, m), (b, n)) = if steep { ((ay, ax), (by, bx)) } else { ((ax, ay), (bx, by)) };
        Some(Self { a, b, m, n, length: NonZeroU32::new(a.abs_diff(b))?, steep, up: a < b })
    }

    /// The first column whose centre is passed, and the last one.
    fn centres(&self) -> (i32, i32) {
        if self.up {
            (first_centre_from(self.a), first_centre_from(self.b).wrapping_sub(1))
        } else {
            (first_centre_after(self.a).wrapping_sub(1), first_centre_after(self.b))
        }
    }

    fn pixel(&self, along: i32, across: i32) -> (i32, i32) {
        if self.steep {
            (across, along)
        } else {
            (along, across)
        }
    }

    /// Which of two columns comes later on the way.
    fn later(&self, p: i32, q: i32) -> i32 {
        if self.up {
            p.max(q)
        } else {
            p.min(q)
        }
    }

    fn sooner(&self, p: i32, q: i32) -> i32 {
        if self.up {
            p.min(q)
        } else {
            p.max(q)
        }
    }

    /// So many columns later. Columns of places and margins are small.
    fn after(&self, column: i32, count: i32) -> i32 {
        if self.up {
            column.wrapping_add(count)
        } else {
            column.wrapping_sub(count)
        }
    }

    /// How far it rises on so many units, as units and remainder.
    fn rise(&self, along: u32) -> (i32, u32) {
        ratio(along, self.m.abs_diff(self.n), self.length, self.n < self.m)
    }

    /// Where it is at the centre of a column, as units and remainder.
    fn row(&self, column: i32) -> (i32, u32) {
        let (rise, rest) = self.rise((column << 8 | 128).abs_diff(self.a));
        (self.m.wrapping_add(rise), rest)
    }

    /// Whether a part of it lies outside of these rows of pixels.
    fn leaves(&self, (low, high): (i32, i32)) -> bool {
        self.m.min(self.n) >> 8 < low || self.m.max(self.n) >> 8 >= high
    }

    /// The columns where it enters and leaves these rows of pixels; `None` if it misses them. Its pixels outside of these columns
    /// lie outside of these rows, and those inside lie in these rows but for one at each end.
    fn seen(&self, (low, high): (i32, i32)) -> Option<(i32, i32)> {
        // Across the line, in its direction: units from its start to the rows, and to their end. Below 2^41.
        let from_start = |row: i32| (i64::from(row) << 8).wrapping_sub(self.m.into());
        let (near, far) = if self.m <= self.n {
            (from_start(low), from_start(high))
        } else {
            (from_start(high).wrapping_neg(), from_start(low).wrapping_neg())
        };
        let height = self.m.abs_diff(self.n);
        if far < 0 || near > i64::from(height) {
            return None;
        }
        let column = |across: i64| {
            let across = u32::try_from(across.max(0)).unwrap_or(u32::MAX);
            let place = match NonZeroU32::new(height) {
                _ if across == 0 => self.a,
                Some(height) if across < height.get() => {
                    let (units, _) = div_rem_wide(u64::from(across).wrapping_mul(self.length.get().into()), height);
                    if self.up {
                        self.a.wrapping_add_unsigned(units)
                    } else {
                        self.a.wrapping_sub_unsigned(units)
                    }
                }
                _ => self.b,
            };
            place >> 8
        };
        Some((column(near), column(far)))
    }
}

/// Collects the pixels of an outline, in the order of the path, into spans.
struct Trace<S> {
    window: Rect,
    sink: S,
    /// The direction of the run: whether it goes along y, and whether that coordinate grows. `None` at the start of a contour.
    way: Option<(bool, bool)>,
    /// The pixel where the run ends so far, if it must be drawn in case that no line of the same direction follows.
    end: Option<(i32, i32)>,
    /// The pixel before the last one.
    before: Option<(i32, i32)>,
    last: Option<(i32, i32)>,
    /// Whether `before` is the corner of an L.
    bent: bool,
    /// Pixels side by side that are not emitted yet.
    run: Span,
}

impl<S: Sink> Trace<S> {
    fn start(&mut self, start: PointFx) {
        let pixel = start.pixel();
        (self.way, self.end) = (None, Some((pixel.x, pixel.y)));
    }

    /// The pixels of one line: those of the window, some before and after them, and some at both ends.
    fn line(&mut self, a: PointFx, b: PointFx) {
        let Some(line) = Line::new(a, b) else { return };
        let way = self.way.replace((line.steep, line.up));
        let (first, last) = line.centres();
        let end = (last != line.b >> 8).then(|| line.pixel(line.b >> 8, line.n >> 8));
        let before = core::mem::replace(&mut self.end, end);
        if way != self.way {
            if let Some(end) = before.filter(|_| way.is_some()) {
                self.push(end);
            }
            if first != line.a >> 8 {
                self.push(line.pixel(line.a >> 8, line.m >> 8));
            }
        }
        let Rect { x0, y0, x1, y1 } = self.window;
        let (columns, rows) = if line.steep { ((y0, y1), (x0, x1)) } else { ((x0, x1), (y0, y1)) };
        let (low, high) = (columns.0.saturating_sub(MARGIN), columns.1.saturating_add(MARGIN));
        let (near, far) = if line.up { (low, high) } else { (high, low) };
        let (at, end) = (line.later(first, near), line.sooner(last, far));
        if line.leaves(rows) {
            self.follow_parts(&line, rows, (first, last), (at, end));
        } else {
            self.follow(&line, at, end);
        }
    }

    /// The pixels of a line that leaves the rows of the window. What lies between its ends and these rows is left out, but for
    /// the columns that can matter.
    #[cold]
    #[inline(never)]
    fn follow_parts(&mut self, line: &Line, rows: (i32, i32), (first, last): (i32, i32), (mut at, end): (i32, i32)) {
        let (enter, leave) = line.seen(rows).unwrap_or((last, last));
        let gap = |from: i32, to: i32| (line.after(from, MARGIN), line.after(to, -MARGIN));
        for (stop, next) in [gap(first, enter), gap(leave, last), (end, end)] {
            if line.later(next, stop) == next {
                self.follow(line, at, line.sooner(stop, end));
                at = line.later(at, next);
            }
        }
    }

    /// The pixels of a line from one column to another.
    #[inline(always)]
    fn follow(&mut self, line: &Line, mut at: i32, end: i32) {
        if at != end && line.later(at, end) == at {
            return;
        }
        let start = line.row(at);
        let slope = if at == end { (0, 0) } else { line.rise(256) };
        let mut row = Stepper::new(line.length, start, slope);
        loop {
            #[cfg(test)]
            crate::num::tally::add(crate::num::tally::Work::Step);
            self.push(line.pixel(at, row.value >> 8));
            if at == end {
                return;
            }
            row.step();
            at = line.after(at, 1);
        }
    }

    fn push(&mut self, pixel: (i32, i32)) {
        if self.last == Some(pixel) {
            return;
        }
        let bent = self.before.zip(self.last).is_some_and(|(p, q)| {
            let diagonal = p.0.abs_diff(pixel.0) == 1 && p.1.abs_diff(pixel.1) == 1;
            diagonal && (q == (p.0, pixel.1) || q == (pixel.0, p.1))
        });
        if let Some(last) = self.last.filter(|_| !bent || self.bent) {
            self.paint(last);
        }
        (self.before, self.last, self.bent) = (self.last, Some(pixel), bent);
    }

    fn paint(&mut self, (x, y): (i32, i32)) {
        if y == self.run.y && x == self.run.x1 {
            self.run.x1 = x.wrapping_add(1);
        } else if y == self.run.y && x.wrapping_add(1) == self.run.x0 {
            self.run.x0 = x;
        } else {
            self.flush(Span { y, x0: x, x1: x.wrapping_add(1) });
        }
    }

    /// Emits the run and begins another.
    fn flush(&mut self, next: Span) {
        if let Some(span) = core::mem::replace(&mut self.run, next).clip(self.window) {
            self.sink.span(span);
        }
    }

    /// The contour ends.
    fn finish(&mut self) {
        if let Some(end) = self.end.take() {
            self.push(end);
        }
        if let Some(last) = self.last.take() {
            self.paint(last);
        }
        self.flush(Span { y: 0, x0: 0, x1: 0 });
        (self.before, self.bent) = (None, false);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{geom::Path, num::tally, span::ClippedSpan};
    use std::{vec, vec::Vec};
    use twins::rng::Rng;

    fn drawn(path: &[PathSegment], window: Rect) -> Vec<(i32, i32)> {
        let mut pixels = vec![];
        draw(Path::new(path), window, |s: ClippedSpan| pixels.extend((s.x0()..s.x1()).map(|x| (s.y(), x))));
        pixels.sort_unstable();
        pixels
    }

    /// Pixels that are looked at, and pixels in the window.
    fn work(path: &[PathSegment], window: Rect) -> (usize, usize) {
        let mut pixels = 0;
        let done = tally::of(|| draw(Path::new(path), window, |s: ClippedSpan| pixels += s.len() as usize));
        (done[tally::Work::Step as usize], pixels)
    }

    fn line(a: (i32, i32), b: (i32, i32)) -> [PathSegment; 2] {
        [PathSegment::MoveTo(PointFx::from_bits(a.0, a.1)), PathSegment::LineTo(PointFx::from_bits(b.0, b.1))]
    }

    /// A band as wide as a frame can be, which a line crosses in a few columns, or runs beside.
    #[test]
    fn lines_are_followed_where_they_are_seen() {
        let band = Rect::new(0, 0, 65_535, 1);
        let across = work(&line((0, -32_767 * 256), (65_534 * 256, 32_767 * 256)), band);
        assert!(across.0 <= 24 && across.1 > 0, "{across:?}");
        let beside = work(&line((0, 2 * 256), (65_535 * 256, 2 * 256 + 9)), band);
        assert!(beside.0 <= 24 && beside.1 == 0, "{beside:?}");
        let mut rng = Rng::new(540);
        let (mut most, mut seen) = (0, 0);
        for _ in 0..60_000 {
            let shift = rng.int(0, 20);
            let mut end = || (rng.int(i32::MIN, i32::MAX) >> shift, rng.int(i32::MIN, i32::MAX) >> rng.int(0, 24));
            let (a, b) = (end(), end());
            let turned = rng.one_in(2);
            let [a, b] = [a, b].map(|(x, y)| if turned { (y, x) } else { (x, y) });
            let (x, y) = (rng.int(-99, 99), rng.int(-99, 99));
            let (long, high) = (65_535 >> rng.int(0, 12), rng.int(1, 4));
            let (w, h) = if rng.one_in(2) { (long, high) } else { (high, long) };
            let (looked, shown) = work(&line(a, b), Rect::new(x, y, x + w, y + h));
            assert!(looked <= shown + 24, "{looked} for {shown} pixels: {a:?} {b:?} in {w} x {h} at {x}, {y}");
            most = most.max(shown);
            seen += usize::from(shown > 0);
        }
        assert!(most > 2_000 && seen > 4_000, "{most} at most, {seen} seen");
    }

    /// A window shows what a larger one shows there, corners of an L and all.
    #[test]
    fn every_window_shows_the_same_outline() {
        let mut rng = Rng::new(541);
        let mut shown = 0;
        for _ in 0..40_000 {
            let reach = rng.pick(&[500, 2_000, 9_000, 60_000]);
            let mut at = (rng.int(-reach, reach), rng.int(-reach, reach));
            let mut path = vec![PathSegment::MoveTo(PointFx::from_bits(at.0, at.1))];
            for _ in 0..rng.int(1, 9) {
                // From somewhere else, or not far on, as flattened curves go.
                let near = rng.pick(&[300, 1_500, reach]);
                let (low, high) = (at.0.saturating_sub(near), at.1.saturating_sub(near));
                at = (
                    rng.int(low, low + 2 * near).clamp(-reach, reach),
                    rng.int(high, high + 2 * near).clamp(-reach, reach),
                );
                path.push(PathSegment::LineTo(PointFx::from_bits(at.0, at.1)));
            }
            if rng.one_in(3) {
                path.push(PathSegment::Close);
            }
            let pixels = (reach >> 8) + 1;
            let whole = drawn(&path, Rect::new(-pixels - 9, -pixels - 9, pixels + 9, pixels + 9));
            for _ in 0..4 {
                let (x, y) = (rng.int(-pixels, pixels), rng.int(-pixels, pixels));
                let mut side = || rng.pick(&[1, 1, 2, 3, 9, 500]);
                let window = Rect::new(x, y, x + side(), y + side());
                let got = drawn(&path, window);
                let wanted: Vec<_> = whole.iter().copied().filter(|&(y, x)| window.contains(x, y)).collect();
                assert_eq!(got, wanted, "{path:?} in {window:?}");
                shown += got.len();
            }
        }
        assert!(shown > 100_000, "only {shown} pixels were shown");
    }
}
