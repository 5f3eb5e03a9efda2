//! `cargo run --example hello` writes `hello.png`: a triangle at four bits per pixel.

use std::{error::Error, process::ExitCode};

use embedded_raster::{buffer_bytes, pixel::EGA, Canvas, Framebuffer, Index4, PointFx};
use embedded_raster_simulator::{finish, Picture};

fn main() -> ExitCode {
    finish("hello", draw())
}

fn draw() -> Result<String, Box<dyn Error>> {
    let mut ram = [0; buffer_bytes::<Index4>(64, 48)]; // 1,536 bytes: a display driver would be sent these
    let mut frame = Framebuffer::<Index4>::new(&mut ram, 64, 48)?;
    frame.clear(Index4::new(1));
    frame.fill_triangle_fx([PointFx::px(32, 4), PointFx::px(60, 40), PointFx::px(6, 44)], Index4::new(14));
    frame.draw_line((-9, 47), (70, 0), Index4::new(12));

    let picture = Picture::indexed(&frame, &EGA);
    picture.show(64);
    picture.write_png("hello.png")?;
    Ok("hello.png: 64 x 48 at 4 bits per pixel\n".into())
}
