//! [`Bends`]: is a part of a curve flat, does it bend evenly, does it lie beside the view?
//!
//! The letters are those of [`flatten`](super).

use core::num::NonZeroU32;

use crate::{
    geom::{
        point::{bits, PointFx},
        view::View,
    },
    num::{
        cast::{signed, unsigned},
        round::div_rem_wide,
    },
};

/// 4 D is `2^7` units for strokes.
const FOUR_D_BITS: u32 = 7;
/// Strokes up to this width, in units, are thin.
pub(crate) const THIN: u32 = 320;

/// W(1/3) and W(2/3) of a part. A coordinate that does not fit is the largest there is.
pub(super) struct Bends(pub(super) (i32, i32), pub(super) (i32, i32));

impl Bends {
    /// How many pieces the part between two places is cut into; 0 if it is halved instead. 4 D is `2^tolerance`.
    ///
    /// Coordinates of W and of the chord are below 2^15: sums of two products fit 31 bits.
    #[inline(always)]
    pub(super) fn pieces(&self, from: PointFx, to: PointFx, tolerance: u32, width: u32) -> u32 {
        let &Self(first, second) = self;
        if !are_small(first, second) {
            return 0;
        }
        if width != 0 {
            return u32::from(self.is_flat_beside(from, to, width));
        }
        let (c, scale) = chord(bits(from), bits(to));
        let square = product(c, c);
        let flat = |w: (i32, i32)| {
            let least = 1_u32.wrapping_shl(tolerance.wrapping_mul(2));
            if square < least {
                return product(w, w) <= least;
            }
            let across = cross(w, c).unsigned_abs().wrapping_shr(tolerance);
            let along = product(w, c).wrapping_shr(scale);
            along <= square && across >> 16 == 0 && across.wrapping_mul(across) <= square
        };
        if flat(first) && flat(second) {
            return 1;
        }
        // W is linear: W(0) = 2 W(1/3) - W(2/3), and W(1) = 2 W(2/3) - W(1/3).
        let on = |p: i32, q: i32| p.wrapping_mul(2).wrapping_sub(q);
        let start = (on(first.0, second.0), on(first.1, second.1));
        let end = (on(second.0, first.0), on(second.1, first.1));
        if !are_small(start, end) {
            return 0;
        }
        let longer = product(start, start).max(product(end, end));
        let mut pieces = 1_u32;
        // The lowest m with |W| <= 4 D m^2, both sides squared.
        while pieces.wrapping_mul(pieces).wrapping_shl(tolerance).wrapping_pow(2) < longer {
            pieces = pieces.wrapping_add(1);
        }
        let (p, q) = (cross(start, c), cross(end, c));
        let across = u64::from(p.unsigned_abs().min(q.unsigned_abs()));
        let even = p ^ q >= 0 && across.wrapping_mul(across) > u64::from(longer).wrapping_mul(u64::from(square)) >> 4;
        if pieces == 2 || even && pieces <= 16 {
            pieces
        } else {
            0
        }
    }

