//! Segments of ellipses: what a chord cuts off.
//! ```text
//!          . - - - - .
//!       a ------------- b          The segment of a sector lies between the arc of the sector and the chord, the straight line
//!      . ############### .         between both of its ends. Of a sector of more than half a turn it is more than half of the
//!      . ############### .         ellipse, and of a whole turn all of it.
//!        .#############.
//!           ' ##### '              here from b to a, clockwise
//! ```
//! A pixel belongs to the segment when it is one of the filled [ellipse](super::ellipse) and its centre lies on this side of the
//! chord, exactly, in 64 bits. The ends of the chord are the places where the rays of the [`Sector`] meet the curve, rounded to 1/256
//! pixel; they stop at the ends of `I24F8`. A centre exactly on the chord counts as if it stood a little to the right and, much less,
//! down, as for all [fills](crate::raster). So both segments of a chord draw each pixel of the ellipse once, and the segment of an
//! angle and its mirror image is as symmetric as they are.
//!
//! Work: that of the ellipse, and a bisection for each row that the chord crosses.

use core::cmp::Ordering;

use super::{
    arc::Sector,
    curve::Ellipse,
    ellipse,
    ray::{place, scaled},
};
use crate::{
    geom::exact::{turn_at, Place},
    num::cast::{saturate, signed, unsigned},
    span::{ClippedSpan, Rect, Sink, Span},
};

/// Emits the spans of a segment of an ellipse that lie in `window`, top row first.
/// ```
/// use embedded_raster::{raster::chord, Angle, ClippedSpan, Ellipse, Rect, Sector};
/// let (area, mut spans) = (Rect::new(0, 0, 8, 8), vec![]);
/// let bowl = Sector::new(Angle::degrees(30), Angle::degrees(150));
/// chord::fill(Ellipse::in_box(area), bowl, area, |s: ClippedSpan| spans.push((s.y(), s.x0(), s.x1())));
/// assert_eq!(spans, [(6, 1, 7), (7, 2, 6)]); // below y = 4 + 4 sin 30 = 6
/// ```
pub fn fill(ellipse: Ellipse, sector: Sector, window: Rect, mut sink: impl Sink) {
    let Some([from, to]) = sector.rays() else {
        if sector.is_wide() {
            ellipse::fill(ellipse, window, sink);
        }
        return;
    };
    let curve = ellipse.curve();
    let (centre, radii) = scaled(&curve);
    let end = |direction: (i32, i32)| {
        let (x, y) = place(radii, direction);
        // From 1/512 pixel; the distance from the centre first, so that mirror images stay mirror images.
        let half = |n: i64| n.signum().wrapping_mul(n.wrapping_abs().wrapping_add(1) >> 1);
        let rounded = |centre: i64, n: i64| saturate(centre.wrapping_add(half(n).wrapping_mul(2)) >> 1);
        (rounded(centre.0, x), rounded(centre.1, y))
    };
    let chord = Chord::new(end(from), end(to), sector.is_wide());
    ellipse::fill(ellipse, window, |span: ClippedSpan| {
        if let Some(span) = chord.part(span) {
            sink.span(span);
        }
    });
}

/// A chord from one end to the other. The segment lies on its left.
struct Chord {
    ends: [Place; 2],
    /// Whether a centre on the line is on its left.
    tie: bool,
}

impl Chord {
    fn new(a: Place, b: Place, is_wide: bool) -> Self {
        // Where both ends are one, all is on one side.
        let tie = if a == b { is_wide } else { b.1 > a.1 || b.1 == a.1 && b.0 < a.0 };
        Self { ends: [a, b], tie }
    }

    fn has(&self, x: i32, y: i32) -> bool {
        let [a, b] = self.ends;
        let centre = |n: i32| saturate((i64::from(n) << 8).wrapping_add(128));
        match turn_at(a, b, (centre(x), centre(y))) {
            Ordering::Less => true,
            Ordering::Equal => self.tie,
            Ordering::Greater => false,
        }
    }

    /// The part of a span that is on its left. Along a row it is crossed once.
    fn part(&self, span: ClippedSpan) -> Option<ClippedSpan> {
        let (x0, x1, y) = (span.x0(), span.x1(), span.y());
        let starts = self.has(x0, y);
        if self.has(x1.wrapping_sub(1), y) == starts {
            return starts.then_some(span);
        }
        let (mut low, mut high) = (x0, x1);
        while low < high {
            #[cfg(test)]
            crate::num::tally::add(crate::num::tally::Work::Step);
            let middle = low.wrapping_add(signed(unsigned(high.wrapping_sub(low)) >> 1));
            if self.has(middle, y) == starts {
                low = middle.wrapping_add(1);
            } else {
                high = middle;
            }
        }
        let (start, end) = if starts { (x0, low) } else { (low, x1) };
        (Span { y, x0: start, x1: end }).clip_columns(Rect { x0, y0: y, x1, y1: y.wrapping_add(1) })
    }
}
