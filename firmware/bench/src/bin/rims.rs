//! Prints what soft rims cost: each shape as a plain fill and antialiased, at 16 bits, and how many pixels it covers in part.
#![no_std]
#![no_main]

use core::hint::black_box;

use bench::scene::{Scene, Segment, Triangle, Work, HEIGHT, WIDTH};
use board::counter::{count, Count};
use board::{println, CHIP};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::paint::{Alpha, Brush, Cover, Paint};
use embedded_raster::raster::{coverage, rectangle};
use embedded_raster::{
    Antialias, Canvas, ClippedSpan, CoverageSlot, EdgeSlot, Ellipse, FillRule, Framebuffer, Path, PathSegment, PointFx,
    Rect, Sink, Solid, Span,
};
use textbook::scene as triangles;

board::entry!(main);

const RED: Rgb565 = Rgb565::new(27, 11, 5);

type Frame<'a> = Framebuffer<'a, Rgb565>;

/// Scratch memory for sides and cells.
struct Scratch {
    edges: [EdgeSlot; 128],
    sides: [CoverageSlot; 512],
    cells: [i32; coverage::cells(WIDTH as u16)],
}

/// Counts what a shape covers: pixels in part, and calls that tell them.
#[derive(Default)]
struct Rims {
    pixels: u32,
    rims: u32,
}

impl Sink for &mut Rims {
    fn span(&mut self, span: ClippedSpan) {
        self.pixels += span.len();
    }

    fn coverage(&mut self, span: ClippedSpan, _: &[u8]) {
        self.pixels += span.len();
        self.rims += span.len();
    }
}

/// A shape: drawn as a plain fill, drawn with soft rims, and told.
struct Shape<'a> {
    name: &'a str,
    flat: &'a dyn Fn(&mut Frame<'_>, &mut Scratch),
    soft: &'a dyn Fn(&mut Frame<'_>, &mut Scratch),
    told: &'a dyn Fn(&mut Rims, &mut Scratch),
}

fn print(shape: &Shape<'_>, memory: &mut [u8], scratch: &mut Scratch) {
    let mut rims = Rims::default();
    (shape.told)(&mut rims, scratch);
    for (way, draw) in [("flat", shape.flat), ("soft", shape.soft)] {
        let mut frame = Frame::new(&mut *memory, WIDTH as u16, HEIGHT as u16).unwrap();
        let Count { cycles, instructions } = count(&mut || black_box(draw)(black_box(&mut frame), black_box(scratch)));
        println!("{};{way};{cycles};{instructions};{};{}", shape.name, rims.pixels, rims.rims);
    }
}

const WINDOW: Rect = Rect::new(0, 0, WIDTH as i32, HEIGHT as i32);

fn main() {
    println!("# {CHIP}: modelled cycles");
    println!("# shape;way;cycles;instructions;pixels;rims");
    let mut memory = [0; 2 * WIDTH * HEIGHT];
    let mut scratch = Scratch {
        edges: [EdgeSlot::EMPTY; 128],
        sides: [CoverageSlot::EMPTY; 512],
        cells: [0; coverage::cells(WIDTH as u16)],
    };
    let scene = Scene::new();
    let pictures = bench::scene::Pictures::new(bench::scene::Format::Rgb565);
    for workload in &scene.workloads(&pictures) {
        match (&workload.work, workload.name) {
            (Work::Triangles(list), "triangle-20000") => {
                fill_triangles("triangle of 20,000 px", list, &mut memory, &mut scratch)
            }
            (Work::Lines(list), "lines-long" | "lines-12") => lines(workload.name, list, &mut memory, &mut scratch),
            (Work::Discs(list), "disc-101") => disc(Ellipse::in_box(list[0].sides), &mut memory, &mut scratch),
            (Work::Blob(blob), _) => path(blob.curves, &mut memory, &mut scratch),
            _ => {}
        }
    }
    let units = |corners: &triangles::Triangle| corners.each_ref().map(|corner| corner.at);
    let small = triangles::small().each_ref().map(|corners| Triangle {
        px: Default::default(),
        units: units(corners),
        ink: bench::scene::Ink(1),
    });
    fill_triangles("120 triangles of 100 px", &small, &mut memory, &mut scratch);
    span(&mut memory, &mut scratch);
    glyph(&mut memory, &mut scratch);
}

fn places(triangle: &Triangle) -> [PointFx; 3] {
    triangle.units.map(|[x, y]| PointFx::from_bits(x, y))
}

fn fill_triangles(name: &str, list: &[Triangle], memory: &mut [u8], scratch: &mut Scratch) {
    let shape = Shape {
        name,
        flat: &|frame, _| list.iter().for_each(|t| frame.fill_triangle_fx(places(t), RED)),
        soft: &|frame, s| list.iter().for_each(|t| frame.fill_triangle_aa(places(t), &mut s.cells, Cover(RED))),
        told: &|told, s| list.iter().for_each(|t| coverage::triangle(places(t), &mut s.cells, WINDOW, &mut *told)),
    };
    print(&shape, memory, scratch);
}

fn lines(name: &str, list: &[Segment], memory: &mut [u8], scratch: &mut Scratch) {
    let ends = |line: &Segment| line.ends.map(PointFx::centre_of);
    let shape = Shape {
        name,
        flat: &|frame, _| list.iter().for_each(|line| frame.draw_line(line.ends[0], line.ends[1], RED)),
        soft: &|frame, _| {
            for line in list {
                let [a, b] = ends(line);
                frame.draw_line_aa(a, b, Cover(RED));
            }
        },
        told: &|told, _| {
            for line in list {
                let [a, b] = ends(line);
                coverage::line(a, b, WINDOW, &mut *told);
            }
        },
    };
    print(&shape, memory, scratch);
}

