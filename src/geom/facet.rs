//! [`Facet`]: a triangle as the plane over which values change, and [`Barycentric`]: where a place lies in it.
//!
//! A value at each corner of a triangle makes a plane. At a place p the value is `(w0 v0 + w1 v1 + w2 v2) / w`, where each weight
//! is an edge function, twice the area of the triangle between p and the side opposite to a corner, and w is their sum, twice the
//! area of the whole.
//! ```text
//!            0
//!           / \        w0 = area of p12, and so on
//!          / p \       inside, all three have the sign of w; on a side, one is 0
//!         1-----2
//! ```
//! All of them are exact integers: with corners in 24.8 the unit is 1/65,536 of a square pixel.
//!
//! Sources: A. Möbius, "Der barycentrische Calcul", 1827; J. Pineda, "A Parallel Algorithm for Polygon Rasterization", SIGGRAPH
//! 1988.

use fixed::types::I16F16;

use super::point::{bits, PointFx};
use crate::{
    error::TriangleTooLarge,
    num::{
        cast::{magnitude, narrow, saturate, signed_wide, unsigned},
        divisor::{Scale, WideDivisor},
        mixed::Mixed,
        round::{difference, first_centre_from},
        wide::{signed_product, wide_times_small},
    },
};

/// A triangle over which values change from corner to corner.
///
/// Its box may be 12,288 pixels wide and high together, anywhere. So twice its area is below 2^42 units.
/// ```
/// use embedded_raster::{geom::Facet, PointFx};
/// let facet = Facet::new([PointFx::px(10, 5), PointFx::px(20, 15), PointFx::px(5, 15)])?;
/// assert_eq!(facet.twice_area(), 150 << 16);
/// assert!(facet.weights(PointFx::px(10, 12)).is_inside());
/// assert!(!facet.weights(PointFx::px(5, 5)).is_inside());
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Copy, Clone, Debug)]
pub struct Facet {
    corner: (i32, i32),
    /// From the first corner to the others; of a triangle whose corners turn the other way, from the others to the first.
    sides: [(i32, i32); 2],
    is_clockwise: bool,
    area: i64,
    divisor: WideDivisor,
    /// The first pixel of its box.
    first: (i32, i32),
    /// Width and height of the box together, in pixels, rounded up.
    extent: u32,
}

impl Facet {
    /// The most pixels that the box of a facet may have in width and height together.
    pub const MOST: u32 = 3 << 12;

    /// The triangle between three places, in either winding.
    ///
    /// # Errors
    /// If its box is wider and higher, together, than [`MOST`](Self::MOST) pixels.
    #[inline]
    pub fn new(corners: [PointFx; 3]) -> Result<Self, TriangleTooLarge> {
        let facet = Self::of_any_size(corners);
        facet.fits(corners)?;
        Ok(facet)
    }

    /// Whether it is not too large, where it was made by [`of_any_size`](Self::of_any_size) of these corners.
    ///
    /// # Errors
    /// As those of [`new`](Self::new).
    #[inline(always)]
    pub(crate) fn fits(&self, corners: [PointFx; 3]) -> Result<(), TriangleTooLarge> {
        if self.extent > Self::MOST {
            return Err(too_large(corners));
        }
        Ok(())
    }

    /// The same, which means nothing for a triangle that is too large. It is where the caller wants it, as it is no part of a
    /// result: its 18 words are not copied.
    pub(crate) fn of_any_size(corners: [PointFx; 3]) -> Self {
        let [a, b, c] = corners.map(bits);
        let (left, right) = (a.0.min(b.0).min(c.0), a.0.max(b.0).max(c.0));
        let (upper, lower) = (a.1.min(b.1).min(c.1), a.1.max(b.1).max(c.1));
        let extent = right.abs_diff(left).saturating_add(lower.abs_diff(upper));
        let (mut b, mut c) =
            ((b.0.wrapping_sub(a.0), b.1.wrapping_sub(a.1)), (c.0.wrapping_sub(a.0), c.1.wrapping_sub(a.1)));
        let area = signed_product(b.0, c.1).wrapping_sub(signed_product(b.1, c.0));
        let is_clockwise = area >= 0;
        if !is_clockwise {
            let back = |(x, y): (i32, i32)| (x.wrapping_neg(), y.wrapping_neg());
            (b, c) = (back(b), back(c));
        }
        Self {
            corner: a,
            sides: [b, c],
            is_clockwise,
            area: area.wrapping_abs(),
            divisor: WideDivisor::new(area.unsigned_abs()),
            first: (first_centre_from(left), first_centre_from(upper)),
            extent: extent.div_ceil(256),
        }
    }