    /// Whether the part between two places is flat, and so are the borders of a stroke beside it. Coordinates of W are below 2^15.
    #[inline(never)]
    fn is_flat_beside(&self, from: PointFx, to: PointFx, width: u32) -> bool {
        let &Self(first, second) = self;
        if product(first, first) <= 64 && product(second, second) <= 64 {
            return true;
        }
        let (c, scale) = chord(bits(from), bits(to));
        let longer = c.0.unsigned_abs().max(c.1.unsigned_abs());
        let Some(square) = NonZeroU32::new(product(c, c)) else { return false };
        let is_along = |w: (i32, i32)| product(w, c).wrapping_shr(scale) <= square.get();
        if !(is_along(first) && is_along(second)) {
            return false;
        }
        let across = |w: (i32, i32)| {
            let product = |a: i32, b: i32| i64::from(a).wrapping_mul(i64::from(b));
            product(w.0, c.1).wrapping_sub(product(w.1, c.0))
        };
        // The ways at the ends are c - W(1/3) and c + W(2/3): how far they go along c, times its length. Below 2^33.
        let mean = i64::from(square.get());
        let speeds = [
            mean.wrapping_sub(dot(first, c).wrapping_shr(scale)),
            mean.wrapping_add(dot(second, c).wrapping_shr(scale)),
        ];
        // W and c are rounded.
        let rounding = u64::from(c.0.unsigned_abs()).wrapping_add(c.1.unsigned_abs().into());
        let angle = |w: (i32, i32), speed: i64| {
            let speed = NonZeroU32::new(u32::try_from(speed).ok()?)?;
            let across = (across(w).unsigned_abs().wrapping_add(rounding) << 12).wrapping_shr(scale);
            (across < u64::from(speed.get()) << 12).then(|| div_rem_wide(across, speed).0)
        };
        let (Some(start), Some(end)) = (angle(first, speeds[0]), angle(second, speeds[1])) else { return false };
        let is_slow = speeds.iter().any(|&speed| speed.wrapping_mul(4) < mean.wrapping_mul(3));
        // Where the inner border may turn back, and where it is slow, it does not turn unevenly.
        let wide = u64::from(width);
        let sharp = wide.wrapping_mul(u64::from(start.wrapping_add(end))) >> 13;
        if (is_slow || sharp.wrapping_shr(scale) >= u64::from(longer))
            && wide.wrapping_mul(start.abs_diff(end).into()) > 64 << 12
        {
            return false;
        }
        // 4 (D - w m^2 / 4), rounded up.
        let down = if width <= THIN { 20 } else { 24 };
        let most = u64::from(start.max(end));
        let turned = most.wrapping_mul(most).wrapping_mul(wide).wrapping_shr(down);
        // At least a quarter of D is left for the curve itself.
        let Some(rest) = (1_u64 << FOUR_D_BITS).checked_sub(turned).filter(|&rest| rest >= 32) else { return false };
        let flat = |w: (i32, i32)| {
            let across = across(w).unsigned_abs();
            across.wrapping_mul(across) <= rest.wrapping_mul(rest).wrapping_mul(u64::from(square.get()))
        };
        flat(first) && flat(second)
    }

    /// Whether the part between two places, which has these bends, lies on one side of the view as a whole.
    pub(super) fn lie_beside(&self, view: &View, from: PointFx, to: PointFx) -> bool {
        let &Self((a, b), (c, d)) = self;
        let size = [b, c, d].into_iter().fold(a.unsigned_abs(), |size, n| size.max(n.unsigned_abs()));
        // It is within |W| / 4 of the chord, in x and in y alike; the 3 units are for the rounding of W and of both
        // ends.
        size < unsigned(i32::MAX) && view.hides(from, to, i64::from(size >> 2).wrapping_add(3))
    }
}

/// The scalar product of two vectors.
fn dot(a: (i32, i32), b: (i32, i32)) -> i64 {
    let product = |a: i32, b: i32| i64::from(a).wrapping_mul(i64::from(b));
    product(a.0, b.0).wrapping_add(product(a.1, b.1))
}

/// Whether all coordinates are from -2^15 to below 2^15.
#[inline(always)]
fn are_small(a: (i32, i32), b: (i32, i32)) -> bool {
    let beyond = |n: i32| unsigned(n).wrapping_add(1 << 15) >> 16;
    beyond(a.0) | beyond(a.1) | beyond(b.0) | beyond(b.1) == 0
}

/// The vector from one place to another, its coordinates in 15 bits and a sign, and how many low bits they lost for
/// that.
fn chord(from: (i32, i32), to: (i32, i32)) -> ((i32, i32), u32) {
    let (x, y) = (from.0.abs_diff(to.0), from.1.abs_diff(to.1));
    let lost = 17_u32.saturating_sub((x | y).leading_zeros());
    let side = |length: u32, back: bool| {
        let length = signed(length.wrapping_shr(lost));
        if back {
            length.wrapping_neg()
        } else {
            length
        }
    };
    ((side(x, to.0 < from.0), side(y, to.1 < from.1)), lost)
}

/// The cross product of two vectors.
#[inline(always)]
fn cross(a: (i32, i32), b: (i32, i32)) -> i32 {
    a.0.wrapping_mul(b.1).wrapping_sub(a.1.wrapping_mul(b.0))
}

/// The magnitude of the scalar product of two vectors.
#[inline(always)]
fn product(a: (i32, i32), b: (i32, i32)) -> u32 {
    a.0.wrapping_mul(b.0).wrapping_add(a.1.wrapping_mul(b.1)).unsigned_abs()
}
