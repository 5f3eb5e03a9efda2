//! Everyday drawing: pictures of other colours, sizes and angles, patterns, raster operations, dither, and turned screens; beside them
//! what embedded-graphics and tinybmp have of that.

use core::array::from_fn;
use core::convert::Infallible;
use core::hint::black_box;

use bench::scene::{self, Format, Lcg, Scene, Work, HEIGHT, WIDTH};
use bench::{eg, own, report};
use embedded_graphics::image::{Image, ImageDrawableExt, ImageRaw};
use embedded_graphics::pixelcolor::raw::LittleEndian;
use embedded_graphics::pixelcolor::{BinaryColor, Gray8, Rgb565, Rgb888};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use embedded_raster::paint::{pattern, Bayer, Pattern, RasterOp};
use embedded_raster::pixel::FloydSteinberg;
use embedded_raster::raster::rectangle;
use embedded_raster::surface::{Sheet, Turn, Turned};
use embedded_raster::{
    Affine, Angle, Bitmap, Canvas, Framebuffer, Index8, Palette, Pictures as _, Readable, Rect, Span,
};
use fixed::types::I16F16;
use tinybmp::Bmp;

/// Pixels in a row of the pictures, and rows.
const SIDE: usize = 64;
const SQUARE: usize = SIDE * SIDE;
/// Those of a tile.
const TILE: usize = 16;
/// Pictures that are drawn as they are.
const COPIES: usize = 8;

/// A rectangle that lies in no way well in memory.
const AREA: Rect = Rect::new(33, 41, 233, 192);
const PIXELS: usize = 200 * 151;

/// Bytes before the pixels of a BMP of 8 bits: its two headers, and its table.
const BMP_START: usize = 14 + 40 + 4 * 256;

/// The same picture in every way that it is kept.
pub(crate) struct Pictures {
    indices: [u8; SQUARE],
    palette: [Rgb565; 256],
    bmp: [u8; BMP_START + SQUARE],
    bits: [u8; SQUARE / 8],
    colors: [u8; 2 * SQUARE],
    rgb: [u8; 3 * SQUARE],
}

impl Pictures {
    /// Makes them, the same each time.
    pub(crate) fn new() -> Self {
        let random = &mut Lcg::new(0xDA11);
        let mut pictures = Self {
            indices: from_fn(|_| random.bits() as u8),
            palette: from_fn(|_| Rgb565::new(random.bits() as u8, random.bits() as u8, random.bits() as u8)),
            bmp: [0; BMP_START + SQUARE],
            bits: from_fn(|_| random.bits() as u8),
            colors: from_fn(|_| random.bits() as u8),
            // Slopes, which is what dither is for.
            rgb: from_fn(|i| (i / 3 % SIDE * 3 + i / (3 * SIDE) + i % 3 * 20) as u8),
        };
        pictures.write_bmp();
        pictures
    }

    fn write_bmp(&mut self) {
        let mut at = 0;
        let mut put = |bytes: &[u8]| {
            self.bmp[at..at + bytes.len()].copy_from_slice(bytes);
            at += bytes.len();
        };
        let word = |n: usize| (n as u32).to_le_bytes();
        put(b"BM");
        [BMP_START + SQUARE, 0, BMP_START, 40, SIDE].iter().for_each(|&n| put(&word(n)));
        // From the top down; one plane of 8 bits; not compressed.
        put(&(-(SIDE as i32)).to_le_bytes());
        put(&[1, 0, 8, 0]);
        [0, SQUARE, 2_835, 2_835, 256, 0].iter().for_each(|&n| put(&word(n)));
        for color in self.palette.map(Rgb888::from) {
            put(&[color.b(), color.g(), color.r(), 0]);
        }
        put(&self.indices);
    }
}

impl Default for Pictures {
    fn default() -> Self {
        Self::new()
    }
}

/// Where the `i`-th copy of a picture lies: inside the frame, every other one at an odd column.
fn place(i: usize) -> Point {
    let i = i as i32;
    Point::new(4 + 31 * i, 3 + 22 * i)
}

/// The tile in a cell of a map.
fn tile_at(column: i32, row: i32) -> usize {
    (column * 5 + row * 3) as usize & 15
}

/// Prints a line for each.
pub(crate) fn print(pictures: &Pictures, scene: &Scene) {
    let mut frame = own::Frame::new();
    of_pictures(pictures, &mut frame);
    of_paints(&mut frame);
    of_dither(pictures, &mut frame);
    turned(scene, &mut frame);
    of_peers(pictures, &mut eg::Rgb565Frame::new());
}

