//! [`Triangle`]: rasterization, and the fragment stage.

use embedded_graphics_core::geometry::Point;

use super::vertex::{Facing, Vertex};
use crate::{
    canvas::Canvas,
    geom::{At, Facet, Plane, PointFx, Varying},
    num::{cast::magnitude, divisor::WideDivisor},
    paint::{DepthShade, ShadeSome},
    raster::triangle,
    span::Rect,
    surface::{Depth, Frame, Rows, Surface},
};

/// A triangle on the screen.
#[derive(Copy, Clone, Debug)]
pub struct Triangle<V> {
    pub(super) places: [PointFx; 3],
    pub(super) corners: [Vertex<V>; 3],
    pub(super) facing: Facing,
    pub(super) number: u32,
}

/// A pixel of a triangle, as the fragment stage sees it.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Fragment<V, D = ()> {
    /// The pixel.
    pub at: Point,
    /// What changes over the triangle, as it is at the centre of the pixel.
    pub values: V,
    /// How far away it is, of a triangle that is drawn with a depth buffer.
    pub depth: D,
    /// Which side of the triangle is seen.
    pub facing: Facing,
    /// The number of the triangle, from 1 on.
    pub number: u32,
}

impl<V> Triangle<V> {
    /// Where its corners are on the screen.
    #[inline]
    pub const fn places(&self) -> [PointFx; 3] {
        self.places
    }

    /// What the vertex stage made of its corners; of a triangle that was cut, what lies between.
    #[inline]
    pub const fn corners(&self) -> &[Vertex<V>; 3] {
        &self.corners
    }

    /// Which side of it is seen.
    #[inline]
    pub const fn facing(&self) -> Facing {
        self.facing
    }

    /// Its number: the first triangle that the pipeline was given has 1, whether that one was seen or not.
    #[inline]
    pub const fn number(&self) -> u32 {
        self.number
    }
}

impl<V: Varying> Triangle<V> {
    /// Fills it. The fragment stage gives each pixel a colour, or `None` to leave it as it is.
    ///
    /// Values change linearly *on the screen*. That is right for colours of small triangles and wrong for textures of large ones
    /// that lead into the distance.
    pub fn fill<S: Surface>(&self, on: &mut S, mut fragment: impl FnMut(Fragment<V>) -> Option<S::Color>) {
        if !self.reaches(on.window()) {
            return;
        }
        let Some(plane) = self.plane(|corner| (At::default(), corner.values)) else { return };
        let Self { facing, number, places, .. } = *self;
        let shade =
            ShadeSome::new(plane, |(At(at), values)| fragment(Fragment { at, values, depth: (), facing, number }));
        on.paint(shade, |window, brush| triangle::fill(places, window, brush));
    }

    /// Fills the pixels whose depth passes a test, such as [`less`](crate::paint::depth::less), and keeps their depths: z / w, from 0
    /// at the near plane to the largest number at the far one. A pixel that the fragment stage leaves as it is keeps its depth.
    pub fn fill_depth<S: Surface, M: AsMut<[u8]>, Z: DepthOf>(
        &self,
        on: &mut S,
        depth: &mut Frame<M, Rows<Z>>,
        passes: impl Fn(&Z::Number, &Z::Number) -> bool,
        mut fragment: impl FnMut(Fragment<V, Z::Number>) -> Option<S::Color>,
    ) {
        if !self.reaches(on.window()) {
            return;
        }
        let plane = self.plane(|corner| {
            (Z::of(corner.position.z.to_bits(), corner.position.w.to_bits()), (At::default(), corner.values))
        });
        let Some(plane) = plane else { return };
        let Self { facing, number, places, .. } = *self;
        let shade = DepthShade::new(depth, plane, passes, |(At(at), values), depth| {
            fragment(Fragment { at, values, depth, facing, number })
        });
        on.paint(shade, |window, brush| triangle::fill(places, window, brush));
    }

    /// Whether its box and a window have pixels in common. Of a band most triangles have none: their values are not asked for.
    #[inline]
    fn reaches(&self, window: Rect) -> bool {
        let [a, b, c] = self.places.map(|place| (place.x.to_bits() >> 8, place.y.to_bits() >> 8));
        let overlap = |a: i32, b: i32, c: i32, from: i32, to: i32| a.min(b).min(c) < to && a.max(b).max(c) >= from;
        overlap(a.0, b.0, c.0, window.x0, window.x1) && overlap(a.1, b.1, c.1, window.y0, window.y1)
    }

    /// The values over it. It lies in the guard band, where every triangle is a facet.
    #[inline(always)]
    fn plane<W: Varying>(&self, of: impl FnMut(&Vertex<V>) -> W) -> Option<Plane<W>> {
        let facet = Facet::new(self.places).ok()?;
        Some(Plane::new(&facet, self.corners.each_ref().map(of)))
    }
}

/// Depths that the pipeline makes of z and w.
pub trait DepthOf: Depth {
    /// The nearest depth to `MAX z / w`, for z from 0 to w.
    #[doc(hidden)]
    fn of(z: i32, w: i32) -> Self::Number;
}

macro_rules! depth_of {
    ($depth:ty, $number:ty) => {
        impl DepthOf for $depth {
            #[inline]
            fn of(z: i32, w: i32) -> $number {
                let (z, w) = (i64::from(z.clamp(0, w.max(0))), i64::from(w.max(1)));
                // Below 2^63: 2^31 times 2^32.
                let n = z.wrapping_mul(<$number>::MAX.into()).wrapping_add(w >> 1);
                let (q, _) = WideDivisor::new(magnitude(w)).quotient(n);
                <$number>::try_from(q).unwrap_or(<$number>::MAX)
            }
        }
    };
}

depth_of!(crate::pixel::Depth16, u16);
depth_of!(crate::pixel::Depth32, u32);
