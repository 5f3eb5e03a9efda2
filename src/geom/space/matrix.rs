//! [`Mat4`]: motions in space, and cameras.

use core::ops::Mul;

use fixed::types::I16F16;

use super::{
    number::{self, from_2_30},
    vector::{cross, unit, Scale, Vec3, Vec4},
};
use crate::{
    geom::Angle,
    num::{
        cast::{signed, unsigned},
        recip::Denominator,
        round::difference,
        wide::{nearest, Sum},
    },
};

const ONE: i32 = 1 << 16;

/// A matrix of four rows, for vectors that are columns: each coordinate of the result is a row times the vector.
/// ```text
///   | x' |   | a b c d |   | x |
///   | y' | = | e f g h | . | y |        x' = a x + b y + c z + d w       d, h, l move a place (w = 1),
///   | z' |   | i j k l |   | z |                                         but no direction (w = 0)
///   | w' |   | m n o p |   | w |
/// ```
/// `projection * view * model` is what happens to a place: the model first. Each number of a product, and each coordinate of a
/// result, is rounded once, from the exact sum of four products, to the nearest number, halves upwards. It stops at the ends of
/// the range.
///
/// # From the world to the screen
/// ```text
///    world ---look_at---> camera ---perspective---> clip ---Vec4::project---> NDC
///
///    camera: looks along -z, y up          NDC:  x -1 ... 1   left to right
///                                                y -1 ... 1   bottom to top
///          y |   / far                           z  0 ... 1   near to far
///            | /
///      eye   o------ near    -z
/// ```
/// Depth is from 0 to 1. So what lies behind the near plane is what has z < 0, which needs no other number to compare with; and
/// a depth buffer of unsigned numbers takes z / w as it is.
///
/// # Precision
/// A clip coordinate that is w in size has as many bits as w has, and with 16 of them after the point a w of 0.1 has 13. But only
/// the ratios of clip coordinates matter. So [`perspective`](Self::perspective), [`frustum`](Self::frustum) and
/// [`orthographic`](Self::orthographic) multiply their matrix by a power of two, about the largest one with which
/// - w is at most 8,192, so that x and y do not stop before they are four times outside of the picture;
/// - no number of the matrix is beyond 8,192;
/// - at the near plane of a perspective, w is below 2: more bits would be of no use there.
///
/// Multiplying the matrices of a scene first, and places by the product, rounds each coordinate once only.
/// ```
/// use embedded_raster::{Angle, Mat4, Vec3};
/// use fixed::types::I16F16;
/// let [near, far, square] = [1, 100, 1].map(I16F16::from_num);
/// let camera = Mat4::perspective(Angle::degrees(90), square, near, far)
///     * Mat4::look_at(Vec3::whole(0, 0, 10), Vec3::ZERO, Vec3::Y);
/// // 10 in front of the eye, half of the picture is 10 high.
/// let at = camera.transform_point(Vec3::whole(5, -10, 0)).project();
/// assert_eq!((at.x, at.y), (I16F16::from_num(0.5), I16F16::from_num(-1)));
/// assert!(at.z > 0 && at.z < 1);
/// ```
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub struct Mat4 {
    /// From top to bottom.
    pub rows: [Vec4; 4],
}

impl Mat4 {
    /// Changes nothing.
    pub const IDENTITY: Self = Self::scale(Vec3::whole(1, 1, 1));

    /// Of rows, in units of `2^-16`.
    #[inline]
    pub const fn from_bits([a, b, c, d]: [[i32; 4]; 4]) -> Self {
        Self { rows: [Vec4::from_bits(a), Vec4::from_bits(b), Vec4::from_bits(c), Vec4::from_bits(d)] }
    }

    /// The rows, in units of `2^-16`.
    #[inline]
    pub const fn to_bits(self) -> [[i32; 4]; 4] {
        let [a, b, c, d] = self.rows;
        [a.to_bits(), b.to_bits(), c.to_bits(), d.to_bits()]
    }

