//! Filled triangles: three vertices in, at most one span a row out.
//!
//! A pixel is drawn when its *centre* lies inside. A centre exactly on an edge counts for left and top edges only (the
//! top-left rule), so two triangles that share an edge draw every pixel along it once: no gap, no overlap.
//! ```text
//!           a            row y is crossed at y + 1/2, where a.y <= y + 1/2 < b.y
//!         /   \
//!    ---/-.-.-.-\---     x0 = first centre at or right of the left edge
//!     /           \      x1 = first centre at or right of the right edge
//!    b-------------c     drawn: x0 <= x < x1, the same rounding on both sides
//! ```
//! There are three ways to the same pixels. [`fill`] solves each row for its two ends, where the sides cross it: that is what the
//! methods of `Canvas` do. [`walk`] steps the three edge functions over the bounding box, and [`walk_blocks`] over those blocks of
//! 8 x 8 pixels that a side crosses: the ways of graphics hardware, to learn from and to compare with.
//!
//! The *long* side from the top corner to the bottom one faces two short ones. Which of two sides is the left one need not be
//! computed. Crossings are rounded the same way on both, and rounding keeps the order: on every row the left one is not
//! beyond the right one. So of two unequal crossings the lesser is the left side's, on all rows of the triangle; and between
//! equal ones lies no pixel.
//!
//! How crossings are found depends on the chip and the opt-level: by sums of fixed-point numbers where that is exact (the proof is
//! in `raster::sum`), or by quotient and remainder (`steps`). A build for size has the second way only.
//!
//! Work of [`fill`]: six divisions at most, or as many for each 64 rows of a larger one, and two additions for each row of the window
//! between the highest and the lowest corner. Of [`walk`]: three additions for each pixel of the window in the box around the corners,
//! in each row up to the right end of the triangle. Of [`walk_blocks`]: a dozen additions for each block in that box, up to the right end
//! of the triangle, and three for each pixel in blocks that a side crosses.
//!
//! Sources: "Rasterization Rules", Direct3D 11 documentation; J. Pineda, "A Parallel Algorithm for Polygon
//! Rasterization", SIGGRAPH 1988 (edge functions).

mod steps;
mod sums;
mod walk;

pub(crate) use self::sums::{tiny, TinySpan, TinySpans};
pub use self::walk::{walk, walk_blocks};
use crate::{
    geom::{bits, PointFx},
    num::round::first_centre_from,
    raster::sum::SUMS,
    span::{Rect, Sink},
};

/// Emits the spans of a filled triangle that lie in `window`, top row first.
///
/// * `corners`: in either winding, any coordinates.
/// * `sink`: receives one span for each row that has a pixel.
///
/// Cannot fail. A triangle without area emits nothing.
/// ```
/// use embedded_raster::{raster::triangle, ClippedSpan, PointFx, Rect};
/// let mut widths = vec![];
/// let corners = [PointFx::px(0, 0), PointFx::px(4, 0), PointFx::px(0, 4)];
/// triangle::fill(corners, Rect::new(0, 0, 64, 48), |s: ClippedSpan| widths.push(s.len()));
/// assert_eq!(widths, [3, 2, 1]); // centres on the slope, a right edge, are out
/// ```
#[inline(always)]
pub fn fill(corners: [PointFx; 3], window: Rect, sink: impl Sink) {
    // Written out: mapped by a loop, the corners would be in memory, three times.
    let [a, b, c] = corners;
    let corners = sorted([bits(a), bits(b), bits(c)]);
    if SUMS {
        sums::fill(corners, window, sink);
    } else {
        steps::fill(corners, window, sink);
    }
}

/// A box that encloses the pixels of a triangle: those with a centre between its outermost coordinates.
pub fn extent(corners: [PointFx; 3]) -> Rect {
    let [(ax, ay), (bx, by), (cx, cy)] = corners.map(bits);
    Rect {
        x0: first_centre_from(ax.min(bx).min(cx)),
        y0: first_centre_from(ay.min(by).min(cy)),
        x1: first_centre_from(ax.max(bx).max(cx)),
        y1: first_centre_from(ay.max(by).max(cy)),
    }
}

/// By y, with three compare-exchanges.
#[inline(always)]
fn sorted([mut a, mut b, mut c]: [(i32, i32); 3]) -> [(i32, i32); 3] {
    if b.1 < a.1 {
        (a, b) = (b, a);
    }
    if c.1 < b.1 {
        (b, c) = (c, b);
        if b.1 < a.1 {
            (a, b) = (b, a);
        }
    }
    [a, b, c]
}

#[cfg(test)]
#[allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap, reason = "tests cut numbers on purpose")]
mod tests {
    use super::*;
    use crate::span::ClippedSpan;
    use std::{vec, vec::Vec};
    use twins::rng::Rng;

