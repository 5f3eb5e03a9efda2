//! Prints what shaded triangles cost: one line per workload, format and mode.
#![no_std]
#![no_main]

use core::hint::black_box;

use bench::scene::{HEIGHT, WIDTH};
use board::counter::{count, Count};
use board::{crc32, println, stack, CHIP};
use embedded_graphics::pixelcolor::{Gray4, Rgb565, Rgb888};
use embedded_raster::geom::{Fast, Varying};
use embedded_raster::paint::depth;
use embedded_raster::pixel::Depth16;
use embedded_raster::surface::{Counter, DepthBuffer};
use embedded_raster::{Canvas, Framebuffer, PixelFormat, PointFx, Rect};

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
        if i % 2 == 0 {
            [a, b, c]
        } else {
            [c, b, a]
        }
    })
}

/// Columns and rows of the mesh.
const GRID: (usize, usize) = (10, 10);

/// A corner of a mesh: a place, a depth, and a byte.
type Corner = (PointFx, u16, u8);

/// How many layers the mesh has.
const LAYERS: usize = 4;

/// A corner of a layer of the mesh. Cells are about 10 pixels wide and high, and each layer is bent, so that layers pass through
/// each other.
fn bend(layer: usize, (column, row): (usize, usize)) -> Corner {
    let (i, j, n) = (column as i32, row as i32, layer as i32);
    let place = PointFx::from_bits(2600 * i + j * 97 % 300 + 3000 + n * 61, 2550 * j + i * 83 % 300 + 2000 + n * 47);
    let depth = 30_000 + n * 900 + (i - 5) * (j - 4) * (if n % 2 == 0 { 300 } else { -300 }) + i * 211 % 170;
    (place, depth as u16, (i * 29 + j * 53 + n * 71 & 255) as u8)
}

/// Calls `f` with the triangles of the mesh: layer by layer, two for each cell.
fn mesh(mut f: impl FnMut([Corner; 3])) {
    for layer in 0..LAYERS {
        for cell in 0..GRID.0 * GRID.1 {
            let (i, j) = (cell % GRID.0, cell / GRID.0);
            let corner = |i, j| bend(layer, (i, j));
            let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i, j + 1), corner(i + 1, j + 1)];
            f([a, b, c]);
            f([d, c, b]);
        }
    }
}

/// Draws the mesh, depth-tested, after the depths are cleared, which takes about 1 % of it. Its corners are computed before.
fn measure_mesh(memory: &mut Memory) {
    memory.fill(0);
    let mut triangles = [[(PointFx::px(0, 0), 0, 0); 3]; LAYERS * GRID.0 * GRID.1 * 2];
    let mut places = triangles.iter_mut();
    mesh(|corners| *places.next().unwrap() = corners);
    let (width, height) = (130, 120);
    let (colors, depths) = memory.split_at_mut(usize::from(width) * usize::from(height) * 2);
    let mut draw = || {
        let mut frame = Framebuffer::<Rgb565>::new(&mut *colors, width, height).unwrap();
        let mut depth = DepthBuffer::<Depth16>::new(&mut *depths, width, height).unwrap();
        depth.clear(Depth16::MAX);
        for corners in black_box(&triangles) {
            let values = corners.map(|(_, z, n)| (z, Rgb565::new(n >> 3, 63 - (n >> 2), 31 - (n >> 4))));
            frame.depth_triangle_fx(corners.map(|c| c.0), values, &mut depth, depth::less, |c| c).unwrap();
        }
    };
    let Count { cycles, instructions } = count(&mut draw);
    let stack = stack::depth(&mut draw);
    let mut counter = Counter::<Rgb565>::new(Rect::new(0, 0, width.into(), height.into()));
    triangles.iter().for_each(|c| counter.fill_triangle_fx(c.map(|c| c.0), Rgb565::new(0, 0, 0)));
    let mut depth = DepthBuffer::<Depth16>::new(&mut *depths, width, height).unwrap();
    depth.clear(Depth16::MAX);
    let mut seen = Counter::<Rgb565>::new(Rect::new(0, 0, width.into(), height.into()));
    for corners in &triangles {
        let values = corners.map(|(_, z, _)| (z, ()));
        seen.depth_triangle_fx(corners.map(|c| c.0), values, &mut depth, depth::less, |()| Rgb565::new(0, 0, 0))
            .unwrap();
    }
    let (calls, tested, painted, crc32) = (triangles.len(), counter.pixels, seen.pixels, crc32(&memory[..]));
    println!("mesh-50;rgb565;depth16;{cycles};{instructions};{calls};{tested};{stack};{crc32:08x}");
    println!("# of {tested} fragments of the mesh, {painted} pass");
}

fn main() {
    println!("# {CHIP}: modelled cycles; stack in bytes below the call");
    println!("# workload;format;mode;cycles;instructions;calls;pixels;stack;crc32");
    let mut memory: Memory = [0; WIDTH * HEIGHT * 3];
    let small = small();
    for (name, triangles) in [
        ("gouraud-20000", &LARGE[..]),
        ("gouraud-100", &small[..]),
        ("gouraud-rows", &TALL[..]),
        ("gouraud-tiny", &TINY[..]),
    ] {
        let rgb565 = |n: u8| Rgb565::new(n >> 3, 63 - (n >> 2), 31 - (n >> 4));
        measure::<Rgb565, _>(name, "rgb565", "exact", triangles, &mut memory, rgb565, |c| c);
        measure::<Rgb565, _>(name, "rgb565", "fast", triangles, &mut memory, |n| Fast(rgb565(n)), |c| c.0);
        let rgb888 = |n: u8| Rgb888::new(n, 255 - n, n / 2);
        measure::<Rgb888, _>(name, "rgb888", "exact", triangles, &mut memory, rgb888, |c| c);
        measure::<Gray4, _>(name, "gray4", "exact", triangles, &mut memory, |n| Gray4::new(n >> 4), |c| c);
    }
    measure_mesh(&mut memory);
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
    let mut counter = Counter::<F::Color>::new(Rect::new(0, 0, WIDTH as i32, HEIGHT as i32));
    for corners in triangles {
        counter.fill_triangle_fx(corners.map(|(x, y, _)| PointFx::from_bits(x, y)), F::unpack(0));
    }
    let (calls, pixels, crc32) = (triangles.len(), counter.pixels, crc32(&memory[..]));
    println!("{name};{format};{mode};{cycles};{instructions};{calls};{pixels};{stack};{crc32:08x}");
}
