//! [`Triangle`]: rasterization, and the fragment stage.

use embedded_graphics_core::geometry::Point;

use super::{
    depth::{self, DepthOf},
    vertex::{Facing, Vertex},
    viewport::Projected,
};
use crate::{
    geom::{At, Facet, PointFx, Varying},
    paint::{self, shade},
    span::Rect,
    surface::{Frame, Rows, Surface},
};

/// A triangle on the screen.
#[derive(Copy, Clone, Debug)]
pub struct Triangle<V> {
    pub(super) projected: [Projected; 3],
    pub(super) corners: [Vertex<V>; 3],
    pub(super) facing: Facing,
    pub(super) number: u32,
}

/// A pixel of a triangle, a line or a point, as the fragment stage sees it.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Fragment<V, D = ()> {
    /// The pixel.
    pub at: Point,
    /// What changes over the triangle, as it is at the centre of the pixel; what changes along a line; what belongs to a point.
    pub values: V,
    /// How far away it is, if there is a depth buffer.
    pub depth: D,
    /// Which side of the triangle is seen. Lines and points look like fronts.
    pub facing: Facing,
    /// The number of the triangle, the line or the point, from 1 on.
    pub number: u32,
}

impl<V> Triangle<V> {
    /// Where its corners are on the screen.
    #[inline]
    pub const fn places(&self) -> [PointFx; 3] {
        let [a, b, c] = &self.projected;
        [a.place, b.place, c.place]
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
        let Ok(facet) = Facet::new(self.places()) else { return };
        let (Self { facing, number, .. }, places) = (*self, self.places());
        let values = self.corners.each_ref().map(|corner| (At::default(), corner.values));
        shade::fill_some(on, (places, &facet), values, |(At(at), values)| {
            fragment(Fragment { at, values, depth: (), facing, number })
        });
    }

    /// Fills the pixels whose depth passes a test, such as [`less`](crate::paint::depth::less), and keeps their depths: z / w, from 0
    /// at the near plane to the largest number at the far one. A pixel that the fragment stage leaves as it is keeps its depth.
    pub fn fill_depth<S: Surface, M: AsMut<[u8]>, Z: DepthOf>(
        &self,
        on: &mut S,
        depth: &mut Frame<M, Rows<Z>>,
        passes: impl Fn(&Z::Number, &Z::Number) -> bool,
        fragment: impl FnMut(Fragment<V, Z::Number>) -> Option<S::Color>,
    ) {
        self.fill_depths(on, depth, |_, depths| depths, passes, fragment);
    }

    /// [`fill_depth`](Self::fill_depth), set back a little, so that lines along its sides are in front of it: for pictures of lines
    /// without those that are hidden. Fill the triangles so, in the colour of the background, then draw lines with
    /// [`less_equal`](crate::paint::depth::less_equal).
    ///
    /// All depths are larger by m + 1, where m is the most that the triangle's depth changes within half a pixel each way, and not more
    /// than it changes over the whole triangle. The centre of a pixel of a line lies beside the line by half a pixel each way at most.
    /// So its depth is not more than m away from that of the triangle there, and no triangle hides a side of its own. Depths stop at
    /// the largest one. Of a triangle that is seen nearly edge-on, m is large, and a line close behind it may be seen.
    pub fn fill_behind<S: Surface, M: AsMut<[u8]>, Z: DepthOf>(
        &self,
        on: &mut S,
        depth: &mut Frame<M, Rows<Z>>,
        passes: impl Fn(&Z::Number, &Z::Number) -> bool,
        fragment: impl FnMut(Fragment<V, Z::Number>) -> Option<S::Color>,
    ) {
        let set_back = |facet: &Facet, depths: [u32; 3]| depth::set_back::<Z>(depths, facet.steepness(depths));
        self.fill_depths(on, depth, set_back, passes, fragment);
    }

    /// With depths that are made of those of the corners.
    #[inline(always)]
    fn fill_depths<S: Surface, M: AsMut<[u8]>, Z: DepthOf>(
        &self,
        on: &mut S,
        depth: &mut Frame<M, Rows<Z>>,
        change: impl FnOnce(&Facet, [u32; 3]) -> [u32; 3],
        passes: impl Fn(&Z::Number, &Z::Number) -> bool,
        mut fragment: impl FnMut(Fragment<V, Z::Number>) -> Option<S::Color>,
    ) {
        if !self.reaches(on.window()) {
            return;
        }
        // It lies in the guard band, where every triangle is a facet.
        let Ok(facet) = Facet::new(self.places()) else { return };
        let [a, b, c] = &self.corners;
        let [d, e, f] = change(&facet, self.projected.each_ref().map(depth::of::<Z>)).map(Z::number);
        let at = At::default();
        let values = [(d, (at, a.values)), (e, (at, b.values)), (f, (at, c.values))];
        let (Self { facing, number, .. }, places) = (*self, self.places());
        paint::depth::fill_some((on, depth), (places, &facet), values, passes, |(At(at), values), depth| {
            fragment(Fragment { at, values, depth, facing, number })
        });
    }

    /// Whether its box and a window have pixels in common. Of a band most triangles have none: their values are not asked for.
    #[inline]
    fn reaches(&self, window: Rect) -> bool {
        let [a, b, c] = self.places().map(|place| (place.x.to_bits() >> 8, place.y.to_bits() >> 8));
        let overlap = |a: i32, b: i32, c: i32, from: i32, to: i32| a.min(b).min(c) < to && a.max(b).max(c) >= from;
        overlap(a.0, b.0, c.0, window.x0, window.x1) && overlap(a.1, b.1, c.1, window.y0, window.y1)
    }
}