    /// Rows of three numbers each, and a place that (0, 0, 0) is moved to.
    const fn affine([a, b, c]: [[i32; 3]; 3], to: [i32; 3]) -> Self {
        Self::from_bits([
            [a[0], a[1], a[2], to[0]],
            [b[0], b[1], b[2], to[1]],
            [c[0], c[1], c[2], to[2]],
            [0, 0, 0, ONE],
        ])
    }

    /// Moves by `by`. Exact.
    pub const fn translate(by: Vec3) -> Self {
        Self::affine([[ONE, 0, 0], [0, ONE, 0], [0, 0, ONE]], by.to_bits())
    }

    /// Multiplies each coordinate by one of `by`. Exact.
    pub const fn scale(by: Vec3) -> Self {
        let [x, y, z] = by.to_bits();
        Self::affine([[x, 0, 0], [0, y, 0], [0, 0, z]], [0; 3])
    }

    /// Turns around the x axis, y towards z. Each number is at most 0.5001 ulp off.
    pub const fn rotate_x(angle: Angle) -> Self {
        let (c, s) = cos_sin(angle);
        Self::affine([[ONE, 0, 0], [0, c, s.wrapping_neg()], [0, s, c]], [0; 3])
    }

    /// Turns around the y axis, z towards x. Each number is at most 0.5001 ulp off.
    pub const fn rotate_y(angle: Angle) -> Self {
        let (c, s) = cos_sin(angle);
        Self::affine([[c, 0, s], [0, ONE, 0], [s.wrapping_neg(), 0, c]], [0; 3])
    }

    /// Turns around the z axis, x towards y. Each number is at most 0.5001 ulp off.
    pub const fn rotate_z(angle: Angle) -> Self {
        let (c, s) = cos_sin(angle);
        Self::affine([[c, s.wrapping_neg(), 0], [s, c, 0], [0, 0, ONE]], [0; 3])
    }

    /// Turns around an axis of any length, counter-clockwise as seen from its tip. Around (0, 0, 0) it changes nothing.
    ///
    /// Each number is at most 0.501 ulp off.
    pub const fn rotate(axis: Vec3, angle: Angle) -> Self {
        let [x, y, z] = axis.to_bits();
        let [x, y, z] = unit([x as i64, y as i64, z as i64]);
        if x | y | z == 0 {
            return Self::IDENTITY;
        }
        // c I + (1 - c) axis axis^T + s [axis]: the axis, and its multiples by 1 - c and by s, are in 2.30.
        let (c, s) = angle.cos_sin();
        let (c, s, versine) = (c as i64, s as i64, (1_i64 << 30).wrapping_sub(c as i64));
        let (ux, uy, uz) = (times(versine, x), times(versine, y), times(versine, z));
        let (sx, sy, sz) = (times(s, x), times(s, y), times(s, z));
        Self::affine(
            [
                [entry(ux, x, c), entry(ux, y, sz.wrapping_neg()), entry(ux, z, sy)],
                [entry(uy, x, sz), entry(uy, y, c), entry(uy, z, sx.wrapping_neg())],
                [entry(uz, x, sy.wrapping_neg()), entry(uz, y, sx), entry(uz, z, c)],
            ],
            [0; 3],
        )
    }

