//! Rectangles: filled and in outline, by pixels; and the pixels of a rectangle between places.
//!
//! Work: comparisons. A sink is called once, with an area; for an outline four times at most.

use crate::{
    geom::{bits, PointFx},
    num::round::first_centre_from,
    span::{Rect, Sink},
};

/// The pixels whose centres lie in the rectangle between two opposite corners: left and top sides in, right and bottom
/// sides out.
/// ```
/// use embedded_raster::{raster::rectangle, PointFx, Rect};
/// let (a, b) = (PointFx::from_bits(128, 129), PointFx::from_bits(640, 641));
/// assert_eq!(rectangle::pixels(a, b), Rect::new(0, 1, 2, 3));
/// assert_eq!(rectangle::pixels(b, a), Rect::new(0, 1, 2, 3));
/// assert!(rectangle::pixels(a, a).is_empty());
/// ```
pub fn pixels(a: PointFx, b: PointFx) -> Rect {
    let ((ax, ay), (bx, by)) = (bits(a), bits(b));
    Rect {
        x0: first_centre_from(ax.min(bx)),
        y0: first_centre_from(ay.min(by)),
        x1: first_centre_from(ax.max(bx)),
        y1: first_centre_from(ay.max(by)),
    }
}

/// Emits the pixels of a rectangle that lie in `window`.
#[inline]
pub fn fill(area: Rect, window: Rect, mut sink: impl Sink) {
    let seen = area.intersection(window);
    if !seen.is_empty() {
        sink.area(seen);
    }
}

/// Emits the outline of a rectangle, one pixel wide, as far as it lies in `window`: its top row, its left and right columns
/// without their ends, and its bottom row. No two of them share a pixel.
/// ```
/// use embedded_raster::{raster::rectangle, ClippedSpan, Rect};
/// let mut spans = vec![];
/// rectangle::outline(Rect::new(2, 1, 9, 4), Rect::new(0, 0, 64, 48), |s: ClippedSpan| spans.push((s.y(), s.x0(), s.x1())));
/// assert_eq!(spans, [(1, 2, 9), (2, 2, 3), (2, 8, 9), (3, 2, 9)]);
/// ```
#[inline]
pub fn outline(area: Rect, window: Rect, mut sink: impl Sink) {
    let Rect { x0, y0, x1, y1 } = area;
    let (left, top) = (x0.saturating_add(1).min(x1), y0.saturating_add(1).min(y1));
    let (right, bottom) = (x1.saturating_sub(1).max(left), y1.saturating_sub(1).max(top));
    let between = Rect { y0: top, y1: bottom, ..area };
    let sides = [
        Rect { y1: top, ..area },
        Rect { x1: left, ..between },
        Rect { x0: right, ..between },
        Rect { y0: bottom, ..area },
    ];
    for side in sides {
        let seen = side.intersection(window);
        if !seen.is_empty() {
            sink.area(seen);
        }
    }
}
