//! [`Plane`]: values at every pixel of a triangle, and [`Rows`], which finds them from the top down.

use super::traits::Varying;
use crate::{
    geom::facet::Facet,
    num::cast::{signed, unsigned},
};

/// The values of a [`Varying`] at all pixels of a triangle.
#[derive(Copy, Clone, Debug)]
pub struct Plane<V: Varying> {
    first: (i32, i32),
    slopes: V::Slopes,
}

impl<V: Varying> Plane<V> {
    /// With these values at the corners.
    #[inline]
    pub fn new(facet: &Facet, corners: [V; 3]) -> Self {
        Self { first: facet.first(), slopes: V::slopes(facet, corners) }
    }

    /// The value at a pixel of the triangle. Outside of the triangle's box it means nothing.
    #[inline]
    pub fn at(&self, x: i32, y: i32) -> V {
        V::value(&Rows::new(*self, y).run(x, 1))
    }

    /// Calls `f` with the values of `n` pixels of the triangle, from (x, y) to the right.
    /// ```
    /// use embedded_raster::{geom::{Facet, Plane}, PointFx};
    /// let facet = Facet::new([PointFx::px(0, 0), PointFx::px(4, 0), PointFx::px(0, 4)])?;
    /// let mut values = vec![];
    /// Plane::new(&facet, [0_u8, 80, 0]).each(0, 1, 2, |value| values.push(value));
    /// assert_eq!(values, [10, 30]);
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[inline]
    pub fn each(&self, mut x: i32, y: i32, mut n: u32, mut f: impl FnMut(V)) {
        let rows = Rows::new(*self, y);
        let mut run = rows.run(x, n.max(1));
        loop {
            let part = n.min(rows.reach());
            for _ in 0..part {
                f(V::value(&run));
                V::step(&mut run);
            }
            (x, n) = (x.wrapping_add(signed(part)), n.wrapping_sub(part));
            if n == 0 {
                return;
            }
            rows.go_on(&mut run, (x, y), n);
        }
    }

    /// For how many pixels a run is right.
    #[inline(always)]
    pub(crate) fn reach(&self) -> u32 {
        V::reach(&self.slopes).max(1)
    }

    /// The first row of the triangle's box.
    #[inline(always)]
    pub(crate) const fn top(&self) -> i32 {
        self.first.1
    }
}

impl<A: Varying, B: Varying> Plane<(A, B)> {
    /// Each by itself.
    #[inline(always)]
    pub(crate) fn split(self) -> (Plane<A>, Plane<B>) {
        let Self { first, slopes: (a, b) } = self;
        (Plane { first, slopes: a }, Plane { first, slopes: b })
    }
}

/// The rows of a plane, to be asked for from the top down.
#[derive(Copy, Clone, Debug)]
pub(crate) struct Rows<V: Varying> {
    plane: Plane<V>,
    y: i32,
    row: V::Row,
}

impl<V: Varying> Rows<V> {
    /// At the first row of a triangle's box, with these values at its corners.
    #[inline(always)]
    pub(crate) fn over(facet: &Facet, corners: [V; 3]) -> Self {
        let (first, slopes) = (facet.first(), V::slopes(facet, corners));
        let row = V::row(&slopes, 0);
        Self { plane: Plane { first, slopes }, y: first.1, row }
    }

    /// At row y.
    #[inline(always)]
    pub(crate) fn new(plane: Plane<V>, y: i32) -> Self {
        let down = unsigned(y.wrapping_sub(plane.first.1));
        Self { plane, y, row: V::row(&plane.slopes, down) }
    }

    /// To row y: the row below is one addition away.
    #[inline(always)]
    pub(crate) fn go_to(&mut self, y: i32) {
        if y == self.y.wrapping_add(1) {
            V::below(&self.plane.slopes, &mut self.row);
            self.y = y;
        } else if y != self.y {
            *self = Self::new(self.plane, y);
        }
    }

    /// The run that begins in column x of the row, where so many pixels are asked for.
    #[inline(always)]
    pub(crate) fn run(&self, x: i32, pixels: u32) -> V::Run {
        V::stretch(&self.plane.slopes, &self.row, unsigned(x.wrapping_sub(self.plane.first.0)), pixels)
    }

    /// Takes a run on that has come to a pixel, where so many more are asked for.
    #[inline(always)]
    pub(crate) fn go_on(&self, run: &mut V::Run, (x, y): (i32, i32), pixels: u32) {
        let Plane { first, ref slopes } = self.plane;
        V::go_on(slopes, run, (unsigned(x.wrapping_sub(first.0)), unsigned(y.wrapping_sub(first.1))), pixels);
    }

    /// For how many pixels a run is right.
    #[inline(always)]
    pub(crate) fn reach(&self) -> u32 {
        self.plane.reach()
    }
}
