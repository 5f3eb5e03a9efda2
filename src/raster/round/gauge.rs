//! Gauges: sectors of rings with round ends.
//! ```text
//!        .-######-.
//!      .############.         the sector of the ring, and at each of its rays a disc whose diameter is the part of the ray that
//!     ####'      '####        lies between both curves
//!    ###(          )###
//!     '-'          '-'
//! ```
//! A pixel is drawn when it is one of the [sector of a ring](super::arc::ring_sector), or one of the filled [circle](super::ellipse)
//! at one of its ends. In a ring of two circles around one centre, these are the pixels not farther than half its width from an arc,
//! and the ends are half circles. A whole turn has no ends, and no sector at all has nothing: a gauge at 0 % draws nothing.
//!
//! The centre of a disc is the middle between the places where the ray meets both curves, and its radius half of the distance between
//! these, and 1/2048 pixel more, so that no centre of a pixel lies exactly on it. Coordinates of the places are rounded to 1/512 pixel,
//! towards the centre of the ring. Both are meant for ellipses of one centre: the inner one is
//! looked at as if it stood around the centre of the outer one.
//!
//! Each pixel is drawn once, top row first. Work: that of the sector of the ring and of both discs.
//!
//! Range: any ellipses, any angles.

use heapless::Vec;

use super::{
    arc::{self, Sector},
    curve::Ellipse,
    form::AnyRows,
    ray::{place, scaled, SHIFT},
};
use crate::{
    num::{cast::magnitude, root::square_root},
    span::{ClippedSpan, Rect, Sink, Span},
};

/// Emits the spans of a sector of a ring with round ends that lie in `window`, top row first.
/// ```
/// use embedded_raster::{raster::gauge, Angle, ClippedSpan, Ellipse, Rect, Sector};
/// let (outer, inner) = (Rect::new(0, 0, 12, 12), Rect::new(4, 4, 8, 8));
/// let mut spans = vec![];
/// let upper_half = Sector::new(Angle::degrees(180), Angle::degrees(0));
/// gauge::fill(Ellipse::in_box(outer), Ellipse::in_box(inner), upper_half, outer, |s: ClippedSpan| spans.push((s.y(), s.x0(), s.x1())));
/// assert_eq!(spans[6..], [(5, 0, 4), (5, 8, 12), (6, 0, 4), (6, 8, 12), (7, 1, 3), (7, 9, 11)]); // half discs from row 6 on
/// ```
pub fn fill(outer: Ellipse, inner: Ellipse, sector: Sector, window: Rect, mut sink: impl Sink) {
    let Some(rays) = sector.rays() else {
        return arc::ring_sector(outer, inner, sector, window, sink);
    };
    if outer.extent().is_empty() {
        return;
    }
    let discs = rays.map(|ray| Disc::new(&end(&outer, &inner, ray), window));
    let visible = outer.extent().intersection(window);
    let y =
        discs.iter().map(|disc| disc.clip).chain([visible]).filter(|area| !area.is_empty()).map(|area| area.y0).min();
    let Some(y) = y else { return };
    let mut rows = Merged { y, spans: Vec::new(), discs, window };
    arc::ring_sector(outer, inner, sector, window, |span: ClippedSpan| {
        rows.go_to(span.y(), &mut sink);
        rows.add((span.x0(), span.x1()));
    });
    let end = rows.discs.iter().map(|disc| disc.clip.y1).fold(rows.y.wrapping_add(1), i32::max);
    rows.go_to(end, &mut sink);
}

