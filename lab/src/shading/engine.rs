//! Ways to shade a triangle: those of textbooks, and this crate's. Corners are converted as they are drawn.

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::{
    geom::{Fast, Perspective, Runs, Varying},
    paint::depth::less,
    pixel::{Depth16, Depth32},
    surface::{
        texture::{Texture, Tile as Tiled},
        Depth, DepthBuffer, Rows,
    },
    Bitmap, Canvas, Framebuffer, PointFx,
};
use fixed::types::I16F16;
use textbook::{
    depth, gouraud,
    scene::{Corner, Triangle},
    texture::{self, Tile},
    Size,
};

use super::{Drawn, Shaded, Ways, UNPAINTED};
use crate::{
    engine::{entry, Engine, Origin},
    frame::{HEIGHT, WIDTH},
};

pub(super) const SIZE: Size = Size { width: WIDTH, height: HEIGHT };
pub(super) const PIXELS: usize = (WIDTH * HEIGHT) as usize;

/// A pixel of 16 bits that nothing paints.
const WHITE: u16 = u16::MAX;

/// Pixels of 16 bits as they are read.
pub(super) fn read(pixels: impl Iterator<Item = u16>) -> Drawn {
    pixels.map(|pixel| if pixel == WHITE { UNPAINTED } else { pixel.into() }).collect()
}

/// A way to draw on plain pixels.
struct Plain<F> {
    frame: Vec<u16>,
    draw: F,
}

fn plain(draw: impl FnMut(&mut [u16], &Triangle)) -> Plain<impl FnMut(&mut [u16], &Triangle)> {
    Plain { frame: vec![WHITE; PIXELS], draw }
}

impl<F: FnMut(&mut [u16], &Triangle)> Engine<Shaded, Drawn> for Plain<F> {
    fn draw(&mut self, shapes: &[Shaded]) {
        for shape in shapes {
            (self.draw)(&mut self.frame, &shape.corners);
        }
    }

    fn clear(&mut self) {
        self.frame.fill(WHITE);
    }

    fn painted(&self) -> Drawn {
        read(self.frame.iter().copied())
    }
}

/// The same with a depth buffer, which is cleared before each list of shapes.
struct Deep<Z, F> {
    frame: Vec<u16>,
    depths: Vec<Z>,
    far: Z,
    read: fn(Z) -> u32,
    draw: F,
}

impl<Z: Copy + PartialEq, F: FnMut(&mut [u16], &mut [Z], &Triangle)> Engine<Shaded, Drawn> for Deep<Z, F> {
    fn draw(&mut self, shapes: &[Shaded]) {
        self.clear();
        for shape in shapes {
            (self.draw)(&mut self.frame, &mut self.depths, &shape.corners);
        }
    }

    fn clear(&mut self) {
        self.depths.fill(self.far);
    }

    fn painted(&self) -> Drawn {
        let number = |&depth: &Z| if depth == self.far { UNPAINTED } else { (self.read)(depth) };
        self.depths.iter().map(number).collect()
    }
}

/// In floats.
fn deep_floats(
    draw: impl FnMut(&mut [u16], &mut [f32], &Triangle),
) -> Deep<f32, impl FnMut(&mut [u16], &mut [f32], &Triangle)> {
    let (frame, depths) = (vec![WHITE; PIXELS], vec![f32::INFINITY; PIXELS]);
    Deep { frame, depths, far: f32::INFINITY, read: |depth| (f64::from(depth) + 0.5) as u32, draw }
}

/// This crate.
struct Own<F> {
    memory: Vec<u8>,
    draw: F,
}

