//! [`Answer`]: what a call says, as a number.

use core::cmp::Ordering;

use embedded_graphics_core::{
    geometry::{Point, Size},
    primitives::Rectangle,
};
use embedded_raster::{Angle, ClippedSpan, Ellipse, PointFx, Rect, Span};
use fixed::types::{I16F16, I24F8};

/// A number that depends on all of a value, so that whoever computes one cannot be left out by the optimiser, and two surfaces can
/// be compared by what they answer.
pub trait Answer {
    /// The number.
    fn answer(self) -> usize;
}

impl Answer for () {
    fn answer(self) -> usize {
        0
    }
}

impl Answer for usize {
    fn answer(self) -> usize {
        self
    }
}

impl Answer for bool {
    fn answer(self) -> usize {
        self.into()
    }
}

/// By the low bits.
macro_rules! numbers {
    ($($number:ty),*) => {$(
        impl Answer for $number {
            #[allow(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                clippy::cast_lossless,
                reason = "any number will do that depends on this one"
            )]
            fn answer(self) -> usize {
                self as usize
            }
        }
    )*};
}
numbers!(u8, u16, u32, u64, i32, i64, i128);

/// By its parts.
macro_rules! parts {
    ($($type:ty: $it:ident => $parts:expr;)*) => {$(
        impl Answer for $type {
            fn answer(self) -> usize {
                let $it = self;
                $parts.answer()
            }
        }
    )*};
}
parts! {
    I24F8: it => it.to_bits();
    I16F16: it => it.to_bits();
    Angle: it => it.to_bits();
    Ordering: it => it.is_lt();
    Point: it => (it.x, it.y);
    PointFx: it => (it.x, it.y);
    Size: it => (it.width, it.height);
    Rect: it => ((it.x0, it.y0), (it.x1, it.y1));
    Rectangle: it => (it.top_left, it.size);
    Ellipse: it => it.extent();
    Span: it => (it.y, (it.x0, it.x1));
    ClippedSpan: it => (it.y(), (it.x0(), it.x1()));
}

impl<A: Answer, B: Answer> Answer for (A, B) {
    fn answer(self) -> usize {
        self.0.answer().rotate_left(7) ^ self.1.answer()
    }
}

impl<T: Answer, const N: usize> Answer for [T; N] {
    fn answer(self) -> usize {
        sum(self)
    }
}

impl<T: Answer> Answer for Option<T> {
    fn answer(self) -> usize {
        self.map_or(0, |it| it.answer().wrapping_add(1))
    }
}

/// Errors are all the same: `Debug` and `Display` are no calls.
impl<T: Answer, E> Answer for Result<T, E> {
    fn answer(self) -> usize {
        self.map_or(usize::MAX, Answer::answer)
    }
}

/// Of all items.
pub fn sum<T: Answer>(items: impl IntoIterator<Item = T>) -> usize {
    items.into_iter().fold(0, |sum, item| (sum, item.answer()).answer())
}
