//! The list of everything that computes in space: vectors, matrices, surfaces, light.

use embedded_raster::{
    geom::space::{
        light::{self, Gloss},
        number,
        patch::{self, Part, Tessellation, Vertex},
    },
    Angle, Mat4, Patch, Vec3, Vec4,
};
use fixed::types::I16F16;

/// What calls are made with: any bits.
#[derive(Clone, Copy, Debug)]
pub struct Arguments {
    /// Numbers.
    pub numbers: [I16F16; 6],
    /// Places and directions.
    pub vectors: [Vec3; 3],
    /// Homogeneous ones.
    pub places: [Vec4; 2],
    /// Motions and cameras.
    pub matrices: [Mat4; 2],
    /// Of rotations.
    pub angle: Angle,
    /// A surface.
    pub patch: Patch,
    /// How finely its sides are cut.
    pub levels: [u8; 4],
    /// Where in it.
    pub parts: [[u8; 2]; 2],
    /// Number of a vertex or a side, exponent of a gloss.
    pub index: u16,
}

/// Calls by name: a constant list and a function out of the same lines, so none can be in one and not in the other.
macro_rules! calls {
    ($a:ident, $x:ident, $v:ident, $p:ident, $m:ident, $u:ident; $($name:literal => $call:expr;)*) => {
        /// The names of the calls, with their type or their module.
        pub const NAMES: &[&str] = &[$($name),*];

        /// Makes the call of the name of this number in [`NAMES`]. What it answered, as a number.
        pub fn call($a: &Arguments, number: usize) -> u32 {
            let ($x, $v, $p, $m) = (&$a.numbers, &$a.vectors, &$a.places, &$a.matrices);
            let $u = $a.parts.map(|[number, of]| Part::new(number, of));
            let mut numbers = 0..usize::MAX;
            $(
                if numbers.next() == Some(number) {
                    return $call.digest();
                }
            )*
            0
        }
    };
}

