//! Points and axis-parallel rectangles in sub-pixel coordinates, by the rule of all fills.

use crate::{
    geom::{bits, Vertex},
    num::round::first_centre_from,
    rect::Rect,
};

/// The pixels whose centres lie in the rectangle between two opposite corners: left and top sides in, right and bottom
/// sides out.
/// ```
/// use embedded_raster::{raster::rectangle, Rect, Vertex};
/// let (a, b) = (Vertex::from_bits(128, 129), Vertex::from_bits(640, 641));
/// assert_eq!(rectangle::pixels(a, b), Rect::new(0, 1, 2, 3));
/// assert_eq!(rectangle::pixels(b, a), Rect::new(0, 1, 2, 3));
/// assert!(rectangle::pixels(a, a).is_empty());
/// ```
pub fn pixels(a: Vertex, b: Vertex) -> Rect {
    let ((ax, ay), (bx, by)) = (bits(a), bits(b));
    Rect {
        x0: first_centre_from(ax.min(bx)),
        y0: first_centre_from(ay.min(by)),
        x1: first_centre_from(ax.max(bx)),
        y1: first_centre_from(ay.max(by)),
    }
}
