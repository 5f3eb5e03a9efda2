//! Prints what shaded triangles cost: one line per workload, format and mode.
#![no_std]
#![no_main]

use core::hint::black_box;

use bench::scene::{HEIGHT, WIDTH};
use board::counter::{count, Count};
use board::{crc32, println, stack, CHIP};
use embedded_graphics::pixelcolor::{Gray4, Rgb565, Rgb888, RgbColor};
use embedded_raster::geom::{Fast, Varying};
use embedded_raster::{Canvas, Framebuffer, PixelFormat, PointFx};

board::entry!(main);

/// Three corners, and a byte at each.
type Corners = [(i32, i32, u8); 3];

/// Memory for frames of up to 24 bits.
type Memory = [u8; WIDTH * HEIGHT * 3];

/// About 20,000 pixels.
const LARGE: [Corners; 1] = [[(30 * 256, 20 * 256, 250), (290 * 256, 70 * 256, 3), (114 * 256, 190 * 256, 120)]];

/// Rows of two pixels: what a row costs.
const TALL: [Corners; 1] = [[(30 * 256, 20 * 256, 250), (32 * 256, 20 * 256, 3), (34 * 256, 220 * 256, 120)]];

/// One pixel: what a triangle costs.
const TINY: [Corners; 1] = [[(30 * 256, 20 * 256, 250), (32 * 256, 20 * 256, 3), (30 * 256, 22 * 256, 120)]];

/// Triangles of about 100 pixels, of several shapes and both windings, in a grid of cells 20 pixels wide.
fn small() -> [Corners; 120] {
    core::array::from_fn(|i| {
        let (x, y, n) = ((i % 15 * 20) as i32 * 256, (i / 15 * 20) as i32 * 256, i as i32);
        let b = (x + 15 * 256 + n * 37 % 900, y + n * 91 % 700, (n * 29 & 255) as u8);
        let c = (x + n * 53 % 800, y + 13 * 256 + n * 77 % 800, (n * 71 & 255) as u8);
        let a = (x + n * 17 % 256, y, 255);
        if i % 2 == 0 { [a, b, c] } else { [c, b, a] }
    })
}

fn main() {
    println!("# {CHIP}: modelled cycles; stack in bytes below the call");
    println!("# workload;format;mode;cycles;instructions;calls;pixels;stack;crc32");
    let mut memory: Memory = [0; WIDTH * HEIGHT * 3];
    let small = small();
    for (name, triangles) in
        [("gouraud-20000", &LARGE[..]), ("gouraud-100", &small[..]), ("gouraud-rows", &TALL[..]), ("gouraud-tiny", &TINY[..])]
    {
        let rgb565 = |n: u8| Rgb565::new(n >> 3, 63 - (n >> 2), 31 - (n >> 4));
        measure::<Rgb565, _>(name, "rgb565", "exact", triangles, &mut memory, rgb565, |c| c);
        measure::<Rgb565, _>(name, "rgb565", "fast", triangles, &mut memory, |n| Fast(rgb565(n)), |c| c.0);
        let rgb888 = |n: u8| Rgb888::new(n, 255 - n, n / 2);
        measure::<Rgb888, _>(name, "rgb888", "exact", triangles, &mut memory, rgb888, |c| c);
        measure::<Gray4, _>(name, "gray4", "exact", triangles, &mut memory, |n| Gray4::new(n >> 4), |c| c);
    }
}

fn measure<F: PixelFormat, V: Varying>(
    name: &str,
    format: &str,
    mode: &str,
    triangles: &[Corners],
    memory: &mut Memory,
    value: impl Fn(u8) -> V,
    color: impl Fn(V) -> F::Color,
) {
    memory.fill(0);
    let mut draw = || {
        let mut frame = Framebuffer::<F>::new(&mut memory[..], WIDTH as u16, HEIGHT as u16).unwrap();
        for corners in black_box(triangles) {
            let places = corners.map(|(x, y, _)| PointFx::from_bits(x, y));
            frame.shade_triangle_fx(places, corners.map(|c| value(c.2)), &color).unwrap();
        }
    };
    let Count { cycles, instructions } = count(&mut draw);
    let stack = stack::depth(&mut draw);
    let mut counter = embedded_raster::surface::Counter::<F::Color>::new(embedded_raster::Rect::new(0, 0, WIDTH as i32, HEIGHT as i32));
    for corners in triangles {
        counter.fill_triangle_fx(corners.map(|(x, y, _)| PointFx::from_bits(x, y)), F::unpack(0));
    }
    let (calls, pixels, crc32) = (triangles.len(), counter.pixels, crc32(&memory[..]));
    println!("{name};{format};{mode};{cycles};{instructions};{calls};{pixels};{stack};{crc32:08x}");
}