calls! { a, x, v, p, m, u;
    "number::divide" => number::divide(x[0], x[1]);
    "number::reciprocal" => number::reciprocal(x[0]);
    "number::square_root" => number::square_root(x[0]);
    "number::inverse_root" => number::inverse_root(x[0]);
    "number::cos_sin" => number::cos_sin(a.angle);
    "Vec3::new" => Vec3::new(x[0], x[1], x[2]) + v[0] - v[1];
    "Vec3::whole" => -Vec3::whole(a.index.cast_signed(), 1, 2) * x[0];
    "Vec3::from_bits" => Vec3::from_bits(x.map(I16F16::to_bits).first_chunk().copied().unwrap_or_default());
    "Vec3::to_bits" => Vec3::from_bits(v[0].to_bits());
    "Vec3::with_w" => v[0].with_w(x[0]);
    "Vec3::dot" => v[0].dot(v[1]);
    "Vec3::cross" => v[0].cross(v[1]);
    "Vec3::length" => v[0].length();
    "Vec3::normalize" => v[0].normalize();
    "Vec4::new" => Vec4::new(x[0], x[1], x[2], x[3]) + p[0] - p[1];
    "Vec4::whole" => -Vec4::whole(a.index.cast_signed(), 1, 2, 3) * x[0];
    "Vec4::from_bits" => Vec4::from_bits(x.map(I16F16::to_bits).first_chunk().copied().unwrap_or_default());
    "Vec4::to_bits" => Vec4::from_bits(p[0].to_bits());
    "Vec4::xyz" => p[0].xyz();
    "Vec4::dot" => p[0].dot(p[1]);
    "Vec4::project" => p[0].project();
    "Mat4::from_bits" => Mat4::from_bits(m[0].to_bits());
    "Mat4::to_bits" => Mat4::from_bits(m[1].to_bits()) * p[0];
    "Mat4::translate" => Mat4::translate(v[0]);
    "Mat4::scale" => Mat4::scale(v[0]);
    "Mat4::rotate_x" => Mat4::rotate_x(a.angle);
    "Mat4::rotate_y" => Mat4::rotate_y(a.angle);
    "Mat4::rotate_z" => Mat4::rotate_z(a.angle);
    "Mat4::rotate" => Mat4::rotate(v[0], a.angle);
    "Mat4::look_at" => Mat4::look_at(v[0], v[1], v[2]);
    "Mat4::perspective" => Mat4::perspective(a.angle, x[0], x[1], x[2]);
    "Mat4::frustum" => Mat4::frustum([x[0], x[1]], [x[2], x[3]], x[4], x[5]);
    "Mat4::orthographic" => Mat4::orthographic([x[0], x[1]], [x[2], x[3]], x[4], x[5]);
    "Mat4::inverse_rigid" => m[0].inverse_rigid();
    "Mat4::normal_matrix" => m[0].normal_matrix();
    "Mat4::transform_point" => m[0].transform_point(v[0]);
    "Mat4::transform_direction" => m[0].transform_direction(v[0]);
    "Mat4::transform" => m[0].transform(p[0]);
    "Mat4::default" => Mat4::default();
    "Mat4::mul" => m[0] * m[1];
    "Mat4::mul" => m[0] * p[0];
    "Mat4::times" => m[0].times(&m[1]);
    "Part::new" => u[0].to_fixed();
    "Part::to_fixed" => u[1].to_fixed();
    "Patch::position" => a.patch.position(u[0], u[1]);
    "Patch::normal" => a.patch.normal(u[0], u[1]);
    "Patch::side" => a.patch.side(a.index.into());
    "patch::level" => number_of(patch::level(a.patch.side(a.index.into()), x[0]).into());
    "Tessellation::new" => Tessellation::new(&a.patch, a.levels).vertex(0);
    "Tessellation::vertex_count" => number_of(Tessellation::new(&a.patch, a.levels).vertex_count());
    "Tessellation::vertex" => Tessellation::new(&a.patch, a.levels).vertex(a.index);
    "Tessellation::each_vertex" => {
        let mut sum = 0_u32;
        Tessellation::new(&a.patch, a.levels).each_vertex(|vertex| sum = sum.wrapping_mul(31) ^ vertex.digest());
        number_of(sum)
    };
    "Tessellation::each_triangle" => {
        let mut sum = 0_u32;
        Tessellation::new(&a.patch, a.levels)
            .each_triangle(|corners| sum = corners.into_iter().fold(sum, |sum, k| sum.wrapping_mul(31) ^ u32::from(k)));
        number_of(sum)
    };
    "light::diffuse" => light::diffuse(v[0], v[1]);
    "light::half_way" => light::half_way(v[0], v[1]);
    "light::specular" => light::specular(v[0], v[1], v[2], &Gloss::new(a.index));
    "Gloss::new" => Gloss::new(a.index).power(I16F16::ONE);
    "Gloss::power" => Gloss::new(10).power(x[0]);
}

fn number_of(n: u32) -> I16F16 {
    I16F16::from_bits(n.cast_signed())
}

/// What a call answered, as a number that depends on all of it.
trait Digest {
    fn digest(self) -> u32;
}

impl Digest for I16F16 {
    fn digest(self) -> u32 {
        self.to_bits().cast_unsigned()
    }
}

impl Digest for (I16F16, I16F16) {
    fn digest(self) -> u32 {
        self.0.digest().wrapping_mul(31) ^ self.1.digest()
    }
}

impl Digest for Vec4 {
    fn digest(self) -> u32 {
        self.to_bits().into_iter().fold(0, |sum, n| sum.wrapping_mul(31) ^ n.cast_unsigned())
    }
}

impl Digest for Vec3 {
    fn digest(self) -> u32 {
        self.with_w(I16F16::ZERO).digest()
    }
}

impl Digest for Mat4 {
    fn digest(self) -> u32 {
        self.rows.digest()
    }
}

impl Digest for Vertex {
    fn digest(self) -> u32 {
        [self.position, self.normal].digest() ^ (self.u.to_fixed(), self.v.to_fixed()).digest()
    }
}

impl<T: Digest, const N: usize> Digest for [T; N] {
    fn digest(self) -> u32 {
        self.into_iter().fold(0, |sum, part| sum.wrapping_mul(31) ^ part.digest())
    }
}