type Frame = own::Frame<Rgb565>;

fn of_pictures(pictures: &Pictures, frame: &mut Frame) {
    let side = SIDE as u16;
    let mut print = |name: &str, calls: usize, pixels: usize, draw: &dyn Fn(&mut Frame)| {
        report::item(&own::RGB565, frame, (name, calls, pixels), draw);
    };
    let indices = Bitmap::<Index8>::new(&pictures.indices, side, side).unwrap();
    let palette = Palette::new(pictures.palette);
    print("palette-64", COPIES, COPIES * SQUARE, &|frame| {
        let mut surface = frame.surface();
        (0..COPIES).for_each(|i| surface.blit_mapped(place(i), &indices, |index: Index8| palette.get(index.into())));
    });
    let bits = Bitmap::<BinaryColor>::new(&pictures.bits, side, side).unwrap();
    print("bits-64", COPIES, COPIES * SQUARE, &|frame| {
        let (mut surface, [on, off]) = (frame.surface(), black_box([Rgb565::WHITE, Rgb565::BLACK]));
        (0..COPIES).for_each(|i| surface.blit_mask(place(i), &bits, on, off));
    });
    let colors = Bitmap::<Rgb565>::new(&pictures.colors, side, side).unwrap();
    print("stretched-twice", 2, 2 * 4 * SQUARE, &|frame| {
        let mut surface = frame.surface();
        for area in black_box([Rect::new(5, 9, 133, 137), Rect::new(150, 70, 278, 198)]) {
            surface.blit_stretched(area, &colors, Some);
        }
    });
    print("turned-30-degrees", 4, 4 * SQUARE, &|frame| {
        let (mut surface, turn) = (frame.surface(), Affine::rotate(Angle::degrees(30)));
        for at in black_box([[50, 5], [200, 20], [60, 120], [210, 140]]) {
            let [x, y] = at.map(|n| I16F16::from_num(n));
            surface.blit_affine(&turn.then(Affine::translate(x, y)), &colors, Some).unwrap();
        }
    });
    let button = colors.view(Rect::new(0, 0, 24, 24));
    print("nine-patch", 1, PIXELS, &|frame| {
        frame.surface().blit_nine_patch(black_box(AREA), &button, Rect::new(8, 8, 16, 16), Some);
    });
    let sheet = Sheet::new(&colors, TILE as u16, TILE as u16);
    print("tile-map", 1, WIDTH * HEIGHT, &|frame| {
        let at = black_box(Point::new(-5, -9));
        frame.surface().draw_tile_map(at, &sheet, |column, row| Some(tile_at(column, row)), Some);
    });
}

fn of_paints(frame: &mut Frame) {
    let mut print = |name: &str, draw: &dyn Fn(&mut Frame)| {
        report::item(&own::RGB565, frame, (name, 1, PIXELS), draw);
    };
    let [ink, paper] = [Rgb565::new(22, 5, 9), Rgb565::new(3, 60, 28)];
    print("pattern", &|frame| {
        let paint = Pattern::new(black_box(pattern::DIAGONAL), ink, Some(paper));
        frame.surface().paint(paint, |window, brush| rectangle::fill(black_box(AREA), window, brush));
    });
    print("xor", &|frame| {
        let paint = RasterOp::xor(black_box(ink));
        frame.surface().paint(paint, |window, brush| rectangle::fill(black_box(AREA), window, brush));
    });
}

fn of_dither(pictures: &Pictures, frame: &mut Frame) {
    let side = SIDE as u16;
    let picture = Bitmap::<Rgb888>::new(&pictures.rgb, side, side).unwrap();
    report::item(&own::RGB565, frame, ("floyd-steinberg", 1, SQUARE), &|frame| {
        let mut row = [[0; 3]; SIDE];
        let mut rule = FloydSteinberg::new(&mut row);
        frame.surface().blit_mapped(place(1), &picture, |color: Rgb888| {
            Some(rule.next([color.r(), color.g(), color.b()], |[r, g, b]| {
                let nearest = Rgb565::from(Rgb888::new(r, g, b));
                let shown = Rgb888::from(nearest);
                (nearest, [shown.r(), shown.g(), shown.b()])
            }))
        });
    });
    let picture = Bitmap::<Gray8>::new(&pictures.rgb, side, side).unwrap();
    report::item(&own::BINARY, &mut own::Frame::new(), ("floyd-steinberg", 1, SQUARE), &|frame| {
        let mut row = [[0; 1]; SIDE];
        let mut rule = FloydSteinberg::new(&mut row);
        frame.surface().blit_mapped(place(1), &picture, |color: Gray8| {
            Some(rule.next([color.luma()], |[level]| {
                let is_on = level >= 128;
                (BinaryColor::from(is_on), [if is_on { 255 } else { 0 }])
            }))
        });
    });
    report::item(&own::GRAY8, &mut own::Frame::new(), ("bayer-in-place", 1, PIXELS), &|frame| {
        let mut surface = frame.surface();
        for y in AREA.y0..AREA.y1 {
            let Some(span) = (Span { y, x0: AREA.x0, x1: AREA.x1 }).clip(surface.window()) else { continue };
            surface.edit_span(span, |x, old| Gray8::new(Bayer::<4>::shade(old.luma() | 90, 15, Point::new(x, y)) * 17));
        }
    });
}