    /// The camera at `eye` that looks at `target`: from the world to places seen from there, x to the right, y up, -z ahead.
    ///
    /// * `up`: what is up in the picture, of any length. It need not be at right angles to the direction of sight.
    ///
    /// Where the eye is the target, the camera looks along -z. Where up is zero, or along the direction of sight, the axis that is
    /// furthest from that is up. With up at right angles to the direction of sight, numbers of the rotation are at most 0.51 ulp
    /// off; those of the translation 0.5 ulp, and 0.0002 ulp for each unit between the eye and (0, 0, 0). With another up, that
    /// is divided by the sine of the angle between the two.
    pub const fn look_at(eye: Vec3, target: Vec3, up: Vec3) -> Self {
        let ([ex, ey, ez], [tx, ty, tz], [ux, uy, uz]) = (eye.to_bits(), target.to_bits(), up.to_bits());
        let back = match unit([difference(ex, tx), difference(ey, ty), difference(ez, tz)]) {
            [0, 0, 0] => [0, 0, 1 << 30],
            back => back,
        };
        let up = unit([ux as i64, uy as i64, uz as i64]);
        let right = match unit(totals(cross(up, back))) {
            [0, 0, 0] => unit(totals(cross(furthest_axis(back), back))),
            right => right,
        };
        let [x, y, z] = cross(back, right);
        let up = [x.nearest(30), y.nearest(30), z.nearest(30)];
        let eye = [ex, ey, ez];
        Self::affine([to_16(right), to_16(up), to_16(back)], [moved(right, eye), moved(up, eye), moved(back, eye)])
    }

    /// What a camera sees in a picture with the eye in front of its middle.
    ///
    /// * `height`: the angle between the bottom and the top of the picture, below half a turn.
    /// * `aspect`: width divided by height, above 0.
    /// * `near`, `far`: how far ahead the planes are where depth is 0 and 1; 0 < `near` < `far`.
    ///
    /// Numbers are at most half an ulp off, and `2^-22` of the largest; of angles from 1/3 to 1 degree, `2^-21`. Arguments that make
    /// no camera make some matrix.
    pub const fn perspective(height: Angle, aspect: I16F16, near: I16F16, far: I16F16) -> Self {
        // The cotangent of half the angle, and that divided by the aspect.
        let (c, s) = Angle::from_bits(height.to_bits() >> 1).cos_sin();
        let (c, s) = (c as i64, s as i64);
        let x = Fraction::new(c << 16, s.wrapping_mul(aspect.to_bits() as i64), 16);
        Self::lens([x, Fraction::ZERO], [Fraction::new(c, s, 16), Fraction::ZERO], near, far)
    }

    /// What a camera sees through a window in the near plane, be it in front of the eye or aside.
    ///
    /// * `x`, `y`: the sides of the window: left and right, bottom and top, as seen from the eye.
    /// * `near`, `far`: as of [`perspective`](Self::perspective).
    ///
    /// Numbers are at most half an ulp off, and `2^-29` of the largest.
    pub const fn frustum(x: [I16F16; 2], y: [I16F16; 2], near: I16F16, far: I16F16) -> Self {
        let double = (near.to_bits() as i64) << 1;
        let ([dx, sx], [dy, sy]) = (differ_and_add(x), differ_and_add(y));
        let x = [Fraction::new(double, dx, 16), Fraction::new(sx, dx, 16)];
        let y = [Fraction::new(double, dy, 16), Fraction::new(sy, dy, 16)];
        Self::lens(x, y, near, far)
    }

    /// A perspective: x and y are multiples of themselves and of z, w is -z.
    const fn lens(x: [Fraction; 2], y: [Fraction; 2], near: I16F16, far: I16F16) -> Self {
        let (near, far) = (near.to_bits(), far.to_bits());
        let depth = difference(far, near);
        // At the near plane -z = near, and depth 0; at the far plane -z = far, and depth 1.
        let z = Fraction::new((far as i64).wrapping_neg(), depth, 16);
        let z_w = Fraction::new((far as i64).wrapping_mul(near as i64).wrapping_neg(), depth, 0);
        // Below 2 and below 2^13 after so many doublings.
        let power = least(near.leading_zeros().saturating_sub(15), far.leading_zeros().saturating_sub(3));
        let power = least(x[0].room(x[1].room(y[0].room(y[1].room(z.room(z_w.room(power)))))), MOST);
        Self::from_bits([
            [x[0].nearest(power), 0, x[1].nearest(power), 0],
            [0, y[0].nearest(power), y[1].nearest(power), 0],
            [0, 0, z.nearest(power), z_w.nearest(power)],
            [0, 0, ONE.wrapping_shl(power).wrapping_neg(), 0],
        ])
    }