    /// Twice its area in units of 1/65,536 square pixel, whatever its winding.
    #[inline]
    pub const fn twice_area(&self) -> i64 {
        self.area
    }

    /// Whether its corners turn clockwise on the screen, where y points down. A triangle without area does.
    #[inline]
    pub const fn is_clockwise(&self) -> bool {
        self.is_clockwise
    }

    /// Where a place lies: exactly, for every place that there is.
    pub fn weights(&self, at: PointFx) -> Barycentric {
        let (a, [b, c], p) = (self.corner, self.sides, bits(at));
        let p = (difference(p.0, a.0), difference(p.1, a.1));
        // Seen from the first corner, the weight of the second is a cross product with the third, and the other way round. Products
        // are below 2^33 times 2^21.6.
        let cross = |(ax, ay): (i64, i64), (bx, by): (i64, i64)| ax.wrapping_mul(by).wrapping_sub(ay.wrapping_mul(bx));
        let wide = |(x, y): (i32, i32)| (i64::from(x), i64::from(y));
        let (second, third) = (cross(p, wide(c)), cross(wide(b), p));
        let first = self.area.wrapping_sub(second).wrapping_sub(third);
        Barycentric { weights: [first, second, third], total: self.area }
    }

    /// The first pixel of its box.
    #[inline(always)]
    pub(crate) const fn first(&self) -> (i32, i32) {
        self.first
    }

    /// The most pixels that a row of it may have.
    #[inline]
    pub(crate) fn width(&self) -> u32 {
        let [(b, _), (c, _)] = self.sides;
        b.unsigned_abs().max(c.unsigned_abs()).max(b.abs_diff(c)).div_ceil(256)
    }

    /// The most that a number changes over the triangle within half a pixel to the right or left and half a pixel up or down, rounded
    /// up.
    #[inline(never)]
    pub(crate) fn steepness(&self, corners: [u32; 3]) -> u32 {
        let [v0, v1, v2] = corners.map(i64::from);
        let ([b, c], product) = (self.sides, |v: i64, side: i32| v.wrapping_mul(side.into()));
        let (v1, v2) = (v1.wrapping_sub(v0), v2.wrapping_sub(v0));
        let right = product(v1, c.1).wrapping_sub(product(v2, b.1));
        let down = product(v2, b.0).wrapping_sub(product(v1, c.0));
        // Below 2^55.6 times 2^7.
        let (q, r) = self.divisor.quotient(right.wrapping_abs().wrapping_add(down.wrapping_abs()).wrapping_mul(128));
        let whole = u32::try_from(q).unwrap_or(u32::MAX);
        whole.saturating_add(u32::from(r != 0))
    }

    /// How often twice its area goes into a number; at most 2^31 - 1.
    #[inline]
    pub(crate) fn times_in(&self, n: i64) -> u32 {
        let (q, _) = self.divisor.quotient(n);
        unsigned(saturate(q))
    }

    /// From the first corner to the centre of the first pixel of the box, in units; less than 2^21.6.
    #[inline(always)]
    fn centre_of_first(&self) -> (i32, i32) {
        let centre = |pixel: i32| pixel.wrapping_mul(256).wrapping_add(128);
        (centre(self.first.0).wrapping_sub(self.corner.0), centre(self.first.1).wrapping_sub(self.corner.1))
    }

    /// How a byte changes: what is cut to the nearest value at the first pixel of the box, and what it gains to the right and
    /// downwards, with so many bits of fraction.
    ///
    /// The nearest whole number to N / D, halves upwards, is the whole part of (N + floor(D / 2)) / D. Each number is at least the
    /// true one, and above it by less than 1 + 2^(bits - 55) |n| / D, where n is a numerator: below 2^30.6 for a gain in a unit, below
    /// 2^52 for the start.
    #[inline(never)]
    pub(crate) fn byte_slopes(&self, [v0, v1, v2]: [u8; 3], bits: u32) -> [u64; 3] {
        let start = u64::from(v0) << (bits & 63);
        if self.area == 0 {
            return [start, 0, 0];
        }
        let [b, c] = self.sides;
        let (v1, v2) = (i32::from(v1).wrapping_sub(v0.into()), i32::from(v2).wrapping_sub(v0.into()));
        let right = v1.wrapping_mul(c.1).wrapping_sub(v2.wrapping_mul(b.1));
        let down = v2.wrapping_mul(b.0).wrapping_sub(v1.wrapping_mul(c.0));
        let (x, y) = self.centre_of_first();
        let n = signed_product(right, x).wrapping_add(signed_product(down, y)).wrapping_add(self.area >> 1);
        [
            start.wrapping_add(self.divisor.ratio(n, bits)),
            self.divisor.narrow_ratio(right, bits.wrapping_add(8)),
            self.divisor.narrow_ratio(down, bits.wrapping_add(8)),
        ]
    }

