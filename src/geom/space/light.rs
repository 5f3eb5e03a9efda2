//! How bright a surface is: Lambert and Blinn-Phong, as plain functions of directions.
//!
//! ```text
//!      to the light      normal      to the eye
//!                 \     h  |       /
//!                  \   /   |     /        diffuse  = normal . light                Lambert
//!                   \ /    |   /          h        = (light + eye) / |light + eye|
//!          ----------+-----o-----------   specular = (normal . h)^exponent         Blinn
//! ```
//! Directions have length 1: [`Vec3::normalize`]. All results are from 0 to 1. Multiply colours of lights and of materials by
//! them, and add: there is no scene here, and no list of lights.
//! ```
//! use embedded_raster::{geom::space::light::{diffuse, half_way, specular, Gloss}, Vec3};
//! use fixed::types::I16F16;
//! static GLOSS: Gloss = Gloss::new(32); // computed by the compiler: 140 bytes of flash
//!
//! let (normal, to_light, to_eye) = (Vec3::Z, Vec3::new(I16F16::from_num(0.6), I16F16::ZERO, I16F16::from_num(0.8)), Vec3::Z);
//! let matt = diffuse(normal, to_light);
//! let shine = specular(normal, to_light, half_way(to_light, to_eye), &GLOSS);
//! let [ambient, wood, varnish] = [0.1, 0.6, 0.3].map(I16F16::from_num);
//! let brightness = ambient + matt * wood + shine * varnish; // as a part of white
//! assert_eq!((matt, brightness.to_num::<f32>()), (I16F16::from_num(0.8), 0.635_650_63));
//! ```
//! Sources: J. H. Lambert, "Photometria", 1760; J. F. Blinn, "Models of Light Reflection for Computer Synthesized Pictures",
//! SIGGRAPH 1977.

use core::num::NonZeroU32;

use fixed::types::I16F16;

use super::vector::{normalized, Vec3};
use crate::num::{
    cast::{low_u16, low_u32, signed, unsigned},
    recip::Divisor,
};

/// Lambert: the cosine of the angle between the normal and the direction to the light, 0 where that lies behind.
///
/// At most 0.5 ulp off the cosine of the directions given; they are rounded themselves. It is never above 1.
/// ```
/// use embedded_raster::{geom::space::light::diffuse, Vec3};
/// assert_eq!(diffuse(Vec3::Z, Vec3::Z), 1);
/// assert_eq!(diffuse(Vec3::Z, -Vec3::Z), 0);
/// ```
pub const fn diffuse(normal: Vec3, to_light: Vec3) -> I16F16 {
    clamped(normal.dot(to_light))
}

/// The direction in the middle between the light and the eye, of length 1; zero if they are opposite.
///
/// Each coordinate is at most 0.501 ulp off.
pub const fn half_way(to_light: Vec3, to_eye: Vec3) -> Vec3 {
    let ([a, b, c], [d, e, f]) = (to_light.to_bits(), to_eye.to_bits());
    // Of numbers of 32 bits.
    normalized([
        (a as i64).wrapping_add(d as i64),
        (b as i64).wrapping_add(e as i64),
        (c as i64).wrapping_add(f as i64),
    ])
}

/// Blinn-Phong: how bright the reflection of a light is. 0 where the light lies behind the surface.
///
/// * `half_way`: of [`half_way`].
///
/// As far off as `gloss` says.
pub fn specular(normal: Vec3, to_light: Vec3, half_way: Vec3, gloss: &Gloss) -> I16F16 {
    if normal.dot(to_light).to_bits() <= 0 {
        return I16F16::ZERO;
    }
    gloss.power(normal.dot(half_way))
}

const fn clamped(x: I16F16) -> I16F16 {
    let bits = x.to_bits();
    I16F16::from_bits(if bits < 0 {
        0
    } else if bits > ONE {
        ONE
    } else {
        bits
    })
}

const ONE: i32 = 1 << 16;