    /// What a camera sees whose lines of sight are parallel: a box.
    ///
    /// * `x`, `y`: its sides: left and right, bottom and top.
    /// * `near`, `far`: how far ahead depth is 0 and 1. They may be negative, behind the camera.
    ///
    /// w is the same for all places, and makes the other numbers as large as they can be; they are at most 0.5001 ulp off.
    /// ```
    /// use embedded_raster::{Mat4, Vec3};
    /// use fixed::types::I16F16;
    /// let [left, right, bottom, top, near, far] = [0, 320, 240, 0, -1, 1].map(I16F16::from_num);
    /// let screen = Mat4::orthographic([left, right], [bottom, top], near, far);
    /// assert_eq!(screen.transform_point(Vec3::whole(240, 0, 0)).project(), Vec3::from_bits([1 << 15, 1 << 16, 1 << 15]));
    /// ```
    pub const fn orthographic(x: [I16F16; 2], y: [I16F16; 2], near: I16F16, far: I16F16) -> Self {
        let ([dx, sx], [dy, sy]) = (differ_and_add(x), differ_and_add(y));
        let (near, depth) = (near.to_bits() as i64, difference(far.to_bits(), near.to_bits()));
        let one = ONE as i64;
        let x = [Fraction::new(one << 1, dx, 16), Fraction::new(sx.wrapping_neg(), dx, 16)];
        let y = [Fraction::new(one << 1, dy, 16), Fraction::new(sy.wrapping_neg(), dy, 16)];
        let z = [Fraction::new(one.wrapping_neg(), depth, 16), Fraction::new(near.wrapping_neg(), depth, 16)];
        let power = x[0].room(x[1].room(y[0].room(y[1].room(z[0].room(z[1].room(MOST))))));
        Self::from_bits([
            [x[0].nearest(power), 0, 0, x[1].nearest(power)],
            [0, y[0].nearest(power), 0, y[1].nearest(power)],
            [0, 0, z[0].nearest(power), z[1].nearest(power)],
            [0, 0, 0, ONE.wrapping_shl(power)],
        ])
    }

    /// The way back, of a matrix that turns and moves only: of a product of [`rotate`](Self::rotate) and
    /// [`translate`](Self::translate), or of [`look_at`](Self::look_at).
    ///
    /// Each number is what the transposed rotation makes of the numbers given, rounded once. There and back is as exact as the
    /// rotation is: of a place d away from (0, 0, 0), `2^-15` d off at most.
    #[must_use]
    pub const fn inverse_rigid(self) -> Self {
        let [[a, b, c, x], [d, e, f, y], [g, h, i, z], _] = self.to_bits();
        Self::affine(
            [[a, d, g], [b, e, h], [c, f, i]],
            [
                Sum::ZERO.minus(a, x).minus(d, y).minus(g, z).nearest(16),
                Sum::ZERO.minus(b, x).minus(e, y).minus(h, z).nearest(16),
                Sum::ZERO.minus(c, x).minus(f, y).minus(i, z).nearest(16),
            ],
        )
    }

