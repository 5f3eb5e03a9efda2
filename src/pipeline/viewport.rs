//! From clip coordinates to pixels.

use super::vertex::Vertex;
use crate::{
    geom::{space::Vec4, PointFx},
    num::{
        cast::{magnitude, saturate},
        divisor::WideDivisor,
    },
    span::Rect,
};

/// The picture: its size in pixels.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) struct Screen {
    pub(super) width: u16,
    pub(super) height: u16,
}

impl Screen {
    /// The largest picture each way.
    pub(super) const MOST: u16 = 4096;
    /// How far from the middle of the picture a corner may lie, in half pixels: what a [`Facet`](crate::geom::Facet) may have, half
    /// of it each way, in both directions, less what rounding and the pixels around a line may add.
    pub(super) const GUARD: i64 = 6_140;

    /// Its pixels.
    pub(super) fn window(self) -> Rect {
        Rect::new(0, 0, self.width.into(), self.height.into())
    }

    /// A vertex in the guard band, projected.
    #[inline(always)]
    pub(super) fn corner<V>(self, vertex: Vertex<V>) -> Option<Corner<V>> {
        Some(Corner { projected: self.project(vertex.position)?, vertex })
    }

    /// Three of them.
    #[inline(always)]
    pub(super) fn corners<V>(self, [a, b, c]: [Vertex<V>; 3]) -> Option<[Corner<V>; 3]> {
        Some([self.corner(a)?, self.corner(b)?, self.corner(c)?])
    }

    /// Two of them.
    #[inline(always)]
    pub(super) fn ends<V>(self, [a, b]: [Vertex<V>; 2]) -> Option<[Corner<V>; 2]> {
        Some([self.corner(a)?, self.corner(b)?])
    }

    /// Where a place in the guard band lies, in clip coordinates or some power of two times as much. `None` if its w is not above 0, which only happens where all its coordinates are 0.
    ///
    /// Products: a coordinate below 2^31 times 128 times a size of up to 2^12 is below 2^50.
    #[inline(never)]
    pub(super) fn project(self, at: Vec4) -> Option<Projected> {
        let [x, y, _, w] = at.to_bits().map(i64::from);
        if w <= 0 {
            return None;
        }
        let w = WideDivisor::new(magnitude(w));
        let part = |n: i64, size: u16| {
            let half = i64::from(size).wrapping_mul(128);
            saturate(w.nearest(n.wrapping_mul(half)).wrapping_add(half))
        };
        let place = PointFx::from_bits(part(x, self.width), part(y.wrapping_neg(), self.height));
        Some(Projected { place, z: at.z.to_bits(), w })
    }
}

/// A vertex after the perspective divide.
#[derive(Copy, Clone)]
pub(super) struct Corner<V> {
    pub(super) vertex: Vertex<V>,
    pub(super) projected: Projected,
}

/// Where it is.
#[derive(Copy, Clone, Debug)]
pub(super) struct Projected {
    /// Where it is on the screen.
    pub(super) place: PointFx,
    /// How far away it is, before the division.
    pub(super) z: i32,
    /// What it was divided by, and z has to be.
    pub(super) w: WideDivisor,
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