    /// Factors for 45 bits of fraction, if the triangle is small: at most so many pixels wide and high together, up to 512; not
    /// smaller than a quarter of a pixel; and D times its width and height, with 10 pixels more, is at most 2^36 less 3 %.
    #[inline(always)]
    fn small_scale(&self, extent: u32) -> Option<Scale> {
        let steps = i64::from(self.extent).wrapping_add(10);
        let most = (1 << 36) - (1 << 31);
        let is_small = self.extent <= extent && self.area >= 1 << 15 && self.area.wrapping_mul(steps) <= most;
        self.divisor.scale(Self::SMALL_BITS.wrapping_add(8)).filter(|_| is_small)
    }

    /// Bits of the fraction of slopes in small triangles.
    pub(crate) const SMALL_BITS: u32 = 37;

    /// [`byte_slopes`](Self::byte_slopes) with [`SMALL_BITS`](Self::SMALL_BITS) of levels of up to 6 bits, in a small triangle.
    ///
    /// Sides are at most 2^17 units long, and the product of width and height is at most 2^32. So what is gained in a unit is below
    /// 2^24, and the numerator of the start below 2^40.1. Gains are above the true ones by at most 2 + 2^-6 units of the fraction,
    /// the start by at most 9: with all steps, by less than 1 / D. No number is above 2^62.2, as D is at least 2^15.
    #[inline(always)]
    pub(crate) fn level_slopes(&self, levels: [[u8; 3]; 3]) -> Option<[[u64; 3]; 3]> {
        let scale = self.small_scale(512)?;
        Some(levels.map(|corners| self.small_slopes(scale, corners.map(i32::from), 2, 6)))
    }

    /// The same as a small triangle; means nothing if it is not [small](SmallFacet::is_small).
    #[inline(always)]
    pub(crate) fn small(&self) -> SmallFacet {
        let (x, y) = self.centre_of_first();
        let back = (unsigned(256_i32.wrapping_sub(x)), unsigned(256_i32.wrapping_sub(y)));
        let is_small = self.extent <= SmallFacet::MOST && self.area >= i64::from(SmallFacet::LEAST_AREA);
        let scale = self.divisor.scale(SmallFacet::BITS).filter(|_| is_small);
        SmallFacet { sides: self.sides, first: self.first, back, scale: scale.unwrap_or_default() }
    }

    #[inline(always)]
    fn small_slopes(&self, scale: Scale, [v0, v1, v2]: [i32; 3], more: i64, more_at_start: u64) -> [u64; 3] {
        let [b, c] = self.sides;
        let (v1, v2) = (v1.wrapping_sub(v0), v2.wrapping_sub(v0));
        let right = v1.wrapping_mul(c.1).wrapping_sub(v2.wrapping_mul(b.1));
        let down = v2.wrapping_mul(b.0).wrapping_sub(v1.wrapping_mul(c.0));
        let (x, y) = self.centre_of_first();
        let n = signed_product(right, x).wrapping_add(signed_product(down, y)).wrapping_add(self.area >> 1);
        let start =
            (i64::from(v0) << Self::SMALL_BITS).cast_unsigned().wrapping_add(scale.wide_ratio(n, more_at_start));
        [start, scale.ratio(right, more), scale.ratio(down, more)]
    }