    /// What normals are transformed by, with [`transform_direction`](Self::transform_direction), when places are transformed by
    /// this matrix: the inverse of the upper left three rows and columns, transposed, times some positive number. Normalize
    /// what it makes.
    ///
    /// It needs no division: these are the cross products of the rows, all with the sign of the determinant. So a mirror leaves a
    /// normal on the side where it was. The largest number is from 32 to 64; no number is more than half a unit of `2^-16` off, and
    /// `2^-27` of the largest. A matrix that flattens space has a normal matrix of the flat image, or zero.
    #[must_use]
    pub const fn normal_matrix(self) -> Self {
        let [[a, b, c, _], [d, e, f, _], [g, h, i, _], _] = self.to_bits();
        // Products of numbers of 30 bits add up to less than 2^62.
        let all = size(a) | size(b) | size(c) | size(d) | size(e) | size(f) | size(g) | size(h) | size(i);
        let scale = Scale::to_bits(30, all);
        let rows = [scale.of_all(wide([a, b, c])), scale.of_all(wide([d, e, f])), scale.of_all(wide([g, h, i]))];
        let [p, q, r] =
            [totals(cross(rows[1], rows[2])), totals(cross(rows[2], rows[0])), totals(cross(rows[0], rows[1]))];
        let all = sizes(p) | sizes(q) | sizes(r);
        let scale = Scale::to_bits(22, all);
        let [p, q, r] = [scale.of_all(p), scale.of_all(q), scale.of_all(r)];
        let ([x, y, z], [k, l, m]) = (rows[0], p);
        let outward = Sum::ZERO.plus(x, k).plus(y, l).plus(z, m).total() >= 0;
        Self::affine(if outward { [p, q, r] } else { [opposite(p), opposite(q), opposite(r)] }, [0; 3])
    }

    /// A place, with w = 1: in clip coordinates, if the matrix has a projection in it.
    #[inline]
    pub const fn transform_point(&self, at: Vec3) -> Vec4 {
        self.transform(at.with_w(I16F16::ONE))
    }

    /// A direction, with w = 0: it is turned and scaled, but not moved.
    #[inline]
    pub const fn transform_direction(&self, v: Vec3) -> Vec3 {
        let v = v.with_w(I16F16::ZERO);
        let [a, b, c, _] = self.rows;
        Vec3::new(a.dot(v), b.dot(v), c.dot(v))
    }

    /// The matrix times a column: also `matrix * v`.
    #[inline]
    pub const fn transform(&self, v: Vec4) -> Vec4 {
        let [a, b, c, d] = self.rows;
        Vec4::new(a.dot(v), b.dot(v), c.dot(v), d.dot(v))
    }

    /// What `other` does, and then this: also `self * other`.
    #[must_use]
    pub const fn times(&self, other: &Self) -> Self {
        let [[a, b, c, d], [e, f, g, h], [i, j, k, l], [m, n, o, p]] = other.to_bits();
        let columns = [[a, e, i, m], [b, f, j, n], [c, g, k, o], [d, h, l, p]];
        let [a, b, c, d] = columns;
        // Each column of the other one, transformed, is one of the product.
        let turned = [
            self.transform(Vec4::from_bits(a)).to_bits(),
            self.transform(Vec4::from_bits(b)).to_bits(),
            self.transform(Vec4::from_bits(c)).to_bits(),
            self.transform(Vec4::from_bits(d)).to_bits(),
        ];
        let [[a, b, c, d], [e, f, g, h], [i, j, k, l], [m, n, o, p]] = turned;
        Self::from_bits([[a, e, i, m], [b, f, j, n], [c, g, k, o], [d, h, l, p]])
    }
}

impl Default for Mat4 {
    /// [`IDENTITY`](Self::IDENTITY).
    fn default() -> Self {
        Self::IDENTITY
    }
}

/// What the right one does, and then the left one.
impl Mul for Mat4 {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        self.times(&other)
    }
}

impl Mul<Vec4> for Mat4 {
    type Output = Vec4;

    #[inline]
    fn mul(self, v: Vec4) -> Vec4 {
        self.transform(v)
    }
}

/// A quotient times a power of two, to be multiplied by another one before it is rounded.
#[derive(Copy, Clone)]
struct Fraction {
    n: i64,
    d: Denominator,
    /// It is `n 2^shift / d`.
    shift: i32,
}

impl Fraction {
    const ZERO: Self = Self::new(0, ONE as i64, 0);

