//! Prints what shaded triangles cost, one line per workload and way: those of textbooks, and this crate's.
#![no_std]
#![no_main]

use core::hint::black_box;

use bench::scene::{HEIGHT, WIDTH};
use board::counter::{count, Count};
use board::{println, CHIP};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::geom::{Fast, Perspective, Runs, Varying};
use embedded_raster::paint::depth::less;
use embedded_raster::pixel::{Depth16, Depth32};
use embedded_raster::surface::texture::{Texture, Tile};
use embedded_raster::surface::{Counter, Depth, DepthBuffer};
use embedded_raster::{Bitmap, Canvas, Framebuffer, PointFx, Rect};
use fixed::types::I16F16;
use textbook::scene::{self, Corner, Triangle};
use textbook::{depth, gouraud, texture, Size};

board::entry!(main);

/// Pixels, as bytes of this crate's frames and as numbers of the textbooks'.
struct Memory {
    bytes: [u8; WIDTH * HEIGHT * 2],
    depths: [u8; MESH * 4],
    pixels: [u16; WIDTH * HEIGHT],
    words: [u16; MESH],
    floats: [f32; MESH],
}

/// Pixels of the mesh's frame.
const MESH: usize = scene::MESH_SIZE.0 as usize * scene::MESH_SIZE.1 as usize;

const SIZE: Size = Size { width: WIDTH as i32, height: HEIGHT as i32 };
const MESH_SIZE: Size = Size { width: scene::MESH_SIZE.0 as i32, height: scene::MESH_SIZE.1 as i32 };

/// The side of the texture is `1 << TEXTURE`.
const TEXTURE: u32 = 6;

fn main() {
    println!("# {CHIP}: modelled cycles");
    println!("# family;workload;way;cycles;instructions;pixels");
    let mut memory = Memory {
        bytes: [0; WIDTH * HEIGHT * 2],
        depths: [0; MESH * 4],
        pixels: [0; WIDTH * HEIGHT],
        words: [0; MESH],
        floats: [0.0; MESH],
    };
    let small = scene::small();
    for (name, triangles) in [("20,000 px", &scene::LARGE[..]), ("100 px", &small[..])] {
        colors(name, triangles, &mut memory);
    }
    depths(&scene::mesh(), &mut memory);
    textures(&scene::LARGE, &mut memory);
}

/// One line: what it takes to draw the triangles.
fn line(name: &str, family: &str, way: &str, triangles: &[Triangle], size: Size, mut draw: impl FnMut(&[Triangle])) {
    let Count { cycles, instructions } = count(&mut || draw(black_box(triangles)));
    let mut counter = Counter::<Rgb565>::new(Rect::new(0, 0, size.width, size.height));
    triangles.iter().for_each(|corners| counter.fill_triangle_fx(places(corners), Rgb565::new(0, 0, 0)));
    println!("{family};{name};{way};{cycles};{instructions};{}", counter.pixels);
}

fn colors(name: &str, triangles: &[Triangle], memory: &mut Memory) {
    let frame = &mut memory.pixels[..];
    let mut textbook = |way, draw: fn(&mut [u16], Size, &Triangle)| {
        line(name, "gouraud", way, triangles, SIZE, |list| list.iter().for_each(|t| draw(black_box(frame), SIZE, t)));
    };
    textbook("barycentric", gouraud::barycentric);
    textbook("floats", gouraud::float_rows);
    textbook("fixed8", gouraud::fixed_rows::<8>);
    textbook("fixed16", gouraud::fixed_rows::<16>);
    textbook("plane16", gouraud::plane::<i32, 16>);
    textbook("plane24", gouraud::plane::<i64, 24>);
    own(name, "gouraud", "fast", triangles, memory, |c| Fast(color(c)), |Fast(color)| color);
    own(name, "gouraud", "exact", triangles, memory, color, |color| color);
}

fn places(corners: &Triangle) -> [PointFx; 3] {
    corners.each_ref().map(|corner| PointFx::from_bits(corner.at[0], corner.at[1]))
}

fn color(corner: &Corner) -> Rgb565 {
    let [r, g, b] = corner.levels.map(|level| level as u8);
    Rgb565::new(r, g, b)
}

/// This crate, with some values at the corners.
fn own<V: Varying>(
    name: &str,
    family: &str,
    way: &str,
    triangles: &[Triangle],
    memory: &mut Memory,
    value: impl Fn(&Corner) -> V,
    color: impl Fn(V) -> Rgb565 + Copy,
) {
    line(name, family, way, triangles, SIZE, |list| {
        let mut frame = Framebuffer::<Rgb565>::new(&mut memory.bytes[..], WIDTH as u16, HEIGHT as u16).unwrap();
        for corners in list {
            frame.shade_triangle_fx(places(corners), corners.each_ref().map(&value), color).unwrap();
        }
    });
}

