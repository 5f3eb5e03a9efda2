//! Prints what textured triangles cost: one line per workload, way to the places, and texture.
#![no_std]
#![no_main]

use core::hint::black_box;

use bench::scene::{HEIGHT, WIDTH};
use board::counter::{count, Count};
use board::{crc32, println, stack, CHIP};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::geom::{Fast, Perspective, Runs, Varying};
use embedded_raster::surface::texture::{AddressMode, Clamp, Mirror, Repeat, Tile};
use embedded_raster::surface::{Counter, Rows, Texture};
use embedded_raster::{Bitmap, Canvas, Framebuffer, PixelFormat, PointFx, Rect};
use fixed::types::I16F16;

board::entry!(main);

/// Three corners, with a place in the texture in texels at each, and their distance from the eye.
type Corners = [(i32, i32, i32, i32, i32); 3];

/// About 20,000 pixels.
const LARGE: [Corners; 1] =
    [[(30 * 256, 20 * 256, 0, 0, 2), (290 * 256, 70 * 256, 230, 3, 4), (114 * 256, 190 * 256, 40, 170, 7)]];

/// Triangles of about 100 pixels, in a grid of cells 20 pixels wide.
fn small() -> [Corners; 120] {
    core::array::from_fn(|i| {
        let (x, y, n) = ((i % 15 * 20) as i32 * 256, (i / 15 * 20) as i32 * 256, i as i32);
        let b = (x + 15 * 256 + n * 37 % 900, y + n * 91 % 700, n % 60, 5, 3);
        let c = (x + n * 53 % 800, y + 13 * 256 + n * 77 % 800, 5, n * 7 % 60, 4);
        let a = (x + n * 17 % 256, y, 20, 20, 4);
        if i % 2 == 0 {
            [a, b, c]
        } else {
            [c, b, a]
        }
    })
}

type Memory = [u8; WIDTH * HEIGHT * 2];

fn main() {
    println!("# {CHIP}: modelled cycles; stack in bytes below the call");
    println!("# workload;texture;mode;cycles;instructions;calls;pixels;stack;crc32");
    let mut memory: Memory = [0; WIDTH * HEIGHT * 2];
    let mut texels = [0; 64 * 64 * 2];
    (0_u32..).zip(&mut texels).for_each(|(i, byte)| *byte = (i.wrapping_mul(0x9e37_79b1) >> 24) as u8);
    let (small, picture) = (small(), Bitmap::<Rgb565>::new(&texels, 64, 64).unwrap());
    let part = picture.view(Rect::new(2, 2, 62, 61));
    for (name, triangles) in [("texture-20000", &LARGE[..]), ("texture-100", &small[..])] {
        let tile = Texture::new(&picture, (Tile, Tile)).unwrap();
        nearest(name, "64x64", triangles, &mut memory, tile);
        nearest(name, "clamp", triangles, &mut memory, Texture::new(&part, (Clamp, Clamp)).unwrap());
        nearest(name, "60x59", triangles, &mut memory, Texture::new(&part, (Repeat, Repeat)).unwrap());
        nearest(name, "mirror", triangles, &mut memory, Texture::new(&part, (Mirror, Mirror)).unwrap());
        measure(name, "64x64", "exact", triangles, &mut memory, |u, v, _| (u, v), move |(u, v)| tile.nearest(u, v));
        let seen = |u, v, w| Perspective { w, value: Fast((u, v)) };
        let color = move |at: Perspective<Fast<(I16F16, I16F16)>>| tile.nearest(at.value.0 .0, at.value.0 .1);
        measure(name, "64x64", "perspective", triangles, &mut memory, seen, color);
        runs::<8, _, _>(name, "runs-8", triangles, &mut memory, tile);
        runs::<16, _, _>(name, "runs-16", triangles, &mut memory, tile);
        runs::<32, _, _>(name, "runs-32", triangles, &mut memory, tile);
        let mix = move |Fast((u, v))| tile.bilinear(u, v);
        measure(name, "bilinear", "fast", triangles, &mut memory, |u, v, _| Fast((u, v)), mix);
    }
}

fn nearest<U: AddressMode, V: AddressMode>(
    name: &str,
    kind: &str,
    triangles: &[Corners],
    memory: &mut Memory,
    texture: Texture<'_, Rows<Rgb565>, U, V>,
) {
    let color = move |Fast((u, v))| texture.nearest(u, v);
    measure(name, kind, "fast", triangles, memory, |u, v, _| Fast((u, v)), color);
}

fn runs<const N: u32, U: AddressMode, V: AddressMode>(
    name: &str,
    mode: &str,
    triangles: &[Corners],
    memory: &mut Memory,
    texture: Texture<'_, Rows<Rgb565>, U, V>,
) {
    let value = |u, v, w| Runs::<_, N> { w, value: Fast((u, v)) };
    let color = move |at: Runs<Fast<(I16F16, I16F16)>, N>| texture.nearest(at.value.0 .0, at.value.0 .1);
    measure(name, "64x64", mode, triangles, memory, value, color);
}

fn measure<V: Varying>(
    name: &str,
    texture: &str,
    mode: &str,
    triangles: &[Corners],
    memory: &mut Memory,
    value: impl Fn(I16F16, I16F16, I16F16) -> V,
    color: impl Fn(V) -> Rgb565 + Copy,
) {
    memory.fill(0);
    let mut draw = || {
        let mut frame = Framebuffer::<Rgb565>::new(&mut memory[..], WIDTH as u16, HEIGHT as u16).unwrap();
        for corners in black_box(triangles) {
            let places = corners.map(|(x, y, ..)| PointFx::from_bits(x, y));
            let values = corners.map(|(_, _, u, v, w)| {
                let [u, v, w] = [u, v, w].map(|n| I16F16::from_bits(n << 16));
                value(u, v, w)
            });
            frame.shade_triangle_fx(places, values, color).unwrap();
        }
    };
    let Count { cycles, instructions } = count(&mut draw);
    let stack = stack::depth(&mut draw);
    let mut counter = Counter::<Rgb565>::new(Rect::new(0, 0, WIDTH as i32, HEIGHT as i32));
    for corners in triangles {
        counter.fill_triangle_fx(corners.map(|(x, y, ..)| PointFx::from_bits(x, y)), Rgb565::unpack(0));
    }
    let (calls, pixels, crc32) = (triangles.len(), counter.pixels, crc32(&memory[..]));
    println!("{name};{texture};{mode};{cycles};{instructions};{calls};{pixels};{stack};{crc32:08x}");
}
