//! Free-form surfaces: bicubic Bézier patches, cut into triangles without a gap.
//!
//! ```text
//!   v = 1   12---13---14---15        A patch has 16 control points: points[row][column]. Its corners are four of them, a
//!            |    |    |    |        side is the Bézier curve of the four points along it, and the place (u, v) is
//!            8----9---10---11
//!            |    |    |    |           S(u, v) = sum of B_i(u) B_j(v) points[j][i],   B_i(t) = (3 over i) t^i (1 - t)^(3 - i)
//!            4----5----6----7
//!            |    |    |    |        Seen from the side to which the normal points, u to v is a counter-clockwise turn.
//!   v = 0    0----1----2----3
//!          u = 0          u = 1
//! ```
//! **Exact.** A place is asked for by fractions, u = i / n and v = j / m with n and m up to 255: each is a [`Part`]. Then S is a
//! fraction too, with the denominator `n^3 m^3`, and each of its coordinates is rounded once, to the nearest 16.16 number, halves
//! upwards. So
//! - points of a side depend on the four control points of that side and on its level, on nothing else;
//! - they are the same from either end, and from either of two patches that share the side;
//! - no level drifts from another one: the middle of a side is the middle at levels 2, 4 and 64.
//!
//! **No cracks.** A [`Tessellation`] gives each side a level of its own: how many segments it has. If neighbours ask for the same
//! level of the side that they share, they have the same vertices there. The inside is a grid as fine as the finer one of opposite
//! sides; a strip of triangles stitches each side to it, and always takes the step whose middle comes first.
//! ```text
//!          o-----o-----o         the first row of the grid: 3 of the 5 places of level 4
//!        /  `.   |   .'  \
//!       /     `. | .'     \
//!      o---------o---------o     a side of level 2
//! ```
//! Where a side is a single point, as at the knob of a teapot, its triangles have no area.
//!
//! **Work.** What a column of vertices has in common, 132 multiplications and 12 divisions by the same number, is computed once.
//! Then the place of a vertex takes 24 multiplications and 6 divisions by two numbers, and its normal about 45 multiplications. All
//! divisions are multiplications by reciprocals. Nothing is stored but a column: 200 bytes of stack.
//!
//! Range: any control points.
//!
//! Source: G. Farin, "Curves and Surfaces for CAGD", 5th edition, Morgan Kaufmann, 2002 (patches, their normals, and the bound of the
//! distance from chord to curve).

use core::num::NonZeroU32;

use fixed::types::I16F16;

use super::vector::{cross, normalized, Scale, Vec3};
use crate::num::{
    cast::{low_u16, low_u8, signed, unsigned},
    recip::{Denominator, Divisor},
    wide::Sum,
};

/// A fraction of a side: `number / of`, from 0 to 1.
///
/// What is above 1 counts as 1, and with `of` = 0 it is 0.
/// ```
/// use embedded_raster::geom::space::patch::Part;
/// assert_eq!(Part::new(1, 4).to_fixed(), 0.25);
/// ```
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub struct Part {
    number: u8,
    of: u8,
}

impl Part {
    /// 0: where a side begins.
    pub const START: Self = Self { number: 0, of: 1 };
    /// 1: where a side ends.
    pub const END: Self = Self { number: 1, of: 1 };

    /// `number / of`.
    pub const fn new(number: u8, of: u8) -> Self {
        if number == 0 || of == 0 {
            Self::START
        } else if number >= of {
            Self::END
        } else {
            Self { number, of }
        }
    }

    /// The nearest 16.16 number: a coordinate of a texture.
    pub const fn to_fixed(self) -> I16F16 {
        I16F16::from_bits(Denominator::new(self.of as i32).under((self.number as i64) << 16))
    }

    /// As far from the other end.
    const fn mirrored(self) -> Self {
        Self { number: self.of.wrapping_sub(self.number), of: self.of }
    }

    /// The weights of four points, which add up to the cube of `of`.
    const fn cubic(self) -> [u32; 4] {
        let (t, s) = (self.number as u32, self.of.wrapping_sub(self.number) as u32);
        [s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t]
    }

    /// The weights of three differences of points, which add up to the square of `of`.
    const fn quadratic(self) -> [u32; 3] {
        let (t, s) = (self.number as u32, self.of.wrapping_sub(self.number) as u32);
        [s * s, 2 * s * t, t * t]
    }

