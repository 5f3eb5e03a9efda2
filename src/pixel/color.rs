//! Colour types that embedded-graphics does not have: indices into a colour table, RGB332, RGB444 and XRGB8888. And what else a pixel
//! may hold: a depth, or the number of a triangle.

use embedded_graphics_core::pixelcolor::{
    raw::{RawData, RawU1, RawU16, RawU2, RawU32, RawU4, RawU8},
    BinaryColor, PixelColor, Rgb555, Rgb565, Rgb888, RgbColor,
};

use super::levels::{luma, nearest, rescale, EGA_RGB};

macro_rules! index {
    ($name:ident, $raw:ident, $bits:literal, $colors:literal, $standard:literal) => {
        #[doc = concat!("An index into a colour table of ", $colors, " entries, ", $bits, " bit(s) in memory.")]
        ///
        /// It is an embedded-graphics colour, so text and images draw with it. What it looks like depends on the
        /// [`Palette`](crate::Palette) that it is shown through. Conversions from and to RGB colours use the standard table
        #[doc = concat!($standard, ", and `BinaryColor::On` is the last index.")]
        #[derive(Copy, Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct $name($raw);

        impl $name {
            /// The largest index.
            pub const MAX: Self = Self($raw::new(0xff));

            /// The index in the low bits of `index`.
            #[inline]
            pub const fn new(index: u8) -> Self {
                Self($raw::new(index))
            }

            /// The number.
            #[inline]
            pub fn index(self) -> u8 {
                self.0.into_inner()
            }
        }

        impl PixelColor for $name {
            type Raw = $raw;
        }

        impl From<$raw> for $name {
            #[inline(always)]
            fn from(raw: $raw) -> Self {
                Self(raw)
            }
        }

        impl From<$name> for $raw {
            #[inline(always)]
            fn from(color: $name) -> Self {
                color.0
            }
        }

        impl From<$name> for u8 {
            fn from(color: $name) -> Self {
                color.index()
            }
        }

        impl From<BinaryColor> for $name {
            fn from(color: BinaryColor) -> Self {
                if color.is_on() {
                    Self::MAX
                } else {
                    Self::new(0)
                }
            }
        }
    };
}

index!(Index1, RawU1, "1", "2", "black, white");
index!(Index2, RawU2, "2", "4", "of four greys");
index!(Index4, RawU4, "4", "16", "[`EGA`](crate::pixel::EGA)");
index!(Index8, RawU8, "8", "256", "[`Palette::rgb332`](crate::Palette::rgb332)");

macro_rules! number {
    ($name:ident, $raw:ident, $number:ty, $doc:literal) => {
        #[doc = $doc]
        #[derive(Copy, Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct $name(pub $number);

        impl $name {
            /// The largest one.
            pub const MAX: Self = Self(<$number>::MAX);
        }

        impl PixelColor for $name {
            type Raw = $raw;
        }

        impl From<$raw> for $name {
            #[inline(always)]
            fn from(raw: $raw) -> Self {
                Self(raw.into_inner())
            }
        }

        impl From<$name> for $raw {
            #[inline(always)]
            fn from(number: $name) -> Self {
                Self::new(number.0)
            }
        }
    };
}

number!(
    Depth16,
    RawU16,
    u16,
    "A depth of 16 bits. A frame of depths is a depth buffer: see [`paint::depth`](crate::paint::depth)."
);
number!(Depth32, RawU32, u32, "A depth of 32 bits.");
number!(
    Id16,
    RawU16,
    u16,
    "The number of a triangle, from 1 on; 0 is the background. A frame of them tells what is seen where."
);
number!(Id32, RawU32, u32, "The number of a triangle, from 1 on, if there are more than 65,535.");

/// An 8-bit colour: three bits of red, three of green, two of blue.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Rgb332(RawU8);

impl PixelColor for Rgb332 {
    type Raw = RawU8;
}

impl From<RawU8> for Rgb332 {
    #[inline(always)]
    fn from(raw: RawU8) -> Self {
        Self(raw)
    }
}

impl From<Rgb332> for RawU8 {
    #[inline(always)]
    fn from(color: Rgb332) -> Self {
        color.0
    }
}

/// A 12-bit colour: four bits of red, of green and of blue, in the low bits of 16.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Rgb444(RawU16);

impl PixelColor for Rgb444 {
    type Raw = RawU16;
}

impl From<RawU16> for Rgb444 {
    #[inline(always)]
    fn from(raw: RawU16) -> Self {
        Self(RawU16::new(raw.into_inner() & 0xfff))
    }
}

impl From<Rgb444> for RawU16 {
    #[inline(always)]
    fn from(color: Rgb444) -> Self {
        color.0
    }
}

/// A 32-bit colour: the low 24 bits are those of [`Rgb888`], the high byte is kept as it is given.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Xrgb8888(RawU32);

impl PixelColor for Xrgb8888 {
    type Raw = RawU32;
}

impl From<RawU32> for Xrgb8888 {
    #[inline(always)]
    fn from(raw: RawU32) -> Self {
        Self(raw)
    }
}

impl From<Xrgb8888> for RawU32 {
    #[inline(always)]
    fn from(color: Xrgb8888) -> Self {
        color.0
    }
}

