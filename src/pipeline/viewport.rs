//! From clip coordinates to pixels.

use super::vertex::Vertex;
use crate::{
    geom::{space::Vec4, PointFx},
    num::{
        cast::{magnitude, saturate},
        divisor::WideDivisor,
    },
};

/// The picture: its size in pixels.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) struct Screen {
    pub(super) width: u16,
    pub(super) height: u16,
}

impl Screen {
    /// The largest picture each way.
    const MOST: u16 = 4096;
    /// How far from the middle of the picture a corner may lie, in half pixels: what a [`Facet`](crate::geom::Facet) may have, half
    /// of it each way, in both directions, less what rounding may add.
    pub(super) const GUARD: i64 = 6_143;

    pub(super) const fn new(width: u16, height: u16) -> Self {
        const fn least(n: u16) -> u16 {
            if n < Screen::MOST {
                n
            } else {
                Screen::MOST
            }
        }
        Self { width: least(width), height: least(height) }
    }

    /// Where three corners lie on the screen. `None` if one has no w above 0, which only happens where all its coordinates are 0.
    #[inline]
    pub(super) fn places<V>(self, corners: &[Vertex<V>; 3]) -> Option<[PointFx; 3]> {
        let [a, b, c] = corners.each_ref().map(|corner| corner.position);
        Some([self.place(a)?, self.place(b)?, self.place(c)?])
    }

    /// Where a corner in the guard band lies.
    ///
    /// Products: a coordinate below 2^31 times 128 times a size of up to 2^12 is below 2^50.
    #[inline(never)]
    fn place(self, at: Vec4) -> Option<PointFx> {
        let [x, y, _, w] = at.to_bits().map(i64::from);
        if w <= 0 {
            return None;
        }
        let divisor = WideDivisor::new(magnitude(w));
        let part = |n: i64, size: u16| {
            let half = i64::from(size).wrapping_mul(128);
            let (q, _) = divisor.quotient(n.wrapping_mul(half).wrapping_add(w >> 1));
            saturate(q.wrapping_add(half))
        };
        Some(PointFx::from_bits(part(x, self.width), part(y.wrapping_neg(), self.height)))
    }
}

/// Twice the area of a triangle on the screen, positive when its corners turn clockwise there. The corners lie in the guard band.
#[inline]
pub(super) fn turn([a, b, c]: [PointFx; 3]) -> i64 {
    let from = |p: PointFx| {
        let ((px, py), (ax, ay)) = ((p.x.to_bits(), p.y.to_bits()), (a.x.to_bits(), a.y.to_bits()));
        (i64::from(px.wrapping_sub(ax)), i64::from(py.wrapping_sub(ay)))
    };
    let ((bx, by), (cx, cy)) = (from(b), from(c));
    bx.wrapping_mul(cy).wrapping_sub(by.wrapping_mul(cx))
}
