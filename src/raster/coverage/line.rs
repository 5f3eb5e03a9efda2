//! Lines one pixel wide, with soft rims.
//!
//! The line from a to b is the rectangle one pixel wide around it, cut off at right angles at a and at b. Its corners are half a
//! pixel beside these places, rounded to the nearest 1/256 pixel: so it is at most 0.6 % thicker or thinner than a pixel. What it
//! covers of the pixels across it adds up to a pixel at any angle, and it is as bright at one angle as at another.

use super::{fill::fill, slot::CoverageSlot};
use crate::{
    geom::{bits, fill_rule::FillRule, PointFx},
    num::{
        cast::{low_u32, signed},
        recip::inverse_root_wide,
    },
    span::{Rect, Sink},
};

/// Tells what a line one pixel wide covers, from one place to another; nothing if they are the same.
///
/// Cannot fail: four slots are enough. Each pixel is told once.
pub fn line(a: PointFx, b: PointFx, cells: &mut [i32], window: Rect, sink: impl Sink) {
    let Some((x, y)) = beside(a, b) else { return };
    let moved = |v: PointFx, by: fn(i32, i32) -> i32| PointFx::from_bits(by(bits(v).0, x), by(bits(v).1, y));
    let corners = [(a, false), (b, false), (b, true), (a, true)]
        .map(|(v, back)| moved(v, if back { i32::saturating_sub } else { i32::saturating_add }));
    let mut table = [CoverageSlot::EMPTY; 4];
    fill([corners], FillRule::NonZero, &mut table, cells, window, sink).unwrap_or(());
}

/// Half a pixel to one side of the line from a to b, at right angles to it. `None` if they are the same place.
fn beside(a: PointFx, b: PointFx) -> Option<(i32, i32)> {
    let (a, b) = (bits(a), bits(b));
    let (x, y) = (b.0.abs_diff(a.0), b.1.abs_diff(a.1));
    // With 31 bits in the larger one the sum of the squares is at least 2^60 and below 2^63.
    let up = (x | y).leading_zeros();
    let scaled = |n: u32| u64::from(n.checked_shl(up).unwrap_or(0) >> 1);
    let (x, y) = (scaled(x), scaled(y));
    let square = x.wrapping_mul(x).wrapping_add(y.wrapping_mul(y));
    if square == 0 {
        return None;
    }
    // 1 / length is `root 2^(shift / 2 - 62)`, with a shift of 0 or 2; half a pixel are 2^7 units.
    let (root, shift) = inverse_root_wide(square);
    let down = 55_u32.wrapping_sub(shift >> 1) & 63;
    let part = |n: u64| signed(low_u32(n.wrapping_mul(root.into()).wrapping_add(1 << (down - 1)) >> down));
    let with_sign = |n: i32, is_negative: bool| if is_negative { n.wrapping_neg() } else { n };
    Some((with_sign(part(y), b.1 >= a.1), with_sign(part(x), b.0 < a.0)))
}
