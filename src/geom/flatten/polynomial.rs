//! [`Polynomial`]: one coordinate of a curve.

use crate::num::{
    cast::{low_u32, magnitude, narrow, saturate, signed},
    round::difference,
    wide::{signed_product, times, wide_times},
};

/// Times are in units of `2^-20`.
pub(super) const TIME_BITS: u32 = 20;

/// One coordinate of a curve as a function of the time t: `((a t + b) t + c) t + d`.
#[derive(Copy, Clone, Debug)]
pub(super) struct Polynomial {
    pub(super) a: i64,
    pub(super) b: i64,
    c: i64,
    d: i32,
}

impl Polynomial {
    /// Always 0.
    pub(super) const NONE: Self = Self { a: 0, b: 0, c: 0, d: 0 };

    /// By four control points, or, if it is not `cubic`, by the first three of them.
    #[cfg_attr(embedded_raster_compact, inline(never))]
    pub(super) fn new([p0, p1, p2, p3]: [i32; 4], cubic: bool) -> Self {
        // The second difference is below 2^33.
        let (way, bend) = (difference(p1, p0), difference(p0, p1).wrapping_add(difference(p2, p1)));
        if cubic {
            let a = difference(p3, p0).wrapping_sub(difference(p2, p1).wrapping_mul(3));
            Self { a, b: bend.wrapping_mul(3), c: way.wrapping_mul(3), d: p0 }
        } else {
            Self { a: 0, b: bend, c: way << 1, d: p0 }
        }
    }

    /// A coordinate of W, `h^2 P''/2`, for a part that takes the time h, with `h^2 = 2^-down`. P'' is taken at the time
    /// `time / 3`, in units of 2^-20.
    ///
    /// `P''/2 = 3 a t + b`, which is `a time + b`. When both coefficients are [small](Self::is_small), everything fits
    /// 31 bits.
    #[inline(always)]
    pub(super) fn small_bend(&self, time: u32, down: u32) -> i32 {
        let by_time = signed_product(narrow(self.a), signed(time)) >> TIME_BITS;
        narrow(self.b).wrapping_add(narrow(by_time)).wrapping_shr(down)
    }

    /// The same for any coefficients: the sum is below 2^36, and the product below 2^56, before they are shifted.
    #[inline(never)]
    pub(super) fn bend(&self, time: u32, down: u32) -> i32 {
        let by_time = wide_times(self.a, time) >> TIME_BITS;
        saturate(self.b.wrapping_add(by_time).wrapping_shr(down))
    }

    /// Whether both coefficients of the second derivative are below 2^28.
    pub(super) fn is_small(&self) -> bool {
        (self.a.unsigned_abs() | self.b.unsigned_abs()) >> 28 == 0
    }

    /// Its slope at `t / 2^20`, times 2^24, rounded towards zero: below 2^60.
    ///
    /// `3 a t + 2 b` is below 2^38, and times 2^20 it has 58 bits. Times t, and with the slope at the start, `c 2^40`, it has 80.
    #[cfg_attr(embedded_raster_compact, inline(never))]
    pub(super) fn slope(&self, t: u32) -> i64 {
        let first = wide_times(self.a.wrapping_mul(3), t).wrapping_add(self.b << (TIME_BITS + 1));
        let (high, low) = times((first >> 32, low_u32(magnitude(first))), t);
        let high = high.wrapping_add(self.c << (2 * TIME_BITS - 32));
        let slope = high << 16 | i64::from(low >> 16);
        slope.wrapping_add(i64::from(slope < 0 && low & 0xffff != 0))
    }

    /// Its value at `t / 2^20`, rounded to nearest.
    ///
    /// `a t + b` is below 2^36, and times 2^20 it has 56 bits. `(a t + b) t + c` is the slope of the chord from the
    /// start of the curve to here, below 2^35, and times 2^40 it has 75 bits. The third product is the way from the
    /// start to here: below 2^32, and 2^92 when times 2^60.
    #[inline(never)]
    pub(super) fn at(self, t: u32) -> i32 {
        let first = wide_times(self.a, t).wrapping_add(self.b << TIME_BITS);
        let (high, low) = times((first >> 32, low_u32(magnitude(first))), t);
        let (high, _) = times((high.wrapping_add(self.c << (2 * TIME_BITS - 32)), low), t);
        // The low word is dropped: it never changes what is rounded down here.
        narrow(i64::from(self.d).wrapping_add(high.wrapping_add(1 << 27) >> 28))
    }
}
