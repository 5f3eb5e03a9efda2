//! One triangle in clip coordinates with a colour at each corner at 16 bits and a depth buffer of 16 bits, cut where it has
//! to be.
#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::{
    paint::depth,
    pipeline::{Pipeline, Vertex},
};

board::entry!(main);

fn main() {
    size::on_depth::<Rgb565>(|frame, depths| {
        let ([a, b, c], [p, q, r]) = (size::places(), size::colors());
        let Ok(pipeline) = Pipeline::new(size::WIDTH, size::HEIGHT) else { return };
        pipeline.triangles(
            [[(a, p), (b, q), (c, r)]],
            |(place, color)| Vertex::new(place, color),
            |triangle| triangle.fill_depth(frame, depths, depth::less, |fragment| Some(fragment.values)),
        );
    });
}