/// How many chords a table has.
const SEGMENTS: u32 = 64;

/// A table of powers `x^exponent` for x from 0 to 1: 64 chords of the curve, 140 bytes.
///
/// A high power is close to 0 but for the last bit of the way to 1, so the chords are laid there: from 1 down to
/// `1 - 8 / exponent`, as `x^n` is about `e^(-n (1 - x))`. Below that it is 0, where the power would be less than 1/2,900.
///
/// At most 0.002 off, half a step of 8 bits, for every exponent. In a `static`, the compiler computes it; then a power takes two
/// multiplications of 32 bits.
/// ```
/// use embedded_raster::geom::space::light::Gloss;
/// use fixed::types::I16F16;
/// let gloss = Gloss::new(10);
/// let off = gloss.power(I16F16::from_num(0.9)).to_num::<f32>() - 0.9_f32.powi(10);
/// assert!(off.abs() < 0.002);
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Gloss {
    /// In 1.15, that of 1 first.
    values: [u16; SEGMENTS as usize + 1],
    /// Chords to a unit of `1 - x`.
    scale: u32,
    /// How far the chords reach down from 1, in 16.16.
    reach: u32,
}

impl Gloss {
    /// * `exponent`: the higher, the smaller is the reflection: 10 is like wood, 100 like metal. 0 counts as 1.
    pub const fn new(exponent: u16) -> Self {
        let exponent = if exponent == 0 { 1 } else { exponent as u32 };
        let scale = if exponent < 8 { SEGMENTS } else { exponent.wrapping_mul(SEGMENTS / 8) };
        let mut values = [0; SEGMENTS as usize + 1];
        let mut rest: &mut [u16] = &mut values;
        let mut segment = 0_u32;
        if let Some(scale) = NonZeroU32::new(scale) {
            let scale = Divisor::new(scale);
            while let [first, others @ ..] = rest {
                // 1 - segment / scale: the quotient is at most 2^31.
                let (part, _) = scale.div_rem((segment as u64) << 31);
                *first = power(ONE_31.wrapping_sub(part), exponent);
                segment = segment.wrapping_add(1);
                rest = others;
            }
        }
        let reach = match (SEGMENTS << 16).checked_div(scale) {
            Some(reach) => reach,
            None => 0,
        };
        Self { values, scale, reach }
    }

    /// `x^exponent`; 0 of what is negative, 1 of what is above 1.
    pub fn power(&self, x: I16F16) -> I16F16 {
        let below_one = unsigned(ONE.wrapping_sub(clamped(x).to_bits()));
        if below_one >= self.reach {
            return I16F16::ZERO;
        }
        // Chords in 16.16, at most 64.
        let at = below_one.wrapping_mul(self.scale);
        let (segment, share) = (at >> 16, at & 0xffff);
        let [from, to] = match self.values.get(segment as usize..) {
            Some([from, to, ..]) => [*from, *to].map(u32::from),
            _ => [0; 2],
        };
        // The values go down. Each is doubled: below 2^31 before it is cut off.
        let down = from.wrapping_sub(to).wrapping_mul(share) >> 15;
        I16F16::from_bits(signed(from.wrapping_mul(2).wrapping_sub(down)))
    }
}

/// 1 in 1.31.
const ONE_31: u32 = 1 << 31;

/// `x^exponent` in 1.15, of x in 1.31 up to 1, by squares. It is less than `exponent / 2^31` off, and half a unit.
const fn power(x: u32, exponent: u32) -> u16 {
    let (mut result, mut square, mut left) = (ONE_31, x, exponent);
    while left > 0 {
        if left & 1 == 1 {
            result = product(result, square);
        }
        square = product(square, square);
        left >>= 1;
    }
    low_u16(result.wrapping_add(1 << 15) >> 16)
}

/// Of numbers in 1.31, up to 1.
const fn product(a: u32, b: u32) -> u32 {
    low_u32((a as u64).wrapping_mul(b as u64).wrapping_add(1 << 30) >> 31)
}
