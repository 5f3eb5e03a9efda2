//! A camera that turns, and a place seen by it.
#![no_std]
#![no_main]

use core::hint::black_box;

use embedded_raster::{Angle, Mat4, Vec3};
use fixed::types::I16F16;

board::entry!(main);

fn main() {
    size::on_memory(|_| {
        let [a, b, _] = size::places().map(|place| place.xyz());
        let angle = black_box(Angle::turns(1, 7));
        let [aspect, near, far] = black_box([1, 2, 3].map(|n| I16F16::from_bits(n << 16)));
        let camera = Mat4::perspective(angle, aspect, near, far) * Mat4::look_at(a, b, Vec3::Y) * Mat4::rotate_y(angle);
        black_box(camera.transform_point(b));
    });
}