fn disc(disc: Ellipse, memory: &mut [u8], scratch: &mut Scratch) {
    let shape = Shape {
        name: "circle of 101 px",
        flat: &|frame, _| frame.fill_ellipse_fx(disc, RED),
        soft: &|frame, _| frame.fill_ellipse_aa(disc, Cover(RED)),
        told: &|told, _| coverage::ellipse(disc, WINDOW, told),
    };
    print(&shape, memory, scratch);
}

fn path(curves: &[[[i32; 2]; 4]; 8], memory: &mut [u8], scratch: &mut Scratch) {
    let place = |[x, y]: [i32; 2]| PointFx::from_bits(x, y);
    let mut segments = [PathSegment::MoveTo(place(curves[0][0])); 9];
    for (segment, curve) in segments[1..].iter_mut().zip(curves) {
        let [_, c, d, b] = curve.map(place);
        *segment = PathSegment::CubicTo(c, d, b);
    }
    let rule = FillRule::NonZero;
    let shape = Shape {
        name: "path of 8 curves",
        flat: &|frame, s| frame.fill_path_fx(Path::new(&segments), rule, &mut s.edges, RED).unwrap(),
        soft: &|frame, s| {
            frame.fill_path_aa(Path::new(&segments), rule, &mut s.sides, &mut s.cells, Cover(RED)).unwrap();
        },
        told: &|told, s| coverage::path(Path::new(&segments), rule, &mut s.sides, &mut s.cells, WINDOW, told).unwrap(),
    };
    print(&shape, memory, scratch);
}

/// Sixty-four rows of 200 pixels, filled, or mixed with what is there.
fn span(memory: &mut [u8], scratch: &mut Scratch) {
    let area = Rect::new(31, 20, 231, 84);
    let shape = Shape {
        name: "64 spans of 200 px, half transparent",
        flat: &|frame, _| frame.fill_rectangle(area, RED),
        soft: &|frame, _| {
            let glass = Alpha { color: RED, alpha: 100 };
            frame.paint(glass, |window, brush| rectangle::fill(area, window, brush));
        },
        told: &|told, _| {
            let pixels = area.width() * area.height();
            *told = Rims { pixels, rims: pixels };
        },
    };
    print(&shape, memory, scratch);
}

/// Columns and rows of the glyph.
const GLYPH: (i32, i32) = (14, 18);

/// The coverage of a glyph, as a rasterizer of fonts bakes it: an "a" of two rings.
fn bake(scratch: &mut Scratch) -> [u8; (GLYPH.0 * GLYPH.1) as usize] {
    struct Baked([u8; (GLYPH.0 * GLYPH.1) as usize]);
    impl Sink for &mut Baked {
        fn span(&mut self, span: ClippedSpan) {
            self.coverage(span, &[255; GLYPH.0 as usize][..span.len() as usize]);
        }

        fn coverage(&mut self, span: ClippedSpan, levels: &[u8]) {
            let start = (span.y() * GLYPH.0 + span.x0()) as usize;
            self.0[start..start + levels.len()].copy_from_slice(levels);
        }
    }
    let ring = |cy: i32, outer: i32, inner: i32| {
        let at = |r: i32, i: usize| {
            let way =
                [(256, 0), (181, 181), (0, 256), (-181, 181), (-256, 0), (-181, -181), (0, -256), (181, -181)][i % 8];
            PointFx::from_bits(7 * 256 + way.0 * r / 16, cy * 16 + way.1 * r / 16)
        };
        let place = move |i: usize| if i < 8 { at(outer, i) } else { at(inner, 15 - i) };
        [core::array::from_fn::<_, 8, _>(place), core::array::from_fn::<_, 8, _>(|i| place(i + 8))]
    };
    let mut baked = Baked([0; (GLYPH.0 * GLYPH.1) as usize]);
    let contours = [ring(75, 70, 38), ring(210, 76, 40)];
    let contours = contours.iter().flatten();
    let window = Rect::new(0, 0, GLYPH.0, GLYPH.1);
    let (table, cells) = (&mut scratch.sides, &mut scratch.cells);
    coverage::fill(contours, FillRule::NonZero, table, cells, window, &mut baked).unwrap();
    baked.0
}

/// Sixteen glyphs of 14 x 18 pixels: as many levels of each row as there are pixels.
fn glyph(memory: &mut [u8], scratch: &mut Scratch) {
    let levels = bake(scratch);
    let rows = |draw: &mut dyn FnMut(ClippedSpan, &[u8])| {
        for i in 0..16 {
            for (y, row) in (30..).zip(levels.chunks_exact(GLYPH.0 as usize)) {
                let x0 = 20 + 15 * i;
                if let Some(span) = (Span { y, x0, x1: x0 + GLYPH.0 }).clip(WINDOW) {
                    draw(span, row);
                }
            }
        }
    };
    let shape = Shape {
        name: "16 glyphs of 14 x 18 px",
        flat: &|frame, _| rows(&mut |span, levels| Solid(RED).coverage(&mut *frame, span, levels)),
        soft: &|frame, _| rows(&mut |span, levels| Brush::new(&mut *frame, Cover(RED)).coverage(span, levels)),
        told: &|told, _| {
            rows(&mut |_, levels| told.pixels += levels.iter().filter(|&&level| level > 0).count() as u32);
            told.rims = told.pixels;
        },
    };
    print(&shape, memory, scratch);
}