    fn both(corners: [(i32, i32); 3], window: Rect) -> [Vec<(i32, i32, i32)>; 2] {
        let vertices = corners.map(|(x, y)| PointFx::from_bits(x, y));
        let mut spans = [vec![], vec![], vec![]];
        steps::fill(sorted(corners), window, |s: ClippedSpan| spans[0].push((s.y(), s.x0(), s.x1())));
        walk(vertices, window, |s: ClippedSpan| spans[1].push((s.y(), s.x0(), s.x1())));
        sums::fill(sorted(corners), window, |s: ClippedSpan| spans[2].push((s.y(), s.x0(), s.x1())));
        let [solved, walked, summed] = spans;
        assert_eq!(solved, summed, "steps, sums: {corners:?}");
        [solved, walked]
    }

    #[test]
    fn corners_on_centres() {
        let [solved, walked] = both([(128, 128), (1152, 128), (128, 1152)], Rect::new(0, 0, 8, 8));
        assert_eq!(solved, [(0, 0, 4), (1, 0, 3), (2, 0, 2), (3, 0, 1)]);
        assert_eq!(walked, solved);
    }

    #[test]
    fn random_triangles_agree_in_every_way() {
        let mut rng = Rng::new(301);
        let mut random = |bits: u32| (rng.bits() as i32) >> (32 - bits);
        for i in 0..200_000 {
            let bits = [10, 12, 14, 16, 17, 20, 25, 32][i % 8];
            let corners = [(); 3].map(|()| (random(bits), random(bits)));
            let (x, y) = ((random(bits) >> 8).max(-1 << 22), random(bits) >> 8);
            let [solved, walked] = both(corners, Rect::new(x - 20, y - 20, x + 20, y + 20));
            assert_eq!(walked, solved, "{corners:?}");
        }
    }

    #[test]
    fn sums_agree_up_to_their_limits() {
        let mut rng = Rng::new(302);
        let mut random = |below: i32| rng.int(0, below - 1);
        for i in 0..60_000 {
            let columns = [320, 1023, 64, 1024][i % 4];
            let (width, height) = (random(columns * 256) + 1, random([13, 54, 257, 400][i / 4 % 4] * 256) + 1);
            let (left, top) = (random(columns * 256 - width + 1), random(40 * 256) - 20 * 256);
            // Two of three corners on corners of the box, or on the lines through them: the longest and steepest sides.
            let mut corner = |j: i32| {
                let (x, y) = (random(width + 1), random(height + 1));
                (
                    left + if random(3) == 0 { j % 2 * width } else { x },
                    top + if random(3) == 0 { j / 2 * height } else { y },
                )
            };
            let corners = sorted([corner(0), corner(3), corner(i as i32 % 4)]);
            let window = Rect::new(0, random(8), columns, 230);
            let (mut summed, mut stepped) = (vec![], vec![]);
            sums::fill(corners, window, |s: ClippedSpan| summed.push((s.y(), s.x0(), s.x1())));
            steps::fill(corners, window, |s: ClippedSpan| stepped.push((s.y(), s.x0(), s.x1())));
            assert_eq!(summed, stepped, "{corners:?} in {window:?}");
        }
    }

    /// Where a proof in `raster::sum` ends: one row more, or half of the margin less or more, and a pixel would be wrong.
    #[test]
    fn sums_at_the_bounds_of_their_proofs() {
        let window = Rect::new(0, 0, 200, 200);
        // M + 1 is a multiple of dy, 2^15, on each row. On row 127, the first beyond the reach, a sum would be too large by 2^-15.
        // On row k the slope passes the centre of pixel k, which is out.
        let [solved, walked] = both([(128, 128), (128, 32_896), (32_896, 32_896)], window);
        assert_eq!((walked.len(), solved[126]), (127, (127, 0, 127)));
        assert_eq!(walked, solved);
        // Tiny ones, with a remainder of (2^32 - 1) / dy close to dy: dx, dy, from a to the centre of row 0, and f.
        let too_small_with_a_quarter =
            [(4_157, 9_629, 120, 211), (4_179, 9_629, 81, 206), (3_858, 9_929, 165, 252), (3_950, 9_812, 7, 177)];
        // On a row near the end M is a multiple of dy, or M + 1 is one.
        let too_large_with_three_quarters =
            [(-3_872, 9_929, 119, 0), (-4_140, 9_629, 57, 1), (-4_379, 9_437, 165, 1), (-4_705, 9_064, 177, 2)];
        for (dx, dy, down, f) in too_small_with_a_quarter.into_iter().chain(too_large_with_three_quarters) {
            let a = (20 * 256 + f + 128, 128 - down);
            let [solved, walked] = both([a, (a.0, a.1 + dy / 2), (a.0 + dx, a.1 + dy)], window);
            assert_eq!(walked, solved, "{dx} {dy} {down} {f}");
            assert!(solved.len() > 30, "{} rows", solved.len());
        }
    }

    #[test]
    fn ends_of_the_type() {
        let (low, high) = (i32::MIN, i32::MAX);
        let [solved, walked] = both([(low, low), (high, low), (low, high)], Rect::new(-3, -2, 4, 2));
        assert_eq!(solved, [(-2, -3, 1), (-1, -3, 0), (0, -3, -1), (1, -3, -2)]);
        assert_eq!(walked, solved);
    }
}
