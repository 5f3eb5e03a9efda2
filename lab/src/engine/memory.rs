//! Ways of this crate and of embedded-graphics into memory: blits, text, and everything at one bit per pixel.

use std::convert::Infallible;

use embedded_graphics::{
    framebuffer::{buffer_size, Framebuffer as GraphicsFrame},
    image::{GetPixel, Image, ImageRaw},
    mono_font::{ascii::FONT_6X10, MonoFont, MonoTextStyleBuilder},
    pixelcolor::{
        raw::{LittleEndian, RawU1},
        BinaryColor, Rgb565,
    },
    prelude::*,
    primitives::Rectangle,
    text::Text,
};
use embedded_raster::{buffer_bytes, Bitmap, Canvas, Framebuffer, Surface};

use super::{entry, ink, peers, Engine, Entry, Origin};
use crate::{
    frame::{Mask, HEIGHT, WIDTH},
    shape::{Job, SPRITE},
};

const COLUMNS: usize = WIDTH as usize;
const ROWS: usize = HEIGHT as usize;
type Bits =
    GraphicsFrame<BinaryColor, RawU1, LittleEndian, COLUMNS, ROWS, { buffer_size::<BinaryColor>(COLUMNS, ROWS) }>;

pub(crate) fn entries() -> Vec<Entry<Job>> {
    vec![
        entry("canvas", "`Canvas`, `Framebuffer`", Origin::Crate, Own::new()),
        entry("eg", "embedded-graphics", Origin::Peer, Graphics::new()),
    ]
}

/// The picture of the blits in memory of 16 bits per pixel.
fn sprite() -> Vec<u8> {
    let bit = |i: i32| if Job::sprite_has(i % SPRITE, i / SPRITE) { ink().into_storage() } else { 0 };
    (0..SPRITE * SPRITE).flat_map(|i| bit(i).to_le_bytes()).collect()
}

const FONT: MonoFont = FONT_6X10;
const LABEL: &str = "Quick brown fox 0123456789";

/// A label with its background.
pub(crate) fn text<D: DrawTarget<Error = Infallible>>(target: &mut D, at: Point, color: D::Color, ground: D::Color) {
    let style = MonoTextStyleBuilder::new().font(&FONT).text_color(color).background_color(ground).build();
    let Ok(_) = Text::new(LABEL, at, style).draw(target);
}

/// The pictures of a font: of character c the row c - 32.
fn glyphs() -> Vec<[u8; 10]> {
    let (size, image) = (FONT.character_size, FONT.image);
    let columns = image.size().width / size.width;
    let glyph = |c: char| {
        let index = FONT.glyph_mapping.index(c) as u32;
        let corner = Point::new((index % columns * size.width) as i32, (index / columns * size.height) as i32);
        let row = |y: usize| {
            let bit = |x: u32| image.pixel(corner + Point::new(x as i32, y as i32)) == Some(BinaryColor::On);
            (0..size.width).map(|x| u8::from(bit(x)) << (7 - x)).sum()
        };
        std::array::from_fn(row)
    };
    (' '..='~').map(glyph).collect()
}

/// This crate, at 16 bits and at one.
struct Own {
    colors: Vec<u8>,
    bits: Vec<u8>,
    sprite: Vec<u8>,
    glyphs: Vec<[u8; 10]>,
}

impl Own {
    fn new() -> Self {
        let (width, height) = (WIDTH as u16, HEIGHT as u16);
        let (colors, bits) = (buffer_bytes::<Rgb565>(width, height), buffer_bytes::<BinaryColor>(width, height));
        Self { colors: vec![0; colors], bits: vec![0; bits], sprite: sprite(), glyphs: glyphs() }
    }
}