/// The disc at the end of a ring that lies in the direction of a ray.
fn end(outer: &Ellipse, inner: &Ellipse, ray: (i32, i32)) -> Ellipse {
    let (centre, radii) = scaled(&outer.curve());
    // An empty box has no ellipse; another one may have no pixel.
    let inner = if inner.is_in_box() && inner.extent().is_empty() { (0, 0) } else { scaled(&inner.curve()).1 };
    let (a, b) = (place(radii, ray), place(inner, ray));
    // In units of 1/2048 pixel, four times as many as before. The centre has an even number of them and the radius an odd one, so
    // distances from the centre to others differ from the radius.
    let middle = |centre: i64, a: i64, b: i64| centre.wrapping_mul(2).wrapping_add(a).wrapping_add(b).wrapping_mul(2);
    let diameter = if radii.0 == radii.1 && inner.0 == inner.1 {
        magnitude(radii.0.wrapping_sub(inner.0).max(0))
    } else {
        length(a.0.wrapping_sub(b.0), a.1.wrapping_sub(b.1))
    };
    let radius = if diameter == 0 { 0 } else { diameter.wrapping_mul(2).wrapping_add(1) };
    Ellipse::round((middle(centre.0, a.0, b.0), middle(centre.1, a.1, b.1)), radius, SHIFT.wrapping_add(2))
}

/// The length of a vector, rounded down, of one below `2^43` to 30 bits.
fn length(x: i64, y: i64) -> u64 {
    let (x, y) = (x.unsigned_abs(), y.unsigned_abs());
    let down = 33_u32.saturating_sub((x | y).leading_zeros());
    let (x, y) = (x >> down, y >> down);
    u64::from(square_root(x.wrapping_mul(x).wrapping_add(y.wrapping_mul(y)))) << down
}

/// The rows of a disc that are visible.
struct Disc {
    clip: Rect,
    rows: Option<AnyRows>,
}

impl Disc {
    fn new(disc: &Ellipse, window: Rect) -> Self {
        let clip = disc.extent().intersection(window);
        Self { clip, rows: (!clip.is_empty()).then(|| AnyRows::new(disc, clip)) }
    }

    /// What it has of a row. Rows are asked for one after the other.
    fn row(&mut self, y: i32) -> Option<(i32, i32)> {
        let Rect { x0, y0, x1, y1 } = self.clip;
        let rows = self.rows.as_mut().filter(|_| y0 <= y && y < y1)?;
        let (start, end) = rows.row();
        Some((start.max(x0), end.min(x1)))
    }
}

/// Rows of which spans come from several shapes.
struct Merged {
    /// The row that spans belong to.
    y: i32,
    /// Of the ring there are two in a row, each in two parts; of the discs there is one each.
    spans: Vec<(i32, i32), 6>,
    discs: [Disc; 2],
    window: Rect,
}

impl Merged {
    /// Adds a span, in the order of their starts.
    fn add(&mut self, mut new: (i32, i32)) {
        for span in &mut self.spans {
            if new.0 < span.0 {
                core::mem::swap(&mut new, span);
            }
        }
        // There is room for all.
        self.spans.push(new).unwrap_or(());
    }

    /// Emits all rows before y.
    fn go_to(&mut self, y: i32, sink: &mut impl Sink) {
        while self.y < y {
            #[cfg(test)]
            crate::num::tally::add(crate::num::tally::Work::Step);
            for i in 0..2 {
                if let Some(span) = self.discs.get_mut(i).and_then(|disc| disc.row(self.y)).filter(|(a, b)| a < b) {
                    self.add(span);
                }
            }
            self.emit(sink);
            self.y = self.y.wrapping_add(1);
        }
    }

    /// Emits this row: what overlaps or touches as one span.
    fn emit(&mut self, sink: &mut impl Sink) {
        let mut spans = self.spans.iter().copied();
        let mut last = spans.next();
        while let Some((x0, x1)) = last {
            let mut end = x1;
            last = spans.find(|next| {
                let joins = next.0 <= end;
                end = if joins { end.max(next.1) } else { end };
                !joins
            });
            if let Some(span) = (Span { y: self.y, x0, x1: end }).clip(self.window) {
                sink.span(span);
            }
        }
        self.spans.clear();
    }
}