    /// The cube of `of`: below `2^24`.
    const fn cube(self) -> NonZeroU32 {
        let of = self.of as u32;
        match NonZeroU32::new(of * of * of) {
            Some(cube) => cube,
            None => NonZeroU32::MIN,
        }
    }
}

/// A bicubic Bézier patch.
/// ```
/// use embedded_raster::{geom::space::patch::Part, Patch, Vec3};
/// // A flat one, three units wide.
/// let points = [0, 1, 2, 3].map(|y| [0, 1, 2, 3].map(|x| Vec3::whole(x, y, 0)));
/// let patch = Patch { points };
/// assert_eq!(patch.position(Part::new(1, 3), Part::new(2, 3)), Vec3::whole(1, 2, 0));
/// assert_eq!(patch.normal(Part::new(1, 3), Part::new(2, 3)), Vec3::Z);
/// ```
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub struct Patch {
    /// The control points, row by row: u grows along a row, v from row to row.
    pub points: [[Vec3; 4]; 4],
}

/// A point of a surface.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub struct Vertex {
    /// The nearest to the exact place.
    pub position: Vec3,
    /// Of length 1, or zero where the surface has none.
    pub normal: Vec3,
    /// Where in the patch it lies.
    pub u: Part,
    /// Where in the patch it lies.
    pub v: Part,
}

impl Patch {
    /// The place (u, v): each coordinate is the nearest number, halves upwards.
    pub fn position(&self, u: Part, v: Part) -> Vec3 {
        Column::new(self, u).position(v)
    }

    /// The normal at (u, v), of length 1: the cross product of the tangents along u and along v.
    ///
    /// Where a side is a single point, the tangent along it is that of the nearest row or column of control points that has
    /// one: that is where the normals beside it go. Zero where that does not help: where both tangents are parallel.
    ///
    /// Each coordinate is at most 0.51 ulp off, where neither tangent is shorter than 1/16 of the longest one of that u.
    pub fn normal(&self, u: Part, v: Part) -> Vec3 {
        Slopes::new(self, u).normal(self, v)
    }

    /// The control points of a side. The sides go around counter-clockwise: v = 0, u = 1, v = 1 backwards, u = 0 backwards.
    ///
    /// * `number`: modulo 4.
    pub fn side(&self, number: usize) -> [Vec3; 4] {
        let [bottom, .., top] = self.points;
        let reversed = |[a, b, c, d]: [Vec3; 4]| [d, c, b, a];
        match number & 3 {
            0 => bottom,
            1 => self.column(3),
            2 => reversed(top),
            _ => reversed(self.column(0)),
        }
    }

    /// The control points of a column: 0 to 3.
    fn column(&self, k: u8) -> [Vec3; 4] {
        self.points.map(|[a, b, c, d]| match k {
            0 => a,
            1 => b,
            2 => c,
            _ => d,
        })
    }
}

/// How many segments a side needs, so that no chord is further from the curve than `tolerance`: from 1 to 255.
///
/// It is the same from either end, so two patches agree on the side that they share. Where 255 are not enough, it is 255.
///
/// * `side`: as of [`Patch::side`].
/// ```
/// use embedded_raster::{geom::space::patch::level, Vec3};
/// use fixed::types::I16F16;
/// let arch = [Vec3::ZERO, Vec3::Y, Vec3::Y + Vec3::X, Vec3::X];
/// assert_eq!(level(arch, I16F16::from_num(0.01)), 11);
/// assert_eq!(level([Vec3::X; 4], I16F16::ZERO), 1);
/// ```
pub fn level(side: [Vec3; 4], tolerance: I16F16) -> u8 {
    // |second derivative| / (8 n^2) is the bound, and the derivative is at most 6 times the longer second difference.
    let [a, b, c, d] = side;
    let bend = |a: Vec3, b: Vec3, c: Vec3| ((a - b) - (b - c)).length().to_bits();
    let bend = i64::from(bend(a, b, c).max(bend(b, c, d)));
    let tolerance = i64::from(tolerance.to_bits().max(0));
    let fits = |n: &u8| {
        i64::from(*n).wrapping_mul((*n).into()).wrapping_mul(tolerance).wrapping_mul(4) >= bend.wrapping_mul(3)
    };
    (1..u8::MAX).find(fits).unwrap_or(u8::MAX)
}

