//! Points and axis-parallel rectangles in sub-pixel coordinates, by the rule of all fills; outlines of boxes of pixels.

use crate::{
    geom::{bits, PointFx},
    num::round::first_centre_from,
    rect::Rect,
};

/// The pixels whose centres lie in the rectangle between two opposite corners: left and top sides in, right and bottom
/// sides out.
/// ```
/// use embedded_raster::{raster::rectangle, Rect, PointFx};
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

/// The outline of a box of pixels, one pixel wide: its top and bottom rows, and between them its left and right columns. No
/// two of them share a pixel; of a box with less than three rows or columns some are empty.
/// ```
/// use embedded_raster::{raster::rectangle, Rect};
/// let sides = [Rect::new(2, 1, 9, 2), Rect::new(2, 4, 9, 5), Rect::new(2, 2, 3, 4), Rect::new(8, 2, 9, 4)];
/// assert_eq!(rectangle::sides(Rect::new(2, 1, 9, 5)), sides);
/// ```
pub fn sides(area: Rect) -> [Rect; 4] {
    let Rect { x0, y0, x1, y1 } = area;
    let (left, top) = (x0.saturating_add(1).min(x1), y0.saturating_add(1).min(y1));
    let (right, bottom) = (x1.saturating_sub(1).max(left), y1.saturating_sub(1).max(top));
    let between = Rect { y0: top, y1: bottom, ..area };
    [Rect { y1: top, ..area }, Rect { y0: bottom, ..area }, Rect { x1: left, ..between }, Rect { x0: right, ..between }]
}