macro_rules! rgb {
    ($name:ident, $storage:ty, $r:literal at $r_place:literal, $g:literal at $g_place:literal, $b:literal at $b_place:literal) => {
        impl $name {
            /// A colour of its channels. Of each channel the low bits count, as many as it has.
            #[inline]
            pub const fn new(r: u8, g: u8, b: u8) -> Self {
                let (r, g, b) = (r & Self::MAX_R, g & Self::MAX_G, b & Self::MAX_B);
                let bits = (r as $storage) << $r_place | (g as $storage) << $g_place | (b as $storage) << $b_place;
                Self(<Self as PixelColor>::Raw::new(bits))
            }
        }

        impl RgbColor for $name {
            const MAX_R: u8 = 0xff >> (8 - $r);
            const MAX_G: u8 = 0xff >> (8 - $g);
            const MAX_B: u8 = 0xff >> (8 - $b);
            const BLACK: Self = Self::new(0, 0, 0);
            const RED: Self = Self::new(255, 0, 0);
            const GREEN: Self = Self::new(0, 255, 0);
            const BLUE: Self = Self::new(0, 0, 255);
            const YELLOW: Self = Self::new(255, 255, 0);
            const MAGENTA: Self = Self::new(255, 0, 255);
            const CYAN: Self = Self::new(0, 255, 255);
            const WHITE: Self = Self::new(255, 255, 255);

            fn r(&self) -> u8 {
                crate::num::cast::low_u8(u32::from(self.0.into_inner() >> $r_place)) & Self::MAX_R
            }

            fn g(&self) -> u8 {
                crate::num::cast::low_u8(u32::from(self.0.into_inner() >> $g_place)) & Self::MAX_G
            }

            fn b(&self) -> u8 {
                crate::num::cast::low_u8(u32::from(self.0.into_inner() >> $b_place)) & Self::MAX_B
            }
        }

        impl From<Rgb888> for $name {
            fn from(c: Rgb888) -> Self {
                Self::new(
                    rescale(c.r(), 255, Self::MAX_R),
                    rescale(c.g(), 255, Self::MAX_G),
                    rescale(c.b(), 255, Self::MAX_B),
                )
            }
        }

        impl From<$name> for Rgb888 {
            fn from(c: $name) -> Self {
                Self::new(
                    rescale(c.r(), $name::MAX_R, 255),
                    rescale(c.g(), $name::MAX_G, 255),
                    rescale(c.b(), $name::MAX_B, 255),
                )
            }
        }
    };
}

rgb!(Rgb332, u8, 3 at 5, 3 at 2, 2 at 0);
rgb!(Rgb444, u16, 4 at 8, 4 at 4, 4 at 0);
rgb!(Xrgb8888, u32, 8 at 16, 8 at 8, 8 at 0);

fn luma_of(c: Rgb888) -> u8 {
    crate::num::cast::low_u8(luma([c.r(), c.g(), c.b()].map(u32::from)))
}

impl From<Rgb888> for Index1 {
    fn from(c: Rgb888) -> Self {
        Self::new(rescale(luma_of(c), 255, 1))
    }
}

impl From<Rgb888> for Index2 {
    fn from(c: Rgb888) -> Self {
        Self::new(rescale(luma_of(c), 255, 3))
    }
}

impl From<Rgb888> for Index4 {
    fn from(c: Rgb888) -> Self {
        Self::new(nearest(EGA_RGB.iter().copied(), c))
    }
}

impl From<Rgb888> for Index8 {
    fn from(c: Rgb888) -> Self {
        Self::from(RawU8::from(Rgb332::from(c)))
    }
}

impl From<Index1> for Rgb888 {
    fn from(c: Index1) -> Self {
        let grey = rescale(c.index(), 1, 255);
        Self::new(grey, grey, grey)
    }
}

impl From<Index2> for Rgb888 {
    fn from(c: Index2) -> Self {
        let grey = rescale(c.index(), 3, 255);
        Self::new(grey, grey, grey)
    }
}

impl From<Index4> for Rgb888 {
    fn from(c: Index4) -> Self {
        EGA_RGB.get(usize::from(c.index())).copied().unwrap_or(Self::BLACK)
    }
}

impl From<Index8> for Rgb888 {
    fn from(c: Index8) -> Self {
        Rgb332::from(RawU8::from(c)).into()
    }
}

macro_rules! through_rgb888 {
    ($($name:ident),*) => {
        $(
            impl From<Rgb565> for $name {
                fn from(c: Rgb565) -> Self {
                    Rgb888::from(c).into()
                }
            }

            impl From<Rgb555> for $name {
                fn from(c: Rgb555) -> Self {
                    Rgb888::from(c).into()
                }
            }

            impl From<$name> for Rgb565 {
                fn from(c: $name) -> Self {
                    Rgb888::from(c).into()
                }
            }

            impl From<$name> for Rgb555 {
                fn from(c: $name) -> Self {
                    Rgb888::from(c).into()
                }
            }
        )*
    };
}

through_rgb888!(Index1, Index2, Index4, Index8, Rgb332, Rgb444, Xrgb8888);
