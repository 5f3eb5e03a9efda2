//! The light on a surface: Lambert and Blinn-Phong.
#![no_std]
#![no_main]

use core::hint::black_box;

use embedded_raster::geom::space::light::{diffuse, half_way, specular, Gloss};

board::entry!(main);

fn main() {
    static GLOSS: Gloss = Gloss::new(32);
    size::on_memory(|_| {
        let [normal, to_light, to_eye] = size::places().map(|place| place.xyz().normalize());
        black_box(diffuse(normal, to_light) + specular(normal, to_light, half_way(to_light, to_eye), &GLOSS));
    });
}
