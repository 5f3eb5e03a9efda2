//! The scene: a cube that turns, with a spindle of eight faces that turns in it another way, so that its tips come out of the faces
//! of the cube. Both are lit. Integers only and no heap: a chip draws it with this same code.
//!
//! A vertex goes through the vertex stage once for each picture. What comes out is kept, 20 bytes for each of 30 vertices, and serves
//! all triangles and all bands.
#![allow(unreachable_pub, reason = "firmwares have this scene as a module of a library")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::manual_is_multiple_of,
    clippy::precedence,
    reason = "numbers of a few corners and faces"
)]

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{Rgb888, RgbColor},
};
use embedded_raster::{
    geom::{
        space::{
            light::{diffuse, half_way, specular, Gloss},
            number::divide,
        },
        Mix, Varying,
    },
    paint::depth,
    pipeline::{assemble, Facing, Pipeline, Topology, Vertex},
    pixel::Depth16,
    surface::DepthBuffer,
    Angle, Canvas, Mat4, Surface, Vec3, Vec4,
};
use fixed::types::I16F16;

/// Columns of the screen, unless told.
pub const WIDTH: u16 = 160;
/// Rows of the screen, unless told.
pub const HEIGHT: u16 = 128;
/// What is behind everything.
pub const BACKGROUND: Rgb888 = Rgb888::new(0x12, 0x18, 0x28);

/// Four corners for each face of the cube, as each face has its own normal; six tips of the spindle.
const CORNERS: usize = 24;
const TIPS: usize = 6;
/// Three for each triangle: two on each face of the cube, and eight.
const INDICES: usize = 36 + 24;

const EYE: Vec3 = Vec3::whole(0, 0, 6);
const LIGHT: Vec3 = Vec3::whole(2, 2, 4);
const AMBIENT: I16F16 = I16F16::lit("0.3");
const MATT: I16F16 = I16F16::lit("0.9");
const VARNISH: I16F16 = I16F16::lit("0.5");
static GLOSS: Gloss = Gloss::new(8);

/// How far the tips of the spindle are from the middle. The faces of the cube are 1 away, its corners 1.73.
const REACH: I16F16 = I16F16::lit("1.9");
/// A colour for each two faces of the cube that are opposite, then one for each two tips.
const PAINTS: [Rgb888; 6] = [
    Rgb888::new(0xe8, 0x58, 0x48),
    Rgb888::new(0xf0, 0xb0, 0x40),
    Rgb888::new(0x58, 0xb8, 0x70),
    Rgb888::new(0x40, 0x60, 0xff),
    Rgb888::new(0xd0, 0xf0, 0xff),
    Rgb888::new(0xc0, 0x50, 0xe0),
];

/// All triangles, counter-clockwise as seen from outside.
static TRIANGLES: [u8; INDICES] = triangles();

/// The scene at one moment.
#[derive(Clone, Debug)]
pub struct Scene<V> {
    pipeline: Pipeline,
    vertices: [Vertex<V>; CORNERS + TIPS],
}

impl<V: Varying + Mix> Scene<V> {
    /// Through the pipeline of a screen, which has that many columns and rows, a part of a turn after it began. `value` makes what changes from pixel to pixel of
    /// the colour of a vertex.
    pub fn new(pipeline: Pipeline, [width, height]: [u16; 2], turn: Angle, value: impl Fn(Rgb888) -> V) -> Self {
        let [wide, high] = [width, height].map(|n| I16F16::from_bits(i32::from(n)));
        let [near, far] = [3, 9].map(|n| I16F16::from_bits(n << 16));
        let camera = Mat4::perspective(Angle::degrees(40), divide(wide, high), near, far)
            * Mat4::look_at(EYE, Vec3::ZERO, Vec3::Y);
        let cube = Mat4::rotate_x(Angle::degrees(25)) * Mat4::rotate_y(turn);
        let spindle = Mat4::rotate_z(turn + turn) * Mat4::rotate_x(turn);
        // In its place: an array that is mapped would be on the stack of a chip several times.
        let nowhere = Vertex::new(Vec4::ZERO, value(BACKGROUND));
        let mut scene = Self { pipeline: pipeline.cull(Facing::Back), vertices: [nowhere; CORNERS + TIPS] };
        for (number, vertex) in scene.vertices.iter_mut().enumerate() {
            let (place, normal, paint) = model(number);
            let body = if number < CORNERS { &cube } else { &spindle };
            let (at, normal) = (body.transform_point(place).xyz(), body.transform_direction(normal));
            *vertex = Vertex::new(camera.transform_point(at), value(lit(at, normal, PAINTS[paint])));
        }
        scene
    }