/// Shapes of the table on a screen that is turned by a quarter: it is as wide as the frame is high.
fn turned(data: &Scene, frame: &mut Frame) {
    let pictures = scene::Pictures::new(Format::Rgb565);
    for workload in &data.workloads(&pictures) {
        let mut print = |name: &str, draw: &dyn Fn(&mut Turned<'_, Framebuffer<'_, Rgb565>>)| {
            report::item(&own::RGB565, frame, (name, workload.calls, workload.pixels as usize), &|frame| {
                draw(&mut Turned::new(&mut frame.surface(), Turn::Quarter));
            });
        };
        match (&workload.work, workload.name) {
            (Work::Rects(list), "rects-8x8") => print("turned-rects-8x8", &|on| {
                for rect in *list {
                    let Rect { x0, y0, x1, y1 } = rect.sides;
                    on.fill_rectangle(Rect::new(y0, x0, y1, x1), own::color::<Rgb565>(rect.ink));
                }
            }),
            (Work::Lines(list), "lines-12") => print("turned-lines-12", &|on| {
                for line in *list {
                    let [from, to] = line.ends.map(|p| Point::new(p.y, p.x));
                    on.draw_line(from, to, own::color::<Rgb565>(line.ink));
                }
            }),
            (Work::Text(list), name) => {
                let name = if name == "text" { "turned-text" } else { "turned-text-opaque" };
                print(name, &|on| {
                    for label in *list {
                        own::style::<Rgb565>(label).draw(on, Point::new(0, label.at.y), label.text);
                    }
                });
            }
            _ => {}
        }
    }
}

/// Pictures of the same pixels by embedded-graphics and tinybmp.
fn of_peers(pictures: &Pictures, frame: &mut eg::Rgb565Frame) {
    let mut print = |name: &str, calls: usize, pixels: usize, draw: &dyn Fn(&mut eg::Rgb565Frame)| {
        report::item(&eg::RGB565, frame, (name, calls, pixels), draw);
    };
    let bmp = Bmp::<Rgb565>::from_slice(&pictures.bmp).unwrap();
    print("palette-64", COPIES, COPIES * SQUARE, &|frame| {
        for i in 0..COPIES {
            let Ok(()) = Image::new(&bmp, place(i)).draw(frame);
        }
    });
    let bits = ImageRaw::<BinaryColor>::new(&pictures.bits, SIDE as u32);
    print("bits-64", COPIES, COPIES * SQUARE, &|frame| {
        let mut frame = frame.color_converted::<BinaryColor>();
        for i in 0..COPIES {
            let Ok(()) = Image::new(&bits, place(i)).draw(&mut frame);
        }
    });
    let colors = ImageRaw::<Rgb565, LittleEndian>::new(&pictures.colors, SIDE as u32);
    print("tile-map", 1, WIDTH * HEIGHT, &|frame| {
        let Ok(()) = tiles(frame, &colors, black_box(Point::new(-5, -9)));
    });
}

/// A map of tiles as one writes it with embedded-graphics: each visible tile is an image.
fn tiles(frame: &mut eg::Rgb565Frame, sheet: &ImageRaw<'_, Rgb565, LittleEndian>, at: Point) -> Result<(), Infallible> {
    let size = TILE as i32;
    for row in 0..(HEIGHT as i32 - at.y + size - 1) / size {
        for column in 0..(WIDTH as i32 - at.x + size - 1) / size {
            let tile = tile_at(column, row) as i32;
            let corner = Point::new(tile % 4, tile / 4) * size;
            let image = sheet.sub_image(&Rectangle::new(corner, Size::new_equal(TILE as u32)));
            Image::new(&image, at + Point::new(column, row) * size).draw(frame)?;
        }
    }
    Ok(())
}
