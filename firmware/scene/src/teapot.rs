//! The teapot of 32 Bézier patches, lit, in RGB565 with depths of 16 bits.
//!
//! No mesh is kept: a patch is cut into triangles when it is drawn, and its vertices are on the stack. So a band of the screen goes
//! through the vertex stage again. A patch lies in the hull of its control points; where none of these reaches the rows of a band,
//! nor some from above and some from below, its 16 products with a matrix are all that it takes.

use core::ops::Range;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::geom::space::light::diffuse;
use embedded_raster::geom::space::patch::Tessellation;
use embedded_raster::paint::depth;
use embedded_raster::pipeline::{Pipeline, Vertex};
use embedded_raster::pixel::Depth16;
use embedded_raster::surface::DepthBuffer;
use embedded_raster::{Angle, Error, Framebuffer, Mat4, Patch, Vec3, Vec4};
use fixed::types::I16F16;

use crate::{HEIGHT, WIDTH};

include!(concat!(env!("OUT_DIR"), "/teapot.rs"));

/// Segments of each side of a patch.
const LEVEL: u8 = 4;
/// Vertices of a patch: five to a side.
const VERTICES: usize = 25;

const BACKGROUND: Rgb565 = Rgb565::new(2, 6, 5);
const EYE: Vec3 = Vec3::whole(-3, 5, 8);
const MIDDLE: Vec3 = Vec3::new(I16F16::lit("0.2"), I16F16::lit("1.2"), I16F16::ZERO);
const TO_LIGHT: Vec3 = Vec3::new(I16F16::lit("-0.4"), I16F16::lit("0.6"), I16F16::lit("0.69"));

/// Draws it on the whole screen or a band of it, with the depths of the same rows.
///
/// # Errors
/// None: the screen is not too large for the pipeline.
pub fn draw(frame: &mut Framebuffer<'_, Rgb565>, depths: &mut DepthBuffer<'_, Depth16>) -> Result<(), Error> {
    let window = frame.window();
    let [wide, high] = [WIDTH, HEIGHT].map(I16F16::from_num);
    let [near, far] = [5, 14].map(I16F16::from_num);
    let camera = Mat4::perspective(Angle::degrees(38), wide / high, near, far) * Mat4::look_at(EYE, MIDDLE, Vec3::Y);
    let pipeline = Pipeline::new(WIDTH, HEIGHT)?;
    frame.clear(BACKGROUND);
    depths.clear(Depth16::MAX);
    for points in &PATCHES {
        let patch = Patch { points: points.map(|row| row.map(Vec3::from_bits)) };
        if !meets(&patch, &camera, window.y0..window.y1) {
            continue;
        }
        let mesh = Tessellation::new(&patch, [LEVEL; 4]);
        let mut vertices = [Vertex::new(Vec4::ZERO, BACKGROUND); VERTICES];
        let mut places = vertices.iter_mut();
        mesh.each_vertex(|vertex| {
            if let Some(place) = places.next() {
                *place = Vertex::new(camera.transform_point(vertex.position), lit(vertex.normal));
            }
        });
        mesh.each_triangle(|corners| {
            let corners = corners.map(|number| vertices[usize::from(number) % VERTICES]);
            // Nothing comes near the planes that would cut.
            pipeline.whole_triangles(
                [corners],
                |vertex| vertex,
                |triangle| {
                    triangle.fill_depth(frame, depths, depth::less, |fragment| Some(fragment.values));
                },
            );
        });
    }
    Ok(())
}

/// Whether a patch may have pixels in some rows.
fn meets(patch: &Patch, camera: &Mat4, rows: Range<i32>) -> bool {
    let (mut is_above, mut is_below) = (true, true);
    for &point in patch.points.iter().flatten() {
        let [_, y, _, w] = camera.transform_point(point).to_bits().map(i64::from);
        // Row Y = (1 - y / w) H / 2, so this is 2 w Y. One row more on either side, for what is rounded.
        let place = (w - y) * i64::from(HEIGHT);
        is_above &= place < 2 * w * i64::from(rows.start - 1);
        is_below &= place > 2 * w * i64::from(rows.end + 1);
    }
    !is_above && !is_below
}

/// Clay in the light.
fn lit(normal: Vec3) -> Rgb565 {
    // From 64 to 256.
    let tone = 64 + (diffuse(normal, TO_LIGHT).to_bits() >> 8) * 192 / 256;
    let level = |most: i32| (most * tone >> 8) as u8;
    Rgb565::new(level(30), level(44), level(16))
}