/// The sum of vectors times weights. The caller knows that it fits.
fn mix<const N: usize, T: Into<i64>>(weights: [u32; N], vectors: [[T; 3]; N]) -> [i64; 3] {
    let mut sum = [0_i64; 3];
    for (weight, vector) in weights.into_iter().zip(vectors) {
        for (sum, x) in sum.iter_mut().zip(vector) {
            *sum = sum.wrapping_add(i64::from(weight).wrapping_mul(x.into()));
        }
    }
    sum
}

/// What all places with one u have in common: four points, one of each row, as exact mixed numbers `whole + rest / n^3`.
struct Column {
    whole: [[i32; 3]; 4],
    rest: [[u32; 3]; 4],
    cube: NonZeroU32,
    divisor: Divisor,
}

impl Column {
    fn new(patch: &Patch, u: Part) -> Self {
        let (weights, cube) = (u.cubic(), u.cube());
        let divisor = Divisor::new(cube);
        // Below 2^31 times the cube.
        let rows = patch.points.map(|row| mix(weights, row.map(Vec3::to_bits)).map(|n| divisor.floor(n)));
        Self {
            whole: rows.map(|row| row.map(|(whole, _)| whole)),
            rest: rows.map(|row| row.map(|(_, rest)| rest)),
            cube,
            divisor,
        }
    }

    fn position(&self, v: Part) -> Vec3 {
        let (weights, cube) = (v.cubic(), v.cube());
        // floor(T / (n^3 m^3) + 1/2) for T = n^3 A + R, where A and R are the sums of wholes and of rests:
        // it is floor((A + floor((R + n^3 m^3 / 2) / n^3)) / m^3). R is below n^3 m^3, which is below 2^48.
        let half = u64::from(self.cube.get()).wrapping_mul(cube.get().into()) >> 1;
        let (by_n, by_m) = (self.divisor, Divisor::new(cube));
        let mut rests = [half; 3];
        for (weight, row) in weights.into_iter().zip(self.rest) {
            for (sum, rest) in rests.iter_mut().zip(row) {
                *sum = sum.wrapping_add(u64::from(weight).wrapping_mul(rest.into()));
            }
        }
        let [x, y, z] = mix(weights, self.whole);
        let [p, q, r] = rests.map(|rest| i64::from(by_n.div_rem(rest).0));
        Vec3::from_bits([(x, p), (y, q), (z, r)].map(|(whole, rest)| by_m.floor(whole.wrapping_add(rest)).0))
    }
}

/// The tangents of all places with one u, as directions: along u, those of each row of points; along v, the steps from row to row.
/// Vectors of one kind have a scale in common.
struct Slopes {
    u: Part,
    along_u: [[i32; 3]; 4],
    along_v: [[i32; 3]; 3],
}

impl Slopes {
    fn new(patch: &Patch, u: Part) -> Self {
        // Below 2^32 times the square of `of`, and times its cube.
        let rows = patch.points.map(|row| mix(u.quadratic(), steps(row.map(|point| point.to_bits().map(i64::from)))));
        let columns = patch.points.map(|row| mix(u.cubic(), row.map(Vec3::to_bits)));
        Self { u, along_u: to_common_scale(rows), along_v: to_common_scale(steps(columns)) }
    }

    fn normal(&self, patch: &Patch, v: Part) -> Vec3 {
        let mut along_u = mix(v.cubic(), self.along_u);
        let mut along_v = mix(v.quadratic(), self.along_v);
        if along_u == [0; 3] {
            along_u = nearest_one(self.along_u.map(|row| row.map(i64::from)), v);
        }
        if along_v == [0; 3] {
            let columns = [0, 1, 2, 3].map(|k| patch.column(k).map(|point| point.to_bits().map(i64::from)));
            along_v = nearest_one(columns.map(|column| mix(v.quadratic(), steps(column))), self.u);
        }
        let [[a], [b]] = [along_u, along_v].map(|v| to_common_scale([v]));
        normalized(cross(a, b).map(Sum::total))
    }
}

/// From each of four points to the next one.
fn steps([a, b, c, d]: [[i64; 3]; 4]) -> [[i64; 3]; 3] {
    let step = |[x, y, z]: [i64; 3], [p, q, r]: [i64; 3]| [p.wrapping_sub(x), q.wrapping_sub(y), r.wrapping_sub(z)];
    [step(a, b), step(b, c), step(c, d)]
}

/// Numbers of 30 bits in the same ratio.
fn to_common_scale<const N: usize>(vectors: [[i64; 3]; N]) -> [[i32; 3]; N] {
    let all = vectors.iter().flatten().fold(0, |all, n| all | n.unsigned_abs());
    let scale = Scale::to_bits(30, all);
    vectors.map(|vector| scale.of_all(vector))
}