    /// Draws it on a band of the screen, or the whole, with the depths of the same rows. `color` is the fragment stage.
    pub fn draw<S: Surface>(
        &self,
        on: &mut S,
        depths: &mut DepthBuffer<'_, Depth16>,
        background: S::Color,
        color: impl Fn(Point, V) -> S::Color,
    ) {
        on.fill_window(background);
        depths.clear(Depth16::MAX);
        let Ok(triangles) = assemble(Topology::List, &self.vertices, &TRIANGLES) else { return };
        // Nothing comes near the planes that would cut: there is no clipper to link.
        self.pipeline.whole_triangles(triangles, Clone::clone, |triangle| {
            triangle.fill_depth(on, depths, depth::less, |fragment| Some(color(fragment.at, fragment.values)));
        });
    }
}

/// Place, normal and paint of a vertex: of the cube those of each face together, then the tips.
fn model(number: usize) -> (Vec3, Vec3, usize) {
    let axis = |face: usize, length: I16F16| {
        let mut bits = [0; 3];
        bits[face / 2] = if face % 2 == 0 { length.to_bits() } else { -length.to_bits() };
        Vec3::from_bits(bits)
    };
    let Some(tip) = number.checked_sub(CORNERS) else {
        let (face, corner) = (number / 4, number % 4);
        let normal = axis(face, I16F16::ONE);
        // The other two axes in their order, so that both with the normal turn the right way.
        let (next, last) = ((face / 2 + 1) % 3 * 2, (face / 2 + 2) % 3 * 2);
        let (next, last) = (axis(next + corner % 2, I16F16::ONE), axis(last + corner / 2, I16F16::ONE));
        return (normal + next + last, normal, face / 2);
    };
    (axis(tip, REACH), axis(tip, I16F16::ONE), 3 + tip / 2)
}

/// Vertices of all triangles.
const fn triangles() -> [u8; INDICES] {
    // Corners of a face: the first axis goes down from one to the next, the second from one pair to the next.
    const FACE: [u8; 6] = [0, 1, 3, 0, 3, 2];
    let (mut indices, mut at) = ([0; INDICES], 0);
    while at < 36 {
        let face = at / 6;
        // On the other side of the cube everything is seen from behind.
        let corner = if face % 2 == 0 { FACE[at % 6] } else { FACE[5 - at % 6] };
        indices[at] = 4 * face as u8 + corner;
        at += 1;
    }
    while at < INDICES {
        let (side, corner) = (at as u8 / 3 - 12, at as u8 % 3);
        // A tip of each axis, seen from behind where an odd number of them is negative.
        let odd = (side & 1) ^ (side >> 1 & 1) ^ (side >> 2);
        let axis = if odd == 0 { corner } else { 2 - corner };
        indices[at] = CORNERS as u8 + 2 * axis + (side >> axis & 1);
        at += 1;
    }
    indices
}

/// The colour of a place on a surface in the light.
fn lit(at: Vec3, normal: Vec3, paint: Rgb888) -> Rgb888 {
    let (to_light, to_eye) = ((LIGHT - at).normalize(), (EYE - at).normalize());
    let part = |a: I16F16, b: I16F16| I16F16::from_bits((i64::from(a.to_bits()) * i64::from(b.to_bits()) >> 16) as i32);
    let matt = AMBIENT + part(MATT, diffuse(normal, to_light));
    let shine = part(VARNISH, specular(normal, to_light, half_way(to_light, to_eye), &GLOSS));
    let level = |n: u8| {
        let sum = matt.to_bits() * i32::from(n) + shine.to_bits() * 255;
        (sum >> 16).min(255) as u8
    };
    Rgb888::new(level(paint.r()), level(paint.g()), level(paint.b()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangles_are_seen_from_outside() {
        for corners in TRIANGLES.chunks_exact(3) {
            let [a, b, c] = [0, 1, 2].map(|i| model(corners[i].into()).0);
            assert!((b - a).cross(c - a).dot(a) > 0, "{corners:?}");
        }
    }

    #[test]
    fn normals_point_outside() {
        for (place, normal, paint) in (0..CORNERS + TIPS).map(model) {
            assert!(place.dot(normal) >= 1 && normal.length() == 1 && paint < PAINTS.len(), "{place:?}");
        }
    }
}