    /// `n 2^shift / d`; a long `d` is rounded to 30 bits.
    const fn new(n: i64, d: i64, shift: i32) -> Self {
        let scale = Scale::to_at_most_bits(30, d.unsigned_abs());
        Self { n, d: Denominator::new(scale.of(d)), shift: shift.wrapping_add(scale.left) }
    }

    /// The nearest number to `2^power` times it. Stops at the ends of the range.
    const fn nearest(self, power: u32) -> i32 {
        let shift = self.shift.wrapping_add(signed(power));
        if shift < 0 {
            return self.d.under(self.n >> (shift.wrapping_neg() & 63));
        }
        // Where bits would be lost, the quotient by less than 2^31 is beyond the range in any case.
        let free = self.n.unsigned_abs().leading_zeros();
        self.d.under(if unsigned(shift) < free {
            self.n << (shift & 63)
        } else if self.n < 0 {
            i64::MIN
        } else {
            i64::MAX
        })
    }

    /// How many doublings, up to `most`, leave it below `2^29` units: 8,192.
    const fn room(self, most: u32) -> u32 {
        least(most, self.nearest(0).unsigned_abs().leading_zeros().saturating_sub(3))
    }
}

/// The largest power of two that a projection is multiplied by: w is at most `2^13`.
const MOST: u32 = 13;

const fn least(a: u32, b: u32) -> u32 {
    if a < b {
        a
    } else {
        b
    }
}

/// The difference and the sum of two bounds.
const fn differ_and_add([low, high]: [I16F16; 2]) -> [i64; 2] {
    let (low, high) = (low.to_bits(), high.to_bits());
    [difference(high, low), (high as i64).wrapping_add(low as i64)]
}

const fn cos_sin(angle: Angle) -> (i32, i32) {
    let (c, s) = number::cos_sin(angle);
    (c.to_bits(), s.to_bits())
}

/// `m x` in 2.30 of two of them, m up to 2.
const fn times(m: i64, x: i32) -> i64 {
    m.wrapping_mul(x as i64).wrapping_add(1 << 29) >> 30
}

/// `m x + plus` in 16.16 of numbers in 2.30, up to 2 each.
const fn entry(m: i64, x: i32, plus: i64) -> i32 {
    nearest(m.wrapping_mul(x as i64).wrapping_add(plus << 30), 44)
}

const fn totals([x, y, z]: [Sum; 3]) -> [i64; 3] {
    [x.total(), y.total(), z.total()]
}

const fn to_16([x, y, z]: [i32; 3]) -> [i32; 3] {
    [from_2_30(x).to_bits(), from_2_30(y).to_bits(), from_2_30(z).to_bits()]
}

/// Minus the dot product of an axis in 2.30 and a place in 16.16.
const fn moved([x, y, z]: [i32; 3], [a, b, c]: [i32; 3]) -> i32 {
    Sum::ZERO.minus(x, a).minus(y, b).minus(z, c).nearest(30)
}

/// The axis of which a direction has least.
const fn furthest_axis([x, y, z]: [i32; 3]) -> [i32; 3] {
    let (x, y, z) = (x.unsigned_abs(), y.unsigned_abs(), z.unsigned_abs());
    if y <= x && y <= z {
        [0, 1 << 30, 0]
    } else if x <= z {
        [1 << 30, 0, 0]
    } else {
        [0, 0, 1 << 30]
    }
}

const fn wide([x, y, z]: [i32; 3]) -> [i64; 3] {
    [x as i64, y as i64, z as i64]
}

const fn size(n: i32) -> u64 {
    n.unsigned_abs() as u64
}

const fn sizes([x, y, z]: [i64; 3]) -> u64 {
    x.unsigned_abs() | y.unsigned_abs() | z.unsigned_abs()
}

const fn opposite([x, y, z]: [i32; 3]) -> [i32; 3] {
    [x.wrapping_neg(), y.wrapping_neg(), z.wrapping_neg()]
}
