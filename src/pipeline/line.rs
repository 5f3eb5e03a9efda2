//! [`Line`]: rasterization of lines, and their fragment stage.
//!
//! A line on the screen has the pixels of [`line_fx`]: those of a straight line between two places in 24.8. What changes from one
//! end to the other is found as [`along`] says: at each pixel, the nearest value to the exact ratio along the line. Depths are
//! tested and kept as those of triangles are.

use super::{
    depth::{self, DepthOf},
    draw::Fragment,
    vertex::{Facing, Vertex},
    viewport::Projected,
};
use crate::{
    geom::{At, PointFx, Varying},
    paint::{along, DepthShade, ShadeSome},
    raster::line_fx,
    span::ClippedSpan,
    surface::{Frame, Rows, Surface},
};

/// A line on the screen, one pixel wide.
#[derive(Copy, Clone, Debug)]
pub struct Line<V> {
    pub(super) projected: [Projected; 2],
    pub(super) ends: [Vertex<V>; 2],
    pub(super) number: u32,
}

impl<V> Line<V> {
    /// Where its ends are on the screen.
    #[inline]
    pub const fn places(&self) -> [PointFx; 2] {
        let [a, b] = &self.projected;
        [a.place, b.place]
    }

    /// What the vertex stage made of its ends; of a line that was cut, what lies between.
    #[inline]
    pub const fn ends(&self) -> &[Vertex<V>; 2] {
        &self.ends
    }

    /// Its number: the first line that the pipeline was given has 1, whether that one was seen or not.
    #[inline]
    pub const fn number(&self) -> u32 {
        self.number
    }
}

impl<V: Varying> Line<V> {
    /// Draws it. The fragment stage gives each pixel a colour, or `None` to leave it as it is.
    pub fn draw<S: Surface>(&self, on: &mut S, mut fragment: impl FnMut(Fragment<V>) -> Option<S::Color>) {
        let ([a, b], number) = (self.places(), self.number);
        let values = self.ends.each_ref().map(|end| (At::default(), end.values));
        // It lies in the guard band, where no line is too long.
        _ = along::parts([a, b], values, on.window(), |plane, window| {
            let mut shade = ShadeSome::new(plane, |(At(at), values)| {
                fragment(Fragment { at, values, depth: (), facing: Facing::Front, number })
            });
            line_fx::draw(a, b, window, |span: ClippedSpan| shade.row(on, span));
        });
    }

    /// Draws the pixels whose depth passes a test, such as [`less_equal`](crate::paint::depth::less_equal), and keeps their depths. A
    /// pixel that the fragment stage leaves as it is keeps its depth.
    ///
    /// Along the side of a triangle that was filled, a line fights with it for each pixel. One that is to be seen wants the triangle
    /// set back: [`Triangle::fill_behind`](super::Triangle::fill_behind).
    pub fn draw_depth<S: Surface, M: AsMut<[u8]>, Z: DepthOf>(
        &self,
        on: &mut S,
        depth: &mut Frame<M, Rows<Z>>,
        passes: impl Fn(&Z::Number, &Z::Number) -> bool,
        mut fragment: impl FnMut(Fragment<V, Z::Number>) -> Option<S::Color>,
    ) {
        let ([a, b], number, [first, last], [p, q]) = (self.places(), self.number, &self.ends, &self.projected);
        let values = [(first, p), (last, q)]
            .map(|(end, projected)| (Z::number(depth::of::<Z>(projected)), (At::default(), end.values)));
        let window = on.window().intersection(depth.window());
        _ = along::parts([a, b], values, window, |plane, window| {
            let mut shade = DepthShade::new(depth, plane, &passes, |(At(at), values), depth| {
                fragment(Fragment { at, values, depth, facing: Facing::Front, number })
            });
            line_fx::draw(a, b, window, |span: ClippedSpan| shade.row(on, span));
        });
    }
}
