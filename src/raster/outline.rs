//! Outlines of paths, one pixel wide.
//!
//! Curves become lines within 9.3 units (1/27 pixel), as [`flatten`](crate::geom::flatten) tells; each line, and each line of
//! the path itself, runs through pixels along its longer axis:
//! ```text
//!     +-----+-----+-----+-----+    from a to b along x (if |dx| >= |dy|): one pixel a column, from the column of a to
//!     |  .  |  .  |  .__|--b  |    that of b, in the row where the line is at the column's centre; where the line
//!     +-----+---__+--'--+-----+    begins or ends beside the centre, in the row of its end
//!     |  a--|--'  |  .  |  .  |
//!     +-----+-----+-----+-----+    here: a's pixel, one below the line, two above
//! ```
//! So all pixels of an outline touch the next, across corners too. Where lines meet, the pixels before and after a third one may
//! touch already: then it is left out, unless the one before it might be left out for the same reason. Every pixel has its
//! centre within 0.75 pixels of the true curve: half the diagonal of a pixel, and the tolerance.
//!
//! **Work.** Lines that stay 4 pixels outside of the window are not followed, nor are parts of others, so work depends on the
//! window. What happens there cannot matter, as the rule looks two pixels back and one ahead.
//!
//! Range: any `I24F8`.

use core::num::NonZeroU32;

use crate::{
    geom::{bits, flatten::FINER, Path, Vertex, View},
    num::{
        cast::{signed, unsigned},
        round::div_rem_wide,
        stepper::Stepper,
    },
    rect::Rect,
    span::{ClippedSpan, Span},
};

/// Pixels around a window that decide what is drawn inside, and one more.
const MARGIN: i32 = 4;

/// Emits the pixels of a path's outline that lie in `window`, as spans in the order of the path. A pixel that the path comes
/// back to is emitted again.
///
/// Cannot fail, for any coordinates and any window.
/// ```
/// use embedded_graphics_core::geometry::Point;
/// use embedded_raster::{raster::outline, Path, PathSegment::*, Rect, Vertex};
/// let at = |x, y| Vertex::centre_of(Point::new(x, y));
/// let arch = [MoveTo(at(0, 5)), QuadraticTo(at(5, -5), at(10, 5))];
/// let mut rows = [[b'.'; 11]; 6];
/// outline::draw(Path::new(&arch), Rect::new(0, 0, 11, 6), |s| {
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
pub fn draw(path: Path<'_>, window: Rect, emit: impl FnMut(ClippedSpan)) {
    if window.is_empty() {
        return;
    }
    let reach = unsigned(MARGIN) << 8;
    let view = View::of(window, reach);
    let mut trace = Trace { window, emit, before: None, last: None, bent: false, run: Span { y: 0, x0: 0, x1: 0 } };
    for mut contour in path.contours_near(window, reach, FINER) {
        let closed = contour.is_closed();
        let Some(start) = contour.next() else { continue };
        if !view.hides(start, start, 0) {
            let start = start.pixel();
            trace.push((start.x, start.y));
        }
        let mut from = start;
        for to in contour.chain(closed.then_some(start)) {
            if !view.hides(from, to, 0) {
                line(from, to, window, |pixel| trace.push(pixel));
            }
            from = to;
        }
        trace.finish();
    }
}

/// The pixels of one line in a window and near it, from `a` to `b`.
fn line(a: Vertex, b: Vertex, window: Rect, mut push: impl FnMut((i32, i32))) {
    let ((ax, ay), (bx, by)) = (bits(a), bits(b));
    let steep = ay.abs_diff(by) > ax.abs_diff(bx);
    let ((a, m), (b, n), low, high) =
        if steep { ((ay, ax), (by, bx), window.y0, window.y1) } else { ((ax, ay), (bx, by), window.x0, window.x1) };
    let mut push = |along: i32, across: i32| push(if steep { (across >> 8, along) } else { (along, across >> 8) });
    let Some(way) = NonZeroU32::new(a.abs_diff(b)) else { return push(a >> 8, m) };
    let (ahead, rise) = (a < b, m.abs_diff(n));
    let (first, last) = (a >> 8, b >> 8);
    // Columns as they are passed, without those that nobody can see.
    let (low, high) = (low.saturating_sub(MARGIN), high.saturating_add(MARGIN));
    let (near, far) = if ahead { (first.max(low), last.min(high)) } else { (first.min(high), last.max(low)) };
    if (near > far) == ahead && near != far {
        return;
    }
    let across = |place: i32| ratio(place.abs_diff(a), rise, way, n < m);
    let step = if ahead { 1 } else { -1 };
    let mut at = near;
    if at == first {
        let centre = centre(at);
        let place = if ahead { centre.max(a).min(b) } else { centre.min(a).max(b) };
        push(at, m.wrapping_add(across(place).0));
        if at == far {
            return;
        }
        at = at.wrapping_add(step);
    }
    if at != last {
        let start = across(centre(at));
        let mut row = Stepper::new(way, (m.wrapping_add(start.0), start.1), ratio(256, rise, way, n < m));
        while at != last {
            push(at, row.value);
            if at == far {
                return;
            }
            row.step();
            at = at.wrapping_add(step);
        }
    }
    let centre = centre(at);
    let place = if ahead { centre.min(b) } else { centre.max(b) };
    push(at, m.wrapping_add(across(place).0));
}

/// The middle of a column that a place in the range of `I24F8` may lie in.
fn centre(column: i32) -> i32 {
    column << 8 | 128
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

/// Pixels in the order of the path, on their way to become spans.
struct Trace<E> {
    window: Rect,
    emit: E,
    /// The pixel before the last one.
    before: Option<(i32, i32)>,
    last: Option<(i32, i32)>,
    /// The pixels before and after `before` touch.
    bent: bool,
    /// Pixels side by side that are not emitted yet.
    run: Span,
}

impl<E: FnMut(ClippedSpan)> Trace<E> {
    fn push(&mut self, pixel: (i32, i32)) {
        if self.last == Some(pixel) {
            return;
        }
        let touches =
            |before: (i32, i32)| before != pixel && before.0.abs_diff(pixel.0) <= 1 && before.1.abs_diff(pixel.1) <= 1;
        let bent = self.before.is_some_and(touches);
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
            (self.emit)(span);
        }
    }

    /// The contour ends.
    fn finish(&mut self) {
        if let Some(last) = self.last.take() {
            self.paint(last);
        }
        self.flush(Span { y: 0, x0: 0, x1: 0 });
        (self.before, self.bent) = (None, false);
    }
}
