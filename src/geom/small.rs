//! [`Small`]: what changes over a small triangle, as sums that are ready to be added up.
//!
//! Over any triangle a value has slopes, and ways to its rows and runs that depend on how large the triangle is. In a mesh nearly
//! all triangles are small, of a hundred pixels and less, and what is looked up and chosen once a triangle and once a row costs more
//! than their pixels. So a small triangle has a form of its own: one sum for each number, right at each of its pixels, with nothing
//! to choose. Which triangles are small is a question of their size alone: 63 pixels wide and high together, and not smaller than a
//! pixel.
//!
//! The values are the same: both are the nearest ones. What D and the number of steps allow is said where the sums are made: in
//! `SmallFacet::levels` and `SmallFacet::words`.

use core::fmt::Debug;

use crate::num::wide::wide_times_small;

/// What changes over a small triangle, at the first column of one of its rows.
pub trait Small<R>: Copy + Debug {
    /// Whether there is such a form.
    #[doc(hidden)]
    const EXISTS: bool = true;

    /// So many rows further down, below 2^16.
    #[doc(hidden)]
    fn skip(&mut self, rows: u32);

    /// To the row below.
    #[doc(hidden)]
    fn below(&mut self);

    /// The run that begins so many pixels further right, below 2^16.
    #[doc(hidden)]
    fn run(&self, right: u32) -> R;
}

/// What has no form of its own in small triangles.
#[derive(Copy, Clone, Debug)]
pub enum NoSmall {}

impl<R> Small<R> for NoSmall {
    const EXISTS: bool = false;

    fn skip(&mut self, _: u32) {}

    fn below(&mut self) {}

    fn run(&self, _: u32) -> R {
        match *self {}
    }
}

/// A number: where a row begins, what it gains to the right, and downwards.
#[derive(Copy, Clone, Debug)]
pub struct Sums<T> {
    pub(crate) at: T,
    pub(crate) right: T,
    pub(crate) down: T,
}

impl Sums<u64> {
    /// Of numbers with fewer bits of fraction.
    #[inline(always)]
    pub(super) fn shifted([at, right, down]: [u64; 3], left: u32) -> Self {
        let shift = |n: u64| n << (left & 63);
        Self { at: shift(at), right: shift(right), down: shift(down) }
    }

    #[inline(always)]
    pub(super) fn down(&mut self, rows: u32) {
        self.at = self.at.wrapping_add(wide_times_small(self.down, rows));
    }

    #[inline(always)]
    pub(super) fn step(&mut self) {
        self.at = self.at.wrapping_add(self.down);
    }

    /// Where a run begins, and what it gains.
    #[inline(always)]
    pub(super) fn start(&self, right: u32) -> (u64, u64) {
        (self.at.wrapping_add(wide_times_small(self.right, right)), self.right)
    }
}

impl Small<()> for () {
    #[inline(always)]
    fn skip(&mut self, _: u32) {}

    #[inline(always)]
    fn below(&mut self) {}

    #[inline(always)]
    fn run(&self, _: u32) {}
}

impl<R, S: Small<R>, const N: usize> Small<[R; N]> for [S; N] {
    const EXISTS: bool = S::EXISTS;

    #[inline(always)]
    fn skip(&mut self, rows: u32) {
        for small in self {
            small.skip(rows);
        }
    }

    #[inline(always)]
    fn below(&mut self) {
        self.iter_mut().for_each(S::below);
    }

    #[inline(always)]
    fn run(&self, right: u32) -> [R; N] {
        self.each_ref().map(|small| small.run(right))
    }
}

macro_rules! tuple {
    ($($name:ident $run:ident $place:tt),*) => {
        impl<$($run, $name: Small<$run>),*> Small<($($run,)*)> for ($($name,)*) {
            const EXISTS: bool = $($name::EXISTS)&&*;

            #[inline(always)]
            fn skip(&mut self, rows: u32) {
                $(self.$place.skip(rows);)*
            }

            #[inline(always)]
            fn below(&mut self) {
                $(self.$place.below();)*
            }

            #[inline(always)]
            fn run(&self, right: u32) -> ($($run,)*) {
                ($(self.$place.run(right),)*)
            }
        }
    };
}

tuple!(A P 0);
tuple!(A P 0, B Q 1);
tuple!(A P 0, B Q 1, C R 2);
tuple!(A P 0, B Q 1, C R 2, D S 3);
tuple!(A P 0, B Q 1, C R 2, D S 3, E T 4);
tuple!(A P 0, B Q 1, C R 2, D S 3, E T 4, F U 5);
