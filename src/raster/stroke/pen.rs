//! [`Pen`]: what all sides, joins and caps of a stroke are made from.

use core::num::NonZeroU32;

use super::{
    direction::{with_sign, Direction},
    style::{Cap, Join, Stroke},
};
use crate::{
    geom::{bits, PointFx, View},
    num::{
        cast::{low_u32, magnitude, unsigned},
        round::{difference, div_rem_wide},
    },
    span::Rect,
    tune::COMPACT,
};

/// For widths up to the first number: cosine and sine, times 2^30, of the turn from one vertex of a fan to the next. The turns are
/// 1/8, 1/16 ... 1/2048 of a circle.
const TURNS: [(u32, (i32, i32)); 9] = [
    (192, (759_250_125, 759_250_125)),
    (768, (992_008_094, 410_903_207)),
    (3_072, (1_053_110_176, 209_476_638)),
    (12_288, (1_068_571_464, 105_245_103)),
    (49_152, (1_072_448_455, 52_686_014)),
    (196_608, (1_073_418_433, 26_350_943)),
    (786_432, (1_073_660_973, 13_176_464)),
    (3_145_728, (1_073_721_611, 6_588_356)),
    (u32::MAX, (1_073_736_771, 3_294_193)),
];

/// Whether [`Sight::hides`] looks at one place alone before it looks at the box around two: most places are seen, and that tells it sooner.
const LOOKS_FIRST: bool = !COMPACT;

/// What all pieces of a stroke are made from.
#[derive(Copy, Clone, Debug)]
pub struct Pen {
    /// At least the least width of the stroke.
    pub(super) width: u32,
    pub(super) cap: Cap,
    pub(super) join: Join,
    /// Square of the miter limit, in 2^-16.
    limit: u32,
    /// From one vertex of a fan to the next: cosine and sine.
    pub(super) turn: (i32, i32),
    /// How far from its line it may paint.
    pub(super) reach: u32,
    pub(super) sight: Sight,
    /// The rows of the window.
    pub(super) rows: (i32, i32),
}

/// Which parts of a stroke a window can show.
#[derive(Copy, Clone, Debug)]
pub struct Sight {
    /// The window, and as much around it as a side, a cap, or a join without a tip may reach.
    pub(super) near: View,
    /// The window, and as much around it as the tip of a miter may reach. Tips stand at corners, nowhere else.
    corners: View,
}

impl Sight {
    /// With so many units more around the window.
    pub(super) fn wider(self, units: u32) -> Self {
        Self { near: self.near.wider(units), corners: self.corners.wider(units) }
    }

    /// Whether what lies around two places, but for tips of miters, cannot be seen.
    pub(super) fn hides(&self, a: PointFx, b: PointFx) -> bool {
        !self.shows(a) && self.near.hides(a, b, 0)
    }

    /// Whether a place is known to be seen. In builds for size it is never asked, and the answer is `false`.
    pub(super) fn shows(&self, v: PointFx) -> bool {
        LOOKS_FIRST && self.near.holds(v)
    }

    /// Whether a join cannot be seen, whatever its kind.
    pub(super) fn hides_corner(&self, v: PointFx) -> bool {
        self.corners.hides(v, v, 0)
    }

    /// A lower bound for the distance of a place from what can be seen, but for tips of miters, in units of 2^-20 pixel.
    pub(super) fn beside(&self, v: PointFx) -> u64 {
        let ((x, y), [(x0, y0), (x1, y1)]) = (bits(v), self.near.corners());
        let beside = |n: i32, low: i32, high: i32| difference(low, n).max(difference(n, high));
        magnitude(beside(x, x0, x1).max(beside(y, y0, y1)).max(0)) << 12
    }
}

impl Pen {
    /// How wide a stroke is, in units: up to 2^24.
    #[inline]
    pub(super) fn width<D>(stroke: &Stroke<D>) -> u32 {
        unsigned(stroke.width.max(stroke.min_width).to_bits().clamp(0, 1 << 24))
    }

    /// For strokes that `window` may show.
    pub(super) fn new<D>(stroke: &Stroke<D>, window: Rect) -> Self {
        let width = Self::width(stroke);
        let limit = unsigned(stroke.miter_limit.to_bits().clamp(0, 0xffff));
        let turn = TURNS.iter().find(|&&(most, _)| width <= most).map_or((0, 0), |turn| turn.1);
        // Half the width for round joins, times the root of 2 for the corners of a square cap, the limit for a miter.
        let far = if matches!(stroke.join, Join::Miter) { limit.max(384) } else { 384 };
        let reach = |far: u32| low_u32(u64::from(width).wrapping_mul(u64::from(far)) >> 9).wrapping_add(2);
        let (near, reach) = (reach(384), reach(far));
        let sight = Sight { near: View::of(window, near), corners: View::of(window, reach) };
        Self {
            width,
            cap: stroke.cap,
            join: stroke.join,
            limit: limit.wrapping_mul(limit),
            turn,
            reach,
            sight,
            rows: (window.y0, window.y1),
        }
    }

    /// Where two offset borders meet, unless that is too far.
    pub(super) fn tip(&self, from: Direction, to: Direction) -> Option<(i32, i32)> {
        // 1 + cos, of 31 bits.
        let c = (from.dot(to) >> 30).wrapping_add(1 << 30);
        let near = c > 0 && u64::from(self.limit).wrapping_mul(magnitude(c)) >= 1 << 47;
        let c = NonZeroU32::new(low_u32(magnitude(c))).filter(|_| near)?;
        let reach = |p: i32, q: i32| tip_of(self.width, i64::from(p).wrapping_add(q.into()), c);
        Some((reach(from.x, to.x), reach(from.y, to.y)))
    }
}

/// A coordinate of a tip: `w sum / 2 c`, rounded to nearest.
#[cfg_attr(embedded_raster_compact, inline(never))]
fn tip_of(width: u32, sum: i64, c: NonZeroU32) -> i32 {
    let n = u64::from(width).wrapping_mul(sum.unsigned_abs()).wrapping_add(u64::from(c.get()));
    with_sign(div_rem_wide(n >> 1, c).0, sum)
}