    /// The same for any number: with 64 bits of fraction, above the true numbers by at most 3 or, if `is_wide`, 6 units.
    ///
    /// If not `is_wide`, the values differ by less than 2^18. The gain of a unit is below 2^23.6 times a difference of values.
    #[inline]
    pub(super) fn slopes(&self, [v0, v1, v2]: [i64; 3], is_wide: bool) -> [Mixed; 3] {
        let (start, half) = (Mixed::from_whole(narrow(v0)), self.area >> 1);
        if self.area == 0 {
            return [start, Mixed::default(), Mixed::default()];
        }
        let ([b, c], times) = (self.sides, |v: i64, n: i32| v.wrapping_mul(n.into()));
        let (v1, v2) = (v1.wrapping_sub(v0), v2.wrapping_sub(v0));
        let right = times(v1, c.1).wrapping_sub(times(v2, b.1));
        let down = times(v2, b.0).wrapping_sub(times(v1, c.0));
        let (x, y) = self.centre_of_first();
        if !is_wide {
            // Below 2^63.
            let n = times(right, x).wrapping_add(times(down, y));
            return [
                start + self.divisor.divide(n.wrapping_add(half)),
                self.divisor.divide(right.wrapping_mul(256)),
                self.divisor.divide(down.wrapping_mul(256)),
            ];
        }
        let [along, below] = [right, down].map(|n| self.divisor.quotient(n));
        // A remainder is below 2^41.2, times a distance below 2^62.8.
        let part = |(q, r): (i64, u64), n: i32, more: i64| {
            let rest = times(signed_wide(r), n).wrapping_add(more);
            Mixed::from_whole(narrow(times(q, n))) + self.divisor.divide(rest)
        };
        [start + part(along, x, half) + part(below, y, 0), part(along, 256, 0), part(below, 256, 0)]
    }
}

/// A small triangle over which values change: 63 pixels wide and high together, and not smaller than a pixel.
///
/// In a mesh nearly all triangles are small, and to set them up costs as much as their pixels. So there is no more to it than what their
/// values take: 32 bits are enough for D, which is from 2^17 to 2^26. See [`small`](super::small).
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct SmallFacet {
    /// As those of a [`Facet`].
    sides: [(i32, i32); 2],
    /// The first pixel of its box.
    first: (i32, i32),
    /// From the pixel before the first of the box, each way, to the first corner, in units: at least half a pixel, less than 2^16.
    back: (u32, u32),
    /// For [`BITS`](Self::BITS) of fraction; 0 of a triangle that is not small.
    scale: Scale,
}

impl SmallFacet {
    /// Bits of the fraction of numbers.
    pub(crate) const BITS: u32 = 48;
    /// The most pixels that its box may have in width and height together.
    const MOST: u32 = 63;
    /// The least twice its area may be.
    const LEAST_AREA: u32 = 1 << 17;

    /// The triangle between three places, in either winding. Of one that is not [small](Self::is_small) nothing is computed: the result
    /// says that it is not. An `Option` would be copied once more.
    // Not inlined: it is the same for all values.
    #[inline(never)]
    pub(crate) fn new(corners: &[PointFx; 3]) -> Self {
        let [a, b, c] = corners.map(bits);
        let (left, right) = (a.0.min(b.0).min(c.0), a.0.max(b.0).max(c.0));
        let (upper, lower) = (a.1.min(b.1).min(c.1), a.1.max(b.1).max(c.1));
        if right.abs_diff(left).saturating_add(lower.abs_diff(upper)) > 256 * Self::MOST {
            return Self::default();
        }
        // Sides are below 2^14.
        let side = |to: (i32, i32)| (to.0.wrapping_sub(a.0), to.1.wrapping_sub(a.1));
        let (mut b, mut c) = (side(b), side(c));
        let area = b.0.wrapping_mul(c.1).wrapping_sub(b.1.wrapping_mul(c.0));
        if area < 0 {
            let back = |(x, y): (i32, i32)| (x.wrapping_neg(), y.wrapping_neg());
            (b, c) = (back(b), back(c));
        }
        let area = area.unsigned_abs();
        if area < Self::LEAST_AREA {
            return Self::default();
        }
        let first = (first_centre_from(left), first_centre_from(upper));
        let back = |corner: i32, first: i32| unsigned(corner.wrapping_sub(first.wrapping_mul(256)).wrapping_add(128));
        let back = (back(a.0, first.0), back(a.1, first.1));
        Self { sides: [b, c], first, back, scale: Scale::small(area) }
    }

    /// Whether it is small.
    #[inline(always)]
    pub(crate) fn is_small(&self) -> bool {
        self.scale != Scale::default()
    }

    /// The first pixel of its box.
    #[inline(always)]
    pub(crate) const fn first(&self) -> (i32, i32) {
        self.first
    }

