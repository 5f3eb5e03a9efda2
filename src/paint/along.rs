//! Values along a line between two places: what changes from one end to the other.
//!
//! A line has one pixel in each column, or in each row if it is steep: see [`line_fx`]. The value there is that of the place on the
//! line in the middle of the column: with n and m the distances along the longer axis from that place to the ends, it is the nearest
//! whole number to
//! ```text
//!        m v0 + n v1             v0                            v1
//!        -----------              o------------x---------------o
//!           m + n                 |     n      |       m       |
//! ```
//! halves upwards, as over triangles. A line of no length has the value of its first end. At the ends of a line the middle of a
//! pixel may lie beyond the end: then it has the value of the end. So nothing leaves the range of the two values, and no other
//! pixel, no window and no band takes part in a value. Depths are tested and kept as those of triangles are.
//!
//! **How.** Along a line, values change as they do over a triangle that has an end of the line at two of its corners, both moved to
//! the first row of the line's box, and the third corner straight below one of them:
//! ```text
//!     v0 ----------- v1       flat: values change from column to column and not from row to row
//!      |          ..          steep: the same with rows and columns exchanged
//!      |     ..''
//!     v0 ''
//! ```
//! So everything that changes over triangles changes along lines, by the same additions.
//!
//! Range: any places. A row or a column beyond those that places can name, where a line may have a pixel too, is left out.
//!
//! Work: the set-up of up to three planes, two of which have the same value everywhere and one pixel.

use core::cmp::Ordering;

use crate::{
    error::TriangleTooLarge,
    geom::{bits, px, Facet, Plane, PointFx, Varying},
    num::round::{first_centre_after, first_centre_from},
    raster::line_fx,
    span::Rect,
};

/// Calls `draw` with each part of a window in which the values along a line are those of one plane: from the middle of a pixel on
/// that lies on the line to the last such middle, and what is beyond at both ends.
///
/// # Errors
/// If the box of the line is wider and higher, together, than [`Facet::MOST`] pixels. Then nothing is drawn.
#[inline(always)]
pub(crate) fn parts<V: Varying>(
    ends: [PointFx; 2],
    [first, last]: [V; 2],
    window: Rect,
    mut draw: impl FnMut(Plane<V>, Rect),
) -> Result<(), TriangleTooLarge> {
    let line = Line::new(ends);
    let between = Facet::new(line.corners)?;
    let [low, high] = match line.way {
        Ordering::Less => [first, last],
        Ordering::Equal => [first, first],
        Ordering::Greater => [last, first],
    };
    let [from, to] = line.middles;
    let parts = [(i32::MIN, from, [low, low]), (from, to, [low, high]), (to, i32::MAX, [high, high])];
    for (start, end, [low, high]) in parts {
        let part = line.part(window, start, end);
        if part.is_empty() {
            continue;
        }
        let facet = if start == from { between } else { Line::around(part).unwrap_or(between) };
        draw(Plane::new(&facet, [low, high, low]), part);
    }
    Ok(())
}

/// Where a line is.
struct Line {
    /// Those of its pixels that a place can name, in a box.
    pixels: Rect,
    /// Its lower end, its higher end, and a place beside the lower one: corners of a triangle around its pixels.
    corners: [PointFx; 3],
    /// The first pixel along the longer axis whose middle lies between the ends, and the one after the last.
    middles: [i32; 2],
    is_steep: bool,
    /// From the first end to the last one: `Less` if the first is the lower one.
    way: Ordering,
}

impl Line {
    #[inline(never)]
    fn new([a, b]: [PointFx; 2]) -> Self {
        let everywhere = Rect { x0: -1 << 23, y0: -1 << 23, x1: 1 << 23, y1: 1 << 23 };
        let pixels = line_fx::extent(a, b).intersection(everywhere);
        let ((ax, ay), (bx, by)) = (bits(a), bits(b));
        let is_steep = ay.abs_diff(by) > ax.abs_diff(bx);
        let (from, to) = if is_steep { (ay, by) } else { (ax, bx) };
        let (low, high) = (from.min(to), from.max(to));
        // All that is left of the triangle is where its corners are along the longer axis.
        let corner = |along: i32, aside: [i32; 2]| {
            let [column, row] = aside.map(|pixel| px(pixel).to_bits());
            if is_steep {
                PointFx::from_bits(column, along)
            } else {
                PointFx::from_bits(along, row)
            }
        };
        let (near, far) = ([pixels.x0, pixels.y0], [pixels.x1, pixels.y1]);
        Self {
            pixels,
            corners: [corner(low, near), corner(high, near), corner(low, far)],
            middles: [first_centre_from(low), first_centre_after(high)],
            is_steep,
            way: from.cmp(&to),
        }
    }

    /// The pixels of a window that are the line's and lie in these columns, or rows if it is steep.
    #[inline]
    fn part(&self, window: Rect, start: i32, end: i32) -> Rect {
        let seen = window.intersection(self.pixels);
        if self.is_steep {
            Rect { y0: seen.y0.max(start), y1: seen.y1.min(end), ..seen }
        } else {
            Rect { x0: seen.x0.max(start), x1: seen.x1.min(end), ..seen }
        }
    }

    /// A triangle around the pixel at one end.
    fn around(Rect { x0, y0, x1, y1 }: Rect) -> Option<Facet> {
        Facet::new([PointFx::px(x0, y0), PointFx::px(x1, y0), PointFx::px(x0, y1)]).ok()
    }
}