/// The first tangent that is not zero, from the end where a place lies; zero where it lies at neither, or there is none.
fn nearest_one(mut tangents: [[i64; 3]; 4], at: Part) -> [i64; 3] {
    if at == Part::END {
        tangents.reverse();
    } else if at != Part::START {
        return [0; 3];
    }
    tangents.into_iter().find(|tangent| *tangent != [0; 3]).unwrap_or([0; 3])
}

/// A patch as a mesh of triangles, each side with a level of its own.
///
/// Vertices have numbers: those of the sides come first, around the patch, then those of the inside. Triangles are three numbers.
/// Nothing is stored: a program keeps the vertices that [`each_vertex`](Self::each_vertex) makes in memory of its own, or asks for
/// one by its number.
/// ```
/// use embedded_raster::{geom::space::patch::Tessellation, Patch, Vec3};
/// let points = [0, 1, 2, 3].map(|y| [0, 1, 2, 3].map(|x| Vec3::whole(x, y, 0)));
/// let patch = Patch { points };
/// let mesh = Tessellation::new(&patch, [5, 4, 2, 4]);
/// let mut vertices = [Vec3::ZERO; 40]; // memory of the program
/// let mut slots = vertices.iter_mut();
/// mesh.each_vertex(|vertex| {
///     if let Some(slot) = slots.next() {
///         *slot = vertex.position;
///     }
/// });
/// let mut triangles = vec![];
/// mesh.each_triangle(|corners| triangles.push(corners.map(|number| vertices[usize::from(number)])));
/// assert_eq!((mesh.vertex_count(), triangles.len()), (5 + 4 + 2 + 4 + 4 * 3, 37));
/// ```
#[derive(Copy, Clone, Debug)]
pub struct Tessellation<'a> {
    patch: &'a Patch,
    levels: [u8; 4],
}

impl<'a> Tessellation<'a> {
    /// * `levels`: how many segments the sides have, in the order of [`Patch::side`]. 0 counts as 1.
    pub const fn new(patch: &'a Patch, levels: [u8; 4]) -> Self {
        let [a, b, c, d] = levels;
        Self { patch, levels: [larger(a, 1), larger(b, 1), larger(c, 1), larger(d, 1)] }
    }

    /// How many columns and rows of vertices the grid inside has: one less than the finer one of opposite sides has segments.
    const fn inside(&self) -> [u32; 2] {
        let [a, b, c, d] = self.levels;
        [larger(a, c).wrapping_sub(1) as u32, larger(b, d).wrapping_sub(1) as u32]
    }

    /// How many vertices lie on the sides.
    const fn on_sides(&self) -> u32 {
        let [a, b, c, d] = self.levels;
        (a as u32).wrapping_add(b as u32).wrapping_add(c as u32).wrapping_add(d as u32)
    }

    /// How many vertices there are: at most 65,536, so that the largest number fits 16 bits.
    pub const fn vertex_count(&self) -> u32 {
        let [columns, rows] = self.inside();
        self.on_sides().wrapping_add(columns.wrapping_mul(rows))
    }

    /// Where a vertex lies in the patch. Numbers that no vertex has lie somewhere.
    fn parts(&self, number: u16) -> [Part; 2] {
        let mut rest = u32::from(number);
        for (side, level) in self.levels.into_iter().enumerate() {
            let Some(after) = rest.checked_sub(level.into()) else {
                let t = Part::new(low_u8(rest), level);
                return match side {
                    0 => [t, Part::START],
                    1 => [Part::END, t],
                    2 => [t.mirrored(), Part::END],
                    _ => [Part::START, t.mirrored()],
                };
            };
            rest = after;
        }
        let [columns, rows] = self.inside();
        let (column, row) = match NonZeroU32::new(rows) {
            Some(rows) => (rest / rows, rest % rows),
            None => (0, 0),
        };
        // Below 2^8, for numbers that vertices have.
        let part = |k: u32, of: u32| Part::new(low_u8(k.wrapping_add(1)), low_u8(of.wrapping_add(1)));
        [part(column, columns), part(row, rows)]
    }

    /// The vertex of a number below [`vertex_count`](Self::vertex_count); of others, some point of the patch.
    pub fn vertex(&self, number: u16) -> Vertex {
        let [u, v] = self.parts(number);
        Vertex { position: self.patch.position(u, v), normal: self.patch.normal(u, v), u, v }
    }