    /// The slopes of a number of up to 16 bits, with [`BITS`](Self::BITS) of fraction in 64 bits: at the first pixel of the
    /// box, to the right, and downwards.
    ///
    /// All of it is computed from what is gained in a unit, above which is D: the numerator is below 2^31, and the ratio above the true
    /// one by at most 5 units of the fraction. No pixel of the triangle is farther from the first corner than 63 pixels, so numbers
    /// are off by at most 80,640 units; 2^17 are added. A half is not below floor(D / 2) / D, and above it by at most half of 1 / D. The
    /// other half of that is more than 2^21 units.
    #[inline(always)]
    pub(crate) fn words(&self, [v0, v1, v2]: [i32; 3]) -> [u64; 3] {
        let scale = self.scale;
        let ([b, c], (v1, v2)) = (self.sides, (v1.wrapping_sub(v0), v2.wrapping_sub(v0)));
        let right = scale.ratio(v1.wrapping_mul(c.1).wrapping_sub(v2.wrapping_mul(b.1)), 3);
        let down = scale.ratio(v2.wrapping_mul(b.0).wrapping_sub(v1.wrapping_mul(c.0)), 3);
        let (back_x, back_y) = self.back;
        let way = wide_times_small(right, back_x).wrapping_add(wide_times_small(down, back_y));
        let at = (i64::from(v0) << Self::BITS).cast_unsigned().wrapping_add((1 << (Self::BITS - 1)) + (1 << 17));
        let (right, down) = (right << 8, down << 8);
        [at.wrapping_sub(way).wrapping_add(right).wrapping_add(down), right, down]
    }

    /// The slopes of levels of up to 6 bits, with [`SMALL_BITS`](Facet::SMALL_BITS) of fraction.
    ///
    /// The numerator of a gain in a unit is below 2^20, so a gain is below 2^48. It is off by at most 1 + 2^-10 units of the fraction.
    /// The start is computed from the first corner: that is not farther away than 64 pixels, be it from there or from a pixel of the
    /// triangle, and the way to it is below 2^63. So numbers are off by less than 65 units, and one more for what is cut away; 66 are
    /// added. A half is not below floor(D / 2) / D, and above it by at most half of 1 / D. The other half of that is more than 2^9
    /// units.
    #[inline(always)]
    pub(crate) fn levels(&self, [a, b, c]: [[u8; 3]; 3]) -> [[u64; 3]; 3] {
        [self.level(a), self.level(b), self.level(c)]
    }

    #[inline(always)]
    fn level(&self, [v0, v1, v2]: [u8; 3]) -> [u64; 3] {
        let ([b, c], scale) = (self.sides, self.scale.less(3));
        let (v1, v2) = (i32::from(v1).wrapping_sub(v0.into()), i32::from(v2).wrapping_sub(v0.into()));
        let right = scale.narrow_ratio(v1.wrapping_mul(c.1).wrapping_sub(v2.wrapping_mul(b.1)));
        let down = scale.narrow_ratio(v2.wrapping_mul(b.0).wrapping_sub(v1.wrapping_mul(c.0)));
        let (back_x, back_y) = self.back;
        let way = wide_times_small(right, back_x).wrapping_add(wide_times_small(down, back_y));
        let beyond = (u64::from(v0) << Facet::SMALL_BITS).wrapping_add((1 << (Facet::SMALL_BITS - 1)) + 66);
        let start = beyond.wrapping_sub((signed_wide(way) >> 8).cast_unsigned()).wrapping_add(right).wrapping_add(down);
        [start, right, down]
    }
}

/// How large a triangle is that is too large.
#[cold]
fn too_large(corners: [PointFx; 3]) -> TriangleTooLarge {
    let [a, b, c] = corners.map(bits);
    let extent = |a: i32, b: i32, c: i32| a.max(b).max(c).abs_diff(a.min(b).min(c)).div_ceil(256);
    TriangleTooLarge { width: extent(a.0, b.0, c.0), height: extent(a.1, b.1, c.1), most: Facet::MOST }
}

/// Where a place lies in a triangle: three weights, and their sum. The place is the mean of the corners, weighted so.
///
/// A weight of a [`Facet`] is not negative inside. Outside, one or two are.
/// ```
/// use embedded_raster::geom::Barycentric;
/// // A fifth of the first colour, three tenths of the second, half of the third.
/// let place = Barycentric { weights: [2, 3, 5], total: 10 };
/// let colors = [(255, 0, 0), (255, 51, 0), (255, 0, 51)];
/// assert_eq!(place.mix(colors.map(|c| c.1)), 15);
/// assert_eq!(place.mix(colors.map(|c| c.2)), 26);
/// ```
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Barycentric {
    /// One for each corner.
    pub weights: [i64; 3],
    /// Their sum, below 2^46. Not negative; 0 for a triangle without area.
    pub total: i64,
}

