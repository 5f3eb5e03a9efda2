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
//! **Work.** Lines, and parts of lines, that are more than 4 pixels outside of the window are not followed, so work depends on
//! the window. They cannot change a pixel inside, as the rule looks two pixels back and one ahead.
//!
//! Range: any `I24F8`.

use core::num::NonZeroU32;

use crate::{
    geom::{bits, Path, PathSegment, PointFx, View},
    num::{
        cast::{signed, unsigned},
        round::{div_rem_wide, first_centre_after, first_centre_from},
        stepper::Stepper,
    },
    span::{Rect, Sink, Span},
};

/// Pixels around a window that decide what is drawn inside, and one more.
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
pub fn draw(path: Path<'_>, window: Rect, sink: impl Sink) {
    if window.is_empty() {
        return;
    }
    let reach = unsigned(MARGIN) << 8;
    let view = View::of(window, reach);
    let run = Span { y: 0, x0: 0, x1: 0 };
    let mut trace = Trace { window, sink, way: None, end: None, before: None, last: None, bent: false, run };
    for mut contour in path.contours_near(window, reach) {
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
pub fn extent(path: Path<'_>) -> Rect {
    let (mut low, mut high) = ((i32::MAX, i32::MAX), (i32::MIN, i32::MIN));
    let mut hold = |place: PointFx| {
        let (x, y) = bits(place);
        low = (low.0.min(x >> 8), low.1.min(y >> 8));
        high = (high.0.max(x >> 8), high.1.max(y >> 8));
    };
    // A path that does not begin with a move begins at (0, 0).
    if !matches!(path.segments(), [] | [PathSegment::MoveTo(_), ..]) {
        hold(PointFx::from_bits(0, 0));
    }
    for segment in path.segments() {
        match *segment {
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

    /// The pixels of one line, those of the window and near it.
    fn line(&mut self, a: PointFx, b: PointFx) {
        let ((ax, ay), (bx, by)) = (bits(a), bits(b));
        let steep = ay.abs_diff(by) > ax.abs_diff(bx);
        let Rect { x0, y0, x1, y1 } = self.window;
        let ((a, m), (b, n), low, high) =
            if steep { ((ay, ax), (by, bx), y0, y1) } else { ((ax, ay), (bx, by), x0, x1) };
        let Some(length) = NonZeroU32::new(a.abs_diff(b)) else { return };
        let turned = |along: i32, across: i32| if steep { (across, along) } else { (along, across) };
        // The first column whose centre is passed, and the last one.
        let up = a < b;
        let (first, last) = if up {
            (first_centre_from(a), first_centre_from(b).wrapping_sub(1))
        } else {
            (first_centre_after(a).wrapping_sub(1), first_centre_after(b))
        };
        let end = (last != b >> 8).then(|| turned(b >> 8, n >> 8));
        let (way, before) = (self.way.replace((steep, up)), core::mem::replace(&mut self.end, end));
        if way != self.way {
            if let Some(end) = before.filter(|_| way.is_some()) {
                self.push(end);
            }
            if first != a >> 8 {
                self.push(turned(a >> 8, m >> 8));
            }
        }
        // Without columns that are too far outside of the window to matter.
        let (low, high) = (low.saturating_sub(MARGIN), high.saturating_add(MARGIN));
        let step = if up { 1 } else { -1 };
        let (mut at, far) = if up { (first.max(low), last.min(high)) } else { (first.min(high), last.max(low)) };
        if if up { at > far } else { at < far } {
            return;
        }
        let rise = m.abs_diff(n);
        let centre = at << 8 | 128;
        let (start, rest) = ratio(centre.abs_diff(a), rise, length, n < m);
        let slope = if at == far { (0, 0) } else { ratio(256, rise, length, n < m) };
        let mut row = Stepper::new(length, (m.wrapping_add(start), rest), slope);
        loop {
            self.push(turned(at, row.value >> 8));
            if at == far {
                return;
            }
            row.step();
            at = at.wrapping_add(step);
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