    /// All vertices, by their numbers. What those of a column have in common is computed once.
    ///
    /// * `emit`: called once for each vertex.
    pub fn each_vertex(&self, mut emit: impl FnMut(Vertex)) {
        let mut common: Option<(Part, Column, Slopes)> = None;
        for number in 0..self.vertex_count() {
            let [u, v] = self.parts(low_u16(number));
            let (_, column, slopes) = match &mut common {
                Some(known) if known.0 == u => known,
                other => other.insert((u, Column::new(self.patch, u), Slopes::new(self.patch, u))),
            };
            emit(Vertex { position: column.position(v), normal: slopes.normal(self.patch, v), u, v });
        }
    }

    /// All triangles, counter-clockwise as seen from where normals point to.
    ///
    /// * `emit`: called once for each triangle, with the numbers of its vertices.
    pub fn each_triangle(&self, mut emit: impl FnMut([u16; 3])) {
        let ([columns, rows], [a, b, c, d]) = (self.inside(), self.levels.map(u32::from));
        // Where the sides begin. The last vertex of the last side is the first one of all.
        let (second, third) = (a, a.wrapping_add(b));
        let (fourth, around) = (third.wrapping_add(c), self.on_sides());
        let side = |first: u32, len: u32| Chain { first, step: 1, len, around };
        let back = |first: u32, len: u32| Chain { first: first.wrapping_add(len), step: -1, len, around };
        // Without an inside, two sides of one segment lie between the other two.
        let (Some(last_column), Some(last_row)) = (columns.checked_sub(1), rows.checked_sub(1)) else {
            return if rows == 0 {
                stitch(side(0, a), back(third, c), 0, &mut emit);
            } else {
                stitch(side(second, b), back(fourth, d), 0, &mut emit);
            };
        };
        let inner = |column: u32, row: u32| around.wrapping_add(column.wrapping_mul(rows)).wrapping_add(row);
        let chain = |first: u32, step: i32, len: u32| Chain { first, step, len, around: u32::MAX };
        let (right, left) = (signed(rows), signed(rows).wrapping_neg());
        stitch(side(0, a), chain(inner(0, 0), right, last_column), 1, &mut emit);
        stitch(side(second, b), chain(inner(last_column, 0), 1, last_row), 1, &mut emit);
        stitch(side(third, c), chain(inner(last_column, last_row), left, last_column), 1, &mut emit);
        stitch(side(fourth, d), chain(inner(0, last_row), -1, last_row), 1, &mut emit);
        for column in 0..last_column {
            for row in 0..last_row {
                let p = inner(column, row);
                let q = p.wrapping_add(rows);
                let [p, q, r, s] = [p, q, q.wrapping_add(1), p.wrapping_add(1)].map(low_u16);
                emit([p, q, r]);
                emit([p, r, s]);
            }
        }
    }
}

/// Vertices in a row.
#[derive(Copy, Clone)]
struct Chain {
    first: u32,
    /// From one number to the next.
    step: i32,
    /// How many segments.
    len: u32,
    /// The number that stands for 0.
    around: u32,
}

impl Chain {
    const fn number(self, k: u32) -> u16 {
        let number = self.first.wrapping_add(unsigned(self.step).wrapping_mul(k));
        low_u16(if number == self.around { 0 } else { number })
    }
}

/// The triangles between two chains; the second one lies to the left of the first one, and goes the same way.
///
/// * `inset`: how many segments the second one is shorter at each end than the side that it is a part of.
fn stitch(right: Chain, left: Chain, inset: u32, emit: &mut impl FnMut([u16; 3])) {
    let (mut i, mut j) = (0, 0);
    // Halves of segments: where the middle of the next segment lies, over the whole length.
    let middle = |k: u32| k.wrapping_mul(2).wrapping_add(1);
    let whole = left.len.wrapping_add(inset.wrapping_mul(2));
    while i < right.len || j < left.len {
        // Products below 2^18.
        let (here, there) = (middle(i).wrapping_mul(whole), middle(j.wrapping_add(inset)).wrapping_mul(right.len));
        let (p, q) = (right.number(i), left.number(j));
        if j == left.len || i < right.len && here <= there {
            i = i.wrapping_add(1);
            emit([p, right.number(i), q]);
        } else {
            j = j.wrapping_add(1);
            emit([p, left.number(j), q]);
        }
    }
}

const fn larger(a: u8, b: u8) -> u8 {
    if a > b {
        a
    } else {
        b
    }
}