impl Barycentric {
    /// Whether the place lies in the triangle or on one of its sides.
    #[inline]
    pub fn is_inside(&self) -> bool {
        self.total > 0 && self.weights.iter().all(|&w| w >= 0)
    }

    /// Whether the place lies in the triangle and on none of its sides.
    #[inline]
    pub fn is_strictly_inside(&self) -> bool {
        self.total > 0 && self.weights.iter().all(|&w| w > 0)
    }

    /// The weights as parts of 1. They sum to exactly 1 as long as none of them is above 32,767 or below -32,768, where they stop.
    ///
    /// The first two are the nearest numbers, the third is what is left: off by at most 2^-16. A triangle without area has the
    /// weights 1, 0, 0.
    pub fn parts(&self) -> [I16F16; 3] {
        let [a, b, _] = self.weights;
        if self.total <= 0 {
            return [I16F16::ONE, I16F16::ZERO, I16F16::ZERO];
        }
        let divisor = WideDivisor::new(magnitude(self.total));
        // A weight is below 2^56: divided first, its rest times 2^16 is below 2^58.
        let part = |w: i64| {
            let (q, r) = divisor.quotient(w);
            let rest = divisor.divide((signed_wide(r) << 16).wrapping_add(self.total >> 1));
            q.saturating_mul(1 << 16).saturating_add(rest.whole.into())
        };
        let (a, b) = (part(a), part(b));
        let rest = 0x1_0000_i64.saturating_sub(a).saturating_sub(b);
        [a, b, rest].map(|n| I16F16::from_bits(saturate(n)))
    }

    /// The value at the place: the nearest whole number to the exact mean of three values, halves upwards.
    ///
    /// Inside, it is never out of the range of the three. Outside, it stops at the ends of the type. Without area, it is the first
    /// value.
    pub fn mix(&self, values: [i32; 3]) -> i32 {
        if self.total <= 0 {
            return values[0];
        }
        let divisor = WideDivisor::new(magnitude(self.total));
        let [v0, v1, v2] = values.map(i64::from);
        let [_, w1, w2] = self.weights;
        let (q1, r1) = product(&divisor, w1, v1.wrapping_sub(v0));
        let (q2, r2) = product(&divisor, w2, v2.wrapping_sub(v0));
        let (half, _) = divisor.quotient(signed_wide(r1.wrapping_add(r2)).wrapping_add(self.total >> 1));
        let sum = q1.wrapping_add(q2).wrapping_add(v0.wrapping_add(half).into());
        saturate(i64::try_from(sum).unwrap_or(if sum < 0 { i64::MIN } else { i64::MAX }))
    }
}

/// Quotient and remainder of `w v` by a divisor below 2^46, for a v of 33 bits: digit by digit, as the product may have 97 bits.
fn product(divisor: &WideDivisor, w: i64, v: i64) -> (i128, u64) {
    let (whole, rest) = divisor.quotient(w);
    let (rest, high, low) = (signed_wide(rest), v >> 16, v & 0xffff);
    let (q1, r1) = divisor.quotient(rest.wrapping_mul(high));
    let (q2, r2) = divisor.quotient((signed_wide(r1) << 16).wrapping_add(rest.wrapping_mul(low)));
    // What is left of q: below v.
    let part = q1.wrapping_mul(1 << 16).wrapping_add(q2);
    (i128::from(whole).wrapping_mul(v.into()).wrapping_add(part.into()), r2)
}

#[cfg(test)]
mod tests {
    use super::*;
    use twins::rng::Rng;

    #[test]
    fn small_triangles_are_set_up_as_any() {
        let (mut rng, mut small) = (Rng::new(401), 0);
        for i in 0..100_000 {
            let most = [300, 900, 4_000, 8_000, 8_064, 16_128, 20_000, i32::MAX][i % 8];
            let (x, y) = (rng.int(-90_000, 90_000), rng.int(-90_000, 90_000));
            let mut corner = || {
                let (right, down) = (rng.int(0, most), rng.int(0, most));
                PointFx::from_bits(x.wrapping_add(right), y.wrapping_add(rng.pick(&[0, down, most])))
            };
            let corners = [corner(), corner(), corner()];
            let (found, wanted) = (SmallFacet::new(&corners), Facet::of_any_size(corners).small());
            assert_eq!(found.is_small(), wanted.is_small(), "{corners:?}");
            if found.is_small() {
                assert_eq!(found, wanted, "{corners:?}");
                small += 1;
            }
        }
        assert!(small > 20_000, "only {small} are small");
    }
}
