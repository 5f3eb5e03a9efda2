//! [`Mix`]: values anywhere in a triangle, and [`At`]: the pixel as a value.

use embedded_graphics_core::geometry::Point;
use fixed::types::{I16F16, I24F8};

use super::{
    facet::{Facet, SmallFacet},
    perspective::{Perspective, Runs},
    small::Small,
    varying::{Fast, Varying},
};
use crate::num::cast::{low_u16, low_u8, signed, unsigned};

/// What has a mean: numbers, colours, or several of them in an array or a tuple.
///
/// It is made of means of numbers: whoever asks for it says how those are found. [`Barycentric::mix`](super::Barycentric::mix)
/// rounds once, from the exact mean to the nearest number, halves upwards.
/// ```
/// use embedded_raster::geom::{Barycentric, Mix};
/// // A quarter of the way from the first corner to the second.
/// let place = Barycentric { weights: [3, 1, 0], total: 4 };
/// let mean = |numbers| place.mix(numbers);
/// assert_eq!(<(u8, i16)>::mix(&mean, [(10, -4), (20, 4), (0, 0)]), (13, -2));
/// ```
pub trait Mix: Copy {
    /// The mean of three values, where `mean` is that of three numbers. It is not out of their range.
    fn mix(mean: &impl Fn([i32; 3]) -> i32, corners: [Self; 3]) -> Self;
}

macro_rules! numbers {
    ($($type:ty, |$n:ident| $bits:expr, |$back:ident| $value:expr;)*) => {
        $(impl Mix for $type {
            #[inline]
            fn mix(mean: &impl Fn([i32; 3]) -> i32, corners: [Self; 3]) -> Self {
                let $back = mean(corners.map(|$n| $bits));
                $value
            }
        })*
    };
}

numbers! {
    u8, |n| n.into(), |n| low_u8(unsigned(n));
    u16, |n| n.into(), |n| low_u16(unsigned(n));
    i16, |n| n.into(), |n| Self::from_le_bytes(low_u16(unsigned(n)).to_le_bytes());
    i32, |n| n, |n| n;
    // With the highest bit turned over, numbers without a sign are in the order of those with one.
    u32, |n| signed(n ^ 1 << 31), |n| unsigned(n) ^ 1 << 31;
    I16F16, |n| n.to_bits(), |n| Self::from_bits(n);
    I24F8, |n| n.to_bits(), |n| Self::from_bits(n);
}

impl Mix for () {
    #[inline(always)]
    fn mix(_: &impl Fn([i32; 3]) -> i32, _: [Self; 3]) {}
}

impl<V: Mix> Mix for Fast<V> {
    #[inline(always)]
    fn mix(mean: &impl Fn([i32; 3]) -> i32, corners: [Self; 3]) -> Self {
        Self(V::mix(mean, corners.map(|fast| fast.0)))
    }
}

/// In space both change evenly: what is seen in perspective is right of parts of a triangle, too.
impl<V: Mix> Mix for Perspective<V> {
    #[inline(always)]
    fn mix(mean: &impl Fn([i32; 3]) -> i32, corners: [Self; 3]) -> Self {
        let (w, value) = Mix::mix(mean, corners.map(|seen| (seen.w, seen.value)));
        Self { w, value }
    }
}

impl<V: Mix, const N: u32> Mix for Runs<V, N> {
    #[inline(always)]
    fn mix(mean: &impl Fn([i32; 3]) -> i32, corners: [Self; 3]) -> Self {
        let (w, value) = Mix::mix(mean, corners.map(|seen| (seen.w, seen.value)));
        Self { w, value }
    }
}

impl<V: Mix, const N: usize> Mix for [V; N] {
    #[inline]
    fn mix(mean: &impl Fn([i32; 3]) -> i32, [a, b, c]: [Self; 3]) -> Self {
        let mut rest = b.into_iter().zip(c);
        a.map(|a| {
            let (b, c) = rest.next().unwrap_or((a, a));
            V::mix(mean, [a, b, c])
        })
    }
}

macro_rules! tuple {
    ($($name:ident $place:tt),*) => {
        impl<$($name: Mix),*> Mix for ($($name,)*) {
            #[inline]
            fn mix(mean: &impl Fn([i32; 3]) -> i32, [a, b, c]: [Self; 3]) -> Self {
                ($($name::mix(mean, [a.$place, b.$place, c.$place]),)*)
            }
        }
    };
}

tuple!(A 0);
tuple!(A 0, B 1);
tuple!(A 0, B 1, C 2);
tuple!(A 0, B 1, C 2, D 3);
tuple!(A 0, B 1, C 2, D 3, E 4);
tuple!(A 0, B 1, C 2, D 3, E 4, F 5);

/// The pixel itself, as a varying: for functions of colours that want to know where they are. What it is given at the corners does
/// not matter.
/// ```
/// use embedded_graphics_core::{geometry::Point, pixelcolor::Gray8};
/// use embedded_raster::{geom::At, Canvas, Framebuffer, PointFx};
/// let mut ram = [0; 12];
/// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 4, 3)?;
/// let corners = [PointFx::px(0, 0), PointFx::px(9, 0), PointFx::px(0, 9)];
/// frame.shade_triangle_fx(corners, [At::default(); 3], |At(at)| Gray8::new(10 * at.y as u8 + at.x as u8))?;
/// assert_eq!(ram, [0, 1, 2, 3, 10, 11, 12, 13, 20, 21, 22, 23]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct At(pub Point);

/// The first pixel of a row.
#[derive(Copy, Clone, Debug)]
pub struct Place((i32, i32));

impl Small<(i32, i32)> for Place {
    #[inline(always)]
    fn skip(&mut self, rows: u32) {
        self.0 .1 = self.0 .1.wrapping_add(signed(rows));
    }

    #[inline(always)]
    fn below(&mut self) {
        self.skip(1);
    }

    #[inline(always)]
    fn run(&self, right: u32) -> (i32, i32) {
        (self.0 .0.wrapping_add(signed(right)), self.0 .1)
    }
}

impl Varying for At {
    type Slopes = (i32, i32);
    type Row = i32;
    type Run = (i32, i32);
    type Small = Place;

    #[inline(always)]
    fn slopes(facet: &Facet, _: [Self; 3]) -> (i32, i32) {
        facet.first()
    }

    #[inline(always)]
    fn small(facet: &SmallFacet, _: [Self; 3]) -> Option<Place> {
        Some(Place(facet.first()))
    }

    #[inline(always)]
    fn row(slopes: &(i32, i32), down: u32) -> i32 {
        slopes.1.wrapping_add(signed(down))
    }

    #[inline(always)]
    fn below(_: &(i32, i32), row: &mut i32) {
        *row = row.wrapping_add(1);
    }

    #[inline(always)]
    fn run(slopes: &(i32, i32), row: &i32, right: u32) -> (i32, i32) {
        (slopes.0.wrapping_add(signed(right)), *row)
    }

    #[inline(always)]
    fn value(run: &(i32, i32)) -> Self {
        Self(Point::new(run.0, run.1))
    }

    #[inline(always)]
    fn step(run: &mut (i32, i32)) {
        run.0 = run.0.wrapping_add(1);
    }
}

impl Mix for At {
    #[inline(always)]
    fn mix(_: &impl Fn([i32; 3]) -> i32, [first, ..]: [Self; 3]) -> Self {
        first
    }
}