/// The mesh. Depths are cleared before, which takes about 1 % of it.
fn depths(triangles: &[Triangle], memory: &mut Memory) {
    let Memory { pixels, words, floats, .. } = memory;
    let mesh = "mesh of 50 px";
    line(mesh, "depth16", "barycentric", triangles, MESH_SIZE, |list| {
        floats.fill(f32::INFINITY);
        list.iter().for_each(|t| depth::barycentric(pixels, floats, MESH_SIZE, t));
    });
    line(mesh, "depth16", "floats", triangles, MESH_SIZE, |list| {
        floats.fill(f32::INFINITY);
        list.iter().for_each(|t| depth::float_rows(pixels, floats, MESH_SIZE, t));
    });
    line(mesh, "depth16", "fixed14", triangles, MESH_SIZE, |list| {
        words.fill(u16::MAX);
        list.iter().for_each(|t| depth::fixed_rows(pixels, words, MESH_SIZE, t));
    });
    deep::<Depth16>(mesh, "depth16", triangles, memory, |corner| corner.depth as u16, Depth16::MAX);
    deep::<Depth32>(mesh, "depth32", triangles, memory, |corner| corner.depth << 16 | corner.depth, Depth32::MAX);
}

fn deep<Z: Depth>(
    name: &str,
    family: &str,
    triangles: &[Triangle],
    memory: &mut Memory,
    number: impl Fn(&Corner) -> Z::Number,
    far: Z,
) {
    let (width, height) = scene::MESH_SIZE;
    line(name, family, "exact", triangles, MESH_SIZE, |list| {
        let mut frame = Framebuffer::<Rgb565>::new(&mut memory.bytes[..MESH * 2], width, height).unwrap();
        let mut depths = DepthBuffer::<Z>::new(&mut memory.depths[..], width, height).unwrap();
        depths.clear(far);
        for corners in list {
            let values = corners.each_ref().map(|corner| (number(corner), color(corner)));
            frame.depth_triangle_fx(places(corners), values, &mut depths, less, |color| color).unwrap();
        }
    });
}

fn textures(triangles: &[Triangle], memory: &mut Memory) {
    let mut bytes = [0; 2 << (2 * TEXTURE)];
    (0_u32..).zip(&mut bytes).for_each(|(i, byte)| *byte = (i.wrapping_mul(0x9e37_79b1) >> 24) as u8);
    let texels: [u16; 1 << (2 * TEXTURE)] =
        core::array::from_fn(|i| u16::from_le_bytes([bytes[2 * i], bytes[2 * i + 1]]));
    let (name, kind) = ("20,000 px", "perspective");
    let frame = &mut memory.pixels[..];
    let mut textbook = |way, draw: fn(&mut [u16], Size, &Triangle, texture::Tile<'_>)| {
        let tile = texture::Tile { texels: &texels, bits: TEXTURE };
        line(name, kind, way, triangles, SIZE, |list| list.iter().for_each(|t| draw(black_box(frame), SIZE, t, tile)));
    };
    textbook("floats", texture::each);
    textbook("floats16", texture::runs::<16>);
    textbook("fixed", texture::affine::<16>);
    let side = 1 << TEXTURE;
    let picture = Bitmap::<Rgb565>::new(&bytes, side, side).unwrap();
    let tile = Texture::new(&picture, (Tile, Tile)).unwrap();
    let texel = move |Fast((u, v)): Fast<(I16F16, I16F16)>| tile.nearest(u, v);
    own(name, kind, "affine", triangles, memory, place, texel);
    own(
        name,
        kind,
        "runs32",
        triangles,
        memory,
        |c| Runs::<_, 32> { w: w(c), value: place(c) },
        move |at| texel(at.value),
    );
    own(
        name,
        kind,
        "runs16",
        triangles,
        memory,
        |c| Runs::<_, 16> { w: w(c), value: place(c) },
        move |at| texel(at.value),
    );
    own(
        name,
        kind,
        "runs8",
        triangles,
        memory,
        |c| Runs::<_, 8> { w: w(c), value: place(c) },
        move |at| texel(at.value),
    );
    own(
        name,
        kind,
        "exact",
        triangles,
        memory,
        |c| Perspective { w: w(c), value: place(c) },
        move |at| texel(at.value),
    );
}

fn place(corner: &Corner) -> Fast<(I16F16, I16F16)> {
    let [u, v] = corner.texel.map(|n| I16F16::from_bits(n << 16));
    Fast((u, v))
}

fn w(corner: &Corner) -> I16F16 {
    I16F16::from_bits(corner.w << 16)
}