impl Engine<Job> for Own {
    fn draw(&mut self, jobs: &[Job]) {
        let (width, height, side) = (WIDTH as u16, HEIGHT as u16, SPRITE as u16);
        let colors = &mut Framebuffer::<Rgb565>::new(&mut self.colors, width, height).expect("made for this size");
        let bits = &mut Framebuffer::<BinaryColor>::new(&mut self.bits, width, height).expect("made for this size");
        let sprite = Bitmap::<Rgb565>::new(&self.sprite, side, side).expect("made for this size");
        for job in jobs {
            match job {
                Job::BitLine(line) => bits.draw_line(line.a, line.b, BinaryColor::On),
                Job::BitRectangle(area) => bits.fill_area(*area, BinaryColor::On),
                Job::BitTriangle(triangle) => bits.fill_triangle_fx(triangle.vertices, BinaryColor::On),
                Job::Blit(at) => colors.blit(*at, &sprite),
                Job::BlitKeyed(at) => colors.blit_keyed(*at, &sprite, Rgb565::BLACK),
                Job::Text(at) => text(colors, *at, ink(), Rgb565::BLACK),
                Job::Glyphs(at) => {
                    let mut at = *at - Point::new(0, FONT.baseline as i32);
                    for c in LABEL.bytes() {
                        let glyph = Bitmap::<BinaryColor>::new(&self.glyphs[usize::from(c - b' ')], 6, 10);
                        colors.blit_mask(at, &glyph.expect("ten rows of a byte"), ink(), Rgb565::BLACK);
                        at.x += 6;
                    }
                }
            }
        }
    }

    fn clear(&mut self) {
        self.colors.fill(0);
        self.bits.fill(0);
    }

    fn painted(&self) -> Mask {
        let colors = self.colors.chunks_exact(2).map(|bytes| bytes != [0, 0]);
        let bits = self.bits.iter().flat_map(|byte| (0..8).rev().map(move |i| byte >> i & 1 != 0));
        Mask::from_pixels(colors.zip(bits).map(|(color, bit)| color || bit))
    }
}

/// embedded-graphics, at 16 bits and at one.
struct Graphics {
    colors: Box<peers::Graphics>,
    bits: Box<Bits>,
    sprite: Vec<u8>,
}

impl Graphics {
    fn new() -> Self {
        Self { colors: Box::new(peers::Graphics::new()), bits: Box::new(Bits::new()), sprite: sprite() }
    }
}

impl Engine<Job> for Graphics {
    fn draw(&mut self, jobs: &[Job]) {
        let Self { colors, bits, sprite } = self;
        let sprite = ImageRaw::<Rgb565, LittleEndian>::new(sprite, SPRITE as u32);
        for job in jobs {
            match job {
                Job::BitLine(line) => peers::line(bits.as_mut(), line.a, line.b, BinaryColor::On),
                Job::BitRectangle(area) => {
                    let Ok(()) = bits.fill_solid(&Rectangle::from(*area), BinaryColor::On);
                }
                Job::BitTriangle(triangle) => peers::triangle(bits.as_mut(), triangle.pixels, BinaryColor::On),
                Job::Blit(at) => {
                    let Ok(()) = Image::new(&sprite, *at).draw(colors.as_mut());
                }
                Job::BlitKeyed(at) => {
                    let area = Rectangle::new(*at, sprite.size());
                    let opaque = |p: &Pixel<Rgb565>| p.1 != Rgb565::BLACK;
                    let pixels = area.points().filter_map(|p| Some(Pixel(p, sprite.pixel(p - *at)?))).filter(opaque);
                    let Ok(()) = colors.draw_iter(pixels);
                }
                Job::Text(at) | Job::Glyphs(at) => text(colors.as_mut(), *at, ink(), Rgb565::BLACK),
            }
        }
    }

    fn clear(&mut self) {
        self.colors.data_mut().fill(0);
        self.bits.data_mut().fill(0);
    }

    fn painted(&self) -> Mask {
        let colors = self.colors.data().chunks_exact(2).map(|bytes| bytes != [0, 0]);
        let bits = self.bits.data().iter().flat_map(|byte| (0..8).rev().map(move |i| byte >> i & 1 != 0));
        Mask::from_pixels(colors.zip(bits).map(|(color, bit)| color || bit))
    }
}
