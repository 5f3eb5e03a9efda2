//! Colours as [`Varying`]s: each channel changes by itself, and is the nearest level of its own.

use embedded_graphics_core::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, Gray2, Gray4, Gray8, GrayColor, Rgb555, Rgb565, Rgb666, Rgb888, RgbColor,
};

use crate::{
    geom::{Facet, Fast, Varying},
    pixel::{Rgb332, Rgb444, Xrgb8888},
};

/// What changes as its levels do.
macro_rules! by_levels {
    ($color:ty, $levels:ty, |$c:ident| $split:expr, |$l:pat_param| $join:expr) => {
        impl Varying for $color {
            type Slopes = <$levels as Varying>::Slopes;
            type Run = <$levels as Varying>::Run;

            #[inline(always)]
            fn slopes(facet: &Facet, corners: [Self; 3]) -> Self::Slopes {
                <$levels>::slopes(facet, corners.map(|$c| $split))
            }

            #[inline(always)]
            fn run(slopes: &Self::Slopes, right: u32, down: u32) -> Self::Run {
                <$levels>::run(slopes, right, down)
            }

            #[inline(always)]
            fn value(run: &Self::Run) -> Self {
                let $l = <$levels>::value(run);
                $join
            }

            #[inline(always)]
            fn step(run: &mut Self::Run) {
                <$levels>::step(run);
            }
        }
    };
}

macro_rules! rgb {
    ($($color:ty),*) => {
        $(
            by_levels!($color, [u8; 3], |c| [c.r(), c.g(), c.b()], |[r, g, b]| Self::new(r, g, b));
            by_levels!(Fast<$color>, [Fast<u8>; 3], |c| [Fast(c.0.r()), Fast(c.0.g()), Fast(c.0.b())], |[r, g, b]| {
                Self(<$color>::new(r.0, g.0, b.0))
            });
        )*
    };
}

macro_rules! gray {
    ($($color:ty),*) => {
        $(
            by_levels!($color, u8, |c| c.luma(), |luma| Self::new(luma));
            by_levels!(Fast<$color>, Fast<u8>, |c| Fast(c.0.luma()), |luma| Self(<$color>::new(luma.0)));
        )*
    };
}

rgb!(Rgb332, Rgb444, Rgb555, Rgb565, Rgb666, Rgb888, Xrgb8888, Bgr555, Bgr565, Bgr666, Bgr888);
gray!(Gray2, Gray4, Gray8);