fn own(
    draw: impl FnMut(&mut Framebuffer<'_, Rgb565>, &Triangle),
) -> Own<impl FnMut(&mut Framebuffer<'_, Rgb565>, &Triangle)> {
    Own { memory: vec![u8::MAX; 2 * PIXELS], draw }
}

impl<F: FnMut(&mut Framebuffer<'_, Rgb565>, &Triangle)> Engine<Shaded, Drawn> for Own<F> {
    fn draw(&mut self, shapes: &[Shaded]) {
        let frame = Framebuffer::new(&mut self.memory, WIDTH as u16, HEIGHT as u16);
        let mut frame = frame.expect("the memory was made for this size");
        for shape in shapes {
            (self.draw)(&mut frame, &shape.corners);
        }
    }

    fn clear(&mut self) {
        self.memory.fill(u8::MAX);
    }

    fn painted(&self) -> Drawn {
        read(self.memory.chunks_exact(2).map(|bytes| u16::from_le_bytes([bytes[0], bytes[1]])))
    }
}

/// This crate with a depth buffer.
struct OwnDeep<Z> {
    memory: Vec<u8>,
    depths: Vec<u8>,
    number: fn(&Corner) -> Z,
}

impl<Z> OwnDeep<Z> {
    fn new(number: fn(&Corner) -> Z) -> Self {
        Self { memory: vec![u8::MAX; 2 * PIXELS], depths: vec![u8::MAX; size_of::<Z>() * PIXELS], number }
    }
}

/// A depth format whose numbers become depths.
trait Number: Varying {
    type Format: Depth<Number = Self>;
}

impl Number for u16 {
    type Format = Depth16;
}

impl Number for u32 {
    type Format = Depth32;
}

impl<Z: Number + PartialOrd> Engine<Shaded, Drawn> for OwnDeep<Z> {
    fn draw(&mut self, shapes: &[Shaded]) {
        self.clear();
        let size = (WIDTH as u16, HEIGHT as u16);
        let mut frame = Framebuffer::<Rgb565>::new(&mut self.memory, size.0, size.1).expect("made for this size");
        let mut depths = DepthBuffer::<Z::Format>::new(&mut self.depths, size.0, size.1).expect("made for this size");
        for Shaded { corners, .. } in shapes {
            let values = corners.each_ref().map(|corner| ((self.number)(corner), color(corner)));
            let drawn = frame.depth_triangle_fx(places(corners), values, &mut depths, less, |color| color);
            drawn.expect("triangles are small enough");
        }
    }

    fn clear(&mut self) {
        self.depths.fill(u8::MAX);
    }

    fn painted(&self) -> Drawn {
        match size_of::<Z>() {
            2 => read(self.depths.chunks_exact(2).map(|bytes| u16::from_le_bytes([bytes[0], bytes[1]]))),
            _ => self.depths.chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect(),
        }
    }
}

fn places(corners: &Triangle) -> [PointFx; 3] {
    corners.each_ref().map(|corner| PointFx::from_bits(corner.at[0], corner.at[1]))
}

fn color(corner: &Corner) -> Rgb565 {
    let [r, g, b] = corner.levels.map(|level| level as u8);
    Rgb565::new(r, g, b)
}

/// Shades with the values that the corners have.
fn shade<V: Varying>(
    frame: &mut Framebuffer<'_, Rgb565>,
    corners: &Triangle,
    value: impl Fn(&Corner) -> V,
    color: impl Fn(V) -> Rgb565,
) {
    let drawn = frame.shade_triangle_fx(places(corners), corners.each_ref().map(value), color);
    drawn.expect("triangles are small enough");
}

pub(super) fn gouraud() -> Ways {
    use Origin::{Crate, Textbook};
    vec![
        entry("barycentric", "f32, barycentric, per pixel", Textbook, plain(|f, t| gouraud::barycentric(f, SIZE, t))),
        entry("floats", "f32, row by row", Textbook, plain(|f, t| gouraud::float_rows(f, SIZE, t))),
        entry(
            "fixed8",
            "fixed point 8.8, sides and rows",
            Textbook,
            plain(|f, t| gouraud::fixed_rows::<8>(f, SIZE, t)),
        ),
        entry(
            "fixed16",
            "fixed point 16.16, sides and rows",
            Textbook,
            plain(|f, t| gouraud::fixed_rows::<16>(f, SIZE, t)),
        ),
        entry("plane16", "fixed point 16.16, plane", Textbook, plain(|f, t| gouraud::plane::<i32, 16>(f, SIZE, t))),
        entry("plane24", "fixed point 40.24, plane", Textbook, plain(|f, t| gouraud::plane::<i64, 24>(f, SIZE, t))),
        entry("fast", "this crate, `Fast`", Crate, own(|f, t| shade(f, t, |c| Fast(color(c)), |Fast(color)| color))),
        entry("exact", "this crate", Crate, own(|f, t| shade(f, t, color, |color| color))),
    ]
}

pub(super) fn depth16() -> Ways {
    use Origin::{Crate, Textbook};
    let (frame, depths) = (vec![WHITE; PIXELS], vec![u16::MAX; PIXELS]);
    let draw = |f: &mut [u16], z: &mut [u16], t: &Triangle| depth::fixed_rows(f, z, SIZE, t);
    vec![
        entry(
            "barycentric",
            "f32, barycentric, per pixel",
            Textbook,
            deep_floats(|f, z, t| depth::barycentric(f, z, SIZE, t)),
        ),
        entry("floats", "f32, row by row", Textbook, deep_floats(|f, z, t| depth::float_rows(f, z, SIZE, t))),
        entry(
            "fixed14",
            "fixed point 16.14, sides and rows",
            Textbook,
            Deep { frame, depths, far: u16::MAX, read: u32::from, draw },
        ),
        entry("exact", "this crate", Crate, OwnDeep::new(|corner| corner.depth as u16)),
    ]
}

pub(super) fn depth32() -> Ways {
    use Origin::{Crate, Textbook};
    vec![
        entry(
            "barycentric",
            "f32, barycentric, per pixel",
            Textbook,
            deep_floats(|f, z, t| depth::barycentric(f, z, SIZE, t)),
        ),
        entry("floats", "f32, row by row", Textbook, deep_floats(|f, z, t| depth::float_rows(f, z, SIZE, t))),
        entry("exact", "this crate", Crate, OwnDeep::new(|corner| corner.depth)),
    ]
}

/// The side of the texture is `1 << TEXTURE`.
pub(super) const TEXTURE: u32 = 8;

/// A texture in which each texel says which one it is: its row, then its column.
pub(super) fn texels() -> Vec<u16> {
    (0..=u16::MAX).collect()
}

/// Places in the texture.
type Place = (I16F16, I16F16);

fn place(corner: &Corner) -> Place {
    (I16F16::from_num(corner.texel[0]), I16F16::from_num(corner.texel[1]))
}

/// This crate with a texture, which is not copied.
fn textured<V: Varying>(
    value: impl Fn(&Corner) -> V,
    place: impl Fn(V) -> Place + Copy,
) -> Own<impl FnMut(&mut Framebuffer<'_, Rgb565>, &Triangle)> {
    let bytes: &'static [u8] = texels().iter().flat_map(|texel| texel.to_le_bytes()).collect::<Vec<_>>().leak();
    own(move |frame, corners| {
        let side = 1 << TEXTURE;
        let picture = Bitmap::<Rgb565>::new(bytes, side, side).expect("as many texels");
        let texture: Texture<'_, Rows<Rgb565>, _, _> = Texture::new(&picture, (Tiled, Tiled)).expect("a power of two");
        shade(frame, corners, &value, move |value| {
            let (u, v) = place(value);
            texture.nearest(u, v)
        });
    })
}

fn runs<const N: u32>() -> impl Engine<Shaded, Drawn> {
    textured(|c| Runs::<_, N> { w: I16F16::from_num(c.w), value: Fast(place(c)) }, |at| at.value.0)
}

pub(super) fn perspective() -> Ways {
    use Origin::{Crate, Textbook};
    let texels: &'static [u16] = texels().leak();
    let tile = Tile { texels, bits: TEXTURE };
    vec![
        entry("floats", "f32, a division per pixel", Textbook, plain(move |f, t| texture::each(f, SIZE, t, tile))),
        entry("floats16", "f32, runs of 16", Textbook, plain(move |f, t| texture::runs::<16>(f, SIZE, t, tile))),
        entry(
            "fixed",
            "fixed point 16.16, affine",
            Textbook,
            plain(move |f, t| texture::affine::<16>(f, SIZE, t, tile)),
        ),
        entry("affine", "this crate, affine, `Fast`", Crate, textured(|c| Fast(place(c)), |at| at.0)),
        entry("runs32", "this crate, `Runs` of 32", Crate, runs::<32>()),
        entry("runs16", "this crate, `Runs` of 16", Crate, runs::<16>()),
        entry("runs8", "this crate, `Runs` of 8", Crate, runs::<8>()),
        entry(
            "exact",
            "this crate, per pixel",
            Crate,
            textured(|c| Perspective { w: I16F16::from_num(c.w), value: Fast(place(c)) }, |at| at.value.0),
        ),
    ]
}

/// The ways of the peers.
#[derive(Default)]
pub(super) struct Peers {
    pub(super) gouraud: Ways,
    pub(super) depth16: Ways,
    pub(super) depth32: Ways,
    pub(super) perspective: Ways,
}
