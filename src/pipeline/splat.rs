//! [`Splat`]: rasterization of points, and their fragment stage.
//!
//! A point on the screen is drawn as a square or a disc of any size around its place, to 1/256 pixel, which faces the eye: all of it
//! has the depth and the values of the point. A pixel belongs to it when its *centre* lies inside.
//! - Of a square, centres on the left and upper sides are inside: the pixels of
//!   [`fill_square_point_fx`](crate::Canvas::fill_square_point_fx), which are a rectangle. A square of a whole number of pixels n has
//!   n x n of them, wherever it is; of a size below 1 it may have none.
//! - Of a disc, centres on the left half of the circle are inside: the pixels of
//!   [`fill_round_point_fx`](crate::Canvas::fill_round_point_fx), which are those of a filled ellipse with these diameters.
//!
//! A point is left out if its place lies in front of the near plane, beyond the far one, or outside of the guard band: then none of
//! it is drawn. All others are drawn as far as the window shows them, also if their places lie outside of the picture.

use embedded_graphics_core::geometry::Point;
use fixed::types::I24F8;

use super::{
    depth::{self, DepthOf},
    draw::Fragment,
    vertex::{Facing, Vertex},
    viewport::Projected,
};
use crate::{
    geom::PointFx,
    raster::{
        ellipse::{self, Ellipse},
        rectangle,
    },
    span::{ClippedSpan, Rect},
    surface::{DepthCell, Frame, Inside, Rows, Said, Surface},
};

/// A point on the screen.
#[derive(Copy, Clone, Debug)]
pub struct Splat<V> {
    pub(super) projected: Projected,
    pub(super) vertex: Vertex<V>,
    pub(super) number: u32,
}

/// What a point looks like, and how large it is: a side or a diameter, to 1/256 pixel. A number that is not positive is no pixel.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Dot {
    /// A square.
    Square(I24F8),
    /// A disc.
    Round(I24F8),
}

impl Dot {
    /// The spans of its pixels.
    #[inline(always)]
    fn fill(self, at: PointFx, window: Rect, emit: impl FnMut(ClippedSpan)) {
        match self {
            Self::Square(size) => rectangle::fill(ellipse::square(at, size), window, emit),
            Self::Round(size) => ellipse::fill(Ellipse::splat(at, size), window, emit),
        }
    }
}

impl<V> Splat<V> {
    /// Where it is on the screen.
    #[inline]
    pub const fn place(&self) -> PointFx {
        self.projected.place
    }

    /// What the vertex stage made of it.
    #[inline]
    pub const fn vertex(&self) -> &Vertex<V> {
        &self.vertex
    }

    /// Its number: the first point that the pipeline was given has 1, whether that one was seen or not.
    #[inline]
    pub const fn number(&self) -> u32 {
        self.number
    }
}

impl<V: Copy> Splat<V> {
    /// Draws it. The fragment stage gives each pixel a colour, or `None` to leave it as it is.
    pub fn draw<S: Surface>(&self, dot: Dot, on: &mut S, mut fragment: impl FnMut(Fragment<V>) -> Option<S::Color>) {
        dot.fill(self.place(), on.window(), |span| {
            on.write_inside(Inside(Said::Span(span)), |x| fragment(self.fragment(Point::new(x, span.y()), ())));
        });
    }

    /// Draws it where its depth passes a test, such as [`less`](crate::paint::depth::less), and keeps its depth there. A pixel that
    /// the fragment stage leaves as it is keeps its own.
    pub fn draw_depth<S: Surface, M: AsMut<[u8]>, Z: DepthOf>(
        &self,
        dot: Dot,
        on: &mut S,
        depth: &mut Frame<M, Rows<Z>>,
        passes: impl Fn(&Z::Number, &Z::Number) -> bool,
        mut fragment: impl FnMut(Fragment<V, Z::Number>) -> Option<S::Color>,
    ) {
        let number = Z::number(depth::of::<Z>(&self.projected));
        // Where there are no depths, nothing is painted.
        let window = on.window().intersection(depth.window());
        dot.fill(self.place(), window, |span| {
            let Some(cells) = depth.cells(span) else { return };
            let mut cells = cells.iter_mut();
            on.write_inside(Inside(Said::Span(span)), |x| {
                let cell = cells.next().filter(|cell| passes(&number, &cell.load()))?;
                let color = fragment(self.fragment(Point::new(x, span.y()), number))?;
                *cell = Z::Cell::store(number);
                Some(color)
            });
        });
    }

    #[inline(always)]
    fn fragment<D>(&self, at: Point, depth: D) -> Fragment<V, D> {
        Fragment { at, values: self.vertex.values, depth, facing: Facing::Front, number: self.number }
    }
}
