//! None, one or several varyings as one: arrays and tuples.

use super::traits::Varying;
use crate::geom::facet::{Facet, SmallFacet};

impl Varying for () {
    type Slopes = ();
    type Row = ();
    type Run = ();
    type Small = ();

    #[inline(always)]
    fn slopes(_: &Facet, _: [Self; 3]) {}

    #[inline(always)]
    fn small(_: &SmallFacet, _: [Self; 3]) -> Option<()> {
        Some(())
    }

    #[inline(always)]
    fn row((): &(), _: u32) {}

    #[inline(always)]
    fn below((): &(), (): &mut ()) {}

    #[inline(always)]
    fn run((): &(), (): &(), _: u32) {}

    #[inline(always)]
    fn value((): &()) {}

    #[inline(always)]
    fn step((): &mut ()) {}
}

impl<V: Varying, const N: usize> Varying for [V; N] {
    type Slopes = [V::Slopes; N];
    type Row = [V::Row; N];
    type Run = [V::Run; N];
    type Small = [V::Small; N];

    #[inline(always)]
    fn slopes(facet: &Facet, [a, b, c]: [Self; 3]) -> Self::Slopes {
        let mut rest = b.into_iter().zip(c);
        a.map(|a| {
            let (b, c) = rest.next().unwrap_or((a, a));
            V::slopes(facet, [a, b, c])
        })
    }

    #[inline(always)]
    fn small(facet: &SmallFacet, [a, b, c]: [Self; 3]) -> Option<Self::Small> {
        let mut corners = a.into_iter().zip(b).zip(c).map(|((a, b), c)| [a, b, c]);
        let mut sums = [V::small(facet, corners.next()?)?; N];
        for (sum, corners) in sums.iter_mut().skip(1).zip(corners) {
            *sum = V::small(facet, corners)?;
        }
        Some(sums)
    }

    #[inline(always)]
    fn row(slopes: &Self::Slopes, down: u32) -> Self::Row {
        slopes.each_ref().map(|slopes| V::row(slopes, down))
    }

    #[inline(always)]
    fn below(slopes: &Self::Slopes, row: &mut Self::Row) {
        slopes.iter().zip(row).for_each(|(slopes, row)| V::below(slopes, row));
    }

    #[inline(always)]
    fn run(slopes: &Self::Slopes, row: &Self::Row, right: u32) -> Self::Run {
        Self::stretch(slopes, row, right, 1)
    }

    #[inline(always)]
    fn stretch(slopes: &Self::Slopes, row: &Self::Row, right: u32, pixels: u32) -> Self::Run {
        let mut rows = row.iter();
        // There is one for each.
        slopes.each_ref().map(|slopes| match rows.next() {
            Some(row) => V::stretch(slopes, row, right, pixels),
            None => V::stretch(slopes, &V::row(slopes, 0), right, pixels),
        })
    }

    #[inline(always)]
    fn value(run: &Self::Run) -> Self {
        run.each_ref().map(V::value)
    }

    #[inline(always)]
    fn step(run: &mut Self::Run) {
        for run in run {
            V::step(run);
        }
    }

    #[inline(always)]
    fn reach(slopes: &Self::Slopes) -> u32 {
        slopes.iter().map(V::reach).fold(u32::MAX, u32::min)
    }
}

macro_rules! tuple {
    ($($name:ident $place:tt),*) => {
        impl<$($name: Varying),*> Varying for ($($name,)*) {
            type Slopes = ($($name::Slopes,)*);
            type Row = ($($name::Row,)*);
            type Run = ($($name::Run,)*);
            type Small = ($($name::Small,)*);

            #[inline(always)]
            fn slopes(facet: &Facet, [a, b, c]: [Self; 3]) -> Self::Slopes {
                ($($name::slopes(facet, [a.$place, b.$place, c.$place]),)*)
            }

            #[inline(always)]
            fn small(facet: &SmallFacet, [a, b, c]: [Self; 3]) -> Option<Self::Small> {
                Some(($($name::small(facet, [a.$place, b.$place, c.$place])?,)*))
            }

            #[inline(always)]
            fn row(slopes: &Self::Slopes, down: u32) -> Self::Row {
                ($($name::row(&slopes.$place, down),)*)
            }

            #[inline(always)]
            fn below(slopes: &Self::Slopes, row: &mut Self::Row) {
                $($name::below(&slopes.$place, &mut row.$place);)*
            }

            #[inline(always)]
            fn run(slopes: &Self::Slopes, row: &Self::Row, right: u32) -> Self::Run {
                ($($name::run(&slopes.$place, &row.$place, right),)*)
            }

            #[inline(always)]
            fn stretch(slopes: &Self::Slopes, row: &Self::Row, right: u32, pixels: u32) -> Self::Run {
                ($($name::stretch(&slopes.$place, &row.$place, right, pixels),)*)
            }

            #[inline(always)]
            fn value(run: &Self::Run) -> Self {
                ($($name::value(&run.$place),)*)
            }

            #[inline(always)]
            fn step(run: &mut Self::Run) {
                $($name::step(&mut run.$place);)*
            }

            #[inline(always)]
            fn reach(slopes: &Self::Slopes) -> u32 {
                u32::MAX$(.min($name::reach(&slopes.$place)))*
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
