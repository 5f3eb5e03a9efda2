//! One triangle in clip coordinates, of one colour at 16 bits, that is never cut.
#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::pipeline::{Pipeline, Vertex};

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        let color = size::color::<Rgb565>();
        let Ok(pipeline) = Pipeline::new(size::WIDTH, size::HEIGHT) else { return };
        pipeline.whole_triangles(
            [size::places()],
            |place| Vertex::new(place, ()),
            |triangle| triangle.fill(frame, |_| Some(color)),
        );
    });
}
